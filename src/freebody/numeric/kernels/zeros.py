"""Where what is watched is zero in a step: its parts are judged by their enclosures, and halved until all is told.

With f, f' and f''/2 on a part in balls (`enclosures`) and the sizes below,

    |f| > resolution throughout                     nothing happens there
    f' has one sign                                 one zero if the ends have unlike signs, else none
    f'' has one sign                                the zero of f' divides the part into two of the kind before
    else, while |f| is not below the resolution     the part is halved

So a zero of the dense output at which it changes its sign is not overlooked, however long the step, unless two of them
lie so close that between them it stays within the resolution; that is then a touch, as is a least value within it.
Source: Moore, Kearfott & Cloud, Introduction to Interval Analysis, 2009, ch. 8.
"""

# pyright: basic

from __future__ import annotations

import math
from typing import NamedTuple

from freebody.numeric.kernels.arrays import Floats, Floats2, Ints2
from freebody.numeric.kernels.declaring import entry, kernel
from freebody.numeric.kernels.enclosures import counted_on, evaluated

NARROWEST = 2.0**-44  # a part of a step that is not divided further
# what is found: a sign change, with the sign after it; a touch; what could not be told apart within the resolution
FALLING, RISING, TOUCH = -1.0, 1.0, 2.0
# what is carried from step to step: the sign that was met last (0: none since it was zero); whether it may just touch
# zero, and since when; where the last touch was
SIDE, IS_NEAR, NEAR_TIME, LAST_TOUCH = range(4)
# how a search ends
DONE, FULL, EXHAUSTED = 0, 1, 2


@kernel
def root_in(code, constants, P, T, t0, h, offset, order, low, high, rises, turns, C, R):
    """The zero of the value (order 0) or of the derivative (order 1) between two places, where it rises or falls
    through it: Newton's method, halving where that leaves the bracket."""
    s = 0.5 * (low + high)
    for _ in range(80):
        last = evaluated(code, constants, 0, len(code), P, T, t0, h, s, 1.0, True, turns, C, R)
        x = C[last, 0] + offset if order == 0 else C[last, 1]
        slope = C[last, 1] if order == 0 else 2.0 * C[last, 2]
        if x == 0.0 or high - low < 1e-16:
            return s
        if (x < 0.0) == rises:
            low = s
        else:
            high = s
        after = s - x / slope if slope != 0.0 else low
        if not low < after < high:
            after = 0.5 * (low + high)
        if abs(after - s) <= 2e-16 * abs(s) or after == s:
            return after
        s = after
    return s


@kernel
def changed_in(code, constants, P, T, t0, h, offset, order, low, high, sign, turns, C, R):
    """Where between two places, within the resolution of zero, the sign of the value (order 0) or of the derivative
    (order 1) becomes that at the end."""
    while True:
        s = 0.5 * (low + high)
        if not low < s < high or high - low < 1e-16:
            return high
        last = evaluated(code, constants, 0, len(code), P, T, t0, h, s, 1.0, True, turns, C, R)
        if (C[last, 0] + offset if order == 0 else C[last, 1]) * sign > 0.0:
            high = s
        else:
            low = s


@kernel
def noted(found, n, s, kind):
    found[n, 0], found[n, 1] = s, kind
    return n + 1


@kernel
def touched(found, n, s, state, t0, h):
    """Notes a touch, but the same one once only: next to the last, or where one step ends and the next begins."""
    if abs(t0 + s * h - state[LAST_TOUCH]) <= 1e-7 * h:
        return n
    state[LAST_TOUCH] = t0 + s * h
    return noted(found, n, s, TOUCH)


@kernel
def sign_of(x, zero):
    return 1.0 if x > zero else (-1.0 if x < -zero else 0.0)


class Watched(NamedTuple):
    """A program in a step from t0 of length h: what is watched is what it gives, and `offset`."""

    code: Ints2
    constants: Floats
    P: Floats2  # the dense output, by powers
    T: Floats
    t0: float
    h: float
    offset: float
    turns: Floats2
    C: Floats2  # registers: centres, and radii
    R: Floats2


