"""A section of a rod on whose sides the given numbers tell what acts: cut as it lies there."""

from __future__ import annotations

from dataclasses import replace

from freebody.narrative.context import Context, Method
from freebody.narrative.kinds import derivation_of
from freebody.narrative.lines.script import DerivationStage
from freebody.narrative.questions import course, instant
from freebody.questions.reading import Question
from freebody.questions.section import SectionForce
from freebody.study.answering.answer import Answer
from freebody.study.answering.section import placed


def derive(context: Context, question: Question, answer: Answer, method: Method) -> list[DerivationStage]:
    """The derivation of the section as it lies; where no numbers tell that, as lengths do by themselves."""
    setup, q = context.setup, question.quantity
    assert isinstance(q, SectionForce)
    state = setup.start_for(q) if question.at_start else setup.state
    cut = placed(setup, q, state).section
    if cut.order:
        asked = replace(question, quantity=cut)
        return derivation_of(context.system, asked)(context, asked, answer, method)
    return (instant if question.event is None else course).derive(context, question, answer, method)
