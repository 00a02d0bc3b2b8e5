"""Cylinder: a homogeneous one in space.

Moment of inertia: Beer, Johnston & Cornwell, Vector Mechanics for Engineers: Dynamics, inside back cover.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, ClassVar

from freebody.language.expression import divide, number
from freebody.language.units import LENGTH, MASS
from freebody.model.shapes.base import Build, Shape, half, square
from freebody.model.shapes.round import about_axis, own_axis
from freebody.model.solids import CYLINDER
from freebody.model.spec import Formula, Heading

if TYPE_CHECKING:
    from freebody.model.names import Names


class Cylinder(Shape, kind="cylinder"):
    """A homogeneous cylinder about its `axis` (z): I = m R^2/2 about it, m (3 R^2 + L^2)/12 across. Points `start`,
    `end`: the middles of its ends. For models in space."""

    space_only = True
    in_plane_take = "disk"

    called: ClassVar[tuple[str, ...]] = ("roller", "drum", "disk", "disc", "wheel", "shaft")

    mass: Formula = 0
    radius: Formula
    length: Formula
    axis: Heading = "z"

    example = "{mass: 1 kg, radius: 0.1 m, length: 1 m, axis: z}"

    def build(self, names: Names) -> Build:
        m, r, length = (names.positive(self, f, d) for f, d in (("mass", MASS), ("radius", LENGTH), ("length", LENGTH)))
        along = half(m * square(r))
        axis = own_axis(names, self)
        end = half(length)
        return Build(
            m,
            along,
            points={"start": tuple(-end * c for c in axis), "end": tuple(end * c for c in axis)},
            radius=r,
            tensor=about_axis(axis, along, divide(m * (3 * square(r) + square(length)), number(12))),
            round="disk",
            axis=axis,
            solid=CYLINDER,
            sizes=(r, length),
        )
