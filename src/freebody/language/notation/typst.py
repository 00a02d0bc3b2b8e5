"""Expressions in Typst mathematics: frac(a, b), Greek letters, indices, dot(x) for a rate.

What is longer than one letter stands in quotes, which sets it upright and keeps Typst from taking it for one of its
own names. As on one line, every text carries how strongly its top operation binds.
"""

from __future__ import annotations

from freebody.language.expression import Call, Expr, Number, PowerOf, ProductOf, Sum, Symbol, children
from freebody.language.notation.parts import (
    ATOM,
    LETTER_OF,
    LETTER_OF_INTEGRAL,
    MINUS,
    POWER,
    PRODUCT,
    SUM,
    as_decimal,
    is_whole,
    quotient,
    signed_terms,
    split_name,
)

_OPERATORS = {
    **{name: name for name in ("sin", "cos", "tan", "log", "sinh", "cosh", "tanh")},
    **{"asin": "arcsin", "acos": "arccos", "atan": "arctan", "sign": 'op("sign")'},
}
_DOTS = ("", "dot", "dot.double", "dot.triple", "dot.quad")


def typst(expr: Expr, is_followed: bool = False) -> tuple[str, int]:
    """The text and its strength; before another factor (`is_followed`) sin x is written sin(x)."""
    match expr:
        case Number(value):
            decimal = as_decimal(abs(value)) or (str(abs(value)) if is_whole(expr) else None)
            return _fraction((expr,)) if decimal is None else _decimal(decimal, value < 0)
        case Symbol():
            return _name(expr)
        case Sum(terms):
            text = ""
            for is_subtracted, term in signed_terms(terms):
                sign = (" - " if text else "-") if is_subtracted else (" + " if text else "")
                text += sign + _at_least(PRODUCT, term)
            return text, SUM
        case ProductOf(factors):
            return _fraction(factors)
        case PowerOf(_, Number(value)) if value < 0:
            return _fraction((expr,))
        case PowerOf(Call("sin" | "cos" | "tan" | "sinh" | "cosh" | "tanh" as function, argument), exponent) if (
            is_whole(exponent)
        ):
            operator = f"{_OPERATORS[function]}^({typst(exponent)[0]})"
            return operator + _argument(argument, is_followed), PRODUCT
        case PowerOf(base, exponent):
            return f"{_at_least(ATOM, base)}^({typst(exponent)[0]})", POWER
        case Call("sqrt", argument):
            return f"sqrt({typst(argument)[0]})", POWER
        case Call("abs", argument):
            return f"abs({typst(argument)[0]})", ATOM
        case Call("rate"):
            return _name(expr)
        case Call("exp", argument):
            return f"e^({typst(argument)[0]})", POWER
        case Call(function) if function in LETTER_OF_INTEGRAL:
            return f"{LETTER_OF_INTEGRAL[function]}({', '.join(typst(x)[0] for x in children(expr))})", ATOM
        case Call(function, argument):
            return _OPERATORS[function] + _argument(argument, is_followed), PRODUCT


def _at_least(strength: int, expr: Expr, is_followed: bool = False) -> str:
    text, own = typst(expr, is_followed)
    return text if own >= strength else f"({text})"


def _decimal(decimal: str, is_negative: bool) -> tuple[str, int]:
    mantissa, _, exponent = decimal.partition("e")
    text = f"{mantissa} ⋅ 10^({exponent})".removeprefix("1 ⋅ ") if exponent else mantissa
    return ("-" + text, MINUS) if is_negative else (text, PRODUCT if exponent else ATOM)


def _argument(argument: Expr, is_followed: bool) -> str:
    text = typst(argument)[0]
    return f" {text}" if isinstance(argument, Symbol) and not is_followed else f" ({text})"


def _fraction(factors: tuple[Expr, ...]) -> tuple[str, int]:
    parts = quotient(factors)
    sign = "-" if parts.is_negative else ""
    text = _row(parts.above)
    if sign and not parts.below and len(parts.above) == 1:
        text = _at_least(PRODUCT, parts.above[0])
    if parts.below:
        text = f"frac({text}, {_row(parts.below)})"
    elif len(factors) == 1 and not sign:
        return text, ATOM
    return sign + text, MINUS if sign else PRODUCT


def _row(factors: tuple[Expr, ...]) -> str:
    if len(factors) == 1:
        return typst(factors[0])[0]
    text = ""
    for i, factor in enumerate(factors):
        written = _at_least(PRODUCT, factor, is_followed=i < len(factors) - 1)
        joint = " ⋅ " if text and written[0].isdigit() else " " if text else ""
        text += joint + written
    return text


def _name(expr: Expr) -> tuple[str, int]:
    """A symbol with the dots of its rates and its index: theta1' -> dot(θ)_1; the strength that it binds with."""
    n_dots = 0
    while isinstance(expr, Call):
        expr, n_dots = expr.argument, n_dots + 1
    letters, rest = split_name(expr.name if isinstance(expr, Symbol) else "?")
    letter = LETTER_OF.get(letters, letters if len(letters) == 1 else f'"{letters}"')
    if letters in LETTER_OF and letters[0].isupper():
        letter = f"upright({letter})"
    index = rest.removeprefix("_").replace("_", ",")
    written = "" if not index else f"_({index})" if index.isdigit() or len(index) == 1 else f'_"{index}"'
    if n_dots >= len(_DOTS):
        return f"{letter}^(({n_dots})){written}", POWER
    return (f"{_DOTS[n_dots]}({letter})" if n_dots else letter) + written, ATOM
