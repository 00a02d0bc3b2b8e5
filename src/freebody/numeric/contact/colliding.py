"""Collisions of all that touches at one instant: which law says their impulses, and what they do to a state.

The law is Newton's or Poisson's of restitution, or Keller's, with Coulomb's friction in impulses (`impacts`). Where
Newton's has no solution Poisson's takes its place, and where that has none either, the fastest contact collides alone:
what it does to the others is a collision of its own.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from freebody.numeric.contact.after import ImpactRecord
from freebody.numeric.contact.bounded import Bounded
from freebody.numeric.contact.impacts import impact
from freebody.numeric.contact.impulses import ImpactOutcome
from freebody.numeric.contact.problem import MOST_OTHERS
from freebody.numeric.contact.rows import ContactInstant, RowProblem
from freebody.numeric.kernels.arrays import Floats
from freebody.numeric.options import ImpactLaw

TIED = 1e-9  # rates of approach that differ by less, relatively, are equal
OPEN = 1e-12  # eigenvalues of rows that depend on each other, by the largest
_SEEN = 1e-6  # of a unit vector of forces that do nothing: less is no part in it


class Collisions:
    """Those of one motion, by one law."""

    def __init__(self, bounded: Bounded, law: ImpactLaw) -> None:
        self.bounded, self.law = bounded, law
        self.tied: dict[str, None] = {}  # contacts hit equally fast of which one had to come first
        self.is_replaced = False  # whether an impact did not obey the law, and another one took its place

    def impulses(
        self, now: ContactInstant, touching: list[int], rates: dict[int, float]
    ) -> tuple[ImpactOutcome, RowProblem] | None:
        """The impulses of all that touches, by the law; None where none obey it, and no other law either."""
        b = self.bounded
        drags = {k: 0 for k, d in enumerate(b.drags) if d.of in touching or (d.of < 0 and d.loads)}
        closed = list(touching)
        while True:
            problem = b.problem(now, closed, drags, of_rates=True)
            restitution = {problem.row_of_barrier(k): b.barriers[k].restitution for k in closed}
            law = self._law(closed, drags)
            outcome = impact(problem.matrices, restitution, law, most_others=MOST_OTHERS)
            if not outcome.is_found and law is ImpactLaw.NEWTON:
                outcome = impact(problem.matrices, restitution, ImpactLaw.POISSON, most_others=MOST_OTHERS)
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

    def _law(self, closed: list[int], drags: dict[int, int]) -> ImpactLaw:
        """The law of an impact: Keller's follows one contact with the one friction along a line that it loads,
        Poisson's takes over elsewhere."""
        followed = [self.bounded.drags[k] for k in drags]
        is_single = len(closed) == 1 and len(drags) < 2 and all(d.of in closed and d.across < 0 for d in followed)
        if self.law is not ImpactLaw.KELLER or is_single:
            return self.law
        self.is_replaced = True
        return ImpactLaw.POISSON

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
        outcome = impact(
            problem.matrices, {problem.row_of_barrier(hit): b.barriers[hit].restitution}, ImpactLaw.POISSON
        )
        self.is_replaced = self.is_replaced or outcome.is_found
        return (outcome, problem) if outcome.is_found else None


def push(bounded: Bounded, y: Floats, weighted: Floats, impulses: Floats) -> float:
    """Gives impulses to a state; what they change of the kinetic energy, dv.M (v + dv/2), with what is driven."""
    n = bounded.free.n_coordinates
    inverse = bounded.inverse_mass
    dv = weighted.T @ impulses
    momentum = np.divide(dv, inverse, out=np.zeros_like(dv), where=inverse > 0.0)
    change = float(momentum @ (y[n : 2 * n] + 0.5 * dv))
    y[n : 2 * n] += dv
    return change


def recorded(
    bounded: Bounded, t: float, problem: RowProblem, outcome: ImpactOutcome, rates: dict[int, float], change: float
) -> ImpactRecord:
    """What is kept of a collision. rates: before it, by barrier; change: of the kinetic energy."""
    after = {k: float(outcome.velocities[problem.row_of_barrier(k)]) for k in problem.closed}
    for end in (bounded.ends.by_flat[k] for k in problem.closed if k in bounded.ends.by_flat):
        turning = outcome.velocities[[problem.row_of_drag(end.moment), problem.across[end.moment]]]
        after[end.flat] -= end.radius * float(np.linalg.norm(turning))
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
        {problem.places[row]: float(outcome.impulses[row]) for row in problem.rows_of_friction},
        {k: rates[k] for k in rows},
        after,
        change,
        outcome.energy_grew,
        joints,
        tuple(place for row, place in enumerate(problem.places) if is_open[row]),
    )


def _not_unique(A: Floats) -> NDArray[np.bool_]:
    """(n,) which of the forces x are not determined by A x, A symmetric and not negative."""
    sizes = np.sqrt(np.maximum(np.diag(A), 0.0))
    sizes[sizes == 0.0] = 1.0
    values, vectors = np.linalg.eigh(A / np.outer(sizes, sizes))
    null = vectors[:, values <= OPEN * max(1.0, float(values.max(initial=0.0)))]
    found: NDArray[np.bool_] = np.abs(null).max(axis=1, initial=0.0) > _SEEN
    return found
