"""What a blow or an impact does to a quantity: its value just after, its value just before, and how they differ."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from freebody.errors import CannotAnswer
from freebody.language.expression import ZERO, Expr, add, negate
from freebody.language.sentences import Message
from freebody.narrative.context import Context, Method, refuse
from freebody.narrative.kinds import derivation_of
from freebody.narrative.lines.script import DerivationStage, NumberedFormula, Script
from freebody.questions.conservation import ConservedInBlow
from freebody.questions.reading import Question
from freebody.study.answering.answer import Answer
from freebody.study.answering.jumps import before_start, sides_of
from freebody.study.answering.solve import solve


def derive(context: Context, question: Question, answer: Answer, method: Method) -> list[DerivationStage]:
    """Both sides, one after the other, and the change. Raises CannotAnswer where one of them has no derivation."""
    refuse(method, (), Message("what a blow does"))
    if answer.expression is None:
        raise CannotAnswer(answer.reason or Message("there is no closed form"))
    own = question.quantity.jump
    assert isinstance(question.quantity, ConservedInBlow)
    assert own is not None
    before, after = (
        replace(q, id=f"Q_{side}", text=f"{question.quantity.name} just {side} the blow")
        for q, side in zip(sides_of(question), ("before", "after"), strict=True)
    )
    is_of_start = context.system.is_struck and not {b.name for b in context.system.blows} & {*own[1]}
    early = context
    if is_of_start:
        before, after = (replace(q, transition=None, at_start=True) for q in (before, after))
        early = Context(before_start(context.system), context.next_number, context.introduced)
    stages, first = _side(early, before, method)
    context.next_number = max(context.next_number, _last(stages) + 1)
    more, second = _side(context, after, method)
    script = Script(context.glossary, max(context.next_number - 1, _last(more)) + 1)
    with script.stage("stage.change", "hint.change"):
        lines = tuple(n for n in (_last(stages), _last(more)) if n)
        left = tuple(add(b, negate(a)) for a, b in zip(_parts(first), _parts(second), strict=True))
        right = answer.expression
        is_one = not isinstance(right, tuple)
        script.line(left[0] if is_one else left, right, why="impact.change", args={"lines": lines}, when="never")
        if own[0].is_momentum_of_all:
            is_kept = all(part == ZERO for part in (right if isinstance(right, tuple) else (right,)))
            script.say("impact.kept" if is_kept else "impact.not_kept")
    return [*stages, *more, *script.stages]


def _side(context: Context, question: Question, method: Method) -> tuple[list[DerivationStage], Answer]:
    """The derivation of one side, with its answer."""
    (given,) = solve(replace(context.system, questions=(question,))).answers
    if given.expression is None:
        raise CannotAnswer(given.reason or Message("there is no closed form"))
    return derivation_of(context.system, question)(context, question, given, method), given


def _parts(answer: Answer) -> tuple[Expr, ...]:
    assert answer.expression is not None
    return answer.expression if isinstance(answer.expression, tuple) else (answer.expression,)


def _last(stages: Sequence[DerivationStage]) -> int:
    numbers = [item.number for stage in stages for item in stage.items if isinstance(item, NumberedFormula)]
    return max(numbers, default=0)
