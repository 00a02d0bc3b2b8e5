"""Prismatic joint in space: a body moves along an axis of another and does not turn against it."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING, Any, ClassVar

from freebody.connections.joints import AxialJoint, Joint, read_joint, rubbing_along
from freebody.measures.base import Measure
from freebody.model import glyphs
from freebody.model.elements import ConstraintRow, DryFriction, UnilateralConstraint
from freebody.model.glyphs import Glyph
from freebody.model.spec import Formula, Heading

if TYPE_CHECKING:
    from freebody.model.names import Names


class Prismatic(AxialJoint, kind="prismatic"):
    """`prismatic: {first: ground.A, second: block, along: x}`: the second point stays on the line through the first,
    and the bodies keep their attitude to each other (5 rows). `friction: mu`: the force that resists is mu times the
    resultant of the forces across the axis; what the moments that it transmits press on its ends is not counted."""

    space_only = True
    in_plane_take = "slider"

    first: str
    second: str
    along: Heading
    second_axis: Heading | None = None
    friction: Formula | dict[str, Any] = 0

    turns_about_axis: ClassVar[bool] = False
    example = """
space: true
bodies: {block: {box: {mass: 1 kg, size: [1 m, 0.1 m, 0.2 m]}}}
connections: {it: {prismatic: {first: ground.A, second: block, along: x}}}
"""

    def joint(self, names: Names) -> Joint | None:
        return read_joint(names, self, self.first, self.second, self.along, self.second_axis, "along")

    def bounds(self, names: Names, connection: str) -> tuple[list[UnilateralConstraint], list[DryFriction]]:
        with names.quietly():
            joint = self.joint(names)
        if joint is None:
            return [], []
        return rubbing_along(names, self.friction, joint.travel, joint.on_the_axis(), connection)

    def held(self, names: Names, joint: Joint) -> list[ConstraintRow]:
        return [*joint.on_the_axis(), *joint.parallel(), joint.not_turning()]

    def measured(self, joint: Joint) -> Iterable[tuple[str, Measure]]:
        return (("travel", joint.travel),)

    def sign(self, joint: Joint) -> Glyph:
        return glyphs.Rail(joint.first, joint.second, joint.axis, "not")
