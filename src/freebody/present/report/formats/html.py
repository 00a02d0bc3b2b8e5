"""A report as a web page that needs nothing else: MathML, drawings as SVG, one style sheet, a font for mathematics and
a short script in it.

Steps are closed when the page opens and open by themselves (`details`); the script only adds the buttons that open
the next one or all.
"""

from __future__ import annotations

import hashlib
import re
from collections.abc import Sequence
from html import escape
from itertools import pairwise

from freebody.language.plain_text import plain
from freebody.present.assets import asset, embedded
from freebody.present.report.blocks import (
    Block,
    Columns,
    Emphasis,
    Entries,
    Equation,
    Equations,
    Figure,
    Formula,
    Paragraph,
    Report,
    Section,
    Step,
    Table,
    Text,
    Unbroken,
)
from freebody.present.report.formulas.mathml import MathMLFormulas
from freebody.present.report.formulas.rows import by_relation, formula_width, rows
from freebody.present.report.words import capital
from freebody.present.report.writer import BlockWriter, ReportFormat, in_its_decimals

_ROW_WIDTH = 64  # characters of a displayed formula before it is broken into rows
_LABEL_WIDTH = 26  # a longer label may be broken
_NUMBERED = re.compile(r"\d+\. ")  # a title with a number of its own
_PAPER_WIDTH = 80  # that fit on a page
_INLINE_WIDTH = 24  # a wider formula in a text scrolls on a narrow screen
_SIZE, _HEAD = re.compile(r'viewBox="0 0 (\d+)\S* (\d+)'), 600  # [points] of a picture; letters in which it says it
_FEW_LINES = 5
_BEFORE_A_POINT = re.compile(r"<math (?:(?!</math>).)*</math>[.,;:)]+")
_FORMULAS = MathMLFormulas()
_SIGNS = {"right": "✓", "wrong": "✗"}
_LOOKS = {
    "code": "<code>{}</code>",
    "strong": "<strong>{}</strong>",
    "soft": '<span class="soft">{}</span>',
    "name": "<i>{}</i>",
}
# notebooks have rules of their own for tables, which are more special than those of the page
_IN_NOTEBOOKS = """.freebody-report .table :is(th, td) { text-align: left; }
.freebody-report .table tbody tr { background: none; }
"""
_POLICY = "default-src 'none'; style-src 'unsafe-inline'; script-src 'unsafe-inline'; img-src data:; font-src data:"


def html_page(report: Report) -> str:
    """The text of the page."""
    has_steps = _count_steps(report.blocks) > 0
    return f"""<!DOCTYPE html>
<html lang="{escape(report.language)}">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta http-equiv="Content-Security-Policy" content="{_POLICY}">
<meta name="color-scheme" content="light dark">
<title>{_words(report.title)}</title>
<style>
{_font()}{_rules(report)}body {{ margin: 0; }}
@page {{ size: A4; margin: 15mm 18mm; }}
</style>
</head>
<body>
<div class="freebody-report page">
{_body(report, "", "main")}
</div>
{f"<script>{asset('report', 'report.js')}</script>" if has_steps else ""}
</body>
</html>
"""


def _font() -> str:
    """The font for mathematics that a page carries, so that formulas look alike on every machine."""
    address = embedded("font/woff2", "report", "font", "math.woff2")
    return f'@font-face {{ font-family: "Freebody Math"; src: url({address}) format("woff2"); }}\n'


def html_content(report: Report, prefix: str, *, is_marked: bool = False) -> str:
    """The report without any style, for a page that has `report.css`. prefix: of the names of its parts, which a page
    with several reports keeps apart; is_marked: whether lines of pictures say what they belong to."""
    return _body(report, prefix, "div", is_marked=is_marked)


def html_fragment(report: Report) -> str:
    """The report to stand within another page, as a notebook's: its style is its own, and it has no script."""
    digest = hashlib.sha256(_body(report, "", "div").encode()).hexdigest()[:8]
    style = f"<style>\n{_rules(report)}{_IN_NOTEBOOKS}</style>"
    return f'<div class="freebody-report">\n{style}\n{_body(report, f"r{digest}-", "div")}\n</div>'


