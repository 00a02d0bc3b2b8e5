"""Integrals over a coordinate: of whole powers of it, in the cosine and sine of one angle that turns with it, or in
exponentials of it, and of sums of these.

int c^m s = -c^(m+1)/(m+1),      int c^m = c^(m-1) s/m + (m-1)/m int c^(m-2),      s^2 = 1 - c^2;
int x^n e = (x^n e - n int x^(n-1) e)/k,     int x^n c = (x^n s - n int x^(n-1) s)/k,   and likewise for s;
int (a + b x)^-n = -(a + b x)^(1-n)/((n-1) b),     int 1/(a + b x) = log|a + b x|/b.
"""

from __future__ import annotations

from freebody.symbolic.field import Field
from freebody.symbolic.functions import functions
from freebody.symbolic.ratio import Ratio


def antiderivative(x: Ratio, index: int) -> Ratio | None:
    """An element whose derivative with respect to a coordinate is x; None where it is not of these kinds."""
    field = x.field
    moving = [g for g in x.generators() if index in field.ingredients(field.variable(g))]
    below = dict[int, int]()  # exp(-k x) stands there as exp(k x), and x^-n as x^n
    if index in field.ingredients(x.denominator()):
        if (over := _over_a_line(x, moving, index)) is not None:
            return over
        terms = list(field.terms(x.denominator().num))
        below = {g: e for g, e in terms[0] if g in moving}
        if len(terms) != 1 or any(g != index and field.arguments.get(g, ("", field.one))[0] != "exp" for g in below):
            return None
    divisor = x.denominator()
    for g, e in below.items():
        divisor = divisor / field.variable(g) ** e
    total = field.zero
    for monomial, coefficient in field.terms(x.num).items():
        powers = {g: e for g, e in monomial if g in moving}
        powers |= {g: powers.get(g, 0) - e for g, e in below.items()}
        powers = {g: e for g, e in powers.items() if e}
        rest = field.polynomial({tuple((g, e) for g, e in monomial if g not in moving): coefficient})
        part = _of_term(field, powers, index)
        if part is None:
            return None
        total = total + rest * part
    total = field.lowest_terms(total / divisor)
    return total if field.derivative(total, index) == x else None


def _over_a_line(x: Ratio, moving: list[int], index: int) -> Ratio | None:
    """The integral of what does not change with the coordinate over a power of what is linear in it, with two terms."""
    field = x.field
    if moving != [index] or index in field.ingredients(x.numerator()):
        return None
    changing = [(base, n) for base, n in field.factor(x.denominator().num)[1] if index in base.generators()]
    if len(changing) != 1:
        return None
    ((line, n),) = changing
    slope = field.derivative(line, index)
    if index in field.ingredients(slope) or len(field.terms(line.num)) == 1:
        return None
    if n > 1:
        return field.lowest_terms(x * line / (slope * (1 - n)))
    start = field.follow(line, {index: field.zero})
    return field.lowest_terms(x * line / slope * functions(field)["log"](field.lowest_terms(line / start)))


def _of_term(field: Field, powers: dict[int, int], index: int) -> Ratio | None:
    """The integral of a product of powers of what changes with the coordinate."""
    n = powers.get(index, 0)
    others = {g: e for g, e in powers.items() if g != index}
    if not others:
        if n == -1:
            return functions(field)["log"](field.variable(index))
        return field.variable(index) ** (n + 1) / (n + 1)
    if n < 0:
        return None
    pairs = field.pairs(others)
    if len(pairs) == 1 and set(others) <= set(pairs[0]):
        (cosine, sine), sized = pairs[0], field.derivative(field.variable(pairs[0][0]), index)
        if n and sum(others.values()) > 1:
            return None
        if not n:
            return _wave(field, cosine, sine, others.get(cosine, 0), others.get(sine, 0), index)
        x, c, s = (field.variable(g) for g in (index, cosine, sine))
        per_angle = -s / sized  # 1/k
        if not per_angle.is_constant():
            return None
        below = _of_term(field, {index: n - 1, (sine if cosine in others else cosine): 1}, index)
        if below is None:
            return None
        return per_angle * (x**n * s - n * below) if cosine in others else per_angle * (n * below - x**n * c)
    if len(others) == 1:
        ((g, e),) = others.items()
        name, argument = field.arguments.get(g, ("", field.one))
        slope = field.lowest_terms(field.derivative(argument, index))
        if name != "exp" or slope.is_zero() or index in field.ingredients(slope):
            return None
        grown, x = field.variable(g) ** e, field.variable(index)
        below = _of_term(field, {index: n - 1, g: e}, index) if n else field.zero
        return None if below is None else (x**n * grown - n * below) / (e * slope)
    return None


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
