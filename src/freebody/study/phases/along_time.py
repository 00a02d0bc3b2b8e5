"""What ends a phase first along its time: where accelerations are constant, and by laws of the coordinates."""

from __future__ import annotations

from collections.abc import Sequence
from contextlib import suppress

import numpy as np

from freebody.errors import CannotAnswer
from freebody.language.sentences import Message
from freebody.numeric.jets import Array
from freebody.study.phases.decide import Test, as_test
from freebody.study.phases.ends import (
    NOT_NEGATIVE,
    PossibleEnd,
    PossibleEnds,
    Proofs,
    all_hold,
    needed_there,
    no_closed_form,
)
from freebody.study.phases.numbers import Chosen, Mask, Sets
from freebody.study.phases.phase import PhaseWatch
from freebody.study.phases.words import occurs
from freebody.symbolic.phases.course import (
    ClosedFormMotion,
    MotionInTime,
    UniformMotion,
    behind_zeros,
    has_roots,
)
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.signs import sign_of
from freebody.tolerances import LEAST

_NOW = 1e-9  # a zero at the very start, relative to what the function can become
_SOON = 1e-12  # [s] a time that is none
_BESIDE = 1e-6  # of a time: just before and just after it
_LONG = 20.0  # units of time of a law that a motion without an end is looked at
_SHARES = tuple((k + 0.5) / 60 for k in range(60))  # of a motion at which it is looked at
_TIMES = tuple(10.0 ** ((k - 29.5) / 10) for k in range(60))  # [s] where no law of the motion has a unit of time


def in_time(course: UniformMotion, watches: Sequence[PhaseWatch], sets: Sets, indices: Chosen) -> PossibleEnds:
    model, found = course.model, PossibleEnds()
    mine = np.zeros(sets.n, dtype=bool)
    mine[indices] = True
    if any(course.periods(watch.element) for watch in watches):
        return by_laws(course, watches, sets, indices)
    for watch in watches:
        try:
            coefficients = course.sign_along(watch.element)
            parts = course.parts_along(watch.element)
        except CannotAnswer as error:
            raise no_closed_form(watch, error) from None
        open_ones = [part for part in map(behind_zeros, parts) if not has_roots(part)]
        if open_ones:
            raise CannotAnswer(
                Message(
                    "when {contact} {event} is a root of degree {n}",
                    contact=watch.connection,
                    event=occurs(watch),
                    n=len(open_ones[0]) - 1,
                )
            )
        numbers = np.array([sets.evaluate(model, c) for c in coefficients])
        n_before = len(found.candidates)
        for zero in course.zeros(watch.element):
            assert zero.time is not None
            t = sets.evaluate(model, zero.time)
            there = needed_there(model, watch, zero)
            good = _falls(numbers, t) & mine & all_hold(model, there, sets)
            if good.any():
                found.candidates.append(PossibleEnd(watch, zero, np.where(good, t, np.inf), (zero.time, *there)))
                found.tests += [as_test(x, ">", sets.evaluate(model, x)) for x in there]
        if len(found.candidates) == n_before and not all(sign_of(c) in NOT_NEGATIVE for c in coefficients[1:]):
            found.unsure.append(_without_roots(coefficients))
    found.tests = _times_in_order(course, found.candidates, sets) + found.tests
    return found


def _without_roots(c: Sequence[Ratio]) -> Proofs:
    """A polynomial that is not negative at the start stays so: if nothing pulls it down, or it has no two roots."""
    if len(c) != 3:
        return (tuple(c[1:]),)
    return (c[1], c[2]), (c[2], 4 * c[0] * c[2] - c[1] * c[1])


def _falls(numbers: Array, t: Array) -> Mask:
    """Where the polynomial, positive before, falls through zero at the time t."""
    with np.errstate(invalid="ignore", over="ignore"):
        slope = sum((k * c * t ** (k - 1) for k, c in enumerate(numbers) if k), np.zeros(len(t)))
        shares = [np.abs(k * c * t ** (k - 1)) for k, c in enumerate(numbers) if k]
        size = np.max(shares, axis=0) + LEAST
        result: Mask = np.isfinite(t) & (t > _SOON) & (slope < _NOW * size)
    return result


