"""What ends a phase first, at every parameter set, and when, as a formula.

A motion that is uniform is followed along its time. Where energy gives the speed, u^2 = f(q), it is followed along its
way: in the direction of the start to the next zero of f, where it turns, and back to the zero of f on the other side;
what has not happened by then never does, since the motion repeats itself. Without such zeros an angle that stands in
sines and cosines alone goes round for ever.
"""

from __future__ import annotations

from collections.abc import Sequence
from contextlib import suppress
from dataclasses import dataclass, field

import numpy as np

from freebody.errors import CannotAnswer
from freebody.language.sentences import Message
from freebody.numeric.jets import Array
from freebody.study.phases.decide import NOTHING, Cell, Inequality, Test, as_test, cells
from freebody.study.phases.numbers import Chosen, Mask, Sets
from freebody.study.phases.phase import Phase, PhaseWatch
from freebody.study.phases.words import occurs
from freebody.symbolic.field import Ratio
from freebody.symbolic.laws import Decay, Growth, MotionLaw, Oscillation
from freebody.symbolic.model import SymbolicModel
from freebody.symbolic.phases.course import ClosedFormMotion, CourseZero, EnergyMotion, LawMotion, UniformMotion
from freebody.symbolic.signs import Sign, sign_of

_NOW = 1e-9  # a zero at the very start, relative to what the function can become
_SOON = 1e-12  # [s] a time that is none
_HERE = 1e-7  # a place that is the one of the start
_CLOSE = 1e-5  # a place that round-off may put on either side of the start
_BESIDE = 1e-6  # of a time: just before and just after it
_LONG = 20.0  # units of time of a law that a motion without an end is looked at
_SHARES = tuple((k + 0.5) / 60 for k in range(60))  # of a motion at which it is looked at
N_ALONG = 24  # places on the way at which a speed must be real
_FAR = 1e4  # how far a way without an end is looked along, by its own size
_NOT_NEGATIVE = (Sign.POSITIVE, Sign.NONNEGATIVE, Sign.ZERO)


@dataclass(frozen=True)
class FirstEvent:
    """A zero of a watched function that comes before all others."""

    watch: PhaseWatch
    zero: CourseZero
    together: tuple[PhaseWatch, ...] = ()  # what else happens at the same instant


Proofs = tuple[tuple[Ratio, ...], ...]  # groups of elements; where all of one group are not negative, it is proved


@dataclass(frozen=True)
class PhaseOutcome:
    """How a phase ends in one part of the space of parameters; without `first` it lasts. The inequalities are over
    elements of the phase's field. `unsure`: what ends it at none of the sets, each by the inequalities of which one
    group must hold for a proof of that."""

    first: FirstEvent | None
    sets: Chosen
    conditions: tuple[Inequality, ...]
    is_exact: bool
    unsure: tuple[Proofs, ...] = ()


@dataclass
class _Candidate:
    """One zero of one watched function, at all sets: how long until it is reached (inf: never)."""

    watch: PhaseWatch
    zero: CourseZero
    reached: Array
    exists: tuple[Ratio, ...] = field(default=())  # positive where it happens at all


@dataclass
class _PossibleEnds:
    """What can end a phase, the inequalities that tell which does, and what is known to last by formulas."""

    candidates: list[_Candidate] = field(default_factory=list[_Candidate])
    tests: list[Test] = field(default_factory=list[Test])
    unsure: list[Proofs] = field(default_factory=list[Proofs])  # what vanishes at none of the sets


def first_events(phase: Phase, sets: Sets, indices: Chosen, extra: Sequence[PhaseWatch] = ()) -> list[PhaseOutcome]:
    """The events that end a phase, each with the sets at which it comes first. Raises CannotAnswer where the motion, or
    an event of it, has no closed form."""
    watches = (*extra, *phase.watches)
    match phase.course:
        case UniformMotion() as course:
            found = _in_time(course, watches, sets, indices)
        case LawMotion() as course:
            found = _by_laws(course, watches, sets, indices)
        case EnergyMotion() as course:
            road = _Road(course, sets, indices)
            found = road.events(watches)
            indices = np.setdiff1d(indices, np.flatnonzero(road.too_near))
            sets.left_out |= road.too_near
        case _:
            found = _PossibleEnds(unsure=[() for _watch in watches])
    candidates = found.candidates
    labels = np.full(sets.n, NOTHING)
    if candidates:
        times = np.array([c.reached for c in candidates])
        # what is asked for comes first where it comes together with something else
        winner = np.argmax(times <= times.min(axis=0) * (1.0 + 1e-9), axis=0)
        labels = np.where(np.isfinite(times.min(axis=0)), winner, NOTHING)
    return [_outcome(cell, found) for cell in cells(labels, indices, found.tests)]


