"""Cams: by how much one pushes aside of the way on which its follower is guided, and how its edge is curved.

The pressure angle is that between the normal of the edge and the guide; friction in the guide jams the follower where
it is large, so that it is kept below 30 to 35 degrees. Where the edge would have no positive radius of curvature under
a flat face, or the path of a roller a smaller one than the roller, it cannot be cut (undercut). Source: Norton, Design
of Machinery, sec. 8.6 and 8.7; Shigley & Uicker, Theory of Machines and Mechanisms, sec. 6.6.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from freebody.language.sentences import Message, Sentence
from freebody.model.noting import did_you_mean
from freebody.questions.base import Described, Path, Quantity
from freebody.questions.forms import NAME, Found, asked
from freebody.questions.motion import OfMeasure

if TYPE_CHECKING:
    from collections.abc import Callable

    from freebody.measures.base import Measure
    from freebody.model.names import Joining, Names

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


@dataclass(frozen=True)
class EdgeRadius(OfMeasure, kind="radius of curvature"):
    """Of the edge of a cam, where it touches its follower; in undercut it is not positive."""

    connection: str

    example = EXAMPLE.replace("pressure angle", "radius of curvature")

    def sentence(self, system: Described) -> Sentence:
        return Sentence("what.edge_radius", {"connection": self.connection})


@asked("pressure angle of CAM", rf"pressure angle of (?:the )?(?P<of>{NAME})", rank=75)
def _pressure_angle(names: Names, found: Found, path: Path) -> Quantity | None:
    measure = _of_cam(names, found["of"], path, lambda cam: cam.aside_of_way(names))
    return None if measure is None else PressureAngle(measure, 0, f"pressure angle of {found['of']}", found["of"])


@asked("radius of curvature of CAM", rf"radius of curvature of (?:the )?(?P<of>{NAME})", rank=75)
def _edge_radius(names: Names, found: Found, path: Path) -> Quantity | None:
    measure = _of_cam(names, found["of"], path, lambda cam: cam.edge_radius(names))
    return None if measure is None else EdgeRadius(measure, 0, f"radius of curvature of {found['of']}", found["of"])


def _of_cam(names: Names, name: str, path: Path, measure_of: Callable[[Joining], Measure | Message]) -> Measure | None:
    """A measure of the cam of that name; None with a problem noted."""
    connection = names.connections.get(name)
    if connection is None:
        hint = did_you_mean(name, names.connections)
        names.unknown(name, Message("there is no connection {name}.{hint}", name=name, hint=hint), *path)
        return None
    measure = measure_of(connection)
    if isinstance(measure, str):
        names.problem(measure, *path)
        return None
    return measure
