"""Sums of squares under a root, as people write amplitudes and sizes.

    M^2 w^4 - 2 M k w^2 + k^2 + c^2 w^2 = (k - M w^2)^2 + c^2 w^2

A polynomial in which one generator g stands squared alone, p + q g^2, is shown so where p is, but for single symbols, a
square; which of such forms is the shortest decides.
"""

from __future__ import annotations

from collections.abc import Callable

from freebody.language.expression import Expr, add, n_operations
from freebody.symbolic.field import Field
from freebody.symbolic.polynomials import Poly
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.signs_shown import is_written_negative

_FEWEST, _MOST = 4, 40  # terms of what is looked at
_ROUND = ("cos", "sin", "root", "function")


def as_sum_of_squares(field: Field, poly: Poly, shown: Callable[[Poly], Expr]) -> Expr:
    """The shortest form, by `shown` as a whole or in two parts."""
    best = shown(poly)
    terms = field.terms(poly)
    if not _FEWEST <= len(terms) <= _MOST:
        return best
    powers: dict[int, set[int]] = {}
    for monomial in terms:
        for g, exponent in monomial:
            powers.setdefault(g, set()).add(exponent)
    if any(field.generators[g].kind in _ROUND for g in powers):
        return best
    whole = Ratio(field, poly, None)
    for g in sorted(g for g, exponents in powers.items() if exponents == {2}):
        parts = whole.coefficients(g)
        if len(parts) == 3 and _is_square(field, parts[0]):
            rest = parts[2] * field.variable(g) * field.variable(g)
            both = [shown(parts[0].num), shown(rest.num)]
            both.sort(key=is_written_negative)
            best = min(best, add(*both), key=n_operations)
    return best


def _is_square(field: Field, x: Ratio) -> bool:
    """Whether all factors of several terms have even powers, and there is one."""
    if x.is_zero() or x.den is not None:
        return False
    sums = [exponent for base, exponent in field.factor(x.num)[1] if len(base.num) > 1]
    return bool(sums) and all(exponent % 2 == 0 for exponent in sums)
