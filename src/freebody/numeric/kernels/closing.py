"""What is missing to the targets of held rows, and the least move that closes it.

With D = M^-1 the move is dq = D J^T (J D J^T)^-1 gap, to first order, and dv the same with the gap of motion.
"""

# pyright: basic

from __future__ import annotations

from freebody.numeric.kernels.declaring import part
from freebody.numeric.kernels.factoring import (
    N_LEFT_OUT,
    REGULARISATION,
    VANISHED,
    assemble,
    back_solve,
    factor,
    is_spatial,
)
from freebody.numeric.kernels.kinematics import DRIFT, GOAL, GOAL_RATE, MOTION, PLACE, VALUE
from freebody.numeric.kernels.solving import apply_multipliers, held_along


@part
def gaps(L, S, v):
    """Fills `gaps` with what is missing to the targets, of positions and of velocities; returns the largest ones in
    parts of their size."""
    place, motion = 0.0, 0.0
    for r in range(len(L.held)):
        row, has_target = L.held[r, 0], L.held[r, 1] >= 0
        if L.held[r, 2]:
            S.held[r, PLACE] = (S.held[r, GOAL] if has_target else 0.0) - S.rows[row, VALUE]
            S.held[r, MOTION] = (
                (S.held[r, GOAL_RATE] if has_target else 0.0) - S.rows[row, DRIFT] - held_along(L, S, r, v)
            )
        else:
            S.held[r, PLACE] = 0.0
            S.held[r, MOTION] = (S.held[r, GOAL] if has_target else 0.0) - S.rows[row, DRIFT] - held_along(L, S, r, v)
        x, y = abs(S.held[r, PLACE]) * L.held_scale[r], abs(S.held[r, MOTION]) * L.held_scale[r]
        if not x <= place:
            place = x
        if not y <= motion:
            motion = y
    return place, motion


@part
def closed(L, S, q, v):
    """Moves q and v by the least, in the metric of the masses, that closes the gaps to first order. Beside redundant
    rows, those that hold velocities alone have no say in q: they would keep it from where the others want it."""
    for r in range(len(L.held)):
        S.step[r] = S.held[r, MOTION]
    back_solve(L.column_ptr, L.column_row, S.schur, S.step)
    apply_multipliers(L.held_ptr, L.held_slots, S.weighted, S.step, v)
    if is_spatial(S.frames) and S.info[N_LEFT_OUT] > 0.0:
        factored_for_places(L, S)
    for r in range(len(L.held)):
        S.step[r] = S.held[r, PLACE]
    back_solve(L.column_ptr, L.column_row, S.schur, S.step)
    apply_multipliers(L.held_ptr, L.held_slots, S.weighted, S.step, q)


@part
def factored_for_places(L, S):
    """Factors for the rows that hold positions; nothing to do where there are no others."""
    n_others = 0
    for r in range(len(L.held)):
        if not L.held[r, 2]:
            n_others += 1
    if n_others == 0:
        return
    assemble(
        L.held_slots, L.inverse_mass, L.schur_base, L.pair_ptr, L.pair_a, L.pair_b, S.gradient, S.weighted, S.schur
    )
    for j in range(len(L.held)):
        for i in range(L.column_ptr[j], L.column_ptr[j + 1]):
            if not (L.held[j, 2] and L.held[L.column_row[i], 2]):
                S.schur[i] = 0.0
    factor(L.column_ptr, L.target, REGULARISATION, VANISHED, 0.0, S.schur, S.diagonal)
