"""Convex polyhedra: the corners, edges and faces of a body with plane faces, as contacts want them.

A face is what lies at the height `offset` along sign * normal from the reference point; opposite faces of a box share
the normal, so that measures along it are stated once. An edge goes along b from a corner; of the two faces that meet
there, with the outer normals m_1 and m_2, the first is the one into which b x m_1 points.
"""

from __future__ import annotations

import itertools
from dataclasses import dataclass
from typing import TYPE_CHECKING

from freebody.language.expression import ZERO, Expr, divide, negate, number
from freebody.measures.geometry import Direction, Point
from freebody.model.elements import RigidBody
from freebody.model.solids import BOX
from freebody.model.spins import body_axes

if TYPE_CHECKING:
    from freebody.model.names import Names

SIDES = (("left", "right"), ("bottom", "top"), ("back", "front"))  # of a box along x, y, z


@dataclass(frozen=True)
class Outward:
    """The outer normal of a face, sign * along."""

    along: Direction
    sign: int = 1


@dataclass(frozen=True)
class Side:
    """Of a face: its points have components along a direction between two values."""

    along: Direction
    low: Expr | None = None
    high: Expr | None = None


@dataclass(frozen=True)
class Face:
    """sign * (along . r) = offset, r from the reference point, as far as its sides."""

    label: str
    normal: Outward
    offset: Expr
    sides: tuple[Side, ...]


@dataclass(frozen=True)
class Corner:
    """With the directions of its edges away from it."""

    point: Point
    leaving: tuple[Outward, ...]


@dataclass(frozen=True)
class PolyhedronEdge:
    """From a corner along a direction; normals: m_1 and m_2 of the faces that meet in it."""

    faces: tuple[str, str]  # which meet there
    start: Point
    along: Direction
    length: Expr
    normals: tuple[Outward, Outward]

    def label(self, sign: int) -> str:
        """`crate top-front`, and `crate front-top` the other way round."""
        return f"{self.start.body} {'-'.join(self.faces[::sign])}"


@dataclass(frozen=True)
class Polyhedron:
    """A convex one."""

    body: RigidBody
    corners: tuple[Corner, ...]
    edges: tuple[PolyhedronEdge, ...]
    faces: tuple[Face, ...]


def polyhedron_of(names: Names, text: str) -> Polyhedron | None:
    """`crate`; None for what has no plane faces all round."""
    body = names.bodies.get(text)
    if body is None or body.solid != BOX or ZERO in body.sizes:
        return None
    return _box(body)


def corners_of_box(body: RigidBody) -> list[Point]:
    """The eight corners, by the signs of their places along x, y and z."""
    return [_corner(body, k, signs) for k, signs in enumerate(itertools.product((-1, 1), repeat=3), 1)]


def _corner(body: RigidBody, k: int, signs: tuple[int, ...]) -> Point:
    place = tuple(number(sign) * divide(size, number(2)) for sign, size in zip(signs, body.sizes, strict=True))
    return Point(body.name, place, f"{body.name}.corner{k}")


def _box(body: RigidBody) -> Polyhedron:
    axes = body_axes(body.name)
    halves = [divide(size, number(2)) for size in body.sizes]
    limits = [Side(along, negate(half), half) for along, half in zip(axes, halves, strict=True)]
    faces = [
        Face(f"{body.name}.{name}", Outward(axes[k], sign), halves[k], (limits[(k + 1) % 3], limits[(k + 2) % 3]))
        for k in range(3)
        for sign, name in zip((-1, 1), SIDES[k], strict=True)
    ]
    points = corners_of_box(body)
    signs = list(itertools.product((-1, 1), repeat=3))
    corners = [
        Corner(point, tuple(Outward(along, -sign) for along, sign in zip(axes, own, strict=True)))
        for point, own in zip(points, signs, strict=True)
    ]
    edges: list[PolyhedronEdge] = []
    for point, own in zip(points, signs, strict=True):
        for k in range(3):
            if own[k] < 0:
                edges.append(_edge_of_box(body, point, own, k))
    return Polyhedron(body, tuple(corners), tuple(edges), tuple(faces))


def _edge_of_box(body: RigidBody, start: Point, signs: tuple[int, ...], k: int) -> PolyhedronEdge:
    """Along axis k: e_k x s e_k+1 = s e_k+2 points into the face of e_k+1 where the edge is at the other end of e_k+2,
    s' = -s; else e_k x s' e_k+2 = -s' e_k+1 points into that of e_k+2, with s = s'."""
    axes, (p, q) = body_axes(body.name), ((k + 1) % 3, (k + 2) % 3)
    one, other = Outward(axes[p], signs[p]), Outward(axes[q], signs[q])
    first, second = (SIDES[j][(signs[j] + 1) // 2] for j in sorted((p, q)))
    normals = (one, other) if signs[p] != signs[q] else (other, one)
    return PolyhedronEdge((first, second), start, axes[k], body.sizes[k], normals)


__all__ = ["Corner", "Face", "Outward", "Polyhedron", "PolyhedronEdge", "Side", "corners_of_box", "polyhedron_of"]
