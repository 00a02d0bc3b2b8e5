"""Rows along a motion: values, rates and accelerations of what is watched."""

# pyright: basic

from __future__ import annotations

from freebody.numeric.kernels.arrays import Floats, Floats2, ModelArrays, Workspace
from freebody.numeric.kernels.declaring import of_either
from freebody.numeric.kernels.kinematics import BIAS, DRIFT, VALUE, along, kinematics
from freebody.numeric.kernels.measures_planar import BEARING, NEAR
from freebody.numeric.kernels.rotating import framed


@of_either
def observe(
    L: ModelArrays,
    S: Workspace,
    times: Floats,
    states: Floats2,
    accelerations_of: Floats2,
    values: Floats2,
    rates: Floats2,
    seconds: Floats2,
) -> None:
    """(n_times, n_rows) values, rates and second derivatives of all rows along states y = (q, v, ...)."""
    n = accelerations_of.shape[1]
    for k in range(len(times)):
        q, v = states[k, :n].reshape((n // 3, 3)), states[k, n : 2 * n].reshape((n // 3, 3))
        framed(S.frames, states[k], 2 * n + 1)
        kinematics(L, S, q, v, times[k])
        for j in range(len(S.measures)):
            S.measures[j, NEAR] = S.measures[j, BEARING]
        a = accelerations_of[k].reshape((n // 3, 3))
        for r in range(values.shape[1]):
            values[k, r] = S.rows[r, VALUE]
            rates[k, r] = along(L, S, r, v) + S.rows[r, DRIFT]
            seconds[k, r] = along(L, S, r, a) + S.rows[r, BIAS]
