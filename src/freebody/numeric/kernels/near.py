"""Which pairs of circles are near: sort and sweep. Source: Ericson, Real-Time Collision Detection, 2005, sec. 7.5."""

# pyright: basic

from __future__ import annotations

from freebody.numeric.kernels.arrays import Floats, Floats2, Ints, Ints2
from freebody.numeric.kernels.declaring import entry


@entry
def close_circles(centers: Floats2, radii: Floats, order: Ints, margin: float, pair_of: Ints2, found: Ints2) -> int:
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
