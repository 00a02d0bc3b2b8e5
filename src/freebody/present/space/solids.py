"""Convex solids as points, faces and edges, from which everything in space is drawn.

Faces list their points counter-clockwise as seen from outside. An edge knows its two faces: from these follows
whether it is seen, hidden or an outline.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from itertools import pairwise
from typing import Literal, NamedTuple

import numpy as np
from numpy.typing import NDArray

from freebody.present.figures import Array

Kind = Literal["crease", "smooth", "mark"]
Face = tuple[int, ...]
N_SIDES = 64  # of a round solid


class Edge(NamedTuple):
    """From point to point, between two faces. A crease is always an edge; a smooth one only where the solid ends for
    the eye; a mark is a line on its face, seen with it."""

    start: int
    end: int
    left: int
    right: int
    kind: Kind


@dataclass(frozen=True)
class Solid:
    """points: (n, 3) [m]; `open` faces are not painted, because another solid goes on there."""

    points: Array
    faces: tuple[Face, ...]
    edges: tuple[Edge, ...] = ()
    open: frozenset[int] = frozenset()

    @cached_property
    def _fans(self) -> tuple[NDArray[np.intp], NDArray[np.intp]]:
        """The faces cut into triangles (m, 3) from their first points, and the face of each (m,)."""
        cuts = [(k, (face[0], a, b)) for k, face in enumerate(self.faces) for a, b in pairwise(face[1:])]
        triangles = np.array([cut for _k, cut in cuts], dtype=np.intp).reshape(-1, 3)  # none of a point
        return triangles, np.array([k for k, _cut in cuts], dtype=np.intp)

    def normals(self, points: Array) -> Array:
        """(n_faces, 3) outward normals with its points elsewhere, twice as long as the faces are large."""
        triangles, owners = self._fans
        a, b, c = (points[triangles[:, k]] for k in range(3))
        found = np.zeros((len(self.faces), 3))
        np.add.at(found, owners, np.cross(b - a, c - a))
        return found

    @property
    def is_smooth(self) -> bool:
        """Whether some of its faces stand for one curved surface, and it is whole: then its outline is one area."""
        return not self.open and any(edge.kind == "smooth" for edge in self.edges)

    def moved(self, axes: Array, at: Sequence[float] | Array = (0.0, 0.0, 0.0)) -> Solid:
        """Turned so that its own axes are the rows of (3, 3), then moved."""
        return replace(self, points=self.points @ axes + np.asarray(at, dtype=np.float64))


def solid(points: Array, faces: Sequence[Face], smooth: Iterable[int] = (), open: Iterable[int] = ()) -> Solid:
    """With the edges between its faces; those between two `smooth` faces are smooth, those of `open` faces none."""
    round_, skipped = frozenset(smooth), frozenset(open)
    owner = {(a, b): k for k, face in enumerate(faces) for a, b in zip(face, (*face[1:], face[0]), strict=True)}

    def edges() -> Iterator[Edge]:
        for (a, b), left in owner.items():
            right = owner[b, a]
            if a < b and not {left, right} & skipped:
                yield Edge(a, b, left, right, "smooth" if {left, right} <= round_ else "crease")

    return Solid(points, tuple(faces), chained(edges()), skipped)


def chained(edges: Iterable[Edge]) -> tuple[Edge, ...]:
    """Edges of one kind after each other, each beginning where the last one ended if it can."""
    listed = sorted(edges, key=lambda edge: edge.kind)
    at: dict[int, list[int]] = {}
    for k, edge in enumerate(listed):
        for point in edge[:2]:
            at.setdefault(point, []).append(k)
    used: set[int] = set()
    found: list[Edge] = []
    for first, begin in enumerate(listed):
        k, end = first, begin.start
        while k >= 0 and k not in used:
            used.add(k)
            edge = listed[k] if listed[k].start == end else _reversed(listed[k])
            found.append(edge)
            end = edge.end
            k = next((j for j in at[end] if j not in used and listed[j].kind == edge.kind), -1)
    return tuple(found)


def _reversed(edge: Edge) -> Edge:
    return Edge(edge.end, edge.start, edge.right, edge.left, edge.kind)


def basis(axis: Sequence[float] | Array) -> Array:
    """(3, 3) rows of a right-handed frame whose third is the axis; for z the axes themselves."""
    w = np.asarray(axis, dtype=np.float64)
    w = w / np.linalg.norm(w)
    start = np.eye(3)[0 if abs(w[0]) < 0.9 else 1]
    u = start - (start @ w) * w
    u = u / np.linalg.norm(u)
    return np.array([u, np.cross(w, u), w], dtype=np.float64)


def box(a: float, b: float, c: float) -> Solid:
    """With sides a, b, c along x, y, z about the origin."""
    signs = np.array([(i, j, k) for k in (-1, 1) for j in (-1, 1) for i in (-1, 1)], dtype=np.float64)
    faces = ((0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5))
    return solid(signs * (0.5 * a, 0.5 * b, 0.5 * c), faces)


def prism(radius: float, low: float, high: float, n: int = N_SIDES, *, is_open: bool = False) -> Solid:
    """A round bar along z from low to high, its caps the last two faces."""
    a = np.linspace(0.0, 2 * np.pi, n, endpoint=False)
    rim = radius * np.stack((np.cos(a), np.sin(a)), axis=-1)
    points = np.concatenate([np.column_stack((rim, np.full(n, z))) for z in (low, high)])
    sides = [(k, (k + 1) % n, n + (k + 1) % n, n + k) for k in range(n)]
    faces = [*sides, tuple(range(n - 1, -1, -1)), tuple(range(n, 2 * n))]
    return solid(points, faces, range(n), (n, n + 1) if is_open else ())


def turned_on_axis(profile: Sequence[tuple[float, float]], n: int = N_SIDES) -> Solid:
    """A convex solid of revolution about z, by the radii and heights of its circles from below; its caps the last two
    faces."""
    a = np.linspace(0.0, 2 * np.pi, n, endpoint=False)
    points = np.concatenate([np.column_stack((r * np.cos(a), r * np.sin(a), np.full(n, z))) for r, z in profile])
    m = len(profile) - 1
    sides = [
        (j * n + k, j * n + (k + 1) % n, (j + 1) * n + (k + 1) % n, (j + 1) * n + k) for j in range(m) for k in range(n)
    ]
    faces = [*sides, tuple(range(n - 1, -1, -1)), tuple(range(m * n, (m + 1) * n))]
    return solid(points, faces, range(m * n))


def marked(bar: Solid, n_teeth: int = 1) -> Solid:
    """A round bar with a radius on each cap, so that its turning is seen, and lines along its side: one, or teeth."""
    n = len(bar.points) // 2
    middles = np.array([bar.points[:n].mean(axis=0), bar.points[n:].mean(axis=0)])
    step = max(1, n // n_teeth)
    edges = [e._replace(kind="mark") if e.end == e.start + n and e.start % step == 0 else e for e in bar.edges]
    edges += [Edge(2 * n, 0, n, n, "mark"), Edge(2 * n + 1, n, n + 1, n + 1, "mark")]
    return replace(bar, points=np.concatenate((bar.points, middles)), edges=tuple(edges))


def cone(radius: float, height: float, n: int = N_SIDES) -> Solid:
    """With its apex at the origin and the middle of its base at z = height."""
    a = np.linspace(0.0, 2 * np.pi, n, endpoint=False)
    rim = np.column_stack((radius * np.cos(a), radius * np.sin(a), np.full(n, height)))
    points = np.concatenate((rim, [(0.0, 0.0, 0.0), (0.0, 0.0, height)]))
    sides = [(n, (k + 1) % n, k) for k in range(n)]
    return solid(points, [*sides, tuple(range(n))], range(n))


def marked_cone(radius: float, height: float) -> Solid:
    """A cone with a line along its side and a radius on its base, so that its turning is seen."""
    plain, n = cone(radius, height), N_SIDES
    edges = [e._replace(kind="mark") if {e.start, e.end} == {0, n} else e for e in plain.edges]
    return replace(plain, edges=(*edges, Edge(n + 1, 0, n, n, "mark")))


def plate(corners: Array) -> Solid:
    """A flat sheet (n, 3) without thickness, seen from both sides."""
    n = len(corners)
    front = tuple(range(n))
    edges = tuple(Edge(k, (k + 1) % n, 0, 1, "crease") for k in range(n))
    return Solid(corners, (front, front[::-1]), edges)


def band(radius: float, half_width: float, half_depth: float, n: int = 64) -> list[Solid]:
    """A hoop about z, as wide along z and as deep as said, in parts that stand one in front of the other."""
    inner, outer = radius - half_depth, radius + half_depth
    parts: list[Solid] = []
    for k in range(n):
        ends = [2 * np.pi * (k + i) / n for i in (0, 1)]
        section = [(outer, -half_width), (outer, half_width), (inner, half_width), (inner, -half_width)]
        points = np.array([(r * np.cos(a), r * np.sin(a), z) for a in ends for r, z in section])
        sides = [(i, 4 + i, 4 + (i + 1) % 4, (i + 1) % 4) for i in range(4)]
        parts.append(solid(points, [*sides, (0, 1, 2, 3), (7, 6, 5, 4)], (), (4, 5)))
    return parts


def tube(way: Array, radius: float, n: int = 8) -> list[Solid]:
    """A line (m, 3) with a thickness, in straight parts that are mitred where they meet."""
    ends = [(a, b) for a, b in pairwise(way) if float(np.linalg.norm(b - a)) > 1e-12]
    along = [(b - a) / float(np.linalg.norm(b - a)) for a, b in ends]
    is_ring = len(ends) > 2 and float(np.linalg.norm(ends[0][0] - ends[-1][1])) < 1e-9
    parts: list[Solid] = []
    for k, (a, b) in enumerate(ends):
        before = along[k - 1] if k or is_ring else along[k]
        after = along[(k + 1) % len(ends)] if k + 1 < len(ends) or is_ring else along[k]
        bar = prism(radius, 0.0, float(np.linalg.norm(b - a)), n, is_open=True).moved(basis(b - a), a)
        caps = [_slid(bar.points[:n], a, along[k], before), _slid(bar.points[n:], b, along[k], after)]
        parts.append(replace(bar, points=np.concatenate(caps)))
    return parts


def _slid(rim: Array, at: Array, along: Array, other: Array) -> Array:
    """(n, 3) points of a rim moved along a bar into the plane that halves the angle to the next bar."""
    normal = along + other
    slope = float(along @ normal)
    return rim if slope < 0.2 else rim - np.outer((rim - at) @ normal / slope, along)
