"""The engine from Python: the motions of a packed system."""

from __future__ import annotations

import time
from collections.abc import Iterator
from dataclasses import replace
from typing import TYPE_CHECKING, Any

import numpy as np

from freebody.numeric.engine.course import Trajectory
from freebody.numeric.engine.evaluator import Evaluator
from freebody.numeric.kernels.arrays import Floats
from freebody.numeric.options import SimulationOptions

if TYPE_CHECKING:
    from freebody.numeric.engine.motion import Progress
    from freebody.numeric.engine.patrol import Guarding


_AT_BORDER, _SHORTEST = 1e-8, 1e-12  # of the step before, and of the end: the first one behind a border


class Engine(Evaluator):
    """A system with a number for every parameter, packed: its instants and its motions."""

    def run(
        self,
        y: Floats,
        until: float,
        options: SimulationOptions,
        *,
        start: float = 0.0,
        first_step: float = 0.0,
        outputs: Floats | None = None,
        progress: Progress | None = None,
        guarded: Guarding | None = None,
        keep: bool = False,
    ) -> Trajectory:
        """The motion from a state at the time `start` [s] to `until`, or to a terminal event. first_step: [s], chosen
        if it is zero. outputs: times at which the motion is wanted, besides its events and its end. guarded: what is
        known of the guards of the mode, of which the first violation is the end. keep: the steps."""
        from freebody.numeric.engine.motion import RunningMotion  # instants need none of it

        began = time.perf_counter()
        wanted = np.array([until]) if outputs is None else outputs
        motion = RunningMotion(self, y, start, until, options, first_step, wanted)
        if guarded is not None:
            motion.guard(guarded)
        if keep:
            motion.keep_steps()
        return motion.course(began, progress)

    def runs(
        self,
        y: Floats,
        until: float,
        options: SimulationOptions,
        *,
        start: float = 0.0,
        first_step: float = 0.0,
        outputs: Floats | None = None,
        borders: frozenset[str] = frozenset(),
        **given: Any,
    ) -> Iterator[Trajectory]:
        """The motion as `run` has it, in parts that end at borders: terminal events of these names, at which its law
        changes. The first step behind one is short, for what begins there may be over soon."""
        wanted = np.array([until]) if outputs is None else outputs
        step = first_step or (step_at_border(until - start, until) if borders else 0.0)
        while True:
            course = self.run(y, until, options, start=start, first_step=step, outputs=wanted, **given)
            yield course
            if not course.ends_at(borders) or course.t_end >= until:
                return
            options = replace(options, max_steps=max(options.max_steps - course.n_steps, 0))
            start, step = course.t_end, step_at_border(course.last_step, until)
            wanted = np.concatenate(([start], wanted[wanted > start]))
            self.count_from(course.near)
            y = self.state_at(course, -1)
            y[self.at_work] = course.work[-1]


def step_at_border(before: float, until: float) -> float:
    """[s] The first step behind a border, where what begins may be over soon, by the one before."""
    return max(_AT_BORDER * before, _SHORTEST * abs(until))
