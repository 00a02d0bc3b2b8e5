"""The real branches of Lambert's W in floating point: w e^w = x,

    W_0(x) >= -1  for x >= -1/e,        W_-1(x) <= -1  for -1/e <= x < 0.

Near the branch point w = -1 + p - p^2/3 + 11 p^3/72 with p = +-sqrt(2 (e x + 1)); from there, or from logarithms, by
Halley's iteration on f = w - x e^-w, which overflows nowhere.
Source: Corless, Gonnet, Hare, Jeffrey & Knuth, On the Lambert W function, Adv. Comput. Math. 5, 1996, 329-359.
"""

from __future__ import annotations

import math

_MOST_STEPS = 40  # each one triples the number of digits
_CLOSE = 4e-16
_NEAR = 0.3  # of p, where the series starts the iteration
_ROUNDED = 1e-15  # by how much an argument may miss the branch point


def lambert_W0(x: float) -> float:
    """The principal branch. Raises ValueError where x < -1/e."""
    p = _from_branch_point(x)
    if p < _NEAR:
        return _refined(x, _series(p), p)
    start = math.log1p(x) if x < math.e else math.log(x) - math.log(math.log(x))
    return _refined(x, start, p)


def lambert_Wm1(x: float) -> float:
    """The branch -1. Raises ValueError unless -1/e <= x < 0."""
    if not x < 0:
        raise ValueError("math domain error: the branch -1 of Lambert's W is real between -1/e and 0")
    p = _from_branch_point(x)
    if p < _NEAR:
        return _refined(x, _series(-p), p)
    far = math.log(-x)
    return _refined(x, far - math.log(-far), p)


def _from_branch_point(x: float) -> float:
    """p >= 0."""
    square = 2.0 * (math.e * x + 1.0)
    if not square >= -_ROUNDED:
        raise ValueError("math domain error: Lambert's W is real from -1/e on")
    return math.sqrt(max(square, 0.0))


def _series(p: float) -> float:
    return -1.0 + p * (1.0 - p * (1.0 / 3.0 - 11.0 / 72.0 * p))


def _refined(x: float, w: float, p: float) -> float:
    if p < 1e-4 or w == 0.0:  # where the series is exact to the last digit, and where x is zero
        return w
    for _ in range(_MOST_STEPS):
        # f/f' = (w - x e^-w)/(1 + x e^-w), and f''/f' = -x e^-w/(1 + x e^-w)
        grown = x * math.exp(-w)
        newton = (w - grown) / (1.0 + grown)
        step = newton / (1.0 + 0.5 * newton * grown / (1.0 + grown))
        w -= step
        if abs(step) <= _CLOSE * abs(w):
            break
    return w
