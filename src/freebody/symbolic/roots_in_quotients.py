"""Quotients with roots below the bar: a root comes to the top, and roots of numbers leave the divisor."""

from __future__ import annotations

from freebody.symbolic.field import Field
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.signs import Sign, sign_of


def strict_sign(x: Ratio) -> int:
    """1 or -1 where that is known, else 0."""
    return {Sign.POSITIVE: 1, Sign.NEGATIVE: -1}.get(sign_of(x), 0)


def is_root_generator(field: Field, base: Ratio) -> bool:
    (index,) = base.generators()
    generator = field.generators[index]
    return generator.kind == "root" and bool(generator.made_of) and len(base.num) == 1


def root_on_top(x: Ratio) -> Ratio:
    """a/(b sqrt(r)) = a sqrt(r)/(b r)."""
    field = x.field
    if x.den is None:
        return x
    _unit, factors = field.factor(x.den)
    for base, _e in factors:
        if len(base.generators()) == 1 and is_root_generator(field, base):
            return field.quotient((x.numerator() * base).num, (x.denominator() * base).num)
    return x


def without_numeric_roots(x: Ratio) -> Ratio:
    """1/(a + b sqrt(n)) = (a - b sqrt(n))/(a^2 - n b^2) for roots of numbers n: where a - b sqrt(n) vanishes for no
    values, which the right side would exclude, and where that is not longer."""
    field = x.field
    while x.den is not None:
        den = x.denominator()
        roots = [g for g in den.generators() if field.generators[g].kind == "root" and not field.generators[g].made_of]
        if not roots:
            return x
        parts = den.coefficients(roots[0])
        if len(parts) != 2:
            return x
        conjugate = parts[0] - parts[1] * field.variable(roots[0])
        if strict_sign(conjugate) == 0:
            return x
        below = den * conjugate
        if roots[0] in below.generators():  # which the square of another root has brought back
            return x
        # multiplying numerator and denominator separately keeps the root out of the denominator
        plain = field.quotient((x.numerator() * conjugate).num, below.num)
        if len(plain.num) + len(plain.denominator().num) > len(x.num) + len(den.num):
            return x
        x = plain
    return x
