"""A report as text for a terminal: formulas with drawn fractions, numbers at the right margin, aligned tables."""

from __future__ import annotations

import re
import textwrap
import unicodedata
from collections.abc import Sequence
from dataclasses import replace
from itertools import pairwise

from freebody.language.expression import Expr, n_operations
from freebody.language.notation.stacked import TextBox, flat
from freebody.language.plain_text import plain
from freebody.present.report.blocks import (
    Block,
    Emphasis,
    Entries,
    Equation,
    Equations,
    Figure,
    Formula,
    Remark,
    Report,
    Section,
    Step,
    Table,
    Text,
)
from freebody.present.report.formulas.line import LineFormulas
from freebody.present.report.formulas.rows import Row, rows, side_width
from freebody.present.report.formulas.stacked import StackedFormulas
from freebody.present.report.words import capital
from freebody.present.report.writer import BlockWriter, ReportFormat, in_its_decimals

WIDTH, SUMMARY_WIDTH, MAX_WIDTH, MIN_WIDTH = 100, 110, 120, 40
_INDENT = 4
_LINE, _STACKED = LineFormulas(), StackedFormulas()
_SIGNS = {"": " ", "right": "✓", "wrong": "✗"}
_NO_BREAK = "\u00a0"
# of summaries: columns of labels, and from where on something is told by its size
_LABEL, _LONGEST_RULE, _WIDEST = 12, 78, 100  # characters; a formula that is wider stands on one line
_LONGEST_FORMULA, _LONGEST_TEXT, _SHOWN = 70, 600, 120  # operations, some twelve terms; characters
_SHORT_BRACKETS = re.compile(r"\([^()]{1,30}\)")


@in_its_decimals
def terminal_text(report: Report, width: int | None = None, *, is_short: bool = False) -> str:
    """The report in lines of at most `width` characters; only a table, or a word too long, may be wider. Of a summary
    only labelled texts are broken; if it `is_short`, what nobody would read is told by its size."""
    if report.is_summary:
        lines = _Summary(report, max(MIN_WIDTH, width or SUMMARY_WIDTH), is_short=is_short).sheet()
    else:
        writer = _Writer(report, max(MIN_WIDTH, min(width or WIDTH, MAX_WIDTH)))
        head = [plain(report.title), *([plain(report.subtitle)] if report.subtitle else [])]
        lines = [*head, "═" * min(writer.width, max(map(columns, head))), "", *writer.blocks(report.blocks)]
    return "\n".join(line.replace(_NO_BREAK, " ").rstrip() for line in lines).rstrip("\n") + "\n"


def columns(text: str) -> int:
    """How many columns of a terminal a text takes."""
    return sum(0 if unicodedata.combining(c) else 2 if unicodedata.east_asian_width(c) in "WF" else 1 for c in text)


