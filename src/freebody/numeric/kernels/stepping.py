"""Explicit steps with projection: one loop for every tableau.

The state is y = (q, v, W, r): positions and velocities of all bodies (the fixed one last), the work done by loads
without a potential and by drivers, and in space the quaternions of the bodies' rotations. A step advances
y' = (v, a, P, r'); then q and r move to the nearest pose, in the metric of the masses, that holds what is held, and v
loses what does not. Errors count by the size of the motion: positions in
parts of the system's length and angles in radians, or in parts of the largest move so far where that is less;
velocities in parts of the largest speed met so far (in lengths or radians a second).
Source: Hairer, Norsett & Wanner, Solving Ordinary Differential Equations I, 1993, sec. II.4 to II.6; Hairer & Wanner,
II, 1996, sec. IV.2 (stiffness) and VII.2 (projection).
"""

# pyright: basic

from __future__ import annotations

import math
from typing import NamedTuple

from freebody.numeric.kernels.arrays import Floats, Floats2, Ints, ModelArrays, Workspace
from freebody.numeric.kernels.declaring import kernel, of_either, part
from freebody.numeric.kernels.dynamics import (
    BEST_OF_MOTION,
    IS_REGULARISED,
    N_LEFT_OUT,
    N_REDUNDANT,
    SMALLEST_PIVOT,
    accelerations,
    closed,
    factored,
    gaps,
    guarded,
    kinematics,
    power,
    respond,
)
from freebody.numeric.kernels.measures_planar import BEARING, NEAR
from freebody.numeric.kernels.rotating import absorbed, framed, normalised, rates

# -- what a run is about ----------------------------------------------------------------------
N_CLOCK = 16
(
    NOW,
    STEP,
    END,
    TOLERANCE,
    SPEED,
    LONGEST,
    PLACE_GAP,
    MOTION_GAP,
    BEFORE,
    DONE_STEP,
    BEST_PIVOT,
    LOWEST_PIVOT,
    ALLOWED,
    MOVED,
) = range(14)
N_COUNT = 12
(
    STEPS,
    EVALUATIONS,
    REJECTED,
    OUTPUTS,
    REGULARISED,
    IS_WATCHED,
    STIFF,
    NOT_STIFF,
    DENSE_READY,
    TROUBLE,
    IS_CAREFUL,
    LEFT_OUT,
) = range(12)

# what `advance` returns
REACHED, PAUSED, LOOK, TOO_SMALL, STIFF_FOUND = 0, 1, 2, 3, 4
STIFF_STEPS = 15  # so many whose size stability bounds are taken for stiffness
# what was in the way of the last step (`TROUBLE`)
NOTHING, ERROR_LARGE, NOT_FINITE, NOT_HELD = 0, 1, 2, 3

Y, OLD, NEW, STAGE, HELD, FIRST = range(6)  # rows of `Run.states`

EPSILON = 2.220446049250313e-16
N_PROJECTIONS = 8
N_TOGETHER = 3  # of these, in which places and motion are closed together
CAREFUL_PIVOT = 1e-2  # below this part of the best pivot met so far, stages are projected too
MOST_ALLOWED = 1e5  # errors of a step, by the tolerance, that are accepted there if nothing else helps
NEAR_PIVOT = 1e-5  # below this part of it, no step should end
N_OTHER_STEPS = 24  # how often a slightly shorter step is tried to get past a singular pose


class Tableau(NamedTuple):
    """An explicit Runge-Kutta method in arrays (`engine.tableaus`)."""

    a: Floats2  # (n + extra + 1, n + extra + 1)
    c: Floats
    b: Floats
    error: Floats2  # (2, n + 1): the second row is zero if there is one embedded formula only
    dense: Floats2  # (n_terms, n + extra + 1)
    sizes: Ints  # number of stages, extra stages, order, is adaptive, error needs the slope at the new point


class SteppedRun(NamedTuple):
    """A motion under way."""

    clock: Floats
    count: Ints
    states: (
        Floats2  # (6, n_y): the state, that before the last step, the new one, a stage, that as it is held, the start
    )
    slopes: Floats2  # (stages, len(y)); the first is that of y
    dense: Floats2  # (terms, len(y)) of the last step
    unit: Floats  # size of every entry of q: a length or a radian
    multiplier: Floats  # at y
    out_t: Floats
    out_y: Floats2
    out_a: Floats2
    out_multiplier: Floats2


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


@part
def error_of(T, R, h):
    """The estimated error of a step, 1 where it is what is allowed; NaN if it is not finite. A turn by an angle changes
    a quaternion by half of it."""
    n = len(R.unit)
    n_slopes = T.error.shape[1]
    fastest = 0.0
    for i in range(n):
        fastest = max(fastest, abs(R.slopes[0, n + i]) / R.unit[i])
    speed = max(R.clock[SPEED], h * fastest)
    moved = min(1.0, max(R.clock[MOVED], h * speed))
    first, second = 0.0, 0.0
    for i in range(len(R.states[Y])):
        if i == 2 * n:
            continue
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


