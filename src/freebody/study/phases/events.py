"""What ends a phase first, at every parameter set, and when, as a formula."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field

import numpy as np

from freebody.errors import CannotAnswer
from freebody.numeric.jets import Array
from freebody.study.phases.numbers import Chosen, Mask, Sets
from freebody.study.phases.phase import Phase, Watch
from freebody.symbolic.field import Ratio
from freebody.symbolic.phases.course import Course, Energy, Uniform, Zero

_NOW = 1e-9  # a zero at the very start, relative to what the function can become
N_ALONG = 24  # places on the way at which a speed must be real


@dataclass(frozen=True)
class First:
    """A zero of a watched function that comes before all others."""

    watch: Watch
    zero: Zero
    exists: tuple[Ratio, ...]  # positive where it happens at all; elements of the phase's field
    before: tuple[tuple[Ratio, str], ...] = ()  # positive where it comes first

    @property
    def conditions(self) -> list[tuple[Ratio, str]]:
        return [*((x, "it happens") for x in self.exists), *self.before]


@dataclass
class _Candidate:
    """One zero of one watched function, at all sets: how long until it is reached (inf: never)."""

    watch: Watch
    zero: Zero
    reached: Array
    exists: tuple[Ratio, ...] = field(default=())


def first_events(
    phase: Phase, sets: Sets, indices: Chosen, extra: Sequence[Watch] = ()
) -> tuple[list[tuple[First, Chosen]], Chosen]:
    """The events that end a phase, each with the sets at which it comes first, and the sets at which none comes.
    Raises CannotAnswer where the motion, or an event of it, has no closed form."""
    course = phase.course
    mine = np.zeros(sets.n, dtype=bool)
    mine[indices] = True
    candidates: list[_Candidate] = []
    for watch in (*extra, *phase.watches):
        candidates += _candidates(course, watch, sets, mine)
    if not candidates:
        return [], indices
    times = np.array([c.reached for c in candidates])[:, indices]
    # what is asked for comes first where it comes together with something else
    winner = np.argmax(times <= times.min(axis=0) * (1.0 + 1e-9), axis=0)
    happens = np.isfinite(times.min(axis=0))
    found: list[tuple[First, Chosen]] = []
    winners: set[int] = set(winner[happens].tolist())
    for k in sorted(winners):
        mine = indices[happens & (winner == k)]
        chosen = candidates[k]
        before = _before(candidates, k, mine)
        found.append((First(chosen.watch, chosen.zero, chosen.exists, before), mine))
    found.sort(key=lambda item: int(item[1][0]))
    return found, indices[~happens]


def _before(candidates: Sequence[_Candidate], k: int, mine: Chosen) -> tuple[tuple[Ratio, str], ...]:
    """Where another event comes at some of the sets at which this one is first, it must come later."""
    chosen = candidates[k]
    found: list[tuple[Ratio, str]] = []
    for j, other in enumerate(candidates):
        if j == k or other.watch is chosen.watch or not np.isfinite(other.reached[mine]).any():
            continue
        if chosen.zero.time is not None and other.zero.time is not None and np.isfinite(other.reached[mine]).all():
            found.append((other.zero.time - chosen.zero.time, f"before {other.watch.connection} {other.watch.kind}"))
    return tuple(found)


def _candidates(course: Course, watch: Watch, sets: Sets, mine: Mask) -> list[_Candidate]:
    match course:
        case Uniform():
            return _in_time(course, watch, sets, mine)
        case Energy():
            return _on_the_way(course, watch, sets, mine)
        case _:
            return []


def _in_time(course: Uniform, watch: Watch, sets: Sets, mine: Mask) -> list[_Candidate]:
    model = course.model
    try:
        coefficients = course.along(watch.element)
    except CannotAnswer as error:
        raise CannotAnswer(f"when {watch.connection} {watch.kind} has no closed form: {error}") from None
    if len(coefficients) > 3:
        raise CannotAnswer(f"when {watch.connection} {watch.kind} is a root of degree {len(coefficients) - 1}")
    numbers = np.array([sets.evaluate(model, c) for c in coefficients])
    found: list[_Candidate] = []
    for zero in course.zeros(watch.element):
        assert zero.time is not None
        t = sets.evaluate(model, zero.time)
        # positive before, so it falls through zero
        slope = sum((k * c * t ** (k - 1) for k, c in enumerate(numbers) if k), np.zeros(sets.n))
        with np.errstate(invalid="ignore"):
            size = np.abs(numbers[:, :]).max(axis=0) + 1e-300
            good = np.isfinite(t) & (t > _NOW) & (slope < 0) | (
                np.isfinite(t) & (t > _NOW) & (np.abs(slope) < _NOW * size)
            )
        good &= mine
        if good.any():
            found.append(_Candidate(watch, zero, np.where(good, t, np.inf), (zero.time,)))
    return found


def _on_the_way(course: Energy, watch: Watch, sets: Sets, mine: Mask) -> list[_Candidate]:
    model, c = course.model, course.coordinate
    q0 = sets.evaluate(model, course.start.of(c.index))
    u0 = sets.evaluate(model, course.start.of(c.speed))
    a0 = sets.evaluate(
        model, model.field.follow(model.solved_accelerations[model.accelerations[0]], course.start.values)
    )
    way = np.where(np.abs(u0) > _NOW, np.sign(u0), np.sign(a0))
    found: list[_Candidate] = []
    value = course.as_function(watch.element)
    for place in course.places(watch.element):
        at = sets.evaluate(model, place)
        distance = way * (at - q0)
        with np.errstate(invalid="ignore"):
            good = np.isfinite(at) & (distance > 1e-7)
        good &= _passable(course, sets, q0, at)
        # it must be positive on the way there
        middle = sets.evaluate(model, value, {c.index: 0.5 * (q0 + at)}) * (
            way if course.is_odd(watch.element) else 1.0
        )
        with np.errstate(invalid="ignore"):
            good &= mine & (middle > 0)
        if good.any():
            signs: set[float] = set(np.sign(way[good]).tolist())
            if len(signs) > 1:
                raise CannotAnswer(f"whether {c.name} grows or shrinks on the way depends on the parameter values")
            zero = course.at(place, int(signs.pop()))
            found.append(_Candidate(watch, zero, np.where(good, distance, np.inf), course.reachable(zero)))
    return found


def _passable(course: Energy, sets: Sets, q0: Array, at: Array) -> Mask:
    """Where the square of the speed is positive all the way."""
    good = np.ones(sets.n, dtype=bool)
    # the last place is the zero itself, up to round-off
    for share in (*((np.arange(N_ALONG) + 0.5) / N_ALONG), 1.0 - 1e-9):
        with np.errstate(invalid="ignore"):
            place = q0 + share * (at - q0)
            good &= sets.evaluate(course.model, course.square, {course.coordinate.index: place}) > 0
    return good
