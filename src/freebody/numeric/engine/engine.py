"""The engine from Python: a packed system, its instants and its motions."""

from __future__ import annotations

import math
import time
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from freebody.errors import CannotAnswer
from freebody.language.expression import free_symbols, has_jump
from freebody.measures.base import Measure
from freebody.model.elements import RATE, VALUE, RateMeasure
from freebody.numeric.engine import dynamics, stepping
from freebody.numeric.engine.course import Course, Happening, Status, Tracks
from freebody.numeric.engine.implicit import Implicit
from freebody.numeric.engine.jit import plain
from freebody.numeric.engine.layout import Floats, room_for
from freebody.numeric.engine.measures_planar import BEARING, NEAR
from freebody.numeric.engine.observing import observe
from freebody.numeric.engine.packing import Packing
from freebody.numeric.engine.stepping import Run
from freebody.numeric.engine.tableaus import CLASSICAL, DOP853, DOPRI5, Tableau
from freebody.numeric.engine.tape import play
from freebody.numeric.numbers import Numbers

# methods by name; the implicit one borrows the room of a tableau
METHODS: Mapping[str, Tableau] = {"dop853": DOP853, "dopri5": DOPRI5, "radau5": CLASSICAL, "rk4": CLASSICAL}
CHUNK = 0.1  # seconds between looks at the clock and the keyboard
Progress = Callable[[float, int], None]


@dataclass(frozen=True)
class Watch:
    """Something whose zero is an event: a measure (order 0) or its rate (order 1) minus a value; or, without a
    measure, a multiplier by its place among the held rows, times `sign`."""

    name: str
    measure: Measure | RateMeasure | None = None
    order: int = 0
    value: float = 0.0
    direction: int = 0  # 1: rising only, -1: falling only
    is_terminal: bool = False
    held: int = -1
    sign: int = 1
    size: float = 1.0  # what counts as large


class Packed:
    """Rows of a system in arrays, and the room in which they are evaluated."""

    def __init__(self, numbers: Numbers, packing: Packing) -> None:
        self.numbers = numbers
        self.n_bodies = packing.n_bodies
        self.layout, self.order, self.rows = packing.layout()
        self._bearings = packing.bearings()
        self.turning = packing.keys()
        self.room = room_for(self.layout)
        self.n_y = 6 * (self.n_bodies + 1) + 1
        unit = np.ones((self.n_bodies + 1, 3))
        unit[:, :2] = numbers.length
        self.unit = unit.ravel()

    def state(self, poses: Floats, velocities: Floats) -> Floats:
        """The state of poses and velocities (n_bodies, 3)."""
        y = np.zeros(self.n_y)
        q, v = self.parts(y)
        q[:-1], v[:-1] = poses, velocities
        return y

    def parts(self, y: Floats) -> tuple[Floats, Floats]:
        """Views on the poses and velocities (n_bodies + 1, 3) of a state."""
        n = 3 * (self.n_bodies + 1)
        return y[:n].reshape(-1, 3), y[n : 2 * n].reshape(-1, 3)

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
        return self.room.measures[:, NEAR].copy()

    def count_from(self, near: Floats) -> None:
        """Counts turns from given bearings."""
        self.room.measures[:, NEAR] = near

    def _look(self, y: Floats, t: float) -> None:
        n, n_rows = 3 * (self.n_bodies + 1), len(self.room.rows)
        tables = [np.zeros((1, n_rows)) for _ in range(3)]
        near = self.room.measures[:, NEAR].copy()
        observe(self.layout, self.room, np.array([t]), y.reshape(1, -1), np.zeros((1, n)), *tables)
        self.room.measures[:, NEAR] = near


