"""What is calculated from extremes of a motion and values at its start: each of them is derived, then put together."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Any, cast

from freebody.errors import CannotAnswer
from freebody.language.expression import Expr, Symbol
from freebody.language.sentences import Argument, Message
from freebody.narrative.context import Context, Method
from freebody.narrative.kinds import derivation_of
from freebody.narrative.lines.naming import asked_name, asked_symbol
from freebody.narrative.lines.script import DerivationStage, NumberedFormula, Script
from freebody.narrative.sharing import lines_of, result_line
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
    stages, lines, found, names = list[DerivationStage](), list[int](), list[Expr](), list[Expr]()
    first = context.next_number
    for k, part in enumerate(questions_in(question), 1):
        part = replace(part, id=f"Q_{k}", text=question.text)
        (given,) = solve(replace(context.system, questions=(part,)), setup=context.setup).answers
        if given.expression is None or isinstance(given.expression, tuple):
            raise CannotAnswer(given.reason or Message("there is no closed form"))
        if part.at_start and part.quantity.kinematic_order in (0, 1):
            found.append(given.expression)
            names.append(given.expression)
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
        ends = result_line(own)
        is_told = ends is not None and ends.sides[-1] == given.expression
        names.append(cast("Expr", ends.sides[0]) if ends is not None and is_told else found[-1])
    script = Script(context.glossary, context.next_number)
    context.next_number = first
    with script.stage("stage.value"):
        assert isinstance(question.quantity, Joined)
        left: Any = question.quantity.made_of(operands_of(question, found), AsWritten())
        assert answer.expression is not None
        uses = tuple(lines)
        args: dict[str, Argument] = {"lines": uses}
        script.line(left, answer.expression, why="turned.together", args=args, uses=uses, when="start")
    by_names: Any = question.quantity.made_of(operands_of(question, names), AsWritten())
    return [*stages, *(_in_names(context, question, by_names, stage) for stage in script.stages)]


def _in_names(context: Context, question: Question, by_names: Expr, stage: DerivationStage) -> DerivationStage:
    """The last line, which has been checked with the values of the parts put in, by their names: v = s/t = v0/2."""
    (line,) = lines_of([stage])
    sides = (asked_symbol(context, question), by_names, line.sides[-1])
    named = replace(line, sides=sides, relations=("=", "="))
    return replace(stage, items=tuple(named if item is line else item for item in stage.items))


def _last(stages: Sequence[DerivationStage]) -> int:
    return max((i.number for stage in stages for i in stage.items if isinstance(i, NumberedFormula)), default=0)
