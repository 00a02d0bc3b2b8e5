"""How far a motion gets: the place at which it turns, in closed form, and in numbers."""

from __future__ import annotations

from contextlib import suppress
from dataclasses import replace

import numpy as np

from freebody.errors import CannotAnswer, NeverHappens, RoutesDisagree, SaysNothing
from freebody.language.sentences import Message
from freebody.measures.base import Measure
from freebody.numeric.engine.course import Status, Trajectory
from freebody.numeric.engine.engine import Engine
from freebody.numeric.engine.evaluator import EngineWatch
from freebody.questions.base import Wanted
from freebody.questions.event_base import QuestionEvent
from freebody.questions.reading import Question
from freebody.questions.turned_round import REACHED, RangeFor
from freebody.study.answering.answer import Evidence
from freebody.study.answering.crosscheck import (
    MOTION_TOLERANCE,
    CrossCheck,
    broken,
    element_at,
    holds,
)
from freebody.study.answering.draws import Draw
from freebody.study.answering.finding import Finding, NotHere
from freebody.study.answering.parameter_domain import is_within
from freebody.study.answering.repeated import DIED_AWAY, SHORTER, checked, coordinate_of, taken_throughout
from freebody.study.answering.witness import least_rate, patience, run, snapshots
from freebody.study.setup import Setup
from freebody.symbolic.conditions import Condition, insisted
from freebody.symbolic.on_the_way import kept_until
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.reached import Reached
from freebody.symbolic.signs import Sign, sign_of
from freebody.symbolic.unknowns import Coordinate
from freebody.symbolic.validity import TAKEN

LONGEST = 60.0  # [s] in which a motion has to turn
_N_STEPS = 65  # to the last of the turns
_N_TURNS = 2  # of a motion that goes to and fro: both sides


def as_reached(question: Question, q: Wanted) -> Question | None:
    """That a measure just reaches the place where it is to turn, which needs no formula of where it turns. None where
    something else is to have a value."""
    if q.of.turn is None or q.relation != "=":
        return None
    of, turn, _side = q.of.turn
    if not isinstance(turn, QuestionEvent):  # a peak of what no measure is
        return None
    event = QuestionEvent(turn.measure, 0, q.target, q.text)
    asked = RangeFor(q.parameter, of, q.target, question.quantity.dimension, question.quantity.unit, q.text, REACHED)
    return replace(question, quantity=asked, event=event, options={}, key=None)


def turning_there(setup: Setup, question: Question, q: Wanted, found: Finding) -> Finding | None:
    """Of the ends of the range of a parameter in which a place is reached those at which the motion turns in it: where
    it stops being a motion that turns it ends as well. None where it turns there at none of them."""
    assert q.of.turn is not None
    _of, turn, side = q.of.turn
    assert isinstance(turn, QuestionEvent)
    parameter, ends = setup.system.parameters[q.parameter], found.element
    kept: list[tuple[Ratio, Evidence]] = []
    for value in ends if isinstance(ends, tuple) else (ends,):
        if not isinstance(value, Ratio):
            continue
        route = Message("the value put in for the parameter, numerical integration until it has turned on both sides")
        check = CrossCheck(question.text, route, MOTION_TOLERANCE)

        def compare(draw: Draw, value: Ratio = value, check: CrossCheck = check) -> None:
            (number,) = element_at(setup, value, draw, draw.start())
            if is_within(parameter, number) and all(holds(setup, c, draw, draw.start()) for c in found.conditions):
                made = draw.with_values(draw.values | {q.parameter: number}, setup.system)
                extreme = extent_in_numbers(made, turn.measure, side, turns=True)
                check.compare(made, made.reference.number(q.target), extreme)

        with suppress(CannotAnswer, RoutesDisagree):
            kept.append((value, check.gather(setup.draw_stream(), compare).evidence()))
    if not kept:
        return None
    element = kept[0][0] if len(kept) == 1 else tuple(value for value, _evidence in kept)
    return replace(
        found, element=element, evidence=max((e for _x, e in kept), key=lambda e: e.worst_relative_difference)
    )


def find(setup: Setup, question: str, measure: Measure, side: int, name: str) -> Finding:
    """The closed form. side: +1 for the greatest value, -1 for the least."""
    _c, found, x = turn_of(setup, measure, side, name)
    is_start = (x - setup.start_instant.value(measure)).is_zero()
    told = Message("it sets out to the other side") if is_start else Message("it turns")
    conditions = insisted(
        (Condition(part, relation, told) for part, relation in found.conditions),
        NeverHappens(Message("it does not turn")),
    )
    taken, kept = taken_throughout(setup), kept_on_the_way(setup, found)
    if not any(c.element.field.ingredients(c.element) & setup.model.moving for c in taken):
        kept = [*taken, *(c for c in kept if c.purpose != TAKEN)]  # told of all of the motion, in parameters
    conditions += kept
    check = CrossCheck(question, Message("numerical integration until it has turned on both sides"), MOTION_TOLERANCE)
    evidence = checked(
        setup, check, x, conditions, lambda draw: extent_in_numbers(draw, measure, side, turns=not is_start)
    )
    if evidence is None:
        needs = ", ".join(broken(setup, conditions))
        raise NotHere(Message("it does not turn so at the model's own values: that needs {x}", x=needs))
    return Finding(x, evidence, conditions, list(found.notes), list(found.says))


