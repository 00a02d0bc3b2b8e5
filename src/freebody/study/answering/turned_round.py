"""For which value of a parameter a quantity has a value: its formula is solved for the parameter, and that put back.

The formula holds under conditions, in which the value is put in for the parameter as well; the parameter keeps its own
domain. A root of an equation that was squared need be none of the formula: at random numbers the value is put in for
the parameter, and the quantity must have the value there by the numeric route. Source of the elimination of a root:
a + b sqrt(c) = 0 implies a^2 = b^2 c.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from contextlib import suppress
from dataclasses import dataclass, replace
from itertools import islice
from typing import Any, TypeVar

from freebody.errors import CannotAnswer, FreebodyError, ModelError, NeverHappens, NoRealRoot, NotReached, SaysNothing
from freebody.language.expression import ZERO, Symbol
from freebody.language.notation import compared, joined, reworded, to_text
from freebody.language.sentences import Message
from freebody.model.elements import Parameter
from freebody.numeric.snapshot import Snapshot
from freebody.questions.base import Quantity, Wanted
from freebody.questions.clock import Clock
from freebody.questions.event import AskedEvent
from freebody.questions.reading import Question
from freebody.study.answering.answer import Evidence
from freebody.study.answering.conditions import real
from freebody.study.answering.crosscheck import (
    INSTANT_TOLERANCE,
    MIN_DRAWS,
    MOTION_TOLERANCE,
    OF_PARTS,
    CrossCheck,
    TooLittleCompared,
    element_at,
    holds,
)
from freebody.study.answering.draws import SEED, Draw, draws
from freebody.study.answering.finding import Finding, NotHere
from freebody.study.answering.formula import Formula
from freebody.study.answering.magnitude import magnitude
from freebody.study.answering.numbers import LONGEST, at_event, number_at
from freebody.study.answering.parameter_domain import domain_of, for_every, is_within
from freebody.study.answering.solved_in_numbers import Side, solved_in_numbers
from freebody.study.answering.witness import patience
from freebody.study.setup import N_DRAWS, Setup
from freebody.symbolic.conditions import Condition, merged, require
from freebody.symbolic.parameter_roots import solutions
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.signs import Sign, sign_of
from freebody.symbolic.tidy import tidy
from freebody.symbolic.validity import TAKEN
from freebody.symbolic.zeros import zeros_of
from freebody.system.system import System

_NEAR = 1e-6  # of the size of its parts: a quantity that is smaller is zero at the value that was put in
TIME = 0.37  # [s] at which drivers are looked at
_ENOUGH = 2 * MIN_DRAWS  # numbers at which a value is one: some of them may say nothing more
_ROUNDS, _SETTLED = 6, 1e-12  # rounds in which a value and the pose that it is put in come to agree, relative
# further draws: their spread, how many lots of them, and how many where the value may change with the pose
_WIDE, _BATCHES, _OF_POSES = 2.5, 6, 24
# of the file's number: values with which a motion may get there
_OTHERS = (1.25, 0.8, 2.0, 0.5, 3.0, 1 / 3, 10.0, 0.1, 30.0, 1 / 30)
_ANGLES = (0.2, 0.5, 0.8, 1.1, 1.4)  # [rad] the same for acute angles


class NoneFound(CannotAnswer):
    """The equation is solved, and none of its solutions was found to be one of the question."""


T = TypeVar("T")


@dataclass(frozen=True)
class PutBack:
    """A draw with the value in place of its own. number: of the draw from which it was made; size: [SI] of the parts of
    the quantity there, where they need not cancel."""

    number: int
    draw: Draw
    size: float


@dataclass
class _Candidate:
    """A value of the parameter, what it needs, and at which draws it is one."""

    of: _Turned
    value: Ratio
    conditions: list[Condition]
    at: list[PutBack]


def first_found(system: System, name: str, attempt: Callable[[System], T]) -> T:
    """What is found with the system's own number for a parameter; where the motion does not get there with it, with
    others."""
    first: CannotAnswer | None = None
    for other in with_others(system, name):
        try:
            return attempt(other)
        except (NeverHappens, NotHere, NotReached, NoneFound, TooLittleCompared) as error:
            first = first or error
        except ModelError:  # with another number it may not be assembled
            if other is system:
                raise
    assert first is not None
    raise first


def with_others(system: System, name: str) -> Iterator[System]:
    """The system, then with other numbers for a parameter that has one. name: nothing where none is asked for."""
    yield system
    parameter = system.parameters.get(name)
    if parameter is None or parameter.value is None:
        return
    for number in _ANGLES if parameter.acute else [factor * parameter.value for factor in _OTHERS]:
        with suppress(FreebodyError):
            yield system.with_parameters(**{name: number})


def find(setup: Setup, question: Question, formulas: Sequence[Formula]) -> Finding:
    """The value of the parameter. formulas: of what is to have a value, each with its own conditions. Raises
    CannotAnswer where the equation is not solvable in closed form, or no value was found."""
    quantity = question.quantity.wanted
    assert quantity is not None
    name = quantity.parameter
    turned: list[_Turned] = []
    why_not: CannotAnswer | None = None
    for formula in formulas:
        try:
            turned.append(_turned(setup, question, quantity, formula))
        except CannotAnswer as error:
            why_not = error if isinstance(error, SoInRange) else why_not or error
    if not turned:
        assert why_not is not None
        raise why_not
    candidates = [candidate for one in turned for candidate in one.candidates()]
    if not candidates:
        field, left = setup.model.field, [one.element.numerator() for one in turned]
        if not any(turned[0].index in field.ingredients(x) for x in left):
            rest = to_text(tidy(left[0]))
            raise NoneFound(
                Message(
                    "no value of {name} makes that so: {rest} would have to be zero, and {name} is not in it",
                    name=name,
                    rest=rest,
                )
            )
        equation = compared(tidy(turned[0].element.numerator()), "=", ZERO)
        why = Message("the equation {equation} is not solved for {name} in closed form", equation=equation, name=name)
        raise _in_numbers(setup, question, turned, reworded(why, equation))
    possible = [c for c in candidates if c.at] or list(_between_cases(turned))
    if not possible and (told := _of_other_sign(setup.system.parameters[name], candidates)) is not None:
        raise NoneFound(told)
    if not possible and isinstance(why_not, SoInRange):
        raise why_not
    if not possible:
        raise NoneFound(Message("no value of {name} within its range was found for which that is so", name=name))
    lasting = [c for c in possible if not c.of.is_of_pose(c.value)]
    if lasting and len(lasting) < len(possible):
        found = _chosen(lasting)
        return replace(
            found, notes=[Message("it is so at every instant; at one alone, for other values, too"), *found.notes]
        )
    return _chosen(possible)


def _between_cases(turned: Sequence[_Turned]) -> Iterator[_Candidate]:
    """Values on the border of two cases by the formulas of both: a body that rebounds or goes on, and just stops."""
    found = [c for one in turned for c in one.candidates(at_border=True) if c.at]
    for k, c in enumerate(found):
        if any(c.value == other.value and c.of is not other.of for other in found[k + 1 :]):
            yield c


def _of_other_sign(parameter: Parameter, candidates: Sequence[_Candidate]) -> Message | None:
    """That only values solve the equation which the parameter cannot have, by the sign that the file gives it."""
    if parameter.sign == "any" or not all(sign_of(c.value) is Sign.NEGATIVE for c in candidates):
        return None
    return Message(
        "that is so for {name} = {values} alone, which is negative; write {name}: {{value: ..., sign: any}} where the "
        "parameter may be that",
        name=parameter.name,
        values=", ".join(to_text(tidy(c.value)) for c in candidates),
    )


def _in_numbers(setup: Setup, question: Question, turned: Sequence[_Turned], why: str) -> CannotAnswer:
    """That there is no closed form, with all solutions at the model's own numbers where it is known which are all."""
    first = turned[0]
    found = None
    if setup.has_values:
        sides = [Side(one.element, one.formula.needed) for one in turned]
        found = solved_in_numbers(setup, first.parameter, first.index, sides)
    if found is None or not first.is_confirmed(found.values):
        return CannotAnswer(why)
    return found.told(why, question.quantity.unit)


