"""Expressions as text: for Python, for reading on one line, for LaTeX, MathML and Typst, and stacked for the terminal.

All writers see an expression the same way: a sum is signed terms, a product is a sign and a fraction
(`Quotient`), and a number is written as a decimal only where that is exact and reads better than p/q.

parts      what the writers share
stated     statements in words that carry the same for machines
one_line   for Python, and for reading
typeset    the walk that the writers of typeset mathematics share:
latex      for LaTeX
mathml     for browsers
typst      for Typst
stacked    for the terminal
"""

from __future__ import annotations

from freebody.language.expression import Expr
from freebody.language.notation.one_line import PYTHON, TEXT
from freebody.language.notation.stated import Stated, as_equation, compared, joined, reworded, stated_plain
from freebody.messages import Shown

__all__ = [
    "Stated",
    "as_equation",
    "compared",
    "joined",
    "reworded",
    "stated_plain",
    "to_latex",
    "to_mathml",
    "to_pretty",
    "to_pretty_lines",
    "to_python",
    "to_text",
    "to_typst",
]


def to_python(expr: Expr) -> str:
    """One line that both Python and `parse` read: 2*m1*g/(m1 + m2)."""
    return PYTHON.write(expr)[0]


def to_text(expr: Expr) -> str:
    """One line for reading, which `parse` reads too: 2·m₁·g/(m₁ + m₂)."""
    return Shown(TEXT.write(expr)[0], expr)


def to_latex(expr: Expr) -> str:
    r"""LaTeX mathematics: \\frac{2 m_{1} g}{m_{1} + m_{2}}."""
    from freebody.language.notation.latex import latex

    return latex(expr)[0]


def to_mathml(expr: Expr) -> str:
    """Presentation MathML, elements for a `math`: <mfrac><mrow>...</mrow><mrow>...</mrow></mfrac>."""
    from freebody.language.notation.mathml import mathml

    return mathml(expr)[0]


def to_typst(expr: Expr) -> str:
    """Typst mathematics, as between dollar signs: frac(2 m_(1) g, m_(1) + m_(2))."""
    from freebody.language.notation.typst import typst

    return typst(expr)[0]


def to_pretty(expr: Expr, width: int = 100) -> str:
    """Several lines with fractions over a bar; the one line of `to_text` when more than `width` columns."""
    return "\n".join(line.rstrip() for line in to_pretty_lines(expr, width)[0])


def to_pretty_lines(expr: Expr, width: int = 100) -> tuple[tuple[str, ...], int]:
    """The lines of `to_pretty`, and which of them stands beside other text: the one of the outermost bar, say."""
    from freebody.language.notation.stacked import stacked

    box = stacked(expr)[0]
    return (box.lines, box.baseline) if box.width <= width else ((to_text(expr),), 0)
