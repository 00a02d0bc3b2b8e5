"""Formulas of a report in Typst mathematics."""

from __future__ import annotations

from collections.abc import Sequence

from freebody.language.expression import Expr
from freebody.language.notation import to_typst
from freebody.present.report.formulas.statement import FormulaWriter, is_close, unit_parts


class TypstFormulas(FormulaWriter[str]):
    def expression(self, expr: Expr) -> str:
        return to_typst(expr)

    def nothing(self) -> str:
        return '""'

    def operator(self, symbol: str) -> str:
        return " dot " if symbol == "·" else f" {symbol} "

    def head(self, sign: str) -> str:
        if sign == "Σ":
            return "sum "
        return f"op({quoted(sign)})" if sign.isalpha() else sign

    def beside(self, pieces: Sequence[str]) -> str:
        return "".join(pieces)

    def in_brackets(self, piece: str) -> str:
        return f" ({piece})"

    def over(self, above: str, below: str) -> str:
        return f"frac({above}, {below})"

    def column(self, entries: Sequence[str]) -> str:
        return f"vec({', '.join(entries)})"

    def d(self, is_partial: bool) -> str:
        return "∂ " if is_partial else "upright(d) "

    def unit(self, unit: str) -> str:
        text = "" if is_close(unit) else " thin "
        for part, exponent in unit_parts(unit):
            text += quoted(part) + (f"^({exponent})" if exponent else "")
        return text


def quoted(text: str) -> str:
    """A string of Typst."""
    return '"' + text.replace("\\", "\\\\").replace('"', '\\"') + '"'
