"""What is calculated from extremes of a motion and values at its start: (greatest y) - (y at start); or at its events.

Each operand is a question of its own, and the answers are calculated with, in formulas and in numbers.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from typing import Any

from freebody.errors import CannotAnswer
from freebody.language.expression import Call, Expr, Number, evaluate, n_operations
from freebody.language.sentences import Message
from freebody.questions.arithmetic import AtStart, Functions, Joined, OfParameters, OnTheWay, refuse_vectors
from freebody.questions.at_events import AtEvent
from freebody.questions.base import Quantity
from freebody.questions.reading import Question
from freebody.study.answering.answer import Answer, made, of_all
from freebody.study.answering.draws import Draw
from freebody.study.answering.finding import Finding
from freebody.study.answering.scope import is_scope
from freebody.study.setup import Setup
from freebody.symbolic.conditions import Condition
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.tidy import tidy
from freebody.system.system import System


def questions_in(question: Question) -> tuple[Question, ...]:
    """A question for each operand that is more than parameters; one of a motion up to an event is asked up to it."""
    alone = replace(question, options={}, key=None, at_start=False)
    asked: list[Question] = []
    for k, q in enumerate(question.quantity.inner):
        part = replace(alone, id=f"{question.id} {k}", quantity=q)
        if isinstance(q, AtEvent):
            part = replace(part, quantity=q.of, event=q.event, at_start=q.at_start, transition=q.transition)
        elif isinstance(q, AtStart):
            part = replace(part, quantity=q.of, event=None, at_start=True, transition=None)
        if not isinstance(q, OfParameters):
            asked.append(part)
    return tuple(asked)


def calculated(system: System, question: Question, answers: Mapping[str, Answer]) -> Answer:
    """The answer, from those to the questions for its operands, by id. Raises CannotAnswer where one of them has no
    formula, or several."""
    parts = [answers[part.id] for part in questions_in(question)]
    for part in parts:
        if part.expression is None:
            raise CannotAnswer(part.reason or Message("there is no closed form"))
        if part.cases and not isinstance(part.value, float):  # which case is meant only numbers tell
            raise CannotAnswer(Message("it depends on the case: ask for each quantity alone"))
    setup = Setup(system, 1)
    formulas = operands_of(question, [part.expression for part in parts])
    refuse_vectors(formulas)
    found = _made(question, tuple(map(setup.model.geometry.scalar, formulas)), setup.state)
    whole = tidy(setup.model.field.lowest_terms(setup.model.field.element(found)))
    written = _made(question, formulas, AsWritten())
    assert isinstance(question.quantity, Joined)
    value = number(setup, question, answers)
    forms = [whole, written, *_root_of(setup, setup.model.field.element(found * found), value)]
    return made(
        question,
        question.quantity.written(min(forms, key=n_operations)),  # over one denominator roots become long
        value,
        conditions=_together(parts),
        notes=tuple(dict.fromkeys([*(n for part in parts for n in part.notes), *_other_cases(parts)])),
        evidence=of_all([part.evidence for part in parts]),
    )


def _root_of(setup: Setup, square: Ratio, value: float | None) -> list[Expr]:
    """What has the same square for all parameters, a number, is its root: 2 sqrt(L)/sqrt(2 L) is sqrt(2). It has one
    sign, as it is nowhere zero; none where that is not known."""
    number = setup.model.field.lowest_terms(square).fraction()
    if number is None or not value:
        return []
    root = tidy(setup.model.field.element(setup.state.sqrt(setup.model.geometry.scalar(Number(number)))))
    return [root if value > 0 else -root]


def _together(parts: Sequence[Answer]) -> tuple[str, ...]:
    """The conditions of all; that one holds for all parameters says nothing beside those of another."""
    all_ = tuple(dict.fromkeys(c for part in parts for c in part.conditions))
    return tuple(c for c in all_ if not is_scope(c)) or all_


def _other_cases(parts: Sequence[Answer]) -> list[str]:
    """That an operand has other formulas in other cases than that of the model's own numbers."""
    told = Message("this is the case of the given numbers; for other cases ask for each quantity alone")
    return [told] if any(part.cases for part in parts) else []


class AsWritten:
    """Functions of formulas as they are written."""

    def sqrt(self, x: Any) -> Expr:
        return Call("sqrt", x)

    def absolute(self, x: Any) -> Expr:
        return Call("abs", x)

    def function(self, name: str, x: Any) -> Expr:
        return Call(name, x)

    def direction(self, y: Any, x: Any) -> Expr:
        return 2 * Call("atan", y / (Call("sqrt", x * x + y * y) + x))


Found = Callable[[Question], tuple[Finding, list[Condition]]]


def found_of(setup: Setup, question: Question, found: Found) -> Finding:
    """A formula to go on with, from what is found for each operand and the conditions of it. Raises CannotAnswer."""
    parts = [found(part) for part in questions_in(question)]
    formulas = operands_of(question, [finding.element for finding, _needed in parts])
    f, geometry = setup.model.field, setup.model.geometry
    values = tuple(x if isinstance(x, Ratio) else geometry.scalar(x) for x in formulas)
    refuse_vectors(values)
    needed: list[Condition] = []
    for _finding, conditions in parts:
        needed += [c for c in conditions if c not in needed]
    notes = list(dict.fromkeys(note for finding, _needed in parts for note in finding.notes))
    says = list(dict.fromkeys(said for finding, _needed in parts for said in finding.says))
    evidence = of_all([finding.evidence for finding, _needed in parts])
    assert evidence is not None
    x = f.lowest_terms(f.element(_made(question, values, setup.state)))
    return Finding(x, evidence, needed, notes, says, is_complete=True)


def number_at_draw(q: Quantity, draw: Draw, of: Callable[[Quantity], Any]) -> Any:
    """The same by the numeric route, at the numbers of a draw."""
    assert isinstance(q, Joined)
    values = [evaluate(p.expr, draw.values) if isinstance(p, OfParameters) else of(p) for p in q.inner]
    refuse_vectors(tuple(values))
    return q.made_of(tuple(values), OnTheWay())


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
