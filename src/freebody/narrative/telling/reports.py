"""The report of a result in another language: every text of it as the catalogue says it, all formulas as they are.

Results say themselves in English, in messages and in words of the author; where a report is handed to a writer is the
only place where they are told in another language.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, replace

from freebody.language.notation import Stated
from freebody.language.sentences import Message
from freebody.model.style import HouseStyle
from freebody.narrative.telling.catalogue import Catalogue
from freebody.narrative.telling.house import in_style
from freebody.narrative.telling.pictures import told_picture
from freebody.present.report.blocks import (
    Block,
    Bullets,
    Choices,
    Columns,
    Emphasis,
    Entries,
    Entry,
    Equation,
    Equations,
    Figure,
    Figures,
    Paragraph,
    Piece,
    Remark,
    Report,
    Section,
    Step,
    Table,
    Text,
    Unbroken,
)


@dataclass(frozen=True)
class ReportTeller:
    """Tells reports in a language."""

    language: str

    def tell(self, report: Report) -> Report:
        catalogue = Catalogue(self.language)
        words = _Words(catalogue)
        told = replace(
            report,
            title=words.said(report.title),
            subtitle=words.said(report.subtitle),
            language=self.language,
            words={**catalogue.report_words, **report.words},
            blocks=words.blocks(report.blocks),
        )
        return in_style(told, HouseStyle(), catalogue.decimal)

    def said(self, text: str) -> str:
        """A text that is drawn."""
        return Catalogue(self.language).said(text)


class _Words:
    def __init__(self, catalogue: Catalogue) -> None:
        self.catalogue = catalogue

    def said(self, words: str) -> str:
        """With the formulas that a message remembers still in it."""
        if not isinstance(words, (Message, Stated)):
            return self.catalogue.said(words)
        return Message.of_parts(self.catalogue.parts(words))

    def blocks(self, blocks: Iterable[Block]) -> tuple[Block, ...]:
        return tuple(self.block(block) for block in blocks)

    def block(self, block: Block) -> Block:
        match block:
            case Paragraph(text) | Remark(text):
                return replace(block, text=self.text(text))
            case Equations(lines):
                return replace(block, lines=tuple(self.equation(line) for line in lines))
            case Bullets(items):
                return replace(block, items=self.texts(items))
            case Choices(items):
                return Choices(tuple((letter, self.text(text)) for letter, text in items))
            case Table(header, rows):
                return replace(block, header=self.texts(header), rows=tuple(self.texts(row) for row in rows))
            case Entries(entries):
                return Entries(tuple(self.entry(entry) for entry in entries))
            case Figure():
                return self.figure(block)
            case Figures(figures):
                return Figures(tuple(self.figure(figure) for figure in figures))
            case Step(title, hint, blocks):
                return Step(self.text(title), self.text(hint), self.blocks(blocks))
            case Section(title, blocks):
                return replace(block, title=self.text(title), blocks=self.blocks(blocks))
            case Columns(left, right):
                return Columns(self.blocks(left), self.blocks(right))
            case Unbroken(blocks):
                return Unbroken(self.blocks(blocks))
            case _:
                return block

    def equation(self, line: Equation) -> Equation:
        return replace(line, label=self.said(line.label), note=self.text(line.note))

    def entry(self, entry: Entry) -> Entry:
        return replace(entry, label=self.said(entry.label), texts=self.texts(entry.texts))

    def figure(self, figure: Figure) -> Figure:
        return replace(figure, picture=told_picture(figure.picture, self.catalogue), caption=self.text(figure.caption))

    def texts(self, texts: Iterable[Text]) -> tuple[Text, ...]:
        return tuple(self.text(text) for text in texts)

    def text(self, text: Text) -> Text:
        return tuple(self.piece(piece) for piece in text)

    def piece(self, piece: Piece) -> Piece:
        if isinstance(piece, Emphasis):
            return piece if piece.look in ("code", "name") else replace(piece, words=self.said(piece.words))
        return self.said(piece) if isinstance(piece, str) else piece
