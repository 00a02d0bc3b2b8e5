"""Which of two pieces is in front, and the order in which to draw all of them.

Two convex pieces that do not run into each other are ordered by any one line of sight that meets both: it is laid
through the middle of where they overlap on paper. Pieces that do run into each other are ordered by what is nearer
there. Drawn is from the back by a depth-first search; where pieces lie round in a circle, the mean depth decides, and
of two as deep the place in the list.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from freebody.present.figures import Array, Pair, hull

_SLIVER = 1e-6  # overlaps with less than this share of the smaller piece are none
_LEVEL = 1e-6  # depths nearer than this, by the size of the pieces, are one: round-off orders nothing
EDGE_ON = 1e-9  # of the normal of a face towards the viewer: below it the face is seen from its edge, and not looked at


@dataclass(frozen=True)
class Seen:
    """A piece as it is seen: its outline on paper (n, 2) counter-clockwise, its depth [m], and its sides as planes.

    fronts, backs: (n, 3) rows (a, b, c), depth = a x + b y + c; middle, radius: of a ball."""

    outline: Array
    depth: float
    fronts: Array
    backs: Array
    middle: Array | None = None
    radius: float = 0.0

    @cached_property
    def corners(self) -> list[Pair]:
        return [(x, y) for x, y in self.outline.tolist()]

    @cached_property
    def area(self) -> float:
        return _area(self.corners)

    def depths(self, at: Array) -> tuple[float, float]:
        """The depth of the back and of the front at a point of the outline (2,)."""
        if self.middle is not None:
            square = self.radius**2 - float(((at - self.middle[:2]) ** 2).sum())
            half = max(0.0, square) ** 0.5
            return float(self.middle[2]) - half, float(self.middle[2]) + half
        x, y = at
        front = self.fronts @ (x, y, 1.0) if len(self.fronts) else np.array([self.depth])
        back = self.backs @ (x, y, 1.0) if len(self.backs) else front
        return float(back.max()), float(front.min())


def seen_ball(middle: Array, radius: float) -> Seen:
    """middle: (3,) on paper and depth."""
    a = np.linspace(0.0, 2 * np.pi, 24, endpoint=False)
    outline = middle[:2] + radius * np.stack((np.cos(a), np.sin(a)), axis=-1)
    return Seen(outline, float(middle[2]), np.zeros((0, 3)), np.zeros((0, 3)), middle, radius)


def seen_solid(points: Array, normals: Array, corners: Array) -> Seen:
    """points: (n, 3) on paper and depth; of each face the outward normal (n_faces, 3) and a corner (n_faces, 3)."""
    steep = np.abs(normals[:, 2]) > 1e-6 * np.linalg.norm(normals, axis=1)
    n, p = normals[steep], corners[steep]
    rows = np.column_stack((-n[:, 0], -n[:, 1], (n * p).sum(axis=1))) / n[:, 2:]
    is_front = n[:, 2] > EDGE_ON
    return Seen(hull(points[:, :2]), float(points[:, 2].mean()), rows[is_front], rows[~is_front])


def back_to_front(pieces: Sequence[Seen]) -> list[int]:
    """The order in which to draw pieces."""
    behind: list[list[int]] = [[] for _ in pieces]
    low = np.array([piece.outline.min(axis=0) for piece in pieces])
    high = np.array([piece.outline.max(axis=0) for piece in pieces])
    for i in range(len(pieces)):
        meets = (low[i + 1 :] < high[i]).all(axis=1) & (high[i + 1 :] > low[i]).all(axis=1)
        for j in (np.flatnonzero(meets) + i + 1).tolist():
            sign = _compare(pieces[i], pieces[j])
            if sign:
                behind[i if sign > 0 else j].append(j if sign > 0 else i)
    order: list[int] = []
    done = [False] * len(pieces)
    level = _LEVEL * max((abs(piece.area) ** 0.5 for piece in pieces), default=0.0) or 1.0
    far = sorted(range(len(pieces)), key=lambda k: round(pieces[k].depth / level))
    rank = {k: n for n, k in enumerate(far)}
    for start in far:
        stack = [(start, False)]
        while stack:
            k, is_ready = stack.pop()
            if is_ready:
                order.append(k)
            elif not done[k]:
                done[k] = True
                stack.append((k, True))
                stack.extend((j, False) for j in sorted(behind[k], key=rank.__getitem__, reverse=True) if not done[j])
    return order


def _compare(a: Seen, b: Seen) -> int:
    """+1 where a is in front of b, -1 where it is behind, 0 where they do not overlap on paper."""
    both = overlap(a.corners, b.corners)
    if len(both) < 3 or abs(_area(both)) < _SLIVER * min(abs(a.area), abs(b.area)):
        return 0
    at = np.array(both).mean(axis=0)
    (back_a, front_a), (back_b, front_b) = a.depths(at), b.depths(at)
    slack = _LEVEL * (front_a - back_a + front_b - back_b + abs(a.area) ** 0.5 + abs(b.area) ** 0.5)
    is_before, is_behind = back_a >= front_b - slack, back_b >= front_a - slack
    if is_before != is_behind:
        return 1 if is_before else -1
    nearer = front_a - front_b
    return 0 if abs(nearer) <= slack else 1 if nearer > 0 else -1


def overlap(a: Sequence[Pair], b: Sequence[Pair]) -> list[Pair]:
    """The common part of two convex outlines, in plain numbers, because there are few of them.
    Source: Sutherland & Hodgman, Commun. ACM 17 (1974) 32."""
    kept = list(a)
    for k, (px, py) in enumerate(b):
        if not kept:
            break
        ex, ey = b[(k + 1) % len(b)][0] - px, b[(k + 1) % len(b)][1] - py
        side = [ex * (y - py) - ey * (x - px) for x, y in kept]
        found: list[Pair] = []
        for i, (x, y) in enumerate(kept):
            j = (i + 1) % len(kept)
            if side[i] >= 0:
                found.append((x, y))
            if side[i] * side[j] < 0:
                s = side[i] / (side[i] - side[j])
                found.append((x + s * (kept[j][0] - x), y + s * (kept[j][1] - y)))
        kept = found
    return kept


def _area(outline: Sequence[Pair]) -> float:
    return 0.5 * sum(x * v - y * u for (x, y), (u, v) in zip(outline, [*outline[1:], *outline[:1]], strict=True))
