"""The slope of a state, and the nearest state that holds what is held.

Positions q move by the least in the metric of the masses, and v loses what is not held, until both gaps are round-off.
Near a singular pose the slope of a stage is that of the state so projected: stages are off by a low power of the step,
which the inverse of the smallest pivot would enlarge.
Source: Hairer & Wanner, Solving Ordinary Differential Equations II, 1996, sec. VII.2.
"""

# pyright: basic

from __future__ import annotations

import math

from freebody.numeric.kernels.closing import closed, gaps
from freebody.numeric.kernels.declaring import kernel, part
from freebody.numeric.kernels.dynamics import accelerations, power, respond
from freebody.numeric.kernels.factoring import N_LEFT_OUT, SMALLEST_PIVOT, factored
from freebody.numeric.kernels.kinematics import kinematics
from freebody.numeric.kernels.rotating import absorbed, framed, normalised, rates
from freebody.numeric.kernels.stepped_run import (
    BEST_PIVOT,
    EPSILON,
    EVALUATIONS,
    IS_CAREFUL,
    LEFT_OUT,
    LOWEST_PIVOT,
    MOTION_GAP,
    PLACE_GAP,
    SPEED,
)

N_PROJECTIONS = 8
N_TOGETHER = 3  # of these, in which places and motion are closed together
NEAR_PIVOT = 1e-5  # below this part of it, no step should end


@part
def slope(L, S, y, t, out):
    n = len(L.inverse_mass)
    q, v = y[:n].reshape((n // 3, 3)), y[n : 2 * n].reshape((n // 3, 3))
    framed(S.frames, y, 2 * n + 1)
    accelerations(L, S, q, v, t)
    store_slope(L, S, y, out)


@part
def store_slope(L, S, y, out):
    n = len(L.inverse_mass)
    for i in range(n):
        out[i] = y[n + i]
        out[n + i] = S.acceleration[i]
    out[2 * n] = power(L, S)
    rates(S.frames, y, n, 2 * n + 1, out)


@kernel
def project(L, S, clock, count, unit, y, t):
    """Closes the gaps of a state; True if that succeeds. Kinematics are those of the state then."""
    n = len(unit)
    q, v = y[:n].reshape((n // 3, 3)), y[n : 2 * n].reshape((n // 3, 3))
    normalised(S.frames, y, 2 * n + 1)
    # how small gaps must become
    size = 1.0
    for i in range(n):
        size = max(size, abs(y[i]) / unit[i])
    place_enough = 3e-14 + 4.0 * EPSILON * size
    motion_enough = 1e-13 * clock[SPEED] + 1e-15
    if count[IS_CAREFUL] > 0:
        place_enough, motion_enough = EPSILON * size, 2.0 * EPSILON * clock[SPEED]
    last_place, last_motion = math.inf, math.inf
    for attempt in range(N_PROJECTIONS):
        framed(S.frames, y, 2 * n + 1)
        kinematics(L, S, q, v, t)
        place, motion = gaps(L, S, y[n : 2 * n])
        if not (place < math.inf and motion < math.inf):
            return False
        enough = place <= place_enough and motion <= motion_enough
        stuck = place >= 0.5 * last_place and motion >= 0.5 * last_motion
        if attempt > N_TOGETHER:
            # rows that say the same thing may leave a gap of places that none can close, while that of motion goes on
            # to vanish: then each of the two is enough, or stuck, for itself
            is_placed = place <= place_enough or place >= 0.5 * last_place
            stuck = is_placed and (motion <= motion_enough or motion >= 0.5 * last_motion)
        if enough or stuck:
            if place > 1e-10 * size or motion > 1e-8 * clock[SPEED] + 1e-9:
                return False
            clock[PLACE_GAP], clock[MOTION_GAP] = place, motion
            return True
        if place > 1e4 * last_place and attempt > 1:
            return False
        last_place, last_motion = place, motion
        factored(L, S)
        closed(L, S, y[:n], y[n : 2 * n])
        absorbed(S.frames, y, 2 * n + 1)
    return False


@part
def is_near_singular(S, R):
    """True if rows nearly depend on each other that do not do so always."""
    return S.info[SMALLEST_PIVOT] < NEAR_PIVOT * R.clock[BEST_PIVOT] or S.info[N_LEFT_OUT] > R.count[LEFT_OUT]


@kernel
def slope_held(L, S, clock, count, unit, held, y, t, out):
    """The slope of a stage. Near a singular pose it is that of the nearest state that holds what is held: stages are
    off by a low power of the step, and there that would be enlarged by the inverse of the smallest pivot."""
    count[EVALUATIONS] += 1
    if count[IS_CAREFUL] > 0:
        for i in range(len(y)):
            held[i] = y[i]
        if project(L, S, clock, count, unit, held, t):
            respond(L, S, t)
            store_slope(L, S, held, out)
            clock[LOWEST_PIVOT] = min(clock[LOWEST_PIVOT], S.info[SMALLEST_PIVOT])
            return
    slope(L, S, y, t, out)
    clock[LOWEST_PIVOT] = min(clock[LOWEST_PIVOT], S.info[SMALLEST_PIVOT])
