"""Where what moves by a law, or by energy, turns back between the start and an event: a way is the sum of its pieces.

    to and fro:  way = |q_1 - q_0| + |q_2 - q_1| + ... + |q_end - q_n|,   q_1 ... q_n the places at which q' = 0

A law in the time gives the instants t_k of q' = 0: how many of them lie before the event is told as it is at the first
sample, with t_n <= t_end <= t_(n+1) as what that needs. A harmonic motion turns every half period at one end or the
other. By energy a place is come to before the first turn, or on the way back from it.
Source: Meriam & Kraige, Dynamics, 8th ed. 2015, sec. 2/2 (net displacement and distance travelled).
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from itertools import count
from math import isfinite

from freebody.errors import CannotAnswer
from freebody.language.sentences import Message
from freebody.symbolic.laws import LawInstant, MotionLaw, first
from freebody.symbolic.laws.base import Need
from freebody.symbolic.motion_laws import MotionLaws
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.reached import Reached
from freebody.symbolic.unknowns import Coordinate

_SAME = 1e-9  # of the time of the event: a turn that comes with it
_MOST = 1000  # turns that are counted
_IN_A_PERIOD = 2  # turns


@dataclass(frozen=True)
class TurnedWay:
    """What is gone through until an event. turns: the places at which it turns, in their order; needs: without what it
    turns more often, or less."""

    turns: list[Ratio]
    needs: list[Need] = field(default_factory=list[Need])


def turned_way(motion: MotionLaws, value: Ratio, reached: Reached) -> TurnedWay | None:
    """Of a measure that is linear in what moves. None where neither a law nor energy tells where it turns. Raises
    CannotAnswer where it turns too often to be counted."""
    f, model = motion.field, motion.model
    inside = f.ingredients(value)
    found = [c for c in model.coordinates if c.index in inside]
    slopes = [f.partial(value, c.index) for c in found]
    is_bound = any(c.index in inside for c in model.dependent)
    if is_bound or not found or f.index(f.time) in inside or any(f.ingredients(x) & model.moving for x in slopes):
        return None
    if len(found) > 1:
        law = motion.law_together(value, found)
        return None if law is None or reached.time is None else _by_law(law, reached.time)
    (c,), (slope,) = found, slopes
    rest = f.lowest_terms(value - slope * f.variable(c.index))
    law = motion.law_of(c, takes_side=True)
    by_time = law is not None and reached.time is not None
    there = reached if reached.coordinate is c else None
    way = _by_law(law, reached.time, there) if by_time else _by_energy(motion, c, reached)
    if way is None:
        return None
    known = {id(q): f.lowest_terms(slope * q + rest) for q in way.turns}
    return TurnedWay([known[id(q)] for q in way.turns], way.needs)


def _by_law(law: MotionLaw | None, end: Ratio | None, there: Reached | None = None) -> TurnedWay | None:
    """By the instants at which the rate of a law is zero. there: where the event is one of what moves by the law."""
    assert law is not None
    assert end is not None
    samples, lowest = law.model.samples, law.model.field.lowest_terms
    until = samples.at_starts(end)[0]
    found = None if law.is_still or not isfinite(until) else _turnings(law)
    if found is None:
        return TurnedWay([]) if law.is_still else None
    turns, needs, last = list[Ratio](), list(found[1]), law.model.field.zero
    for time, place in found[0]:
        now = samples.at_starts(time)[0]
        if now >= until * (1 - _SAME):
            within = _within_a_period(law, there, turns, turns[0] if turns else place)
            if within is not None:
                return TurnedWay(turns, [need for need in (*needs, *within) if not need[0].is_zero()])
            needs.append((lowest(time - end), ">="))
            break
        if len(turns) >= _MOST:
            raise CannotAnswer(Message("it turns back too often on the way to be counted"))
        turns.append(place)
        if law.half_period is None:  # at other values it has turned before the start
            needs.append((lowest(time), ">="))
        last = time
    if turns:
        needs.append((lowest(end - last), ">="))
    return TurnedWay(turns, [need for need in needs if not need[0].is_zero()])


def _within_a_period(
    law: MotionLaw, there: Reached | None, turns: Sequence[Ratio], first_turn: Ratio
) -> list[Need] | None:
    """What tells of a harmonic motion at an event of its own, which comes within a period, how often it has turned: it
    goes on as at first or against that, and is ahead of its start or behind it. None for other laws."""
    if there is None or there.speed is None or law.half_period is None or not law.is_undamped:
        return None
    f, samples = law.model.field, law.model.samples
    sense = 1 if samples.at_starts(f.lowest_terms(first_turn - law.q0))[0] > 0 else -1
    ahead, onward = (f.lowest_terms(sense * x) for x in (there.at - law.q0, there.speed))
    if len(turns) == 1:
        return [(-onward, ">=")]
    return [(onward, ">="), (-ahead if turns else ahead, ">=")] if len(turns) <= _IN_A_PERIOD else None


def _turnings(law: MotionLaw) -> tuple[Iterator[tuple[Ratio, Ratio]], list[Need]] | None:
    """The times after the start at which it turns, and the places, one after the other, and what these need. What does
    not swing turns as often as its rate is zero."""
    instants = law.rates(law.model.field.zero)
    if instants is None:
        return None
    if law.half_period is None:
        times = [(law.model.samples.at_starts(i.time)[0], i) for i in instants[0]]
        after = sorted(((t, i) for t, i in times if t > 0), key=lambda pair: pair[0])
        before = [(-i.time, ">=") for t, i in times if t < 0]
        return ((i.time, i.place) for _t, i in after), before
    found = first(law.model, instants[0])
    return None if found is None else (_swings(law, found.instant), [*instants[1], *found.conditions])


def _swings(law: MotionLaw, begin: LawInstant) -> Iterator[tuple[Ratio, Ratio]]:
    half = law.half_period
    assert half is not None
    places = dict[int, Ratio]()
    for n in count():
        key = n % 2 if law.is_undamped else n
        if key not in places:
            places[key] = law.turned_after(begin, key)
        yield begin.time + n * half, places[key]


def _by_energy(motion: MotionLaws, c: Coordinate, reached: Reached) -> TurnedWay | None:
    """By the first turn on a way by energy: an event there is before it, or on the way back."""
    if reached.coordinate is not c or reached.speed is None:
        return None
    try:
        path = motion.way_of(c)
        distance, speed = (path.numbers(x)[0] for x in (motion.field.lowest_terms(reached.at - path.q0), reached.speed))
        goes_on = path.sense * distance > _SAME and path.sense * speed >= -_SAME
        return TurnedWay([] if goes_on else [path.turn])
    except CannotAnswer:
        return None
