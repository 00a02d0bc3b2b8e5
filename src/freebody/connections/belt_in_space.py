"""A belt in space, round pulleys whose axes are parallel on one body: on the ground, or on what carries both.

Followed from the first pulley to the second, one of its runs has the length L = lead(rho) + s_2 R_2 theta_2 - R_1
theta_1 with rho = s_2 R_2 - R_1 (see `measures.lead`), s_2 = 1 of an open belt and -1 of a crossed one; the other run
is its mirror image. The belt force F is in both by a half, so that it is the reaction of

    -(L - L')/2 = R_1 theta_1 - s_2 R_2 theta_2 - (lead(rho) - lead(-rho))/2,

which pulls at the centres with F (R_1 - s_2 R_2)/d across their line.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING

from freebody.connections.standing import is_zero, moves_out_of_plane, number_of
from freebody.connections.standing_in_space import StandingInSpace
from freebody.connections.string.in_space import wheel_plane
from freebody.connections.string.node import WheelPlane
from freebody.language.expression import ZERO, Call, Expr, divide, multiply, negate, number
from freebody.language.sentences import Message
from freebody.language.units import LENGTH
from freebody.measures.base import Measure
from freebody.measures.combination import Combination
from freebody.measures.geometry import Direction, Point
from freebody.measures.lead import LeadInPlane
from freebody.model import glyphs
from freebody.model.elements import RigidBody
from freebody.model.glyphs import Glyph
from freebody.model.rotations import dot, perpendiculars, vector_product

if TYPE_CHECKING:
    from freebody.model.names import Names


@dataclass(frozen=True)
class BeltInSpace:
    """Two pulleys with a belt, and the planes of both as one body sees them, with their normals the same way."""

    wheels: tuple[RigidBody, RigidBody]
    radii: tuple[Expr, Expr]
    planes: tuple[WheelPlane, WheelPlane]
    distance: Expr
    is_crossed: bool

    @property
    def way(self) -> Combination:
        """How far the belt has run over the first pulley."""
        return Combination(self._wound(0, self.radii[0]), LENGTH)

    @property
    def rolled(self) -> Combination:
        """What the belt holds."""
        (first, second), (plane, _other) = self.wheels, self.planes
        own, others = self.radii[0], negate(self.radii[1]) if self.is_crossed else self.radii[1]
        rho = others - own
        terms = [*self._wound(0, own), *self._wound(1, negate(others))]
        if rho != ZERO:
            for share, arm in ((-1, rho), (1, negate(rho))):
                lead = LeadInPlane(first.center, second.center, arm, plane.along, plane.side)
                terms.append((divide(number(share), number(2)), lead))
        return Combination(tuple(terms), LENGTH)

    def _wound(self, k: int, arm: Expr) -> tuple[tuple[Expr, Measure], ...]:
        return tuple((multiply(arm, share), angle) for share, angle in self.planes[k].turned)

    def glyphs(self) -> Iterator[Glyph]:
        """A rope to the second pulley, back and there again: so it has an arc on each."""
        arms = self.radii[0], negate(self.radii[1]) if self.is_crossed else self.radii[1]
        ends = [
            glyphs.Node(wheel.center, arm, False, plane.normal, plane.carrier)
            for wheel, arm, plane in zip(self.wheels, arms, self.planes, strict=True)
        ]
        yield glyphs.Rope((*ends, *ends), tuple(glyphs.Lead(None) for _ in range(3)))


def lies_flat(names: Names, wheels: tuple[str, str]) -> bool:
    """Whether it runs in the plane of x and y; in space between wheels of which one does not it finds its own."""
    return not names.space or not moves_out_of_plane(names, [name for name in wheels if name in names.bodies])


def own_plane(
    names: Names, wheels: tuple[str, str], radii: tuple[Expr, Expr], *, crossed: bool = False
) -> BeltInSpace | None:
    """The belt of two pulleys in a plane of its own; None where it lies in that of x and y."""
    if wheels[0] == wheels[1] or lies_flat(names, wheels):
        return None
    return belt_in_space(names, (names.body(wheels[0]), names.body(wheels[1])), radii, crossed=crossed)


def belt_in_space(
    names: Names, wheels: tuple[RigidBody, RigidBody], radii: tuple[Expr, Expr], *, crossed: bool
) -> BeltInSpace | None:
    """The belt of two pulleys; None with a problem noted."""
    still = StandingInSpace(names)
    planes = [wheel_plane(still, wheel.name) for wheel in wheels]
    first, second = planes
    if first is None or second is None:
        return None
    one, other = wheels
    m, n = first.normal.components, second.normal.components
    if first.normal.body != second.normal.body or any(not is_zero(names, c) for c in vector_product(m, n)):
        told = Message(
            "a belt needs parallel axes: those of {first} and {second} are not", first=one.name, second=other.name
        )
        names.problem(told)
        return None
    if number_of(names, dot(m, n)) < 0.0:
        second = second.reversed()
    aside = still.distance_along(one.center, other.center, first.normal)
    distance = _distance(still, one.center, other.center, first.normal)
    if aside is None or distance is None:
        told = Message(
            "the distance of {first} and {second} may change: in space a belt needs the bearings of both on one body",
            first=one.name,
            second=other.name,
        )
        names.problem(told)
        return None
    if not is_zero(names, aside):
        told = Message(
            "{second} is {aside:.6g} m beside the plane of {first}, across its axis: a belt runs in one plane",
            first=one.name,
            second=other.name,
            aside=abs(number_of(names, aside)),
        )
        names.problem(told)
        return None
    return BeltInSpace(wheels, radii, (first, second), distance, crossed)


def _distance(still: StandingInSpace, one: Point, other: Point, normal: Direction) -> Expr | None:
    """How far two points are apart across a direction, on a body that keeps both of them; None where there is none."""
    names = still.names
    for body, kept in still.carried(normal).items():
        x, y = (still.distance_along(one, other, Direction(body, e)) for e in perpendiculars(kept.components))
        if x is None or y is None:
            continue
        if ZERO in (x, y):
            along = x if y == ZERO else y
            return along if number_of(names, along) >= 0 else negate(along)
        return Call("sqrt", x * x + y * y)
    return None
