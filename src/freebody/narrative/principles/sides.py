"""How the sides of an equation are written, with as few minus signs as they need."""

from __future__ import annotations

from collections.abc import Sequence
from math import gcd

from freebody.errors import CannotAnswer
from freebody.language.expression import Expr, Sum, add, multiply, negate, number
from freebody.language.notation.parts import signed_terms
from freebody.language.sentences import Message
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.signs import sign_is_positive
from freebody.symbolic.tidy import tidy

ZERO = number(0)
MOST_TERMS = 120  # of one entry that anybody reads


def scaled(coefficient: Ratio, symbol: Expr) -> Expr:
    """coefficient * symbol as it is written."""
    return multiply(tidy(coefficient), symbol)


def positive_first(terms: Sequence[Expr]) -> Expr:
    """A sum that does not begin with a minus where it need not."""
    signs = signed_terms(tuple(terms))
    ordered = [t for t, (minus, _e) in zip(terms, signs, strict=True) if not minus]
    ordered += [t for t, (minus, _e) in zip(terms, signs, strict=True) if minus]
    return add(*ordered)


def n_minus(side: Expr) -> int:
    """How many terms of a side have a minus sign."""
    return sum(minus for minus, _e in signed_terms(side.terms if isinstance(side, Sum) else (side,)))


def parted(e: Expr) -> tuple[Expr, Expr]:
    """a - b as a and b."""
    if not isinstance(e, Sum):
        return e, ZERO
    signs = signed_terms(e.terms)
    left = [t for t, (minus, _x) in zip(e.terms, signs, strict=True) if not minus]
    right = [negate(t) for t, (minus, _x) in zip(e.terms, signs, strict=True) if minus]
    return (add(*left) if left else ZERO), (add(*right) if right else ZERO)


def balanced(e: Expr) -> tuple[Expr, Expr]:
    """a - b = 0 as a = b; -a - b = 0 as a + b = 0."""
    left, right = parted(e)
    return (left, right) if left != ZERO else (right, left)


def readable(x: Ratio) -> Ratio:
    """The element; raises CannotAnswer for one that is too long to read."""
    if len(x.num) + len(x.denominator().num) > MOST_TERMS:
        raise CannotAnswer(
            Message("its equations of motion are longer than anybody reads; freebody eom writes them out")
        )
    return x


def common_factor(parts: Sequence[Ratio]) -> Ratio:
    """The factors, positive for all parameters, that all parts share; those of parts with denominators are left."""
    present = [x for x in parts if not x.is_zero()]
    if not present:
        raise ValueError("nothing that could share a factor")
    f, found = present[0].field, present[0].field.one
    if any(not x.denominator().is_one() for x in present):
        return found
    split = [f.factor(x.num, is_quick=True) for x in present]
    for base, exponent in split[0][1]:
        shared = min(next((e for b, e in factors if b == base), 0) for _unit, factors in split)
        if shared and base.is_constant() and sign_is_positive(base):
            found = found * base ** min(shared, exponent)
    return found * gcd(*(abs(unit) for unit, _factors in split))


def without_common_factor(parts: Sequence[Ratio]) -> list[Ratio]:
    """The parts of an equation without what all share above the bar, or below it: m z/2 and m w/2 as z and w."""
    f = parts[0].field
    above = common_factor([f.quotient(x.num, None) for x in parts])
    below = common_factor([x.denominator() for x in parts])
    return [f.lowest_terms(x * below / above) for x in parts]


def taking_out_roots(terms: Sequence[Ratio]) -> Ratio | None:
    """The factor, a root r or 1/r, after which none of the terms contains r; None where no root is in all of them."""
    common = frozenset[int].intersection(*(frozenset(x.generators()) for x in terms)) if terms else frozenset[int]()
    for index in sorted(common):
        field = terms[0].field
        if field.generators[index].kind != "root":
            continue
        root = field.variable(index)
        for factor in (root, 1 / root):
            if not any(index in field.lowest_terms(x * factor).generators() for x in terms):
                return factor
    return None
