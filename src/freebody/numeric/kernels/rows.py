"""The rows of one step: what may close in it, as gradients over the coordinates that can move.

A row is a list of (coordinate, entry of J), and its response a list of (coordinate, entry of the velocity that a unit
impulse along the row brings about): M^-1 J^T, and where held rows are on the same bodies

    M^-1 J^T - M^-1 H^T (H M^-1 H^T)^-1 H M^-1 J^T,        H the gradients of the held rows,

so that a contact impulse and the impulses in joints that it calls for come together.
"""

# pyright: basic

from __future__ import annotations

from typing import NamedTuple

from freebody.numeric.kernels.arrays import Floats, Floats2, Ints, Ints2
from freebody.numeric.kernels.candidates import (
    ARM,
    CHOSEN,
    EDGE,
    FIRST_BODY,
    GAP,
    HIGH,
    KINETIC,
    LOW,
    N_EDGES,
    N_SPANS,
    N_TERMS,
    NORMAL_IMPULSE,
    RESTITUTION,
    SECOND_BODY,
    SIDE,
    SIGN,
    SLIP,
    SLIP_IMPULSE,
    SLIP_SIGN,
    SLOPE,
    SPAN,
    STATIC,
    TARGET,
    TURN,
    TURN_IMPULSE,
)
from freebody.numeric.kernels.declaring import kernel, part
from freebody.numeric.kernels.dynamics import BIAS as ROW_BIAS
from freebody.numeric.kernels.dynamics import DRIFT, VALUE, apply_multipliers, back_solve, held_along
from freebody.numeric.kernels.tape import play

# kinds of row
NORMAL, FRICTION = 0, 1
# columns of `Rows.what`; a load is a row, or -1: none, or -2 - k: the held row k
KIND, IS_COUPLED, LOAD_A, LOAD_B, ORIGIN, SOURCE, COLUMN = range(7)
N_WHAT = 7
# where a row comes from: a candidate, a bound of the layout, a friction of the layout
OF_SITE, OF_BOUND, OF_FRICTION = range(3)
# columns of `Rows.number`: the impulse; the row of a normal is J v + bias >= 0; J M^-1 J^T, that without held rows, and
# that with the next row; limits of friction against a growing and a falling measure, by the load or as impulses; the
# rate at the start of the step; what the rate at its end is more than J v; the gap at the start; what closes the gap at
# the end; 1 for an impact; the impulse before a sweep, and the direction of the iteration
IMPULSE, BIAS, OWN, BARE, CROSS, FORWARD, BACK, BEFORE, OPEN, DRIFTING, SHIFT, NEED, IS_IMPACT, LAST, ALONG = range(15)
N_NUMBER = 15
NO_LIMIT = 1e12  # a coefficient of friction that always holds


class Fixtures(NamedTuple):
    """One-sided rows and friction of the layout: stops, strings, brakes."""

    bound: Ints2  # (n, 6): row, sign, tape of the target (-1: a number), rows of two spans (-1: none), has a rate
    bound_number: Floats2  # (n, 6): target, restitution, lows and highs of the spans
    bound_memory: Floats  # impulse of the last step
    friction: (
        Ints2  # (n, 6): row, loads a and b (bounds, or -2 - k: held rows, -1: none), tapes of static and kinetic limit
    )
    friction_number: Floats2  # (n, 4): coefficients, static and kinetic against a growing measure, then a falling one
    friction_memory: Floats
    tape_ptr: Ints
    tape: Ints2
    tape_number: Floats
    registers: Floats2
    row_of_bound: Ints  # in this step; -1: open


class ClosedRows(NamedTuple):
    """The closed rows of one step."""

    count: Ints  # rows, entries, entries of responses, steps of the iteration, closed bounds
    ptr: Ints
    coordinate: Ints
    entry: Floats
    response_ptr: Ints
    response_at: Ints
    response: Floats
    what: Ints2  # (capacity, N_WHAT)
    number: Floats2  # (capacity, N_NUMBER)
    local: Floats  # scratch of one row
    wide: Floats  # scratch of one response


