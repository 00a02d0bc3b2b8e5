"""Enclosures of what is watched over whole parts of a step, and where it is zero in a step.

On a part [a, b] of a step the dense output is a polynomial in u = -1 ... 1. A register holds three balls, which contain
f(u), f'(u) and f''(u)/2 for every u, and whose centres are those of u = 0: a polynomial is developed about the middle,

    p(u) = sum c_k u^k,    |p^(k)(u)/k! - c_k| <= sum over j > k of (j over k) |c_j|,

and balls are added, multiplied and put into functions as Taylor coefficients are, every radius enlarged by what
rounding may have done. With the mean value form, |f(u) - f(0)| <= max |f'|, and the sizes below:

    |f| > resolution throughout                     nothing happens there
    f' has one sign                                 one zero if the ends have unlike signs, else none
    f'' has one sign                                the zero of f' divides the part into two of the kind before
    else, while |f| is not below the resolution     the part is halved

So a zero of the dense output at which it changes its sign is not overlooked, however long the step, unless two of them
lie so close that between them it stays within the resolution; that is then a touch, as is a least value within it.
Source: Moore, Kearfott & Cloud, Introduction to Interval Analysis, 2009, ch. 6 and 8; Griewank & Walther, Evaluating
Derivatives, 2nd ed. 2008, ch. 13 (Taylor coefficients).
"""

# pyright: basic

from __future__ import annotations

import math
from typing import NamedTuple

from freebody.numeric.kernels.arrays import Floats, Floats2, Ints, Ints2
from freebody.numeric.kernels.declaring import entry, kernel
from freebody.numeric.kernels.operations import (
    ABS,
    ACOS,
    ADD,
    ARGUMENT,
    ASIN,
    ATAN,
    CONSTANT,
    COS,
    COSH,
    DIVIDE,
    EXP,
    INPUT,
    LOG,
    MULTIPLY,
    POWER,
    SIGN,
    SIN,
    SINH,
    SQRT,
    SUBTRACT,
    TANH,
    TIME,
)

EPS = 2.3e-16
N_TERMS = 8  # of a dense output: degree 7
NARROWEST = 2.0**-44  # a part of a step that is not divided further
# what is found: a sign change, with the sign after it; a touch; what could not be told apart within the resolution
FALLING, RISING, TOUCH = -1.0, 1.0, 2.0
# what is carried from step to step: the sign that was met last (0: none since it was zero); whether it may just touch
# zero, and since when; where the last touch was
SIDE, IS_NEAR, NEAR_TIME, LAST_TOUCH = range(4)
# how a search ends
DONE, FULL, EXHAUSTED = 0, 1, 2


@kernel
def widened(r, c):
    """A radius enlarged by the rounding of an operation with the result c; what is undefined may be anything."""
    x = r * (1.0 + 4.0 * EPS) + EPS * abs(c)
    return x if x == x else math.inf


@kernel
def product(C, R, i, m, j, n):
    """The product of the coefficients m and n of two registers."""
    a, b = C[i, m], C[j, n]
    p, q = R[i, m], R[j, n]
    c = a * b
    r = 0.0
    if q > 0.0 and (a != 0.0 or p > 0.0):
        r += (abs(a) + p) * q
    if p > 0.0 and b != 0.0:
        r += p * abs(b)
    return c, widened(r, c)


@kernel
def times(c, r, d, q):
    """The product of two balls."""
    x = c * d
    y = 0.0
    if q > 0.0 and (c != 0.0 or r > 0.0):
        y += (abs(c) + r) * q
    if r > 0.0 and d != 0.0:
        y += r * abs(d)
    return x, widened(y, x)


@kernel
def chained(C, R, k, i, f, fr, d, dr, e, er):
    """Register k becomes phi(register i), from balls of phi, phi' and phi''/2."""
    C[k, 0], R[k, 0] = f, widened(fr, f)
    x, y = times(d, dr, C[i, 1], R[i, 1])
    C[k, 1], R[k, 1] = x, y
    a, b = times(d, dr, C[i, 2], R[i, 2])
    s, t = times(C[i, 1], R[i, 1], C[i, 1], R[i, 1])
    s, t = times(s, t, e, er)
    C[k, 2], R[k, 2] = a + s, widened(b + t, abs(a) + abs(s))


