"""The slope of a quantity along a motion in numbers, by differences: it vanishes where the quantity is greatest."""

from __future__ import annotations

from collections.abc import Callable
from typing import Protocol

from freebody.numeric.jets import Array
from freebody.numeric.reference import Reference
from freebody.numeric.snapshot import Snapshot
from freebody.questions.base import Quantity
from freebody.study.phases.quantities import value_in_mode
from freebody.system.system import System

_STEP = 1e-6  # [s] between which differences are taken
_NOISE = 1e-12  # of a quantity: rounding in it
_SOON = 1e-4  # [s] after the beginning of a phase: whether it grows or falls from there


class Accelerated(Protocol):
    """A motion in numbers: what it needs to be followed."""

    base: System
    system: System
    references: list[Reference]

    def accelerations(self, q: Array, v: Array, t: float) -> Array: ...

    def snapshot(self, q: Array, v: Array, t: float) -> Snapshot: ...


def slope_of(mode: Accelerated, quantity: Quantity, begin: Snapshot) -> Callable[[Array, Array, float], float]:
    """The slope in every state, with the sign that it has when the motion begins; zero where it is rounding."""

    def moved(q: Array, v: Array, t: float, by: float) -> tuple[Array, Array, float]:
        return q + by * mode.references[0].frame.slope(q, v), v + by * mode.accelerations(q, v, t), t + by

    def value(q: Array, v: Array, t: float) -> float:
        return float(value_in_mode(quantity, mode.base, mode.system, mode.snapshot(q, v, t)))

    def slope(q: Array, v: Array, t: float) -> float:
        after, before = value(*moved(q, v, t, _STEP)), value(*moved(q, v, t, -_STEP))
        is_noise = abs(after - before) <= _NOISE * (abs(after) + abs(before))
        return 0.0 if is_noise else (after - before) / (2 * _STEP)

    first = slope(begin.q, begin.v, begin.t) or slope(*moved(begin.q, begin.v, begin.t, _SOON))
    sign = -1.0 if first < 0.0 else 1.0
    return lambda q, v, t: sign * slope(q, v, t)
