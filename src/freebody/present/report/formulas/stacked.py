"""Formulas of a report over several lines, for the terminal."""

from __future__ import annotations

from collections.abc import Sequence

from freebody.language.expression import Expr
from freebody.language.notation.stacked import TextBox, stacked
from freebody.present.report.formulas.line import unit_text
from freebody.present.report.formulas.statement import FormulaWriter, is_close


class StackedFormulas(FormulaWriter[TextBox]):
    def expression(self, expr: Expr) -> TextBox:
        return stacked(expr)[0]

    def nothing(self) -> TextBox:
        return flat("")

    def operator(self, symbol: str) -> TextBox:
        return flat(f" {symbol} ")

    def beside(self, pieces: Sequence[TextBox]) -> TextBox:
        """Boxes in a row, their baselines on one line."""
        above = max(box.baseline for box in pieces)
        height = above + 1 + max(box.below for box in pieces)
        lines = [""] * height
        for box in pieces:
            top = above - box.baseline
            for i in range(height):
                lines[i] += box.lines[i - top] if top <= i < top + len(box.lines) else " " * box.width
        return TextBox(tuple(lines), above)

    def in_brackets(self, piece: TextBox) -> TextBox:
        n = len(piece.lines)
        if n == 1:
            return flat(f"({piece.lines[0]})")
        left, right = "⎛" + "⎜" * (n - 2) + "⎝", "⎞" + "⎟" * (n - 2) + "⎠"
        return TextBox(tuple(left[i] + line + right[i] for i, line in enumerate(piece.lines)), piece.baseline)

    def over(self, above: TextBox, below: TextBox) -> TextBox:
        width = max(above.width, below.width)
        lines = [line.center(width) for line in above.lines]
        lines += ["─" * width, *(line.center(width) for line in below.lines)]
        return TextBox(tuple(lines), len(above.lines))

    def column(self, entries: Sequence[TextBox]) -> TextBox:
        width = max(box.width for box in entries)
        lines = tuple(line.center(width) for box in entries for line in box.lines)
        return self.in_brackets(TextBox(lines, (len(lines) - 1) // 2))

    def d(self, is_partial: bool) -> TextBox:
        return flat("∂" if is_partial else "d")

    def unit(self, unit: str) -> TextBox:
        return flat(("" if is_close(unit) else " ") + unit_text(unit))


def flat(text: str) -> TextBox:
    return TextBox((text,), 0)
