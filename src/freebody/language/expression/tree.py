"""The nodes of an expression tree, and how they are put together.

    a/b  is  Product((a, Power(b, Number(-1))))        -a  is  Product((Number(-1), a))
    pi   is  Symbol("pi")                              0.1 is  Number(1/10), exactly

Trees are built by `add`, `multiply`, `power` or by Python operators, which flatten, fold numbers and
drop zeros and ones, and nothing more: they never expand, collect or reorder.
"""

from __future__ import annotations

import keyword
import math
import re
from collections.abc import Callable, Iterable
from dataclasses import dataclass, replace
from fractions import Fraction
from typing import TypeAlias, cast

from freebody.errors import ExpressionError
from freebody.language.decimals import written_number
from freebody.messages import Message

ELEMENTARY = ("sqrt", "sin", "cos", "tan", "asin", "acos", "atan", "exp", "log", "sinh", "cosh", "tanh")
FRESNEL = ("fresnel_c", "fresnel_s")  # int_0^x cos(pi t^2/2) dt, and of the sine
ELLIPTIC = ("elliptic_K", "elliptic_F")  # of a modulus k; of an angle and a modulus
LAMBERT = ("lambert_W0", "lambert_Wm1")  # w with w e^w = x, on the real branches 0 and -1
FUNCTIONS = frozenset({*ELEMENTARY, *FRESNEL, *ELLIPTIC, *LAMBERT, "abs", "sign", "rate"})

# A number raised to a larger constant exponent stays a Power: 9^(9^9) is never computed.
MAX_EXPONENT = 64

_NAME = re.compile(r"[A-Za-z][A-Za-z0-9_]*")


class _Operators:
    """Python arithmetic on trees: `a + 2*b` builds a tree."""

    __slots__ = ()

    def __add__(self, other: Operand) -> Expr:
        return add(_tree(self), _tree(other))

    def __radd__(self, other: Operand) -> Expr:
        return add(_tree(other), _tree(self))

    def __sub__(self, other: Operand) -> Expr:
        return add(_tree(self), negate(_tree(other)))

    def __rsub__(self, other: Operand) -> Expr:
        return add(_tree(other), negate(_tree(self)))

    def __mul__(self, other: Operand) -> Expr:
        return multiply(_tree(self), _tree(other))

    def __rmul__(self, other: Operand) -> Expr:
        return multiply(_tree(other), _tree(self))

    def __truediv__(self, other: Operand) -> Expr:
        return divide(_tree(self), _tree(other))

    def __rtruediv__(self, other: Operand) -> Expr:
        return divide(_tree(other), _tree(self))

    def __pow__(self, other: Operand) -> Expr:
        return power(_tree(self), _tree(other))

    def __rpow__(self, other: Operand) -> Expr:
        return power(_tree(other), _tree(self))

    def __neg__(self) -> Expr:
        return negate(_tree(self))

    def __pos__(self) -> Expr:
        return _tree(self)


@dataclass(frozen=True, slots=True)
class Number(_Operators):
    """An exact rational number."""

    value: Fraction

    def __hash__(self) -> int:  # a fraction is hashed like the float that it may equal, which takes long
        return hash((self.value.numerator, self.value.denominator))


@dataclass(frozen=True, slots=True)
class Symbol(_Operators):
    """A named quantity; `pi` is reserved for the constant."""

    name: str


@dataclass(frozen=True, slots=True)
class VectorSymbol(Symbol):
    """A named vector. It stands as a factor of one power in each term of a sum, so that a formula with vectors is one
    formula for each component."""


@dataclass(frozen=True, slots=True)
class Sum(_Operators):
    """terms[0] + terms[1] + ..."""

    terms: tuple[Expr, ...]


@dataclass(frozen=True, slots=True)
class ProductOf(_Operators):
    """factors[0] * factors[1] * ..."""

    factors: tuple[Expr, ...]


@dataclass(frozen=True, slots=True)
class PowerOf(_Operators):
    """base ** exponent"""

    base: Expr
    exponent: Expr


@dataclass(frozen=True, slots=True)
class Call(_Operators):
    """function(argument), with a function of FUNCTIONS; elliptic_F(argument, modulus)."""

    function: str
    argument: Expr
    modulus: Expr | None = None

    def of(self, change: Callable[[Expr], Expr]) -> Call:
        """The same function of changed arguments."""
        return Call(self.function, change(self.argument), None if self.modulus is None else change(self.modulus))


@dataclass(frozen=True, slots=True)
class GivenCall(Call):
    """A function that is given in numbers, as a curve through points: formulas keep its name, numbers take its form.

    forms: of the function and of its derivatives, in `PLACE`; those beyond are zero. place: what `PLACE` is there of
    the argument, which also is `PLACE` in it. dimension: of its values."""

    forms: tuple[Expr, ...] = ()
    place: Expr = Symbol("@place")
    dimension: object = None

    def of(self, change: Callable[[Expr], Expr]) -> GivenCall:
        """The same function of a changed argument."""
        return replace(self, argument=change(self.argument))

    def derivative(self) -> GivenCall | None:
        """Its derivative by the argument; None where that is zero."""
        rest = self.forms[1:]
        return replace(self, function=f"{self.function}'", forms=rest) if rest else None


Expr: TypeAlias = Number | Symbol | Sum | ProductOf | PowerOf | Call
Operand: TypeAlias = Expr | int | float | Fraction