# -- rows of candidates -----------------------------------------------------------------------
@part
def pour(C, m, factor, a, b, local):
    """local += factor times the gradient of a measure: entries of body a, then of body b."""
    o = C.at[m]
    for j in range(C.width[m]):
        body = C.bodies[m, j]
        if body == a:
            for i in range(3):
                local[i] += factor * C.gradient[o + 3 * j + i]
        elif body == b:
            for i in range(3):
                local[3 + i] += factor * C.gradient[o + 3 * j + i]


@part
def begin_row(X, kind, origin, source, column, impulse):
    """A new row without entries; its number."""
    r = X.count[0]
    X.count[0] += 1
    X.what[r, KIND], X.what[r, IS_COUPLED], X.what[r, LOAD_A], X.what[r, LOAD_B] = kind, 0, -1, -1
    X.what[r, ORIGIN], X.what[r, SOURCE], X.what[r, COLUMN] = origin, source, column
    for j in range(N_NUMBER):
        X.number[r, j] = 0.0
    X.number[r, IMPULSE] = impulse
    X.ptr[r] = X.ptr[r + 1] = X.count[1]
    return r


@part
def add_entry(L, X, r, coordinate, value):
    if value != 0.0 and L.inverse_mass[coordinate] > 0.0:
        p = X.count[1]
        X.coordinate[p], X.entry[p] = coordinate, value
        X.count[1] += 1
        X.ptr[r + 1] = X.count[1]


@part
def add_local(L, X, r, a, b):
    for i in range(3):
        add_entry(L, X, r, 3 * a + i, X.local[i])
    for i in range(3):
        add_entry(L, X, r, 3 * b + i, X.local[3 + i])


@part
def rate_of(X, r, v):
    """J v of a row."""
    total = 0.0
    for p in range(X.ptr[r], X.ptr[r + 1]):
        total += X.entry[p] * v[X.coordinate[p]]
    return total


@part
def set_rates(X, r, drift, bias, v, h):
    """Rates at the ends of the step. J is that of the middle: the rate at the start is J v + drift - h/2 bias, that at
    the end J v+ + drift + h/2 bias, with the second derivative `bias` of the measure where nothing accelerates."""
    X.number[r, BEFORE] = rate_of(X, r, v) + drift - 0.5 * h * bias
    X.number[r, BIAS] = X.number[r, DRIFTING] = drift + 0.5 * h * bias


@part
def approach(rate, speed, gained, gap_at_middle, bias, restitution, h):
    """What a normal with the given rate at the start asks for: 0: nothing, its gap cannot close within the step; 1: to
    close no further than to zero; 2: to bounce; and the gap at the start. speed: what the rate could be if all
    velocities were against each other; gained: what loads can add to that. An approach that loads bring about within
    two steps is no impact: a body at rest would bounce forever."""
    gap = gap_at_middle - 0.5 * h * (rate + 0.25 * h * bias)
    if gap > h * (abs(rate) + speed + 2.0 * gained):
        return 0, gap
    if restitution > 0.0 and rate < -2.0 * gained:
        return (0 if gap_at_middle > 0.0 else 2), gap
    return 1, gap


@part
def set_normal(X, n, what, gap, restitution, h):
    """The demand of a normal: u+ >= -e u for an impact, else gap + h u+ >= 0."""
    X.number[n, OPEN] = gap
    if what == 2:
        X.number[n, BIAS] += restitution * X.number[n, BEFORE]
        X.number[n, IS_IMPACT] = 1.0
    else:
        X.number[n, BIAS] += max(gap, 0.0) / h


@kernel
def drop_row(X, n):
    """Takes back the last row."""
    X.count[0], X.count[1] = n, X.ptr[n]


