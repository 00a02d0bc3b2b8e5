"""Frustum: a cone whose tip is cut off.

At the distance z from the base the radius is rho = R + (r - R) z/h, and a slice is dm ~ rho^2 dz. With

    A = R^2 + R r + r^2,   B = R^4 + R^3 r + R^2 r^2 + R r^3 + r^4

    z_G = h (R^2 + 2 R r + 3 r^2)/(4 A)
    I_z = 3 m B/(10 A)                                               (integral of rho^2/2 dm)
    I_x = 3 m B/(20 A) + m h^2 (R^2 + 3 R r + 6 r^2)/(10 A)          about the base, and m z_G^2 less about z_G

which for r = 0 is the cone and for r = R the cylinder. Source: integration; the limits in Beer, Johnston & Cornwell,
Vector Mechanics for Engineers: Dynamics, inside back cover.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from freebody.language.expression import divide, number, power
from freebody.language.units import LENGTH, MASS
from freebody.measures.geometry import ZERO
from freebody.model.shapes.base import Build, Shape, square
from freebody.model.shapes.round import about_axis, own_axis
from freebody.model.solids import FRUSTUM
from freebody.model.spec import Formula, Heading

if TYPE_CHECKING:
    from freebody.model.names import Names


class Frustum(Shape, kind="frustum"):
    """`frustum: {mass: m, radius: R, top_radius: r, height: h}`: a homogeneous cone without its tip, from the middle
    of its `base` (radius R), the reference point, along its `axis` (z) to the middle of its `top` (radius r). For
    models in space."""

    space_only = True
    in_plane_take = "polygon"

    mass: Formula = 0
    radius: Formula
    top_radius: Formula
    height: Formula
    axis: Heading = "z"

    example = "{mass: 1 kg, radius: 0.2 m, top_radius: 0.1 m, height: 0.3 m, axis: z}"

    def build(self, names: Names) -> Build:
        m = names.positive(self, "mass", MASS)
        R, r, h = (names.positive(self, field, LENGTH) for field in ("radius", "top_radius", "height"))
        A = square(R) + R * r + square(r)
        cubed = power(R, number(3)) * r + R * power(r, number(3))
        B = power(R, number(4)) + cubed + square(R) * square(r) + power(r, number(4))
        middle = divide(h * (square(R) + 2 * R * r + 3 * square(r)), 4 * A)
        along = divide(3 * m * B, 10 * A)
        slices = divide(m * square(h) * (square(R) + 3 * R * r + 6 * square(r)), 10 * A)
        across = divide(along, number(2)) + slices - m * square(middle)
        axis = own_axis(names, self)
        return Build(
            m,
            along,
            tuple(middle * c for c in axis),
            points={"base": (ZERO, ZERO, ZERO), "top": tuple(h * c for c in axis)},
            tensor=about_axis(axis, along, across),
            axis=axis,
            default_point="base",
            solid=FRUSTUM,
            sizes=(R, r, h),
        )
