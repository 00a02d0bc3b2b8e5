"""Where a cylinder or a disk can touch a convex polyhedron.

With a the axis, R the radius, C the middle and E the middle of a rim, m the outer normal of a face, in axes of the
polyhedron; b an edge from A, p x q = b:

    a flat end on a face   all of it, a moment about its middle being R times the normal force at most,
    a rim on a face        where the rim is lowest, E + r,  r = -R (m - (a.m) a)/w,  w = sqrt(1 - (a.m)^2),
                           gap m.E - h - R w,               between the sides of the face;
    the side on an edge    n = s (a x b)/|a x b|,           gap n.(C - A) - R, both feet as of two edges;
    a rim on an edge       where the edge goes through the plane of the rim, X = A + b (a.(E - A))/(a.b),
                           gap (|X - E| - R)/sqrt(1 + k^2), n = -(u - k a)/sqrt(1 + k^2),  u = (X - E)/|X - E|,
                           k = u.b/a.b:  n is across the edge and the tangent a x u of the rim;
    a corner               on the side, rho - R, or on an end, z - L/2, in axes of the cylinder, as of a point.

A normal is one that both bodies have there: n is between the normals of the faces of the edge, and -n between u and the
outward axis, so that k >= 0 at the start of a cylinder and <= 0 at its end. A line along which a lying cylinder touches
is its ends. A cylinder that stands flat across an edge of a face, touching part of it, is refused. Source: Ericson,
Real-Time Collision Detection, 2005, sec. 5.1.8; Kosenko & Alexandrov, Multibody System Dynamics 12 (2004), for rims.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING

from freebody.connections.contact_places import COS, HEIGHT, SIN, ContactPlace, PivotPlace, settings_of
from freebody.connections.frames_of_contact import ContactFrame
from freebody.connections.places_of_polyhedra import (
    AB,
    ACROSS,
    AP,
    AQ,
    DB,
    DP,
    DQ,
    FOOT_ON_A,
    FOOT_ON_B,
    GAP,
    LEAST,
    PARALLEL,
    W,
)
from freebody.connections.places_on_planes import FLAT, along_plane, bounded
from freebody.connections.polyhedra import Corner, Face, Polyhedron, PolyhedronEdge, polyhedron_of
from freebody.language.expression import ONE, ZERO, Call, Expr, Symbol, divide, negate, number
from freebody.language.sentences import Message
from freebody.language.units import DIMENSIONLESS, LENGTH
from freebody.measures.geometry import Components, Direction, Point
from freebody.measures.turn import Alignment
from freebody.model.elements import BodyPlane, RigidBody, Span, at_least
from freebody.model.polynomials import dot as exact_dot
from freebody.model.polynomials import polynomial
from freebody.model.rotations import dot, perpendiculars
from freebody.model.solids import CYLINDER, DISK
from freebody.model.spins import body_axes

if TYPE_CHECKING:
    from freebody.model.names import Names

D = (Symbol("@d1"), Symbol("@d2"), Symbol("@d3"))
A = (Symbol("@a1"), Symbol("@a2"), Symbol("@a3"))


@dataclass(frozen=True)
class Rim:
    """The edge of a flat end; outward: of the cylinder, along its axis or against it, 0 for a disk."""

    label: str
    center: Point
    outward: int


@dataclass(frozen=True)
class Round:
    """A cylinder, or a disk as one without length."""

    body: RigidBody
    center: Point
    radius: Expr
    length: Expr | None
    rims: tuple[Rim, ...]

    @property
    def axis(self) -> Direction:
        return Direction(self.body.name, self.body.axis)


def round_of(names: Names, text: str) -> Round | None:
    """`can`; None for what is no cylinder or disk. A bore is left out of account (the hull touches)."""
    body = names.bodies.get(text)
    if body is None or body.solid not in (CYLINDER, DISK):
        return None
    if body.solid == DISK:
        return Round(body, body.center, body.sizes[0], None, (Rim(body.name, body.center, 0),))
    rims = (Rim(f"{text}.{end}", body.point(end), out) for end, out in (("start", -1), ("end", 1)))
    return Round(body, body.center, body.sizes[0], body.sizes[1], tuple(rims))


def places_of_rims(names: Names, first: str, second: str) -> list[ContactPlace]:
    """The places at which a cylinder or a disk can touch a polyhedron; none for another pair."""
    can = round_of(names, first)
    solid = None if can is None else polyhedron_of(names, second)
    if can is None or solid is None:
        return []
    found = [place for rim in can.rims for face in solid.faces for place in _ends_on(can, rim, face, solid)]
    for edge in solid.edges:
        found += [] if can.length is None else _side_on_edge(can, can.length, edge, solid)
        found += [_rim_on_edge(can, rim, edge, solid) for rim in can.rims]
    for corner in solid.corners:
        found += _corner_on(can, corner, solid)
    return found


# -- rims and flat ends on faces -----------------------------------------------------------------
def _ends_on(can: Round, rim: Rim, face: Face, solid: Polyhedron) -> Iterator[ContactPlace]:
    """A rim, as long as it is tilted, and all that it surrounds where it is flat."""
    middle, axes, m = solid.body.mass_center, body_axes(solid.body.name), face.normal.components
    turned = [(s.name, Alignment(can.axis, e)) for s, e in zip(A, axes, strict=True)]
    frame = ContactFrame.of(rim.center, middle, axes, D, *turned)
    p, q = (along.components for along in along_plane(BodyPlane(middle, face.normal.along)))
    leaning = dot(A, m)
    square = dot(A, p) * dot(A, p) + dot(A, q) * dot(A, q)  # 1 - (a.m)^2, without the loss of digits
    size = Call("sqrt", bounded(square, LEAST))
    arm = tuple(negate(can.radius) * (c - leaning * a) / size for c, a in zip(m, A, strict=True))
    lowest = tuple(d + r for d, r in zip(D, arm, strict=True))
    beside = tuple(
        Span(frame.composed(dot(side.along.components, lowest), LENGTH), side.low, side.high) for side in face.sides
    )
    tilted = frame.composed(size - FLAT, DIMENSIONLESS)
    yield ContactPlace(
        rim.label,
        face.label,
        frame.composed(dot(m, D) - can.radius * size, LENGTH),
        face.offset,
        (frame.slip(p, arm), frame.slip(q, arm)),
        ("1", "2"),
        lambda: (frame.turning(p), frame.turning(q)),
        lambda: frame.turning(m),
        within=(*beside, Span(tilted, low=ZERO)),
        obstacle=f"{rim.label} in {solid.body.name}",
        bodies=(can.body.name, solid.body.name),
        pitfall=Message("{rim} lies flat on {face}", rim=rim.label, face=face.label),
        lost=tilted,
    )
    flat, touched, least = FLAT - size, list[Span](), FLAT - size
    # what is beyond a side, in parts of the radius, makes it less than flat
    for side in face.sides:
        place = dot(side.along.components, D)
        low = None if side.low is None else side.low - can.radius
        high = None if side.high is None else side.high + can.radius
        touched.append(Span(frame.composed(place, LENGTH), low, high))
        inside = [] if side.low is None else [place - side.low]
        inside += [] if side.high is None else [side.high - place]
        for room in inside:
            beyond = ONE - room / can.radius
            least = least - (beyond + Call("abs", beyond)) / 2
    lost = frame.composed(least, DIMENSIONLESS)
    yield ContactPlace(
        rim.label,
        face.label,
        frame.composed(dot(m, D), LENGTH),
        face.offset,
        (frame.slip(p), frame.slip(q)),
        ("1", "2"),
        lambda: (frame.turning(p), frame.turning(q)),
        lambda: frame.turning(m),
        within=(*touched, Span(frame.composed(flat, DIMENSIONLESS), low=ZERO), Span(lost)),
        obstacle=f"flat {rim.label} in {solid.body.name}",
        bodies=(can.body.name, solid.body.name),
        pitfall=Message("{rim} lies flat across an edge of {face}, with part of it", rim=rim.label, face=face.label),
        lost=lost,
        reach=can.radius,
        pivot=_pivot(can, rim, face, solid),
    )


def _pivot(can: Round, rim: Rim, face: Face, solid: Polyhedron) -> PivotPlace:
    """The point of the rim about which a flat end on a face tips."""
    middle, axes, m = solid.body.mass_center, body_axes(solid.body.name), face.normal.components
    known, across = (
        settings_of(rim.label, face.label),
        [Direction(can.body.name, v) for v in perpendiculars(can.body.axis)],
    )
    turned = [(f"@b{j}{k}", Alignment(b, e)) for j, b in enumerate(across) for k, e in enumerate(axes)]
    frame = ContactFrame.of(rim.center, middle, axes, D, *turned, *known)
    b = [tuple(Symbol(f"@b{j}{k}") for k in range(3)) for j in range(2)]
    arm = tuple(can.radius * (COS * x + SIN * y) for x, y in zip(*b, strict=True))
    directions = along_plane(BodyPlane(middle, face.normal.along))
    p, q = (along.components for along in directions)
    place = ContactPlace(
        rim.label,
        face.label,
        frame.composed(dot(m, D) + dot(m, arm) - face.offset - HEIGHT, LENGTH),
        ZERO,
        (frame.slip(p, arm), frame.slip(q, arm)),
        ("1", "2"),
        lambda: (frame.turning(p), frame.turning(q)),
        lambda: frame.turning(m),
        bodies=(can.body.name, solid.body.name),
    )
    lowest = tuple(frame.composed(dot(m, own), DIMENSIONLESS) for own in b)
    along = tuple(tuple(Alignment(each, d) for d in directions) for each in across)
    settings = tuple(measure for _name, measure in known)
    return PivotPlace(place, settings, lowest, along, face.normal.sign)  # pyrefly: ignore[bad-argument-type]


# -- on edges ------------------------------------------------------------------------------------
def _frame_of(edge: PolyhedronEdge, point: Point, can: Round) -> ContactFrame:
    axes = (*edge.across, edge.along)
    turned = [(s.name, Alignment(can.axis, e)) for s, e in zip((AP, AQ, AB), axes, strict=True)]
    return ContactFrame.of(point, edge.start, axes, (DP, DQ, DB), *turned)


def _side_on_edge(can: Round, length: Expr, edge: PolyhedronEdge, solid: Polyhedron) -> Iterator[ContactPlace]:
    """Both ways in which it can lie across the edge."""
    frame = _frame_of(edge, can.center, can)
    half = divide(length, number(2))
    feet = (
        Span(frame.composed(W, DIMENSIONLESS), low=PARALLEL),
        Span(frame.composed(FOOT_ON_A, LENGTH), negate(half), half),
        Span(frame.composed(FOOT_ON_B, LENGTH), ZERO, edge.length),
    )
    along, across = (ZERO, ZERO, ONE), (*ACROSS, ZERO)
    for sign in (1, -1):
        n = (number(sign) * AQ / W, number(-sign) * AP / W, ZERO)
        arm = tuple(FOOT_ON_A * a - can.radius * c for a, c in zip((AP, AQ, AB), n, strict=True))
        arcs = (
            at_least(Alignment(can.axis, normal.along), way * sign * normal.sign)
            for normal, way in zip(edge.normals, (1, -1), strict=True)
        )
        yield ContactPlace(
            can.body.name,
            edge.label(sign),
            frame.composed(GAP, LENGTH),
            number(sign) * can.radius,
            (frame.slip(along, arm), frame.slip(across, arm)),
            ("1", "2"),
            lambda: (frame.turning(along), frame.turning(across)),
            lambda n=n: frame.turning(n),
            sign,
            (*feet, *arcs),
            f"{can.body.name} on {edge.label(1)}",
            (can.body.name, solid.body.name),
            is_crossing=True,
        )


def _rim_on_edge(can: Round, rim: Rim, edge: PolyhedronEdge, solid: Polyhedron) -> ContactPlace:
    frame, R = _frame_of(edge, rim.center, can), can.radius
    over = AB / bounded(AB * AB, LEAST)  # 1/(a.b)
    foot = (AP * DP + AQ * DQ + AB * DB) * over
    arm = (negate(DP), negate(DQ), foot - DB)
    size = Call("sqrt", bounded(dot(arm, arm), R * R * LEAST))
    k = arm[2] / size * over
    lean = Call("sqrt", ONE + k * k)
    n = (*((k * a - r / size) / lean for a, r in zip((AP, AQ), arm[:2], strict=True)), ZERO)
    along, across = (ZERO, ZERO, ONE), (n[1], negate(n[0]), ZERO)
    within = [
        Span(frame.composed(AB * AB, DIMENSIONLESS), low=PARALLEL * PARALLEL),
        Span(frame.composed(foot, LENGTH), ZERO, edge.length),
    ]
    for out in edge.beyond:
        own = (_exact(out.components, axis.components) for axis in edge.across)
        within.append(Span(frame.composed(dot((*own, ZERO), n), DIMENSIONLESS), low=ZERO))
    if rim.outward:
        within.append(at_least(frame.composed(k, DIMENSIONLESS), -rim.outward))
    return ContactPlace(
        rim.label,
        edge.label(1),
        frame.composed((size - R) / lean, LENGTH),
        ZERO,
        (frame.slip(along, arm), frame.slip(across, arm)),
        ("1", "2"),
        lambda: (frame.turning(along), frame.turning(across)),
        lambda: frame.turning(n),
        within=tuple(within),
        obstacle=f"{rim.label} on {edge.label(1)}",
        bodies=(can.body.name, solid.body.name),
        is_crossing=True,
    )


def _exact(a: Components, b: Components) -> Expr:
    return exact_dot([polynomial(c) for c in a], [polynomial(c) for c in b]).expression()


# -- corners on it -------------------------------------------------------------------------------
def _corner_on(can: Round, corner: Corner, solid: Polyhedron) -> Iterator[ContactPlace]:
    """On its side and on its ends, in its own axes."""
    one, other = perpendiculars(can.body.axis)
    axes = Direction(can.body.name, one), Direction(can.body.name, other), can.axis
    frame = ContactFrame.of(corner.point, can.center, axes, D)
    name, R = corner.point.name, can.radius
    half = ZERO if can.length is None else divide(can.length, number(2))
    rho = Call("sqrt", bounded(D[0] * D[0] + D[1] * D[1], R * R * LEAST))

    def place(
        facing: str, gap: Expr, target: Expr, sign: int, n: Components, t: tuple[Components, Components], *within: Span
    ) -> ContactPlace:
        return ContactPlace(
            name,
            facing,
            frame.composed(gap, LENGTH),
            target,
            (frame.slip(t[0]), frame.slip(t[1])),
            ("1", "2"),
            lambda: (frame.turning(t[0]), frame.turning(t[1])),
            lambda: frame.turning(n),
            sign,
            within,
            f"{name} in {can.body.name}",
            (solid.body.name, can.body.name),
        )

    if can.length is not None:
        n = (D[0] / rho, D[1] / rho, ZERO)
        leaving: list[Span] = []
        for e in corner.leaving:
            seen = [(s.name, Alignment(e.along, axis)) for s, axis in zip(A, axes, strict=True)]
            own = ContactFrame.of(corner.point, can.center, axes, D, *seen)
            leaving.append(at_least(own.composed(A[0] * n[0] + A[1] * n[1], DIMENSIONLESS), e.sign))
        beside = Span(frame.composed(D[2], LENGTH), negate(half), half)
        t = (ZERO, ZERO, ONE), (n[1], negate(n[0]), ZERO)
        yield place(can.body.name, rho, R, 1, n, t, beside, *leaving)
    inside = Span(frame.composed(rho, LENGTH), high=R)
    for sign, end in ((-1, "start"), (1, "end")):
        above = (at_least(Alignment(e.along, can.axis), e.sign * sign) for e in corner.leaving)
        flat = (ONE, ZERO, ZERO), (ZERO, ONE, ZERO)
        facing = f"{can.body.name}.{end}"
        yield place(facing, D[2], number(sign) * half, sign, (ZERO, ZERO, number(sign)), flat, inside, *above)


__all__ = ["places_of_rims"]
