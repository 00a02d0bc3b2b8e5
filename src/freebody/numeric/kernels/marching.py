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
from typing import NamedTuple

from freebody.numeric.kernels.arrays import Floats, Floats2, Ints, ModelArrays, Workspace
from freebody.numeric.kernels.blocks import accelerated, correct, note_impulses, start_from_memory, sweep
from freebody.numeric.kernels.candidates import Candidates
from freebody.numeric.kernels.declaring import entry, kernel, part
from freebody.numeric.kernels.dynamics import BIAS as ROW_BIAS
from freebody.numeric.kernels.dynamics import (
    DRIFT,
    GOAL,
    GOAL_RATE,
    MOTION,
    POWER_OF_LOADS,
    apply_multipliers,
    back_solve,
    closed,
    factored,
    gaps,
    held_along,
    kinematics,
    loads,
)
from freebody.numeric.kernels.measures_planar import BEARING, NEAR, measure
from freebody.numeric.kernels.rows import (
    BEFORE,
    BIAS,
    COLUMN,
    DRIFTING,
    IMPULSE,
    IS_IMPACT,
    KIND,
    NORMAL,
    OF_BOUND,
    OF_SITE,
    OPEN,
    ORIGIN,
    SOURCE,
    ClosedRows,
    Fixtures,
    add_bounds,
    add_candidates,
    add_dry_friction,
    add_responses,
    gap_of,
    is_within,
    rate_of,
)
from freebody.numeric.kernels.turning import turned

# what `advance` returns
DONE, REBUILD, FULL, NOT_FINITE, NOT_HELD = range(5)
# `March.clock`: time, length of a step, what is asked of the iteration (by the speeds), the most a gap may be negative;
# how far something may move before candidates are made anew; results
(
    NOW,
    STEP,
    TOLERANCE,
    SLOP,
    SKIN,
    RESIDUAL,
    WORST_RESIDUAL,
    DEEPEST,
    WORK,
    LOSS,
    PLACE_GAP,
    ACCELERATION,
    FASTEST,
    WORST_SHARE,
) = range(14)
N_CLOCK = 14
# `March.count`
STEPS, SWEEPS, MOST_SWEEPS, CAPPED, SOFTENED, MOST_CLOSED, REBUILDS, LAST_SWEEPS = range(8)
N_COUNT = 8
N_OUTER = 20  # how often friction is solved again as the loads of held rows change
N_CORRECTED = 5  # sweeps that close gaps
N_PLACED = 8


class March(NamedTuple):
    """A motion under way."""

    clock: Floats
    count: Ints
    q: Floats2  # (n_bodies + 1, 3)
    v: Floats2
    middle: Floats2  # pose at the middle of the step
    free: Floats2  # velocities without contact
    bare: Floats2  # velocities without contact and without held rows
    new: Floats2
    held_impulse: Floats
    is_jointed: Ints  # for every body: it has held rows
    is_whole: Ints  # for every body: it moves by h v+, not by the mean of v and v+
    circle_body: Ints
    circle: Floats2  # centres of circles about outlines, on their bodies
    circle_built: Floats2  # where they were when candidates were made


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


@part
def hold_velocities(L, S, velocities, h, impulse, n_passes):
    """Velocities by coordinates that hold at the end of the step what is held, and the impulses of the held rows."""
    for _ in range(n_passes):
        gaps(L, S, velocities)
        for r in range(len(L.held)):
            order = 2 if L.held[r, 2] else 1
            bending = S.held[r, GOAL + order] if L.held[r, 1] >= 0 else 0.0
            S.step[r] = S.held[r, MOTION] + 0.5 * h * (bending - S.rows[L.held[r, 0], ROW_BIAS])
        back_solve(L.column_ptr, L.column_row, S.schur, S.step)
        apply_multipliers(L.held_ptr, L.held_slots, S.weighted, S.step, velocities)
        for r in range(len(L.held)):
            impulse[r] += S.step[r]


@kernel
def held_impulses(L, S, X, R, n_passes):
    """The impulses of the held rows with those of the contacts; how much they changed, by their size."""
    flat = R.new.reshape(R.new.size)
    bare = R.bare.reshape(R.bare.size)
    for i in range(len(flat)):
        flat[i] = bare[i]
    for r in range(X.count[0]):
        for k in range(X.ptr[r], X.ptr[r + 1]):
            flat[X.coordinate[k]] += L.inverse_mass[X.coordinate[k]] * X.entry[k] * X.number[r, IMPULSE]
    change, size = 0.0, 0.0
    for r in range(len(L.held)):
        S.multiplier[r] = R.held_impulse[r]
        R.held_impulse[r] = 0.0
    hold_velocities(L, S, flat, R.clock[STEP], R.held_impulse, n_passes)
    for r in range(len(L.held)):
        change = max(change, abs(R.held_impulse[r] - S.multiplier[r]))
        size = max(size, abs(R.held_impulse[r]))
    return change / size if size > 0.0 else 0.0


@kernel
def solve_impulses(L, S, X, R, v, speed, is_pressed_by_held, n_passes):
    """Impulses and velocities of one step. Returns the residual: the largest change of a velocity in the last sweep."""
    enough = R.clock[TOLERANCE] * speed
    n = 0
    residual = 0.0
    for _ in range(N_OUTER):
        square, is_first = 0.0, True
        while n < R.count[MOST_SWEEPS]:
            note_impulses(X)
            residual = sweep(X, v, R.held_impulse, False)
            n += 1
            if residual <= enough or n == R.count[MOST_SWEEPS]:
                break
            square = accelerated(X, v, square, is_first)
            is_first = False
        if not is_pressed_by_held or n >= R.count[MOST_SWEEPS]:
            break
        if held_impulses(L, S, X, R, n_passes) <= 1e-12:
            break
    R.count[SWEEPS] += n
    R.count[LAST_SWEEPS] = n
    return residual


