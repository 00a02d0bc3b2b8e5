"""Exact rational functions of named generators that change in time.

An element is a quotient of two polynomials with integer coefficients in the generators (see `polynomials`). A generator
may be

- free: a parameter, a coordinate, a speed, an acceleration, time, a given function of time;
- bound by a quadratic relation g^2 = r in earlier generators: the sine of an angle whose cosine
  is a generator (s^2 = 1 - c^2), or a square root;
- a function atom (exp, atan ...) of an earlier element (see `atoms`).

Every generator knows its time derivative, so `DifferentialField.rate` is total differentiation in time.
"""

from __future__ import annotations

from collections import abc
from collections.abc import Callable, Mapping, Sequence
from contextlib import contextmanager, suppress
from dataclasses import dataclass
from fractions import Fraction
from typing import TYPE_CHECKING, Any, Literal, cast

from freebody.language.expression import Expr, Symbol
from freebody.symbolic.polynomials import Poly, PolynomialRing, Terms
from freebody.symbolic.ratio import DivisorVanishes, Ratio

if TYPE_CHECKING:
    from freebody.symbolic.field import Field

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


class WhenAsked(dict[int, Any]):
    """Values of generators; those that are computed are so when they are first asked for."""

    def __init__(self, generators: Mapping[int, Generator], values: Mapping[int, Any], functions: Any) -> None:
        super().__init__(values)
        self._generators, self._functions = generators, functions

    def __missing__(self, index: int) -> Any:
        compute = self._generators[index].compute
        if compute is not None:
            with suppress(KeyError, ValueError, ArithmeticError):
                value = self[index] = compute(self, self._functions)
                return value
        raise KeyError(index)


class DifferentialField(PolynomialRing):
    """The generators with their rates, the elements that are made of them, and derivatives of these."""

    def __init__(self, capacity: int = 64) -> None:
        self.generators: dict[int, Generator] = {}
        self.last_long: tuple[Ratio, tuple[Terms, Terms]] | None = None
        self._rates: dict[int, Ratio] = {}
        self._atoms: dict[Any, int] = {}
        self.acute_angles: set[int] = set()
        self.no_angles: set[int] = set()  # what moves and is a length or a time
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
        return self.over(self.variables[index])

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
            return self.over(self.constant(value))
        fraction = Fraction(value)
        num = self.constant(fraction.numerator)
        den = None if fraction.denominator == 1 else self.constant(fraction.denominator)
        return self.over(num, den)

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
            return self.over(num)
        below: Poly = self.reduce(self.current(den))
        if below == 0:
            raise ZeroDivisionError("division by an expression that is zero")
        if num == 0:
            return self.over(num)
        divisor = num.gcd(below)
        if not divisor.is_one():
            num, below = num / divisor, below / divisor
        if below.leading_coefficient() < 0:
            num, below = -num, -below
        return self.over(num, None if below.is_one() else below)

    def polynomial(self, terms: Terms) -> Ratio:
        return self.over(self.reduce(self.as_written(terms)))

    def over(self, num: Poly, den: Poly | None = None) -> Ratio:
        """num/den as they stand: coprime and reduced."""
        return Ratio(cast("Field", self), num, den)

    # -- calculus -----------------------------------------------------------------------------
    def partial(self, x: Ratio, generator: int) -> Ratio:
        """Derivative with respect to one generator, the others held."""
        name = f"g{generator}"
        num = self.current(x.num)
        if x.den is None:
            return self.over(self.reduce(num.derivative(name)))
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
        direction: dict[int, Ratio] = {coordinate: self.one}
        speeds = self._rates.get(coordinate)
        if speeds is None:
            return self.partial(x, coordinate)
        speed = None if speeds.is_one() else self.index(speeds)  # that of the time is one
        for index in x.generators() - {coordinate}:
            rate = self._rates.get(index)
            if rate is not None and self.generators[index].kind in ("cos", "sin", "root", "function"):
                slope = self._without_speeds(rate) if speed is None else self.partial(rate, speed)
                if not slope.is_zero():
                    direction[index] = slope
        return self._derivative(x, direction)

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
            raise DivisorVanishes(self.over(x.den, None))
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