@in_its_decimals
def _body(report: Report, prefix: str, element: str, *, is_marked: bool = False) -> str:
    subtitle = f'<p class="subtitle">{_words(report.subtitle)}</p>' if report.subtitle else ""
    writer = _Writer(report, prefix, is_marked=is_marked)
    content = writer.blocks(report.blocks)
    bar = writer.bar() if writer.n_steps and not prefix else ""
    heading = f"<header><h1>{_words(report.title)}</h1>{subtitle}</header>"
    return f'<{element} class="sheet">\n{heading}\n{writer.contents()}{content}{bar}\n</{element}>'


def _count_steps(blocks: Sequence[Block]) -> int:
    n = 0
    for block in blocks:
        match block:
            case Step():
                n += 1
            case Section():
                n += _count_steps(block.blocks)
            case Columns(left, right):
                n += _count_steps(left) + _count_steps(right)
            case _:
                pass
    return n


class _Writer(BlockWriter[str]):
    """Writes the blocks of one report, and counts the sections and steps that it has met."""

    def __init__(self, report: Report, prefix: str, *, is_marked: bool) -> None:
        super().__init__(report)
        self.prefix, self.is_marked = prefix, is_marked
        self.n_sections = 0
        self.n_steps = 0
        self.depth = 1

    def contents(self) -> str:
        """A list of the top sections, if there are more than two."""
        top = [block for block in self.report.blocks if isinstance(block, Section)]
        if len(top) <= 2:
            return ""
        number, items = 0, ""
        for section in top:
            number += 1
            items += f'<li><a href="#{self.prefix}section-{number}">{self.text(section.title)}</a></li>'
            number += _count_sections(section.blocks)
        label = self.word("contents")
        has_numbers = any(_NUMBERED.match(self.text(section.title)) for section in top)
        kind = ' style="list-style: none; padding-left: 0"' if has_numbers else ""
        return f'<nav class="contents" aria-label="{label}"><h2>{label}</h2><ol{kind}>{items}</ol></nav>\n'

    def bar(self) -> str:
        return (
            f'\n<div class="bar" hidden><button type="button" data-show="next" aria-keyshortcuts="n">'
            f"{self.word('show next')} <kbd>n</kbd></button>"
            f'<button type="button" data-show="all" aria-keyshortcuts="a">{self.word("show all")} <kbd>a</kbd></button>'
            "<output></output></div>"
        )

    # -- blocks -----------------------------------------------------------------------------------
    def blocks(self, blocks: Sequence[Block]) -> str:
        """What a few equations are told with stays with them on paper."""
        written = list(map(self.block, blocks))
        for k, (first, second) in enumerate(pairwise(blocks)):
            if isinstance(first, Paragraph) and isinstance(second, Equations) and len(second.lines) <= _FEW_LINES:
                written[k : k + 2] = f'<div class="led">{written[k]}', f"{written[k + 1]}</div>"
        return "\n".join(written)

    def paragraph(self, text: Text) -> str:
        """A formula that stands alone is as large as one of a derivation."""
        alone = ' class="alone"' if len(text) == 1 and isinstance(text[0], Formula) else ""
        return f"<p{alone}>{self.text(text)}</p>"

    def equations(self, lines: Sequence[Equation]) -> str:
        widest = max((row.width for line in lines for row in rows(line.formula, _ROW_WIDTH)), default=0)
        # On paper nothing scrolls: a wide formula is made smaller.
        size = f' style="--widest: {widest}"' if widest > _PAPER_WIDTH else ""
        return f'<div class="equations"{size}>{"".join(self.equation(line) for line in lines)}</div>'

    def bullets(self, items: Sequence[str], *, is_numbered: bool) -> str:
        element = "ol" if is_numbered else "ul"
        return f"<{element}>{''.join(f'<li>{item}</li>' for item in items)}</{element}>"

    def choices(self, items: Sequence[tuple[str, str]]) -> str:
        # the rows of a column are small in a browser, also where the formula is displayed
        shown = [(letter, said.replace("<mtable>", '<mtable displaystyle="true">')) for letter, said in items]
        inner = "".join(
            f'<li><span class="letter">{_words(letter)}</span> <span>{said}</span></li>' for letter, said in shown
        )
        return f'<ul class="choices">{inner}</ul>'

    def unbroken(self, blocks: Sequence[Block]) -> str:
        return f'<div class="unbroken">\n{self.blocks(blocks)}\n</div>'

    def room(self, height: float) -> str:
        return f'<div class="room" style="height: {height:g}cm"></div>'

    def figures(self, figures: Sequence[Figure]) -> str:
        return f'<div class="figures">{"".join(self.figure(figure) for figure in figures)}</div>'

    def beside(self, left: Sequence[Block], right: Sequence[Block]) -> str:
        return f'<div class="columns"><div>{self.blocks(left)}</div><div>{self.blocks(right)}</div></div>'

    def remark(self, text: str, kind: str) -> str:
        return f'<div class="remark {kind}" role="note"><p>{text}</p></div>'

    def section(self, section: Section) -> str:
        self.n_sections += 1
        name = f"{self.prefix}section-{self.n_sections}"
        before, self.depth = self.depth, max(2, min(section.level, 6))
        heading = f'<h{self.depth} id="{name}">{self.text(section.title)}</h{self.depth}>'
        content = self.blocks(section.blocks)
        self.depth = before
        apart = ' class="apart"' if section.is_apart else ""
        return f'<section{apart} aria-labelledby="{name}">\n{heading}\n{content}\n</section>'

    def step(self, step: Step) -> str:
        self.n_steps += 1
        name = f"{self.prefix}step-{self.n_steps}"
        before, self.depth = self.depth, min(self.depth + 1, 6)
        title = f'<h{self.depth} id="{name}">{self.text(step.title)}</h{self.depth}>'
        hint = f'<p class="hint"><b>{capital(self.word("hint"))}</b> {self.text(step.hint)}</p>' if step.hint else ""
        summary = f'<summary aria-describedby="{name}">{capital(self.word("show the step"))}</summary>'
        content = self.blocks(step.blocks)
        self.depth = before
        return (
            f'<section class="step" aria-labelledby="{name}">\n{title}\n{hint}\n'
            f'<details>{summary}\n<div class="inside">{content}</div></details>\n</section>'
        )

    def equation(self, equation: Equation) -> str:
        """A line of the grid: label, left side, the rest, note, number; a broken formula has further rows."""
        number, note = equation.number, self.text(equation.note)
        long = " long" if len(equation.label) > _LABEL_WIDTH else ""
        cells = f'<span class="label{long}">{_words(equation.label)}</span>' if equation.label else ""
        broken = rows(equation.formula, _ROW_WIDTH)
        for k, row in enumerate(broken):
            cells += f'<span class="left">{_math(_FORMULAS.left(row))}</span>'
            parts = [_math(_FORMULAS.right(part)) for part in by_relation(row)]
            inner = parts[0] if len(parts) == 1 else "".join(f'<span class="part">{part}</span>' for part in parts)
            cells += f'<span class="rest">{inner}</span>'
            if k == 0 and number is not None:
                where = f"#{self.prefix}eq-{number}"
                label = f"{self.word('equation')} {number}"
                cells += f'<a class="number" href="{where}" aria-label="{label}">({number})</a>'
        if note:
            cells += f'<span class="note">{note}</span>'
        anchor = f' id="{self.prefix}eq-{number}"' if number is not None else ""
        kind = "equation result" if equation.is_result else "equation"
        return f'<div class="{kind}"{anchor}>{cells}</div>'

    def entries(self, entries: Entries) -> str:
        """Labels beside their texts; a formula too wide for its column scrolls by itself, and the words stay."""
        inner = ""
        for entry in entries.entries:
            texts = "".join(f"<dd>{self.text(text)}</dd>" for text in entry.texts)
            inner += f"<div><dt>{_words(entry.label)}</dt>{texts}</div>"
        return f'<dl class="entries">{inner}</dl>'

    def table(self, table: Table) -> str:
        marked = any(table.marks)
        head = "".join(f'<th scope="col">{self.text(cell)}</th>' for cell in table.header)
        body = ""
        for k, row in enumerate(table.rows):
            mark = table.marks[k] if k < len(table.marks) else ""
            cells = "".join(f"<td>{self.text(cell)}</td>" for cell in row)
            body += f'<tr class="{mark}">{self.mark(mark) if marked else ""}{cells}</tr>'
        corner = "<td></td>" if marked else ""
        head = f"<thead><tr>{corner}{head}</tr></thead>" if head else ""
        return f'<div class="table"><table>{head}<tbody>{body}</tbody></table></div>'

    def mark(self, mark: str) -> str:
        if not mark:
            return '<td class="mark"></td>'
        return f'<td class="mark"><span role="img" aria-label="{self.word(mark)}">{_SIGNS[mark]}</span></td>'

    def figure(self, figure: Figure) -> str:
        picture = figure.picture
        label = escape(plain(f"{picture.title}. {picture.description}"), quote=True)
        lead = f"<b>{capital(self.word('figure'))} {figure.number}</b>"
        caption = f"<figcaption>{lead} {self.text(figure.caption)}</figcaption>"
        svg = picture.svg(is_marked=self.is_marked)
        drawing = f'<div class="drawing" role="img" aria-label="{label}">{svg}</div>'
        size = "".join(f' style="--wide:{wide}pt;--tall:{tall}pt"' for wide, tall in _SIZE.findall(svg[:_HEAD]))
        return f'<figure id="{self.prefix}fig-{figure.number}"{size}>{drawing}{caption}</figure>'

    # -- text -------------------------------------------------------------------------------------
    def text(self, text: Text) -> str:
        """WebKit breaks a line between a formula and the point behind it, unless they are kept together."""
        return _BEFORE_A_POINT.sub(r'<span class="kept">\g<0></span>', super().text(text))

    def words(self, text: str) -> str:
        return _words(text)

    def formula(self, formula: Formula) -> str:
        math = _math(_FORMULAS.formula(formula), is_display=False)
        return f'<span class="wide">{math}</span>' if formula_width(formula) > _INLINE_WIDTH else math

    def emphasis(self, emphasis: Emphasis) -> str:
        return _LOOKS[emphasis.look].format(_words(emphasis.words))

    def equation_link(self, number: int) -> str:
        return f'<a href="#{self.prefix}eq-{number}" aria-label="{self.word("equation")} {number}">({number})</a>'

    def figure_link(self, number: int) -> str:
        return f'<a href="#{self.prefix}fig-{number}">{self.word("figure")} {number}</a>'


def _rules(report: Report) -> str:
    """The style sheet; with what exercises need beside it, where there are any."""
    sheet = asset("report", "report.css")
    return f"{sheet}{asset('report', 'exercises.css')}" if _has_exercises(report.blocks) else sheet


def _has_exercises(blocks: Sequence[Block]) -> bool:
    return any(
        isinstance(block, Unbroken) or (isinstance(block, Section) and _has_exercises(block.blocks)) for block in blocks
    )


def _count_sections(blocks: Sequence[Block]) -> int:
    n = 0
    for block in blocks:
        match block:
            case Section():
                n += 1 + _count_sections(block.blocks)
            case Step():
                n += _count_sections(block.blocks)
            case Columns(left, right):
                n += _count_sections(left) + _count_sections(right)
            case _:
                pass
    return n


def _math(elements: str, is_display: bool = True) -> str:
    if not elements:
        return ""
    display = ' displaystyle="true"' if is_display else ""
    return f'<math xmlns="http://www.w3.org/1998/Math/MathML"{display}><mrow>{elements}</mrow></math>'


def _words(text: str) -> str:
    return escape(plain(text))


ReportFormat(".html", "a web page", lambda report, path, _code: [(path, html_page(report).encode())])