@kernel
def over(op, x):
    """A monotone function of a number."""
    if op == SQRT:
        return math.sqrt(x) if x >= 0.0 else math.nan
    if op == EXP:
        return math.exp(x) if x < 700.0 else math.inf
    if op == LOG:
        return math.log(x) if x > 0.0 else math.nan
    if op == ASIN:
        return math.asin(x) if -1.0 <= x <= 1.0 else math.nan
    if op == ACOS:
        return math.acos(x) if -1.0 <= x <= 1.0 else math.nan
    if op == ATAN:
        return math.atan(x)
    if op == SINH:
        return math.sinh(x) if abs(x) < 700.0 else math.nan
    if op == TANH:
        return math.tanh(x)
    return math.tan(x)


@kernel
def spread(op, c, r, f):
    """How far a monotone function with the value f at c may be from it in the ball."""
    return max(abs(over(op, c + r) - f), abs(f - over(op, c - r))) + 4.0 * EPS * abs(f)


@kernel
def function(C, R, op, k, i):
    """Register k becomes an elementary function of register i."""
    c, r = C[i, 0], R[i, 0]
    if op in (SIN, COS):
        s, o = math.sin(c), math.cos(c)
        w = min(r, 2.0) + EPS
        if op == SIN:
            chained(C, R, k, i, s, min(abs(o) * r + 0.5 * r * r, w) + EPS, o, w, -0.5 * s, w)
        else:
            chained(C, R, k, i, o, min(abs(s) * r + 0.5 * r * r, w) + EPS, -s, w, -0.5 * o, w)
        return
    if op in (ABS, SIGN):
        sign = 1.0 if c > 0.0 else (-1.0 if c < 0.0 else 0.0)
        if abs(c) > r:
            if op == ABS:
                chained(C, R, k, i, abs(c), r, sign, 0.0, 0.0, 0.0)
            else:
                chained(C, R, k, i, sign, 0.0, 0.0, 0.0, 0.0, 0.0)
        elif op == ABS:
            chained(C, R, k, i, abs(c), r, sign, 2.0, 0.0, math.inf)
        else:
            chained(C, R, k, i, sign, 2.0, 0.0, math.inf, 0.0, math.inf)
        return
    if op == COSH:
        f, g = math.cosh(min(abs(c), 700.0)), math.sinh(max(-700.0, min(c, 700.0)))
        far = math.cosh(abs(c) + r) if abs(c) + r < 700.0 else math.inf
        wide = min(r * far, max(far - f, f - 1.0)) + EPS * f
        chained(C, R, k, i, f, wide, g, r * far, 0.5 * f, wide)
        return
    f = over(op, c)
    if op == SQRT:
        low = c - r
        if low > 0.0:
            d, e = 0.5 / f, -0.125 / (f * c)
            lower = math.sqrt(low)
            chained(C, R, k, i, f, f - lower + EPS * f, d, 0.5 / lower - d + EPS * d, e, 0.125 / (lower * low) + e)
        else:
            top = math.sqrt(max(c + r, 0.0))
            f = f if f == f else 0.0
            wide = max(top - f, f) if c + r >= 0.0 else math.inf
            chained(C, R, k, i, f, wide, 0.5 / f if f > 0.0 else 0.0, math.inf, 0.0, math.inf)
        return
    if op in (ASIN, ACOS):  # the argument cannot leave the domain
        top, bottom = over(op, max(-1.0, min(1.0, c + r))), over(op, max(-1.0, min(1.0, c - r)))
        f = over(op, max(-1.0, min(1.0, c)))
        wide = max(abs(top - f), abs(f - bottom)) + 4.0 * EPS
    else:
        wide = spread(op, c, r, f)
    if op == EXP:
        chained(C, R, k, i, f, wide, f, wide, 0.5 * f, 0.5 * wide)
        return
    if op == LOG:
        if c > r:
            d = 1.0 / c
            dr = r * d / (c - r)
            e, er = times(d, dr, d, dr)
            chained(C, R, k, i, f, wide, d, widened(dr, d), -0.5 * e, 0.5 * er)
        else:
            chained(C, R, k, i, f if f == f else 0.0, math.inf, 0.0, math.inf, 0.0, math.inf)
        return
    if op == ATAN:
        s, t = times(c, r, c, r)
        s, t = 1.0 + s, widened(t, 1.0 + s)
        low = max(s - t, 1.0)
        d = 1.0 / s
        dr = widened(min(t * d / low, 1.0), d)
        e, er = times(d, dr, d, dr)
        e, er = times(e, er, -c, r)
        chained(C, R, k, i, f, wide, d, dr, e, er)
        return
    if op in (ASIN, ACOS):
        if abs(c) + r < 1.0:
            sign = 1.0 if op == ASIN else -1.0
            d = 1.0 / math.sqrt(1.0 - c * c)
            near, far = max(0.0, abs(c) - r), abs(c) + r
            dr = max(1.0 / math.sqrt(1.0 - far * far) - d, d - 1.0 / math.sqrt(1.0 - near * near))
            dr = widened(dr, 8.0 * d)
            e, er = times(d, dr, d, dr)
            e, er = times(e, er, d, dr)
            e, er = times(e, er, 0.5 * c, 0.5 * r)
            chained(C, R, k, i, f, wide, sign * d, dr, sign * e, er)
        else:
            chained(C, R, k, i, f, wide, 0.0, math.inf, 0.0, math.inf)
        return
    if op == SINH:
        g = math.cosh(min(abs(c), 700.0))
        far = math.cosh(abs(c) + r) if abs(c) + r < 700.0 else math.inf
        chained(C, R, k, i, f, wide, g, r * far, 0.5 * f, 0.5 * wide)
        return
    if op == TANH:
        s, t = times(f, wide, f, wide)
        d, dr = 1.0 - s, widened(t, 1.0)
        e, er = times(d, dr, -f, wide)
        chained(C, R, k, i, f, wide, d, dr, e, er)
        return
    # the tangent: monotone unless a pole is in the ball
    if abs(math.cos(c)) > r + EPS:
        s, t = times(f, wide, f, wide)
        d, dr = 1.0 + s, widened(t, 1.0 + s)
        e, er = times(d, dr, f, wide)
        chained(C, R, k, i, f, wide, d, dr, e, er)
    else:
        chained(C, R, k, i, f, math.inf, 0.0, math.inf, 0.0, math.inf)


