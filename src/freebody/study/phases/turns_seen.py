"""Where something turns back within a phase that is followed in numbers."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise

from freebody.language.expression import ZERO
from freebody.measures.base import Measure
from freebody.numeric.snapshot import Snapshot
from freebody.questions.event_base import QuestionEvent
from freebody.study.phases.witness import PhaseSnapshot


def turns_seen(seen: Sequence[PhaseSnapshot], measures: Sequence[Measure]) -> list[Snapshot]:
    """The instants at which one of some measures turns back between two instants of a phase, at which it goes one way
    and the other; in their order, phase by phase."""
    return [turn for one in seen for turn in _in_phase(one, measures)]


def _in_phase(one: PhaseSnapshot, measures: Sequence[Measure]) -> list[Snapshot]:
    turns: list[Snapshot] = []
    for measure in measures:
        event = QuestionEvent(measure, 1, ZERO, "turns back")
        for before, after in pairwise((one.begin, *one.looks, one.snapshot())):
            if before.rate(measure) * after.rate(measure) < 0.0:
                there = one.mode.run(before.q, before.v, before.t, after.t, event)
                if there.event is not None and there.event[0] == "is reached":
                    turns.append(there.snapshot())
    return sorted(turns, key=lambda s: s.t)