def _outcome(cell: Cell, found: _PossibleEnds) -> PhaseOutcome:
    unsure = tuple(found.unsure)
    if cell.label == NOTHING:
        return PhaseOutcome(None, cell.sets, cell.cuts, cell.is_exact, unsure)
    chosen = found.candidates[cell.label]
    with np.errstate(invalid="ignore"):
        others = [c for c in found.candidates if c.watch is not chosen.watch]
        same = [c.watch for c in others if np.allclose(c.reached[cell.sets], chosen.reached[cell.sets], 1e-9, 0.0)]
    needs = tuple((x, ">", Message("it happens")) for x in chosen.exists)
    cuts = tuple(cut for cut in cell.cuts if not any(cut[0] == x for x, _r, _p in needs))
    return PhaseOutcome(
        FirstEvent(chosen.watch, chosen.zero, tuple(same)), cell.sets, (*needs, *cuts), cell.is_exact, unsure
    )


# -- along the time ---------------------------------------------------------------------------
def _in_time(course: UniformMotion, watches: Sequence[PhaseWatch], sets: Sets, indices: Chosen) -> _PossibleEnds:
    model, found = course.model, _PossibleEnds()
    mine = np.zeros(sets.n, dtype=bool)
    mine[indices] = True
    for watch in watches:
        try:
            coefficients = course.along(watch.element)
        except CannotAnswer as error:
            raise _no_closed_form(watch, error) from None
        n_now = next((k for k, c in enumerate(coefficients) if not c.is_zero()), 0)  # zeros at the start itself
        if len(coefficients) - n_now > 3:
            raise CannotAnswer(
                Message(
                    "when {contact} {event} is a root of degree {n}",
                    contact=watch.connection,
                    event=occurs(watch),
                    n=len(coefficients) - 1 - n_now,
                )
            )
        numbers = np.array([sets.evaluate(model, c) for c in coefficients])
        n_before = len(found.candidates)
        for zero in course.zeros(watch.element):
            assert zero.time is not None
            t = sets.evaluate(model, zero.time)
            there = _where(model, watch, zero)
            good = _falls(numbers, t) & mine & _all_hold(model, there, sets)
            if good.any():
                found.candidates.append(_Candidate(watch, zero, np.where(good, t, np.inf), (zero.time, *there)))
                found.tests += [as_test(x, ">", sets.evaluate(model, x)) for x in there]
        if len(found.candidates) == n_before and not all(sign_of(c) in _NOT_NEGATIVE for c in coefficients[1:]):
            found.unsure.append(_without_roots(coefficients))
    found.tests = _times_in_order(course, found.candidates, sets) + found.tests
    return found


def _no_closed_form(watch: PhaseWatch, error: CannotAnswer) -> CannotAnswer:
    told = Message(
        "when {contact} {event} has no closed form: {why}", contact=watch.connection, event=occurs(watch), why=error
    )
    return CannotAnswer(told)


def _without_roots(c: Sequence[Ratio]) -> Proofs:
    """A polynomial that is not negative at the start stays so: if nothing pulls it down, or it has no two roots."""
    if len(c) != 3:
        return (tuple(c[1:]),)
    return (c[1], c[2]), (c[2], 4 * c[0] * c[2] - c[1] * c[1])


def _where(model: SymbolicModel, watch: PhaseWatch, zero: CourseZero) -> tuple[Ratio, ...]:
    """What must be positive for the place that touches to exist at that instant."""
    f = model.field
    found = (f.lowest_terms(f.follow(model.in_independent_speeds(x), zero.values)) for x in watch.within)
    return tuple(x for x in found if not x.is_zero())


def _all_hold(model: SymbolicModel, elements: Sequence[Ratio], sets: Sets) -> Mask:
    found = np.ones(sets.n, dtype=bool)
    with np.errstate(invalid="ignore"):
        for x in elements:
            found &= sets.evaluate(model, x) > 0
    return found


def _falls(numbers: Array, t: Array) -> Mask:
    """Where the polynomial, positive before, falls through zero at the time t."""
    with np.errstate(invalid="ignore", over="ignore"):
        slope = sum((k * c * t ** (k - 1) for k, c in enumerate(numbers) if k), np.zeros(len(t)))
        shares = [np.abs(k * c * t ** (k - 1)) for k, c in enumerate(numbers) if k]
        size = np.max(shares, axis=0) + 1e-300
        result: Mask = np.isfinite(t) & (t > _SOON) & (slope < _NOW * size)
    return result


def _before(watch: PhaseWatch) -> str:
    return Message("before {contact} {event}", contact=watch.connection, event=occurs(watch))


