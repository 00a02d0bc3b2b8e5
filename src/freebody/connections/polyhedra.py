"""Convex polyhedra: the corners, edges and faces of a body with plane faces, as contacts want them.

All follows from the corners and from the faces as lists of corners, counter-clockwise as seen from outside. A face is
what lies at the height `offset` along sign * normal from the mass centre; directions that are parallel are one, and
opposite faces of a box share the normal, so that measures along it are stated once. An edge goes along b from a corner;
of the two faces that meet there, with the outer normals m_1 and m_2, the first is the one into which b x m_1 points:
the one whose corners go against b.
"""

from __future__ import annotations

import itertools
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

from freebody.language.expression import ZERO, Expr, divide, number
from freebody.measures.geometry import Components, Direction, Point
from freebody.model.elements import RigidBody
from freebody.model.polynomials import Polynomial, common_factor, cross, dot, polynomial, root
from freebody.model.rotations import UNIT, along_axis, perpendiculars
from freebody.model.solids import BOX

if TYPE_CHECKING:
    from freebody.model.names import Names

# of a box, by the signs of its corners' places along x, y, z; the faces along x, y, z
SIGNS = tuple(itertools.product((-1, 1), repeat=3))
NAMES_OF_BOX = (("left", "right"), ("bottom", "top"), ("back", "front"))
Vertex = tuple[Polynomial, ...]


@dataclass(frozen=True)
class Outward:
    """The outer normal of a face, sign * along."""

    along: Direction
    sign: int = 1

    @property
    def components(self) -> Components:
        return self.along.components if self.sign > 0 else tuple(-c for c in self.along.components)


@dataclass(frozen=True)
class Side:
    """Of a face: its points have components along a direction between two values."""

    along: Direction
    low: Expr | None = None
    high: Expr | None = None


@dataclass(frozen=True)
class Face:
    """sign * (along . r) = offset, r from the mass centre, as far as its sides."""

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
    """From a corner along b; across: p, q with p x q = b; normals: m_1 and m_2 of the faces that meet in it; beyond:
    m_1 x b and b x m_2, in the planes of these faces out of them."""

    faces: tuple[str, str]  # which meet there
    start: Point
    along: Direction
    length: Expr
    across: tuple[Direction, Direction]
    normals: tuple[Outward, Outward]
    beyond: tuple[Outward, Outward]

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


def is_polyhedron(names: Names, text: str) -> bool:
    """Whether it is a body with plane faces all round."""
    body = names.bodies.get(text)
    return body is not None and (bool(body.faces) or (body.solid == BOX and ZERO not in body.sizes))


def polyhedron_of(names: Names, text: str) -> Polyhedron | None:
    """`crate`; None for what has no plane faces all round."""
    return _Made(names, names.bodies[text]).polyhedron() if is_polyhedron(names, text) else None


def corners_of(body: RigidBody) -> list[Point]:
    """The corners of a box, by the signs of their places along x, y and z, or of a convex body, in the order of its
    points."""
    if body.faces:
        on_faces = {name for _face, corners in body.faces for name in corners}
        return [body.point(name) for name in body.points if name in on_faces]
    return [_corner_of_box(body, k, signs) for k, signs in enumerate(SIGNS, 1)]


def _corner_of_box(body: RigidBody, k: int, signs: tuple[int, ...]) -> Point:
    place = tuple(number(sign) * divide(size, number(2)) for sign, size in zip(signs, body.sizes, strict=True))
    return Point(body.name, place, f"{body.name}.corner{k}")


def _faces_of(body: RigidBody, points: Sequence[Point]) -> list[tuple[str, tuple[int, ...]]]:
    """The faces by their labels, with the numbers of their corners."""
    if body.solid == BOX:
        return [
            (f"{body.name}.{name}", _face_of_box(k, sign))
            for k, pair in enumerate(NAMES_OF_BOX)
            for sign, name in zip((-1, 1), pair, strict=True)
        ]
    at = {point.name.partition(".")[2]: k for k, point in enumerate(points)}
    return [(f"{body.name}.{name}", tuple(at[corner] for corner in corners)) for name, corners in body.faces]


def _face_of_box(k: int, sign: int) -> tuple[int, ...]:
    """The corners of the face at the end of axis k, round the axes k + 1 and k + 2."""
    ends = ((-1, -1), (1, -1), (1, 1), (-1, 1))[::sign]
    return tuple(SIGNS.index((sign, p, q)[-k:] + (sign, p, q)[:-k]) for p, q in ends)


@dataclass(frozen=True)
class _Beside:
    """A face beside an edge: its label, its outer normal, and what lies in its plane out of it."""

    label: str
    normal: Outward
    beyond: Outward


