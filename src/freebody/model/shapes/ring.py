"""Ring: a thin hoop."""

from __future__ import annotations

from typing import TYPE_CHECKING, ClassVar

from freebody.language.units import LENGTH, MASS
from freebody.model.shapes.base import Build, square
from freebody.model.shapes.gyration import Gyrating
from freebody.model.shapes.round import wheel
from freebody.model.solids import RING
from freebody.model.spec import Formula, Heading

if TYPE_CHECKING:
    from freebody.model.names import Names


class Ring(Gyrating, kind="ring"):
    """A thin ring or hoop; I = m R^2 unless `inertia`, or `radius_of_gyration: k`, is given. Wheels may run on its
    inside. `hub: r` is the radius of a second circle about its middle, on which a rope is wound."""

    called: ClassVar[tuple[str, ...]] = ("hoop", "wheel", "pipe")
    also: ClassVar[tuple[str, ...]] = ("hoop", "thin_ring", "thin_hoop", "rim")

    mass: Formula = 0
    radius: Formula | None = None
    inertia: Formula | None = None
    hub: Formula | None = None
    axis: Heading = "z"

    open_lengths: ClassVar[dict[str, tuple[str, ...]]] = {"radius": ()}

    example = "{mass: 1 kg, radius: 0.5 m}"

    def build(self, names: Names) -> Build:
        m, r = names.positive(self, "mass", MASS), names.positive(self, "radius", LENGTH)
        return wheel(names, self, m, r, m * square(r), RING)
