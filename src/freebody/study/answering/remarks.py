"""What is said beside an answer that is zero whatever the motion is: what may have been meant instead."""

from __future__ import annotations

from dataclasses import replace

from freebody.language.expression import ZERO
from freebody.measures.displacement import Displacement
from freebody.measures.geometry import GROUND
from freebody.questions.reading import Question
from freebody.study.answering.answer import Answer
from freebody.system.system import System


def with_remark(system: System, question: Question, answer: Answer) -> Answer:
    """With what is to be said where what comes together on the way to an event is nothing, or where the middle of a
    body in a bearing is asked how fast it is there."""
    parts = answer.expression if isinstance(answer.expression, tuple) else (answer.expression,)
    quantity = question.quantity
    at_event = question.event is not None and all(_is_borne(system, name) for name in quantity.bodies_in_motion)
    if any(part != ZERO for part in parts) or not (quantity.scope == "course" or at_event):
        return answer
    remark = quantity.remark_on_zero(system)
    return replace(answer, notes=(*answer.notes, remark)) if remark else answer


def _is_borne(system: System, name: str) -> bool:
    """Whether the ground holds the middle of a body where it is."""
    middle = system.bodies[name].mass_center
    held = [row.measure for row in system.constraint_rows if row.target is None and not row.closes]
    ends = [{each.of, each.origin} for each in held if isinstance(each, Displacement)]
    n_axes = 3 if system.space else 2
    return sum(middle in pair and any(end.body == GROUND for end in pair) for pair in ends) >= n_axes
