"""The table of a characteristic polynomial."""

from __future__ import annotations

from collections.abc import Sequence

from freebody.language.expression import Expr
from freebody.language.sentences import Sentence
from freebody.narrative.lines.script import FormulaTable, Script
from freebody.narrative.principles.sides import readable
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.tidy import tidy


def tell_polynomial(script: Script, coefficients: Sequence[Ratio]) -> None:
    """A row for each power, the highest first; coefficients: from the constant term up."""
    rows: list[tuple[Sentence | Expr | str, ...]] = []
    for power, c in enumerate(coefficients):
        if not c.is_zero():
            rows.append((str(power), tidy(readable(c))))
    header = (Sentence("steady.table_power"), Sentence("conserved.table_coefficient"))
    script.add(FormulaTable(header, tuple(reversed(rows))))
