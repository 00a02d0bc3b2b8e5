"""A planner that looks at every principle that touches what is unknown so far."""

from __future__ import annotations

import numpy as np

from freebody.narrative.principles.planner import Mask, Places, Planner


class WidePlanner(Planner):
    """Where a friction counts as its normal force, an equation may be needed although no unknown of it is alone: a
    wider search, for the few bodies that contacts are derived for."""

    def _useful(self, support: Mask, chosen: tuple[int, ...], wanted: Mask) -> Places:
        if not chosen:
            return super()._useful(support, chosen, wanted)
        there: Mask = np.asarray(support[list(chosen)].any(axis=0) | wanted)
        free = support.copy()
        free[list(chosen)] = False
        return np.flatnonzero(free[:, there].any(axis=1))