class _Writer(BlockWriter[list[str]]):
    sets_formulas = False

    def __init__(self, report: Report, width: int) -> None:
        super().__init__(report)
        self.width = width

    # -- blocks -----------------------------------------------------------------------------------
    def blocks(self, blocks: Sequence[Block]) -> list[str]:
        """The lines of some blocks, an empty one after each."""
        lines: list[str] = []
        for block in blocks:
            lines += [*self.block(block), ""]
        return lines

    def paragraph(self, text: Text) -> list[str]:
        return self.wrapped(self.text(text))

    def bullets(self, items: Sequence[str], *, is_numbered: bool) -> list[str]:
        leads = [f"{k:>3}. " if is_numbered else "  • " for k in range(1, len(items) + 1)]
        return [line for lead, item in zip(leads, items, strict=True) for line in self.wrapped(item, lead)]

    def figures(self, figures: Sequence[Figure]) -> list[str]:
        return [line for figure in figures for line in self.figure(figure)]

    def section(self, section: Section) -> list[str]:
        title = self.text(section.title)
        rule = "─" if section.level <= 2 else "╌"
        heading = [*self.wrapped(title), rule * min(self.width, columns(title)), ""]
        return [*heading, *self.blocks(section.blocks)][:-1]

    def beside(self, left: Sequence[Block], right: Sequence[Block]) -> list[str]:
        return [*self.blocks(left), "· · ·".center(self.width), "", *self.blocks(right)][:-1]

    def step(self, step: Step) -> list[str]:
        lines = self.wrapped(self.text(step.title), "▸ ")
        inner = _Writer(self.report, self.width - 2)
        content = inner.blocks(step.blocks)[:-1]
        return [*lines, "", *(f"  {line}" for line in content)] if content else lines

    def remark(self, text: str, kind: str) -> list[str]:
        if kind != "result":
            return self.wrapped(text, "✓ " if kind == "evidence" else "! ")
        inside = textwrap.wrap(text, self.width - 4, break_long_words=False) or [""]
        size = max(map(columns, inside))
        body = [f"│ {line}{' ' * (size - columns(line))} │" for line in inside]
        return [f"┌{'─' * (size + 2)}┐", *body, f"└{'─' * (size + 2)}┘"]

    def figure(self, figure: Figure) -> list[str]:
        caption = self.text(figure.caption)
        drawing = [plain(line).rstrip() for line in figure.picture.text().splitlines()]
        name = f"{self.word('figure')} {figure.number}"
        if any(drawing):
            return [*drawing, *self.wrapped(f"{capital(name)}: {caption}")]
        return self.wrapped(f"[{name}: {caption}]" if caption else f"[{name}]")

    def table(self, table: Table) -> list[str]:
        texts = [[self.text(cell) for cell in row] for row in (table.header, *table.rows) if row]
        if any(table.marks):
            marks = [_SIGNS[mark] for mark in table.marks] + [" "] * (len(table.rows) - len(table.marks))
            marks = [" ", *marks] if table.header else marks
            texts = [[mark, *row] for mark, row in zip(marks, texts, strict=True)]
        sizes = [max(columns(row[k]) for row in texts) for k in range(len(texts[0]))]
        words = [max((columns(w) for row in texts for w in row[k].split(" ")), default=0) for k in range(len(sizes))]
        sizes = _shrunk(sizes, words, self.width - 2 * len(sizes))
        lines: list[str] = []
        for row in texts:
            cells = [
                textwrap.wrap(cell, size, break_long_words=False) or [""] for cell, size in zip(row, sizes, strict=True)
            ]
            for k in range(max(map(len, cells))):
                parts = [cell[k] if k < len(cell) else "" for cell in cells]
                padded = [part + " " * (size - columns(part)) for part, size in zip(parts, sizes, strict=True)]
                lines.append("  ".join(padded))
            if table.header and row is texts[0]:
                lines.append("  ".join("─" * size for size in sizes))
        return lines

    # -- formulas ---------------------------------------------------------------------------------
    def equations(self, lines: Sequence[Equation]) -> list[str]:
        """Aligned at the first relation; the label before, the note behind, the number at the right margin."""
        label_size = max((columns(plain(line.label)) for line in lines), default=0)
        is_above = label_size > 0.3 * self.width
        start = _INDENT + (label_size + 2 if label_size and not is_above else 0)
        free = self.width - start - 8
        lefts = [side_width(line.formula.sides[0]) for line in lines if line.formula.relations]
        left_size = max((size for size in lefts if size <= free // 2), default=0)
        drawn = [(line, _parts(line.formula, free, left_size)) for line in lines]
        found: list[str] = []
        below = 0
        for line, parts in drawn:
            if found and below + max(box.baseline for box in parts[0]) > 1:
                found.append("")
            if is_above and line.label:
                found += self.wrapped(plain(line.label), " " * _INDENT)
            found += self._equation(replace(line, label="") if is_above else line, parts, start, left_size)
            below = max(box.below for box in parts[-1])
        return found

    def _equation(self, line: Equation, parts: list[tuple[TextBox, TextBox]], start: int, left_size: int) -> list[str]:
        label, note = plain(line.label), self.text(line.note)
        number = f"({line.number})" if line.number is not None else ""
        found: list[str] = []
        for k, (left, rest) in enumerate(parts):
            before = (" " * _INDENT + label if k == 0 else "").ljust(start + max(left_size - left.width, 0))
            box = _STACKED.beside([flat(before), left, rest])
            end = len(parts) - 1
            if k == end and note and box.width + columns(note) + 12 <= self.width:
                box, note = _STACKED.beside([box, flat(f"    {note}")]), ""
            drawn = list(box.lines)
            if k and box.baseline + max(part.below for part in parts[k - 1]) > 1:
                found.append("")
            if k == end and number:
                gap = max(2, self.width - box.width - len(number))
                drawn[box.baseline] += " " * gap + number
            found += drawn
        return [*found, *self.wrapped(note, " " * start)] if note else found

    # -- text -------------------------------------------------------------------------------------
    def words(self, text: str) -> str:
        return plain(text)

    def formula(self, formula: Formula) -> str:
        written = _LINE.formula(formula)
        # A short formula stays on one line.
        return written.replace(" ", _NO_BREAK) if len(written) <= 30 else written

    def emphasis(self, emphasis: Emphasis) -> str:
        return plain(emphasis.words)

    def equation_link(self, number: int) -> str:
        return f"({number})"

    def figure_link(self, number: int) -> str:
        return f"{self.word('figure')}{_NO_BREAK}{number}"

    def wrapped(self, text: str, lead: str = "") -> list[str]:
        indent = " " * columns(lead)
        return textwrap.wrap(
            text,
            self.width,
            initial_indent=lead,
            subsequent_indent=indent,
            break_long_words=False,
            break_on_hyphens=False,
        ) or [lead.rstrip()]


class _Summary(_Writer):
    """Writes the sheet of a result closely: labels in a column of their own, no rules, no boxes, empty lines only
    before sections and round displayed formulas. What is in a section is indented."""

    def __init__(self, report: Report, width: int, *, is_short: bool) -> None:
        super().__init__(report, width)
        self.is_short = is_short
        self.depth = 0  # of sections

    def sheet(self) -> list[str]:
        title = plain(self.report.title)
        return [title, "─" * min(len(title), _LONGEST_RULE), *self.blocks(self.report.blocks)]

    @property
    def indent(self) -> str:
        return " " * _INDENT if self.depth else ""

    def blocks(self, blocks: Sequence[Block]) -> list[str]:
        lines: list[str] = []
        for before, block in pairwise([None, *blocks]):
            assert block is not None
            after = isinstance(before, Equations | Section | Remark)
            if after or isinstance(block, Equations) or (before and isinstance(block, Section | Remark)):
                lines.append("")
            is_told = isinstance(block, Equations) and block.on_request and self.is_short
            lines += [self._told(block)] if is_told else self.block(block)  # pyrefly: ignore[bad-argument-type]
        return lines

    def _told(self, block: Equations) -> str:
        """That formulas come before the next one, which are shown on request."""
        if len(block.lines) == 1:
            return f"{' ' * 6}{self.word('by one formula')} ({self.word('where it is')})"
        told = self.word("by formulas in turn").format(n=len(block.lines))
        return f"{' ' * 6}{told} ({self.word('where they are')})"

    def section(self, section: Section) -> list[str]:
        title = ("  " if self.depth else "") + self.text(section.title)
        self.depth += 1
        content = self.blocks(section.blocks)
        self.depth -= 1
        return [title, *content]

    def paragraph(self, text: Text) -> list[str]:
        is_remark = len(text) == 1 and isinstance(text[0], Emphasis) and text[0].look == "soft"
        lead = self.indent + " " * _INDENT * is_remark
        return [lead + line for line in self.text(text).splitlines()]

    def equations(self, lines: Sequence[Equation]) -> list[str]:
        """Each with what it is equal to, at its own width."""
        found: list[str] = []
        for line in lines:
            prefix = f"{line.label} = " if line.label else "" if line.formula.relations else "= "
            n = sum(n_operations(side) for side in line.formula.sides if isinstance(side, Expr))
            if self.is_short and n > _LONGEST_FORMULA:
                box = flat(f"{self.word('a long formula').format(n=n)} ({self.word('where it is')})")
            else:
                box = _STACKED.formula(line.formula)
                box = box if box.width <= _WIDEST else flat(_LINE.formula(line.formula))
            found += [" " * 6 + row for row in _STACKED.beside([flat(prefix), box]).lines]
        return found

    def bullets(self, items: Sequence[str], *, is_numbered: bool) -> list[str]:
        return [self.indent + item for item in items]

    def remark(self, text: str, kind: str) -> list[str]:
        return [self.indent + text]

    def entries(self, entries: Entries) -> list[str]:
        lines: list[str] = []
        for entry in entries.entries:
            label = ("  " if entry.is_below else "") + plain(entry.label)
            for text in entry.texts:
                first, *others = self._broken(self.text(text))
                lead = label.ljust(_LABEL) if len(label) < _LABEL else f"{label} "
                lines += [" " * _INDENT + lead + first, *(" " * (_INDENT + _LABEL) + other for other in others)]
                label = ""
        return lines

    def _broken(self, text: str) -> list[str]:
        width = self.width - _INDENT - _LABEL
        return textwrap.wrap(self._shortened(text), width, break_long_words=False) or [""]

    def _shortened(self, text: str) -> str:
        if self.is_short and len(text) > _LONGEST_TEXT:
            told = self.word("characters").format(n=len(text))
            return f"{text[:_SHOWN]} ... ({told}; {self.word('where it is')})"
        return text

    def table(self, table: Table) -> list[str]:
        texts = [[self._shortened(self.text(cell)) for cell in row] for row in (table.header, *table.rows) if row]
        sizes = [max(columns(row[k]) for row in texts) for k in range(len(texts[0]))]
        return [
            self.indent + "   ".join(cell + " " * (size - columns(cell)) for cell, size in zip(row, sizes, strict=True))
            for row in texts
        ]

    def formula(self, formula: Formula) -> str:
        return _LINE.formula(formula)


def _parts(formula: Formula, width: int, left_size: int) -> list[tuple[TextBox, TextBox]]:
    """The rows of a formula whose left side stands in a column of that size."""
    own = side_width(formula.sides[0]) if formula.relations else 0
    width -= max(left_size - own, 0)
    return [_drawn(row, width) for row in rows(formula, width)]


def _drawn(row: Row, width: int) -> tuple[TextBox, TextBox]:
    """What stands before the relation of a row, and the rest; on lines of text where a drawing would be too wide."""
    left, right = _STACKED.left(row), _STACKED.right(row)
    if left.width + right.width <= width:
        return left, right
    left, written = flat(_LINE.left(row)), _LINE.right(row).strip()
    if left.width > width // 2:  # no room for a column beside it
        left, written = flat(""), f"{_LINE.left(row).strip()} {written}"
    written = _SHORT_BRACKETS.sub(lambda found: found[0].replace(" ", _NO_BREAK), written)
    lines = textwrap.wrap(written, max(width - left.width - 3, MIN_WIDTH // 2), subsequent_indent="  ") or [""]
    size = max(map(len, lines))
    gap = " " if left.width else ""
    return left, TextBox(tuple(f"{gap}{line.ljust(size)}" for line in lines), 0)


def _shrunk(sizes: list[int], words: list[int], width: int) -> list[int]:
    """Columns of a table made narrower, the widest first, until they fit; none is narrower than its longest word."""
    sizes = list(sizes)
    while sum(sizes) > width:
        free = [k for k, size in enumerate(sizes) if size > words[k]]
        if not free:
            break
        sizes[max(free, key=lambda k: sizes[k])] -= 1
    return sizes


ReportFormat(".txt", "text", lambda report, path, _code: [(path, terminal_text(report).encode())], place=5)
