"""Cylindrical joint: a body turns about an axis of another and moves along it."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING

from freebody.connections.joints import AxialJoint, Joint, read_joint
from freebody.measures.base import Measure
from freebody.model import glyphs
from freebody.model.elements import ConstraintRow
from freebody.model.glyphs import Glyph
from freebody.model.spec import Heading

if TYPE_CHECKING:
    from freebody.model.names import Names


class Cylindrical(AxialJoint, kind="cylindrical"):
    """`cylindrical: {first: ground.A, second: collar, about: x}`: the second point stays on the axis through the first,
    and the axes stay parallel (4 rows)."""

    space_only = True
    in_plane_take = "slot"

    first: str
    second: str
    about: Heading
    second_axis: Heading | None = None

    example = """
space: true
bodies: {collar: {box: {mass: 1 kg, size: [1 m, 0.1 m, 0.2 m]}}}
connections: {it: {cylindrical: {first: ground.A, second: collar, about: x}}}
"""

    def joint(self, names: Names) -> Joint | None:
        return read_joint(names, self, self.first, self.second, self.about, self.second_axis)

    def held(self, names: Names, joint: Joint) -> list[ConstraintRow]:
        return [*joint.on_the_axis(), *joint.parallel()]

    def measured(self, joint: Joint) -> Iterable[tuple[str, Measure]]:
        return (("travel", joint.travel), ("angle", joint.angle))

    def sign(self, joint: Joint) -> Glyph:
        return glyphs.Rail(joint.first, joint.second, joint.axis, "about")
