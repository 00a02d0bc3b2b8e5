"""One step of a Runge-Kutta method by its tableau: its stages, its error, and the dense output.

With k_i the slopes of the stages, y+ = y + h sum of b_i k_i; the error is h times another such sum, and between the
ends the state is a polynomial in the part s of the step, nested by s and 1 - s in turn.
Source: Hairer, Norsett & Wanner, Solving Ordinary Differential Equations I, 1993, sec. II.4 to II.6.
"""

# pyright: basic

from __future__ import annotations

import math

from freebody.numeric.kernels.declaring import kernel, part
from freebody.numeric.kernels.dynamics import respond
from freebody.numeric.kernels.projecting import project, slope_held
from freebody.numeric.kernels.stepped_run import (
    BEFORE,
    DONE_STEP,
    EPSILON,
    HELD,
    MOTION_GAP,
    MOVED,
    NEW,
    NOW,
    OLD,
    OUTPUTS,
    PLACE_GAP,
    SPEED,
    STAGE,
    TOLERANCE,
    Y,
)

STRAYED, GROSS = 10.0, 0.5  # by the range of the other slopes of an entry, and by the largest acceleration of all


@part
def strays(T, R, h):
    """Whether a stage that no sum of the step weighs has an acceleration far beyond those of the others. It is then
    alone in having met another law, as behind a border over which the step leads: what the stage does to the later ones
    may throw them back again, and neither the new state nor its error knows of it."""
    n = len(R.unit)
    largest = 0.0
    for j in range(T.sizes[0]):
        if j == 0 or T.error[0, j] != 0.0 or T.error[1, j] != 0.0:
            for i in range(n):
                largest = max(largest, abs(R.slopes[j, n + i]) / R.unit[i])
    for i in range(n):
        lowest = highest = R.slopes[0, n + i]
        least = most = lowest
        for j in range(1, T.sizes[0]):
            x = R.slopes[j, n + i]
            if T.error[0, j] != 0.0 or T.error[1, j] != 0.0:
                lowest, highest = min(lowest, x), max(highest, x)
            else:
                least, most = min(least, x), max(most, x)
        beyond = max(most - highest, lowest - least) - STRAYED * (highest - lowest)
        if beyond > GROSS * largest * R.unit[i] and h * beyond > R.clock[TOLERANCE] * R.unit[i] * R.clock[SPEED]:
            return True
    return False


@part
def error_of(T, R, h):
    """The estimated error of a step, 1 where it is what is allowed; NaN if it is not finite. A turn by an angle changes
    a quaternion by half of it."""
    n = len(R.unit)
    n_slopes = T.error.shape[1]
    fastest = 0.0
    for i in range(n):
        fastest = max(fastest, abs(R.slopes[0, n + i]) / R.unit[i])
    # by the largest speed and the largest move so far
    speed = max(R.clock[SPEED], h * fastest)
    moved = min(1.0, max(R.clock[MOVED], h * speed))
    first, second = 0.0, 0.0
    for i in range(len(R.states[Y])):
        if i == 2 * n:
            continue
        # both estimates of an entry, by what is allowed of it
        e1, e2 = 0.0, 0.0
        for j in range(n_slopes):
            e1 += T.error[0, j] * R.slopes[j, i]
            e2 += T.error[1, j] * R.slopes[j, i]
        scale = R.clock[TOLERANCE]
        if i < n:
            scale *= R.unit[i] * moved
        elif i < 2 * n:
            scale *= R.unit[i - n] * speed
        else:
            scale *= 0.5 * moved
        scale += 4.0 * EPSILON * abs(R.states[Y][i])
        if scale > 0.0:
            e1, e2 = abs(e1) / scale, abs(e2) / scale
            if not e1 <= first:
                first = e1
            if not e2 <= second:
                second = e2
    if strays(T, R, h):
        return math.inf
    if second > 0.0:
        return h * first * first / math.sqrt(first * first + 0.01 * second * second)
    return h * first


