"""Where two convex polyhedra can touch: corners of either on faces of the other, and edges on edges.

A corner C of one body is at the height h = m . (C - P) over a face of the other, m its outer normal. It touches where
C is between the sides of the face and all edges c of the corner lead away from it, m . c >= 0: then -m is one of the
normals that the body has there. It slips with the face's plane as a point on a plane does.

Two edges, along a from A and along b from B, have the common normal n = s (a x b)/w, w = |a x b|, s = 1 or -1. With
p, q across b, p x q = b, the components a_p, a_q of a and d_p, d_q, d_b of d = A - B, and c = a . b,

    w = sqrt(a_p^2 + a_q^2),       gap  n . d = s (a_q d_p - a_p d_q)/w,
    foot on a from A               sigma = -(a_p d_p + a_q d_q)/w^2,         on b from B      d_b + sigma c,

and they touch where both feet are on the edges, n points out of both faces of b and -n out of both of a. With the faces
ordered as in `polyhedra` the first of b is on the side of n where n . (b x m_1) = -s (a . m_1)/w <= 0, so

    s a.m_1 >= 0,  s a.m_2 <= 0  for the faces of b,        s b.k_1 >= 0,  s b.k_2 <= 0  for those of a:

the arcs of both edges on the sphere of normals cross. The slip is that of the material point A + sigma a along b and
across it, along (a_p p + a_q q)/w, where a_p a_p' + a_q a_q' = w w'. Edges that are nearly parallel (w below a bound)
have no normal of their own: their contact is that of corners on faces. Bodies that touch along faces do so at the
corners of the polygon that they share: at corners on faces and at crossing edges. Sources: Ericson, Real-Time Collision
Detection, 2005, sec. 5.1.8 (nearest points of lines) and 5.2.1 (separating axes); Gregorius, The Separating Axis Test
between Convex Polyhedra, GDC 2013 (arcs of edges); Baraff, Computer Graphics 23 (1989) 223-232 (contact points of
polyhedra).
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from fractions import Fraction
from typing import TYPE_CHECKING

from freebody.connections.contact_places import ContactPlace
from freebody.connections.places_on_planes import PlaceOnPlane
from freebody.connections.polyhedra import Corner, Face, Outward, Polyhedron, PolyhedronEdge, polyhedron_of
from freebody.language.expression import ONE, ZERO, Call, Expr, Symbol, free_symbols, negate, number
from freebody.language.units import DIMENSIONLESS, LENGTH, Dimension
from freebody.measures.base import Measure
from freebody.measures.combination import Composed
from freebody.measures.displacement import Displacement
from freebody.measures.geometry import Direction
from freebody.measures.turn import Alignment
from freebody.model.elements import BodyPlane, NonholonomicForm, Span, at_least
from freebody.model.spins import constant, spin

if TYPE_CHECKING:
    from freebody.model.names import Names

PARALLEL = number(Fraction(1, 10**4))  # w, the sine of their angle, below which edges are parallel
LEAST = number(Fraction(1, 10**10))  # of w^2, so that nothing is divided by zero
AP, AQ, DP, DQ, DB, AB = (Symbol(name) for name in ("@ap", "@aq", "@dp", "@dq", "@db", "@ab"))
W2 = AP * AP + AQ * AQ
BOUNDED = (W2 + LEAST + Call("abs", W2 - LEAST)) / 2  # the greater one
W = Call("sqrt", BOUNDED)
GAP = (AQ * DP - AP * DQ) / W
FOOT_ON_A = negate(AP * DP + AQ * DQ) / BOUNDED
FOOT_ON_B = DB + FOOT_ON_A * AB
ACROSS = AP / W, AQ / W


def places_of_polyhedra(names: Names, first: str, second: str) -> list[ContactPlace]:
    """The places at which two bodies, or a point and a body, can touch; none where one is no convex polyhedron."""
    one, other = (polyhedron_of(names, text) for text in (first, second))
    if one is None or other is None:
        solid, text = (other, first) if one is None else (one, second)
        point = None if solid is None else _point(names, text)
        return [] if solid is None or point is None else [_on_face(point, face, solid) for face in solid.faces]
    found = [_on_face(corner, face, other) for corner in one.corners for face in other.faces]
    found += [_on_face(corner, face, one) for corner in other.corners for face in one.faces]
    for a in one.edges:
        for b in other.edges:
            found += _EdgePair(a, b, one, other).places()
    return found


def _point(names: Names, text: str) -> Corner | None:
    """A point of a body, or a particle, which touches faces from all directions; None for what is extended."""
    owner, dot, _name = text.partition(".")
    return Corner(names.point(text, "between"), ()) if dot or not names.known(owner).turns else None


# -- corners on faces ----------------------------------------------------------------------------
def _on_face(corner: Corner, face: Face, of: Polyhedron) -> ContactPlace:
    middle = of.body.mass_center
    plane = BodyPlane(middle, face.normal.along, face.label)
    height = Displacement(corner.point, middle, face.normal.along)
    sign = face.normal.sign
    target = face.offset if sign > 0 else negate(face.offset)
    place = PlaceOnPlane(corner.point.name, corner.point, height, target, None).on(plane, face.label)
    beside = [Span(Displacement(corner.point, middle, side.along), side.low, side.high) for side in face.sides]
    above = [at_least(Alignment(c.along, face.normal.along), c.sign * sign) for c in corner.leaving]
    obstacle = f"{corner.point.name} in {of.body.name}"
    bodies = corner.point.body, of.body.name
    return replace(place, sign=sign, within=(*beside, *above), obstacle=obstacle, bodies=bodies, is_separating=True)


# -- edges on edges ------------------------------------------------------------------------------
class _EdgePair:
    """Gap, slip and turning of two edges."""

    def __init__(self, a: PolyhedronEdge, b: PolyhedronEdge, one: Polyhedron, other: Polyhedron) -> None:
        self.a, self.b, self.one, self.other = a, b, one, other
        p, q = self.across = b.across
        alignments = ("@ap", p), ("@aq", q), ("@ab", b.along)
        self.turns: dict[str, Measure] = {name: Alignment(a.along, along) for name, along in alignments}
        moves = ("@dp", p), ("@dq", q), ("@db", b.along)
        self.moves: dict[str, Measure] = {name: Displacement(a.start, b.start, along) for name, along in moves}

    def places(self) -> Iterator[ContactPlace]:
        """Both ways in which the edges can cross."""
        gap = self._composed(GAP, LENGTH)
        feet = (
            Span(self._composed(W, DIMENSIONLESS), low=PARALLEL),
            Span(self._composed(FOOT_ON_A, LENGTH), ZERO, self.a.length),
            Span(self._composed(FOOT_ON_B, LENGTH), ZERO, self.b.length),
        )
        slip = self._slip()
        for sign in (1, -1):
            arcs = (*self._arc(self.a.along, self.b.normals, sign), *self._arc(self.b.along, self.a.normals, sign))
            yield ContactPlace(
                self.a.label(sign),
                self.b.label(1),
                gap,
                ZERO,
                slip,
                ("1", "2"),
                self._rolling,
                self._spinning,
                sign,
                (*feet, *arcs),
                f"{self.a.label(1)} on {self.b.label(1)}",
                (self.one.body.name, self.other.body.name),
                is_crossing=True,
                is_separating=True,
            )

    def _arc(self, along: Direction, normals: tuple[Outward, Outward], sign: int) -> Iterator[Span]:
        for normal, way in zip(normals, (1, -1), strict=True):
            yield at_least(Alignment(along, normal.along), way * sign * normal.sign)

    def _composed(self, expression: Expr, dimension: Dimension) -> Composed:
        """Of what occurs in it, so that edges along the same directions share what depends on these alone."""
        own = free_symbols(expression)
        seen = tuple((name, measure) for name, measure in (self.turns | self.moves).items() if name in own)
        return Composed(expression, seen, dimension, here=True)

    def _slip(self) -> tuple[NonholonomicForm, NonholonomicForm]:
        """With sigma as it is now: along b d_b' + sigma c', across it (a_p d_p' + a_q d_q')/w + sigma w'."""
        sigma = self._composed(FOOT_ON_A, LENGTH)
        along = (constant(ONE), self.moves["@db"]), (sigma, self.turns["@ab"])
        shares = [self._composed(share, DIMENSIONLESS) for share in ACROSS]
        across = (
            *zip(shares, (self.moves["@dp"], self.moves["@dq"]), strict=True),
            (sigma, self._composed(W, DIMENSIONLESS)),
        )
        return NonholonomicForm(along, LENGTH), NonholonomicForm(across, LENGTH)

    def _rolling(self) -> tuple[NonholonomicForm, NonholonomicForm]:
        return spin(self.one.body.name, self.b.along, self.other.body.name), self._mixed(*ACROSS)

    def _spinning(self) -> NonholonomicForm:
        return self._mixed(AQ / W, negate(AP) / W)

    def _mixed(self, *shares: Expr) -> NonholonomicForm:
        """The angular velocity along a direction across b, by its components along p and q."""
        terms: list[tuple[Measure, Measure]] = []
        for share, along in zip(shares, self.across, strict=True):
            for coefficient, rate in spin(self.one.body.name, along, self.other.body.name).terms:
                assert isinstance(coefficient, Composed)
                seen = (*self.turns.items(), *coefficient.measures)
                along_p_q = Composed(share * coefficient.expression, seen, DIMENSIONLESS, here=True)
                terms.append((along_p_q, rate))
        return NonholonomicForm(tuple(terms), DIMENSIONLESS)


__all__ = ["places_of_polyhedra"]
