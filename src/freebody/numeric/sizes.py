"""What is large and what is small in a system: a typical length, and the metric of the masses.

A move dq costs twice the kinetic energy dq^T M dq at unit speed. With D = M^(-1/2) and dq = D y that is |y|^2,
so that "the smallest move" means the cheapest one. A massless body counts as one much lighter than the lightest.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from freebody.errors import CannotAnswer
from freebody.language.expression import Expr, free_symbols
from freebody.language.units import LENGTH
from freebody.numeric.jets import Array
from freebody.system.system import System

LIGHT = 1e-2  # what counts as the mass of a massless body where the smallest move is meant, by the lightest


@dataclass(frozen=True)
class Sizes:
    """Scales of one system in numbers, along its coordinates q."""

    length: float  # typical of the system [m]
    mass: float  # of the heaviest body [kg]
    unit_moves: Array  # a move by the typical length, a turn by a radian
    small_moves: Array  # D: 1/sqrt(mass) for every coordinate
    turning: NDArray[np.bool_]  # which coordinates are angles

    @classmethod
    def of(cls, masses: Array, turning: NDArray[np.bool_], length: float) -> Sizes:
        """From the mass or moment of inertia at every coordinate, and which of these are angles. Raises
        CannotAnswer for negative masses."""
        return cls(
            length,
            float(masses[~turning].max(initial=0.0)) or 1.0,
            np.where(turning, 1.0, length),
            _small_moves(masses, turning, length),
            turning,
        )

    def clipped(self, step: Array, reach: float) -> Array:
        """A step shortened so that nothing moves by more than half of the size of the system, or half of `reach` sizes
        where that is more, and nothing turns by more than half a radian."""
        moved = self.relative(step)
        far = float(moved[~self.turning].max(initial=0.0)) / max(1.0, reach)
        return step * min(1.0, 0.5 / max(far, float(moved[self.turning].max(initial=0.0)), 1e-300))

    def relative(self, step: Array) -> Array:
        """A move by the size of the system, a turn in radians."""
        return np.abs(step) / self.unit_moves


def typical_length(system: System, number: Callable[[Expr], float]) -> float:
    """How far points are from mass centres and from the origin, and how long held lengths are, at most [m]."""
    lengths = [0.0]
    for body in system.bodies.values():
        for place in [*body.points.values(), *([body.start.at[1]] if body.start.at else [])]:
            lengths.append(math.hypot(*map(number, place)))
        if body.radius is not None:
            lengths.append(abs(number(body.radius)))
    for row in system.held:
        if row.target is not None and row.measure.dimension == LENGTH and "t" not in free_symbols(row.target):
            lengths.append(abs(number(row.target)))
    return max(lengths) or 1.0


def _small_moves(masses: Array, turning: NDArray[np.bool_], length: float) -> Array:
    """1/sqrt(mass) for every coordinate: the move that costs a unit of (twice the) kinetic energy."""
    masses = masses.copy()
    if (masses < 0.0).any():
        raise CannotAnswer("with these parameters a mass or a moment of inertia is negative")
    moved = masses[~turning]
    light = LIGHT * float(moved[moved > 0.0].min()) if (moved > 0.0).any() else 1.0
    spun = masses[turning]
    inert = LIGHT * float(spun[spun > 0.0].min()) if (spun > 0.0).any() else light * length**2
    masses[(masses == 0.0) & ~turning] = light
    masses[(masses == 0.0) & turning] = inert
    return 1.0 / np.sqrt(masses)
