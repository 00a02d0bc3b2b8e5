"""A motion while it runs: its steps, what is watched in them, and the events found so far."""

from __future__ import annotations

from functools import cached_property

import numpy as np

from freebody.language.sentences import Message
from freebody.numeric.engine.course import Event
from freebody.numeric.engine.evaluator import EngineWatch, Evaluator
from freebody.numeric.engine.integrators.base import OwnSteps
from freebody.numeric.engine.search import ProgramSearch
from freebody.numeric.kernels import kinematics, stepped_run, stepping
from freebody.numeric.kernels.arrays import Floats
from freebody.numeric.kernels.measures_planar import NEAR
from freebody.numeric.kernels.stepped_run import SteppedRun, Tableau


class MotionUnderWay:
    """The steps of one run."""

    def __init__(self, engine: Evaluator, tableau: Tableau, run: SteppedRun, until: float) -> None:
        self.engine, self.tableau, self.run, self.until = engine, tableau, run, until
        self.solver: OwnSteps | None = None
        self.searches: list[ProgramSearch] = []  # of what is watched
        self.notes: list[Message] = []
        self.extra: list[tuple[float, Floats, Floats, Floats]] = []  # states at events
        self.events: list[Event] = []

    def values(self) -> list[float]:
        """What is watched, at the instant looked at last."""
        return [self.derivatives_of(k)[watch.order] for k, watch in enumerate(self.engine.watches)]

    def derivatives_of(self, k: int) -> tuple[float, float, float]:
        """Value, rate and second derivative of what is watched, at the instant looked at last, counted from where it is
        zero."""
        e, watch, row = self.engine, self.engine.watches[k], self.engine.watched_rows[k]
        value, rate, bias = (float(e.room.rows[row, c]) for c in (kinematics.VALUE, kinematics.RATE, kinematics.BIAS))
        if watch.order == 0:
            value -= watch.value
        else:
            rate -= watch.value
        return value, rate, bias + float(e.gradient_of(row) @ e.room.acceleration)

    def values_at(self, s: float, y: Floats, t: float) -> list[float]:
        """What is watched at the part s of the last step; y becomes the state there."""
        e = self.engine
        stepping.visit(e.layout, e.room, self.run, s, y, t, self.slope, 0)
        return self.values()

    def step_of(self, h: float) -> Floats | None:
        """The state after a step of the given length from where the last step began, which is then looked at; None if
        there is no such step."""
        e, run = self.engine, self.run
        if self.solver is not None:
            after = self.solver.state_after(h)
            return None if after is None else self._seen(after, float(run.clock[stepped_run.BEFORE]) + h)
        own = e.new_run(run.states[1], self.tableau, np.zeros(0))
        own.clock[:] = run.clock
        stepping.visit(
            e.layout, e.room, own, -1.0, own.states[0], float(run.clock[stepped_run.BEFORE]), own.slopes[0], 1
        )
        own.clock[stepped_run.NOW], own.clock[stepped_run.STEP] = run.clock[stepped_run.BEFORE], h
        own.clock[stepped_run.END], own.clock[stepped_run.TOLERANCE] = run.clock[stepped_run.BEFORE] + h, 1e6
        own.count[stepped_run.LEFT_OUT], own.count[stepped_run.IS_CAREFUL] = run.count[stepped_run.LEFT_OUT], 1
        near = e.room.measures[:, NEAR].copy()
        result = stepping.advance(e.layout, e.room, self.tableau, own, 1)
        e.room.measures[:, NEAR] = near
        if (
            result not in (stepped_run.REACHED, stepped_run.PAUSED)
            or own.clock[stepped_run.NOW] < own.clock[stepped_run.END]
        ):
            return None
        return self._seen(own.states[0].copy(), float(own.clock[stepped_run.NOW]))

    def _seen(self, state: Floats, t: float) -> Floats:
        stepping.visit(self.engine.layout, self.engine.room, self.run, -1.0, state, t, self.slope, 0)
        return state

    def say_zero(self, watch: EngineWatch, t: float) -> None:
        """Notes, once, that something is zero throughout."""
        if all(h.name != watch.name or h.kind != "zero" for h in self.events):
            self.events.append(Event(t, watch.name, "zero"))

    def say_unsearched(self, what: str, part: float) -> None:
        """Notes that events may have been overlooked in the last step from a part of it on."""
        begin, end = float(self.run.clock[stepped_run.BEFORE]), float(self.run.clock[stepped_run.NOW])
        t = begin + part * (end - begin)
        self.notes.append(
            Message(
                "{what} was not looked for between t = {t:.9g} s and {end:.9g} s: it happens too often in one step; "
                "set a shorter longest step (max_step)",
                what=what,
                t=t,
                end=end,
            )
        )

    def add(self, happening: Event, state: Floats | None) -> None:
        """Notes an event, and the motion at its instant."""
        self.events.append(happening)
        if state is not None:
            self.keep(happening.time, state)

    def keep(self, t: float, state: Floats) -> None:
        """The motion at an instant between output times."""
        e = self.engine
        self.values_at(-1.0, state, t)
        n = e.n_coordinates
        self.extra.append((t, state, self.slope[n : 2 * n].copy(), e.room.multiplier.copy()))

    @cached_property
    def slope(self) -> Floats:
        """(n_y,) room for a slope."""
        return np.zeros(self.engine.n_y)
