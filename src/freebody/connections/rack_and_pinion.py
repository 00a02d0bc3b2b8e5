"""Rack and pinion: the pitch circle of a pinion rolls on the pitch line of a rack."""

from __future__ import annotations

from typing import TYPE_CHECKING

from freebody.connections.base import Connection
from freebody.language.expression import negate
from freebody.language.units import LENGTH
from freebody.measures.angle import Angle
from freebody.measures.combination import Combination
from freebody.measures.displacement import Displacement
from freebody.measures.geometry import ONE
from freebody.model.elements import Held
from freebody.model.spec import Formula, Heading

if TYPE_CHECKING:
    from freebody.model.names import Names


class RackAndPinion(Connection, kind="rack_and_pinion"):
    """`rack_and_pinion: {pinion: gear, rack: bar, along: right}`; the rack's teeth run `along` (a direction
    fixed in the rack) below the pinion (`above: true`: above it). Bearings hold the distance (1 row). The tooth
    force is positive when it drives the rack along its direction."""

    pinion: str
    rack: str
    along: Heading = "right"
    above: bool = False
    radius: Formula | None = None

    in_plane = True
    example = """
bodies: {gear: {disk: {mass: 1 kg, radius: 1 m}}, bar: {rectangle: {mass: 1 kg, width: 4 m, height: 1 m}}}
connections: {p: {pin: [ground.A, gear]}, g: {slider: {body: bar, along: right}},
  it: {rack_and_pinion: {pinion: gear, rack: bar}}}
"""

    def rows(self, names: Names) -> list[Held]:
        pinion, rack = names.body(self.pinion, "pinion"), names.body(self.rack, "rack")
        own = names.optional(self, "radius", LENGTH)
        radius = names.radius(pinion.name, "pinion") if own is None else own
        along = names.direction(self.along, "along", body=rack.name)
        if pinion.name == rack.name:
            names.problem(f"{pinion.name} cannot be its own rack")
            return []
        # rolling of the pinion on a line of the rack: s + R theta, seen from the rack
        arm = negate(radius) if self.above else radius
        travel = Displacement(pinion.center, rack.center, along)
        rolled = Combination(((ONE, travel), (arm, Angle(pinion.name, along.body))), LENGTH)
        return [Held("teeth", "tooth force", rolled, sign=-1)]
