"""Whether an inequality holds for a value of a parameter, in numbers: by formulas with their conditions."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, replace
from typing import Any

from freebody.errors import CannotAnswer
from freebody.language.expression import Symbol
from freebody.language.sentences import Message
from freebody.model.elements import Parameter
from freebody.questions.base import Wanted
from freebody.questions.happening import FailsFirst, Happening
from freebody.questions.reading import Question
from freebody.questions.turned_round import REACHED, SO
from freebody.study.answering.draws import Draw
from freebody.study.answering.formula import Formula
from freebody.study.setup import Setup
from freebody.symbolic.conditions import Condition
from freebody.symbolic.ratio import Ratio

_ON = 1e-7  # of the size of its terms: a formula that vanishes at an end
_INSIDE = (0.07, 0.31, 0.5, 0.68, 0.94)  # places between two ends that are looked at
_BEYOND = (1.02, 1.5, 4.0, 30.0)  # times the last end, where there is none behind it


class NotKnown(CannotAnswer):
    """No case tells what happens for some values."""


@dataclass(frozen=True)
class End:
    """Where an interval ends: a formula, or none where the parameter itself ends. is_in: whether it belongs to it."""

    value: Ratio | None
    is_in: bool


Interval = tuple[End, End]


@dataclass(frozen=True)
class Truth:
    """A formula with what it is compared with. element: its difference from the target, which the relation is about;
    none where only its conditions matter."""

    formula: Formula
    element: Ratio | None
    relation: str

    @property
    def conditions(self) -> Sequence[Condition]:
        return self.formula.needed


class TruthInNumbers:
    """Whether something is so of one parameter, whatever else the model says."""

    def __init__(self, setup: Setup, question: Question, wanted: Wanted, formulas: Sequence[Formula]) -> None:
        self.setup, self.question, self.wanted = setup, question, wanted
        self.model, self.field = setup.model, setup.model.field
        self.parameter: Parameter = setup.system.parameters[wanted.parameter]
        self.index = self.field.index(self.model.geometry.scalar(Symbol(wanted.parameter)))
        self.left_aside: Sequence[Formula] = ()
        self.is_seen_in_numbers = False  # whether no formula said somewhere if it is so
        self.truths = [self._truth(formula) for formula in self._changing(formulas)]
        of = wanted.of  # what is to come before something else comes with it at the ends
        self.is_open = isinstance(of, FailsFirst) or (isinstance(of, Happening) and of.before is not None)

    def _truth(self, formula: Formula) -> Truth:
        if self.wanted.relation in (REACHED, SO):
            return Truth(formula, None, self.wanted.relation)
        element = self.field.lowest_terms(formula.number - self.model.geometry.scalar(self.wanted.target))
        return Truth(formula, element, self.wanted.relation)

    def _changing(self, formulas: Sequence[Formula]) -> Sequence[Formula]:
        """Of several values of one quantity those that the parameter changes, if there are some: a bead may stay at
        the bottom of a hoop at any speed, and is not asked about."""
        if not self.wanted.of.is_any_of_several:
            return formulas
        f = self.field
        changing = [x for x in formulas if isinstance(x.element, Ratio) and self.index in f.ingredients(x.element)]
        self.left_aside = [x for x in formulas if x not in changing] if changing else []
        return changing or formulas

    # -- in numbers ---------------------------------------------------------------------------
    def numbers_of(self, draw: Draw) -> dict[int, Any]:
        return self.model.samples.numbers(draw.sample(draw.start()))

    def with_value(self, numbers: Mapping[int, Any], value: float) -> dict[int, Any]:
        """All generators with a value for the parameter."""
        f = self.field
        kept = {g: v for g, v in numbers.items() if self.index not in f.generators[g].made_of}
        return f.complete({**kept, self.index: value})

    def value_of(self, x: Ratio, numbers: Mapping[int, Any]) -> tuple[float, float]:
        """An element, and the size of its terms; nan where it has no real value."""
        try:
            value = float(self.field.evaluate(x, numbers))
            total, size = self.field.numerator_and_size(x, numbers)
            # the total is added up without round-off, the value is not
            return (value, abs(value) * size / abs(total)) if total else (0.0, 0.0)
        except (KeyError, ValueError, ArithmeticError):
            return math.nan, 0.0

    def is_true(
        self, numbers: Mapping[int, Any], value: float, *, at_end: bool = False, draw: Draw | None = None
    ) -> bool:
        """Whether the inequality holds for a value of the parameter, by one of the formulas. at_end: where something
        vanishes, which then counts as zero. draw: whose numbers these are; where no formula says whether it is so, it
        is looked at in numbers. Raises NotKnown where these do not tell it either."""
        if at_end and self.is_open:
            return False
        here = self.with_value(numbers, value)
        found = [truth.formula for truth in self.truths if self.holds_for(truth, here, at_end)]
        if self.wanted.relation != SO or at_end or any(formula.says for formula in found):
            return any(formula.says for formula in found)
        if not any(formula.says is False for formula in found):
            if draw is not None and (is_so := self.seen(value, draw)) is not None:
                self.is_seen_in_numbers = True
                return is_so
            why = next((formula.why for formula in found if formula.why), "")
            told = Message("for some values of {name} it is not known what happens", name=self.parameter.name)
            raise NotKnown(Message("{told}: {why}", told=told, why=why) if why else told)
        return False

    def seen(self, value: float, draw: Draw) -> bool | None:
        """Whether it is so for a value of the parameter by the numeric route; None where that does not tell it."""
        found = next((t.formula.in_numbers for t in self.truths if t.formula.in_numbers is not None), None)
        if found is None:
            return None
        with suppress(CannotAnswer, ArithmeticError, ValueError):
            return found(draw.values | {self.parameter.name: value}) not in (None, 0.0)
        return None

    def holds_for(self, truth: Truth, here: Mapping[int, Any], at_end: bool) -> bool:
        checks = [(c.element, c.relation) for c in truth.conditions]
        checks += [] if truth.element is None else [(truth.element, truth.relation)]
        return all(self.is_so(x, relation, here, at_end) for x, relation in checks)

    def is_so(self, x: Ratio, relation: str, here: Mapping[int, Any], at_end: bool) -> bool:
        value, size = self.value_of(x, here)
        if at_end and abs(value) <= _ON * size:
            value = 0.0
        if math.isnan(value):
            return False
        return {
            ">": value > 0,
            ">=": value >= 0,
            "<": value < 0,
            "<=": value <= 0,
            "!=": value != 0,
            "=": value == 0,
        }[relation]

    def domain(self) -> tuple[float, float]:
        low = -math.inf if self.parameter.sign == "any" else 0.0
        high = math.pi / 2 if self.parameter.acute else 1.0 if self.parameter.is_share else math.inf
        return (0.0 if self.parameter.acute else low, high)

    def places_between(self, a: float, b: float) -> list[float]:
        if math.isfinite(a) and math.isfinite(b):
            return [a + share * (b - a) for share in _INSIDE]
        size = next((abs(x) for x in (a, b) if math.isfinite(x) and x), None)
        size = abs(self.parameter.value or 1.0) if size is None else size
        if math.isfinite(a):
            return [a + size * (factor - 1.0) for factor in _BEYOND]
        if math.isfinite(b):
            return [b - size * (factor - 1.0) for factor in _BEYOND]
        return [way * size * factor for way in (1, -1) for factor in _BEYOND]


def keys_of(found: Sequence[Interval]) -> list[Any]:
    return [(end.value.key() if end.value is not None else None, end.is_in) for interval in found for end in interval]


def with_ends(found: Sequence[Interval], others: Mapping[Any, Ratio]) -> list[Interval]:
    """The same with other ends for some."""

    def changed(end: End) -> End:
        return end if end.value is None else replace(end, value=others.get(end.value.key(), end.value))

    return [(changed(low), changed(high)) for low, high in found]
