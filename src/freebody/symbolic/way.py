"""The way of one coordinate by energy: u^2 = W(q), from the start on in the direction in which it sets out.

W must not vanish on the way: a place behind a hill of potential energy is reached only by who gets over the hill.
Where W vanishes with a slope the coordinate turns, and goes back the same way.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property

from freebody.errors import CannotAnswer, NeverHappens, NotReached
from freebody.language.sentences import Message
from freebody.symbolic.algebraic_time import AlgebraicTime, algebraic_time
from freebody.symbolic.elliptic import EllipticTime, elliptic_time
from freebody.symbolic.model import SymbolicModel
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.signs import Sign, sign_of
from freebody.symbolic.unknowns import Coordinate
from freebody.symbolic.zeros import changes_sign, reals, turn_of, zeros_of

Need = tuple[Ratio, str]
Places = list[tuple[Ratio, list[float]]]  # a place as a formula, and at every sample
_NEAR = 1e-9
_CLEAR = 1e-3  # of a number that is not the round-off of a zero
_TURNS = range(-2, 3)  # by which a place of an angle may differ from the formula's
_N_STEPS = 64


@dataclass(frozen=True)
class PassedPlaces:
    """All places that a motion goes through again and again: between two turns, or (no ends) all round."""

    ends: tuple[Ratio, Ratio] | None
    needs: list[Need]
    says: list[str]


class EnergyPath:
    """The motion of the one coordinate of a model with a first integral of energy. takes_side: whether it is told as it
    is at the first sample where parameters decide which way it goes; that is then needed. coasts: whether nothing
    changes its kinetic energy, which it has from the start."""

    def __init__(
        self,
        model: SymbolicModel,
        c: Coordinate,
        square: Ratio,
        start: tuple[Ratio, Ratio, Ratio],
        *,
        takes_side: bool = False,
        coasts: bool = False,
    ) -> None:
        self.model, self.c = model, c
        self.field = model.field
        self.square = model.field.lowest_terms(square)
        self.q0, self.u0, a0 = start
        self._takes_side, self._others = takes_side, set[int]()  # samples on the other side
        self._coasts = coasts
        self._drive = self._outset(a0) if self.u0.is_zero() else self.u0
        if self._drive.is_zero():
            raise CannotAnswer(Message("{x} starts at rest where nothing accelerates it", x=c.name))

    def _outset(self, a0: Ratio) -> Ratio:
        """How it is accelerated where it starts at rest: a0, or where that is told by what loops bind, dW/dq/2."""
        bound = {k for d in self.model.dependent for k in (d.index, d.speed)}
        if not self.field.ingredients(a0) & bound:
            return a0
        slope = self.field.derivative(self.square, self.c.index) / 2
        return self.field.lowest_terms(self.field.follow(slope, {self.c.index: self.q0}))

    # -- what is asked ------------------------------------------------------------------------
    def to(self, at: Ratio) -> tuple[Ratio, list[Need], list[str]]:
        """The speed when a place is reached first after the start, and what that needs, as formulas and in words."""
        distance = self.field.lowest_terms(at - self.q0)
        way, needs = self._way
        speed = self.field.sqrt(self.field.lowest_terms(self._square_at(at)), self.model.samples.is_negative)
        side = 0 if distance.is_zero() else self._side(distance)
        if side == way:
            if not sign_of(distance).is_strict:
                needs = [*needs, (way * distance, ">")]
            needs, says = self._over(self.q0, at, [*needs, self._arrives(at)])
            return way * speed, needs, says
        if self.u0.is_zero() and side:
            is_proved = sign_of(self._drive).is_strict and sign_of(distance).is_strict
            why = Message(
                "{x} starts at rest and sets out the other way; it comes back to its start, and no further",
                x=self.c.name,
            )
            raise (
                NeverHappens(why)
                if is_proved
                else NotReached(Message("{why} (at the parameter values that were tried)", why=why))
            )
        _turn, back, says = self._turning
        if not side:
            return (self.field.zero if self.u0.is_zero() else -self.u0), [*needs, *back], says
        if not sign_of(distance).is_strict:
            needs = [*needs, (-way * distance, ">")]
        needs, more = self._over(self.q0, at, [*needs, *back, self._arrives(at)])
        return -way * speed, needs, [*says, *more]

    def where(self, wanted: Ratio) -> tuple[Ratio, list[Need], list[str]]:
        """The place at which the speed has a value first after the start, and what that needs."""
        way, needs = self._way
        if wanted.is_zero():
            turn, more, says = self._turning
            return turn, [*needs, *more], says
        side = self._side(wanted)
        if not sign_of(wanted).is_strict:
            needs = [*needs, (side * wanted, ">")]
        beyond = self.square - wanted * wanted
        if side == way:
            at, first = self._nearest(beyond, self.q0, way)
            needs, says = self._over(self.q0, at, [*needs, *first])
            return at, needs, says
        turn, more, says = self._turning
        at, first = self._nearest(beyond, turn, -way)
        needs, words = self._over(self.q0, at, [*needs, *more, *first])
        return at, needs, [*says, *words]

    # -- the time -----------------------------------------------------------------------------
    @cached_property
    def integral(self) -> EllipticTime | AlgebraicTime | None:
        """The time along the way up to a constant, where it has a closed form."""
        plain = algebraic_time(self.model, self.c, self.square, self.q0)
        return elliptic_time(self.model, self.c, self.square, self.q0, self.u0) if plain is None else plain

    def time_to(self, at: Ratio) -> tuple[Ratio, list[Need]] | None:
        """How long it takes to a place, as `to` goes there."""
        distance = self.field.lowest_terms(at - self.q0)
        return self._time(at, is_back=distance.is_zero() or self._side(distance) != self._way[0])

    def time_until(self, at: Ratio, wanted: Ratio) -> tuple[Ratio, list[Need]] | None:
        """How long it takes until the speed has a value, at the place that `where` finds."""
        if not wanted.is_zero():
            return self._time(at, is_back=self._side(wanted) != self._way[0])
        law, way = self.integral, self._way[0]
        turned = None if law is None else law.at_turn(way)
        if law is None or turned is None:
            return None
        return self.field.lowest_terms(way * (turned - law.at(self.q0))), list(law.needs)

    def _time(self, at: Ratio, *, is_back: bool) -> tuple[Ratio, list[Need]] | None:
        """On the way out, or after it has turned."""
        law = self.integral
        if law is None:
            return None
        way, _needs = self._way
        begin, end = law.at(self.q0), law.at(at)
        if not is_back:
            return self.field.lowest_terms(way * (end - begin)), list(law.needs)
        turned = law.at_turn(way)
        if turned is None:
            return None
        return self.field.lowest_terms(way * (2 * turned - begin - end)), list(law.needs)

    def period(self) -> tuple[Ratio, list[Need], list[str]] | None:
        """After which time it moves as at the start, and what that needs."""
        law = self.integral
        if law is None or (found := law.period) is None:
            return None
        _way, needs = self._way
        needs, says = [*needs, *law.needs], list[str]()
        if law.highest is not None:
            _turn, more, says = self._turning
            needs += more
        found = self.field.lowest_terms(found)
        return (found if self._side(found) > 0 else -found), needs, says

    def extent(self, side: int) -> tuple[Ratio, list[Need], list[str]]:
        """The farthest place on one side, and what it needs: from rest the start, which energy lets it reach again and
        no more; else where it turns, also where it comes back to after the turn on the other side. What sets out from
        there and never turns has been farthest at the start."""
        way, needs = self._way
        if side == way:
            turn, more, says = self._turning_to(side)
            return turn, [*needs, *more], says
        if self.u0.is_zero():
            return self.q0, needs, []
        try:
            _turn, more, says = self._turning
        except NotReached:
            return self.q0, needs, []
        back = EnergyPath(
            self.model, self.c, self.square, (self.q0, -self.u0, -self._drive), takes_side=self._takes_side
        )
        turn, others, words = back._turning_to(side)
        return turn, [*needs, *more, *others], [*says, *words]

    def _turning_to(self, side: int) -> tuple[Ratio, list[Need], list[str]]:
        """Where it turns on the side to which it sets out. Raises NotReached where it goes on."""
        try:
            return self._turning
        except NotReached:
            why = (
                Message("{x} grows without end at all parameter values that were tried", x=self.c.name)
                if side > 0
                else Message("{x} falls without end at all parameter values that were tried", x=self.c.name)
            )
            raise NotReached(why) from None

    def span(self) -> PassedPlaces:
        """All places that the motion goes through. Raises CannotAnswer where it does not come back."""
        f, turn = self.field, turn_of(self.square, self.c.index)
        if turn is not None:
            begin, whole = self.numbers(self.q0)[0], self.numbers(turn)[0]
            steps = [begin + whole * k / _N_STEPS for k in range(_N_STEPS)]
            if all(self.model.samples.at_start_with(self.square, 0, {self.c.index: v}) > 0 for v in steps):
                _way, needs = self._way
                needs, says = self._over(self.q0, f.lowest_terms(self.q0 + turn), needs)
                return PassedPlaces(None, needs, says)
        (low, below, some), (high, above, more) = (self.extent(side) for side in (-1, 1))
        return PassedPlaces((low, high), [*below, *(need for need in above if need not in below)], [*some, *more])

    def round(self) -> tuple[list[Need], list[str]]:
        """What an angle needs to come all round, in formulas and in words."""
        way, needs = self._way
        whole, turn = 2 * self.field.pi, turn_of(self.square, self.c.index)
        turns = None if turn is None else (whole / turn).fraction()
        if turns is None or turns.denominator != 1:
            raise CannotAnswer(Message("no turn of {x} is as the one before", x=self.c.name))
        return self._over(self.q0, self.field.lowest_terms(self.q0 + way * whole), needs)

    @property
    def turn(self) -> Ratio:
        """Where it turns first. Raises CannotAnswer where that is not found, NotReached where it does not turn."""
        return self._turning[0]

    @property
    def sense(self) -> int:
        """+1 if the coordinate grows at first, else -1."""
        return self._way[0]

    def covered(self, at: Ratio) -> tuple[Ratio, Ratio]:
        """The ends of what the coordinate goes through until it comes to a place first after the start: where it turns
        before, that is an end."""
        distance = self.field.lowest_terms(at - self.q0)
        side = 0 if distance.is_zero() else self._side(distance)
        if side == self._way[0]:
            return self.q0, at
        return self._turning[0], at

    # -- the direction and the end ------------------------------------------------------------
    @cached_property
    def _way(self) -> tuple[int, list[Need]]:
        """+1 if the coordinate grows at first, else -1."""
        way = self._side(self._drive)
        return way, [] if sign_of(self._drive).is_strict else [(way * self._drive, ">")]

    def _side(self, x: Ratio) -> int:
        sign = sign_of(x)
        if sign.is_strict:
            return 1 if sign is Sign.POSITIVE else -1
        ways = [(v > 0) - (v < 0) for v in self.model.samples.at_starts(x)]
        if self._takes_side and ways[0]:
            self._others |= {s for s, way in enumerate(ways) if way != ways[0]}
            return ways[0]
        if len(set(ways)) != 1 or 0 in ways:
            raise CannotAnswer(Message("which way {x} goes depends on the parameter values", x=self.c.name))
        return ways[0]

    @cached_property
    def _turning(self) -> tuple[Ratio, list[Need], list[str]]:
        """The place at which the coordinate turns first, and what that needs."""
        way, _needs = self._way
        if self._never_stops:
            raise NotReached(Message("{x} never turns", x=self.c.name))
        turn, first = self._nearest(self.square, self.q0, way)
        needs, says = self._over(self.q0, turn, [*first, *((x, ">") for x in self._ahead(turn))])
        return turn, needs, says

    def _ahead(self, turn: Ratio) -> list[Ratio]:
        """What must be positive for a place to be on the side on which it was found: where its divisor changes sign it
        goes beyond all bounds, and comes back from the other side."""
        if turn.den is None or sign_of(turn.denominator()) is not Sign.UNKNOWN:
            return []
        divisor = turn.denominator()
        return [divisor if self.numbers(divisor)[0] > 0 else -divisor]

    # -- places -------------------------------------------------------------------------------
    def places(self, x: Ratio) -> Places:
        """The zeros of a function of the coordinate; of an angle also those by whole turns from them."""
        f, found = self.field, Places()
        turn = turn_of(x, self.c.index)
        for zero in zeros_of(self.model, x.numerator(), self.c, quadratic=True):
            zero = f.lowest_terms(zero)
            for n in _TURNS if turn is not None else (0,):
                place = zero if turn is None else zero + n * turn
                found.append((place, self.numbers(place)))
        return found

    def _nearest(self, x: Ratio, start: Ratio, way: int) -> tuple[Ratio, list[Need]]:
        """The zero of a function that is next from the start, at every sample at which there is one, and what it needs
        to be there, and the next one. Raises NotReached where there is none, which factors without a closed form might
        hide."""
        places, picks, starts = self.places(x), set[int](), self.numbers(start)
        for s, begin in enumerate(starts):
            if s in self._others:
                continue
            ahead = [(way * (at[s] - begin), k) for k, (_x, at) in enumerate(places) if way * (at[s] - begin) > _NEAR]
            if ahead and self._takes_side and picks and min(ahead)[1] not in picks:
                self._others.add(s)
            elif ahead:
                picks.add(min(ahead)[1])
        if not picks:
            if not places or self._changes_sign(x, starts, way):
                why = Message("no closed form was found for the place of {x} at which that is so", x=self.c.name)
                raise CannotAnswer(why)
            raise NotReached(
                Message(
                    "{x} does not come to such a place at any of the parameter values that were tried", x=self.c.name
                )
            )
        if len(picks) > 1:
            raise CannotAnswer(
                Message("at which place of {x} that is so first depends on the parameter values", x=self.c.name)
            )
        place = places[picks.pop()][0]
        needs: list[Need] = [(x, ">") for x in reals(place)]
        return place, [*needs, *self._before_others(place, places, start, way)]

    def _before_others(self, place: Ratio, places: Places, start: Ratio, way: int) -> Iterator[Need]:
        """What keeps other zeros from standing between the start and one of them: each is beyond it, or behind the
        start, as at the first sample. Of angles that follow by arcs samples tell it alone."""
        f, (here, begin) = self.field, (self.numbers(x)[0] for x in (place, start))
        for other, at in places:
            if way * (at[0] - here) > _NEAR:
                apart = f.lowest_terms(way * (other - place))
            elif way * (begin - at[0]) > _NEAR:
                apart = f.lowest_terms(way * (start - other))
            else:
                continue
            if sign_of(apart) is Sign.UNKNOWN and not f.ingredients(apart) & f.arguments.keys():
                yield apart, ">"

    def _changes_sign(self, x: Ratio, start: Sequence[float], way: int) -> bool:
        """Whether a function changes its sign ahead of the start, at one sample at least."""
        index, samples = self.c.index, self.model.samples
        return any(
            changes_sign(lambda q, s=s: samples.at_start_with(x, s, {index: way * q}), way * begin)
            for s, begin in enumerate(start)
            if s not in self._others
        )

    def _arrives(self, at: Ratio) -> Need:
        """u^2 at the end of a way, where it can vanish at all: zero is enough for a place where the coordinate turns,
        not for the top of a hill."""
        if self._never_stops:
            return self.field.one, ">"
        slope = self.field.derivative(self.square, self.c.index)
        is_flat = not self._has_value(slope, at) and self.field.follow(slope, {self.c.index: at}).is_zero()
        is_hill = is_flat and not self._is_maximum(at)
        return self._square_at(at), ">" if is_hill else ">="

    @cached_property
    def _never_stops(self) -> bool:
        """Whether u^2 is known to be positive in every pose: what coasts has u^2 = M0 u0^2/M, and M is positive."""
        return self._coasts or sign_of(self.square) is Sign.POSITIVE

    def _has_value(self, x: Ratio, place: Ratio) -> bool:
        """Whether a function is clearly not zero at a place, at one sample at least: then it does not vanish there
        formally."""
        samples, index = self.model.samples, self.c.index
        return any(abs(samples.at_start_with(x, s, {index: v})) > _CLEAR for s, v in enumerate(self.numbers(place)))

    def _is_maximum(self, place: Ratio) -> bool:
        bend = self.field.derivative(self.field.derivative(self.square, self.c.index), self.c.index)
        return all(v < 0 for v in self.numbers(self.field.follow(bend, {self.c.index: place})))

    def _over(self, start: Ratio, end: Ratio, known: Sequence[Need]) -> tuple[list[Need], list[str]]:
        """What a way between two places needs besides what is known: u^2 is positive at each of its minima there. In
        words, where not every minimum has a formula. Raises CannotAnswer where something else is in the way."""
        if self._never_stops:
            return [*known], []
        slope = self.field.derivative(self.square, self.c.index)
        starts, ends = self.numbers(start), self.numbers(end)
        needs: list[Need] = list(known)
        valleys: list[list[float]] = []
        for place, numbers in self.places(slope):
            inside = [
                _NEAR < (v - p) / (q - p) < 1 - _NEAR
                for s, (v, p, q) in enumerate(zip(numbers, starts, ends, strict=True))
                if q != p and s not in self._others
            ]
            if not any(inside):
                continue
            if self._is_maximum(place):
                continue
            valleys.append(numbers)
            least = self.field.lowest_terms(self._square_at(place))
            if all(least != other for other, _relation in needs):
                needs.append((least, ">"))
        is_told = True
        for s, (p, q) in enumerate(zip(starts, ends, strict=True)):
            if (
                s in self._others
                or math.isnan(p)
                or math.isnan(q)
                or not all(self.numbers(x)[s] > -_NEAR for x, _r in needs)
            ):
                continue  # it does not get there with these numbers
            steps = [p + (q - p) * (k + 0.5) / _N_STEPS for k in range(_N_STEPS)]
            heights = [self.model.samples.at_start_with(self.square, s, {self.c.index: v}) for v in steps]
            if not all(h > 0 for h in heights):
                raise CannotAnswer(
                    Message("whether {x} gets there depends on more than could be told in formulas", x=self.c.name)
                )
            near = 2 * abs(q - p) / _N_STEPS
            for before, v, h, after in zip(heights, steps[1:], heights[1:], heights[2:], strict=False):
                if h < before and h < after and not any(abs(valley[s] - v) < near for valley in valleys):
                    is_told = False
        return needs, [] if is_told else [Message("{x} does not turn back on the way there", x=self.c.name)]

    def _square_at(self, place: Ratio) -> Ratio:
        return self.field.follow(self.square, {self.c.index: place})

    def numbers(self, x: Ratio) -> list[float]:
        """An element at every sample."""
        return self.model.samples.at_starts(x)
