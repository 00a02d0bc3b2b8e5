"""The period of a motion: in closed form from a law of motion or from energy, and from an integration in numbers."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import partial

import numpy as np

from freebody.errors import CannotAnswer, NeverHappens, SaysNothing
from freebody.language.sentences import Message
from freebody.language.units import DIMENSIONLESS
from freebody.measures.base import Measure
from freebody.numeric.engine.course import Status, Trajectory
from freebody.numeric.engine.engine import Engine
from freebody.numeric.engine.evaluator import EngineWatch
from freebody.numeric.jets import Array
from freebody.study.answering.answer import Evidence
from freebody.study.answering.crosscheck import (
    MIN_DRAWS,
    MOTION_TOLERANCE,
    CrossCheck,
    broken,
    element_at,
    holds,
)
from freebody.study.answering.draws import Draw
from freebody.study.answering.finding import Finding, NotHere
from freebody.study.answering.witness import least_rate, patience, run
from freebody.study.setup import Setup
from freebody.symbolic.conditions import Condition, insisted, require
from freebody.symbolic.on_the_way import kept_throughout
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.reached import Reached
from freebody.symbolic.unknowns import Coordinate
from freebody.symbolic.validity import TAKEN

LONGEST = 60.0  # [s] in which a motion without a closed form has to repeat itself
SHORTER = (1 / 32, 1 / 8)  # of the longest motion: most have done in that what is looked for
_N_TURNS = 3  # between the first and the last of which a motion that goes to and fro repeats itself
_MARGIN = 1.6  # periods that are followed: three turns are among them
_CROSSED = ("rising", "falling")
_SAME = 1e-6  # relative: a state that is taken up again
DIED_AWAY = 1e-9  # relative to the way from the start: turns that are no nearer to each other are round-off


def find(setup: Setup, question: str, measure: Measure | None) -> Finding:
    """The closed form. Raises NeverHappens where the motion is proved not to repeat itself, CannotAnswer where none was
    found."""
    found, watched = period_of(setup, measure)
    period = found.time
    assert period is not None
    conditions = insisted(
        (Condition(x, relation, Message("the motion repeats itself")) for x, relation in found.conditions),
        NeverHappens(Message("the motion does not repeat itself")),
    ) + held_throughout(setup)
    check = CrossCheck(question, Message("numerical integration over more than one period"), MOTION_TOLERANCE)
    evidence = checked(setup, check, period, conditions, lambda draw: followed(setup, watched, draw, found))
    if evidence is None:
        needs = ", ".join(broken(setup, conditions))
        raise NotHere(
            Message("the motion does not repeat itself so at the model's own values: that needs {x}", x=needs)
        )
    return Finding(period, evidence, conditions, list(found.notes), list(found.says))


def period_of(setup: Setup, measure: Measure | None) -> tuple[Reached, Measure]:
    """The period of a coordinate, or of a measure in several that moves by itself, and what is watched for it."""
    model = setup.model
    if measure is not None:
        value = model.value_of(measure)
        if sum(c.index in model.field.ingredients(value) for c in model.coordinates) > 1:
            return setup.motion.period_of_sum(value, "it"), measure
    c = coordinate_of(setup, measure)
    return setup.motion.period(c), _watched(setup, measure, c)


def taken_throughout(setup: Setup) -> list[Condition]:
    """Signs that the formulas take as they are at the start, which must be so in all of a motion that comes back."""
    state = setup.state
    taken = [Condition(state.here(setup.model.express(x)), ">", TAKEN) for x in setup.model.samples.assumed]
    needed = [condition for c in taken if (condition := require(c.element, c.relation, c.purpose)[0]) is not None]
    return kept_throughout(setup.motion, needed)


def held_throughout(setup: Setup) -> list[Condition]:
    """The same, and that ideal strings pull and contacts push in all of the motion."""
    held = setup.in_free_coordinates(setup.holding(setup.state), setup.state)
    return kept_throughout(setup.motion, held)


def checked(
    setup: Setup,
    check: CrossCheck,
    x: Ratio | tuple[Ratio, ...],
    conditions: Sequence[Condition],
    number: Callable[[Draw], float | tuple[float, ...]],
    parts: Callable[[Draw], float] = lambda _draw: 0.0,
) -> Evidence | None:
    """One or several elements against what a motion in numbers shows, at draws that satisfy conditions. parts: the size
    of what was added up on the way, asked for where the sum is small. None where too little was compared because the
    model's own values break them."""

    def compare(draw: Draw) -> None:
        exact = element_at(setup, x, draw, draw.start())
        if all(holds(setup, condition, draw, draw.start()) for condition in conditions):
            check.compare(draw, exact, number(draw), partial(parts, draw))

    check.gather(setup.draw_stream(), compare)
    if len(check.pairs) < MIN_DRAWS and setup.has_values and broken(setup, conditions):
        return None
    return check.evidence()


