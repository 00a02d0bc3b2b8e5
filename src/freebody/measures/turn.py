"""Measures of directions in space: how far two of them agree, and how far one has turned about an axis.

A rotation has no coordinate of its own in space; what joints hold and what people call an angle are measures of
directions fixed in bodies. The component of an angular velocity along a direction is the rate of no measure, but linear
in rates of alignments (`angular_velocity`).
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import TypeVar

from freebody.language.expression import Expr
from freebody.language.units import DIMENSIONLESS, Dimension
from freebody.measures.base import Measure
from freebody.measures.geometry import ZERO, Direction, Geometry, Scalar, Vector, unit

S = TypeVar("S", bound=Scalar)


@dataclass(frozen=True)
class Alignment(Measure):
    """The cosine of the angle between two directions: 0 where they are perpendicular."""

    of: Direction
    along: Direction

    @property
    def dimension(self) -> Dimension:
        return DIMENSIONLESS

    def value(self, g: Geometry[S]) -> S:
        return unit(g, self.of).dot(unit(g, self.along))

    def bodies(self) -> Iterator[str]:
        yield from (self.of.body, self.along.body)


@dataclass(frozen=True)
class Turn(Measure):
    """The angle by which a direction has turned from `start` towards `side`, two directions of the same length fixed
    in one body and perpendicular to each other: about the axis start x side, right-handed, not reduced to one turn."""

    of: Direction
    start: Direction
    side: Direction
    reference: Expr = ZERO

    @property
    def dimension(self) -> Dimension:
        return DIMENSIONLESS

    @property
    def is_angle(self) -> bool:
        return True

    def value(self, g: Geometry[S]) -> S:
        of = unit(g, self.of)
        seen = Vector(of.dot(unit(g, self.start)), of.dot(unit(g, self.side)))
        return g.tangent(seen, g.scalar(ZERO))[1] - g.scalar(self.reference)

    def bodies(self) -> Iterator[str]:
        yield from (self.of.body, self.start.body, self.side.body)
