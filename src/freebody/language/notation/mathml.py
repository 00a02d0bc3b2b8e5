"""Expressions in presentation MathML, as browsers draw it (MathML Core): elements to stand in an `mrow` or a `math`.

As on one line, every text carries how strongly its top operation binds; what is above or below a bar, under a root
or raised needs no bracket. Source: W3C, MathML Core, 2025.
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

_NAMES = {"asin": "arcsin", "acos": "arccos", "atan": "arctan", "log": "log"}
_DOTS = ("", "˙", "¨", "˙˙˙", "˙˙˙˙")
_MINUS = "<mo>−</mo>"
_APPLIED = "<mo>&#x2061;</mo>"
_TIMES = "<mo>&#x2062;</mo>"
_THIN_SPACE = '<mspace width="0.17em"/>'


def mathml(expr: Expr, is_followed: bool = False) -> tuple[str, int]:
    """The elements and their strength; before another factor (`is_followed`) sin x is written sin(x)."""
    match expr:
        case Number(value):
            decimal = as_decimal(abs(value)) or (str(abs(value)) if is_whole(expr) else None)
            return _fraction((expr,)) if decimal is None else _decimal(decimal, value < 0)
        case Symbol():
            return _indexed(*_letter_and_index(expr)), ATOM
        case Sum(terms):
            text = ""
            for is_subtracted, term in signed_terms(terms):
                sign = _MINUS if is_subtracted else "<mo>+</mo>" if text else ""
                text += sign + _at_least(PRODUCT, term)
            return text, SUM
        case ProductOf(factors):
            return _fraction(factors)
        case PowerOf(_, Number(value)) if value < 0:
            return _fraction((expr,))
        case PowerOf(Call("sin" | "cos" | "tan" | "sinh" | "cosh" | "tanh" as function, argument), exponent) if (
            is_whole(exponent)
        ):
            operator = f"<msup><mi>{function}</mi>{row(mathml(exponent)[0])}</msup>"
            return operator + _argument(argument, is_followed), PRODUCT
        case PowerOf(base, exponent):
            return _raised(base, row(mathml(exponent)[0])), POWER
        case Call("sqrt", argument):
            return f"<msqrt>{mathml(argument)[0]}</msqrt>", POWER
        case Call("abs", argument):
            return f'<mrow><mo form="prefix">|</mo>{mathml(argument)[0]}<mo form="postfix">|</mo></mrow>', ATOM
        case Call("rate"):
            return _indexed(*_letter_and_index(expr)), ATOM
        case Call("exp", argument):
            return f"<msup><mi>e</mi>{row(mathml(argument)[0])}</msup>", POWER
        case Call(function) if function in LETTER_OF_INTEGRAL:
            arguments = "<mo>,</mo>".join(mathml(x)[0] for x in children(expr))
            return f"<mi>{LETTER_OF_INTEGRAL[function]}</mi>{_APPLIED}{in_brackets(arguments)}", ATOM
        case Call(function, argument):
            return f"<mi>{_NAMES.get(function, function)}</mi>" + _argument(argument, is_followed), PRODUCT


def row(elements: str) -> str:
    """Elements as one."""
    return f"<mrow>{elements}</mrow>"


def in_brackets(elements: str) -> str:
    """Brackets grow with fractions, roots and columns; around anything lower they keep their size, for browsers would
    take the next larger one."""
    fixed = "" if any(tall in elements for tall in ("<mfrac", "<msqrt", "<mtable")) else ' stretchy="false"'
    return f'<mrow><mo form="prefix"{fixed}>(</mo>{elements}<mo form="postfix"{fixed}>)</mo></mrow>'


def _at_least(strength: int, expr: Expr, is_followed: bool = False) -> str:
    elements, own = mathml(expr, is_followed)
    return elements if own >= strength else in_brackets(elements)


def _decimal(decimal: str, is_negative: bool) -> tuple[str, int]:
    mantissa, _, exponent = decimal.partition("e")
    text = f"<mn>{mantissa}</mn>"
    if exponent:
        sign = _MINUS if exponent.startswith("-") else ""
        power = f"<msup><mn>10</mn><mrow>{sign}<mn>{exponent.lstrip('-')}</mn></mrow></msup>"
        text = power if mantissa == "1" else f"{text}<mo>⋅</mo>{power}"
    return (_MINUS + text, MINUS) if is_negative else (text, PRODUCT if exponent else ATOM)


def _argument(argument: Expr, is_followed: bool) -> str:
    elements = mathml(argument)[0]
    is_plain = isinstance(argument, Symbol) and not is_followed
    return _APPLIED + (_THIN_SPACE + elements if is_plain else in_brackets(elements))


def _raised(base: Expr, exponent: str) -> str:
    """A power; the index of a symbol and its exponent stand above each other."""
    is_name = isinstance(base, Symbol) or (isinstance(base, Call) and base.function == "rate")
    if is_name:
        letter, index = _letter_and_index(base)
        if index:
            return f"<msubsup>{letter}{index}{exponent}</msubsup>"
    return f"<msup>{row(_at_least(ATOM, base))}{exponent}</msup>"


def _fraction(factors: tuple[Expr, ...]) -> tuple[str, int]:
    parts = quotient(factors)
    sign = _MINUS if parts.is_negative else ""
    text = _beside(parts.above)
    if sign and not parts.below and len(parts.above) == 1:
        text = _at_least(PRODUCT, parts.above[0])
    if parts.below:
        text = f"<mfrac>{row(text)}{row(_beside(parts.below))}</mfrac>"
    elif len(factors) == 1 and not sign:
        return text, ATOM
    return sign + text, MINUS if sign else PRODUCT


def _beside(factors: tuple[Expr, ...]) -> str:
    if len(factors) == 1:
        return mathml(factors[0])[0]
    text = ""
    for i, factor in enumerate(factors):
        written = _at_least(PRODUCT, factor, is_followed=i < len(factors) - 1)
        if text:
            is_number = written.startswith(("<mn>", "<msup><mrow><mn>", "<msup><mn>"))
            is_spaced = _is_word(factor) or _is_word(factors[i - 1], is_before=True)
            text += "<mo>⋅</mo>" if is_number else _TIMES + (_THIN_SPACE if is_spaced else "")
        text += written
    return text


def _is_word(factor: Expr, is_before: bool = False) -> bool:
    """Is it a function or a name of several letters, which would run into its neighbour? A function before its
    neighbour ends with a bracket."""
    match factor:
        case Symbol(name):
            letters, _ = split_name(name)
            return len(letters) > 1 and letters not in LETTER_OF
        case Call("rate", argument):
            return _is_word(argument, is_before)
        case Call(function, _):
            return not is_before and function not in ("sqrt", "abs", "exp")
        case PowerOf(base, _):
            return _is_word(base, is_before)
        case _:
            return False


def _letter_and_index(expr: Expr) -> tuple[str, str]:
    """The letter of a symbol, with the dots of its rates, and its index or nothing."""
    n_dots = 0
    while isinstance(expr, Call):
        expr, n_dots = expr.argument, n_dots + 1
    letters, rest = split_name(expr.name if isinstance(expr, Symbol) else "?")
    letter = LETTER_OF.get(letters, letters)
    # A single letter is set in italics, save the capital Greek ones.
    upright = ' mathvariant="normal"' if letters in LETTER_OF and letters[0].isupper() else ""
    text = f"<mi{upright}>{letter}</mi>"
    if n_dots >= len(_DOTS):
        text = f"<msup>{text}<mrow><mo>(</mo><mn>{n_dots}</mn><mo>)</mo></mrow></msup>"
    elif n_dots:
        # Three single dots drawn together: browsers misplace the sign of three.
        close = ' style="letter-spacing:-0.08em"' if n_dots > 2 else ""
        text = f'<mover accent="true">{text}<mo stretchy="false"{close}>{_DOTS[n_dots]}</mo></mover>'
    return text, _index(rest.removeprefix("_").replace("_", ","))


def _index(index: str) -> str:
    if not index:
        return ""
    if index.isdigit():
        return f"<mn>{index}</mn>"
    return f"<mi>{index}</mi>" if len(index) == 1 else f'<mi mathvariant="normal">{index}</mi>'


def _indexed(letter: str, index: str) -> str:
    return f"<msub>{letter}{index}</msub>" if index else letter