def _turned(setup: Setup, question: Question, quantity: Wanted, formula: Formula) -> _Turned:
    name, model = quantity.parameter, setup.model
    element = formula.number - model.geometry.scalar(quantity.target)
    index = model.field.index(model.geometry.scalar(Symbol(name)))
    if quantity.of.scope == "steady motion" and index not in model.field.ingredients(element):
        element, formula = _at_rates_of_start(setup, element, formula, index)
    if element.is_zero():
        if any(index in model.field.ingredients(c.element) for c in formula.needed):
            told = Message(
                "that is so in a whole range of {name}; ask with <= or >= in place of = for its end", name=name
            )
            raise SoInRange(told)
        raise CannotAnswer(for_every(setup.system, setup.system.parameters[name], question.text))
    if index not in model.field.ingredients(element):
        measured = quantity.of.named_measure
        if measured is not None and measured[1] == 0 and question.event is None:
            told = Message(
                "where it starts does not depend on {name}. Where it rests may: value of {name} for which equilibrium "
                "of {x} = ...",
                name=name,
                x=measured[0],
            )
            raise CannotAnswer(told)
        raise CannotAnswer(Message("that does not depend on {name}", name=name))
    return _Turned(setup, question, quantity, setup.system.parameters[name], index, element, formula)


def _at_rates_of_start(setup: Setup, element: Ratio, formula: Formula, index: int) -> tuple[Ratio, Formula]:
    """In steady motion rates go on as they start: with those that the start gives by the parameter, phi' = w."""
    f, given = setup.model.field, setup.start.values
    speeds = {c.speed for c in setup.model.coordinates} & f.ingredients(element)
    known = {g: given[g] for g in speeds if g in given and index in f.ingredients(given[g])}
    needed = [replace(c, element=f.lowest_terms(f.follow(c.element, known))) for c in formula.needed]
    return f.lowest_terms(f.follow(element, known)), replace(formula, needed=needed)


