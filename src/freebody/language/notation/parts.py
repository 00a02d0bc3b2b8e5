"""What the four writers see of an expression: signed terms, a fraction, an exact decimal, a letter and its index.

    a - 2 b           is  (+, a), (-, 2 b)
    (-2/3) a b^(-1)   is  the sign -, above the bar 2 and a, below it 3 and b
    1/16              is  0.0625; 1/3 and 1/8 stay fractions

Numbers are exact throughout.
"""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Generator
from contextlib import contextmanager
from contextvars import ContextVar
from dataclasses import dataclass
from fractions import Fraction
from functools import wraps
from typing import Concatenate, ParamSpec, TypeVar

from freebody.language.expression import (
    ONE,
    Expr,
    Number,
    PowerOf,
    ProductOf,
    Symbol,
    power,
)
from freebody.language.guards import MAX_DIGITS
from freebody.language.parser import GREEK

# An underscore within words and their numbers, as in bottom_left, planet_2_axle and sun_P1.
_BETWEEN_WORDS = re.compile(r"(?<=[a-z]{2})_(?=[a-z]{2}|[A-Z]?\d)|(?<=[a-z]{2}_\d)_(?=[a-z]{2})")

MOST_HALVED = 1024  # the largest denominator of what comes of halving again and again
MOST_ZEROS = 6  # behind the point of a long decimal

# Binding strength of what stands at the top of a written expression.
SUM, MINUS, PRODUCT, POWER, ATOM = range(5)

# Greek letters by name, without those that look like Latin ones.
LETTER_OF = {name: letter for letter, name in GREEK.items() if letter not in "ΑΒΕΖΗΙΚΜΝΟΡΤΥΧοϒ"}

# Letter and index of Legendre's elliptic integrals of the first kind, K(k) and F(phi, k) with the modulus k, of
# Fresnel's, and of the branches of Lambert's function.
SPECIAL = {
    **{"elliptic_K": ("K", ""), "elliptic_F": ("F", ""), "fresnel_c": ("C", ""), "fresnel_s": ("S", "")},
    **{"lambert_W0": ("W", "0"), "lambert_Wm1": ("W", "-1")},
}


@dataclass(frozen=True, slots=True)
class Quotient:
    """A product as it is written: sign, factors above and below the bar."""

    is_negative: bool
    above: tuple[Expr, ...]
    below: tuple[Expr, ...]


def quotient(factors: tuple[Expr, ...]) -> Quotient:
    whole = [f.value for f in factors if isinstance(f, Number) and f.value.denominator == 1]
    if 1 < len(whole) == len(factors):  # a product of numbers that is left as it is: 3 times 5 bodies
        return Quotient(math.prod(whole) < 0, tuple(Number(abs(value)) for value in whole), ())
    above: list[Expr] = []
    below: list[Expr] = []
    coefficient = _gather(factors, above, below)
    size = abs(coefficient)
    if as_decimal(size) is not None:
        above.insert(0, Number(size))
    else:
        if size.numerator != 1:
            above.insert(0, Number(Fraction(size.numerator)))
        if size.denominator != 1:
            below.insert(0, Number(Fraction(size.denominator)))
    return Quotient(coefficient < 0, tuple(above) or (ONE,), tuple(below))


def _gather(factors: tuple[Expr, ...], above: list[Expr], below: list[Expr]) -> Fraction:
    """Sorts factors to above and below the bar, through nested quotients, and returns the coefficient."""
    coefficient = Fraction(1)
    for factor in factors:
        match factor:
            case Number(value):
                coefficient *= value
            case PowerOf(ProductOf(inner), Number(value)) if value == -1:
                coefficient /= _gather(inner, below, above)
            case PowerOf(base, Number(value)) if value < 0:
                below.append(power(base, Number(-value)))
            case _:
                above.append(factor)
    return coefficient


def signed_terms(terms: tuple[Expr, ...]) -> list[tuple[bool, Expr]]:
    """Each term as (is it subtracted, what is added or subtracted)."""
    return [_without_sign(term) for term in terms]


def _without_sign(term: Expr) -> tuple[bool, Expr]:
    match term:
        case Number(value) if value < 0:
            return True, Number(-value)
        case ProductOf((Number(value), *rest)) if value < 0 and rest:
            kept = (*(() if value == -1 else (Number(-value),)), *rest)
            return True, kept[0] if len(kept) == 1 else ProductOf(kept)
        case _:
            return False, term


