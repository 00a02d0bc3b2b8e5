"""Weld: two bodies keep their relative pose."""

from __future__ import annotations

from typing import TYPE_CHECKING

from freebody.connections.base import Connection, coincidence
from freebody.language.units import DIMENSIONLESS
from freebody.measures.angle import Angle
from freebody.measures.combination import Combination
from freebody.measures.geometry import ONE
from freebody.model.elements import Held

if TYPE_CHECKING:
    from freebody.model.names import Names


class Weld(Connection, kind="weld"):
    """`weld: [ground.A, beam.start]`. Two points coincide and the angle between the bodies stays as it is at
    the start (3 rows)."""

    first: str
    second: str

    example = """
bodies: {beam: {rod: {mass: 1 kg, length: 1 m}}}
connections: {it: {weld: [ground.A, beam.start]}}
"""

    def rows(self, names: Names) -> list[Held]:
        first, second = names.point(self.first, "first"), names.point(self.second, "second")
        if first.body == second.body:
            names.problem(f"welds {first.body} to itself; name points of two bodies")
            return []
        rows = coincidence(first, second)
        if names.known(first.body).turns and names.known(second.body).turns:
            angle = Angle(second.body, first.body)
            rows.append(Held("angle", "moment", Combination(((ONE, angle),), DIMENSIONLESS)))
        return rows
