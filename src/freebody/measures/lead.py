"""A straight lead of string between two circles (a point is a circle of radius 0).

The string runs round circle i counter-clockwise (s_i = +1) or clockwise (-1). Its lead leaves circle 1
at C_1 - s_1 R_1 n and meets circle 2 at C_2 - s_2 R_2 n, so with rho = s_2 R_2 - s_1 R_1

    C_2 - C_1 = l e(a) + rho n(a).

The arc on pulley i has the length s_i R_i (a_out - a_in). Gathering what belongs to one lead, the length of
the whole string is the sum over its leads of  l - rho a,  whose differential is e . d(C_2 - C_1): the pull
of the string along its line and nothing else.

In space the circles lie in one plane, that of x and y or the one of two perpendicular directions e_1, e_2:
the components of C_2 - C_1 are those along them.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import ClassVar, TypeVar

from freebody.language.expression import Expr
from freebody.language.units import LENGTH, Dimension
from freebody.measures.base import Measure
from freebody.measures.geometry import Direction, Geometry, Point, Scalar, Vector, position, unit

S = TypeVar("S", bound=Scalar)


@dataclass(frozen=True)
class Lead(Measure):
    """l - rho a of the lead from one circle to the next, its share of the string's length."""

    start: Point
    end: Point
    rho: Expr

    incremental: ClassVar[bool] = True

    @property
    def dimension(self) -> Dimension:
        return LENGTH

    def value(self, g: Geometry[S]) -> S:
        rho = g.scalar(self.rho)
        between = position(g, self.end) - position(g, self.start)
        length, angle = g.tangent(Vector(between.x, between.y), rho)  # strings lie in the plane of x and y
        return length - rho * angle

    def bodies(self) -> Iterator[str]:
        yield from (self.start.body, self.end.body)

    def lines(self) -> Iterator[tuple[Point, Point]]:
        yield self.start, self.end


@dataclass(frozen=True)
class LeadInPlane(Lead):
    """In space: the lead between circles in the plane of two perpendicular unit vectors, about along x side."""

    along: Direction
    side: Direction

    def value(self, g: Geometry[S]) -> S:
        rho = g.scalar(self.rho)
        between = position(g, self.end) - position(g, self.start)
        seen = Vector(between.dot(unit(g, self.along)), between.dot(unit(g, self.side)))
        length, angle = g.tangent(seen, rho)
        return length - rho * angle

    def bodies(self) -> Iterator[str]:
        yield from (*super().bodies(), self.along.body, self.side.body)
