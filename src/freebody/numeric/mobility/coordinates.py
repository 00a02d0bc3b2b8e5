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
from freebody.measures.geometry import GROUND, RIGHT, UP, ZERO, Point
from freebody.numeric.jets import Array
from freebody.numeric.mobility.rank import CLEAR_CUT, scaled_rows
from freebody.numeric.mobility.sparse_rows import LARGE, SparseRows
from freebody.numeric.reference import Reference
from freebody.system.system import System

_STILL = 1e-8  # of the slope of a measure, by the size of the system: less is no motion
_INDEPENDENT = 1e-6


def independent_measures(reference: Reference, q: Array) -> list[tuple[str, Measure]]:
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


def _free(reference: Reference, q: Array) -> tuple[int, Callable[[Array], Array]]:
    """How many motions are left free, and the part of a gradient (by the sizes of the system) along them."""
    rows = reference.system.held
    if LARGE < len(rows) <= len(q):
        try:
            sparse = SparseRows(scaled_rows(reference, q, rows))
            if sparse.smallest() > CLEAR_CUT:
                return len(q) - len(rows), sparse.across
        except ValueError:
            pass
    free = reference.split_at(q, {}).null / reference.sizes.unit_moves[:, None]
    basis: Array = np.linalg.qr(free)[0]
    return int(basis.shape[1]), lambda row: basis @ (basis.T @ row)


def _candidates(system: System) -> Iterator[tuple[str, Measure]]:
    yield from system.measures.items()
    yield from ((name, m) for name, m in system.offered if m not in system.measures.values())
    for body in system.moving:
        if body.turns:
            yield f"angle of {body.name}", Angle(body.name)
    origin = Point(GROUND, (ZERO, ZERO), "ground.origin")
    for body in system.moving:
        yield f"x of {body.name}", Displacement(body.mass_center, origin, RIGHT)
        yield f"y of {body.name}", Displacement(body.mass_center, origin, UP)
