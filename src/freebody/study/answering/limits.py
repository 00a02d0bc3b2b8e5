"""To what a quantity tends as a parameter tends to a value: the leading term of its formula.

The formula near the limit is compared with the numeric route; that it tends to the answer is confirmed with 200 bits
at a parameter that differs from its limit by 1e-25 of its size.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

from freebody.assess.points import EvaluationPoint, real, working_precision
from freebody.errors import CannotAnswer
from freebody.language.expression import Symbol
from freebody.language.notation import to_text
from freebody.language.sentences import Message
from freebody.questions.reading import Question
from freebody.study.answering.answer import Evidence
from freebody.study.answering.conditions import real as real_conditions
from freebody.study.answering.crosscheck import INSTANT_TOLERANCE, MOTION_TOLERANCE, CrossCheck, element_at, holds
from freebody.study.answering.draws import SEED, Draw
from freebody.study.answering.finding import Finding, NotHere
from freebody.study.answering.formula import Formula
from freebody.study.answering.magnitude import magnitude
from freebody.study.answering.numbers import number_at
from freebody.study.answering.turned_round import TIME, PutBack, quantity_with
from freebody.study.setup import Setup
from freebody.symbolic.conditions import Condition, require
from freebody.symbolic.limits import Approach, Tendency
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.tidy import tidy

_NEAR = (1e-3, 0.05)  # of its own value: a parameter that is nearly there; the second where the numeric route fails
_LINEARISED = 1e-5  # relative: what is found by a numerical linearisation
_VERY = 10**25
_AGREE = 1e-7  # relative: what the formula differs from its limit there


@dataclass(frozen=True)
class _Found:
    """The limit of one formula from one side."""

    formula: Formula
    approach: Approach
    tends: Tendency
    conditions: tuple[Condition, ...]


def find_limit(setup: Setup, question: Question, formulas: Sequence[Formula]) -> Finding:
    """Raises CannotAnswer where it grows without bound, or has no limit."""
    return _Search(setup, question, formulas).finding()


class _Search:
    def __init__(self, setup: Setup, question: Question, formulas: Sequence[Formula]) -> None:
        wanted = question.quantity.wanted
        assert wanted is not None
        self.setup, self.question, self.formulas, self.wanted = setup, question, formulas, wanted
        self.model, self.field = setup.model, setup.model.field
        self.parameter = setup.system.parameters[wanted.parameter]
        self.index = self.field.index(self.model.parameters[wanted.parameter])
        self.value: Ratio | None = None if wanted.end == "grows" else self.model.geometry.scalar(wanted.target)

    def finding(self) -> Finding:
        sides = [self._from(way) for way in self._ways()]
        first = sides[0]
        for other in sides[1:]:
            if not self._same(first, other):
                raise CannotAnswer(self._differ(first, other))
        if not first.tends.is_finite:
            raise CannotAnswer(self._grows(first, len(sides)))
        x = self.field.lowest_terms(first.tends.value)
        evidence = self._evidence(first, x)
        notes: list[str] = []
        if first.formula is not self.formulas[0]:
            notes.append(Message("near the limit another case holds than at the model's own values"))
        return Finding(x, evidence, [*first.conditions, *real_conditions(x)], notes, is_complete=True)

    def _ways(self) -> tuple[int, ...]:
        """The sides from which the parameter can come."""
        if self.value is None:
            return (1,)
        at = self.value.fraction()
        if at == 0 and (self.parameter.sign != "any" or self.parameter.acute):
            return (1,)
        return (-1,) if self.parameter.acute and self.value == self.field.pi / 2 else (1, -1)

    def _from(self, way: int) -> _Found:
        """Of the formula whose conditions hold near the limit, at the model's own numbers."""
        why: CannotAnswer | None = None
        for formula in self.formulas:
            number = formula.number
            approach = Approach(self.model, self.index, self.value, way)
            try:
                conditions = self._near(approach, formula)
                if conditions is None:
                    continue
                tends = approach.of(number)
            except CannotAnswer as error:
                why = why or error
                continue
            return _Found(formula, approach, tends, (*conditions, *approach.conditions))
        raise why or NotHere(Message("near the limit the formula is not true"))

    def _near(self, approach: Approach, formula: Formula) -> list[Condition] | None:
        """What the conditions of a formula come to near the limit; None where one of them does not hold there."""
        found: list[Condition] = []
        for c in formula.needed:
            if self.index not in self.field.ingredients(c.element):
                found.append(c)
                continue
            tends = approach.of(c.element)
            if tends.coefficient.is_zero():
                if c.relation == ">=":
                    continue
                return None
            condition, possible = require(tends.coefficient, ">" if c.relation == ">=" else c.relation, c.purpose)
            if not possible:
                return None
            if condition is not None:
                found.append(condition)
        draw = self.setup.draws[0]
        return found if all(holds(self.setup, c, draw, draw.start()) for c in found) else None

    def _same(self, a: _Found, b: _Found) -> bool:
        if a.tends.is_finite != b.tends.is_finite:
            return False
        if a.tends.is_finite:
            return bool(a.tends.value == b.tends.value)
        return self._sign(a) == self._sign(b)

    def _sign(self, found: _Found) -> int:
        return found.approach.sign(found.tends.coefficient)

    # -- in words -----------------------------------------------------------------------------
    def _place(self) -> tuple[str, str]:
        return to_text(Symbol(self.parameter.name)), "∞" if self.value is None else to_text(tidy(self.value))

    def _grows(self, found: _Found, n_sides: int) -> str:
        name, value = self._place()
        try:
            sign = self._sign(found)
        except CannotAnswer:
            sign = 0
        to = {1: "+∞", -1: "-∞", 0: "±∞"}[sign if n_sides else 0]
        return Message("it grows without bound: it tends to {to} as {name} → {value}", to=to, name=name, value=value)

    def _differ(self, above: _Found, below: _Found) -> str:
        name, value = self._place()
        shown = [self._shown(found) for found in (above, below)]
        return Message(
            "it has no limit as {name} → {value}: from above it tends to {above}, from below to {below}",
            name=name,
            value=value,
            above=shown[0],
            below=shown[1],
        )

    def _shown(self, found: _Found) -> str:
        if found.tends.is_finite:
            return to_text(tidy(self.field.lowest_terms(found.tends.value)))
        return {1: "+∞", -1: "-∞", 0: "±∞"}[self._sign(found)]

    # -- in numbers ---------------------------------------------------------------------------
    def _evidence(self, found: _Found, x: Ratio) -> Evidence:
        by_event = self.question.event is not None
        route = Message("the formula near the limit by the numeric route, and its limit in 200 bits")
        tolerance = MOTION_TOLERANCE if by_event else INSTANT_TOLERANCE
        check = CrossCheck(self.question.text, route, tolerance if self.wanted.of.is_of_state else _LINEARISED)

        if not found.formula.is_put_back:  # an event of contacts, which the numeric route finds in its own way
            draw = self.setup.draws[0]
            self._confirm(found, x, draw)
            return found.formula.evidence()

        def compare(item: tuple[int, Draw]) -> None:
            k, draw = item
            start = draw.start()
            if not all(holds(self.setup, c, draw, start) for c in found.conditions):
                return
            self._confirm(found, x, draw)
            for share in _NEAR:
                try:
                    self._compare_near(check, found, draw, k, share)
                    return
                except (CannotAnswer, ArithmeticError):
                    continue

        return check.gather(enumerate(self.setup.draw_stream()), compare).evidence()

    def _compare_near(self, check: CrossCheck, found: _Found, draw: Draw, k: int, share: float) -> None:
        made = self._made(found, draw, k, share)
        assert isinstance(found.formula.element, Ratio)
        here = made.draw.start()
        if not (self.question.event or self.question.at_start or found.formula.in_numbers):
            here = made.draw.anywhere(SEED + k, TIME, 0.1)
        exact = element_at(self.setup, found.formula.element, made.draw, here)
        if self.wanted.of.is_of_state:
            numeric = quantity_with(self.setup, self.question, self.wanted.of, found.formula, made)
        else:
            numeric = number_at(self.setup, self.wanted.of, self.question.event, made.draw)
        check.compare(draw, exact, numeric, lambda: magnitude(self.wanted.of.dimension, made.draw.seen(here)))

    def _made(self, found: _Found, draw: Draw, k: int, share: float) -> PutBack:
        own = abs(draw.values[self.parameter.name]) or 1.0
        if self.value is None:
            near = own / share
        else:
            at = element_at(self.setup, self.value, draw, draw.start())[0]
            near = at + found.approach.way * share * (abs(at) or own)
        values = draw.values | {self.parameter.name: near}
        return PutBack(k, draw.with_values(values, self.setup.system), 1.0)

    def _confirm(self, found: _Found, x: Ratio, draw: Draw) -> None:
        """Raises CannotAnswer where the formula is not near its limit."""
        numbers = self.model.samples.numbers(draw.sample(draw.start()))
        f, element = self.field, found.formula.element
        assert isinstance(element, Ratio)
        with working_precision():
            own = real(abs(draw.values[self.parameter.name]) or 1.0)
            free = EvaluationPoint(f, lambda index: real(numbers[index]))
            at = None if self.value is None else free.number(self.value)
            near = own * _VERY if at is None else at + found.approach.way * own / _VERY
            close = EvaluationPoint(f, lambda index: near if index == self.index else real(numbers[index]))
            a, b = close.number(element), free.number(x)
            gap, size = abs(float((a - b).mid())), max(abs(float(b.mid())), abs(float(close.number(element).mid())))
            is_zero = x.is_zero() and gap < _AGREE
        if not (math.isfinite(gap) and (gap <= _AGREE * size or is_zero)):
            raise CannotAnswer(Message("the limit could not be confirmed in numbers"))
