"""What comes together over the time in phases, in numbers."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

import numpy as np

from freebody.errors import CannotAnswer
from freebody.language.sentences import Message
from freebody.numeric.jets import Array
from freebody.numeric.snapshot import Snapshot
from freebody.questions.base import Quantity
from freebody.questions.loads import Power
from freebody.study.answering.crosscheck import as_parts
from freebody.study.phases.looks import steps
from freebody.study.phases.quantities import value_in_mode
from freebody.study.phases.witness import NumericMode, PhaseSnapshot
from freebody.system.system import System
from freebody.tolerances import ROUND_OFF

_N_NODES = 6  # in a step
# parts of a value at an instant, and the instant: by mode, place, speed, time, and an instant before
ValueAt = Callable[[NumericMode, Array, Array, float, Snapshot], tuple[Sequence[float], Snapshot]]


def over_time(base: System, seen: Sequence[PhaseSnapshot], quantity: Quantity) -> Any:
    """The integral over the time, phase by phase. base: the system with its contacts."""
    total = sum(np.array(_integrated(base, one, quantity)) for one in seen)
    parts = [float(x) for x in np.atleast_1d(total)]
    return tuple(parts) if len(parts) > 1 else parts[0]


def work_over_time(base: System, seen: Sequence[PhaseSnapshot], load: str) -> float:
    """The integral of the power of a load, which no reaction stands in."""

    def power(mode: NumericMode, q: Array, v: Array, t: float, near: Snapshot) -> tuple[Sequence[float], Snapshot]:
        now = mode.looked(q, v, t, near)
        return as_parts(Power(load).value(mode.system, now)), now

    return sum(_by_points(base, one, power)[0] for one in seen)


def _integrated(base: System, one: PhaseSnapshot, quantity: Quantity) -> list[float]:
    """In a phase; where balls are followed that turn unseen, of what is the same at both of its ends alone."""

    def value(mode: NumericMode, q: Array, v: Array, t: float, near: Snapshot) -> tuple[Sequence[float], Snapshot]:
        now = mode.snapshot(q, v, t, near)
        return as_parts(value_in_mode(quantity, base, mode.system, now)), now

    if not base.unfollowed:
        return _by_points(base, one, value)
    begin, end = one.mode.snapshot(one.begin.q, one.begin.v, one.begin.t, one.begin), one.snapshot()
    first, last = (as_parts(value_in_mode(quantity, base, one.mode.system, s)) for s in (begin, end))
    if any(abs(a - b) > ROUND_OFF * max(abs(a), abs(b)) for a, b in zip(first, last, strict=True)):
        raise CannotAnswer(Message("the force changes on the way, and its impulse was not checked in numbers"))
    return [x * (end.t - begin.t) for x in last]


def _by_points(base: System, one: PhaseSnapshot, value: ValueAt) -> list[float]:
    """By Gauss-Legendre points in every step of the motion. Raises CannotAnswer where balls are followed that turn
    unseen."""
    if base.unfollowed:
        raise CannotAnswer(Message("the force changes on the way, and its impulse was not checked in numbers"))
    mode, n = one.mode, len(one.begin.q)

    def derivative(t: float, y: Array) -> Array:
        slope = mode.references[0].frame.slope(y[:n], y[n:])
        return np.concatenate([slope, mode.accelerations(y[:n], y[n:], t)])

    nodes, weights = np.polynomial.legendre.leggauss(_N_NODES)
    near, total = one.begin, np.zeros(1)
    for a, b, state in steps(derivative, np.concatenate([one.begin.q, one.begin.v]), one.begin.t, one.time):
        half = 0.5 * (b - a)
        for node, weight in zip(nodes, weights, strict=True):
            t = a + half * (1.0 + float(node))
            y = state(t)
            found, now = value(mode, y[:n], y[n:], t, near)
            near, total = now.counted_on(), total + half * weight * np.array(found)
    return [float(x) for x in total]
