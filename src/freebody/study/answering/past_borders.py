"""Motions under loads that act beyond a border only, such as elastic strings: told in phases, one on each side."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace

from freebody.errors import CannotAnswer, ModelError
from freebody.questions.reading import Question
from freebody.study.answering.solution import Solution

Solver = Callable[[Sequence[Question]], Solution]


def is_of_motion(q: Question) -> bool:
    """Whether a question is about what happens on the way."""
    waits = q.event is not None or q.transition is not None
    return waits or q.quantity.turn is not None or (q.at_start and q.quantity.is_of_state)


def past_borders(questions: Sequence[Question], in_phases: Solver, in_one_law: Solver) -> Solution:
    """What happens on the way by phases, as far as these have formulas; all else by the law of both sides."""
    waiting = [q for q in questions if is_of_motion(q)]
    try:
        told = in_phases(waiting)
    except (CannotAnswer, ModelError):
        return in_one_law(questions)
    found = {a.id: a for a in told.answers if a.expression is not None}
    rest = in_one_law([q for q in questions if q.id not in found])
    refused = {a.id: a for a in told.answers if a.id not in found}
    for a in rest.answers:
        of_phases = refused.get(a.id, a)
        is_better = a.expression is None and (a.value is None or of_phases.value is not None)
        found[a.id] = of_phases if is_better else a
    return replace(told, answers=tuple(found[q.id] for q in questions))
