"""Elementary functions of balls: phi, phi' and phi''/2 over a ball, from their values at its centre.

A monotone function is widest at the ends of the ball; a function with a pole or the end of its domain in it has a
radius without end there. The angle of a vector is counted on from a direction in the same part.
"""

# pyright: basic

from __future__ import annotations

import math

from freebody.numeric.kernels.balls import EPS, chained, product, times, widened
from freebody.numeric.kernels.declaring import kernel
from freebody.numeric.kernels.fresnel import fresnel
from freebody.numeric.kernels.operations import (
    ABS,
    ACOS,
    ASIN,
    ATAN,
    COS,
    COSH,
    EXP,
    FRESNEL_C,
    FRESNEL_S,
    LOG,
    SIGN,
    SIN,
    SINH,
    SQRT,
    TANH,
)


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


# Of each: register k becomes the function of register i, with the centre c and the radius r.
@kernel
def circular(C, R, op, k, i, c, r):
    """Sine and cosine, of which no derivative is larger than 1."""
    s, o = math.sin(c), math.cos(c)
    w = min(r, 2.0) + EPS
    if op == SIN:
        chained(C, R, k, i, s, min(abs(o) * r + 0.5 * r * r, w) + EPS, o, w, -0.5 * s, w)
    else:
        chained(C, R, k, i, o, min(abs(s) * r + 0.5 * r * r, w) + EPS, -s, w, -0.5 * o, w)


@kernel
def fresnel_integral(C, R, op, k, i, c, r):
    """Their slopes are cosine and sine of pi x^2/2, of which neither is larger than 1; half of their second
    derivatives, -pi x/2 sin(pi x^2/2) and pi x/2 cos(pi x^2/2), are so large at most as pi |x|/2."""
    s, o = math.sin(0.5 * math.pi * c * c), math.cos(0.5 * math.pi * c * c)
    far = 0.5 * math.pi * (abs(c) + r)
    w = min(2.0 * far * r, 2.0) + 8.0 * EPS * (1.0 + far * far)
    if op == FRESNEL_C:
        chained(C, R, k, i, fresnel(c, False), r + 8.0 * EPS, o, w, -0.5 * math.pi * c * s, far * (1.0 + EPS))
    else:
        chained(C, R, k, i, fresnel(c, True), r + 8.0 * EPS, s, w, 0.5 * math.pi * c * o, far * (1.0 + EPS))


@kernel
def signed(C, R, op, k, i, c, r):
    """The absolute value and the sign: smooth where zero is not in the ball."""
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


@kernel
def hyperbolic_cosine(C, R, k, i, c, r):
    """Not monotone: least at zero."""
    f, g = math.cosh(min(abs(c), 700.0)), math.sinh(max(-700.0, min(c, 700.0)))
    far = math.cosh(abs(c) + r) if abs(c) + r < 700.0 else math.inf
    wide = min(r * far, max(far - f, f - 1.0)) + EPS * f
    chained(C, R, k, i, f, wide, g, r * far, 0.5 * f, wide)


@kernel
def root(C, R, k, i, c, r):
    """The square root: its derivatives have no end where zero is in the ball."""
    f = over(SQRT, c)
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


@kernel
def inverse_circular(C, R, op, k, i, c, r):
    """Arcsine and arccosine, whose argument cannot leave the domain; at its ends their slope has no end."""
    top, bottom = over(op, max(-1.0, min(1.0, c + r))), over(op, max(-1.0, min(1.0, c - r)))
    f = over(op, max(-1.0, min(1.0, c)))
    wide = max(abs(top - f), abs(f - bottom)) + 4.0 * EPS
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


@kernel
def logarithm(C, R, k, i, c, r, f, wide):
    """Its derivatives 1/x and -1/x^2 have no end where zero is in the ball."""
    if c > r:
        d = 1.0 / c
        dr = r * d / (c - r)
        e, er = times(d, dr, d, dr)
        chained(C, R, k, i, f, wide, d, widened(dr, d), -0.5 * e, 0.5 * er)
    else:
        chained(C, R, k, i, f if f == f else 0.0, math.inf, 0.0, math.inf, 0.0, math.inf)


@kernel
def arctangent(C, R, k, i, c, r, f, wide):
    """Its derivatives: 1/(1 + x^2), and by half -x/(1 + x^2)^2."""
    s, t = times(c, r, c, r)
    s, t = 1.0 + s, widened(t, 1.0 + s)
    low = max(s - t, 1.0)
    d = 1.0 / s
    dr = widened(min(t * d / low, 1.0), d)
    e, er = times(d, dr, d, dr)
    e, er = times(e, er, -c, r)
    chained(C, R, k, i, f, wide, d, dr, e, er)


@kernel
def hyperbolic_sine(C, R, k, i, c, r, f, wide):
    """Its slope is the hyperbolic cosine, largest at the end further from zero."""
    g = math.cosh(min(abs(c), 700.0))
    far = math.cosh(abs(c) + r) if abs(c) + r < 700.0 else math.inf
    chained(C, R, k, i, f, wide, g, r * far, 0.5 * f, 0.5 * wide)


@kernel
def hyperbolic_tangent(C, R, k, i, f, wide):
    """Its derivatives by its own value: 1 - f^2, and by half -f (1 - f^2)."""
    s, t = times(f, wide, f, wide)
    d, dr = 1.0 - s, widened(t, 1.0)
    e, er = times(d, dr, -f, wide)
    chained(C, R, k, i, f, wide, d, dr, e, er)


@kernel
def tangent(C, R, k, i, c, r, f, wide):
    """Monotone unless a pole is in the ball; its derivatives: 1 + f^2, and by half f (1 + f^2)."""
    if abs(math.cos(c)) > r + EPS:
        s, t = times(f, wide, f, wide)
        d, dr = 1.0 + s, widened(t, 1.0 + s)
        e, er = times(d, dr, f, wide)
        chained(C, R, k, i, f, wide, d, dr, e, er)
    else:
        chained(C, R, k, i, f, math.inf, 0.0, math.inf, 0.0, math.inf)


@kernel
def function(C, R, op, k, i):
    """Register k becomes an elementary function of register i."""
    c, r = C[i, 0], R[i, 0]
    if op in (SIN, COS):
        circular(C, R, op, k, i, c, r)
    elif op in (ABS, SIGN):
        signed(C, R, op, k, i, c, r)
    elif op in (FRESNEL_C, FRESNEL_S):
        fresnel_integral(C, R, op, k, i, c, r)
    elif op == COSH:
        hyperbolic_cosine(C, R, k, i, c, r)
    elif op == SQRT:
        root(C, R, k, i, c, r)
    elif op in (ASIN, ACOS):
        inverse_circular(C, R, op, k, i, c, r)
    else:  # monotone where they are smooth
        f = over(op, c)
        wide = spread(op, c, r, f)
        if op == EXP:
            chained(C, R, k, i, f, wide, f, wide, 0.5 * f, 0.5 * wide)
        elif op == LOG:
            logarithm(C, R, k, i, c, r, f, wide)
        elif op == ATAN:
            arctangent(C, R, k, i, c, r, f, wide)
        elif op == SINH:
            hyperbolic_sine(C, R, k, i, c, r, f, wide)
        elif op == TANH:
            hyperbolic_tangent(C, R, k, i, f, wide)
        else:
            tangent(C, R, k, i, c, r, f, wide)


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
