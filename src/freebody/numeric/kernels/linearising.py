"""The equations of motion along a motion, linearised: how its changes go on, from the operations that state them.

With u = (a, lambda) the accelerations and multipliers, R(u; q, v, p, t) = 0 the equations of motion, g what is held,
r = g' and J = dr/dv, the changes by names p obey (`tangent.equations`)

    J dq = kept - g_p,    J dv = -(r_q dq + r_p),    R_u du = -(R_q dq + R_v dv + R_p).

Some coordinates I are left free. With x = (dq_I, dv_I) all changes are dq = Tq (x, 1), dv = Tv (x, 1), du = U (x, 1), a
column more for each name, and so x' = F (x, 1) with the rows I of Tv and U. In space d/dt d theta = d omega - omega x
d theta.
"""

# pyright: basic

from __future__ import annotations

import math
from typing import NamedTuple

from freebody.numeric.kernels.arrays import Floats, Floats2, Ints, Ints2
from freebody.numeric.kernels.declaring import entry, kernel
from freebody.numeric.kernels.dense import factor_dense, solve_dense
from freebody.numeric.kernels.playing import play

VALUES, BY_U, JACOBIAN, PLACES_BY_P, RATES_BY_Q, RATES_BY_P, BY_Q, BY_V, BY_P, BY_T = range(10)  # matrices, in order
N_SIGNS = 4  # rounds in which the signs of what presses frictions settle
NATURAL = 1e-3  # of the largest: a mass may be a pivot if it is not far smaller, which leaves the zeros of R_u zero
UNDETERMINED, NO_SIGN = -1, -2  # why there are no accelerations


class TangentProgram(NamedTuple):
    """What is written of the equations of one mode."""

    code: Ints2  # see `playing`
    numbers: Floats
    parts: Ints  # (3,) where the operations begin of what is linear in u, and of the rest
    cells: Ints2  # (n, 3) row, column, register; those of one matrix together
    groups: Ints  # (11,) where the cells of each matrix begin
    unknowns: Ints  # (n_u,) which inputs accelerations and multipliers are
    signs: Ints2  # (n, 2) an input that is the sign of an unknown, and which
    speeds: Ints  # (n,) which inputs velocities are
    turning: Ints  # the first of the three coordinates of every body that turns in space
    places: Ints  # rows that hold places
    rows: Ints  # all rows


class TangentRoom(NamedTuple):
    """Where they are evaluated."""

    registers: Floats2  # (n_registers, width)
    factors: Floats2  # (width n_u, n_u)
    pivots: Ints
    u: Floats2  # (n_u, 1)
    J: Floats2  # (n_rows, n)
    D: Floats2  # (n_rows, n_rows) columns of J that are not free
    held_pivots: Ints
    held: Floats2  # (n_rows, n_columns)
    Tq: Floats2  # (n, n_columns)
    Tv: Floats2
    U: Floats2  # (n_u, n_columns)


class FreeCoordinates(NamedTuple):
    """Which coordinates are free, and which are not, of poses and of velocities."""

    q: Ints
    v: Ints
    dependent_q: Ints
    dependent_v: Ints


@kernel
def solve_unknowns(P, W, inputs, times, turns, first, n):
    """Accelerations and multipliers at n instants, into the inputs; R_u is left factored. Returns n, or why not."""
    n_u = len(P.unknowns)
    for _ in range(N_SIGNS):
        for i in range(n_u):
            for m in range(n):
                inputs[P.unknowns[i], first + m] = 0.0
        play(P.code, P.numbers, P.parts[0], P.parts[1], inputs, times, turns, W.registers, first, n)
        is_settled = True
        for m in range(n):
            o = m * n_u
            for i in range(n_u):
                W.u[i, 0] = 0.0
                for j in range(n_u):
                    W.factors[o + i, j] = 0.0
            for c in range(P.groups[VALUES], P.groups[VALUES + 1]):
                W.u[P.cells[c, 0], 0] = -W.registers[P.cells[c, 2], m]
            for c in range(P.groups[BY_U], P.groups[BY_U + 1]):
                W.factors[o + P.cells[c, 0], P.cells[c, 1]] = W.registers[P.cells[c, 2], m]
            if not factor_dense(W.factors, o, n_u, NATURAL, W.pivots):
                return UNDETERMINED
            solve_dense(W.factors, o, n_u, W.pivots, W.u, 1)
            for i in range(n_u):
                if not abs(W.u[i, 0]) < math.inf:
                    return UNDETERMINED
                inputs[P.unknowns[i], first + m] = W.u[i, 0]
            for k in range(len(P.signs)):
                sign = -1.0 if W.u[P.signs[k, 1], 0] < 0.0 else 1.0
                if inputs[P.signs[k, 0], first + m] != sign:
                    inputs[P.signs[k, 0], first + m] = sign
                    is_settled = False
        if is_settled:
            return n
    return NO_SIGN


