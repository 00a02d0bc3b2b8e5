"""Where a ball in space, or a point, can touch another body: at the place of that body which is nearest to its centre.

With d from the middle of the other body to the centre, by components along axes of that body, and v from the nearest
place of its core to the centre, clamp(x, h) = (|x + h| - |x - h|)/2 being x kept between -h and h,

    a sphere                          v = d,                                        gap |v| - R - r
    a box of the halves h             v_k = d_k - clamp(d_k, h_k),                  gap |v| - r
    a cylinder, a disk (length 0)     v_k = d_k (1 - R/max(rho, R)) across its axis,
                                      v_3 = d_3 - clamp(d_3, L/2) along it,         gap |v| - r
    a rod                             v_k = d_k across, v_3 as of a cylinder,       gap |v| - r
    a ring                            v_k = d_k (1 - R/rho) across, v_3 = d_3,      gap |v| - r
    the inside of a sphere            v = d,                                        gap R - r - |v|
    a rim in a hollow sphere          v_k = d_k (1 + R/rho) across, v_3 = d_3 (-+ L/2 of a cylinder),  gap R_s - |v|
    a corner in a hollow sphere       v = d - corner,                               gap R_s - |v|
    a cylinder that is rolled on      v_k = d_k across its axis, v_3 = 0,           gap |v| - R - r, inside R - r - |v|

so that faces, edges and corners of a box are one place whose normal turns as the ball goes from one to the other. What
lies in a hollow sphere touches it with what is farthest from its middle: d counts to that middle.
While they touch, |v| is the known sum of radii s, and the normal is n = v/s. Two directions across it are those into
which the rotation that takes a fixed q to n takes two across q,

    b_j = f_j - (n.f_j)/(1 + n.q) (n + q),

which is smooth but for n = -q, a direction in which nothing lies by chance; on a cylinder one is along its axis a and
the other round it, n x a. With the arm r = -R n of the material point
of the ball, the slip seen from the other body is b . (d' + w x r), w the angular velocity against it. Sources: Ericson,
Real-Time Collision Detection, 2005, sec. 5.1; Duff et al., J. Computer Graphics Techniques 6 (2017) 1-8 (the frame).
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from fractions import Fraction
from typing import TYPE_CHECKING

from freebody.connections.contact_places import ContactPlace
from freebody.connections.frames_of_contact import ContactFrame
from freebody.connections.polyhedra import Polyhedron, polyhedron_of
from freebody.language.expression import ONE, ZERO, Call, Expr, Symbol, divide, number
from freebody.language.sentences import Message
from freebody.language.units import LENGTH
from freebody.measures.base import Measure
from freebody.measures.displacement import Displacement
from freebody.measures.distance import Distance
from freebody.measures.geometry import Components, Direction, Point
from freebody.model.elements import NonholonomicForm, RigidBody, Span, at_least
from freebody.model.rotations import UNIT, dot, perpendiculars
from freebody.model.solids import BOX, CYLINDER, DISK, ELLIPSOID, RING, ROD, SPHERE, SolidKind
from freebody.model.spins import body_axes

if TYPE_CHECKING:
    from freebody.model.names import Names

D = (Symbol("@d1"), Symbol("@d2"), Symbol("@d3"))
# q, and two directions across it, F_1 x F_2 = Q: a rotation in fractions, of a direction that no model has of its own
Q: Components = tuple(number(Fraction(k, 209)) for k in (111, 168, 56))
F: tuple[Components, Components] = (
    tuple(number(Fraction(k, 209)) for k in (-168, 79, 96)),
    tuple(number(Fraction(k, 209)) for k in (56, -96, 177)),
)
Frame = tuple[Components, tuple[Components, Components]]
INSIDE = "inside "


@dataclass(frozen=True)
class Ball:
    """A sphere, or a point as one of radius 0."""

    label: str
    center: Point
    radius: Expr
    turns: bool
    holds: bool = False  # a hollow sphere, in which something lies


@dataclass(frozen=True)
class Core:
    """What a ball stays away from: axes of the body, the vector v by components along them, |v| in as simple a
    form as there is, and the distance s from it at which the ball touches; inside: where it has to stay nearer."""

    body: RigidBody
    label: str
    axes: tuple[Direction, Direction, Direction]
    v: Components
    size: Expr
    reach: Expr
    inside: bool = False
    of_polyhedron: bool = False  # a face, an edge or a corner, with where that is the nearest
    within: tuple[Span, ...] = ()
    is_face: bool = False
    across: tuple[Components, Components] | None = None  # directions b_1, b_2 = n x b_1 of its own
    called: tuple[str, str] = ("1", "2")  # these
    pitfall: Message | None = None  # of its own

    @property
    def middle(self) -> Point:
        """From which v counts."""
        return self.body.mass_center if self.of_polyhedron else self.body.center


def ball_of(names: Names, text: str) -> Ball | None:
    """`ball`, `rod.end`, `inside bowl`; None for what is neither a sphere nor a point."""
    if text.startswith(INSIDE):
        bowl = names.known(text.removeprefix(INSIDE))
        is_hollow = bowl.round == "sphere" and bowl.inside_radius is not None
        return Ball(text, bowl.center, bowl.inside_radius or ZERO, bowl.turns, holds=True) if is_hollow else None
    owner, dot_, _point = text.partition(".")
    body = names.known(owner)
    if dot_ or not body.turns:
        return Ball(text, names.point(text, "between"), ZERO, body.turns)
    if body.round == "sphere" and body.radius is not None:
        return Ball(body.name, body.center, body.radius, body.turns)
    return None


def cores_of(names: Names, text: str, ball: Ball) -> list[Core]:
    """What of a body the ball stays away from; none where nothing is known of its form."""
    if ball.holds:
        return list(_cores_held(names, text, ball))
    other = ball_of(names, text.removeprefix(INSIDE))
    if other is not None and (other.radius != ZERO or not text.startswith(INSIDE)):
        body, inside = names.known(other.center.body), text.startswith(INSIDE)
        reach = (body.inside_radius or ZERO) - ball.radius if inside else other.radius + ball.radius
        return [] if reach == ZERO else [Core(body, text, body_axes(body.name), D, _size(D), reach, inside)]
    body = names.known(text)
    if text.startswith(INSIDE) or ball.radius == ZERO or body.inner is not None:
        return []  # nothing is known of the edge of a bore
    if body.solid in _CORES:
        axes, v, size = _CORES[body.solid](body)
        return [Core(body, text, axes, v, size, ball.radius)]
    solid = polyhedron_of(names, text)
    return [] if solid is None else _cores_of_polyhedron(solid, ball)


def places_on_body(names: Names, text: str, other: str, frame: Frame = (Q, F)) -> list[ContactPlace]:
    """The places at which a ball, or a point, can touch another body; none where the pair has none. frame: q, f_1 and
    f_2 in axes of the other body."""
    ball = ball_of(names, text)
    return [] if ball is None else [_Touching(ball, core, frame).place() for core in cores_of(names, other, ball)]


def place_on_side(names: Names, ball: RigidBody, other: RigidBody, *, inside: bool) -> ContactPlace:
    """The place at which a sphere touches the curved side of a cylinder, from inside or outside, however long that is.
    Both have radii."""
    rim, radius = (other.inside_radius if inside else other.radius) or ZERO, ball.radius or ZERO
    reach = rim - radius if inside else rim + radius
    v, along = (D[0], D[1], ZERO), (ZERO, ZERO, ONE)
    around = (D[1] / reach, -D[0] / reach, ZERO)
    size = _size(v[:2])
    core = Core(other, other.name, _about(other, other.axis), v, size, reach, inside, across=(along, around))
    return _Touching(Ball(ball.name, ball.center, radius, ball.turns), core, (Q, F)).place()


def place_of_rim(names: Names, round_body: RigidBody, sphere: RigidBody, *, inside: bool) -> ContactPlace:
    """The place at which the rim of a disk or a ring touches a sphere, or a hollow one from inside. Both have radii."""
    ball = ball_of(names, f"{INSIDE}{sphere.name}" if inside else sphere.name)
    assert ball is not None
    radius = round_body.radius or ZERO
    touching = _Touching(ball, _rim(round_body, radius, ball, ZERO), (Q, F))
    if inside or round_body.solid != DISK:
        return touching.place()
    beside = touching.frame.composed(_size(D[:2]), LENGTH)  # nearer to the axis its flat side is what touches
    return replace(touching.place(), within=(Span(beside, low=radius),))


# -- cores ---------------------------------------------------------------------------------------
Made = tuple[tuple[Direction, Direction, Direction], Components, Expr]


def _size(v: Components) -> Expr:
    return Call("sqrt", dot(v, v))


def _clamped(x: Expr, half: Expr) -> Expr:
    return (Call("abs", x + half) - Call("abs", x - half)) / 2


def _box(body: RigidBody) -> Made:
    halves = [divide(size, number(2)) for size in body.sizes]
    v = tuple(x - _clamped(x, half) for x, half in zip(D, halves, strict=True))
    return body_axes(body.name), v, _size(v)


def _about(body: RigidBody, axis: Components) -> tuple[Direction, Direction, Direction]:
    b, c = perpendiculars(axis)
    return Direction(body.name, b), Direction(body.name, c), Direction(body.name, axis)


def _round(body: RigidBody) -> Made:
    """A cylinder, and a disk as one without length. With a >= 0 across the axis and b along it the size is
    sqrt(a^2 + b^2) = a + b^2/(a + sqrt(a^2 + b^2)), which is a itself beside the body, where b is zero."""
    radius, *length = body.sizes
    rho2, square = D[0] * D[0] + D[1] * D[1], radius * radius
    farther = (rho2 + square + Call("abs", rho2 - square)) / 2  # max(rho, R)^2, so that the axis is no exception
    out = Call("sqrt", farther)
    beyond, a = ONE - radius / out, out - radius
    along = D[2] - _clamped(D[2], divide(length[0], number(2))) if length else D[2]
    return _about(body, body.axis), (D[0] * beyond, D[1] * beyond, along), a + along * along / (a + _size((a, along)))


def _ring(body: RigidBody) -> Made:
    radius, rho = body.sizes[0], Call("sqrt", D[0] * D[0] + D[1] * D[1])
    beyond = ONE - radius / rho
    return _about(body, body.axis), (D[0] * beyond, D[1] * beyond, D[2]), _size((rho - radius, D[2]))


def _rod(body: RigidBody) -> Made:
    v = (D[0], D[1], D[2] - _clamped(D[2], divide(body.sizes[0], number(2))))
    return _about(body, UNIT[0]), v, _size(v)


def _rim(body: RigidBody, radius: Expr, ball: Ball, height: Expr) -> Core:
    """A circle about the axis of a body, at a height: its nearest point to the ball, or the farthest in a hollow one.
    Slip 1 is along the rim, slip 2 across it."""
    rho = _size(D[:2])
    beyond = ONE + radius / rho if ball.holds else ONE - radius / rho
    v = (D[0] * beyond, D[1] * beyond, D[2] - height)
    along = (-D[1] / rho, D[0] / rho, ZERO)
    n = tuple(c / ball.radius for c in v)
    across = (-n[2] * D[0] / rho, -n[2] * D[1] / rho, rho * beyond / ball.radius)
    return Core(
        body,
        body.name,
        _about(body, body.axis),
        v,
        _size((rho * beyond, v[2])),
        ball.radius,
        across=(along, across),
        called=("along", "across"),
        pitfall=Message("the middle of {ball} is on the axis of {rim}", ball=ball.center.body, rim=body.name),
    )


def _cores_held(names: Names, text: str, ball: Ball) -> Iterator[Core]:
    """What of a body can touch the hollow sphere in which it lies: rims or corners."""
    body = names.bodies.get(text)
    if body is None or body.solid in (SPHERE, ELLIPSOID):
        return
    if body.solid in (DISK, RING):
        yield _rim(body, body.sizes[0], ball, ZERO)
    elif body.solid == CYLINDER:
        for end, sign in (("start", -1), ("end", 1)):
            height = divide(body.sizes[1], number(2 * sign))
            yield replace(_rim(body, body.sizes[0], ball, height), label=f"{text}.{end}")
    else:
        solid = polyhedron_of(names, text)
        for corner in () if solid is None else solid.corners:
            v = tuple(d - c for d, c in zip(D, corner.point.offset, strict=True))
            yield Core(body, corner.point.name, body_axes(text), v, _size(v), ball.radius, of_polyhedron=True)


_CORES: dict[SolidKind, Callable[[RigidBody], Made]] = {
    BOX: _box,
    CYLINDER: _round,
    DISK: _round,
    RING: _ring,
    ROD: _rod,
}


def _cores_of_polyhedron(solid: Polyhedron, ball: Ball) -> list[Core]:
    """Its faces, edges and corners, each where it is what is nearest to the centre."""
    body, center, found = solid.body, ball.center, list[Core]()

    def core(v: Components, size: Expr, facing: str, *within: Span, is_face: bool = False) -> None:
        axes = body_axes(body.name)
        found.append(Core(body, facing, axes, v, size, ball.radius, of_polyhedron=True, within=within, is_face=is_face))

    for face in solid.faces:
        m = face.normal.components
        above = dot(m, D) - face.offset
        beside = [Span(Displacement(center, body.mass_center, s.along), s.low, s.high) for s in face.sides]
        core(tuple(above * c for c in m), above, face.label, *beside, is_face=True)
    for edge in solid.edges:
        b, away = edge.along.components, tuple(d - c for d, c in zip(D, edge.start.offset, strict=True))
        along = dot(b, away)
        v = tuple(x - along * c for x, c in zip(away, b, strict=True))
        outside = [at_least(Displacement(center, edge.start, out.along), out.sign) for out in edge.beyond]
        core(
            v, _size(v), edge.label(1), Span(Displacement(center, edge.start, edge.along), ZERO, edge.length), *outside
        )
    for corner in solid.corners:
        v = tuple(d - c for d, c in zip(D, corner.point.offset, strict=True))
        before = [at_least(Displacement(center, corner.point, e.along), -e.sign) for e in corner.leaving]
        core(v, _size(v), corner.point.name, *before)
    return found


# -- the place -----------------------------------------------------------------------------------
class _Touching:
    """Gap, slip and turning of a ball and a core."""

    def __init__(self, ball: Ball, core: Core, frame: Frame) -> None:
        self.ball, self.core = ball, core
        turns = ball.turns or core.body.turns
        self.frame = ContactFrame.of(ball.center, core.middle, core.axes, D, turns=turns)
        n = self.n = tuple(c / core.reach for c in core.v)
        q, across = frame
        leaning = [dot(n, f) / (ONE + dot(n, q)) for f in across]
        self.across = core.across or tuple(
            tuple(f[k] - share * (n[k] + q[k]) for k in range(3)) for f, share in zip(across, leaning, strict=True)
        )

    def place(self) -> ContactPlace:
        core = self.core
        sphere = core.v == D
        gap: Measure = Distance(core.body.center, self.ball.center)
        if not sphere:
            gap = self.frame.composed(core.size, LENGTH)
        one, other = self.across
        label, facing = self.ball.label, core.label
        if self.ball.holds:
            label, facing = facing, label
        return ContactPlace(
            label,
            facing,
            gap,
            core.reach,
            (self._slip(one, other, -1), self._slip(other, one, 1)),
            core.called,
            lambda: (self.frame.turning(one), self.frame.turning(other)),
            lambda: self.frame.turning(self.n),
            -1 if core.inside or self.ball.holds else 1,
            within=core.within,
            obstacle=f"{self.ball.label} in {core.body.name}" if core.is_face else "",
            bodies=(self.ball.center.body, core.body.name) if core.of_polyhedron else (),
            pitfall=self._pitfall(),
        )

    def _pitfall(self) -> Message:
        """Where |v| is zero, or its nearest place is not a single one."""
        if self.core.pitfall is not None:
            return self.core.pitfall
        ball, other = self.ball.label, self.core.body.name
        if self.core.v == D:
            return Message("the middle of {ball} is the middle of {other}", ball=ball, other=other)
        if self.core.body.solid == RING:
            return Message("the middle of {ball} is on the axis of {other} or on its rim", ball=ball, other=other)
        return Message("the middle of {ball} is inside {other}", ball=ball, other=other)

    def _slip(self, along: Components, other: Components, sign: int) -> NonholonomicForm:
        """b . d' + w . (r x b): r = -R n, and n x b_1 = b_2, n x b_2 = -b_1; inside r = R n."""
        if self.ball.radius == ZERO:
            return self.frame.slip(along)
        arm = number(-sign if self.core.inside else sign) * self.ball.radius
        return self.frame.slip_by_moment(along, tuple(arm * c for c in other))
