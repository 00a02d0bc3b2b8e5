"""Shapes of bodies: mass, moment of inertia about the mass centre, mass centre and named points.

Moments of inertia of homogeneous bodies: Beer, Johnston & Cornwell, Vector Mechanics for Engineers: Dynamics,
inside back cover. A mass that is left out is zero: a massless link or pulley.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any, ClassVar

from freebody.language.expression import Expr, Number, divide, multiply, negate, number, power
from freebody.language.units import INERTIA, LENGTH, MASS
from freebody.model.spec import Formula, Spec

if TYPE_CHECKING:
    from freebody.model.names import Names

ZERO = number(0)
CORNERS = ("bottom_left", "bottom_right", "top_left", "top_right")


@dataclass(frozen=True)
class Build:
    """What a shape comes to. Points are components in the body's own frame, from its reference point."""

    mass: Expr
    inertia: Expr
    center_of_mass: tuple[Expr, Expr] = (ZERO, ZERO)
    points: dict[str, tuple[Expr, Expr]] = field(default_factory=dict[str, tuple[Expr, Expr]])
    radius: Expr | None = None
    turns: bool = True
    default_point: str = "center"
    corners: tuple[str, ...] = ()  # points of a straight-edged rim, in order
    is_ring: bool = False


class Shape(Spec):
    """Base of the shapes; a subclass is found by its `kind`."""

    kinds: ClassVar[dict[str, type[Shape]]] = {}
    # lengths that may be left open, with the points that depend on them; () where the whole body does
    open_lengths: ClassVar[dict[str, tuple[str, ...]]] = {}

    def __init_subclass__(cls, kind: str = "", **rest: Any) -> None:
        super().__init_subclass__(**rest)
        cls.kind = kind
        Shape.kinds[kind] = cls

    def build(self, names: Names) -> Build:
        raise NotImplementedError


def _half(e: Expr) -> Expr:
    return divide(e, number(2))


class Particle(Shape, kind="particle"):
    """A point mass; it has no angle."""

    mass: Formula = 0

    def build(self, names: Names) -> Build:
        return Build(names.positive(self, "mass", MASS), ZERO, turns=False)


class Rod(Shape, kind="rod"):
    """A slender uniform rod from `start` to `end`, along its own x axis; I = m L^2/12."""

    mass: Formula = 0
    length: Formula | None = None

    open_lengths: ClassVar[dict[str, tuple[str, ...]]] = {"length": ()}

    def build(self, names: Names) -> Build:
        m, length = names.positive(self, "mass", MASS), names.positive(self, "length", LENGTH)
        half = _half(length)
        return Build(
            m,
            divide(multiply(m, power(length, number(2))), number(12)),
            points={"start": (negate(half), ZERO), "end": (half, ZERO)},
            corners=("start", "end"),
        )


class Disk(Shape, kind="disk"):
    """A uniform disk (or cylinder, pulley, gear wheel); I = m R^2/2 unless `inertia` is given."""

    mass: Formula = 0
    radius: Formula | None = None
    inertia: Formula | None = None

    open_lengths: ClassVar[dict[str, tuple[str, ...]]] = {"radius": ()}

    def build(self, names: Names) -> Build:
        m, r = names.positive(self, "mass", MASS), names.positive(self, "radius", LENGTH)
        given = names.optional(self, "inertia", INERTIA)
        return Build(m, divide(m * power(r, number(2)), number(2)) if given is None else given, radius=r)


class Ring(Shape, kind="ring"):
    """A thin ring or hoop; I = m R^2 unless `inertia` is given. Wheels may run on its inside."""

    mass: Formula = 0
    radius: Formula | None = None
    inertia: Formula | None = None

    open_lengths: ClassVar[dict[str, tuple[str, ...]]] = {"radius": ()}

    def build(self, names: Names) -> Build:
        m, r = names.positive(self, "mass", MASS), names.positive(self, "radius", LENGTH)
        given = names.optional(self, "inertia", INERTIA)
        return Build(m, m * power(r, number(2)) if given is None else given, radius=r, is_ring=True)


