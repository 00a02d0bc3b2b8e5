"""What all writers of reports share: which part is written by which method, and how texts are put together.

A format is one file of `formats`: a `BlockWriter` and a dialect of formulas (`formulas`), and its `ReportFormat`, by
which it is found.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import ClassVar, Generic, Literal, TypeVar

from freebody.language.notation.parts import in_decimals_of
from freebody.present.report.blocks import (
    Block,
    Bullets,
    Choices,
    Columns,
    Emphasis,
    Entries,
    Equation,
    Equations,
    Figure,
    Figures,
    Formula,
    Paragraph,
    Piece,
    Reference,
    Remark,
    Report,
    Room,
    Section,
    Step,
    Table,
    Text,
    Unbroken,
)
from freebody.present.report.typeset import typeset
from freebody.present.report.words import word

Written = TypeVar("Written")  # what a block becomes: markup, or lines of a terminal


@dataclass(frozen=True)
class ReportFormat:
    """A kind of file that reports are written into.

    files: the files and what is in them, of a report, the path that was asked for, and the code that a notebook runs
    first. check: raises InputError where it cannot be written, before anything is computed."""

    suffix: str
    what: str
    files: Callable[[Report, Path, str], Sequence[tuple[Path, bytes]]]
    check: Callable[[Path], None] = lambda _path: None
    place: int = 0  # in the list that is shown

    known: ClassVar[dict[str, ReportFormat]] = {}

    def __post_init__(self) -> None:
        ReportFormat.known[self.suffix] = self


def _decimal_of(report: Report) -> str:
    return report.decimal


# for a function that writes a report
in_its_decimals = in_decimals_of(_decimal_of)


class BlockWriter(ABC, Generic[Written]):
    """Writes the blocks of one report in one format; texts and formulas in them are always strings."""

    sets_formulas: ClassVar[bool] = True  # not on a terminal, where they are as words have them

    def __init__(self, report: Report) -> None:
        self.report = report

    def word(self, key: str) -> str:
        """What the writer itself has to say."""
        return self.words(word(self.report, key))

    def block(self, block: Block) -> Written:
        match block:
            case Paragraph(text):
                return self.paragraph(text)
            case Equations(lines):
                return self.equations(lines)
            case Bullets(items, is_numbered):
                return self.bullets([self.text(item) for item in items], is_numbered=is_numbered)
            case Choices(items):
                return self.choices([(letter, self.text(said)) for letter, said in items])
            case Unbroken(blocks):
                return self.unbroken(blocks)
            case Room(height):
                return self.room(height)
            case Table():
                return self.table(block)
            case Entries():
                return self.entries(block)
            case Figure():
                return self.figure(block)
            case Figures(figures):
                return self.figures(figures)
            case Step():
                return self.step(block)
            case Section():
                return self.section(block)
            case Columns(left, right):
                return self.beside(left, right)
            case Remark(text, kind):
                return self.remark(self.text(text), kind)

    # -- blocks -----------------------------------------------------------------------------------
    @abstractmethod
    def blocks(self, blocks: Sequence[Block]) -> Written: ...

    @abstractmethod
    def paragraph(self, text: Text) -> Written: ...

    @abstractmethod
    def equations(self, lines: Sequence[Equation]) -> Written: ...

    @abstractmethod
    def bullets(self, items: Sequence[str], *, is_numbered: bool) -> Written: ...

    def choices(self, items: Sequence[tuple[str, str]]) -> Written:
        """Options, a line each; formulas in them are displayed where that can be."""
        return self.bullets([f"{self.words(letter)} {said}" for letter, said in items], is_numbered=False)

    def unbroken(self, blocks: Sequence[Block]) -> Written:
        """Blocks that stay together, where there are pages."""
        return self.blocks(blocks)

    def room(self, height: float) -> Written:
        """Empty space, where there is paper. height: [cm]"""
        return self.blocks(())

    @abstractmethod
    def table(self, table: Table) -> Written: ...

    def entries(self, entries: Entries) -> Written:
        """Labelled texts as a table without a header."""
        rows: list[tuple[Text, Text]] = []
        for entry in entries.entries:
            for k, text in enumerate(entry.texts):
                rows.append(((Emphasis(entry.label),) if entry.label and not k else (), text))
        return self.table(Table((), tuple(rows)))

    @abstractmethod
    def figure(self, figure: Figure) -> Written: ...

    @abstractmethod
    def figures(self, figures: Sequence[Figure]) -> Written:
        """Small ones side by side."""

    @abstractmethod
    def step(self, step: Step) -> Written: ...

    @abstractmethod
    def section(self, section: Section) -> Written: ...

    @abstractmethod
    def beside(self, left: Sequence[Block], right: Sequence[Block]) -> Written: ...

    @abstractmethod
    def remark(self, text: str, kind: Literal["result", "evidence", "warning"]) -> Written: ...

    # -- text -------------------------------------------------------------------------------------
    def text(self, text: Text) -> str:
        return "".join(self.piece(piece) for piece in text)

    def piece(self, piece: Piece) -> str:
        match piece:
            case str():
                return self.said(piece) if self.sets_formulas else self.words(piece)
            case Formula():
                return self.formula(piece)
            case Emphasis():
                return self.emphasis(piece)
            case Reference(number, "equation"):
                return self.equation_link(number)
            case Reference(number, _):
                return self.figure_link(number)

    def said(self, text: str) -> str:
        """Words with the formulas that they remember set as such."""
        return "".join(self.words(p) if isinstance(p, str) else self.piece(p) for p in typeset(text))

    @abstractmethod
    def words(self, text: str) -> str:
        """Plain words, in which nothing is markup."""

    @abstractmethod
    def formula(self, formula: Formula) -> str:
        """A formula within a text."""

    @abstractmethod
    def emphasis(self, emphasis: Emphasis) -> str: ...

    @abstractmethod
    def equation_link(self, number: int) -> str: ...

    @abstractmethod
    def figure_link(self, number: int) -> str: ...