def _before(watch: PhaseWatch) -> str:
    return Message("before {contact} {event}", contact=watch.connection, event=occurs(watch))


def _times_in_order(course: ClosedFormMotion, candidates: Sequence[PossibleEnd], sets: Sets) -> list[Test]:
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
def by_laws(course: MotionInTime, watches: Sequence[PhaseWatch], sets: Sets, indices: Chosen) -> PossibleEnds:
    """Zeros in closed form; that there are no others before the first of them is seen along the motion."""
    model, found = course.model, PossibleEnds()
    mine = np.zeros(sets.n, dtype=bool)
    mine[indices] = True
    too_near = np.zeros(sets.n, dtype=bool)
    functions = {watch: course.over_time(watch.element) for watch in watches}
    tau = model.field.index(course.tau)

    def at(watch: PhaseWatch, t: Array) -> Array:
        return sets.evaluate(model, functions[watch], {tau: t})

    for watch in watches:
        with suppress(CannotAnswer):  # what is seen to vanish without a closed form is refused below
            for zero in course.zeros(watch.element):
                assert zero.time is not None
                t = sets.evaluate(model, zero.time)
                exists = (*zero.needs, *needed_there(model, watch, zero))
                with np.errstate(invalid="ignore"):
                    good = mine & np.isfinite(t) & (t > _SOON) & all_hold(model, exists, sets)
                    before, after = (at(watch, t * (1 + way * _BESIDE)) for way in (-1, 1))
                    # where exponentials are beyond all numbers nothing can be told
                    too_near |= good & (np.isnan(before + after) | sets.loses_digits(model, zero.time))
                    good &= (before > 0) & (after < 0)
                if good.any():
                    found.candidates.append(PossibleEnd(watch, zero, np.where(good, t, np.inf), exists))
                    found.tests += [as_test(x, ">", sets.evaluate(model, x)) for x in exists]
        if all(c.watch is not watch for c in found.candidates):
            found.unsure.append(())
    ends = np.min([c.reached for c in found.candidates], axis=0) if found.candidates else np.full(sets.n, np.inf)
    horizon = _LONG * np.max(_units_of_time(course, watches, sets), axis=0, initial=0.0)
    until = np.where(np.isfinite(ends), ends, horizon)
    for watch in watches:
        seen = np.array([at(watch, np.where(until > 0.0, s * until, t)) for s, t in zip(_SHARES, _TIMES, strict=True)])
        missed = _falls_unseen(at(watch, np.zeros(sets.n)), seen)
        if not (missed & mine & ~too_near).any():
            continue
        if watch.kind != "changes sign" or missed[0] or not mine[0]:
            raise CannotAnswer(
                Message("when {contact} {event} has no closed form", contact=watch.connection, event=occurs(watch))
            )
        too_near |= missed & mine  # beyond a side that formulas take for granted, as of a cart that has broken through
    found.tests = _times_in_order(course, found.candidates, sets) + found.tests
    found.too_near = too_near & mine
    return found


def _falls_unseen(first: Array, seen: Array) -> Mask:
    """Where a function becomes negative. What is negative from the start on, as the gap to the far side of a block, has
    to be positive before it falls."""
    with np.errstate(invalid="ignore"):
        size = np.maximum(np.abs(seen).max(axis=0), np.abs(first))
        negative, positive = seen < -_NOW * size, seen > _NOW * size
        falls = (negative[1:] & np.logical_or.accumulate(positive, axis=0)[:-1]).any(axis=0)
        result: Mask = negative.any(axis=0) & (falls | ~(first < -_NOW * size))
    return result


def _units_of_time(course: MotionInTime, watches: Sequence[PhaseWatch], sets: Sets) -> Array:
    """[s] (n_units, n_sets) in which the laws of a motion, or the waves that drive it, do what they do."""
    if isinstance(course, UniformMotion):
        periods = [period for watch in watches for period in course.periods(watch.element)]
        return np.array([np.abs(sets.evaluate(course.model, period)) for period in periods]).reshape(-1, sets.n)
    units = [np.abs(sets.evaluate(course.model, unit)) for unit in course.units_of_time]
    return np.array(units).reshape(-1, sets.n)
