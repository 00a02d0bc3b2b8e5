"""What a closed surface of triangles looks like in the plane: the edges of what it covers, and of the holes through it.

Of the triangles that face the viewer each side that none of them shares bounds what is seen. These sides close to loops
with the surface on their left; a loop counts where nothing lies on its other side: the number of layers over a point
is the sum of the winding numbers of all loops about it. What lies within a pocket or on a boss is not drawn.
"""

from __future__ import annotations

import math
from collections import defaultdict
from collections.abc import Iterable, Sequence
from itertools import pairwise

Flat = tuple[float, float]
_EDGE_ON = 1e-9  # of a normal: triangles that are seen from their side
_BESIDE = 1e-5  # by the size of the whole: how far from a loop its other side is looked at


def silhouette(corners: Sequence[Sequence[float]], triangles: Iterable[Sequence[int]]) -> list[list[int]]:
    """Loops of corners by their numbers, counter-clockwise around what is covered and clockwise around holes.
    corners: (n, 3), seen along the third; triangles: (m, 3), counter-clockwise as seen from outside."""
    ways = {way for each in triangles if _faces(*(corners[k] for k in each)) for way in pairwise((*each, each[0]))}
    loops = _loops([way for way in ways if way[::-1] not in ways])
    flat = [[(corners[k][0], corners[k][1]) for k in (*loop, loop[0])] for loop in loops]
    low, high = ([choose(c) for c in zip(*corners, strict=True)] for choose in (min, max))
    step = _BESIDE * math.dist(low, high)
    return [loop for loop, places in zip(loops, flat, strict=True) if not _layers(flat, _beside(places, step))]


def is_hole(places: Sequence[Flat]) -> bool:
    """Whether a loop goes round clockwise."""
    return sum(a[0] * b[1] - b[0] * a[1] for a, b in pairwise((*places, places[0]))) < 0


def _faces(a: Sequence[float], b: Sequence[float], c: Sequence[float]) -> bool:
    """Does a triangle face the viewer?"""
    (ux, uy, uz), (vx, vy, vz) = ([q - p for p, q in zip(a, end, strict=True)] for end in (b, c))
    height = ux * vy - uy * vx
    return height > _EDGE_ON * math.hypot(uy * vz - uz * vy, uz * vx - ux * vz, height)


def _loops(ways: list[tuple[int, int]]) -> list[list[int]]:
    """The ways put together, each of them once."""
    onwards: dict[int, list[int]] = defaultdict(list)
    for a, b in sorted(ways, reverse=True):
        onwards[a].append(b)
    found: list[list[int]] = []
    for start in sorted(onwards):
        while onwards[start]:
            loop, here = [start], onwards[start].pop()
            while here != start:
                loop.append(here)
                here = onwards[here].pop()
            found.append(loop)
    return found


def _beside(places: Sequence[Flat], step: float) -> Flat:
    """A point to the right of the longest side of a loop."""
    (ax, ay), (bx, by) = max(pairwise(places), key=lambda side: math.dist(*side))
    length = math.hypot(bx - ax, by - ay)
    return 0.5 * (ax + bx) + step * (by - ay) / length, 0.5 * (ay + by) - step * (bx - ax) / length


def _layers(loops: Iterable[Sequence[Flat]], point: Flat) -> int:
    """The sum of the winding numbers: how often loops cross the ray to the right of a point, upwards less downwards."""
    total = 0
    x, y = point
    for (ax, ay), (bx, by) in (side for places in loops for side in pairwise(places)):
        if (ay <= y) != (by <= y):
            is_left = (bx - ax) * (y - ay) - (x - ax) * (by - ay) > 0.0
            total += int(ay <= y and is_left) - int(ay > y and not is_left)
    return total
