"""The impulses of one step of time stepping, held rows and closed rows together, and how bodies move by them.

The closed rows are solved by sweeps (`blocks`), the held rows by their factor; where held rows press friction, both in
turn. A body moves by the mean of its velocities, or by the last one where the mean would close a gap too far or add
energy. Newton's law of impacts can add energy where several are coupled: then the step is done without restitution.
"""

# pyright: basic

from __future__ import annotations

from freebody.numeric.kernels.blocks import accelerated, note_impulses, start_from_memory, sweep
from freebody.numeric.kernels.closing import gaps
from freebody.numeric.kernels.declaring import kernel, part
from freebody.numeric.kernels.factoring import back_solve
from freebody.numeric.kernels.kinematics import BIAS as ROW_BIAS
from freebody.numeric.kernels.kinematics import GOAL, MOTION
from freebody.numeric.kernels.march import (
    ACCELERATION,
    CAPPED,
    LAST_SWEEPS,
    MOST_SWEEPS,
    RESIDUAL,
    SLOP,
    SOFTENED,
    STEP,
    SWEEPS,
    TOLERANCE,
    WORST_RESIDUAL,
    WORST_SHARE,
)
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
    rate_of,
)
from freebody.numeric.kernels.solving import apply_multipliers, held_along

N_OUTER = 20  # how often friction is solved again as the loads of held rows change


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
    # bodies of a row that would close too far, or add energy
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
    # what presses or is joined to such a body does as it does; to and fro, until nothing changes
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
