"""Disk: a uniform disk.

Moment of inertia: Beer, Johnston & Cornwell, Vector Mechanics for Engineers: Dynamics, inside back cover.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, ClassVar

from freebody.language.sentences import Message
from freebody.language.units import LENGTH, MASS
from freebody.model.shapes.base import Build, half, square
from freebody.model.shapes.gyration import Gyrating
from freebody.model.shapes.round import wheel
from freebody.model.solids import DISK
from freebody.model.spec import Formula, Heading

if TYPE_CHECKING:
    from freebody.model.names import Names


class Disk(Gyrating, kind="disk"):
    """A uniform disk (or cylinder, pulley, gear wheel); I = m R^2/2 unless `inertia`, or `radius_of_gyration: k`, is
    given. `hub: r` is the radius of a second circle about its middle, on which a rope is wound (`wound on spool.hub`)
    or that touches something (`spool.hub`). In space it is thin, about its `axis` (z), with half of that inertia about
    its diameters."""

    called: ClassVar[tuple[str, ...]] = ("disc", "wheel", "cylinder", "pulley", "roller", "drum", "gear", "flywheel")
    elsewhere: ClassVar[Mapping[str, str]] = {
        **Gyrating.elsewhere,
        **dict.fromkeys(
            ("teeth", "module"),
            Message("teeth and a module are those of a gear: {{gear: {{teeth: 20, module: 2 mm}}}}"),
        ),
        **dict.fromkeys(
            ("inner_radius", "small_radius"),
            Message("a smaller circle for a rope is its hub: {{radius: R, hub: r}}; what has a hole is an annulus"),
        ),
        **dict.fromkeys(
            ("eccentricity", "eccentric", "offset", "e"),
            Message(
                "an axle beside its middle is a point of it, at which it is pinned: beside the disk "
                "points: {{axle: [-e, 0]}}"
            ),
        ),
    }
    also: ClassVar[tuple[str, ...]] = (
        *("solid_disk", "solid_disc", "solid_cylinder", "sheave"),
        "disc",
        "cylinder",
        "pulley",
        "roller",
        "drum",
        "flywheel",
        "sprocket",
        "Scheibe",
        "Rolle",
        "Walze",
        "Schwungrad",
        "Zylinder",
        "Trommel",
    )

    mass: Formula = 0
    radius: Formula | None = None
    inertia: Formula | None = None
    hub: Formula | None = None
    axis: Heading = "z"

    open_lengths: ClassVar[dict[str, tuple[str, ...]]] = {"radius": ()}

    example = "{mass: 1 kg, radius: 0.2 m}"

    def build(self, names: Names) -> Build:
        m, r = names.positive(self, "mass", MASS), names.positive(self, "radius", LENGTH)
        return wheel(names, self, m, r, half(m * square(r)), DISK)
