"""Particle: a point mass."""

from __future__ import annotations

from typing import TYPE_CHECKING, ClassVar

from freebody.language.units import MASS
from freebody.measures.geometry import ZERO
from freebody.model.shapes.base import Build, Shape
from freebody.model.spec import Formula

if TYPE_CHECKING:
    from freebody.model.names import Names


class Particle(Shape, kind="particle"):
    """A point mass; it has no angle."""

    called: ClassVar[tuple[str, ...]] = (
        *("block", "bob", "bead", "ball", "object", "weight"),
        *("piston", "car", "cart", "collar"),
    )
    also: ClassVar[tuple[str, ...]] = (
        *("block", "bob", "bead", "piston", "car", "cart", "collar"),
        *("Massenpunkt", "Punktmasse", "Kolben", "Klotz", "Perle", "Wagen", "point_mass"),
    )

    mass: Formula = 0

    example = "{mass: 1 kg}"

    def build(self, names: Names) -> Build:
        return Build(names.positive(self, "mass", MASS), ZERO, turns=False)