@part
def look_for_stiffness(T, R, h):
    """Counts steps whose size seems to be bounded by stability: h |df/dy| between the last stage and the new value."""
    n_stages = T.sizes[0]
    n = len(R.unit)
    above, below = 0.0, 0.0
    for i in range(n):
        u = R.unit[i]
        d = (R.slopes[n_stages, n + i] - R.slopes[n_stages - 1, n + i]) / u
        e = (R.states[NEW][n + i] - R.states[OLD][n + i]) / u
        above += d * d
        below += e * e
        x = (R.states[NEW][i] - R.states[OLD][i]) / u
        below += x * x / (h * h)
    for i in range(2 * n + 1, len(R.states[Y])):
        x = 2.0 * (R.states[NEW][i] - R.states[OLD][i])
        below += x * x / (h * h)
    bound = 6.1 if T.sizes[2] >= 8 else 3.25
    if below > 0.0 and h * math.sqrt(above / below) > bound:
        R.count[NOT_STIFF] = 0
        R.count[STIFF] += 1
    else:
        R.count[NOT_STIFF] += 1
        if R.count[NOT_STIFF] >= 6:
            R.count[STIFF] = 0


@part
def accept(S, R, h):
    """The new value becomes the state."""
    n = len(R.unit)
    speed = R.clock[SPEED]
    for i in range(len(R.states[Y])):
        R.states[OLD][i] = R.states[Y][i]
        R.states[Y][i] = R.states[NEW][i]
    moved = R.clock[MOVED]
    for i in range(n):
        speed = max(speed, abs(R.states[Y][n + i]) / R.unit[i])
        moved = max(moved, abs(R.states[Y][i] - R.states[FIRST][i]) / R.unit[i])
    for i in range(2 * n + 1, len(R.states[Y])):
        moved = max(moved, 2.0 * abs(R.states[Y][i] - R.states[FIRST][i]))
    R.clock[SPEED], R.clock[MOVED] = speed, moved
    for k in range(len(S.measures)):
        S.measures[k, NEAR] = S.measures[k, BEARING]
    for r in range(len(S.multiplier)):
        R.multiplier[r] = S.multiplier[r]
    R.clock[BEFORE] = R.clock[NOW]
    R.clock[DONE_STEP] = h
    R.count[STEPS] += 1


@part
def try_step(L, S, T, R, t, h, allowed):
    """A step of length h from t: its error by the tolerance, and whether what is held could be closed at its end, with
    the slope there."""
    needs_new = T.sizes[4] > 0
    R.clock[LOWEST_PIVOT] = 1.0
    stages(L, S, T, R, t, h)
    error = error_of(T, R, h) if T.sizes[3] > 0 and not needs_new else 0.0
    is_held = error <= allowed and project(L, S, R.clock, R.count, R.unit, R.states[NEW], t + h)
    if is_held:
        respond(L, S, t + h)
        store_slope(L, S, R.states[NEW], R.slopes[T.sizes[0]])
        R.count[EVALUATIONS] += 1
        if needs_new:
            error = error_of(T, R, h)
        for i in range(len(R.states[Y])):
            if not abs(R.slopes[T.sizes[0], i]) < math.inf:
                error = math.nan
    return error, is_held


@part
def shortened(T, R, h, error, allowed):
    """The next length to try, h err^(-1/p) with the error err and the order p of the method; why goes to the count."""
    if error > allowed:
        R.count[TROUBLE] = ERROR_LARGE
        return h * max(0.2, 0.9 * error ** (-1.0 / T.sizes[2])) if error < math.inf else h * 0.2
    R.count[TROUBLE] = NOT_HELD if error <= allowed else NOT_FINITE
    return h * 0.25


# What is left out, or regularised, is decided by the best pivot of the motion: a pivot far below it belongs to a
# singular pose, in whose neighbourhood stages are projected too (`IS_CAREFUL`).
@part
def remember_pivots(S, R):
    """The best pivot of the motion and what was left out at it, after a step."""
    if S.info[IS_REGULARISED] > 0.0:
        R.count[REGULARISED] += 1
    R.clock[BEST_PIVOT] = max(R.clock[BEST_PIVOT], S.info[SMALLEST_PIVOT])
    R.count[LEFT_OUT] = min(R.count[LEFT_OUT], int(S.info[N_LEFT_OUT]))
    S.info[N_REDUNDANT], S.info[BEST_OF_MOTION] = R.count[LEFT_OUT], R.clock[BEST_PIVOT]
    R.count[IS_CAREFUL] = 1 if S.info[SMALLEST_PIVOT] < CAREFUL_PIVOT * R.clock[BEST_PIVOT] else 0


@part
def choose_next(T, R, h, error, was_rejected, is_last):
    """The length of the next step, h err^(-1/p) within bounds: no longer after a rejection; a last step that was cut
    short says nothing against longer ones."""
    growth = 5.0 if error == 0.0 else min(5.0, 0.9 * error ** (-1.0 / T.sizes[2]))
    if was_rejected:
        growth = min(1.0, growth)
    if not (is_last and growth * h < R.clock[STEP]):
        R.clock[STEP] = h * max(0.2, growth)


