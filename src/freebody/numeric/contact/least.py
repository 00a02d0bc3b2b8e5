"""The shortest vector in a polyhedron.

    min |y| with G y >= h:    u >= 0 minimises |E u - f|, E = (G, h)^T, f = (0, .., 0, 1);  r = E u - f;  y = -r_1/r_2

where r_2 is the last entry of r; r = 0 says that nothing satisfies the inequalities.
Source: Lawson & Hanson, Solving Least Squares Problems (1974), ch. 23 (LDP).
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from freebody.numeric.solvers import optimize
from freebody.tolerances import ROUND_OFF, ROUNDED

Array = NDArray[np.float64]

_FAR = 1e-7  # what is left of the unit vector: no y is as long as one over this


def least_within(G: Array, h: Array) -> Array | None:
    """The shortest y (k,) with G y >= h, G (m, k), or None if there is none, or none shorter than about 1e7."""
    lengths: Array = np.sqrt((G * G).sum(axis=1))
    moving = lengths > ROUNDED
    if bool((h[~moving] > ROUND_OFF).any()):
        return None
    directions, offsets = G[moving] / lengths[moving, None], h[moving] / lengths[moving]
    if bool((offsets <= 0.0).all()):
        nowhere: Array = np.zeros(len(G.T))
        return nowhere
    E = np.vstack([directions.T, offsets])
    f = np.zeros(len(E))
    f[-1] = 1.0
    try:
        u = np.array(optimize().nnls(E, f)[0], dtype=np.float64)
    except RuntimeError:  # too many iterations
        return None
    r = E @ u - f
    if float(np.linalg.norm(r)) < _FAR or r[-1] == 0.0:
        return None
    y = -r[:-1] / r[-1]
    # the inequalities that hold y back are met exactly
    tight = u > ROUNDED * float(u.max())
    left_over = offsets[tight] - directions[tight] @ y
    return y + np.asarray(np.linalg.lstsq(directions[tight], left_over, rcond=ROUNDED)[0], dtype=np.float64)
