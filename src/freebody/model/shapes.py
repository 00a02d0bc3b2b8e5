"""Shapes of bodies: mass, moment of inertia about the mass centre, mass centre and named points.

Moments of inertia of homogeneous bodies: Beer, Johnston & Cornwell, Vector Mechanics for Engineers: Dynamics,
inside back cover. A mass that is left out is zero: a massless link or pulley.
"""

from __future__ import annotations

import random
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any, ClassVar

from freebody.language.expression import (
    Expr,
    Number,
    Sum,
    divide,
    evaluate,
    free_symbols,
    multiply,
    negate,
    number,
    power,
)
from freebody.language.sentences import Message
from freebody.language.units import INERTIA, LENGTH, MASS
from freebody.measures.geometry import Components
from freebody.model.spec import Formula, Heading, Spec
from freebody.model.tensors import read_tensor
from freebody.tolerances import ROUNDED

if TYPE_CHECKING:
    from freebody.model.names import Names

ZERO = number(0)
CORNERS = ("bottom_left", "bottom_right", "top_left", "top_right")


@dataclass(frozen=True)
class Build:
    """What a shape comes to. Points are components in the body's own frame, from its reference point."""

    mass: Expr
    inertia: Expr
    center_of_mass: Components = (ZERO, ZERO)
    points: dict[str, Components] = field(default_factory=dict[str, Components])
    radius: Expr | None = None
    turns: bool = True
    default_point: str = "center"
    corners: tuple[str, ...] = ()  # points of a straight-edged rim, in order
    is_ring: bool = False
    # in space
    tensor: Components = ()  # about the mass centre: xx, yy, zz, xy, xz, yz
    round: str = ""
    axis: Components = ()
    solid: str = ""
    sizes: Components = ()


class Shape(Spec):
    """Base of the shapes; a subclass is found by its `kind`."""

    kinds: ClassVar[dict[str, type[Shape]]] = {}
    # lengths that may be left open, with the points that depend on them; () where the whole body does
    open_lengths: ClassVar[dict[str, tuple[str, ...]]] = {}
    # its fields with values, as a file has them: for documentation and for random models
    example: ClassVar[str] = ""

    def __init_subclass__(cls, kind: str = "", **rest: Any) -> None:
        super().__init_subclass__(**rest)
        cls.kind = kind
        Shape.kinds[kind] = cls

    def build(self, names: Names) -> Build:
        raise NotImplementedError


def _half(e: Expr) -> Expr:
    return divide(e, number(2))


def _square(e: Expr) -> Expr:
    return power(e, number(2))


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


def _axis(names: Names, spec: Shape) -> Components:
    """The axis of a round shape in space, z unless it says otherwise."""
    given = getattr(spec, "axis", "z")
    if not names.space:
        if given != "z":
            names.problem(Message("an axis is for models in space: write space: true"), "axis")
        return ()
    return names.direction(given, "axis").components


class Particle(Shape, kind="particle"):
    """A point mass; it has no angle."""

    called: ClassVar[tuple[str, ...]] = (
        *("block", "bob", "bead", "ball", "object", "weight"),
        *("piston", "car", "cart", "collar"),
    )

    mass: Formula = 0

    example = "{mass: 1 kg}"

    def build(self, names: Names) -> Build:
        return Build(names.positive(self, "mass", MASS), ZERO, turns=False)


class Rod(Shape, kind="rod"):
    """A slender uniform rod from `start` to `end`, along its own x axis; I = m L^2/12."""

    called: ClassVar[tuple[str, ...]] = ("bar", "beam", "ladder", "link", "crank", "stick", "pole", "arm")

    mass: Formula = 0
    length: Formula | None = None

    open_lengths: ClassVar[dict[str, tuple[str, ...]]] = {"length": ()}

    example = "{mass: 1 kg, length: 1 m}"

    def build(self, names: Names) -> Build:
        m, length = names.positive(self, "mass", MASS), names.positive(self, "length", LENGTH)
        half, inertia = _half(length), divide(multiply(m, power(length, number(2))), number(12))
        return Build(
            m,
            inertia,
            points={"start": (negate(half), ZERO), "end": (half, ZERO)},
            corners=("start", "end"),
            tensor=(ZERO, inertia, inertia, ZERO, ZERO, ZERO) if names.space else (),
            solid="rod",
            sizes=(length,),
        )


