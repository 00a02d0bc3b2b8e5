"""What is calculated from extremes of a motion and values at its start: (greatest y) - (y at start).

Each operand is a question of its own, and the answers are calculated with, in formulas and in numbers.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Any

from freebody.errors import CannotAnswer
from freebody.language.expression import Expr, evaluate
from freebody.language.sentences import Message
from freebody.questions.arithmetic import AtStart, Functions, Joined, OfParameters, OnTheWay, refuse_vectors
from freebody.questions.reading import Question
from freebody.study.answering.answer import Answer, made, of_all
from freebody.study.setup import Setup
from freebody.symbolic.tidy import tidy
from freebody.system.system import System


def questions_in(question: Question) -> tuple[Question, ...]:
    """A question for each operand that is more than parameters."""
    alone = replace(question, options={}, key=None, event=None, transition=None)
    return tuple(
        replace(
            alone,
            id=f"{question.id} {k}",
            quantity=q.of if isinstance(q, AtStart) else q,
            at_start=isinstance(q, AtStart),
        )
        for k, q in enumerate(question.quantity.inner)
        if not isinstance(q, OfParameters)
    )


def calculated(system: System, question: Question, answers: Mapping[str, Answer]) -> Answer:
    """The answer, from those to the questions for its operands, by id. Raises CannotAnswer where one of them has no
    formula, or several."""
    parts = [answers[part.id] for part in questions_in(question)]
    for part in parts:
        if part.expression is None:
            raise CannotAnswer(part.reason or Message("there is no closed form"))
        if part.cases:
            raise CannotAnswer(Message("it depends on the case: ask for each quantity alone"))
    setup = Setup(system, 1)
    formulas = operands_of(question, [part.expression for part in parts])
    refuse_vectors(formulas)
    found = _made(question, tuple(map(setup.model.geometry.scalar, formulas)), setup.state)
    return made(
        question,
        tidy(setup.model.field.lowest_terms(setup.model.field.element(found))),
        number(setup, question, answers),
        conditions=tuple(dict.fromkeys(c for part in parts for c in part.conditions)),
        notes=tuple(dict.fromkeys(n for part in parts for n in part.notes)),
        evidence=of_all([part.evidence for part in parts]),
    )


def number(setup: Setup, question: Question, answers: Mapping[str, Answer]) -> float | None:
    """The same in numbers; None where one is missing."""
    values = [answers[part.id].value for part in questions_in(question)]
    if not setup.has_values or not all(isinstance(x, float) for x in values):
        return None
    own = setup.draws[0].values
    found = [evaluate(x, own) if isinstance(x, Expr) else x for x in operands_of(question, values)]
    return float(_made(question, tuple(found), OnTheWay()))


def _made(question: Question, values: tuple[Any, ...], of: Functions) -> Any:
    assert isinstance(question.quantity, Joined)
    return question.quantity.made_of(values, of)


def operands_of(question: Question, found: Sequence[Any]) -> tuple[Any, ...]:
    """Of all operands, in their order: what was found of them, and the formulas in the parameters."""
    rest = iter(found)
    return tuple(q.expr if isinstance(q, OfParameters) else next(rest) for q in question.quantity.inner)
