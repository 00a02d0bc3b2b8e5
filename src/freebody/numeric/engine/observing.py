"""Rows along a motion: values, rates and accelerations of what is watched."""

# pyright: basic

import numpy as np

from freebody.numeric.engine.dynamics import BIAS, DRIFT, VALUE, along, kinematics
from freebody.numeric.engine.either import of_either
from freebody.numeric.engine.measures_planar import BEARING, NEAR
from freebody.numeric.engine.rotating import framed

_TABLE, _LIST = np.zeros((1, 1)), np.zeros(1)


@of_either(_LIST, _TABLE, _TABLE, _TABLE, _TABLE, _TABLE)
def observe(L, S, times, states, accelerations_of, values, rates, seconds):
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
