"""Roots of p + r g, with g = sqrt(c), that come apart: (a + b g)^2 = a^2 + b^2 c + 2 a b g.

    p^2 - r^2 c = d^2    gives    a^2, b^2 c = (p + d)/2, (p - d)/2    in either order

sqrt(3 + 2 sqrt(2)) is 1 + sqrt(2), and sqrt(S^2 + 4 u^2 - 4 u S) is |S - 2 u| for S = sqrt(u^2 + v^2). Source: Borodin,
Fagin, Hopcroft & Tompa, Decreasing the nesting depth of expressions involving square roots, J. Symb. Comp. 1, 1985.
"""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from typing import TYPE_CHECKING

from freebody.symbolic.numbers_with_roots import Roots, in_roots, rational_root

if TYPE_CHECKING:
    from freebody.symbolic.field import Field
    from freebody.symbolic.ratio import Ratio

_MOST_TERMS = 20  # of a radicand: longer ones are squares of nothing that anyone reads


def root_without_root(x: Ratio, is_negative: Callable[[Ratio], bool | None]) -> Ratio | None:
    """sqrt(x) of a polynomial as a + b g, where it comes apart and the sign of that is known; else None."""
    field = x.field
    if len(x.num) > _MOST_TERMS:
        return None
    roots = [g for g in sorted(x.generators()) if field.generators[g].kind == "root"]
    if not roots or len(parts := x.coefficients(roots[-1])) != 2:
        return None
    if (numbers := in_roots(x)) is not None:
        return _of_numbers(x.field, numbers)
    found = _of_a_square(parts[0], parts[1], field.radicand(roots[-1]), field.variable(roots[-1]))
    turned = None if found is None else is_negative(found)
    return found if found is None or turned is False else None if turned is None else -found


def _of_numbers(field: Field, x: Roots) -> Ratio | None:
    """sqrt(a + b sqrt(n)) as sqrt(p) + b sqrt(n)/(2 sqrt(p)), or with q in the place of p where its root is shorter:
    no other root is made beside that of n, which may be the product of both."""
    n = max(x) if len(x) == 2 and min(x) == 1 else 0  # of sqrt(2) + sqrt(3) no number stands beside one root
    a, b = x.get(1, Fraction(0)), x.get(n, Fraction(0))
    d = rational_root(a * a - b * b * n) if n and a > 0 else None
    if d is None:
        return None
    p, q = (a + d) / 2, (a - d) / 2
    p_root, q_root = field.sqrt(field.element(p)), field.sqrt(field.element(q))
    rest = field.element(b) * field.sqrt(field.element(n)) / 2
    if not p_root.generators() or q_root.generators():
        return p_root + rest / p_root
    return q_root + rest / q_root if b > 0 else -q_root - rest / q_root


def _of_a_square(p: Ratio, r: Ratio, c: Ratio, g: Ratio) -> Ratio | None:
    """a + b g, with either sign, of polynomials a and b with a^2 + b^2 c = p and 2 a b = r."""
    d = _root_of_square(p * p - r * r * c)
    for half in () if d is None else (p + d, p - d):
        twice = _root_of_square(2 * half)  # 2 a
        if twice is not None and not twice.is_zero() and not (b := r / twice).denominator().generators():
            return twice / 2 + b * g
    return None


def _root_of_square(x: Ratio) -> Ratio | None:
    """Of a polynomial, with either sign."""
    return None if x.den is not None else x.field.root_as_written(x.terms()[0])