ZERO = Number(Fraction(0))
ONE = Number(Fraction(1))
MINUS_ONE = Number(Fraction(-1))
PLACE = Symbol("@place")  # in the forms of a given function: where it is looked at
PI = Symbol("pi")


def number(value: int | float | Fraction) -> Number:
    """An exact number; a float counts as the decimal it prints as, so 0.1 is 1/10."""
    if isinstance(value, float):
        if not math.isfinite(value):
            raise ExpressionError(Message("{value} is not a number that can be calculated with", value=value))
        return Number(written_number(repr(float(value))))
    return Number(Fraction(value))


def symbol(name: str) -> Symbol:
    """A symbol. Raises ExpressionError when `name_problem` finds fault with the name."""
    if problem := name_problem(name):
        raise ExpressionError(problem)
    return Symbol(name)


def name_problem(name: str) -> Message | None:
    """What is wrong with a name for a symbol, or None."""
    if not _NAME.fullmatch(name):
        return Message(
            "'{name}' is not a name: names have letters a-z or Greek ones, digits and underscores, and begin with a "
            "letter",
            name=name[:40],
        )
    if "__" in name:
        return Message("'{name}' is not a name: names have no double underscore", name=name[:40])
    if name == "lambda":
        return Message("'lambda' cannot be a name: write lam")
    if keyword.iskeyword(name):
        return Message(
            "'{name}' is a word of the Python language and cannot be a name: write {other}, say",
            name=name,
            other=f"{name}_1",
        )
    if name in FUNCTIONS:
        return Message("'{name}' is a function and cannot be a name: write {other}, say", name=name, other=f"{name}_1")
    if name.lower() in ("nan", "inf", "infinity"):
        return Message("'{name}' is not a number that can be calculated with", name=name)
    return None


def add(*terms: Expr) -> Expr:
    """The sum; numbers are folded into the place of the first."""
    kept: list[Expr] = []
    place, constant = None, Fraction(0)
    for term in _flatten(terms, Sum):
        if isinstance(term, Number):
            place = len(kept) if place is None else place
            constant += term.value
        else:
            kept.append(term)
    if constant and place is not None:
        kept.insert(place, Number(constant))
    if not kept:
        return ZERO
    return kept[0] if len(kept) == 1 else Sum(tuple(kept))


def multiply(*factors: Expr) -> Expr:
    """The product; numbers are folded into one coefficient in front."""
    kept: list[Expr] = []
    coefficient = Fraction(1)
    for factor in _flatten(factors, ProductOf):
        if isinstance(factor, Number):
            coefficient *= factor.value
        else:
            kept.append(factor)
    if not coefficient:
        return ZERO
    if coefficient != 1 or not kept:
        kept.insert(0, Number(coefficient))
    return kept[0] if len(kept) == 1 else ProductOf(tuple(kept))


def power(base: Expr, exponent: Expr) -> Expr:
    """The power; exponent 1/2 becomes sqrt. Raises ZeroDivisionError for a negative power of the number 0."""
    if not isinstance(exponent, Number):
        return ONE if base == ONE else PowerOf(base, exponent)
    n = exponent.value
    if n == 1:
        return base
    if n == 0 or base == ONE:
        return ONE
    if n == Fraction(1, 2):
        return Call("sqrt", base)
    if base == ZERO:
        if n < 0:
            raise ZeroDivisionError("division by zero")
        return ZERO
    if n.denominator != 1 or abs(n) > MAX_EXPONENT:
        return PowerOf(base, exponent)
    if isinstance(base, Number):
        return Number(base.value**n.numerator)
    # (x^m)^n = x^(m n) holds for whole m and n, whatever the sign of x.
    inner = whole_exponent(base) if isinstance(base, PowerOf) else None
    if isinstance(base, PowerOf) and inner is not None and abs(inner * n) <= MAX_EXPONENT:
        return power(base.base, Number(inner * n))
    return PowerOf(base, exponent)


def negate(expr: Expr) -> Expr:
    """-expr"""
    return multiply(MINUS_ONE, expr)


def divide(numerator: Expr, denominator: Expr) -> Expr:
    """numerator / denominator. Raises ZeroDivisionError when the denominator is the number 0."""
    return multiply(numerator, power(denominator, MINUS_ONE))


def whole_exponent(expr: PowerOf) -> int | None:
    """The exponent when it is an integer number, else None."""
    exponent = expr.exponent
    if isinstance(exponent, Number) and exponent.value.denominator == 1:
        return exponent.value.numerator
    return None


def children(expr: Expr) -> tuple[Expr, ...]:
    """The direct parts of an expression, in order."""
    match expr:
        case Number() | Symbol():
            return ()
        case Sum(terms):
            return terms
        case ProductOf(factors):
            return factors
        case PowerOf(base, exponent):
            return (base, exponent)
        case Call(_, argument, modulus):
            return (argument,) if modulus is None else (argument, modulus)


def _tree(operand: object) -> Expr:
    if isinstance(operand, _Operators):
        return cast(Expr, operand)
    if isinstance(operand, int | float | Fraction):
        return number(operand)
    raise TypeError(f"an expression or a number is needed here, not {type(operand).__name__}")


def _flatten(parts: Iterable[Expr], kind: type[Sum] | type[ProductOf]) -> Iterable[Expr]:
    for part in parts:
        if isinstance(part, kind):
            yield from part.terms if isinstance(part, Sum) else part.factors
        else:
            yield part
