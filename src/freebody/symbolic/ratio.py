"""An element of the field: a quotient of two polynomials, in the one form in which its field writes it."""

from __future__ import annotations

from fractions import Fraction
from typing import TYPE_CHECKING, Any

from freebody.errors import CannotAnswer
from freebody.language.sentences import Message
from freebody.symbolic.polynomials import Poly, Terms

if TYPE_CHECKING:
    from freebody.symbolic.field import Field

MAX_POWER = 64

_ONE: Terms = {(): 1}
_KEPT_TERMS = 200  # of an element [terms]; those of longer ones would fill the memory


class DivisorVanishes(ZeroDivisionError):
    """A divisor of a formula is zero in the state that is put in."""

    def __init__(self, divisor: Ratio) -> None:
        super().__init__("division by an expression that is zero in the state that is put in")
        self.divisor = divisor


class Ratio:
    """An element of the field: `num / den`, coprime, the leading coefficient of `den` positive."""

    __slots__ = ("_generators", "_terms", "den", "field", "num")

    def __init__(self, field: Field, num: Poly, den: Poly | None) -> None:
        self.field = field
        self.num = num
        self.den = den  # None means 1
        self._generators: frozenset[int] | None = None
        self._terms: tuple[Terms, Terms] | None = None

    # -- arithmetic ---------------------------------------------------------------------------
    def __add__(self, other: Ratio | int) -> Ratio:
        b = self.field.element(other)
        if self.is_zero():
            return b
        if b.is_zero():
            return self
        an, bn = self.field.lift(self, b)
        if self.den is None and b.den is None:
            return Ratio(self.field, an + bn, None)
        ad, bd = self.field.denominators(self, b)
        if ad == bd:
            return self.field.quotient(an + bn, ad)
        product = self.field.product
        return self.field.quotient(product(an, bd) + product(bn, ad), product(ad, bd))

    __radd__ = __add__

    def __neg__(self) -> Ratio:
        return Ratio(self.field, -self.num, self.den)

    def __sub__(self, other: Ratio | int) -> Ratio:
        return self + (-self.field.element(other))

    def __rsub__(self, other: int) -> Ratio:
        return (-self) + other

    def __mul__(self, other: Ratio | int) -> Ratio:
        b = self.field.element(other)
        if self.is_zero() or b.is_one():
            return self
        if b.is_zero() or self.is_one():
            return b
        an, bn = self.field.lift(self, b)
        if self.den is None and b.den is None:
            return Ratio(self.field, self.field.reduce(self.field.product(an, bn)), None)
        ad, bd = self.field.denominators(self, b)
        return self.field.quotient(self.field.product(an, bn), self.field.product(ad, bd))

    __rmul__ = __mul__

    def __truediv__(self, other: Ratio | int) -> Ratio:
        b = self.field.element(other)
        if b.is_zero():
            raise ZeroDivisionError("division by an expression that is zero")
        an, bn = self.field.lift(self, b)
        ad, bd = self.field.denominators(self, b)
        return self.field.quotient(self.field.product(an, bd), self.field.product(ad, bn))

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
    @property
    def n_terms(self) -> int:
        """Of the numerator, and of the denominator where there is one."""
        return len(self.num) + (0 if self.den is None else len(self.den))

    def is_zero(self) -> bool:
        return bool(self.num.is_zero())

    def is_one(self) -> bool:
        return self.den is None and bool(self.num.is_one())

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
        top, below = self.terms()
        return tuple(sorted(top.items())), () if self.den is None else tuple(sorted(below.items()))

    def terms(self) -> tuple[Terms, Terms]:
        """Those of the numerator and of the denominator. They are asked for at every point where the element is
        evaluated, so short ones are kept, and those of the long one that was asked last."""
        if self._terms is not None:
            return self._terms
        if self.field.last_long is not None and self.field.last_long[0] is self:
            return self.field.last_long[1]
        found = self.field.terms(self.num), _ONE if self.den is None else self.field.terms(self.den)
        if len(found[0]) + len(found[1]) <= _KEPT_TERMS:
            self._terms = found
        else:
            self.field.last_long = self, found
        return found

    def coefficients(self, generator: int) -> list[Ratio]:
        """c_0, c_1, ... with self = sum c_k g^k; the denominator must be free of g."""
        parts = self.field.split(self.num, generator)
        if self.den is not None and generator in self.field.used(self.den):
            raise CannotAnswer(Message("{x} stands in a denominator", x=self.field.generators[generator].display))
        return [self.field.quotient(p, self.den) for p in parts]

    def __repr__(self) -> str:
        return str(self.field.expression(self))
