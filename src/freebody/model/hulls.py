"""The convex hull of a few points in numbers: its faces, by the corners of each.

A plane through three of the points that has all others on one side carries a face, which is the hull of all points in
that plane. That is O(n^4), and exact in what belongs to a face. Source: Preparata & Shamos, Computational Geometry,
1985, sec. 3.4; of points in a plane: Andrew, Information Processing Letters 9 (1979) 216-219.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Sequence

Triple = tuple[float, float, float]

SAME = 1e-9  # by the size of the whole: points that are nearer to a plane lie in it
MOST_POINTS = 40


def faces_of_hull(points: Sequence[Triple], same: float = SAME) -> list[tuple[int, ...]]:
    """The corners of every face by their numbers, counter-clockwise as seen from outside, each from its lowest number
    on, in the order of these lists; none where all points lie in a plane. same: what counts as in a plane, by the size
    of the whole."""
    slack = same * max((math.dist(points[0], p) for p in points), default=0.0)
    found: dict[frozenset[int], tuple[int, ...]] = {}
    kept: list[int] = []  # one place that is given twice is one corner
    for k, p in enumerate(points):
        if all(math.dist(p, points[j]) > slack for j in kept):
            kept.append(k)
    for triple in itertools.combinations(kept, 3):
        if any(known.issuperset(triple) for known in found):
            continue
        a, b, c = (points[k] for k in triple)
        normal = _cross(_minus(b, a), _minus(c, a))
        size = math.hypot(*normal)
        if size <= slack * slack:
            continue
        heights = [_dot(_minus(points[k], a), normal) / size for k in kept]
        below, above = max(heights) <= slack, min(heights) >= -slack
        if below and above:
            return []
        if below or above:
            outward = normal if below else _minus((0.0, 0.0, 0.0), normal)
            members = [k for k, height in zip(kept, heights, strict=True) if abs(height) <= slack]
            found[frozenset(members)] = _around(points, members, outward, slack)
    return sorted(found.values())


def outline_of_hull(points: Sequence[Triple], same: float = SAME) -> tuple[int, ...]:
    """The corners of the hull of points with z = 0, counter-clockwise."""
    spread = [max(p[k] for p in points) - min(p[k] for p in points) for k in range(2)]
    return _around(points, list(range(len(points))), (0.0, 0.0, 1.0), same * math.hypot(*spread))


def _around(points: Sequence[Triple], members: list[int], outward: Triple, slack: float) -> tuple[int, ...]:
    """The corners of the hull of points in a plane, counter-clockwise about the normal."""
    first = points[members[0]]
    far = max((_minus(points[k], first) for k in members), key=lambda v: math.hypot(*v))
    u, v = _unit(far), _unit(_cross(outward, far))
    flat = {k: (_dot(_minus(points[k], first), u), _dot(_minus(points[k], first), v)) for k in members}

    def chain(ordered: list[int]) -> list[int]:
        kept: list[int] = []
        for k in ordered:
            while len(kept) > 1:
                (ax, ay), (bx, by), (x, y) = (flat[j] for j in (*kept[-2:], k))
                if (bx - ax) * (y - ay) - (by - ay) * (x - ax) > slack * math.hypot(x - ax, y - ay):
                    break
                kept.pop()
            kept.append(k)
        return kept[:-1]

    ordered = sorted(members, key=lambda k: (round(flat[k][0] / slack), flat[k][1]))
    ring = chain(ordered) + chain(ordered[::-1])
    start = ring.index(min(ring))
    return tuple(ring[start:] + ring[:start])


def _minus(a: Triple, b: Triple) -> Triple:
    return a[0] - b[0], a[1] - b[1], a[2] - b[2]


def _unit(v: Triple) -> Triple:
    size = math.hypot(*v)
    return v[0] / size, v[1] / size, v[2] / size


def _dot(a: Triple, b: Triple) -> float:
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def _cross(a: Triple, b: Triple) -> Triple:
    return a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]