class SoInRange(CannotAnswer):
    """It is so wherever one of the cases is: a ball that does not slip in an impact leaves it by one formula."""


@dataclass(frozen=True)
class _Turned:
    """An equation to be solved. element: what vanishes; index: that of the parameter."""

    setup: Setup
    question: Question
    quantity: Wanted
    parameter: Parameter
    index: int
    element: Ratio
    formula: Formula

    def candidates(self, *, at_border: bool = False) -> list[_Candidate]:
        """All values that solve the equation, with what they need. at_border: what the formula needs may just not be so
        there."""
        field, known = self.setup.model.field, list[Ratio]()
        equation, one_side = without_roots(self.element, self.index)
        zeros = zeros_of(self.setup.model, equation, self, quadratic=True)
        for value in zeros or [values[self.index] for values in solutions(field, equation, self.index)]:
            value = field.lowest_terms(value)
            if self.index not in field.ingredients(value) and value not in known:
                known.append(value)
        needed = [Condition(x, ">=", Message("the root has the sign it needs")) for x in one_side]
        below = self.element.denominator()
        if self.index in field.ingredients(below):
            needed.append(Condition(below, "!=", Message("divisor")))
        return [self._candidate(value, needed, at_border=at_border) for value in known]

    def _candidate(self, value: Ratio, needed: Sequence[Condition], *, at_border: bool) -> _Candidate:
        """needed: in which the value is put in for the parameter, as it is where the formula is one."""
        conditions = [*domain_of(self.parameter, value), *real(value)]
        try:
            own = [self._with_value(c, value) for c in self.formula.needed]
            conditions += [self._with_value(c, value) for c in needed]
        except NoRealRoot:  # the formula has no value there
            return _Candidate(self, value, [], [])
        own = [c for c in own if not (at_border and c.relation == ">" and c.element.is_zero())]
        conditions += own
        kept: list[Condition] = []
        for c in conditions:
            condition, possible = require(c.element, c.relation, c.purpose)
            if not possible:
                return _Candidate(self, value, [], [])
            if condition is not None:
                kept.append(condition)
        so = (made for made in self._put_back(value) if self._is_so(made, value, own))
        return _Candidate(self, value, kept, list(islice(so, _ENOUGH)))

    def _with_value(self, c: Condition, value: Ratio) -> Condition:
        """A condition with the value put in. What a formula takes to be positive, |x| = x, may vanish there."""
        relation = ">=" if (c.purpose, c.relation) == (TAKEN, ">") else c.relation
        return replace(c, element=self._put_in(c.element, value), relation=relation)

    def _put_in(self, x: Ratio, value: Ratio) -> Ratio:
        return x.field.lowest_terms(x.field.follow(x, {self.index: value}))

    # -- in numbers ---------------------------------------------------------------------------
    def _put_back(self, value: Ratio) -> Iterator[PutBack]:
        """The draws with the value in place of their own, where it is within the range of the parameter and the system
        can be assembled with it."""
        for k, draw in enumerate(self._draws(value)):
            with suppress(CannotAnswer, ArithmeticError, ValueError):
                if (made := self._made(k, draw, value)) is not None:
                    yield PutBack(k, made, max(self._size(draw), self._size(made)) or 1.0)

    def _made(self, k: int, draw: Draw, value: Ratio) -> Draw | None:
        """A draw with the value, which may change with the pose, and the pose with the value; None where there is none
        within the range of the parameter, or they were not found to agree."""
        made, last = draw, math.nan
        for _ in range(_ROUNDS):
            (number,) = element_at(self.setup, value, made, self._instant(value, PutBack(k, made, 1.0)))
            if not math.isfinite(number) or not is_within(self.parameter, number):
                return None
            if abs(number - last) <= _SETTLED * abs(number):
                return made
            values = draw.values | {self.parameter.name: number}
            made, last = draw.with_values(values, self.setup.system), number
        return None

    def _instant(self, value: Ratio, made: PutBack) -> Snapshot:
        """Where a value is put in: one that depends on the pose or the speeds, where the quantity is looked at."""
        return instant_of(self.question, self.quantity.of, made) if self.is_of_pose(value) else made.draw.start()

    def is_of_pose(self, value: Ratio) -> bool:
        return bool(self.setup.model.moving & value.field.ingredients(value))

    def _draws(self, value: Ratio) -> Iterator[Draw]:
        """Those that all answers are compared at; then others further away, for values that are there only."""
        yield from self.setup.draw_stream()
        for k in range(_OF_POSES if self.is_of_pose(value) else _BATCHES):
            yield from draws(self.setup.system, N_DRAWS, seed=SEED + 20 + k, widest=_WIDE, near=self.setup.draws[0])

    def _size(self, draw: Draw) -> float:
        target = abs(draw.reference.number(self.quantity.target))
        return max(target, magnitude(self.quantity.of.dimension, draw.seen(draw.start())))

    def _is_so(self, made: PutBack, value: Ratio, needed: Sequence[Condition]) -> bool:
        """Whether the formula has the value there, and is true."""
        try:
            here, room = self._instant(value, made), _NEAR * made.size
            (number,) = element_at(self.setup, self.element, made.draw, here)
            own = [c for c in needed if c.relation != "!="]
            return abs(number) <= room and all(holds(self.setup, c, made.draw, here, round_off=room) for c in own)
        except (CannotAnswer, ArithmeticError, ValueError):
            return False

    def is_confirmed(self, values: Sequence[float]) -> bool:
        """Whether the numeric route finds the quantity to be what it is to be, at the model's own numbers."""
        self.formula.evidence()
        own = self.setup.draws[0]
        for value in values if self.formula.is_put_back else ():
            draw = own.with_values(own.values | {self.parameter.name: value}, self.setup.system)
            made = PutBack(0, draw, max(self._size(own), self._size(draw)) or 1.0)
            with suppress(CannotAnswer, ArithmeticError, ValueError):
                numeric = quantity_with(self.setup, self.question, self.quantity.of, self.formula, made)
                if abs(numeric - draw.reference.number(self.quantity.target)) > _NEAR * made.size:
                    return False
        return True

    def evidence(self, candidate: _Candidate) -> Evidence:
        """The quantity by the numeric route, with the value put in for the parameter; else that of the formula."""
        of, event = self.quantity.of, self.question.event
        is_steady = of.scope == "steady motion" and self.formula.in_numbers is not None
        event = None if is_steady else event  # there it says what the motion keeps
        is_of_way = of.turn is not None and self.formula.in_numbers is not None
        if not (is_steady or is_of_way or (of.is_of_state and self.formula.is_put_back)):
            return self.formula.evidence()
        is_at_once = event is None and not is_of_way
        route = (
            Message("the value put in for the parameter, floating-point solve of all bodies and constraints")
            if is_at_once
            else Message("the value put in for the parameter, numerical integration over the motion")
            if is_of_way
            else Message("the value put in for the parameter, numerical integration from the start to the event")
        )
        check = CrossCheck(self.question.text, route, INSTANT_TOLERANCE if is_at_once else MOTION_TOLERANCE)

        def compare(made: PutBack) -> None:
            draw, target = made.draw, made.draw.reference.number(self.quantity.target)
            numeric = quantity_with(self.setup, self.question, of, self.formula, made)
            share = 1.0 if event is None or target else 1.0 / OF_PARTS  # what vanishes in motion counts by its size
            if event is not None and not target and of.kinematic_order == 1 and isinstance(numeric, float):
                # a velocity that vanishes is the root of what energy leaves: its square has the error of the motion
                check.compare(draw, target, numeric**2, lambda: share * made.size**2)
            else:
                check.compare(draw, target, numeric, lambda: share * made.size)

        return check.gather(candidate.at, compare).evidence()