class Disk(Shape, kind="disk"):
    """A uniform disk (or cylinder, pulley, gear wheel); I = m R^2/2 unless `inertia` is given. In space it is thin,
    about its `axis` (z), with half of that inertia about its diameters."""

    called: ClassVar[tuple[str, ...]] = ("disc", "wheel", "cylinder", "pulley", "roller", "drum", "gear", "flywheel")

    mass: Formula = 0
    radius: Formula | None = None
    inertia: Formula | None = None
    axis: Heading = "z"

    open_lengths: ClassVar[dict[str, tuple[str, ...]]] = {"radius": ()}

    example = "{mass: 1 kg, radius: 0.2 m}"

    def build(self, names: Names) -> Build:
        m, r = names.positive(self, "mass", MASS), names.positive(self, "radius", LENGTH)
        given = names.optional(self, "inertia", INERTIA)
        inertia = _half(m * _square(r)) if given is None else given
        axis = _axis(names, self)
        tensor = about_axis(axis, inertia, _half(inertia)) if axis else ()
        return Build(m, inertia, radius=r, tensor=tensor, round="disk", axis=axis, solid="disk", sizes=(r,))


class Ring(Shape, kind="ring"):
    """A thin ring or hoop; I = m R^2 unless `inertia` is given. Wheels may run on its inside."""

    called: ClassVar[tuple[str, ...]] = ("hoop", "wheel", "pipe")

    mass: Formula = 0
    radius: Formula | None = None
    inertia: Formula | None = None
    axis: Heading = "z"

    open_lengths: ClassVar[dict[str, tuple[str, ...]]] = {"radius": ()}

    example = "{mass: 1 kg, radius: 0.5 m}"

    def build(self, names: Names) -> Build:
        m, r = names.positive(self, "mass", MASS), names.positive(self, "radius", LENGTH)
        given = names.optional(self, "inertia", INERTIA)
        inertia = m * _square(r) if given is None else given
        axis = _axis(names, self)
        tensor = about_axis(axis, inertia, _half(inertia)) if axis else ()
        return Build(
            m, inertia, radius=r, is_ring=True, tensor=tensor, round="disk", axis=axis, solid="ring", sizes=(r,)
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
        return Build(m, inertia, radius=r, tensor=tensor, round="sphere", solid="sphere", sizes=(r,))


class Cylinder(Shape, kind="cylinder"):
    """A homogeneous cylinder about its `axis` (z): I = m R^2/2 about it, m (3 R^2 + L^2)/12 across. Points `start`,
    `end`: the middles of its ends. For models in space."""

    called: ClassVar[tuple[str, ...]] = ("roller", "drum", "disk", "disc", "wheel", "shaft")

    mass: Formula = 0
    radius: Formula
    length: Formula
    axis: Heading = "z"

    example = "{mass: 1 kg, radius: 0.1 m, length: 1 m, axis: z}"

    def build(self, names: Names) -> Build:
        m, r, length = (names.positive(self, f, d) for f, d in (("mass", MASS), ("radius", LENGTH), ("length", LENGTH)))
        along = _half(m * _square(r))
        if not _is_spatial(names, self):
            return Build(m, along, radius=r)
        axis = _axis(names, self)
        half = _half(length)
        return Build(
            m,
            along,
            points={"start": tuple(-half * c for c in axis), "end": tuple(half * c for c in axis)},
            radius=r,
            tensor=about_axis(axis, along, divide(m * (3 * _square(r) + _square(length)), number(12))),
            round="disk",
            axis=axis,
            solid="cylinder",
            sizes=(r, length),
        )


class Cone(Shape, kind="cone"):
    """A homogeneous cone from its `apex` along its `axis` (z) to the middle of its `base`, its mass centre at three
    quarters of the height: I = 3/10 m R^2 about the axis, 3/80 m (4 R^2 + h^2) across, about the mass centre. The
    reference point is the apex. For models in space."""

    mass: Formula = 0
    radius: Formula
    height: Formula
    axis: Heading = "z"

    example = "{mass: 1 kg, radius: 0.1 m, height: 0.3 m, axis: z}"

    def build(self, names: Names) -> Build:
        m, r, h = (names.positive(self, f, d) for f, d in (("mass", MASS), ("radius", LENGTH), ("height", LENGTH)))
        along = divide(3 * m * _square(r), number(10))
        if not _is_spatial(names, self):
            return Build(m, along, radius=r)
        axis = _axis(names, self)
        zero = (ZERO, ZERO, ZERO)
        return Build(
            m,
            along,
            tuple(divide(3 * h * c, number(4)) for c in axis),
            points={"apex": zero, "base": tuple(h * c for c in axis)},
            radius=r,
            tensor=about_axis(axis, along, divide(3 * m * (4 * _square(r) + _square(h)), number(80))),
            round="cone",
            axis=axis,
            default_point="apex",
            solid="cone",
            sizes=(r, h),
        )


class Box(Shape, kind="box"):
    """A homogeneous block with the sides `size: [a, b, c]` along its x, y and z; I_x = m (b^2 + c^2)/12. Points: the
    middles of its faces, `left`, `right` (x), `bottom`, `top` (y), `back`, `front` (z). For models in space."""

    called: ClassVar[tuple[str, ...]] = ("block", "crate", "brick")

    mass: Formula = 0
    size: list[Formula]

    example = "{mass: 1 kg, size: [1 m, 0.1 m, 0.2 m]}"

    def build(self, names: Names) -> Build:
        m = names.positive(self, "mass", MASS)
        if not _is_spatial(names, self):
            return Build(m, ZERO)
        if len(self.size) != 3:
            names.problem(
                Message("size is three sides, [a, b, c] along x, y and z, found {size}", size=repr(self.size)),
                "size",
            )
        a, b, c = names.components(self.size, LENGTH, "size")
        Ix, Iy, Iz = (divide(m * (_square(p) + _square(q)), number(12)) for p, q in ((b, c), (a, c), (a, b)))
        x, y, z = map(_half, (a, b, c))
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
            solid="box",
            sizes=(a, b, c),
        )


