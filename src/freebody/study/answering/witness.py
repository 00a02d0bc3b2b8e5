"""What the engine says of a draw: the second opinion behind every closed form.

Positions, velocities and measures are those of a snapshot; accelerations and multipliers come from the compiled engine.
Where rows depend on each other, the dense solution of the reference route says which multipliers are unique.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from contextlib import suppress
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from freebody.budgets import allowed
from freebody.errors import BudgetExhausted, CannotAnswer
from freebody.language.sentences import Message
from freebody.measures.base import Measure
from freebody.model.elements import ConstraintRow, NonholonomicForm
from freebody.numeric.balanced import Balanced
from freebody.numeric.engine.course import Status, Trajectory
from freebody.numeric.engine.engine import Engine
from freebody.numeric.engine.evaluator import EngineWatch
from freebody.numeric.instant import WithoutInertia, place_of
from freebody.numeric.jets import Array
from freebody.numeric.kernels import factoring
from freebody.numeric.options import SimulationOptions
from freebody.numeric.reference import Reference
from freebody.numeric.snapshot import Snapshot
from freebody.questions.clock import Clock
from freebody.questions.event import AskedEvent
from freebody.questions.event_base import QuestionEvent
from freebody.tolerances import LEAST

MOST_STEPS = 100_000  # of a motion to an event
N_LINKS = 33  # snapshots along a motion, by which angles are counted on
TOLERANCE = 1e-11
_FEW = 9  # links up to an event
_BALANCED = 1e-7  # of the size of all loads that nothing balances: a pose is assembled to 1e-11 of its size
_TURN = "turn"
_SLOW = 1e-3  # [SI/s]
_SLOWEST = 1e9  # [s] of these times: slower is round-off
_SOON = 1e-9  # [s] of a motion that is looked at where it begins
TOUCH = 1e-8  # what a measure may miss a value by where it turns, by the size of the event


class NumericSnapshot(Snapshot):
    """A snapshot whose accelerations and multipliers the engine finds."""

    def __init__(self, snapshot: Snapshot, engine: Engine) -> None:
        super().__init__(snapshot.reference, snapshot.geometry, snapshot.q, snapshot.v, snapshot.t)
        self._engine = engine

    @cached_property
    def _solved(self) -> tuple[Array, Array, bool]:
        """Accelerations by coordinate, multipliers, and whether all rows are independent."""
        y = self._engine.state(*self.reference.by_body(self.q, self.v))
        self._engine.align(y, self.t, self.value)
        accelerations, multipliers = self._engine.evaluate(y, self.t)
        info = self._engine.room.info
        is_plain = (
            info[factoring.IS_REGULARISED] == 0.0
            and info[factoring.N_LEFT_OUT] == 0.0
            and not self._engine.layout.has_gap[0]
        )
        return self.reference.by_column(accelerations), multipliers, is_plain

    @property
    def accelerations(self) -> Array:
        found, _multipliers, is_plain = self._solved
        if not is_plain:
            _ = self._dynamics  # refuses what contradicts itself, or can move without inertia
        return found

    def multiplier(self, row: ConstraintRow) -> float:
        _accelerations, multipliers, is_plain = self._solved
        value = float(multipliers[place_of(self.reference, row)])
        if is_plain:
            return value
        dense = self._dense(row)
        return dense if self._engine.room.info[factoring.IS_REGULARISED] > 0.0 else value

    def _dense(self, row: ConstraintRow) -> float:
        """By the reference, which refuses what is not unique; at rest, where loads balance on what has no mass, by that
        balance."""
        try:
            return super().multiplier(row)
        except WithoutInertia:
            if self.v.any():
                raise
            still = Balanced(self.reference, self.geometry, self.q, self.v, self.t)
            if float(np.abs(still.accelerations).max(initial=0.0)) > _BALANCED:
                raise
            return still.multiplier(row)


@dataclass(frozen=True)
class Found:
    """The event of a motion, and the states before it."""

    time: float
    event: NumericSnapshot
    links: tuple[NumericSnapshot, ...]


def motion_to(
    reference: Reference, start: Snapshot, until: float, event: AskedEvent, times: Array | None = None
) -> Found:
    """The motion from a start to the first time after it at which a measure, or its rate, has the value of the event;
    a value that is only touched is reached where the measure turns. times: where states are wanted before. Raises
    CannotAnswer if the event does not happen until `until`, BudgetExhausted if it was not reached within the budget of
    steps. As the time grows without end it is followed to `until`."""
    if isinstance(event, Clock):
        return _at_time(reference, start, until if event.time is None else reference.number(event.time), times)
    target = reference.number(event.value)
    own = reference.sizes.length ** float(event.measure.dimension.length)  # of a place; an angle is of the size of one
    slow = least_rate(start, event.measure)
    size = max(abs(target), own if event.order == 0 else slow)
    crossing = EngineWatch("event", event.measure, event.order, target, is_terminal=True, size=size)
    watches = [crossing] if event.order else [crossing, EngineWatch(_TURN, event.measure, 1, size=slow)]
    course, links = _followed(reference, start, until, watches, times)
    turn = _turn_at(course, links, event, target, size)
    if turn is not None:
        return turn
    if course.status is Status.TOO_LONG:
        raise BudgetExhausted(_too_long(course))
    if course.status is Status.NOT_FINITE and (last := _at_end(reference, start, course, event, target, size)):
        return last
    if course.status is not Status.EVENT:
        told = Message("the event does not happen until t = {until:.6g} s", until=until)
        if course.status is not Status.FINISHED and course.message:
            told = Message("{what}: {why}", what=told, why=course.message)
        raise CannotAnswer(told)
    if times is None and len(links) < _FEW:  # angles are counted on from link to link: none may be half a turn away
        closer = np.linspace(start.t, course.events[-1].time, N_LINKS)
        links = _followed(reference, start, float(closer[-1]), [], closer)[1]
    found = Found(course.events[-1].time, links[-1], links)
    soon = _until_turn(found.event, event, size)
    if soon is not None:  # crossed just before it turns, by no more than round-off: the turn itself is meant
        course, links = _followed(reference, start, found.time + soon, watches[1:], times)
        return _turn_at(course, links, event, target, size) or found
    return found


def least_rate(start: Snapshot, measure: Measure | NonholonomicForm) -> float:
    """[SI/s] What counts as large where a rate is watched for zeros: what it is the sum of at the start, since it may
    be zero there but for the round-off of that."""
    return max(_SLOW, start.rate_size(measure))


def patience(start: Snapshot, seconds: float) -> float:
    """[s] How long a motion is waited for: so many seconds, or as many of the times in which what moves goes through
    the size of the system, or turns by a radian, where these are longer, as those of planets are."""
    sizes, rates = start.reference.sizes, [0.0]
    rates.append(float(sizes.relative(start.v).max(initial=0.0)))
    with suppress(CannotAnswer, ArithmeticError, ValueError):
        rates.append(math.sqrt(float(sizes.relative(start.accelerations).max(initial=0.0))))
    slowest = 1.0 / max(*rates, LEAST)
    return seconds * (max(1.0, slowest) if slowest < _SLOWEST else 1.0)  # what is slower yet is at rest


def states_at(reference: Reference, start: Snapshot, times: Array) -> tuple[NumericSnapshot, ...]:
    """The states of a motion at some instants, in their order. Raises CannotAnswer where it does not go on so long."""
    course, links = _followed(reference, start, float(times[-1]) + _SOON, [], times)
    if course.status not in (Status.FINISHED, Status.TOO_LONG) or len(links) < len(times):
        raise CannotAnswer(course.message or Message("the motion does not go on"))
    return links[: len(times)]


def turned_on_the_way(
    reference: Reference, start: Snapshot, end: float, measures: Sequence[Measure]
) -> list[NumericSnapshot]:
    """The states of a motion until an instant at which one of some measures turns back."""
    watches = [EngineWatch(f"{_TURN} {k}", m, 1, size=least_rate(start, m)) for k, m in enumerate(measures)]
    course, links = _followed(reference, start, end, watches, np.linspace(start.t, end, N_LINKS))
    turns = {h.time for h in course.events if start.t < h.time < end}
    return [s for s in links if s.t in turns]


def _at_time(reference: Reference, start: Snapshot, time: float, times: Array | None) -> Found:
    """The motion to an instant by the clock."""
    if time < start.t:
        raise CannotAnswer(Message("t = {time:.6g} s is before the start", time=time))
    if time == start.t:
        course, links = _followed(reference, start, time + _SOON, [], np.array([time]))
        return Found(time, links[0], links[:1])
    wanted = np.linspace(start.t, time, N_LINKS) if times is None else np.append(times[times < time], time)
    course, links = _followed(reference, start, time, [], wanted)
    if course.status is Status.TOO_LONG:
        raise BudgetExhausted(_too_long(course))
    if course.status is not Status.FINISHED:
        told = Message("the motion does not go on until t = {time:.6g} s", time=time)
        raise CannotAnswer(Message("{what}: {why}", what=told, why=course.message) if course.message else told)
    return Found(time, links[-1], links)


def _too_long(course: Trajectory) -> Message:
    return Message(
        "the event was not found within {n} steps; raise the effort (--effort) to look further (t = {t:.6g} s is "
        "reached)",
        n=allowed(MOST_STEPS),
        t=course.t_end,
    )


def _followed(
    reference: Reference, start: Snapshot, until: float, watches: Sequence[EngineWatch], times: Array | None
) -> tuple[Trajectory, tuple[NumericSnapshot, ...]]:
    """A motion, and its states at the wanted times and at what is watched."""
    outputs = np.linspace(start.t, until, N_LINKS) if times is None else times
    engine, course = run(reference, start, outputs, watches, until)
    links: list[NumericSnapshot] = []
    for snapshot in snapshots(reference, engine, course, start):
        near = NumericSnapshot(snapshot, engine)
        for measure in reference.system.measures.values():
            with suppress(CannotAnswer, ArithmeticError, ValueError):
                near.value(measure)  # angles of lines are counted on where they are looked at
        links.append(near)
    return course, tuple(links)


def run(
    reference: Reference,
    start: Snapshot,
    outputs: Array,
    watches: Sequence[EngineWatch] = (),
    until: float | None = None,
    tolerance: float = TOLERANCE,
    most_steps: int | None = None,
) -> tuple[Engine, Trajectory]:
    """The motion from a start to `until`, the last of the outputs where it is not given [s]. most_steps: at the usual
    effort; `MOST_STEPS` where none are given."""
    engine = Engine(reference.numbers(), watches)
    y = engine.state(*reference.by_body(start.q, start.v))
    engine.align(y, start.t, start.value)
    options = SimulationOptions(method="dop853", tolerance=tolerance, max_steps=allowed(most_steps or MOST_STEPS))
    end = float(outputs[-1]) if until is None else until
    return engine, engine.run(y, end, options, start=start.t, outputs=outputs)


def snapshots(reference: Reference, engine: Engine, course: Trajectory, start: Snapshot) -> Iterator[Snapshot]:
    """The states of a motion, in which angles are counted on from one to the next."""
    near = start
    for k, t in enumerate(course.times):
        q, v = map(reference.by_column, engine.coordinates(engine.state_at(course, k)))
        near = reference.snapshot(q, v, float(t), near)
        yield near


def _turn_at(
    course: Trajectory, links: Sequence[NumericSnapshot], event: QuestionEvent, target: float, size: float
) -> Found | None:
    """The first instant after the start at which the measure of an event turns at its value."""
    turns = {h.time for h in course.events if h.name == _TURN and h.time > links[0].t}
    for k, link in enumerate(links):
        if link.t in turns and abs(link.value(event.measure) - target) <= TOUCH * size:
            return Found(link.t, link, tuple(links[: k + 1]))
    return None


def _at_end(
    reference: Reference, start: Snapshot, course: Trajectory, event: QuestionEvent, target: float, size: float
) -> Found | None:
    """The instant at which a law ends, as the root of a speed does where that comes to rest, if it is the event."""
    times = np.linspace(start.t, course.t_end, N_LINKS)
    _course, links = _followed(reference, start, course.t_end, [], times)
    if not links:
        return None
    here = links[-1].rate(event.measure) if event.order else links[-1].value(event.measure)
    return Found(course.t_end, links[-1], links) if abs(here - target) <= TOUCH * size else None


def _until_turn(here: NumericSnapshot, event: QuestionEvent, size: float) -> float | None:
    """How long at most until a measure turns that has passed a value by less than counts; None if it does not."""
    if event.order:
        return None
    rate, acceleration = abs(here.rate(event.measure)), abs(here.acceleration(event.measure))
    return 4.0 * rate / acceleration if rate * rate < 2.0 * TOUCH * size * acceleration else None