@kernel
def choose_rule(L, X, R, v, h, still):
    """Which bodies move by h v+. Rows ask for gap + h u+ >= 0; a body moves by the mean of its velocities instead
    unless that would close a gap too far, or add energy (rates below `still` do not count). Bodies that press each
    other do the same."""
    whole = R.is_whole
    for b in range(len(whole)):
        whole[b] = 0
    found = False
    for r in range(X.count[0]):
        before, after = X.number[r, BEFORE], rate_of(X, r, v) + X.number[r, DRIFTING]
        is_whole = X.number[r, IMPULSE] * (before + after) > abs(X.number[r, IMPULSE]) * still
        if X.what[r, KIND] == NORMAL:
            end = X.number[r, OPEN] + 0.5 * h * (before + after)
            is_whole = is_whole or end < min(0.0, X.number[r, OPEN]) - 1e-3 * R.clock[SLOP]
            is_whole = is_whole and X.number[r, IS_IMPACT] == 0.0
        if is_whole:
            found = True
            for k in range(X.ptr[r], X.ptr[r + 1]):
                whole[X.coordinate[k] // 3] = 1
    is_backward = False
    while found:
        found = False
        any_joint = False
        is_backward = not is_backward
        for i in range(X.count[0]):
            r = X.count[0] - 1 - i if is_backward else i
            if X.what[r, KIND] == NORMAL and X.number[r, IMPULSE] == 0.0:
                continue
            mixed = 0
            for k in range(X.ptr[r], X.ptr[r + 1]):
                mixed |= 2 if whole[X.coordinate[k] // 3] > 0 else 1
            if mixed == 3:
                found = True
                for k in range(X.ptr[r], X.ptr[r + 1]):
                    whole[X.coordinate[k] // 3] = 1
        for b in range(len(whole)):
            any_joint = any_joint or (whole[b] > 0 and R.is_jointed[b] > 0)
        for b in range(len(whole)):
            if any_joint and R.is_jointed[b] > 0 and whole[b] == 0:
                whole[b], found = 1, True


@kernel
def loss_of(L, S, R, v, moved):
    """What contacts and friction add to the energy: what bodies gain in speed, less the work of loads and of held
    rows. moved: by what the pose moves in a unit of time."""
    h, total = R.clock[STEP], 0.0
    old = R.v.reshape(R.v.size)
    for i in range(len(v)):
        if L.inverse_mass[i] > 0.0:
            total += 0.5 * (v[i] * v[i] - old[i] * old[i]) / L.inverse_mass[i] - h * S.force[i] * moved[i]
    for r in range(len(L.held)):
        total -= R.held_impulse[r] * held_along(L, S, r, moved)
    return total


@kernel
def move(R, v, moved):
    """By what every body moves in a unit of time, in this step."""
    old = R.v.reshape(R.v.size)
    for i in range(len(v)):
        moved[i] = v[i] if R.is_whole[i // 3] > 0 else 0.5 * (old[i] + v[i])


@kernel
def soften(X):
    """Takes the restitution out of all rows; True if there was any."""
    found = False
    for r in range(X.count[0]):
        if X.number[r, IS_IMPACT] > 0.0:
            X.number[r, BIAS] = X.number[r, DRIFTING]
            X.number[r, IS_IMPACT] = 0.0
            found = True
    return found


@kernel
def remember(C, F, X):
    """Impulses, for the start of the next step."""
    for s in range(len(C.memory)):
        C.memory[s, 0] = C.memory[s, 1] = C.memory[s, 2] = 0.0
    for k in range(len(F.bound_memory)):
        F.bound_memory[k] = 0.0
    for r in range(X.count[0]):
        origin, k = X.what[r, ORIGIN], X.what[r, SOURCE]
        if origin == OF_SITE:
            C.memory[k, X.what[r, COLUMN]] = X.number[r, IMPULSE]
        elif origin == OF_BOUND:
            F.bound_memory[k] = X.number[r, IMPULSE]
        else:
            F.friction_memory[k] = X.number[r, IMPULSE]


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


# Newton's law of impacts can add energy where several are coupled. With the kinetic energy E before, an energy gained
# beyond 1e-9 E is taken for that, and all impacts of the step are done again without restitution.
@kernel
def exchange(L, S, C, F, X, R, free, moved, speed, is_pressed_by_held, n_passes):
    """The impulses of the closed rows and what they do to the velocities. Returns what they add to the energy."""
    h, old, energy = R.clock[STEP], R.v.reshape(R.v.size), 0.0
    for i in range(len(free)):
        if L.inverse_mass[i] > 0.0:
            energy += 0.5 * old[i] * old[i] / L.inverse_mass[i]
    start_from_memory(X, free)
    while True:
        residual = solve_impulses(L, S, X, R, free, speed, is_pressed_by_held, n_passes)
        if len(L.held) > 0:
            held_impulses(L, S, X, R, n_passes)
        choose_rule(L, X, R, free, h, 1e-6 * (h * R.clock[ACCELERATION]))
        move(R, free, moved)
        loss = loss_of(L, S, R, free, moved)
        if not loss > 1e-9 * energy or not soften(X):
            break
        R.count[SOFTENED] += 1
    R.clock[RESIDUAL] = residual
    R.clock[WORST_RESIDUAL] = max(R.clock[WORST_RESIDUAL], residual)
    if residual > R.clock[TOLERANCE] * speed:
        R.count[CAPPED] += 1
        R.clock[WORST_SHARE] = max(R.clock[WORST_SHARE], residual / speed)
    remember(C, F, X)
    return loss


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
