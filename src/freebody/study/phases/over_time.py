"""What comes together over the time in phases, in numbers: of what stays the same in each of them."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from freebody.errors import CannotAnswer
from freebody.language.sentences import Message
from freebody.questions.base import Quantity
from freebody.study.answering.crosscheck import as_parts
from freebody.study.phases.quantities import value_in_mode
from freebody.study.phases.witness import PhaseSnapshot
from freebody.system.system import System
from freebody.tolerances import ROUND_OFF


def over_time(base: System, seen: Sequence[PhaseSnapshot], quantity: Quantity) -> Any:
    """The integral over the time of what stays the same in every phase; base: the system with its contacts. Raises
    CannotAnswer for what changes."""
    total: list[float] = []
    for one in seen:
        begin = one.mode.snapshot(one.begin.q, one.begin.v, one.begin.t, one.begin)
        end = one.snapshot()
        first, last = (as_parts(value_in_mode(quantity, base, one.mode.system, s)) for s in (begin, end))
        if any(abs(a - b) > ROUND_OFF * max(abs(a), abs(b)) for a, b in zip(first, last, strict=True)):
            raise CannotAnswer(Message("the force changes on the way, and its impulse was not checked in numbers"))
        parts = [x * (end.t - begin.t) for x in last]
        total = [a + b for a, b in zip(total, parts, strict=True)] if total else parts
    return tuple(total) if len(total) > 1 else total[0]
