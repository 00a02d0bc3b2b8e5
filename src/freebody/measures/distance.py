"""Distance between two points, and the bearing of the line from one to the other."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import TypeVar

from freebody.language.expression import Expr
from freebody.language.units import DIMENSIONLESS, LENGTH, Dimension
from freebody.measures.base import Measure
from freebody.measures.geometry import GROUND, ZERO, Geometry, Point, Scalar, SpatialPose, Vector, position

S = TypeVar("S", bound=Scalar)


@dataclass(frozen=True)
class Distance(Measure):
    """|r_B - r_A|; its gradient is the unit vector between the points."""

    start: Point
    end: Point

    @property
    def is_size(self) -> bool:
        return True

    @property
    def dimension(self) -> Dimension:
        return LENGTH

    def value(self, g: Geometry[S]) -> S:
        between = position(g, self.end) - position(g, self.start)
        return g.tangent(between, g.scalar(ZERO))[0] if between.z is None else g.root(between.dot(between))

    def bodies(self) -> Iterator[str]:
        yield from (self.start.body, self.end.body)

    def lines(self) -> Iterator[tuple[Point, Point]]:
        yield self.start, self.end


@dataclass(frozen=True)
class Bearing(Measure):
    """Angle of the line from A to B, counter-clockwise from `reference` on `origin`; in space that of its picture in
    the plane of x and y of the origin."""

    start: Point
    end: Point
    origin: str = GROUND
    reference: Expr = ZERO

    @property
    def dimension(self) -> Dimension:
        return DIMENSIONLESS

    @property
    def is_angle(self) -> bool:
        return True

    def value(self, g: Geometry[S]) -> S:
        between, origin = position(g, self.end) - position(g, self.start), g.pose(self.origin)
        if isinstance(origin, SpatialPose):
            seen = Vector(between.dot(origin.axes[0]), between.dot(origin.axes[1]))
            return g.tangent(seen, g.scalar(ZERO))[1] - g.scalar(self.reference)
        return g.tangent(between, g.scalar(ZERO))[1] - origin.angle - g.scalar(self.reference)

    def bodies(self) -> Iterator[str]:
        yield from (self.start.body, self.end.body, self.origin)

    def lines(self) -> Iterator[tuple[Point, Point]]:
        yield self.start, self.end
