"""Points and straight-edged shapes: particle, rod, rectangle, box, polygon.

Moments of inertia of homogeneous bodies: Beer, Johnston & Cornwell, Vector Mechanics for Engineers: Dynamics,
inside back cover.
"""

from __future__ import annotations

import random
from typing import TYPE_CHECKING, ClassVar

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
from freebody.language.units import LENGTH, MASS
from freebody.measures.geometry import ZERO, Components
from freebody.model.shapes.base import Build, Shape, half, square
from freebody.model.solids import BOX, PLATE, ROD
from freebody.model.spec import Formula
from freebody.tolerances import ROUNDED

if TYPE_CHECKING:
    from freebody.model.names import Names


CORNERS = ("bottom_left", "bottom_right", "top_left", "top_right")


class Particle(Shape, kind="particle"):
    """A point mass; it has no angle."""

    called: ClassVar[tuple[str, ...]] = (
        *("block", "bob", "bead", "ball", "object", "weight"),
        *("piston", "car", "cart", "collar"),
    )
    also: ClassVar[tuple[str, ...]] = ("block", "bob", "bead", "piston", "car", "cart", "collar")

    mass: Formula = 0

    example = "{mass: 1 kg}"

    def build(self, names: Names) -> Build:
        return Build(names.positive(self, "mass", MASS), ZERO, turns=False)


class Rod(Shape, kind="rod"):
    """A slender uniform rod from `start` to `end`, along its own x axis; I = m L^2/12."""

    called: ClassVar[tuple[str, ...]] = ("bar", "beam", "ladder", "link", "crank", "stick", "pole", "arm")
    also: ClassVar[tuple[str, ...]] = ("bar", "beam", "ladder", "crank", "stick", "pole", "arm")

    mass: Formula = 0
    length: Formula | None = None

    open_lengths: ClassVar[dict[str, tuple[str, ...]]] = {"length": ()}

    example = "{mass: 1 kg, length: 1 m}"

    def build(self, names: Names) -> Build:
        m, length = names.positive(self, "mass", MASS), names.positive(self, "length", LENGTH)
        end, inertia = half(length), divide(multiply(m, power(length, number(2))), number(12))
        return Build(
            m,
            inertia,
            points={"start": (negate(end), ZERO), "end": (end, ZERO)},
            corners=("start", "end"),
            tensor=(ZERO, inertia, inertia, ZERO, ZERO, ZERO) if names.space else (),
            solid=ROD,
            sizes=(length,),
        )


class Rectangle(Shape, kind="rectangle"):
    """A uniform rectangular plate or block; I = m (w^2 + h^2)/12. Points: the corners `bottom_left` ...
    and the middles `left`, `right`, `top`, `bottom` of its sides. A side that is left out is zero, unless one of
    these points is used."""

    called: ClassVar[tuple[str, ...]] = ("block", "box", "crate", "plate", "plank", "cart", "car", "domino")
    also: ClassVar[tuple[str, ...]] = ("block", "box", "crate", "plate", "plank", "cart", "car")

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
        x, y = half(w), half(h)
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
            tensor=_flat(m * square(h) / 12, m * square(w) / 12) if names.space else (),
            solid=BOX,
            sizes=(w, h, ZERO),
        )


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
        a, b, c = names.components(self.size, LENGTH, "size")
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
            solid=PLATE,
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
