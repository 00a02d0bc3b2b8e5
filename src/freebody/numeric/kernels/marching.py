"""Steps of the Moreau-Jean scheme with theta = 1/2.

    q_m = q + h/2 v                                   gaps and all gradients are those of this pose
    M (v+ - v) = h Q(q_m) + H^T P_held + J^T P        impulses by `blocks`, held rows eliminated
    q+ = q + h/2 (v + v+)                             then held rows are closed

What holds at the end of the step is asked of u+ = J v+ + h/2 (J' v), J that of the middle. Without contact this is the
midpoint rule. A resting body has v = 0 and v+ = 0, so it stays where it is, exactly. The energy changes by
P . (u + u+)/2 and the work of loads: not positive for lasting contacts.

A contact that closes without restitution is stopped where its gap is closed, not after: gap + h u+ >= 0, with
q+ = q + h v+ for the bodies of which that is asked; their energy changes by P . u+ - |v+ - v|^2_M / 2 < 0. One with
restitution is taken when its gap at the middle is closed: u+ = -e u, and several at once can add energy by Newton's
law; then the step is done without restitution.
Source: Moreau, in Nonsmooth Mechanics and Applications, 1988; Jean, Comput. Methods Appl. Mech. Engrg. 177 (1999) 235;
Stewart & Trinkle, Int. J. Numer. Meth. Engrg. 39 (1996) 2673 (gaps at the end of the step).
"""

# pyright: basic

from __future__ import annotations

import math

from freebody.numeric.kernels.arrays import Floats2, ModelArrays, Workspace
from freebody.numeric.kernels.blocks import correct
from freebody.numeric.kernels.candidates import Candidates
from freebody.numeric.kernels.closing import closed, gaps
from freebody.numeric.kernels.declaring import entry, kernel
from freebody.numeric.kernels.dynamics import loads
from freebody.numeric.kernels.exchange import exchange, hold_velocities, move
from freebody.numeric.kernels.factoring import POWER_OF_LOADS, factored
from freebody.numeric.kernels.fixture_rows import add_bounds, add_dry_friction
from freebody.numeric.kernels.kinematics import DRIFT, GOAL, GOAL_RATE, kinematics
from freebody.numeric.kernels.march import (
    ACCELERATION,
    DEEPEST,
    DONE,
    FASTEST,
    FULL,
    LOSS,
    MOST_CLOSED,
    NOT_FINITE,
    NOT_HELD,
    NOW,
    PLACE_GAP,
    REBUILD,
    SKIN,
    SLOP,
    STEP,
    STEPS,
    WORK,
    March,
)
from freebody.numeric.kernels.measures_planar import BEARING, NEAR, measure
from freebody.numeric.kernels.responses import add_responses
from freebody.numeric.kernels.rows import ClosedRows, Fixtures
from freebody.numeric.kernels.sites import add_candidates, gap_of, is_within
from freebody.numeric.kernels.turning import turned

N_CORRECTED = 5  # sweeps that close gaps
N_PLACED = 8


@kernel
def has_moved(R):
    """True if something may leave the margin of the candidates within the next step."""
    h, allowed = R.clock[STEP], 0.5 * R.clock[SKIN]
    for k in range(len(R.circle_body)):
        b = R.circle_body[k]
        # within a step a centre moves by h (|v| + |w| |offset|) at most, and gravity adds to that
        reach = abs(R.circle[k, 0]) + abs(R.circle[k, 1])
        if reach > 0.0:
            c, s = math.cos(R.q[b, 2]), math.sin(R.q[b, 2])
            x = R.q[b, 0] + c * R.circle[k, 0] - s * R.circle[k, 1]
            y = R.q[b, 1] + s * R.circle[k, 0] + c * R.circle[k, 1]
        else:
            x, y = R.q[b, 0], R.q[b, 1]
        dx, dy = x - R.circle_built[k, 0], y - R.circle_built[k, 1]
        speed = abs(R.v[b, 0]) + abs(R.v[b, 1]) + abs(R.v[b, 2]) * reach
        if not abs(dx) + abs(dy) + h * speed <= allowed:
            return True
    return False


