"""Diagrams of answers that are functions: of the place along a rod (axial force, shear force, bending moment), of the
time, at the given numbers; with formulas at the ends of their parts where these are short.

Sign convention: as of the answer, positive upwards.
"""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import suppress
from dataclasses import replace
from functools import cached_property
from itertools import pairwise
from typing import NamedTuple

import numpy as np

from freebody.errors import CannotAnswer, ExpressionError, InputError
from freebody.language.expression import ZERO, Expr, Symbol, evaluate, free_symbols, substitute
from freebody.language.notation import Stated, to_text
from freebody.language.sentences import Message
from freebody.language.units import LENGTH
from freebody.model.noting import did_you_mean
from freebody.numeric.jets import Array
from freebody.present.charts.diagram import Mark, Stretch, below_each_other, diagram
from freebody.present.picture import label
from freebody.present.picture.arrows import shown
from freebody.present.picture.label import Label
from freebody.present.picture.picture import Picture
from freebody.questions.along_rods import functions_of
from freebody.questions.event import AnyInstant, Anywhere
from freebody.questions.reading import Question
from freebody.questions.section import rods_of
from freebody.study.answering.answer import Answer
from freebody.study.answering.forms import AnswerForm, forms_of, which_holds
from freebody.study.answering.solve import solve
from freebody.study.setup import Setup
from freebody.symbolic.tidy import tidy
from freebody.system.system import System

_N = 81  # points of a part
_ROOM = 10.0  # heights of letters that a formula may be long
_GOES_ON = 1.5  # how long a motion is drawn, by the last of its changes
_SAME = 1e-9  # of the range
_MANY = 1e4  # [N, N m] from where on it is told in kilo
_NO_VALUES = Message("the diagram needs values of all parameters")


class End(NamedTuple):
    """Of a part, by its number [SI] and its formula, which none has where a drawing ends and nothing changes."""

    place: float
    formula: Expr | None


class Part(NamedTuple):
    """Of what is drawn, between two ends, with the formula that holds there."""

    form: AnswerForm
    begin: End
    end: End


def diagrams_along(system: System, rod: str) -> Picture:
    """Axial force, shear force and bending moment of a rod below each other, without those that vanish everywhere.
    Raises InputError where there is no such rod, CannotAnswer where nothing is transmitted or where it is not known."""
    rods = rods_of(system.names)
    if rod not in rods:
        raise InputError(Message("there is no rod {name}.{hint}", name=rod, hint=did_you_mean(rod, rods)))
    asked = system.asked(*functions_of(system.names, rod))
    answers = solve(replace(system, questions=asked)).answers
    drawn = [diagram_of(system, q, a) for q, a in zip(asked, answers, strict=True) if a.expression != ZERO or a.cases]
    if not drawn:
        raise CannotAnswer(Message("nothing is transmitted through {rod}", rod=rod))
    return below_each_other(Message("{rod}: what is transmitted through its sections", rod=rod), drawn)


def diagram_of(system: System, question: Question, answer: Answer) -> Picture:
    """Raises CannotAnswer where the answer is no function, is 0 or has no value, or where no end is known."""
    if answer.expression is None:
        raise CannotAnswer(answer.reason)
    if not question.runs_over or isinstance(answer.expression, tuple):
        raise CannotAnswer(Message("there is a diagram of a function of a place or of the time"))
    return _Diagram(system, question, answer).drawn()