@kernel
def power(C, R, k, i, n):
    """Register k becomes a broken power of register i."""
    c, r = C[i, 0], R[i, 0]
    if not c > r:
        C[k, 0] = c**n if c > 0.0 else 0.0
        C[k, 1] = C[k, 2] = 0.0
        R[k, 0] = R[k, 1] = R[k, 2] = math.inf
        return
    f = c**n
    d, e = n * f / c, 0.5 * n * (n - 1.0) * f / (c * c)
    low, high = c - r, c + r
    wide = max(abs(high**n - f), abs(low**n - f)) + 8.0 * EPS * abs(f)
    slope = max(abs(n * high ** (n - 1.0) - d), abs(n * low ** (n - 1.0) - d)) + 8.0 * EPS * abs(d)
    bend = abs(0.5 * n * (n - 1.0))
    curve = bend * max(abs(high ** (n - 2.0) - c ** (n - 2.0)), abs(low ** (n - 2.0) - c ** (n - 2.0)))
    chained(C, R, k, i, f, wide, d, slope, e, curve + 8.0 * EPS * abs(e))


@kernel
def argument(C, R, k, i, j, from_x, from_y, base):
    """Register k becomes the angle of the vector (x, y) = (register i, register j), counted on from a direction in the
    same part, at which it is `base`. A disc without the origin is seen at less than half a turn."""
    x, y = C[i, 0], C[j, 0]
    r = math.hypot(R[i, 0], R[j, 0])
    s = x * x + y * y
    far = math.sqrt(s)
    c = base + math.atan2(from_x * y - from_y * x, from_x * x + from_y * y)
    C[k, 0] = c
    if not far > r * (1.0 + 1e-14):
        C[k, 1] = C[k, 2] = 0.0
        R[k, 0] = R[k, 1] = R[k, 2] = math.inf
        return
    R[k, 0] = widened(math.asin(min(1.0, r / far)), c) + 8.0 * EPS
    # (x y' - y x') / s, and its derivative by half
    a, b = product(C, R, i, 0, j, 1)
    d, e = product(C, R, j, 0, i, 1)
    n, m = a - d, widened(b + e, abs(a) + abs(d))
    low, high = (far - r) * (far - r), (far + r) * (far + r)
    inverse = 1.0 / s
    spread_of = widened(max(1.0 / low - inverse, inverse - 1.0 / high), 8.0 * inverse)
    C[k, 1], R[k, 1] = times(n, m, inverse, spread_of)
    a, b = product(C, R, i, 0, j, 2)
    d, e = product(C, R, j, 0, i, 2)
    g, h = a - d, widened(b + e, abs(a) + abs(d))
    a, b = product(C, R, i, 0, i, 1)
    d, e = product(C, R, j, 0, j, 1)
    p, q = times(a + d, widened(b + e, abs(a) + abs(d)), C[k, 1], R[k, 1])
    C[k, 2], R[k, 2] = times(g - p, widened(h + q, abs(g) + abs(p)), inverse, spread_of)