@kernel
def place(L, S, R, v, t):
    """Moves the new pose and its velocities by the least to where they hold what is held; False if that fails."""
    q, last, last_motion = R.middle, 1e300, 1e300
    for _ in range(N_PLACED):
        kinematics(L, S, q, R.free, t)
        gap, motion = gaps(L, S, v)
        if not (gap < 1e300 and motion < 1e300):
            return False
        if (gap <= 1e-14 or gap >= 0.5 * last) and (motion == 0.0 or motion >= 0.5 * last_motion):
            R.clock[PLACE_GAP] = max(R.clock[PLACE_GAP], gap)
            return gap <= 1e-8
        last, last_motion = gap, motion
        factored(L, S)
        closed(L, S, q.reshape(q.size), v)
    R.clock[PLACE_GAP] = max(R.clock[PLACE_GAP], gap)
    return gap <= 1e-8


@kernel
def forces(L, S, R, t):
    """Rows and loads at the middle of the step; loads that depend on velocities are those at its middle too."""
    h = R.clock[STEP]
    kinematics(L, S, R.middle, R.v, t)
    loads(L, S, t)
    bare, v = R.bare.reshape(R.bare.size), R.v.reshape(R.v.size)
    for i in range(len(bare)):
        bare[i] = v[i] + h * L.inverse_mass[i] * S.force[i]
    if len(L.load) > 0:
        for b in range(len(R.v)):
            for i in range(3):
                R.new[b, i] = 0.5 * (R.v[b, i] + R.bare[b, i])
        kinematics(L, S, R.middle, R.new, t)
        loads(L, S, t)
        for i in range(len(bare)):
            bare[i] = v[i] + h * L.inverse_mass[i] * S.force[i]


@kernel
def to_middle(L, S, R, t):
    """The pose at the middle, q + h/2 v, and the velocities that loads alone would lead to. Returns the largest
    acceleration by them, and the largest speed before."""
    typical, fastest = 0.0, 0.0
    for b in range(len(R.v)):
        for i in range(3):
            R.middle[b, i] = R.q[b, i] + 0.5 * R.clock[STEP] * R.v[b, i]
        fastest = max(fastest, abs(R.v[b, 0]) + abs(R.v[b, 1]))
    forces(L, S, R, t)
    free, bare = R.free.reshape(R.free.size), R.bare.reshape(R.bare.size)
    for i in range(len(free)):
        free[i] = bare[i]
    for b in range(len(R.v)):
        typical = max(typical, abs(S.force[3 * b]) * L.inverse_mass[3 * b])
        typical = max(typical, abs(S.force[3 * b + 1]) * L.inverse_mass[3 * b + 1])
    R.clock[ACCELERATION] = max(R.clock[ACCELERATION], typical)
    return typical, fastest


@kernel
def hold_free(L, S, R, free, h):
    """Takes from the free velocities what is held. Returns how often a solution is refined."""
    n_passes = 1
    if len(L.held) > 0:
        n_passes = factored(L, S)
        for r in range(len(L.held)):
            R.held_impulse[r] = 0.0
        hold_velocities(L, S, free, h, R.held_impulse, n_passes)
    return n_passes


@kernel
def collect(L, S, C, F, X, R, free, t, fastest, n_passes):
    """The rows of all that may touch or has friction in this step, and what their impulses do; False if these are too
    many."""
    h, old = R.clock[STEP], R.v.reshape(R.v.size)
    gain = h * R.clock[ACCELERATION]
    X.count[0] = X.count[1] = 0
    measure(C.kinds, C.starts, C.bodies, C.numbers, R.middle, R.v, S.turn, C.measures, C.gradient)
    if not add_candidates(L, C, X, old, free, h, 3.0 * h * (fastest + gain), R.clock[SLOP], 1e-3 * gain):
        return False
    if X.count[0] + len(F.bound) + len(F.friction) >= len(X.what):
        return False
    add_bounds(L, S, F, X, old, free, t, h, R.clock[SLOP])
    add_dry_friction(L, S, F, X, old, t, h, 1e-3 * gain)
    if not add_responses(L, S, X, R.is_jointed, n_passes):
        return False
    R.count[MOST_CLOSED] = max(R.count[MOST_CLOSED], X.count[0])
    return True