@part
def show(L, S, T, R):
    """The dense output of the step, if it is looked at, and the outputs that lie in it."""
    has_outputs = R.count[OUTPUTS] < len(R.out_t) and R.out_t[R.count[OUTPUTS]] <= R.clock[NOW]
    if R.count[IS_WATCHED] > 0 or (has_outputs and R.out_t[R.count[OUTPUTS]] < R.clock[NOW]):
        interpolant(L, S, T, R)
    if has_outputs:
        store_outputs(L, S, R)


@of_either
def advance(L: ModelArrays, S: Workspace, T: Tableau, R: SteppedRun, max_steps: int) -> int:
    """Makes steps to the end time, or max_steps of them, or one if the run is watched.

    A step is tried until its error is allowed, what is held can be closed at its end, and it does not end next to a
    singular pose. There slightly different steps are tried first (`n_others`), and errors may be ten times as large
    whenever none of these will do; elsewhere the step is shortened."""
    is_adaptive = T.sizes[3] > 0
    for _ in range(max_steps):
        t = R.clock[NOW]
        left = R.clock[END] - t
        if left <= 0.0:
            return REACHED
        h = min(R.clock[STEP], R.clock[LONGEST])
        was_rejected, n_others, allowed, wanted = False, 0, 1.0, h
        while True:
            if h < 16.0 * EPSILON * max(abs(t), abs(R.clock[END])):
                return TOO_SMALL
            is_last = h >= left * (1.0 - 1e-12)
            if is_last:
                h = left
            elif 2.0 * h > left and is_adaptive:
                h = 0.5 * left  # two equal steps instead of one and a tiny one
            error, is_held = try_step(L, S, T, R, t, h, allowed)
            is_near = is_held and is_near_singular(S, R)
            may_differ = is_adaptive and n_others < N_OTHER_STEPS
            if is_held and error <= allowed and not (is_near and may_differ and not is_last):
                break
            R.count[REJECTED] += 1
            if not is_adaptive:
                R.count[TROUBLE] = NOT_HELD if error == 0.0 else NOT_FINITE
                return TOO_SMALL
            was_rejected = True
            if may_differ and (is_near or R.clock[LOWEST_PIVOT] < CAREFUL_PIVOT * R.clock[BEST_PIVOT]):
                # stages next to a singular pose spoil a step; a slightly different one misses it, a short one does not
                n_others += 1
                if R.count[IS_CAREFUL] > 0 or is_near:
                    h *= 0.93
                R.count[IS_CAREFUL] = 1
                if n_others == N_OTHER_STEPS and allowed < MOST_ALLOWED:
                    n_others, allowed, h = 0, 10.0 * allowed, wanted
                continue
            h = shortened(T, R, h, error, allowed)
        R.clock[ALLOWED] = max(R.clock[ALLOWED], allowed)
        remember_pivots(S, R)
        if is_adaptive:
            look_for_stiffness(T, R, h)
            choose_next(T, R, h, error, was_rejected, is_last)
        accept(S, R, h)
        R.clock[NOW] = R.clock[END] if is_last else t + h
        show(L, S, T, R)
        for i in range(len(R.states[Y])):
            R.slopes[0, i] = R.slopes[T.sizes[0], i]
        if R.count[IS_WATCHED] > 0:
            return LOOK
        if R.count[STIFF] >= STIFF_STEPS:
            return STIFF_FOUND
    return REACHED if R.clock[NOW] >= R.clock[END] else PAUSED


@of_either
def visit(
    L: ModelArrays, S: Workspace, R: SteppedRun, s: float, y: Floats, t: float, out: Floats, n_times: int
) -> bool:
    """The slope of a state: that at the part s of the last step, or, for s < 0, of y as it is. Its rows, accelerations
    and multipliers stand in `S`. The gaps of the state are closed before; with n_times > 0 they are not, and the slope
    is found that many times. False if the gaps cannot be closed."""
    if s >= 0.0:
        between(R, s, y)
    if n_times == 0 and not project(L, S, R.clock, R.count, R.unit, y, t):
        return False
    for _ in range(max(1, n_times)):
        slope(L, S, y, t, out)
    return True


@of_either
def patrol(
    L: ModelArrays,
    S: Workspace,
    R: SteppedRun,
    parts: Floats,
    t: float,
    y: Floats,
    values: Floats2,
    rates: Floats2,
    sizes: Floats2,
) -> None:
    """What is guarded at parts of the last step (after a negative part, at the state y and the time t as they are): one
    row of values, rates and sizes for each."""
    for j in range(len(parts)):
        if parts[j] >= 0.0:
            between(R, parts[j], y)
            t = R.clock[BEFORE] + parts[j] * R.clock[DONE_STEP]
        project(L, S, R.clock, R.count, R.unit, y, t)
        respond(L, S, t)
        guarded(L, S, t, values[j], rates[j], sizes[j])
