"""Independent coordinates: as many measures as there are freedoms, by which a pose is told.

The user's own measures come first, then those that connections offer, then angles and places of bodies. With N a basis
of the motions that the held measures leave free, a measure is taken if its gradient times N is independent of those
taken before.
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from freebody.errors import CannotAnswer
from freebody.measures.angle import Angle
from freebody.measures.base import Measure
from freebody.measures.displacement import Displacement
from freebody.measures.geometry import GROUND, RIGHT, UP, ZERO, Point
from freebody.numeric.jets import Array
from freebody.numeric.reference import Reference
from freebody.system.system import System

_STILL = 1e-8  # of the slope of a measure, by the size of the system: less is no motion
_INDEPENDENT = 1e-6


def independent_measures(reference: Reference, q: Array) -> list[tuple[str, Measure]]:
    """Names and measures at the pose q, one for each freedom."""
    sizes = reference.sizes
    free = reference.split_at(q, {}).null / sizes.unit_moves[:, None]
    if not free.shape[1]:
        return []
    free = np.linalg.qr(free)[0] * sizes.unit_moves[:, None]
    found: list[tuple[str, Measure]] = []
    rows = np.zeros((0, free.shape[1]))
    g = reference.geometry(q, np.zeros_like(q), 0.0)
    for name, measure in _candidates(reference.system):
        try:
            row = reference.jet(g, measure, name).row(len(q)) @ free
        except CannotAnswer:
            continue
        size = float(np.linalg.norm(row))
        if size <= _STILL * sizes.length:
            continue
        more = np.vstack([rows, row / size])
        if np.linalg.matrix_rank(more, tol=_INDEPENDENT) > len(rows):
            rows = more
            found.append((name, measure))
        if len(found) == free.shape[1]:
            break
    return found


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
