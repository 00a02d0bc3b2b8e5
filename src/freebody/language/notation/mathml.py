"""Expressions in presentation MathML, as browsers draw it (MathML Core): elements to stand in an `mrow` or a `math`.

Source: W3C, MathML Core, 2025.
"""

from __future__ import annotations

from collections.abc import Sequence

from freebody.language.expression import Call, Expr, PowerOf, Symbol
from freebody.language.notation.parts import ATOM, LETTER_OF, as_on_paper, split_name
from freebody.language.notation.typeset import Typesetter, dotted, letters_and_index

_NAMES = {"asin": "arcsin", "acos": "arccos", "atan": "arctan"}
_DOTS = ("", ".", "..", "...", "....")
_MINUS = "<mo>−</mo>"
_APPLIED = "<mo>&#x2061;</mo>"
_TIMES = "<mo>&#x2062;</mo>"
_THIN_SPACE = '<mspace width="0.17em"/>'


def row(elements: str) -> str:
    """Elements as one."""
    return f"<mrow>{elements}</mrow>"


def in_brackets(elements: str) -> str:
    """Brackets grow with fractions, roots and columns; around anything lower they keep their size, for browsers would
    take the next larger one."""
    fixed = "" if any(tall in elements for tall in ("<mfrac", "<msqrt", "<mtable")) else ' stretchy="false"'
    return f'<mrow><mo form="prefix"{fixed}>(</mo>{elements}<mo form="postfix"{fixed}>)</mo></mrow>'


class _MathML(Typesetter):
    e = "<mi>e</mi>"
    minus = _MINUS
    between = ("<mo>+</mo>", _MINUS)
    dot = "<mo>⋅</mo>"

    def in_brackets(self, text: str) -> str:
        return in_brackets(text)

    def superscript(self, base: str, exponent: str) -> str:
        return f"<msup>{base}{row(exponent)}</msup>"

    def over(self, above: str, below: str) -> str:
        return f"<mfrac>{row(above)}{row(below)}</mfrac>"

    def root(self, argument: str) -> str:
        return f"<msqrt>{argument}</msqrt>"

    def size(self, argument: str) -> str:
        return f'<mrow><mo form="prefix">|</mo>{argument}<mo form="postfix">|</mo></mrow>'

    def operator(self, function: str) -> str:
        return f"<mi>{_NAMES.get(function, function)}</mi>"

    def degrees(self, digits: str) -> str:
        return f"<mn>{digits}°</mn>"

    def applied(self, argument: str, is_bare: bool) -> str:
        return _APPLIED + (_THIN_SPACE + argument if is_bare else in_brackets(argument))

    def special(self, letter: str, index: str, arguments: Sequence[str]) -> str:
        size = f"<mn>{index.lstrip('-')}</mn>"
        written = f"<mrow>{_MINUS}{size}</mrow>" if index.startswith("-") else size
        name = f"<msub><mi>{letter}</mi>{written}</msub>" if index else f"<mi>{letter}</mi>"
        return f"{name}{_APPLIED}{in_brackets('<mo>,</mo>'.join(arguments))}"

    def name(self, name: str, n_dots: int, *, is_vector: bool = False) -> tuple[str, int]:
        letter, index = _letter_and_index(name, n_dots)
        if is_vector:  # browsers know no bold letters in mathematics but by their style
            letter = f'<mrow style="font-weight:bold">{letter}</mrow>'
        return (f"<msub>{letter}{index}</msub>" if index else letter), ATOM

    def digits(self, mantissa: str, exponent: str) -> str:
        text = f"<mn>{mantissa}</mn>"
        if not exponent:
            return text
        sign = _MINUS if exponent.startswith("-") else ""
        power = self.superscript("<mn>10</mn>", f"{sign}<mn>{exponent.lstrip('-')}</mn>")
        return power if mantissa == "1" else f"{text}{self.dot}{power}"

    def raised(self, base: Expr, exponent: str) -> str:
        """A power; the index of a symbol and its exponent stand above each other."""
        if isinstance(base, Symbol) or (isinstance(base, Call) and base.function == "rate"):
            letter, index = _letter_and_index(*dotted(base))
            if index:
                return f"<msubsup>{letter}{index}{row(exponent)}</msubsup>"
        return self.superscript(row(self.at_least(ATOM, base)), exponent)

    def joint(self, factors: tuple[Expr, ...], i: int, written: str) -> str:
        if written.startswith(("<mn>", "<msup><mrow><mn>", "<msup><mn>")):
            return self.dot
        is_spaced = _is_word(factors[i]) or _is_word(factors[i - 1], is_before=True)
        return _TIMES + (_THIN_SPACE if is_spaced else "")


def _is_word(factor: Expr, is_before: bool = False) -> bool:
    """Is it a function or a name of several letters, which would run into its neighbour? A function before its
    neighbour ends with a bracket."""
    match factor:
        case Symbol(name):
            letters, _ = split_name(as_on_paper(name))
            return len(letters) > 1 and letters not in LETTER_OF
        case Call("rate", argument):
            return _is_word(argument, is_before)
        case Call(function, _):
            return not is_before and function not in ("sqrt", "abs", "exp")
        case PowerOf(base, _):
            return _is_word(base, is_before)
        case _:
            return False


def _letter_and_index(name: str, n_dots: int) -> tuple[str, str]:
    """The letter of a symbol, with the dots of its rates, and its index or nothing."""
    letters, index = letters_and_index(name)
    letter = LETTER_OF.get(letters, letters)
    # A single letter is set in italics, save the capital Greek ones.
    upright = ' mathvariant="normal"' if letters in LETTER_OF and letters[0].isupper() else ""
    text = f"<mi{upright}>{letter}</mi>"
    if n_dots >= len(_DOTS):
        text = f"<msup>{text}<mrow><mo>(</mo><mn>{n_dots}</mn><mo>)</mo></mrow></msup>"
    elif n_dots:
        # Full stops set above the letter: without a font for mathematics browsers draw accents into it, and a rate
        # would look like its coordinate. As large as at the letter: Firefox goes by the level, Safari by the size.
        close = ' style="letter-spacing:-0.08em"' if n_dots > 1 else ""
        text = f'<mover>{text}<mo stretchy="false" scriptlevel="+0" mathsize="1em"{close}>{_DOTS[n_dots]}</mo></mover>'
    return text, _index(index)


def _index(index: str) -> str:
    if not index:
        return ""
    if index.isdigit():
        return f"<mn>{index}</mn>"
    return f"<mi>{index}</mi>" if len(index) == 1 else f'<mi mathvariant="normal">{index}</mi>'


mathml = _MathML().write
