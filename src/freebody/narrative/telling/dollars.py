"""$t > 0$, or a rate(x) = 0 that a user has written: formulas within words."""

from __future__ import annotations

import re
from typing import cast

from freebody.errors import ExpressionError
from freebody.language.expression import Symbol
from freebody.language.parser import GREEK, parse
from freebody.present.report.blocks import Formula, Piece, Relation

_VALUE = r"-?(?:[^\W\d]\w*(?:[*/^]\w+)*|\d+(?!\w|\.\d| [A-Za-zµ°]))(?!\w|[-(^/*+]| [-+*/^])"  # of no unit
_RATE = re.compile(rf"((?:\|rate\(\w+\)\||\brate\(\w+\))(?: [=<>] {_VALUE})?)")
_BY_NAME = "|".join(sorted(GREEK.values(), key=len, reverse=True))
_INDEX = r"(?:_\w+|[0-9₀-₉]+)"
_INDEXED = re.compile(
    rf"(?<![\w.])((?:[{''.join(GREEK)}]{_INDEX}?|[A-Za-z](?:_\w+|[₀-₉]+)|(?:{_BY_NAME}){_INDEX}))(?![\w'(]|\.\w)"
)
_DIGITS = str.maketrans("₀₁₂₃₄₅₆₇₈₉", "0123456789")
_RELATION = re.compile(r" ([=<>≤≥≠→]) ")


def formula_of(text: str) -> Formula:
    """Sides with relations between them. Raises ExpressionError."""
    parts = _RELATION.split(text.strip())
    return Formula(tuple(map(parse, parts[::2])), cast("tuple[Relation, ...]", tuple(parts[1::2])))


def with_rates(words: str) -> list[Piece]:
    """Words of a user, in which a rate that is written as in a file is a formula, and its equation too."""
    found: list[Piece] = []
    for k, part in enumerate(_RATE.split(words) if "rate(" in words else [words]):
        try:
            found += [formula_of(part)] if k % 2 else _with_symbols(part)
        except ExpressionError:
            found.append(part)
    return found


def _with_symbols(words: str) -> list[Piece]:
    """Words in which Greek letters and letters with an index, as θ_0, omega_0 and k_i, are formulas."""
    parts = _INDEXED.split(words)
    return [Formula((Symbol(_in_latin(part)),)) if k % 2 else part for k, part in enumerate(parts) if part]


def _in_latin(symbol: str) -> str:
    """θ₀ as theta0"""
    latin = GREEK[symbol[0]] + symbol[1:] if symbol[0] in GREEK else symbol
    return latin.translate(_DIGITS)
