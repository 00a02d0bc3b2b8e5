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

from freebody.numeric.kernels.arrays import Floats, Floats2, ModelArrays, Workspace
from freebody.numeric.kernels.declaring import of_either, part
from freebody.numeric.kernels.dynamics import respond
from freebody.numeric.kernels.factoring import BEST_OF_MOTION, IS_REGULARISED, N_LEFT_OUT, N_REDUNDANT, SMALLEST_PIVOT
from freebody.numeric.kernels.guarding import guarded
from freebody.numeric.kernels.measures_planar import BEARING, NEAR
from freebody.numeric.kernels.projecting import is_near_singular, project, slope, store_slope
from freebody.numeric.kernels.stages import between, error_of, interpolant, stages, store_outputs
from freebody.numeric.kernels.stepped_run import (
    ALLOWED,
    BEFORE,
    BEST_PIVOT,
    DONE_STEP,
    END,
    EPSILON,
    ERROR_LARGE,
    EVALUATIONS,
    FIRST,
    IS_CAREFUL,
    IS_WATCHED,
    KEPT,
    LEFT_OUT,
    LONGEST,
    LOOK,
    LOWEST_PIVOT,
    MOVED,
    NEW,
    NOT_FINITE,
    NOT_HELD,
    NOT_STIFF,
    NOW,
    OLD,
    OUTPUTS,
    PAUSED,
    REACHED,
    REGULARISED,
    REJECTED,
    SPEED,
    STEP,
    STEPS,
    STIFF,
    STIFF_FOUND,
    STIFF_STEPS,
    TOO_SMALL,
    TROUBLE,
    SteppedRun,
    Tableau,
    Y,
)

CAREFUL_PIVOT = 1e-2  # below this part of the best pivot met so far, stages are projected too
MOST_ALLOWED = 1e5  # errors of a step, by the tolerance, that are accepted there if nothing else helps
N_OTHER_STEPS = 24  # how often a slightly shorter step is tried to get past a singular pose


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
    is_seen = R.count[IS_WATCHED] > 0 or len(R.kept_clock) > 0
    if is_seen or (has_outputs and R.out_t[R.count[OUTPUTS]] < R.clock[NOW]):
        interpolant(L, S, T, R)
    if has_outputs:
        store_outputs(L, S, R)


@part
def keep(S, R):
    """Copies the last step, with the bearings at its end, into the next row that is free; True if none is left."""
    k, n_terms = R.count[KEPT], len(R.dense)
    for i in range(len(R.states[Y])):
        R.kept_old[k, i] = R.states[OLD][i]
        for j in range(n_terms):
            R.kept_dense[k * n_terms + j, i] = R.dense[j, i]
    for i in range(len(R.clock)):
        R.kept_clock[k, i] = R.clock[i]
    for i in range(len(S.measures)):
        R.kept_near[k, i] = S.measures[i, NEAR]
    R.count[KEPT] = k + 1
    return k + 1 == len(R.kept_clock)


@of_either
def advance(L: ModelArrays, S: Workspace, T: Tableau, R: SteppedRun, max_steps: int) -> int:
    """Makes steps to the end time, or max_steps of them, or one if the run is watched, or as many as can be kept.

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
        is_full = keep(S, R) if len(R.kept_clock) > 0 else False
        if is_full or R.count[IS_WATCHED] > 0:
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
