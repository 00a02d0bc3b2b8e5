"""Rack and pinion: the pitch circle of a pinion rolls on the pitch line of a rack."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING, Self

from freebody.connections.base import Connection
from freebody.connections.standing import ground_guide_of, is_parallel, number_of, stands_at, starts_at
from freebody.connections.teeth import parting_slope, parts_of_tooth_force, read_pressure_angle
from freebody.language.expression import ZERO, Call, Expr, add, negate
from freebody.language.sentences import Message
from freebody.language.units import LENGTH
from freebody.measures.angle import Angle
from freebody.measures.base import Measure
from freebody.measures.combination import Combination
from freebody.measures.displacement import Displacement
from freebody.measures.geometry import GROUND, ONE, Direction
from freebody.model import glyphs
from freebody.model.elements import ConstraintRow, RigidBody
from freebody.model.glyphs import Glyph
from freebody.model.pressed_side import Flank
from freebody.model.spec import Formula, Heading
from freebody.tolerances import ROUND_OFF

if TYPE_CHECKING:
    from freebody.model.names import Names


class RackAndPinion(Connection, kind="rack_and_pinion"):
    """`rack_and_pinion: {pinion: gear, rack: bar, along: right}`; the rack's teeth run `along` (a direction
    fixed in the rack; without it, along the guide of the rack or, where that is fixed, of the pinion; else to the
    rack's right). The rack is below the pinion for a direction to the right, to its right for one that goes up, unless
    the places of the two say otherwise; `above: true` puts it on the other side. Bearings hold the distance (1 row).
    The tooth force is positive when it drives the rack along its direction. With a `pressure_angle` the teeth part the
    two as well, by its tangent times the tooth force, which is positive then, or negative with `other_flank: true`."""

    pinion: str
    rack: str
    along: Heading | None = None
    above: bool | None = None
    radius: Formula | None = None
    pressure_angle: Formula | None = None
    other_flank: bool = False

    in_plane = True
    has_contact_point = True
    example = """
bodies: {gear: {disk: {mass: 1 kg, radius: 1 m}}, bar: {rectangle: {mass: 1 kg, width: 4 m, height: 1 m}}}
connections: {p: {pin: [ground.A, gear]}, g: {slider: {body: bar, along: right}},
  it: {rack_and_pinion: {pinion: gear, rack: bar}}}
"""

    def as_meant(self, names: Names) -> Self:
        """With the pinion first, which is the one that has a radius."""
        pinion, rack = names.bodies.get(self.pinion), names.bodies.get(self.rack)
        if pinion is None or rack is None or pinion.radius is not None or rack.radius is None:
            return self
        return self.model_copy(update={"pinion": self.rack, "rack": self.pinion})

    def rows(self, names: Names) -> list[ConstraintRow]:
        pinion, rack = names.body(self.pinion, "pinion"), names.body(self.rack, "rack")
        along = self._pitch_line(names, rack, pinion)
        if pinion.name == rack.name:
            names.problem(Message("{pinion} cannot be its own rack", pinion=pinion.name))
            return []
        # rolling of the pinion on a line of the rack: s + R theta, seen from the rack
        travel = Displacement(pinion.center, rack.center, along)
        arm = self._arm(names, pinion, rack, along)
        terms: list[tuple[Expr, Measure]] = [(ONE, travel), (arm, Angle(pinion.name, along.body))]
        slope = parting_slope(read_pressure_angle(names, self))
        flank, pressed = -1 if self.other_flank else 1, None
        if slope != ZERO:  # the pinion is on the left of the rack's direction, with the rack below it
            is_above = self._is_above(names, pinion, rack, along)
            parting = slope if is_above == (flank > 0) else -slope
            apart = Displacement(pinion.center, rack.center, along.normal())
            pressed = Flank(flank, Combination((*terms, (negate(parting), apart)), LENGTH))
            terms.append((parting, apart))
        rolled = Combination(tuple(terms), LENGTH)
        return [ConstraintRow("teeth", "tooth force", rolled, sign=-1, pressed=pressed)]

    def parts(self, names: Names) -> dict[str, Expr]:
        return parts_of_tooth_force(read_pressure_angle(names, self))

    def _arm(self, names: Names, pinion: RigidBody, rack: RigidBody, along: Direction) -> Expr:
        """The radius of the pinion, negative where the rack is on its left."""
        own = names.optional(self, "radius", LENGTH)
        radius = names.radius(pinion.name, "pinion") if own is None else own
        return negate(radius) if self._is_above(names, pinion, rack, along) else radius

    def _pitch_line(self, names: Names, rack: RigidBody, pinion: RigidBody) -> Direction:
        """Where the teeth run: what a guide on the ground lets the rack do must be a motion along them."""
        given = names.direction("right" if self.along is None else self.along, "along", body=rack.name)
        guide = ground_guide_of(names, (pinion if rack.fixed else rack).name, turning=True)
        here = _at_start(rack, given)
        if guide is None or here is None or is_parallel(names, guide, here):
            return given
        if self.along is not None:
            if rack.fixed or stands_at(names, pinion.center, here.normal()) is not None:
                guided = pinion.name if rack.fixed else rack.name
                names.problem(
                    Message(
                        "the teeth of {rack} run along {along}, but the guide of {guided} runs along {guide}: the "
                        "pinion leaves the teeth or is held fast. Leave along out, or turn the rack (angle) or the "
                        "guide",
                        rack=rack.name,
                        along=self.along,
                        guided=guided,
                        guide=guide.name,
                    ),
                    "along",
                )
            return given
        x, y = (number_of(names, c) for c in guide.components[:2])
        line = guide if x > ROUND_OFF or (abs(x) <= ROUND_OFF and y > 0) else guide.reversed()
        me = self.own_name(names)
        told = Message(
            "{connection}: the teeth of {rack} run along the guide of {pinion}"
            if rack.fixed
            else "{connection}: the teeth of {rack} run along its guide",
            connection=me,
            rack=rack.name,
            pinion=pinion.name,
        )
        names.assumptions.append(told)
        return line

    def _is_above(self, names: Names, pinion: RigidBody, rack: RigidBody, along: Direction) -> bool:
        """Whether the rack is on the left of the pinion, looking along its direction."""
        if self.above is not None:
            return self.above
        here = _at_start(rack, along)
        if here is None:
            return False
        places = [starts_at(names, body.center, here.normal()) for body in (rack, pinion)]
        if places[0] is None or places[1] is None:
            return False
        return number_of(names, add(places[0], negate(places[1]))) > ROUND_OFF

    def glyphs(self, names: Names) -> Iterable[Glyph]:
        pinion, rack = names.body(self.pinion), names.body(self.rack)
        along = self._pitch_line(names, rack, pinion)
        yield glyphs.Track(pinion.center, along, self._arm(names, pinion, rack, along), is_toothed=True)


def _at_start(rack: RigidBody, along: Direction) -> Direction | None:
    """A direction in the rack by components on the ground, at the start; None where the angle is not given."""
    if along.body != rack.name:
        return along
    if rack.start.angle is None:
        known = rack.start.near is None or rack.start.near.angle is None
        return Direction(GROUND, along.components, along.name) if known else None
    c, s = Call("cos", rack.start.angle), Call("sin", rack.start.angle)
    x, y, *_ = along.components
    return Direction(GROUND, (add(c * x, negate(s * y)), add(s * x, c * y)), along.name)
