"""What is asked for from the numeric route alone: a plain number, with or without a formula beside it."""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial, singledispatch
from itertools import pairwise

import numpy as np

from freebody.errors import BudgetExhausted, CannotAnswer
from freebody.language.sentences import Message
from freebody.measures.base import Measure
from freebody.numeric.jets import Array
from freebody.numeric.snapshot import Snapshot
from freebody.questions.arithmetic import AtStart
from freebody.questions.at_events import AtEvent
from freebody.questions.base import Quantity
from freebody.questions.clock import Clock
from freebody.questions.event import AskedEvent
from freebody.questions.extent import Extent, ExtremeOfMotion
from freebody.questions.loads import Power
from freebody.questions.period import Period
from freebody.questions.reading import Question
from freebody.questions.small_motion import Equilibrium, OfSmallMotion, RestValue, SmallOscillations
from freebody.study.answering.answer import Value
from freebody.study.answering.crosscheck import as_parts
from freebody.study.answering.draws import Draw
from freebody.study.answering.magnitude import power_size
from freebody.study.answering.passage import smooth_numbers
from freebody.study.answering.witness import TOLERANCE, motion_to, patience, states_at, turned_on_the_way
from freebody.study.mobility.centres import moving_for
from freebody.study.setup import Setup
from freebody.study.where_true import insist_on_truth
from freebody.system.modes import depends_on_time

N_PANELS = 16
_FEWEST_PANELS = 4  # between two halts
_APART = 1e-7  # of the time: halts that are nearer to each other are one
LONGEST = 60.0  # [s] that an event is waited for
_N_LOOKS = 2401  # in that time
_FARTHER = 1e-6  # of the size: what is more than how exactly it is seen


def at_event(setup: Setup, quantity: Quantity, draw: Draw, start: Snapshot, until: float, event: AskedEvent) -> object:
    found = motion_to(draw.reference, start, until, event)
    work = partial(work_until, setup, draw=draw, event=event, end=found.time)
    over_time = partial(integral_until, setup, draw=draw, event=event, end=found.time)
    turned = partial(turns_until, draw=draw, end=found.time)
    return quantity.counted(smooth_numbers(setup, start, found.event, work, found.links, over_time, turned))


def turns_until(measures: Sequence[Measure], draw: Draw, end: float) -> Sequence[Snapshot]:
    """The instants before another one at which one of some measures turns back."""
    return turned_on_the_way(draw.reference, draw.start(), end, measures)


def work_until(setup: Setup, load: str, draw: Draw, event: AskedEvent, end: float) -> float:
    """The integral of the power over time from the start to an event."""
    seen, weights = _panels(draw, event, end)
    power = np.array([float(Power(load).value(setup.system, s)) for s in seen])
    work = float(weights @ power)
    # of forces that move nothing, or take back what they gave, no more is left than the motion is off by
    size = float(weights @ np.array([power_size(load, s) for s in seen]))
    return 0.0 if abs(work) <= TOLERANCE * size else work


def integral_until(
    setup: Setup, quantity: Quantity, halts: Sequence[float] = (), *, draw: Draw, event: AskedEvent, end: float
) -> float | tuple[float, ...]:
    """The integral of a quantity, or of each component of it, over time from the start to an event. halts: instants on
    the way at which its slope may jump."""
    seen, weights = _panels(draw, event, end, halts)
    total = weights @ np.array([as_parts(quantity.value(setup.system, s)) for s in seen])
    return tuple(float(x) for x in total) if len(total) > 1 else float(total[0])


