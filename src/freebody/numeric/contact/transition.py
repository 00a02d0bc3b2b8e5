"""The transition between two phases: impacts, then the contact mode in which the motion goes on.

1. Barriers (unilateral constraints) at gap zero (`touching`) that approach collide: the impulses of all that touch are
   found at once (`colliding`).
2. A gap that opens, but would not come wider than can be seen, stays closed (`rebounds`).
3. Of the barriers at gap zero and rate zero (`stillness`), and of friction at rest, the contact problem in
   accelerations says what stays closed and what sticks (`deciding`).
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping

import numpy as np

from freebody.language.sentences import Message
from freebody.numeric.contact.after import After, Choice
from freebody.numeric.contact.bounded import TOUCHING, Bounded
from freebody.numeric.contact.colliding import Collisions, push, recorded
from freebody.numeric.contact.deciding import decide, lasts
from freebody.numeric.contact.keller import impact_without_collision
from freebody.numeric.contact.problem import OutcomeCount
from freebody.numeric.contact.rebounds import settle
from freebody.numeric.contact.rows import ContactInstant, ModeOf
from freebody.numeric.contact.stillness import STILL, MotionSpeeds
from freebody.numeric.contact.touching import far_sides, touching_at
from freebody.numeric.kernels import kinematics
from freebody.numeric.kernels.arrays import Floats
from freebody.numeric.options import ImpactLaw

N_IMPACTS = 50
SAME = 1e-6  # relative, of gradients


class InstantTransition:
    """Decides what follows on an instant of one system."""

    def __init__(self, bounded: Bounded, law: ImpactLaw, *, jams: bool = False) -> None:
        """jams: where no force is consistent, a contact may take an impulse without a collision."""
        self.bounded, self.jams = bounded, jams
        self.collisions = Collisions(bounded, law)
        self.still = MotionSpeeds(bounded)

    def falls_back(self, y: Floats, t: float, near: Floats, mode: ModeOf, rim: int) -> After:
        """What follows where a tilted rim has come down so far that a pivot takes its place."""
        end = self.bounded.ends.by_rim[rim]
        self.bounded.ends.put_at_lowest(end, self.bounded.instant(y, t, near))
        return self.after(y, t, near, mode, touched=(end.edge,), left=rim)

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
        self.still.stopped = set(stopped)
        if left is not None and mode is not None:  # what stuck to the edge sticks to what follows on it
            stuck = any(b.drags[k].of == left and state == 0 for k, state in enumerate(mode.drags))
            family = b.barriers[left].family
            self.still.stopped |= {
                k for k, d in enumerate(b.drags) if stuck and d.of >= 0 and b.barriers[d.of].family == family
            }
        # what touches now; the far side of an edge does not
        y = y.copy()
        forbidden = tuple(forbidden)
        result = After(y, None)
        before_all = frozenset[int]() if mode is None else mode.closed
        before = before_all - {left}
        now = b.instant(y, t, near)
        touching = [k for k in touching_at(b, now, before, touched) if k != left]
        if mode is None:
            touching += b.ends.hardly_tilted(now, TOUCHING * b.numbers.length)
        result.behind = far_sides(self.still, now, touching, before.union(touched))
        touching = [k for k in touching if k not in result.behind]
        hit_as_it_leaves = left if self._is_hit_as_it_leaves(left, before_all, now, touching) else None
        now = self._impacts(result, t, near, touching if hit_as_it_leaves is None else [*touching, hit_as_it_leaves])
        if result.status is OutcomeCount.NONE:
            return result
        slow = STILL * self.still.speed(y, now)
        if hit_as_it_leaves is not None and not self._goes_beyond(hit_as_it_leaves, slow):
            touching.append(hit_as_it_leaves)
            forbidden = tuple(choice for choice in forbidden if choice != ("closed", hit_as_it_leaves, None))
        touching = self._pivoting(result, now, touching, {k for k in touching if b.ends.tips(k, now, slow)})
        # rebounds too small to be followed end at once; then accelerations decide on the mode
        settle(self.still, result, b.instant(y, t, near), touching, near)
        now = b.instant(y, t, near)
        outcome = decide(self.still, result, now, touching, mode, forbidden)
        if result.mode is not None and (tipping := self._tipping(result.mode)):
            touching = self._pivoting(result, now, touching, set(tipping), tipping)
            now = b.instant(y, t, near)
            outcome = decide(self.still, result, now, touching, mode, forbidden)
        if self.jams and outcome.status is OutcomeCount.NONE and self._jam(result, now, touching):
            now = b.instant(y, t, near)
            outcome = decide(self.still, result, now, touching, None, forbidden)
        result.status = outcome.status
        if left is not None and result.mode is not None and not result.impacts:
            result.handed = self._handed(result.mode, before, left, now)
        result.handed |= {edge for edge in b.ends.by_edge if left in (edge, b.ends.by_edge[edge].rim)}
        return result

    def _is_hit_as_it_leaves(
        self, left: int | None, before: frozenset[int], now: ContactInstant, touching: list[int]
    ) -> bool:
        """Whether what touches comes to the end of its edge at the very instant at which something collides, as where
        two edges come to lie on each other: it takes part in the collision, whichever of the two is noticed first."""
        if left is None or left not in before or not self.bounded.barriers[left].within:
            return False
        slow = STILL * self.still.speed(now.y, now)
        return any(self.bounded.ends.opening(k, now) < -slow for k in touching)

    def _goes_beyond(self, k: int, slow: float) -> bool:
        """Whether a foot moves beyond the end of its edge at which it is, faster than what counts as none; at the
        instant that was looked at last."""
        rows = self.bounded.free.room.rows
        for row, low, high in self.bounded.barriers[k].within:
            value, rate = float(rows[row, kinematics.VALUE]), float(rows[row, kinematics.RATE])
            if (rate if value - low < high - value else -rate) < -slow:
                return True
        return False

    def _tipping(self, mode: ModeOf) -> dict[int, float]:
        """Flat ends that tip by the accelerations of a mode, with the angles of these."""
        ways, ends = dict(mode.ways), self.bounded.ends
        return {end.flat: ways[k] for k, end in ends.by_moment.items() if mode.drags[k] and k in ways}

    def _pivoting(
        self, result: After, now: ContactInstant, touching: list[int], flat: set[int], angles: Mapping[int, float] = {}
    ) -> list[int]:
        """What touches, with pivots for flat ends that tip: by their turning, or by angles that are known."""
        b, found = self.bounded, [k for k in touching if k not in flat]
        for k in sorted(flat):
            end = b.ends.by_flat[k]
            b.ends.put_against(end, angles.get(k, b.way(end.moment, now)), now)
            found.append(end.edge)
            result.tipping.add(k)
            family = b.barriers[k].family
            self.still.stopped |= {j for j, d in enumerate(b.drags) if d.of >= 0 and b.barriers[d.of].family == family}
        return found

    def _impacts(self, result: After, t: float, near: Floats, touching: list[int]) -> ContactInstant:
        """Impacts, one after another, until nothing that touches approaches; and the instant after them. Without a
        consistent impulse the status says so."""
        b = self.bounded
        now = b.instant(result.y, t, near)
        for _ in range(N_IMPACTS):
            now = b.instant(result.y, t, near)
            speed = self.still.speed(result.y, now)
            rates = {k: b.ends.opening(k, now) for k in touching}
            if not any(rate < -STILL * speed for rate in rates.values()):
                break
            collision = self.collisions.impulses(now, touching, rates)
            if collision is None:
                result.status, result.why = OutcomeCount.NONE, Message("the impact")
                break
            outcome, problem = collision
            change = push(b, result.y, problem.weighted, outcome.impulses)
            result.impacts.append(recorded(b, t, problem, outcome, rates, change))
        return now

    def _handed(self, mode: ModeOf, before: frozenset[int], left: int, now: ContactInstant) -> set[int]:
        """An edge that ends may hand its contact over to the next one of the same outlines: both; or to what touches at
        the same place, as two edges do that cross where a corner leaves a face."""
        barriers = self.bounded.barriers
        own = {k for k in mode.closed if barriers[k].family == barriers[left].family}
        gone = {left, *(k for k in before - mode.closed if barriers[k].family == barriers[left].family)}
        taken = own - before
        handed = {k for k in gone if any(self._is_same(k, j, now) for j in own)}
        return handed | (taken | {left} if taken else set[int]())

    def _is_same(self, k: int, j: int, now: ContactInstant) -> bool:
        """Whether two gaps are at the same place along the same normal."""
        g, h = (x.sign * now.gradients[x.place] for x in (self.bounded.barriers[k], self.bounded.barriers[j]))
        return bool(np.abs(h - g).max() <= SAME * np.abs(g).max())

    def _jam(self, result: After, now: ContactInstant, touching: list[int]) -> bool:
        """An impulse of a sliding contact without a collision, which ends its slip; False if there is none, or several
        contacts touch."""
        b = self.bounded
        if len(touching) != 1:
            return False
        speed = self.still.speed(result.y, now)
        drags = self.still.drags_on(now, touching, speed)
        sliding = next((s for k, s in drags.items() if b.drags[k].of == touching[0]), 0)
        problem = b.problem(now, touching, dict.fromkeys(drags, 0), of_rates=True)
        try:
            outcome = impact_without_collision(problem.matrices, b.barriers[touching[0]].restitution, slip=sliding)
        except ValueError:
            return False
        if not outcome.is_found or not np.abs(outcome.impulses).max() > 0.0:
            return False
        rates = {touching[0]: b.barriers[touching[0]].sign * float(now.rates[b.barriers[touching[0]].place])}
        change = push(b, result.y, problem.weighted, outcome.impulses)
        result.impacts.append(recorded(b, now.t, problem, outcome, rates, change))
        result.jammed = touching[0]
        return True

    def lasts(self, y: Floats, t: float, near: Floats, mode: ModeOf) -> bool:
        """Whether a mode can go on in a state: some distribution of its forces, unique or not, is admissible."""
        return lasts(self.bounded, y, t, near, mode)
