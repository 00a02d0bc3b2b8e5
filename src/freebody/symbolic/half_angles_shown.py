"""Quotients of a given angle whose divisor has terms of both of its functions: (1 + c - s)/(1 + c + s) is (1 - s)/c.

A quotient and its divisor are multiplied by the divisor with the sine, or the cosine, of the other sign:
(1 + c - s)^2 = 2 (1 + c)(1 - s) and (1 + c)^2 - s^2 = 2 c (1 + c), by c^2 + s^2 = 1 alone.
"""

from __future__ import annotations

from collections.abc import Iterator

from freebody.symbolic.ratio import Ratio
from freebody.symbolic.roots_in_quotients import strict_sign

_TERMS = 8  # a longer divisor has no such form that is short


def by_conjugates(x: Ratio) -> Iterator[Ratio]:
    """The same element with other divisors, which vanish nowhere; they are not in lowest terms."""
    field = x.field
    if x.den is None or len(x.den) > _TERMS or len(x.num) > _TERMS:
        return
    pairs = field.pairs(field.used(x.den))
    if len(pairs) != 1 or not all(field.is_constant_generator(g) for g in pairs[0]):
        return
    cosine, sine = pairs[0]
    if not {cosine, sine} <= x.denominator().generators() & x.numerator().generators():
        return
    for g in (sine, cosine):
        conjugate = field.substitute(x.denominator(), {g: -field.variable(g)})
        top, bottom = x.numerator() * conjugate, x.denominator() * conjugate
        if top.den is None and bottom.den is None and strict_sign(bottom):
            yield field.quotient(top.num, bottom.num)
