"""Gear trains whose wheels have their axles on a body that turns: its carrier, its planets, and its central gears."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING

from freebody.errors import CannotAnswer
from freebody.language.sentences import Message
from freebody.measures.geometry import GROUND, Point

if TYPE_CHECKING:
    from freebody.model.names import Names


@dataclass(frozen=True)
class GearTrain:
    """A planetary gear. members: the gears that mesh with the planets, in the order of the file."""

    carrier: str
    planets: tuple[str, ...]
    members: tuple[str, ...]


def gear_trains(names: Names) -> list[GearTrain]:
    """The planetary gears of a model of the plane, one for each carrier. Raises CannotAnswer where no body carries a
    gear that meshes."""
    found: list[GearTrain] = []
    meshes = [c for c in names.connections.values() if c.has_contact_point]
    for carrier in (name for name, body in names.bodies.items() if name != GROUND and not body.fixed):
        planets = _borne(names, carrier)
        mesh = [c for c in meshes if c.mentions(names) & set(planets)]
        alike = {copy for planet in planets for copy in names.bodies[planet].copies}
        gears = {body for c in mesh for body in c.mentions(names)} - {carrier, *planets, *alike, GROUND}
        if mesh and gears:
            found.append(GearTrain(carrier, tuple(planets), tuple(b for b in names.bodies if b in gears)))
    if found:
        return found
    raise CannotAnswer(Message("no body carries a gear on an axle of its own that meshes with others"))


def _borne(names: Names, carrier: str) -> list[str]:
    """The bodies that a body carries beside the axis about which it turns itself."""
    pairs = [pair for joint in _joints(names) for pair in (joint, joint[::-1]) if pair[0].body == carrier]
    axes = {own.offset for own, other in pairs if other.body == GROUND}
    copies = {copy for body in names.bodies.values() for copy in body.copies}  # they turn as the one that is written
    found = [other.body for own, other in pairs if axes and own.offset not in axes and other.body not in copies]
    return list(dict.fromkeys(found))


def _joints(names: Names) -> Iterator[tuple[Point, Point]]:
    for connection in names.connections.values():
        joined = connection.joined_points(names)
        if joined is not None:
            yield joined