class _Made:
    """A polyhedron of its corners and faces; directions that are parallel are one."""

    def __init__(self, names: Names, body: RigidBody) -> None:
        self.names, self.body = names, body
        self.points = corners_of(body)
        self.faces = _faces_of(body, self.points)
        self.places: list[Vertex] = [tuple(polynomial(c) for c in point.offset) for point in self.points]
        self.known: list[tuple[Direction, Vertex]] = []
        for axis in UNIT:
            self.known.append((Direction(body.name, axis), tuple(polynomial(c) for c in axis)))

    def polyhedron(self) -> Polyhedron:
        beside: dict[tuple[int, int], _Beside] = {}  # by the edge as its face goes along it
        faces: list[Face] = []
        for label, corners in self.faces:
            a, b, c = (self.places[k] for k in corners[:3])
            normal, unit, _size = self._directed(cross(_minus(b, a), _minus(c, b)))
            outward = [self._directed(cross(_minus(self.places[j], self.places[i]), unit)) for i, j in _round(corners)]
            beside |= {ends: _Beside(label, normal, out[0]) for ends, out in zip(_round(corners), outward, strict=True)}
            offset = dot(unit, a).expression()
            faces.append(Face(label, normal, offset, self._sides(corners, outward)))
        leaving: list[list[Outward]] = [[] for _ in self.points]
        edges: list[PolyhedronEdge] = []
        labels = [label for label, _corners in self.faces]
        for i, j in sorted(ends for ends in beside if ends[0] < ends[1]):
            along, _unit, length = self._directed(_minus(self.places[j], self.places[i]))
            leaving[i].append(along)
            leaving[j].append(Outward(along.along, -along.sign))
            start, end = (i, j) if along.sign > 0 else (j, i)
            # the face that goes against the edge comes first
            first, second = beside[end, start], beside[start, end]
            one, other = sorted((first.label, second.label), key=labels.index)
            edges.append(
                PolyhedronEdge(
                    (one.partition(".")[2], other.partition(".")[2]),
                    self.points[start],
                    along.along,
                    length,
                    self._across(along.along, first.normal.along),
                    (first.normal, second.normal),
                    (first.beyond, second.beyond),
                )
            )
        corners = tuple(Corner(point, tuple(own)) for point, own in zip(self.points, leaving, strict=True))
        return Polyhedron(self.body, corners, tuple(edges), tuple(faces))

    def _sides(self, corners: tuple[int, ...], outward: list[tuple[Outward, Vertex, Expr]]) -> tuple[Side, ...]:
        """What a face ends at: along b x m, outwards in its plane; two that are opposite are one side."""
        found: dict[Direction, Side] = {}
        for corner, (out, unit, _size) in zip(corners, outward, strict=True):
            end = dot(unit, self.places[corner])
            old = found.get(out.along, Side(out.along))
            low, high = (old.low, end.expression()) if out.sign > 0 else ((-end).expression(), old.high)
            found[out.along] = Side(out.along, low, high)
        return tuple(found.values())

    def _across(self, along: Direction, one: Direction) -> tuple[Direction, Direction]:
        """Two directions across an edge, p x q = b: the normal of a face of it, and what lies in that face."""
        if along_axis(along.components) is not None:
            p, q = (Direction(along.body, v) for v in perpendiculars(along.components))
            return p, q
        b, p = (next(unit for known, unit in self.known if known == each) for each in (along, one))
        other, _unit, _size = self._directed(cross(b, p))
        return (one, other.along) if other.sign > 0 else (other.along, one)

    def _directed(self, v: Vertex) -> tuple[Outward, Vertex, Expr]:
        """The direction of a vector, its components, and the vector's length."""
        factor = common_factor(v)
        rest = [c.over(factor) for c in v]
        own = tuple(c.whole() for c in rest if c is not None)
        known = self.known if own == tuple(rest) else []  # nothing is seen to be parallel to what is long
        value = self.names.numeric(factor.expression())
        sign = -1 if value is not None and value < 0.0 else 1
        size = root(dot(own, own))
        for direction, unit in known:
            if all(c.is_zero for c in cross(own, unit)):
                way = dot(own, unit)
                turned = sign * self._sign(way)
                return (
                    Outward(direction, turned),
                    unit if turned > 0 else tuple(-c for c in unit),
                    (factor.scaled(sign) * size).expression(),
                )
        made = tuple(_over(c.scaled(sign), size).whole() for c in own)
        direction = Direction(self.body.name, tuple(c.expression() for c in made))
        self.known.append((direction, made))
        return Outward(direction), made, (factor.scaled(sign) * size).expression()

    def _sign(self, x: Polynomial) -> int:
        value = self.names.numeric(x.expression())
        if value is None:
            q = next(iter(x.terms.values()))  # of a box without values, whose sides are positive
            return 1 if q > 0 else -1
        return 1 if value > 0.0 else -1


def _over(c: Polynomial, size: Polynomial) -> Polynomial:
    quotient = c.over(size)
    return c if quotient is None else quotient


def _round(corners: tuple[int, ...]) -> Iterator[tuple[int, int]]:
    return zip(corners, (*corners[1:], corners[0]), strict=True)


def _minus(a: Vertex, b: Vertex) -> Vertex:
    return tuple(x - y for x, y in zip(a, b, strict=True))


__all__ = [
    "Corner",
    "Face",
    "Outward",
    "Polyhedron",
    "PolyhedronEdge",
    "Side",
    "corners_of",
    "is_polyhedron",
    "polyhedron_of",
]
