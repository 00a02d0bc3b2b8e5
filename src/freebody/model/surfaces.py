"""Surfaces of a body, z = f(x, y).

With f_x and f_y the slopes and w^2 = 1 + f_x^2 + f_y^2 the unit normal is n = (-f_x, -f_y, 1)/w; the surface has the
tangents b_1 = (1, 0, f_x)/sqrt(1 + f_x^2) and b_2 = n x b_1. Source: do Carmo, Differential Geometry of Curves and
Surfaces, sec. 2-4 and 3-3.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

from freebody.language.expression import ONE, ZERO, Call, Expr, Symbol, differentiate, divide
from freebody.language.units import LENGTH
from freebody.measures.base import Measure
from freebody.measures.combination import Composed
from freebody.measures.displacement import Displacement
from freebody.measures.geometry import Components, Direction, Point
from freebody.model.rotations import vector_product

Axes = tuple[Direction, Direction, Direction]
HEIGHT = Symbol("@z")  # of a point, in formulas with x and y
SQUARE = Symbol("x") * Symbol("x") + Symbol("y") * Symbol("y")


@dataclass(frozen=True)
class Surface:
    """z = height in x and y, from a point of a body along its axes. is_round: in rho = sqrt(x^2 + y^2) alone."""

    height: Expr
    is_round: bool
    origin: Point
    axes: Axes

    @cached_property
    def slopes(self) -> tuple[Expr, Expr]:
        """df/dx and df/dy."""
        return differentiate(self.height, "x"), differentiate(self.height, "y")

    @cached_property
    def steepness(self) -> Expr:
        """sqrt(1 + f_x^2 + f_y^2), one over the cosine of the slope."""
        fx, fy = self.slopes
        return Call("sqrt", ONE + fx * fx + fy * fy)

    @cached_property
    def normal(self) -> Components:
        fx, fy = self.slopes
        return divide(-fx, self.steepness), divide(-fy, self.steepness), divide(ONE, self.steepness)

    @cached_property
    def tangents(self) -> tuple[Components, Components]:
        """b_1 in the plane of x and z, b_2 = n x b_1."""
        fx = self.slopes[0]
        along = Call("sqrt", ONE + fx * fx)
        first = divide(ONE, along), ZERO, divide(fx, along)
        return first, vector_product(self.normal, first)

    def place_of(self, point: Point) -> tuple[tuple[str, Measure], ...]:
        """x, y and z of a point, as the surface counts them."""
        return tuple(
            (name, Displacement(point, self.origin, axis))
            for name, axis in zip(("x", "y", HEIGHT.name), self.axes, strict=True)
        )


def from_axis(point: Point, origin: Point, axes: Axes) -> Measure:
    """The distance of a point from the third of the axes through an origin."""
    x, y = (Displacement(point, origin, axis) for axis in axes[:2])
    return Composed(Call("sqrt", SQUARE), (("x", x), ("y", y)), LENGTH)
