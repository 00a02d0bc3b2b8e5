"""What ends a phase first along its way, where energy gives the speed: u^2 = f(q).

It is followed in the direction of the start to the next zero of f, where it turns, and back to the zero of f on the
other side; what has not happened by then never does, since the motion repeats itself. Without such zeros an angle that
stands in sines and cosines alone goes round for ever.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import replace

import numpy as np

from freebody.errors import CannotAnswer
from freebody.language.sentences import Message
from freebody.numeric.jets import Array
from freebody.study.phases.decide import Test, as_test
from freebody.study.phases.ends import (
    NOT_NEGATIVE,
    PossibleEnd,
    PossibleEnds,
    all_hold,
    needed_there,
    no_closed_form,
)
from freebody.study.phases.numbers import Chosen, Mask, Sets
from freebody.study.phases.phase import PhaseWatch
from freebody.study.phases.words import occurs
from freebody.symbolic.phases.course import TAU
from freebody.symbolic.phases.energy_motion import EnergyMotion
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.signs import sign_of
from freebody.symbolic.zeros import reals, turn_of

_NOW = 1e-9  # a place at the very end of the way, relative to it
_HERE = 1e-7  # a place that is the one of the start
_BESIDE = 1e-6  # of a place: just before and just after it
_CLOSE = 1e-5  # a place that round-off may put on either side of the start
N_ALONG = 24  # places on the way at which a speed must be real
_FAR = 1e4  # how far a way without an end is looked along, by its own size
_STEPS = 1e-3 * 1.1 ** np.arange(180)  # at which a turn without a formula is looked for
_HALVINGS = 50
_N_TIMED = 200  # places on a way at which the time is known


def _comes_to_touch(seen: Array, inside: Mask) -> Mask:
    """Where a gap that was open falls below zero, where the place exists at which it touches; or has no number."""
    with np.errstate(invalid="ignore"):
        size = np.abs(seen).max(axis=0)
        was_open = np.logical_or.accumulate(seen > _NOW * size, axis=0)
        negative = seen < -_NOW * size
    falls = negative[1:] & ~negative[:-1] & was_open[:-1] & (inside[1:] | inside[:-1])
    result: Mask = falls.any(axis=0) | np.isnan(seen).any(axis=0)
    return result


class TurnsSomewhere(CannotAnswer):
    """It turns back at a place that has no closed form."""


class EnergyRoad:
    """The way of one coordinate whose speed energy gives, at all sets."""

    def __init__(self, course: EnergyMotion, sets: Sets, indices: Chosen) -> None:
        self.course, self.sets = course, sets
        self.mine = np.zeros(sets.n, dtype=bool)
        self.mine[indices] = True
        model, c = course.model, course.coordinate
        self.model, self.c = model, c
        self.start, self.speed = course.start.of(c.index), course.start.of(c.speed)
        self.push = model.field.follow(
            model.dynamics.solved_accelerations[model.accelerations[model.coordinates.index(c)]], course.start.values
        )
        self.q0, self.u0, self.a0 = (sets.evaluate(model, x) for x in (self.start, self.speed, self.push))
        self.way = np.sign(np.where(self.u0 != 0.0, self.u0, self.a0))
        self.too_near = np.zeros(sets.n, dtype=bool)  # sets at which a place cannot be told from the start in numbers
        turn = turn_of(course.square, c.index)
        self.goes_round = turn is not None
        self.endless = _FAR * np.maximum(np.abs(self.q0), 1.0) if turn is None else np.abs(sets.evaluate(model, turn))
        self.turns = self._variants(course.zeros_of(course.square), course.square)
        self.ahead, self.behind = self._turning(1), self._turning(-1)
        self.wall = self._wall()
        self.behind = np.where(self.u0 == 0.0, 0.0, self.behind)

    def _wall(self) -> Array:
        """The distance to where the speed grows without bound, beyond which no motion goes on (a string that is wound
        up); inf where there is none on the way."""
        below = self.course.square.denominator()
        if self.c.index not in self.model.field.ingredients(below):
            return np.full(self.sets.n, np.inf)
        found = [self._distance(at, 1) for _place, at in self._variants(self.course.zeros_of(below), below)]
        wall = np.min([np.where(np.isfinite(d), d, np.inf) for d in found], axis=0) if found else np.inf
        return np.where(wall < self.ahead, wall, np.inf)

    def _variants(self, places: Sequence[Ratio], of: Ratio) -> list[tuple[Ratio, Array]]:
        """Zeros of a function with their numbers; of an angle also a turn on and a turn back."""
        turn = turn_of(of, self.c.index)
        shifts = (0,) if turn is None else (0, turn, -turn)
        listed = [place + shift if shift else place for shift in shifts for place in places]
        found = [(place, self.sets.evaluate(self.model, place)) for place in listed]
        begins_at_one = self.model.field.follow(of, {self.c.index: self.start}).is_zero()
        for _place, at in found:
            size = self._size(at)
            apart = np.abs(at - self.q0) / np.where(size > 0.0, size, 1.0)  # where both are zero they are one
            near = apart < _CLOSE
            own = self.mine[: self.sets.n_near]  # of other sets it says nothing
            if not near[: self.sets.n_near][own].all():  # else it is the start, however it is written
                # a root and its sign: the start is one branch at some sets, the other one at others
                self.too_near |= near & (apart > _HERE) if begins_at_one else near
        return found

    def _size(self, at: Array) -> Array:
        return np.ones(self.sets.n) if self.goes_round else np.maximum(np.abs(at), np.abs(self.q0))

    def _distance(self, at: Array, direction: int) -> Array:
        """How far ahead (or behind) of the start a place is; nan at the start itself and on the other side."""
        with np.errstate(invalid="ignore"):
            d = direction * self.way * (at - self.q0)
            return np.where(d > _HERE * self._size(at), d, np.nan)

    def _turning(self, direction: int) -> Array:
        """The distance to the next place where the speed vanishes; inf where there is none."""
        found = np.full(self.sets.n, np.inf)
        for _place, at in self.turns:
            d = self._distance(at, direction)
            found = np.where(np.isfinite(d), np.fmin(found, d), found)
        return found

    def events(self, watches: Sequence[PhaseWatch], n_asked: int = 0) -> PossibleEnds:
        """n_asked: so many of the watches, the first ones, are asked for: what comes before a turn is told also where
        the turn itself has no formula."""
        found = PossibleEnds()
        turn: TurnsSomewhere | None = None
        beside = [w for w in watches[n_asked:] if self.course.depends_on_others(w.element)]
        for watch in watches:
            if watch in beside:
                found.unsure.append(())
                continue
            try:
                places = self._variants(self.course.places(watch.element), self.course.as_function(watch.element))
            except CannotAnswer as error:
                raise no_closed_form(watch, error) from None
            for place, at in places:
                found.candidates += self._reached(watch, place, at)
            if not watch.within:
                try:
                    self._require_known(watch, [c for c in found.candidates if c.watch is watch])
                except TurnsSomewhere as error:
                    if not n_asked:
                        raise
                    turn = error
            if watch.within or (not places and sign_of(self.course.as_function(watch.element)) not in NOT_NEGATIVE):
                found.unsure.append(())
        if turn is not None:
            before = self._turn_in_numbers()
            for c in found.candidates:
                c.reached = np.where(c.reached < before, c.reached, np.inf)
            asked = [c for c in found.candidates if c.watch in watches[:n_asked]]
            if not any(np.isfinite(c.reached[self.mine]).any() for c in asked):
                raise turn
            found.is_exact = False
        if beside:
            self._require_apart(beside, found)
        found.tests = self._tests(found.candidates)
        return found

    def _require_apart(self, watches: Sequence[PhaseWatch], found: PossibleEnds) -> None:
        """What depends on other coordinates as well is looked at along the motion up to the first event, in which the
        time passes as int dq/u; sets at which it vanishes, or no event is known, are left out. Raises CannotAnswer
        where that of the model is one of them."""
        first = np.full(self.sets.n, np.min([c.reached for c in found.candidates], axis=0, initial=np.inf))
        self._leave_out(~np.isfinite(first), watches[0])
        f, tau = self.model.field, self.model.field.parameter(TAU)
        along = list(self._timed(first, f.index(tau)))
        for watch in watches:
            gap, *spans = (self.course.in_course(x, tau) for x in (watch.element, *watch.within))
            seen = np.array([self.sets.evaluate(self.model, gap, there) for there in along])
            inside = np.ones(seen.shape, dtype=bool)
            for x in spans:
                inside &= ~np.array([self.sets.evaluate(self.model, x, there) < 0 for there in along])
            self._leave_out(_comes_to_touch(seen, inside), watch)
        found.is_exact = False

    def _leave_out(self, unknown: Mask, watch: PhaseWatch) -> None:
        """Sets at which nobody knows when an event comes; CannotAnswer where that of the model is one of them."""
        unknown = unknown & self.mine & ~self.too_near
        if unknown.any() and (unknown[0] or not self.mine[0]):
            raise CannotAnswer(
                Message("when {contact} {event} has no closed form", contact=watch.connection, event=occurs(watch))
            )
        self.too_near |= unknown

    def _timed(self, first: Array, tau: int) -> Iterator[dict[int, Array]]:
        """States along the way to an event, out to a turn and back again where it is behind one: the coordinate, its
        speed, the time, and cyclic coordinates, which go on by int (dq_k/dt) dt. By d = (a + b)/2 - (b - a)/2 cos s no
        pole of 1/u is left where the way begins or ends at rest."""
        course, time = self.course, np.zeros(self.sets.n)
        cyclic = {k: self.sets.evaluate(self.model, course.start.of(k.index)) for k in course.cyclic}
        turn = np.minimum(first, self.ahead)
        for sign, a, b in ((1.0, np.zeros(self.sets.n), turn), (-1.0, turn, first)):
            shares = (np.arange(_N_TIMED) + 0.5) * math.pi / _N_TIMED if (b > a).any() else ()
            for s in shares:
                with np.errstate(all="ignore"):
                    d = 0.5 * (a + b) - 0.5 * (b - a) * np.cos(s)
                    place = self.q0 + self.way * (d if sign > 0 else 2.0 * turn - d)
                    speed = np.sqrt(self.sets.evaluate(self.model, course.square, {self.c.index: place}))
                    passed = 0.5 * (b - a) * np.sin(s) / speed * math.pi / _N_TIMED
                    step = np.where(b > a, passed, 0.0)
                state = {self.c.index: place, self.c.speed: sign * self.way * speed}
                rates = {k: self.sets.evaluate(self.model, course.rate_of(k), state) for k in cyclic}
                half = 0.5 * step
                yield {**state, tau: time + half, **{k.index: x + half * rates[k] for k, x in cyclic.items()}}
                cyclic = {k: x + step * rates[k] for k, x in cyclic.items()}
                time = time + step

    def _turn_in_numbers(self) -> Array:
        """The distance ahead at which the speed first vanishes, by its sign along the way; inf where it never does."""

        def is_real(d: Array) -> Mask:
            with np.errstate(invalid="ignore"):
                return self.sets.evaluate(self.model, self.course.square, {self.c.index: self.q0 + self.way * d}) >= 0

        size = np.maximum(np.abs(self.q0), 1.0)
        near, far = np.zeros(self.sets.n), np.full(self.sets.n, np.inf)
        for step in _STEPS:
            d = step * size
            real = is_real(d)
            near = np.where(real & np.isinf(far), d, near)
            far = np.where(~real & np.isinf(far), d, far)
        for _ in range(_HALVINGS):
            middle = np.where(np.isfinite(far), (near + far) / 2, near)
            real = is_real(middle)
            near, far = np.where(real, middle, near), np.where(real, far, np.minimum(far, middle))
        return far

    def _reached(self, watch: PhaseWatch, place: Ratio, at: Array) -> list[PossibleEnd]:
        """The place on the way out, and on the way back behind the start."""
        out, back = self._distance(at, 1), self._distance(at, -1)
        with np.errstate(invalid="ignore"):  # the start itself is passed on the way back
            back = np.where((np.abs(at - self.q0) <= _HERE * self._size(at)) & (self.u0 != 0.0), 0.0, back)
        with np.errstate(invalid="ignore"):
            roads = (
                (1, np.where(out <= np.minimum(self.ahead * (1 + _NOW), self.wall), out, np.inf)),
                (
                    -1,
                    np.where(
                        np.isfinite(self.ahead) & np.isinf(self.wall) & (back <= self.behind * (1 + _NOW)),
                        back + 2 * self.ahead,
                        np.inf,
                    ),
                ),
            )
        found: list[PossibleEnd] = []
        for turned, length in roads:
            good = self.mine & np.isfinite(length)
            if watch.kind == "touches":
                good &= ~self._comes_from_behind(watch, at, self.way * turned)
            for sign in (1, -1):
                here = good & (self.way * turned == sign)
                if here.any():
                    zero = self.course.at(place, sign)
                    there = needed_there(self.model, watch, zero)
                    here &= all_hold(self.model, there, self.sets)
                    zero = replace(zero, time=self._time(place, sign, here))
                    exists = (*self.course.reachable(zero), *there)
                    found.append(PossibleEnd(watch, zero, np.where(here, length, np.inf), exists))
        return found

    def _comes_from_behind(self, watch: PhaseWatch, at: Array, way: Array) -> Mask:
        """Where a gap is negative before a place and positive after it: what comes through a face from behind does not
        touch it."""
        step = _BESIDE * self._size(at) * way
        gap = self.course.as_function(watch.element)
        before, after = (self.sets.evaluate(self.model, gap, {self.c.index: at + side * step}) for side in (-1, 1))
        with np.errstate(invalid="ignore"):
            return (before < 0.0) & (after > 0.0)

    def _time(self, place: Ratio, way: int, here: Mask) -> Ratio | None:
        """When the coordinate is first at a place on its way up (+1) or down (-1), by the one formula that says so at
        all of some sets; None where there is none."""
        instants = self.course.instants(place)
        if not instants or not here.any():
            return None
        times, rates = (
            np.array([self.sets.evaluate(self.model, x)[here] for x in xs]) for xs in zip(*instants, strict=True)
        )
        with np.errstate(invalid="ignore"):
            good = (times > 0) & (way * rates >= -_NOW * np.nanmax(np.abs(rates), axis=0, initial=0.0))
        times = np.where(good, times, np.inf)
        picks: list[int] = np.unique(times.argmin(axis=0)[np.isfinite(times.min(axis=0))]).tolist()
        return self.model.field.lowest_terms(instants[picks[0]][0]) if len(picks) == 1 else None

    def _require_known(self, watch: PhaseWatch, own: Sequence[PossibleEnd]) -> None:
        """Up to its first zero a watched function must be positive and the speed real: zeros without a closed form
        show there. Raises CannotAnswer."""
        first = np.min([c.reached for c in own], axis=0) if own else np.full(self.sets.n, np.inf)
        value = self.course.as_function(watch.element)
        is_odd = self.course.is_odd(watch.element)
        out = np.minimum(first, np.minimum(self.ahead, self.wall))
        out = np.where(np.isfinite(out), out, self.endless)
        ends = np.isfinite(first) | ~np.isfinite(self.ahead) | np.isfinite(self.wall)
        back = np.where(ends, 0.0, np.minimum(self.behind, self.endless))
        missed, turned = np.zeros((2, self.sets.n), dtype=bool)
        shares = (np.arange(N_ALONG) + 0.5) / N_ALONG
        for share in shares:
            for d in (share * out, -share * back):
                place = {self.c.index: self.q0 + self.way * d}
                f, square = (self.sets.evaluate(self.model, x, place) for x in (value, self.course.square))
                sign = self.way if is_odd else 1.0
                with np.errstate(invalid="ignore"):
                    missed |= (d != 0) & (sign * f < 0)
                    turned |= (d != 0) & (square < 0)
                if is_odd:
                    break  # its sign turns with the speed: on the way back it has ended
        counts = self.mine & ~self.too_near & (self.way != 0)
        if (turned & counts).any():
            raise TurnsSomewhere(Message("where {coordinate} turns back has no closed form", coordinate=self.c.name))
        if (missed & counts).any():
            raise CannotAnswer(
                Message("when {contact} {event} has no closed form", contact=watch.connection, event=occurs(watch))
            )

    def _tests(self, candidates: Sequence[PossibleEnd]) -> list[Test]:
        """That a place is real and is reached; which way it goes first, and which place is nearer."""
        found: list[Test] = []

        def add(x: Ratio, relation: str = ">", purpose: str = "", against: str = "") -> None:
            found.append(as_test(x, relation, self.sets.evaluate(self.model, x), purpose, against))

        for c in candidates:
            for x in c.exists:
                add(x, ">", Message("it happens"), Message("no event ends it"))
        for place, _at in self.turns:
            for x in reals(place):
                add(x)
        add(self.push if self.speed.is_zero() else self.speed)
        places = [c.zero.at for c in candidates if c.zero.at is not None]
        listed = [*dict.fromkeys(places), *(place for place, _at in self.turns)]
        for j, place in enumerate(listed):
            add(place - self.start)
            for other in listed[:j]:
                add(place - other)
        return found