@kernel
def developed(P, T, i, m, r, is_point, C, R, k):
    """Register k becomes an entry of the state, of which P[i] are the coefficients by powers of the part of the step,
    on the part of half the width r about m."""
    size, steep, bent = 0.0, 0.0, 0.0
    for j in range(N_TERMS):
        T[j] = P[i, j]
        x = abs(P[i, j])
        size += x
        steep += j * x
        bent += j * j * x
    for n in range(N_TERMS - 1):
        for j in range(N_TERMS - 2, n - 1, -1):
            T[j] += m * T[j + 1]
    x0, x1, x2 = 0.0, 0.0, 0.0
    if not is_point:
        power_of_r = 1.0
        for j in range(1, N_TERMS):
            power_of_r *= r
            x = abs(T[j]) * power_of_r
            x0 += x
            if j > 1:
                x1 += j * x
            if j > 2:
                x2 += 0.5 * j * (j - 1) * x
    C[k, 0], C[k, 1], C[k, 2] = T[0], T[1] * r, T[2] * r * r
    noise = N_TERMS * EPS
    R[k, 0] = widened(x0 + noise * size, 0.0)
    R[k, 1] = widened(x1 + noise * steep * r, 0.0)
    R[k, 2] = widened(x2 + noise * bent * r * r, 0.0)


@kernel
def evaluated(code, constants, begin, end, P, T, t0, h, m, r, is_point, turns, C, R):
    """Fills the registers of a program, the operations from `begin` to `end`, for the part of half the width r about m,
    or for the point m alone. Returns the last register."""
    last = end - begin - 1
    for k in range(last + 1):
        op, i, j, constant = code[begin + k, 0], code[begin + k, 1], code[begin + k, 2], constants[begin + k]
        if op == CONSTANT:
            C[k, 0], R[k, 0] = constant, 0.0
            C[k, 1] = C[k, 2] = R[k, 1] = R[k, 2] = 0.0
        elif op == TIME:
            C[k, 0], C[k, 1], C[k, 2] = t0 + m * h, r * h, 0.0
            R[k, 0] = 4.0 * EPS * (abs(t0) + h) + (0.0 if is_point else r * h)
            R[k, 1], R[k, 2] = EPS * r * h, 0.0
        elif op == INPUT:
            developed(P, T, i, m, r, is_point, C, R, k)
        elif op in (ADD, SUBTRACT):
            sign = 1.0 if op == ADD else -1.0
            for n in range(3):
                C[k, n] = C[i, n] + sign * C[j, n]
                R[k, n] = widened(R[i, n] + R[j, n], C[k, n])
        elif op == MULTIPLY:
            for n in range(3):
                c, w = 0.0, 0.0
                for p in range(n + 1):
                    x, y = product(C, R, i, p, j, n - p)
                    c += x
                    w += y + EPS * abs(x)
                C[k, n], R[k, n] = c, w if w == w else math.inf
        elif op == DIVIDE:
            b, q = C[j, 0], R[j, 0]
            d = 1.0 / b if b != 0.0 else 0.0
            dr = widened(q * abs(d) / (abs(b) - q), d) if abs(b) > q else math.inf
            c, w = times(C[i, 0], R[i, 0], d, dr)
            C[k, 0], R[k, 0] = c, w
            x, y = times(c, w, C[j, 1], R[j, 1])
            c, w = times(C[i, 1] - x, widened(R[i, 1] + y, abs(C[i, 1]) + abs(x)), d, dr)
            C[k, 1], R[k, 1] = c, w
            x, y = times(c, w, C[j, 1], R[j, 1])
            z, v = times(C[k, 0], R[k, 0], C[j, 2], R[j, 2])
            noise = abs(C[i, 2]) + abs(x) + abs(z)
            C[k, 2], R[k, 2] = times(C[i, 2] - x - z, widened(R[i, 2] + y + v, noise), d, dr)
        elif op == POWER:
            power(C, R, k, i, constant)
        elif op == ARGUMENT:
            n = int(constant)
            argument(C, R, k, i, j, turns[n, 0], turns[n, 1], turns[n, 2])
        else:
            function(C, R, op, k, i)
    return last


