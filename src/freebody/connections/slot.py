"""Pin in a slot: a point of one body moves along a straight slot of another; both may turn."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING

from freebody.connections.base import Connection
from freebody.connections.slider import guide
from freebody.measures.base import Measure
from freebody.measures.geometry import GROUND
from freebody.model.elements import Held
from freebody.model.spec import Heading

if TYPE_CHECKING:
    from freebody.model.names import Names


class Slot(Connection, kind="slot"):
    """`slot: {pin: rod.end, along: up}`; `on` is the slotted body (default the ground), `through` a point of
    the slot's centre line. Holds the displacement across the slot (1 row)."""

    pin: str
    along: Heading
    on: str = GROUND
    through: str | None = None

    example = """
bodies: {rod: {rod: {mass: 1 kg, length: 1 m}}}
connections: {it: {slot: {pin: rod.end, along: up}}}
"""

    def rows(self, names: Names) -> list[Held]:
        point = names.point(self.pin, "pin")
        across, _along, direction = guide(names, point, self.along, self.on, self.through)
        if point.body == direction.body:
            names.problem(f"the pin and the slot are both on {point.body}")
            return []
        return [Held("normal", "normal force", across)]

    def offers(self, names: Names) -> Iterable[tuple[str, Measure]]:
        point = names.point(self.pin, "pin")
        yield "travel", guide(names, point, self.along, self.on, self.through)[1]
