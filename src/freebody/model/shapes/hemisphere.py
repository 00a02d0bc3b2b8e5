"""Halves of balls: hemisphere and hemispherical shell.

From the centre of the ball, along the axis of symmetry x:

    hemisphere   x_G = 3 R/8    I = 2/5 m R^2 about every axis through the centre
    shell        x_G = R/2      I = 2/3 m R^2

since a ball is two of them; about the mass centre by parallel axes. Source: Meriam & Kraige, Dynamics, table D/4.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, ClassVar

from freebody.language.expression import PI, Call, Expr, divide, number
from freebody.language.units import LENGTH, MASS
from freebody.measures.geometry import ZERO
from freebody.model.elements import Edge
from freebody.model.shapes.base import N_SIDES, Build, Shape, square
from freebody.model.solids import DOME
from freebody.model.spec import Formula

if TYPE_CHECKING:
    from freebody.model.names import Names

_N_SIDES = N_SIDES // 2  # of the drawn rim


class Hemisphere(Shape, kind="hemisphere"):
    """`hemisphere: {mass: m, radius: R}`: a homogeneous half ball, its round side towards its own +x, seen from the
    side in the plane: the mass centre is 3 R/8 from the `center` of its flat face, its reference point; about the mass
    centre I = 2/5 m R^2 along x and 83/320 m R^2 across. It rolls with its round side. Points: `start`, `middle` and
    `end` of the rim."""

    called: ClassVar[tuple[str, ...]] = ("half ball", "half sphere")

    mass: Formula = 0
    radius: Formula

    example = "{mass: 1 kg, radius: 0.1 m}"

    def build(self, names: Names) -> Build:
        m, R = names.positive(self, "mass", MASS), names.positive(self, "radius", LENGTH)
        return _half_ball(names, m, R, divide(2 * m * square(R), number(5)), divide(3 * R, number(8)), is_wire=False)


class HemisphericalShell(Shape, kind="hemispherical_shell"):
    """`hemispherical_shell: {mass: m, radius: R}`: a thin half ball (bowl, dome), its round side towards its own +x,
    seen from the side in the plane: the mass centre is R/2 from the `center`, its reference point; about the mass
    centre I = 2/3 m R^2 along x and 5/12 m R^2 across. Points: `start`, `middle` and `end` of the rim."""

    called: ClassVar[tuple[str, ...]] = ("bowl", "dome", "half shell")

    mass: Formula = 0
    radius: Formula

    example = "{mass: 1 kg, radius: 0.1 m}"

    def build(self, names: Names) -> Build:
        m, R = names.positive(self, "mass", MASS), names.positive(self, "radius", LENGTH)
        return _half_ball(names, m, R, divide(2 * m * square(R), number(3)), divide(R, number(2)), is_wire=True)


def _half_ball(names: Names, m: Expr, R: Expr, about_center: Expr, middle: Expr, *, is_wire: bool) -> Build:
    """about_center: the moment of inertia about every axis through the centre; middle: the mass centre on x."""
    across = about_center - m * square(middle)
    angles = [divide(k * PI, number(_N_SIDES)) for k in range(-_N_SIDES // 2, _N_SIDES // 2 + 1)]
    rim = tuple((R * Call("cos", angle), R * Call("sin", angle)) for angle in angles)
    return Build(
        m,
        across,
        (middle, ZERO),
        {"start": (ZERO, -R), "middle": (R, ZERO), "end": (ZERO, R)},
        radius=R,
        edges=(Edge(rim, "wire" if is_wire else "area"),),
        tensor=(about_center, across, across, ZERO, ZERO, ZERO) if names.space else (),
        solid=DOME,
        sizes=(R,),
    )


__all__ = ["Hemisphere", "HemisphericalShell"]
