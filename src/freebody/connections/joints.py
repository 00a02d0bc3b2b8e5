"""What the joints of space are made of: two points, an axis on each body, and the rows that hold them together.

An axis of a joint is fixed in the first body and, by the same components unless another one is named, in the second:
the joint is at zero where both bodies stand parallel. With b, c on the first body, b x c = a its axis, and a', b' on
the second, the rows

    b . a' = 0,  c . a' = 0     keep the axes parallel; their multipliers are moments on the second body about c and -b,
    b . c' = 0                  keeps the bodies from turning about the axis; its multiplier is a moment about -a.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, ClassVar

from freebody.connections.base import Connection
from freebody.language.sentences import Message
from freebody.language.units import DIMENSIONLESS
from freebody.measures.base import Measure
from freebody.measures.displacement import Displacement
from freebody.measures.geometry import GROUND, ZERO, Direction, Point
from freebody.measures.turn import Alignment, Turn
from freebody.model.elements import Attitude, ConstraintRow, DryFriction, UnilateralConstraint
from freebody.model.friction import read_friction
from freebody.model.glyphs import Glyph
from freebody.model.rotations import UNIT, perpendiculars
from freebody.model.spec import Formula, Heading, Spec

if TYPE_CHECKING:
    from freebody.model.names import Names

AXES = tuple(Direction(GROUND, along, name) for along, name in zip(UNIT, "xyz", strict=True))


@dataclass(frozen=True)
class Joint:
    """Two points and an axis on each of their bodies, with two directions across it."""

    first: Point
    second: Point
    axis: Direction
    b: Direction
    c: Direction
    axis2: Direction
    b2: Direction
    c2: Direction

    @property
    def angle(self) -> Measure:
        """How far the second body has turned about the axis of the first."""
        return Turn(self.b2, self.b, self.c)

    @property
    def travel(self) -> Measure:
        """How far the second point is along the axis."""
        return Displacement(self.second, self.first, self.axis)

    def meeting(self) -> list[ConstraintRow]:
        """The points coincide."""
        return meeting(self.first, self.second)

    def on_the_axis(self) -> list[ConstraintRow]:
        """The second point is on the axis of the first body."""
        across = zip((self.b, self.c), across_names(self.axis), strict=True)
        return [ConstraintRow(name, "force", Displacement(self.second, self.first, along)) for along, name in across]

    def parallel(self) -> list[ConstraintRow]:
        """The axes are parallel."""
        one, other = across_names(self.axis)
        return [
            ConstraintRow(f"moment {other}", "moment", Alignment(self.axis2, self.b)),
            ConstraintRow(f"moment {one}", "moment", Alignment(self.axis2, self.c), sign=-1),
        ]

    def not_turning(self) -> ConstraintRow:
        """The bodies do not turn about the axis against each other."""
        return ConstraintRow("moment about axis", "moment", Alignment(self.c2, self.b), sign=-1)

    def attitude(self, *, turns: bool) -> Attitude:
        """How the second body is turned: about the axis, or not at all."""
        rows = tuple(row.component for row in self.parallel())
        angle = ((UNIT[2], "angle", self.angle),) if turns else ()
        before = (self.b.components, self.c.components, self.axis.components)
        after = (self.b2.components, self.c2.components, self.axis2.components)
        if not turns:
            rows = (*rows, self.not_turning().component)
        return Attitude(self.first.body, self.second.body, before, after, angle, rows)


def meeting(first: Point, second: Point) -> list[ConstraintRow]:
    """Two points coincide. The multipliers are the force on the second body along x, y and z."""
    return [ConstraintRow(axis.name, "force", Displacement(second, first, axis)) for axis in AXES]


def across_names(axis: Direction) -> tuple[str, str]:
    """What the directions across an axis are called: y and z for x, else 1 and 2."""
    for k in range(3):
        if axis.components == UNIT[k]:
            return "xyz"[(k + 1) % 3], "xyz"[(k + 2) % 3]
    return "1", "2"


def read_joint(
    names: Names, spec: Spec, first: str, second: str, about: Heading, second_axis: Heading | None, key: str = "about"
) -> Joint | None:
    """The points and axes of a joint; None after noting a problem."""
    one, other = names.point(first, "first"), names.point(second, "second")
    if one.body == other.body:
        names.problem(Message("joins {body} to itself; name points of two bodies", body=one.body))
        return None
    for point, field in ((one, "first"), (other, "second")):
        if not names.known(point.body).turns:
            names.problem(
                Message(
                    "{body} is a particle, which cannot turn; give it a body with inertia, or guide the point alone by "
                    "point_on_line or point_on_plane",
                    body=point.body,
                ),
                field,
            )
            return None
    axis = own_direction(names, about, one.body, key)
    if second_axis is None and axis.body == other.body != one.body:
        axis = Direction(one.body, axis.components, axis.name)
    if axis.body != one.body:
        names.problem(
            Message(
                "the axis is fixed in {owner}, but it must be on {body}, the body of first; give the one on "
                "{other} as second_axis",
                owner=axis.body,
                body=one.body,
                other=other.body,
            ),
            key,
        )
        return None
    axis2 = Direction(other.body, axis.components, axis.name)
    if second_axis is not None:
        axis2 = own_direction(names, second_axis, other.body, "second_axis")
        if axis2.body != other.body:
            names.problem(
                Message("second_axis must be fixed in {other}, the body of second", other=other.body),
                "second_axis",
            )
            return None
    b, c = (Direction(one.body, v) for v in perpendiculars(axis.components))
    b2, c2 = (Direction(other.body, v) for v in perpendiculars(axis2.components))
    return Joint(one, other, axis, b, c, axis2, b2, c2)


def rubbing_along(
    names: Names, friction: Formula | dict[str, Any], travel: Measure, across: Iterable[ConstraintRow], connection: str
) -> tuple[list[UnilateralConstraint], list[DryFriction]]:
    """What a straight guide resists along itself: mu times the resultant N of its forces across it, whichever side of
    the guide that presses on, T = -mu N sign(v)."""
    mu = read_friction(names, friction, DIMENSIONLESS)
    if mu.is_none:
        return [], []
    row = ConstraintRow("friction", "friction force", travel, connection=connection)
    load = tuple(f"{connection}.{held.component}" for held in across)
    return [], [DryFriction(row, mu.static, mu.kinetic, load)]


def own_direction(names: Names, value: Heading, body: str, *path: str | int) -> Direction:
    """A direction by components along the axes of a body, where it names no other."""
    found = names.direction(value, *path, body=body)
    return Direction(found.body, (*found.components, *(ZERO,) * (3 - len(found.components))), found.name)


class AxialJoint(Connection):
    """A joint of space at two points and an axis: what it holds, offers and looks like it says of a `Joint`."""

    turns_about_axis: ClassVar[bool] = True

    def joint(self, names: Names) -> Joint | None:
        """Its points and axes; None after noting a problem."""
        raise NotImplementedError

    def held(self, names: Names, joint: Joint) -> list[ConstraintRow]:
        """The rows it holds."""
        raise NotImplementedError

    def measured(self, joint: Joint) -> Iterable[tuple[str, Measure]]:
        """The measures it offers as coordinates."""
        raise NotImplementedError

    def sign(self, joint: Joint) -> Glyph:
        """What it looks like."""
        raise NotImplementedError

    def rows(self, names: Names) -> list[ConstraintRow]:
        joint = self.joint(names)
        return [] if joint is None else self.held(names, joint)

    def attitude(self, names: Names) -> Attitude | None:
        joint = self.joint(names)
        return None if joint is None else joint.attitude(turns=self.turns_about_axis)

    def offers(self, names: Names) -> Iterable[tuple[str, Measure]]:
        joint = self.joint(names)
        return () if joint is None else self.measured(joint)

    def glyphs(self, names: Names) -> Iterable[Glyph]:
        joint = self.joint(names)
        return () if joint is None else (self.sign(joint),)
