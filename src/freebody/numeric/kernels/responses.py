"""What unit impulses along the rows of a step do to the velocities, with those in the held rows that they call for:

M^-1 J^T - M^-1 H^T (H M^-1 H^T)^-1 H M^-1 J^T,        H the gradients of the held rows.
"""

# pyright: basic

from __future__ import annotations

from freebody.numeric.kernels.declaring import kernel
from freebody.numeric.kernels.factoring import back_solve
from freebody.numeric.kernels.rows import BARE, CROSS, IS_COUPLED, OWN
from freebody.numeric.kernels.solving import apply_multipliers, held_along


@kernel
def add_responses(L, S, X, is_jointed, n_passes):
    """Responses of all rows, and the matrix of their own and their neighbour's. False if they have no room."""
    X.count[2] = 0
    n = len(L.inverse_mass)
    for r in range(X.count[0]):
        X.response_ptr[r] = p = X.count[2]
        # a row on bodies with held rows moves all that they lead to
        is_wide = False
        if len(L.held) > 0:
            for k in range(X.ptr[r], X.ptr[r + 1]):
                is_wide = is_wide or is_jointed[X.coordinate[k] // 3] > 0
        if p + (n if is_wide else X.ptr[r + 1] - X.ptr[r]) > len(X.response):
            return False
        bare = 0.0
        # M^-1 J^T, entry by entry; or spread out, with the impulses in held rows taken in
        if not is_wide:
            for k in range(X.ptr[r], X.ptr[r + 1]):
                w = L.inverse_mass[X.coordinate[k]] * X.entry[k]
                X.response_at[p], X.response[p] = X.coordinate[k], w
                bare += w * X.entry[k]
                p += 1
        else:
            x = X.wide
            for i in range(n):
                x[i] = 0.0
            for k in range(X.ptr[r], X.ptr[r + 1]):
                w = L.inverse_mass[X.coordinate[k]] * X.entry[k]
                x[X.coordinate[k]] += w
                bare += w * X.entry[k]
            for _ in range(n_passes):
                for i in range(len(L.held)):
                    S.step[i] = -held_along(L, S, i, x)
                back_solve(L.column_ptr, L.column_row, S.schur, S.step)
                apply_multipliers(L.held_ptr, L.held_slots, S.weighted, S.step, x)
            for i in range(n):
                if x[i] != 0.0:
                    X.response_at[p], X.response[p] = i, x[i]
                    p += 1
        X.count[2] = X.response_ptr[r + 1] = p
        for i in range(X.response_ptr[r], p):
            X.wide[X.response_at[i]] = X.response[i]
        # J M^-1 J^T of the row, and with the next one where the two are a block
        own, cross = 0.0, 0.0
        if X.what[r, IS_COUPLED] > 0:
            for k in range(X.ptr[r + 1], X.ptr[r + 2]):
                X.wide[X.coordinate[k]] = 0.0
            for i in range(X.response_ptr[r], p):
                X.wide[X.response_at[i]] = X.response[i]
            for k in range(X.ptr[r + 1], X.ptr[r + 2]):
                cross += X.entry[k] * X.wide[X.coordinate[k]]
        for k in range(X.ptr[r], X.ptr[r + 1]):
            own += X.entry[k] * X.wide[X.coordinate[k]]
        X.number[r, OWN] = own if own > 1e-12 * bare else 0.0
        X.number[r, BARE], X.number[r, CROSS] = bare, cross
    return True