@kernel
def counted_on(code, constants, turns, C, R):
    """Angles are counted on from the point that was evaluated last."""
    for k in range(len(code)):
        if code[k, 0] == ARGUMENT:
            n = int(constants[k])
            turns[n, 0], turns[n, 1], turns[n, 2] = C[code[k, 1], 0], C[code[k, 2], 0], C[k, 0]


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
        c0, c2, is_known, is_clear, is_monotone, is_bent, is_within = judged(W, a, b, resolution)
        if not is_known or not (is_clear or is_monotone or is_bent or is_within):
            if b - a > NARROWEST and top + 2 <= len(stack):
                middle = 0.5 * (a + b)
                stack[top, 0], stack[top, 1] = middle, b
                stack[top + 1, 0], stack[top + 1, 1] = a, middle
                top += 2
                continue
            is_clear, c0 = pass_jump(W, b, fa, is_known, zero, resolution, state)
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


@entry
def sifted(
    code: Ints2,
    constants: Floats,
    ptr: Ints,
    P: Floats2,
    t0: float,
    h: float,
    offsets: Floats,
    resolutions: Floats,
    T: Floats,
    turns: Floats2,
    C: Floats2,
    R: Floats2,
    signs: Floats,
) -> None:
    """signs[g]: the sign that program g has throughout a step, 0 if that cannot be said at once. With h = 0 the values
    where the step begins."""
    for g in range(len(ptr) - 1):
        begin, end = ptr[g], ptr[g + 1]
        if h == 0.0:
            last = evaluated(code, constants, begin, end, P, T, t0, h, 0.0, 1.0, True, turns, C, R)
            signs[g] = C[last, 0] + offsets[g]
            continue
        last = evaluated(code, constants, begin, end, P, T, t0, h, 0.5, 0.5, False, turns, C, R)
        c0, r0 = C[last, 0] + offsets[g], R[last, 0]
        rest = abs(C[last, 1]) + min(abs(C[last, 2]) + R[last, 2], R[last, 1])
        signs[g] = 0.0
        if abs(c0) - r0 > resolutions[g]:
            signs[g] = 1.0 if c0 > 0.0 else -1.0
        elif r0 < math.inf and abs(c0) - rest > resolutions[g]:
            evaluated(code, constants, begin, end, P, T, t0, h, 0.5, 0.5, True, turns, C, R)
            if abs(c0) - rest - R[last, 0] > resolutions[g]:
                signs[g] = 1.0 if c0 > 0.0 else -1.0


@entry
def powers(dense: Floats2, old: Floats, inputs: Ints, P: Floats2) -> None:
    """P[i]: the coefficients by powers of s of the entry i of the state, from the terms of a dense output, which are
    nested by s and 1 - s in turn (`stepping.between`). inputs: which entries."""
    n_terms = len(dense)
    for k in range(len(inputs)):
        i = inputs[k]
        for j in range(N_TERMS):
            P[i, j] = 0.0
        for n in range(n_terms - 1, -1, -1):
            P[i, 0] += dense[n, i]
            if n % 2 == 0:
                for j in range(N_TERMS - 1, 0, -1):
                    P[i, j] = P[i, j - 1]
                P[i, 0] = 0.0
            else:
                for j in range(N_TERMS - 1, 0, -1):
                    P[i, j] -= P[i, j - 1]
        P[i, 0] += old[i]
