"""Integrals over a coordinate: of polynomials in it, or in the cosine and sine of one angle that turns with it.

int c^m s = -c^(m+1)/(m+1),      int c^m = c^(m-1) s/m + (m-1)/m int c^(m-2),      s^2 = 1 - c^2.
"""

from __future__ import annotations

from freebody.symbolic.field import Field, Ratio


def antiderivative(x: Ratio, index: int) -> Ratio | None:
    """An element whose derivative with respect to a coordinate is x; None where it is not of these kinds."""
    field = x.field
    if index in field.ingredients(x.denominator()):
        return None
    moving = [g for g in x.generators() if index in field.ingredients(field.variable(g))]
    pairs = field.pairs(g for g in moving if g != index)
    if len(pairs) > 1 or (pairs and (index in moving or not set(moving) <= set(pairs[0]))):
        return None
    total = field.zero
    for monomial, coefficient in field.terms(x.num).items():
        powers = dict(monomial)
        rest = field.polynomial({tuple((g, e) for g, e in monomial if g not in moving): coefficient})
        if pairs:
            part = _wave(field, *pairs[0], powers.get(pairs[0][0], 0), powers.get(pairs[0][1], 0), index)
        else:
            n = powers.get(index, 0) + 1
            part = field.variable(index) ** n / n
        total = total + rest * part
    total = field.lowest_terms(total / x.denominator())
    return total if field.derivative(total, index) == x else None


def _wave(field: Field, cosine: int, sine: int, m: int, n: int, index: int) -> Ratio:
    """The integral of c^m s^n."""
    c, s = field.variable(cosine), field.variable(sine)
    if n >= 2:
        return _wave(field, cosine, sine, m, n - 2, index) - _wave(field, cosine, sine, m + 2, n - 2, index)
    per_angle = -s / field.derivative(c, index)
    if n == 1:
        return -per_angle * c ** (m + 1) / (m + 1)
    if m == 0:
        return field.variable(index)
    if m == 1:
        return per_angle * s
    return (per_angle * c ** (m - 1) * s + (m - 1) * _wave(field, cosine, sine, m - 2, 0, index)) / m