def coordinate_of(setup: Setup, measure: Measure | None) -> Coordinate:
    """The coordinate whose motion repeats itself: the measure, or what it is proportional to."""
    model, f = setup.model, setup.model.field
    if measure is None:
        if len(model.coordinates) != 1:
            name = model.coordinates[0].name if model.coordinates else "x"
            raise CannotAnswer(Message("say of which measure: period of {x}", x=name))
        return model.coordinates[0]
    if not model.coordinates:
        raise CannotAnswer(Message("there is no degree of freedom: nothing goes to and fro"))
    value = model.value_of(measure)
    inside = f.ingredients(value)
    found = [c for c in (*model.coordinates, *model.dependent) if c.index in inside]
    if len(found) != 1 or not f.partial(value, found[0].index).is_constant() or found[0] not in model.coordinates:
        names = ", ".join(c.name for c in model.coordinates)
        raise CannotAnswer(Message("that is told of the coordinates alone: {names}", names=names))
    return found[0]


def _watched(setup: Setup, measure: Measure | None, c: Coordinate) -> Measure:
    measure = measure or setup.model.measure_of(c)
    if measure is None:
        raise CannotAnswer(Message("name a measure whose period is meant"))
    return measure


def followed(setup: Setup, watched: Measure, draw: Draw, found: Reached) -> float:
    """The period in numbers, where a formula tells how long to follow the motion."""
    assert found.time is not None
    (exact,) = element_at(setup, (found.time,), draw, draw.start())
    return period_in_numbers(draw, watched, _MARGIN * exact, is_exact=False)


def number(measure: Measure | None, setup: Setup, draw: Draw) -> float:
    """From an integration alone. Raises CannotAnswer unless the whole state is taken up again."""
    measure = measure or next(iter(setup.system.measures.values()), None)
    if measure is None:
        raise CannotAnswer(Message("name a measure whose period is meant"))
    return period_in_numbers(draw, measure, patience(draw.start(), LONGEST), is_exact=True)


def period_in_numbers(draw: Draw, measure: Measure, until: float, *, is_exact: bool) -> float:
    """From one turn to the next but one; of what turns over, the time of a whole turn. is_exact: whether the whole
    state must be taken up again."""
    first, last = cycle(draw, measure, until, is_exact=is_exact)
    return last - first


def cycle(draw: Draw, measure: Measure, until: float, *, is_exact: bool) -> tuple[float, float]:
    """The instants between which a period is counted. Raises SaysNothing where there is none until `until`."""
    whole = math.tau if measure.dimension == DIMENSIONLESS else None
    return _ends_of_cycle(draw, _watched_motion(draw, measure, until, whole), until, is_exact=is_exact)


