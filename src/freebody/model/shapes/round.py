"""Round shapes: disk, ring, sphere, cylinder, cone.

Moments of inertia of homogeneous bodies: Beer, Johnston & Cornwell, Vector Mechanics for Engineers: Dynamics,
inside back cover.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, ClassVar

from freebody.language.expression import (
    Expr,
    divide,
    multiply,
    number,
    power,
)
from freebody.language.sentences import Message
from freebody.language.units import INERTIA, LENGTH, MASS
from freebody.measures.geometry import ZERO, Components
from freebody.model.shapes.base import Build, Shape, half, square
from freebody.model.solids import CONE, CYLINDER, DISK, RING, SPHERE, SolidKind
from freebody.model.spec import Formula, Heading

if TYPE_CHECKING:
    from freebody.model.names import Names


def about_axis(axis: Components, along: Expr, across: Expr) -> Components:
    """across (1 - a a^T) + along a a^T: the tensor of a body that looks alike all round an axis."""
    more = along - across
    x, y, z = axis
    return (
        across + more * x * x,
        across + more * y * y,
        across + more * z * z,
        more * x * y,
        more * x * z,
        more * y * z,
    )


def own_axis(names: Names, spec: Shape) -> Components:
    """The axis of a round shape in space, z unless it says otherwise."""
    given = getattr(spec, "axis", "z")
    if not names.space:
        if given != "z":
            names.problem(Message("an axis is for models in space: write space: true"), "axis")
        return ()
    return names.direction(given, "axis").components


class Disk(Shape, kind="disk"):
    """A uniform disk (or cylinder, pulley, gear wheel); I = m R^2/2 unless `inertia` is given. In space it is thin,
    about its `axis` (z), with half of that inertia about its diameters."""

    called: ClassVar[tuple[str, ...]] = ("disc", "wheel", "cylinder", "pulley", "roller", "drum", "gear", "flywheel")
    elsewhere: ClassVar[Mapping[str, str]] = dict.fromkeys(
        ("teeth", "module"),
        Message(
            "teeth and module belong to the mesh: gear_mesh: {{first: sun, second: planet, module: m, teeth: [z1, z2]}}"
        ),
    )
    also: ClassVar[tuple[str, ...]] = ("disc", "cylinder", "pulley", "roller", "drum", "gear", "flywheel")

    mass: Formula = 0
    radius: Formula | None = None
    inertia: Formula | None = None
    axis: Heading = "z"

    open_lengths: ClassVar[dict[str, tuple[str, ...]]] = {"radius": ()}

    example = "{mass: 1 kg, radius: 0.2 m}"

    def build(self, names: Names) -> Build:
        m, r = names.positive(self, "mass", MASS), names.positive(self, "radius", LENGTH)
        return _wheel(names, self, m, r, half(m * square(r)), DISK)


class Ring(Shape, kind="ring"):
    """A thin ring or hoop; I = m R^2 unless `inertia` is given. Wheels may run on its inside."""

    called: ClassVar[tuple[str, ...]] = ("hoop", "wheel", "pipe")
    also: ClassVar[tuple[str, ...]] = ("hoop",)

    mass: Formula = 0
    radius: Formula | None = None
    inertia: Formula | None = None
    axis: Heading = "z"

    open_lengths: ClassVar[dict[str, tuple[str, ...]]] = {"radius": ()}

    example = "{mass: 1 kg, radius: 0.5 m}"

    def build(self, names: Names) -> Build:
        m, r = names.positive(self, "mass", MASS), names.positive(self, "radius", LENGTH)
        return _wheel(names, self, m, r, m * square(r), RING)


def _wheel(names: Names, spec: Disk | Ring, m: Expr, r: Expr, own: Expr, solid: SolidKind) -> Build:
    """A thin round body. own: its moment of inertia about its axis unless one is given; half of it about a diameter."""
    given = names.optional(spec, "inertia", INERTIA)
    inertia = own if given is None else given
    axis = own_axis(names, spec)
    tensor = about_axis(axis, inertia, half(inertia)) if axis else ()
    return Build(
        m, inertia, radius=r, is_ring=solid.is_hoop, tensor=tensor, round="disk", axis=axis, solid=solid, sizes=(r,)
    )


class Sphere(Shape, kind="sphere"):
    """A homogeneous ball; I = 2/5 m R^2 about any axis through its centre."""

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


class Cone(Shape, kind="cone"):
    """A homogeneous cone from its `apex` along its `axis` (z) to the middle of its `base`, its mass centre at three
    quarters of the height: I = 3/10 m R^2 about the axis, 3/80 m (4 R^2 + h^2) across, about the mass centre. The
    reference point is the apex. For models in space."""

    space_only = True

    mass: Formula = 0
    radius: Formula
    height: Formula
    axis: Heading = "z"

    example = "{mass: 1 kg, radius: 0.1 m, height: 0.3 m, axis: z}"

    def build(self, names: Names) -> Build:
        m, r, h = (names.positive(self, f, d) for f, d in (("mass", MASS), ("radius", LENGTH), ("height", LENGTH)))
        along = divide(3 * m * square(r), number(10))
        axis = own_axis(names, self)
        zero = (ZERO, ZERO, ZERO)
        return Build(
            m,
            along,
            tuple(divide(3 * h * c, number(4)) for c in axis),
            points={"apex": zero, "base": tuple(h * c for c in axis)},
            radius=r,
            tensor=about_axis(axis, along, divide(3 * m * (4 * square(r) + square(h)), number(80))),
            round="cone",
            axis=axis,
            default_point="apex",
            solid=CONE,
            sizes=(r, h),
        )
