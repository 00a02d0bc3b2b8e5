"""Numbers that are sums of roots of whole numbers: a + b sqrt(2) + c sqrt(3) by what is under each root."""

from __future__ import annotations

import math
from collections.abc import Collection, Mapping
from fractions import Fraction
from typing import TYPE_CHECKING

from freebody.symbolic.polynomials import Poly, square_part

if TYPE_CHECKING:
    from freebody.symbolic.field import Field, Ratio

_SMALL_PRIMES = [n for n in range(2, 1000) if all(n % k for k in range(2, math.isqrt(n) + 1))]
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


def by_other_roots(n: Fraction, known: Collection[Fraction]) -> tuple[Fraction, tuple[Fraction, ...]] | None:
    """q and numbers k of those known with sqrt(n) = q times the product of their roots; None where there are none. The
    exponents of primes, odd or even, are vectors over two elements: elimination tells which depend on others."""
    basis: dict[int, tuple[frozenset[int], frozenset[Fraction]]] = {}  # by a prime in it

    def reduced(primes: frozenset[int], used: frozenset[Fraction]) -> tuple[frozenset[int], frozenset[Fraction]]:
        for prime, (own, parts) in basis.items():
            if prime in primes:
                primes, used = primes ^ own, used ^ parts
        return primes, used

    for k in known:
        primes, used = reduced(_odd_primes(k), frozenset([k]))
        if primes:
            first = min(primes)
            for prime, (own, parts) in basis.items():
                if first in own:
                    basis[prime] = own ^ primes, parts ^ used
            basis[first] = primes, used
    primes, used = reduced(_odd_primes(n), frozenset())
    root = None if primes or not used else rational_root(n / math.prod(used))
    return None if root is None else (root, tuple(sorted(used)))


def _odd_primes(n: Fraction) -> frozenset[int]:
    """The primes of which a number has an odd power; what is left beyond the first ones counts as one."""
    found, left = set[int](), abs(n.numerator * n.denominator)
    for prime in _SMALL_PRIMES:
        while left % prime == 0:
            left //= prime
            found ^= {prime}
    return frozenset(found ^ ({left} if left > 1 else set()))


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
