"""Which pairs of outlines are near: sort and sweep over circles, heights over lines.

Only pairs that come within a margin are looked at in the steps; the margin is used up when something has moved by half
of it. Source: Ericson, Real-Time Collision Detection, 2005, sec. 7.5.
"""

# pyright: basic

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from freebody.numeric.kernels.arrays import Floats


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
