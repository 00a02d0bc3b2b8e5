"""The accelerations and multipliers of one instant.

With J the gradients of the held rows, M the masses and Q the generalized forces of the loads,

    M a = Q + J^T lambda,    J a = target'' - bias        =>        (J M^-1 J^T) lambda = target'' - bias - J M^-1 Q.

In space Q has the gyroscopic torques as well. What stands on the left is factored (`factoring`) and solved (`solving`),
with friction that slides (`sliding`), after the rows are known (`kinematics`).
Source: Nikravesh, Computer-Aided Analysis of Mechanical Systems, 1988, ch. 8.
"""

# pyright: basic

from __future__ import annotations

from freebody.numeric.kernels.declaring import kernel, part
from freebody.numeric.kernels.factoring import POWER_OF_LOADS, factored
from freebody.numeric.kernels.kinematics import DRIFT, GOAL, GOAL_RATE, RATE, VALUE, kinematics
from freebody.numeric.kernels.sliding import slid
from freebody.numeric.kernels.solving import solve
from freebody.numeric.kernels.tape import play


@part
def law_of(L, S, p, t):
    """The generalized force of a load."""
    tape, r = L.load[p, 1], L.load[p, 0]
    if tape < 0:
        return L.load_law[p, 0] + L.load_law[p, 1] * S.rows[r, VALUE] + L.load_law[p, 2] * S.rows[r, RATE]
    begin, end = L.tape_ptr[tape], L.tape_ptr[tape + 1]
    play(begin, end, L.tape, L.tape_number, t, S.rows, S.registers)
    return S.registers[end - 1, 0]


@part
def loads(L, S, t):
    """Generalized forces of all loads; the power of those without a potential."""
    F = S.force
    for i in range(len(F)):
        F[i] = L.constant_force[i]
    for b in range(len(L.gyration)):
        for i in range(3):
            F[6 * b + 3 + i] += S.gyroscopic[b, i]
    power = 0.0
    for p in range(len(L.load)):
        law, r = law_of(L, S, p, t), L.load[p, 0]
        if L.load[p, 2]:
            power += law * (S.rows[r, RATE] - S.rows[r, DRIFT])
        for k in range(L.slot_ptr[r], L.slot_ptr[r + 1]):
            b, o = L.slots[k, 0], L.slots[k, 1]
            for i in range(3):
                F[3 * b + i] += law * S.gradient[o + i]
    S.info[POWER_OF_LOADS] = power


@kernel
def respond(L, S, t):
    """Forces, accelerations and multipliers, where the kinematics are known."""
    loads(L, S, t)
    n_passes = factored(L, S)
    solve(L, S, S.force, False, n_passes)
    if len(L.slide) > 0:
        slid(L, S, n_passes, t)


@part
def accelerations(L, S, q, v, t):
    """Everything at one instant: rows, forces, accelerations, multipliers."""
    kinematics(L, S, q, v, t)
    respond(L, S, t)


@part
def power(L, S):
    """Power of the loads without a potential and of the held rows that move."""
    total = S.info[POWER_OF_LOADS]
    for r in range(len(L.held)):
        if L.held[r, 3]:
            row = L.held[r, 0]
            if L.held[r, 2]:
                rate = (S.held[r, GOAL_RATE] if L.held[r, 1] >= 0 else 0.0) - S.rows[row, DRIFT]
            else:
                rate = (S.held[r, GOAL] if L.held[r, 1] >= 0 else 0.0) - S.rows[row, DRIFT]
            total += S.multiplier[r] * rate
    return total
