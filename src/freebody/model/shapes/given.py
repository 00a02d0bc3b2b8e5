"""A body given by its mass and moments of inertia."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, ClassVar

from freebody.language.sentences import Message
from freebody.language.units import INERTIA, LENGTH, MASS
from freebody.measures.geometry import ZERO
from freebody.model.shapes.base import Build
from freebody.model.shapes.gyration import Gyrating
from freebody.model.shapes.round import with_hub
from freebody.model.spec import Formula
from freebody.model.tensors import read_tensor

if TYPE_CHECKING:
    from freebody.model.names import Names


class Body(Gyrating, kind="body"):
    """A body given by mass, moment of inertia about its mass centre, and the mass centre's place in the body's
    own frame, whose origin is the reference point `origin`; `radius_of_gyration: k` in place of the inertia. A `radius`
    makes its rim a circle about the origin, `hub: r` another one, on which a rope is wound (`wound on spool.hub`).

    In space `inertia` is the three moments about its axes, [Ixx, Iyy, Izz], or the tensor as three rows, about the mass
    centre, or `about: origin`, or another place by components."""

    called: ClassVar[tuple[str, ...]] = (
        *("block", "cart", "car", "disk", "disc", "wheel", "cylinder", "drum"),
        *("pulley", "gear", "plate", "platform", "crate", "shaft"),
    )

    elsewhere: ClassVar[Mapping[str, str]] = {
        **Gyrating.elsewhere,
        "axis": Message("its moments of inertia are those about its axes x, y and z: inertia: [Ixx, Iyy, Izz]"),
    }

    mass: Formula = 0
    inertia: Formula | list[Formula] | list[list[Formula]] = 0
    center_of_mass: list[Formula] | None = None
    radius: Formula | None = None
    hub: Formula | None = None
    about: str | list[Formula] = "mass_center"

    example = "{mass: 1 kg, inertia: 0.1 kg m^2, center_of_mass: [0.1 m, 0], radius: 0.2 m}"

    def build(self, names: Names) -> Build:
        mass = names.positive(self, "mass", MASS)
        middle = names.vector(self, "center_of_mass", LENGTH) or names.origin
        radius = names.optional(self, "radius", LENGTH)
        if names.space:
            tensor = read_tensor(names, self.inertia, mass, middle, self.about)
            about = Build(
                mass, tensor[2], middle, {"origin": names.origin}, radius, default_point="origin", tensor=tensor
            )
            return with_hub(names, self, about)
        if isinstance(self.inertia, list) or self.about != "mass_center":
            names.problem(Message("three moments of inertia are for models in space: write space: true"), "inertia")
            return Build(mass, ZERO, default_point="origin")
        about = Build(
            mass,
            names.positive(self, "inertia", INERTIA),
            middle,
            {"origin": (ZERO, ZERO)},
            radius,
            default_point="origin",
        )
        return with_hub(names, self, about)
