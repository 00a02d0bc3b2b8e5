"""Formulas of a report in MathML."""

from __future__ import annotations

import html
from collections.abc import Sequence

from freebody.language.expression import Expr
from freebody.language.notation import to_mathml
from freebody.language.notation.mathml import in_brackets, row
from freebody.present.report.formulas.statement import FormulaWriter, is_close, unit_parts


class MathMLFormulas(FormulaWriter[str]):
    def expression(self, expr: Expr) -> str:
        return row(to_mathml(expr))

    def nothing(self) -> str:
        return ""

    def operator(self, symbol: str) -> str:
        # Arrows would stretch over what stands beside them.
        return f'<mo form="infix" stretchy="false">{html.escape(symbol.replace("-", "−"))}</mo>'

    def head(self, sign: str) -> str:
        if sign.isalpha() and sign != "Σ":
            return f'<mi mathvariant="normal">{html.escape(sign)}</mi>'
        return f'<mo form="prefix" stretchy="false">{html.escape(sign.replace("-", "−"))}</mo>'

    def beside(self, pieces: Sequence[str]) -> str:
        return "".join(pieces)

    def in_brackets(self, piece: str) -> str:
        return in_brackets(piece)

    def over(self, above: str, below: str) -> str:
        return f"<mfrac>{row(above)}{row(below)}</mfrac>"

    def column(self, entries: Sequence[str]) -> str:
        cells = "".join(f"<mtr><mtd>{entry}</mtd></mtr>" for entry in entries)
        return in_brackets(f"<mtable>{cells}</mtable>")

    def d(self, is_partial: bool) -> str:
        return '<mi mathvariant="normal">∂</mi>' if is_partial else '<mi mathvariant="normal">d</mi>'

    def unit(self, unit: str) -> str:
        text = "" if is_close(unit) else '<mspace width="0.25em"/>'
        for part, exponent in unit_parts(unit):
            name = f'<mi mathvariant="normal">{html.escape(part).replace(" ", "&#xa0;")}</mi>'
            text += f"<msup>{name}<mn>{exponent.replace('-', '−')}</mn></msup>" if exponent else name
        return row(text)