class _Diagram:
    def __init__(self, system: System, question: Question, answer: Answer) -> None:
        self.question, self.answer, self.name = question, answer, question.runs_over
        self.setup = Setup(system)
        self.parameters = {*system.parameters}
        self.known = {p.name: p.value for p in system.parameters.values() if p.value is not None}
        self.is_over_time = isinstance(question.event, AnyInstant)
        event = question.event
        self.place_unit = str(event.dimension if isinstance(event, Anywhere) else LENGTH)

    def drawn(self) -> Picture:
        parts = list(self._parts())
        stretches = [self._stretch(part) for part in parts]
        if not any(s.values.any() for s in stretches):
            raise CannotAnswer(Message("it is 0 everywhere"))
        marks = [
            Mark(part.end.place, self._label(part.end.formula, part.end.place, self.place_unit))
            for part in parts
            if part.end.formula is not None
        ]
        marks += [mark for part, s in zip(parts, stretches, strict=True) for mark in self._summits(part, s)]
        q = self.question.quantity
        of = q.named_measure[0] if q.named_measure and q.named_measure[1] == 0 else q.letter
        is_filled = not isinstance(self.question.event, Anywhere)
        return diagram(self.question.text, label.name(self.name), label.name(of), stretches, marks, is_filled=is_filled)

    def _parts(self) -> Iterator[Part]:
        """Parts with different formulas; a motion goes on for a while after its last change."""
        ends = self._ends()
        if self.is_over_time:
            ends.append(End(2.0 * ends[-1].place, None))
        found: list[Part] = []
        for begin, end in pairwise(ends):
            form = self._form_at(0.5 * (begin.place + end.place))
            if found and found[-1].form is form:
                found[-1] = found[-1]._replace(end=end)
            else:
                found.append(Part(form, begin, end))
        if self.is_over_time:
            found[-1] = found[-1]._replace(end=End(_GOES_ON * (found[-1].begin.place or found[-1].end.place), None))
        yield from found

    def _ends(self) -> list[End]:
        """Where a case begins or ends, in order. Raises CannotAnswer where there are not two."""
        every = [self.answer.conditions, *(case.conditions for case in self.answer.cases)]
        sides = [c.sides for conditions in every for c in conditions if isinstance(c, Stated) and c.sides]
        found = [End(self._number(right), right) for left, _relation, right in sides if left == Symbol(self.name)]
        if self.is_over_time:
            found = [End(0.0, ZERO), *(end for end in found if end.place > 0.0)]
        found.sort(key=lambda end: end.place)
        ends = [end for k, end in enumerate(found) if k == 0 or end.place > found[k - 1].place]
        if len(ends) < 2:
            raise CannotAnswer(Message("how far the diagram goes is not known"))
        return ends

    def _number(self, e: Expr) -> float:
        try:
            return float(evaluate(e, self.known))
        except (ExpressionError, ArithmeticError, ValueError, TypeError) as error:
            raise CannotAnswer(_NO_VALUES) from error

    def _form_at(self, place: float) -> AnswerForm:
        k = int(which_holds(self.forms, {**self.known, self.name: place}, np.ones(1, dtype=bool))[0])
        if k < 0:
            raise CannotAnswer(self._why_without_value())
        return self.forms[k]

    def _why_without_value(self) -> Message:
        """That a parameter has no value, or that it changes in the motion."""
        e = self.answer.expression
        assert isinstance(e, Expr)
        moving = sorted(free_symbols(e) - self.parameters - {self.name, "pi"})
        if not moving:
            return _NO_VALUES
        shown = ", ".join(to_text(Symbol(name)) for name in moving)
        return Message("it changes in the motion, with {names}: there is a diagram of what rests", names=shown)

    @cached_property
    def forms(self) -> tuple[AnswerForm, ...]:
        return forms_of(self.answer, 1)

    def _values(self, form: AnswerForm, places: Array) -> Array:
        """(n,)"""
        return form.parts.at({**self.known, self.name: places}, len(places))[0]

    def _stretch(self, part: Part) -> Stretch:
        places = np.linspace(part.begin.place, part.end.place, _N)
        values = self._values(part.form, places)
        if not np.isfinite(values).all():
            raise CannotAnswer(Message("it grows without bound at the end of a part"))
        first = self._value(part.form, part.begin, float(values[0]))
        last = None if part.end.formula is None else self._value(part.form, part.end, float(values[-1]))
        return Stretch(places, values, first, last)

    def _value(self, form: AnswerForm, at: End, value: float) -> Label:
        there = None if at.formula is None else substitute(form.expressions[0], {self.name: at.formula})
        return self._label(there, value, self.answer.unit)

    def _label(self, e: Expr | None, value: float, unit: str) -> Label:
        """The formula where it is short, else the number."""
        if e is not None and free_symbols(e):
            f = self.setup.model.field
            with suppress(CannotAnswer, ArithmeticError):  # what has no formula there has a number
                formula = label.formula(tidy(f.lowest_terms(f.element(self.setup.state.scalar(e)))))
                if formula.width <= _ROOM:
                    return formula
        if unit.startswith("N") and abs(value) >= _MANY:
            value, unit = value / 1e3, f"k{unit}"
        text = shown(value)
        return label.words(f"{text} {unit}" if unit not in ("", "1") else text)

    def _summits(self, part: Part, stretch: Stretch) -> Iterator[Mark]:
        """Where the value within a part is greater or less than on both sides, by its number."""
        x, y = stretch.places, stretch.values
        rise = np.diff(y)
        turns = (rise[:-1] * rise[1:] < 0) & (np.abs(rise[:-1]) + np.abs(rise[1:]) > _SAME * np.ptp(y))
        for k in np.flatnonzero(turns) + 1:
            place = _summit(x[k - 1 : k + 2], y[k - 1 : k + 2])
            value = float(self._values(part.form, np.array([place]))[0])
            yield Mark(place, self._label(None, value, self.answer.unit), value)


def _summit(places: Array, values: Array) -> float:
    """Of the parabola through three points."""
    a, b, _c = np.polyfit(places - places[1], values, 2)
    return float(places[1] - b / (2 * a))