def _times_in_order(course: ClosedFormMotion, candidates: Sequence[_Candidate], sets: Sets) -> list[Test]:
    """That a time is real, that it comes, and that it comes before another one."""
    model, found = course.model, list[Test]()
    times = [c.zero.time for c in candidates]
    for t in times:
        assert t is not None
        for g in sorted(model.field.ingredients(t)):
            if model.field.generators[g].kind == "root" and model.field.generators[g].made_of:
                inside = model.field.radicand(g)
                found.append(
                    as_test(
                        inside, ">", sets.evaluate(model, inside), Message("it happens"), Message("no event ends it")
                    )
                )
    for t in times:
        assert t is not None
        found.append(as_test(t, ">", sets.evaluate(model, t), Message("it happens"), Message("no event ends it")))
    for j, one in enumerate(candidates):
        for k, other in enumerate(candidates[:j]):
            s, t = times[j], times[k]
            assert s is not None
            assert t is not None
            if one.watch is other.watch:
                continue
            words = (_before(c.watch) for c in (one, other))
            found.append(as_test(s - t, ">", sets.evaluate(model, s - t), *words))
    return found


# -- along laws of the time -----------------------------------------------------------------------
def _by_laws(course: LawMotion, watches: Sequence[PhaseWatch], sets: Sets, indices: Chosen) -> _PossibleEnds:
    """Zeros in closed form; that there are no others before the first of them is seen along the motion."""
    model, found = course.model, _PossibleEnds()
    mine = np.zeros(sets.n, dtype=bool)
    mine[indices] = True
    functions = {watch: course.over_time(watch.element) for watch in watches}
    tau = model.field.index(course.tau)

    def at(watch: PhaseWatch, t: Array) -> Array:
        return sets.evaluate(model, functions[watch], {tau: t})

    for watch in watches:
        with suppress(CannotAnswer):  # what is seen to vanish without a closed form is refused below
            for zero in course.zeros(watch.element):
                assert zero.time is not None
                t = sets.evaluate(model, zero.time)
                exists = (*zero.needs, *_where(model, watch, zero))
                with np.errstate(invalid="ignore"):
                    good = mine & np.isfinite(t) & (t > _SOON) & _all_hold(model, exists, sets)
                    good &= (at(watch, t * (1 - _BESIDE)) > 0) & (at(watch, t * (1 + _BESIDE)) < 0)
                if good.any():
                    found.candidates.append(_Candidate(watch, zero, np.where(good, t, np.inf), exists))
                    found.tests += [as_test(x, ">", sets.evaluate(model, x)) for x in exists]
        if all(c.watch is not watch for c in found.candidates):
            found.unsure.append(())
    ends = np.min([c.reached for c in found.candidates], axis=0) if found.candidates else np.full(sets.n, np.inf)
    horizon = _LONG * np.max([_unit_of_time(model, law, sets) for law in course.laws], axis=0)
    until = np.where(np.isfinite(ends), ends, horizon)
    for watch in watches:
        seen = np.array([at(watch, share * until) for share in _SHARES])
        with np.errstate(invalid="ignore"):
            missed = (seen < -_NOW * np.abs(seen).max(axis=0)).any(axis=0)
        if (missed & mine).any():
            raise CannotAnswer(
                Message("when {contact} {event} has no closed form", contact=watch.connection, event=occurs(watch))
            )
    found.tests = _times_in_order(course, found.candidates, sets) + found.tests
    return found


def _unit_of_time(model: SymbolicModel, law: MotionLaw, sets: Sets) -> Array:
    """[s] In which a law does what it does; 0 for constant acceleration."""
    match law:
        case Oscillation() | Growth():
            return 1.0 / np.sqrt(sets.evaluate(model, law.square))
        case Decay():
            return 1.0 / np.abs(sets.evaluate(model, law.gamma))
        case _:
            return np.zeros(sets.n)


