"""Bearings followed through a row of states."""

# pyright: basic

import numpy as np

from freebody.numeric.engine.dynamics import kinematics
from freebody.numeric.engine.either import of_either
from freebody.numeric.engine.measures_planar import BEARING, NEAR
from freebody.numeric.engine.rotating import framed

SOURCES = ("following",)
_TABLE, _LIST = np.zeros((1, 1)), np.zeros(1)


@of_either(_LIST, _TABLE, _TABLE, more=SOURCES)
def follow(L, S, times, states, bearings):
    """(n_times, n_measures) bearings at states y = (q, v, ...), each counted on from the state before."""
    n = len(L.inverse_mass)
    for k in range(len(times)):
        q, v = states[k, :n].reshape((n // 3, 3)), states[k, n : 2 * n].reshape((n // 3, 3))
        framed(S.frames, states[k], 2 * n + 1)
        kinematics(L, S, q, v, times[k])
        for j in range(len(S.measures)):
            S.measures[j, NEAR] = S.measures[j, BEARING]
            bearings[k, j] = S.measures[j, BEARING]
