r"""Texts and blocks as the HTML that learning platforms keep: plain elements without classes, scripts or styles.

What a platform does its own way is a `Dialect`: formulas in LaTeX between marks of its own, or in MathML. All elements
are closed, so that what is written is well-formed XML as well, and a reader gets it back sign by sign.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from html import escape

from freebody.language.plain_text import plain
from freebody.present.report.blocks import (
    Block,
    Emphasis,
    Equation,
    Figure,
    Formula,
    Report,
    Section,
    Step,
    Table,
    Text,
)
from freebody.present.report.formulas.displayed import WRITER, aligned_rows, fits, lead_of
from freebody.present.report.formulas.displayed import Dialect as Rows
from freebody.present.report.formulas.mathml import MathMLFormulas
from freebody.present.report.formulas.rows import rows
from freebody.present.report.latex_text import web_words
from freebody.present.report.words import capital
from freebody.present.report.writer import BlockWriter, in_its_decimals

_ROW_WIDTH = 72  # characters of a displayed formula before it is broken into rows
_SIGNS = {"right": "✓", "wrong": "✗", "": ""}
_LOOKS = {"code": "code", "strong": "strong", "soft": "span", "name": "em"}
_MATHML = MathMLFormulas()
_SPACES = re.compile(r"\s*\n\s*")


@dataclass(frozen=True)
class Dialect:
    """How a platform writes. words: plain words, escaped; formula: within a text; displayed: equations under each
    other; heading: the level of the highest heading."""

    formula: Callable[[Formula], str]
    displayed: Callable[[Sequence[Equation], Callable[[Text], str]], str]
    words: Callable[[str], str] = lambda text: escape(plain(text))
    heading: int = 3


# -- formulas ---------------------------------------------------------------------------------
def latex(formula: Formula) -> str:
    """A formula within a text, in LaTeX that stands in HTML."""
    return _in_html(WRITER.formula(formula))


def latex_dialect(
    inline: tuple[str, str], displayed: tuple[str, str], words: Callable[[str], str] | None = None
) -> Dialect:
    r"""Formulas in LaTeX between marks, as \( and \): for platforms that show it by MathJax or KaTeX."""

    def formula(one: Formula) -> str:
        return f"{inline[0]}{latex(one)}{inline[1]}"

    def lines(equations: Sequence[Equation], text: Callable[[Text], str]) -> str:
        """One formula on one row by itself; anything more aligned; labels above where they have no room."""
        if any(map(lead_of, equations)) and not fits(equations, _ROW_WIDTH):
            return "".join(
                (f"<p>{text(lead_of(one)).strip()}</p>" if lead_of(one) else "")
                + lines((replace(one, label="", note=()),), text)
                for one in equations
            )
        first = equations[0]
        if len(equations) == 1 and not lead_of(first) and len(rows(first.formula, _ROW_WIDTH)) == 1:
            tag = "" if first.number is None else f" {_tag(first.number)}"
            body = WRITER.formula(first.formula) + tag
        else:
            body = f"\\begin{{alignat*}}{{3}} {aligned_rows(equations, _ROW_WIDTH, _ROWS)}\\end{{alignat*}}"
        return f"<p>{displayed[0]}{_in_html(body)}{displayed[1]}</p>"

    return Dialect(formula, lines) if words is None else Dialect(formula, lines, words)


def _in_html(formula: str) -> str:
    r"""Without signs that HTML would take for its own, but for the & of aligned rows, which stands by its name."""
    formula = re.sub(r"< *", r"\\lt ", re.sub(r"> *", r"\\gt ", formula))
    return _SPACES.sub(" ", escape(formula, quote=False)).strip()


def _tag(number: int) -> str:
    return rf"\tag{{{number}}}"


_ROWS = Rows(web_words, _tag)


def _mathml(formula: Formula) -> str:
    return f'<math xmlns="http://www.w3.org/1998/Math/MathML"><mrow>{_MATHML.formula(formula)}</mrow></math>'


def _mathml_lines(equations: Sequence[Equation], text: Callable[[Text], str]) -> str:
    """A paragraph for each equation: label, formula, number, note."""
    found = ""
    for one in equations:
        label = f"{escape(plain(one.label))} " if one.label else ""
        number = "" if one.number is None else f" ({one.number})"
        note = f" {text(one.note)}" if one.note else ""
        found += f"<p>{label}{_mathml(one.formula)}{number}{note}</p>"
    return found


MATHML = Dialect(_mathml, _mathml_lines)


# -- blocks -----------------------------------------------------------------------------------
@in_its_decimals
def _written(report: Report, dialect: Dialect, image: Callable[[Figure], str]) -> str:
    return MarkupWriter(report, dialect, image).blocks(report.blocks)


class Markup:
    """Writes the texts and blocks of a bank in one dialect.

    image: the element of a figure, which keeps the drawing where the platform finds it."""

    def __init__(self, language: str, words: dict[str, str], dialect: Dialect, image: Callable[[Figure], str]) -> None:
        self.language, self.report_words, self.dialect, self.image = language, words, dialect, image

    def blocks(self, blocks: Sequence[Block]) -> str:
        report = Report("", self.language, "", tuple(blocks), self.report_words)
        return _written(report, self.dialect, self.image)

    def text(self, text: Text) -> str:
        report = Report("", self.language, "", (), self.report_words)
        return MarkupWriter(report, self.dialect, self.image).text(text)


class MarkupWriter(BlockWriter[str]):
    """Writes the blocks of one report."""

    def __init__(self, report: Report, dialect: Dialect, image: Callable[[Figure], str]) -> None:
        super().__init__(report)
        self.dialect, self.image = dialect, image
        self.depth = dialect.heading

    def blocks(self, blocks: Sequence[Block]) -> str:
        return "".join(self.block(block) for block in blocks)

    def paragraph(self, text: Text) -> str:
        return f"<p>{self.text(text)}</p>"

    def equations(self, lines: Sequence[Equation]) -> str:
        return self.dialect.displayed(lines, self.text)

    def bullets(self, items: Sequence[str], *, is_numbered: bool) -> str:
        element = "ol" if is_numbered else "ul"
        return f"<{element}>{''.join(f'<li>{item}</li>' for item in items)}</{element}>"

    def table(self, table: Table) -> str:
        marks = [*table.marks, *[""] * (len(table.rows) - len(table.marks))]
        marked = any(table.marks)
        head = "".join(f"<th>{self.text(cell)}</th>" for cell in table.header)
        head = f"<thead><tr>{'<td></td>' if marked else ''}{head}</tr></thead>" if head else ""
        body = ""
        for row, mark in zip(table.rows, marks, strict=True):
            cells = "".join(f"<td>{self.text(cell)}</td>" for cell in row)
            body += f"<tr>{f'<td>{_SIGNS[mark]}</td>' if marked else ''}{cells}</tr>"
        return f"<table>{head}<tbody>{body}</tbody></table>"

    def figure(self, figure: Figure) -> str:
        caption = f"<strong>{capital(self.word('figure'))} {figure.number}</strong> {self.text(figure.caption)}"
        return f"<p>{self.image(figure)}</p><p>{caption}</p>"

    def figures(self, figures: Sequence[Figure]) -> str:
        return self.blocks(figures)

    def step(self, step: Step) -> str:
        return self._headed(step.title, step.blocks)

    def section(self, section: Section) -> str:
        return self._headed(section.title, section.blocks)

    def _headed(self, title: Text, blocks: Sequence[Block]) -> str:
        before, self.depth = self.depth, min(self.depth + 1, 6)
        content = self.blocks(blocks)
        self.depth = before
        return f"<h{before}>{self.text(title)}</h{before}>{content}"

    def beside(self, left: Sequence[Block], right: Sequence[Block]) -> str:
        return self.blocks((*left, *right))

    def remark(self, text: str, kind: str) -> str:
        return f"<p><strong>{text}</strong></p>" if kind == "warning" else f"<p>{text}</p>"

    # -- text -------------------------------------------------------------------------------------
    def words(self, text: str) -> str:
        return self.dialect.words(text)

    def formula(self, formula: Formula) -> str:
        return self.dialect.formula(formula)

    def emphasis(self, emphasis: Emphasis) -> str:
        element = _LOOKS[emphasis.look]
        return f"<{element}>{self.words(emphasis.words)}</{element}>"

    def equation_link(self, number: int) -> str:
        return f"({number})"

    def figure_link(self, number: int) -> str:
        return f"{self.word('figure')} {number}"


def described(figure: Figure) -> str:
    """The words of a figure for those who cannot see it, as the value of an attribute."""
    return escape(plain(f"{figure.picture.title}. {figure.picture.description}"), quote=True)


def plain_words(markup: str) -> str:
    """What is left of HTML without its elements."""
    return " ".join(re.sub(r"<[^>]*>", " ", markup).split())
