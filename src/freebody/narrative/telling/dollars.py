"""$t > 0$: formulas within words."""

from __future__ import annotations

import re
from typing import cast

from freebody.language.parser import parse
from freebody.present.report.blocks import Formula, Relation

_RELATION = re.compile(r" ([=<>≤≥≠→]) ")


def formula_of(text: str) -> Formula:
    """Sides with relations between them. Raises ExpressionError."""
    parts = _RELATION.split(text.strip())
    return Formula(tuple(map(parse, parts[::2])), cast("tuple[Relation, ...]", tuple(parts[1::2])))