def _panels(draw: Draw, event: AskedEvent, end: float, halts: Sequence[float] = ()) -> tuple[Sequence[Snapshot], Array]:
    """States between the start and an event, and their weights in an integral over the time: Gauss-Legendre points in
    panels, none of which reaches over one of the halts."""
    start = draw.start()
    nodes, weights = np.polynomial.legendre.leggauss(8)
    ends = [start.t]
    for t in halts:
        if min(t - ends[-1], end - t) > _APART * (end - start.t):
            ends.append(t)
    n_panels = max(_FEWEST_PANELS, N_PANELS // len(ends))
    edges = np.array([np.linspace(a, b, n_panels + 1) for a, b in pairwise((*ends, end))])
    halves, centers = (0.5 * np.diff(edges)).ravel(), (0.5 * (edges[:, 1:] + edges[:, :-1])).ravel()
    times = (centers[:, None] + halves[:, None] * nodes).ravel()
    found = motion_to(draw.reference, start, end + halves[-1], event, times)
    wanted = set(times.tolist())  # where the motion turns there are states as well
    seen = [s for s in found.links if s.t in wanted]
    return seen, (halves[:, None] * weights).ravel()


def number_instead(setup: Setup, question: Question) -> Value:
    """The value of the numeric route where there is no closed form, at the start or at the event. Raises CannotAnswer
    where it has none."""
    q = question.quantity
    if not setup.has_values:
        return None
    if q.scope == "steady motion":
        from freebody.study.steady.ask import number as number_of_steady

        return number_of_steady(q, setup, question)
    if q.scope == "linkage":
        from freebody.study.mobility.loop_answers import value_of as number_of_loop

        return number_of_loop(q, setup)
    if q.wanted is not None:
        return None
    if question.event is not None and not q.is_of_state and q.turn is None:
        return None  # it says of which equilibrium it is asked
    return number_of(setup, q, question.event)


def number_of(setup: Setup, quantity: Quantity, event: AskedEvent | None) -> float | tuple[float, ...]:
    """The quantity from the numeric route alone, at the start or at the event; a plain number without a formula.
    Raises CannotAnswer if the event does not happen within a minute."""
    return number_at(setup, quantity, event, setup.draws[0])


def number_at(setup: Setup, quantity: Quantity, event: AskedEvent | None, draw: Draw) -> float | tuple[float, ...]:
    """The same at other numbers of the parameters."""
    if quantity.is_of_answers:
        from freebody.study.answering.of_answers import number_at_draw

        def number(part: Quantity) -> float | tuple[float, ...]:
            if isinstance(part, AtEvent):
                if part.transition is not None:
                    raise CannotAnswer(Message("numbers alone tell nothing of an event of contacts and strings"))
                return number_at(setup, part.of, part.event, draw)
            of, until = (part.of, None) if isinstance(part, AtStart) else (part, event)
            return number_at(setup, of, until, draw)

        return float(number_at_draw(quantity, draw, number))
    return _number(quantity, setup, event, draw)


@singledispatch
def _number(quantity: Quantity, setup: Setup, event: AskedEvent | None, draw: Draw) -> float | tuple[float, ...]:
    start = draw.start()
    if event is None:
        values = as_parts(quantity.value(setup.system, draw.seen(moving_for(quantity, start))))
    elif isinstance(event, Clock) and event.time is None:
        raise CannotAnswer(Message("numbers of a motion tell nothing of what it tends to"))
    elif _rests(setup):
        raise CannotAnswer(Message("it starts at rest, and only round-off accelerates it: numbers would follow that"))
    else:
        until = patience(start, LONGEST)
        if setup.system.validities:
            insist_on_truth(setup.system, draw.reference, motion_to(draw.reference, start, until, event).links)
        values = as_parts(at_event(setup, quantity, draw, start, until, event))
    return values[0] if len(values) == 1 else values


@_number.register(SmallOscillations)
def _small_number(
    quantity: SmallOscillations, setup: Setup, event: AskedEvent | None, draw: Draw
) -> float | tuple[float, ...]:
    from freebody.study.answering.at_equilibrium import small_number

    return small_number(quantity, setup, draw)


@_number.register(Equilibrium)
def _rest_number(quantity: Equilibrium, setup: Setup, event: AskedEvent | None, draw: Draw) -> float:
    from freebody.study.small_motion.equilibrium import nearest_equilibrium, refuse_out_of_bounds

    if setup.is_mode:
        raise CannotAnswer(Message("whether contacts stay as they are at a rest is told by formulas alone"))
    q = nearest_equilibrium(setup.system)[0].q
    refuse_out_of_bounds(setup.system, draw.reference, q)
    return draw.reference.snapshot(q, np.zeros_like(q)).value(quantity.measure)


@_number.register(RestValue)
def _number_at_rest(
    quantity: RestValue, setup: Setup, event: AskedEvent | None, draw: Draw
) -> float | tuple[float, ...]:
    from freebody.study.small_motion.equilibrium import nearest_equilibrium, refuse_out_of_bounds

    if setup.is_mode:
        raise CannotAnswer(Message("whether contacts stay as they are at a rest is told by formulas alone"))
    q = nearest_equilibrium(setup.system)[0].q
    refuse_out_of_bounds(setup.system, draw.reference, q)
    seen = moving_for(quantity.of, draw.reference.snapshot(q, np.zeros_like(q)))
    values = as_parts(quantity.of.value(setup.system, draw.seen(seen)))
    return values[0] if len(values) == 1 else values


@_number.register(Period)
def _period_number(quantity: Period, setup: Setup, event: AskedEvent | None, draw: Draw) -> float | tuple[float, ...]:
    from freebody.study.answering.repeated import number

    return number(quantity.measure, setup, draw)


@_number.register(Extent)
def _extent_number(quantity: Extent, setup: Setup, event: AskedEvent | None, draw: Draw) -> float | tuple[float, ...]:
    from freebody.study.answering.extent import farthest_in_numbers
    from freebody.study.answering.motion_values import insist_held

    if event is not None:
        return _extreme_number(quantity.of_motion, setup, event, draw)
    value, when = farthest_in_numbers(draw, quantity.measure, quantity.side)
    insist_held(setup, draw, draw.start().t, when)
    if len(setup.model.coordinates) > 1 or depends_on_time(setup.system):  # the first turns need not be the farthest
        _insist_no_farther(quantity, draw, value)
    return value


def _insist_no_farther(quantity: Extent, draw: Draw, value: float) -> None:
    """Raises BudgetExhausted where it gets farther later on: the time that is looked at tells how far, not that no more
    comes."""
    longest = patience(draw.start(), LONGEST)
    try:
        seen = states_at(draw.reference, draw.start(), np.linspace(0.0, longest, _N_LOOKS))
    except CannotAnswer:  # the motion cannot be followed so long
        return
    reached = max(quantity.side * s.value(quantity.measure) for s in seen) * quantity.side
    if quantity.side * (reached - value) > _FARTHER * max(abs(reached), abs(value)):
        told = Message(
            "it gets farther later on: in a simulation of {t:.3g} s to {value:.6g}", t=longest, value=reached
        )
        raise BudgetExhausted(told)


def rates_seen(draw: Draw, measure: Measure) -> tuple[float, float]:
    """The least and the greatest rate of a measure at instants of a simulation. Raises CannotAnswer where it fails."""
    longest = patience(draw.start(), LONGEST)
    found = [s.rate(measure) for s in states_at(draw.reference, draw.start(), np.linspace(0.0, longest, _N_LOOKS))]
    return min(found), max(found)


@_number.register(ExtremeOfMotion)
def _extreme_number(
    quantity: ExtremeOfMotion, setup: Setup, event: AskedEvent | None, draw: Draw
) -> float | tuple[float, ...]:
    from freebody.study.answering.extremes_until import extreme_in_numbers
    from freebody.study.answering.motion_values import extremes_between, insist_held
    from freebody.study.answering.repeated import cycle_at_all

    if event is not None:
        return extreme_in_numbers(setup, draw, quantity, event)
    measure = next(iter(setup.system.measures.values()), None)
    if measure is None:
        raise CannotAnswer(Message("name a measure that moves to and fro, or round and round"))
    begin, end = cycle_at_all(draw, measure, is_exact=True)
    insist_held(setup, draw, begin, end)
    low, high = extremes_between(setup, draw, quantity.of, begin, end)
    return low if quantity.side < 0 else high


@_number.register(OfSmallMotion)
def _of_small_motion(
    quantity: OfSmallMotion, setup: Setup, event: AskedEvent | None, draw: Draw
) -> float | tuple[float, ...]:
    from freebody.study.small_motion.numbers import small_quantity

    return small_quantity(quantity, setup, draw)


def _rests(setup: Setup) -> bool:
    """Whether the start is one of rest that only round-off would leave."""
    from freebody.study.simulation.at_rest import is_unstable_rest
    from freebody.study.simulation.simulator import Simulator

    simulator = Simulator(setup.system)
    return is_unstable_rest(simulator, simulator.start, 0.0)
