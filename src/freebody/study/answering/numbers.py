"""What is asked for from the numeric route alone: a plain number, with or without a formula beside it."""

from __future__ import annotations

import math
from functools import partial, singledispatch

import numpy as np

from freebody.errors import CannotAnswer
from freebody.language.sentences import Message
from freebody.measures.base import Measure
from freebody.measures.displacement import Displacement
from freebody.measures.geometry import GROUND, RIGHT, UP, Point
from freebody.numeric.linearised import frequencies
from freebody.numeric.reference import Snapshot
from freebody.numeric.small_motion import LinearisationPoint, SmallMotion
from freebody.questions.base import Quantity
from freebody.questions.loads import Power
from freebody.questions.reading import QuestionEvent
from freebody.questions.small_motion import SmallOscillations
from freebody.study.answering.crosscheck import as_parts, element_at
from freebody.study.answering.draws import Draw
from freebody.study.answering.passage import NumericPassage
from freebody.study.answering.witness import motion_to
from freebody.study.mobility.centres import moving_for
from freebody.study.setup import Setup
from freebody.study.simulation.at_rest import is_unstable_rest
from freebody.study.simulation.simulator import Simulator
from freebody.study.small_motion.equilibrium import nearest_equilibrium
from freebody.symbolic.equilibrium import find_equilibrium
from freebody.symbolic.field import Ratio
from freebody.symbolic.state import SymbolicState

N_PANELS = 16


def at_event(
    setup: Setup, quantity: Quantity, draw: Draw, start: Snapshot, until: float, event: QuestionEvent
) -> object:
    found = motion_to(draw.reference, start, until, event)
    work = partial(work_until, setup, draw=draw, event=event, end=found.time)
    return quantity.counted(NumericPassage(setup, start, found.event, found.time, work, found.links))


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
        values = as_parts(at_event(setup, quantity, draw, start, 60.0, event))
    return values[0] if len(values) == 1 else values


@_number.register(SmallOscillations)
def _small_number(
    quantity: SmallOscillations, setup: Setup, event: QuestionEvent | None, draw: Draw
) -> float | tuple[float, ...]:
    """Natural frequencies, or the one period, about the equilibrium that formulas give, else the one nearest to the
    start. Raises CannotAnswer where there is none, where it is not stable, or where there are several periods."""
    try:
        equilibrium = find_equilibrium(setup.model, setup.start).values
        q = draw.reference.pose_near(draw.q, places_at(setup, equilibrium, draw))
    except CannotAnswer:
        q = nearest_equilibrium(setup.system)[0].q
    small = SmallMotion(
        draw.reference, LinearisationPoint(q, np.zeros_like(q), 0.0, draw.start().branches, frozen=True)
    )
    found = [float(w) for w in frequencies(small.M, small.K)]
    if not found:
        raise CannotAnswer(Message("nothing can move, so nothing oscillates"))
    if quantity.what == "frequencies":
        return tuple(found) if len(found) > 1 else found[0]
    if len(found) > 1:
        raise CannotAnswer(Message("there are {n} natural frequencies; ask for natural frequencies", n=len(found)))
    if not found[0] > 0.0:
        raise CannotAnswer(Message("it does not oscillate: nothing drives it back"))
    return 2.0 * math.pi / found[0] if quantity.what == "period" else found[0]


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


def _rests(setup: Setup) -> bool:
    """Whether the start is one of rest that only round-off would leave."""
    simulator = Simulator(setup.system)
    return is_unstable_rest(simulator, simulator.start, 0.0)
