"""Signs, factors and quotients of plain expressions, as people write them.

A sum is written with a positive term first, a product with its sign in front; a quotient has no numbers to cancel.
"""

from __future__ import annotations

from fractions import Fraction

from freebody.language.expression import (
    Call,
    Expr,
    Number,
    PowerOf,
    ProductOf,
    Sum,
    add,
    divide,
    multiply,
    n_operations,
    negate,
    number,
    power,
)
from freebody.symbolic.decimals_shown import decimals_of_root
from freebody.symbolic.polynomials import square_part


def root_shown(inside: Expr) -> Expr:
    """The root of an expression; that of a square is a size."""
    if isinstance(inside, PowerOf) and inside.exponent == number(2):
        return Call("abs", inside.base)
    if isinstance(inside, Number) and inside.value > 0 and inside.value.denominator == 1:
        whole, free = square_part(inside.value.numerator)
        return multiply(number(whole), Call("sqrt", number(free))) if free > 1 else number(whole)
    outside, inside = decimals_of_root(inside)
    return multiply(number(outside), Call("sqrt", inside))


def fraction_shown(top: Expr, bottom: Expr, *, turns: bool = True) -> Expr:
    """top/bottom with the sign in front and the numbers gathered. turns: a sign may go into a difference below, which
    spoils one that is known to be positive."""
    n_top, rest_top = number_part(top)
    n_bottom, rest_bottom = number_part(bottom)
    ratio = n_top / n_bottom
    if turns and ratio < 0 and isinstance(rest_bottom, Sum) and any(map(is_written_negative, rest_bottom.terms)):
        ratio, rest_bottom = -ratio, positive_first([negate(t) for t in rest_bottom.terms])
    elif turns and ratio < 0 and isinstance(rest_bottom, ProductOf):
        ratio, rest_bottom = _sign_of_a_factor(ratio, rest_bottom)
    up = multiply(number(ratio.numerator), *factors_of(rest_top))
    down = multiply(number(ratio.denominator), *factors_of(rest_bottom))
    return divide(up, down)


def raised(base: Expr, n: int) -> Expr:
    """base^n; exp(u)^n is exp(n u)."""
    if n != 1 and isinstance(base, Call) and base.function == "exp":
        return Call("exp", multiply(number(n), *factors_of(base.argument)))
    return base if n == 1 else power(base, number(n))


def logarithms_turned(e: Expr) -> Expr:
    """-log(a/b) as log(b/a), in a product or in the terms of a sum; log(1/2) as -log(2)."""
    if isinstance(e, Sum):
        return add(*map(logarithms_turned, e.terms))
    e = multiply(*map(_of_more_than_one, factors_of(e)))
    if not is_written_negative(e):
        return e
    factors = list(factors_of(negate(e)))
    logs = [k for k, f in enumerate(factors) if isinstance(f, Call) and f.function == "log"]
    if len(logs) != 1:
        return e
    (k,) = logs
    log = factors[k]
    assert isinstance(log, Call)
    above = [f for f in factors_of(log.argument) if not (isinstance(f, PowerOf) and f.exponent == number(-1))]
    below = [f.base for f in factors_of(log.argument) if isinstance(f, PowerOf) and f.exponent == number(-1)]
    if not below or is_written_negative(log.argument):
        return e
    factors[k] = Call("log", divide(multiply(*below), multiply(*above)))
    return multiply(*factors)


def _of_more_than_one(factor: Expr) -> Expr:
    """The logarithm of a number below one by that of its inverse, also among the terms of a sum."""
    if isinstance(factor, Sum):
        terms = [multiply(*map(_of_more_than_one, factors_of(term))) for term in factor.terms]
        return factor if terms == list(factor.terms) else positive_first(terms)
    inside = factor.argument if isinstance(factor, Call) and factor.function == "log" else None
    if not isinstance(inside, Number) or not 0 < inside.value < 1:
        return factor
    return negate(Call("log", number(1 / inside.value)))


def with_halves(e: Expr) -> Expr:
    """2 a/(2 b + 2 c + d) as a/(b + c + d/2), as people have it whose inertia is m r^2/2: where more terms of a
    sum below have a two than a one, no other number stands there, something is left above, and the whole becomes no
    longer."""
    if not isinstance(e, ProductOf):
        return e
    below = [f.base for f in e.factors if isinstance(f, PowerOf) and f.exponent == number(-1)]
    sums = [base for base in below if isinstance(base, Sum)]
    if len(sums) != 1 or sorted(set(map(_size, sums[0].terms))) != [1, 2]:
        return e
    twos = sum(_size(term) == 2 for term in sums[0].terms)
    if 2 * twos <= len(sums[0].terms):
        return e
    factors = [f for f in e.factors if f != PowerOf(sums[0], number(-1))]
    sized = [k for k, f in enumerate(factors) if isinstance(f, Sum)]
    if isinstance(factors[0], Number) and factors[0].value.numerator % 2 == 0:
        factors[0] = number(factors[0].value / 2)
    elif len(sized) == 1:
        factors[sized[0]] = _halved(factors[sized[0]])
    else:
        return e
    if all(f == number(1) or f in [PowerOf(base, number(-1)) for base in below] for f in factors):
        return e  # 2/(2 a + 2 b - c) has nothing else above
    halved = divide(multiply(*factors), _halved(sums[0]))
    return halved if n_operations(halved) <= n_operations(e) else e


def _size(term: Expr) -> Fraction:
    return abs(number_part(term)[0])


def _halved(e: Expr) -> Expr:
    assert isinstance(e, Sum)
    return add(*(multiply(number(n / 2), *factors_of(rest)) for n, rest in map(number_part, e.terms)))


def _sign_of_a_factor(ratio: Fraction, product: ProductOf) -> tuple[Fraction, Expr]:
    """-1/(a (b - c)) = 1/(a (c - b))"""
    for k, factor in enumerate(product.factors):
        if isinstance(factor, Sum) and any(map(is_written_negative, factor.terms)):
            turned = positive_first([negate(t) for t in factor.terms])
            return -ratio, multiply(*product.factors[:k], turned, *product.factors[k + 1 :])
    return ratio, product


def number_part(e: Expr) -> tuple[Fraction, Expr]:
    if isinstance(e, Number):
        return e.value, number(1)
    if isinstance(e, ProductOf) and isinstance(e.factors[0], Number):
        return e.factors[0].value, multiply(*e.factors[1:])
    return Fraction(1), e


def factors_of(e: Expr) -> tuple[Expr, ...]:
    return e.factors if isinstance(e, ProductOf) else (e,)


def signed_product(unit: int, parts: list[Expr]) -> Expr:
    """Turns a factor such as (m2 - m1) round so that the product has no sign in front, if one can."""
    if unit < 0:
        for k, part in enumerate(parts):
            n, rest = number_part(part)
            if isinstance(rest, Sum) and 2 * sum(map(is_written_negative, rest.terms)) >= len(rest.terms):
                parts[k] = positive_first([negate(t) for t in rest.terms])
                return multiply(number(-unit * n), *parts)
    return multiply(number(unit), *parts)


def positive_first(terms: list[Expr]) -> Expr:
    """A sum that does not begin with a minus sign, if it need not."""
    if terms and is_written_negative(terms[0]):
        for k, term in enumerate(terms):
            if not is_written_negative(term):
                return add(term, *terms[:k], *terms[k + 1 :])
        if len(terms) > 1:
            return negate(add(*(negate(term) for term in terms)))
    return add(*terms)


def is_written_negative(e: Expr) -> bool:
    return number_part(e)[0] < 0
