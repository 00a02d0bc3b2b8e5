"""The lift of a cam through points: a periodic spline over a turn, as a function that is given in numbers.

With breaks w_k over one turn and cubics between them, a curve is its first cubic and, from every further break on,
what is added there: with the jumps J_j of its derivatives,

    L(w) = p_0(w) + sum_k (1 + sign(w - w_k))/2 sum_j J_kj/j! (w - w_k)^j.

The angle is counted over one turn by w = pi + 2 atan tan((phi - w_0 - pi)/2), from a place w_0 between two points.
Source: de Boor, A Practical Guide to Splines, ch. IV (cubic) and VIII (truncated powers); Fritsch & Carlson, SIAM J.
Numer. Anal. 17 (1980) 238 (monotone cubics); the curves themselves are SciPy's.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from freebody.connections.points_given import GivenPoints, PointList, read_points
from freebody.language.expression import ONE, PI, PLACE, ZERO, Call, Expr, GivenCall, Symbol, number
from freebody.language.sentences import Message
from freebody.language.units import DIMENSIONLESS, LENGTH

if TYPE_CHECKING:
    from freebody.model.names import Names

CURVES = ("cubic", "pchip")
_LEAST = 4  # points of a turn
_SAME = 1e-9  # of a turn, and of the lift
_BETWEEN = 0.381966  # where between two points a turn begins: no place at which a motion is likely to start


def lift_through(names: Names, points: PointList, curve: str, angle: str) -> Expr | None:
    """The lift in the angle of that name; None with a problem noted."""
    if curve not in CURVES:
        names.problem(Message("through is one of {names}", names=", ".join(CURVES)), "through")
        return None
    table = _table(names, points)
    if table is None:
        return None
    forms = _forms(*table, curve)
    return GivenCall("lift", Symbol(angle), None, *forms, LENGTH)


def _table(names: Names, points: PointList) -> tuple[list[float], list[float]] | None:
    """Angles within a turn [rad], growing, and lifts [m]."""
    found = read_points(
        names,
        points,
        (("phi", DIMENSIONLESS), ("lift", LENGTH)),
        Message("a point is an angle and a lift, e.g. [30 deg, 2 mm]"),
        Message("a cam through points needs numbers: give the parameters values"),
    )
    return None if found is None else _whole_turn(names, found)


def _whole_turn(names: Names, points: GivenPoints) -> tuple[list[float], list[float]] | None:
    """Without a last point that repeats the first one; None with a problem noted where they make no turn."""
    angles, lifts = [x for x, _y in points.pairs], [y for _x, y in points.pairs]
    for k in range(1, len(angles)):
        if angles[k] <= angles[k - 1]:
            told = Message(
                "the angles of the points grow: {this:.4g}° comes after {last:.4g}°",
                this=math.degrees(angles[k]),
                last=math.degrees(angles[k - 1]),
            )
            points.problem(names, told, k)
            return None
    size = max(map(abs, lifts), default=0.0)
    if len(angles) > 1 and abs(angles[-1] - angles[0] - math.tau) <= _SAME * math.tau:
        if abs(lifts[-1] - lifts[0]) > _SAME * size:
            told = Message(
                "after a full turn the lift is that of the beginning: {first:.4g} m, not {last:.4g} m",
                first=lifts[0],
                last=lifts[-1],
            )
            points.problem(names, told, len(angles) - 1)
            return None
        angles, lifts = angles[:-1], lifts[:-1]
    if len(angles) < _LEAST:
        points.problem(names, Message("a turn needs at least {n} points, found {found}", n=_LEAST, found=len(angles)))
        return None
    if angles[-1] - angles[0] >= math.tau:
        told = Message(
            "the points go over more than one turn: from {first:.4g}° to {last:.4g}°",
            first=math.degrees(angles[0]),
            last=math.degrees(angles[-1]),
        )
        points.problem(names, told, len(angles) - 1)
        return None
    return angles, lifts


def _forms(angles: list[float], lifts: list[float], curve: str) -> tuple[tuple[Expr, ...], Expr]:
    """The lift and its derivatives in the angle of one turn from between two points, by SciPy's curve, and that
    angle."""
    import numpy as np
    from scipy.interpolate import CubicSpline, PchipInterpolator

    around = [a + n * math.tau for n in (-1, 0, 1) for a in angles]
    if curve == "cubic":
        closed = [*angles, angles[0] + math.tau]
        found: Any = CubicSpline(closed, [*lifts, lifts[0]], bc_type="periodic", extrapolate="periodic")
    else:  # its slopes hang on the neighbours alone
        found = PchipInterpolator(around, lifts * 3)
    begin = angles[-1] - math.tau + _BETWEEN * (angles[0] + math.tau - angles[-1])
    # derivatives just after each break, at the beginning and at every point
    breaks = [0.0, *(a - begin for a in angles)]
    ends = [*breaks[1:], math.tau]
    orders = range(4)
    after = np.array(
        [[_derivative(found, begin, low, high, j) for j in orders] for low, high in zip(breaks, ends, strict=True)]
    )
    half = (PLACE - number(begin) - PI) / 2
    turned = PI + 2 * Call("atan", Call("sin", half) / Call("cos", half))
    return tuple(piecewise(after, breaks, order, PLACE) for order in orders), turned


def _derivative(found: Any, begin: float, low: float, high: float, order: int) -> float:
    """The derivative at the beginning of a stretch, of the cubic there: from that in its middle by Taylor's formula."""
    half = (high - low) / 2
    middle = begin + low + half
    return sum(float(found(middle, j)) * (-half) ** (j - order) / math.factorial(j - order) for j in range(order, 4))


def piecewise(after: Any, breaks: Sequence[float], order: int, w: Expr) -> Expr:
    """The derivative of an order: the first cubic, and what is added from each break on."""

    def polynomial(derivatives: Sequence[float], x: Expr) -> Expr:
        total: Expr = ZERO
        for j in reversed(range(order, 4)):
            total = total * x + number(derivatives[j] / math.factorial(j - order))
        return total

    total = polynomial(after[0], w)
    for k in range(1, len(breaks)):
        x, length = w - number(breaks[k]), breaks[k] - breaks[k - 1]
        before = [
            sum(after[k - 1][i] * length ** (i - j) / math.factorial(i - j) for i in range(j, 4)) for j in range(4)
        ]
        jumps = [float(now - was) for now, was in zip(after[k], before, strict=True)]
        lowest = _first_jump(jumps, order)
        if lowest is None:
            continue
        kept = [jump if j >= lowest else 0.0 for j, jump in enumerate(jumps)]
        total = total + (ONE + Call("sign", x)) / 2 * polynomial(kept, x)
    return total


def _first_jump(jumps: Sequence[float], order: int) -> int | None:
    """Of the derivatives from an order on, the first that jumps: those below are equal but for rounding."""
    size = max(map(abs, jumps))
    return next((j for j in range(order, 4) if abs(jumps[j]) > _SAME * size), None)
