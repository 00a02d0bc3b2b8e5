"""Sphere: a homogeneous ball.

Moment of inertia: Beer, Johnston & Cornwell, Vector Mechanics for Engineers: Dynamics, inside back cover.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, ClassVar

from freebody.language.expression import multiply, number, power
from freebody.language.units import LENGTH, MASS
from freebody.measures.geometry import ZERO
from freebody.model.shapes.base import Build, Shape
from freebody.model.solids import SPHERE
from freebody.model.spec import Formula

if TYPE_CHECKING:
    from freebody.model.names import Names


class Sphere(Shape, kind="sphere"):
    """A homogeneous ball; I = 2/5 m R^2 about any axis through its centre."""

    also: ClassVar[tuple[str, ...]] = ("Kugel", "solid_sphere", "solid_ball")

    called: ClassVar[tuple[str, ...]] = ("ball",)

    mass: Formula = 0
    radius: Formula | None = None

    open_lengths: ClassVar[dict[str, tuple[str, ...]]] = {"radius": ()}

    example = "{mass: 1 kg, radius: 0.1 m}"

    def build(self, names: Names) -> Build:
        m, r = names.positive(self, "mass", MASS), names.positive(self, "radius", LENGTH)
        inertia = multiply(number(2), m, power(r, number(2))) / number(5)
        tensor = (inertia, inertia, inertia, ZERO, ZERO, ZERO) if names.space else ()
        return Build(m, inertia, radius=r, tensor=tensor, round="sphere", solid=SPHERE, sizes=(r,))
