"""The least and the largest value of a quantity over a motion that repeats itself.

With one freedom and u^2 = W(q) by energy the motion goes to and fro between two turns, or round and round, and is in
every place as fast as the time before. A quantity of the state is there A(q) + B(q) u, so that its extremes over the
whole motion are those over the places it goes through: at the turns, where u = 0, or where the slope along q vanishes,

    A' + B' u + B W'/(2 u) = 0,  u = +-sqrt(W):      4 A'^2 W = (2 B' W + B W')^2       (B' W + B W'/2 = 0 for A' = 0).

Source: Goldstein, Poole & Safko, Classical Mechanics, 3rd ed. 2002, sec. 3.3 (one-dimensional problem, turning points).
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field, replace

from freebody.errors import CannotAnswer, NotReached
from freebody.language.expression import Symbol
from freebody.language.notation import compared, joined, reworded
from freebody.language.sentences import Message, in_turn
from freebody.questions.base import Quantity
from freebody.study.answering.crosscheck import MOTION_TOLERANCE, CrossCheck, broken, element_at
from freebody.study.answering.damped_extremes import damped_of
from freebody.study.answering.damped_extremes import find as find_damped
from freebody.study.answering.draws import Draw
from freebody.study.answering.finding import Finding, NotHere
from freebody.study.answering.linear_extremes import find as find_linear
from freebody.study.answering.linear_extremes import measure_followed
from freebody.study.answering.modal_extremes import find as find_modal
from freebody.study.answering.modal_extremes import wave_of
from freebody.study.answering.motion_values import OneSided, extremes_over_cycle
from freebody.study.answering.repeated import checked, taken_throughout
from freebody.study.answering.settling_extremes import find as find_settling
from freebody.study.answering.settling_extremes import settling_of
from freebody.study.answering.sizes import is_size, moves
from freebody.study.answering.uniform_extremes import even_turn
from freebody.study.answering.uniform_extremes import find as find_even
from freebody.study.setup import Setup
from freebody.symbolic.closure import explicit
from freebody.symbolic.conditions import Condition, closed, require
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.reached import Reached
from freebody.symbolic.tidy import tidy
from freebody.symbolic.unknowns import Coordinate
from freebody.symbolic.way import EnergyPath, PassedPlaces
from freebody.symbolic.zeros import reals, turn_of

_NO_FORM = CannotAnswer(Message("where its slope along the motion vanishes has no closed form"))
_NEAR = 1e-9
_N_STEPS = 96  # of the way, on which it is looked at whether there is a value beyond
_ROUND_OFF = 1e-9  # of the largest value on the way


@dataclass(frozen=True)
class Stationary:
    """A value that may be an extreme, and the places at which the quantity has it. is_turn: at the end of the way."""

    value: Ratio
    places: tuple[tuple[Ratio, list[float]], ...]
    is_turn: bool = False


@dataclass
class Along:
    """A quantity along a motion by energy, even + odd u; the square of a size. repeats: whether the motion is
    meant as a whole, which goes through its places again and again; is_once: whether it goes through them once, in one
    sense; conditions: under which it is so."""

    setup: Setup
    c: Coordinate
    way: EnergyPath
    span: PassedPlaces
    even: Ratio
    odd: Ratio
    is_root: bool
    repeats: bool = True
    is_once: bool = False
    conditions: list[Condition] = field(default_factory=list[Condition])

    # -- what may be extreme ------------------------------------------------------------------
    def candidates(self) -> list[Stationary]:
        """The values at the ends of the way and where the slope vanishes, each once."""
        found = list[Stationary]()
        for end in () if self.span.ends is None else self.span.ends:
            for value in self._values(end) if self.is_once else (self._at(self.even, end),):  # u = 0 at a turn
                found = _with(found, Stationary(value, ((end, self.way.numbers(end)),), is_turn=True))
        for place, numbers in self.way.places(self._slope()):
            for value in self._values(place):
                found = _with(found, Stationary(value, ((place, numbers),)))
        if not found:
            raise _NO_FORM
        return found

    def _values(self, place: Ratio) -> Iterator[Ratio]:
        """The quantity at a place, in each sense in which the motion goes through it."""
        f, value = self.setup.model.field, self._at(self.even, place)
        if self.odd.is_zero():
            yield value
            return
        rate = f.sqrt(self._at(self.way.square, place), self.setup.model.samples.is_negative)
        for sense in self.senses:
            yield f.lowest_terms(value + sense * self._at(self.odd, place) * rate)

    @property
    def senses(self) -> tuple[int, ...]:
        """In which the coordinate moves: both ways, or on and on."""
        return (self.way.sense,) if self.span.ends is None or self.is_once else (1, -1)

    @property
    def whole(self) -> Ratio:
        """The way after which the quantity is as before, of what goes on and on. Raises CannotAnswer where it never
        is."""
        f = self.setup.model.field
        both = self.even + self.odd * f.variable(self.c.speed)
        still = self.c.index not in f.ingredients(both)
        turn = turn_of(self.way.square if still else self.way.square + both, self.c.index)
        if turn is None:
            raise _NO_FORM
        return turn

    def _slope(self) -> Ratio:
        """What vanishes where the slope along the coordinate does."""
        f, q, W = self.setup.model.field, self.c.index, self.way.square
        slope = f.lowest_terms(f.derivative(self.even, q))
        if self.odd.is_zero():
            return slope
        beside = f.lowest_terms(2 * f.derivative(self.odd, q) * W + self.odd * f.derivative(W, q))
        if slope.is_zero():
            return beside
        return f.lowest_terms(4 * slope * slope * W - beside * beside)

    def _at(self, x: Ratio, place: Ratio) -> Ratio:
        f = self.setup.model.field
        try:
            return f.lowest_terms(f.follow(x, {self.c.index: place}))
        except ZeroDivisionError:
            raise CannotAnswer(Message("it grows without bound on the way")) from None

    def add_needs(self) -> None:
        """What the motion itself needs, as conditions."""
        for x, relation in self.span.needs:
            self._add(x, Message("it moves so"), relation)

    # -- the choice ---------------------------------------------------------------------------
    def best(self, found: Sequence[Stationary], side: int) -> Stationary:
        """The largest (side 1) or least one at the model's own values, or the first sample; that it is so for others is
        a condition. Raises CannotAnswer where some place of the way is beyond it."""
        inside = [s for s in found if self.is_inside(s)]
        if not inside:
            raise _NO_FORM
        chosen = max(inside, key=lambda s: side * self._first(s.value))
        if not chosen.is_turn:
            place = next(p for p in chosen.places if self._is_inside(p[1][0]))
            for end, sign in zip(self.span.ends or (), (-1, 1), strict=False):
                self._add(sign * (end - place[0]), Message("it gets there"))
        for other in found:
            gap = side * (chosen.value - other.value)
            if other is chosen or gap.is_zero():
                continue
            if self.is_inside(other):
                self._add(gap, Message("which extreme is which"), ">=")
            elif require(gap, ">=")[0] is not None:
                self._stay_outside(other)
        self._check(chosen, side)
        return chosen

    def is_inside(self, s: Stationary) -> bool:
        """Whether the motion comes to one of its places, at the model's own values."""
        return s.is_turn or any(self._is_inside(numbers[0]) for _place, numbers in s.places)

    def _is_inside(self, v: float) -> bool:
        if self.span.ends is None or math.isnan(v):
            return not math.isnan(v)
        low, high = (self._first(end) for end in self.span.ends)
        return low + _NEAR < v < high - _NEAR

    def _stay_outside(self, s: Stationary) -> None:
        """The places of a larger value are beyond the turns, or no real ones."""
        assert self.span.ends is not None or all(math.isnan(n[0]) for _p, n in s.places)
        for place, numbers in s.places:
            if math.isnan(numbers[0]):
                for x in reals(place):
                    if self._first(x) < 0:
                        self._add(-x, Message("there is no such place"), ">=")
                        break
                continue
            assert self.span.ends is not None
            low, high = self.span.ends
            is_above = numbers[0] >= self._first(high) - _NEAR
            self._add(place - high if is_above else low - place, Message("it does not get there"), ">=")

    def _first(self, x: Ratio) -> float:
        values = self.setup.model.samples.at_starts(x)
        return values[0] if values else math.nan

    def _add(self, x: Ratio, purpose: str, relation: str = ">") -> None:
        condition, possible = require(self.setup.model.field.lowest_terms(x), relation, purpose)
        if not possible:
            raise CannotAnswer(Message("which value is the extreme one was not decided"))
        if condition is not None and all(condition.element != c.element for c in self.conditions):
            self.conditions.append(condition)

    def _check(self, chosen: Stationary, side: int) -> None:
        """No value on the way is beyond the chosen one at the first sample: no stationary place was missed."""
        best, seen = self._first(chosen.value), self.seen()
        size = max(map(abs, seen))
        if not all(side * (v - best) <= _ROUND_OFF * size for v in seen):
            raise _NO_FORM

    def seen(self) -> list[float]:
        """The quantity at places of the way, at the first sample."""
        samples, f = self.setup.model.samples, self.setup.model.field
        if self.span.ends is None:
            low, high = self._first(self.way.q0), self._first(self.way.q0 + self.whole)
        else:
            low, high = (self._first(end) for end in self.span.ends)
        x = self.even + self.odd * f.variable(self.c.speed)
        seen: list[float] = []
        for k in range(_N_STEPS):
            q = low + (high - low) * (k + 0.5) / _N_STEPS
            square = samples.at_start_with(self.way.square, 0, {self.c.index: q})
            for sense in self.senses:
                rate = sense * math.sqrt(max(square, 0.0))
                seen.append(samples.at_start_with(x, 0, {self.c.index: q, self.c.speed: rate}))
        return seen

    def in_numbers(self, of: Quantity, draw: Draw) -> tuple[float, float]:
        """The least and the largest value of the quantity by the numeric route."""
        whole = None
        if self.span.ends is None:
            whole = abs(next(iter(element_at(self.setup, self.whole, draw, draw.start()))))
        return extremes_over_cycle(self.setup, draw, self.setup.model.measure_of(self.c), of, whole=whole)

    # -- what is told -------------------------------------------------------------------------
    def value_of(self, s: Stationary) -> Ratio:
        """Of the quantity itself."""
        f = self.setup.model.field
        return f.sqrt(s.value, self.setup.model.samples.is_negative) if self.is_root else s.value

    def place_texts(self, s: Stationary) -> list[str]:
        """All of its places to which the motion comes; of what goes on and on that nearest ahead of the start, or to
        where the coordinate is zero."""
        there = [one for one in s.places if self._is_passed(one[1][0])] or list(s.places)
        if self.span.ends is None:
            begin = self._first(self.way.q0)
            there = [one for one in there if self.way.sense * (one[1][0] - begin) >= 0.0] or there
            there = [min(there, key=lambda one: abs(one[1][0]))]
        there.sort(key=lambda one: (abs(one[1][0]), -one[1][0]))
        apart = [one for k, one in enumerate(there) if all(abs(one[1][0] - o[1][0]) > _NEAR for o in there[:k])]
        return [compared(Symbol(self.c.name), "=", tidy(place)) for place, _numbers in apart]

    def _is_passed(self, v: float) -> bool:
        """Whether the motion comes to a place, or turns there, at the model's own values."""
        ends = () if self.span.ends is None else self.span.ends
        return self._is_inside(v) or any(abs(v - self._first(end)) <= _NEAR for end in ends)

    def where(self, which: str, s: Stationary) -> str:
        """At which places it is."""
        shown = self.place_texts(s)
        told = Message("{which} at {places}", which=which, places=in_turn(shown, "{first} and {second}"))
        return reworded(told, joined(shown, " or "))