def _is_spatial(names: Names, spec: Shape) -> bool:
    if not names.space:
        names.problem(Message("a {kind} is for models in space: write space: true", kind=spec.kind))
    return names.space


class Rectangle(Shape, kind="rectangle"):
    """A uniform rectangular plate or block; I = m (w^2 + h^2)/12. Points: the corners `bottom_left` ...
    and the middles `left`, `right`, `top`, `bottom` of its sides. A side that is left out is zero, unless one of
    these points is used."""

    called: ClassVar[tuple[str, ...]] = ("block", "box", "crate", "plate", "plank", "cart", "car")

    mass: Formula = 0
    width: Formula | None = None
    height: Formula | None = None

    open_lengths: ClassVar[dict[str, tuple[str, ...]]] = {
        "width": ("left", "right", *CORNERS),
        "height": ("top", "bottom", *CORNERS),
    }

    example = "{mass: 1 kg, width: 0.4 m, height: 0.2 m}"

    def build(self, names: Names) -> Build:
        m = names.positive(self, "mass", MASS)
        w, h = (names.optional(self, side, LENGTH) or ZERO for side in ("width", "height"))
        x, y = _half(w), _half(h)
        return Build(
            m,
            divide(m * (power(w, number(2)) + power(h, number(2))), number(12)),
            points={
                "left": (negate(x), ZERO),
                "right": (x, ZERO),
                "top": (ZERO, y),
                "bottom": (ZERO, negate(y)),
                "bottom_left": (negate(x), negate(y)),
                "bottom_right": (x, negate(y)),
                "top_left": (negate(x), y),
                "top_right": (x, y),
            },
            corners=("bottom_left", "bottom_right", "top_right", "top_left"),
            tensor=_flat(m * _square(h) / 12, m * _square(w) / 12) if names.space else (),
            solid="box",
            sizes=(w, h, ZERO),
        )


def _flat(Ix: Expr, Iy: Expr, xy: Expr = ZERO) -> Components:
    """The tensor of a plate in the plane of x and y: I_z = I_x + I_y."""
    return Ix, Iy, Ix + Iy, xy, ZERO, ZERO


def _is_zero(x: Expr) -> bool:
    """Whether an expression vanishes whatever the parameters are: at places at which nothing else does by chance
    (Schwartz and Zippel), where round-off leaves less than 1e-12 of its terms."""
    if isinstance(x, Number):
        return x.value == 0
    rng = random.Random(1)
    for _ in range(3):
        values = {name: rng.uniform(0.5, 2.0) for name in sorted(free_symbols(x))}
        terms = [float(evaluate(term, values)) for term in (x.terms if isinstance(x, Sum) else (x,))]
        if abs(sum(terms)) > ROUNDED * sum(map(abs, terms)):
            return False
    return True


