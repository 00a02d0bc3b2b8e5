"""Which pairs of outlines are near: sort and sweep over circles, heights over lines.

Only pairs that come within a margin are looked at in the steps; the margin is used up when something has moved by half
of it. Source: Ericson, Real-Time Collision Detection, 2005, sec. 7.5.
"""

# pyright: basic

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from freebody.numeric.engine.layout import Floats
from freebody.numeric.timestepping.compiled import entry

_LIST, _TABLE, _INTS, _PAIRS, _FLOAT = (
    np.zeros(1),
    np.zeros((1, 1)),
    np.zeros(1, np.int32),
    np.zeros((1, 1), np.int32),
    1.0,
)


@entry(_TABLE, _LIST, _INTS, _FLOAT, _PAIRS, _PAIRS)
def close_circles(centers, radii, order, margin, pair_of, found):
    """Pairs of circles (with `pair_of` their number, -1: none) that come within the margin: (n, 1) numbers of pairs in
    `found`, as many as have room; returns how many there are. order: the circles from left to right, as it was before
    and as it becomes."""
    n = len(order)
    for k in range(1, n):  # insertion sort: little changes between two calls
        i = order[k]
        left = centers[i, 0] - radii[i]
        j = k - 1
        while j >= 0 and centers[order[j], 0] - radii[order[j]] > left:
            order[j + 1] = order[j]
            j -= 1
        order[j + 1] = i
    count = 0
    for k in range(n):
        i = order[k]
        x, y, r = centers[i, 0], centers[i, 1], radii[i] + margin
        for m in range(k + 1, n):
            j = order[m]
            if centers[j, 0] - radii[j] > x + r:
                break
            p = pair_of[i, j]
            if p < 0:
                continue
            dx, dy, reach = centers[j, 0] - x, centers[j, 1] - y, r + radii[j]
            if dx * dx + dy * dy <= reach * reach:
                if count < len(found):
                    found[count, 0] = p
                count += 1
    return count


def placed(q: Floats, bodies: NDArray[Any], offsets: Floats) -> Floats:
    """(n, 2) ground positions of points of bodies."""
    c, s = np.cos(q[bodies, 2]), np.sin(q[bodies, 2])
    x, y = offsets[:, 0], offsets[:, 1]
    return np.column_stack([q[bodies, 0] + c * x - s * y, q[bodies, 1] + s * x + c * y])


def close_to_line(centers: Floats, radii: Floats, through: Floats, along: Floats, margin: float) -> NDArray[np.bool_]:
    """Which circles come within the margin of the solid side of a fixed line."""
    height = (centers[:, 1] - through[1]) * along[0] - (centers[:, 0] - through[0]) * along[1]
    return np.asarray(height - radii <= margin, bool)


def close_to_ring(centers: Floats, radii: Floats, ring: Floats, radius: float, margin: float) -> NDArray[np.bool_]:
    """Which circles come within the margin of the inside of a ring."""
    distance = np.hypot(centers[:, 0] - ring[0], centers[:, 1] - ring[1])
    return np.asarray(distance + radii >= radius - margin, bool)