def _with(found: list[Stationary], new: Stationary) -> list[Stationary]:
    """Places with the same value together."""
    for k, s in enumerate(found):
        if s.value == new.value:
            both = Stationary(s.value, (*s.places, *new.places), s.is_turn or new.is_turn)
            return [*found[:k], both, *found[k + 1 :]]
    return [*found, new]


def along(setup: Setup, of: Quantity) -> Along:
    """A quantity along the motion. Raises CannotAnswer where that is not one freedom by energy that repeats itself."""
    reason: CannotAnswer | None = None
    for c in setup.model.coordinates:
        try:
            return _along(setup, of, c)
        except CannotAnswer as error:
            reason = reason or error
    raise reason or CannotAnswer(Message("nothing moves by itself"))


def along_until(setup: Setup, of: Quantity, reached: Reached) -> Along:
    """A quantity along the motion from its start to an event. Raises CannotAnswer where that is not one freedom by
    energy, or where it changes with the sense of a motion that turns before."""
    c = reached.coordinate
    if c is None:
        raise _NO_FORM
    way = setup.motion.way_of(c)
    begin, end = way.covered(reached.at)
    ends = (begin, end) if way.numbers(begin)[0] < way.numbers(end)[0] else (end, begin)
    seen = _along(setup, of, c, PassedPlaces(ends, [], []))
    turns = begin != way.q0
    if turns and not seen.odd.is_zero():
        raise _NO_FORM
    return replace(seen, repeats=False, is_once=not turns)


