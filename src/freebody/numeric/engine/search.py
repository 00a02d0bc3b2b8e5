"""The search for zeros of what is watched or guarded along a motion: one `ProgramSearch` for each, step after step.

What is looked at is the dense output of every step as it is; `zeros` says what is found for certain. The dense
output itself is off the motion by what the steps before are off, of which the tolerance is an estimate: what comes
nearer to zero than that (the resolution), without crossing it or by crossing it twice, is a touch, and whether it
crosses or misses no number can say.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from freebody.numeric.engine.operations import Program
from freebody.numeric.kernels import enclosures, stepped_run, zeros
from freebody.numeric.kernels.arrays import Floats
from freebody.tolerances import RESOLUTION, WATCHED_ZERO

if TYPE_CHECKING:
    from freebody.numeric.kernels.stepped_run import SteppedRun

A_STEP = 0.1  # of the tolerance, that a step may be off
MOST_PARTS = 2_000_000  # of one step that are looked at
N_FOUND = 1024  # events for which there is room in one call
KINDS = {zeros.RISING: "rising", zeros.FALLING: "falling", zeros.TOUCH: "touch"}


@dataclass(frozen=True)
class StepZero:
    """Where in a step something is zero: the part of the step, and "rising", "falling" or "touch"."""

    part: float
    kind: str


class ProgramSearch:
    """One program along one motion."""

    def __init__(
        self,
        program: Program,
        target: float,
        size: float,
        tolerance: float,
        near: Floats,
        powers: Floats | None = None,
    ) -> None:
        """target: what the program is searched for. size: what counts as large. near: the bearings, by measure, from
        which turns are counted. powers: of the entries of the state, if others find them."""
        self.program, self.zero = program, WATCHED_ZERO * size
        self._size, self._tolerance = size, tolerance
        self._sizes = np.array([-target, self.zero, RESOLUTION * size, MOST_PARTS])
        n = len(program.code)
        self._powers = np.zeros((0, enclosures.N_TERMS)) if powers is None else powers
        self._is_shared = powers is not None
        self._terms = np.zeros(enclosures.N_TERMS)
        base = [float(near[place]) if place >= 0 else 0.0 for place in program.turns]
        self._turns = np.array([(math.cos(a), math.sin(a), a) for a in base]).reshape(-1, 3)
        self._centres, self._radii = np.zeros((n, 3)), np.zeros((n, 3))
        self._state = np.array([0.0, 0.0, 0.0, -math.inf, 0.0])
        self._found = np.zeros((N_FOUND, 2))
        self._stack = np.zeros((64, 2))
        self._info = np.zeros(6)
        self.unsearched: float | None = None  # from which part of the step on nothing was looked at

    def _resolution(self, n_steps: int) -> float:
        """How near to zero a motion of so many steps tells what happens."""
        return self._size * max(RESOLUTION, self._tolerance * (1.0 + A_STEP * n_steps))

    @property
    def ends(self) -> tuple[float, float]:
        """The values where the last step began and ended; beyond the resolution the latter may be another."""
        return float(self._info[3]), float(self._info[4])

    def begin(self, value: float) -> None:
        """The value where the motion begins."""
        self._state[zeros.SIDE] = 0.0 if abs(value) <= self.zero else math.copysign(1.0, value)

    def forget(self) -> None:
        """It is zero now: nothing counts before it has been different."""
        self._state[zeros.SIDE] = self._state[zeros.IS_NEAR] = 0.0

    @property
    def side(self) -> float:
        """The sign met last; 0 if it has been zero since the beginning."""
        return float(self._state[zeros.SIDE])

    @property
    def is_idle(self) -> bool:
        """Whether nothing is left to be decided from the step before."""
        return self._state[zeros.IS_NEAR] == 0.0

    @property
    def offset(self) -> float:
        """What is added to the program."""
        return float(self._sizes[0])

    def count_from(self, offset: float) -> None:
        """Something else is added to the program."""
        self._sizes[0] = offset

    def look(self, run: SteppedRun) -> None:
        """Takes the last step of a run."""
        if not self._is_shared:
            if not len(self._powers):
                self._powers = np.zeros((run.dense.shape[1], enclosures.N_TERMS))
            enclosures.powers(run.dense, run.states[stepped_run.OLD], self.program.inputs, self._powers)

    def calibrate(self, run: SteppedRun, value: float) -> None:
        """Counts from the value where the last step begins, if the program does not say the same: of some measures only
        changes mean something."""
        self.look(run)
        self._sizes[3] = 0.0
        self._call(run, 0.0)
        off = value - self.ends[0]
        self._sizes[0] += off if abs(off) > 1e3 * self.zero else 0.0
        self._sizes[3] = MOST_PARTS

    def in_step(self, run: SteppedRun) -> Iterator[StepZero]:
        """The zeros in the last step."""
        self.look(run)
        self._sizes[2] = self._resolution(int(run.count[stepped_run.STEPS]))
        self.unsearched = None
        at = 0.0
        while True:
            ended = self._call(run, at)
            for part, kind in self._found[: int(self._info[0])]:
                yield StepZero(float(part), KINDS[float(kind)])
            if ended != zeros.FULL:
                break
            at = float(self._info[1])
        if ended == zeros.EXHAUSTED:
            self.unsearched = float(self._info[1])
            self.forget()

    def at_end(self) -> StepZero | None:
        """What the end of the motion is, if it comes to zero just there."""
        side, value = float(self._state[zeros.SIDE]), self.ends[1]
        if side == 0.0 or not self._state[zeros.IS_NEAR] or abs(value) > self.zero:
            return None
        is_steep = abs(float(self._info[5])) > math.sqrt(self.zero * RESOLUTION * self._size)
        return StepZero(1.0, "touch" if not is_steep else "falling" if side > 0.0 else "rising")

    def _call(self, run: SteppedRun, at: float) -> int:
        t0, h = float(run.clock[stepped_run.BEFORE]), float(run.clock[stepped_run.DONE_STEP])
        self._info[1] = at
        return int(
            zeros.search(
                self.program.code,
                self.program.constants,
                self._powers,
                t0,
                h,
                self._sizes,
                self._terms,
                self._turns,
                self._centres,
                self._radii,
                self._state,
                self._found,
                self._stack,
                self._info,
            )
        )
