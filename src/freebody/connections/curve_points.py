"""A curve through points: y = f(x) as a function that is given in numbers.

Between the points SciPy's cubics: a natural spline, which has the acceleration of a bead steady, or a monotone one,
which does not overshoot. Before the first point and behind the last one the curve goes on straight, as a natural spline
does. Source: de Boor, A Practical Guide to Splines, ch. IV; Fritsch & Carlson, SIAM J. Numer. Anal. 17 (1980) 238.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from freebody.connections.cam_points import CURVES, piecewise
from freebody.connections.points_given import GivenPoints, PointList, read_points
from freebody.language.expression import PLACE, Expr, GivenCall, Symbol, number
from freebody.language.sentences import Message
from freebody.language.units import LENGTH

if TYPE_CHECKING:
    from freebody.model.names import Names

_LEAST, _MOST = 3, 200  # points: of more the sums of cubics lose digits
_X = Symbol("x")


def curve_through(names: Names, points: PointList, curve: str) -> tuple[Expr, tuple[float, float]] | None:
    """y in the symbol x, and from where to where the points are; None with a problem noted."""
    if curve not in CURVES:
        names.problem(Message("through is one of {names}", names=", ".join(CURVES)), "through")
        return None
    found = read_points(
        names,
        points,
        (("x", LENGTH), ("y", LENGTH)),
        Message("a point is x and y, e.g. [2 m, 30 cm]"),
        Message("a curve through points needs numbers: give the parameters values"),
    )
    if found is None or not _is_sound(names, found):
        return None
    xs, ys = ([pair[k] for pair in found.pairs] for k in (0, 1))
    told = (
        Message("f(x) is the smooth curve through the given points, a natural cubic spline")
        if curve == "cubic"
        else Message("f(x) is the monotone curve through the given points, a cubic spline")
    )
    if told not in names.assumptions:
        names.assumptions.append(told)
    return GivenCall("f", _X, None, *_forms(xs, ys, curve), LENGTH), (xs[0], xs[-1])


def _is_sound(names: Names, points: GivenPoints) -> bool:
    if not _LEAST <= len(points.pairs) <= _MOST:
        told = Message(
            "a curve goes through {least} to {most} points, found {n}", least=_LEAST, most=_MOST, n=len(points.pairs)
        )
        points.problem(names, told)
        return False
    for k, ((before, _), (x, _y)) in enumerate(zip(points.pairs, points.pairs[1:], strict=False), 1):
        if x <= before:
            told = Message(
                "x grows along a curve through points: {x:.6g} m comes after {before:.6g} m", x=x, before=before
            )
            points.problem(names, told, k)
            return False
    return True


def _forms(xs: list[float], ys: list[float], curve: str) -> tuple[tuple[Expr, ...], Expr]:
    """y and its derivatives in the way from the first point, and that way."""
    import numpy as np
    from scipy.interpolate import CubicSpline, PchipInterpolator

    found: Any = CubicSpline(xs, ys, bc_type="natural") if curve == "cubic" else PchipInterpolator(xs, ys)
    first, last = ([float(found(x, order)) for order in (0, 1)] for x in (xs[0], xs[-1]))
    cubics = [[float(c) * factor for c, factor in zip(row, (6, 2, 1, 1), strict=True)][::-1] for row in found.c.T]
    after = np.array([[*first, 0.0, 0.0], *cubics, [*last, 0.0, 0.0]])
    breaks = [0.0, *(x - xs[0] for x in xs)]
    return tuple(piecewise(after, breaks, order, PLACE) for order in range(4)), PLACE - number(xs[0])
