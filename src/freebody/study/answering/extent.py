"""How far a motion gets: the place at which it turns, in closed form, and in numbers."""

from __future__ import annotations

import numpy as np

from freebody.budgets import allowed
from freebody.errors import CannotAnswer, NeverHappens
from freebody.language.sentences import Message
from freebody.measures.base import Measure
from freebody.numeric.engine.course import Status
from freebody.numeric.engine.engine import Engine
from freebody.numeric.engine.evaluator import EngineWatch
from freebody.numeric.options import SimulationOptions
from freebody.study.answering.crosscheck import (
    MIN_DRAWS,
    MOTION_TOLERANCE,
    CrossCheck,
    SaysNothing,
    broken,
    element_at,
    holds,
)
from freebody.study.answering.draws import Draw
from freebody.study.answering.finding import Finding, NotHere
from freebody.study.answering.repeated import coordinate_of
from freebody.study.answering.witness import MOST_STEPS, TOLERANCE
from freebody.study.setup import Setup
from freebody.symbolic.conditions import Condition, require
from freebody.symbolic.field import Ratio
from freebody.symbolic.motion import Reached
from freebody.symbolic.signs import Sign, sign_of
from freebody.symbolic.unknowns import Coordinate

LONGEST = 60.0  # [s] in which a motion has to turn
_N_TURNS = 2  # of a motion that goes to and fro: both sides


def find(setup: Setup, question: str, measure: Measure, side: int) -> Finding:
    """The closed form. side: +1 for the greatest value, -1 for the least."""
    _c, found, x = turn_of(setup, measure, side)
    conditions: list[Condition] = []
    for part, relation in found.conditions:
        condition, possible = require(part, relation, Message("it turns"))
        if not possible:
            raise NeverHappens(Message("it does not turn"))
        if condition is not None:
            conditions.append(condition)
    check = CrossCheck(question, Message("numerical integration until it has turned on both sides"), MOTION_TOLERANCE)

    def compare(draw: Draw) -> None:
        (exact,) = element_at(setup, (x,), draw, draw.start())
        if all(holds(setup, condition, draw, draw.start()) for condition in conditions):
            check.compare(draw, exact, extent_in_numbers(draw, measure, side))

    check.gather(setup.draw_stream(), compare)
    if len(check.pairs) < MIN_DRAWS and setup.has_values and (missed := broken(setup, conditions)):
        raise NotHere(Message("it does not turn so at the model's own values: that needs {x}", x=", ".join(missed)))
    return Finding(x, check.evidence(), conditions, list(found.notes), list(found.says))


def turn_of(setup: Setup, measure: Measure, side: int) -> tuple[Coordinate, Reached, Ratio]:
    """The coordinate of a measure, the turn on that side, and the measure there."""
    f, c = setup.model.field, coordinate_of(setup, measure)
    value = setup.model.value_of(measure)
    slope = sign_of(f.partial(value, c.index))
    if not slope.is_strict:
        raise CannotAnswer(Message("which way the measure grows depends on the parameter values"))
    found = setup.motion.extent(c, side if slope is Sign.POSITIVE else -side)
    return c, found, f.lowest_terms(f.follow(value, {c.index: found.at}))


def extent_in_numbers(draw: Draw, measure: Measure, side: int) -> float:
    """The farthest of the start and the first two turns."""
    start, reference = draw.start(), draw.reference
    watches = [EngineWatch("turn", measure, 1, size=1e-3)]
    engine = Engine(reference.numbers(), watches)
    y = engine.state(*reference.by_body(start.q, start.v))
    engine.align(y, start.t, start.value)
    options = SimulationOptions(method="dop853", tolerance=TOLERANCE, max_steps=allowed(MOST_STEPS))
    course = engine.run(y, start.t + LONGEST, options, start=start.t, outputs=np.array([start.t, start.t + LONGEST]))
    turns = [h.time for h in course.events if h.kind in ("rising", "falling") and h.time > start.t][:_N_TURNS]
    goes_on = course.status in (Status.FINISHED, Status.TOO_LONG)
    if not turns and not (goes_on and start.rate(measure) == 0.0):
        raise SaysNothing(Message("the motion has not turned until t = {t:.6g} s", t=course.t_end))
    values, near = [side * start.value(measure)], start
    for k, t in enumerate(course.times):
        q, v = map(reference.by_column, engine.coordinates(engine.state_at(course, k)))
        near = reference.snapshot(q, v, float(t), near)
        value = side * near.value(measure)
        if t in turns:
            values.append(value)
    return side * max(values)