@kernel
def add_product(P, W, m, matrix, T, n_columns, factor, out):
    """out += factor times a matrix times the first columns of T."""
    for c in range(P.groups[matrix], P.groups[matrix + 1]):
        i, j, x = P.cells[c, 0], P.cells[c, 1], factor * W.registers[P.cells[c, 2], m]
        if x != 0.0:
            for s in range(n_columns):
                out[i, s] += x * T[j, s]


@kernel
def add_names(P, W, m, matrix, origins, factor, out, o):
    """out += factor times the derivatives by the names, in the columns from o on; some are by where measures count
    from, which changes with the names as well."""
    k = origins.shape[1]
    for c in range(P.groups[matrix], P.groups[matrix + 1]):
        i, j, x = P.cells[c, 0], P.cells[c, 1], factor * W.registers[P.cells[c, 2], m]
        if j < k:
            out[i, o + j] += x
        else:
            for name in range(k):
                out[i, o + name] += x * origins[j - k, name]


@kernel
def emptied(A):
    for i in range(A.shape[0]):
        for j in range(A.shape[1]):
            A[i, j] = 0.0


@kernel
def factor_held(W, rows, dependent, unit):
    """Factors the part of J by what is not free, in units of size. False where that does not follow from the rest."""
    n = len(dependent)
    for r in range(n):
        for i in range(n):
            W.D[r, i] = W.J[rows[r], dependent[i]] * unit[dependent[i]]
    return factor_dense(W.D, 0, n, 1.0, W.held_pivots)


@kernel
def solve_held(W, T, rows, free, dependent, o, unit, n_columns):
    """Fills T from what is free, in the columns from o on, and from what is held: some rows of J times T are W.held.
    Returns the largest change of what depends by one of what is free, in units of size."""
    n = len(dependent)
    for f in range(len(free)):
        T[free[f], o + f] = 1.0
        for r in range(n):
            W.held[r, o + f] -= W.J[rows[r], free[f]]
    solve_dense(W.D, 0, n, W.held_pivots, W.held, n_columns)
    largest = 0.0
    for i in range(n):
        for c in range(n_columns):
            T[dependent[i], c] = W.held[i, c] * unit[dependent[i]]
        for f in range(len(free)):
            largest = max(largest, abs(W.held[i, o + f]) * unit[free[f]])
    return largest


@kernel
def map_changes(P, W, m, free, kept, origins, unit, n_columns):
    """Tq and Tv at the instant of column m. Returns how large what depends is (`solve_held`); -1 where it does not
    follow."""
    n_q, o = len(free.q), len(free.q) + len(free.v)
    emptied(W.J)
    emptied(W.held)
    emptied(W.Tq)
    emptied(W.Tv)
    for c in range(P.groups[JACOBIAN], P.groups[JACOBIAN + 1]):
        W.J[P.cells[c, 0], P.cells[c, 1]] = W.registers[P.cells[c, 2], m]
    for r in range(len(P.places)):
        for name in range(kept.shape[1]):
            W.held[r, o + name] = kept[r, name]
    add_names(P, W, m, PLACES_BY_P, origins, -1.0, W.held, o)
    if not factor_held(W, P.places, free.dependent_q, unit):
        return -1.0
    size = solve_held(W, W.Tq, P.places, free.q, free.dependent_q, 0, unit, n_columns)

    emptied(W.held)
    add_product(P, W, m, RATES_BY_Q, W.Tq, n_columns, -1.0, W.held)
    add_names(P, W, m, RATES_BY_P, origins, -1.0, W.held, o)
    if len(P.places) < len(P.rows) and not factor_held(W, P.rows, free.dependent_v, unit):
        return -1.0
    return max(size, solve_held(W, W.Tv, P.rows, free.v, free.dependent_v, n_q, unit, n_columns))


