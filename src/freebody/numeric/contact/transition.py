"""The transition between two phases: impacts, then the contact mode in which the motion goes on.

1. Barriers (unilateral constraints) at gap zero that approach collide: the impulses of all that touch are found at
   once.
2. A gap that opens, but would not come wider than `REST` of the system's size, stays closed. After an impact this ends
   the sequence of rebounds; its time is the limit of the geometric series, t + 2 u / (a (1 - e)), with u the speed of
   the rebound and a the acceleration with which it is pressed back.
3. Of the barriers at gap zero and rate zero, and of friction at rest, the contact problem in accelerations says what
   stays closed and what sticks.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from freebody.language.sentences import Message, in_turn
from freebody.numeric.contact.bounded import TOUCHING, Bounded
from freebody.numeric.contact.forces import contact_forces, is_admissible
from freebody.numeric.contact.impacts import impact
from freebody.numeric.contact.impulses import ImpactOutcome
from freebody.numeric.contact.keller import impact_without_collision
from freebody.numeric.contact.problem import ForceOutcome, OutcomeCount, RowState
from freebody.numeric.contact.rows import ContactInstant, ModeOf, RowProblem
from freebody.numeric.kernels.arrays import Floats
from freebody.numeric.options import Law
from freebody.tolerances import ROUND_OFF, ROUNDED

STILL = 1e-9  # rates below this part of the system's speed are none
REST = 1e-10  # gaps that do not come wider than this part of the system's size are none
TIED = 1e-9  # rates of approach that differ by less, relatively, are equal
N_IMPACTS = 50
OPEN = 1e-12  # eigenvalues of rows that depend on each other, by the largest
_SEEN = 1e-6  # of a unit vector of forces that do nothing: less is no part in it
MOST_OTHERS = 300  # modes that are tried to find out whether there is another outcome: those of three contacts

Choice = tuple[str, int, int | None]  # ("closed", barrier, None), ("open", barrier, None), ("drag", drag, state)


@dataclass(frozen=True)
class ImpactRecord:
    """Collisions at one instant: impulses [N s], rates before and after by barrier, and the energy that they take."""

    time: float
    impulses: dict[int, float]
    friction: dict[int, float]  # by drag
    before: dict[int, float]
    after: dict[int, float]
    energy_change: float
    energy_grew: bool
    joints: dict[int, float] = field(default_factory=dict[int, float])  # by place: of what holds, where they are unique
    not_unique: tuple[int, ...] = ()  # places of rows whose impulses are not


@dataclass
class After:
    """The outcome of an instant."""

    y: Floats
    mode: ModeOf | None  # None: no consistent one
    impacts: list[ImpactRecord] = field(default_factory=list[ImpactRecord])
    resting: dict[int, float] = field(default_factory=dict[int, float])  # barrier: time at which its rebounds end
    status: OutcomeCount = OutcomeCount.UNIQUE
    why: str = ""
    jammed: int | None = None  # the barrier that took an impulse without a collision
    behind: set[int] = field(default_factory=set[int])  # far sides of what touches: passed through, not met
    handed: set[int] = field(default_factory=set[int])  # a place that ends and those of the same outlines that go on
    settled: float = 0.0  # work of the friction of rebounds that are too small to be followed


HELD_ALONE = Message(
    "what is held without any contact: constraints that say the same thing contradict each other by round-off"
)


class InstantTransition:
    """Decides what follows on an instant of one system."""

    def __init__(self, bounded: Bounded, law: Law, *, jams: bool = False) -> None:
        """jams: where no force is consistent, a contact may take an impulse without a collision."""
        self.bounded, self.law, self.jams = bounded, law, jams
        self.length = bounded.numbers.length
        self.fastest = 0.0  # met so far: by it rates count as none
        self.tied: dict[str, None] = {}  # contacts hit equally fast of which one had to come first
        self.is_replaced = False  # whether an impact did not obey the law, and another one took its place

    def after(
        self,
        y: Floats,
        t: float,
        near: Floats,
        mode: ModeOf | None,
        touched: Iterable[int] = (),
        stopped: Iterable[int] = (),
        left: int | None = None,
        forbidden: Iterable[Choice] = (),
    ) -> After:
        """What follows on a state. mode: the one before. touched: barriers whose gap has just closed; stopped: drags
        whose slip has just ended; left: a barrier of which the end of the edge has just been passed. forbidden: states
        that the motion has shown to be impossible."""
        b = self.bounded
        self.stopped = set(stopped)
        if left is not None and mode is not None:  # what stuck to the edge sticks to what follows on it
            stuck = any(b.drags[k].of == left and state == 0 for k, state in enumerate(mode.drags))
            family = b.barriers[left].family
            self.stopped |= {
                k for k, d in enumerate(b.drags) if stuck and d.of >= 0 and b.barriers[d.of].family == family
            }
        # what touches now; the far side of an edge does not
        y = y.copy()
        forbidden = tuple(forbidden)
        result = After(y, None)
        before = frozenset[int]() if mode is None else mode.closed - {left}
        now = b.instant(y, t, near)
        touching = [k for k in self._touching(now, before, touched) if k != left]
        result.behind = self._far_sides(now, touching, before.union(touched))
        touching = [k for k in touching if k not in result.behind]
        # impacts, one after another, until nothing that touches approaches
        for _ in range(N_IMPACTS):
            now = b.instant(y, t, near)
            speed = self._speed(y, touching, now)
            rates = {k: b.barriers[k].sign * float(now.rates[b.barriers[k].place]) for k in touching}
            if not any(rate < -STILL * speed for rate in rates.values()):
                break
            collision = self._collide(now, touching, rates)
            if collision is None:
                result.status, result.why = OutcomeCount.NONE, Message("the impact")
                return result
            outcome, problem = collision
            change = self._push(y, problem.weighted, outcome.impulses)
            result.impacts.append(self._impact(t, problem, outcome, rates, change))
        # rebounds too small to be followed end at once; then accelerations decide on the mode
        self._settle(result, now, touching, near)
        now = b.instant(y, t, near)
        outcome = self._decide(result, now, touching, mode, forbidden)
        if self.jams and outcome.status is OutcomeCount.NONE and self._jam(result, now, touching):
            now = b.instant(y, t, near)
            outcome = self._decide(result, now, touching, None, forbidden)
        # an edge that ends may hand its contact over to the next one of the same outlines
        result.status = outcome.status
        if left is not None and result.mode is not None and not result.impacts:
            family = b.barriers[left].family
            taken = {k for k in result.mode.closed - before if b.barriers[k].family == family}
            result.handed = taken | {left} if taken else set()
        return result

    def _jam(self, result: After, now: ContactInstant, touching: list[int]) -> bool:
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
        change = self._push(result.y, problem.weighted, outcome.impulses)
        result.impacts.append(self._impact(now.t, problem, outcome, rates, change))
        result.jammed = touching[0]
        return True

    # -- what touches -------------------------------------------------------------------------
    def _touching(self, now: ContactInstant, before: frozenset[int], touched: Iterable[int]) -> list[int]:
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

    def _far_sides(self, now: ContactInstant, touching: list[int], known: frozenset[int]) -> set[int]:
        """Of an edge with two sides, a rod, the side that a thing which touches it is not on: not the one at which it
        was, else that with the narrower gap or, between equal ones, that which moves away."""
        b = self.bounded
        found: set[int] = set()
        for n, j in enumerate(touching):
            for k in touching[n + 1 :]:
                one, other = b.barriers[j], b.barriers[k]
                if not one.obstacle or one.obstacle != other.obstacle:
                    continue
                g, h = (x.sign * now.gradients[x.place] for x in (one, other))
                if np.abs(g + h).max() > ROUND_OFF * np.abs(g).max():
                    continue
                free = b.inverse_mass * now.force

                def order(i: int, g: Floats = g, free: Floats = free) -> tuple[bool, float, float, float]:
                    x = b.barriers[i]
                    gap = round(x.sign * float(now.values[x.place]) / (1e-13 * self.length))
                    rate = float(now.rates[x.place])
                    speed = STILL * self._speed(now.y, touching, now)
                    falls = float(now.gradients[x.place] @ free + now.biases[x.place])
                    return i not in known, -gap, x.sign * rate if abs(rate) > speed else 0.0, x.sign * falls

                found.add(max(j, k, key=order))
        return found

    def _speed(self, y: Floats, touching: list[int], now: ContactInstant) -> float:
        n = self.bounded.free.n_coordinates
        unit = self.bounded.free.unit
        fastest = float((np.abs(y[n : 2 * n]) / unit).max(initial=0.0)) * self.length
        hardest = float((np.abs(now.force * self.bounded.inverse_mass) / unit).max(initial=0.0)) * self.length
        self.fastest = max(self.fastest, fastest)
        return max(self.fastest, 1e-3 * float(np.sqrt(hardest * self.length)), ROUNDED)

    # -- impacts ------------------------------------------------------------------------------
    def _collide(
        self, now: ContactInstant, touching: list[int], rates: dict[int, float]
    ) -> tuple[ImpactOutcome, RowProblem] | None:
        b = self.bounded
        drags = {k: 0 for k, d in enumerate(b.drags) if d.of in touching or (d.of < 0 and d.loads)}
        closed = list(touching)
        while True:
            problem = b.problem(now, closed, drags, of_rates=True)
            restitution = {problem.row_of_barrier(k): b.barriers[k].restitution for k in closed}
            law = self._law(closed, drags)
            outcome = impact(problem.matrices, restitution, law, most_others=MOST_OTHERS)
            if not outcome.is_found and law is Law.NEWTON:
                outcome = impact(problem.matrices, restitution, Law.POISSON, most_others=MOST_OTHERS)
                self.is_replaced = self.is_replaced or outcome.is_found
            if not outcome.is_found:
                return self._alone(now, closed, drags, rates)
            # an ideal contact that takes no impulse does not grip either
            loose = [
                k
                for k in closed
                if b.barriers[k].grips and outcome.impulses[problem.row_of_barrier(k)] <= 0.0 and rates[k] >= 0.0
            ]
            if not loose:
                return outcome, problem
            closed = [k for k in closed if k not in loose]

    def _law(self, closed: list[int], drags: dict[int, int]) -> Law:
        """The law of an impact: Keller's follows one contact with the one friction that it loads, Poisson's takes over
        elsewhere."""
        is_single = len(closed) == 1 and len(drags) < 2 and all(self.bounded.drags[k].of in closed for k in drags)
        if self.law is not Law.KELLER or is_single:
            return self.law
        self.is_replaced = True
        return Law.POISSON

    def _alone(
        self, now: ContactInstant, closed: list[int], drags: dict[int, int], rates: dict[int, float]
    ) -> tuple[ImpactOutcome, RowProblem] | None:
        """Where no impulses of all contacts at once obey the law: that of the fastest one alone, of equally fast ones
        the first by name; what it does to the others is a collision of its own."""
        b = self.bounded
        fastest = min(rates[k] for k in closed)
        tied = [k for k in closed if rates[k] <= fastest * (1.0 - TIED)]
        hit = min(tied)
        if len(tied) > 1:
            self.tied |= dict.fromkeys(b.barriers[k].name for k in tied)
        own = {k: s for k, s in drags.items() if b.drags[k].of == hit}
        problem = b.problem(now, [hit], own, of_rates=True)
        outcome = impact(problem.matrices, {problem.row_of_barrier(hit): b.barriers[hit].restitution}, Law.POISSON)
        self.is_replaced = self.is_replaced or outcome.is_found
        return (outcome, problem) if outcome.is_found else None

    def _push(self, y: Floats, weighted: Floats, impulses: Floats) -> float:
        """Gives impulses to a state; what they change of the kinetic energy, dv.M (v + dv/2), with what is driven."""
        n = self.bounded.free.n_coordinates
        inverse = self.bounded.inverse_mass
        dv = weighted.T @ impulses
        momentum = np.divide(dv, inverse, out=np.zeros_like(dv), where=inverse > 0.0)
        change = float(momentum @ (y[n : 2 * n] + 0.5 * dv))
        y[n : 2 * n] += dv
        return change

    def _impact(
        self, t: float, problem: RowProblem, outcome: ImpactOutcome, rates: dict[int, float], change: float
    ) -> ImpactRecord:
        rows = {k: problem.row_of_barrier(k) for k in problem.closed}
        is_open = _not_unique(problem.matrices.A)
        joints = {
            place: float(outcome.impulses[row])
            for row, place in enumerate(problem.places[: problem.n_held])
            if not is_open[row]
        }
        return ImpactRecord(
            t,
            {k: float(outcome.impulses[row]) for k, row in rows.items()},
            {k: float(outcome.impulses[problem.row_of_drag(k)]) for k in problem.drags},
            {k: rates[k] for k in rows},
            {k: float(outcome.velocities[row]) for k, row in rows.items()},
            change,
            outcome.energy_grew,
            joints,
            tuple(place for row, place in enumerate(problem.places) if is_open[row]),
        )

    # -- the end of rebounds ------------------------------------------------------------------
    def _settle(self, result: After, now: ContactInstant, touching: list[int], near: Floats) -> None:
        """Contacts that would open by less than can be seen stay closed."""
        b = self.bounded
        hit = {k for impact in result.impacts for k, rate in impact.before.items() if rate < 0.0}
        now = b.instant(result.y, now.t, near)
        speed = self._speed(result.y, touching, now)
        rates = {k: b.barriers[k].sign * float(now.rates[b.barriers[k].place]) for k in touching}
        rising = [k for k in touching if rates[k] > STILL * speed and (k not in hit or b.barriers[k].restitution < 1.0)]
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
                if k in hit:
                    result.resting[k] = now.t + 2.0 * u / (a * (1.0 - e))
        if settled:
            self._hold(result, now, touching, settled, rates, speed)

    def _accelerations(
        self, now: ContactInstant, touching: list[int], rising: list[int], rates: dict[int, float], speed: float
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
        now: ContactInstant,
        touching: list[int],
        settled: list[int],
        rates: dict[int, float],
        speed: float,
    ) -> None:
        """Takes the rates of the settled gaps away, by the least impulse. Until the rebounds end, contact presses by
        that impulse less than lasting contact would, and friction that slides takes as much less: it goes with it."""
        b = self.bounded
        kept = [k for k in touching if k in settled or abs(rates[k]) <= STILL * speed]
        drags = {k: slip for k, slip in self._drags_on(now, kept, speed).items() if b.drags[k].of >= 0}
        held = [*b.bilateral, *(b.drags[k].keeps for k, slip in drags.items() if slip == 0)]
        places = [*held, *(b.barriers[k].place for k in kept)]
        J = now.gradients[places]
        along = J.copy()
        for k, slip in drags.items():
            if slip:
                c = b.numbers.number(b.drags[k].rub.coefficient(slip))
                row = len(held) + kept.index(b.drags[k].of)
                along[row] -= slip * c * b.barriers[b.drags[k].of].sign * now.gradients[b.drags[k].keeps]
        weighted = along * b.inverse_mass
        impulse = np.asarray(np.linalg.lstsq(J @ weighted.T, -now.rates[places], rcond=ROUNDED)[0], dtype=np.float64)
        result.settled += (change := self._push(result.y, weighted, impulse))
        result.y[b.free.at_work] += change

    # -- what stays ---------------------------------------------------------------------------
    def _drags_on(self, now: ContactInstant, closed: Iterable[int], speed: float) -> dict[int, int]:
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
        self,
        result: After,
        now: ContactInstant,
        touching: list[int],
        mode: ModeOf | None,
        forbidden: tuple[Choice, ...],
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
            outcome = contact_forces(problem.matrices, previous, banned, most_others=MOST_OTHERS)
            if not outcome.is_found and banned:
                outcome = contact_forces(problem.matrices, previous, most_others=MOST_OTHERS)
            if not outcome.is_found:
                result.status = outcome.status
                names = [b.barriers[k].name for k in closed]
                names += [b.drags[k].name for k in drags if b.drags[k].of not in closed]
                result.why = Message("contact and friction at {names}", names=in_turn(names)) if names else HELD_ALONE
                return outcome
            still = [k for k in closed if outcome.mode[problem.row_of_barrier(k)] is RowState.CLOSED]
            if len(still) < len(closed) and any(b.barriers[k].grips for k in closed if k not in still):
                closed = still  # an ideal contact that opens does not grip either
                continue
            break
        states: list[int | None] = [None] * len(b.drags)
        for k in drags:
            state = outcome.mode[problem.row_of_drag(k)]
            is_on = b.drags[k].of < 0 or b.drags[k].of in still
            known = {RowState.STICKING: 0, RowState.FORWARD: 1, RowState.BACKWARD: -1}
            states[k] = known.get(state) if is_on else None
            if is_on and states[k] is None and b.drags[k].of < 0:
                states[k] = drags[k] or 1  # nothing presses it: it slides without force
        result.mode = ModeOf(frozenset(still), tuple(states))
        return outcome

    def lasts(self, y: Floats, t: float, near: Floats, mode: ModeOf) -> bool:
        """Whether a mode can go on in a state: some distribution of its forces, unique or not, is admissible."""
        now = self.bounded.instant(y, t, near)
        drags = {k: state for k, state in enumerate(mode.drags) if state is not None}
        problem = self.bounded.problem(now, sorted(mode.closed), drags, of_rates=False)
        states = self._previous(problem, mode)
        return states is not None and is_admissible(problem.matrices, states)

    def _previous(self, problem: RowProblem, mode: ModeOf | None) -> tuple[RowState, ...] | None:
        if mode is None:
            return None
        states = [RowState.HELD] * problem.matrices.n
        for k in problem.closed:
            states[problem.row_of_barrier(k)] = RowState.CLOSED if k in mode.closed else RowState.OPEN
        known = {0: RowState.STICKING, 1: RowState.FORWARD, -1: RowState.BACKWARD, None: RowState.ABSENT}
        for k in problem.drags:
            states[problem.row_of_drag(k)] = known[mode.drags[k]]
        return tuple(states)

    def _banned(self, problem: RowProblem, forbidden: tuple[Choice, ...]) -> list[tuple[int, RowState]]:
        known = {0: RowState.STICKING, 1: RowState.FORWARD, -1: RowState.BACKWARD}
        found: list[tuple[int, RowState]] = []
        for what, k, state in forbidden:
            if what == "drag" and k in problem.drags and state is not None:
                found.append((problem.row_of_drag(k), known[state]))
            elif what == "open" and k in problem.closed:
                found.append((problem.row_of_barrier(k), RowState.OPEN))
        return found


def _not_unique(A: Floats) -> NDArray[np.bool_]:
    """(n,) which of the forces x are not determined by A x, A symmetric and not negative."""
    sizes = np.sqrt(np.maximum(np.diag(A), 0.0))
    sizes[sizes == 0.0] = 1.0
    values, vectors = np.linalg.eigh(A / np.outer(sizes, sizes))
    null = vectors[:, values <= OPEN * max(1.0, float(values.max(initial=0.0)))]
    found: NDArray[np.bool_] = np.abs(null).max(axis=1, initial=0.0) > _SEEN
    return found
