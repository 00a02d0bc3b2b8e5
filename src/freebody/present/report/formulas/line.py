"""Formulas of a report on one line of Unicode, within a paragraph of the terminal."""

from __future__ import annotations

from collections.abc import Sequence

from freebody.language.expression import Expr
from freebody.language.notation import to_text
from freebody.present.report.formulas.statement import FormulaWriter, is_close, unit_parts

_SUPERSCRIPTS = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")


class LineFormulas(FormulaWriter[str]):
    def expression(self, expr: Expr) -> str:
        return to_text(expr)

    def nothing(self) -> str:
        return ""

    def operator(self, symbol: str) -> str:
        return f" {symbol} "

    def head(self, sign: str) -> str:
        return f"{sign} " if sign == "Σ" else sign

    def beside(self, pieces: Sequence[str]) -> str:
        return "".join(pieces)

    def in_brackets(self, piece: str) -> str:
        return f"({piece})"

    def over(self, above: str, below: str) -> str:
        return f"{above}/{below}"

    def column(self, entries: Sequence[str]) -> str:
        return f"({', '.join(entries)})"

    def d(self, is_partial: bool) -> str:
        return "∂" if is_partial else "d"

    def unit(self, unit: str) -> str:
        return ("" if is_close(unit) else " ") + unit_text(unit)


def unit_text(unit: str) -> str:
    """m/s^2 -> m/s²"""
    return "".join(part + exponent.translate(_SUPERSCRIPTS) for part, exponent in unit_parts(unit))
