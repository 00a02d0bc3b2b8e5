"""What packing needs to know of a system in numbers."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass

from freebody.language.expression import Expr
from freebody.measures.base import Measure
from freebody.system.system import System


@dataclass(frozen=True)
class Numbers:
    """A system with a number for every parameter, and where its measures count from."""

    system: System
    values: Mapping[str, float]
    length: float  # typical of the system [m]
    fixed: Mapping[str, tuple[float, float, float]]  # poses of the fixed bodies: x, y [m], angle [rad]
    number: Callable[[Expr], float]
    start_value: Callable[[Measure], float]

    def fixed_pose(self, body: str) -> tuple[float, float, float, float]:
        """x, y, cosine and sine of a fixed body."""
        x, y, angle = self.fixed.get(body, (0.0, 0.0, 0.0))
        return x, y, math.cos(angle), math.sin(angle)

    def fixed_angle(self, body: str) -> float:
        """Angle of a fixed body [rad]."""
        return self.fixed.get(body, (0.0, 0.0, 0.0))[2]
