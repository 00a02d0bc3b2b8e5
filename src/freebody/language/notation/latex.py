r"""Expressions in LaTeX mathematics: fractions with \frac, Greek letters, indices, a dot for a rate."""

from __future__ import annotations

from collections.abc import Sequence

from freebody.language.notation.parts import ATOM, LETTER_OF, POWER
from freebody.language.notation.typeset import Typesetter, letters_and_index

_OPERATORS = {
    **{name: rf"\{name}" for name in ("sin", "cos", "tan", "log", "sinh", "cosh", "tanh")},
    **{"asin": r"\arcsin", "acos": r"\arccos", "atan": r"\arctan", "sign": r"\operatorname{sign}"},
}
_DOTS = ("", r"\dot", r"\ddot", r"\dddot", r"\ddddot")


class _Latex(Typesetter):
    dot = r" \cdot "
    comma = "{,}"

    def in_brackets(self, text: str) -> str:
        return rf"\left({text}\right)"

    def superscript(self, base: str, exponent: str) -> str:
        return f"{base}^{{{exponent}}}"

    def over(self, above: str, below: str) -> str:
        return rf"\frac{{{above}}}{{{below}}}"

    def root(self, argument: str) -> str:
        return rf"\sqrt{{{argument}}}"

    def size(self, argument: str) -> str:
        return rf"\left|{argument}\right|"

    def operator(self, function: str) -> str:
        if function in _OPERATORS:
            return _OPERATORS[function]
        name = function.rstrip("'")  # of a function that is given in numbers
        return rf"\operatorname{{{name}}}" + function[len(name) :]

    def degrees(self, digits: str) -> str:
        return rf"{digits}^{{\circ}}"

    def applied(self, argument: str, is_bare: bool) -> str:
        return f" {argument}" if is_bare else self.in_brackets(argument)

    def special(self, letter: str, index: str, arguments: Sequence[str]) -> str:
        written = f"_{{{index}}}" if index else ""
        return rf"{letter}{written}\!{self.in_brackets(', '.join(arguments))}"

    def name(self, name: str, n_dots: int, *, is_vector: bool = False) -> tuple[str, int]:
        """The letter, which carries the dots of a rate, and its index: theta1 -> \\theta, _{1}."""
        letters, written = letters_and_index(name)
        if letters in LETTER_OF:
            letter = r"\lambda" if letters == "lam" else rf"\{letters}"
        else:
            letter = letters if len(letters) == 1 else rf"\mathrm{{{letters}}}"
        if is_vector:
            letter = rf"\boldsymbol{{{letter}}}"
        index = f"_{{{written}}}" if written else ""
        if len(written) > 1 and not written.isdigit():
            index = rf"_{{\mathrm{{{written.replace(' ', '~')}}}}}"
        if n_dots >= len(_DOTS):
            return f"{letter}^{{({n_dots})}}{index}", POWER
        return (f"{_DOTS[n_dots]}{{{letter}}}" if n_dots else letter) + index, ATOM


latex = _Latex().write
