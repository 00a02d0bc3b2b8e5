"""Guards: quantities that a contact mode needs to be positive, monitored along the steps. They are the gaps of open
contacts, the forces of closed ones, slip rates, and friction reserves (limit less force).

A guard is violated where it falls below zero; the first violation ends the phase there. How a guard begins:

- at zero (a contact that has just opened): it is violated at the start if it falls at once;
- below zero (a gap on the far side of an edge that ends): it counts only once it has been above zero. Slightly below,
  by the round-off with which bodies were placed in contact elsewhere, a gap counts from there, as a slip rate does;
- at zero and asleep (the far side of a rod on which something lies, an edge whose end has just been passed): it counts
  only once it has been above zero.

Gaps and slip rates are searched for zeros as events are (`search`): no crossing is missed however long the step, unless
it stays within the resolution. For most gaps, which are far from zero, one enclosure over the step excludes a crossing.

Forces and reserves are no polynomials in a step. They are sampled at the ends of at least `N_PARTS` parts of it, short
enough that no body with corners turns by more than `TURN` in one, and minimised between samples where one is lower than
both neighbours. A dip below zero between two samples that shows in none of them is missed.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Collection, Sequence
from dataclasses import dataclass
from functools import partial
from itertools import zip_longest
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from freebody.numeric.brent import least_between, zero_between
from freebody.numeric.engine.search import ProgramSearch
from freebody.numeric.kernels import enclosures, stepped_run, stepping
from freebody.numeric.kernels.arrays import Floats
from freebody.numeric.kernels.guarding import GUARD_RATE, GUARD_VALUE
from freebody.numeric.kernels.kinematics import RATE
from freebody.tolerances import RESOLUTION, WATCHED_ZERO

if TYPE_CHECKING:
    from freebody.numeric.engine.underway import MotionUnderWay

N_PARTS = 4
QUARTERS = np.linspace(0.0, 1.0, N_PARTS + 1)
TURN = 0.1  # [rad]
MOST_PARTS = 4000
N_MENDED = 3
SLACK = 1e-9  # by the size of a gap or a slip rate: so far below zero it may begin

Lasts = Callable[[Floats, float, Floats], bool]  # of a state, the time, and the bearings from which turns are counted


@dataclass(frozen=True)
class Guarding:
    """What is known of the guards of a mode. sizes: what counts as large of each. is_valid: whether a violation means
    something at the instant that the engine looked at last, up to a part of the system's size. asleep: guards that
    count only once they have been above zero. turning: bodies whose turning moves a gap. lasts: whether the mode can go
    on in a state, where forces are not unique."""

    sizes: Floats
    is_valid: Callable[[int, float], bool]
    asleep: Collection[int]
    turning: Sequence[int]
    lasts: Lasts | None = None


@dataclass(frozen=True)
class Violation:
    """The first guard that fell below zero, when, and the state there."""

    guard: int
    time: float
    state: Floats
    at_start: bool = False  # where the step began: it fell at once


class Gaps:
    """Gaps and slip rates along one motion."""

    def __init__(self, motion: MotionUnderWay, sizes: Floats) -> None:
        self.programs = motion.engine.guard_programs
        self.guards = self.programs.guards
        n, longest = len(self.guards), self.programs.longest
        self._powers = np.zeros((motion.engine.n_y, enclosures.N_TERMS))
        self._terms = np.zeros(enclosures.N_TERMS)
        self._turns = np.zeros((int(self.programs.n_turns.max(initial=0)) + 1, 3))
        self._centres, self._radii = np.zeros((longest, 3)), np.zeros((longest, 3))
        self._searches: dict[int, ProgramSearch] = {}
        self._turning = self.programs.n_turns > 0
        self.signs = np.zeros(n)
        self._resolutions = RESOLUTION * sizes[self.guards]
        self._sizes, self._near = sizes, motion.engine.near()
        self._offsets: Floats | None = None

    def look(self, run: stepped_run.SteppedRun, values: Floats, floor: Floats) -> Floats:
        """The signs that the guards with programs have throughout the last step; 0 where that is not clear. values: of
        the guards where it begins; floor: from where each counts."""
        dense, old = run.dense, run.states[stepped_run.OLD]
        enclosures.powers(dense, old, self.programs.inputs, self._powers)
        t0, h = float(run.clock[stepped_run.BEFORE]), float(run.clock[stepped_run.DONE_STEP])
        if self._offsets is None:  # rows count from somewhere: what a program is off by at the beginning is that
            self._sift(t0, 0.0, np.zeros(len(self.signs)))
            self._offsets = np.where(self._turning, 0.0, values[self.guards] - self.signs)
            for k in np.flatnonzero(self._turning).tolist():
                search = self.search(k)
                search.calibrate(run, float(values[self.guards[k]]))
                self._offsets[k] = search.offset
        self.counted = self._offsets - floor[self.guards]
        self._sift(t0, h, self.counted)
        self.signs[self._turning] = 0.0
        for k, search in self._searches.items():
            if not search.is_idle:
                self.signs[k] = 0.0
        return self.signs

    def _sift(self, t0: float, h: float, offsets: Floats) -> None:
        enclosures.sifted(
            self.programs.code,
            self.programs.constants,
            self.programs.ptr,
            self._powers,
            t0,
            h,
            offsets,
            self._resolutions,
            self._terms,
            self._turns,
            self._centres,
            self._radii,
            self.signs,
        )

    def search(self, k: int) -> ProgramSearch:
        """That of one guard."""
        if k not in self._searches:
            size = float(self._sizes[self.guards[k]])
            self._searches[k] = ProgramSearch(self.programs.each[k], 0.0, size, 0.0, self._near, self._powers)
        return self._searches[k]


class GuardMonitor:
    """The guards of one motion."""

    def __init__(self, motion: MotionUnderWay, guarding: Guarding) -> None:
        self.motion, self.guarding = motion, guarding
        self.sizes, self.is_valid, self.lasts = guarding.sizes, guarding.is_valid, guarding.lasts
        n = len(motion.engine.layout.guard)
        self._kinds = motion.engine.layout.guard[:, 0]
        self._is_gap = self._kinds == GUARD_VALUE
        self._is_force = ~self._is_gap & (self._kinds != GUARD_RATE)
        self._is_counted = self._is_gap | (self._kinds == GUARD_RATE)
        self._is_counted[list(guarding.asleep)] = False
        self._turns = (self._kinds == GUARD_RATE) & (motion.engine.layout.guard[:, 2] >= 0)  # slip in a plane
        self._started = np.zeros(n, dtype=bool)  # whether that has been fast enough to have a direction
        self._gaps: Gaps | None = None
        self._side = np.zeros(n)  # of gaps and rates: the sign met last
        self._floor: Floats | None = None
        self._parts = QUARTERS
        self._values, self._rates, self._own = self._room(len(QUARTERS))
        self._one = self._room(1)
        self._y = np.zeros(motion.engine.n_y)

    def _room(self, n_parts: int) -> tuple[Floats, Floats, Floats]:
        a, b, c = (np.zeros((n_parts, len(self._kinds))) for _ in range(3))
        return a, b, c

    def _divided(self) -> None:
        """Divides the last step into parts, for the forces; gaps and rates need its beginning only."""
        states = self.motion.run.states
        n_parts = 0
        if self._is_force.any():
            largest = float(
                self.motion.engine.border.largest_turn(
                    states[stepped_run.OLD], states[stepped_run.Y], self.guarding.turning
                )
            )
            n_parts = max(N_PARTS, min(MOST_PARTS, int(largest / TURN) + 1))
        if n_parts + 1 != len(self._parts):
            self._parts = np.linspace(0.0, 1.0, n_parts + 1) if n_parts else np.zeros(1)
            self._values, self._rates, self._own = self._room(n_parts + 1)

    def violation(self) -> Violation | None:
        """The first violation in the last step."""
        m, run = self.motion, self.motion.run
        self._divided()
        values = self._values
        stepping.patrol(m.engine.layout, m.engine.room, run, self._parts, 0.0, self._y, values, self._rates, self._own)
        zero = WATCHED_ZERO * np.maximum(self.sizes, self._own.max(axis=0))
        if self._gaps is None:
            self._gaps = Gaps(m, self.sizes)
        begin = values[0].copy()
        if self._floor is None:
            is_low = self._is_counted & (begin < 0.0) & (begin >= -SLACK * self.sizes)
            self._floor = np.where(is_low, begin, 0.0)
        self._floor[begin > 0.0] = 0.0
        values -= self._floor
        found = self._of_gaps(begin, zero)
        of_forces = self._of_forces(zero, 1.0 if found is None else found[0])
        if of_forces is not None and (found is None or of_forces[0] <= found[0]):
            found = of_forces
        if self.lasts is not None:
            soft = self._end_of_forces(self._is_force, zero, 1.0 if found is None else found[0])
            if soft is not None:
                return soft
        if found is None and (slow := self._slow()) is not None:
            found = 1.0, slow
        if found is None:
            return None
        s, g = found
        t0, h = float(run.clock[stepped_run.BEFORE]), float(run.clock[stepped_run.DONE_STEP])
        if s == 0.0:
            return Violation(g, t0, run.states[stepped_run.OLD].copy(), at_start=True)
        if self._turns[g]:  # a step that ends where the slip does has no direction there
            self._at(s)
            return Violation(g, t0 + s * h, self._y.copy())
        t, state = self._mended(g, t0, s, h)
        return Violation(g, t, state)

    def _slow(self) -> int | None:
        """The guard of a slip in a plane that is slower at the end of the step than what tells its direction. It comes
        to rest in ever shorter steps where its direction turns meanwhile. Or that of a slip that began from rest and
        has set out the other way."""
        if not self._turns.any():
            return None
        values = self._at(1.0)
        for g in np.flatnonzero(self._turns).tolist():
            speed, small = self._slip(g)
            if speed <= small and self._started[g]:
                return g
            if speed > small and not self._started[g] and values[g] < 0.0:
                return g
            self._started[g] = self._started[g] or speed > small
        return None

    def _slip(self, g: int) -> tuple[float, float]:
        """The speed of a slip in a plane at the instant looked at last, and that below which it has no direction of its
        own."""
        layout, rows = self.motion.engine.layout, self.motion.engine.room.rows
        one, other = layout.guard[g, 1:3].tolist()
        small = float(layout.slide_factor[layout.slide[:, 0].tolist().index(one), 3])
        return math.hypot(rows[one, RATE], rows[other, RATE]), small

    # -- gaps and slip rates ------------------------------------------------------------------
    def _of_gaps(self, begin: Floats, zero: Floats) -> tuple[float, int] | None:
        """The first place at which a gap or a slip rate falls below zero, and which."""
        run, gaps, floor = self.motion.run, self._gaps, self._floor
        assert gaps is not None
        assert floor is not None
        if not len(gaps.guards):
            return None
        signs = gaps.look(run, begin, floor)
        clear = gaps.guards[signs != 0.0]
        best: tuple[float, int] | None = None
        was = self._side[gaps.guards]
        for k in np.flatnonzero((signs == 0.0) | (was * signs < 0.0)).tolist():
            g = int(gaps.guards[k])
            s = self._fall(k, g, float(begin[g] - floor[g]), float(zero[g]))
            if s is not None and (best is None or (s, g) < best):
                best = s, g
        self._side[clear] = signs[signs != 0.0]
        return best

    def _fall(self, k: int, g: int, value: float, zero: float) -> float | None:
        """Where in the last step a guard first falls below zero, while that means something."""
        gaps = self._gaps
        assert gaps is not None
        search, side = gaps.search(k), float(self._side[g])
        if side == 0.0:  # it begins
            is_above = value > zero or (value >= -zero and self._is_counted[g])
            side = 1.0 if is_above or not self._is_gap[g] else -1.0
        if search.is_idle:
            search.begin(side)
        search.count_from(float(gaps.counted[k]))
        found = [zero_of for zero_of in search.in_step(self.motion.run) if zero_of.kind != "touch"]
        if search.unsearched is not None:
            self.motion.say_unsearched("a contact or a slip", search.unsearched)
        self._side[g] = search.side
        for place, after in zip_longest(found, found[1:]):
            if place.kind != "falling":
                continue
            end = 1.0 if after is None else 0.5 * (place.part + after.part)
            if not (self._value(g, end) < -zero or self._value(g, 0.5 * (place.part + end)) < -zero):
                self._side[g] = 1.0  # the dense output passes zero by what it is off
                continue
            self._at(place.part)
            if self._turns[g] and not self._started[g] and self._is_below_its_noise(g, end):
                continue
            self._at(place.part)
            if self.is_valid(g, 0.0):
                return place.part
            self._side[g] = search.side
        return None

    def _is_below_its_noise(self, g: int, part: float) -> bool:
        """Whether a slip in a plane that has only begun is so slow at a part of the step that rounding turns it."""
        self._at(part)
        speed, small = self._slip(g)
        return speed <= small

    # -- forces -------------------------------------------------------------------------------
    def _of_forces(self, zero: Floats, until: float) -> tuple[float, int] | None:
        """The first place before another at which a force or a reserve is seen to fall below zero."""
        if self.lasts is not None or len(self._parts) < 2:
            return None
        best: tuple[float, int] | None = None
        v = self._values
        is_least = np.zeros(v.shape, dtype=bool)
        left, right = v[:-2] - v[1:-1], v[2:] - v[1:-1]
        both = left + right
        is_least[1:-1] = (left >= 0.0) & (right >= 0.0) & (both > 0.0)
        # a parabola through three points tells how far below the middle one its least value is
        drop = np.divide((left - right) ** 2, 8.0 * both, out=np.zeros_like(both), where=is_least[1:-1])
        reach = 3.0 * drop + 0.02 * (v.max(axis=0) - v.min(axis=0))
        is_least[1:-1] &= (v[1:-1] > zero) & (v[1:-1] < reach + zero)
        suspects = self._is_force & ((v < -zero).any(axis=0) | is_least.any(axis=0))
        for g in np.flatnonzero(suspects).tolist():
            s = self._first_of_force(g, float(zero[g]), is_least[:, g])
            if s is not None and s <= until and (best is None or (s, g) < best):
                self._at(s)
                if self.is_valid(g, 0.0):
                    best = s, g
        return best

    def _first_of_force(self, g: int, zero: float, is_least: NDArray[np.bool_]) -> float | None:
        """Where a force first falls below zero."""
        v, parts = self._values[:, g], self._parts
        value = partial(self._value, g)
        for j in range(len(parts)):
            if is_least[j]:
                around = float(parts[j - 1]), float(parts[j + 1])
                lowest, least = least_between(value, *around, xtol=1e-9)
                if least < -zero:
                    return _root(value, around[0] if around[0] < lowest else 0.0, lowest)
            if j == len(parts) - 1:
                break
            low, high, a, b = float(parts[j]), float(parts[j + 1]), float(v[j]), float(v[j + 1])
            if a < -zero:
                return low
            if b < -zero and a > zero:
                return _root(value, low, high)
            if b < -zero:
                peak = _peak(value, low, high, zero)
                return low if peak is None else _root(value, peak, high)
        return None

    def _end_of_forces(self, of_force: Any, zero: Floats, until: float) -> Violation | None:
        """Where in the last step the forces of the mode cease to be admissible, though they are not unique: one of them
        is below zero as it is computed, and no other distribution is found either. Found by bisection."""
        run = self.motion.run
        t0, h = float(run.clock[stepped_run.BEFORE]), float(run.clock[stepped_run.DONE_STEP])

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
                state = self._y.copy() if step is None else step
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
            state = step
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


def _peak(value: Callable[[float], float], low: float, high: float, zero: float) -> float | None:
    """A place where the value is above zero, in a part at whose beginning it is zero; None if there is none."""
    for k in range(12):
        s = low + (high - low) * 0.5 ** (k + 1)
        if value(s) > zero:
            return s
    return None


def _root(value: Callable[[float], float], low: float, high: float) -> float:
    """Where a value changes its sign. At a place in between where it has none, as a force in a singular pose, it counts
    as what it was at the lower end."""
    before = value(low)

    def known(s: float) -> float:
        x = value(s)
        return x if math.isfinite(x) else before

    return zero_between(known, low, high, xtol=1e-15, rtol=1e-14)
