"""What packing needs to know of a system in numbers."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field

import numpy as np

from freebody.language.expression import Expr
from freebody.measures.base import Measure
from freebody.numeric.rotation import Array, matrix
from freebody.system.system import System


@dataclass(frozen=True)
class Numbers:
    """A system with a number for every parameter, and where its measures count from."""

    system: System
    values: Mapping[str, float]
    length: float  # typical of the system [m]
    fixed: Mapping[str, tuple[float, ...]]  # of the fixed bodies: x, y [m], angle [rad]; x, y, z, rotation vector
    number: Callable[[Expr], float]
    start_value: Callable[[Measure], float]
    principal_moments: Mapping[str, tuple[Array, Array]] = field(default_factory=dict[str, tuple[Array, Array]])

    @property
    def space(self) -> bool:
        return self.system.space

    def moments(self, body: str) -> Array:
        """(3,) principal moments of inertia of a body in space [kg m^2]."""
        return self.principal_moments[body][0]

    def principal(self, body: str) -> Array:
        """(3, 3) principal axes of a body in space: columns of components along the body's axes."""
        return self.principal_moments[body][1]

    def fixed_frame(self, body: str) -> tuple[Array, Array]:
        """Place (3,) and axes, the columns of a rotation (3, 3), of a fixed body in space."""
        place = np.array(self.fixed.get(body, (0.0,) * 6))
        return place[:3], matrix(place[3:])

    def fixed_pose(self, body: str) -> tuple[float, float, float, float]:
        """x, y, cosine and sine of a fixed body."""
        x, y, angle = self.fixed.get(body, (0.0, 0.0, 0.0))[:3]
        return x, y, math.cos(angle), math.sin(angle)

    def fixed_angle(self, body: str) -> float:
        """Angle of a fixed body [rad]."""
        return self.fixed.get(body, (0.0, 0.0, 0.0))[2]