def cycle_at_all(draw: Draw, measure: Measure, *, is_exact: bool, whole: float | None = None) -> tuple[float, float]:
    """The same in the longest motion, of which no more is followed than has the turns that count. whole: after which
    way all is as before, of what goes on and on; of an angle a turn."""
    longest = patience(draw.start(), LONGEST)
    if whole is None and measure.dimension == DIMENSIONLESS:
        whole = math.tau
    for share in SHORTER:
        seen = _watched_motion(draw, measure, share * longest, whole)
        if len(seen.turns) >= _N_TURNS:
            return _ends_of_cycle(draw, seen, share * longest, is_exact=is_exact)
    seen = _watched_motion(draw, measure, longest, whole)
    return _ends_of_cycle(draw, seen, longest, is_exact=is_exact)


def _ends_of_cycle(draw: Draw, seen: _WatchedMotion, until: float, *, is_exact: bool) -> tuple[float, float]:
    if len(seen.turns) >= _N_TURNS:
        first, last = seen.turns[0], seen.turns[_N_TURNS - 1]
    elif seen.over and not seen.turns:
        first, last = draw.start().t, seen.over[0]
    else:
        raise SaysNothing(Message("the motion has not repeated itself until t = {t:.6g} s", t=until))
    if is_exact:
        states = [_state(seen.engine, seen.course, k) for k, t in enumerate(seen.course.times) if t in (first, last)]
        if len(states) != 2 or not _is_same(*states) or _has_died_away(seen, first, last):
            raise CannotAnswer(Message("the motion does not repeat itself"))
    return first, last


def _has_died_away(seen: _WatchedMotion, first: float, last: float) -> bool:
    """Whether what is left between two turns is round-off beside the way from the start to there: what repeats itself
    comes back to its start."""
    states = {t: _state(seen.engine, seen.course, k) for k, t in enumerate(seen.course.times)}
    there = states[first]
    left = max(float(np.abs(x - there).max()) for t, x in states.items() if first <= t <= last)
    return left < DIED_AWAY * float(np.abs(states[seen.course.times[0]] - there).max())


def comes_round(draw: Draw, measure: Measure, until: float) -> bool:
    """Whether an angle comes all round before it turns. Raises SaysNothing where it has done neither until `until`."""
    for share in (*SHORTER, 1.0):
        seen = _watched_motion(draw, measure, share * until, math.tau)
        if seen.turns or seen.over:
            return bool(seen.over) and (not seen.turns or seen.over[0] < seen.turns[0])
    raise SaysNothing(Message("the motion has not repeated itself until t = {t:.6g} s", t=until))


@dataclass(frozen=True)
class _WatchedMotion:
    """A motion, the instants at which a measure turns, and at which it has come a whole turn from the start, where that
    is told."""

    engine: Engine
    course: Trajectory
    turns: list[float]
    over: list[float]


def _watched_motion(draw: Draw, measure: Measure, until: float, whole: float | None) -> _WatchedMotion:
    start = draw.start()
    watches = [EngineWatch("turn", measure, 1, size=least_rate(start, measure))]
    if whole is not None:
        there = start.value(measure) + math.copysign(whole, start.rate(measure))
        watches.append(EngineWatch("over", measure, 0, there, size=whole / math.tau))
    engine, course = run(draw.reference, start, np.array([start.t, until]), watches)
    if course.status not in (Status.FINISHED, Status.TOO_LONG):
        raise SaysNothing(course.message or Message("the motion does not go on"))
    turns = [h.time for h in course.events if h.name == "turn" and h.kind in _CROSSED and h.time > start.t]
    over = [h.time for h in course.events if h.name == "over" and h.time > start.t]
    return _WatchedMotion(engine, course, turns, over)


def _state(engine: Engine, course: Trajectory, k: int) -> Array:
    q, v = engine.coordinates(engine.state_at(course, k))
    return np.concatenate([np.ravel(q), np.ravel(v)])


def _is_same(a: Array, b: Array) -> bool:
    return bool(np.allclose(a, b, rtol=_SAME, atol=_SAME * float(np.abs(a).max(initial=1.0))))
