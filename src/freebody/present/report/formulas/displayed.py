r"""Displayed formulas in LaTeX, for a document and for Markdown: rows of `aligned`-like environments.

A row is  label & left & = rest & note \tag{n}  between the alignment points of alignat*, whose columns are right and
left in turn, so that labels and notes are flush left and relations stand under each other.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

from freebody.present.report.blocks import Emphasis, Equation, Formula, Piece, Reference, Text
from freebody.present.report.formulas.latex import LatexFormulas
from freebody.present.report.formulas.rows import rows

WRITER = LatexFormulas()


@dataclass(frozen=True)
class Dialect:
    """What differs between LaTeX and the web: words as mathematics, the mark of a numbered line, and, on paper alone, a
    text above a row and what makes a long formula smaller."""

    words: Callable[[str], str]
    tag: Callable[[int], str]
    above: Callable[[Text], str] | None = None
    shrunk: Callable[[str], str] | None = None


def aligned_rows(lines: Sequence[Equation], width: int, dialect: Dialect) -> str:
    """The rows of alignat*{3}. width: [characters] of a row; where label and note do not fit beside the formula, they
    stand above it."""
    has_labels = any(line.label for line in lines)
    above = None if fits(lines, width) else dialect.above
    start = r"\quad " if has_labels and not above else ""
    found = ""
    for n, line in enumerate(lines):
        if above and (line.label or line.note):
            found += above(lead_of(line))
        broken = rows(line.formula, width)
        for k, row in enumerate(broken):
            is_first = k == 0 and not above
            label = dialect.words(line.label) if is_first and line.label else ""
            right = WRITER.right(row)
            if dialect.shrunk and row.right_width > width:
                right = dialect.shrunk(right)
            found += f"&{label}{start}&{'' if row.left is None else WRITER.left(row)} & {right}"
            if is_first and line.note:
                found += r" &&\qquad " + note(line.note, dialect.words)
            if k == 0 and line.number is not None:
                found += " " + dialect.tag(line.number)
            found += "\n" if k == len(broken) - 1 and n == len(lines) - 1 else " \\\\\n"
    return found


def fits(lines: Sequence[Equation], width: int) -> bool:
    """Is there room for labels and notes beside the formulas?"""
    sizes = [_sizes(line, width) for line in lines]
    return sum(max(column) for column in zip(*sizes, strict=True)) <= width + 12


def lead_of(line: Equation) -> Text:
    """Label and note as one text."""
    gap = (" ",) if line.label and line.note else ()
    return (*((line.label,) if line.label else ()), *gap, *line.note)


def _sizes(line: Equation, width: int) -> tuple[int, int, int]:
    """[characters] of label, formula and note"""
    formula = max(row.width for row in rows(line.formula, width))
    return len(line.label), formula, sum(len(p) if isinstance(p, str) else 12 for p in line.note)


def note(text: Text, words: Callable[[str], str]) -> str:
    """A text within mathematics."""
    return "".join(_piece(piece, words) for piece in text)


def _piece(piece: Piece, words: Callable[[str], str]) -> str:
    match piece:
        case str():
            return words(piece)
        case Formula():
            return WRITER.formula(piece)
        case Emphasis(inner, _):
            return words(inner)
        case Reference(number, _):
            return words(f"({number})")
