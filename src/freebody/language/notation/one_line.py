"""Expressions on one line: for Python and `parse`, and for reading.

Every text carries how strongly its top operation binds, so that a bracket stands only where one is needed.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import dataclass, replace
from fractions import Fraction

from freebody.language.expression import (
    MINUS_ONE,
    Call,
    Expr,
    Number,
    PowerOf,
    ProductOf,
    Sum,
    Symbol,
    VectorSymbol,
    children,
)
from freebody.language.notation.parts import (
    ATOM,
    LETTER_OF,
    MINUS,
    POWER,
    PRODUCT,
    SPECIAL,
    SUM,
    as_decimal,
    as_on_paper,
    in_degrees,
    is_whole,
    quotient,
    signed_terms,
    split_name,
    with_sign,
)

_SUBSCRIPT = str.maketrans("-0123456789", "₋₀₁₂₃₄₅₆₇₈₉")
_SUPERSCRIPT = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")


@dataclass(frozen=True, slots=True)
class OneLineWriter:
    """A writer on one line; `write` returns the text and how strongly its top operation binds."""

    times: str
    name: Callable[[str], str]
    call: Callable[[Call, str], str]
    power: Callable[[str, Expr, str], str]
    vector: Callable[[str], str] | None = None  # else by its name
    decimal: Callable[[str], str] | None = None  # else with a point

    def write(self, expr: Expr) -> tuple[str, int]:
        match expr:
            case Number(value):
                return self._number(value)
            case VectorSymbol(name) if self.vector is not None:
                return self.vector(name), ATOM
            case Symbol(name):
                return self.name(name), ATOM
            case Sum(terms):
                return self._sum(terms)
            case PowerOf(base, Number(value)) if value >= 0 or base == MINUS_ONE:
                return self._power(base, expr.exponent)
            case PowerOf(_, Number()):
                return self._product((expr,))
            case PowerOf(base, exponent):
                return self._power(base, exponent)
            case ProductOf(factors):
                return self._product(factors)
            case Call():
                return self.call(expr, ", ".join(self.write(x)[0] for x in children(expr))), ATOM

    def at_least(self, strength: int, expr: Expr) -> str:
        text, own = self.write(expr)
        return text if own >= strength else f"({text})"

    def _number(self, value: Fraction) -> tuple[str, int]:
        size = abs(value)
        decimal = as_decimal(size)
        text = (self.decimal(decimal) if self.decimal else decimal) if decimal else str(size)
        strength = ATOM if decimal or size.denominator == 1 else PRODUCT
        return (f"-{text}", MINUS) if value < 0 else (text, strength)

    def _sum(self, terms: tuple[Expr, ...]) -> tuple[str, int]:
        text = ""
        for is_subtracted, term in signed_terms(terms):
            sign = (" - " if text else "-") if is_subtracted else (" + " if text else "")
            text += sign + self.at_least(PRODUCT, term)
        return text, SUM

    def _product(self, factors: tuple[Expr, ...]) -> tuple[str, int]:
        parts = quotient(factors)
        sign = "-" if parts.is_negative else ""
        # The first factor above may be any product; a quotient further on is grouped.
        text = sign + self.times.join(self.at_least(POWER, factor) for factor in parts.above)
        if len(parts.below) == 1:
            text += "/" + self.at_least(POWER, parts.below[0])
        elif parts.below:
            text += "/(" + self.times.join(self.at_least(POWER, factor) for factor in parts.below) + ")"
        return text, MINUS if sign else PRODUCT

    def _power(self, base: Expr, exponent: Expr) -> tuple[str, int]:
        return self.power(self.at_least(ATOM, base), exponent, self.at_least(ATOM, exponent)), POWER


def _python_power(base: str, exponent: Expr, written: str) -> str:
    return f"{base}**{written}"


def _text_power(base: str, exponent: Expr, written: str) -> str:
    if isinstance(exponent, Number) and is_whole(exponent):
        return base + str(exponent.value).translate(_SUPERSCRIPT)
    return f"{base}^{written}"


def _python_call(call: Call, argument: str) -> str:
    """lift''(x), the second derivative of what is given in numbers, is lift_dd(x)."""
    if call.function.endswith("'"):
        name = call.function.rstrip("'")
        return f"{name}_{'d' * (len(call.function) - len(name))}({argument})"
    return f"{call.function}({argument})"


TEXT_CALLS = {"sqrt": "√", **{name: letter + index.translate(_SUBSCRIPT) for name, (letter, index) in SPECIAL.items()}}


def _text_call(call: Call, argument: str) -> str:
    if call.function == "rate":
        return argument + "'"
    if call.function == "abs":
        return f"|{argument}|"
    return f"{TEXT_CALLS.get(call.function, call.function)}({argument})"


def _call_in_figure(call: Call, argument: str) -> str:
    """Numbers of angles in degrees, as on paper."""
    degrees = in_degrees(call.argument) if call.function in ("sin", "cos", "tan") else None
    return _text_call(call, argument if degrees is None else f"{with_sign(degrees)}°")


def _name_in_figure(name: str) -> str:
    return _text_name(as_on_paper(name))


def _text_name(name: str) -> str:
    """Greek letters, and digits at the end as an index: theta1 -> θ₁, r_S -> r_S."""
    letters, rest = split_name(name)
    stem, index = _split_index(rest)
    return LETTER_OF.get(letters, letters) + stem + index.translate(_SUBSCRIPT)


def _text_vector(name: str) -> str:
    """The letter in bold italics, as vectors are printed."""
    letters, rest = split_name(name)
    stem, index = _split_index(rest)
    return "".join(map(_bold, LETTER_OF.get(letters, letters))) + stem + index.translate(_SUBSCRIPT)


def _bold(letter: str) -> str:
    for first, last, bold in (("a", "z", "𝒂"), ("A", "Z", "𝑨"), ("α", "ω", "𝜶")):
        if first <= letter <= last:
            return chr(ord(bold) + ord(letter) - ord(first))
    return letter


def _split_index(rest: str) -> tuple[str, str]:
    found = re.fullmatch(r"(.*?)([0-9]*)", rest)
    stem, index = (found[1], found[2]) if found else (rest, "")
    return (rest, "") if stem.endswith("_") else (stem, index)


PYTHON = OneLineWriter("*", str, _python_call, _python_power)
TEXT = OneLineWriter("·", _text_name, _text_call, _text_power, _text_vector, with_sign)
IN_FIGURES = replace(TEXT, name=_name_in_figure, call=_call_in_figure)  # for the eye alone