def in_degrees(argument: Expr) -> str | None:
    """The degrees, as on paper, of the angle that sin, cos or tan is taken of, where it is a number: pi/9 is 20."""
    factors = argument.factors if isinstance(argument, ProductOf) else ()
    numbers = [f.value for f in factors if isinstance(f, Number)]
    if len(factors) != len(numbers) + 1 or Symbol("pi") not in factors:
        return None
    value = 180 * math.prod(numbers, start=Fraction(1))
    if value <= 0 or 10 % value.denominator:
        return None
    return f"{float(value):.10g}"


def as_decimal(value: Fraction) -> str | None:
    """The decimal of a positive number whose denominator is over 10 and divides a power of ten. Of sixteenths and the
    like only people who halve make some: they stay fractions."""
    is_halved = value.denominator & (value.denominator - 1) == 0 and value.denominator <= MOST_HALVED
    if (value.denominator <= 10 or is_halved) and len(str(value.numerator)) <= MAX_DIGITS:
        return None
    places = _decimal_places(value.denominator)
    if places is None:
        return None
    digits = str(value.numerator * 10**places // value.denominator)
    stripped = digits.rstrip("0")
    if len(stripped) > MAX_DIGITS:
        return None
    is_short = places <= 15 and len(digits) <= 20
    if places == 0 or not (is_short or places - len(digits) <= MOST_ZEROS):
        return f"{stripped}e{len(digits) - len(stripped) - places}"
    digits = digits.rjust(places + 1, "0")
    return f"{digits[:-places]}.{digits[-places:]}"


_SIGN: ContextVar[str] = ContextVar("sign", default=".")


@contextmanager
def decimals_with(sign: str) -> Generator[None]:
    """Formulas for people are written with this sign of decimals meanwhile; those for programs have a point."""
    before = _SIGN.set(sign)
    try:
        yield
    finally:
        _SIGN.reset(before)


P = ParamSpec("P")
First = TypeVar("First")
Result = TypeVar("Result")
Written = Callable[Concatenate[First, P], Result]


def in_decimals_of(sign: Callable[[First], str]) -> Callable[[Written[First, P, Result]], Written[First, P, Result]]:
    """For a function that writes formulas: decimals have the sign that its first argument asks for."""

    def decorated(write: Written[First, P, Result]) -> Written[First, P, Result]:
        @wraps(write)
        def writes(first: First, *args: P.args, **more: P.kwargs) -> Result:
            with decimals_with(sign(first)):
                return write(first, *args, **more)

        return writes

    return decorated


def sign_of_decimals() -> str:
    """As it is meanwhile."""
    return _SIGN.get()


def with_sign(decimal: str, *, comma: str = ",") -> str:
    """A decimal with the sign that is wanted. comma: how a format writes one."""
    return decimal if _SIGN.get() == "." else decimal.replace(".", comma)


def _decimal_places(denominator: int) -> int | None:
    twos = (denominator & -denominator).bit_length() - 1
    fives, rest = 0, denominator >> twos
    while rest % 5 == 0:
        rest //= 5
        fives += 1
    return max(twos, fives) if rest == 1 else None


def is_whole(expr: Expr) -> bool:
    return isinstance(expr, Number) and expr.value.denominator == 1


def spaced_index(index: str) -> str:
    """An index as it is set: words follow each other with a space, all else with a comma: bottom_left_x -> bottom
    left,x; sun_P1 -> sun P1."""
    return _BETWEEN_WORDS.sub(" ", index).replace("_", ",")


_CAPITALS = re.compile(rf"({'|'.join(sorted(LETTER_OF, key=len, reverse=True))}|[a-z])([A-Z]{{1,2}})(?![A-Za-z])(.*)")


def as_on_paper(name: str) -> str:
    """A name as it is printed: capitals behind a small or Greek letter are its index, m_R for mR, omega_S for omegaS.
    Where the first letter is a capital as well a product may be meant, as by EI."""
    found = _CAPITALS.fullmatch(name)
    return name if found is None else f"{found[1]}_{found[2]}{found[3]}"


def split_name(name: str) -> tuple[str, str]:
    letters = re.match("[A-Za-z]*", name)
    n_letters = letters.end() if letters else 0
    return name[:n_letters], name[n_letters:]
