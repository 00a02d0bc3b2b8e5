"""Revolute joint in space (hinge): two points coincide, the bodies turn about one axis."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import TYPE_CHECKING, Any, ClassVar, Literal

from freebody.connections.joints import AxialJoint, Joint, read_joint
from freebody.language.notation import to_python
from freebody.measures.base import Measure
from freebody.measures.geometry import Components, Direction, Point
from freebody.model import glyphs
from freebody.model.elements import ConstraintRow
from freebody.model.glyphs import Glyph
from freebody.model.spec import Heading

if TYPE_CHECKING:
    from freebody.model.names import Names


class Revolute(AxialJoint, kind="revolute"):
    """`revolute: {first: ground.A, second: rod.start, about: z}`: the axis on the first body, on the second one
    `second_axis` (the same components). Holds the points and the direction of the axis (5 rows)."""

    space_only = True
    in_plane_take = "pin"

    called: ClassVar[tuple[str, ...]] = ("hinge", "pivot", "axle", "bearing", "pin")
    also: ClassVar[tuple[str, ...]] = ("hinge", "pivot", "axle", "bearing")

    with_copies: ClassVar[Literal["", "each", "together"]] = "each"

    meeting = ("first", "second")

    first: str
    second: str
    about: Heading
    second_axis: Heading | None = None

    example = """
space: true
bodies: {rod: {box: {mass: 1 kg, size: [1 m, 0.1 m, 0.2 m]}}}
connections: {it: {revolute: {first: ground.A, second: rod.left, about: z}}}
"""

    def joint(self, names: Names) -> Joint | None:
        return read_joint(names, self, self.first, self.second, self.about, self.second_axis)

    def bearing(self, names: Names) -> tuple[Point, Point, Direction, Direction] | None:
        joint = self.joint(names)
        return None if joint is None else (joint.first, joint.second, joint.axis, joint.axis2)

    def for_copy(self, names: Names, carrier: str, turned: Callable[[Components], Components]) -> dict[str, Any]:
        joint = self.joint(names)
        if joint is None:
            return {}
        axis, axis2 = (turned(v.components) if v.body == carrier else v.components for v in (joint.axis, joint.axis2))
        return {"about": [*map(to_python, axis)], "second_axis": [*map(to_python, axis2)]}

    def held(self, names: Names, joint: Joint) -> list[ConstraintRow]:
        return [*joint.meeting(), *joint.parallel()]

    def measured(self, joint: Joint) -> Iterable[tuple[str, Measure]]:
        return (("angle", joint.angle),)

    def sign(self, joint: Joint) -> Glyph:
        return glyphs.Pin(joint.first, joint.second, joint.axis)