@kernel
def map_unknowns(P, W, m, inputs, t, origins, names, is_end):
    """U at the instant of column m; at the end of a panel with one column more, the rates of the unknowns by
    R_u u' + R_q v + R_v a + R_t = 0."""
    n, n_u = len(P.speeds), len(P.unknowns)
    k = origins.shape[1]
    n_columns = names + k
    emptied(W.U)
    if is_end:
        for i in range(n):
            W.Tq[i, n_columns] = inputs[P.speeds[i], t]
            W.Tv[i, n_columns] = inputs[P.unknowns[i], t]
        for c in range(P.groups[BY_T], P.groups[BY_T + 1]):
            W.U[P.cells[c, 0], n_columns] -= W.registers[P.cells[c, 2], m]
        n_columns += 1
    add_product(P, W, m, BY_Q, W.Tq, n_columns, -1.0, W.U)
    add_product(P, W, m, BY_V, W.Tv, n_columns, -1.0, W.U)
    add_names(P, W, m, BY_P, origins, -1.0, W.U, names)
    solve_dense(W.factors, m * n_u, n_u, W.pivots, W.U, n_columns)


@kernel
def store_maps(W, T, o, n_columns):
    """The maps at the end of a panel, in the rows of T from o on: dq, dv, du."""
    n = len(W.Tq)
    for c in range(n_columns):
        for i in range(n):
            T[o + i, c], T[o + n + i, c] = W.Tq[i, c], W.Tv[i, c]
        for i in range(len(W.U)):
            T[o + 2 * n + i, c] = W.U[i, c]


@kernel
def write_slopes(P, W, free, inputs, t, F, o, n_columns):
    """The rows of F at an instant, from row o on."""
    for b in range(len(P.turning)):
        i = P.turning[b]
        x, y, z = inputs[P.speeds[i], t], inputs[P.speeds[i + 1], t], inputs[P.speeds[i + 2], t]
        for c in range(n_columns):
            W.Tv[i, c] -= y * W.Tq[i + 2, c] - z * W.Tq[i + 1, c]
            W.Tv[i + 1, c] -= z * W.Tq[i, c] - x * W.Tq[i + 2, c]
            W.Tv[i + 2, c] -= x * W.Tq[i + 1, c] - y * W.Tq[i, c]
    for c in range(n_columns):
        for m in range(len(free.q)):
            F[o + m, c] = W.Tv[free.q[m], c]
        for m in range(len(free.v)):
            F[o + len(free.q) + m, c] = W.U[free.v[m], c]


@entry
def linearised(
    P: TangentProgram,
    W: TangentRoom,
    free: FreeCoordinates,
    inputs: Floats2,
    times: Floats,
    turns: Floats2,
    kept: Floats2,
    origins: Floats2,
    unit: Floats,
    F: Floats2,
    T: Floats2,
    first: int,
    stride: int,
    most: float,
) -> int:
    """From the instant `first` on, which ends a panel: F, f rows each, and at every `stride`-th instant, the ends of
    panels, the maps and the rates of the unknowns (`store_maps`). Returns the first instant at which what depends has
    become more than `most` times as large as in the first panel, the number of instants if there is none, or why there
    are no accelerations."""
    f, width = len(free.q) + len(free.v), W.registers.shape[1]
    n_columns, n_maps, largest = f + kept.shape[1], 2 * len(P.speeds) + len(P.unknowns), 1.0
    for begin in range(first, len(times), width):
        n = min(width, len(times) - begin)
        how = solve_unknowns(P, W, inputs, times, turns, begin, n)
        if how < 0:
            return how
        play(P.code, P.numbers, P.parts[1], P.parts[2], inputs, times, turns, W.registers, begin, n)
        for m in range(n):
            t = begin + m
            size = map_changes(P, W, m, free, kept, origins, unit, n_columns)
            if t - first <= stride + 1:
                if not size >= 0.0:
                    return UNDETERMINED
                largest = max(largest, size)
            elif size < 0.0 or not size <= most * largest:
                return t
            is_end = t % stride == 0
            map_unknowns(P, W, m, inputs, t, origins, f, is_end)
            if is_end:
                store_maps(W, T, t // stride * n_maps, n_columns + 1)
            write_slopes(P, W, free, inputs, t, F, (t - first) * f, n_columns)
    return len(times)


@entry
def solved(P: TangentProgram, W: TangentRoom, inputs: Floats2, times: Floats, turns: Floats2) -> int:
    """Accelerations and multipliers at some instants, into the inputs. Returns why there are none, else 0."""
    width = W.registers.shape[1]
    for begin in range(0, len(times), width):
        how = solve_unknowns(P, W, inputs, times, turns, begin, min(width, len(times) - begin))
        if how < 0:
            return how
    return 0