def goes_one_way(setup: Setup, measure: Measure) -> bool:
    """Whether a measure grows with its coordinate, or falls with it, wherever that is: then it turns with it. The
    height of a pendulum's bob does not."""
    f, value = setup.model.field, setup.model.value_of(measure)
    own = [c for c in setup.model.coordinates if c.index in f.ingredients(value)]
    return len(own) != 1 or sign_of(f.partial(value, own[0].index)).is_strict


def kept_on_the_way(setup: Setup, found: Reached) -> list[Condition]:
    """What the formulas take to be so, and what holds things together, from the start to an event."""
    kept = setup.in_free_coordinates(setup.holding(setup.state), setup.state)
    return kept_until(setup.motion, found, kept)


def turn_of(setup: Setup, measure: Measure, side: int, name: str) -> tuple[Coordinate, Reached, Ratio]:
    """The coordinate of a measure, the turn on that side, and the measure there."""
    f, value = setup.model.field, setup.model.value_of(measure)
    several = [c for c in setup.model.coordinates if c.index in f.ingredients(value)]
    if len(several) > 1:
        found = setup.motion.extent_of_sum(value, name, side)
        return several[0], found, f.lowest_terms(found.at)
    c = coordinate_of(setup, measure)
    slope = sign_of(f.partial(value, c.index))
    if not slope.is_strict:
        raise CannotAnswer(Message("which way the measure grows depends on the parameter values"))
    found = setup.motion.extent(c, side if slope is Sign.POSITIVE else -side)
    return c, found, f.lowest_terms(f.follow(value, {c.index: found.at}))


def _real_turns(turns: list[float], values: dict[float, float]) -> list[float]:
    """The instants at which a measure turns, up to where what is left of its motion is round-off beside the way that it
    has come. values: of the measure, at the ends and at the turns."""
    known = [t for t in turns if t in values]
    if len(known) < len(turns) or not known:
        return turns
    ends = list(values)
    for k, t in enumerate(known):
        after = known[k + 1] if k + 1 < len(known) else ends[-1]
        if after > t and abs(values[after] - values[t]) < DIED_AWAY * abs(values[ends[0]] - values[t]):
            return known[:k]
    return known


def extent_in_numbers(draw: Draw, measure: Measure, side: int, *, turns: bool = False) -> float:
    """The farthest of the start and the first two turns. turns: it is known to turn there, so that a motion which has
    not done so yet says nothing."""
    return farthest_in_numbers(draw, measure, side, turns=turns)[0]


def farthest_in_numbers(draw: Draw, measure: Measure, side: int, *, turns: bool = False) -> tuple[float, float]:
    """The same, and when it gets there."""
    start, reference = draw.start(), draw.reference
    watches = [EngineWatch("turn", measure, 1, size=least_rate(start, measure))]

    longest = patience(start, LONGEST)

    def followed(share: float) -> tuple[Engine, Trajectory, list[float]]:
        engine, course = run(reference, start, np.array([start.t, start.t + share * longest]), watches)
        at = [h.time for h in course.events if h.kind in ("rising", "falling") and h.time > start.t]
        seen = dict(zip(course.times, snapshots(reference, engine, course, start), strict=False)) if at else {}
        return engine, course, _real_turns(at, {t: s.value(measure) for t, s in seen.items()})[:_N_TURNS]

    in_short = (seen for share in SHORTER if len((seen := followed(share))[2]) == _N_TURNS)
    engine, course, at = next(in_short, None) or followed(1.0)
    goes_on = course.status in (Status.FINISHED, Status.TOO_LONG)
    if not at:  # it only goes away from there
        seen = list(snapshots(reference, engine, course, start)) if goes_on and not turns else []
        if seen and side * (seen[-1].value(measure) - start.value(measure)) <= 0.0:
            return start.value(measure), start.t
        raise SaysNothing(Message("the motion has not turned until t = {t:.6g} s", t=course.t_end))
    # in small steps, so that an angle of a line is counted on through more than half a turn; turns are among them
    engine, course = run(reference, start, np.linspace(start.t, at[-1], _N_STEPS), watches)
    farthest, when = max((side * s.value(measure), s.t) for s in snapshots(reference, engine, course, start))
    if turns and len(at) < _N_TURNS and farthest <= side * start.value(measure):  # it has turned on the other side only
        raise SaysNothing(Message("the motion has not turned until t = {t:.6g} s", t=course.t_end))
    if side * start.value(measure) >= farthest:
        return start.value(measure), start.t
    return side * farthest, when
