r"""A report in GitHub-flavoured Markdown with $...$ and $$...$$; drawings are files beside it, steps fold.

Words are escaped sign by sign, so that nothing in them is markup or HTML.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from dataclasses import replace
from html import escape
from pathlib import Path

from freebody.errors import InputError
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
from freebody.present.report.formulas.displayed import WRITER, Dialect, aligned_rows, fits, lead_of
from freebody.present.report.formulas.rows import rows
from freebody.present.report.latex_text import web_words
from freebody.present.report.words import capital, word
from freebody.present.report.writer import BlockWriter, ReportFormat, in_its_decimals

_ROW_WIDTH = 72
_MARKS = {"": "", "right": "✓", "wrong": "✗"}
_ALERTS = {"result": "IMPORTANT", "warning": "WARNING", "evidence": "NOTE"}
_SPECIAL = re.compile(r"([`*_\[\]|~#])")
_AT_START = re.compile(r"^(\s*\d*)((?<!\d)[-+=](?=[-+=\s]|$)|(?<=\d)[.)](?=\s|$))")


@in_its_decimals
def markdown_files(report: Report, name: str) -> tuple[str, dict[str, str]]:
    """The text of NAME.md, and the drawings by the path relative to it: NAME-figures/1.svg and so on."""
    files: dict[str, str] = {}

    def place(figure: Figure) -> str:
        path = f"{name}-figures/{figure.number}.svg"
        files[path] = figure.picture.svg()
        return f"<{path}>" if re.search(r"[\s()]", path) else path

    return MarkdownWriter(report, place).document(), files


class MarkdownWriter(BlockWriter[str]):
    """Writes the blocks of one report. place: keeps a drawing, and says where it is. has_alerts: remarks as the
    coloured boxes of GitHub, otherwise as quotations."""

    def __init__(self, report: Report, place: Callable[[Figure], str], *, has_alerts: bool = True) -> None:
        super().__init__(report)
        self.place = place
        self.has_alerts = has_alerts

    def document(self) -> str:
        return "\n\n".join([self.heading(), *map(self.block, self.report.blocks)]) + "\n"

    def heading(self) -> str:
        subtitle = f"\n\n{_words(self.report.subtitle)}" if self.report.subtitle.strip() else ""
        return f"# {_words(self.report.title)}{subtitle}"

    # -- blocks -----------------------------------------------------------------------------------
    def blocks(self, blocks: Sequence[Block]) -> str:
        return "\n\n".join(self.block(block) for block in blocks)

    def paragraph(self, text: Text) -> str:
        return self.text(text).strip()

    def bullets(self, items: Sequence[str], *, is_numbered: bool) -> str:
        leads = [f"{k}. " if is_numbered else "- " for k in range(1, len(items) + 1)]
        return "\n".join(lead + item for lead, item in zip(leads, items, strict=True))

    def figures(self, figures: Sequence[Figure]) -> str:
        return "\n\n".join(self.figure(figure) for figure in figures)

    def section(self, section: Section) -> str:
        level = max(2, min(section.level, 6))
        return f"{'#' * level} {self.text(section.title)}\n\n{self.blocks(section.blocks)}"

    def beside(self, left: Sequence[Block], right: Sequence[Block]) -> str:
        return f"{self.blocks(left)}\n\n---\n\n{self.blocks(right)}"

    def remark(self, text: str, kind: str) -> str:
        alert = f"> [!{_ALERTS[kind]}]\n" if self.has_alerts else ""
        sign = {"result": "", "warning": "**!** ", "evidence": "✓ "}[kind] if not alert else ""
        return f"{alert}> {sign}{text}"

    def step(self, step: Step) -> str:
        hint = f"\n\n*{capital(self.word('hint'))}:* {self.text(step.hint)}" if step.hint else ""
        summary = f"<details>\n<summary>{_html(capital(word(self.report, 'show the step')))}</summary>"
        return f"**{self.title(step.title)}**{hint}\n\n{summary}\n\n{self.blocks(step.blocks)}\n\n</details>"

    def title(self, text: Text) -> str:
        """A title that stands out as a whole has no words that stand out."""
        return "".join(_words(p.words) if isinstance(p, Emphasis) else self.piece(p) for p in text)

    def equations(self, lines: Sequence[Equation]) -> str:
        """One formula on one row by itself; anything more as an aligned environment."""
        if any(map(lead_of, lines)) and not fits(lines, _ROW_WIDTH):
            return "\n\n".join(self.below_words(line) for line in lines)
        if len(lines) == 1 and not lead_of(lines[0]) and len(rows(lines[0].formula, _ROW_WIDTH)) == 1:
            number = lines[0].number
            return self.displayed(WRITER.formula(lines[0].formula) + (f" {_tag(number)}" if number is not None else ""))
        body = aligned_rows(lines, _ROW_WIDTH, _DIALECT)
        return self.displayed(f"\\begin{{alignat*}}{{3}}\n{body}\\end{{alignat*}}")

    def below_words(self, line: Equation) -> str:
        """A formula whose label and note stand above it."""
        lead = self.text(lead_of(line)).strip()
        return (f"{lead}\n\n" if lead else "") + self.equations((replace(line, label="", note=()),))

    def displayed(self, formula: str) -> str:
        return f"$$\n{_math(formula)}\n$$"

    def table(self, table: Table) -> str:
        marked = any(table.marks)
        marks = [_MARKS[mark] for mark in table.marks] + [""] * (len(table.rows) - len(table.marks))
        header = [*([" "] if marked else []), *map(self.text, table.header)]
        body = [[*([marks[k]] if marked else []), *map(self.text, row)] for k, row in enumerate(table.rows)]
        header = header if table.header or not body else [" "] * len(body[0])  # there must be one
        return "\n".join("| " + " | ".join(row) + " |" for row in (header, ["---"] * len(header), *body))

    def figure(self, figure: Figure) -> str:
        label = _words(f"{figure.picture.title}. {figure.picture.description}")
        name = f"**{capital(self.word('figure'))} {figure.number}**"
        return f"![{label}]({self.place(figure)})\n\n{name} {self.text(figure.caption)}"

    # -- text -------------------------------------------------------------------------------------
    def words(self, text: str) -> str:
        return _words(text)

    def formula(self, formula: Formula) -> str:
        return f"${_math(WRITER.formula(formula))}$"

    def emphasis(self, emphasis: Emphasis) -> str:
        words, look = emphasis.words, emphasis.look
        if look == "code":
            return f"<code>{_words(words)}</code>"
        # Beside a sign, asterisks are not always read as emphasis.
        mark, element = ("**", "strong") if look == "strong" else ("*", "em")
        is_plain = words[:1].isalnum() and words[-1:].isalnum()
        return f"{mark}{_words(words)}{mark}" if is_plain else f"<{element}>{_words(words)}</{element}>"

    def equation_link(self, number: int) -> str:
        return f"({number})"

    def figure_link(self, number: int) -> str:
        return f"{self.word('figure')} {number}"


def _words(text: str) -> str:
    """Signs with a meaning are escaped; $ and the backslash stand by their names, since notebooks look for mathematics
    before they look at backslashes."""
    text = escape(plain(text), quote=False).replace("\\", "&bsol;").replace("$", "&dollar;")
    text = _SPECIAL.sub(r"\\\1", text)
    # What would make a line an item of a list, a rule or a heading.
    return _AT_START.sub(r"\1\\\2", text)


def _html(text: str) -> str:
    return escape(plain(text)).replace("$", "&dollar;")


def _math(formula: str) -> str:
    r"""Without signs that Markdown or HTML would take for theirs: <, > and the bar of a table."""
    formula = formula.replace(r"\left|", r"\left\vert ").replace(r"\right|", r"\right\vert ")
    return re.sub(r"< *", r"\\lt ", re.sub(r"> *", r"\\gt ", formula)).strip()


def _tag(number: int) -> str:
    return rf"\tag{{{number}}}"


_DIALECT = Dialect(web_words, _tag)


def _files(report: Report, path: Path, _code: str) -> Sequence[tuple[Path, bytes]]:
    text, drawings = markdown_files(report, path.stem)
    return [(path, text.encode()), *((path.parent / name, svg.encode()) for name, svg in drawings.items())]


def _check(path: Path) -> None:
    folder = path.with_name(f"{path.stem}-figures")
    if folder.exists() and not folder.is_dir():
        raise InputError(f"{folder}: the drawings go into a folder of this name, but there is a file. Rename one")


ReportFormat(".md", "Markdown, with the drawings in a folder beside it", _files, _check, place=1)
