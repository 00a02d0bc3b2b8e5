"""One run of the engine under way: steps in chunks, events, trouble, and the arrays that it leaves."""

from __future__ import annotations

import math
import time
from collections.abc import Callable
from typing import Any

import numpy as np

from freebody.language.expression import free_symbols, has_jump
from freebody.language.sentences import Message, further, in_turn
from freebody.numeric.engine.counting import Counting, bearings_at
from freebody.numeric.engine.course import NO_TRACKS, Event, Status, Trajectory
from freebody.numeric.engine.evaluator import Evaluator
from freebody.numeric.engine.events import found_in_step
from freebody.numeric.engine.integrators import integrator
from freebody.numeric.engine.patrol import Guarding, GuardMonitor, Violation
from freebody.numeric.engine.steps import KeptSteps
from freebody.numeric.engine.trouble import diagnosed
from freebody.numeric.engine.underway import MotionUnderWay
from freebody.numeric.kernels import factoring, stepped_run, stepping
from freebody.numeric.kernels.arrays import Floats
from freebody.numeric.kernels.measures_planar import BEARING, NEAR
from freebody.numeric.kernels.stepped_run import SteppedRun
from freebody.numeric.options import SimulationOptions

CHUNK = 0.1  # seconds between looks at the clock and the keyboard
EXPLICIT, STIFF = "dop853", "radau5"  # what "auto" begins with, and goes on with where a motion is stiff
Progress = Callable[[float, int], None]


def stopped(t: float, after: Message, seconds: float | None) -> Message:
    """That a motion was cut, and by what: seconds on the clock, or the number of steps."""
    by = Message("cut by max_steps")
    if seconds is not None:
        by = Message("cut by the clock (max_seconds = {seconds:g} s)", seconds=seconds)
    return Message("stopped at t = {t:.6g} s after {after}: {by}", t=t, after=after, by=by)


