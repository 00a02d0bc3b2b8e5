"""Polynomials in whatever stands for numbers in formulas: what lengths along the edges of a body come to, in short.

A term is q sqrt(r) x^i y^j ... with a fraction q, a whole number r without square factors and whole exponents, which
may be negative: what is divided by a single term stays a polynomial. Everything that is no sum, product or power, such
as cos(alpha), is a letter of its own, and sqrt(u)^2 is u.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction

from freebody.language.expression import (
    ZERO,
    Call,
    Expr,
    Number,
    PowerOf,
    ProductOf,
    Sum,
    add,
    divide,
    multiply,
    number,
    power,
    whole_exponent,
)

MOST_TRIED = 1000  # divisors of which squares are taken out of a root
MOST_TERMS = 4  # of what further products are made
LARGEST, DIGITS = 10**40, 20  # numbers under a root; digits behind the point of the root of a larger one
Letters = frozenset[tuple[Expr, int]]
Term = tuple[int, Letters]  # r, and the letters with their exponents


@dataclass(frozen=True)
class Polynomial:
    """The fraction of each term; none of them is zero."""

    terms: Mapping[Term, Fraction]

    def __add__(self, other: Polynomial) -> Polynomial:
        return _gathered([*self.terms.items(), *other.terms.items()])

    def __neg__(self) -> Polynomial:
        return Polynomial({term: -q for term, q in self.terms.items()})

    def __sub__(self, other: Polynomial) -> Polynomial:
        return self + -other

    def __mul__(self, other: Polynomial) -> Polynomial:
        total: list[tuple[Term, Fraction]] = []
        for one, q in self.terms.items():
            for two, p in other.terms.items():
                total += _times(one, two, q * p)
        return _gathered(total)

    def scaled(self, q: Fraction | int) -> Polynomial:
        return Polynomial({term: q * p for term, p in self.terms.items()} if q else {})

    def over(self, other: Polynomial) -> Polynomial | None:
        """The quotient by a single term; None for a divisor of several."""
        inverse = other.inverse()
        return None if inverse is None else self * inverse

    def inverse(self) -> Polynomial | None:
        """1 over a single term: 1/sqrt(r) = sqrt(r)/r."""
        if len(self.terms) != 1:
            return None
        (((r, letters), q),) = self.terms.items()
        inverted = frozenset((letter, -n) for letter, n in letters)
        return Polynomial({(r, inverted): 1 / (q * r)})

    def expression(self) -> Expr:
        parts = [_expression(term, q) for term, q in self.terms.items()]
        return add(*(part for _text, part in sorted((repr(part), part) for part in parts))) if parts else ZERO

    def whole(self) -> Polynomial:
        """A long one as a single letter, in which nothing cancels any more."""
        long = len(self.terms) > MOST_TERMS
        return Polynomial({(1, frozenset({(self.expression(), 1)})): Fraction(1)}) if long else self

    @property
    def is_zero(self) -> bool:
        return not self.terms


def polynomial(expr: Expr) -> Polynomial:
    """An expression as a polynomial."""
    match expr:
        case Number(value):
            return constant(value)
        case Sum(terms):
            total = constant(0)
            for term in terms:
                total = total + polynomial(term)
            return total
        case ProductOf(factors):
            total = constant(1)
            for factor in factors:
                total = total * polynomial(factor)
            return total
        case PowerOf(base, _) if (n := whole_exponent(expr)) is not None:
            return _power(polynomial(base), n, expr)
        case Call("sqrt", Number(value)) if value >= 0:
            return _root_of_number(value)
        case _:
            return Polynomial({(1, frozenset({(expr, 1)})): Fraction(1)})


def constant(value: int | Fraction) -> Polynomial:
    return Polynomial({(1, frozenset()): Fraction(value)} if value else {})


def dot(a: Sequence[Polynomial], b: Sequence[Polynomial]) -> Polynomial:
    total = constant(0)
    for x, y in zip(a, b, strict=True):
        total = total + x * y
    return total


def cross(a: Sequence[Polynomial], b: Sequence[Polynomial]) -> tuple[Polynomial, ...]:
    return tuple(a[j] * b[k] - a[k] * b[j] for j, k in ((1, 2), (2, 0), (0, 1)))


def root(square: Polynomial) -> Polynomial:
    """sqrt of what is positive: letters with even exponents stand outside, as if they were positive."""
    if len(square.terms) == 1:
        (((r, letters), q),) = square.terms.items()
        if r == 1 and q > 0 and all(n % 2 == 0 for _letter, n in letters):
            halves = Polynomial({(1, frozenset((letter, n // 2) for letter, n in letters)): Fraction(1)})
            return _root_of_number(q) * halves
    return Polynomial({(1, frozenset({(Call("sqrt", square.expression()), 1)})): Fraction(1)})


def common_factor(parts: Iterable[Polynomial]) -> Polynomial:
    """The letters that all terms have, with the least exponents, and the size of the first fraction."""
    terms = [(letters, q) for part in parts for (_r, letters), q in part.terms.items()]
    least = dict(terms[0][0])
    for letters, _q in terms[1:]:
        own = dict(letters)
        least = {letter: min(n, own.get(letter, 0)) for letter, n in least.items()}
        least |= {letter: n for letter, n in own.items() if letter not in least and n < 0}
    return Polynomial({(1, frozenset((letter, n) for letter, n in least.items() if n)): abs(terms[0][1])})


# -- terms ---------------------------------------------------------------------------------------
def _gathered(terms: Iterable[tuple[Term, Fraction]]) -> Polynomial:
    total: dict[Term, Fraction] = {}
    for term, q in terms:
        total[term] = total.get(term, Fraction(0)) + q
    return Polynomial({term: q for term, q in total.items() if q})


def _times(one: Term, two: Term, q: Fraction) -> list[tuple[Term, Fraction]]:
    """The product of two terms, several where the square of a root is a sum: sqrt(r) sqrt(s) = g sqrt(r s/g^2)."""
    g = math.gcd(one[0], two[0])
    exponents = dict(one[1])
    for letter, n in two[1]:
        exponents[letter] = exponents.get(letter, 0) + n
    whole = constant(q * g)
    for letter, n in list(exponents.items()):
        if isinstance(letter, Call) and letter.function == "sqrt" and n > 1:
            exponents[letter] = n % 2
            whole = whole * _power(polynomial(letter.argument), n // 2, letter)
    rest = one[0] * two[0] // (g * g), frozenset((letter, n) for letter, n in exponents.items() if n)
    if len(whole.terms) == 1 and (1, frozenset()) in whole.terms:
        return [(rest, whole.terms[1, frozenset()])]
    return [*(whole * Polynomial({rest: Fraction(1)})).terms.items()]


def _power(base: Polynomial, n: int, expr: Expr) -> Polynomial:
    inverse = base.inverse() if n < 0 else base
    if inverse is None:  # of a sum
        return Polynomial({(1, frozenset({(base.expression(), n)})): Fraction(1)})
    total = constant(1)
    for _ in range(abs(n)):
        total = total * inverse
    return total


def _root_of_number(value: Fraction) -> Polynomial:
    """sqrt(p/q) = sqrt(p q)/q, with square factors outside."""
    inside, outside = value.numerator * value.denominator, 1
    for divisor in range(2, MOST_TRIED):
        while inside % (divisor * divisor) == 0 and inside:
            inside, outside = inside // (divisor * divisor), outside * divisor
    if inside and (whole := math.isqrt(inside)) ** 2 == inside:
        inside, outside = 1, outside * whole
    if inside > LARGEST:  # of measured decimals: as a fraction of so many digits that nothing sees it
        shift = 10**DIGITS
        return constant(Fraction(outside * math.isqrt(inside * shift * shift), value.denominator * shift))
    q = Fraction(outside, value.denominator)
    return Polynomial({(inside, frozenset()): q} if inside else {})


def _expression(term: Term, q: Fraction) -> Expr:
    r, letters = term
    ordered = sorted(letters, key=lambda item: repr(item[0]))
    over = [power(letter, number(n)) for letter, n in ordered if n > 0]
    under = [power(letter, number(-n)) for letter, n in ordered if n < 0]
    top = multiply(number(q), *([] if r == 1 else [Call("sqrt", number(r))]), *over)
    return divide(top, multiply(*under)) if under else top


__all__ = ["Polynomial", "common_factor", "constant", "cross", "dot", "polynomial", "root"]
