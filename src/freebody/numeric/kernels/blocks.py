"""The impulses of one step: complementarity of normals with Coulomb friction, block by block.

    0 <= J_n v + e J_n v_before  _|_  P_n >= 0,        -mu P_n <= P_t <= mu P_n,   P_t at a limit where J_t v != 0

A block is one normal and the friction that it presses. With what else acts fixed, its velocities are b + W P, W of two
by two, and the law has one solution, tried in the order open, sticking, sliding. Blocks are visited again and again,
each with the latest velocities (nonsmooth Gauss-Seidel); a sweep that changes no velocity by more than the tolerance is
the last. Source: Jean, Comput. Methods Appl. Mech. Engrg. 177 (1999) 235; Acary & Brogliato, Numerical Methods for
Nonsmooth Dynamical Systems, 2008, sec. 10.1 and 13.7.
"""

# pyright: basic

from __future__ import annotations

import math

from freebody.numeric.kernels.declaring import kernel, part
from freebody.numeric.kernels.rows import (
    ALONG,
    BACK,
    BIAS,
    CROSS,
    DRIFTING,
    FORWARD,
    IMPULSE,
    IS_COUPLED,
    KIND,
    LAST,
    LOAD_A,
    LOAD_B,
    NEED,
    NORMAL,
    OPEN,
    OWN,
    SHIFT,
    rate_of,
)

CORRECTED = 0.2  # part of a penetration that is taken back in one step


@part
def apply_impulse(X, r, impulse, v):
    """What an impulse along a row does to velocities."""
    for k in range(X.response_ptr[r], X.response_ptr[r + 1]):
        v[X.response_at[k]] += impulse * X.response[k]


@kernel
def block_impulses(bn, bt, wnn, wnt, wtt, forward, back):
    """P_n, P_t of one block with the velocities bn + wnn P_n + wnt P_t and bt + wnt P_n + wtt P_t."""
    if bn >= 0.0:
        return 0.0, 0.0
    if not wtt > 0.0:
        return -bn / wnn, 0.0
    determinant = wnn * wtt - wnt * wnt
    side = 1.0 if bt < 0.0 else -1.0
    if determinant > 1e-12 * wnn * wtt:
        n, t = (bt * wnt - bn * wtt) / determinant, (bn * wnt - bt * wnn) / determinant
        if n >= 0.0 and -forward * n <= t <= back * n:
            return n, t
        if n > 0.0:
            side = 1.0 if t > 0.0 else -1.0
    for _ in range(2):
        ratio = back if side > 0.0 else -forward
        stiffness = wnn + ratio * wnt
        if stiffness > 1e-12 * wnn:
            n = -bn / stiffness
            slip = bt + (wnt + ratio * wtt) * n
            if slip * side <= 0.0:
                return n, ratio * n
        side = -side
    # no sliding is consistent with a rigid contact here (Painleve): the normal alone stops it
    n = -bn / wnn
    return n, min(max(-(bt + wnt * n) / wtt, -forward * n), back * n)


@kernel
def load_of(X, r, held_impulse):
    """What presses the friction of a row."""
    a, b = X.what[r, LOAD_A], X.what[r, LOAD_B]
    if a == -1 and b == -1:
        return 1.0  # its limits are impulses
    x = X.number[a, IMPULSE] if a >= 0 else (held_impulse[-2 - a] if a < -1 else 0.0)
    if b == -1:
        return abs(x)
    y = X.number[b, IMPULSE] if b >= 0 else held_impulse[-2 - b]
    return math.hypot(x, y)