class Sphere(Shape, kind="sphere"):
    """A homogeneous ball; I = 2/5 m R^2 about any axis through its centre."""

    mass: Formula = 0
    radius: Formula | None = None

    open_lengths: ClassVar[dict[str, tuple[str, ...]]] = {"radius": ()}

    def build(self, names: Names) -> Build:
        m, r = names.positive(self, "mass", MASS), names.positive(self, "radius", LENGTH)
        return Build(m, multiply(number(2), m, power(r, number(2))) / number(5), radius=r)


class Rectangle(Shape, kind="rectangle"):
    """A uniform rectangular plate or block; I = m (w^2 + h^2)/12. Points: the corners `bottom_left` ...
    and the middles `left`, `right`, `top`, `bottom` of its sides. A side that is left out is zero, unless one of
    these points is used."""

    mass: Formula = 0
    width: Formula | None = None
    height: Formula | None = None

    open_lengths: ClassVar[dict[str, tuple[str, ...]]] = {
        "width": ("left", "right", *CORNERS),
        "height": ("top", "bottom", *CORNERS),
    }

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
        )


class Polygon(Shape, kind="polygon"):
    """A uniform plate with straight edges; corners in order (either way round) in the body's own frame,
    whose origin is the reference point `origin`; points `corner1`, `corner2` ... Area, centroid and polar
    second moment by the shoelace formulas (Green's theorem)."""

    mass: Formula = 0
    corners: list[list[Formula]]

    def build(self, names: Names) -> Build:
        m = names.positive(self, "mass", MASS)
        corners = names.vectors(self, "corners", LENGTH)
        if len(corners) < 3:
            names.problem("a polygon needs at least three corners", self, "corners")
            return Build(m, ZERO)
        area2: Expr = ZERO
        sx: Expr = ZERO
        sy: Expr = ZERO
        polar: Expr = ZERO
        for (x1, y1), (x2, y2) in zip(corners, corners[1:] + corners[:1], strict=True):
            cross = x1 * y2 - x2 * y1
            area2 = area2 + cross
            sx = sx + (x1 + x2) * cross
            sy = sy + (y1 + y2) * cross
            squares = x1 * x1 + x1 * x2 + x2 * x2 + y1 * y1 + y1 * y2 + y2 * y2
            polar = polar + cross * squares
        if isinstance(area2, Number) and area2.value == 0:
            names.problem("the corners enclose no area", self, "corners")
            return Build(m, ZERO)
        cx, cy = divide(sx, 3 * area2), divide(sy, 3 * area2)
        about_origin = divide(m * polar, 6 * area2)
        inertia = about_origin - m * (cx * cx + cy * cy)
        points = {f"corner{k}": corner for k, corner in enumerate(corners, 1)}
        return Build(
            m,
            inertia,
            (cx, cy),
            points | {"origin": (ZERO, ZERO)},
            default_point="origin",
            corners=tuple(f"corner{k}" for k in range(1, len(corners) + 1)),
        )


class Body(Shape, kind="body"):
    """A body given by mass, moment of inertia about its mass centre, and the mass centre's place in the body's
    own frame, whose origin is the reference point `origin`. A `radius` makes its rim a circle about the origin."""

    mass: Formula = 0
    inertia: Formula = 0
    center_of_mass: list[Formula] | None = None
    radius: Formula | None = None

    def build(self, names: Names) -> Build:
        return Build(
            names.positive(self, "mass", MASS),
            names.positive(self, "inertia", INERTIA),
            names.vector(self, "center_of_mass", LENGTH) or (ZERO, ZERO),
            {"origin": (ZERO, ZERO)},
            names.optional(self, "radius", LENGTH),
            default_point="origin",
        )
