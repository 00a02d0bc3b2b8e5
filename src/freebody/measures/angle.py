"""Angle of a body, counter-clockwise, relative to another body or the ground."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import TypeVar

from freebody.language.expression import Expr
from freebody.language.units import DIMENSIONLESS, Dimension
from freebody.measures.base import Measure
from freebody.measures.geometry import GROUND, ZERO, Geometry, Pose, Scalar, SpatialPose, Vector

S = TypeVar("S", bound=Scalar)


@dataclass(frozen=True)
class Angle(Measure):
    """theta_of - theta_origin - reference; not reduced to one turn. In space: of a body that moves in the plane of x
    and y of the other, the angle between their x axes."""

    of: str
    origin: str = GROUND
    reference: Expr = ZERO

    @property
    def dimension(self) -> Dimension:
        return DIMENSIONLESS

    @property
    def is_angle(self) -> bool:
        return True

    def value(self, g: Geometry[S]) -> S:
        return _between(g, g.pose(self.of), g.pose(self.origin)) - g.scalar(self.reference)

    def bodies(self) -> Iterator[str]:
        yield from (self.of, self.origin)


def _between(g: Geometry[S], of: Pose[S] | SpatialPose[S], origin: Pose[S] | SpatialPose[S]) -> S:
    if isinstance(of, SpatialPose) and isinstance(origin, SpatialPose):
        x, (along, across, _) = of.axes[0], origin.axes
        return g.tangent(Vector(x.dot(along), x.dot(across)), g.scalar(ZERO))[1]
    assert isinstance(of, Pose)
    assert isinstance(origin, Pose)
    return of.angle - origin.angle
