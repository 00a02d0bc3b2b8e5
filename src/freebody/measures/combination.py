"""Measures made of measures: a linear combination, and a user's expression."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import ClassVar, TypeVar

from freebody.language.expression import Call, Expr
from freebody.language.units import Dimension
from freebody.measures.angle import Angle
from freebody.measures.base import Measure
from freebody.measures.geometry import Geometry, Point, Scalar

S = TypeVar("S", bound=Scalar)


@dataclass(frozen=True)
class Combination(Measure):
    """sum of coefficient * measure: an arc rolled, a length of string, a gear's mesh. Only its changes
    have a meaning, so it is held at its start value."""

    terms: tuple[tuple[Expr, Measure], ...]
    dimension_: Dimension

    incremental: ClassVar[bool] = True

    @property
    def dimension(self) -> Dimension:
        return self.dimension_

    def value(self, g: Geometry[S]) -> S:
        first, *rest = (g.scalar(coefficient) * measure.value(g) for coefficient, measure in self.terms)
        for term in rest:
            first = first + term
        return first

    def bodies(self) -> Iterator[str]:
        for _coefficient, measure in self.terms:
            yield from measure.bodies()

    def lines(self) -> Iterator[tuple[Point, Point]]:
        for _coefficient, measure in self.terms:
            yield from measure.lines()


@dataclass(frozen=True)
class Composed(Measure):
    """An expression in other measures, the parameters and time. here: its formula need hold only where what it takes
    the size of keeps its sign, as for a contact, whose nearest place is another one beyond an edge."""

    expression: Expr
    measures: tuple[tuple[str, Measure], ...]
    dimension_: Dimension
    here: bool = False

    @property
    def dimension(self) -> Dimension:
        return self.dimension_

    @property
    def is_angle(self) -> bool:
        """So is an angle that is counted the other way round, or in another unit, and an arc of something."""
        if isinstance(self.expression, Call) and self.expression.function in ("acos", "asin", "atan"):
            return True
        return len(self.measures) == 1 and self.measures[0][1].is_angle

    @property
    def is_size(self) -> bool:
        """So is the root that a distance from an axis is."""
        return isinstance(self.expression, Call) and self.expression.function == "sqrt"

    def value(self, g: Geometry[S]) -> S:
        return g.apply(self.expression, {name: measure.value(g) for name, measure in self.measures}, here=self.here)

    def bodies(self) -> Iterator[str]:
        for _name, measure in self.measures:
            yield from measure.bodies()

    def lines(self) -> Iterator[tuple[Point, Point]]:
        for _name, measure in self.measures:
            yield from measure.lines()


def is_of_turning(measure: object) -> bool:
    """Whether a measure tells how bodies turn and nothing else, as the angle of a stop: what pushes it is a couple."""
    if isinstance(measure, Composed):
        return all(is_of_turning(part) for _name, part in measure.measures)
    return isinstance(measure, Angle)