@kernel
def work_of(L, S, R, h):
    """The work, in this step, of loads without a potential and of held rows that move: P_held (goal rate - drift)."""
    work = h * S.info[POWER_OF_LOADS]
    for r in range(len(L.held)):
        if L.held[r, 3]:
            goal = S.held[r, GOAL_RATE if L.held[r, 2] else GOAL] if L.held[r, 1] >= 0 else 0.0
            work += R.held_impulse[r] * (goal - S.rows[L.held[r, 0], DRIFT])
    return work


@kernel
def arrive(L, S, X, R, free, moved):
    """The pose at the end, in the place of that at the middle, with penetrations and held rows closed. Returns how the
    step ends, and the deepest penetration."""
    h, deepest = R.clock[STEP], 0.0
    for i in range(len(free)):
        if not abs(free[i]) < 1e300:
            return NOT_FINITE, deepest
    for b in range(len(R.v)):
        for i in range(3):
            R.middle[b, i] = R.q[b, i] + h * R.new[b, i]
    if X.count[0] > 0:
        deepest = correct(X, R.middle.reshape(R.middle.size), free, moved, h, R.clock[SLOP], N_CORRECTED)
    if len(L.held) > 0 and not place(L, S, R, free, R.clock[NOW] + h):
        return NOT_HELD, deepest
    return DONE, deepest


@kernel
def settle(S, R, h):
    """Pose and velocities at the end become those of the motion; in `R.new` stays the mean acceleration."""
    for k in range(len(S.measures)):
        S.measures[k, NEAR] = S.measures[k, BEARING]
    for b in range(len(R.v)):
        for i in range(3):
            R.new[b, i] = (R.free[b, i] - R.v[b, i]) / h
            R.q[b, i], R.v[b, i] = R.middle[b, i], R.free[b, i]


@kernel
def step(L, S, C, F, X, R, is_pressed_by_held):
    """One step; see above. Nothing of the motion is changed unless it is DONE."""
    h = R.clock[STEP]
    t = R.clock[NOW] + 0.5 * h
    typical, fastest = to_middle(L, S, R, t)
    free, moved = R.free.reshape(R.free.size), R.new.reshape(R.new.size)
    n_passes = hold_free(L, S, R, free, h)
    if not collect(L, S, C, F, X, R, free, t, fastest, n_passes):
        return FULL
    for b in range(len(R.v)):
        R.is_whole[b] = 0
    loss = 0.0
    if X.count[0] > 0:
        speed = fastest + h * typical
        loss = exchange(L, S, C, F, X, R, free, moved, speed, is_pressed_by_held, n_passes)
    move(R, free, moved)
    work = work_of(L, S, R, h)
    how, deepest = arrive(L, S, X, R, free, moved)
    if how != DONE:
        return how
    settle(S, R, h)
    R.clock[DEEPEST] = max(R.clock[DEEPEST], deepest)
    R.clock[WORK] += work
    R.clock[LOSS] += loss
    R.clock[FASTEST] = max(R.clock[FASTEST], fastest)
    R.count[STEPS] += 1
    R.clock[NOW] += h
    return DONE


@entry
def advance(L: ModelArrays, S: Workspace, C: Candidates, F: Fixtures, X: ClosedRows, R: March, n_steps: int) -> int:
    """Makes steps until the count of all is n_steps, or what is returned stops it."""
    # a Boolean from the first line on: begun as the literal False it would be of two types, and all that takes it
    # compiled for both
    is_pressed_by_held = len(F.friction) < 0
    for k in range(len(F.friction)):
        is_pressed_by_held = is_pressed_by_held or F.friction[k, 1] < -1 or F.friction[k, 2] < -1
    while R.count[STEPS] < n_steps:
        if has_moved(R):
            return REBUILD
        result = step(L, S, C, F, X, R, is_pressed_by_held)
        if result != DONE:
            return result
    return DONE


@entry
def penetration(S: Workspace, C: Candidates, q: Floats2, v: Floats2, tolerance: float) -> float:
    """The deepest penetration of the candidates at a pose, of those that a step would look at."""
    turned(q, S.turn)
    measure(C.kinds, C.starts, C.bodies, C.numbers, q, v, S.turn, C.measures, C.gradient)
    deepest = 0.0
    for p in range(len(C.pair)):
        for s in range(C.pair_ptr[p], C.pair_ptr[p + 1]):
            if C.memory[s, 0] > 0.0 and is_within(C, s, tolerance):
                deepest = max(deepest, -gap_of(C, s))
    return deepest
