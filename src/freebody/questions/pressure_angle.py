"""Pressure angle: by how much a cam pushes aside of the way on which its follower is guided.

It is the angle between the normal of the edge and the guide; friction in the guide jams the follower where it is large,
so that it is kept below 30 to 35 degrees. Source: Norton, Design of Machinery, sec. 8.6; Shigley & Uicker, sec. 6.6.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from freebody.language.sentences import Message, Sentence
from freebody.model.noting import did_you_mean
from freebody.questions.base import NAME, Described, Found, Path, Quantity, asked
from freebody.questions.motion import OfMeasure

if TYPE_CHECKING:
    from freebody.model.names import Names

EXAMPLE = """
bodies:
  disk: {body: {mass: 1 kg, inertia: 0.01 kg m^2}}
  valve: {particle: {mass: 1 kg}, near: {at: [0, 0.05 m]}}
connections:
  axle: {pin: [ground.O, disk]}
  guide: {slider: {body: valve, along: up}}
  cam: {cam: {cam: disk, follower: valve, base_radius: 40 mm, lift: 5 mm * (1 - cos(phi)), form: edge}}
measures: {phi: angle of disk from up}
start: {phi: 60 deg}
questions: {it: pressure angle of cam}
"""


@dataclass(frozen=True)
class PressureAngle(OfMeasure, kind="pressure angle"):
    """Of a cam: between the force on its follower and the way of this."""

    connection: str

    example = EXAMPLE

    def sentence(self, system: Described) -> Sentence:
        return Sentence("what.pressure_angle", {"connection": self.connection})


@asked("pressure angle of CAM", rf"pressure angle of (?:the )?(?P<of>{NAME})", rank=75)
def _pressure_angle(names: Names, found: Found, path: Path) -> Quantity | None:
    connection = names.connections.get(found["of"])
    if connection is None:
        hint = did_you_mean(found["of"], names.connections)
        names.unknown(found["of"], Message("there is no connection {name}.{hint}", name=found["of"], hint=hint), *path)
        return None
    measure = connection.aside_of_way(names)
    if isinstance(measure, str):
        names.problem(measure, *path)
        return None
    return PressureAngle(measure, 0, f"pressure angle of {found['of']}", found["of"])