class Observer(Packed):
    """Measures that are watched along a motion that is known."""

    def __init__(self, numbers: Numbers, measures: Sequence[Measure | RateMeasure]) -> None:
        packing = Packing(numbers)
        for measure in measures:
            packing.watch(measure)
        super().__init__(numbers, packing)
        self.measures = tuple(measures)

    def along(self, course: Course) -> dict[Measure | RateMeasure, tuple[Floats, Floats, Floats]]:
        """(n_times,) value, rate and second derivative of each measure."""
        n_times, n_rows = len(course.times), len(self.room.rows)
        states = np.zeros((n_times, self.n_y))
        n = 3 * (self.n_bodies + 1)
        states[:, :n] = course.poses.reshape(n_times, -1)
        states[:, n : 2 * n] = course.velocities.reshape(n_times, -1)
        tables = [np.zeros((n_times, n_rows)) for _ in range(3)]
        accelerations = np.ascontiguousarray(course.accelerations.reshape(n_times, -1))
        times = np.ascontiguousarray(course.times)
        known = [(place, course.tracks.column(key)) for key, place in self.turning.items() if key in course.tracks.keys]
        if not known:
            observe(self.layout, self.room, times, states, accelerations, *tables)
        # turns are counted on from the nearest step, since there may be many between two output times
        nearest = course.tracks.nearest(times) if known else []
        for k, step in enumerate(nearest):
            for place, bearings in known:
                self.room.measures[place, NEAR] = bearings[step]
            at = slice(k, k + 1)
            observe(self.layout, self.room, times[at], states[at], accelerations[at], *(table[at] for table in tables))
        return {m: tuple(table[:, self.rows[m]].copy() for table in tables) for m in self.measures}  # type: ignore[misc]


