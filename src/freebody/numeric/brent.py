"""A zero of a function of one variable, and its least value, in an interval.

Source: Brent, Algorithms for Minimization without Derivatives, 1973, ch. 4 (zero) and 5 (localmin), in the arithmetic
of SciPy's `brentq` and `minimize_scalar(method="bounded")`, to the last digit; `scipy.optimize` itself takes longer to
load than most models take to solve.
"""

from __future__ import annotations

import math
from collections.abc import Callable

Function = Callable[[float], float]

_GOLDEN = 0.5 * (3.0 - math.sqrt(5.0))
_OF_PLACE = math.sqrt(2.2e-16)  # where a function is least is not seen more finely
_MAX_STEPS = 100
_MAX_VALUES = 500


def zero_between(function: Function, low: float, high: float, *, xtol: float, rtol: float) -> float:
    """A zero x of the function, within xtol + rtol |x|, between two places where its signs differ.

    Raises ValueError if they do not differ or a value is not a number, RuntimeError if 100 steps do not find it.
    """
    before, x, other = low, high, 0.0  # the last two places, and one where the sign is the other
    f_before, f_x, f_other = _known(function, before), _known(function, x), 0.0
    if f_before == 0.0:
        return before
    if f_x == 0.0:
        return x
    if (f_before < 0.0) == (f_x < 0.0):
        raise ValueError(f"the function has the same sign at {low} and at {high}")
    step = last = 0.0
    for _ in range(_MAX_STEPS):
        if f_before != 0.0 and f_x != 0.0 and (f_before < 0.0) != (f_x < 0.0):
            other, f_other = before, f_before
            step = last = x - before
        if abs(f_other) < abs(f_x):
            before, x, other = x, other, x
            f_before, f_x, f_other = f_x, f_other, f_x
        least = (xtol + rtol * abs(x)) / 2
        half = (other - x) / 2
        if f_x == 0.0 or abs(half) < least:
            return x
        # a line or a parabola in f through what is known, where it comes nearer than halving does
        trial = math.inf
        if abs(last) > least and abs(f_x) < abs(f_before):
            trial = _interpolated(before, x, other, f_before, f_x, f_other)
        is_nearer = 2 * abs(trial) < min(abs(last), 3 * abs(half) - least)
        last, step = (step, trial) if is_nearer else (half, half)
        before, f_before = x, f_x
        x += step if abs(step) > least else math.copysign(least, half)
        f_x = _known(function, x)
    raise RuntimeError(f"{_MAX_STEPS} steps find no zero between {low} and {high}")


def _known(function: Function, x: float) -> float:
    value = float(function(x))
    if math.isnan(value):
        raise ValueError(f"the function has no value at {x}")
    return value


def _interpolated(before: float, x: float, other: float, f_before: float, f_x: float, f_other: float) -> float:
    """How far from x the secant has its zero, or the inverse parabola through three places."""
    if before == other:
        return -f_x * (x - before) / (f_x - f_before)
    slope = (f_before - f_x) / (before - x)
    slope_other = (f_other - f_x) / (other - x)
    return -f_x * (f_other * slope_other - f_before * slope) / (slope_other * slope * (f_other - f_before))


def least_between(function: Function, low: float, high: float, *, xtol: float) -> tuple[float, float]:
    """A place between two others where the function has a least value, within xtol, and that value. Of several such
    places it may be any; at the ends themselves the function is not asked for."""
    a, b = low, high
    x = second = third = a + _GOLDEN * (b - a)  # the three best places so far
    f_x = f_second = f_third = float(function(x))
    step = last = 0.0
    for _ in range(1, _MAX_VALUES):
        middle = 0.5 * (a + b)
        near = _OF_PLACE * abs(x) + xtol / 3.0
        if abs(x - middle) <= 2.0 * near - 0.5 * (b - a):
            break
        vertex = None
        if abs(last) > near:
            vertex = _vertex((x, second, third), (f_x, f_second, f_third), (a, b), last)
        if vertex is None:
            # the golden section of the longer part
            last = (a if x >= middle else b) - x
            step = _GOLDEN * last
        else:
            last, step = step, vertex
            if x + step - a < 2.0 * near or b - (x + step) < 2.0 * near:
                step = near if middle >= x else -near
        u = x + (1.0 if step >= 0.0 else -1.0) * max(abs(step), near)
        f_u = float(function(u))
        if f_u <= f_x:
            a, b = (x, b) if u >= x else (a, x)
            third, f_third, second, f_second, x, f_x = second, f_second, x, f_x, u, f_u
            continue
        a, b = (u, b) if u < x else (a, u)
        if f_u <= f_second or second == x:
            third, f_third, second, f_second = second, f_second, u, f_u
        elif f_u <= f_third or third in (x, second):
            third, f_third = u, f_u
    return x, f_x


def _vertex(
    places: tuple[float, float, float], values: tuple[float, float, float], within: tuple[float, float], last: float
) -> float | None:
    """How far from the first place the parabola through three has its vertex; None if that is outside or no less than
    half the step before the last, so that steps would not become shorter."""
    x, second, third = places
    f_x, f_second, f_third = values
    r = (x - second) * (f_x - f_third)
    q = (x - third) * (f_x - f_second)
    p = (x - third) * q - (x - second) * r
    q = 2.0 * (q - r)
    if q > 0.0:
        p = -p
    q = abs(q)
    a, b = within
    if abs(p) < abs(0.5 * q * last) and q * (a - x) < p < q * (b - x):
        return p / q
    return None
