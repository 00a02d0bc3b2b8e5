"""The field in which the symbolic route computes: exact rational functions.

An element is a quotient of two polynomials with integer coefficients in named generators
(see `polynomials`). A generator may be

- free: a parameter, a coordinate, a speed, an acceleration, time, a given function of time;
- bound by a quadratic relation g^2 = r in earlier generators: the sine of an angle whose cosine
  is a generator (s^2 = 1 - c^2), or a square root;
- a function atom (exp, atan ...) of an earlier element (see `atoms`).

The quotient ring is an integral domain, hence a/b = c/d if and only if a d - b c reduces to zero: equality is
decided exactly, without `simplify`.

Every generator knows its time derivative, so `Field.rate` is total differentiation in time.
"""

from __future__ import annotations

import math
from collections import abc
from collections.abc import Callable, Iterable, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from fractions import Fraction
from functools import cache
from typing import Any, Literal

from freebody.errors import NoRealRoot
from freebody.language.expression import ONE, Expr, Number, Symbol, add, divide, multiply, number, power
from freebody.language.notation import to_text
from freebody.language.sentences import Message
from freebody.symbolic.half_tangents import cancelled
from freebody.symbolic.nested_roots import root_without_root
from freebody.symbolic.numbers_with_roots import factors_among, in_roots
from freebody.symbolic.polynomials import Monomial, Poly, PolynomialRing, Terms, declaration_order, square_part
from freebody.symbolic.ratio import DivisorVanishes, Ratio
from freebody.symbolic.values_of_terms import WhenAsked, sum_and_size, value_of, with_computed

Kind = Literal["parameter", "coordinate", "speed", "acceleration", "time", "cos", "sin", "root", "function"]


@dataclass(frozen=True)
class Generator:
    """One generator: how it is shown, how it is computed from earlier ones, how it changes in time."""

    display: Expr
    kind: Kind
    positive: bool = False
    # value from the values of earlier generators and the numeric functions; None: a free variable
    compute: Callable[[Mapping[int, Any], Any], Any] | None = None
    # what it is made of, and how to make it again when that is substituted
    made_of: frozenset[int] = frozenset()
    remake: Callable[[Callable[[Ratio], Ratio]], Ratio] | None = None


