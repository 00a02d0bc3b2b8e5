r"""Expressions in LaTeX mathematics: fractions with \frac, Greek letters, indices, a dot for a rate.

As on one line, every text carries how strongly its top operation binds; what stands in braces needs no bracket.
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
    **{name: rf"\{name}" for name in ("sin", "cos", "tan", "log", "sinh", "cosh", "tanh")},
    **{"asin": r"\arcsin", "acos": r"\arccos", "atan": r"\arctan", "sign": r"\operatorname{sign}"},
}
_DOTS = ("", r"\dot", r"\ddot", r"\dddot", r"\ddddot")


def latex(expr: Expr, is_followed: bool = False) -> tuple[str, int]:
    """The text and its strength; before another factor (`is_followed`) sin x is written sin(x)."""
    match expr:
        case Number(value):
            decimal = as_decimal(abs(value)) or (str(abs(value)) if is_whole(expr) else None)
            return _fraction((expr,)) if decimal is None else _decimal(decimal, value < 0)
        case Symbol(name):
            return _name(name), ATOM
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
            operator = f"{_OPERATORS[function]}^{{{latex(exponent)[0]}}}"
            return operator + _argument(argument, is_followed), PRODUCT
        case PowerOf(base, exponent):
            return f"{_at_least(ATOM, base)}^{{{latex(exponent)[0]}}}", POWER
        case Call("sqrt", argument):
            return rf"\sqrt{{{latex(argument)[0]}}}", POWER
        case Call("abs", argument):
            return rf"\left|{latex(argument)[0]}\right|", ATOM
        case Call("rate"):
            name, n_dots = _rate_of(expr)
            letter, index = _name_parts(name)
            if n_dots >= len(_DOTS):
                return f"{letter}^{{({n_dots})}}{index}", POWER
            return f"{_DOTS[n_dots]}{{{letter}}}{index}", ATOM
        case Call("exp", argument):
            return f"e^{{{latex(argument)[0]}}}", POWER
        case Call(function) if function in LETTER_OF_INTEGRAL:
            arguments = ", ".join(latex(x)[0] for x in children(expr))
            return rf"{LETTER_OF_INTEGRAL[function]}\!\left({arguments}\right)", ATOM
        case Call(function, argument):
            return _OPERATORS[function] + _argument(argument, is_followed), PRODUCT


def _at_least(strength: int, expr: Expr, is_followed: bool = False) -> str:
    text, own = latex(expr, is_followed)
    return text if own >= strength else rf"\left({text}\right)"


def _decimal(decimal: str, is_negative: bool) -> tuple[str, int]:
    mantissa, _, exponent = decimal.partition("e")
    text = rf"{mantissa} \cdot 10^{{{exponent}}}".removeprefix(r"1 \cdot ") if exponent else mantissa
    return ("-" + text, MINUS) if is_negative else (text, PRODUCT if exponent else ATOM)


def _argument(argument: Expr, is_followed: bool) -> str:
    text = latex(argument)[0]
    return f" {text}" if isinstance(argument, Symbol) and not is_followed else rf"\left({text}\right)"


def _fraction(factors: tuple[Expr, ...]) -> tuple[str, int]:
    parts = quotient(factors)
    sign = "-" if parts.is_negative else ""
    text = _row(parts.above)
    if sign and not parts.below and len(parts.above) == 1:
        text = _at_least(PRODUCT, parts.above[0])
    if parts.below:
        text = rf"\frac{{{text}}}{{{_row(parts.below)}}}"
    elif len(factors) == 1 and not sign:
        return text, ATOM
    return sign + text, MINUS if sign else PRODUCT


def _row(factors: tuple[Expr, ...]) -> str:
    if len(factors) == 1:
        return latex(factors[0])[0]
    text = ""
    for i, factor in enumerate(factors):
        written = _at_least(PRODUCT, factor, is_followed=i < len(factors) - 1)
        joint = r" \cdot " if text and written[0].isdigit() else " " if text else ""
        text += joint + written
    return text


def _name(name: str) -> str:
    return "".join(_name_parts(name))


def _name_parts(name: str) -> tuple[str, str]:
    """The letter, which carries the dots of a rate, and its index: theta1 -> \\theta, _{1}."""
    letters, rest = split_name(name)
    if letters in LETTER_OF:
        letter = r"\lambda" if letters == "lam" else rf"\{letters}"
    else:
        letter = letters if len(letters) == 1 else rf"\mathrm{{{letters}}}"
    index = rest.removeprefix("_").replace("_", ",")
    if not index:
        return letter, ""
    is_plain = index.isdigit() or len(index) == 1
    return letter, f"_{{{index}}}" if is_plain else rf"_{{\mathrm{{{index}}}}}"


def _rate_of(expr: Expr) -> tuple[str, int]:
    """The measure and the number of dots over it."""
    n_dots = 0
    while isinstance(expr, Call):
        expr, n_dots = expr.argument, n_dots + 1
    return (expr.name if isinstance(expr, Symbol) else "?"), n_dots
