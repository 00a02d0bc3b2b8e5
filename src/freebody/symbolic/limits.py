"""To what an element tends as a parameter tends to a value, or grows without bound: its leading term.

With P = a + s d^k, or P = 1/d^k, and d -> 0 from above an element is c d^e (1 + o(1)); c and e of numerator and
denominator are found by the first derivative at d = 0 that does not vanish. k makes roots of d whole powers. What grows
inside of a function is taken out of it first:

    atan(u) = +-pi/2 - atan(1/u),      log(d^n h) = n log(d) + log(h),      exp(u) beyond all powers of d
Source: Hardy, Orders of Infinity, 1910; Gruntz, On Computing Limits in a Symbolic Manipulation System, 1996.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, field
from fractions import Fraction

from freebody.errors import CannotAnswer
from freebody.language.expression import Symbol
from freebody.language.sentences import Message
from freebody.symbolic.conditions import Condition, require
from freebody.symbolic.field import Field, Generator
from freebody.symbolic.functions import functions
from freebody.symbolic.model import SymbolicModel
from freebody.symbolic.numbers_with_roots import rational_root
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.signs import Sign, sign_of

_MOST = 10  # derivatives that are looked at
_POWERS = (1, 2, 4)  # of d, tried one after the other
_SAME = Message("which sign decides the limit")


@dataclass(frozen=True)
class Tendency:
    """An element is of the order of coefficient d^exponent. conditions: signs that were taken."""

    coefficient: Ratio
    exponent: float

    @property
    def is_finite(self) -> bool:
        return self.exponent >= 0

    @property
    def value(self) -> Ratio:
        return self.coefficient if self.exponent == 0 else self.coefficient.field.zero


@dataclass
class Approach:
    """A parameter on its way. value: None where it grows without bound; way: from above (1) or below (-1)."""

    model: SymbolicModel
    index: int
    value: Ratio | None
    way: int = 1
    conditions: list[Condition] = field(default_factory=list[Condition])
    _power: int = 1
    _grown: Ratio | None = None  # what stands in the exponential function that grows

    def of(self, x: Ratio) -> Tendency:
        """Raises CannotAnswer where an element tends to nothing, or that has no closed form."""
        why: CannotAnswer | None = None
        for power in _POWERS:
            self._power = power
            self._grown = None
            try:
                found = self._without_exponentials(self.put(x))
            except _RootOfNothing as error:
                why = error
                continue
            return self._with_logs(Tendency(self.model.field.zero, 0.0) if found is None else found)
        assert why is not None
        raise why

    def sign(self, x: Ratio) -> int:
        """Of a constant; where it is open, as it is at the model's own numbers, which is a condition then."""
        known = sign_of(x)
        if known is Sign.ZERO or x.is_zero():
            return 0
        if known in (Sign.POSITIVE, Sign.NEGATIVE):
            return 1 if known is Sign.POSITIVE else -1
        negative = self.model.samples.is_negative(x)
        condition, _possible = require(-x if negative else x, ">", _SAME)
        if condition is not None and condition not in self.conditions:
            self.conditions.append(condition)
        return -1 if negative else 1

    # -- the parameter put in -----------------------------------------------------------------
    @property
    def small(self) -> Ratio:
        """The small number; its rate is one, so that all that is made of it knows its derivative."""
        f = self.model.field
        return f.generator(Generator(Symbol("@near"), "parameter", True), f.one, key=("near",))

    @property
    def _log(self) -> Ratio:
        """log(d), which falls without bound."""
        return self.model.field.generator(Generator(Symbol("@log"), "parameter"), key=("log near",))

    @property
    def _exp(self) -> Ratio:
        """exp(u) with a u that grows without bound: it is beyond all powers of d."""
        return self.model.field.generator(Generator(Symbol("@exp"), "parameter", True), key=("exp near",))

    def _without_exponentials(self, x: Ratio) -> Tendency | None:
        """The highest powers of the exponential function decide."""
        exp = self.model.field.index(self._exp)
        if exp not in x.generators():
            return self._leading(x)
        top, below = (part.coefficients(exp) for part in (x.numerator(), x.denominator()))
        found = self._leading(top[-1] / below[-1])
        assert found is not None
        n = len(top) - len(below)
        return found if n == 0 else Tendency(found.coefficient, -math.inf if n > 0 else math.inf)

    def put(self, x: Ratio) -> Ratio:
        f, d = self.model.field, self.small**self._power
        place = 1 / d if self.value is None else self.value + self.way * d
        values: dict[int, Ratio] = {self.index: place}

        def followed(part: Ratio) -> Ratio:
            for g in sorted(part.generators()):
                if g not in values and self.index in f.generators[g].made_of:
                    values[g] = self._remade(g, followed)
            return f.substitute(part, values)

        return followed(x)

    def _remade(self, g: int, put: Callable[[Ratio], Ratio]) -> Ratio:
        f = self.model.field
        generator = f.generators[g]
        if generator.kind == "root":
            return self._root(put(f.radicand(g)))
        if g in f.arguments:
            name, inside = f.arguments[g][0], put(f.arguments[g][1])
            known = self._function(name, inside)
            if known is not None:
                return known
        elif generator.kind in ("cos", "sin"):
            angle = put(f.angles[g if generator.kind == "cos" else g - 1])
            if not self._is_regular(angle):
                raise CannotAnswer(Message("it oscillates and tends to nothing"))
        assert generator.remake is not None
        return generator.remake(put)

    def _root(self, radicand: Ratio) -> Ratio:
        f = self.model.field
        found = self._leading(radicand)
        if found is None:
            return f.zero
        if found.exponent % 2:
            raise _RootOfNothing(Message("a root of the parameter has no whole power there"))
        cancels = self._first(radicand.numerator())[1] > 0
        return f.sqrt(self._rationalised(radicand) if cancels else radicand, self._is_negative)

    def _rationalised(self, x: Ratio) -> Ratio:
        """What vanishes since a + b r does, with a root r: by (a^2 - b^2 r^2)/(a - b r), of which the powers of d come
        out of the root."""
        f, d = self.model.field, self.model.field.index(self.small)
        for g in sorted(x.generators()):
            generator, parts = f.generators[g], x.numerator().coefficients(g)
            if generator.kind != "root" or d not in generator.made_of or len(parts) != 2:
                continue
            a, b = parts
            other = self._leading(a - b * f.variable(g))
            first = self._leading(a)
            if first is not None and other is not None and other.exponent == first.exponent:
                return f.lowest_terms((a * a - b * b * f.radicand(g)) / ((a - b * f.variable(g)) * x.denominator()))
        return x

    def _is_negative(self, x: Ratio) -> bool:
        found = self._leading(x)
        return found is not None and self.sign(found.coefficient) < 0

    def _is_regular(self, x: Ratio) -> bool:
        found = self._leading(x)
        return found is None or found.exponent >= 0

    def _function(self, name: str, u: Ratio) -> Ratio | None:
        """A function of what grows, or of what vanishes where the function does not exist."""
        f, fn = self.model.field, functions(self.model.field)
        found = self._leading(u)
        if name == "log":
            if found is None:
                raise CannotAnswer(Message("it has no value there"))
            if found.exponent:
                n = int(found.exponent)
                return n * self._log + fn["log"](f.lowest_terms(u / self.small**n))
            return None
        if found is None or found.exponent >= 0:
            return None
        sign = self.sign(found.coefficient)
        if name == "atan":
            return sign * f.pi / 2 - fn["atan"](f.lowest_terms(1 / u))
        if name == "exp":
            if self._grown is not None and u not in (self._grown, -self._grown):
                raise CannotAnswer(Message("several exponential functions decide the limit"))
            self._grown = u if sign > 0 else -u
            return self._exp if sign > 0 else 1 / self._exp
        raise CannotAnswer(Message("it has no value there"))

    # -- the leading term ---------------------------------------------------------------------
    def _leading(self, x: Ratio) -> Tendency | None:
        """None for zero."""
        if x.is_zero():
            return None
        top, below = self._first(x.numerator()), self._first(x.denominator())
        f = self.model.field
        return Tendency(f.lowest_terms(top[0] / below[0]), float(top[1] - below[1]))

    def _first(self, x: Ratio) -> tuple[Ratio, int]:
        """The first coefficient of the powers of d that does not vanish, and its power."""
        f = self.model.field
        d = f.index(self.small)
        if not any(d in f.generators[g].made_of for g in x.generators()):
            parts = x.coefficients(d)
            k = next(k for k, part in enumerate(parts) if not part.is_zero())
            return parts[k], k
        for k in range(_MOST):
            at_zero = f.follow(x, {d: f.zero})
            if not at_zero.is_zero():
                return at_zero / math.factorial(k), k
            x = f.lowest_terms(f.derivative(x, d))
        raise CannotAnswer(Message("the limit was not found by the first {n} derivatives", n=_MOST))

    def _with_logs(self, found: Tendency) -> Tendency:
        """log(d) grows more slowly than any power of d: it decides only beside none."""
        f = self.model.field
        log = f.index(self._log)
        top, below = (p.coefficients(log) for p in (found.coefficient.numerator(), found.coefficient.denominator()))
        n, exponent = len(top) - len(below), found.exponent
        if n == 0 and len(top) == 1:
            return found
        coefficient = f.lowest_terms(top[-1] / below[-1]) * (-1) ** n
        small = 1e-9 * (n > 0) - 1e-9 * (n < 0)  # log(d)^n counts as a power that is less than any other
        return Tendency(coefficient, exponent - small)


