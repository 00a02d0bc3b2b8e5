"""Gear: a wheel by its module and its number of teeth.

The pitch circle has the diameter d = m z. Source: ISO 21771; Shigley, Mechanical Engineering Design, sec. 13-1.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import TYPE_CHECKING, Any, ClassVar

from freebody.language.expression import ONE, divide, free_symbols, multiply, number
from freebody.language.sentences import Message
from freebody.language.units import DIMENSIONLESS, LENGTH, MASS
from freebody.model.elements import Teeth
from freebody.model.shapes.base import Build, half, square
from freebody.model.shapes.gyration import Gyrating
from freebody.model.shapes.round import wheel
from freebody.model.solids import DISK, RING
from freebody.model.spec import Formula, Heading
from freebody.tolerances import ROUNDED

if TYPE_CHECKING:
    from freebody.model.names import Names


_INTERNAL = ("ring_gear", "internal_gear", "annular_gear", "Hohlrad")


class Gear(Gyrating, kind="gear"):
    """`gear: {teeth: z, module: m, mass: M}`: a uniform disk of the radius m z/2 of its pitch circle, M r^2/2 unless
    `inertia` is given; gears of one module mesh (`gear_mesh: [sun, planet]`). `internal: true` for a ring gear, a thin
    ring, M r^2. A `radius` in place of teeth and module where only the ratio counts."""

    called: ClassVar[tuple[str, ...]] = ("disk", "gear wheel", "cog", "pinion")
    also: ClassVar[tuple[str, ...]] = ("pinion", "Zahnrad", *_INTERNAL)
    meant_by_word: ClassVar[Mapping[str, Mapping[str, Any]]] = {word: {"internal": True} for word in _INTERNAL}

    elsewhere: ClassVar[Mapping[str, str]] = {
        **Gyrating.elsewhere,
        "m": Message("m may be its mass or its module: write mass, or module"),
    }

    mass: Formula = 0
    teeth: Formula | None = None
    module: Formula | None = None
    radius: Formula | None = None
    internal: bool = False
    inertia: Formula | None = None
    axis: Heading = "z"

    open_lengths: ClassVar[dict[str, tuple[str, ...]]] = {"radius": ()}

    example = "{mass: 1 kg, teeth: 20, module: 10 mm}"

    def lengths_left_open(self) -> Mapping[str, tuple[str, ...]]:
        return self.open_lengths if self.teeth is None and self.module is None else {}

    def build(self, names: Names) -> Build:
        M, teeth = names.positive(self, "mass", MASS), self._teeth(names)
        r = names.positive(self, "radius", LENGTH) if teeth is None else teeth.radius
        own, solid = (M * square(r), RING) if self.internal else (half(M * square(r)), DISK)
        return replace(wheel(names, self, M, r, own, solid), teeth=teeth, has_inner_teeth=self.internal)

    def _teeth(self, names: Names) -> Teeth | None:
        if self.teeth is None and self.module is None:
            return None
        if self.teeth is None or self.module is None:
            names.problem(Message("a gear has teeth and a module, e.g. gear: {{teeth: 20, module: 2 mm}}"))
            return Teeth(ONE, ONE, ONE)
        z, m = names.positive(self, "teeth", DIMENSIONLESS), names.positive(self, "module", LENGTH)
        names.counts.update(free_symbols(z))
        count = names.numeric(z)
        if count is not None and abs(count - round(count)) > ROUNDED:
            near = max(1, round(count))
            names.problem(Message("{z:g} teeth: a number of teeth is whole, e.g. {near}", z=count, near=near), "teeth")
        return Teeth(z, m, divide(multiply(m, z), number(2)))
