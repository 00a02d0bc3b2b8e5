"""Polygon: a uniform plate with straight edges."""

from __future__ import annotations

import random
from typing import TYPE_CHECKING, ClassVar

from freebody.language.expression import Expr, Number, Sum, divide, evaluate, free_symbols
from freebody.language.sentences import Message
from freebody.language.units import LENGTH, MASS
from freebody.measures.geometry import ZERO
from freebody.model.shapes.base import Build, Shape, plate_tensor
from freebody.model.solids import PLATE
from freebody.model.spec import Formula
from freebody.tolerances import ROUNDED

if TYPE_CHECKING:
    from freebody.model.names import Names


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
            tensor=plate_tensor(Ix, Iy, xy) if names.space else (),
            solid=PLATE,
        )


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
