"""Rows of candidates: places of two outlines that may close in a step, their normals and their friction.

Of two outlines that overlap an edge separates them best; places that lie behind another edge than the chosen one are no
contact.
"""

# pyright: basic

from __future__ import annotations

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
from freebody.numeric.kernels.rows import (
    BACK,
    BEFORE,
    FORWARD,
    FRICTION,
    IS_COUPLED,
    LOAD_A,
    NORMAL,
    OF_SITE,
    add_local,
    approach,
    begin_row,
    set_normal,
    set_rates,
)


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
    # how it closes within the step
    a, b = C.site[s, FIRST_BODY], C.site[s, SECOND_BODY]
    m, sign, restitution = C.site[s, GAP], C.site[s, SIGN], C.number[s, RESTITUTION]
    bias = sign * C.measures[m, 1]
    speed, gained = measure_speeds(C, m, v, free)
    rate = sign * measure_rate(C, m, v) - 0.5 * h * bias
    what, gap = approach(rate, speed, gained, gap_of(C, s), bias, restitution, h)
    if what == 0:
        return
    # its normal
    n = begin_row(X, NORMAL, OF_SITE, s, NORMAL_IMPULSE, C.memory[s, NORMAL_IMPULSE])
    X.local[:6] = 0.0
    pour(C, m, sign, a, b, X.local)
    add_local(L, X, n, a, b)
    set_rates(X, n, 0.0, bias, v, h)
    set_normal(X, n, what, gap, restitution, h)
    # friction along its slip, pressed by the normal: static as long as it is still
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
    # resistance against rolling, mu N with an arm in place of mu
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
    # the least gap beyond each edge, and the edge of which that is largest
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
    # the one before, unless another is better by more than the margin
    if C.pair[p, CHOSEN] >= 0 and best <= kept + margin:
        chosen = C.pair[p, CHOSEN]
    C.pair[p, CHOSEN] = chosen
    return chosen


@kernel
def facing_edge(C, p, chosen):
    """The edge of the other outline that faces an edge most; -1: it has none."""
    # the normal of the edge that was chosen
    nx, ny, side = 0.0, 0.0, -1
    for s in range(C.pair_ptr[p], C.pair_ptr[p + 1]):
        if C.site[s, EDGE] == chosen:
            o = C.at[C.site[s, GAP]]
            nx, ny, side = C.gradient[o], C.gradient[o + 1], C.site[s, SIDE]
            break
    # the edge of the other side whose normal is most against it
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
        # pairs of which nothing comes near need no row
        nearest = 1e300
        for s in range(begin, end):
            nearest = min(nearest, gap_of(C, s))
        if nearest > reach:
            continue
        if X.count[0] + 3 * (end - begin) + 1 >= len(X.what):
            return False
        # of several edges two count
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
