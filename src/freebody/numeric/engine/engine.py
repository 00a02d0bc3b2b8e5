"""The engine from Python: the motions of a packed system."""

from __future__ import annotations

import time
from typing import TYPE_CHECKING

import numpy as np

from freebody.numeric.engine.course import Trajectory
from freebody.numeric.engine.evaluator import Evaluator
from freebody.numeric.kernels.arrays import Floats
from freebody.numeric.options import SimulationOptions

if TYPE_CHECKING:
    from freebody.numeric.engine.motion import Progress
    from freebody.numeric.engine.patrol import Guarding


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
