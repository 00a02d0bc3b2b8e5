"""Uniform gravity on every body with mass."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING, ClassVar

from freebody.errors import UnitError
from freebody.language.expression import Expr, multiply
from freebody.language.sentences import Message
from freebody.language.units import ACCELERATION, FORCE, Dimension, parse_quantity
from freebody.loads.base import Load
from freebody.measures.displacement import Displacement
from freebody.measures.geometry import ZERO, Direction
from freebody.model import glyphs
from freebody.model.elements import AppliedLoad, RigidBody
from freebody.model.glyphs import Glyph
from freebody.model.spec import Formula, Heading

if TYPE_CHECKING:
    from freebody.model.names import Names


class Gravity(Load, kind="gravity"):
    """`gravity: g`, `gravity: {strength: g, along: down}`. Pushes each mass centre with m g."""

    called: ClassVar[tuple[str, ...]] = ("weight",)
    also: ClassVar[tuple[str, ...]] = ("weight", "g", "Gewicht", "Gewichtskraft", "Schwerkraft")

    strength: Formula
    along: Heading = "down"

    stores_energy = True
    spread_over = "mass"
    example = """
bodies: {ball: {particle: {mass: 1 kg}}}
loads: {it: {gravity: 9.81 m/s^2}}
"""

    def applied_loads(self, names: Names) -> list[AppliedLoad]:
        if _is_of(self.along, ACCELERATION):
            told = Message(
                "gravity is a strength and a direction, not components: gravity: 9.81 m/s^2, or "
                "{{strength: 9.81 m/s^2, along: down}}"
            )
            names.problem(told)
            return []
        if _is_of(self.strength, FORCE):
            told = Message(
                "gravity takes the acceleration g and pulls on every body by its own mass: gravity: 9.81 m/s^2; a "
                "single weight is a force: force: {{at: POINT, along: down, magnitude: {weight}}}",
                weight=self.strength,
            )
            names.problem(told, "strength")
            return []
        g = names.positive(self, "strength", ACCELERATION)
        along = names.direction(self.along, "along")
        names.fields.add((along, g))
        return [
            self._weight(names, body, along, g)
            for body in names.bodies.values()
            if body.mass != ZERO and not body.fixed
        ]

    def _weight(self, names: Names, body: RigidBody, along: Direction, g: Expr) -> AppliedLoad:
        """At the mass centre, or as what lays the body along its way says."""
        laid = (connection.weighs(names, body.name, along) for connection in names.connections.values())
        spread = next((found for found in laid if found is not None), None)
        if spread is not None:
            return AppliedLoad(body.name, spread[0], multiply(g, spread[1]))
        return AppliedLoad(
            body.name, Displacement(body.mass_center, names.ground_origin, along), multiply(body.mass, g)
        )

    def glyphs(self, names: Names) -> Iterable[Glyph]:
        yield glyphs.Field(names.direction(self.along, "along"))


def _is_of(value: Heading, dimension: Dimension) -> bool:
    """Whether a quantity of some dimension stands where another one belongs."""
    try:
        return isinstance(value, str) and parse_quantity(value).dimension == dimension
    except UnitError:
        return False
