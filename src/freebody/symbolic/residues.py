"""Polynomials in one unknown s modulo an irreducible p(s): what is rational in a root of p, without the root itself.

An element is the list of its coefficients from the constant term up, of lower degree than p. Since p is irreducible
every element but zero has an inverse, by Euclid's algorithm, and vanishes at a root of p only if it is zero: so what is
zero at an eigenvalue is decided exactly, whether the eigenvalue has a closed form or not.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import zip_longest

from freebody.symbolic.ratio import Ratio

Coefficients = list[Ratio]


@dataclass(frozen=True)
class ResidueField:
    """Arithmetic modulo p, given by its coefficients from the constant term up."""

    modulus: tuple[Ratio, ...]

    @property
    def one(self) -> Coefficients:
        return [self.modulus[0].field.one]

    def reduced(self, a: Sequence[Ratio]) -> Coefficients:
        return _divided(_trimmed(a), self.modulus)[1]

    def add(self, a: Sequence[Ratio], b: Sequence[Ratio]) -> Coefficients:
        zero = self.modulus[0].field.zero
        return _trimmed([_short(x + y) for x, y in zip_longest(a, b, fillvalue=zero)])

    def multiply(self, a: Sequence[Ratio], b: Sequence[Ratio]) -> Coefficients:
        return self.reduced(_product(a, b))

    def inverse(self, a: Sequence[Ratio]) -> Coefficients:
        """u with u a = 1 modulo p: Euclid's algorithm for a and p. Raises ZeroDivisionError for zero."""
        before, now = list(self.modulus), _trimmed(a)
        u_before, u = list[Ratio](), self.one
        if not now:
            raise ZeroDivisionError("an element that is zero has no inverse")
        while len(now) > 1:
            quotient, rest = _divided(before, now)
            u_before, u = u, self.add(u_before, [-x for x in _product(quotient, u)])
            before, now = now, rest
        return self.reduced([_short(x / now[0]) for x in u])

    def at(self, a: Sequence[Ratio], root: Ratio) -> Ratio:
        """An element at a root of p."""
        total = root.field.zero
        for coefficient in reversed(a):
            total = total * root + coefficient
        return _short(total)


def _short(x: Ratio) -> Ratio:
    return x.field.lowest_terms(x)


def _trimmed(a: Sequence[Ratio]) -> Coefficients:
    """Without leading zeros."""
    n = len(a)
    while n and a[n - 1].is_zero():
        n -= 1
    return list(a[:n])


def _product(a: Sequence[Ratio], b: Sequence[Ratio]) -> Coefficients:
    if not a or not b:
        return []
    found = [a[0].field.zero] * (len(a) + len(b) - 1)
    for j, x in enumerate(a):
        for k, y in enumerate(b):
            found[j + k] = _short(found[j + k] + x * y)
    return _trimmed(found)


def _divided(a: Sequence[Ratio], b: Sequence[Ratio]) -> tuple[Coefficients, Coefficients]:
    """Quotient and remainder of long division."""
    rest, quotient = list(a), [b[0].field.zero] * max(len(a) - len(b) + 1, 0)
    for k in range(len(quotient) - 1, -1, -1):
        factor = quotient[k] = _short(rest[k + len(b) - 1] / b[-1])
        for j, x in enumerate(b):
            rest[k + j] = _short(rest[k + j] - factor * x)
    return _trimmed(quotient), _trimmed(rest[: len(b) - 1])
