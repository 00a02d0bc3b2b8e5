"""$t > 0$, or a rate(x) = 0 that a user has written: formulas within words."""

from __future__ import annotations

import re
from typing import cast
from unicodedata import normalize

from freebody.errors import ExpressionError
from freebody.language.expression import Expr, Symbol, VectorSymbol, substitute
from freebody.language.parser import GREEK, parse
from freebody.present.report.blocks import Beside, Derivative, Formula, Piece, Relation

_VALUE = r"-?(?:[^\W\d]\w*(?:[*/^]\w+)*|\d+(?!\w|\.\d| [A-Za-zµ°]))(?!\w|[-(^/*+]| [-+*/^])"  # of no unit
_RATE = re.compile(rf"((?:\|rate\(\w+\)\||\brate\(\w+\))(?: [=<>] {_VALUE})?)")
_BY_NAME = "|".join(sorted(GREEK.values(), key=len, reverse=True))
_INDEX = r"(?:_\w+|[0-9₀-₉]+)"
_INDEXED = re.compile(
    rf"(?<![\w.])((?:[{''.join(GREEK)}]{_INDEX}?|[A-Za-z](?:_\w+|[₀-₉]+)|(?:{_BY_NAME}){_INDEX}))(?![\w'(]|\.\w)"
)
_ALONE = ("×", "·", "±", "Σ", "+", "-", "det", "Re")  # signs and words between the parts of a formula or before one
_SIGNS = re.compile(r"([×·±Σ]|\bdet\b|\bRe\b|∂\w+/∂\w+'*|\bd\w/d\w\b)")
_DERIVATIVE = re.compile(r"[∂d](\w+)/[∂d](\w+'*)")
_LOOSE = re.compile(r"(?:([-+]) |\*)?(.*?)(?: ([-+])|\*)?")  # its sums and products go on with the part beside it
_BOLD = re.compile(r"([\U0001d468-\U0001d49b\U0001d71c-\U0001d74e])(_\w+)?")
_DIGITS = str.maketrans("₀₁₂₃₄₅₆₇₈₉", "0123456789")
_RELATION = re.compile(r" ([=<>≤≥≠→]) ")


def formula_of(text: str) -> Formula:
    """Sides with relations between them. Raises ExpressionError."""
    parts = _RELATION.split(text.strip())
    return Formula(tuple(map(_side, parts[::2])), cast("tuple[Relation, ...]", tuple(parts[1::2])))


def _side(text: str) -> Expr | Beside:
    """An expression, or what is more than one: a vector is a bold letter, and between vectors stand × and ·."""
    found: list[Expr | Derivative | str] = []
    for part in filter(None, map(str.strip, _SIGNS.split(text))):
        if part in _ALONE:
            found.append(part)
        elif (derivative := _DERIVATIVE.fullmatch(part)) is not None:
            above, below = map(_with_vectors, derivative.groups())
            found.append(Derivative(above, below, is_partial=part.startswith("∂")))
        elif (loose := _LOOSE.fullmatch(part)) is not None:
            before, inner, behind = loose.groups()
            found += [before] * bool(before) + [_with_vectors(inner)] + [behind] * bool(behind)
    return found[0] if len(found) == 1 and isinstance(found[0], Expr) else Beside(tuple(found))


def _with_vectors(text: str) -> Expr:
    vectors: dict[str, Expr] = {}

    def plain(found: re.Match[str]) -> str:
        letter = normalize("NFKC", found[1])
        name = GREEK.get(letter, letter) + (found[2] or "")
        vectors[f"bold_{name}"] = VectorSymbol(name)
        return f"bold_{name}"

    return substitute(parse(_BOLD.sub(plain, text)), vectors)


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