def _along(setup: Setup, of: Quantity, c: Coordinate, span: PassedPlaces | None = None) -> Along:
    """span: the places that count, else all of a motion that repeats itself."""
    model, motion = setup.model, setup.motion
    f = model.field
    value = of.value(setup.system, setup.state)
    if isinstance(value, tuple):
        raise CannotAnswer(Message("a vector has no extremes; ask for its size or for a component along a direction"))
    way = motion.way_of(c)
    x = explicit(model, f.lowest_terms(model.in_independent_speeds(f.element(value))))
    place = f.variable(c.index)
    integrals = motion.integrals_of(c)
    here = {**integrals.places_at(c, place, None), **integrals.resting}
    here |= integrals.speeds_at(c, place, f.variable(c.speed))
    here = {k: v for k, v in here.items() if k not in (c.index, c.speed)}
    x = f.lowest_terms(f.follow(x, here))
    others = {k.index for k in (*model.coordinates, *model.dependent)} - {c.index}
    others |= {k.speed for k in (*model.coordinates, *model.dependent)} - {c.speed}
    if f.ingredients(x) & others or any(f.generators[g].kind == "time" for g in f.ingredients(x)):
        raise CannotAnswer(Message("it depends on more than the place of {x} on its way", x=c.name))
    if is_root := any(f.generators[g].kind == "root" and moves(g, (c,), f) for g in x.generators()):
        is_root = is_size(model, x, c)
        x = f.lowest_terms(x * x) if is_root else x
    even, odd = _by_parity(x, c, way.square)
    try:
        span = span or way.span()
    except NotReached:
        raise CannotAnswer(Message("the motion does not repeat itself")) from None
    return Along(setup, c, way, span, even, odd, is_root)


