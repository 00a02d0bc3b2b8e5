"""Fresnel's integrals in floating point, as one complex number:

    F(x) = fresnel_c(x) + i fresnel_s(x) = int_0^x exp(i pi t^2/2) dt,        odd in x.

Near zero by its power series  sum_n (i pi x^2/2)^n/n! x/(2 n + 1); farther by F = (1 + i)/2 erf(sqrt(pi) (1 - i) x/2)
and the continued fraction of the error function. Source: Abramowitz & Stegun, Handbook of Mathematical Functions, 1964,
7.3; Press, Teukolsky, Vetterling & Flannery, Numerical Recipes, 3rd ed. 2007, sec. 6.8.
"""

from __future__ import annotations

import cmath
import math

_NEAR, _FAR = 1.5, 1e16  # beyond, F is (1 + i)/2 to rounding
_MOST_TERMS = 200
_CLOSE = 1e-17


def fresnel_c(x: float) -> float:
    """That of the cosine."""
    return _both(x).real


def fresnel_s(x: float) -> float:
    """That of the sine."""
    return _both(x).imag


def _both(x: float) -> complex:
    if x < 0.0:
        return -_both(-x)
    if x < _NEAR:
        return _by_series(x)
    return _by_continued_fraction(x) if x < _FAR else complex(0.5, 0.5)


def _by_series(x: float) -> complex:
    total = term = complex(x)
    for n in range(1, _MOST_TERMS):
        term *= 0.5j * math.pi * x * x / n
        total += term / (2 * n + 1)
        if abs(term) <= _CLOSE * x:
            break
    return total


def _by_continued_fraction(x: float) -> complex:
    """1 - erf by Lentz's method, in steps of two: b_k = 1 - i pi x^2 + 4 k, a_k = -(2 k - 1) 2 k."""
    b = 1.0 - 1j * math.pi * x * x
    below, found = 1.0 / b, 1.0 / b
    above = complex(math.inf)
    for k in range(1, _MOST_TERMS):
        a = -(2 * k - 1) * 2.0 * k
        b += 4.0
        below = 1.0 / (a * below + b)
        above = b if k == 1 else b + a / above
        found *= above * below
        if abs(above * below - 1.0) <= 1e-16:
            break
    return complex(0.5, 0.5) * (1.0 - cmath.exp(0.5j * math.pi * x * x) * (1.0 - 1j) * x * found)
