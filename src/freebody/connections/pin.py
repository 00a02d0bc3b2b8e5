"""Pin (revolute joint): two points coincide, the bodies turn freely about them."""

from __future__ import annotations

from typing import TYPE_CHECKING

from freebody.connections.base import Connection, coincidence
from freebody.model.elements import Held

if TYPE_CHECKING:
    from freebody.model.names import Names


class Pin(Connection, kind="pin"):
    """`pin: [ground.A, rod.start]`. Holds r_second - r_first = 0 (2 rows)."""

    first: str
    second: str

    example = """
bodies: {rod: {rod: {mass: 1 kg, length: 1 m}}}
connections: {it: {pin: [ground.A, rod.start]}}
"""

    def rows(self, names: Names) -> list[Held]:
        first, second = names.point(self.first, "first"), names.point(self.second, "second")
        if first.body == second.body:
            names.problem(f"pins {first.body} to itself; name points of two bodies")
            return []
        return coincidence(first, second)
