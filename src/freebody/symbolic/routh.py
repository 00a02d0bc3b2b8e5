"""When small disturbances die out or stay small: conditions on a characteristic polynomial, in the field.

hurwitz      c_0 + c_1 s + ... + c_n s^n has all roots in the left half plane if and only if the first column of Routh's
             array is positive. Source: Routh, A Treatise on the Stability of a Given State of Motion, 1877; Gantmacher,
             Applications of the Theory of Matrices, 1959, ch. V.
oscillating  a polynomial in s^2 (conservative and gyroscopic forces) has imaginary roots only if and only if all values
             of s^2 are real and negative. Source: Merkin, Introduction to the Theory of Stability, 1997, ch. 6.
"""

from __future__ import annotations

from collections.abc import Sequence

from freebody.errors import CannotAnswer
from freebody.language.sentences import Message
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.signs import Sign, sign_of

_MOST_SQUARES = 3


def hurwitz(c: Sequence[Ratio]) -> list[Ratio]:
    """What has to be positive; c: from the constant term up, at least degree 1. Raises CannotAnswer where Routh's array
    breaks off, which it does only where the polynomial is not stable."""
    field, n = c[0].field, len(c) - 1
    down = [x / c[-1] for x in reversed(c)]
    above, row = down[0::2], down[1::2]
    column: list[Ratio] = []
    for _ in range(n):
        if not row or row[0].is_zero():
            raise CannotAnswer(Message("a root of the characteristic polynomial does not lie in the left half plane"))
        column.append(row[0])
        after = [*row[1:], field.zero]
        below = [field.lowest_terms(x - above[0] * y / row[0]) for x, y in zip(above[1:], after, strict=False)]
        above, row = row, below
    return column


def oscillating(c: Sequence[Ratio]) -> list[Ratio]:
    """What has to be positive so that c_0 + c_1 m + ... has real negative roots m only, all different. Raises
    CannotAnswer for more than three."""
    n = len(c) - 1
    if n > _MOST_SQUARES:
        raise CannotAnswer(
            Message("the characteristic polynomial is of degree {n} in the squared exponent and does not factor", n=n)
        )
    ratios = [x / c[-1] for x in c[:-1]]
    if n == 1:
        return ratios
    if n == 2:
        return [ratios[1] * ratios[1] - 4 * ratios[0], *ratios]
    r, q, p = ratios
    return [p * p * q * q - 4 * q * q * q - 4 * p * p * p * r + 18 * p * q * r - 27 * r * r, *ratios]


def without_implied(elements: Sequence[Ratio]) -> list[Ratio]:
    """Elements that have to be positive, without those that are so wherever another one is."""
    kept = list(dict.fromkeys(elements))
    for x in list(kept):
        if any(y is not x and _follows(x, y) for y in kept):
            kept.remove(x)
    return kept


def _follows(x: Ratio, y: Ratio) -> bool:
    """Whether x - k y >= 0 for a positive number k."""
    field = x.field
    own, other = field.terms(x.num), field.terms(y.num)
    for monomial in own.keys() & other.keys():
        if own[monomial] * other[monomial] > 0:
            rest = x.numerator() * abs(other[monomial]) - y.numerator() * abs(own[monomial])
            if sign_of(rest) in (Sign.POSITIVE, Sign.NONNEGATIVE, Sign.ZERO):
                return True
    return False