@part
def measure_rate(C, m, v):
    """gradient . v of a measure of the candidates; v by coordinates."""
    total, o = 0.0, C.at[m]
    for j in range(C.width[m]):
        b = 3 * C.bodies[m, j]
        total += C.gradient[o] * v[b] + C.gradient[o + 1] * v[b + 1] + C.gradient[o + 2] * v[b + 2]
        o += 3
    return total


@part
def measure_speeds(C, m, v, free):
    """Sums of the sizes of the terms of gradient . v, and of gradient . (free - v)."""
    speed, gained, o = 0.0, 0.0, C.at[m]
    for j in range(C.width[m]):
        b = 3 * C.bodies[m, j]
        for i in range(3):
            speed += abs(C.gradient[o + i] * v[b + i])
            gained += abs(C.gradient[o + i] * (free[b + i] - v[b + i]))
        o += 3
    return speed, gained


@part
def gap_of(C, s):
    return C.site[s, SIGN] * (C.measures[C.site[s, GAP], 0] - C.number[s, TARGET])


@part
def is_within(C, s, tolerance):
    for j in range(N_SPANS):
        m = C.site[s, SPAN + j]
        if m >= 0:
            x = C.measures[m, 0]
            if x < C.number[s, LOW + j] - tolerance or x > C.number[s, HIGH + j] + tolerance:
                return False
    return True


@part
def add_site(L, C, X, s, v, free, h, still_speed):
    """The rows of a closed site: normal, slip, turn."""
    a, b = C.site[s, FIRST_BODY], C.site[s, SECOND_BODY]
    m, sign, restitution = C.site[s, GAP], C.site[s, SIGN], C.number[s, RESTITUTION]
    bias = sign * C.measures[m, 1]
    speed, gained = measure_speeds(C, m, v, free)
    rate = sign * measure_rate(C, m, v) - 0.5 * h * bias
    what, gap = approach(rate, speed, gained, gap_of(C, s), bias, restitution, h)
    if what == 0:
        return
    n = begin_row(X, NORMAL, OF_SITE, s, NORMAL_IMPULSE, C.memory[s, NORMAL_IMPULSE])
    X.local[:6] = 0.0
    pour(C, m, sign, a, b, X.local)
    add_local(L, X, n, a, b)
    set_rates(X, n, 0.0, bias, v, h)
    set_normal(X, n, what, gap, restitution, h)
    if C.number[s, STATIC] > 0.0:
        r = begin_row(X, FRICTION, OF_SITE, s, SLIP_IMPULSE, C.memory[s, SLIP_IMPULSE])
        X.local[:6] = 0.0
        bias = 0.0
        for j in range(N_TERMS):
            m = C.site[s, SLIP + j]
            if m >= 0:
                slope = C.site[s, SLIP_SIGN] * C.number[s, SLOPE + j]
                pour(C, m, slope, a, b, X.local)
                bias += slope * C.measures[m, 1]
        add_local(L, X, r, a, b)
        set_rates(X, r, 0.0, bias, v, h)
        mu = C.number[s, STATIC] if abs(X.number[r, BEFORE]) <= still_speed else C.number[s, KINETIC]
        X.number[r, FORWARD], X.number[r, BACK] = mu, mu
        X.what[r, LOAD_A], X.what[n, IS_COUPLED] = n, 1
    if C.number[s, ARM] > 0.0:
        r = begin_row(X, FRICTION, OF_SITE, s, TURN_IMPULSE, C.memory[s, TURN_IMPULSE])
        X.local[:6] = 0.0
        pour(C, C.site[s, TURN], 1.0, a, b, X.local)
        add_local(L, X, r, a, b)
        set_rates(X, r, 0.0, 0.0, v, h)
        X.number[r, FORWARD], X.number[r, BACK] = C.number[s, ARM], C.number[s, ARM]
        X.what[r, LOAD_A] = n