# -- along the way ----------------------------------------------------------------------------
class _Road:
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
        self.goes_round = self._is_periodic(course.square)
        self.turns = self._variants(course.zeros_of(course.square), course.square)
        self.ahead, self.behind = self._turning(1), self._turning(-1)
        self.behind = np.where(self.u0 == 0.0, 0.0, self.behind)

    def _is_periodic(self, x: Ratio) -> bool:
        """Whether the coordinate is an angle that stands in sines and cosines alone."""
        return self.c.index not in x.generators()

    def _variants(self, places: Sequence[Ratio], of: Ratio) -> list[tuple[Ratio, Array]]:
        """Zeros of a function with their numbers; of an angle also a turn on and a turn back."""
        whole = 2 * self.model.field.pi
        shifts = (0, 1, -1) if self._is_periodic(of) else (0,)
        listed = [place + k * whole if k else place for k in shifts for place in places]
        found = [(place, self.sets.evaluate(self.model, place)) for place in listed]
        for _place, at in found:
            near = np.abs(at - self.q0) < _CLOSE * self._size(at)
            if not near[: self.sets.n_near].all():  # else it is the start, however it is written
                self.too_near |= near
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

    def events(self, watches: Sequence[PhaseWatch]) -> _PossibleEnds:
        found = _PossibleEnds()
        for watch in watches:
            try:
                places = self._variants(self.course.places(watch.element), self.course.as_function(watch.element))
            except CannotAnswer as error:
                raise _no_closed_form(watch, error) from None
            for place, at in places:
                found.candidates += self._reached(watch, place, at)
            if not watch.within:
                self._require_known(watch, [c for c in found.candidates if c.watch is watch])
            if watch.within or (not places and sign_of(self.course.as_function(watch.element)) not in _NOT_NEGATIVE):
                found.unsure.append(())
        found.tests = self._tests(found.candidates)
        return found

    def _reached(self, watch: PhaseWatch, place: Ratio, at: Array) -> list[_Candidate]:
        """The place on the way out, and on the way back behind the start."""
        out, back = self._distance(at, 1), self._distance(at, -1)
        with np.errstate(invalid="ignore"):  # the start itself is passed on the way back
            back = np.where((np.abs(at - self.q0) <= _HERE * self._size(at)) & (self.u0 != 0.0), 0.0, back)
        with np.errstate(invalid="ignore"):
            roads = (
                (1, np.where(out <= self.ahead * (1 + _NOW), out, np.inf)),
                (
                    -1,
                    np.where(
                        np.isfinite(self.ahead) & (back <= self.behind * (1 + _NOW)), back + 2 * self.ahead, np.inf
                    ),
                ),
            )
        found: list[_Candidate] = []
        for turned, length in roads:
            good = self.mine & np.isfinite(length)
            for sign in (1, -1):
                here = good & (self.way * turned == sign)
                if here.any():
                    zero = self.course.at(place, sign)
                    if turned < 0:
                        zero = CourseZero(None, zero.values, zero.at)
                    there = _where(self.model, watch, zero)
                    here &= _all_hold(self.model, there, self.sets)
                    exists = (*self.course.reachable(zero), *there)
                    found.append(_Candidate(watch, zero, np.where(here, length, np.inf), exists))
        return found

    def _require_known(self, watch: PhaseWatch, own: Sequence[_Candidate]) -> None:
        """Up to its first zero a watched function must be positive and the speed real: zeros without a closed form
        show there. Raises CannotAnswer."""
        first = np.min([c.reached for c in own], axis=0) if own else np.full(self.sets.n, np.inf)
        value = self.course.as_function(watch.element)
        is_odd = self.course.is_odd(watch.element)
        out = np.minimum(first, self.ahead)
        endless = 2 * np.pi if self.goes_round else _FAR * np.maximum(np.abs(self.q0), 1.0)
        out = np.where(np.isfinite(out), out, endless)
        back = np.where(np.isfinite(first) | ~np.isfinite(self.ahead), 0.0, np.minimum(self.behind, endless))
        missed = np.zeros(self.sets.n, dtype=bool)
        shares = (np.arange(N_ALONG) + 0.5) / N_ALONG
        for share in shares:
            for d in (share * out, -share * back):
                place = {self.c.index: self.q0 + self.way * d}
                f, square = (self.sets.evaluate(self.model, x, place) for x in (value, self.course.square))
                sign = self.way if is_odd else 1.0
                with np.errstate(invalid="ignore"):
                    missed |= (d != 0) & ((sign * f < 0) | (square < 0))
                if is_odd:
                    break  # its sign turns with the speed: on the way back it has ended
        if (missed & self.mine & ~self.too_near & (self.way != 0)).any():
            raise CannotAnswer(
                Message("when {contact} {event} has no closed form", contact=watch.connection, event=occurs(watch))
            )

    def _tests(self, candidates: Sequence[_Candidate]) -> list[Test]:
        """That a place is real and is reached; which way it goes first, and which place is nearer."""
        found: list[Test] = []

        def add(x: Ratio, relation: str = ">", purpose: str = "", against: str = "") -> None:
            found.append(as_test(x, relation, self.sets.evaluate(self.model, x), purpose, against))

        for c in candidates:
            for x in c.exists:
                add(x, ">", Message("it happens"), Message("no event ends it"))
        for place, _at in self.turns:
            for x in self.course.real(place):
                add(x)
        add(self.push if self.speed.is_zero() else self.speed)
        places = [c.zero.at for c in candidates if c.zero.at is not None]
        listed = [*dict.fromkeys(places), *(place for place, _at in self.turns)]
        for j, place in enumerate(listed):
            add(place - self.start)
            for other in listed[:j]:
                add(place - other)
        return found