# On a part, with f, f' and f''/2 in the balls c0 +- r0, c1 +- r1 and c2 +- r2 for u = -1 ... 1:
#
#     |f - c0| <= r0, and by the mean value  <= rest = |c1| + min(|c2| + r2, r1)
#     |f' - c1| <= r1, and                   <= change = 2 (|c2| + r2)
#
# where the c of a mean value are those of the point u = 0, of which only rounding is uncertain.
@kernel
def judged(W, a, b, resolution):
    """What the enclosures say of a part [a, b]: f and f''/2 in its middle; whether f is known to be finite, and whether
    it is apart from zero; whether f' has one sign, and f''; whether f is within the resolution of zero throughout."""
    m, r = 0.5 * (a + b), 0.5 * (b - a)
    last = evaluated(W.code, W.constants, 0, len(W.code), W.P, W.T, W.t0, W.h, m, r, False, W.turns, W.C, W.R)
    c0, r0, c1, r1 = W.C[last, 0] + W.offset, W.R[last, 0], W.C[last, 1], W.R[last, 1]
    c2, r2 = W.C[last, 2], W.R[last, 2]
    is_clear = abs(c0) - r0 > resolution
    is_known = r0 < math.inf
    rest, change = abs(c1) + min(abs(c2) + r2, r1), 2.0 * (abs(c2) + r2)
    is_monotone = abs(c1) > r1
    if is_known and not is_clear and (abs(c0) - rest > resolution or (abs(c1) > change and not is_monotone)):
        evaluated(W.code, W.constants, 0, len(W.code), W.P, W.T, W.t0, W.h, m, r, True, W.turns, W.C, W.R)
        is_clear = abs(c0) - W.R[last, 0] - rest > resolution
        is_monotone = is_monotone or abs(c1) - W.R[last, 1] > change
    is_bent = abs(c2) > r2
    is_within = abs(c0) + min(r0, rest) <= resolution
    return c0, c2, is_known, is_clear, is_monotone, is_bent, is_within


@kernel
def seen_at(W, s):
    """Value and derivative at a place of the step."""
    last = evaluated(W.code, W.constants, 0, len(W.code), W.P, W.T, W.t0, W.h, s, 1.0, True, W.turns, W.C, W.R)
    return W.C[last, 0] + W.offset, W.C[last, 1]


@kernel
def zero_in(W, order, low, high, rises):
    """`root_in` of what is watched."""
    return root_in(W.code, W.constants, W.P, W.T, W.t0, W.h, W.offset, order, low, high, rises, W.turns, W.C, W.R)


@kernel
def change_in(W, order, low, high, sign):
    """`changed_in` of what is watched."""
    return changed_in(W.code, W.constants, W.P, W.T, W.t0, W.h, W.offset, order, low, high, sign, W.turns, W.C, W.R)


@kernel
def near_since(W, state):
    """The place since which it may just touch zero, no earlier than the step."""
    return max(0.0, (state[NEAR_TIME] - W.t0) / W.h)


# A part that is not divided any further and of which no enclosure says anything holds a jump, a pole, or an angle that
# ceases to be defined. At a pole f changes its sign without a zero: an end is huge, and no side is kept. Where f is not
# known to be finite and both ends are on one side, nothing happens. All else counts as within the resolution.
@kernel
def pass_jump(W, b, fa, is_known, zero, resolution, state):
    """Whether nothing happens in such a part, and the value at its end."""
    fb, _slope = seen_at(W, b)
    huge = 1e18 * zero
    is_pole = not (abs(fa) < huge and abs(fb) < huge) and zero > 0.0
    is_clear = is_pole or (not is_known and fa * fb > 0.0 and min(abs(fa), abs(fb)) > resolution)
    if is_clear:
        state[IS_NEAR] = 0.0
    if is_pole:
        state[SIDE] = 0.0
    return is_clear, fb


# Where f is apart from zero nothing happens on the part itself, but it shows what happened while f was within the
# resolution before it: with another sign than the last one f has changed it, with the same one it has touched zero.
@kernel
def pass_clear(W, a, sign, found, n, state):
    """Notes what a part with one sign ends; how many events were found by then."""
    side = state[SIDE]
    if side == -sign:  # it changed at a jump, or while it was within the resolution
        s = a
        if state[IS_NEAR] > 0.0:
            s = change_in(W, 0, near_since(W, state), a, sign)
        n = noted(found, n, s, sign)
    elif state[IS_NEAR] > 0.0 and side != 0.0:
        s = change_in(W, 1, near_since(W, state), a, side)
        n = touched(found, n, s, state, W.t0, W.h)
    state[SIDE], state[IS_NEAR] = sign, 0.0
    return n


@kernel
def turning_in(W, a, b, da, db, c2):
    """Where f' is zero in a part in which f'' has one sign and f' has unlike ones at the ends."""
    if db == 0.0:
        return b
    if da == 0.0:
        return a
    return zero_in(W, 1, a, b, c2 > 0.0)


# Between two places where f' has one sign f has one zero if its signs there are unlike, else none. A first sign that is
# not the one met last is due to a jump, or to what happened while f was within the resolution.
@kernel
def pass_piece(W, low, f_low, high, f_high, side, zero, was_near, begin, found, n):
    """Notes the zeros between two places in which f is monotone; how many events were found by then, and the side."""
    after = sign_of(f_high, zero)
    before = sign_of(f_low, zero)
    if before == -side and side != 0.0:  # after a jump, or while it was within the resolution
        s = low
        if was_near:
            s = change_in(W, 0, begin, low, before)
        n = noted(found, n, s, before)
        side = before
    if after != 0.0 and after == -side:
        s = low
        if f_low * side > 0.0:
            s = zero_in(W, 0, low, high, after > 0.0)
        n = noted(found, n, s, after)
    if after != 0.0:
        side = after
    return n, side


