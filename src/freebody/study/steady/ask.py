"""Who answers which question about motion that goes on evenly."""

from __future__ import annotations

from freebody.errors import CannotAnswer
from freebody.questions.reading import Question
from freebody.questions.steady import Extremes, SpinStability, SteadyStability, SteadyValue
from freebody.study.setup import Setup
from freebody.study.steady.finding import Finding


def find(setup: Setup, question: Question) -> Finding:
    """The closed form with its evidence. Raises CannotAnswer with the reason where there is none."""
    if question.event is not None:
        raise CannotAnswer("what goes on evenly has no event; leave out 'when'")
    match question.quantity:
        case SteadyValue():
            from freebody.study.steady.motion import steady_value

            return steady_value(setup, question, question.quantity)
        case Extremes():
            from freebody.study.steady.extremes import extremes

            return extremes(setup, question, question.quantity)
        case SpinStability():
            from freebody.study.steady.spin import spin_stability

            return spin_stability(setup, question, question.quantity)
        case SteadyStability():
            from freebody.study.steady.stability import steady_stability

            return steady_stability(setup, question)
        case _:
            raise CannotAnswer("this is no question about steady motion")
