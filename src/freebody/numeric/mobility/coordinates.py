"""Independent coordinates: as many measures as there are freedoms, by which a pose is told.

The user's own measures come first, then those that connections offer, then angles and places of bodies. With N a basis
of the motions that the held measures leave free, a measure is taken if its gradient times N is independent of those
taken before.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator

import numpy as np

from freebody.errors import CannotAnswer
from freebody.measures.angle import Angle
from freebody.measures.base import Measure
from freebody.measures.displacement import Displacement
from freebody.measures.geometry import GROUND, ZERO, Direction, Point
from freebody.measures.turn import Turn
from freebody.model.rotations import UNIT
from freebody.numeric.described import axes_of
from freebody.numeric.jets import Array
from freebody.numeric.mobility.rank import CLEAR_CUT, scaled_rows
from freebody.numeric.mobility.sparse_rows import LARGE, FactoredRows
from freebody.numeric.system import NumericSystem
from freebody.system.system import System

_STILL = 1e-8  # of the slope of a measure, by the size of the system: less is no motion
_INDEPENDENT = 1e-6  # of a measure: a part of its slope across those before that is larger makes it a freedom more


def independent_measures(reference: NumericSystem, q: Array) -> list[tuple[str, Measure]]:
    """Names and measures at the pose q, one for each freedom."""
    n_free, across = _free(reference, q)
    taken: list[Array] = []
    found: list[tuple[str, Measure]] = []
    g = reference.geometry(q, np.zeros_like(q), 0.0)
    for name, measure in _candidates(reference.system):
        if len(found) == n_free:
            break
        try:
            row = across(reference.jet(g, measure, name).row(len(q)) * reference.sizes.unit_moves)
        except CannotAnswer:
            continue
        size = float(np.linalg.norm(row))
        if size <= _STILL * reference.sizes.length:
            continue
        for _ in range(2):
            for other in taken:
                row = row - (other @ row) * other
        left = float(np.linalg.norm(row))
        if left > _INDEPENDENT * size:
            taken.append(row / left)
            found.append((name, measure))
    return found


def _free(reference: NumericSystem, q: Array) -> tuple[int, Callable[[Array], Array]]:
    """How many motions are left free, and the part of a gradient (by the sizes of the system) along them."""
    rows = reference.system.constraint_rows
    if LARGE < len(rows) <= len(q):
        try:
            sparse = FactoredRows(scaled_rows(reference, q, rows))
            if sparse.smallest() > CLEAR_CUT:
                return len(q) - len(rows), sparse.across
        except ValueError:
            pass
    free = reference.split_at(q, {}).null / reference.sizes.unit_moves[:, None]
    basis: Array = np.linalg.qr(free)[0]
    return int(basis.shape[1]), lambda row: basis @ (basis.T @ row)


def _candidates(system: System) -> Iterator[tuple[str, Measure]]:
    yield from system.all_measures.items()
    yield from ((name, m) for name, m in system.offered if m not in system.all_measures.values())
    yield from own_measures(system)


def own_measures(system: System) -> Iterator[tuple[str, Measure]]:
    """Angles and places of bodies; in space "angle of crank.x about z" is that of the body's x axis, seen along the
    ground's z."""
    turning = [body.name for body in system.all_moving if body.turns]
    if system.space:
        # first by the own axis that is across in a body parallel to the ground, then by the other one
        for k in (1, 2):
            for about in (2, 0, 1):
                own = (about + k) % 3
                for body in turning:
                    yield f"angle of {body}.{'xyz'[own]} about {'xyz'[about]}", _turn(body, own, about, k)
    else:
        yield from ((f"angle of {body}", Angle(body)) for body in turning)
    origin = Point(GROUND, (ZERO, ZERO), "ground.origin")
    for body in system.all_moving:
        for name, axis in zip("xyz", axes_of(system), strict=False):
            yield f"{name} of {body.name}", Displacement(body.mass_center, origin, axis)


def _turn(body: str, own: int, about: int, k: int) -> Turn:
    """The angle of an axis of a body from the ground's axis of that name, about another axis of the ground."""
    start, side = UNIT[own], UNIT[(about + 2) % 3]
    if k == 2:
        side = tuple(-c for c in UNIT[(about + 1) % 3])
    return Turn(Direction(body, UNIT[own]), Direction(GROUND, start), Direction(GROUND, side))
