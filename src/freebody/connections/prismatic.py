"""Prismatic joint in space: a body moves along an axis of another and does not turn against it."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING

from freebody.connections.base import Connection
from freebody.connections.joints import read_joint
from freebody.measures.base import Measure
from freebody.model import glyphs
from freebody.model.elements import Attitude, ConstraintRow
from freebody.model.glyphs import Glyph
from freebody.model.spec import Heading

if TYPE_CHECKING:
    from freebody.model.names import Names


class Prismatic(Connection, kind="prismatic"):
    """`prismatic: {first: ground.A, second: block, along: x}`: the second point stays on the line through the first,
    and the bodies keep their attitude to each other (5 rows)."""

    first: str
    second: str
    along: Heading
    second_axis: Heading | None = None

    example = """
space: true
bodies: {block: {box: {mass: 1 kg, size: [1 m, 0.1 m, 0.2 m]}}}
connections: {it: {prismatic: {first: ground.A, second: block, along: x}}}
"""

    def rows(self, names: Names) -> list[ConstraintRow]:
        joint = read_joint(names, self, self.first, self.second, self.along, self.second_axis, "along")
        return [] if joint is None else [*joint.on_the_axis(), *joint.parallel(), joint.not_turning()]

    def attitude(self, names: Names) -> Attitude | None:
        joint = read_joint(names, self, self.first, self.second, self.along, self.second_axis, "along")
        return None if joint is None else joint.attitude(turns=False)

    def offers(self, names: Names) -> Iterable[tuple[str, Measure]]:
        joint = read_joint(names, self, self.first, self.second, self.along, self.second_axis, "along")
        if joint is not None:
            yield "travel", joint.travel

    def glyphs(self, names: Names) -> Iterable[Glyph]:
        joint = read_joint(names, self, self.first, self.second, self.along, self.second_axis, "along")
        if joint is not None:
            yield glyphs.Rail(joint.first, joint.second, joint.axis, "not")
