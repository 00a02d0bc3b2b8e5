"""Formulas of a report over several lines, for the terminal."""

from __future__ import annotations

from collections.abc import Sequence

from freebody.language.expression import Expr
from freebody.language.notation.stacked import TextBox, beside, flat, in_brackets, over, stacked
from freebody.present.report.formulas.line import unit_text
from freebody.present.report.formulas.statement import FormulaWriter, is_close


class StackedFormulas(FormulaWriter[TextBox]):
    def expression(self, expr: Expr) -> TextBox:
        return stacked(expr)[0]

    def nothing(self) -> TextBox:
        return flat("")

    def operator(self, symbol: str) -> TextBox:
        return flat(f" {symbol} ")

    def head(self, sign: str) -> TextBox:
        return flat(f"{sign} " if sign == "Σ" else sign)

    def beside(self, pieces: Sequence[TextBox]) -> TextBox:
        return beside(pieces)

    def in_brackets(self, piece: TextBox) -> TextBox:
        return in_brackets(piece)

    def over(self, above: TextBox, below: TextBox) -> TextBox:
        return over(above, below)

    def column(self, entries: Sequence[TextBox]) -> TextBox:
        width = max(box.width for box in entries)
        lines = tuple(line.center(width) for box in entries for line in box.lines)
        return in_brackets(TextBox(lines, (len(lines) - 1) // 2))

    def d(self, is_partial: bool) -> TextBox:
        return flat("∂" if is_partial else "d")

    def unit(self, unit: str) -> TextBox:
        return flat(("" if is_close(unit) else " ") + unit_text(unit))
