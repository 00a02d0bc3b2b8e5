"""The Schur complement J M^-1 J^T and its factors L D L^T, in an order found once.

It is positive semidefinite and as sparse as the mechanism. A row whose pivot vanishes says what rows before it said (a
redundant connection): it is left out, its multiplier is zero. A pivot that nearly vanishes belongs to a pose near a
singular one: there 1e-10 of the diagonal is added and the solution refined (proximal point iteration).
Source: Davis, Direct Methods for Sparse Linear Systems, 2006, ch. 4; Rockafellar, SIAM J. Control Optim. 14 (1976) 877.
"""

# pyright: basic

from __future__ import annotations

from freebody.numeric.kernels.declaring import kernel, part

VANISHED = 1e-13  # a pivot below this part of its diagonal is none
# nor is one below this by the smallest pivot before it, which enlarges rounding so much, up to a part of the diagonal
ROUNDING, MOST_ROUNDING = 1e-15, 1e-3
# beside rows that are left out: below this part of the best pivot of the motion, others of these rows should have been
# kept; the pivot is then given as this part of the best one at most, so that stages are looked after (`stepping`)
SHAKY_PIVOT, PSEUDO_PIVOT = 1e-2, 1e-3
SMALL_PIVOT = 1e-2  # see `pseudo_pivot`
PIVOT_CUT = 1e-8  # a smaller pivot, relative to its diagonal, calls for regularisation
REGULARISATION = 1e-10
N_REFINED = 3
# what `Room.info` holds; of a motion also how many rows depend on others all the time, and the best smallest pivot
SMALLEST_PIVOT, IS_REGULARISED, POWER_OF_LOADS, RESIDUAL, N_LEFT_OUT, N_REDUNDANT, BEST_OF_MOTION = range(7)


@kernel
def assemble(slots, inverse_mass, base, ptr, left, right, G, W, A):
    """J M^-1 J^T, where its factor will stand. What never changes is in `base`."""
    for k in range(len(slots)):
        W[k] = G[slots[k, 1]] * inverse_mass[slots[k, 0]]
    for e in range(len(A)):
        total = base[e]
        for k in range(ptr[e], ptr[e + 1]):
            total += W[left[k]] * G[right[k]]
        A[e] = total


@kernel
def factor(ptr, target, regularisation, vanished, rounding, A, diagonal):
    """A becomes its L D L^T, a part of the diagonal added, column by column; 1/D stands on the diagonal. Returns the
    smallest pivot by its diagonal, and how many rows are left out, whose pivots are below `vanished`, or below the
    `rounding` of one operation by the smallest pivot before."""
    smallest, n_left_out = 1.0, 0
    n = len(ptr) - 1
    for j in range(n):
        diagonal[j] = A[ptr[j]]
        A[ptr[j]] *= 1.0 + regularisation
    p = 0
    for j in range(n):
        begin, end = ptr[j], ptr[j + 1]
        pivot, size = A[begin], diagonal[j]
        ratio = pivot / size if size > 0.0 else 0.0
        if ratio < max(vanished, min(MOST_ROUNDING, rounding / smallest)):
            n_left_out += 1
            inverse = 0.0
        else:
            inverse = 1.0 / pivot
            if not ratio >= smallest:
                smallest = ratio
        A[begin] = inverse
        for i in range(begin + 1, end):
            scaled = A[i] * inverse
            for k in range(begin + 1, i + 1):
                A[target[p]] -= scaled * A[k]
                p += 1
        for i in range(begin + 1, end):
            A[i] *= inverse
    return smallest, n_left_out


@kernel
def back_solve(ptr, rows, A, x):
    """x becomes (L D L^T)^-1 x."""
    n = len(ptr) - 1
    for j in range(n):
        xj = x[j]
        for i in range(ptr[j] + 1, ptr[j + 1]):
            x[rows[i]] -= A[i] * xj
    for j in range(n - 1, -1, -1):
        xj = x[j] * A[ptr[j]]
        for i in range(ptr[j] + 1, ptr[j + 1]):
            xj -= A[i] * x[rows[i]]
        x[j] = xj


@part
def assembled(L, S):
    assemble(
        L.held_slots, L.inverse_mass, L.schur_base, L.pair_ptr, L.pair_a, L.pair_b, S.gradient, S.weighted, S.schur
    )


@kernel
def pseudo_pivot(ptr, A, diagonal, n_left_out):
    """How small the smallest pivot would be in a better order of rows, of which n_left_out depend on others: with
    regularisation mu the determinant tends to mu^n_left_out times the product of what is not zero, so it is the product
    of the small pivots by mu^n_left_out."""
    found = 1.0
    n_small = 0
    for j in range(len(ptr) - 1):
        ratio = 1.0 / (A[ptr[j]] * diagonal[j]) if A[ptr[j]] != 0.0 else 0.0
        if ratio < SMALL_PIVOT:
            n_small += 1
            found *= ratio / REGULARISATION if n_small <= n_left_out else ratio
    return found


@kernel
def is_spatial(frames):
    """Whether there are rotations in space; decided where kernels are compiled."""
    return frames is not None


@part
def factored(L, S):
    """Factors; regularised where rows depend on each other. Returns the number of passes that a solution needs.

    Rows are left out in a fixed order. A row that was kept may lose its meaning to one that is left out later: its
    pivot passes through zero at a pose that is not singular. There, too, all rows are kept with regularisation, which
    does not ask for the order. In a stage what is held is a little off, and so is that rows depend on each other."""
    assemble(
        L.held_slots, L.inverse_mass, L.schur_base, L.pair_ptr, L.pair_a, L.pair_b, S.gradient, S.weighted, S.schur
    )
    in_space = is_spatial(S.frames)  # in the plane what rows say passes from one to another at singular poses alone
    vanished = PIVOT_CUT if in_space and S.info[N_REDUNDANT] > 0.0 else VANISHED
    rounding = ROUNDING if in_space else 0.0
    smallest, n_left_out = factor(L.column_ptr, L.target, 0.0, vanished, rounding, S.schur, S.diagonal)
    S.info[SMALLEST_PIVOT], S.info[N_LEFT_OUT] = smallest, n_left_out
    S.info[IS_REGULARISED] = 0.0
    is_shaky = in_space and n_left_out > 0 and smallest < SHAKY_PIVOT * S.info[BEST_OF_MOTION]
    if not (smallest < PIVOT_CUT or is_shaky):
        return 1
    assemble(
        L.held_slots, L.inverse_mass, L.schur_base, L.pair_ptr, L.pair_a, L.pair_b, S.gradient, S.weighted, S.schur
    )
    factor(L.column_ptr, L.target, REGULARISATION, VANISHED, 0.0, S.schur, S.diagonal)
    if is_shaky:
        most = PSEUDO_PIVOT * S.info[BEST_OF_MOTION]
        S.info[SMALLEST_PIVOT] = min(most, pseudo_pivot(L.column_ptr, S.schur, S.diagonal, n_left_out))
    if S.info[SMALLEST_PIVOT] < PIVOT_CUT:
        S.info[IS_REGULARISED] = 1.0
    return N_REFINED
