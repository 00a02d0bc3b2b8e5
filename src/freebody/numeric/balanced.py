"""A pose at rest in which something without mass could move: loads and reactions have to balance there.

With the constraint Jacobian J and the loads Q at rest, J^T lambda = -Q. What of Q acts along the free directions N,
J N = 0, is balanced by nothing; at an equilibrium it is zero. Source: virtual work, e.g. Goldstein, Poole & Safko,
Classical Mechanics, 3rd ed. 2002, sec. 1.4."""

from __future__ import annotations

from functools import cached_property

import numpy as np

from freebody.numeric.instant import Dynamics, each_force
from freebody.numeric.snapshot import Snapshot
from freebody.numeric.split import RANK_CUT, Split, stack
from freebody.tolerances import LEAST


class Balanced(Snapshot):
    """A snapshot at rest. Its reactions balance the loads; in the place of accelerations, which are not determined, it
    has the part of the loads that nothing balances, by the size of all loads [1]."""

    @cached_property
    def _dynamics(self) -> Dynamics:
        reference, g = self.reference, self.geometry
        rows = [reference.gap(row, g).row(len(reference.masses)) for row in reference.system.constraint_rows]
        split = Split(stack(rows, len(reference.masses)), reference.sizes.small_moves, RANK_CUT)
        each = list(each_force(reference, g))
        loads = sum(each, np.zeros(len(reference.masses)))
        size = sum(float(np.linalg.norm(load)) for load in each)  # they may balance without any reaction
        left = split.null @ (split.null.T @ loads)
        return Dynamics(left / max(size, LEAST), split.multipliers(-loads), split)