class Polygon(Shape, kind="polygon"):
    """A uniform plate with straight edges; corners in order (either way round) in the body's own frame,
    whose origin is the reference point `origin`; points `corner1`, `corner2` ... Area, centroid and polar
    second moment by the shoelace formulas (Green's theorem)."""

    called: ClassVar[tuple[str, ...]] = ("wedge", "block", "plate")

    mass: Formula = 0
    corners: list[list[Formula]]

    example = "{mass: 1 kg, corners: [[0, 0], [0.3 m, 0], [0, 0.4 m]]}"

    def build(self, names: Names) -> Build:
        m = names.positive(self, "mass", MASS)
        corners = names.vectors(self, "corners", LENGTH)
        if len(corners) < 3:
            names.problem(Message("a polygon needs at least three corners"), "corners")
            return Build(m, ZERO)
        area2: Expr = ZERO
        sx: Expr = ZERO
        sy: Expr = ZERO
        polar: Expr = ZERO
        second: list[Expr] = [ZERO, ZERO, ZERO]  # integrals of y^2, x^2 and x y
        for (x1, y1, *_), (x2, y2, *_) in zip(corners, corners[1:] + corners[:1], strict=True):
            cross = x1 * y2 - x2 * y1
            second[0] = second[0] + cross * (y1 * y1 + y1 * y2 + y2 * y2)
            second[1] = second[1] + cross * (x1 * x1 + x1 * x2 + x2 * x2)
            second[2] = second[2] + cross * (x1 * y2 + 2 * x1 * y1 + 2 * x2 * y2 + x2 * y1)
            area2 = area2 + cross
            sx = sx + (x1 + x2) * cross
            sy = sy + (y1 + y2) * cross
            squares = x1 * x1 + x1 * x2 + x2 * x2 + y1 * y1 + y1 * y2 + y2 * y2
            polar = polar + cross * squares
        if _is_zero(area2):
            names.problem(Message("the corners enclose no area"), "corners")
            return Build(m, ZERO)
        cx, cy = divide(sx, 3 * area2), divide(sy, 3 * area2)
        about_origin = divide(m * polar, 6 * area2)
        inertia = about_origin - m * (cx * cx + cy * cy)
        points = {f"corner{k}": corner for k, corner in enumerate(corners, 1)}
        Ix, Iy = (divide(m * total, 6 * area2) - m * c * c for total, c in ((second[0], cy), (second[1], cx)))
        xy = -(divide(m * second[2], 12 * area2) - m * cx * cy)
        return Build(
            m,
            inertia,
            (cx, cy),
            points | {"origin": (ZERO, ZERO)},
            default_point="origin",
            corners=tuple(f"corner{k}" for k in range(1, len(corners) + 1)),
            tensor=_flat(Ix, Iy, xy) if names.space else (),
            solid="plate",
        )


class Body(Shape, kind="body"):
    """A body given by mass, moment of inertia about its mass centre, and the mass centre's place in the body's
    own frame, whose origin is the reference point `origin`. A `radius` makes its rim a circle about the origin.

    In space `inertia` is the three moments about its axes, [Ixx, Iyy, Izz], or the tensor as three rows, about the mass
    centre, or `about: origin`, or another place by components."""

    called: ClassVar[tuple[str, ...]] = (
        *("block", "cart", "car", "disk", "disc", "wheel", "cylinder", "drum"),
        *("pulley", "gear", "plate", "platform", "crate", "shaft"),
    )

    mass: Formula = 0
    inertia: Formula | list[Formula] | list[list[Formula]] = 0
    center_of_mass: list[Formula] | None = None
    radius: Formula | None = None
    about: str | list[Formula] = "mass_center"

    example = "{mass: 1 kg, inertia: 0.1 kg m^2, center_of_mass: [0.1 m, 0], radius: 0.2 m}"

    def build(self, names: Names) -> Build:
        mass = names.positive(self, "mass", MASS)
        middle = names.vector(self, "center_of_mass", LENGTH) or names.origin
        radius = names.optional(self, "radius", LENGTH)
        if names.space:
            tensor = read_tensor(names, self.inertia, mass, middle, self.about)
            return Build(
                mass, tensor[2], middle, {"origin": names.origin}, radius, default_point="origin", tensor=tensor
            )
        if isinstance(self.inertia, list) or self.about != "mass_center":
            names.problem(Message("three moments of inertia are for models in space: write space: true"), "inertia")
            return Build(mass, ZERO, default_point="origin")
        return Build(
            mass,
            names.positive(self, "inertia", INERTIA),
            middle,
            {"origin": (ZERO, ZERO)},
            radius,
            default_point="origin",
        )
