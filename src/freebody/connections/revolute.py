"""Revolute joint in space (hinge): two points coincide, the bodies turn about one axis."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING, ClassVar

from freebody.connections.base import Connection
from freebody.connections.joints import read_joint
from freebody.measures.base import Measure
from freebody.model import glyphs
from freebody.model.elements import Attitude, ConstraintRow
from freebody.model.glyphs import Glyph
from freebody.model.spec import Heading

if TYPE_CHECKING:
    from freebody.model.names import Names


class Revolute(Connection, kind="revolute"):
    """`revolute: {first: ground.A, second: rod.start, about: z}`: the axis on the first body, on the second one
    `second_axis` (the same components). Holds the points and the direction of the axis (5 rows)."""

    called: ClassVar[tuple[str, ...]] = ("hinge", "pivot", "axle", "bearing", "pin")

    first: str
    second: str
    about: Heading
    second_axis: Heading | None = None

    example = """
space: true
bodies: {rod: {box: {mass: 1 kg, size: [1 m, 0.1 m, 0.2 m]}}}
connections: {it: {revolute: {first: ground.A, second: rod.left, about: z}}}
"""

    def rows(self, names: Names) -> list[ConstraintRow]:
        joint = read_joint(names, self, self.first, self.second, self.about, self.second_axis)
        return [] if joint is None else [*joint.meeting(), *joint.parallel()]

    def attitude(self, names: Names) -> Attitude | None:
        joint = read_joint(names, self, self.first, self.second, self.about, self.second_axis)
        return None if joint is None else joint.attitude(turns=True)

    def offers(self, names: Names) -> Iterable[tuple[str, Measure]]:
        joint = read_joint(names, self, self.first, self.second, self.about, self.second_axis)
        if joint is not None:
            yield "angle", joint.angle

    def glyphs(self, names: Names) -> Iterable[Glyph]:
        joint = read_joint(names, self, self.first, self.second, self.about, self.second_axis)
        if joint is not None:
            yield glyphs.Pin(joint.first, joint.second, joint.axis)
