"""All rests of a system that searches lead to.

From the start and from every rest the system is led along a free coordinate for a full turn each way, and wherever the
loads are nearest to balance on such a tour a search starts (`rest.py`). With one degree of freedom a tour runs through
the whole branch.
"""

from __future__ import annotations

import numpy as np

from freebody.budgets import allowed
from freebody.errors import CannotAnswer
from freebody.model.elements import NonholonomicForm
from freebody.numeric.families import is_one_family, soft_directions
from freebody.numeric.rest import CountedPose, LoadBalance, RestFinder
from freebody.numeric.tours import toured

_N_LOOKS = 12_000  # at the loads of a pose, after which no further search begins


class RestSearch(RestFinder):
    """The search for rests of one system, from its start pose."""

    @property
    def is_single(self) -> bool:
        """Whether one search must do: nothing is free, or velocities are bound more than positions, which makes
        every rest one of a family."""
        rows = self.reference.system.constraint_rows
        return not len(self.balance(self.start).residual) or any(isinstance(r.measure, NonholonomicForm) for r in rows)

    def near_start(self) -> list[LoadBalance]:
        """The rests to which searches from the start lead, by the shortest way and downhill."""
        found: list[LoadBalance] = []
        self._keep(found, self.rest_near(self.start))
        if not (found and self.is_single):
            self._keep(found, self.lowest_near(self.start))
        return found

    def rests(self) -> list[LoadBalance]:
        """All rests that searches from the start and along tours from it and from every rest lead to."""
        found = self.near_start()
        n_free = len(self.balance(self.start).residual)
        if self.is_single and found:
            return found
        most = allowed(_N_LOOKS)
        waiting, known = [self.start], 0
        while waiting and self._n_looks < most:
            pose = waiting.pop(0)
            for k in range(n_free):
                for start in toured(self, pose, k):
                    if n_free == 1 or self._n_looks < most:
                        self._keep(found, self.rest_near(start))
            if n_free == 1:
                return found  # the tour has seen the whole branch
            waiting += [b.pose for b in found[known:]]
            known = len(found)
        for seed in range(6):
            start = self._wandered(seed)
            if start is not None and self._n_looks < most:
                self._keep(found, self.rest_near(start))
                self._keep(found, self.lowest_near(start))
        return found

    def _wandered(self, seed: int) -> CountedPose | None:
        try:
            q, _v = self.reference.wander(self.start.q, np.random.default_rng(seed), (0.3, 1.0, 3.0)[seed % 3])
        except CannotAnswer:
            return None
        return self.moved(CountedPose(q, self.start.branches), np.zeros_like(q))

    def _keep(self, found: list[LoadBalance], rest: LoadBalance | None) -> None:
        """Adds a rest that is not there yet; of two that are the same the less wound one is kept, of a family the
        first."""
        if rest is None:
            return
        soft = soft_directions(self, rest).shape[1] if found else 0
        for k, other in enumerate(found):
            if self.is_same(rest, other):
                if self._winding(rest) < self._winding(other) - 1e-3:
                    found[k] = rest
                return
            if soft and is_one_family(self, rest, other):
                return
        found.append(rest)

    def _winding(self, b: LoadBalance) -> float:
        """All turns away from the angle zero, of those turning to the left a little less."""
        return float(np.abs(b.pose.q[self._turning] - 0.01).sum())
