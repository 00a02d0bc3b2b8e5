"""What is calculated from extremes of a motion and values at its start: each of them is derived, then put together."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Any

from freebody.errors import CannotAnswer
from freebody.language.expression import Expr, Symbol
from freebody.language.sentences import Message
from freebody.narrative.context import Context, Method
from freebody.narrative.kinds import derivation_of
from freebody.narrative.lines.naming import asked_name
from freebody.narrative.lines.script import DerivationStage, NumberedFormula, Script
from freebody.questions.arithmetic import Joined
from freebody.questions.reading import Question
from freebody.study.answering.answer import Answer
from freebody.study.answering.of_answers import AsWritten, operands_of, questions_in
from freebody.study.answering.solve import solve


def derive_calculated(context: Context, question: Question, answer: Answer, method: Method) -> list[DerivationStage]:
    """One derivation after the other, of the values at the start those alone that the file does not say. Raises
    CannotAnswer where one of them has none."""
    if question.quantity.continues_impacts:
        raise CannotAnswer(
            Message("the formula in n continues those of the first impacts: ask for one of these to see it derived")
        )
    stages, lines, found = list[DerivationStage](), list[int](), list[Expr]()
    first = context.next_number
    for k, part in enumerate(questions_in(question), 1):
        part = replace(part, id=f"Q_{k}", text=question.text)
        (given,) = solve(replace(context.system, questions=(part,)), setup=context.setup).answers
        if given.expression is None or isinstance(given.expression, tuple):
            raise CannotAnswer(given.reason or Message("there is no closed form"))
        if part.at_start and part.quantity.kinematic_order in (0, 1):
            found.append(given.expression)
            continue
        own = derivation_of(context.system, part)(context, part, given, method)
        last = _last(own)
        stages, lines = [*stages, *own], [*lines, *([last] if last else [])]
        context.next_number = max(context.next_number, last + 1)
        name = asked_name(context, part)  # as it is called there, where it has got a name
        # what is gathered up to an event has no value at the instant at which the parts are put together
        is_gathered = part.quantity.scope == "course" and not part.quantity.is_of_event
        is_named = name in context.glossary.meanings and not is_gathered
        found.append(Symbol(name) if is_named else given.expression)
    script = Script(context.glossary, context.next_number)
    context.next_number = first
    with script.stage("stage.value"):
        assert isinstance(question.quantity, Joined)
        left: Any = question.quantity.made_of(operands_of(question, found), AsWritten())
        assert answer.expression is not None
        script.line(left, answer.expression, why="turned.together", args={"lines": tuple(lines)}, when="start")
    return [*stages, *script.stages]


def _last(stages: Sequence[DerivationStage]) -> int:
    return max((i.number for stage in stages for i in stage.items if isinstance(i, NumberedFormula)), default=0)
