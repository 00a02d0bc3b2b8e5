"""The steps of a motion, kept with their dense outputs, so that it can be looked at later at any instant."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from freebody.numeric.kernels import stepped_run
from freebody.numeric.kernels.arrays import Floats
from freebody.numeric.kernels.stepped_run import SteppedRun


def between(old: Floats, dense: Floats, s: Floats) -> Floats:
    """(n, n_y) the state at the part s of each of n steps; see `stages.between`."""
    states, factors = np.zeros(old.shape), (s[:, None], 1.0 - s[:, None])
    for k in reversed(range(dense.shape[1])):
        states = (states + dense[:, k]) * factors[k % 2]
    return states + old


@dataclass(frozen=True)
class Steps:
    """Where steps begin (n_steps,), how long they are, the states there (n_steps, n_y), and the terms of their dense
    outputs (n_steps, n_terms, n_y)."""

    begins: Floats
    lengths: Floats
    old: Floats
    dense: Floats

    def states(self, times: Floats) -> Floats:
        """(n, n_y) as the dense output has them, near what is held by the tolerance."""
        k = np.clip(np.searchsorted(self.begins, times, side="right") - 1, 0, len(self.begins) - 1)
        return between(self.old[k], self.dense[k], (times - self.begins[k]) / self.lengths[k])


class KeptSteps:
    """Steps of a motion under way."""

    def __init__(self) -> None:
        self._clock: list[tuple[float, float]] = []
        self._old: list[Floats] = []
        self._dense: list[Floats] = []

    def add(self, run: SteppedRun) -> None:
        """The last step."""
        self._clock.append((float(run.clock[stepped_run.BEFORE]), float(run.clock[stepped_run.DONE_STEP])))
        self._old.append(run.states[stepped_run.OLD].copy())
        self._dense.append(run.dense.copy())

    def all(self) -> Steps | None:
        """None where no step was made."""
        if not self._clock:
            return None
        clock = np.array(self._clock)
        return Steps(clock[:, 0].copy(), clock[:, 1].copy(), np.array(self._old), np.array(self._dense))
