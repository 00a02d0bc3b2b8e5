"""Values of a parameter that are asked for: their symbols, and where they are numbers."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence

from freebody.errors import CannotAnswer
from freebody.language.expression import Expr, Symbol
from freebody.language.notation import Stated
from freebody.language.sentences import Sentence
from freebody.language.truth import is_true
from freebody.narrative.context import Context
from freebody.narrative.lines.glossary import Meaning, World
from freebody.narrative.lines.script import Legend, Script
from freebody.questions.reading import Question
from freebody.study.answering.answer import Answer
from freebody.tolerances import ROUND_OFF


def has_values(world: World, values: Sequence[Expr]) -> bool:
    """Whether all values are real numbers there."""
    try:
        return all(math.isfinite(x) for value in values for x in world.of(value))
    except (CannotAnswer, ArithmeticError, ValueError):
        return False


def introduced(
    context: Context,
    script: Script,
    question: Question,
    values: Sequence[Expr],
    reader: Callable[[Expr], Callable[[World], float]],
) -> list[Symbol]:
    """Symbols for the values that are asked for. reader: how the numeric route finds one."""
    quantity = question.quantity.wanted
    assert quantity is not None
    ends = [""] if len(values) == 1 else [str(k + 1) for k in range(len(values))]
    names = [context.symbol(f"{quantity.parameter}_req{end}", f"{quantity.parameter}_asked{end}") for end in ends]
    what = Sentence("symbol.asked")
    for name, value in zip(names, values, strict=True):
        script.glossary.redefine(Meaning(name, what, reader(value), question.quantity.unit))
        script.add(Legend(((name, what, question.quantity.unit),)))
    return names


def answer_holds(world: World, answer: Answer) -> bool:
    """Whether the answer is the one there: elsewhere another one is, as where a contact slips."""
    stated = [condition.expression for condition in answer.conditions if isinstance(condition, Stated)]
    return all(is_true(each, world.draw.values, round_off=ROUND_OFF) is not False for each in stated)