def quantity_with(setup: Setup, question: Question, of: Quantity, formula: Formula, made: PutBack) -> Any:
    """The quantity by the numeric route, with a value put in for the parameter. Raises SaysNothing where that route has
    no number, as for an event that it does not see."""
    draw = made.draw
    if formula.in_numbers is not None:
        found = formula.in_numbers(draw.values)
        if found is None:
            raise SaysNothing(Message("the numeric route has no number there"))
        return found
    if not of.is_of_state:
        return number_at(setup, of, question.event, draw)
    if question.event is not None:
        return at_event(setup, of, draw, draw.start(), _until(setup, question.event, draw), question.event)
    return of.value(setup.system, draw.seen(instant_of(question, of, made)))


def instant_of(question: Question, of: Quantity, made: PutBack) -> Snapshot:
    """Where a formula is looked at: at the start, from which an event is reached, or at any instant."""
    is_of_any = of.is_of_state and question.event is None and not question.at_start
    return made.draw.anywhere(SEED + made.number, TIME, 0.1) if is_of_any else made.draw.start()


def _until(setup: Setup, event: AskedEvent, draw: Draw) -> float:
    """[s] How long an event is waited for; where the time grows without end, until all has settled."""
    longest = patience(draw.start(), LONGEST)
    if not isinstance(event, Clock) or event.time is not None:
        return longest
    settled = setup.motion.at_clock(None).settled
    return longest if settled is None else element_at(setup, (settled,), draw, draw.start())[0]


