"""A packed system from Python, and its instants."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from copy import copy
from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise
from typing import Any, Self

import numpy as np

from freebody.errors import CannotAnswer
from freebody.language.sentences import Message
from freebody.measures.base import Measure
from freebody.model.elements import RATE, VALUE, NonholonomicForm
from freebody.numeric.engine.border import border_of
from freebody.numeric.engine.course import Trajectory
from freebody.numeric.engine.guard_programs import GuardPrograms
from freebody.numeric.engine.integrators import dop853
from freebody.numeric.engine.packing import Packing
from freebody.numeric.engine.workspace import room_for
from freebody.numeric.engine.writing import ArrayBuilder, Guard
from freebody.numeric.kernels import kinematics, solving, stepped_run, stepping
from freebody.numeric.kernels.arrays import Floats, ModelArrays
from freebody.numeric.kernels.declaring import plain
from freebody.numeric.kernels.measures_planar import BEARING, NEAR
from freebody.numeric.kernels.observing import observe
from freebody.numeric.kernels.stepped_run import SteppedRun, Tableau
from freebody.numeric.kernels.tape import play
from freebody.numeric.numbers import Numbers

COMPLIANCE = 1e-5  # of held rows whose multipliers are shared, by the most mobile one
WITHOUT_LIMIT = 1e30  # times that: of rows that carry nothing


@dataclass(frozen=True)
class EngineWatch:
    """Something whose zero is an event: a measure (order 0) or its rate (order 1) minus a value."""

    name: str
    measure: Measure | NonholonomicForm
    order: int = 0
    value: float = 0.0
    direction: int = 0  # 1: rising only, -1: falling only
    is_terminal: bool = False
    size: float = 1.0  # what counts as large
    is_border: bool = False  # where the law of a load changes


@dataclass(frozen=True)
class EngineRows:
    """What is held of a written system, along what friction slides, and what is guarded."""

    written: ArrayBuilder
    held: tuple[int, ...]
    sliding: tuple[tuple[int, int], ...]
    guards: tuple[Guard, ...]


class Packed:
    """Rows of a system in arrays, and the room in which they are evaluated."""

    def __init__(self, numbers: Numbers, packing: Packing, mode: EngineRows | None = None) -> None:
        self.numbers = numbers
        self.n_bodies = packing.n_bodies
        self.written = ArrayBuilder(packing) if mode is None else mode.written
        chosen = None if mode is None else mode.held
        sliding, guards = ((), ()) if mode is None else (mode.sliding, mode.guards)
        self.layout, self.order = self.written.layout(chosen, sliding, guards)
        self.rows = self.written.rows
        self._bearings = packing.bearings()
        self.turning = packing.keys()
        self.border = border_of(numbers)
        self.room = room_for(self.layout, space=numbers.system.space)
        self.n_coordinates, self.n_y = self.border.n_coordinates, self.border.n_y
        self.at_work = 2 * self.n_coordinates  # where the work done stands in a state
        self.unit = self.border.unit

    def again(self, numbers: Numbers) -> Self | None:
        """The same arrays, with room of their own, for the same rows and loads from another start; None where that
        changes one of them."""
        if not self.written.packing.is_of(numbers):
            return None
        other = copy(self)
        other.numbers, other.room = numbers, room_for(self.layout, space=numbers.system.space)
        vars(other).pop("idle", None)  # a run of the other room
        return other

    def state(self, poses: Floats, velocities: Floats) -> Floats:
        """The state of poses and velocities (n_bodies, 3); in space (n_bodies, 6): those of the mass centre, then the
        rotation vector and the angular velocity of the principal axes, the latter by components along them."""
        return self.border.state(poses, velocities)

    def coordinates(self, y: Floats) -> tuple[Floats, Floats]:
        """Poses and velocities of the moving bodies in a state, as `state` takes them."""
        return self.border.coordinates(y)

    def parts(self, y: Floats) -> tuple[Floats, Floats]:
        """Views on the poses and velocities of a state: (n_bodies + 1, 3), in space (n_bodies + 1, 6), where the
        rotations stand elsewhere and are zero here."""
        n, n_bodies = self.n_coordinates, self.n_bodies + 1
        return y[:n].reshape(n_bodies, -1), y[n : 2 * n].reshape(n_bodies, -1)

    def states(self, course: Trajectory) -> Floats:
        """(n_times, n_y) states along a motion."""
        return self.border.states(course)

    def state_at(self, course: Trajectory, k: int) -> Floats:
        """The state at output k of a motion."""
        return self.border.states(course, slice(k, k + 1 or None))[0]

    def accelerations(self, course: Trajectory) -> Floats:
        """(n_times, n_coordinates) accelerations along a motion."""
        return self.border.accelerations(course)

    def align(self, y: Floats, t: float, value: Callable[[Measure], float]) -> None:
        """Bearings are counted on from those of a state, in which measures have the given values: what they are off by
        is whole turns. Rows of which only changes mean something are zero there."""
        S = self.room
        S.measures[:, NEAR] = 0.0
        self._look(y, t)
        near = S.measures[:, BEARING].copy()
        for k, measure, constant, rho in self._bearings:
            off = value(measure) - constant - float(S.measures[k, 0])
            near[k] += -off / rho if rho is not None else off
        S.measures[:, NEAR] = near

    def near(self) -> Floats:
        """The bearings from which turns are counted."""
        return self.near_view.copy()

    @property
    def near_view(self) -> Floats:
        """The same, as they stand in the room."""
        return self.room.measures[:, NEAR]

    def count_from(self, near: Floats) -> None:
        """Counts turns from given bearings."""
        self.room.measures[:, NEAR] = near

    def _look(self, y: Floats, t: float) -> None:
        n, n_rows = self.n_coordinates, len(self.room.rows)
        tables = [np.zeros((1, n_rows)) for _ in range(3)]
        near = self.room.measures[:, NEAR].copy()
        observe(self.layout, self.room, np.array([t]), y.reshape(1, -1), np.zeros((1, n)), *tables)
        self.room.measures[:, NEAR] = near

    def along(
        self, course: Trajectory, measures: Iterable[Measure | NonholonomicForm]
    ) -> dict[Measure | NonholonomicForm, tuple[Floats, Floats, Floats]]:
        """(n_times,) value, rate and second derivative of each of some measures that have rows."""
        n_times, n_rows = len(course.times), len(self.room.rows)
        states, accelerations = self.states(course), self.accelerations(course)
        tables = [np.zeros((n_times, n_rows)) for _ in range(3)]
        times = np.ascontiguousarray(course.times)
        known = [(place, course.tracks.column(key)) for key, place in self.turning.items() if key in course.tracks.keys]
        if not known:
            observe(self.layout, self.room, times, states, accelerations, *tables)
        # turns are counted on from the nearest step, since there may be many between two output times
        nearest = course.tracks.nearest(times) if known else []
        edges = [0, *(np.flatnonzero(np.diff(nearest)) + 1), n_times] if nearest else []
        for start, stop in pairwise(edges):  # the times near one step
            for place, bearings in known:
                self.room.measures[place, NEAR] = bearings[nearest[start]]
            at = slice(start, stop)
            observe(self.layout, self.room, times[at], states[at], accelerations[at], *(table[at] for table in tables))
        return {m: tuple(table[:, self.rows[m]].copy() for table in tables) for m in measures}  # pyrefly: ignore[bad-return]


def packed(
    numbers: Numbers, watches: Sequence[EngineWatch] = (), tracked: Sequence[Measure | NonholonomicForm] = ()
) -> Packing:
    """The held rows and loads of a system, and what is watched."""
    packing = Packing(numbers)
    for row in numbers.system.constraint_rows:
        packing.hold(row)
    for load in numbers.system.all_loads:
        packing.load(load)
    packing.reads_turns = bool(packing.keys())
    for watch in watches:
        packing.watch(watch.measure)
    for measure in tracked:
        packing.watch(measure)
    return packing


class Observer(Packed):
    """Measures that are watched along a motion that is known."""

    def __init__(self, numbers: Numbers, measures: Sequence[Measure | NonholonomicForm]) -> None:
        packing = Packing(numbers)
        for measure in measures:
            packing.watch(measure)
        super().__init__(numbers, packing)


class Evaluator(Packed):
    """A system with a number for every parameter, packed: what is seen of it at an instant."""

    def __init__(
        self,
        numbers: Numbers,
        watches: Sequence[EngineWatch] = (),
        tracked: Sequence[Measure | NonholonomicForm] = (),
        mode: EngineRows | None = None,
    ) -> None:
        """tracked: measures whose turns are to be counted in every step of a motion. mode: another choice of held rows
        than all of the system's, of what was packed with the same watches and tracked measures."""
        self.watches = tuple(watches)
        packing = packed(numbers, watches, tracked) if mode is None else mode.written.packing
        self.is_tracked = bool(tracked) and bool(packing.keys())
        self.reads_turns = packing.reads_turns  # whether the motion depends on turns
        super().__init__(numbers, packing, mode)
        self.held = [packing.held[k].held for k in (range(len(packing.held)) if mode is None else mode.held)]
        self.applied_loads = [load for _where, load, _linear, _works in packing.applied_loads]
        self.watched_rows = [self.rows[w.measure] for w in watches]
        self.place_of = np.empty(len(self.order), dtype=np.intp)  # of the model's held rows in the order of elimination
        self.place_of[self.order] = np.arange(len(self.order))
        self._unshared: ModelArrays = self.layout
        self.is_shared = False  # whether multipliers that are not unique are the least

    def again(self, numbers: Numbers) -> Self | None:
        other = super().again(numbers)
        if other is not None:
            other.share_no_more()
        return other

    @cached_property
    def guard_programs(self) -> GuardPrograms:
        """What is guarded as programs."""
        return GuardPrograms(self.layout, self.written)

    def point(self, directions: Mapping[int, float], small: float, guard: int) -> None:
        """Slip in a plane goes in a direction, given by its components along its two rows. small: the speed below which
        it has that direction; guard: that of the slip."""
        layout = self.layout
        for k, row in enumerate(layout.slide[:, 0].tolist()):
            if row in directions:
                layout.slide_factor[k, 2:] = directions[row], small
        row, across = layout.guard[guard, 1:3].tolist()
        layout.guard_factor[guard, 0], layout.guard_factor[guard, 2] = directions[row], directions[across]
        self.__dict__.pop("guard_programs", None)

    def evaluate(self, y: Floats, t: float, n_times: int = 1) -> tuple[Floats, Floats]:
        """Accelerations (n_bodies + 1, 3), in space (n_bodies + 1, 6), and multipliers (n_held,) of a state as it is.
        Raises CannotAnswer if they are not finite."""
        out = np.zeros(self.n_y)
        stepping.visit(self.layout, self.room, self.idle, -1.0, y, t, out, n_times)
        multipliers = self.room.multiplier[self.place_of]
        if not (np.isfinite(out).all() and np.isfinite(multipliers).all()):
            raise CannotAnswer(Message("the accelerations at t = {t:.6g} s are not finite", t=t))
        return self.room.acceleration.reshape(self.n_bodies + 1, -1).copy(), multipliers

    @property
    def scale_of_held(self) -> Floats:
        """(n_held,) by which gaps of the held rows count: 1/length, 1 for angles."""
        return np.array(self.layout.held_scale)[self.place_of]

    def share_by_compliance(self, idle: Sequence[int] = ()) -> None:
        """From now on multipliers that are not unique are the least ones, sum of (lambda_i h_i)^2 over the held rows,
        h_i the size of the system where the row is a length, 1 where it is an angle: as if all joints yielded alike.
        That depends on no order of rows, on no units, and where bodies are joined by forces on no axes.

        Every row is given the same small compliance e, (J M^-1 J^T + e H^-2) lambda = b, which the passes of
        `solving.projected` take back without leaving the range of J: what is left of it is the choice of lambda.
        Rows that are `idle` yield without limit and carry nothing.
        Their sizes are those at the instant looked at last; raises RuntimeError if something was shared there.
        Source: Tikhonov regularisation, Hansen, Rank-Deficient and Discrete Ill-Posed Problems, 1998, ch. 5."""
        if self.is_shared:  # the diagonal would contain the compliance itself
            raise RuntimeError("the multipliers are shared already")
        L = self._unshared
        held = np.array(L.held_scale)
        diagonal = np.array(self.room.diagonal)[: len(held)]
        compliance = COMPLIANCE * float((diagonal * held**2).max(initial=0.0))
        base = np.array(L.schur_base)
        yielding = compliance / held**2
        yielding[self.place_of[list(idle)]] *= WITHOUT_LIMIT
        base[np.array(L.column_ptr[:-1])] += yielding
        self.layout = L._replace(schur_base=base, has_gap=L.has_gap | solving.SHARES)
        self.is_shared = True

    def share_no_more(self) -> None:
        """From now on multipliers that are not unique are as the elimination leaves them."""
        self.layout, self.is_shared = self._unshared, False

    def tape_value(self, tape: int, t: float) -> float:
        """The value of a tape at the instant looked at last."""
        L, S = self.layout, self.room
        begin, end = int(L.tape_ptr[tape]), int(L.tape_ptr[tape + 1])
        plain(play)(begin, end, L.tape, L.tape_number, t, S.rows, S.registers)
        return float(S.registers[end - 1, 0])

    def gradient_of(self, row: int) -> Floats:
        """(n_coordinates,) gradient of a row at the instant looked at last."""
        g = np.zeros((self.n_coordinates // 3, 3))
        for cell, o in self.layout.slots[self.layout.slot_ptr[row] : self.layout.slot_ptr[row + 1]]:
            g[cell] += self.room.gradient[o : o + 3]
        return g.ravel()

    def law_names(self, p: int, t: float) -> dict[str, float]:
        """What the law of a load sees at the instant looked at last."""
        load, rows = self.applied_loads[p], self.room.rows
        own = rows[self.layout.load[p, 0]]
        names = {**self.numbers.values, "t": t, RATE.name: float(own[kinematics.RATE])}
        if not isinstance(load.measure, NonholonomicForm):
            names[VALUE.name] = float(own[kinematics.VALUE]) - self.numbers.start_value(load.measure)
        for name, measure in load.measures:
            other = rows[self.rows[measure]]
            names[name], names[f"rate({name})"] = float(other[kinematics.VALUE]), float(other[kinematics.RATE])
        return names

    @cached_property
    def idle(self) -> SteppedRun:
        """A run that is not under way, for looking at single states."""
        return self.new_run(np.zeros(self.n_y), dop853.INTEGRATOR.tableau, np.zeros(0))

    def jacobian(self) -> Floats:
        """(n_held, n_bodies + 1, 3), in space (n_held, n_bodies + 1, 6), gradients of the held rows, in the order of
        the model, at the instant looked at last."""
        J = np.zeros((len(self.order), self.n_coordinates))
        ptr, slots, gradient = self.layout.held_ptr, self.layout.held_slots, self.room.gradient
        for k, r in enumerate(self.place_of):
            for coordinate, o in slots[ptr[r] : ptr[r + 1]]:
                J[k, coordinate] += gradient[o]
        return J.reshape(len(J), self.n_bodies + 1, self.n_coordinates // (self.n_bodies + 1))

    def non_unique(self) -> Any:
        """(n_held,) True for multipliers that are not unique at the instant looked at last."""
        return np.linalg.norm(self.open_multipliers()[0], axis=1) > 1e-6

    def open_multipliers(self) -> tuple[Floats, Floats]:
        """Sets of multipliers that do nothing together at the instant looked at last, (n_held, n_sets), each row by its
        size, and these sizes (n_held,)."""
        J = self.jacobian()
        n = len(J)
        weighted = J.reshape(n, self.n_coordinates) * np.sqrt(self.layout.inverse_mass)
        sizes = np.linalg.norm(weighted, axis=1)
        sizes = np.where(sizes > 1e-12 * sizes.max(initial=0.0), sizes, 1.0)
        U, singular, _ = np.linalg.svd(weighted / sizes[:, None], full_matrices=True)
        rank = int(np.count_nonzero(singular > 1e-8 * singular.max(initial=0.0)))
        return U[:, rank:], sizes

    def new_run(self, y: Floats, tableau: Tableau, outputs: Floats) -> SteppedRun:
        n_all = len(tableau.a)
        n, n_held = self.n_coordinates, len(self.order)
        states = np.zeros((6, self.n_y))
        states[stepped_run.Y] = states[stepped_run.FIRST] = y
        return SteppedRun(
            clock=np.zeros(stepped_run.N_CLOCK),
            count=np.zeros(stepped_run.N_COUNT, dtype=np.int32),
            states=states,
            slopes=np.zeros((n_all, self.n_y)),
            dense=np.zeros((3 + len(tableau.dense), self.n_y)),
            unit=self.unit,
            multiplier=np.zeros(n_held),
            out_t=np.ascontiguousarray(outputs, dtype=np.float64),
            out_y=np.zeros((len(outputs), self.n_y)),
            out_a=np.zeros((len(outputs), n)),
            out_multiplier=np.zeros((len(outputs), n_held)),
            kept_old=np.zeros((0, self.n_y)),
            kept_dense=np.zeros((0, self.n_y)),
            kept_clock=np.zeros((0, stepped_run.N_CLOCK)),
            kept_near=np.zeros((0, len(self.room.measures))),
        )