class Engine(Packed):
    """A system with a number for every parameter, packed."""

    def __init__(
        self, numbers: Numbers, watches: Sequence[Watch] = (), tracked: Sequence[Measure | RateMeasure] = ()
    ) -> None:
        """tracked: measures whose turns are to be counted in every step of a motion."""
        self.watches = tuple(watches)
        packing = Packing(numbers)
        for row in numbers.system.held:
            packing.hold(row)
        for push in numbers.system.pushes:
            packing.push(push)
        for watch in watches:
            if watch.measure is not None:
                packing.watch(watch.measure)
        before = packing.keys().keys()
        for measure in tracked:
            packing.watch(measure)
        self.is_tracked = bool(packing.keys().keys() - before) or bool(before and tracked)
        super().__init__(numbers, packing)
        self.pushes = packing.pushes
        self.watched_rows = [-1 if w.measure is None else self.rows[w.measure] for w in watches]
        self.place_of = np.empty(len(self.order), dtype=np.intp)  # of the model's held rows in the order of elimination
        self.place_of[self.order] = np.arange(len(self.order))

    def evaluate(self, y: Floats, t: float, n_times: int = 1) -> tuple[Floats, Floats]:
        """Accelerations (n_bodies + 1, 3) and multipliers (n_held,) of a state as it is. Raises CannotAnswer if they
        are not finite."""
        out = np.zeros(self.n_y)
        stepping.visit(self.layout, self.room, self.idle, -1.0, y, t, out, n_times)
        multipliers = self.room.multiplier[self.place_of]
        if not (np.isfinite(out).all() and np.isfinite(multipliers).all()):
            raise CannotAnswer(f"the accelerations at t = {t:.6g} s are not finite")
        return self.room.acceleration.reshape(-1, 3).copy(), multipliers

    def tape_value(self, tape: int, t: float) -> float:
        """The value of a tape at the instant looked at last."""
        L, S = self.layout, self.room
        begin, end = int(L.tape_ptr[tape]), int(L.tape_ptr[tape + 1])
        plain(play)(begin, end, L.tape, L.tape_number, t, S.rows, S.registers)
        return float(S.registers[end - 1, 0])

    def largest_gaps(self, y: Floats, t: float) -> tuple[float, float]:
        """How far a state is from what is held, at most: positions and velocities, by the size of the system."""
        own = self.idle
        state = y.copy()
        stepping.visit(self.layout, self.room, own, -1.0, state, t, np.zeros(self.n_y), 0)
        n = 3 * (self.n_bodies + 1)
        moved = np.abs(state - y)
        return float((moved[:n] / self.unit).max()), float((moved[n : 2 * n] / self.unit).max())

    def gradient_of(self, row: int) -> Floats:
        """(3 (n_bodies + 1),) gradient of a row at the instant looked at last."""
        g = np.zeros((self.n_bodies + 1, 3))
        for body, o in self.layout.slots[self.layout.slot_ptr[row] : self.layout.slot_ptr[row + 1]]:
            g[body] += self.room.gradient[o : o + 3]
        return g.ravel()

    def law_names(self, p: int, t: float) -> dict[str, float]:
        """What the law of a load sees at the instant looked at last."""
        push, rows = self.pushes[p], self.room.rows
        own = rows[self.layout.push[p, 0]]
        names = {**self.numbers.values, "t": t, RATE.name: float(own[dynamics.RATE])}
        if not isinstance(push.measure, RateMeasure):
            names[VALUE.name] = float(own[dynamics.VALUE]) - self.numbers.start_value(push.measure)
        for name, measure in push.measures:
            other = rows[self.rows[measure]]
            names[name], names[f"rate({name})"] = float(other[dynamics.VALUE]), float(other[dynamics.RATE])
        return names

    @property
    def idle(self) -> Run:
        """A run that is not under way, for looking at single states."""
        return self.new_run(np.zeros(self.n_y), DOP853, np.zeros(0))

    def jacobian(self) -> Floats:
        """(n_held, n_bodies + 1, 3) gradients of the held rows, in the order of the model, at the instant looked at
        last."""
        J = np.zeros((len(self.order), self.n_bodies + 1, 3))
        ptr, slots, gradient = self.layout.held_ptr, self.layout.held_slots, self.room.gradient
        for k, r in enumerate(self.place_of):
            for coordinate, o in slots[ptr[r] : ptr[r + 1]]:
                J[k, coordinate // 3, coordinate % 3] += gradient[o]
        return J

    def non_unique(self) -> Any:
        """(n_held,) True for multipliers that are not unique at the instant looked at last."""
        J = self.jacobian()
        n = len(J)
        weighted = J.reshape(n, -1) * np.sqrt(self.layout.inverse_mass)
        sizes = np.linalg.norm(weighted, axis=1)
        scaled = weighted / np.where(sizes > 1e-12 * sizes.max(initial=0.0), sizes, 1.0)[:, None]
        U, singular, _ = np.linalg.svd(scaled, full_matrices=True)
        rank = int(np.count_nonzero(singular > 1e-8 * singular.max(initial=0.0)))
        return np.linalg.norm(U[:, rank:], axis=1) > 1e-6

    # -- motions ------------------------------------------------------------------------------
    def new_run(self, y: Floats, tableau: Tableau, outputs: Floats) -> Run:
        n_all = len(tableau.a)
        n, n_held = 3 * (self.n_bodies + 1), len(self.order)
        states = np.zeros((6, self.n_y))
        states[stepping.Y] = states[stepping.FIRST] = y
        return Run(
            clock=np.zeros(stepping.N_CLOCK),
            count=np.zeros(stepping.N_COUNT, dtype=np.int32),
            states=states,
            slopes=np.zeros((n_all, self.n_y)),
            dense=np.zeros((3 + len(tableau.dense), self.n_y)),
            unit=self.unit,
            multiplier=np.zeros(n_held),
            out_t=np.ascontiguousarray(outputs, dtype=np.float64),
            out_y=np.zeros((len(outputs), self.n_y)),
            out_a=np.zeros((len(outputs), n)),
            out_multiplier=np.zeros((len(outputs), n_held)),
        )

    def run(
        self,
        y: Floats,
        until: float,
        *,
        start: float = 0.0,
        tolerance: float = 1e-9,
        method: str = "dop853",
        step: float = 0.0,
        longest: float = math.inf,
        outputs: Floats | None = None,
        max_seconds: float = math.inf,
        max_steps: int = 10_000_000,
        progress: Progress | None = None,
    ) -> Course:
        """The motion from a state at the time `start` [s] to `until`, or to a terminal event. tolerance: the error
        allowed in a step, relative to the size of the system (`stepping`). step: the first step, or the only one of a
        method without error control. outputs: times at which the motion is wanted, besides its events and its end."""
        began = time.perf_counter()
        wanted = np.array([until]) if outputs is None else outputs
        return Motion(self, y, start, until, tolerance, method, step, longest, wanted).course(
            began, max_seconds, max_steps, progress
        )


class Motion:
    """One run under way."""

    def __init__(
        self,
        engine: Engine,
        y: Floats,
        start: float,
        until: float,
        tolerance: float,
        method: str,
        step: float,
        longest: float,
        outputs: Floats,
    ) -> None:
        self.engine = engine
        self.is_automatic, self.method = method == "auto", "dop853" if method == "auto" else method
        self.start, self.until = start, until
        self.tableau = METHODS[self.method]
        self.run = engine.new_run(y, self.tableau, outputs)
        clock = self.run.clock
        clock[stepping.END], clock[stepping.TOLERANCE], clock[stepping.LENGTH] = until, tolerance, engine.numbers.length
        clock[stepping.LONGEST], clock[stepping.STEP] = longest, step
        self.run.count[stepping.IS_WATCHED] = int(bool(engine.watches) or engine.is_tracked)
        self.tracks: list[tuple[float, Floats]] = []
        self.extra: list[tuple[float, Floats, Floats, Floats]] = []  # states at events
        self.happenings: list[Happening] = []
        self.implicit: Implicit | None = None

    # -- the loop -----------------------------------------------------------------------------
    def course(self, began: float, max_seconds: float, max_steps: int, progress: Progress | None) -> Course:
        clock, count = self.run.clock, self.run.count
        status, message, note = Status.FINISHED, "", ""
        if not self._begin():
            status, message = Status.UNREACHABLE, "the start does not hold what is held"
        else:
            size = 64
            if self.method == "radau5":
                self.implicit = Implicit(self, float(clock[stepping.STEP]))
            try:
                while clock[stepping.NOW] < self.until:
                    if time.perf_counter() - began > max_seconds or count[stepping.STEPS] >= max_steps:
                        status = Status.TOO_LONG
                        message = f"stopped at t = {clock[stepping.NOW]:.6g} s after {count[stepping.STEPS]} steps"
                        jumping = [p.name for p in self.engine.pushes if has_jump(p.law, free_symbols(p.law))]
                        if jumping:
                            message += f"; the law of {', '.join(jumping)} jumps, which takes many small steps"
                        break
                    at = time.perf_counter()
                    result = self._advance(min(size, max_steps - int(count[stepping.STEPS])))
                    took = time.perf_counter() - at
                    size = max(16, min(1_000_000, int(size * min(4.0, CHUNK / max(took, 1e-6)))))
                    if progress is not None:
                        progress(float(clock[stepping.NOW]), int(count[stepping.STEPS]))
                    if result == stepping.LOOK:
                        self._track()
                    if result == stepping.LOOK and self.engine.watches and self._look():
                        status = Status.EVENT
                        message = f"{self.happenings[-1].name} at t = {self.happenings[-1].time:.9g} s"
                        break
                    if result == stepping.TOO_SMALL:
                        status, message = self._trouble()
                        break
                    if result == stepping.STIFF_FOUND:
                        count[stepping.STIFF] = -1_000_000_000 if not self.is_automatic else 0
                        stiff = f"stiff from t = {clock[stepping.NOW]:.6g} s"
                        if self.is_automatic:
                            self.implicit = Implicit(self, 10.0 * float(clock[stepping.DONE_STEP]))
                            self.method, note = "dop853, then radau5", f"{stiff}, where the method changed to radau5"
                        else:
                            note = f"{stiff}: radau5 takes fewer steps"
            except KeyboardInterrupt:
                status, message = Status.INTERRUPTED, f"interrupted at t = {clock[stepping.NOW]:.6g} s"
        return self._collected(status, "; ".join(part for part in (message, note) if part), time.perf_counter() - began)

    def _track(self) -> None:
        if self.engine.is_tracked:
            self.tracks.append((float(self.run.clock[stepping.NOW]), self.engine.near()))

    def _advance(self, n: int) -> int:
        e = self.engine
        if self.implicit is not None:
            for _ in range(min(n, 64)):
                result = self.implicit.advance()
                if result != stepping.PAUSED:
                    return result
            return stepping.PAUSED
        return int(stepping.advance(e.layout, e.room, self.tableau, self.run, n))

    def _begin(self) -> bool:
        e, run = self.engine, self.run
        clock, y = run.clock, run.states[0]
        n = 3 * (e.n_bodies + 1)
        clock[stepping.NOW] = clock[stepping.BEFORE] = self.start
        # a speed that moves nothing by a thousandth of its size within the whole time does not matter
        slowest = 1e-3 / (self.until - self.start)
        clock[stepping.SPEED] = float((np.abs(y[n : 2 * n]) / e.unit).max(initial=slowest))
        if not stepping.visit(e.layout, e.room, run, -1.0, y, self.start, run.slopes[0], 0):
            return False
        if not np.isfinite(run.slopes[0]).all():
            return False
        run.count[stepping.LEFT_OUT] = int(e.room.info[dynamics.N_LEFT_OUT])
        clock[stepping.BEST_PIVOT] = e.room.info[dynamics.SMALLEST_PIVOT]
        e.room.measures[:, NEAR] = e.room.measures[:, BEARING]
        run.multiplier[:] = e.room.multiplier
        fastest = float((np.abs(y[n : 2 * n]) / e.unit).max(initial=0.0))
        hardest = float((np.abs(run.slopes[0][n : 2 * n]) / e.unit).max(initial=0.0))
        rate = fastest + math.sqrt(hardest)
        order, is_adaptive = int(self.tableau.sizes[2]), self.method != "rk4"
        h = self.until - self.start
        if is_adaptive and rate > 0.0:
            h = min(h, 0.1 / rate * (clock[stepping.TOLERANCE] * 1e6) ** (1.0 / order))
        if clock[stepping.STEP] == 0.0:
            clock[stepping.STEP] = h if is_adaptive else h / 1000.0
        self._store_start()
        self._track()
        if e.watches:
            self.values_before = self._values()
            for watch, value in zip(e.watches, self.values_before, strict=True):
                if abs(value) <= 1e-12 * watch.size and watch.measure is not None:
                    self.happenings.append(Happening(self.start, watch.name, "start"))
        return True

    def _store_start(self) -> None:
        """Output times that are not after the start get the start."""
        run, e = self.run, self.engine
        k = 0
        while k < len(run.out_t) and run.out_t[k] <= self.start:
            run.out_y[k] = run.states[0]
            run.out_a[k] = e.room.acceleration
            run.out_multiplier[k] = e.room.multiplier
            k += 1
        run.count[stepping.OUTPUTS] = k

    # -- events -------------------------------------------------------------------------------
    def _values(self) -> list[float]:
        """What is watched, at the instant looked at last."""
        rows, multiplier = self.engine.room.rows, self.engine.room.multiplier
        values: list[float] = []
        for watch, row in zip(self.engine.watches, self.engine.watched_rows, strict=True):
            if watch.measure is None:
                values.append(watch.sign * float(multiplier[self.engine.place_of[watch.held]]))
            else:
                column = dynamics.VALUE if watch.order == 0 else dynamics.RATE
                values.append(float(rows[row, column]) - watch.value)
        return values

    def values_at(self, s: float, y: Floats, t: float) -> list[float]:
        """What is watched at the part s of the last step; y becomes the state there."""
        e = self.engine
        stepping.visit(e.layout, e.room, self.run, s, y, t, self._slope, 0)
        return self._values()

    def step_of(self, h: float) -> tuple[Floats, list[float], list[float]] | None:
        """The state after a step of the given length from where the last step began, what is watched there, and its
        rates; None if there is no such step."""
        e, run = self.engine, self.run
        if self.implicit is not None:
            after = self.implicit.state_after(h)
            return None if after is None else self._seen(after, float(run.clock[stepping.BEFORE]) + h)
        own = e.new_run(run.states[1], self.tableau, np.zeros(0))
        own.clock[:] = run.clock
        stepping.visit(e.layout, e.room, own, -1.0, own.states[0], float(run.clock[stepping.BEFORE]), own.slopes[0], 1)
        own.clock[stepping.NOW], own.clock[stepping.STEP] = run.clock[stepping.BEFORE], h
        own.clock[stepping.END], own.clock[stepping.TOLERANCE] = run.clock[stepping.BEFORE] + h, 1e6
        own.count[stepping.LEFT_OUT], own.count[stepping.IS_CAREFUL] = run.count[stepping.LEFT_OUT], 1
        near = e.room.measures[:, NEAR].copy()
        result = stepping.advance(e.layout, e.room, self.tableau, own, 1)
        e.room.measures[:, NEAR] = near
        if result not in (stepping.REACHED, stepping.PAUSED) or own.clock[stepping.NOW] < own.clock[stepping.END]:
            return None
        return self._seen(own.states[0].copy(), float(own.clock[stepping.NOW]))

    def _seen(self, state: Floats, t: float) -> tuple[Floats, list[float], list[float]]:
        e = self.engine
        values = self.values_at(-1.0, state, t)
        rates = [0.0 if row < 0 else float(e.room.rows[row, dynamics.RATE]) for row in e.watched_rows]
        return state, values, rates

    def say_zero(self, watch: Watch, t: float) -> None:
        """Notes, once, that something is zero throughout."""
        if all(h.name != watch.name or h.kind != "zero" for h in self.happenings) and watch.measure is not None:
            self.happenings.append(Happening(t, watch.name, "zero"))

    def add(self, happening: Happening, state: Floats | None) -> None:
        """Notes an event, and the motion at its instant."""
        e = self.engine
        self.happenings.append(happening)
        if state is not None:
            self.values_at(-1.0, state, happening.time)
            n = 3 * (e.n_bodies + 1)
            self.extra.append((happening.time, state, self._slope[n : 2 * n].copy(), e.room.multiplier.copy()))

    def _look(self) -> bool:
        """Finds the events of the last step; True if a terminal one ends the motion there."""
        from freebody.numeric.engine.events import found_in_step

        return found_in_step(self)

    # -- trouble ------------------------------------------------------------------------------
    def _trouble(self) -> tuple[Status, str]:
        from freebody.numeric.engine.trouble import diagnosed

        return diagnosed(self.engine, self.run)

    # -- the result ---------------------------------------------------------------------------
    def _collected(self, status: Status, message: str, wall: float) -> Course:
        e, run = self.engine, self.run
        n = 3 * (e.n_bodies + 1)
        k = int(run.count[stepping.OUTPUTS])
        now = float(run.clock[stepping.NOW])
        times = [float(t) for t in run.out_t[:k]]
        states = [run.out_y[i] for i in range(k)]
        accelerations = [run.out_a[i] for i in range(k)]
        multipliers = [run.out_multiplier[i] for i in range(k)]
        n_slopes = run.slopes[0]
        extra = list(self.extra)
        if not times or times[-1] < now:
            extra.append((now, run.states[0].copy(), n_slopes[n : 2 * n].copy(), run.multiplier.copy()))
        known = set(times)
        for t, y, a, m in extra:
            if t not in known:
                known.add(t)
                times.append(t)
                states.append(y)
                accelerations.append(a)
                multipliers.append(m)
        order = np.argsort(times, kind="stable")
        last = self.happenings[-1].time if status is Status.EVENT else math.inf
        order = np.array([i for i in order if times[i] <= last], dtype=np.intp)
        Y = np.array(states)[order]
        multiplier_rows = np.array(multipliers).reshape(len(times), -1)[order][:, e.place_of]
        T = np.array(times)[order]
        shape = (len(T), e.n_bodies + 1, 3)
        return Course(
            status=status,
            message=message,
            times=T,
            poses=Y[:, :n].reshape(shape),
            velocities=Y[:, n : 2 * n].reshape(shape),
            accelerations=np.array(accelerations)[order].reshape(shape),
            multipliers=multiplier_rows,
            unique=self._unique(T, Y, multiplier_rows.shape),
            work=Y[:, -1].copy(),
            happenings=tuple(self.happenings),
            n_steps=int(run.count[stepping.STEPS]),
            n_evaluations=int(run.count[stepping.EVALUATIONS]),
            n_rejected=int(run.count[stepping.REJECTED]),
            n_regularised=int(run.count[stepping.REGULARISED]),
            wall_time=wall,
            place_gap=float(run.clock[stepping.PLACE_GAP]),
            motion_gap=float(run.clock[stepping.MOTION_GAP]),
            last_step=float(run.clock[stepping.STEP]),
            method=self.method,
            tracks=Tracks.of(e.turning, self.tracks),
            near=e.room.measures[:, NEAR].copy(),
        )

    def _unique(self, times: Floats, states: Floats, shape: tuple[int, ...]) -> Any:
        """Which multipliers are unique, looked up where rows depend on each other."""
        e = self.engine
        unique = np.ones(shape, dtype=bool)
        if not shape[1]:
            return unique
        out = np.zeros(e.n_y)
        known: list[Any] = []
        for k, t in enumerate(times):
            if len(known) >= 8 and all((m == known[0]).all() for m in known):
                unique[k] = ~known[0]  # rows that depend on each other everywhere
                continue
            stepping.visit(e.layout, e.room, self.run, -1.0, states[k].copy(), float(t), out, 1)
            if e.room.info[dynamics.IS_REGULARISED] > 0.0 or e.room.info[dynamics.N_LEFT_OUT] > 0.0:
                mask = e.non_unique()
                unique[k] = ~mask
                known.append(mask)
            elif k == 0 and self.run.count[stepping.REGULARISED] == 0:
                return unique
        return unique

    @property
    def _slope(self) -> Floats:
        if not hasattr(self, "_slope_room"):
            self._slope_room = np.zeros(self.engine.n_y)
        return self._slope_room
