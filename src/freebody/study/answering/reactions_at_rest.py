"""A reaction while nothing moves, where the motion has no formulas: at rest it needs none.

What touches sticks; where all reactions that balance the loads within the cones of friction agree in one, that is it.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from freebody.errors import CannotAnswer
from freebody.language.expression import Expr
from freebody.language.sentences import Message
from freebody.numeric.jets import Array
from freebody.questions.base import Quantity
from freebody.questions.reactions_by_component import component_of
from freebody.questions.reading import Question
from freebody.questions.rest import ReactionRange
from freebody.study.answering.answer import Answer
from freebody.study.setup import Setup
from freebody.system.modes import depends_on_time
from freebody.system.system import System
from freebody.tolerances import ROUND_OFF

_AT_REST = Message("while it stays at rest")


def reaction_at_rest(system: System, question: Question) -> Answer | None:
    """The reaction of a system that starts at rest and stays there; None where it does not, or others balance it. The
    greatest or least one is the end of what rest allows."""
    if question.quantity.turn is not None:
        return None if depends_on_time(system) else _end_at_rest(system, question, *question.quantity.turn)
    found = range_at_rest(system, question)
    if found is None or not isinstance(found.expression, Expr) or not isinstance(found.value, float):
        return None
    if depends_on_time(system):
        return replace(found, notes=(Message("at the start, while nothing slips beside what is driven"),))
    return replace(found, notes=(_AT_REST,))


def _end_at_rest(system: System, question: Question, of: Quantity, _event: object, side: int) -> Answer | None:
    found = range_at_rest(system, replace(question, quantity=of))
    if found is None or not isinstance(found.expression, tuple) or not isinstance(found.value, tuple):
        return found and replace(found, notes=(_AT_REST,))
    if question.options:  # these were judged beside both ends
        return None
    k = 0 if side < 0 else -1
    return replace(found, expression=found.expression[k], value=found.value[k], notes=(_AT_REST,))


def range_at_rest(system: System, question: Question) -> Answer | None:
    """Between which values a reaction lies of a system that starts at rest and stays there, be it beside what is
    driven, one formula where they are one; None where it does not stay there."""
    from freebody.study.friction.answers import answer, prepared

    of = component_of(question.quantity)
    if of is None or of.less or question.event or question.transition:
        return None
    if not system.has_values:
        return None
    try:
        speeds = Setup(system).draws[0].start().v
        if depends_on_time(system) and not _leads(Setup(prepared(system).touching.stuck), speeds):
            return None
        if np.any(speeds) and not depends_on_time(system):
            return None
        one = ReactionRange((of.row, *of.further), of.reaction, of.dimension)
        return answer(system, replace(question, quantity=one))
    except (CannotAnswer, ArithmeticError, ValueError):
        return None


def _leads(stuck: Setup, speeds: Array) -> bool:
    """Whether a drive leads all along where nothing slips, with the speeds of the start [SI, by column]."""
    if stuck.model.degrees_of_freedom:
        return False
    led = stuck.draws[0].start().v
    return led.shape == speeds.shape and bool(np.allclose(led, speeds, rtol=ROUND_OFF, atol=ROUND_OFF))
