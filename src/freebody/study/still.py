"""Whether a system starts at rest in an equilibrium, as far as floating-point numbers can tell.

Such a system stays there, be the equilibrium stable or not. In numbers an unstable one is left: round-off is a
disturbance, and grows. What it grows to is no property of the model.
"""

from __future__ import annotations

import numpy as np

from freebody.language.expression import free_symbols
from freebody.numeric.jets import Array
from freebody.numeric.reference import Snapshot
from freebody.system.system import System

ROUND_OFF = 1e-10  # an acceleration [m/s^2, rad/s^2] that counts as none, by the size of the system


def is_still(start: Snapshot, accelerations: Array) -> bool:
    """True at rest, without accelerations, where nothing depends on time."""
    if start.v.any() or _depends_on_time(start.reference.system):
        return False
    size = max(1.0, start.reference.sizes.length)
    return float(np.abs(accelerations).max(initial=0.0)) <= ROUND_OFF * size


def _depends_on_time(system: System) -> bool:
    targets = [row.target for row in system.held if row.target is not None]
    general = [*(row.general for row in system.held), *(push.general for push in system.pushes)]
    return any(g is not None for g in general) or any(
        "t" in free_symbols(law) for law in (*targets, *(push.law for push in system.pushes))
    )
