"""A start pose in which no bar lies folded on another one, where nobody asks for that.

Two bars of one length that are pinned to each other can close with their other ends at one place: a toggle whose ram is
at the upper pin, a governor whose sleeve is at the top of the spindle. In such a pose the second bar turns freely about
that place, so that it is a dead one, and no figure shows it. Where the file says nothing of the second bar it is put on
the other side of their joint, so far as all else fits to that and the first bar stays where it is.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence

import numpy as np

from freebody.measures.geometry import GROUND, Point, position
from freebody.measures.turned import points_in
from freebody.model.elements import ConstraintRow, RigidBody
from freebody.numeric.jet_geometry import JetGeometry
from freebody.numeric.jets import Array
from freebody.numeric.placing import ACCEPTED, Fit, PoseEquation
from freebody.numeric.system import NumericSystem

_SAME_PLACE = 1e-9  # of the size of the system
_PAIR = 2
_NEAR = 1e-3  # of that: less is the same pose


def unfolded(
    reference: NumericSystem, fit: Fit, equations: Sequence[PoseEquation], stands: Callable[[Fit], bool]
) -> Fit:
    """The pose with every bar stretched that lies on another one and of which nothing is said."""
    for first, second in _elbows(reference):
        other = _stretched(reference, fit, equations, (first, second))
        if other is not None and stands(other):
            fit = other
    return fit


def is_folded(reference: NumericSystem, q: Array) -> bool:
    """Whether a bar of which nothing is said lies on another one."""
    return any(_folded(reference, q, bars) for bars in _elbows(reference))


def is_told(body: RigidBody) -> bool:
    """Whether the file says something of its pose."""
    own = body.start
    return own.at is not None or own.angle is not None or own.near is not None


def joint_between(rows: Sequence[ConstraintRow], first: str, second: str) -> Point | None:
    """The point of the first body at which it is pinned to the second."""
    for row in _pins(rows):
        points = list(points_in(row.measure))
        if {p.body for p in points} == {first, second}:
            return next(p for p in points if p.body == first)
    return None


def _pins(rows: Sequence[ConstraintRow]) -> Iterator[ConstraintRow]:
    return (row for row in rows if row.reaction.startswith("force"))


def _elbows(reference: NumericSystem) -> Iterator[tuple[str, str]]:
    """Bars that turn and are pinned to each other, the second one not told of."""
    system = reference.system
    told = {body for name in system.all_start for body in system.all_measures[name].bodies()}
    bars = {} if system.space else {body.name: body for body in system.all_moving if body.turns}
    joined = (tuple(dict.fromkeys(p.body for p in points_in(row.measure))) for row in _pins(system.constraint_rows))
    pairs = dict.fromkeys(pair for pair in joined if len(pair) == len(bars.keys() & pair) == _PAIR)
    for first, second in (order for a, b in pairs for order in ((a, b), (b, a))):
        if second not in told and not is_told(bars[second]):
            yield first, second


def _stretched(
    reference: NumericSystem, fit: Fit, equations: Sequence[PoseEquation], bars: tuple[str, str]
) -> Fit | None:
    """The pose with the second bar on the other side of the joint; None where it does not lie on the first one, or does
    not fit there."""
    first, second = bars
    folded, here = _folded(reference, fit.q, bars), _places(reference, fit.q)
    elbow = joint_between(reference.system.constraint_rows, first, second)
    if not folded or elbow is None:
        return None
    guess, at = fit.q.copy(), here(elbow)
    x, y, angle = reference.columns(second)
    guess[[x, y]] = 2.0 * at - guess[[x, y]]
    guess[angle] = np.pi - np.remainder(-guess[angle], 2.0 * np.pi)  # half a turn on, within half a turn of zero
    for end, joined in _other_ends(
        reference.system.constraint_rows, second, bars
    ):  # what hangs on its ends goes with them
        if joined not in (GROUND, first) and joined not in reference.frame.fixed:
            columns = list(reference.columns(joined))[:2]
            guess[columns] += 2.0 * (at - here(end))
    found = reference.placing.fit(guess, equations, 0.0, {})
    if found is None or found.error > ACCEPTED:
        return None
    there = _places(reference, found.q)
    stays = float(np.linalg.norm(there(elbow) - at)) < _NEAR * reference.sizes.length
    apart = min(float(np.linalg.norm(there(a) - there(b))) for a, b in folded)
    return found if stays and apart > _NEAR * reference.sizes.length else None


def _folded(reference: NumericSystem, q: Array, bars: tuple[str, str]) -> list[tuple[Point, Point]]:
    """Ends of two bars away from the joint between both, each held by something else, that are at one place."""
    rows = reference.system.constraint_rows
    elbow = joint_between(rows, *bars)
    if elbow is None:
        return []
    here, close = _places(reference, q), _SAME_PLACE * reference.sizes.length
    return [
        (a, b)
        for a, _joined in _other_ends(rows, bars[0], bars)
        for b, _other in _other_ends(rows, bars[1], bars)
        if np.linalg.norm(here(a) - here(b)) < close < np.linalg.norm(here(a) - here(elbow))
    ]


def _other_ends(rows: Sequence[ConstraintRow], body: str, bars: tuple[str, str]) -> list[tuple[Point, str]]:
    """Where a bar is held by what is none of both, and by what."""
    found: dict[tuple[Point, str], None] = {}
    for row in rows:
        points = list(points_in(row.measure))
        others = {p.body for p in points} - {body}
        if not row.unilateral and len(others) == 1 and not others & {*bars}:
            found |= {(p, next(iter(others))): None for p in points if p.body == body}
    return [*found]


def _places(reference: NumericSystem, q: Array) -> Callable[[Point], Array]:
    geometry: JetGeometry = reference.geometry(q, np.zeros_like(q), 0.0)

    def place(point: Point) -> Array:
        """(2,) [m]"""
        r = position(geometry, point)
        return np.array([r.x.value, r.y.value])

    return place
