"""Limits on numbers in what users type: every one is checked before the work that it bounds."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction

from freebody.errors import ExpressionError
from freebody.language.decimals import written_number
from freebody.language.expression import (
    MAX_EXPONENT,
    Expr,
    Number,
    PowerOf,
    ProductOf,
    Sum,
    power,
    whole_exponent,
)
from freebody.language.sentences import Message

MAX_DIGITS = 30
MAX_DECIMAL_EXPONENT = 300
_MAX_BITS = 10_000  # of all numbers that fold into one


def refuse_huge(parts: Sequence[Expr], column: int) -> None:
    """Raises where numbers would fold into one with too many digits: the bits of a product, and of a sum over its
    common denominator, are at most those of its parts."""
    if sum(map(_bits, parts)) > _MAX_BITS:
        raise ExpressionError(Message("the numbers here make one with too many digits"), column)


def checked_power(base: Expr, exponent: Expr, column: int) -> Expr:
    """A power whose number, if it is one, can be computed."""
    if isinstance(exponent, Number):
        size = abs(exponent.value)
        if isinstance(base, PowerOf) and (inner := whole_exponent(base)) is not None:
            size *= abs(inner)
        if size > MAX_EXPONENT:
            raise exponent_too_large(column)
        if isinstance(base, Number) and size * _bits(base) > _MAX_BITS:
            raise ExpressionError(Message("this power has too many digits"), column)
    try:
        return power(base, exponent)
    except ZeroDivisionError:
        raise ExpressionError(Message("division by zero"), column) from None


def exponent_too_large(column: int) -> ExpressionError:
    """What is said of an exponent beyond the limit."""
    return ExpressionError(Message("an exponent may be at most {most} in magnitude", most=MAX_EXPONENT), column)


def _bits(expr: Expr) -> int:
    match expr:
        case Number(value):
            return value.numerator.bit_length() + value.denominator.bit_length()
        case Sum(parts) | ProductOf(parts):
            return sum(_bits(part) for part in parts if isinstance(part, Number))
        case _:
            return 0


def exact_number(text: str, column: int) -> Fraction:
    """The value of a number as it is typed."""
    mantissa, _, exponent = text.lower().partition("e")
    if len(mantissa.replace(".", "")) > MAX_DIGITS:
        raise ExpressionError(Message("a number may have at most {most} digits", most=MAX_DIGITS), column)
    if len(exponent) > 6 or abs(int(exponent or 0)) > MAX_DECIMAL_EXPONENT:
        limit = Message("the exponent of ten is at most {most}", most=MAX_DECIMAL_EXPONENT)
        raise ExpressionError(Message("{text} is too large or too small: {limit}", text=text[:40], limit=limit), column)
    return written_number(text)
