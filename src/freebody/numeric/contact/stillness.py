"""What counts as a rate that is none: one far below the speeds that the system has shown.

A system at rest has no speed; there a speed is taken from the forces, sqrt(a L) with the largest acceleration a of free
bodies and the size L of the system, made small.
"""

from __future__ import annotations

import math
from collections.abc import Iterable

import numpy as np

from freebody.numeric.contact.bounded import Bounded
from freebody.numeric.contact.rows import ContactInstant
from freebody.numeric.kernels.arrays import Floats
from freebody.tolerances import ROUNDED

STILL = 1e-9  # rates below this part of the system's speed are none

DIRECTED = 1e-7  # slips in planes below this part of it have no direction of their own: the errors of steps turn them


class MotionSpeeds:
    """The speeds of one motion."""

    def __init__(self, bounded: Bounded) -> None:
        self.bounded, self.length = bounded, bounded.numbers.length
        self.fastest = 0.0  # met so far: by it rates count as none
        self.stopped = set[int]()  # drags whose slip has just ended

    def speed(self, y: Floats, now: ContactInstant) -> float:
        """The largest speed met so far, or what the forces of now lead to in a moment, as a length a second."""
        n = self.bounded.free.n_coordinates
        unit = self.bounded.free.unit
        fastest = float((np.abs(y[n : 2 * n]) / unit).max(initial=0.0)) * self.length
        hardest = float((np.abs(now.force * self.bounded.inverse_mass) / unit).max(initial=0.0)) * self.length
        self.fastest = max(self.fastest, fastest)
        return max(self.fastest, 1e-3 * float(np.sqrt(hardest * self.length)), ROUNDED)

    def drags_on(self, now: ContactInstant, closed: Iterable[int], speed: float) -> dict[int, int]:
        """Drags that act where these barriers are closed, with the sign of their slip rates."""
        b = self.bounded
        closed = set(closed)
        found: dict[int, int] = {}
        for k, drag in enumerate(b.drags):
            if drag.of in closed or drag.of < 0:
                rate = float(now.rates[drag.keeps])
                if drag.across >= 0:
                    rate = math.hypot(rate, float(now.rates[drag.keeps_across]))
                size = speed if not b.is_angle(drag.rub.row) else speed / self.length
                is_still = abs(rate) <= STILL * size or (k in self.stopped and abs(rate) <= 1e-6 * size)
                found[k] = 0 if is_still else (1 if rate > 0.0 else -1)
        return found
