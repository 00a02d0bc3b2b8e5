"""Values, rates, gradients and biases of all rows at one instant, and the targets of those that are held.

A row is a combination of measures, then an expression in other rows (a tape), then a sum of products  c(pose) dm/dt:
gradient c grad m, bias c bias m + c' m'. The bias is the second derivative along a motion without acceleration.
"""

# pyright: basic

from __future__ import annotations

from freebody.numeric.kernels.declaring import kernel, part
from freebody.numeric.kernels.measures_planar import measure
from freebody.numeric.kernels.measures_spatial import measure as measure_in_space
from freebody.numeric.kernels.rotating import gyroscopic
from freebody.numeric.kernels.tape import play, sweep
from freebody.numeric.kernels.turning import turned

# columns of `Room.rows`: value, rate, second derivative without acceleration, partial time derivative, weight in a tape
VALUE, RATE, BIAS, DRIFT, WEIGHT = range(5)
# columns of `Room.held`: the target and its derivatives, gaps of place and of motion, the right side
GOAL, GOAL_RATE, GOAL_BIAS, PLACE, MOTION, RIGHT = range(6)


@kernel
def measured(kinds, starts, bodies, numbers, q, v, turn, frames, out, gradient):
    """Values, gradients and biases of all measures. The plane has no frames, and for it the kernels of space are not
    compiled; in space they are those of the state (`rotating.framed`)."""
    if frames is None:
        turned(q, turn)
        measure(kinds, starts, bodies, numbers, q, v, turn, out, gradient)
    else:
        measure_in_space(kinds, starts, bodies, numbers, q, v, frames, out, gradient)


@kernel
def kinematics(L, S, q, v, t):
    """Values, gradients and biases of all rows, and the targets of those that are held."""
    G = S.gradient
    measured(L.kinds, L.starts, L.measure_bodies, L.measure_numbers, q, v, S.turn, S.frames, S.measures, G)
    gyroscopic(S.frames, L.gyration, v, S.gyroscopic)
    for r in range(len(L.term_ptr) - 1):
        x, b = L.row_constant[r], 0.0
        for k in range(L.term_ptr[r], L.term_ptr[r + 1]):
            x += L.term_coefficient[k] * S.measures[L.term_measure[k], 0]
            b += L.term_coefficient[k] * S.measures[L.term_measure[k], 1]
        S.rows[r, VALUE], S.rows[r, BIAS] = x, b
    for k in range(len(L.cleared)):
        o = L.cleared[k]
        G[o] = G[o + 1] = G[o + 2] = 0.0
    for k in range(len(L.mix)):
        o, i, c = L.mix[k, 0], L.mix[k, 1], L.mix_coefficient[k]
        G[o] += c * G[i]
        G[o + 1] += c * G[i + 1]
        G[o + 2] += c * G[i + 2]
    for k in range(len(L.rated)):
        S.rows[L.rated[k], RATE] = along(L, S, L.rated[k], v)
    composed(L, S, t)
    products(L, S, v)  # their coefficients may be expressions
    for k in range(len(L.held)):
        tape = L.held[k, 1]
        if tape >= 0:
            begin, end = L.tape_ptr[tape], L.tape_ptr[tape + 1]
            play(begin, end, L.tape, L.tape_number, t, S.rows, S.registers)
            S.held[k, GOAL] = S.registers[end - 1, 0]
            S.held[k, GOAL_RATE] = S.registers[end - 1, 1]
            S.held[k, GOAL_BIAS] = S.registers[end - 1, 2]


@part
def along(L, S, r, v):
    """gradient . v of a row."""
    total = 0.0
    for k in range(L.slot_ptr[r], L.slot_ptr[r + 1]):
        b, o = L.slots[k, 0], L.slots[k, 1]
        total += S.gradient[o] * v[b, 0] + S.gradient[o + 1] * v[b, 1] + S.gradient[o + 2] * v[b, 2]
    return total


@part
def products(L, S, v):
    """Rows  sum of c(pose) dm/dt:  gradient c grad m, bias c bias m + c' m'."""
    for k in range(len(L.product)):
        S.rows[L.product[k, 0], BIAS] = S.rows[L.product[k, 0], DRIFT] = 0.0
    for k in range(len(L.product)):
        r, c, m = L.product[k, 0], L.product[k, 1], L.product[k, 2]
        S.rows[r, BIAS] += S.rows[c, VALUE] * S.rows[m, BIAS] + S.rows[c, RATE] * S.rows[m, RATE]
        S.rows[r, DRIFT] += S.rows[c, VALUE] * S.rows[m, DRIFT]
        S.product_weight[k] = S.rows[c, VALUE]
    for k in range(len(L.product_mix)):
        o, w, i = L.product_mix[k, 0], S.product_weight[L.product_mix[k, 1]], L.product_mix[k, 2]
        for j in range(3):
            S.gradient[o + j] += w * S.gradient[i + j]
    for k in range(len(L.product)):
        r = L.product[k, 0]
        S.rows[r, RATE] = along(L, S, r, v) + S.rows[r, DRIFT]


@part
def composed(L, S, t):
    """Rows that are expressions in other rows and time."""
    at = 0
    for k in range(len(L.composed)):
        r, tape = L.composed[k, 0], L.composed[k, 1]
        begin, end = L.tape_ptr[tape], L.tape_ptr[tape + 1]
        play(begin, end, L.tape, L.tape_number, t, S.rows, S.registers)
        S.rows[r, VALUE] = S.registers[end - 1, 0]
        S.rows[r, BIAS] = S.registers[end - 1, 2]
        S.rows[r, DRIFT] = S.registers[end - 1, 1]
        first = at
        while at < len(L.composed_mix) and L.composed_mix[at, 1] == k:
            S.rows[L.composed_mix[at, 3], WEIGHT] = 0.0
            at += 1
        sweep(begin, end, L.tape, L.tape_number, S.registers, S.rows)
        last = -1
        for i in range(first, at):
            o, source, row = L.composed_mix[i, 0], L.composed_mix[i, 2], L.composed_mix[i, 3]
            w = S.rows[row, WEIGHT]
            if row != last:
                S.rows[r, DRIFT] -= w * S.rows[row, RATE]
                last = row
            if source >= 0:
                for j in range(3):
                    S.gradient[o + j] += w * S.gradient[source + j]
        S.rows[r, RATE] = S.registers[end - 1, 1]