@kernel
def separating_edge(C, p, v, half, margin):
    """The edge of a pair of outlines beyond which the other one lies farthest at the start of the step; the last one
    as long as no other is better by more than the margin. The gap there is that at the middle less half a step."""
    chosen, best, kept = -1, 0.0, 0.0
    for e in range(C.pair[p, N_EDGES]):
        least, is_first = 0.0, True
        for s in range(C.pair_ptr[p], C.pair_ptr[p + 1]):
            if C.site[s, EDGE] == e:
                gap = gap_of(C, s) - half * C.site[s, SIGN] * measure_rate(C, C.site[s, GAP], v)
                if is_first or gap < least:
                    least, is_first = gap, False
        if chosen < 0 or least > best:
            chosen, best = e, least
        if e == C.pair[p, CHOSEN]:
            kept = least
    if C.pair[p, CHOSEN] >= 0 and best <= kept + margin:
        chosen = C.pair[p, CHOSEN]
    C.pair[p, CHOSEN] = chosen
    return chosen


@kernel
def facing_edge(C, p, chosen):
    """The edge of the other outline that faces an edge most; -1: it has none."""
    nx, ny, side = 0.0, 0.0, -1
    for s in range(C.pair_ptr[p], C.pair_ptr[p + 1]):
        if C.site[s, EDGE] == chosen:
            o = C.at[C.site[s, GAP]]
            nx, ny, side = C.gradient[o], C.gradient[o + 1], C.site[s, SIDE]
            break
    found, most = -1, 0.0
    for s in range(C.pair_ptr[p], C.pair_ptr[p + 1]):
        if C.site[s, EDGE] >= 0 and C.site[s, SIDE] != side:
            o = C.at[C.site[s, GAP]]
            facing = -(nx * C.gradient[o] + ny * C.gradient[o + 1])
            if found < 0 or facing > most:
                found, most = C.site[s, EDGE], facing
    return found


@kernel
def add_candidates(L, C, X, v, free, h, reach, tolerance, still_speed):
    """Rows of all sites that may close in the step: at its middle their gaps are below `reach`. Of a pair with several
    edges only sites on the edge that separates it count, and on the one that faces it: behind its other edges the gaps
    of a body are negative too. False if the rows have no room."""
    for p in range(len(C.pair)):
        begin, end = C.pair_ptr[p], C.pair_ptr[p + 1]
        nearest = 1e300
        for s in range(begin, end):
            nearest = min(nearest, gap_of(C, s))
        if nearest > reach:
            continue
        if X.count[0] + 3 * (end - begin) + 1 >= len(X.what):
            return False
        chosen, facing = -1, -1
        if C.pair[p, N_EDGES] > 1:
            chosen = separating_edge(C, p, v, 0.5 * h, 4.0 * tolerance)
            facing = facing_edge(C, p, chosen)
        for s in range(begin, end):
            e = C.site[s, EDGE]
            if chosen >= 0 and e >= 0 and e != chosen and e != facing:
                continue
            if gap_of(C, s) <= reach and is_within(C, s, tolerance):
                add_site(L, C, X, s, v, free, h, still_speed)
    return True


# -- rows of the layout -----------------------------------------------------------------------
@kernel
def add_layout_row(L, S, X, r, row, sign):
    for k in range(L.slot_ptr[row], L.slot_ptr[row + 1]):
        b, o = L.slots[k, 0], L.slots[k, 1]
        for i in range(3):
            add_entry(L, X, r, 3 * b + i, sign * S.gradient[o + i])


