"""Expressions as tapes: each operation is a register with a value and two derivatives along the motion.

A register follows f by (f, f', f'') as the system moves without acceleration; `sweep` then finds the derivatives of the
last register by the rows that it reads. Source: Griewank & Walther, Evaluating Derivatives, 2008, ch. 3 and 13.
"""

# pyright: basic

import math

from freebody.numeric.kernels.declaring import kernel, leaf
from freebody.numeric.kernels.fresnel import fresnel

CONSTANT, TIME, VALUE, RATE = 0, 1, 2, 3
ADD, MULTIPLY, DIVIDE, WHOLE_POWER, POWER = 4, 5, 6, 7, 8
SQRT, SIN, COS, TAN, ASIN, ACOS, ATAN, EXP, LOG, SINH, COSH, TANH, ABS, SIGN = range(9, 23)
FRESNEL_C, FRESNEL_S = 23, 24


@leaf
def function_derivatives(op, x):
    """Value and first two derivatives of an elementary function."""
    if op == SIN:
        s, c = math.sin(x), math.cos(x)
        return s, c, -s
    if op == COS:
        s, c = math.sin(x), math.cos(x)
        return c, -s, -c
    if op == SQRT:
        r = math.sqrt(x) if x >= 0.0 else math.nan
        return r, 0.5 / r, -0.25 / (r * x)
    if op == EXP:
        e = math.exp(x)
        return e, e, e
    if op == LOG:
        g = math.log(x) if x > 0.0 else math.nan
        return g, 1.0 / x, -1.0 / (x * x)
    if op == TAN:
        r = math.tan(x)
        d = 1.0 + r * r
        return r, d, 2.0 * r * d
    if op in (ASIN, ACOS):
        if not -1.0 <= x <= 1.0:
            return math.nan, math.nan, math.nan
        d = 1.0 / math.sqrt(1.0 - x * x)
        if op == ASIN:
            return math.asin(x), d, x * d * d * d
        return math.acos(x), -d, -x * d * d * d
    if op == ATAN:
        d = 1.0 / (1.0 + x * x)
        return math.atan(x), d, -2.0 * x * d * d
    if op == SINH:
        return math.sinh(x), math.cosh(x), math.sinh(x)
    if op == COSH:
        return math.cosh(x), math.sinh(x), math.cosh(x)
    if op == TANH:
        r = math.tanh(x)
        d = 1.0 - r * r
        return r, d, -2.0 * r * d
    if op in (FRESNEL_C, FRESNEL_S):
        c, s = math.cos(0.5 * math.pi * x * x), math.sin(0.5 * math.pi * x * x)
        if op == FRESNEL_C:
            return fresnel(x, False), c, -math.pi * x * s
        return fresnel(x, True), s, math.pi * x * c
    s = 1.0 if x > 0.0 else (-1.0 if x < 0.0 else 0.0)
    if op == ABS:
        return abs(x), s, 0.0
    return s, 0.0, 0.0


@leaf
def whole_power(x, n):
    """x^n for a whole n >= 0."""
    result, factor = 1.0, x
    while n > 0:
        if n & 1:
            result *= factor
        factor *= factor
        n >>= 1
    return result


@leaf
def power_derivatives(x, c):
    """Value and first two derivatives of x^c for a constant c."""
    n = int(c)
    if n == c and 0 <= n <= 64:
        if n == 0:
            return 1.0, 0.0, 0.0
        if n == 1:
            return x, 1.0, 0.0
        p = whole_power(x, n - 2)
        return p * x * x, c * p * x, c * (c - 1.0) * p
    if x < 0.0 and n != c:
        return math.nan, math.nan, math.nan
    p = x**c
    return p, c * x ** (c - 1.0), c * (c - 1.0) * x ** (c - 2.0)


@kernel
def play(begin, end, tape, constants, t, rows, registers):
    """Fills the registers of one tape; the result is in the last of them."""
    for k in range(begin, end):
        op, i, j = tape[k, 0], tape[k, 1], tape[k, 2]
        if op == CONSTANT:
            f, d, e = constants[k], 0.0, 0.0
        elif op == TIME:
            f, d, e = t, 1.0, 0.0
        elif op == VALUE:
            f, d, e = rows[i, 0] + constants[k], rows[i, 1], rows[i, 2]
        elif op == RATE:
            f, d, e = rows[i, 1], 0.0, 0.0
        elif op == ADD:
            f = registers[i, 0] + registers[j, 0]
            d = registers[i, 1] + registers[j, 1]
            e = registers[i, 2] + registers[j, 2]
        elif op == MULTIPLY:
            x, y = registers[i, 0], registers[j, 0]
            f = x * y
            d = registers[i, 1] * y + x * registers[j, 1]
            e = registers[i, 2] * y + 2.0 * registers[i, 1] * registers[j, 1] + x * registers[j, 2]
        elif op == DIVIDE:
            y = 1.0 / registers[j, 0]
            f = registers[i, 0] * y
            d = (registers[i, 1] - f * registers[j, 1]) * y
            e = (registers[i, 2] - 2.0 * d * registers[j, 1] - f * registers[j, 2]) * y
        elif op == POWER:  # x^y = exp(y log x)
            x, y = registers[i, 0], registers[j, 0]
            g = math.log(x) if x > 0.0 else math.nan
            p = registers[i, 1] / x
            gd, ge = p, registers[i, 2] / x - p * p
            ud = registers[j, 1] * g + y * gd
            ue = registers[j, 2] * g + 2.0 * registers[j, 1] * gd + y * ge
            f = math.exp(y * g)
            d = f * ud
            e = f * (ue + ud * ud)
        else:
            if op == WHOLE_POWER:
                f, a, b = power_derivatives(registers[i, 0], constants[k])
            else:
                f, a, b = function_derivatives(op, registers[i, 0])
            d = a * registers[i, 1] if registers[i, 1] != 0.0 else 0.0
            e = 0.0
            if registers[i, 2] != 0.0:
                e += a * registers[i, 2]
            if registers[i, 1] != 0.0:
                e += b * registers[i, 1] * registers[i, 1]
        registers[k, 0], registers[k, 1], registers[k, 2] = f, d, e


@kernel
def sweep(begin, end, tape, constants, registers, rows):
    """Derivatives of the last register by the values of the rows that the tape reads, added to column 4 of `rows`."""
    for k in range(begin, end):
        registers[k, 3] = 0.0
    registers[end - 1, 3] = 1.0
    for k in range(end - 1, begin - 1, -1):
        w = registers[k, 3]
        if w == 0.0:
            continue
        op, i, j = tape[k, 0], tape[k, 1], tape[k, 2]
        if op == VALUE:
            rows[i, 4] += w
        elif op == ADD:
            registers[i, 3] += w
            registers[j, 3] += w
        elif op == MULTIPLY:
            registers[i, 3] += w * registers[j, 0]
            registers[j, 3] += w * registers[i, 0]
        elif op == DIVIDE:
            y = 1.0 / registers[j, 0]
            registers[i, 3] += w * y
            registers[j, 3] -= w * registers[k, 0] * y
        elif op == POWER:
            x, y = registers[i, 0], registers[j, 0]
            registers[i, 3] += w * registers[k, 0] * y / x
            registers[j, 3] += w * registers[k, 0] * math.log(x) if x > 0.0 else math.nan
        elif op == WHOLE_POWER:
            registers[i, 3] += w * power_derivatives(registers[i, 0], constants[k])[1]
        elif op > POWER:
            registers[i, 3] += w * function_derivatives(op, registers[i, 0])[1]
