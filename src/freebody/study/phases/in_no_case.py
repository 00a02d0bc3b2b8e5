"""Answers by cases of which none holds at the model's own values: no formula of theirs is the answer.

What rests may be braced, as a car on a slope that brakes both of its axles: then no phase has formulas, as the split of
friction is not unique. A reaction that is unique all the same, as the pressure on each axle, is told while it rests; of
what is not unique the range is told that rest allows.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from functools import partial

from freebody.errors import CannotAnswer
from freebody.language.expression import Expr
from freebody.language.sentences import Message
from freebody.present.lines import number_text
from freebody.questions.reading import Question
from freebody.study.answering.answer import Answer, AnswerCase
from freebody.study.answering.finding import answered
from freebody.study.answering.reactions_at_rest import range_at_rest, reaction_at_rest
from freebody.study.answering.simulated_numbers import number_with_changes
from freebody.study.phases.tree import PhaseTree
from freebody.study.phases.words import action


def in_no_case(tree: PhaseTree, question: Question, cases: Sequence[AnswerCase]) -> Answer:
    """The answer at the model's own values, which is none of the cases: what is unique at rest, else a number, or the
    reason why there is none. The cases are told beside it."""
    resting = reaction_at_rest(tree.system, question)
    if resting is not None and isinstance(resting.expression, Expr):
        first = AnswerCase(resting.expression, resting.conditions, Message("it stays at rest"))
        return replace(resting, cases=(first, *cases))
    refuse = partial(_refuse, tree, question)
    instead = partial(number_with_changes, tree.system, question, is_single=tree.is_single)
    return replace(answered(tree.system, question, refuse, instead), cases=tuple(cases))


def _refuse(tree: PhaseTree, question: Question) -> Answer:
    span = range_at_rest(tree.system, question)
    if span is not None and isinstance(span.value, tuple):
        low, high = map(number_text, span.value)
        raise CannotAnswer(
            Message(
                "it is not unique at the given numbers, where everything stays at rest: what balances the loads there "
                "lies between {low} and {high} {unit}",
                low=low,
                high=high,
                unit=question.quantity.unit,
            )
        )
    told = Message("none of the cases holds at the given numbers")
    if own := next((node for node in tree.roots if 0 in node.sets), None):
        begins = action(own.phase)
        raise CannotAnswer(Message("{told}, where it begins so: {case}", told=told, case=begins))
    why = tree.lost.get(0, "")
    raise CannotAnswer(Message("{told}: {why}", told=told, why=why) if why else told)
