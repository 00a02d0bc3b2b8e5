"""Questions about motion that goes on evenly: steady rates, what a turn brings, whether a disturbance grows."""

from __future__ import annotations

from functools import singledispatch

from freebody.errors import CannotAnswer
from freebody.language.sentences import Message
from freebody.narrative.context import Context, Method, refuse
from freebody.narrative.lines.script import DerivationStage
from freebody.questions.base import Quantity
from freebody.questions.reading import Question
from freebody.questions.steady import Extremes, SpinStability, SteadyOscillations, SteadyStability, SteadyValue
from freebody.study.answering.answer import Answer


def derive(context: Context, question: Question, answer: Answer, method: Method) -> list[DerivationStage]:
    """The derivation of a question about steady motion. Raises CannotAnswer where the solver has no formula."""
    refuse(method, (), Message("steady motion"))
    if answer.expression is None:
        raise CannotAnswer(answer.reason or Message("there is no closed form"))
    return _told(question.quantity, context, question, answer)


@singledispatch
def _told(q: Quantity, context: Context, question: Question, answer: Answer) -> list[DerivationStage]:
    raise CannotAnswer(Message("this is no question about steady motion"))


@_told.register(SteadyValue)
def _value(q: SteadyValue, context: Context, question: Question, answer: Answer) -> list[DerivationStage]:
    from freebody.narrative.steady.steady_motion import tell_steady

    return tell_steady(context, question, answer, q)


@_told.register(Extremes)
def _extremes(q: Extremes, context: Context, question: Question, answer: Answer) -> list[DerivationStage]:
    from freebody.narrative.steady.extremes import tell_extremes

    return tell_extremes(context, question, answer, q)


@_told.register(SpinStability)
def _spin(q: SpinStability, context: Context, question: Question, answer: Answer) -> list[DerivationStage]:
    from freebody.narrative.steady.stability import tell_spin

    return tell_spin(context, question, answer, q)


@_told.register(SteadyStability)
def _stability(q: SteadyStability, context: Context, question: Question, answer: Answer) -> list[DerivationStage]:
    from freebody.narrative.steady.stability import tell_stability

    return tell_stability(context, question, answer)


@_told.register(SteadyOscillations)
def _oscillations(q: SteadyOscillations, context: Context, question: Question, answer: Answer) -> list[DerivationStage]:
    from freebody.narrative.steady.oscillations import tell_oscillations

    return tell_oscillations(context, question, answer, q)
