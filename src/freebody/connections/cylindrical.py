"""Cylindrical joint: a body turns about an axis of another and moves along it."""

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


class Cylindrical(Connection, kind="cylindrical"):
    """`cylindrical: {first: ground.A, second: collar, about: x}`: the second point stays on the axis through the first,
    and the axes stay parallel (4 rows)."""

    first: str
    second: str
    about: Heading
    second_axis: Heading | None = None

    example = """
space: true
bodies: {collar: {box: {mass: 1 kg, size: [1 m, 0.1 m, 0.2 m]}}}
connections: {it: {cylindrical: {first: ground.A, second: collar, about: x}}}
"""

    def rows(self, names: Names) -> list[ConstraintRow]:
        joint = read_joint(names, self, self.first, self.second, self.about, self.second_axis)
        return [] if joint is None else [*joint.on_the_axis(), *joint.parallel()]

    def attitude(self, names: Names) -> Attitude | None:
        joint = read_joint(names, self, self.first, self.second, self.about, self.second_axis)
        return None if joint is None else joint.attitude(turns=True)

    def offers(self, names: Names) -> Iterable[tuple[str, Measure]]:
        joint = read_joint(names, self, self.first, self.second, self.about, self.second_axis)
        if joint is not None:
            yield "travel", joint.travel
            yield "angle", joint.angle

    def glyphs(self, names: Names) -> Iterable[Glyph]:
        joint = read_joint(names, self, self.first, self.second, self.about, self.second_axis)
        if joint is not None:
            yield glyphs.Rail(joint.first, joint.second, joint.axis, "about")
