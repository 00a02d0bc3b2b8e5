"""Extremes over a cycle of a motion by the numeric route alone: seen at many instants, then closer and closer about the
best one."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from freebody.errors import CannotAnswer
from freebody.language.sentences import Message
from freebody.measures.base import Measure
from freebody.model.elements import ConstraintRow
from freebody.model.state import State
from freebody.numeric.jets import Array
from freebody.questions.base import Described, Quantity
from freebody.study.answering.draws import Draw
from freebody.study.answering.repeated import cycle_at_all
from freebody.study.answering.witness import states_at
from freebody.study.setup import Setup
from freebody.tolerances import ROUND_OFF

_N_INSTANTS = 121  # of a cycle
_N_CLOSER = 25  # between the neighbours of the best one
_ROUNDS = 4  # the last ones are 4e-7 of a cycle apart: what is flat there differs by 1e-12 of its size


def extremes_over_cycle(
    setup: Setup,
    draw: Draw,
    measure: Measure | None,
    of: Quantity,
    *,
    is_exact: bool = False,
    whole: float | None = None,
) -> tuple[float, float]:
    """The least and the largest value. measure: what comes back to where it was, or goes on and on by `whole` each
    time; is_exact: whether the whole state must be taken up again. Raises CannotAnswer where the motion does not repeat
    itself."""
    if measure is None:
        raise CannotAnswer(Message("name a measure that moves to and fro, or round and round"))
    return extremes_between(setup, draw, of, *cycle_at_all(draw, measure, is_exact=is_exact, whole=whole))


def extremes_between(setup: Setup, draw: Draw, of: Quantity, begin: float, end: float) -> tuple[float, float]:
    """The least and the largest value between two instants."""
    times = np.linspace(begin, end, _N_INSTANTS)
    values = _values(setup, draw, of, times)
    low, high = (sign * _closer(setup, draw, of, times, values, sign) for sign in (1.0, -1.0))
    return low, high


@dataclass(frozen=True)
class OneSided(Quantity):
    """What a row transmits that can only pull, or push."""

    row: ConstraintRow

    def value(self, system: Described, state: State[Any]) -> Any:
        return self.row.sign * state.multiplier(self.row)


def insist_held(setup: Setup, draw: Draw, begin: float, end: float) -> None:
    """Raises CannotAnswer where a string goes slack, or a contact opens, between two instants: what is seen there holds
    it on."""
    for row in setup.system.constraint_rows:
        if not row.unilateral or begin == end:
            continue
        low, high = extremes_between(setup, draw, OneSided(row), begin, end)
        if low < -ROUND_OFF * max(abs(low), abs(high)):
            raise CannotAnswer(Message("{connection} does not hold all the time", connection=row.connection))


def _closer(setup: Setup, draw: Draw, of: Quantity, times: Array, values: Array, sign: float) -> float:
    """The least of sign times the quantity."""
    best = float((sign * values).min())
    for _ in range(_ROUNDS):
        k = int(np.argmin(sign * values))
        begin, end = float(times[max(k - 1, 0)]), float(times[min(k + 1, len(times) - 1)])
        times = np.linspace(begin, end, _N_CLOSER)
        values = _values(setup, draw, of, times)
        best = min(best, float((sign * values).min()))
    return best


def _values(setup: Setup, draw: Draw, of: Quantity, times: Array) -> Array:
    seen = states_at(draw.reference, draw.start(), times)
    return np.array([float(of.value(setup.system, s)) for s in seen])