def _by_parity(x: Ratio, c: Coordinate, square: Ratio) -> tuple[Ratio, Ratio]:
    """even + odd u = x, with the squares of u by energy. Raises CannotAnswer where x is no polynomial in u."""
    f = x.field
    if any(c.speed in f.generators[g].made_of for g in f.ingredients(x) - {c.speed}):
        raise _NO_FORM
    if c.speed in x.denominator().generators():
        raise _NO_FORM
    parts = x.numerator().coefficients(c.speed) if c.speed in x.generators() else [x.numerator()]
    even = odd = f.zero
    for k, part in enumerate(parts):
        power = part * square ** (k // 2)
        even, odd = (even + power, odd) if k % 2 == 0 else (even, odd + power)
    return f.lowest_terms(even / x.denominator()), f.lowest_terms(odd / x.denominator())


def find(setup: Setup, question: str, of: Quantity, sides: Sequence[int]) -> Finding:
    """The closed form. sides: -1 for the least value, +1 for the greatest, in the order in which they are wanted."""
    followed = measure_followed(setup, of)
    if followed is not None:
        return find_linear(setup, question, of, followed, sides)
    swing = wave_of(setup, of)
    if swing is not None:
        return find_modal(setup, question, of, swing, sides)
    damped = damped_of(setup, of)
    if damped is not None:
        return find_damped(setup, question, of, damped, sides)
    turn = even_turn(setup, of)
    if turn is not None:
        return find_even(setup, question, of, turn, sides)
    settling = settling_of(setup, of)
    if settling is not None:
        return find_settling(setup, question, of, settling, sides)
    seen = along(setup, of)
    seen.add_needs()
    found = seen.candidates()
    chosen = [seen.best(found, side) for side in sides]
    values = tuple(seen.value_of(s) for s in chosen)
    conditions = [*seen.conditions, *_kept(setup)]
    conditions += _of_these(taken_throughout(setup), [*values, seen.even, seen.odd, *(c.element for c in conditions)])
    check = CrossCheck(question, Message("numerical integration over a cycle of the motion"), MOTION_TOLERANCE)

    def numbers(draw: Draw) -> tuple[float, ...]:
        low, high = seen.in_numbers(of, draw)
        return tuple(low if side < 0 else high for side in sides)

    evidence = checked(setup, check, values, conditions, numbers)
    if evidence is None:
        needs = ", ".join(broken(setup, conditions))
        raise NotHere(Message("the motion is another one at the model's own values: that needs {x}", x=needs))
    words = {-1: Message("least"), 1: Message("largest")}
    notes = [seen.where(words[side], s) for side, s in zip(sides, chosen, strict=True)]
    element = values if len(values) > 1 else next(iter(values))
    return Finding(element, evidence, conditions, notes, list(seen.span.says))


def _of_these(taken: Sequence[Condition], told: Sequence[Ratio]) -> list[Condition]:
    """Signs that were taken, without those of roots that stand in nothing that is told: of places that do not count."""
    f = told[0].field
    inside = set[int]().union(*map(f.ingredients, told))
    roots = [(c, {g for g in f.ingredients(c.element) if f.generators[g].kind == "root"}) for c in taken]
    return [c for c, own in roots if own <= inside]


def _kept(setup: Setup) -> list[Condition]:
    """That ideal strings stay taut and contacts keep touching all the time: by the least value, and where that has no
    closed form, at every instant."""
    found: list[Condition] = []
    for row in sorted(setup.system.constraint_rows, key=lambda row: row.name):
        if not row.unilateral:
            continue
        purpose = closed(row.connection, row.reaction)
        seen = along(setup, OneSided(row))
        try:
            least = seen.value_of(seen.best(seen.candidates(), -1))
        except CannotAnswer:
            if min(seen.seen()) < 0.0:
                raise CannotAnswer(
                    Message("{connection} does not hold all the time", connection=row.connection)
                ) from None
            is_of_place = seen.odd.is_zero() and not seen.is_root
            x = seen.even if is_of_place else OneSided(row).value(setup.system, setup.state)
            found.append(Condition(x, ">=", purpose))
            continue
        condition, possible = require(least, ">=", purpose)
        if not possible:
            raise CannotAnswer(Message("{connection} does not hold all the time", connection=row.connection))
        found += [*seen.conditions, *([] if condition is None else [condition])]
    return found
