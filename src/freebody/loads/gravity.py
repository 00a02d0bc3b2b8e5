"""Uniform gravity on every body with mass."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING, ClassVar

from freebody.language.expression import multiply
from freebody.language.units import ACCELERATION
from freebody.loads.base import Load
from freebody.measures.displacement import Displacement
from freebody.measures.geometry import ZERO
from freebody.model import glyphs
from freebody.model.elements import AppliedLoad
from freebody.model.glyphs import Glyph
from freebody.model.spec import Formula, Heading

if TYPE_CHECKING:
    from freebody.model.names import Names


class Gravity(Load, kind="gravity"):
    """`gravity: g`, `gravity: {strength: g, along: down}`. Pushes each mass centre with m g."""

    called: ClassVar[tuple[str, ...]] = ("weight",)

    strength: Formula
    along: Heading = "down"

    stores_energy = True
    example = """
bodies: {ball: {particle: {mass: 1 kg}}}
loads: {it: {gravity: 9.81 m/s^2}}
"""

    def applied_loads(self, names: Names) -> list[AppliedLoad]:
        g = names.positive(self, "strength", ACCELERATION)
        along = names.direction(self.along, "along")
        origin = names.ground_origin
        return [
            AppliedLoad(body.name, Displacement(body.mass_center, origin, along), multiply(body.mass, g))
            for body in names.bodies.values()
            if body.mass != ZERO and not body.fixed
        ]

    def glyphs(self, names: Names) -> Iterable[Glyph]:
        yield glyphs.Field(names.direction(self.along, "along"))
