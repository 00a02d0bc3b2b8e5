"""Products of generators and sums of them as people write them: in order, with signs and numbers in front."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass

from freebody.language.expression import Call, Expr, multiply, n_operations, number
from freebody.symbolic.field import Field
from freebody.symbolic.polynomials import declaration_order, has_lonely_symbol, primitive, square_part
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.signs_shown import factors_of, positive_first, raised, signed_product
from freebody.symbolic.waves import Monomial

# order in which factors of a product are written
_PLACE = {
    "parameter": 0,
    "time": 1,
    "coordinate": 2,
    "speed": 3,
    "acceleration": 4,
    "cos": 5,
    "sin": 5,
    "function": 5,
    "root": 6,
}


def place(field: Field, base: Ratio) -> tuple[int, int]:
    """Simple symbols first, sums last, each in order of declaration."""
    generators = base.generators()
    if len(base.num) == 1 and len(generators) == 1:
        (index,) = generators
        return _PLACE[field.generators[index].kind], index
    return 4 if base.is_constant() else 9, min(generators, default=0)


def roots_gathered(field: Field, parts: Sequence[tuple[int, int]]) -> tuple[int, list[Expr], list[tuple[int, int]]]:
    """Roots of whole numbers in a product as one, with the number that comes out of it; and the other factors:
    sqrt(3) sqrt(6) as 3 sqrt(2)."""
    inside = {g: field.radicand(g).fraction() for g, _e in parts if field.generators[g].kind == "root"}
    whole = {g: n.numerator for g, n in inside.items() if n is not None and n > 0 and n.denominator == 1}
    numbers = [(g, e) for g, e in parts if g in whole]
    if len(numbers) < 2:
        return 1, [], list(parts)
    outside, free = square_part(math.prod(whole[g] ** e for g, e in numbers))
    return outside, [Call("sqrt", number(free))] if free > 1 else [], [part for part in parts if part not in numbers]


@dataclass(frozen=True)
class Products:
    """Monomials and sums of them in a field. shown: a generator as it is displayed."""

    field: Field
    shown: Callable[[Field, int], Expr]

    def one(self, monomial: Monomial, coefficient: int) -> Expr:
        parts = sorted(monomial, key=lambda item: (_PLACE[self.field.generators[item[0]].kind], item[0]))
        outside, roots, parts = roots_gathered(self.field, parts)
        factors = [raised(self.shown(self.field, g), e) for g, e in parts]
        return multiply(number(coefficient * outside), *factors, *roots)

    def sum(self, terms: Mapping[Monomial, int]) -> Expr:
        ordered = sorted(terms.items(), key=lambda item: declaration_order(item[0]))
        content = 0
        for _m, c in ordered:
            content = math.gcd(content, c)
        if content > 1 and len(ordered) > 1:
            inner = positive_first([self.one(m, c // content) for m, c in ordered])
            return multiply(number(content), *factors_of(inner))
        return positive_first([self.one(m, c) for m, c in ordered])

    def factored(self, terms: Mapping[Monomial, int]) -> Expr:
        """A polynomial in parameters, factored where that is shorter."""
        if len(terms) == 1:
            return self.sum(terms)
        content, common, rest = primitive(terms)
        if has_lonely_symbol(rest):
            front = self.one(tuple(sorted(common.items())), content)
            return multiply(*factors_of(front), *factors_of(self.sum(rest)))
        poly = self.field.polynomial(terms)
        unit, factors = self.field.factor(poly.num)
        plain = self.sum(terms)
        parts = sorted(((place(self.field, b), b, e) for b, e in factors), key=lambda item: item[0])
        product = signed_product(
            unit,
            [raised(self.sum(self.field.terms(b.num)), e) for _p, b, e in parts],
        )
        return product if n_operations(product) <= n_operations(plain) else plain
