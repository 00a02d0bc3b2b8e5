"""Enclosures of what is watched over whole parts of a step.

On a part [a, b] of a step the dense output is a polynomial in u = -1 ... 1. A register holds three balls, which contain
f(u), f'(u) and f''(u)/2 for every u, and whose centres are those of u = 0: a polynomial is developed about the middle,

    p(u) = sum c_k u^k,    |p^(k)(u)/k! - c_k| <= sum over j > k of (j over k) |c_j|,

and balls are added, multiplied (`balls`) and put into functions (`elementary`) as Taylor coefficients are. With the
mean value form, |f(u) - f(0)| <= max |f'|; `zeros` finds by that where f is zero.
Source: Moore, Kearfott & Cloud, Introduction to Interval Analysis, 2009, ch. 6; Griewank & Walther, Evaluating
Derivatives, 2nd ed. 2008, ch. 13 (Taylor coefficients).
"""

# pyright: basic

from __future__ import annotations

import math

from freebody.numeric.kernels.arrays import Floats, Floats2, Ints, Ints2
from freebody.numeric.kernels.balls import EPS, product, times, widened
from freebody.numeric.kernels.declaring import entry, kernel
from freebody.numeric.kernels.elementary import argument, function, power
from freebody.numeric.kernels.operations import ADD, ARGUMENT, CONSTANT, DIVIDE, INPUT, MULTIPLY, POWER, SUBTRACT, TIME

N_TERMS = 8  # of a dense output: degree 7


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
    nested by s and 1 - s in turn (`stages.between`). inputs: which entries."""
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