class _RootOfNothing(CannotAnswer):
    """A root has no whole power of d."""


def derivative_by(model: SymbolicModel, x: Ratio, index: int) -> Ratio:
    """The derivative of an element by a parameter, in all functions that stand in it: that of x(P + d) at d = 0, sizes
    by |u|' = u u'/|u|, since u(P + d) would be of one sign."""
    f = model.field
    sizes = [g for g in sorted(x.generators()) if _is_size(f, g) and index in f.ingredients(f.radicand(g))]
    if sizes:
        g, held = sizes[0], f.generator(Generator(Symbol("@size"), "parameter", True), f.zero, key=("size", sizes[0]))
        along = f.partial(x, g) * derivative_by(model, f.radicand(g), index) / (2 * f.variable(g))
        rest = derivative_by(model, f.substitute(x, {g: held}), index)
        return f.lowest_terms(along + f.substitute(rest, {f.index(held): f.variable(g)}))
    near = Approach(model, index, f.variable(index))
    d, moved = near.small, near.put(x)
    return f.lowest_terms(f.follow(f.derivative(moved, f.index(d)), {f.index(d): f.zero}))


def _is_size(f: Field, g: int) -> bool:
    """Whether a generator is the root of a square, |u|."""
    if f.generators[g].kind != "root" or not f.generators[g].made_of:
        return False
    square = f.radicand(g)
    unit, factors = f.factor(square.num)
    return (
        square.den is None
        and rational_root(Fraction(unit)) is not None
        and all(exponent % 2 == 0 for _base, exponent in factors)
    )
