"""Rope: a heavy rope or chain, uniform, inextensible and without resistance to bending.

Its place is that of its last end, and all of it runs as fast as that: along its way it has one freedom, and the inertia
m. What lies where, and what of its weight drives it, says the connection that lays it over edges and wheels.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, ClassVar

from freebody.language.expression import ONE, multiply
from freebody.language.sentences import Message
from freebody.language.units import LENGTH, MASS
from freebody.measures.geometry import ZERO
from freebody.model.shapes.base import Build, Shape
from freebody.model.solids import ROPE
from freebody.model.spec import Formula

if TYPE_CHECKING:
    from freebody.model.names import Names


class Rope(Shape, kind="rope"):
    """A uniform heavy rope or chain by its last end, which has no angle; `mass: m` of all of it, or
    `mass_per_length: rho`. A `heavy_rope` among the connections says over what it runs."""

    called: ClassVar[tuple[str, ...]] = ("chain", "cable", "rope")

    length: Formula
    mass: Formula | None = None
    mass_per_length: Formula | None = None

    example = "{mass: 1 kg, length: 2 m}"

    def build(self, names: Names) -> Build:
        length = names.positive(self, "length", LENGTH)
        whole, by_length = names.optional(self, "mass", MASS), names.optional(self, "mass_per_length", MASS / LENGTH)
        if (whole is None) == (by_length is None):
            names.problem(Message("give mass, that of the whole rope, or mass_per_length"))
            whole = ONE
        mass = multiply(by_length, length) if by_length is not None else whole
        assert mass is not None
        return Build(mass, ZERO, turns=False, solid=ROPE, sizes=(length,))
