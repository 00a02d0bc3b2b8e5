"""Screw joint: a cylindrical joint whose travel follows its angle, with or without friction in its thread.

Unroll the thread at its mean radius r: with the lead angle tan(lambda) = pitch/(2 pi r), x = travel and s = r angle,
the thread holds x - s tan(lambda) = 0 by the multiplier S along the axis, and N = S/cos(lambda) presses its flanks.
They slide along the thread by u = s cos(lambda) + x sin(lambda), and resist with mu N. In u/cos(lambda), whose
multiplier is the part of the friction round the axis, that is mu S. A load along the axis does not turn the screw
where mu >= tan(lambda): it locks itself. Square thread; source: Meriam & Kraige, Statics, sec. 6/5.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING, Any

from freebody.connections.joints import AxialJoint, Joint, read_joint
from freebody.language.expression import PI, divide, negate
from freebody.language.sentences import Message
from freebody.language.units import DIMENSIONLESS, LENGTH
from freebody.measures.base import Measure
from freebody.measures.combination import Combination
from freebody.measures.geometry import ONE
from freebody.model import glyphs
from freebody.model.elements import ConstraintRow, DryFriction, UnilateralConstraint
from freebody.model.friction import read_friction
from freebody.model.glyphs import Glyph
from freebody.model.spec import Formula, Heading
from freebody.model.thread import Thread

if TYPE_CHECKING:
    from freebody.model.names import Names


class Screw(AxialJoint, kind="screw"):
    """`screw: {first: ground.A, second: nut, about: x, pitch: 2 mm}`: a cylindrical joint in which a turn of the second
    body moves it by the pitch along the axis (5 rows). A negative pitch is a left-hand thread. `friction` in the thread
    needs its mean `radius`; the screw locks itself where the coefficient is at least pitch/(2 pi radius). The friction
    force is its part round the axis."""

    space_only = True

    first: str
    second: str
    about: Heading
    pitch: Formula
    second_axis: Heading | None = None
    friction: Formula | dict[str, Any] = 0
    radius: Formula | None = None

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

    def bounds(self, names: Names, connection: str) -> tuple[list[UnilateralConstraint], list[DryFriction]]:
        friction = read_friction(names, self.friction, DIMENSIONLESS)
        with names.quietly():
            joint = self.joint(names)
        if friction.is_none or joint is None:
            return [], []
        radius = names.optional(self, "radius", LENGTH)
        if radius is None:
            names.problem(Message("friction in a thread acts at its mean radius; give radius"), "friction")
            return [], []
        slope = divide(names.formula(self.pitch, LENGTH, "pitch"), 2 * PI * radius)
        slip = Combination(((radius, joint.angle), (slope, joint.travel)), LENGTH)
        row = ConstraintRow("slip", "friction force", slip, connection=connection)
        return [], [DryFriction(row, friction.static, friction.kinetic, (f"{connection}.thread",))]

    def thread(self, names: Names) -> Thread | Message:
        with names.quietly():
            friction, radius = (
                read_friction(names, self.friction, DIMENSIONLESS),
                names.optional(self, "radius", LENGTH),
            )
            pitch = names.formula(self.pitch, LENGTH, "pitch")
        if radius is None:
            return Message("friction in a thread acts at its mean radius; give radius")
        is_left_handed = (names.numeric(pitch) or 0.0) < 0.0
        slope = divide(negate(pitch) if is_left_handed else pitch, 2 * PI * radius)
        return Thread(slope, friction.static, friction.kinetic)

    def measured(self, joint: Joint) -> Iterable[tuple[str, Measure]]:
        return (("angle", joint.angle),)

    def sign(self, joint: Joint) -> Glyph:
        return glyphs.Rail(joint.first, joint.second, joint.axis, "about", has_thread=True)