@kernel
def sweep(X, v, held_impulse, is_backward):
    """Visits all blocks once; returns the largest change of a velocity."""
    n_rows = X.count[0]
    largest = 0.0
    for i in range(n_rows):
        r = n_rows - 1 - i if is_backward else i
        own = X.number[r, OWN]
        if X.what[r, KIND] == NORMAL:
            if not own > 0.0:
                continue
            bn = rate_of(X, r, v) + X.number[r, BIAS] - own * X.number[r, IMPULSE]
            if X.what[r, IS_COUPLED] > 0:
                t = r + 1
                cross, tangential = X.number[r, CROSS], X.number[t, OWN]
                before_n, before_t = X.number[r, IMPULSE], X.number[t, IMPULSE]
                bn -= cross * before_t
                bt = rate_of(X, t, v) + X.number[t, BIAS] - cross * before_n - tangential * before_t
                pn, pt = block_impulses(bn, bt, own, cross, tangential, X.number[t, FORWARD], X.number[t, BACK])
                if pt != before_t:
                    apply_impulse(X, t, pt - before_t, v)
                    X.number[t, IMPULSE] = pt
                    largest = max(largest, abs(pt - before_t) * tangential)
            else:
                before_n = X.number[r, IMPULSE]
                pn = max(0.0, -bn / own)
            if pn != before_n:
                apply_impulse(X, r, pn - before_n, v)
                X.number[r, IMPULSE] = pn
                largest = max(largest, abs(pn - before_n) * own)
        elif X.what[r, LOAD_A] < 0 or X.what[X.what[r, LOAD_A], IS_COUPLED] == 0 or X.what[r, LOAD_A] != r - 1:
            if not own > 0.0:
                continue
            load, before = load_of(X, r, held_impulse), X.number[r, IMPULSE]
            wanted = before - (rate_of(X, r, v) + X.number[r, BIAS]) / own
            p = min(max(wanted, -X.number[r, FORWARD] * load), X.number[r, BACK] * load)
            if p != before:
                apply_impulse(X, r, p - before, v)
                X.number[r, IMPULSE] = p
                largest = max(largest, abs(p - before) * own)
    return largest


@kernel
def accelerated(X, v, before, is_first):
    """Nonlinear conjugate gradients with a sweep in the place of the gradient step: goes on along the last direction as
    far as the changes of two sweeps suggest (Fletcher-Reeves). Returns the square of the change, by mobilities.
    Source: Silcowitz-Hansen, Niebe & Erleben, The Visual Computer 26 (2010) 893."""
    square = 0.0
    for r in range(X.count[0]):
        change = X.number[r, IMPULSE] - X.number[r, LAST]
        square += X.number[r, OWN] * change * change
    beta = 0.0 if is_first or not before > 0.0 else square / before
    is_restarted = not beta <= 1.0
    for r in range(X.count[0]):
        change = X.number[r, IMPULSE] - X.number[r, LAST]
        if is_first or is_restarted:
            X.number[r, ALONG] = 0.0 if is_restarted else change
        else:
            along = beta * X.number[r, ALONG]
            if along != 0.0 and X.number[r, IMPULSE] != 0.0:
                X.number[r, IMPULSE] += along
                apply_impulse(X, r, along, v)
            X.number[r, ALONG] = along + change
    return square


@kernel
def note_impulses(X):
    for r in range(X.count[0]):
        X.number[r, LAST] = X.number[r, IMPULSE]


@kernel
def start_from_memory(X, v):
    """Velocities with the impulses of the last step."""
    for r in range(X.count[0]):
        if not X.number[r, OWN] > 0.0:
            X.number[r, IMPULSE] = 0.0
        if X.number[r, IMPULSE] != 0.0:
            apply_impulse(X, r, X.number[r, IMPULSE], v)


@kernel
def correct(X, q, v, w, h, tolerance, most_sweeps):
    """Moves q by the least, in the metric of the masses, out of gaps that are negative at the end of the step, to first
    order; no velocity changes. w: by what the pose moves in a unit of time. Returns the deepest penetration before."""
    deepest = 0.0
    for r in range(X.count[0]):
        X.number[r, SHIFT] = 0.0
        if X.what[r, KIND] == NORMAL and X.number[r, OWN] > 0.0:
            gap = X.number[r, OPEN] + h * (rate_of(X, r, w) + X.number[r, DRIFTING])
            # to be closed to zero if it is too deep, kept from becoming so if not
            X.number[r, NEED] = CORRECTED * gap if gap < -tolerance else gap + tolerance
            deepest = max(deepest, -gap)
    if not deepest > tolerance:
        return deepest
    moved = X.wide
    for i in range(len(moved)):
        moved[i] = 0.0
    for s in range(most_sweeps):
        largest, n_rows = 0.0, X.count[0]
        for i in range(n_rows):
            r = i if s % 2 == 0 else n_rows - 1 - i
            if X.what[r, KIND] != NORMAL or not X.number[r, OWN] > 0.0:
                continue
            before = X.number[r, SHIFT]
            after = max(0.0, before - (rate_of(X, r, moved) + X.number[r, NEED]) / X.number[r, OWN])
            if after != before:
                apply_impulse(X, r, after - before, moved)
                X.number[r, SHIFT] = after
                largest = max(largest, abs(after - before) * X.number[r, OWN])
        if largest <= 0.1 * CORRECTED * deepest:
            break
    for i in range(len(q)):
        q[i] += moved[i]
    return deepest
