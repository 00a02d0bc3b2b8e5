"""Where a body in space can touch a plane: at a point of its own, at its corners, its rim, its curved surface.

With n the normal of the plane and C the centre, what is lowest is

    a sphere                       C - R n,                                          h - R above the plane,
    the rim of a disk with axis a  C - R (n - (n.a) a)/|n x a|,                      h - R |n x a|,
    the flat end of a cylinder     all of it, C being its middle,                    h,
    an ellipsoid of semi-axes D    C - D^2 n/sqrt(n.D^2 n), components in its axes,  h - sqrt(n.D^2 n),

with h the height of C. The material point there slips in the plane by its velocity, of which the two components along
the plane are rates of no measure; a point that is always the same one slips by the rates of its place. Source: Neimark
& Fufaev, Dynamics of Nonholonomic Systems, 1972, ch. I sec. 2; Kane & Levinson, Int. J. Non-Linear Mech. 17 (1982).
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from fractions import Fraction
from typing import TYPE_CHECKING

from freebody.connections.contact_places import COS, HEIGHT, SIN, ContactPlace, PivotPlace, settings_of
from freebody.connections.joints import across_names
from freebody.connections.polyhedra import corners_of
from freebody.language.expression import ZERO, Call, Expr, Symbol, number
from freebody.language.sentences import Message
from freebody.language.units import DIMENSIONLESS, LENGTH
from freebody.measures.base import Measure
from freebody.measures.combination import Composed
from freebody.measures.displacement import Displacement
from freebody.measures.geometry import Direction, Point
from freebody.measures.turn import Alignment
from freebody.model.elements import BodyPlane, NonholonomicForm, RigidBody, Span
from freebody.model.rotations import perpendiculars
from freebody.model.solids import BOX, CYLINDER, ELLIPSOID
from freebody.model.spins import body_axes, spin, velocity_of_place

if TYPE_CHECKING:
    from freebody.model.names import Names

LEAST = number(Fraction(1, 10**10))  # of the square of a sine, so that nothing is divided by zero
FLAT = number(Fraction(2, 10**5))  # the sine of a tilt below which an end is flat
_SQUARE = Symbol("@n1") * Symbol("@n1") + Symbol("@n2") * Symbol("@n2")


def bounded(square: Expr, least: Expr) -> Expr:
    """A square, or the least one, whichever is greater: nothing is divided by zero."""
    return (square + least + Call("abs", square - least)) / 2


Arm = list[tuple[Measure, Direction]]  # of a place from the centre: components along directions of the body


@dataclass(frozen=True)
class PlaceOnPlane:
    """A place at which a body can touch a plane. arm: None where it is always the same point of the body."""

    label: str
    center: Point
    gap: Measure
    target: Expr | None
    arm: Arm | None
    pitfall: Message | None = None  # where all of a rim touches there is no lowest place
    within: tuple[Span, ...] = ()
    lost: Measure | None = None
    reach: Expr | None = None  # of a flat end
    across: tuple[Direction, Direction] | None = None  # of a flat end: two directions across its axis

    def on(self, plane: BodyPlane, facing: str) -> ContactPlace:
        """With its slip along two directions of the plane, and its turning about them and the normal."""
        (p, q), owner, body = along_plane(plane), plane.normal.body, self.center.body
        return ContactPlace(
            self.label,
            facing,
            self.gap,
            self.target,
            (self._slip(p, plane), self._slip(q, plane)),
            across_names(plane.normal),
            lambda: (spin(body, p, owner), spin(body, q, owner)),
            lambda: spin(body, plane.normal, owner),
            within=self.within,
            pitfall=self.pitfall,
            lost=self.lost,
            reach=self.reach,
            pivot=self._pivot(plane, facing),
        )

    def _pivot(self, plane: BodyPlane, facing: str) -> PivotPlace | None:
        """The point of the rim about which a flat end tips."""
        if self.across is None or self.reach is None:
            return None
        known, directions = settings_of(self.label, facing), along_plane(plane)
        lowest = tuple(Alignment(b, plane.normal) for b in self.across)
        height = Symbol("@h") + self.reach * (COS * Symbol("@n1") + SIN * Symbol("@n2")) - HEIGHT
        seen = (("@h", self.gap), ("@n1", lowest[0]), ("@n2", lowest[1]), *known)
        arm: Arm = [
            (Composed(self.reach * share, (setting,), LENGTH), b)
            for share, setting, b in zip((COS, SIN), known, self.across, strict=False)
        ]
        point = replace(
            self,
            gap=Composed(height, seen, LENGTH, here=True),
            target=ZERO,
            arm=arm,
            within=(),
            reach=None,
            across=None,
        )
        along = tuple(tuple(Alignment(b, d) for d in directions) for b in self.across)
        settings = tuple(measure for _name, measure in known)
        return PivotPlace(point.on(plane, facing), settings, lowest, along, 1)  # pyrefly: ignore[bad-argument-type]

    def _slip(self, along: Direction, plane: BodyPlane) -> Measure | NonholonomicForm:
        """What slips along a direction of the plane."""
        if self.arm is None:
            return Displacement(self.center, plane.through, along)
        return velocity_of_place(self.center, self.arm, along, plane.through)


def along_plane(plane: BodyPlane) -> tuple[Direction, Direction]:
    """Two directions of a plane, at right angles: with its normal they are right-handed."""
    b, c = perpendiculars(plane.normal.components)
    return Direction(plane.normal.body, b), Direction(plane.normal.body, c)


def places_on_plane(names: Names, text: str, plane: BodyPlane) -> list[PlaceOnPlane]:
    """The places at which a body, or a point of one, can touch a plane; none where it has no form that could."""
    owner, dot, _point = text.partition(".")
    body = names.known(owner)
    if dot or not body.turns:
        return [_point_of(names.point(text, "between"), text, plane)]
    if body.solid == BOX or body.faces:
        return [_point_of(corner, corner.name, plane) for corner in corners_of(body)]
    if body.solid == ELLIPSOID:
        return [ellipsoid_on_plane(body, plane)]
    if body.round == "sphere" and body.radius is not None:
        arm = sphere_arm(body, body.radius, plane)
        return [PlaceOnPlane(body.name, body.center, _height(body.center, plane), body.radius, arm)]
    if body.solid == CYLINDER:
        ends = [(body.point(end), f"{body.name}.{end}") for end in ("start", "end")]
        return [place for end in ends for place in _ends_on(body, *end, body.sizes[0], plane)]
    if body.round == "disk" and body.radius is not None:
        return _ends_on(body, body.center, body.name, body.radius, plane)
    return []


def _height(point: Point, plane: BodyPlane) -> Displacement:
    return Displacement(point, plane.through, plane.normal)


def _point_of(point: Point, label: str, plane: BodyPlane) -> PlaceOnPlane:
    return PlaceOnPlane(label, point, _height(point, plane), None, None)


def sphere_arm(body: RigidBody, radius: Expr, plane: BodyPlane) -> Arm:
    """-R n."""
    return [
        (Composed(-radius * Symbol("@n"), (("@n", Alignment(b, plane.normal)),), LENGTH), b)
        for b in body_axes(body.name)
    ]


def _ends_on(body: RigidBody, center: Point, label: str, radius: Expr, plane: BodyPlane) -> list[PlaceOnPlane]:
    """An end of a cylinder, or a disk: its rim, as long as it is tilted, and all of it where it is flat."""
    across, n = _across(body, plane)
    size = Call("sqrt", bounded(_SQUARE, LEAST))
    tilted = Composed(size - FLAT, n, DIMENSIONLESS, here=True)
    flat = Composed(FLAT - size, n, DIMENSIONLESS, here=True)
    gap, target, arm = _lowest(across, n, center, radius, plane, size)
    lies, upright = Message("{rim} lies flat on {face}", rim=label, face=plane.name), _height(center, plane)
    return [
        PlaceOnPlane(label, center, gap, target, arm, lies, (Span(tilted, low=ZERO),), tilted),
        PlaceOnPlane(
            label,
            center,
            upright,
            None,
            None,
            within=(Span(flat, low=ZERO),),
            reach=radius,
            across=(across[0], across[1]),
        ),
    ]


def _across(body: RigidBody, plane: BodyPlane) -> tuple[list[Direction], tuple[tuple[str, Measure], ...]]:
    """Two directions across the axis of a body, and the components of the normal there."""
    across = [Direction(body.name, v) for v in perpendiculars(body.axis)]
    return across, tuple((f"@n{j}", Alignment(b, plane.normal)) for j, b in enumerate(across, 1))


def _lowest(
    across: list[Direction],
    n: tuple[tuple[str, Measure], ...],
    center: Point,
    radius: Expr,
    plane: BodyPlane,
    size: Expr,
) -> tuple[Measure, Expr | None, Arm]:
    """The gap of a rim, its target, and the arm to where it is lowest; size: |n x a|."""
    gap = Composed(Symbol("@h") - radius * size, (("@h", _height(center, plane)), *n), LENGTH, here=True)
    arm: Arm = [
        (Composed(-radius * Symbol(name) / size, n, LENGTH, here=True), b)
        for (name, _), b in zip(n, across, strict=True)
    ]
    return gap, None, arm


def ellipsoid_on_plane(body: RigidBody, plane: BodyPlane) -> PlaceOnPlane:
    """The lowest place of an ellipsoid."""
    axes = body_axes(body.name)
    n = tuple((f"@n{j}", Alignment(b, plane.normal)) for j, b in enumerate(axes, 1))
    reach: Expr = ZERO
    for half_axis, (name, _) in zip(body.sizes, n, strict=True):
        reach = reach + half_axis * half_axis * Symbol(name) * Symbol(name)
    size = Call("sqrt", reach)
    gap = Composed(Symbol("@h") - size, (("@h", _height(body.center, plane)), *n), LENGTH)
    arm: Arm = [
        (Composed(-half_axis * half_axis * Symbol(name) / size, n, LENGTH), b)
        for half_axis, (name, _), b in zip(body.sizes, n, axes, strict=True)
    ]
    return PlaceOnPlane(body.name, body.center, gap, None, arm)
