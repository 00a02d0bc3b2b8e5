"""Bearings followed through a row of states."""

# pyright: basic

from __future__ import annotations

from freebody.numeric.kernels.arrays import Floats, Floats2, ModelArrays, Workspace
from freebody.numeric.kernels.declaring import of_either
from freebody.numeric.kernels.kinematics import kinematics
from freebody.numeric.kernels.measures_planar import BEARING, NEAR
from freebody.numeric.kernels.rotating import framed


@of_either
def follow(L: ModelArrays, S: Workspace, times: Floats, states: Floats2, bearings: Floats2) -> None:
    """(n_times, n_measures) bearings at states y = (q, v, ...), each counted on from the state before."""
    n = len(L.inverse_mass)
    for k in range(len(times)):
        q, v = states[k, :n].reshape((n // 3, 3)), states[k, n : 2 * n].reshape((n // 3, 3))
        framed(S.frames, states[k], 2 * n + 1)
        kinematics(L, S, q, v, times[k])
        for j in range(len(S.measures)):
            S.measures[j, NEAR] = S.measures[j, BEARING]
            bearings[k, j] = S.measures[j, BEARING]
