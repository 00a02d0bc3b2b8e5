"""Answers of `solve` in many cases: the closed form of the case that holds, compiled to a function of arrays.

An answer is a formula under conditions, or a case distinction of them. What the conditions say of a case decides which
formula is used; where none is known to hold, the numeric route answers (numbers), and where it has none either, the
case is outside of what the answer knows.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from freebody.errors import CannotAnswer, FreebodyError
from freebody.language.notation import to_python
from freebody.language.sentences import Message, further
from freebody.numeric.jets import Array
from freebody.numeric.vectorised import VectorFunction
from freebody.questions.reading import Question
from freebody.study.answering.answer import Answer, Value, refused
from freebody.study.answering.forms import AnswerForm, forms_of, which_holds
from freebody.study.answering.numbers import number_instead
from freebody.study.answering.simulated_numbers import number_with_changes
from freebody.study.answering.solve import solve
from freebody.study.setup import Setup
from freebody.study.simulation.simulator import has_phases
from freebody.study.sweeps.evaluators import Codes, Column, Evaluator, Found, Values
from freebody.study.sweeps.statuses import (
    CODES,
    FORMULA,
    NO_VALUE,
    NOT_ADMISSIBLE,
    NOT_ASSEMBLED,
    NOT_DONE,
    NUMBERS,
    OUTSIDE,
)
from freebody.study.sweeps.varied import with_values
from freebody.study.worded import FAILED
from freebody.symbolic.gradients import derivative
from freebody.system.system import System


class AnswerEvaluator(Evaluator):
    """One question in every case. A quantity of an instant that is not said is meant at the start."""

    def __init__(self, system: System, question: Question, read: System | None = None) -> None:
        super().__init__(system, read)
        q = question.quantity
        is_open = q.is_of_state and question.event is None and question.transition is None and q.wanted is None
        self.question = replace(question, options={}, key=None, at_start=question.at_start or is_open)
        self.name = question.id
        answer = self._answered()
        n = _n_parts(answer)
        unit, text = answer.unit, question.text
        axes = "xyz" if n == (3 if system.space else 2) and not q.is_any_of_several else "123456789"
        labels = [""] if n == 1 else [f".{axes[k]}" if n <= len(axes) else f".{k + 1}" for k in range(n)]
        self.columns = tuple(Column(f"{self.name}{label}", unit, text) for label in labels)
        start = system.start if self.question.at_start else {}
        self.forms = forms_of(answer, n, start)
        self.reason = answer.reason or answer.why_no_value
        self._derivatives: dict[tuple[int, str], VectorFunction | None] = {}

    def _answered(self) -> Answer:
        try:
            return solve(replace(self.system, questions=(self.question,))).answers[0]
        except FreebodyError as error:
            return refused(self.question, str(error))

    # -- many cases ---------------------------------------------------------------------------
    def together(self, values: Mapping[str, Array], n: int) -> tuple[Array, Codes]:
        numbers, codes = super().together(values, n)
        which = self._which(values, n, codes)
        known = {**self.own, **values}
        for k, form in enumerate(self.forms):
            holds = which == k
            if holds.any():
                numbers[holds] = np.column_stack(form.parts.at(known, n))[holds]
                codes[holds] = CODES[FORMULA]
        return numbers, codes

    def _which(self, values: Mapping[str, Array], n: int, codes: Codes) -> NDArray[np.int64]:
        """(n,) the first formula that is known to hold and has a value, -1 for none."""
        return which_holds(self.forms, {**self.own, **values}, codes == CODES[NOT_DONE])

    def slopes(self, values: Mapping[str, Array], n: int, by: Sequence[str]) -> Array:
        """(n, n_columns, n_by) exact derivatives by parameters, of the formula that holds; NaN where there is none."""
        _numbers, codes = super().together(values, n)
        which, known = self._which(values, n, codes), {**self.own, **values}
        found = np.full((n, len(self.columns), len(by)), np.nan)
        for k in np.unique(which[which >= 0]):
            holds = which == k
            for j, name in enumerate(by):
                if (slope := self._derivative(int(k), name)) is not None:
                    found[holds, :, j] = np.column_stack(slope.at(known, n))[holds]
        return found

    def _derivative(self, k: int, by: str) -> VectorFunction | None:
        if (k, by) not in self._derivatives:
            try:
                parts = [derivative(e, by, self.system.parameters) for e in self.forms[k].expressions]
                self._derivatives[k, by] = VectorFunction(parts)
            except CannotAnswer:
                self._derivatives[k, by] = None
        return self._derivatives[k, by]

    def kinds(self, values: Mapping[str, Array], n: int) -> tuple[NDArray[np.int64], list[str]]:
        if len(self.forms) < 2:
            return super().kinds(values, n)
        _numbers, codes = super().together(values, n)
        words = [", ".join(form.said) or to_python(form.expressions[0]) for form in self.forms]
        return self._which(values, n, codes), words

    @property
    def form_at_own(self) -> AnswerForm | None:
        """The formula that is known to hold at the model's own numbers; that of the answer where it has none."""
        if not self.forms:
            return None
        needed = set[str]().union(*(form.parts.names for form in self.forms))
        if not needed <= self.own.keys():
            return self.forms[0]
        codes = np.full(1, CODES[NOT_DONE], dtype=np.int8)
        k = int(self._which({}, 1, codes)[0])
        return None if k < 0 else self.forms[k]

    @property
    def own(self) -> dict[str, float]:
        """The parameters' own values, at the start where they are functions of time."""
        return {p.name: p.value for p in self.system.parameters.values() if p.value is not None}

    # -- one case -----------------------------------------------------------------------------
    def alone(self, values: Values) -> Found:
        """By the numeric route, where no formula is known to hold."""
        nothing = (math.nan,) * len(self.columns)
        if why := self.refused(values):
            return Found(nothing, NOT_ADMISSIBLE, why)
        system = with_values(self.system, values)
        try:
            found = self._number(system)
        except _NotAssembled as error:
            return Found(nothing, NOT_ASSEMBLED, str(error))
        except (FreebodyError, ValueError, *FAILED) as error:
            broken = self._broken(values)
            return Found(nothing, OUTSIDE if broken else NO_VALUE, further(*broken, str(error)))
        parts = found if isinstance(found, tuple) else () if found is None else (found,)
        if len(parts) != len(self.columns) or not all(map(math.isfinite, parts)):
            broken = self._broken(values)
            return Found(nothing, OUTSIDE if broken else NO_VALUE, further(*(broken or [self._reason()])))
        return Found(tuple(map(float, parts)), NUMBERS)

    def _reason(self) -> str:
        return self.reason or Message("the numeric route has no number for it")

    def _number(self, system: System) -> Value:
        """The question by the numeric route. Raises CannotAnswer where it has no number."""
        if has_phases(system):
            try:
                return number_with_changes(system, self.question)
            except CannotAnswer:
                _assembled(system)
                raise
        setup = _assembled(system)
        return number_instead(setup, self.question)

    def _broken(self, values: Values) -> list[str]:
        """Conditions of the answer that are not true of a case."""
        known = {**self.own, **values}
        told = [text for form in self.forms for text in form.broken(known)]
        return [Message("{condition} is not true there", condition=text) for text in dict.fromkeys(told)]

    def described(self) -> dict[str, object]:
        """The formulas and their conditions beside the units."""
        forms = [
            {"expression": [to_python(e) for e in form.expressions], "conditions": list(form.said)}
            for form in self.forms
        ]
        return {name: {**about, "forms": forms} for name, about in super().described().items()}


def _n_parts(answer: Answer) -> int:
    for shown in (answer.expression, answer.value):
        if shown is not None:
            return len(shown) if isinstance(shown, tuple) else 1
    return 1


class _NotAssembled(CannotAnswer):
    """The start contradicts itself at these numbers."""


def _assembled(system: System) -> Setup:
    try:
        return Setup(system, 1)
    except FreebodyError as error:
        raise _NotAssembled(str(error)) from error
