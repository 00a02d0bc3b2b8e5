"""What is asked for from the numeric route alone: a plain number, with or without a formula beside it."""

from __future__ import annotations

import math
from collections.abc import Sequence
from functools import partial, singledispatch

import numpy as np

from freebody.budgets import allowed
from freebody.errors import BudgetExhausted, CannotAnswer
from freebody.language.sentences import Message
from freebody.measures.base import Measure
from freebody.measures.displacement import Displacement
from freebody.measures.geometry import GROUND, RIGHT, UP, Point
from freebody.numeric.engine.course import Status
from freebody.numeric.jets import Array
from freebody.numeric.linearised import frequencies
from freebody.numeric.options import SimulationOptions
from freebody.numeric.reference import Snapshot
from freebody.numeric.small_motion import LinearisationPoint, SmallMotion
from freebody.questions.base import Quantity
from freebody.questions.energy import Energy
from freebody.questions.loads import Power
from freebody.questions.reading import Question, QuestionEvent
from freebody.questions.small_motion import SmallOscillations
from freebody.study.answering.answer import Value
from freebody.study.answering.crosscheck import as_parts, element_at, holds
from freebody.study.answering.draws import Draw
from freebody.study.answering.passage import NumericPassage, smooth_numbers
from freebody.study.answering.witness import TOLERANCE, motion_to
from freebody.study.mobility.centres import moving_for
from freebody.study.phases.quantities import only_friction_takes_energy, value_in_mode
from freebody.study.setup import Setup
from freebody.study.simulation.at_rest import is_unstable_rest
from freebody.study.simulation.instant import SimulatedInstant, with_all_held
from freebody.study.simulation.motion import SimulatedMotion
from freebody.study.simulation.observed import observed
from freebody.study.simulation.simulator import Simulator
from freebody.study.small_motion.equilibrium import nearest_equilibrium
from freebody.symbolic.equilibrium import GYROSCOPIC, find_equilibrium
from freebody.symbolic.field import Ratio
from freebody.symbolic.state import SymbolicState
from freebody.system.system import System
from freebody.tolerances import ROUND_OFF

AT_REST = 1e-7  # [SI] that an acceleration may differ from zero at an equilibrium
N_PANELS = 16
LONGEST = 60.0  # [s] that an event is waited for
_STEPS = 20_000  # of a motion in which contacts change
_SOON = 1e-9  # [s] of a motion that is looked at where it begins


def at_event(
    setup: Setup, quantity: Quantity, draw: Draw, start: Snapshot, until: float, event: QuestionEvent
) -> object:
    found = motion_to(draw.reference, start, until, event)
    work = partial(work_until, setup, draw=draw, event=event, end=found.time)
    return quantity.counted(smooth_numbers(setup, start, found.event, work, found.links))


def work_until(setup: Setup, load: str, draw: Draw, event: QuestionEvent, end: float) -> float:
    """The integral of the power over time from the start to an event, by Gauss-Legendre points in panels."""
    start = draw.start()
    nodes, weights = np.polynomial.legendre.leggauss(8)
    half = 0.5 * (end - start.t) / N_PANELS
    centers = start.t + half * (2.0 * np.arange(N_PANELS) + 1.0)
    times = (centers[:, None] + half * nodes).ravel()
    found = motion_to(draw.reference, start, end + half, event, times)
    power = [float(Power(load).value(setup.system, s)) for s in found.links[: len(times)]]
    return half * float(np.tile(weights, N_PANELS) @ np.array(power))


def number_of(setup: Setup, quantity: Quantity, event: QuestionEvent | None) -> float | tuple[float, ...]:
    """The quantity from the numeric route alone, at the start or at the event; a plain number without a formula.
    Raises CannotAnswer if the event does not happen within a minute."""
    return _number(quantity, setup, event, setup.draws[0])


@singledispatch
def _number(quantity: Quantity, setup: Setup, event: QuestionEvent | None, draw: Draw) -> float | tuple[float, ...]:
    start = draw.start()
    if event is None:
        values = as_parts(quantity.value(setup.system, draw.seen(moving_for(quantity, start))))
    elif _rests(setup):
        raise CannotAnswer(Message("it starts at rest, and only round-off accelerates it: numbers would follow that"))
    else:
        values = as_parts(at_event(setup, quantity, draw, start, LONGEST, event))
    return values[0] if len(values) == 1 else values


@_number.register(SmallOscillations)
def _small_number(
    quantity: SmallOscillations, setup: Setup, event: QuestionEvent | None, draw: Draw
) -> float | tuple[float, ...]:
    """Natural frequencies, or the one period, about the equilibrium that formulas give, else the one nearest to the
    start. Raises CannotAnswer where there is none, where it is not stable, or where there are several periods."""
    try:
        places = places_at(setup, find_equilibrium(setup.model, setup.start).values, draw)
        q, v = resting(draw, places)
        if unrest(draw, places, q, v) > AT_REST:  # the formula takes something to be positive that is not so there
            raise CannotAnswer(Message("this is no equilibrium"))
    except CannotAnswer:
        q = nearest_equilibrium(setup.system)[0].q
        v = np.zeros_like(q)
    there = draw.reference.snapshot(q, v)
    if not all(holds(setup, c, draw, there) for c in setup.clearances(setup.state, ">")):
        raise CannotAnswer(Message("there is no room to move about the equilibrium"))
    found = [float(w) for w in frequencies_about(draw, q, v)]
    if not found:
        raise CannotAnswer(Message("nothing can move, so nothing oscillates"))
    if quantity.what == "frequencies":
        return tuple(found) if len(found) > 1 else found[0]
    swinging = [w for w in found if w > 0.0]
    if len(swinging) > 1:
        raise CannotAnswer(Message("there are {n} natural frequencies; ask for natural frequencies", n=len(swinging)))
    if not swinging:
        raise CannotAnswer(NOTHING_DRIVES_BACK)
    return 2.0 * math.pi / swinging[0] if quantity.what == "period" else swinging[0]