@kernel
def add_bounds(L, S, F, X, v, free, t, h, tolerance):
    for k in range(len(F.bound)):
        row, sign = F.bound[k, 0], F.bound[k, 1]
        target, moving, bending = F.bound_number[k, 0], 0.0, 0.0
        if F.bound[k, 2] >= 0:
            begin, end = F.tape_ptr[F.bound[k, 2]], F.tape_ptr[F.bound[k, 2] + 1]
            play(begin, end, F.tape, F.tape_number, t, S.rows, F.registers)
            target, moving, bending = F.registers[end - 1, 0], F.registers[end - 1, 1], F.registers[end - 1, 2]
        gap = sign * (S.rows[row, VALUE] - target)
        is_closed = True
        for j in range(2):
            span = F.bound[k, 3 + j]
            if span >= 0:
                x = S.rows[span, VALUE]
                if x < F.bound_number[k, 2 + j] - tolerance or x > F.bound_number[k, 4 + j] + tolerance:
                    is_closed = False
        F.row_of_bound[k] = -1
        if is_closed:
            n = begin_row(X, NORMAL, OF_BOUND, k, 0, F.bound_memory[k])
            add_layout_row(L, S, X, n, row, sign)
            drift = sign * (S.rows[row, DRIFT] - moving)
            bias = sign * (S.rows[row, ROW_BIAS] - bending)
            set_rates(X, n, drift, bias, v, h)
            speed, gained = abs(drift), 0.0
            for p in range(X.ptr[n], X.ptr[n + 1]):
                i = X.coordinate[p]
                speed += abs(X.entry[p] * v[i])
                gained += abs(X.entry[p] * (free[i] - v[i]))
            restitution = F.bound_number[k, 1]
            what, gap = approach(X.number[n, BEFORE], speed, gained, gap, bias, restitution, h)
            if what > 0:
                set_normal(X, n, what, gap, restitution, h)
                F.row_of_bound[k] = n
            else:
                drop_row(X, n)


@kernel
def limit_of(S, F, tape, t):
    begin, end = F.tape_ptr[tape], F.tape_ptr[tape + 1]
    play(begin, end, F.tape, F.tape_number, t, S.rows, F.registers)
    return F.registers[end - 1, 0]


@kernel
def add_dry_friction(L, S, F, X, v, t, h, still_speed):
    """Friction of the layout. Its limits by laws are impulses of the step, those by loads are coefficients."""
    for k in range(len(F.friction)):
        r = begin_row(X, FRICTION, OF_FRICTION, k, 0, F.friction_memory[k])
        add_layout_row(L, S, X, r, F.friction[k, 0], 1.0)
        set_rates(X, r, S.rows[F.friction[k, 0], DRIFT], S.rows[F.friction[k, 0], ROW_BIAS], v, h)
        moves = 0 if abs(X.number[r, BEFORE]) <= still_speed else 1
        if F.friction[k, 3] >= 0:
            X.what[r, LOAD_A] = X.what[r, LOAD_B] = -1
            limit = h * max(0.0, limit_of(S, F, F.friction[k, 3 + moves], t))
            X.number[r, FORWARD] = X.number[r, BACK] = limit
            continue
        X.number[r, FORWARD], X.number[r, BACK] = F.friction_number[k, moves], F.friction_number[k, 2 + moves]
        is_pressed = False
        for j in range(2):
            load = F.friction[k, 1 + j]
            if load >= 0:
                load = F.row_of_bound[load]
            X.what[r, LOAD_A + j] = load
            is_pressed = is_pressed or load != -1
        if not is_pressed:  # nothing touches
            X.number[r, FORWARD] = X.number[r, BACK] = 0.0


# -- responses --------------------------------------------------------------------------------
@kernel
def add_responses(L, S, X, is_jointed, n_passes):
    """Responses of all rows, and the matrix of their own and their neighbour's. False if they have no room."""
    X.count[2] = 0
    n = len(L.inverse_mass)
    for r in range(X.count[0]):
        X.response_ptr[r] = p = X.count[2]
        is_wide = False
        if len(L.held) > 0:
            for k in range(X.ptr[r], X.ptr[r + 1]):
                is_wide = is_wide or is_jointed[X.coordinate[k] // 3] > 0
        if p + (n if is_wide else X.ptr[r + 1] - X.ptr[r]) > len(X.response):
            return False
        bare = 0.0
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
