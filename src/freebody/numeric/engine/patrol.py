"""What a mode needs to be positive, watched along the steps: gaps, pressing forces, slip rates, reserves of friction.

A guard is violated where it falls below zero; the first violation ends the motion there. A guard may begin at zero (a
contact that has just opened): then it is violated at the start if it falls at once. One that is below zero when the
step begins, without having crossed (the far side of an edge that ends), says nothing.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from typing import TYPE_CHECKING, Any

import numpy as np
import scipy.optimize

from freebody.numeric.engine import dynamics, stepping
from freebody.numeric.engine.layout import Floats

if TYPE_CHECKING:
    from freebody.numeric.engine.motion import Motion

_optimize: Any = scipy.optimize
PARTS = np.array([0.0, 0.25, 0.5, 0.75, 1.0])
ZERO = 1e-12  # by the size of what is guarded
N_MENDED = 3
NEAR_ZERO = 0.3  # a dip that does not come below this part of the largest value is not looked into


Lasts = Callable[[Floats, float, Floats], bool]  # of a state, the time, and the bearings from which turns are counted


@dataclass(frozen=True)
class Violation:
    """The first guard that fell below zero, when, and the state there."""

    guard: int
    time: float
    state: Floats
    at_start: bool = False  # where the step began: it fell at once


class Patrol:
    """The guards of one motion."""

    def __init__(
        self, motion: Motion, sizes: Floats, is_valid: Callable[[int], bool], lasts: Lasts | None = None
    ) -> None:
        """sizes: what counts as large of each guard. is_valid: whether a violation means something at the instant that
        the engine looked at last. lasts: whether the mode can go on in a state, where forces are not unique."""
        self.motion, self.sizes, self.is_valid, self.lasts = motion, sizes, is_valid, lasts
        n = len(motion.engine.layout.guard)
        self._values, self._rates, self._own = (np.zeros((len(PARTS), n)) for _ in range(3))
        self._one = tuple(np.zeros((1, n)) for _ in range(3))
        self._y = np.zeros(motion.engine.n_y)

    def violation(self) -> Violation | None:
        """The first violation in the last step."""
        m, run = self.motion, self.motion.run
        stepping.patrol(m.engine.layout, m.engine.room, run, PARTS, 0.0, self._y, self._values, self._rates, self._own)
        zero = ZERO * np.maximum(self.sizes, self._own.max(axis=0))
        values = self._values
        kinds = m.engine.layout.guard[:, 0]
        of_force = (kinds == dynamics.GUARD_MULTIPLIER) | (kinds == dynamics.GUARD_RESERVE)
        hard = np.ones(len(kinds), dtype=bool) if self.lasts is None else ~of_force
        begins = (values[0] >= -zero) | (kinds != dynamics.GUARD_VALUE)
        suspects = np.flatnonzero(hard & begins & (values.min(axis=0) < NEAR_ZERO * values.max(axis=0)))
        found = [(s, g) for g in suspects if (s := self._first(int(g), float(zero[g]))) is not None]
        t0, h = float(run.clock[stepping.BEFORE]), float(run.clock[stepping.DONE_STEP])
        for s, g in sorted(found):
            self._at(s)
            if not self.is_valid(int(g)):
                continue
            if s == 0.0:
                return Violation(int(g), t0, run.states[stepping.OLD].copy(), at_start=True)
            if self.lasts is not None and (soft := self._end_of_forces(of_force, zero, s)) is not None:
                return soft
            t, state = self._mended(int(g), t0, s, h)
            return Violation(int(g), t, state)
        return None if self.lasts is None else self._end_of_forces(of_force, zero, 1.0)

    def _end_of_forces(self, of_force: Any, zero: Floats, until: float) -> Violation | None:
        """Where in the last step the forces of the mode cease to be admissible, though they are not unique: one of them
        is below zero as it is computed, and no other distribution is found either. Found by bisection."""
        run = self.motion.run
        t0, h = float(run.clock[stepping.BEFORE]), float(run.clock[stepping.DONE_STEP])

        def holds(s: float) -> bool:
            values = self._at(s)
            if not (of_force & (values < -zero)).any():
                return True
            assert self.lasts is not None
            return self.lasts(self._y.copy(), t0 + s * h, self.motion.engine.near())

        good = 0.0
        for s in PARTS[1:]:
            part = min(float(s), until)
            if not holds(part):
                bad = part
                while bad - good > 1e-13 * max(1.0, good) and bad - good > 2e-16:
                    middle = 0.5 * (good + bad)
                    if not good < middle < bad:
                        break
                    good, bad = (middle, bad) if holds(middle) else (good, middle)
                values = self._at(bad)
                worst = int(np.where(of_force, values, np.inf).argmin())
                step = self.motion.step_of(bad * h)
                state = self._y.copy() if step is None else step[0]
                return Violation(worst, t0 + bad * h, state, at_start=good == 0.0 and bad < 1e-12)
            good = part
            if part >= until:
                break
        return None

    def _at(self, s: float) -> Floats:
        """Values of the guards at a part of the last step."""
        m = self.motion
        stepping.patrol(m.engine.layout, m.engine.room, m.run, np.array([s]), 0.0, self._y, *self._one)
        return self._one[0][0]

    def _value(self, g: int, s: float) -> float:
        return float(self._at(s)[g])

    def _first(self, g: int, zero: float) -> float | None:
        """Where in the last step a guard first falls below zero."""
        v, rates = self._values[:, g], self._rates[:, g]
        value = partial(self._value, g)
        below = np.flatnonzero(v < -zero)
        for j in range(1, len(PARTS)):
            low, high = float(PARTS[j - 1]), float(PARTS[j])
            is_below = len(below) > 0 and below[0] == j
            if v[j - 1] > zero and not is_below:
                if not self._may_dip(g, j):
                    continue
                least = _optimize.minimize_scalar(value, bounds=(low, high), method="bounded", options={"xatol": 1e-9})
                if least.fun < -zero:
                    return _root(value, low, float(least.x))
                continue
            if not is_below:
                continue
            if v[j - 1] > zero:
                return _root(value, low, high)
            # it begins at zero: does it rise first?
            peak = _peak(value, low, high, zero, rises=rates[j - 1] > 0.0)
            return low if peak is None else _root(value, peak, high)
        return None

    def _may_dip(self, g: int, j: int) -> bool:
        """Whether a guard may fall below zero between two points at which it is above: by its rates where it has any,
        else if it is least there."""
        v, rates = self._values[:, g], self._rates[:, g]
        if self.motion.engine.layout.guard[g, 0] == dynamics.GUARD_VALUE:
            if not (rates[j - 1] < 0.0 < rates[j]):
                return False
            h = 0.25 * float(self.motion.run.clock[stepping.DONE_STEP])
            # the tangents at both ends bound a curve that bends one way
            return min(v[j - 1] + rates[j - 1] * h, v[j] - rates[j] * h) < 0.0
        k = int(v.argmin())
        return 0 < k < len(PARTS) - 1 and j in (k, k + 1) and v[k] < NEAR_ZERO * v.max()

    def _mended(self, g: int, t0: float, s: float, h: float) -> tuple[float, Floats]:
        """Time and state of a violation, by steps of their own from the start of the last step."""
        width = min(1e-3, 0.5 * s)
        slope = (self._value(g, s) - self._value(g, s - width)) / (width * h)
        at, state = s * h, None
        m = self.motion
        for _ in range(N_MENDED):
            step = m.step_of(at)
            if step is None:
                break
            state = step[0]
            stepping.patrol(m.engine.layout, m.engine.room, m.run, np.array([-1.0]), t0 + at, state.copy(), *self._one)
            correction = float(self._one[0][0][g]) / slope if slope else 0.0
            if not abs(correction) < 1e-3 * h or abs(correction) <= 2e-16 * max(abs(t0 + at), h):
                break
            at -= correction
        if state is None:
            self._at(s)
            state = self._y.copy()
        return t0 + at, state


def _peak(value: Callable[[float], float], low: float, high: float, zero: float, *, rises: bool) -> float | None:
    """A place where the value is above zero, in a part at whose beginning it is zero; None if there is none."""
    for k in range(40 if rises else 12):
        s = low + (high - low) * 0.5 ** (k + 1)
        if value(s) > zero:
            return s
    return None


def _root(value: Callable[[float], float], low: float, high: float) -> float:
    return float(_optimize.brentq(value, low, high, xtol=1e-15, rtol=1e-14))
