"""Whether something happens in a motion: what decides it, the event where it comes, friction where nothing slips."""

from __future__ import annotations

from dataclasses import replace

from freebody.errors import CannotAnswer
from freebody.language.sentences import Message
from freebody.narrative.context import Context, Method
from freebody.narrative.lines.script import DerivationStage, NumberedFormula
from freebody.narrative.questions.happening import stages_of
from freebody.questions.course import Transition
from freebody.questions.happening import Lasting
from freebody.questions.reading import Question
from freebody.questions.whether import Whether
from freebody.study.answering.answer import Answer


def derive(context: Context, question: Question, answer: Answer, method: Method) -> list[DerivationStage]:
    """Raises CannotAnswer where what decides has no derivation."""
    assert isinstance(question.quantity, Whether)
    if answer.expression is None:
        raise CannotAnswer(answer.reason or Message("there is no closed form"))
    of = question.quantity.of
    try:
        stages = stages_of(context, question, of, method)
    except CannotAnswer:  # what slips at the given numbers shows no friction that holds
        if not isinstance(of.what, Lasting) or of.what.kind != "rolls":
            raise
        slips = Transition("slips", of.what.of, of.what.text)
        stages = stages_of(context, question, replace(of, what=slips, is_so=True), method)
    return [stage for stage in stages if not _comes_at_once(stage)]


def _comes_at_once(stage: DerivationStage) -> bool:
    """Whether a stage says no more than that an event comes at the start: its conditions say when it does."""
    formulas = [item for item in stage.items if isinstance(item, NumberedFormula)]
    return any(item.why is not None and item.why.key.endswith("at_once") for item in formulas)
