"""A pose that its equations give outright, without a search.

Where some gaps are linear in the pose and give the angles of all bodies, and with these angles all gaps are linear in
the places, both follow by one linear system each. There is then no other pose, and what is guessed does not matter:

    F(q) = F(q0) + J (q - q0),        J the same at q0 and at a pose away from it.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from freebody.numeric.jets import Array
from freebody.numeric.placing import TOLERANCE, Fit, Placing, PoseEquation
from freebody.numeric.sparse import SparseRows
from freebody.tolerances import ROUND_OFF

_FEW = 12  # coordinates, for which a search takes no longer
_RCOND = 1e-9  # of what gives nothing
_TURNED, _SHIFTED = 0.7, 0.4  # [rad], [sizes] to a pose away from another, no part of a turn


def given_outright(placing: Placing, q: Array, equations: Sequence[PoseEquation]) -> Array | None:
    """The one pose (n,) of a system in the plane that fulfils its equations, or at which they contradict each other.
    None where a gap is not as linear as that, something is left open, or nothing has to be
    found; and in a very small or large system. q: (n,) any pose."""
    n, turning = len(q), placing.sizes.turning
    if placing.frame.space or n <= _FEW or len(equations) < n:
        return None
    here = placing.fit(q, equations, 0.0, {}, n_steps=0)
    if here is None or here.error <= TOLERANCE or isinstance(here.rows, SparseRows):
        return None
    if turning.any():
        turned = _solved(placing, here, turning, np.ones_like(turning))
        here = None if turned is None else placing.fit(turned, equations, 0.0, {}, n_steps=0)
    return None if here is None else _solved(placing, here, ~turning, ~turning)


def _solved(placing: Placing, here: Fit, unknown: NDArray[np.bool_], free: NDArray[np.bool_]) -> Array | None:
    """The pose in which some coordinates are such that the gaps vanish which hang on these alone. free: those that are
    not known yet; where they are the unknown ones, all gaps have to be linear."""
    sizes, q = placing.sizes, here.q
    # of as many sizes and angles as there are coordinates no two are alike, so that nothing cancels
    apart = 1.0 + np.arange(len(q)) / (1 + len(q))
    step = np.where(free, apart * np.where(sizes.turning, _TURNED, _SHIFTED * sizes.length), 0.0)
    there = placing.fit(q + step, here.equations, 0.0, {}, n_steps=0)
    if there is None:
        return None
    J = here.weights[:, None] * np.asarray(here.rows) * sizes.unit_moves
    is_told = _are_linear(here, there, step) & ~J[:, free & ~unknown].any(axis=1)
    if not (is_told.all() or (free & ~unknown).any()):
        return None
    A = J[is_told][:, unknown]
    x, _rest, rank, _sizes = np.linalg.lstsq(A, -(here.weights * here.gaps)[is_told], rcond=_RCOND)
    if rank < np.count_nonzero(unknown):
        return None
    found = q.copy()
    found[unknown] += sizes.unit_moves[unknown] * x
    return found


def _are_linear(here: Fit, there: Fit, step: Array) -> NDArray[np.bool_]:
    """Of each gap, whether it changes by a step as its gradient says, which stays the same along the coordinates that
    the step changes."""
    J, K = np.asarray(here.rows)[:, step != 0.0], np.asarray(there.rows)[:, step != 0.0]
    along = step[step != 0.0]
    size = np.abs(J) @ np.abs(along) + np.abs(here.gaps) + np.abs(there.gaps)
    is_same = (np.abs(K - J) @ np.abs(along)) <= ROUND_OFF * size
    return is_same & (np.abs(there.gaps - here.gaps - J @ along) <= ROUND_OFF * size)
