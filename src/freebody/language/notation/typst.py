"""Expressions in Typst mathematics: frac(a, b), Greek letters, indices, dot(x) for a rate.

What is longer than one letter stands in quotes, which sets it upright and keeps Typst from taking it for one of its
own names.
"""

from __future__ import annotations

from collections.abc import Sequence

from freebody.language.notation.parts import ATOM, LETTER_OF, POWER
from freebody.language.notation.typeset import Typesetter, letters_and_index

_OPERATORS = {"asin": "arcsin", "acos": "arccos", "atan": "arctan", "sign": 'op("sign")'}
_DOTS = ("", "dot", "dot.double", "dot.triple", "dot.quad")


class _Typst(Typesetter):
    dot = " ⋅ "
    comma = '","'

    def in_brackets(self, text: str) -> str:
        return f"({text})"

    def superscript(self, base: str, exponent: str) -> str:
        return f"{base}^({exponent})"

    def over(self, above: str, below: str) -> str:
        return f"frac({above}, {below})"

    def root(self, argument: str) -> str:
        return f"sqrt({argument})"

    def size(self, argument: str) -> str:
        return f"abs({argument})"

    def operator(self, function: str) -> str:
        if function.rstrip("'") != function:  # a derivative of what is given in numbers
            name = function.rstrip("'")
            return f'op("{name}"){function[len(name) :]}'
        return _OPERATORS.get(function, function)

    def degrees(self, digits: str) -> str:
        return f"{digits} degree"

    def applied(self, argument: str, is_bare: bool) -> str:
        return f" {argument}" if is_bare else f" ({argument})"

    def special(self, letter: str, index: str, arguments: Sequence[str]) -> str:
        written = f"_({index})" if index else ""
        return f"{letter}{written}({', '.join(arguments)})"

    def name(self, name: str, n_dots: int, *, is_vector: bool = False) -> tuple[str, int]:
        """theta1' -> dot(θ)_1."""
        letters, index = letters_and_index(name)
        letter = LETTER_OF.get(letters, letters if len(letters) == 1 else f'"{letters}"')
        if letters in LETTER_OF and letters[0].isupper():
            letter = f"upright({letter})"
        if is_vector:
            letter = f"bold({letter})"
        written = "" if not index else f"_({index})" if index.isdigit() or len(index) == 1 else f'_"{index}"'
        if n_dots >= len(_DOTS):
            return f"{letter}^(({n_dots})){written}", POWER
        return (f"{_DOTS[n_dots]}({letter})" if n_dots else letter) + written, ATOM


typst = _Typst().write
