"""Hollow round shapes: annulus, hollow cylinder, hollow sphere, spherical shell.

What is cut out counts as a negative part of the same density: with M and m the masses of the full body and of the hole,
m/M = (r/R)^n, n = 2 for what is as long as it is, 3 for balls,

    I = I_full - I_hole  over  M - m:    annulus  (R^2 + r^2)/2      ball  2/5 (R^5 - r^5)/(R^3 - r^3)

and the shell is what that goes to as r goes to R. Source: Beer, Johnston & Cornwell, Vector Mechanics for Engineers:
Dynamics, app. B; Meriam & Kraige, Dynamics, table D/4.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, ClassVar

from freebody.language.expression import Expr, divide, multiply, number, power
from freebody.language.sentences import Message
from freebody.language.units import LENGTH, MASS
from freebody.measures.geometry import ZERO
from freebody.model.shapes.base import Build, Shape, half, square
from freebody.model.shapes.round import about_axis, own_axis
from freebody.model.solids import CYLINDER, DISK, SPHERE
from freebody.model.spec import Formula, Heading

if TYPE_CHECKING:
    from freebody.model.names import Names


class Annulus(Shape, kind="annulus"):
    """`annulus: {mass: m, radius: R, inner_radius: r}`: a uniform disk with a round hole in its middle (thick pipe,
    flange); I = m (R^2 + r^2)/2. Wheels may run on its outside. In space it is thin, about its `axis` (z)."""

    called: ClassVar[tuple[str, ...]] = ("pipe", "washer", "hollow disk", "hollow cylinder")

    mass: Formula = 0
    radius: Formula
    inner_radius: Formula
    axis: Heading = "z"

    example = "{mass: 1 kg, radius: 0.2 m, inner_radius: 0.1 m}"

    def build(self, names: Names) -> Build:
        m, R, r = _mass_and_radii(names, self)
        along = half(m * (square(R) + square(r)))
        axis = own_axis(names, self)
        tensor = about_axis(axis, along, half(along)) if axis else ()
        return Build(m, along, radius=R, tensor=tensor, round="disk", axis=axis, solid=DISK, sizes=(R,), inner=r)


class HollowCylinder(Shape, kind="hollow_cylinder"):
    """`hollow_cylinder: {mass: m, radius: R, inner_radius: r, length: L}`: a homogeneous pipe about its `axis` (z):
    I = m (R^2 + r^2)/2 about it, m (3 (R^2 + r^2) + L^2)/12 across; a thin shell has inner_radius R. Points `start`,
    `end`: the middles of its ends. For models in space."""

    space_only = True
    in_plane_take = "annulus"

    called: ClassVar[tuple[str, ...]] = ("pipe", "sleeve", "cylindrical shell")

    mass: Formula = 0
    radius: Formula
    inner_radius: Formula
    length: Formula
    axis: Heading = "z"

    example = "{mass: 1 kg, radius: 0.1 m, inner_radius: 0.08 m, length: 1 m, axis: z}"

    def build(self, names: Names) -> Build:
        m, R, r = _mass_and_radii(names, self)
        length = names.positive(self, "length", LENGTH)
        axis, squares, end = own_axis(names, self), square(R) + square(r), half(length)
        along = half(m * squares)
        return Build(
            m,
            along,
            points={"start": tuple(-end * c for c in axis), "end": tuple(end * c for c in axis)},
            radius=R,
            tensor=about_axis(axis, along, divide(m * (3 * squares + square(length)), number(12))),
            round="disk",
            axis=axis,
            solid=CYLINDER,
            sizes=(R, length),
            inner=r,
        )


class HollowSphere(Shape, kind="hollow_sphere"):
    """`hollow_sphere: {mass: m, radius: R, inner_radius: r}`: a ball with a hollow in its middle;
    I = 2/5 m (R^5 - r^5)/(R^3 - r^3) about any axis through its centre."""

    called: ClassVar[tuple[str, ...]] = ("ball", "hollow ball")

    mass: Formula = 0
    radius: Formula
    inner_radius: Formula

    example = "{mass: 1 kg, radius: 0.1 m, inner_radius: 0.08 m}"

    def build(self, names: Names) -> Build:
        m, R, r = _mass_and_radii(names, self)
        # (R^5 - r^5)/(R^3 - r^3), both by R - r: it has a value for r = R, that of the shell
        above = _powers(R, r, 4)
        return _ball(names, m, R, r, divide(multiply(number(2), m, above), 5 * _powers(R, r, 2)))


class SphericalShell(Shape, kind="spherical_shell"):
    """`spherical_shell: {mass: m, radius: R}`: a thin hollow ball (table tennis ball, football); I = 2/3 m R^2 about
    any axis through its centre."""

    called: ClassVar[tuple[str, ...]] = ("ball", "shell", "hollow ball")

    mass: Formula = 0
    radius: Formula

    example = "{mass: 1 kg, radius: 0.1 m}"

    def build(self, names: Names) -> Build:
        m, R = names.positive(self, "mass", MASS), names.positive(self, "radius", LENGTH)
        return _ball(names, m, R, R, divide(multiply(number(2), m, square(R)), number(3)))


def _ball(names: Names, m: Expr, R: Expr, r: Expr, inertia: Expr) -> Build:
    tensor = (inertia, inertia, inertia, ZERO, ZERO, ZERO) if names.space else ()
    return Build(m, inertia, radius=R, tensor=tensor, round="sphere", solid=SPHERE, sizes=(R,), inner=r)


def _powers(R: Expr, r: Expr, n: int) -> Expr:
    """R^n + R^(n-1) r + ... + r^n = (R^(n+1) - r^(n+1))/(R - r)."""
    total: Expr = ZERO
    for k in range(n + 1):
        total = total + power(R, number(n - k)) * power(r, number(k))
    return total


def _mass_and_radii(names: Names, spec: Annulus | HollowCylinder | HollowSphere) -> tuple[Expr, Expr, Expr]:
    m, R, r = (
        names.positive(spec, field, dimension)
        for field, dimension in (("mass", MASS), ("radius", LENGTH), ("inner_radius", LENGTH))
    )
    outer, inner = names.numeric(R), names.numeric(r)
    if outer is not None and inner is not None and inner > outer:
        names.problem(
            Message(
                "inner_radius is {inner:.4g} m, more than the radius; it is at most {outer:.4g} m",
                inner=inner,
                outer=outer,
            ),
            "inner_radius",
        )
    return m, R, r


__all__ = ["Annulus", "HollowCylinder", "HollowSphere", "SphericalShell"]
