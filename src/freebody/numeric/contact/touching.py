"""What touches at an instant: barriers at gap zero, without the far sides of what is touched."""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np

from freebody.numeric.contact.bounded import TOUCHING, Bounded
from freebody.numeric.contact.rows import ContactInstant
from freebody.numeric.contact.stillness import STILL, MotionSpeeds
from freebody.numeric.kernels.arrays import Floats
from freebody.tolerances import ROUND_OFF


def touching_at(b: Bounded, now: ContactInstant, before: frozenset[int], touched: Iterable[int]) -> list[int]:
    """The barriers whose gap is none, those that were closed before, and those that have just closed."""
    found: list[int] = []
    touched = set(touched)
    for k, barrier in enumerate(b.barriers):
        is_put = k in b.ends.by_edge and k not in before and k not in touched  # a pivot is put, and never met
        if is_put or not b.is_valid(k):
            continue
        gap = barrier.sign * float(now.values[barrier.place])
        size = 1.0 if b.is_angle(barrier.bound.row) else b.numbers.length
        if k in touched or k in before or abs(gap) <= TOUCHING * size:
            found.append(k)
    standing = {b.ends.by_edge[k].flat for k in found if k in b.ends.by_edge}
    return [k for k in found if k not in standing]


def far_sides(still: MotionSpeeds, now: ContactInstant, touching: list[int], known: frozenset[int]) -> set[int]:
    """Of an edge with two sides, a rod, the side that a thing which touches it is not on: not the one at which it
    was, else that with the narrower gap or, between equal ones, that which moves away. Of two edges at whose corner
    something is that keeps before one of them, the one that it gets behind."""
    b = still.bounded
    slow = STILL * still.speed(now.y, now)
    found: set[int] = set()
    for n, j in enumerate(touching):
        for k in touching[n + 1 :]:
            one, other = b.barriers[j], b.barriers[k]
            if not one.obstacle or (one.family, one.obstacle) != (other.family, other.obstacle):
                continue
            g, h = (x.sign * now.gradients[x.place] for x in (one, other))
            if np.abs(g + h).max() > ROUND_OFF * np.abs(g).max():
                rates = sorted((x.sign * float(now.rates[x.place]), i) for x, i in ((one, j), (other, k)))
                if rates[0][0] < -slow <= rates[1][0]:
                    found.add(rates[0][1])
                continue
            free = b.inverse_mass * now.force

            def order(i: int, g: Floats = g, free: Floats = free) -> tuple[bool, float, float, float]:
                x = b.barriers[i]
                gap = round(x.sign * float(now.values[x.place]) / (1e-13 * still.length))
                rate = float(now.rates[x.place])
                falls = float(now.gradients[x.place] @ free + now.biases[x.place])
                return i not in known, -gap, x.sign * rate if abs(rate) > slow else 0.0, x.sign * falls

            found.add(max(j, k, key=order))
    return found
