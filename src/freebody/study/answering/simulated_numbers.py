"""What is asked for from a simulated motion in which contacts and dry friction may change their states."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import partial
from itertools import pairwise

import numpy as np

from freebody.budgets import allowed
from freebody.errors import BudgetExhausted, CannotAnswer
from freebody.language.sentences import Message
from freebody.measures.base import Measure
from freebody.measures.distance import Distance
from freebody.measures.geometry import NO_DIRECTION
from freebody.model.elements import NonholonomicForm
from freebody.numeric.engine.course import Status
from freebody.numeric.jets import Array
from freebody.numeric.options import SimulationOptions
from freebody.numeric.snapshot import Snapshot
from freebody.questions.base import Quantity
from freebody.questions.clock import Clock
from freebody.questions.course import Transition, TransitionKind
from freebody.questions.energy import Energy
from freebody.questions.reading import Question
from freebody.questions.reading_when import is_of_start
from freebody.study.answering.answer import Value
from freebody.study.answering.crosscheck import as_parts
from freebody.study.answering.numbers import LONGEST
from freebody.study.answering.passage import NumericPassage
from freebody.study.answering.simulated_work import SimulatedWork
from freebody.study.answering.witness import TOLERANCE
from freebody.study.phases.quantities import (
    only_friction_takes_energy,
    only_takes_energy,
    taking_energy,
    value_in_mode,
)
from freebody.study.simulation.instant import SimulatedInstant, with_all_held
from freebody.study.simulation.motion import SimulatedMotion
from freebody.study.simulation.observed import observed
from freebody.study.simulation.simulator import Simulator
from freebody.study.where_true import is_no_longer
from freebody.system.system import System

_STEPS = 20_000  # of a motion in which contacts change
_N_SEEN = 1201  # instants of a motion at which it is looked how far it gets
_CLOSER = 3  # times that it is looked at, each time between two neighbouring instants of the last
_MET = 1e-6  # [m] between two points that coincide
_SOON = 1e-9  # [s] of a motion that is looked at where it begins
_BETWEEN = np.linspace(0.0, 1.0, 8, endpoint=False)  # instants from one change to the next
_COLLIDES = ("touches", "rebounds", "goes taut", "blow")
_WITHIN = (0.1, 0.3, 1.0, 3.0, 10.0, 30.0, LONGEST)  # [s] in which a change of a contact is looked for
_CHANGES: dict[TransitionKind, tuple[str, ...]] = {  # in which nothing jumps: what they are called among the events
    "slips": ("starts to slip",),
    "slip ends": ("stops slipping",),
    "rolls": ("stops slipping",),
    "opens": ("parts", "goes slack"),
}


def number_with_changes(system: System, question: Question, *, is_single: bool = False) -> Value:
    """What a motion in which contacts and dry friction change their states gives, at its start, at the first event
    within a minute or where a contact slips or opens; None where that does not come. Just before an impact, where the
    event is one. is_single: one coordinate moves, and where it turns friction changes. Raises BudgetExhausted where the
    event was not reached within the budget of steps, CannotAnswer where it has no number."""
    quantity, event = question.quantity, question.event
    if not system.has_values or not quantity.is_of_state:
        return None
    if event is not None and question.transition is not None:
        return None
    if is_of_start(quantity) and not system.is_struck:  # it belongs to a blow on the way
        return None
    clock = event.time if isinstance(event, Clock) else None
    if isinstance(event, Clock) and clock is None:
        return None  # numbers of a motion tell nothing of what it tends to
    is_watched = event is not None and clock is None
    simulator = Simulator(system, events=(f"stop when {event.text}",) if event is not None and is_watched else ())
    options = SimulationOptions(method="dop853", tolerance=TOLERANCE, max_steps=allowed(_STEPS))
    changes = None if question.transition is None else _change(system, question.transition, simulator, options)
    if question.transition is not None and changes is None:
        return None
    until = LONGEST if is_watched else _SOON if clock is None else simulator.reference.number(clock)
    until = until if changes is None else changes
    is_of_end = event is not None or changes is not None
    course = simulator.run(until, options, outputs=np.array([until] if is_of_end else [0.0]))
    if course.status is Status.TOO_LONG:
        raise BudgetExhausted(course.message)
    if is_of_end and course.status is not (Status.EVENT if is_watched else Status.FINISHED):
        return None
    motion, k = SimulatedMotion(system, simulator, course, options), -1 if is_of_end else 0
    if is_of_end and (left := [purpose for purpose, time in motion.not_valid if time < course.times[-1]]):
        raise is_no_longer(left[0])
    if quantity.watched is not None:  # angles are counted along the motion
        measure, order = quantity.watched
        return float(observed(motion, {"it": measure})["it"][order][k])
    reference = simulator.reference
    q, v = map(reference.by_column, simulator.engine.coordinates(simulator.start))
    begin = reference.snapshot(q, v)
    now, held = SimulatedInstant(motion, k), with_all_held(system)
    _refuse_without_direction(system, now)

    power = SimulatedWork(system, simulator, options, course)

    def lost(of: str) -> float:
        is_all = only_takes_energy(system) if not of else only_friction_takes_energy(system)
        if is_all and (not of or taking_energy(system) == {of}):
            before, after = (float(Energy("total").value(system, s)) for s in (begin, now))
            return before - after
        if not of or system.bounds:  # which may collide
            raise CannotAnswer(Message("other loads do work as well, and the heat of friction is not counted apart"))
        return -power.of(of)

    def work(load: str) -> float:
        try:
            return passage.by_energies(load)
        except CannotAnswer:
            return power.of(load)

    passage = NumericPassage(
        system,
        begin,
        now,
        lambda q: value_in_mode(q, system, held, now),
        lost,
        work,
        ways=partial(_ways, power) if is_single and system.dry_friction else None,
        takes_energy=frozenset(taking_energy(system)),
    )
    values = as_parts(quantity.counted(passage))
    return values[0] if len(values) == 1 else values


def _ways(along: SimulatedWork) -> Iterator[Sequence[Snapshot]]:
    """The instants of a motion from one change of the contacts to the next, both ends among them. Raises CannotAnswer
    where something collides on the way."""
    if any(event.kind in _COLLIDES for event in along.course.events):
        raise CannotAnswer(Message("the way is not counted here"))
    edges = along.changes()
    times = [a + (b - a) * _BETWEEN for a, b in pairwise(edges)]
    instants = along.instants(np.append(np.concatenate(times), edges[-1]))
    for k in range(len(times)):
        yield instants[k * len(_BETWEEN) : (k + 1) * len(_BETWEEN) + 1]


def _change(system: System, asked: Transition, simulator: Simulator, options: SimulationOptions) -> float | None:
    """[s] when a contact first slips, sticks or opens; None where it does not within a minute, or where others do so
    that are not meant."""
    kinds = _CHANGES.get(asked.kind, ())
    rows = [b.row for b in system.bounds] if asked.kind == "opens" else [rub.row for rub in system.dry_friction]
    if not kinds or asked.count > 1 or (asked.of and not {row.connection for row in rows} <= set(asked.of)):
        return None
    if asked.rests and not asked.of and len({row.connection for row in rows}) > 1:
        return None  # which of them is the last to stop
    for until in _WITHIN:
        course = simulator.run(until, options, outputs=np.array([until]))
        if times := [event.time for event in course.events if event.kind in kinds]:
            return min(times)
        if course.status is not Status.FINISHED:
            return None
    return None


def _refuse_without_direction(system: System, now: SimulatedInstant) -> None:
    """Where the ends of a line meet, what is held along it has no gradient, and the motion no certain speed."""
    for row in system.constraint_rows:
        for first, second in () if isinstance(row.measure, NonholonomicForm) else row.measure.lines():
            if float(now.value(Distance(first, second))) < _MET:
                raise CannotAnswer(NO_DIRECTION)


def farthest(
    system: System, of: Measure | Quantity, side: int, until: float = LONGEST, *, is_exact: bool = False
) -> tuple[float, float, float]:
    """How far a measure gets on one side in a simulated motion, until when that was followed: a minute, or to where
    the motion cannot be followed further, and how large it becomes. until: [s] at most; is_exact: whether it is looked
    at again beside where it is farthest, more and more closely."""
    times, seen = _looked_at(system, of, 0.0, until)
    end, size = float(times[-1]), float(np.abs(seen).max())
    for _ in range(_CLOSER if is_exact else 0):
        best = int(np.argmax(side * seen))
        times, seen = _looked_at(system, of, times[max(best - 1, 0)], times[min(best + 1, len(times) - 1)])
    return side * float((side * seen).max()), end, size


def _looked_at(system: System, of: Measure | Quantity, first: float, last: float) -> tuple[Array, Array]:
    """What a quantity is at instants of a simulated motion."""
    simulator = Simulator(system)
    options = SimulationOptions(method="dop853", tolerance=TOLERANCE, max_steps=allowed(_STEPS))
    course = simulator.run(last, options, outputs=np.linspace(first, last, _N_SEEN))
    motion = SimulatedMotion(system, simulator, course, options)
    if isinstance(of, Quantity):
        held = with_all_held(system)
        instants = (SimulatedInstant(motion, k) for k in range(len(course.times)))
        return course.times, np.array([float(value_in_mode(of, system, held, now)) for now in instants])
    return course.times, observed(motion, {"it": of})["it"][0]
