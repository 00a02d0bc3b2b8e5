"""Numbers that are sums of roots of whole numbers: a + b sqrt(2) + c sqrt(3) by what is under each root."""

from __future__ import annotations

import math
from collections.abc import Collection, Mapping
from fractions import Fraction
from typing import TYPE_CHECKING

from freebody.symbolic.polynomials import Poly, square_part

if TYPE_CHECKING:
    from freebody.symbolic.field import Field
    from freebody.symbolic.ratio import Ratio

Roots = Mapping[int, Fraction]  # coefficients by square-free numbers, 1 for what has no root


def in_roots(x: Ratio) -> Roots | None:
    """The number, if it is one of this kind; without coefficients that are zero."""
    top, below = _sum(x.field, x.num), _sum(x.field, x.denominator().num)
    if top is None or below is None:
        return None
    while irrational := [n for n in below if n > 1]:
        prime = _least_prime(irrational[0])
        conjugate = {n: -a if n % prime == 0 else a for n, a in below.items()}
        top, below = _product(top, conjugate), _product(below, conjugate)
        if not below:
            return None
    return {n: a / below[1] for n, a in top.items()}


def rational_root(x: Fraction) -> Fraction | None:
    """Of a number that is a square."""
    if x < 0:
        return None
    top, below = math.isqrt(x.numerator), math.isqrt(x.denominator)
    return Fraction(top, below) if top * top == x.numerator and below * below == x.denominator else None


def factors_among(n: int, known: Collection[int]) -> tuple[int, ...] | None:
    """Numbers of those known of which n is the product; None where it is not."""
    for k in sorted(known, reverse=True):
        if 1 < k < n and n % k == 0:
            rest = (n // k,) if n // k in known else factors_among(n // k, known)
            if rest is not None:
                return (k, *rest)
    return None


def _sum(field: Field, poly: Poly) -> Roots | None:
    found: dict[int, Fraction] = {}
    for monomial, coefficient in field.terms(poly).items():
        inside = 1
        for g, exponent in monomial:
            if field.generators[g].kind != "root" or (n := field.radicand(g).fraction()) is None:
                return None
            inside *= int(n) ** exponent
        if inside < 0:
            return None
        square, free = square_part(inside)
        found[free] = found.get(free, Fraction(0)) + coefficient * square
    return {n: a for n, a in found.items() if a}


def _product(x: Roots, y: Roots) -> Roots:
    found: dict[int, Fraction] = {}
    for n, a in x.items():
        for m, b in y.items():
            square, free = square_part(n * m)
            found[free] = found.get(free, Fraction(0)) + a * b * square
    return {n: a for n, a in found.items() if a}


def _least_prime(n: int) -> int:
    return next((p for p in range(2, math.isqrt(n) + 1) if n % p == 0), n)
