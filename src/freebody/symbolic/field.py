"""The field in which the symbolic route computes: exact rational functions.

An element is a quotient of two polynomials with integer coefficients in named generators
(FLINT does the polynomial arithmetic). A generator may be

- free: a parameter, a coordinate, a speed, an acceleration, time, a given function of time;
- bound by a quadratic relation g^2 = r in earlier generators: the sine of an angle whose cosine
  is a generator (s^2 = 1 - c^2), or a square root;
- a function atom (exp, atan ...) of an earlier element.

Later generators are larger in the lexicographic order, so dividing by g^2 - r is the reduction to the
normal form. The quotient ring is an integral domain, hence a/b = c/d if and only if a d - b c reduces
to zero: equality is decided exactly, without `simplify`.

Every generator knows its time derivative, so `Field.rate` is total differentiation in time.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass
from fractions import Fraction
from typing import Any, Literal, TypeAlias

import flint

from freebody.errors import CannotAnswer
from freebody.language.expression import Call, Expr, Number, Symbol, add, divide, multiply, number, power
from freebody.language.notation import to_text
from freebody.language.sentences import Message
from freebody.tolerances import ROUND_OFF

_flint: Any = flint
Poly: TypeAlias = Any  # fmpz_mpoly: FLINT ships no type information
Kind = Literal["parameter", "coordinate", "speed", "acceleration", "time", "cos", "sin", "root", "function"]

# Above this many terms an element is no longer something that anybody reads or that factors quickly.
TERM_LIMIT = 60_000
_PRIME = 2**61 - 1
_LOWEST_TERMS_LIMIT = 1_000_000  # terms times the growth that half-angle tangents may bring
_QUICK_TERMS = 40
MAX_POWER = 64


class NoValue(CannotAnswer, KeyError):
    """A part of a formula has no real value at the numbers that are put in."""

    def __init__(self, name: str) -> None:
        super().__init__(Message("{x} has no real value here", x=name))

    __str__ = Exception.__str__


class DivisorVanishes(ZeroDivisionError):
    """A divisor of a formula is zero in the state that is put in."""

    def __init__(self, divisor: Ratio) -> None:
        super().__init__("division by an expression that is zero in the state that is put in")
        self.divisor = divisor


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


class Ratio:
    """An element of the field: `num / den`, coprime, the leading coefficient of `den` positive."""

    __slots__ = ("_generators", "den", "field", "num")

    def __init__(self, field: Field, num: Poly, den: Poly | None) -> None:
        self.field = field
        self.num = num
        self.den = den  # None means 1
        self._generators: frozenset[int] | None = None

    # -- arithmetic ---------------------------------------------------------------------------
    def __add__(self, other: Ratio | int) -> Ratio:
        b = self.field.element(other)
        an, bn = self.field.lift(self, b)
        if self.den is None and b.den is None:
            return Ratio(self.field, an + bn, None)
        ad, bd = self.field.denominators(self, b)
        if ad == bd:
            return self.field.quotient(an + bn, ad)
        return self.field.quotient(an * bd + bn * ad, ad * bd)

    __radd__ = __add__

    def __neg__(self) -> Ratio:
        return Ratio(self.field, -self.num, self.den)

    def __sub__(self, other: Ratio | int) -> Ratio:
        return self + (-self.field.element(other))

    def __rsub__(self, other: int) -> Ratio:
        return (-self) + other

    def __mul__(self, other: Ratio | int) -> Ratio:
        b = self.field.element(other)
        an, bn = self.field.lift(self, b)
        if self.den is None and b.den is None:
            return Ratio(self.field, self.field.reduce(an * bn), None)
        ad, bd = self.field.denominators(self, b)
        return self.field.quotient(an * bn, ad * bd)

    __rmul__ = __mul__

    def __truediv__(self, other: Ratio | int) -> Ratio:
        b = self.field.element(other)
        if b.is_zero():
            raise ZeroDivisionError("division by an expression that is zero")
        an, bn = self.field.lift(self, b)
        ad, bd = self.field.denominators(self, b)
        return self.field.quotient(an * bd, ad * bn)

    def __rtruediv__(self, other: int) -> Ratio:
        return self.field.element(other) / self

    def __pow__(self, exponent: int | Ratio) -> Ratio:
        if isinstance(exponent, Ratio):
            fraction = exponent.fraction()
            if fraction is None or fraction.denominator > 2:
                raise CannotAnswer(Message("the exponent {e} is neither a whole nor a half number", e=exponent))
            if fraction.denominator == 2:
                return self.field.sqrt(self) ** fraction.numerator
            exponent = fraction.numerator
        if abs(exponent) > MAX_POWER:
            raise CannotAnswer(Message("the exponent {e} is larger than {most}", e=exponent, most=MAX_POWER))
        if exponent < 0:
            return 1 / (self**-exponent)
        result = self.field.one
        for _ in range(exponent):
            result = result * self
        return result

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, (Ratio, int)):
            return NotImplemented
        return (self - other).is_zero()

    def __hash__(self) -> int:
        return hash(self.key())

    # -- questions ----------------------------------------------------------------------------
    def is_zero(self) -> bool:
        return bool(self.num == 0)

    def is_constant(self) -> bool:
        """True if nothing in it moves: numbers and parameters only."""
        return all(self.field.is_constant_generator(g) for g in self.generators())

    def generators(self) -> frozenset[int]:
        """Indices of the generators that occur."""
        if self._generators is None:
            used = self.field.used(self.num)
            self._generators = frozenset(used if self.den is None else used | self.field.used(self.den))
        return self._generators

    def denominator(self) -> Ratio:
        return self.field.one if self.den is None else Ratio(self.field, self.den, None)

    def numerator(self) -> Ratio:
        return Ratio(self.field, self.num, None)

    def fraction(self) -> Fraction | None:
        """The rational number that it is, if it is one."""
        if self.generators():
            return None
        den = 1 if self.den is None else int(self.den.leading_coefficient())
        return Fraction(0 if self.is_zero() else int(self.num.leading_coefficient()), den)

    def key(self) -> tuple[Any, ...]:
        """A hashable form; equal elements in normal form have equal keys."""
        n = tuple(sorted(self.field.terms(self.num).items()))
        d = () if self.den is None else tuple(sorted(self.field.terms(self.den).items()))
        return n, d

    def coefficients(self, generator: int) -> list[Ratio]:
        """c_0, c_1, ... with self = sum c_k g^k; the denominator must be free of g."""
        parts = self.field.split(self.num, generator)
        if self.den is not None and generator in self.field.used(self.den):
            raise CannotAnswer(Message("{x} stands in a denominator", x=self.field.generators[generator].display))
        return [self.field.quotient(p, self.den) for p in parts]

    def __repr__(self) -> str:
        return str(self.field.expression(self))


class Field:
    """The generators, their relations and rates; makes, reduces, differentiates and shows elements."""

    def __init__(self, capacity: int = 64) -> None:
        self.generators: dict[int, Generator] = {}
        self._rates: dict[int, Ratio] = {}
        self._relations: dict[int, Poly] = {}
        self._atoms: dict[Any, int] = {}
        self.acute_angles: set[int] = set()
        self.nonnegative: set[int] = set()  # parameters that may be zero, and not less
        self.no_angles: set[int] = set()  # what moves and is a length or a time
        self.angle_units: dict[Any, list[Fraction]] = {}  # terms that are no multiples of angles, by what they share
        self.arguments: dict[int, tuple[str, Ratio]] = {}  # name and argument of every function atom
        self.waves: dict[Any, Any] = {}  # products of sines and cosines as sums, kept by `tidy`
        self.angles: dict[int, Ratio] = {}  # the angle of every cosine generator
        self.known_pairs: dict[int, tuple[Ratio, Ratio]] = {}  # cosine and sine of angles that are made of them
        self.positive_roots: dict[int, bool] = {}  # what `signs` found out about roots
        self.decided: dict[Any, Any] = {}  # what `decide` found out about signs under premises
        self._open(capacity)
        self.one = self.element(1)
        self.zero = self.element(0)

    # -- generators ---------------------------------------------------------------------------
    def _open(self, capacity: int) -> None:
        """Indices count down from the end of the pool: generator k of the pool is named g<k>, and later
        generators are larger in the lexicographic order. Names are stable when the pool grows."""
        self._capacity = capacity
        names = [f"g{k}" for k in range(capacity - 1, -1, -1)]
        self._context = _flint.fmpz_mpoly_ctx.get(names, _flint.Ordering.lex)
        self._variables = list(reversed(self._context.gens()))

    def _grow(self) -> None:
        self._open(2 * self._capacity)
        self._relations = {k: self._project(p) for k, p in self._relations.items()}
        self.one, self.zero = self.element(1), self.element(0)

    def _project(self, poly: Poly) -> Poly:
        return poly.project_to_context(self._context)

    def generator(self, generator: Generator, rate: Ratio | None = None, key: Any = None) -> Ratio:
        """Adds a generator; with `key`, returns the one already made under that key."""
        if key is not None and key in self._atoms:
            return self.variable(self._atoms[key])
        index = len(self.generators)
        if index >= self._capacity:
            self._grow()
        self.generators[index] = generator
        if rate is not None:
            self._rates[index] = rate
        if key is not None:
            self._atoms[key] = index
        return self.variable(index)

    def set_rate(self, generator: Ratio, rate: Ratio) -> None:
        self._rates[self.index(generator)] = rate

    def clear_rate(self, index: int) -> None:
        self._rates.pop(index, None)

    def variable(self, index: int) -> Ratio:
        return Ratio(self, self._variables[index], None)

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
        fraction = Fraction(value)
        num = self._context.constant(fraction.numerator)
        den = None if fraction.denominator == 1 else self._context.constant(fraction.denominator)
        return Ratio(self, num, den)

    def lift(self, a: Ratio, b: Ratio) -> tuple[Poly, Poly]:
        """The numerators, both in the present context (the pool may have grown since)."""
        return self.current(a.num), self.current(b.num)

    def current(self, poly: Poly) -> Poly:
        return poly if poly.context() is self._context else self._project(poly)

    def denominators(self, a: Ratio, b: Ratio) -> tuple[Poly, Poly]:
        one = self.one.num
        return (
            one if a.den is None else self.current(a.den),
            one if b.den is None else self.current(b.den),
        )

    def reduce(self, poly: Poly) -> Poly:
        """Normal form modulo the relations g^2 = r."""
        if len(poly) > TERM_LIMIT:
            raise CannotAnswer(
                Message(
                    "the closed form would have more than {n} terms; ask for numbers or for the "
                    "equations of motion instead",
                    n=TERM_LIMIT,
                )
            )
        if not self._relations or poly.is_constant():
            return poly
        degrees = poly.degrees()
        last = self._capacity - 1
        if all(degrees[last - index] < 2 for index in self._relations):
            return poly
        for index in sorted(self._relations, reverse=True):
            if poly.degrees()[last - index] >= 2:
                poly = divmod(poly, self._relations[index])[1]
        return poly

    def quotient(self, num: Poly, den: Poly | None) -> Ratio:
        num = self.reduce(self.current(num))
        if den is None:
            return Ratio(self, num, None)
        below: Poly = self.reduce(self.current(den))
        if below == 0:
            raise ZeroDivisionError("division by an expression that is zero")
        if num == 0:
            return Ratio(self, num, None)
        divisor = num.gcd(below)
        if not divisor.is_one():
            num, below = num / divisor, below / divisor
        if below.leading_coefficient() < 0:
            num, below = -num, -below
        return Ratio(self, num, None if below.is_one() else below)

    def used(self, poly: Poly) -> set[int]:
        last = poly.context().nvars() - 1
        return {last - k for k, degree in enumerate(poly.degrees()) if degree > 0}

    def terms(self, poly: Poly) -> dict[tuple[tuple[int, int], ...], int]:
        """The polynomial as {((generator, exponent), ...): coefficient}."""
        last = poly.context().nvars() - 1
        places = [(k, last - k) for k, degree in enumerate(poly.degrees()) if degree > 0]
        return {tuple((g, int(m[k])) for k, g in places if m[k]): int(c) for m, c in poly.to_dict().items()}

    def polynomial(self, terms: Mapping[tuple[tuple[int, int], ...], int]) -> Ratio:
        data: dict[tuple[int, ...], int] = {}
        for monomial, coefficient in terms.items():
            exponents = [0] * self._capacity
            for index, exponent in monomial:
                exponents[self._capacity - 1 - index] += exponent
            key = tuple(exponents)
            data[key] = data.get(key, 0) + coefficient
        return Ratio(self, self.reduce(self._context.from_dict(data)), None)

    def _as_written(self, terms: Mapping[tuple[tuple[int, int], ...], int]) -> Poly:
        """A polynomial of which no relation is used."""
        data: dict[tuple[int, ...], int] = {}
        for monomial, coefficient in terms.items():
            exponents = [0] * self._capacity
            for index, exponent in monomial:
                exponents[self._capacity - 1 - index] += exponent
            data[tuple(exponents)] = coefficient
        return self._context.from_dict(data)

    def square_root(self, terms: Mapping[tuple[tuple[int, int], ...], int]) -> Ratio | None:
        """Of a polynomial that is a perfect square as it is written, before any relation is used; else None."""
        try:
            root = self._as_written(terms).sqrt()
        except (_flint.utils.flint_exceptions.DomainError, ValueError):
            return None
        return Ratio(self, self.reduce(root), None)

    def factors_in(self, terms: Mapping[tuple[tuple[int, int], ...], int], generator: int) -> list[list[Ratio]]:
        """The factors of a polynomial as it is written that contain a generator: coefficients of its powers, lowest
        first."""
        poly = self._as_written(terms)
        small = poly.context().drop_gens(poly.unused_gens())
        found: list[list[Ratio]] = []
        for factor, _exponent in poly.project_to_context(small).factor()[1]:
            parts = self.split(factor.project_to_context(self._context), generator)
            if len(parts) > 1:
                found.append([Ratio(self, self.reduce(p), None) for p in parts])
        return found

    def split(self, poly: Poly, generator: int) -> list[Poly]:
        """Coefficients of the powers of one generator, lowest first."""
        poly = self.current(poly)
        place = self._capacity - 1 - generator
        parts: dict[int, dict[tuple[int, ...], int]] = {}
        for monomial, coefficient in poly.to_dict().items():
            rest = list(monomial)
            exponent, rest[place] = int(rest[place]), 0
            parts.setdefault(exponent, {})[tuple(rest)] = coefficient
        highest = max(parts, default=0)
        return [self._context.from_dict(parts.get(k, {})) for k in range(highest + 1)]

    # -- calculus -----------------------------------------------------------------------------
    def partial(self, x: Ratio, generator: int) -> Ratio:
        """Derivative with respect to one generator, the others held."""
        name = f"g{generator}"
        num = self.current(x.num)
        if x.den is None:
            return Ratio(self, self.reduce(num.derivative(name)), None)
        den = self.current(x.den)
        return self.quotient(num.derivative(name) * den - num * den.derivative(name), den * den)

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
        """Derivative along one coordinate, its sines, cosines and roots following it."""
        direction: dict[int, Ratio] = {coordinate: self.one}
        speeds = self._rates.get(coordinate)
        if speeds is None:
            return self.partial(x, coordinate)
        speed = self.index(speeds)
        for index in x.generators() - {coordinate}:
            rate = self._rates.get(index)
            if rate is not None and self.generators[index].kind in ("cos", "sin", "root", "function"):
                slope = self.partial(rate, speed)
                if not slope.is_zero():
                    direction[index] = slope
        return self._derivative(x, direction)

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
        of them whether its sign must be turned (default: never), and if `is_kept` also for what becomes of the root
        when something in it is replaced. Where it tells nothing (None) the root of the square stays."""
        if x.is_zero():
            return x
        num, den = self.current(x.num), self.one.num if x.den is None else self.current(x.den)
        unit, factors = self._with_sines(*self.factor(num * den))
        outside, inside = self.one, self.one
        if unit < 0:
            inside = -inside
        square, free = _square_part(abs(unit))
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
        outside = outside / (-below if is_negative is not None and is_negative(below) else below)
        if inside == 1:
            return outside
        if (inside.fraction() or 1) < 0:
            raise CannotAnswer(Message("square root of the negative number {x}", x=x))
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

    @staticmethod
    def _root_of_square(base: Ratio, is_negative: Callable[[Ratio], bool | None] | None) -> Ratio | None:
        """|base|, or None if its sign is open and nobody decides it."""
        if is_negative is not None:
            turned = is_negative(base)
            return None if turned is None else -base if turned else base
        from freebody.symbolic.signs import Sign, sign_of

        sign = sign_of(base)
        if sign in (Sign.POSITIVE, Sign.NONNEGATIVE):
            return base
        return -base if sign in (Sign.NEGATIVE, Sign.NONPOSITIVE) else None

    def _root(self, radicand: Ratio, is_negative: Callable[[Ratio], bool | None] | None = None) -> Ratio:
        key = ("root", radicand.key())
        if key in self._atoms:
            return self.variable(self._atoms[key])
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
        self._relations[index] = self._variables[index] ** 2 - self.current(radicand.num)
        if not radicand.is_constant():
            # (sqrt r)' = r'/(2 sqrt r)
            self._rates[index] = self.rate(radicand) / (2 * root)
        return root

    def radicand(self, index: int) -> Ratio:
        """g^2 of a root generator."""
        return Ratio(self, self._variables[index] ** 2 - self._relations[index], None)

    def unit_pair(self, angle: Ratio, cos: Generator, sin: Generator, key: Any) -> tuple[Ratio, Ratio]:
        """Cosine and sine of an angle, bound by s^2 = 1 - c^2."""
        if key in self._atoms:
            index = self._atoms[key]
            return self.variable(index), self.variable(index + 1)
        if len(self.generators) + 2 > self._capacity:
            self._grow()
        c = self.generator(cos, key=key)
        s = self.generator(sin)
        index = self.index(s)
        self._relations[index] = self._variables[index] ** 2 + self._variables[index - 1] ** 2 - 1
        self.angles[index - 1] = angle
        rate = self.rate(angle)
        if not rate.is_zero():
            self._rates[index - 1] = -s * rate
            self._rates[index] = c * rate
        return c, s

    def angle_with(self, cos: Ratio, sin: Ratio) -> Ratio:
        """The angle whose cosine and sine are given elements, pi where 2 atan(sin/(1 + cos)) has no value."""
        if cos == -1:
            return self.pi
        key = ("angle with", cos.key(), sin.key())
        if key in self._atoms:
            return self.variable(self._atoms[key])
        atom = self.generator(
            Generator(
                multiply(number(2), Call("atan", self.expression(sin / (1 + cos)))),
                "function",
                compute=lambda v, f: f.atan2(self.evaluate(sin, v, f), self.evaluate(cos, v, f)),
                made_of=self.ingredients(cos) | self.ingredients(sin),
                remake=lambda follow: self.angle_with(follow(cos), follow(sin)),
            ),
            key=key,
        )
        self.known_pairs[self.index(atom)] = cos, sin
        rate = self.lowest_terms(cos * self.rate(sin) - sin * self.rate(cos))
        if not rate.is_zero():
            self._rates[self.index(atom)] = rate
        return atom

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

    def lowest_terms(self, x: Ratio) -> Ratio:
        """Cancels what numerator and denominator share once c^2 + s^2 = 1 is used.

        With T = tan(angle/2), c = (1 - T^2)/(1 + T^2) and s = 2T/(1 + T^2), the element becomes a quotient of
        plain polynomials, whose greatest common divisor FLINT finds. Back again, T^j/(1 + T^2)^n is
        ((1 - c)/2)^a ((1 + c)/2)^b (s/2)^odd. The generators c and s themselves serve as T on the way.
        """
        if x.den is None:
            return x
        pairs = [p for p in self.pairs(self.used(x.den)) if self.generators[p[0]].kind == "cos"]
        if not pairs or len(x.num) + len(x.den) > _LOWEST_TERMS_LIMIT:
            return x
        if self._half_tangent_growth(x, pairs) * (len(x.num) + len(x.den)) > _LOWEST_TERMS_LIMIT:
            return x
        num, den = self.current(x.num), self.current(x.den)
        if not self._may_share(num, den, pairs):
            return x
        for pair in pairs:
            num, den = self._half_tangent(num, den, pair)
        divisor = num.gcd(den)
        if divisor.is_constant():
            return x
        num, den = num / divisor, den / divisor
        for pair in pairs:
            num, den = self._from_half_tangent(num, den, pair)
        return self.quotient(num, den)

    def _may_share(self, num: Poly, den: Poly, pairs: Sequence[tuple[int, int]]) -> bool:
        """Whether both may have a common factor with T = tan(angle/2) of a pair: seen modulo a prime, where everything
        else is a number, cosines and sines on the circle. Factors without any T they cannot share: those divide the
        elements as they are."""
        known: dict[int, int] = {}
        for index in self.used(num) | self.used(den):
            known[index] = _scattered(index)
        for c, s in pairs:
            t = _scattered(c)
            below = pow(1 + t * t, -1, _PRIME)
            known[c], known[s] = (1 - t * t) * below % _PRIME, 2 * t * below % _PRIME
        terms = [self.terms(poly) for poly in (num, den)]
        return any(self._shares_tangent(terms, pair, known) for pair in pairs)

    @staticmethod
    def _shares_tangent(
        both: Sequence[Mapping[tuple[tuple[int, int], ...], int]], pair: tuple[int, int], known: Mapping[int, int]
    ) -> bool:
        """Whether two polynomials have a common factor with the T of a pair, the other generators being numbers."""
        c, s = pair
        seen: list[dict[tuple[int, int], int]] = []
        for terms in both:
            parts: dict[tuple[int, int], int] = {}
            for monomial, coefficient in terms.items():
                i = j = 0
                for index, exponent in monomial:
                    if index == c:
                        i = exponent
                    elif index == s:
                        j = exponent
                    else:
                        coefficient = coefficient * pow(known[index], exponent, _PRIME) % _PRIME
                parts[i, j] = (parts.get((i, j), 0) + coefficient) % _PRIME
            seen.append(parts)
        degree = max(i + j for parts in seen for i, j in parts)
        plus, minus, double = (_flint.nmod_poly(list(k), _PRIME) for k in ((1, 0, 1), (1, 0, -1), (0, 2)))
        found: list[Any] = []
        for parts in seen:
            total = _flint.nmod_poly([], _PRIME)
            for (i, j), coefficient in parts.items():
                total = total + coefficient * minus**i * double**j * plus ** (degree - i - j)
            found.append(total)
        return found[0].gcd(found[1]).degree() > 0

    @staticmethod
    def _half_tangent_growth(x: Ratio, pairs: Sequence[tuple[int, int]]) -> int:
        """A term of degree n in one angle becomes up to 2n + 1 terms."""
        growth = 1
        both: tuple[Poly, Poly] = (x.num, x.den)
        for c, s in pairs:
            degree = 0
            for poly in both:
                last, degrees = poly.context().nvars() - 1, poly.degrees()
                degree = max(degree, int(degrees[last - c]) + int(degrees[last - s]))
            growth *= 2 * degree + 1
        return growth

    def _half_tangent(self, num: Poly, den: Poly, pair: tuple[int, int]) -> tuple[Poly, Poly]:
        """Both polynomials times (1 + T^2)^degree, T written as the cosine's generator."""
        c, s = pair
        tangent = self._variables[c]
        result: list[Poly] = []
        split: list[dict[tuple[int, int], Poly]] = []
        degree = 0
        for poly in (num, den):
            parts: dict[tuple[int, int], Poly] = {}
            for i, by_cos in enumerate(self.split(poly, c)):
                for j, rest in enumerate(self.split(by_cos, s)):
                    if rest != 0:
                        parts[i, j] = rest
                        degree = max(degree, i + j)
            split.append(parts)
        plus, minus = 1 + tangent**2, 1 - tangent**2
        for parts in split:
            total = self.zero.num
            for (i, j), rest in parts.items():
                total = total + rest * minus**i * (2 * tangent) ** j * plus ** (degree - i - j)
            result.append(total)
        return result[0], result[1]

    def _from_half_tangent(self, num: Poly, den: Poly, pair: tuple[int, int]) -> tuple[Poly, Poly]:
        c, s = self._variables[pair[0]], self._variables[pair[1]]
        parts = [self.split(poly, pair[0]) for poly in (num, den)]
        n = (max(len(p) for p in parts)) // 2
        result: list[Poly] = []
        for coefficients in parts:
            total = self.zero.num
            for j, rest in enumerate(coefficients):
                if rest == 0:
                    continue
                a, odd = divmod(j, 2)
                b = n - a - odd
                # everything times 2^n
                total = total + rest * (1 - c) ** a * (1 + c) ** b * (s if odd else 1)
            result.append(self.reduce(total))
        return result[0], result[1]

    def factor(self, poly: Poly, *, is_quick: bool = False) -> tuple[int, list[tuple[Ratio, int]]]:
        """Integer content and irreducible factors with exponents, as elements; a quick one leaves a long rest whole.

        Common symbols and the content come out first. If then a symbol occurs in one term only, and there to
        the first power, the rest is linear in it with coprime parts, hence irreducible; FLINT factors the others."""
        terms = self.terms(poly)
        if not terms:
            return 0, []
        content, common, rest = primitive(terms)
        found = [(self.variable(g), e) for g, e in common.items()]
        if len(terms) == 1:
            return content, found
        remaining = self.polynomial(rest)
        if has_lonely_symbol(rest) or (is_quick and len(rest) > _QUICK_TERMS):
            return content, [*found, (remaining, 1)]
        unused = remaining.num.unused_gens()
        small = remaining.num.context().drop_gens(unused)
        try:
            unit, factors = remaining.num.project_to_context(small).factor()
        except OverflowError:  # FLINT's Python orders factors by machine integers; without factors it is as true
            return content, [*found, (remaining, 1)]
        found += [(Ratio(self, f.project_to_context(self._context), None), int(e)) for f, e in factors]
        return content * int(unit), found

    def factor_by_degree(self, poly: Poly) -> tuple[int, list[tuple[Ratio, int]]] | None:
        """Factors of a polynomial made homogeneous in the cosine and sine of its one angle, 1 = c^2 + s^2: so
        4 c^2 - 4 + ... is a square where it is one. None where this finds no more than `factor`."""
        pairs = self.pairs(self.used(poly))
        if len(pairs) != 1:
            return None
        (c, s), terms = pairs[0], self.terms(poly)
        degrees = {m: dict(m).get(c, 0) + dict(m).get(s, 0) for m in terms}
        highest = max(degrees.values(), default=0)
        if any((highest - d) % 2 for d in degrees.values()) or len(set(degrees.values())) < 2:
            return None
        gc, gs = self._variables[c], self._variables[s]
        free = self.current(poly) - self.current(poly)
        for m, coefficient in terms.items():
            term = self._context.constant(coefficient) * (gc**2 + gs**2) ** ((highest - degrees[m]) // 2)
            for index, exponent in m:
                term = term * self._variables[index] ** exponent
            free = free + term
        small = free.context().drop_gens(free.unused_gens())
        unit, factors = free.project_to_context(small).factor()
        found = [(Ratio(self, self.reduce(f.project_to_context(self._context)), None), int(e)) for f, e in factors]
        found = [(f, e) for f, e in found if f != 1]
        if sum(e for _f, e in found) <= sum(e for _f, e in self.factor(poly)[1]):
            return None
        return int(unit), found

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

    def evaluate(self, x: Ratio, values: Mapping[int, Any], functions: Any = math) -> Any:
        """Value at the given generator values (floats, mpmath numbers, arrays)."""
        top = self._evaluate_poly(x.num, values)
        return top if x.den is None else top / self._evaluate_poly(x.den, values)

    def _evaluate_poly(self, poly: Poly, values: Mapping[int, Any]) -> Any:
        total: Any = 0
        for monomial, coefficient in self.terms(poly).items():
            term: Any = coefficient
            try:
                for index, exponent in monomial:
                    term = term * values[index] ** exponent
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

        terms = self.terms(x.num).items()
        parts = (math.prod((values[k] ** e for k, e in monomial), start=float(c)) for monomial, c in terms)
        sizes = (math.prod((size(k) ** e for k, e in monomial), start=abs(float(c))) for monomial, c in terms)
        return math.fsum(parts), math.fsum(sizes)

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

    def function(self, name: str, argument: Ratio, rate_factor: Callable[[Ratio, Ratio], Ratio]) -> Ratio:
        """A function atom f(argument) with f' = rate_factor(f, argument) * argument'."""
        key = (name, argument.key())
        if key in self._atoms:
            return self.variable(self._atoms[key])
        atom = self.generator(
            Generator(
                Call(name, self.expression(argument)),
                "function",
                positive=name in ("exp", "cosh"),
                compute=lambda v, f: (
                    _sign(self.evaluate(argument, v, f))
                    if name == "sign"
                    else getattr(f, name)(self.evaluate(argument, v, f))
                ),
                made_of=self.ingredients(argument),
                remake=lambda follow: self.function(name, follow(argument), rate_factor),
            ),
            key=key,
        )
        self.arguments[self.index(atom)] = (name, argument)
        inner = self.rate(argument)
        if not inner.is_zero():
            self._rates[self.index(atom)] = rate_factor(atom, argument) * inner
        return atom


def _sign(x: Any) -> int:
    return (x > 0) - (x < 0)


Monomial: TypeAlias = tuple[tuple[int, int], ...]


def primitive(terms: Mapping[Monomial, int]) -> tuple[int, dict[int, int], dict[Monomial, int]]:
    """(content, common symbols with exponents, the rest) of a polynomial that is not zero; the content of a single
    term is its coefficient."""
    content = math.gcd(*terms.values()) if len(terms) > 1 else next(iter(terms.values()))
    common = dict(next(iter(terms)))
    for monomial in terms:
        powers = dict(monomial)
        common = {g: min(e, powers[g]) for g, e in common.items() if g in powers}
    rest = {
        tuple((g, e - common.get(g, 0)) for g, e in monomial if e > common.get(g, 0)): c // content
        for monomial, c in terms.items()
    }
    return content, common, rest


def has_lonely_symbol(terms: Mapping[Monomial, int]) -> bool:
    """True if a symbol occurs in one term only, and there to the first power."""
    count: dict[int, int] = {}
    degree: dict[int, int] = {}
    for monomial in terms:
        for g, e in monomial:
            count[g] = count.get(g, 0) + 1
            degree[g] = e
    return any(n == 1 and degree[g] == 1 for g, n in count.items())


def declaration_order(monomial: tuple[tuple[int, int], ...]) -> tuple[Any, ...]:
    """Sorts terms by the order in which symbols were declared, high powers of early symbols first."""
    return (*((g, -e) for g, e in sorted(monomial)), (10**6, 0))


def _square_part(value: int) -> tuple[int, int]:
    """value = square^2 * free, by trial division (numbers here are small; a big rest stays inside)."""
    square, free, prime = 1, 1, 2
    while prime * prime <= value and prime < 10_000:
        count = 0
        while value % prime == 0:
            value //= prime
            count += 1
        square *= prime ** (count // 2)
        free *= prime ** (count % 2)
        prime += 1
    root = math.isqrt(value)
    return (square * root, free) if root * root == value else (square, free * value)


def _scattered(k: int) -> int:
    """A number for a generator, other for every one, in no simple relation with others."""
    return 2 + 30011 * (k + 1) % 65537
