"""What the author of a model has written, with its mathematics: $h/sin(alpha)$, and names of the model as symbols."""

from __future__ import annotations

import re
from collections.abc import Sequence

from freebody.errors import ExpressionError
from freebody.language.expression import Symbol
from freebody.language.parser import GREEK
from freebody.narrative.telling.dollars import formula_of
from freebody.present.report.blocks import Formula, Piece, Text
from freebody.questions.reading import Question
from freebody.system.system import System

_WORDS = ("a", "A", "I")  # a parameter of this name is one only between dollar signs
_FUNCTIONS = frozenset(("sin", "cos", "tan", "sqrt", "pi"))
_CALCULATED = re.compile(
    r"(?<![\w'^*/])((?:sqrt|sin|cos|tan)?\(?\w[\w()]*(?:[*/^]\(?\w[\w()]*)+)"
)  # without a space in it


def authored(text: str, system: System) -> Text:
    """Words of an author as text with formulas; what cannot be read stays as it is."""
    return _authored(" ".join(text.split()), system)


def _authored(text: str, system: System) -> Text:
    names = sorted((*system.parameters, *system.measures), key=len, reverse=True)
    plain = [name for name in names if name not in _WORDS and not _is_word(name)]
    named = re.compile(rf"(?<![\w'])({'|'.join(map(re.escape, plain))})(?![\w'])") if plain else None
    pieces: list[Piece] = []
    for k, part in enumerate(text.split("$")):
        if k % 2:
            pieces.append(_formula(part))
        elif named is None:
            pieces.append(part)
        else:
            for n, words in enumerate(_CALCULATED.split(part)):
                if n % 2 and (whole := _calculated(words, plain)) is not None:
                    pieces.append(whole)
                else:
                    for m, word in enumerate(named.split(words)):
                        pieces.append(Formula((Symbol(word),)) if m % 2 else word)
    return tuple(piece for piece in pieces if piece != "")


def with_symbols(said: Text, question: Question, system: System) -> Text:
    """A question in words, with symbols in what is quoted of it."""
    if question.quantity.sentence(system) is not None:
        return said
    return tuple(part for piece in said for part in (_authored(piece, system) if isinstance(piece, str) else (piece,)))


def _is_word(name: str) -> bool:
    """Whether a name can be a word of the language: long, and nothing but small letters."""
    return len(name) > 3 and name.isalpha() and name.islower() and name not in GREEK.values()


def _calculated(text: str, names: Sequence[str]) -> Piece | None:
    """What is calculated of names in the running text, as b^2/c; None for words with a stroke between them, and for
    what is no expression."""
    used = set(re.findall(r"[A-Za-z_]\w*", text))
    if not used or not used <= {*names, *_FUNCTIONS}:
        return None
    try:
        return formula_of(text)
    except ExpressionError:
        return None


def _formula(text: str) -> Piece:
    try:
        return formula_of(text)
    except ExpressionError:
        return text