class Field(PolynomialRing):
    """The generators, their relations and rates; makes, differentiates and shows elements."""

    def __init__(self, capacity: int = 64) -> None:
        self.generators: dict[int, Generator] = {}
        self.last_long: tuple[Ratio, tuple[Terms, Terms]] | None = None
        self._rates: dict[int, Ratio] = {}
        self._atoms: dict[Any, int] = {}
        self._number_roots: dict[int, int] = {}  # generators by what is under them
        self.acute_angles: set[int] = set()
        self.nonnegative: set[int] = set()  # parameters that may be zero, and not less
        self.no_angles: set[int] = set()  # what moves and is a length or a time
        self.angle_units: dict[Any, list[Fraction]] = {}  # terms that are no multiples of angles, by what they share
        self.moduli: dict[int, tuple[Ratio | None, Ratio]] = {}  # amplitude and modulus of elliptic integrals
        self.arguments: dict[int, tuple[str, Ratio]] = {}  # name and argument of every function atom
        self.waves: dict[Any, Any] = {}  # products of sines and cosines as sums, kept by `tidy`
        self.angles: dict[int, Ratio] = {}  # the angle of every cosine generator
        self.equal_parts: dict[int, dict[int, int]] = {}  # generators cos(pi p/q), by q and by p
        self.sums_of_parts: dict[int, Ratio] = {}  # such cosines that are sums of others
        self.arcs: dict[int, tuple[str, Ratio]] = {}  # how such an angle is written: an arc, or "half", of an element
        self.known_pairs: dict[int, tuple[Ratio, Ratio]] = {}  # cosine and sine of angles that are made of them
        self.doubled_pairs: dict[Any, tuple[Ratio, Ratio]] = {}  # cosine and sine of twice an angle, by its key
        self.positive_roots: dict[int, bool] = {}  # what `signs` found out about roots
        self.known_signs: dict[str, Any] = {}  # the same about polynomials, by their texts
        self.real_roots: set[int] = set()  # of what cannot be negative, as sums of squares
        self.shown_roots: dict[int, Any] = {}  # as `tidy` writes them
        self.shown: dict[Any, Any] = {}  # elements as it writes them: those of conditions stand in many cases
        self.decided: dict[Any, Any] = {}  # what `decide` found out about signs under premises
        self.trials: Any = None  # points at which `decide` looks for counterexamples, where somebody has some
        super().__init__(capacity)

    # -- generators ---------------------------------------------------------------------------
    def _open(self, capacity: int) -> None:
        super()._open(capacity)
        self.one, self.zero = self.element(1), self.element(0)

    def generator(self, generator: Generator, rate: Ratio | None = None, key: Any = None) -> Ratio:
        """Adds a generator; with `key`, returns the one already made under that key."""
        made = None if key is None else self.known(key)
        if made is not None:
            return made
        index = len(self.generators)
        self.reserve(index + 1)
        self.generators[index] = generator
        if rate is not None:
            self._rates[index] = rate
        if key is not None:
            self._atoms[key] = index
        return self.variable(index)

    def known(self, key: Any) -> Ratio | None:
        """The generator that was made under a key."""
        return self.variable(self._atoms[key]) if key in self._atoms else None

    def set_rate(self, generator: Ratio, rate: Ratio) -> None:
        self._rates[self.index(generator)] = rate

    def clear_rate(self, index: int) -> None:
        self._rates.pop(index, None)

    @contextmanager
    def other_rates(self, rates: Mapping[int, Ratio]) -> abc.Generator[None]:
        """Some generators change otherwise inside."""
        kept = {g: self._rates.get(g) for g in rates}
        self._rates |= rates
        try:
            yield
        finally:
            for g, rate in kept.items():
                self._rates.pop(g)
                self._rates |= {} if rate is None else {g: rate}

    def variable(self, index: int) -> Ratio:
        return Ratio(self, self.variables[index], None)

    def index(self, generator: Ratio) -> int:
        (index,) = generator.generators()
        return index

    def parameter(self, name: str, *, positive: bool = False) -> Ratio:
        return self.generator(Generator(Symbol(name), "parameter", positive), key=("parameter", name))

    @property
    def pi(self) -> Ratio:
        return self.generator(
            Generator(Symbol("pi"), "parameter", True, lambda _values, f: f.pi), key=("parameter", "pi")
        )

    @property
    def time(self) -> Ratio:
        time = self.generator(Generator(Symbol("t"), "time"), self.one, key="time")
        self.no_angles.add(self.index(time))
        return time

    def acute(self, index: int) -> bool:
        """True for a parameter that is an angle between 0 and 90 degrees."""
        return index in self.acute_angles

    def is_constant_generator(self, index: int) -> bool:
        return index not in self._rates or self._rates[index].is_zero()

    # -- elements -----------------------------------------------------------------------------
    def element(self, value: Ratio | int | Fraction) -> Ratio:
        if isinstance(value, Ratio):
            return value
        if isinstance(value, int):
            return Ratio(self, self.constant(value), None)
        fraction = Fraction(value)
        num = self.constant(fraction.numerator)
        den = None if fraction.denominator == 1 else self.constant(fraction.denominator)
        return Ratio(self, num, den)

    def lift(self, a: Ratio, b: Ratio) -> tuple[Poly, Poly]:
        """The numerators, both in the present context (the pool may have grown since), in which the elements are
        written from here on."""
        for x in (a, b):
            if not self.is_current(x.num):
                x.num, x.den = self.current(x.num), None if x.den is None else self.current(x.den)
        return a.num, b.num

    def denominators(self, a: Ratio, b: Ratio) -> tuple[Poly, Poly]:
        one = self.one.num
        return (
            one if a.den is None else self.current(a.den),
            one if b.den is None else self.current(b.den),
        )

    def quotient(self, num: Poly, den: Poly | None) -> Ratio:
        num = self.reduce(self.current(num))
        if den is None:
            return Ratio(self, num, None)
        below: Poly = self.reduce(self.current(den))
        if below == 0:
            raise ZeroDivisionError("division by an expression that is zero")
        if num == 0:
            return Ratio(self, num, None)
        divisor = self.common_divisor(num, below)
        if not divisor.is_one():
            num, below = num / divisor, below / divisor
        if below.leading_coefficient() < 0:
            num, below = -num, -below
        return Ratio(self, num, None if below.is_one() else below)

    def polynomial(self, terms: Terms) -> Ratio:
        return Ratio(self, self.reduce(self.as_written(terms)), None)

    # -- calculus -----------------------------------------------------------------------------
    def partial(self, x: Ratio, generator: int) -> Ratio:
        """Derivative with respect to one generator, the others held."""
        name = f"g{generator}"
        num = self.current(x.num)
        if x.den is None:
            return Ratio(self, self.reduce(num.derivative(name)), None)
        den = self.current(x.den)
        slope = den.derivative(name)
        is_plain = all(self.generators[g].kind != "root" for g in self.used(den))  # a root goes with its square
        if slope == 0 and is_plain:  # a square of sines, once reduced, would no more show that it cancels
            return self.quotient(num.derivative(name), den)
        top = self.product(num.derivative(name), den) - self.product(num, slope)
        return self.quotient(top, self.product(den, den))

    def rate(self, x: Ratio) -> Ratio:
        """Total time derivative."""
        return self._derivative(x, self._rates)

    def _derivative(self, x: Ratio, rates: Mapping[int, Ratio]) -> Ratio:
        result = self.zero
        for index in x.generators():
            if index in rates:
                result = result + self.partial(x, index) * rates[index]
        return result

    def derivative(self, x: Ratio, coordinate: int) -> Ratio:
        """Derivative along one coordinate (or the time), its sines, cosines and roots following it."""
        return self._derivative(x, self.directions(x, coordinate))

    def directions(self, x: Ratio, coordinate: int) -> dict[int, Ratio]:
        """How generators of x run along one coordinate: itself, and the sines, cosines and roots that follow it."""
        direction: dict[int, Ratio] = {coordinate: self.one}
        speeds = self._rates.get(coordinate)
        if speeds is None:
            return direction
        speed = None if speeds.is_one() else self.index(speeds)  # that of the time is one
        for index in x.generators() - {coordinate}:
            rate = self._rates.get(index)
            if rate is not None and self.generators[index].kind in ("cos", "sin", "root", "function"):
                slope = self._without_speeds(rate) if speed is None else self.partial(rate, speed)
                if not slope.is_zero():
                    direction[index] = slope
        return direction

    def parts(self, x: Ratio) -> tuple[Ratio, Ratio]:
        """Numerator and denominator."""
        num, den = self.current(x.num), None if x.den is None else self.current(x.den)
        return Ratio(self, num, None), self.one if den is None else Ratio(self, den, None)

    def _without_speeds(self, rate: Ratio) -> Ratio:
        """A rate where nothing moves but the time."""
        still = {g: self.zero for g in rate.generators() if self.generators[g].kind in ("speed", "acceleration")}
        return self.substitute(rate, still)

    def ingredients(self, x: Ratio) -> frozenset[int]:
        """The generators of x and all that they are made of."""
        found: set[int] = set()
        for index in x.generators():
            found |= {index} | self.generators[index].made_of
        return frozenset(found)

    def follow(self, x: Ratio, values: Mapping[int, Ratio]) -> Ratio:
        """Replaces generators by elements, in sines, roots and other atoms as well."""
        all_values = dict(values)
        for index in sorted(x.generators()):
            generator = self.generators[index]
            if index not in all_values and generator.remake is not None and generator.made_of & values.keys():
                all_values[index] = generator.remake(lambda part: self.follow(part, values))
        return self.substitute(x, all_values)

    def substitute(self, x: Ratio, values: Mapping[int, Ratio]) -> Ratio:
        """Replaces generators by elements, all at once; atoms that depend on them are not followed."""
        present = [g for g in values if g in x.generators()]
        if not present:
            return x
        top = self._substitute_poly(x.num, present, values)
        if x.den is None:
            return top
        below = self._substitute_poly(x.den, present, values)
        if below.is_zero():
            raise DivisorVanishes(Ratio(self, x.den, None))
        return top / below

    def _substitute_poly(self, poly: Poly, present: Sequence[int], values: Mapping[int, Ratio]) -> Ratio:
        powers: dict[tuple[int, int], Ratio] = {}

        def raised(index: int, exponent: int) -> Ratio:
            if (index, exponent) not in powers:
                powers[index, exponent] = (
                    values[index] if exponent == 1 else raised(index, exponent - 1) * values[index]
                )
            return powers[index, exponent]

        wanted = set(present)
        groups: dict[tuple[tuple[int, int], ...], dict[tuple[tuple[int, int], ...], int]] = {}
        for monomial, coefficient in self.terms(poly).items():
            out = tuple(item for item in monomial if item[0] in wanted)
            rest = tuple(item for item in monomial if item[0] not in wanted)
            groups.setdefault(out, {})[rest] = coefficient
        result = self.zero
        for out, rest in groups.items():
            term = self.polynomial(rest)
            for index, exponent in out:
                term = term * raised(index, exponent)
            result = result + term
        return result

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
            raise NoRealRoot(Message("square root of the negative number {x}", x=to_text(self.expression(x))))
        if (apart := root_without_root(inside, is_negative or self.has_negative_sign)) is not None:
            return outside * apart
        return outside * self._root(inside, is_negative if is_kept else None)

    def size_of(self, x: Ratio, is_negative: Callable[[Ratio], bool | None]) -> Ratio:
        """|x|, of what has no denominator, factor by factor; a root of its square where a sign is open."""
        unit, factors = self.factor(x.num)
        size = self.element(abs(unit))
        for base, exponent in factors:
            taken = self._root_of_square(base, is_negative)
            size = size * (self._root(base * base) if taken is None else taken) ** exponent
        return size

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
        n = radicand.fraction()
        positive = n is not None
        whole = None if n is None or n.denominator > 1 else n.numerator
        if whole is not None and (factors := factors_among(whole, self._number_roots)) is not None:
            return math.prod((self.variable(self._number_roots[k]) for k in factors), start=self.one)
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
        if whole is not None:
            self._number_roots[whole] = index
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
        """Cancels what numerator and denominator share once c^2 + s^2 = 1 is used, and sums of the cosines of equal
        parts of a turn."""
        if self.sums_of_parts and (shorter := self.substitute(x, self.sums_of_parts)).n_terms < x.n_terms:
            x = shorter
        if x.den is None:
            return x
        if self._number_roots and (plain := self._over_a_whole_number(x)) is not None:
            return plain
        pairs = [p for p in self.pairs(self.used(x.den)) if self.generators[p[0]].kind == "cos"]
        found = cancelled(self, x.num, x.den, pairs)
        return x if found is None else self.quotient(*found)

    def _over_a_whole_number(self, x: Ratio) -> Ratio | None:
        """With a whole number below where there is a sum of roots of numbers: digits do not cancel in it. None where
        something else stands there."""
        below = x.denominator()
        if not (used := below.generators()) or not used <= {*self._number_roots.values()}:
            return None
        inverse = in_roots(1 / below)
        if inverse is None:
            return None
        parts = (self.element(a) * self.sqrt(self.element(n)) for n, a in inverse.items())
        return x.numerator() * sum(parts, self.zero)

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
        return with_computed(self.generators, values, functions)

    def when_asked(self, values: Mapping[int, Any], functions: Any = math) -> Mapping[int, Any]:
        """The same values as of `complete`, each computed when it is first asked for: of use where few are needed."""
        return WhenAsked(self.generators, values, functions)

    def evaluate(self, x: Ratio, values: Mapping[int, Any], functions: Any = math) -> Any:
        """Value at the given generator values (floats, mpmath numbers, arrays)."""
        top, below = x.terms()
        value = value_of(self.generators, top, values)
        return value if x.den is None else value / value_of(self.generators, below, values)

    def numerator_and_size(self, x: Ratio, values: Mapping[int, float]) -> tuple[float, float]:
        """The numerator at the given values, and the sum of the sizes of its terms, whatever they are measured in."""
        return sum_and_size(self.generators, x.terms()[0], values)

    def vanishes_at(self, x: Ratio, values: Mapping[int, float], share: float) -> bool:
        """Whether no more than a share of the terms is left of their sum, which is round-off then."""
        total, size = self.numerator_and_size(x, values)
        return abs(total) <= share * size

    def expression(self, x: Ratio) -> Expr:
        """The plain expression, expanded; see `tidy` for the form people read."""
        top = self.poly_expression(x.num)
        return top if x.den is None else divide(top, self.poly_expression(x.den))

    def poly_expression(self, poly: Poly) -> Expr:
        powers = cache(self._power)  # few of them stand in many terms
        summands: list[Expr] = []
        ordered = sorted(self.terms(poly).items(), key=lambda item: declaration_order(item[0]))
        for monomial, coefficient in ordered:
            outside, root, rest = self._roots_as_one(monomial)
            summands.append(multiply(Number(coefficient * outside), root, *(powers(g, n) for g, n in reversed(rest))))
        return add(*summands)

    def _roots_as_one(self, monomial: Monomial) -> tuple[Fraction, Expr, Monomial]:
        """Roots of numbers in a product as one: sqrt(2) sqrt(3) is sqrt(6), whichever of them were made."""
        roots = self._number_roots
        under = {index: n for n, index in roots.items()} if len(roots) > 1 else {}
        several = [under[g] for g, _n in monomial if g in under]
        if len(several) < 2:
            return Fraction(1), ONE, monomial
        square, free = square_part(math.prod(several))
        rest = tuple((g, n) for g, n in monomial if g not in under)
        return Fraction(square), power(number(free), number(Fraction(1, 2))), rest

    def _power(self, index: int, exponent: int) -> Expr:
        return power(self.generators[index].display, number(exponent))
