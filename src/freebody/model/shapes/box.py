"""Box: a homogeneous block in space.

Moment of inertia: Beer, Johnston & Cornwell, Vector Mechanics for Engineers: Dynamics, inside back cover.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, ClassVar

from freebody.language.expression import divide, number
from freebody.language.sentences import Message
from freebody.language.units import LENGTH, MASS
from freebody.measures.geometry import ZERO
from freebody.model.shapes.base import Build, Shape, half, square
from freebody.model.solids import BOX
from freebody.model.spec import Formula

if TYPE_CHECKING:
    from freebody.model.names import Names


class Box(Shape, kind="box"):
    """A homogeneous block with the sides `size: [a, b, c]` along its x, y and z; I_x = m (b^2 + c^2)/12. Points: the
    middles of its faces, `left`, `right` (x), `bottom`, `top` (y), `back`, `front` (z). For models in space."""

    space_only = True
    in_plane_take = "rectangle"

    called: ClassVar[tuple[str, ...]] = ("block", "crate", "brick", "domino")
    also: ClassVar[tuple[str, ...]] = ("block", "crate", "brick")

    mass: Formula = 0
    size: list[Formula]

    example = "{mass: 1 kg, size: [1 m, 0.1 m, 0.2 m]}"

    def build(self, names: Names) -> Build:
        m = names.positive(self, "mass", MASS)
        if len(self.size) != 3:
            names.problem(
                Message("size is three sides, [a, b, c] along x, y and z, found {size}", size=repr(self.size)),
                "size",
            )
        a, b, c = names.sides(self.size, LENGTH, "size")
        Ix, Iy, Iz = (divide(m * (square(p) + square(q)), number(12)) for p, q in ((b, c), (a, c), (a, b)))
        x, y, z = map(half, (a, b, c))
        return Build(
            m,
            Iz,
            points={
                "left": (-x, ZERO, ZERO),
                "right": (x, ZERO, ZERO),
                "bottom": (ZERO, -y, ZERO),
                "top": (ZERO, y, ZERO),
                "back": (ZERO, ZERO, -z),
                "front": (ZERO, ZERO, z),
            },
            tensor=(Ix, Iy, Iz, ZERO, ZERO, ZERO),
            solid=BOX,
            sizes=(a, b, c),
        )
