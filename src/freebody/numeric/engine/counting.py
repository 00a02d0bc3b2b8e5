"""Turns of bearings counted along a motion.

A bearing is known but for whole turns; it is counted on from its last value, so from one look to the next it must
change by less than half a turn. From the ends of a step alone several turns cannot be told from a short way: where
bodies turn far in a step, bearings are followed through parts of it, by its dense output.

Looking back costs little where many steps are looked at together. That is done where nothing in the motion itself
depends on the count: steps are kept until a batch of them is full, by the kernels themselves, so that what is short
does not come back to Python, for which other threads wait, after every step.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from freebody.numeric.engine.course import Tracks
from freebody.numeric.engine.steps import between
from freebody.numeric.kernels import stepped_run
from freebody.numeric.kernels.arrays import Floats
from freebody.numeric.kernels.following import follow

if TYPE_CHECKING:
    from freebody.numeric.engine.evaluator import Evaluator
    from freebody.numeric.kernels.stepped_run import SteppedRun

TURN = 0.5  # [rad] of a body, in which bearings are counted on
BATCH = 128  # steps


class Counting:
    """The turns of the bearings of an engine along one run."""

    def __init__(self, engine: Evaluator, run: SteppedRun, *, is_read: bool) -> None:
        """Counts from where bearings are now. run: of which one with room for steps is made. is_read: whether the
        motion depends on the count, so that it is wanted after every step."""
        n_kept = 1 if is_read else BATCH
        n_terms, n_y = run.dense.shape
        self.engine = engine
        self.run = run._replace(
            kept_old=np.empty((n_kept, n_y)),
            kept_dense=np.empty((n_kept * n_terms, n_y)),
            kept_clock=np.empty((n_kept, len(run.clock))),
            kept_near=np.empty((n_kept, len(engine.room.measures))),  # after a step, as the steps alone count
        )
        self._times: list[Floats] = []
        self._bearings: list[Floats] = []
        self._counted(run.clock[[stepped_run.NOW]], engine.near()[None, :])

    def keep(self) -> None:
        """Takes the last step of a method that is not one of kernels; see `stepping.keep`."""
        run, n_terms = self.run, len(self.run.dense)
        k = int(run.count[stepped_run.KEPT])
        run.kept_old[k], run.kept_clock[k] = run.states[stepped_run.OLD], run.clock
        run.kept_dense[k * n_terms : (k + 1) * n_terms] = run.dense
        run.kept_near[k] = self.engine.near_view
        run.count[stepped_run.KEPT] = k + 1

    def look(self) -> None:
        """Looks back where no room is left for another step."""
        if self.run.count[stepped_run.KEPT] == len(self.run.kept_clock):
            self.look_back()

    def look_back(self) -> None:
        """Counts through the steps that are kept; the engine counts on from there."""
        run, n = self.run, int(self.run.count[stepped_run.KEPT])
        run.count[stepped_run.KEPT] = 0
        if not n:
            return
        old, clock, near = run.kept_old[:n], run.kept_clock[:n], run.kept_near[:n]
        dense = run.kept_dense.reshape(len(run.kept_clock), *run.dense.shape)[:n]
        turned = self.engine.border.largest_turn(old, old + dense[:, 0])
        if turned.max() <= TURN:
            self._counted(clock[:, stepped_run.NOW].copy(), near.copy())
            return
        n_parts = np.maximum(1, np.ceil(turned / TURN).astype(np.intp))
        step = np.repeat(np.arange(n), n_parts)
        part = np.arange(1, len(step) + 1) - np.repeat(np.cumsum(n_parts) - n_parts, n_parts)
        s = part / n_parts[step]
        clock = clock[step]
        times = clock[:, stepped_run.BEFORE] + s * clock[:, stepped_run.DONE_STEP]
        is_end = part == n_parts[step]
        times[is_end] = clock[is_end, stepped_run.NOW]
        states = between(old[step], dense[step], s)
        self._counted(times, bearings_at(self.engine, self._bearings[-1][-1], times, states))

    def _counted(self, times: Floats, bearings: Floats) -> None:
        self._times.append(times)
        self._bearings.append(bearings)

    def tracks(self) -> Tracks:
        """What has been counted."""
        self.look_back()
        return Tracks(self.engine.turning, np.concatenate(self._times), np.concatenate(self._bearings))


def bearings_at(engine: Evaluator, near: Floats, times: Floats, states: Floats) -> Floats:
    """(n_times, n_measures) bearings at states that follow each other closely, the first counted on from `near`."""
    bearings = np.empty((len(times), len(near)))
    engine.count_from(near)
    follow(engine.layout, engine.room, times, states, bearings)
    return bearings
