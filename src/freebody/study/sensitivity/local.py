"""The gradient of answers: how fast each changes with each parameter, exactly, in formulas and at the model's numbers.

Beside dy/dp stands the relative sensitivity p/y dy/dp: by how many per cent y changes if p changes by one.
Source: Saltelli et al., Global Sensitivity Analysis: The Primer, 2008, sec. 1.2.2.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from typing import Any

from freebody.errors import CannotAnswer, InputError
from freebody.language.expression import Expr, free_symbols
from freebody.language.notation import to_python
from freebody.language.sentences import Message
from freebody.numeric.options import SimulationOptions
from freebody.numeric.vectorised import VectorFunction
from freebody.present.lines import number_text
from freebody.present.report.blocks import Block, Equation, Equations, Formula, Report, Section
from freebody.present.report.result import Result
from freebody.present.report.results import entries, entry, line, question_title, summary, table
from freebody.study.given import each
from freebody.study.sensitivity.derivatives import AnswerGradient, Derivative
from freebody.study.sensitivity.motions import of_motion
from freebody.study.sweeps.answers import AnswerEvaluator
from freebody.study.sweeps.sweep import questions_asked
from freebody.study.sweeps.varied import Varied, varied
from freebody.study.worded import in_words
from freebody.symbolic.gradients import derivative
from freebody.system.system import System


@dataclass(frozen=True)
class Gradient(Result):
    """Of all that was asked."""

    system: System
    answers: tuple[AnswerGradient, ...]

    def __getitem__(self, name: str) -> dict[str, float | None]:
        """The derivatives of an answer at the model's numbers, by name."""
        for answer in self.answers:
            if answer.name == name:
                return {d.by: d.value for d in answer.derivatives}
        raise KeyError(f"there is no {name}; there are {', '.join(a.name for a in self.answers)}")

    @property
    def is_complete(self) -> bool:
        return all(not a.why and all(not d.why for d in a.derivatives) for a in self.answers)

    def to_plain(self) -> dict[str, Any]:
        """Plain data: answers with value, formula and derivatives."""
        return {"title": self.system.title, "answers": [_plain(a) for a in self.answers]}

    @property
    def report(self) -> Report:
        return summary(self.system.title, self.blocks())

    def blocks(self) -> Iterator[Block]:
        """A section for each answer: the derivatives, and a table of them in numbers."""
        for a in self.answers:
            if a.why:
                yield Section(question_title(a.name, a.question), (line(a.why),))
                continue
            lines = [Equation(Formula((d.expression,)), label=f"d/d {d.by}") for d in a.derivatives if d.expression]
            rows = [
                [d.by, _told(d.value), d.unit, _told(d.relative), d.why]
                for d in sorted(a.derivatives, key=lambda d: -round(abs(d.relative or 0.0), 9))
            ]
            head = [Message("by"), Message("derivative"), Message("unit"), Message("% for 1 %"), ""]
            shown = f"{_told(a.value)} {a.unit}".strip() if a.formula is None and a.value is not None else ""
            blocks = [
                *entries(*([entry(Message("value"), shown)] if shown else [])),
                *([Equations(tuple(lines))] if lines else []),
                *table(rows, head),
            ]
            yield Section(question_title(a.name, a.question), tuple(blocks))


def _told(x: float | None) -> str:
    return "" if x is None else number_text(x)


def _plain(a: AnswerGradient) -> dict[str, Any]:
    return {
        "id": a.name,
        "question": a.question,
        "formula": None if a.formula is None else to_python(a.formula),
        "conditions": list(a.conditions),
        "value": a.value,
        "reason": a.why or None,
        "derivatives": {
            d.by: {
                "expression": None if d.expression is None else to_python(d.expression),
                "value": d.value,
                "relative": d.relative,
                "unit": d.unit,
                "reason": d.why or None,
            }
            for d in a.derivatives
        },
    }


@in_words
def gradient(
    system: System,
    find: str | Sequence[str] = (),
    by: str | Sequence[str] = (),
    *,
    record: str | Sequence[str] = (),
    until: float | None = None,
    options: SimulationOptions | None = None,
    **given: Any,
) -> Gradient:
    """The derivatives of answers, and of what is recorded of a motion, by parameters and start values.

    find: questions, by id or in words, else, where nothing is recorded, all of the model; by: names, else all
    parameters in a formula; record: of the motion up to `until` [s], as of `sweep`; options, given: how it is followed.
    Raises InputError for what cannot be read, CannotAnswer where there is no motion. Where no formula is known to hold
    at the model's numbers, or something has no derivative, it says so."""
    find, by, record = each(find), each(by), each(record)
    questions = [] if record and not find else questions_asked(system, find)
    if record and until is None:
        raise InputError(Message("how long is the motion? Say until when it is followed, as --until '5 s'"))
    if not questions and not record:
        raise InputError(Message("nothing is asked: the model has no questions; say what to find or to record"))
    found: list[AnswerGradient] = []
    if questions:
        seen, names = varied(system, list(by))
        found += [a for q in questions for a in _of_answer(AnswerEvaluator(seen, q), names, is_open=not by)]
    if record and until is not None:
        followed = replace(options or SimulationOptions(), **given)
        found += of_motion(system, record, by, until, followed)
    return Gradient(system, tuple(found))


def _of_answer(answer: AnswerEvaluator, names: Sequence[Varied], *, is_open: bool) -> Iterator[AnswerGradient]:
    form = answer.form_at_own
    for k, column in enumerate(answer.columns):
        if form is None:
            why = answer.reason or Message("no formula is known to hold at the numbers of the model")
            yield AnswerGradient(column.name, column.long_name, None, (), None, (), why)
            continue
        formula = form.expressions[k]
        value = _number(formula, answer.own)
        inside = [p for p in answer.system.parameters.values() if p.name in free_symbols(formula) and p.form is None]
        chosen = [Varied(p.name, p.name, p.dimension, p.is_angle) for p in inside] if is_open else names
        derivatives = tuple(_derivative(answer, formula, value, of) for of in chosen)
        yield AnswerGradient(column.name, column.long_name, formula, form.said, value, derivatives)


def _derivative(answer: AnswerEvaluator, formula: Expr, value: float | None, of: Varied) -> Derivative:
    unit = str(answer.question.quantity.dimension / of.dimension)
    try:
        found = derivative(formula, of.parameter, answer.system.parameters)
    except CannotAnswer as error:
        return Derivative(of.name, None, None, None, unit, str(error))
    slope, size = _number(found, answer.own), answer.own.get(of.parameter)
    relative = None if slope is None or size is None or not value else slope * size / value
    return Derivative(of.name, found, slope, relative, unit)


def _number(expr: Expr, values: dict[str, float]) -> float | None:
    function = VectorFunction([expr])
    if not function.names <= values.keys():
        return None
    x = float(function.at(values, 1)[0][0])
    return x if math.isfinite(x) else None