# On a part where f' or f'' has one sign let f have its least or greatest value fm at m (`has_turn`, else m = b). It
# touches zero if |fm| is within the resolution, the bend is towards the side that f is on, and no end is on the other
# side. Else the one or two pieces in which f is monotone are passed one after the other.
@kernel
def pass_simple(W, a, fa, da, m, fm, b, fb, has_turn, bend, zero, resolution, found, n, state):
    """Notes touches and zeros on such a part; how many events were found by then."""
    side = state[SIDE]
    if side == 0.0:
        side = sign_of(fa, zero)
    is_touch = has_turn and side != 0.0 and bend == side and abs(fm) <= resolution
    if is_touch and sign_of(fb, zero) != -side and sign_of(fa, zero) != -side:
        n = touched(found, n, m, state, W.t0, W.h)
        if sign_of(fb, zero) != 0.0:
            side = sign_of(fb, zero)
    else:
        was_near, begin = state[IS_NEAR] > 0.0, min(a, near_since(W, state))
        if was_near and sign_of(fa, zero) != -side and da * side > 0.0 and side != 0.0:
            s = change_in(W, 1, begin, a, side)
            n = touched(found, n, s, state, W.t0, W.h)
        n, side = pass_piece(W, a, fa, m, fm, side, zero, was_near, begin, found, n)
        if has_turn:
            n, side = pass_piece(W, m, fm, b, fb, side, zero, False, begin, found, n)
    state[SIDE], state[IS_NEAR] = side, 0.0
    return n


@entry
def search(
    code: Ints2,
    constants: Floats,
    P: Floats2,
    t0: float,
    h: float,
    sizes: Floats,
    T: Floats,
    turns: Floats2,
    C: Floats2,
    R: Floats2,
    state: Floats,
    found: Floats2,
    stack: Floats2,
    info: Floats,
) -> int:
    """The events in a step from t0 of length h, in their order; see above. sizes: what is added to the program, below
    what it is zero, the resolution, how many parts may be looked at. state: what is carried from step to step. found:
    places in the step and kinds. info: how many were found, where the search begins and how far it came, how many parts
    were looked at, the value there, value and slope at the end (beyond the resolution: any). Returns how it ended."""
    # where the search begins, and the parts that are left on a stack
    zero, resolution, most = sizes[1], sizes[2], sizes[3]
    W = Watched(code, constants, P, T, t0, h, sizes[0], turns, C, R)
    n, n_parts = 0, 0.0
    start = info[1]
    fa, da = seen_at(W, start)
    if start == 0.0 and len(turns) > 0:
        counted_on(code, constants, turns, C, R)
    info[3] = fa
    stack[0, 0], stack[0, 1] = start, 1.0
    top = 1
    while top > 0:
        top -= 1
        a, b = stack[top, 0], stack[top, 1]
        if n + 4 > len(found) or n_parts >= most:
            info[0], info[1], info[2] = n, a, n_parts
            return FULL if n + 4 > len(found) else EXHAUSTED
        n_parts += 1.0
        # what the enclosures say of the next part; nothing: it is halved, or holds a jump
        c0, c2, is_known, is_clear, is_monotone, is_bent, is_within = judged(W, a, b, resolution)
        if not is_known or not (is_clear or is_monotone or is_bent or is_within):
            if b - a > NARROWEST and top + 2 <= len(stack):
                middle = 0.5 * (a + b)
                stack[top, 0], stack[top, 1] = middle, b
                stack[top + 1, 0], stack[top + 1, 1] = a, middle
                top += 2
                continue
            is_clear, c0 = pass_jump(W, b, fa, is_known, zero, resolution, state)
        # one sign throughout; else monotone, or with one turn; else all within the resolution
        if is_clear:
            n = pass_clear(W, a, 1.0 if c0 > 0.0 else -1.0, found, n, state)
            fa, da = c0, 0.0
            if b < 1.0 or len(turns) > 0:
                fa, da = seen_at(W, b)
        else:
            fb, db = seen_at(W, b)
            m, fm = b, fb
            has_turn = not is_monotone and is_bent and da * db <= 0.0
            if has_turn:
                m = turning_in(W, a, b, da, db, c2)
                fm, _slope = seen_at(W, m)
            if is_monotone or is_bent:
                bend = 1.0 if c2 > 0.0 else -1.0
                n = pass_simple(W, a, fa, da, m, fm, b, fb, has_turn, bend, zero, resolution, found, n, state)
            elif state[IS_NEAR] == 0.0:
                state[IS_NEAR], state[NEAR_TIME] = 1.0, t0 + a * h
            if len(turns) > 0:
                seen_at(W, b)
            fa, da = fb, db
        if len(turns) > 0:
            counted_on(code, constants, turns, C, R)
    # it may touch zero where the step ends: what follows decides
    if state[IS_NEAR] == 0.0 and state[SIDE] != 0.0 and abs(fa) <= resolution and da * state[SIDE] <= 0.0:
        state[IS_NEAR], state[NEAR_TIME] = 1.0, t0 + h
    info[0], info[1], info[2], info[4], info[5] = n, 1.0, n_parts, fa, da
    return DONE
