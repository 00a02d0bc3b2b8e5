"""Square roots of elements of the field: what comes out of the root, and the generator that stays.

A generator g bound by g^2 = r stands for the root of r; square factors of r and its denominator stand before it.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from fractions import Fraction
from typing import TYPE_CHECKING

from freebody.errors import CannotAnswer
from freebody.language.expression import number, power
from freebody.language.notation import to_text
from freebody.language.sentences import Message
from freebody.symbolic.polynomials import square_part
from freebody.symbolic.ratio import Generator, Ratio

if TYPE_CHECKING:
    from freebody.symbolic.field import Field

Sign = Callable[[Ratio], bool | None]
Factors = list[tuple[Ratio, int]]


def square_root(field: Field, x: Ratio, is_negative: Sign | None = None, *, is_kept: bool = False) -> Ratio:
    """The root that is not negative. Square factors and the denominator come out; `is_negative` tells for each
    of them whether its sign must be turned (default: what is known of it), and if `is_kept` also for what becomes
    of the root when something in it is replaced. Where it tells nothing (None) the root of the square stays."""
    if x.is_zero():
        return x
    num, den = field.current(x.num), field.one.num if x.den is None else field.current(x.den)
    unit, factors = _with_sines(field, *field.factor(num * den))
    square, free = square_part(abs(unit))
    outside, inside = field.one * square, (-field.one if unit < 0 else field.one) * free
    for base, exponent in _with_roots(field, factors):
        taken = _root_of_square(field, base, is_negative) if exponent >= 2 else None
        if taken is None and exponent >= 2 and is_negative is not None:  # |base|, a root of its own
            taken = _root(field, base * base)
        if taken is not None:
            outside = outside * taken ** (exponent // 2)
        if exponent % 2 or taken is None:
            inside = inside * base ** (exponent % 2 if taken is not None else exponent)
    below = Ratio(field, den, None)  # sqrt(n/d) = sqrt(n d)/|d|
    turned = False if below == 1 else (is_negative or field.has_negative_sign)(below)
    outside = outside / (_root(field, below * below) if turned is None else -below if turned else below)
    if inside == 1:
        return outside
    if (inside.fraction() or 1) < 0:
        raise CannotAnswer(Message("square root of the negative number {x}", x=to_text(field.expression(x))))
    return outside * _root(field, inside, is_negative if is_kept else None)


def _with_sines(field: Field, unit: int, factors: Sequence[tuple[Ratio, int]]) -> tuple[int, Factors]:
    """Factors with s^2 in the place of -(c - 1) (c + 1), which the normal form makes of it, where s is positive."""
    found = dict(factors)
    for index in field.angles:
        if not field.generators[index + 1].positive:
            continue
        c, s = field.variable(index), field.variable(index + 1)
        n = min(found.get(c - 1, 0), found.get(c + 1, 0))
        if n:
            unit *= (-1) ** n
            for base in (c - 1, c + 1):
                found[base] -= n
            found[s] = found.get(s, 0) + 2 * n
    return unit, [(base, exponent) for base, exponent in found.items() if exponent]


def _with_roots(field: Field, factors: Sequence[tuple[Ratio, int]]) -> Factors:
    """Factors with g^2 in the place of r, which the normal form makes of it, where the root g of r is one too."""
    found = dict(factors)
    for root, _exponent in factors:
        index = next(iter(root.generators()), -1)
        if index < 0 or field.generators[index].kind != "root" or root != field.variable(index):
            continue
        unit, parts = field.factor(field.square_of(index))
        n = min((found.get(base, 0) // exponent for base, exponent in parts), default=0) if unit == 1 else 0
        if n:
            found |= {base: found[base] - n * exponent for base, exponent in parts}
            found[root] += 2 * n
    return [(base, exponent) for base, exponent in found.items() if exponent]


def _root_of_square(field: Field, base: Ratio, is_negative: Sign | None) -> Ratio | None:
    """|base|, or None if its sign is open and nobody decides it."""
    turned = (is_negative or field.has_negative_sign)(base)
    return None if turned is None else -base if turned else base


def _root(field: Field, radicand: Ratio, is_negative: Sign | None = None) -> Ratio:
    key = ("root", radicand.key())
    made = field.known(key)
    if made is not None:
        return made
    root = field.generator(
        Generator(
            power(field.expression(radicand), number(Fraction(1, 2))),
            "root",
            radicand.fraction() is not None,
            lambda v, f: f.sqrt(field.evaluate(radicand, v, f)),
            field.ingredients(radicand),
            lambda follow: field.sqrt(follow(radicand), is_negative, is_kept=is_negative is not None),
        ),
        key=key,
    )
    field.bind(field.index(root), radicand.num)
    if not radicand.is_constant():
        field.set_rate(root, field.rate(radicand) / (2 * root))  # (sqrt r)' = r'/(2 sqrt r)
    return root
