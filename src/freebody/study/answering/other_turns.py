"""An event of an angle that does not come, while the motion passes the same direction in another turn.

Angles are counted on, so that 30 deg, 390 deg and -330 deg are three events of one direction.
"""

from __future__ import annotations

import math
from contextlib import suppress
from dataclasses import replace

from freebody.errors import CannotAnswer, ExpressionError
from freebody.language.expression import PI, Expr, evaluate, number
from freebody.language.notation import to_text
from freebody.language.sentences import Message, further
from freebody.questions.event_base import QuestionEvent
from freebody.questions.reading import Question
from freebody.study.answering.answer import Answer
from freebody.study.answering.numbers import number_of
from freebody.study.setup import Setup
from freebody.system.system import System

_TURNS = (1, -1, 2, -2, 3, -3)


def with_other_turns(system: System, question: Question, answer: Answer) -> Answer:
    """An answer that says that an event does not come, with the turn in which the same direction is passed."""
    event = question.event
    if not isinstance(event, QuestionEvent) or event.order or not event.measure.is_angle:
        return answer
    is_elsewhere = answer.expression is not None and answer.value is None  # it comes with other numbers
    if not (answer.is_missed or is_elsewhere) or not question.quantity.is_of_state or question.quantity.wanted:
        return answer
    setup = None if system.bounds or system.dry_friction or system.blows else Setup(system)
    for n in _TURNS:
        value = event.value + number(2 * n) * PI
        text = f"{event.text.partition('=')[0].strip()} = {_shown(value, event.value, n)}"
        other = replace(question, event=replace(event, value=value, text=text), options={}, key=None)
        if _comes(system, setup, other):
            told = Message("angles are counted on, and the same direction is passed at {other}", other=text)
            if answer.is_missed:
                return replace(answer, reason=further(answer.reason, told), never=False)
            return replace(answer, notes=(*answer.notes, told))
    return answer


def _comes(system: System, setup: Setup | None, question: Question) -> bool:
    """Whether an event comes within a minute, in numbers. setup: None where contacts or friction change the law."""
    with suppress(CannotAnswer, ArithmeticError, ValueError):
        if setup is None:
            from freebody.study.answering.simulated_numbers import number_with_changes  # loads all of contact

            return number_with_changes(system, question) is not None
        number_of(setup, question.quantity, question.event)
        return True
    return False


def _shown(value: Expr, asked: Expr, n: int) -> str:
    """In degrees, as a file says it."""
    try:
        return f"{round(math.degrees(float(evaluate(value, {}))), 6):g} deg"
    except (KeyError, ValueError, ArithmeticError, ExpressionError):
        return f"{to_text(asked)} {'+' if n > 0 else '-'} {360 * abs(n)} deg"
