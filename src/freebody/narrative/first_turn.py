"""How far a motion gets whose contacts change, as the question what it is where it first turns."""

from __future__ import annotations

from contextlib import suppress
from dataclasses import replace

from freebody.errors import InputError
from freebody.narrative.contact.settings import has_phases
from freebody.questions.reading import Question
from freebody.study.answering.answer import Answer
from freebody.study.answering.solve import solve
from freebody.system.system import System


def at_first_turn(system: System, question: Question, answer: Answer) -> Question | None:
    """The question what it is where it first turns, or at the change up to which it is asked for, where contacts part
    the motion and it has the same answer."""
    turn = question.quantity.turn
    if turn is None or not has_phases(system) or not answer.is_answered:
        return None
    of, event, _side = turn
    own = replace(question, quantity=of, options={}, key=None)
    for asked in (replace(own, event=event), own) if question.transition is not None else (replace(own, event=event),):
        with suppress(InputError):  # where a force turns back is no event that a simulation watches
            (given,) = solve(replace(system, questions=(asked,))).answers
            if given.expression == answer.expression:
                return asked
    return None
