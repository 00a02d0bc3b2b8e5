"""A reaction while nothing moves, where the motion has no formulas: at rest it needs none.

What touches sticks; where all reactions that balance the loads within the cones of friction agree in one, that is it.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from freebody.errors import CannotAnswer
from freebody.language.expression import Expr
from freebody.language.sentences import Message
from freebody.questions.reactions_by_component import component_of
from freebody.questions.reading import Question
from freebody.questions.rest import ReactionRange
from freebody.study.answering.answer import Answer
from freebody.study.setup import Setup
from freebody.system.modes import depends_on_time
from freebody.system.system import System


def reaction_at_rest(system: System, question: Question) -> Answer | None:
    """The reaction of a system that starts at rest and stays there; None where it does not, or others balance it."""
    found = range_at_rest(system, question)
    if found is None or not isinstance(found.expression, Expr) or not isinstance(found.value, float):
        return None
    return replace(found, notes=(Message("while it stays at rest"),))


def range_at_rest(system: System, question: Question) -> Answer | None:
    """Between which values a reaction lies of a system that starts at rest and stays there, one formula where they are
    one; None where it does not stay there."""
    from freebody.study.friction.answers import answer

    of = component_of(question.quantity)
    if of is None or of.less or question.event or question.transition:
        return None
    if not system.has_values or depends_on_time(system):
        return None
    try:
        if np.any(Setup(system).draws[0].start().v):
            return None
        one = ReactionRange((of.row, *of.further), of.reaction, of.dimension)
        return answer(system, replace(question, quantity=one))
    except (CannotAnswer, ArithmeticError, ValueError):
        return None
