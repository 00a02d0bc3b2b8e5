"""Friction that slides, of which the force depends on the reactions that press it.

The forces phi_k = -s_k c_k N_k(lambda) and the multipliers lambda = lambda_0 + sum of phi_j Lambda_j, Lambda_j those by
a unit force along slip j alone, are solved for together.

Slip in a plane has two rates, (v_k, v_l), and its friction both components, s_k = v_k/|v|. Near v = 0, and where the
slip has just turned back, s follows the direction d in which it went last: the force stays smooth through the instant
at which a slip of constant direction stops, which is where the guard v.d > 0 is violated.
"""

# pyright: basic

from __future__ import annotations

import math

from freebody.numeric.kernels.declaring import kernel
from freebody.numeric.kernels.factoring import POWER_OF_LOADS
from freebody.numeric.kernels.kinematics import DRIFT, RATE
from freebody.numeric.kernels.solving import solve
from freebody.numeric.kernels.tape import play

# what presses a sliding friction (`Layout.slide`): a law, a held row, the resultant of two
PRESSED_BY_LAW, PRESSED_BY_ONE, PRESSED_BY_SIZE = range(3)
BACK = -0.8  # the cosine beyond which a slip has not turned aside but back
N_SLIDE = 30  # steps of Newton's method for the friction; one is enough where a single row presses


@kernel
def load_of(L, S, kind, a, b, tape, sign, t):
    """What presses a friction: a law, a multiplier (its size where sign is 0), or the size of two."""
    if kind == PRESSED_BY_LAW:
        begin, end = L.tape_ptr[tape], L.tape_ptr[tape + 1]
        play(begin, end, L.tape, L.tape_number, t, S.rows, S.registers)
        return S.registers[end - 1, 0]
    if a < 0:
        return 0.0
    if kind == PRESSED_BY_ONE:
        return sign * S.multiplier[a] if sign != 0.0 else abs(S.multiplier[a])
    return math.hypot(S.multiplier[a], S.multiplier[b])


@kernel
def direction_of(L, S, k):
    """s_k of a sliding friction, by which its factor is multiplied; 1 along a line."""
    other = L.slide[k, 6]
    if other < 0:
        return 1.0
    r, q = L.slide[k, 0], L.slide[other, 0]
    own, across = S.rows[r, RATE], S.rows[q, RATE]
    speed = math.hypot(own, across)
    if speed <= L.slide_factor[k, 3]:
        return L.slide_factor[k, 2]
    along = own * L.slide_factor[k, 2] + across * L.slide_factor[other, 2]
    return own / speed if along >= BACK * speed else -own / speed


@kernel
def pushed_along(L, S, k, force, F):
    """F += force along the slip of a sliding friction."""
    r = L.slide[k, 0]
    for j in range(L.slot_ptr[r], L.slot_ptr[r + 1]):
        b, o = L.slots[j, 0], L.slots[j, 1]
        for i in range(3):
            F[3 * b + i] += force * S.gradient[o + i]


@kernel
def slid(L, S, n_passes, t):
    """Friction forces phi_k = -s_k c_k N_k(lambda), where lambda = lambda_0 + sum of phi_j Lambda_j, Lambda_j the
    multipliers by a unit force along slip j alone; then the accelerations with them. Newton's method, which is done
    after one step where all loads are linear in lambda."""
    n, n_held, phi, A, F = len(L.slide), len(L.held), S.slide_force, S.slide_matrix, S.unit_force
    # lambda_0, and the multipliers by a unit force along each slip
    for r in range(n_held):
        S.slide_response[n, r] = S.multiplier[r]
    for k in range(n):
        for i in range(len(F)):
            F[i] = 0.0
        pushed_along(L, S, k, 1.0, F)
        solve(L, S, F, True, n_passes)
        for r in range(n_held):
            S.slide_response[k, r] = S.multiplier[r]
        phi[k] = 0.0
    # Newton's method for the forces
    for _ in range(N_SLIDE):
        for r in range(n_held):
            S.multiplier[r] = S.slide_response[n, r]
            for j in range(n):
                S.multiplier[r] += phi[j] * S.slide_response[j, r]
        for k in range(n):
            kind, a, b, factor, sign = (
                L.slide[k, 1],
                L.slide[k, 2],
                L.slide[k, 3],
                L.slide_factor[k, 0] * direction_of(L, S, k),
                L.slide_factor[k, 1],
            )
            size = load_of(L, S, kind, a, b, L.slide[k, 4], sign, t)
            A[k, n] = factor * size - phi[k]
            for j in range(n):
                slope = 0.0
                if kind == PRESSED_BY_ONE and a >= 0:
                    up = sign if sign != 0.0 else (1.0 if S.multiplier[a] >= 0.0 else -1.0)
                    slope = up * S.slide_response[j, a]
                elif kind == PRESSED_BY_SIZE and a >= 0 and size > 0.0:
                    slope = (S.multiplier[a] * S.slide_response[j, a] + S.multiplier[b] * S.slide_response[j, b]) / size
                A[k, j] = (1.0 if j == k else 0.0) - factor * slope
        largest, change = 0.0, 0.0
        eliminated(A, n)
        for k in range(n):
            phi[k] += A[k, n]
            largest, change = max(largest, abs(phi[k])), max(change, abs(A[k, n]))
        if not change > 1e-15 * largest:
            break
    # the accelerations with them
    for k in range(n):
        pushed_along(L, S, k, phi[k], S.force)
        row = L.slide[k, 0]
        S.info[POWER_OF_LOADS] += phi[k] * (S.rows[row, RATE] - S.rows[row, DRIFT])
    solve(L, S, S.force, False, n_passes)


@kernel
def eliminated(A, n):
    """The last column of A (n, n + 1) becomes the solution of the equations, by elimination with pivots."""
    for c in range(n):
        p = c
        for i in range(c + 1, n):
            if abs(A[i, c]) > abs(A[p, c]):
                p = i
        for j in range(c, n + 1):
            A[c, j], A[p, j] = A[p, j], A[c, j]
        for i in range(n):
            if i != c:
                factor = A[i, c] / A[c, c]
                for j in range(c, n + 1):
                    A[i, j] -= factor * A[c, j]
    for c in range(n):
        A[c, n] /= A[c, c]
