"""Formulas of a report in LaTeX mathematics."""

from __future__ import annotations

from collections.abc import Sequence

from freebody.language.expression import Expr
from freebody.language.notation import to_latex
from freebody.present.report.formulas.statement import FormulaWriter, is_close, unit_parts

_OPERATORS = {
    **{"≈": r"\approx", ">": ">", "≥": r"\ge", "<": "<", "≤": r"\le", "≠": r"\ne"},
    **{"→": r"\to", "⇒": r"\Rightarrow", "⇔": r"\Leftrightarrow"},
    **{"×": r"\times", "·": r"\cdot", "±": r"\pm", "Σ": r"\sum"},
}
_UNIT_SIGNS = {" ": r"\,", "°": r"{}^{\circ}", "µ": r"\mu ", "μ": r"\mu ", "%": r"\%", "Ω": r"\Omega "}


class LatexFormulas(FormulaWriter[str]):
    def expression(self, expr: Expr) -> str:
        return to_latex(expr)

    def nothing(self) -> str:
        return "{}"

    def operator(self, symbol: str) -> str:
        return f" {_OPERATORS.get(symbol, symbol)} "

    def head(self, sign: str) -> str:
        if sign in _OPERATORS:
            return f"{_OPERATORS[sign]} "
        return rf"\operatorname{{{sign}}}" if sign.isalpha() else sign

    def beside(self, pieces: Sequence[str]) -> str:
        return "".join(pieces)

    def in_brackets(self, piece: str) -> str:
        return rf"\left({piece}\right)"

    def over(self, above: str, below: str) -> str:
        return rf"\frac{{{above}}}{{{below}}}"

    def column(self, entries: Sequence[str]) -> str:
        between = r" \\[8pt] " if any(r"\frac" in entry for entry in entries) else r" \\ "  # fractions touch else
        return r"\begin{pmatrix}" + between.join(entries) + r"\end{pmatrix}"

    def d(self, is_partial: bool) -> str:
        return r"\partial " if is_partial else r"\mathrm{d}"

    def unit(self, unit: str) -> str:
        letters = ""
        for part, exponent in unit_parts(unit):
            letters += "".join(_UNIT_SIGNS.get(c, c) for c in part if c.isalnum() or c in "/.% °")
            letters += f"^{{{exponent}}}" if exponent else ""
        return rf"\mathrm{{{letters}}}" if is_close(unit) else rf"\,\mathrm{{{letters}}}"
