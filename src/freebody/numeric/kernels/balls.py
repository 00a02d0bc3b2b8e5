"""Balls, a centre and a radius, and what rounding adds to them.

A register holds three of them: f, f' and f''/2 of what is watched, as Taylor coefficients. Sums and products are those
of coefficients, phi(f) has

    phi,    phi' f',    phi' f''/2 + phi''/2 f'^2,

and every radius is enlarged by what the operation may have rounded away.
Source: Griewank & Walther, Evaluating Derivatives, 2nd ed. 2008, ch. 13.
"""

# pyright: basic

from __future__ import annotations

import math

from freebody.numeric.kernels.declaring import kernel

EPS = 2.3e-16


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
