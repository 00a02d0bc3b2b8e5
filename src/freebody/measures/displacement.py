"""Displacement of a point from another along a direction: d = (r_P - r_O) . e"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import TypeVar

from freebody.language.units import LENGTH, Dimension
from freebody.measures.base import Measure
from freebody.measures.geometry import Direction, Geometry, Point, Scalar, position, unit

S = TypeVar("S", bound=Scalar)


@dataclass(frozen=True)
class Displacement(Measure):
    """Positive along the direction, which may turn with a body."""

    of: Point
    origin: Point
    along: Direction

    @property
    def dimension(self) -> Dimension:
        return LENGTH

    def value(self, g: Geometry[S]) -> S:
        return (position(g, self.of) - position(g, self.origin)).dot(unit(g, self.along))

    def bodies(self) -> Iterator[str]:
        yield from (self.of.body, self.origin.body, self.along.body)
