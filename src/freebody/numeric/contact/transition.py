"""What happens at an instant: impacts, then the mode in which the motion goes on.

1. Barriers at gap zero that approach collide: the impulses of all touching ones are found at once.
2. A rebound that would not come higher than `REST` of the system's size ends the sequence of rebounds: the contact
   stays, and its time is the limit of the geometric series, t + 2 u / (a (1 - e)), with u the speed of the rebound and
   a the acceleration with which it is pressed back.
3. Of the barriers at gap zero and rate zero, and of friction at rest, the contact problem in accelerations says what
   stays closed and what sticks.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, field

import numpy as np

from freebody.numeric.contact.bounded import Bounded, Instant, ModeOf, Problem
from freebody.numeric.contact.forces import contact_forces
from freebody.numeric.contact.impacts import ImpactOutcome, Law, impact
from freebody.numeric.contact.keller import impact_without_collision
from freebody.numeric.contact.problem import ForceOutcome, State, Status
from freebody.numeric.engine.layout import Floats

TOUCHING = 1e-10  # gaps below this part of the system's size are none
STILL = 1e-9  # rates below this part of the system's speed are none
REST = 1e-10  # rebounds below this part of the system's size are none
N_IMPACTS = 50

Choice = tuple[str, int, int | None]  # ("closed", barrier, None), ("open", barrier, None), ("drag", drag, state)


@dataclass(frozen=True)
class Impact:
    """Collisions at one instant: impulses [N s], rates before and after by barrier, and the energy that they take."""

    time: float
    impulses: dict[int, float]
    friction: dict[int, float]  # by drag
    before: dict[int, float]
    after: dict[int, float]
    energy_change: float
    energy_grew: bool


@dataclass
class After:
    """The outcome of an instant."""

    y: Floats
    mode: ModeOf | None  # None: no consistent one
    impacts: list[Impact] = field(default_factory=list[Impact])
    resting: dict[int, float] = field(default_factory=dict[int, float])  # barrier: time at which its rebounds end
    status: Status = Status.UNIQUE
    why: str = ""
    jammed: int | None = None  # the barrier that took an impulse without a collision


class Transition:
    """Decides what follows on an instant of one system."""

    def __init__(self, bounded: Bounded, law: Law, *, jams: bool = False) -> None:
        """jams: where no force is consistent, a contact may take an impulse without a collision."""
        self.bounded, self.law, self.jams = bounded, law, jams
        self.length = bounded.numbers.length
        self.fastest = 0.0  # met so far: by it rates count as none

    def after(
        self,
        y: Floats,
        t: float,
        near: Floats,
        mode: ModeOf | None,
        touched: Iterable[int] = (),
        stopped: Iterable[int] = (),
        forbidden: Iterable[Choice] = (),
    ) -> After:
        """What follows on a state. mode: the one before. touched: barriers whose gap has just closed; stopped: drags
        whose slip has just ended. forbidden: states that the motion has shown to be impossible."""
        self.stopped = set(stopped)
        b = self.bounded
        y = y.copy()
        forbidden = tuple(forbidden)
        result = After(y, None)
        before = frozenset[int]() if mode is None else mode.closed
        now = b.instant(y, t, near)
        touching = self._touching(now, before, touched)
        for _ in range(N_IMPACTS):
            now = b.instant(y, t, near)
            speed = self._speed(y, touching, now)
            rates = {k: b.barriers[k].sign * float(now.rates[b.barriers[k].place]) for k in touching}
            if not any(rate < -STILL * speed for rate in rates.values()):
                break
            collision = self._collide(now, touching, rates)
            if collision is None:
                result.status, result.why = Status.NONE, "the impact"
                return result
            outcome, problem = collision
            self._push(y, problem, outcome.impulses)
            result.impacts.append(self._impact(t, problem, outcome, rates))
        self._settle(result, now, touching, near)
        now = b.instant(y, t, near)
        outcome = self._decide(result, now, touching, mode, forbidden)
        if self.jams and outcome.status is Status.NONE and self._jam(result, now, touching):
            now = b.instant(y, t, near)
            outcome = self._decide(result, now, touching, None, forbidden)
        result.status = outcome.status
        return result

    def _jam(self, result: After, now: Instant, touching: list[int]) -> bool:
        """An impulse of a sliding contact without a collision, which ends its slip; False if there is none, or several
        contacts touch."""
        b = self.bounded
        if len(touching) != 1:
            return False
        speed = self._speed(result.y, touching, now)
        drags = self._drags_on(now, touching, speed)
        sliding = next((s for k, s in drags.items() if b.drags[k].of == touching[0]), 0)
        problem = b.problem(now, touching, dict.fromkeys(drags, 0), of_rates=True)
        try:
            outcome = impact_without_collision(problem.matrices, b.barriers[touching[0]].restitution, slip=sliding)
        except ValueError:
            return False
        if not outcome.is_found or not np.abs(outcome.impulses).max() > 0.0:
            return False
        rates = {touching[0]: b.barriers[touching[0]].sign * float(now.rates[b.barriers[touching[0]].place])}
        self._push(result.y, problem, outcome.impulses)
        result.impacts.append(self._impact(now.t, problem, outcome, rates))
        result.jammed = touching[0]
        return True

    # -- what touches -------------------------------------------------------------------------
    def _touching(self, now: Instant, before: frozenset[int], touched: Iterable[int]) -> list[int]:
        b = self.bounded
        found: list[int] = []
        touched = set(touched)
        for k, barrier in enumerate(b.barriers):
            if not b.is_valid(k):
                continue
            gap = barrier.sign * float(now.values[barrier.place])
            size = 1.0 if b.is_angle(barrier.bound.row) else self.length
            if k in touched or k in before or abs(gap) <= TOUCHING * size:
                found.append(k)
        return found

    def _speed(self, y: Floats, touching: list[int], now: Instant) -> float:
        n = 3 * (self.bounded.n_bodies + 1)
        unit = self.bounded.free.unit
        fastest = float((np.abs(y[n : 2 * n]) / unit).max(initial=0.0)) * self.length
        hardest = float((np.abs(now.force * self.bounded.inverse_mass) / unit).max(initial=0.0)) * self.length
        self.fastest = max(self.fastest, fastest)
        return max(self.fastest, 1e-3 * float(np.sqrt(hardest * self.length)), 1e-12)

    # -- impacts ------------------------------------------------------------------------------
    def _collide(
        self, now: Instant, touching: list[int], rates: dict[int, float]
    ) -> tuple[ImpactOutcome, Problem] | None:
        b = self.bounded
        drags = {k: 0 for k, d in enumerate(b.drags) if d.of in touching or (d.of < 0 and d.loads)}
        closed = list(touching)
        while True:
            problem = b.problem(now, closed, drags, of_rates=True)
            restitution = {problem.row_of_barrier(k): b.barriers[k].restitution for k in closed}
            law = self.law if self.law is not Law.KELLER or len(closed) == 1 else Law.POISSON
            outcome = impact(problem.matrices, restitution, law)
            if not outcome.is_found:
                return None
            # an ideal contact that takes no impulse does not grip either
            loose = [
                k
                for k in closed
                if b.barriers[k].grips and outcome.impulses[problem.row_of_barrier(k)] <= 0.0 and rates[k] >= 0.0
            ]
            if not loose:
                return outcome, problem
            closed = [k for k in closed if k not in loose]

    def _push(self, y: Floats, problem: Problem, impulses: Floats) -> None:
        n = 3 * (self.bounded.n_bodies + 1)
        y[n : 2 * n] += problem.weighted.T @ impulses

    def _impact(self, t: float, problem: Problem, outcome: ImpactOutcome, rates: dict[int, float]) -> Impact:
        rows = {k: problem.row_of_barrier(k) for k in problem.closed}
        return Impact(
            t,
            {k: float(outcome.impulses[row]) for k, row in rows.items()},
            {k: float(outcome.impulses[problem.row_of_drag(k)]) for k in problem.drags},
            {k: rates[k] for k in rows},
            {k: float(outcome.velocities[row]) for k, row in rows.items()},
            outcome.energy_change,
            outcome.energy_grew,
        )

    # -- the end of rebounds ------------------------------------------------------------------
    def _settle(self, result: After, now: Instant, touching: list[int], near: Floats) -> None:
        """Contacts that would rebound by less than can be seen stay closed."""
        b = self.bounded
        if not result.impacts:
            return
        now = b.instant(result.y, now.t, near)
        speed = self._speed(result.y, touching, now)
        rates = {k: b.barriers[k].sign * float(now.rates[b.barriers[k].place]) for k in touching}
        rising = [k for k in touching if rates[k] > STILL * speed and b.barriers[k].restitution < 1.0]
        if not rising:
            return
        accelerations = self._accelerations(now, touching, rising, rates, speed)
        if accelerations is None:
            return
        settled: list[int] = []
        for k in rising:
            a, u, e = -accelerations[k], rates[k], b.barriers[k].restitution
            size = 1.0 if b.is_angle(b.barriers[k].bound.row) else self.length
            if a > 0.0 and u * u < 2.0 * a * REST * size:
                settled.append(k)
                result.resting[k] = now.t + 2.0 * u / (a * (1.0 - e)) if result.impacts[-1].before[k] < 0.0 else now.t
        if settled:
            self._hold(result, now, touching, settled, rates, speed)

    def _accelerations(
        self, now: Instant, touching: list[int], rising: list[int], rates: dict[int, float], speed: float
    ) -> dict[int, float] | None:
        """Accelerations of gaps that open, with all others that touch in contact."""
        b = self.bounded
        closed = [k for k in touching if k not in rising and abs(rates[k]) <= STILL * speed]
        drags = self._drags_on(now, closed, speed)
        problem = b.problem(now, closed, drags, of_rates=False)
        outcome = contact_forces(problem.matrices, check_others=False)
        if not outcome.is_found:
            return None
        free = b.inverse_mass * now.force + problem.weighted.T @ outcome.forces
        return {
            k: b.barriers[k].sign * float(now.gradients[b.barriers[k].place] @ free + now.biases[b.barriers[k].place])
            for k in rising
        }

    def _hold(
        self,
        result: After,
        now: Instant,
        touching: list[int],
        settled: list[int],
        rates: dict[int, float],
        speed: float,
    ) -> None:
        """Takes the rates of the settled gaps away, by the least impulse."""
        b = self.bounded
        kept = [k for k in touching if k in settled or abs(rates[k]) <= STILL * speed]
        places = [*b.bilateral, *(b.barriers[k].place for k in kept)]
        J = now.gradients[places]
        weighted = J * b.inverse_mass
        n = 3 * (b.n_bodies + 1)
        impulse = np.linalg.lstsq(weighted @ J.T, -now.rates[places], rcond=1e-12)[0]
        result.y[n : 2 * n] += weighted.T @ impulse

    # -- what stays ---------------------------------------------------------------------------
    def _drags_on(self, now: Instant, closed: Iterable[int], speed: float) -> dict[int, int]:
        """Drags that act where these barriers are closed, with the sign of their slip rates."""
        b = self.bounded
        closed = set(closed)
        found: dict[int, int] = {}
        for k, drag in enumerate(b.drags):
            if drag.of in closed or drag.of < 0:
                rate = float(now.rates[drag.keeps])
                size = speed if not b.is_angle(drag.rub.row) else speed / self.length
                is_still = abs(rate) <= STILL * size or (k in self.stopped and abs(rate) <= 1e-6 * size)
                found[k] = 0 if is_still else (1 if rate > 0.0 else -1)
        return found

    def _decide(
        self, result: After, now: Instant, touching: list[int], mode: ModeOf | None, forbidden: tuple[Choice, ...]
    ) -> ForceOutcome:
        b = self.bounded
        speed = self._speed(result.y, touching, now)
        closed = [
            k
            for k in touching
            if abs(float(now.rates[b.barriers[k].place])) <= STILL * speed and ("closed", k, None) not in forbidden
        ]
        while True:
            drags = self._drags_on(now, closed, speed)
            problem = b.problem(now, closed, drags, of_rates=False)
            previous = self._previous(problem, mode)
            banned = self._banned(problem, forbidden)
            outcome = contact_forces(problem.matrices, previous, banned)
            if not outcome.is_found and banned:
                outcome = contact_forces(problem.matrices, previous)
            if not outcome.is_found:
                result.status = outcome.status
                names = ", ".join(b.barriers[k].name for k in closed)
                result.why = f"contact and friction at {names}"
                return outcome
            still = [k for k in closed if outcome.mode[problem.row_of_barrier(k)] is State.CLOSED]
            if len(still) < len(closed) and any(b.barriers[k].grips for k in closed if k not in still):
                closed = still  # an ideal contact that opens does not grip either
                continue
            break
        states: list[int | None] = [None] * len(b.drags)
        for k in drags:
            state = outcome.mode[problem.row_of_drag(k)]
            is_on = b.drags[k].of < 0 or b.drags[k].of in still
            known = {State.STICKING: 0, State.FORWARD: 1, State.BACKWARD: -1}
            states[k] = known.get(state) if is_on else None
            if is_on and states[k] is None and b.drags[k].of < 0:
                states[k] = drags[k] or 1  # nothing presses it: it slides without force
        result.mode = ModeOf(frozenset(still), tuple(states))
        return outcome

    def _previous(self, problem: Problem, mode: ModeOf | None) -> tuple[State, ...] | None:
        if mode is None:
            return None
        states = [State.HELD] * problem.matrices.n
        for k in problem.closed:
            states[problem.row_of_barrier(k)] = State.CLOSED if k in mode.closed else State.OPEN
        known = {0: State.STICKING, 1: State.FORWARD, -1: State.BACKWARD, None: State.ABSENT}
        for k in problem.drags:
            states[problem.row_of_drag(k)] = known[mode.drags[k]]
        return tuple(states)

    def _banned(self, problem: Problem, forbidden: tuple[Choice, ...]) -> list[tuple[int, State]]:
        known = {0: State.STICKING, 1: State.FORWARD, -1: State.BACKWARD}
        found: list[tuple[int, State]] = []
        for what, k, state in forbidden:
            if what == "drag" and k in problem.drags and state is not None:
                found.append((problem.row_of_drag(k), known[state]))
            elif what == "open" and k in problem.closed:
                found.append((problem.row_of_barrier(k), State.OPEN))
        return found
