"""All values of a parameter for which an inequality holds: between the zeros, poles and limits of a formula.

The formula can change its side only where it vanishes, has no value, or stops being true. All these places are found in
closed form, at the model's own numbers they have an order, and between two of them one value tells. The order is a
condition of the answer; at other random numbers that keep to it the same values must come out, and inside of each
interval the quantity is compared with the numeric route.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise
from typing import Any

from freebody.errors import CannotAnswer
from freebody.language.expression import Symbol
from freebody.language.notation import compared, joined, reworded
from freebody.language.sentences import Message
from freebody.model.elements import Parameter
from freebody.numeric.reference import Reference
from freebody.questions.base import Wanted
from freebody.questions.happening import FailsFirst, Happening
from freebody.questions.reading import Question
from freebody.questions.turned_round import REACHED, SO
from freebody.study.answering.answer import Evidence
from freebody.study.answering.conditions import real
from freebody.study.answering.crosscheck import (
    INSTANT_TOLERANCE,
    MIN_DRAWS,
    MOTION_TOLERANCE,
    CrossCheck,
    TooLittleCompared,
    element_at,
)
from freebody.study.answering.draws import Draw
from freebody.study.answering.finding import Finding
from freebody.study.answering.magnitude import magnitude
from freebody.study.answering.turned_round import (
    Formula,
    NoneFound,
    PutBack,
    above,
    domain_of,
    quantity_with,
    without_roots,
)
from freebody.study.setup import Setup
from freebody.symbolic.conditions import Condition, insisted
from freebody.symbolic.field import Ratio
from freebody.symbolic.parameter_roots import solutions
from freebody.symbolic.signs import sign_of
from freebody.symbolic.tidy import tidy
from freebody.symbolic.zeros import zeros_of

_SAME = 1e-9  # of their size: two ends that are one
_ON = 1e-7  # of the size of its terms: a formula that vanishes at an end
_INSIDE = (0.07, 0.31, 0.5, 0.68, 0.94)  # places between two ends that are looked at
_BEYOND = (1.02, 1.5, 4.0, 30.0)  # times the last end, where there is none behind it
_RISING = ("asin", "atan", "log")
_MOST_SHIFTS = range(-1, 2)  # whole turns by which an angle may differ from that of a formula


@dataclass(frozen=True)
class _End:
    """Where an interval ends: a formula, or none where the parameter itself ends. is_in: whether it belongs to it."""

    value: Ratio | None
    is_in: bool


_Interval = tuple[_End, _End]


@dataclass(frozen=True)
class _Truth:
    """A formula with what it is compared with. element: its difference from the target, which the relation is about;
    none where only its conditions matter."""

    formula: Formula
    element: Ratio | None
    relation: str

    @property
    def conditions(self) -> Sequence[Condition]:
        return self.formula.needed


def find_range(setup: Setup, question: Question, formulas: Sequence[Formula]) -> Finding:
    """The ends of the values for which the question's inequality holds. Raises CannotAnswer where they have no closed
    form, NoneFound where there is no such value."""
    wanted = question.quantity.wanted
    assert wanted is not None
    return RangeSearch(setup, question, wanted, formulas).finding()


class RangeSearch:
    """Where the truth can change, and what it is in between."""

    def __init__(self, setup: Setup, question: Question, wanted: Wanted, formulas: Sequence[Formula]) -> None:
        self.setup, self.question, self.wanted = setup, question, wanted
        self.model, self.field = setup.model, setup.model.field
        self.parameter: Parameter = setup.system.parameters[wanted.parameter]
        self.index = self.field.index(self.model.geometry.scalar(Symbol(wanted.parameter)))
        self.truths = [self._truth(formula) for formula in formulas]
        self._placed: list[Ratio] = []  # all ends within the range of the parameter, where they were looked at last
        of = wanted.of  # what is to come before something else comes with it at the ends
        self.is_open = isinstance(of, FailsFirst) or (isinstance(of, Happening) and of.before is not None)

    def _truth(self, formula: Formula) -> _Truth:
        if self.wanted.relation in (REACHED, SO):
            return _Truth(formula, None, self.wanted.relation)
        if not isinstance(formula.element, Ratio):
            raise CannotAnswer(Message("one number must have a value here, and that is none in closed form"))
        element = self.field.lowest_terms(formula.element - self.model.geometry.scalar(self.wanted.target))
        return _Truth(formula, element, self.wanted.relation)

    # -- where it can change ------------------------------------------------------------------
    @cached_property
    def ends(self) -> list[Ratio]:
        """Every place at which the truth can change, as formulas."""
        found: list[Ratio] = []
        for truth in self.truths:
            elements = [c.element for c in truth.conditions]
            elements += [] if truth.element is None else [truth.element, *(c.element for c in real(truth.element))]
            for x in elements:
                for place in (*self._places(x.numerator()), *self._places(x.denominator())):
                    if all(place != other for other in found):
                        found.append(place)
        return found

    def _places(self, x: Ratio) -> Iterator[Ratio]:
        """Where an element vanishes. Raises CannotAnswer where that has no closed form."""
        f = self.field
        if self.index not in f.ingredients(x):
            return
        equation, _one_side = without_roots(x, self.index)
        for base, _exponent in f.factor(equation.num)[1]:
            if self.index not in f.ingredients(base) or _has_one_sign(base):
                continue
            places = zeros_of(self.model, base, self, quadratic=True)
            places = places or [values[self.index] for values in solutions(f, base, self.index)]
            degree = len(base.coefficients(self.index)) - 1
            made = [g for g in base.generators() if self.index in f.generators[g].made_of]
            if not places:
                zero = compared(tidy(base), "=", tidy(f.zero))
                why = Message(
                    "the equation {equation} is not solved for {name} in closed form",
                    equation=zero,
                    name=self.parameter.name,
                )
                raise CannotAnswer(reworded(why, zero))
            if not made and degree > 2:
                raise CannotAnswer(Message("the ends are roots of a polynomial of degree {n}", n=degree))
            for place in places:
                place = f.lowest_terms(place)
                if self.index in f.ingredients(place):
                    continue
                yield from self._with_turns(place) if made and self.parameter.is_angle else (place,)

    def _with_turns(self, place: Ratio) -> Iterator[Ratio]:
        yield place
        if not self.parameter.acute:
            yield from (place + n * self.field.pi for n in _MOST_SHIFTS if n)

    # -- in numbers ---------------------------------------------------------------------------
    def _numbers(self, draw: Draw) -> dict[int, Any]:
        return self.model.samples.numbers(draw.sample(draw.start()))

    def _with(self, numbers: Mapping[int, Any], value: float) -> dict[int, Any]:
        """All generators with a value for the parameter."""
        f = self.field
        kept = {g: v for g, v in numbers.items() if self.index not in f.generators[g].made_of}
        return f.complete({**kept, self.index: value})

    def _value(self, x: Ratio, numbers: Mapping[int, Any]) -> tuple[float, float]:
        """An element, and the size of its terms; nan where it has no real value."""
        try:
            value = float(self.field.evaluate(x, numbers))
            total, size = self.field.numerator_and_size(x, numbers)
            return value, abs(value) * size / abs(total) if total else 0.0
        except (KeyError, ValueError, ArithmeticError):
            return math.nan, 0.0

    def _is_true(self, numbers: Mapping[int, Any], value: float, *, at_end: bool = False) -> bool:
        """Whether the inequality holds for a value of the parameter, by one of the formulas. at_end: where something
        vanishes, which then counts as zero. Raises CannotAnswer where none of them says whether it is so."""
        if at_end and self.is_open:
            return False
        here = self._with(numbers, value)
        found = [truth.formula for truth in self.truths if self._holds(truth, here, at_end)]
        if self.wanted.relation != SO or at_end or any(formula.says for formula in found):
            return any(formula.says for formula in found)
        if not any(formula.says is False for formula in found):
            why = next((formula.why for formula in found if formula.why), "")
            told = Message("for some values of {name} it is not known what happens", name=self.parameter.name)
            raise CannotAnswer(Message("{told}: {why}", told=told, why=why) if why else told)
        return False

    def _holds(self, truth: _Truth, here: Mapping[int, Any], at_end: bool) -> bool:
        checks = [(c.element, c.relation) for c in truth.conditions]
        checks += [] if truth.element is None else [(truth.element, truth.relation)]
        return all(self._is_so(x, relation, here, at_end) for x, relation in checks)

    def _is_so(self, x: Ratio, relation: str, here: Mapping[int, Any], at_end: bool) -> bool:
        value, size = self._value(x, here)
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
        }[relation]

    def true_at(self, draw: Draw, value: float) -> list[int]:
        """The numbers of the formulas that are true, their relation aside, for a value of the parameter."""
        here = self._with(self._numbers(draw), value)
        return [
            k
            for k, truth in enumerate(self.truths)
            if all(self._is_so(c.element, c.relation, here, at_end=True) for c in truth.conditions)
        ]

    def values_at(self, draw: Draw, value: float, formulas: Sequence[Formula]) -> list[float]:
        """What formulas are worth for a value of the parameter; those that have a value."""
        here = self._with(self._numbers(draw), value)
        found = [self._value(f.element, here)[0] for f in formulas if isinstance(f.element, Ratio)]
        return [x for x in found if not math.isnan(x)]

    def values_between(self, draw: Draw, formulas: Sequence[Formula]) -> Iterator[float]:
        """What the formulas are worth that are true, at places between all ends."""
        numbers, (low, high) = self._numbers(draw), self._domain()
        placed = sorted(x for end in self.ends if low < (x := self._value(end, numbers)[0]) < high)
        for a, b in pairwise([low, *placed, high]):
            for value in self._values(a, b):
                yield from self.values_at(draw, value, [formulas[k] for k in self.true_at(draw, value)])

    # -- the intervals ------------------------------------------------------------------------
    def _domain(self) -> tuple[float, float]:
        low = -math.inf if self.parameter.sign == "any" else 0.0
        return (0.0, math.pi / 2) if self.parameter.acute else (low, math.inf)

    def intervals(self, draw: Draw) -> list[_Interval]:
        """At the numbers of a draw."""
        ends = self.ends  # first: numbers are those of all that there is by now
        numbers, (low, high) = self._numbers(draw), self._domain()
        placed: list[tuple[float, Ratio]] = []
        for end in ends:
            value, _size = self._value(end, numbers)
            is_new = all(abs(value - other) > _SAME * max(abs(value), abs(other)) for other, _e in placed)
            if math.isfinite(value) and low < value < high and is_new:
                placed.append((value, end))
        placed.sort(key=lambda pair: pair[0])
        self._placed = [end for _value, end in placed]
        values = [low, *(value for value, _end in placed), high]
        inside = [self._between(numbers, a, b) for a, b in pairwise(values)]
        is_at = [self._is_true(numbers, value, at_end=True) for value, _end in placed]
        at_low = self.parameter.sign == "nonnegative" and self._is_true(numbers, 0.0, at_end=True)
        found: list[_Interval] = []
        begun = _End(None, at_low) if inside[0] else None
        for k, (_value, end) in enumerate(placed):
            before, after = inside[k], inside[k + 1]
            if before and after and not is_at[k]:
                is_at[k] = self._is_seen(placed[k][0], draw)
            if before and begun is not None and not (after and is_at[k]):
                found.append((begun, _End(end, is_at[k])))
                begun = None
            if after and begun is None:
                begun = _End(end, is_at[k])
            elif is_at[k] and not before and not after:
                found.append((_End(end, True), _End(end, True)))
        if begun is not None:
            found.append((begun, _End(None, False)))
        return found

    def _is_seen(self, value: float, draw: Draw) -> bool:
        """Whether it is so just on the border of two cases, in both of which it is: by the numeric route."""
        if self.wanted.relation not in (REACHED, SO):
            return False
        values = draw.values | {self.parameter.name: value}
        with suppress(CannotAnswer, ArithmeticError, ValueError):
            found = [t.formula.in_numbers for t in self.truths if t.formula.in_numbers is not None][:1]
            return any(in_numbers(values) not in (None, 0.0) for in_numbers in found)
        return False

    def _between(self, numbers: Mapping[int, Any], a: float, b: float) -> bool:
        """Whether it holds between two ends. Raises CannotAnswer where it does so at some places only."""
        seen = {self._is_true(numbers, value) for value in self._values(a, b)}
        if len(seen) > 1:
            raise CannotAnswer(Message("where that holds has ends for which no closed form was found"))
        return seen.pop()

    def _values(self, a: float, b: float) -> list[float]:
        if math.isfinite(a) and math.isfinite(b):
            return [a + share * (b - a) for share in _INSIDE]
        size = next((abs(x) for x in (a, b) if math.isfinite(x) and x), None)
        size = abs(self.parameter.value or 1.0) if size is None else size
        if math.isfinite(a):
            return [a + size * (factor - 1.0) for factor in _BEYOND]
        if math.isfinite(b):
            return [b - size * (factor - 1.0) for factor in _BEYOND]
        return [way * size * factor for way in (1, -1) for factor in _BEYOND]

    # -- the answer ---------------------------------------------------------------------------
    def finding(self) -> Finding:
        own = self.setup.draws[0]
        found = self.intervals(own)
        name = self.parameter.name
        if not found:
            raise NoneFound(Message("no value of {name} within its range was found for which that is so", name=name))
        if len(found) == 1 and found[0][0].value is None and found[0][1].value is None:
            raise CannotAnswer(Message("that is so for every value of {name}", name=name))
        conditions, element, notes = self._order(found, own), self._asked(found), list[str]()
        told = joined([self._told(interval) for interval in found], " or ")
        notes.append(reworded(Message("so for {range}", range=told), told))
        if any(truth.formula.in_numbers is not None for truth in self.truths) and any(
            end.value is not None and not end.is_in for interval in found for end in interval
        ):
            notes.append(Message("the end itself is the limit between two cases, and is not decided here"))
        if self.parameter.value is not None:
            notes.append(Message("the number that the file gives for {name} is left out", name=name))
        evidence = self._evidence(found, conditions)
        return Finding(element, evidence, conditions, notes, has_value=self.setup.has_values, is_complete=True)

    def _asked(self, found: Sequence[_Interval]) -> Ratio | tuple[Ratio, ...]:
        """All ends, or the one that is asked for."""
        if self.wanted.end:
            end = found[0][0] if self.wanted.end == "least" else found[-1][1]
            if end.value is None:
                why = (
                    Message("there is no least value: it is so for all small ones")
                    if self.wanted.end == "least"
                    else Message("there is no largest value: it is so for all large ones")
                )
                raise CannotAnswer(why)
            return end.value
        ends = [end.value for interval in found for end in interval if end.value is not None]
        ends = [x for k, x in enumerate(ends) if all(x != other for other in ends[:k])]
        return ends[0] if len(ends) == 1 else tuple(ends)

    def _told(self, interval: _Interval) -> str:
        """An interval as inequalities of the parameter."""
        (low, high), name = interval, Symbol(self.parameter.name)
        if low.value is not None and high.value is not None and low.value == high.value:
            return compared(name, "=", tidy(low.value))
        sides: list[str] = []
        if low.value is not None:
            sides.append(compared(name, ">=" if low.is_in else ">", tidy(low.value)))
        if high.value is not None:
            sides.append(compared(name, "<=" if high.is_in else "<", tidy(high.value)))
        return joined(sides)

    def _order(self, found: Sequence[_Interval], own: Draw) -> list[Condition]:
        """That the ends are real, within the range of the parameter, and in this order."""
        ends = [end.value for interval in found for end in interval if end.value is not None]
        if self.wanted.of.is_verdict:  # the others have their places as well: in another order others may count
            ends = self._placed
        needs = [c for end in ends for c in real(end)]
        for end in ends[:1] + ends[-1:]:
            needs += domain_of(self.parameter, end)
        needs += [Condition(_after(a, b), ">", Message("which end is which")) for a, b in pairwise(ends) if a != b]
        numbers = self._numbers(own)
        for truth in self.truths:  # what does not depend on the parameter, and holds here
            free = [c for c in truth.conditions if self.index not in self.field.ingredients(c.element)]
            needs += [c for c in free if self._is_so(c.element, c.relation, numbers, True)]
        return insisted(needs, CannotAnswer(Message("where that holds has ends for which no closed form was found")))

    # -- evidence -----------------------------------------------------------------------------
    def _evidence(self, found: Sequence[_Interval], conditions: Sequence[Condition]) -> Evidence:
        """The quantity inside of every interval is compared with the numeric route; and at other numbers that keep to
        the conditions the same ends come out."""
        by_event = self.question.event is not None
        is_verdict = self.wanted.relation == SO
        route = (
            Message("values inside and outside of the range put in for the parameter, each looked at in numbers")
            if is_verdict
            else Message("values inside of the range put in for the parameter, each by the numeric route")
        )
        check = CrossCheck(self.question.text, route, MOTION_TOLERANCE if by_event else INSTANT_TOLERANCE)
        keys = _keys(found)

        def compare(item: tuple[int, Draw]) -> None:
            k, draw = item
            numbers = self._numbers(draw)
            if not all(self._is_so(c.element, c.relation, numbers, False) for c in conditions):
                return
            here = self.intervals(draw)
            if _keys(here) != keys:
                raise CannotAnswer(Message("which ends count depends on more than could be told in formulas"))
            for interval in here:
                for value in self._beside(interval, numbers):
                    self._compare_at(check, k, draw, value)
            if is_verdict:
                for value in self._outside(here, numbers):
                    self._compare_at(check, k, draw, value)

        if not all(truth.formula.is_put_back for truth in self.truths):
            return self._evidence_of_formulas()
        enough = 2 * MIN_DRAWS if is_verdict else MIN_DRAWS
        return check.gather(enumerate(self.setup.draw_stream()), compare, enough).evidence()

    def _evidence_of_formulas(self) -> Evidence:
        """Beside an event of contacts, which the numeric route finds in its own way, the formulas of the cases are what
        it is compared with, at numbers of their own. Raises TooLittleCompared where that was possible for none."""
        found: list[Evidence] = []
        missed: TooLittleCompared | None = None
        for truth in self.truths:
            try:
                found.append(truth.formula.evidence())
            except TooLittleCompared as error:
                missed = missed or error
        if not found:
            raise missed or TooLittleCompared(Message("the quantity could not be compared with the numeric route"))
        worst = max(e.worst_relative_difference for e in found)
        return Evidence(sum(e.draws for e in found), worst, found[0].route)

    def _beside(self, interval: _Interval, numbers: Mapping[int, Any]) -> Iterator[float]:
        low, high = self._domain()
        values = [low if interval[0].value is None else self._value(interval[0].value, numbers)[0]]
        values.append(high if interval[1].value is None else self._value(interval[1].value, numbers)[0])
        if values[0] < values[1]:
            yield self._values(*values)[1]

    def _outside(self, found: Sequence[_Interval], numbers: Mapping[int, Any]) -> Iterator[float]:
        """A value in every gap between the intervals."""
        low, high = self._domain()
        ends = [end.value for interval in found for end in interval]
        values = [None if end is None else self._value(end, numbers)[0] for end in ends]
        borders = [low, *(x for x in values if x is not None), high]
        if ends[0] is None:
            borders = borders[1:]
        if ends[-1] is None:
            borders = borders[:-1]
        for a, b in zip(borders[::2], borders[1::2], strict=True):
            if a < b:
                yield self._values(a, b)[-2 if math.isfinite(a) else 1]

    def _compare_at(self, check: CrossCheck, number: int, draw: Draw, value: float) -> None:
        values = draw.values | {self.parameter.name: value}
        numbers = self._with(self._numbers(draw), value)
        said = [t for t in self.truths if t.formula.says is not None and self._holds(t, numbers, False)]
        truth = max(said, key=lambda t: t.formula.says is True, default=None)
        if truth is None:
            return
        if self.wanted.relation == SO:
            assert truth.formula.in_numbers is not None
            with suppress(CannotAnswer):
                check.compare(draw, 1.0 if truth.formula.says else 0.0, truth.formula.in_numbers(values))
            return
        reference = Reference(self.setup.system, values)
        made = PutBack(number, Draw(values, reference, reference.assemble(guess=draw.q, n_starts=2)), 1.0)
        numeric = quantity_with(self.setup, self.question, self.wanted.of, truth.formula, made)
        if self.wanted.of.is_verdict:
            check.compare(made.draw, 1.0, numeric)
            return
        if truth.element is None:  # the event comes there as well
            check.compare(made.draw, (1.0,), 1.0)
            return
        assert isinstance(truth.formula.element, Ratio)
        exact = element_at(self.setup, truth.formula.element, made.draw, made.draw.start())
        seen = made.draw.seen(made.draw.start())
        check.compare(made.draw, exact, numeric, lambda: magnitude(self.wanted.of.dimension, seen))


def _after(a: Ratio, b: Ratio) -> Ratio:
    """What has the sign of b - a: of two arcs the difference of what they are arcs of."""
    f = a.field
    arcs = [
        next((f.arguments[g] for g in x.generators() if g in f.arguments and x == f.variable(g)), None) for x in (a, b)
    ]
    if arcs[0] is not None and arcs[1] is not None and arcs[0][0] == arcs[1][0] and arcs[0][0] in _RISING:
        return above(f.lowest_terms(arcs[1][1] - arcs[0][1]))
    return above(f.lowest_terms(b - a))


def _keys(found: Sequence[_Interval]) -> list[Any]:
    return [(end.value.key() if end.value is not None else None, end.is_in) for interval in found for end in interval]


def _has_one_sign(x: Ratio) -> bool:
    """Whether an element vanishes nowhere."""
    return sign_of(x).is_strict