class RunningMotion(MotionUnderWay):
    """One run, from its start to its end."""

    def __init__(
        self,
        engine: Evaluator,
        y: Floats,
        start: float,
        until: float,
        options: SimulationOptions,
        first_step: float,
        outputs: Floats,
    ) -> None:
        is_automatic = options.method == "auto"
        method = EXPLICIT if is_automatic else options.method
        chosen = integrator(method)
        tableau = chosen.tableau
        super().__init__(engine, tableau, engine.new_run(y, tableau, outputs), until)
        self.options, self.is_automatic, self.method, self.integrator = options, is_automatic, method, chosen
        self.start = start
        clock = self.run.clock
        clock[stepped_run.END], clock[stepped_run.TOLERANCE] = until, options.tolerance
        clock[stepped_run.LONGEST], clock[stepped_run.STEP] = options.longest, options.step or first_step
        self.run.count[stepped_run.IS_WATCHED] = int(bool(engine.watches))
        self.counting: Counting | None = None
        self.patrol: GuardMonitor | None = None
        self.violation: Violation | None = None
        self.kept: KeptSteps | None = None
        self.stiffness = ""  # when it was met, and what was done about it

    def guard(self, guarding: Guarding) -> None:
        """The first violation of a guard of the layout ends the motion; see `GuardMonitor`."""
        self.patrol = GuardMonitor(self, guarding)
        self.run.count[stepped_run.IS_WATCHED] = 1

    def keep_steps(self) -> None:
        """Every step is kept with its dense output."""
        self.kept = KeptSteps()
        self.run.count[stepped_run.IS_WATCHED] = 1

    # -- the loop -----------------------------------------------------------------------------
    def course(self, began: float, progress: Progress | None) -> Trajectory:
        """The motion to its end. began: when, by the clock of the process."""
        clock = self.run.clock
        status, message = Status.UNREACHABLE, Message("the start does not hold what is held")
        if self._begin():
            if self.integrator.steps is not None:
                self.solver = self.integrator.steps(self, float(clock[stepped_run.STEP]))
            try:
                status, message = self._to_end(began, progress)
            except KeyboardInterrupt:
                now = float(clock[stepped_run.NOW])
                status, message = Status.INTERRUPTED, Message("interrupted at t = {t:.6g} s", t=now)
        loose = ""
        if clock[stepped_run.ALLOWED] > 1.0:
            loose = Message(
                "near singular poses steps were accepted with up to {n:.0e} times the tolerance",
                n=float(clock[stepped_run.ALLOWED]),
            )
        message = further(*(part for part in (message, self.stiffness, loose, *self.notes) if part))
        return self._collected(status, message, time.perf_counter() - began)

    def _to_end(self, began: float, progress: Progress | None) -> tuple[Status, str]:
        """Makes steps, as many at once as take about a time that nobody waits for, until something ends the motion."""
        clock, count, size = self.run.clock, self.run.count, 64
        while clock[stepped_run.NOW] < self.until:
            is_late = time.perf_counter() - began > self.options.max_seconds
            if is_late or count[stepped_run.STEPS] >= self.options.max_steps:
                return Status.TOO_LONG, self._too_long(is_late=is_late)

            at = time.perf_counter()
            result = self._advance(min(size, self.options.max_steps - int(count[stepped_run.STEPS])))
            took = time.perf_counter() - at
            size = max(16, min(1_000_000, int(size * min(4.0, CHUNK / max(took, 1e-6)))))
            if progress is not None:
                progress(float(clock[stepped_run.NOW]), int(count[stepped_run.STEPS]))

            if result == stepped_run.LOOK and self.kept is not None:
                self.kept.add(self.run)
            if result == stepped_run.LOOK and self.counting is not None:
                self.counting.look()
            if result == stepped_run.LOOK and self._look():
                if self.violation is not None:
                    return Status.EVENT, ""
                event = self.events[-1]
                return Status.EVENT, Message("{event} at t = {t:.9g} s", event=event.name, t=event.time)
            if result == stepped_run.TOO_SMALL:
                return self._trouble()
            # a step that is looked at ends before stiffness is
            is_stiff = result == stepped_run.LOOK and count[stepped_run.STIFF] >= stepped_run.STIFF_STEPS
            if result == stepped_run.STIFF_FOUND or (is_stiff and self.solver is None):
                self._meet_stiffness()
        return Status.FINISHED, ""

    def _too_long(self, *, is_late: bool) -> str:
        """What ended a motion that took too long, and what made its steps small, where that is known."""
        ended = stopped(
            float(self.run.clock[stepped_run.NOW]),
            Message("{n} steps", n=int(self.run.count[stepped_run.STEPS])),
            self.options.max_seconds if is_late else None,
        )
        jumping = [p.name for p in self.engine.applied_loads if has_jump(p.law, free_symbols(p.law))]
        if not jumping:
            return ended
        jumps = Message("the law of {names} jumps, which takes many small steps", names=in_turn(jumping))
        return further(ended, jumps)

    def _meet_stiffness(self) -> None:
        """Goes on by the implicit method, or says that it would take fewer steps."""
        now = float(self.run.clock[stepped_run.NOW])
        self.run.count[stepped_run.STIFF] = -1_000_000_000 if not self.is_automatic else 0
        if self.is_automatic:
            steps = integrator(STIFF).steps
            assert steps is not None
            self.solver = steps(self, 10.0 * float(self.run.clock[stepped_run.DONE_STEP]))
            self.method = f"{EXPLICIT}, then {STIFF}"
            self.stiffness = Message("stiff from t = {t:.6g} s, where the method changed to radau5", t=now)
        else:
            self.stiffness = Message("stiff from t = {t:.6g} s: radau5 takes fewer steps", t=now)

    def _advance(self, n: int) -> int:
        e = self.engine
        if self.solver is not None:
            for _ in range(min(n, 64)):
                result = self.solver.advance()
                if result == stepped_run.LOOK and self.counting is not None:
                    self.counting.keep()
                if result != stepped_run.PAUSED:
                    return result
            return stepped_run.PAUSED
        return int(stepping.advance(e.layout, e.room, self.tableau, self.run, n))

    def _begin(self) -> bool:
        e, run = self.engine, self.run
        clock, y = run.clock, run.states[0]
        n = e.n_coordinates
        clock[stepped_run.NOW] = clock[stepped_run.BEFORE] = self.start
        # a speed that moves nothing by a thousandth of its size within the whole time does not matter
        slowest = 1e-3 / (self.until - self.start)
        clock[stepped_run.SPEED] = float((np.abs(y[n : 2 * n]) / e.unit).max(initial=slowest))
        e.room.info[factoring.N_REDUNDANT] = e.room.info[factoring.BEST_OF_MOTION] = 0.0
        if not stepping.visit(e.layout, e.room, run, -1.0, y, self.start, run.slopes[0], 0):
            return False
        if not np.isfinite(run.slopes[0]).all():
            return False
        run.count[stepped_run.LEFT_OUT] = int(e.room.info[factoring.N_LEFT_OUT])
        clock[stepped_run.BEST_PIVOT] = e.room.info[factoring.SMALLEST_PIVOT]
        e.room.measures[:, NEAR] = e.room.measures[:, BEARING]
        run.multiplier[:] = e.room.multiplier
        fastest = float((np.abs(y[n : 2 * n]) / e.unit).max(initial=0.0))
        hardest = float((np.abs(run.slopes[0][n : 2 * n]) / e.unit).max(initial=0.0))
        rate = fastest + math.sqrt(hardest)
        order, is_adaptive = int(self.tableau.sizes[2]), self.integrator.is_adaptive
        h = self.until - self.start
        if is_adaptive and rate > 0.0:
            h = min(h, 0.1 / rate * (clock[stepped_run.TOLERANCE] * 1e6) ** (1.0 / order))
        if clock[stepped_run.STEP] == 0.0:
            clock[stepped_run.STEP] = h if is_adaptive else h / 1000.0
        self._store_start()
        if e.is_tracked:
            is_read = e.reads_turns or bool(e.watches) or self.patrol is not None
            self.counting = Counting(e, run, is_read=is_read)
            self.run: SteppedRun = self.counting.run
        if e.watches:
            self._begin_searches()
        return True

    def _begin_searches(self) -> None:
        """What is zero at the start is an event there."""
        from freebody.numeric.engine.search import ProgramSearch

        e, tolerance = self.engine, float(self.run.clock[stepped_run.TOLERANCE])
        near, self.run.states[stepped_run.OLD] = e.near(), self.run.states[stepped_run.Y]
        for watch, row, value in zip(e.watches, e.watched_rows, self.values(), strict=True):
            program = e.written.program(row, watch.order)
            search = ProgramSearch(program, watch.value, watch.size, tolerance, near)
            search.begin(value)
            search.calibrate(self.run, value)
            self.searches.append(search)
            if abs(value) <= search.zero:
                self.events.append(Event(self.start, watch.name, "start"))

    def _store_start(self) -> None:
        """Output times that are not after the start get the start."""
        run, e = self.run, self.engine
        k = 0
        while k < len(run.out_t) and run.out_t[k] <= self.start:
            run.out_y[k] = run.states[0]
            run.out_a[k] = e.room.acceleration
            run.out_multiplier[k] = e.room.multiplier
            k += 1
        run.count[stepped_run.OUTPUTS] = k

    def _look(self) -> bool:
        """Finds the events of the last step; True if a terminal one ends the motion there."""
        violation = None if self.patrol is None else self.patrol.violation()
        if self.engine.watches and found_in_step(self, violation):
            return True
        if violation is None:
            return False
        self.violation = violation
        self.keep(violation.time, violation.state)
        return True

    # -- trouble ------------------------------------------------------------------------------
    def _trouble(self) -> tuple[Status, str]:
        return diagnosed(self.engine, self.run)

    # -- the result ---------------------------------------------------------------------------
    def _collected(self, status: Status, message: str, wall: float) -> Trajectory:
        e, run, n = self.engine, self.run, self.engine.n_coordinates
        tracks = NO_TRACKS if self.counting is None else self.counting.tracks()
        k = int(run.count[stepped_run.OUTPUTS])
        now = float(run.clock[stepped_run.NOW])
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
        last = math.inf
        if status is Status.EVENT:
            last = self.events[-1].time if self.violation is None else self.violation.time
        order = np.array([i for i in order if times[i] <= last], dtype=np.intp)
        Y = np.array(states)[order]
        multiplier_rows = np.array(multipliers).reshape(len(times), -1)[order][:, e.place_of]
        T = np.array(times)[order]
        near = e.near()
        if len(tracks.times) and last < tracks.times[-1]:  # the last step goes beyond: turns are counted to its event
            tracks = tracks.until(last)
            near = bearings_at(e, tracks.bearings[-1], T[-1:], Y[-1:])[0]
        track = e.border.track(Y, np.array(accelerations)[order].reshape(len(T), n))
        return Trajectory(
            status=status,
            message=message,
            times=T,
            poses=track.poses,
            velocities=track.velocities,
            accelerations=track.accelerations,
            multipliers=multiplier_rows,
            unique=self._unique(T, Y, multiplier_rows.shape),
            work=Y[:, 2 * n].copy(),
            events=tuple(self.events),
            n_steps=int(run.count[stepped_run.STEPS]),
            n_evaluations=int(run.count[stepped_run.EVALUATIONS]),
            n_rejected=int(run.count[stepped_run.REJECTED]),
            n_regularised=int(run.count[stepped_run.REGULARISED]),
            wall_time=wall,
            place_gap=float(run.clock[stepped_run.PLACE_GAP]),
            motion_gap=float(run.clock[stepped_run.MOTION_GAP]),
            last_step=float(run.clock[stepped_run.STEP]),
            method=self.method,
            tracks=tracks,
            near=near,
            violated=-1 if self.violation is None else self.violation.guard,
            rotation=track.rotation,
            steps=None if self.kept is None else self.kept.all(),
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
            is_open = e.is_shared or e.room.info[factoring.N_LEFT_OUT] > 0.0
            if is_open or e.room.info[factoring.IS_REGULARISED] > 0.0:
                mask = e.non_unique()
                unique[k] = ~mask
                known.append(mask)
            elif k == 0 and self.run.count[stepped_run.REGULARISED] == 0:
                return unique
        return unique
