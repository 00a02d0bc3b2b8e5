"""Inequalities as people write them: solved for a coefficient of friction, weaker ones left out, sin/cos as tan."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, replace

from freebody.language.expression import (
    Call,
    Expr,
    Number,
    PowerOf,
    ProductOf,
    Sum,
    add,
    multiply,
    n_operations,
    number,
    power,
)
from freebody.language.notation import Stated, compared
from freebody.symbolic.conditions import Condition, readable_or_told, relation_text, require, solved_for_the_one
from freebody.symbolic.decide import decide, implied, sign_given
from freebody.symbolic.field import Field
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.signs import Sign, sign_of
from freebody.symbolic.tidy import tidy
from freebody.symbolic.waves import square_variants

_FLIPPED = {">": "<", ">=": "<="}
_MOST_COMPARED = 20  # terms of roots that are compared: the squares of longer ones are read by nobody


@dataclass(frozen=True)
class SolvedRelation:
    """`left relation right` where it could be solved for a generator; else `element relation 0`."""

    element: Ratio
    relation: str
    unknown: int | None = None
    bound: Ratio | None = None
    purposes: tuple[str, ...] = ()

    def text(self) -> Stated:
        if self.unknown is None or self.bound is None:
            return shortest(Condition(self.element, self.relation))
        field = self.element.field
        return readable_or_told(compared(field.generators[self.unknown].display, self.relation, readable(self.bound)))


def readable(x: Ratio) -> Expr:
    """The tidy form with tangents."""
    return with_tangents(tidy(x))


def with_tangents(e: Expr) -> Expr:
    """sin(a)/cos(a) in products becomes tan(a)."""
    match e:
        case Sum(terms):
            return add(*map(with_tangents, terms))
        case PowerOf(base, exponent):
            return power(with_tangents(base), exponent)
        case Call():
            return e.of(with_tangents)
        case ProductOf(factors):
            return _tangent_product(factors)
        case _:
            return e


def _tangent_product(factors: tuple[Expr, ...]) -> Expr:
    top = [f for f in factors if not _is_divisor(f)]
    below = [inner for f in factors if _is_divisor(f) for inner in _inner(f)]
    for c in [f for f in below if isinstance(f, Call) and f.function == "cos"]:
        s = Call("sin", c.argument)
        if s in top:
            top[top.index(s)] = Call("tan", c.argument)
            below.remove(c)
    up, down = map(with_tangents, top), map(with_tangents, below)
    product = multiply(*up)
    rest = multiply(*down)
    return product if rest == number(1) else product / rest


def _is_divisor(f: Expr) -> bool:
    return isinstance(f, PowerOf) and isinstance(f.exponent, Number) and f.exponent.value == -1


def _inner(f: Expr) -> tuple[Expr, ...]:
    assert isinstance(f, PowerOf)
    return f.base.factors if isinstance(f.base, ProductOf) else (f.base,)


def solved_for(condition: Condition, unknowns: Sequence[int]) -> SolvedRelation:
    """The condition solved for the first of some generators in which it is linear with a slope of known sign."""
    x = condition.element.numerator()
    below = sign_of(condition.element.denominator())
    purposes = (condition.purpose,) if condition.purpose else ()
    plain = SolvedRelation(condition.element, condition.relation, purposes=purposes)
    if condition.relation not in _FLIPPED:
        return plain
    for g in unknowns:
        if g not in x.generators():
            continue
        parts = x.coefficients(g)
        if len(parts) != 2 or any(g in x.field.ingredients(p) for p in parts):
            continue
        slope = sign_of(parts[1])
        if not slope.is_strict or not below.is_strict:
            continue
        relation = condition.relation if slope is below else _FLIPPED[condition.relation]
        bound = x.field.lowest_terms(-parts[0] / parts[1])
        return SolvedRelation(condition.element, relation, g, bound, purposes)
    return plain


def shortest(c: Condition) -> Stated:
    """The inequality in the form with the fewest operations: as it stands, or solved for one parameter."""
    if (beside_numbers := solved_for_the_one(c.element, c.relation)) is not None:
        return beside_numbers
    e = readable(c.element)
    best, least = relation_text(e, c.relation), n_operations(e) - 1
    for g in _parameters(c.element.field, c.element):
        solved = solved_for(c, (g,))
        if solved.bound is not None:
            n = n_operations(readable(solved.bound))
            if n < least:
                best, least = solved.text(), n
    root = _bound(c)
    return root[0] if root is not None and root[1] < least else best


def _bound(c: Condition) -> tuple[Stated, int] | None:
    """n^2 g^2 > q^2 with a positive parameter g as g > |q|/n, and how many operations that takes."""
    field, x = c.element.field, c.element
    if c.relation == "!=" or x.den is not None:
        return None
    for g in _parameters(field, x):
        parts = x.coefficients(g)
        if len(parts) != 3 or not parts[1].is_zero() or not field.generators[g].positive:
            continue
        front = parts[2].fraction()
        n = 0 if front is None or front < 0 else math.isqrt(int(front))
        if front is None or n * n != front or n == 0:
            continue
        for terms in square_variants(field, field.terms((-parts[0]).num)):
            root = field.root_as_written(terms)
            if root is not None:
                return _bounded(field.variable(g), c.relation, root / n)
    return None


def _bounded(g: Ratio, relation: str, q: Ratio) -> tuple[Stated, int]:
    sign, left = sign_given(q), tidy(g)
    if sign in (Sign.NEGATIVE, Sign.NONPOSITIVE):
        q, sign = -q, -sign
    shown = readable(q)
    is_known = sign in (Sign.POSITIVE, Sign.NONNEGATIVE)
    return compared(left, relation, shown if is_known else Call("abs", shown)), n_operations(shown)


def _parameters(field: Field, x: Ratio) -> list[int]:
    free = x.generators() - {field.index(field.pi)}
    return [g for g in sorted(free) if field.generators[g].kind == "parameter"]


def simplified(conditions: Iterable[Condition], unknowns: Sequence[int]) -> list[SolvedRelation]:
    """The conditions solved, without those that follow from the others."""
    kept: list[SolvedRelation] = []
    for condition in needed(list(conditions)):
        new = solved_for(condition, unknowns)
        if new.unknown is not None and new.bound is not None and _says_nothing(new):
            continue
        if any(_follows(new, old) for old in kept):
            continue
        kept = [old for old in kept if not _follows(old, new)]
        kept.append(new)
    return kept


def needed(conditions: Sequence[Condition]) -> list[Condition]:
    """The conditions without the factors whose signs follow from the others, and without what follows as a whole; of
    two that follow from each other the first stays."""
    kept: list[Condition] = []
    conditions = [plain for c in conditions for plain in _without_compared_roots(c, conditions)]
    for k, condition in enumerate(conditions):
        if condition.relation == "=" or all(c.element != condition.element for c in conditions[:k]):
            kept.append(condition)
    for condition in reversed(tuple(kept)):
        if condition.relation == "=":
            continue
        others = [c for c in kept if c is not condition and c.relation != "="]
        if implied(condition, others):
            kept.remove(condition)
        else:
            kept[kept.index(condition)] = _without_factors(condition, others)
    return kept


def _without_compared_roots(condition: Condition, premises: Sequence[Condition]) -> list[Condition]:
    """A sqrt(a) > B sqrt(b) with positive A and B as A^2 a > B^2 b, where both roots are real; the condition itself if
    it is no such. A sign that follows from the condition alone is lost in the squares, so it stands beside them."""
    x, field = condition.element.numerator(), condition.element.field
    below = sign_given(condition.element.denominator(), premises)
    roots = [g for g in sorted(x.generators()) if field.generators[g].kind == "root"]
    is_short = len(x.num) <= _MOST_COMPARED and len(condition.element.denominator().num) <= _MOST_COMPARED
    if condition.relation not in _FLIPPED or not 0 < len(roots) < 3 or not is_short or not below.is_strict:
        return [condition]
    rest, squares, reals = x, list[tuple[Ratio, Sign]](), list[Condition]()
    others = [c for c in premises if c.element != condition.element]

    def sign_beside(part: Ratio) -> Sign:
        sign = sign_given(part, premises)
        if sign.is_strict and not sign_given(part, others).is_strict:
            reals.append(Condition(part if sign is Sign.POSITIVE else -part, ">"))
        return sign

    for root in roots:
        parts = rest.coefficients(root)
        if len(parts) != 2 or root in field.ingredients(parts[0]) | field.ingredients(parts[1]):
            return [condition]
        rest, factor = parts
        squares.append((factor * factor * field.radicand(root), sign_beside(factor)))
        reals.append(Condition(field.radicand(root), ">="))
    if len(roots) == 1:
        squares.append((rest * rest, sign_beside(rest)))
    elif not rest.is_zero():
        return [condition]
    (a, sign_a), (b, sign_b) = squares
    if {sign_a, sign_b} != {Sign.POSITIVE, Sign.NEGATIVE}:
        return [condition]
    difference = _difference(a, b, premises)
    if (sign_a is Sign.POSITIVE) != (below is Sign.POSITIVE):
        difference = -difference
    return [Condition(difference, condition.relation, condition.purpose), *reals]


def _difference(a: Ratio, b: Ratio, premises: Sequence[Condition]) -> Ratio:
    """What has the sign of a - b: a factor of both whose sign is known is left out before, for where it has sines and
    cosines in it nobody finds it in the difference again."""
    shared = a.field.lowest_terms(a / b)
    common = a.field.lowest_terms(b / shared.denominator())
    sign = sign_given(common, premises) if common.den is None and common.generators() else Sign.UNKNOWN
    if not sign.is_strict:
        return a - b
    difference = shared.numerator() - shared.denominator()
    return difference if sign is Sign.POSITIVE else -difference


def _without_factors(condition: Condition, premises: Sequence[Condition]) -> Condition:
    """A factor that is positive or negative wherever the premises hold decides nothing."""
    rest, sign, is_changed = condition.element.field.one, 1, False
    for base, exponent in _factors(condition.element):
        own = sign_given(base, premises)
        if not own.is_strict and exponent % 2 == 0 and decide(base, "!=", premises):
            own = Sign.POSITIVE
        if own.is_strict and base.generators():
            sign = -sign if own is Sign.NEGATIVE and exponent % 2 else sign
            is_changed = True
        else:
            rest = rest * base**exponent
    if not is_changed or not rest.generators():
        return condition
    return replace(condition, element=sign * rest)


def _says_nothing(r: SolvedRelation) -> bool:
    """mu >= what is never positive."""
    assert r.unknown is not None
    assert r.bound is not None
    sign = sign_of(r.bound)
    return r.relation in (">", ">=") and sign is Sign.NEGATIVE and r.element.field.generators[r.unknown].positive


def _follows(weak: SolvedRelation, strong: SolvedRelation) -> bool:
    """True where the first is a consequence of the second."""
    if weak.element == strong.element:
        return weak.relation == strong.relation or weak.relation == strong.relation + "="
    if weak.unknown is None or weak.unknown != strong.unknown or weak.bound is None or strong.bound is None:
        return False
    if weak.relation[0] != strong.relation[0]:
        return False
    gap = strong.bound - weak.bound if weak.relation[0] == ">" else weak.bound - strong.bound
    if gap.is_zero():
        return weak.relation == strong.relation or len(weak.relation) == 2
    return sign_of(gap) in (Sign.POSITIVE, Sign.NONNEGATIVE)


def parted(x: Ratio, relation: str, purpose: str, sign_at: Callable[[Ratio], int]) -> list[Condition]:
    """What `x relation 0` comes to: one condition for each factor that has one sign wherever it is looked at, and the
    radicand of a root that must be positive. `sign_at` tells that sign, 0 where there is not one."""
    condition, _possible = require(x, relation, purpose)
    if condition is None:
        return []
    field = x.field
    found: list[Condition] = []
    rest = field.one
    n_open = 0
    for base, exponent in _factors(condition.element):
        root = radicand_of(base)
        if root is not None:
            found += parted(root, relation, purpose, sign_at)
            continue
        if exponent % 2 == 0 or sign_of(base).is_strict:
            rest = rest * base**exponent
            continue
        sign = sign_at(base)
        n_open += 1
        if sign == 0:
            rest = rest * base**exponent
            continue
        rest = rest * sign
        part, _possible = require(sign * base, relation, purpose)
        if part is not None:
            found.append(part)
    left, _possible = require(rest, relation, purpose)
    if left is not None and not rest.is_constant():
        return [condition]
    return found if n_open > 1 or left is None or sign_of(rest) is Sign.POSITIVE else [condition]


def _factors(x: Ratio) -> list[tuple[Ratio, int]]:
    """Irreducible factors above and below the bar; the sign as a factor."""
    field = x.field
    found: list[tuple[Ratio, int]] = []
    sign = 1
    for poly in (x.numerator().num, x.denominator().num):
        unit, factors = field.factor_by_degree(poly) or field.factor(poly)
        sign = -sign if unit < 0 else sign
        found += factors
    if sign < 0:
        found.append((-field.one, 1))
    return found


def radicand_of(base: Ratio) -> Ratio | None:
    """What stands under the root that a factor is, if it is one of something that is no number."""
    field = base.field
    if len(base.generators()) != 1 or base.den is not None:
        return None
    (index,) = base.generators()
    generator = field.generators[index]
    is_root = generator.kind == "root" and bool(generator.made_of) and base == field.variable(index)
    return field.radicand(index) if is_root else None


def generators_of(field: Field, names: Sequence[str], known: dict[str, Ratio]) -> list[int]:
    """The generators of parameters by name."""
    return [field.index(known[name]) for name in names if name in known and known[name].generators()]
