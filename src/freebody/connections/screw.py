"""Screw joint: a cylindrical joint whose travel follows its angle."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING

from freebody.connections.joints import AxialJoint, Joint, read_joint
from freebody.language.expression import PI, divide
from freebody.language.units import LENGTH
from freebody.measures.base import Measure
from freebody.measures.combination import Combination
from freebody.measures.geometry import ONE
from freebody.model import glyphs
from freebody.model.elements import ConstraintRow
from freebody.model.glyphs import Glyph
from freebody.model.spec import Formula, Heading

if TYPE_CHECKING:
    from freebody.model.names import Names


class Screw(AxialJoint, kind="screw"):
    """`screw: {first: ground.A, second: nut, about: x, pitch: 2 mm}`: a cylindrical joint in which a turn of the second
    body moves it by the pitch along the axis (5 rows). A negative pitch is a left-hand thread."""

    space_only = True

    first: str
    second: str
    about: Heading
    pitch: Formula
    second_axis: Heading | None = None

    example = """
space: true
bodies: {nut: {box: {mass: 1 kg, size: [1 m, 0.1 m, 0.2 m]}}}
connections: {it: {screw: {first: ground.A, second: nut, about: x, pitch: 0.1 m}}}
"""

    def joint(self, names: Names) -> Joint | None:
        return read_joint(names, self, self.first, self.second, self.about, self.second_axis)

    def held(self, names: Names, joint: Joint) -> list[ConstraintRow]:
        lead = divide(names.formula(self.pitch, LENGTH, "pitch"), 2 * PI)
        thread = Combination(((ONE, joint.travel), (-lead, joint.angle)), LENGTH)
        return [*joint.on_the_axis(), *joint.parallel(), ConstraintRow("thread", "thread force", thread)]

    def measured(self, joint: Joint) -> Iterable[tuple[str, Measure]]:
        return (("angle", joint.angle),)

    def sign(self, joint: Joint) -> Glyph:
        return glyphs.Rail(joint.first, joint.second, joint.axis, "about", has_thread=True)