@part
def stages(L, S, T, R, t, h):
    """Slopes at the stages of a step, and the new value."""
    n_stages, n_y = T.sizes[0], len(R.states[Y])
    for s in range(1, n_stages + 1):
        out = R.states[STAGE] if s < n_stages else R.states[NEW]
        if s == n_stages:
            for i in range(n_y):
                R.states[OLD][i] = R.states[STAGE][i]  # the last stage is needed to see stiffness
        for i in range(n_y):
            out[i] = 0.0
        for j in range(s):
            a = T.a[s, j]
            if a != 0.0:
                for i in range(n_y):
                    out[i] += a * R.slopes[j, i]
        for i in range(n_y):
            out[i] = R.states[Y][i] + h * out[i]
        if s < n_stages:
            slope_held(L, S, R.clock, R.count, R.unit, R.states[HELD], out, t + T.c[s] * h, R.slopes[s])


@part
def interpolant(L, S, T, R):
    """The terms of the dense output of the last step."""
    n_stages, n_extra, n_y = T.sizes[0], T.sizes[1], len(R.states[Y])
    t, h = R.clock[BEFORE], R.clock[DONE_STEP]
    # stages that only the dense output needs
    for s in range(n_stages + 1, n_stages + 1 + n_extra):
        for i in range(n_y):
            R.states[STAGE][i] = 0.0
        for j in range(s):
            a = T.a[s, j]
            if a != 0.0:
                for i in range(n_y):
                    R.states[STAGE][i] += a * R.slopes[j, i]
        for i in range(n_y):
            R.states[STAGE][i] = R.states[OLD][i] + h * R.states[STAGE][i]
        slope_held(L, S, R.clock, R.count, R.unit, R.states[HELD], R.states[STAGE], t + T.c[s] * h, R.slopes[s])
    # values and slopes at both ends (Hermite), then what the slopes of the stages add
    for i in range(n_y):
        change = R.states[Y][i] - R.states[OLD][i]
        R.dense[0, i] = change
        R.dense[1, i] = h * R.slopes[0, i] - change
        R.dense[2, i] = 2.0 * change - h * (R.slopes[0, i] + R.slopes[n_stages, i])
    for k in range(len(T.dense)):
        for i in range(n_y):
            R.dense[3 + k, i] = 0.0
        for j in range(n_stages + 1 + n_extra):
            d = T.dense[k, j]
            if d != 0.0:
                for i in range(n_y):
                    R.dense[3 + k, i] += h * d * R.slopes[j, i]


@kernel
def between(R, s, out):
    """The state at the part s of the last step, by its dense output."""
    for i in range(len(out)):
        out[i] = 0.0
    for k in range(len(R.dense) - 1, -1, -1):
        factor = s if k % 2 == 0 else 1.0 - s
        for i in range(len(out)):
            out[i] = (out[i] + R.dense[k, i]) * factor
    for i in range(len(out)):
        out[i] += R.states[OLD][i]


@part
def store_outputs(L, S, R):
    """Fills the output times that the last step passed."""
    k = R.count[OUTPUTS]
    while k < len(R.out_t) and R.out_t[k] <= R.clock[NOW]:
        t, y = R.out_t[k], R.out_y[k]
        if t >= R.clock[NOW]:
            for i in range(len(y)):
                y[i] = R.states[Y][i]
        else:
            between(R, (t - R.clock[BEFORE]) / R.clock[DONE_STEP], y)
        held = R.clock[PLACE_GAP], R.clock[MOTION_GAP]
        project(L, S, R.clock, R.count, R.unit, y, t)
        R.clock[PLACE_GAP], R.clock[MOTION_GAP] = max(held[0], R.clock[PLACE_GAP]), max(held[1], R.clock[MOTION_GAP])
        respond(L, S, t)
        for i in range(len(S.acceleration)):
            R.out_a[k, i] = S.acceleration[i]
        for r in range(len(S.multiplier)):
            R.out_multiplier[k, r] = S.multiplier[r]
        k += 1
    R.count[OUTPUTS] = k
