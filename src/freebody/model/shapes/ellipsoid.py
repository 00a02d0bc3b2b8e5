"""A body whose surface is an ellipsoid, homogeneous or with a mass centre and moments of inertia of its own.

Homogeneous: I_x = m (b^2 + c^2)/5 about the axis of the semi-axis a, and so on. Source: Beer, Johnston & Cornwell,
Vector Mechanics for Engineers: Dynamics, inside back cover.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, ClassVar

from freebody.language.expression import ZERO, divide, number
from freebody.language.sentences import Message
from freebody.language.units import LENGTH, MASS
from freebody.model.shapes.base import Build, Shape, square
from freebody.model.solids import ELLIPSOID
from freebody.model.spec import Formula
from freebody.model.tensors import read_tensor

if TYPE_CHECKING:
    from freebody.model.names import Names


class Ellipsoid(Shape, kind="ellipsoid"):
    """A body that is rounded as an ellipsoid with `semi_axes: [a, b, c]` along its x, y and z, about its `center`;
    homogeneous unless `inertia` gives its moments of inertia about the mass centre, [Ixx, Iyy, Izz] or three rows, and
    `center_of_mass` its mass centre from the `center`. Three equal semi-axes make it a ball: a tippe top has its mass
    centre below the middle, a rattleback other principal axes than its surface has. For models in space."""

    space_only = True

    called: ClassVar[tuple[str, ...]] = ("egg", "top", "rattleback", "celt", "stone")

    mass: Formula = 0
    semi_axes: list[Formula]
    inertia: list[Formula] | list[list[Formula]] | None = None
    center_of_mass: list[Formula] | None = None

    example = "{mass: 1 kg, semi_axes: [0.3 m, 0.2 m, 0.1 m]}"

    def build(self, names: Names) -> Build:
        m = names.positive(self, "mass", MASS)
        if len(self.semi_axes) != 3:
            told = Message("semi_axes are three, [a, b, c] along x, y and z, found {n}", n=len(self.semi_axes))
            names.problem(told, "semi_axes")
            return Build(m, ZERO)
        a, b, c = names.sides(self.semi_axes, LENGTH, "semi_axes")
        middle = names.vector(self, "center_of_mass", LENGTH) or names.origin
        if self.inertia is not None:
            tensor = read_tensor(names, self.inertia, m, middle, "mass_center")
        elif self.center_of_mass is not None:
            told = Message("with a mass centre beside its middle it is not homogeneous: give inertia as well")
            names.problem(told, "center_of_mass")
            return Build(m, ZERO)
        else:
            moments = (divide(m * (square(p) + square(q)), number(5)) for p, q in ((b, c), (a, c), (a, b)))
            tensor = (*moments, ZERO, ZERO, ZERO)
        return Build(m, tensor[2], middle, {"center": names.origin}, tensor=tensor, solid=ELLIPSOID, sizes=(a, b, c))
