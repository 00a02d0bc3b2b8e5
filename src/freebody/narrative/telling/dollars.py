"""$t > 0$, or a rate(x) = 0 that a user has written: formulas within words."""

from __future__ import annotations

import re
from typing import cast

from freebody.errors import ExpressionError
from freebody.language.parser import parse
from freebody.present.report.blocks import Formula, Piece, Relation

_VALUE = r"-?(?:[^\W\d]\w*(?:[*/^]\w+)*|\d+(?!\w|\.\d| [A-Za-zµ°]))(?!\w|[-(^/*+]| [-+*/^])"  # of no unit
_RATE = re.compile(rf"((?:\|rate\(\w+\)\||\brate\(\w+\))(?: [=<>] {_VALUE})?)")
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
            found += [formula_of(part)] if k % 2 else [part] if part else []
        except ExpressionError:
            found.append(part)
    return found