NOTHING_DRIVES_BACK = Message("there is no period of small oscillations: to first order nothing drives it back")


def resting(draw: Draw, places: Sequence[tuple[Measure, float]]) -> tuple[Array, Array]:
    """The pose in which measures have values, and the velocities of what is driven, all else at rest beside it."""
    q = draw.reference.pose_near(draw.q, places)
    return q, draw.reference.velocities(q, [(measure, 0.0) for measure, _value in places], with_start=False)


def unrest(draw: Draw, places: Sequence[tuple[Measure, float]], q: Array, v: Array) -> float:
    """The largest acceleration of the full system at rest; beside what is driven, that of the measures alone."""
    still = draw.seen(draw.reference.snapshot(q, v))
    if v.any():
        return max((abs(still.acceleration(measure)) for measure, _value in places), default=0.0)
    return float(np.abs(still.accelerations).max(initial=0.0))


def frequencies_about(draw: Draw, q: Array, v: Array) -> Array:
    """Natural angular frequencies [rad/s] of the undamped system at rest, or at rest beside what is driven. Raises
    CannotAnswer where forces that are linear in the speeds, and do no work, mix the motions."""
    small = SmallMotion(draw.reference, LinearisationPoint(q, v, 0.0, draw.start().branches, frozen=not v.any()))
    if float(np.abs(small.C - small.C.T).max(initial=0.0)) > ROUND_OFF * float(np.abs(small.C).max(initial=1.0)):
        raise CannotAnswer(GYROSCOPIC)
    return frequencies(small.M, small.K)


def places_at(setup: Setup, equilibrium: dict[int, Ratio], draw: Draw) -> list[tuple[Measure, float]]:
    """The measures that the coordinates are, with their values at an equilibrium; and where a coordinate is none, as
    the angle of a link, the places of the bodies."""
    start = draw.start()
    measures = {c.index: setup.model.measure_of(c) for c in setup.model.coordinates}
    wanted = [(measure, equilibrium[index]) for index, measure in measures.items() if measure is not None]
    if len(wanted) < len(measures) and not setup.system.space:
        there = SymbolicState(setup.model, equilibrium)
        for body in setup.system.moving:
            of, ground = body.point(body.default_point), Point(GROUND)
            wanted += [(place, there.value(place)) for place in (Displacement(of, ground, d) for d in (RIGHT, UP))]
    return [(measure, element_at(setup, x, draw, start)[0]) for measure, x in wanted]


def number_with_changes(system: System, question: Question) -> Value:
    """What a motion in which contacts and dry friction change their states gives, at its start or at the first event
    within a minute; None where that does not come. Just before an impact, where the event is one. Raises
    BudgetExhausted where the event was not reached within the budget of steps, CannotAnswer where it has no number."""
    quantity, event = question.quantity, question.event
    if not system.has_values or question.transition is not None or not quantity.is_of_state:
        return None
    simulator = Simulator(system, events=() if event is None else (f"stop when {event.text}",))
    options = SimulationOptions(method="dop853", tolerance=TOLERANCE, max_steps=allowed(_STEPS))
    until = LONGEST if event is not None else _SOON
    course = simulator.run(until, options, outputs=np.array([0.0] if event is None else [until]))
    if course.status is Status.TOO_LONG:
        raise BudgetExhausted(course.message)
    if event is not None and course.status is not Status.EVENT:
        return None
    motion, k = SimulatedMotion(system, simulator, course, options), 0 if event is None else -1
    if quantity.watched is not None:  # angles are counted along the motion
        measure, order = quantity.watched
        return float(observed(motion, {"it": measure})["it"][order][k])
    reference = simulator.reference
    q, v = map(reference.by_column, simulator.engine.coordinates(simulator.start))
    begin = reference.snapshot(q, v)
    now, held = SimulatedInstant(motion, k), with_all_held(system)

    def lost() -> float:
        if not only_friction_takes_energy(system):
            raise CannotAnswer(Message("other loads do work as well, and the heat of friction is not counted apart"))
        before, after = (float(Energy("total").value(system, s)) for s in (begin, now))
        return before - after

    passage = NumericPassage(system, begin, now, lambda q: value_in_mode(q, system, held, now), lost)
    values = as_parts(quantity.counted(passage))
    return values[0] if len(values) == 1 else values


def _rests(setup: Setup) -> bool:
    """Whether the start is one of rest that only round-off would leave."""
    simulator = Simulator(setup.system)
    return is_unstable_rest(simulator, simulator.start, 0.0)
