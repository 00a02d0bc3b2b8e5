"""The field in which the symbolic route computes: exact rational functions with roots.

Its elements are those of `differential_field`; here are the square roots that are taken of them, their factors, their
values and the expression that is shown.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Mapping, Sequence
from contextlib import suppress
from fractions import Fraction
from typing import Any

from freebody.errors import CannotAnswer
from freebody.language.expression import Expr, Number, add, divide, multiply, number, power
from freebody.language.notation import to_text
from freebody.language.sentences import Message
from freebody.symbolic.differential_field import DifferentialField, Generator, WhenAsked
from freebody.symbolic.half_tangents import cancelled
from freebody.symbolic.polynomials import Poly, Terms, declaration_order, square_part
from freebody.symbolic.ratio import Ratio
from freebody.tolerances import ROUND_OFF


class NoValue(CannotAnswer, KeyError):
    """A part of a formula has no real value at the numbers that are put in."""

    def __init__(self, name: str) -> None:
        super().__init__(Message("{x} has no real value here", x=name))

    __str__ = Exception.__str__


class Field(DifferentialField):
    """What the elements of a differential field have besides: roots, factors, values and a form that is read."""

    def __init__(self, capacity: int = 64) -> None:
        self.nonnegative: set[int] = set()  # parameters that may be zero, and not less
        self.angle_units: dict[Any, list[Fraction]] = {}  # terms that are no multiples of angles, by what they share
        self.moduli: dict[int, tuple[Ratio | None, Ratio]] = {}  # amplitude and modulus of elliptic integrals
        self.arguments: dict[int, tuple[str, Ratio]] = {}  # name and argument of every function atom
        self.waves: dict[Any, Any] = {}  # products of sines and cosines as sums, kept by `tidy`
        self.angles: dict[int, Ratio] = {}  # the angle of every cosine generator
        self.arcs: dict[int, tuple[str, Ratio]] = {}  # how such an angle is written: an arc, or "half", of an element
        self.known_pairs: dict[int, tuple[Ratio, Ratio]] = {}  # cosine and sine of angles that are made of them
        self.doubled_pairs: dict[Any, tuple[Ratio, Ratio]] = {}  # cosine and sine of twice an angle, by its key
        self.positive_roots: dict[int, bool] = {}  # what `signs` found out about roots
        self.known_signs: dict[str, Any] = {}  # the same about polynomials, by their texts
        self.decided: dict[Any, Any] = {}  # what `decide` found out about signs under premises
        super().__init__(capacity)

    # -- roots --------------------------------------------------------------------------------
    def sqrt(
        self, x: Ratio, is_negative: Callable[[Ratio], bool | None] | None = None, *, is_kept: bool = False
    ) -> Ratio:
        """The root that is not negative. Square factors and the denominator come out; `is_negative` tells for each
        of them whether its sign must be turned (default: what is known of it), and if `is_kept` also for what becomes
        of the root when something in it is replaced. Where it tells nothing (None) the root of the square stays."""
        if x.is_zero():
            return x
        num, den = self.current(x.num), self.one.num if x.den is None else self.current(x.den)
        unit, factors = self._with_sines(*self.factor(num * den))
        factors = self._with_roots(factors)
        outside, inside = self.one, self.one
        if unit < 0:
            inside = -inside
        square, free = square_part(abs(unit))
        outside, inside = outside * square, inside * free
        for base, exponent in factors:
            taken = self._root_of_square(base, is_negative) if exponent >= 2 else None
            if taken is None and exponent >= 2 and is_negative is not None:  # |base|, a root of its own
                taken = self._root(base * base)
            if taken is not None:
                outside = outside * taken ** (exponent // 2)
            if exponent % 2 or taken is None:
                inside = inside * base ** (exponent % 2 if taken is not None else exponent)
        below = Ratio(self, den, None)  # sqrt(n/d) = sqrt(n d)/|d|
        turned = False if below == 1 else (is_negative or self.has_negative_sign)(below)
        outside = outside / (self._root(below * below) if turned is None else -below if turned else below)
        if inside == 1:
            return outside
        if (inside.fraction() or 1) < 0:
            raise CannotAnswer(Message("square root of the negative number {x}", x=to_text(self.expression(x))))
        return outside * self._root(inside, is_negative if is_kept else None)

    def _with_sines(self, unit: int, factors: Sequence[tuple[Ratio, int]]) -> tuple[int, list[tuple[Ratio, int]]]:
        """Factors with s^2 in the place of -(c - 1) (c + 1), which the normal form makes of it, where s is positive."""
        found = dict(factors)
        for index in self.angles:
            if not self.generators[index + 1].positive:
                continue
            c, s = self.variable(index), self.variable(index + 1)
            n = min(found.get(c - 1, 0), found.get(c + 1, 0))
            if n:
                unit *= (-1) ** n
                for base in (c - 1, c + 1):
                    found[base] -= n
                found[s] = found.get(s, 0) + 2 * n
        return unit, [(base, exponent) for base, exponent in found.items() if exponent]

    def _with_roots(self, factors: Sequence[tuple[Ratio, int]]) -> list[tuple[Ratio, int]]:
        """Factors with g^2 in the place of r, which the normal form makes of it, where the root g of r is one too."""
        found = dict(factors)
        for root, _exponent in factors:
            index = next(iter(root.generators()), -1)
            if index < 0 or self.generators[index].kind != "root" or root != self.variable(index):
                continue
            unit, parts = self.factor(self.square_of(index))
            n = min((found.get(base, 0) // exponent for base, exponent in parts), default=0) if unit == 1 else 0
            if n:
                found |= {base: found[base] - n * exponent for base, exponent in parts}
                found[root] += 2 * n
        return [(base, exponent) for base, exponent in found.items() if exponent]

    def _root_of_square(self, base: Ratio, is_negative: Callable[[Ratio], bool | None] | None) -> Ratio | None:
        """|base|, or None if its sign is open and nobody decides it."""
        turned = (is_negative or self.has_negative_sign)(base)
        return None if turned is None else -base if turned else base

    def has_negative_sign(self, x: Ratio) -> bool | None:
        """Whether |x| is -x, where nobody else tells; None if the sign is open. See `SignedField`."""
        return None

    def _root(self, radicand: Ratio, is_negative: Callable[[Ratio], bool | None] | None = None) -> Ratio:
        key = ("root", radicand.key())
        made = self.known(key)
        if made is not None:
            return made
        positive = radicand.fraction() is not None
        shown = power(self.expression(radicand), number(Fraction(1, 2)))
        root = self.generator(
            Generator(
                shown,
                "root",
                positive,
                lambda v, f: f.sqrt(self.evaluate(radicand, v, f)),
                self.ingredients(radicand),
                lambda follow: self.sqrt(follow(radicand), is_negative, is_kept=is_negative is not None),
            ),
            key=key,
        )
        index = self.index(root)
        self.bind(index, radicand.num)
        if not radicand.is_constant():
            # (sqrt r)' = r'/(2 sqrt r)
            self._rates[index] = self.rate(radicand) / (2 * root)
        return root

    def radicand(self, index: int) -> Ratio:
        """g^2 of a root generator."""
        return Ratio(self, self.square_of(index), None)

    def pairs(self, used: Iterable[int]) -> list[tuple[int, int]]:
        """(cosine, sine) generators of the angles of which one occurs."""
        found: set[tuple[int, int]] = set()
        for index in used:
            kind = self.generators[index].kind
            if kind == "cos":
                found.add((index, index + 1))
            elif kind == "sin":
                found.add((index - 1, index))
        return sorted(found)

    def pair_of(self, angle: int) -> tuple[int, int] | None:
        """(cosine, sine) generators of a variable that is an angle, if they were made."""
        own = self.variable(angle)
        return next(((cos, cos + 1) for cos, known in self.angles.items() if known == own), None)

    # -- common factors -----------------------------------------------------------------------
    def lowest_terms(self, x: Ratio) -> Ratio:
        """Cancels what numerator and denominator share once c^2 + s^2 = 1 is used."""
        if x.den is None:
            return x
        pairs = [p for p in self.pairs(self.used(x.den)) if self.generators[p[0]].kind == "cos"]
        found = cancelled(self, x.num, x.den, pairs)
        return x if found is None else self.quotient(*found)

    def factor(self, poly: Poly, *, is_quick: bool = False) -> tuple[int, list[tuple[Ratio, int]]]:
        """Integer content and irreducible factors with exponents, as elements; a quick one leaves a long rest whole."""
        content, found = self.factors(poly, is_quick=is_quick)
        return content, [(Ratio(self, factor, None), exponent) for factor, exponent in found]

    def factor_by_degree(self, poly: Poly) -> tuple[int, list[tuple[Ratio, int]]] | None:
        """Factors of a polynomial made homogeneous in the cosine and sine of its one angle. None where this finds no
        more than `factor`."""
        pairs = self.pairs(self.used(poly))
        free = self.homogeneous(poly, pairs[0]) if len(pairs) == 1 else None
        if free is None:
            return None
        unit, factors = self.irreducible(free)
        found = [(Ratio(self, self.reduce(factor), None), exponent) for factor, exponent in factors]
        found = [(f, e) for f, e in found if f != 1]
        if sum(e for _f, e in found) <= sum(e for _f, e in self.factors(poly)[1]):
            return None
        return unit, found

    def factors_in(self, terms: Terms, generator: int) -> list[list[Ratio]]:
        """The factors of a polynomial as it is written that contain a generator: coefficients of its powers, lowest
        first."""
        split = [self.split(factor, generator) for factor, _exponent in self.irreducible(self.as_written(terms))[1]]
        return [[Ratio(self, self.reduce(p), None) for p in parts] for parts in split if len(parts) > 1]

    def root_as_written(self, terms: Terms) -> Ratio | None:
        """Of a polynomial that is a perfect square as it is written, before any relation is used; else None."""
        root = self.square_root(self.as_written(terms))
        return None if root is None else Ratio(self, self.reduce(root), None)

    # -- numbers and pictures -----------------------------------------------------------------
    def complete(self, values: Mapping[int, Any], functions: Any = math) -> dict[int, Any]:
        """Adds the values of all computed generators whose ingredients are known."""
        full = dict(values)
        for index, generator in self.generators.items():
            if index not in full and generator.compute is not None:
                # what is not real here, or made of what is not, has no value
                with suppress(KeyError, ValueError, ArithmeticError):
                    full[index] = generator.compute(full, functions)
        return full

    def when_asked(self, values: Mapping[int, Any], functions: Any = math) -> Mapping[int, Any]:
        """The same values as of `complete`, each computed when it is first asked for: of use where few are needed."""
        return WhenAsked(self.generators, values, functions)

    def evaluate(self, x: Ratio, values: Mapping[int, Any], functions: Any = math) -> Any:
        """Value at the given generator values (floats, mpmath numbers, arrays)."""
        top, below = x.terms()
        value = self._evaluate_terms(top, values)
        return value if x.den is None else value / self._evaluate_terms(below, values)

    def _evaluate_terms(self, terms: Terms, values: Mapping[int, Any]) -> Any:
        total: Any = 0
        for monomial, coefficient in terms.items():
            term: Any = coefficient
            try:
                for index, exponent in monomial:
                    value = values[index]
                    term = term * (value if exponent == 1 else value**exponent)
            except KeyError as error:
                raise NoValue(to_text(self.generators[error.args[0]].display)) from None
            total = total + term
        return total

    def numerator_and_size(self, x: Ratio, values: Mapping[int, float]) -> tuple[float, float]:
        """The numerator at the given values, and the sum of the sizes of its terms, whatever they are measured in.
        A sine or cosine that vanishes counts as one in a size, so that a single term with it is small beside its size;
        others count as what they are, so that a product of small ones is not taken for zero."""

        def size(k: int) -> float:
            is_zero = self.generators[k].kind in ("cos", "sin") and abs(values[k]) <= ROUND_OFF
            return 1.0 if is_zero else abs(values[k])

        terms = x.terms()[0].items()
        parts = (math.prod((values[k] ** e for k, e in monomial), start=float(c)) for monomial, c in terms)
        sizes = (math.prod((size(k) ** e for k, e in monomial), start=abs(float(c))) for monomial, c in terms)
        return math.fsum(parts), math.fsum(sizes)

    def vanishes_at(self, x: Ratio, values: Mapping[int, float], share: float) -> bool:
        """Whether no more than a share of the terms is left of their sum, which is round-off then."""
        total, size = self.numerator_and_size(x, values)
        return abs(total) <= share * size

    def expression(self, x: Ratio) -> Expr:
        """The plain expression, expanded; see `tidy` for the form people read."""
        top = self.poly_expression(x.num)
        return top if x.den is None else divide(top, self.poly_expression(x.den))

    def poly_expression(self, poly: Poly) -> Expr:
        summands: list[Expr] = []
        ordered = sorted(self.terms(poly).items(), key=lambda item: declaration_order(item[0]))
        for monomial, coefficient in ordered:
            factors: list[Expr] = [Number(Fraction(coefficient))]
            for index, exponent in reversed(monomial):
                base = self.generators[index].display
                factors.append(base if exponent == 1 else power(base, number(exponent)))
            summands.append(multiply(*factors))
        return add(*summands)
