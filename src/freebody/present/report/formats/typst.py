"""A report in Typst, and as a PDF by the package `typst`, which has the compiler in it.

Words stand in strings, so that nothing in them is markup. Displayed formulas are lines of text: the left sides in boxes
of the widest one's width, the numbers pushed to the right.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import replace
from importlib import import_module
from importlib.util import find_spec
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

from freebody.errors import InputError
from freebody.language.plain_text import plain
from freebody.present.assets import asset
from freebody.present.report.blocks import (
    Block,
    Columns,
    Emphasis,
    Equation,
    Equations,
    Figure,
    Figures,
    Formula,
    Paragraph,
    Report,
    Section,
    Step,
    Table,
    Text,
)
from freebody.present.report.formulas.rows import formula_width, rows, text_width
from freebody.present.report.formulas.typst import TypstFormulas, quoted
from freebody.present.report.words import capital, word
from freebody.present.report.writer import BlockWriter, ReportFormat, in_its_decimals

_ROW_WIDTH, _BESIDE_WIDTH, _COLUMN_WIDTH = 68, 42, 30  # characters of a displayed formula
_LED = 1.65  # of these, how long words with a formula behind them may be: letters are narrower than signs
_FORMULAS = TypstFormulas()


@in_its_decimals
def typst_files(report: Report) -> tuple[str, dict[str, str]]:
    """The text of a .typ file, and the drawings by the names by which it reads them."""
    writer = _Writer(report)
    style = asset("report", "report.typ")
    head = f"#show: sheet.with({_words(report.title)}, {_words(report.subtitle)}, {quoted(_language(report))})"
    return f"{style}\n{head}\n\n{writer.blocks(report.blocks)}\n", writer.drawings


def pdf_bytes(report: Report) -> bytes:
    """A PDF. Raises InputError if the package typst is not installed."""
    check_typst()
    typst: Any = import_module("typst")
    source, drawings = typst_files(report)
    with TemporaryDirectory() as folder:
        for name, svg in drawings.items():
            Path(folder, name).write_text(svg, encoding="utf-8")
        main = Path(folder, "report.typ")
        main.write_text(source, encoding="utf-8")
        return bytes(typst.compile(str(main)))


def check_typst() -> None:
    if find_spec("typst") is None:
        raise InputError('a PDF needs the package typst: pip install "freebody[report]"')


def _language(report: Report) -> str:
    found = re.match("[a-z]{2,3}", report.language)
    return found[0] if found else "en"


class _Writer(BlockWriter[str]):
    """Writes the blocks of one report and keeps its drawings."""

    def __init__(self, report: Report) -> None:
        super().__init__(report)
        self.width = _ROW_WIDTH
        self.drawings: dict[str, str] = {}
        self.labels: set[str] = set()
        self.run_in, self.run_in_width = "", 0  # a title that stands before the next words

    def word(self, key: str) -> str:
        """As it is: it becomes a string of Typst together with what stands beside it."""
        return word(self.report, key)

    # -- blocks -----------------------------------------------------------------------------------
    def blocks(self, blocks: Sequence[Block]) -> str:
        found: list[str] = []
        waiting = list(blocks)
        while waiting:
            n = _n_beside(waiting)
            if n:
                found.append(self._beside_figure(waiting[:n]))
            else:
                n = next((k for k in range(1, len(waiting)) if _n_beside(waiting[k:])), len(waiting))
                found.append(self.flowing(waiting[:n]))
            waiting = waiting[n:]
        return "\n\n".join(found)

    def _beside_figure(self, blocks: Sequence[Block]) -> str:
        """A figure, and beside it what else stands in its part and in those after it."""
        head, *others = blocks
        assert isinstance(head, Section | Step)
        figure, *own = head.blocks
        before, self.width = self.width, _BESIDE_WIDTH
        left = self.flowing((replace(head, blocks=tuple(own)), *others))
        self.width = before
        assert isinstance(figure, Figure)
        above = "#v(0.35em)\n" if isinstance(head, Section) else ""  # which a heading loses at the top of its cell
        return f"{above}#wrapped({quoted(_file_of(figure))})[\n{self.block(figure)}\n][\n{left}\n]"

    def flowing(self, blocks: Sequence[Block]) -> str:
        """Under each other; a short formula stands on the line of the words that lead to it."""
        found: list[str] = []
        waiting: Paragraph | None = None
        for block in blocks:
            if waiting is not None and isinstance(block, Equations) and self._is_led(waiting, block.lines[0]):
                found.append(self._led(waiting, block.lines[0]))
                waiting, rest = None, block.lines[1:]
                found += [self.equations(rest)] if rest else []
                continue
            found += [self.block(waiting)] if waiting is not None else []
            waiting = block if isinstance(block, Paragraph) else None
            found += [] if waiting is not None else [self.block(block)]
        found += [self.block(waiting)] if waiting is not None else []
        return "\n\n".join(found)

    def _is_led(self, words: Paragraph, line: Equation) -> bool:
        if line.label or line.note or len(rows(line.formula, self.width)) > 1:
            return False
        said = self.run_in_width + text_width(words.text)
        return said + formula_width(line.formula) < _LED * self.width

    def _led(self, words: Paragraph, line: Equation) -> str:
        (row,) = rows(line.formula, self.width)
        shown = f"{_FORMULAS.left(row)} {_FORMULAS.right(row)}"
        return f"#led([{self.paragraph(words.text)}], {_displayed(shown)}, {self.number(line)})"

    def paragraph(self, text: Text) -> str:
        lead, self.run_in, self.run_in_width = self.run_in, "", 0
        return lead + self.text(text)

    def equations(self, lines: Sequence[Equation]) -> str:
        return f"#equations(({''.join(self.equation(line) + ', ' for line in lines)}))"

    def bullets(self, items: Sequence[str], *, is_numbered: bool) -> str:
        return f"#{'enum' if is_numbered else 'list'}({', '.join(f'[{item}]' for item in items)})"

    def choices(self, items: Sequence[tuple[str, str]]) -> str:
        inner = "".join(f"([{self.words(letter)}], [{said}]), " for letter, said in items)
        return f"#choices(({inner}))"

    def unbroken(self, blocks: Sequence[Block]) -> str:
        return f"#block(breakable: false, width: 100%, above: 1.1em)[\n{self.blocks(blocks)}\n]"

    def room(self, height: float) -> str:
        return f"#v({height:g}cm)"

    def figures(self, figures: Sequence[Figure]) -> str:
        return f"#beside({''.join(f'[{self.figure(figure)}], ' for figure in figures)})"

    def step(self, step: Step) -> str:
        """A part with its title, which runs in where words follow."""
        first, *rest = step.blocks or (Paragraph(()),)
        if not isinstance(first, Paragraph):
            return f"#step([{self.text(step.title)}])[\n{self.blocks(step.blocks)}\n]"
        lead = Paragraph((*(("\u2003",) if first.text else ()), *first.text))
        self.run_in, self.run_in_width = f"#strong[{self.text(step.title)}]", text_width(step.title)
        return f"#block(above: 0.85em)[\n{self.flowing((lead, *rest))}\n]"

    def section(self, section: Section) -> str:
        level = max(1, section.level - 1)
        page = "#pagebreak(weak: true)\n" if section.is_apart else ""
        return f"{page}#heading(level: {level})[{self.text(section.title)}]\n\n{self.blocks(section.blocks)}"

    def beside(self, left: Sequence[Block], right: Sequence[Block]) -> str:
        before, self.width = self.width, _COLUMN_WIDTH
        sides = [self.blocks(left), self.blocks(right)]
        self.width = before
        return f"#two-columns[\n{sides[0]}\n][\n{sides[1]}\n]"

    def remark(self, text: str, kind: str) -> str:
        return f'#remark("{kind}")[{text}]'

    def equation(self, equation: Equation) -> str:
        broken = rows(equation.formula, self.width)
        parts = "".join(f"({_displayed(_FORMULAS.left(row))}, {_displayed(_FORMULAS.right(row))}), " for row in broken)
        label = f"[{self.words(equation.label)}]" if equation.label else "none"
        note = f"[{self.text(equation.note)}]" if equation.note else "none"
        return f"(rows: ({parts}), label: {label}, note: {note}, number: {self.number(equation)})"

    def number(self, equation: Equation) -> str:
        if equation.number is None:
            return "none"
        return f"[({equation.number}) {self.anchor(f'eq-{equation.number}')}]"

    def anchor(self, name: str) -> str:
        """A label to be linked to, at the first place that has this name."""
        if name in self.labels:
            return ""
        self.labels.add(name)
        return f"#metadata(none)<{name}>"

    def link(self, name: str, text: str) -> str:
        return f"#goto({quoted(name)}, {_words(text)});"

    def table(self, table: Table) -> str:
        marks = [f'"{mark}"' for mark in table.marks] + ['""'] * (len(table.rows) - len(table.marks))
        header = "".join(f"[{self.text(cell)}], " for cell in table.header)
        body = "".join(f"({''.join(f'[{self.text(cell)}], ' for cell in row)}), " for row in table.rows)
        return f"#grid-of(({header}), ({body}), ({''.join(mark + ', ' for mark in marks) if any(table.marks) else ''}))"

    def figure(self, figure: Figure) -> str:
        name = _file_of(figure)
        self.drawings[name] = _still(figure.picture.svg())
        described = _words(f"{figure.picture.title}. {figure.picture.description}")
        lead = _words(f"{capital(self.word('figure'))} {figure.number}")
        where = self.anchor(f"fig-{figure.number}")
        return f"#drawing({quoted(name)}, {described}, {lead})[{self.text(figure.caption)}] {where}"

    # -- text -------------------------------------------------------------------------------------
    def words(self, text: str) -> str:
        return f"#{_words(text)};"

    def formula(self, formula: Formula) -> str:
        written = _FORMULAS.formula(formula)
        # A column within a text would be set in small letters.
        is_column = any(isinstance(side, tuple) for side in formula.sides)
        written = f"$display({written})$" if is_column else f"${written}$"
        return f"#alone({written});" if formula_width(formula) > self.width else written

    def emphasis(self, emphasis: Emphasis) -> str:
        return f"#{emphasis.look}({_words(emphasis.words)});"

    def equation_link(self, number: int) -> str:
        return self.link(f"eq-{number}", f"({number})")

    def figure_link(self, number: int) -> str:
        return self.link(f"fig-{number}", f"{self.word('figure')} {number}")


def _n_beside(blocks: Sequence[Block]) -> int:
    """How many parts stand beside the figure with which the first one begins; none where it does not."""
    head = blocks[0]
    if not isinstance(head, Section | Step) or not head.blocks or not isinstance(head.blocks[0], Figure):
        return 0
    if isinstance(head, Step):
        return min(3, len(blocks)) if not _has_figure(blocks[1:3]) else 1
    n = 1
    while n < len(blocks) and isinstance(blocks[n], Section) and not _has_steps(blocks[n]):
        n += 1
    return n


def _has_steps(block: Block) -> bool:
    return isinstance(block, Section) and any(isinstance(inner, Step | Columns) for inner in block.blocks)


def _has_figure(blocks: Sequence[Block]) -> bool:
    return any(isinstance(inner, Figure | Figures) for b in blocks if isinstance(b, Step) for inner in b.blocks)


def _file_of(figure: Figure) -> str:
    return f"{figure.number}.svg"


def _words(text: str) -> str:
    return quoted(plain(text))


def _displayed(formula: str) -> str:
    return f"$display({formula})$"


def _still(svg: str) -> str:
    """A drawing as it is on white paper: rules for dark screens left out, variables by what they fall back to."""
    light = re.sub(r"@media[^{]*\{(?:[^{}]|\{[^{}]*\})*\}", "", svg)
    return re.sub(r"var\(\s*--[\w-]+\s*,\s*([^()]+)\)", r"\1", light)


def _files(report: Report, path: Path, _code: str) -> Sequence[tuple[Path, bytes]]:
    return [(path, pdf_bytes(report))]


ReportFormat(".pdf", "PDF", _files, lambda _path: check_typst(), place=3)
