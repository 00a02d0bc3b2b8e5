"""Turns of bearings counted along a motion.

A bearing is known but for whole turns; it is counted on from its last value, so from one look to the next it must
change by less than half a turn. From the ends of a step alone several turns cannot be told from a short way: where
bodies turn far in a step, bearings are followed through parts of it, by its dense output.

Looking back costs little where many steps are looked at together. That is done where nothing in the motion itself
depends on the count: steps are kept until a batch of them is full.
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
        """is_read: whether the motion depends on the count, so that it is wanted after every step."""
        self.engine, self.run = engine, run
        n_kept = 1 if is_read else BATCH
        n_terms, n_y = run.dense.shape
        self._old = np.empty((n_kept, n_y))
        self._dense = np.empty((n_kept, n_terms, n_y))
        self._clock = np.empty((n_kept, len(run.clock)))
        self._near = np.empty((n_kept, len(engine.room.measures)))  # after a step, as the steps alone count
        self._last = run.states[stepped_run.OLD], run.dense, run.clock, engine.near_view  # of the last step
        self._n = 0
        self._times: list[Floats] = []
        self._bearings: list[Floats] = []

    def begin(self) -> None:
        """Counts from where bearings are now."""
        self._counted(self.run.clock[[stepped_run.NOW]], self.engine.near()[None, :])

    def add(self) -> None:
        """Takes the last step."""
        k = self._n
        self._old[k], self._dense[k], self._clock[k], self._near[k] = self._last
        self._n = k + 1
        if self._n == len(self._old):
            self.look_back()

    def look_back(self) -> None:
        """Counts through the steps that are kept; the engine counts on from there."""
        n, self._n = self._n, 0
        if not n:
            return
        old, dense = self._old[:n], self._dense[:n]
        turned = self.engine.border.largest_turn(old, old + dense[:, 0])
        if turned.max() <= TURN:
            self._counted(self._clock[:n, stepped_run.NOW].copy(), self._near[:n].copy())
            return
        n_parts = np.maximum(1, np.ceil(turned / TURN).astype(np.intp))
        step = np.repeat(np.arange(n), n_parts)
        part = np.arange(1, len(step) + 1) - np.repeat(np.cumsum(n_parts) - n_parts, n_parts)
        s = part / n_parts[step]
        clock = self._clock[step]
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
