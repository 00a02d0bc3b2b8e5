"""Angle of a body, counter-clockwise, relative to another body or the ground."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import ClassVar, TypeVar

from freebody.language.expression import Expr
from freebody.language.units import DIMENSIONLESS, Dimension
from freebody.measures.geometry import GROUND, ZERO, Geometry, Scalar

S = TypeVar("S", bound=Scalar)


@dataclass(frozen=True)
class Angle:
    """theta_of - theta_origin - reference; not reduced to one turn."""

    of: str
    origin: str = GROUND
    reference: Expr = ZERO

    incremental: ClassVar[bool] = False

    @property
    def dimension(self) -> Dimension:
        return DIMENSIONLESS

    def value(self, g: Geometry[S]) -> S:
        return g.pose(self.of).angle - g.pose(self.origin).angle - g.scalar(self.reference)

    def bodies(self) -> Iterator[str]:
        yield from (self.of, self.origin)
