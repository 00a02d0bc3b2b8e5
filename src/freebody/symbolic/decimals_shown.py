"""Sums with long whole numbers in them, as measured decimals make them, are written with decimals again.

10^13 s - 523806778291  is  10^13 (s - 0.0523806778291)
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from fractions import Fraction

from freebody.language.expression import Expr, Number, PowerOf, ProductOf, Sum, add, multiply, number, whole_exponent

_LONG = 10**9  # what nobody reads as a whole number
_MOST_PLACES = 60  # of a decimal


def in_decimals(expr: Expr) -> Expr:
    """The same with a power of ten taken out of each factor that is a sum with long numbers."""
    factors = expr.factors if isinstance(expr, ProductOf) else (expr,)
    return multiply(*(part for factor in factors for part in _factor(factor)))


def decimals_of_root(inside: Expr) -> tuple[int, Expr]:
    """The powers of ten that stand before a root, and what is under it."""
    n = inside.factors[0].value if isinstance(inside, ProductOf) and isinstance(inside.factors[0], Number) else 1
    zeros = len(str(n)) - len(str(n).rstrip("0"))
    if n < _LONG or zeros < 2:
        return 1, inside
    outside = 10 ** (zeros // 2)
    return outside, multiply(number(Fraction(1, outside**2)), inside)


def _factor(factor: Expr) -> tuple[Expr, ...]:
    if isinstance(factor, PowerOf) and isinstance(factor.base, Sum) and (n := whole_exponent(factor)) is not None:
        scale, rest = _scaled(factor.base)
        return number(scale**n), PowerOf(rest, factor.exponent)
    if isinstance(factor, Sum):
        scale, rest = _scaled(factor)
        return number(scale), rest
    return (factor,)


def _scaled(given: Sum) -> tuple[Fraction, Expr]:
    """A power of ten and the sum without it."""
    if max(_coefficients(given)) < _LONG:
        return Fraction(1), given
    terms = [in_decimals(term) for term in given.terms]
    sizes = [abs(_coefficient(term)) for term in terms]
    if any(pow(10, _MOST_PLACES, size.denominator) for size in sizes):  # thirds are no decimals
        return Fraction(1), given
    scale = Fraction(10) ** math.floor(math.log10(sizes[0]))
    return scale, add(*(multiply(number(1 / scale), term) for term in terms))


def _coefficients(expr: Expr) -> Iterator[Fraction]:
    """The sizes of the numbers before the terms of a sum and of the sums in these."""
    for term in expr.terms if isinstance(expr, Sum) else (expr,):
        yield abs(_coefficient(term))
        for factor in term.factors if isinstance(term, ProductOf) else ():
            yield from _coefficients(factor) if isinstance(factor, Sum) else ()


def _coefficient(term: Expr) -> Fraction:
    if isinstance(term, Number):
        return term.value
    if isinstance(term, ProductOf) and isinstance(term.factors[0], Number):
        return term.factors[0].value
    return Fraction(1)
