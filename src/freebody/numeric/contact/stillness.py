"""What counts as a rate that is none: one far below the speeds that the system has shown.

A system at rest has no speed; there a speed is taken from the forces, sqrt(a L) with the largest acceleration a of free
bodies and the size L of the system, made small.
"""

from __future__ import annotations

import math
from collections.abc import Iterable

import numpy as np

from freebody.numeric.contact.bounded import Bounded
from freebody.numeric.contact.rows import ContactInstant, ModeOf
from freebody.numeric.kernels.arrays import Floats
from freebody.tolerances import ROUNDED

STILL = 1e-9  # rates below this part of the system's speed are none
ENDED = 1e-6  # slips that have just ended may be this part of it

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
                rate, size = self._slip(k, now, speed)
                is_still = abs(rate) <= STILL * size or (k in self.stopped and abs(rate) <= ENDED * size)
                found[k] = 0 if is_still else (1 if rate > 0.0 else -1)
        return found

    def _slip(self, k: int, now: ContactInstant, speed: float) -> tuple[float, float]:
        """The rate of a drag, in a plane its size, and a speed of its kind."""
        drag = self.bounded.drags[k]
        rate = float(now.rates[drag.keeps])
        if drag.across >= 0:
            rate = math.hypot(rate, float(now.rates[drag.keeps_across]))
        return rate, speed if not self.bounded.is_angle(drag.rub.row) else speed / self.length

    def vanishing(self, y: Floats, now: ContactInstant, mode: ModeOf) -> tuple[int, ...]:
        """Drags in planes that slide so slowly that their slip may count as ended."""
        speed, drags = self.speed(y, now), self.bounded.drags
        slips = {k: self._slip(k, now, speed) for k, state in enumerate(mode.drags) if state and drags[k].across >= 0}
        return tuple(k for k, (rate, size) in slips.items() if rate <= ENDED * size)
