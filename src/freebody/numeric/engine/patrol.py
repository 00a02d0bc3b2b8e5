"""What a mode needs to be positive, watched along the steps: gaps, pressing forces, slip rates, reserves of friction.

A guard is violated where it falls below zero; the first violation ends the motion there. A guard may begin at zero (a
contact that has just opened): then it is violated at the start if it falls at once. A gap below zero (the far side of
an edge that ends) says nothing until it has been above; but one that is just below when the motion begins, because
things that touch elsewhere have been put where they do, is counted from there, as is a slip rate. One that begins at
zero and is asleep says nothing either: the far side of a rod on which something lies, an edge whose end has just been
passed.

A step is looked at in parts, so short that nothing with corners turns by more than `TURN` in one. In a part the values
and rates of a gap at both ends make a cubic; where that comes near zero, the gap itself is searched.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator, Sequence
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
QUARTERS = np.array([0.0, 0.25, 0.5, 0.75, 1.0])
TURN = 0.1  # [rad]
MOST_PARTS = 4000
ZERO = 1e-12  # by the size of what is guarded
N_MENDED = 3
LOOSE = 0.05  # by the size of the system: a foot that is so far beside its edge will not be on it
SLACK = 1e-9  # by the size of a gap or a slip rate: so far below zero it may begin
NEAR_ZERO = 0.3  # a dip that does not come below this part of the largest value is not looked into
MARGIN = 0.02  # of the cubic, by what a gap changes in a part
PLACES = np.arange(1, 8) / 8.0
HERMITE = np.array(  # value, rate, value, rate at the ends: at the places between
    [[(1 + 2 * u) * (1 - u) ** 2, u * (1 - u) ** 2, u * u * (3 - 2 * u), u * u * (u - 1)] for u in PLACES.tolist()]
)

Lasts = Callable[[Floats, float, Floats], bool]  # of a state, the time, and the bearings from which turns are counted


@dataclass(frozen=True)
class Guarding:
    """What is known of the guards of a mode. sizes: what counts as large of each. is_valid: whether a violation means
    something at the instant that the engine looked at last, up to a part of the system's size. asleep: guards that
    count only once they have been above zero. distances: of gaps that are a distance without a constant, that constant;
    else NaN. turning: bodies whose turning moves a gap. lasts: whether the mode can go on in a state, where forces are
    not unique."""

    sizes: Floats
    is_valid: Callable[[int, float], bool]
    asleep: Collection[int]
    distances: Floats
    turning: Sequence[int]
    lasts: Lasts | None = None


@dataclass(frozen=True)
class Violation:
    """The first guard that fell below zero, when, and the state there."""

    guard: int
    time: float
    state: Floats
    at_start: bool = False  # where the step began: it fell at once


class Patrol:
    """The guards of one motion."""

    def __init__(self, motion: Motion, guarding: Guarding) -> None:
        self.motion, self.guarding = motion, guarding
        self.sizes, self.is_valid, self.lasts = guarding.sizes, guarding.is_valid, guarding.lasts
        n = len(motion.engine.layout.guard)
        self._kinds = motion.engine.layout.guard[:, 0]
        self._is_gap = self._kinds == dynamics.GUARD_VALUE
        self._asleep = np.zeros(n, dtype=bool)
        self._asleep[list(guarding.asleep)] = True
        self._floor: Floats | None = None
        self._signs = motion.engine.layout.guard_factor[:, 0]
        self._parts = QUARTERS
        self._values, self._rates, self._own = self._room(len(QUARTERS))
        self._one = self._room(1)
        self._y = np.zeros(motion.engine.n_y)

    def _room(self, n_parts: int) -> tuple[Floats, Floats, Floats]:
        a, b, c = (np.zeros((n_parts, len(self._kinds))) for _ in range(3))
        return a, b, c

    def _divided(self) -> None:
        """Divides the last step into parts."""
        states = self.motion.run.states
        border = self.motion.engine.border
        largest = border.largest_turn(states[stepping.OLD], states[stepping.Y], self.guarding.turning)
        n_parts = max(4, min(MOST_PARTS, int(largest / TURN) + 1))
        if n_parts + 1 != len(self._parts):
            self._parts = np.linspace(0.0, 1.0, n_parts + 1)
            self._values, self._rates, self._own = self._room(n_parts + 1)

    def violation(self) -> Violation | None:
        """The first violation in the last step."""
        m, run = self.motion, self.motion.run
        self._divided()
        values = self._values
        stepping.patrol(m.engine.layout, m.engine.room, run, self._parts, 0.0, self._y, values, self._rates, self._own)
        zero = ZERO * np.maximum(self.sizes, self._own.max(axis=0))
        if self._floor is None:
            is_counted = (self._is_gap & ~self._asleep) | (self._kinds == dynamics.GUARD_RATE)
            is_low = is_counted & (values[0] < 0.0) & (values[0] >= -SLACK * self.sizes)
            self._floor = np.where(is_low, values[0], 0.0)
        self._floor[values[0] > 0.0] = 0.0
        values -= self._floor
        self._asleep &= values[0] <= zero
        of_force = (self._kinds == dynamics.GUARD_MULTIPLIER) | (self._kinds == dynamics.GUARD_RESERVE)
        self._search_gaps(zero)
        self._soft = np.zeros(len(of_force), dtype=bool) if self.lasts is None else of_force
        t0, h = float(run.clock[stepping.BEFORE]), float(run.clock[stepping.DONE_STEP])
        for j in range(1, len(self._parts)):
            for s, g in sorted(self._found_in(j, zero)):
                self._at(s)
                if not self.is_valid(g, 0.0):
                    continue
                if s == 0.0:
                    return Violation(g, t0, run.states[stepping.OLD].copy(), at_start=True)
                if self.lasts is not None and (soft := self._end_of_forces(of_force, zero, s)) is not None:
                    return soft
                t, state = self._mended(g, t0, s, h)
                return Violation(g, t, state)
        return None if self.lasts is None else self._end_of_forces(of_force, zero, 1.0)

    def _search_gaps(self, zero: Floats) -> None:
        """In which parts a gap that is above zero at both ends may fall below, or one below may rise above, and where
        in a part it may be least. A distance has a kink where two points pass near each other; its square is smooth:
        +-(d^2 - R^2) for +-(d - R)."""
        v, h = self._values, float(self.motion.run.clock[stepping.DONE_STEP])
        rates = self._rates * (h * float(self._parts[1]))
        k = np.flatnonzero(~np.isnan(self.guarding.distances))
        if len(k):
            d = v[:, k] + self._signs[k] * self.guarding.distances[k]  # +-d
            v, rates = v.copy(), rates.copy()
            v[:, k] *= np.abs(d) + self.guarding.distances[k]
            rates[:, k] *= 2.0 * np.abs(d)
        between = np.tensordot(HERMITE, np.stack([v[:-1], rates[:-1], v[1:], rates[1:]]), axes=1)
        margin = MARGIN * (np.abs(v[1:] - v[:-1]) + np.abs(rates[1:]) + np.abs(rates[:-1]))
        self._least = PLACES[between.argmin(axis=0)]
        self._dips = self._is_gap & (np.minimum(v[:-1], v[1:]) > zero) & (between.min(axis=0) < margin)
        self._bumps = self._is_gap & (np.maximum(v[:-1], v[1:]) < -zero) & (between.max(axis=0) > -margin)

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
        for s in QUARTERS[1:]:
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
        if self._floor is not None:
            self._one[0][0] -= self._floor
        return self._one[0][0]

    def _value(self, g: int, s: float) -> float:
        return float(self._at(s)[g])

    def _signed(self, g: int, sign: float, s: float) -> float:
        return sign * self._value(g, float(s))

    def _rate(self, g: int, s: float) -> float:
        self._at(s)
        return float(self._one[1][0, g])

    def _found_in(self, j: int, zero: Floats) -> Iterator[tuple[float, int]]:
        """Places in a part at which a guard falls below zero."""
        a, b = self._values[j - 1], self._values[j]
        is_asleep = self._asleep if j == 1 else np.zeros_like(self._asleep)
        is_silent = self._is_gap & ((a < -zero) | ((a <= zero) & is_asleep))
        falls = ~is_silent & (b < -zero)
        least = ~self._is_gap & (a > zero) & (b >= -zero) & (np.minimum(a, b) < NEAR_ZERO * self._values.max(axis=0))
        below = ~self._is_gap & (a < -zero)
        suspects = ~self._soft & (falls | self._dips[j - 1] | self._bumps[j - 1] | least | below)
        for g in np.flatnonzero(suspects).tolist():
            s = self._first(g, j, float(zero[g]))
            if s is not None:
                yield s, g

    def _first(self, g: int, j: int, zero: float) -> float | None:
        """Where in a part a guard first falls below zero."""
        v = self._values[:, g]
        low, high, a, b = float(self._parts[j - 1]), float(self._parts[j]), float(v[j - 1]), float(v[j])
        value = partial(self._value, g)
        if not self._is_gap[g]:
            if a < -zero:
                return low
            if a > zero and b < -zero:
                return _root(value, low, high)
            if b < -zero:
                peak = _peak(value, low, high, zero, rises=False)
                return low if peak is None else _root(value, peak, high)
            if not self._may_dip(v, j):
                return None
            least = _optimize.minimize_scalar(value, bounds=(low, high), method="bounded", options={"xatol": 1e-9})
            return _root(value, low, float(least.x)) if least.fun < -zero else None
        if self._bumps[j - 1, g]:
            top = self._turn(g, j, high=True)
            return self._crossed(g, top, high) if self._value(g, top) > zero else None
        if self._dips[j - 1, g]:
            bottom = self._turn(g, j, high=False)
            return self._crossed(g, low, bottom) if self._value(g, bottom) < -zero else None
        if a > zero:
            return self._crossed(g, low, high, a, b)
        self._at(low)
        if not self.is_valid(g, LOOSE):
            return None
        # it begins at zero: does it rise first?
        part = (high - low) * float(self.motion.run.clock[stepping.DONE_STEP])
        rise = float(self._rates[j - 1, g]) * part
        peak = None if rise < -zero else _peak(value, low, high, zero, rises=rise > 0.0)
        return low if peak is None else self._crossed(g, peak, high)

    def _turn(self, g: int, j: int, *, high: bool) -> float:
        """The place in a part at which a gap is least, or greatest: where its rate changes sign."""
        low, end = float(self._parts[j - 1]), float(self._parts[j])
        before, after = float(self._rates[j - 1, g]), float(self._rates[j, g])
        sign = -1.0 if high else 1.0
        if not high:
            middle = low + (end - low) * float(self._least[j - 1, g])
            self._at(middle)
            if not self.is_valid(g, LOOSE):
                return low
        if sign * before < 0.0 < sign * after:
            return float(_optimize.brentq(partial(self._rate, g), low, end, xtol=1e-12, rtol=1e-9))
        found = _optimize.minimize_scalar(
            partial(self._signed, g, sign), bounds=(low, end), method="bounded", options={"xatol": 1e-9}
        )
        return float(found.x)

    def _crossed(self, g: int, low: float, high: float, a: float | None = None, b: float | None = None) -> float | None:
        """Where a gap falls through zero between two places (with the values there), by Newton's method within them;
        None if it is clear before that it means nothing there."""
        h = float(self.motion.run.clock[stepping.DONE_STEP])
        a = self._value(g, low) if a is None else a
        b = self._value(g, high) if b is None else b
        s = low + (high - low) * a / (a - b)
        start, end = low, high
        for k in range(30):
            values = self._at(s)
            if k == 1 and not self.is_valid(g, LOOSE):
                return None
            x, slope = float(values[g]), float(self._one[1][0, g]) * h
            start, end = (s, end) if x > 0.0 else (start, s)
            after = s - x / slope if slope else end
            if not start <= after <= end:
                after = 0.5 * (start + end)
            if abs(after - s) <= 1e-15 or x == 0.0:
                return s
            s = after
        return s

    def _may_dip(self, v: Floats, j: int) -> bool:
        """Whether a force may fall below zero between two points at which it is above: if it is least there."""
        k = int(v.argmin())
        return 0 < k < len(v) - 1 and j in (k, k + 1) and bool(v[k] < NEAR_ZERO * v.max())

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
            assert self._floor is not None
            correction = float(self._one[0][0][g] - self._floor[g]) / slope if slope else 0.0
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