def _chosen(possible: Sequence[_Candidate]) -> Finding:
    """The value at the model's own numbers; several where several are values at the same numbers."""
    first = min(made.number for c in possible for made in c.at)
    own = [c for c in possible if any(made.number == first for made in c.at)]
    own = [c for k, c in enumerate(own) if all(c.value != other.value for other in own[:k])]
    evidence = [c.of.evidence(c) for c in own]
    parameter = own[0].of.parameter
    notes: list[str] = []
    if parameter.value is not None:
        notes.append(Message("the number given for {name} is not used", name=parameter.name))
    for c in possible:
        if all(c.value != other.value for other in own):
            shown, where = to_text(tidy(c.value)), joined(merged(c.conditions))
            notes.append(Message("elsewhere it is {value}, where {conditions}", value=shown, conditions=where))
    return Finding(
        own[0].value if len(own) == 1 else tuple(c.value for c in own),
        max(evidence, key=lambda e: e.worst_relative_difference),
        [condition for c in own for condition in c.conditions],
        notes,
        has_value=own[0].of.setup.has_values,
        is_complete=True,
    )


def without_roots(x: Ratio, index: int) -> tuple[Ratio, list[Ratio]]:
    """An element that vanishes where x does, without roots of the parameter; and what must not be negative for its
    zeros to be zeros of x: a + b sqrt(c) = 0 needs a b <= 0."""
    field, needed = x.field, list[Ratio]()
    x = x.numerator()
    while True:
        made = [g for g in x.generators() if index in field.generators[g].made_of]
        roots = [g for g in made if field.generators[g].kind == "root"]
        if not roots:
            return x, needed
        root = max(roots)
        a, b = (*x.coefficients(root), field.zero)[:2]
        needed.append(-a * b)
        x = field.lowest_terms(a * a - b * b * field.radicand(root)).numerator()
