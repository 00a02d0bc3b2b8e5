"""Families of rests: poses that go over into each other without any load in the way.

Where the stiffness K is singular along a direction, a rest may be one of many (a disk on a level floor, an Atwood
machine with equal weights). Two rests are of one family if a walk from one along its directions without stiffness
leads to the other, every step resting.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from freebody.errors import CannotAnswer
from freebody.numeric.jets import Array

if TYPE_CHECKING:
    from freebody.numeric.rest import CountedPose, LoadBalance, RestFinder

_SOFT = 1e-6  # of the stiffest direction, or of what the loads come to: soft enough to try
_STRIDE, _N_STRIDES = 0.5, 40
_NEAR = 1e-4


def soft_directions(statics: RestFinder, rest: LoadBalance) -> Array:
    """Directions (as columns in q, orthonormal in the metric of the masses) in which a rest has no stiffness."""
    N = rest.split.null
    try:
        K = statics.stiffness(rest)
    except (CannotAnswer, ArithmeticError, ValueError):
        return N[:, :0]
    far = max((float(statics.reference.sizes.relative(x).max()) for x in N.T), default=0.0)
    _U, sizes, Vt = np.linalg.svd(K)
    soft = sizes <= _SOFT * (float(sizes.max(initial=0.0)) + rest.scale * far)
    return N @ Vt[soft].T


def goes_on(statics: RestFinder, rest: LoadBalance, direction: Array) -> bool:
    """Whether rests go on both ways along a direction, by a fiftieth of the size."""
    step = direction * (0.02 / float(statics.reference.sizes.relative(direction).max()))
    for sense in (1.0, -1.0):
        there = statics.moved(rest.pose, sense * step)
        near = None if there is None else statics.rest_near(there)
        if near is None or statics.apart(near.pose, rest.pose) < 0.01:
            return False
    return True


def is_one_family(statics: RestFinder, a: LoadBalance, b: LoadBalance) -> bool:
    """Whether a walk over rests leads from a to b."""
    D, relative = statics.reference.sizes.small_moves, statics.reference.sizes.relative
    here, before = a, statics.apart(b.pose, a.pose)
    for _ in range(_N_STRIDES):
        soft = soft_directions(statics, here)
        if not soft.shape[1]:
            return False
        step = soft @ (soft.T @ (statics.difference(b.pose, here.pose) / D**2))
        size = float(relative(step).max(initial=0.0))
        if size == 0.0:
            return False
        # first the whole way, which a straight family allows; then in strides
        for part in (1.0, min(1.0, _STRIDE / size)):
            there = statics.moved(here.pose, part * step)
            near = None if there is None else statics.rest_near(there)
            left = np.inf if near is None else statics.apart(b.pose, near.pose)
            if left < _NEAR:
                return True
            if near is not None and left < 0.95 * before:
                here, before = near, left
                break
        else:
            return False
    return False


def nearest_of_family(statics: RestFinder, rest: LoadBalance, pose: CountedPose) -> LoadBalance:
    """Of the family of a rest the one nearest to a pose, as far as one step leads to it; else the rest itself."""
    soft = soft_directions(statics, rest)
    D = statics.reference.sizes.small_moves
    step = soft @ (soft.T @ (statics.difference(pose, rest.pose) / D**2))
    if float(statics.reference.sizes.relative(step).max(initial=0.0)) < _NEAR:
        return rest
    there = statics.moved(rest.pose, step)
    near = None if there is None else statics.rest_near(there)
    if near is None:
        return rest
    before, after = (float(np.linalg.norm(statics.difference(b.pose, pose) / D)) for b in (rest, near))
    return near if after < before else rest
