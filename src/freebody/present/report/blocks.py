"""The parts of a report, without any format: text with formulas in it, numbered equations, tables, figures, steps.

A text is a tuple of pieces: plain words (never markup), formulas, and emphasised words. Mathematics stays a tree
(`Expr`) until a writer turns it into MathML, LaTeX, Typst or Unicode.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal, Protocol

from freebody.language.expression import Expr


# -- mathematics ------------------------------------------------------------------------------
@dataclass(frozen=True)
class Derivative:
    """d(of)/d(by), or with curly d; `of` may be a derivative itself: d/dt (dL/du)."""

    of: Expr | Derivative
    by: Expr
    is_partial: bool = False


@dataclass(frozen=True)
class Difference:
    """first - second, of parts that are no plain expressions."""

    first: Side
    second: Side


Side = Expr | tuple[Expr, ...] | Derivative | Difference  # a tuple is a vector, written as a column


@dataclass(frozen=True)
class Beside:
    """Parts one after the other, as a principle is written on a board: v + ω × r, det(K − ω² M). A text is the sign
    between two parts; before a part, where none stands, it belongs to it (a minus, Σ), and so does a word (det)."""

    parts: tuple[Expr | Derivative | str, ...]


WrittenSide = Side | Beside
Relation = Literal["=", "≈", ">", "≥", "<", "≤", "≠", "→", "⇒", "⇔"]


@dataclass(frozen=True)
class Formula:
    """sides[0] relations[0] sides[1] relations[1] ...; a formula may have one side only. unit: of the last side, as
    'm/s^2', empty for none."""

    sides: tuple[WrittenSide, ...]
    relations: tuple[Relation, ...] = ()
    unit: str = ""


# -- text -------------------------------------------------------------------------------------
@dataclass(frozen=True)
class Emphasis:
    """Words that stand out: as a file has them ("code"), the name of a thing ("name"), a term ("strong"), a remark
    ("soft")."""

    words: str
    look: Literal["code", "name", "strong", "soft"] = "strong"


@dataclass(frozen=True)
class Reference:
    """To an equation or a figure by its number."""

    number: int
    what: Literal["equation", "figure"] = "equation"


Piece = str | Formula | Emphasis | Reference
Text = tuple[Piece, ...]


# -- blocks -----------------------------------------------------------------------------------
@dataclass(frozen=True)
class Paragraph:
    text: Text


@dataclass(frozen=True)
class Equation:
    """One displayed formula. number: by which it is referred to; label: what stands before it, as "left, ↓:";
    note: what stands beside it; is_result: it stands out."""

    formula: Formula
    number: int | None = None
    label: str = ""
    note: Text = ()
    is_result: bool = False


@dataclass(frozen=True)
class Equations:
    """Formulas under each other, aligned at their first relation. on_request: by which the next one is computed; where
    room is dear they are shown only if that is wanted."""

    lines: tuple[Equation, ...]
    on_request: bool = False


@dataclass(frozen=True)
class Bullets:
    items: tuple[Text, ...]
    is_numbered: bool = False


@dataclass(frozen=True)
class Choices:
    """Options of a question, each with its letter."""

    items: tuple[tuple[str, Text], ...]


@dataclass(frozen=True)
class Unbroken:
    """Blocks that stay together on a page."""

    blocks: tuple[Block, ...]


@dataclass(frozen=True)
class Room:
    """Empty space on paper, to be written in. height: [cm]"""

    height: float


@dataclass(frozen=True)
class Table:
    """rows: each as long as the header, which may be left out. marks: by row, "right" or "wrong" or nothing."""

    header: tuple[Text, ...]
    rows: tuple[tuple[Text, ...], ...]
    marks: tuple[Literal["", "right", "wrong"], ...] = ()


@dataclass(frozen=True)
class Entry:
    """What is said under a label, one text or several. is_below: it belongs to the entry before."""

    label: str
    texts: tuple[Text, ...]
    is_below: bool = False


@dataclass(frozen=True)
class Entries:
    """Labelled texts: the value of an answer, its conditions, notes on it."""

    entries: tuple[Entry, ...]


class Picture(Protocol):
    """A drawing that can be written in every format. title, description: in words, for those who cannot see it."""

    @property
    def title(self) -> str: ...

    @property
    def description(self) -> str: ...

    def svg(self, *, dark: bool | None = None, is_marked: bool = False) -> str:
        """An SVG element of its own, whose colours follow a dark page unless `dark` says which to take. is_marked: with
        what its lines belong to, a body or a force, for pages that light them up"""
        ...

    def tikz(self) -> str:
        """A tikzpicture."""
        ...

    def png(self, *, dark: bool = False) -> bytes: ...

    def text(self) -> str:
        """A picture for a terminal, or nothing."""
        ...


@dataclass(frozen=True)
class Figure:
    picture: Picture
    caption: Text
    number: int


@dataclass(frozen=True)
class Figures:
    """Small figures side by side."""

    figures: tuple[Figure, ...]


@dataclass(frozen=True)
class Step:
    """A part of a worked solution that can be revealed; the hint is seen first."""

    title: Text
    hint: Text
    blocks: tuple[Block, ...]


@dataclass(frozen=True)
class Section:
    """is_apart: it begins on a page of its own, where there are pages."""

    title: Text
    blocks: tuple[Block, ...]
    level: int = 2
    is_apart: bool = False


@dataclass(frozen=True)
class Columns:
    """Two derivations side by side."""

    left: tuple[Block, ...]
    right: tuple[Block, ...]


@dataclass(frozen=True)
class Remark:
    """What a reader must not overlook: a condition, a warning, the evidence."""

    text: Text
    kind: Literal["result", "evidence", "warning"] = "result"


Block = (
    Paragraph
    | Equations
    | Bullets
    | Choices
    | Table
    | Entries
    | Figure
    | Figures
    | Step
    | Section
    | Columns
    | Unbroken
    | Room
    | Remark
)


@dataclass(frozen=True)
class Report:
    """A whole document. words: what the writers themselves have to say in the report's language: "hint", "show the
    step", "show next", "show all", "equation", "figure", "contents", "right", "wrong"; English where one is missing.
    is_summary: it is the sheet of a result, which a terminal writes closely; decimal: the sign of decimals in
    formulas."""

    title: str
    language: str
    subtitle: str
    blocks: tuple[Block, ...]
    words: dict[str, str]
    is_summary: bool = False
    decimal: Literal[".", ","] = "."

    def __repr__(self) -> str:
        """Its title and parts; the blocks are long, and `format_report` or the result itself shows them."""
        parts = [block.title for block in self.blocks if isinstance(block, Section)]
        return f"<Report {self.title!r}: {len(parts)} sections>"


def text(*pieces: Piece) -> Text:
    """A text from its pieces, without empty ones."""
    return tuple(p for p in pieces if p != "")


def equation_numbers(blocks: Sequence[Block]) -> list[int]:
    """All numbers of equations, in the order in which they appear."""
    found: list[int] = []
    for block in blocks:
        match block:
            case Equations(lines):
                found += [line.number for line in lines if line.number is not None]
            case Section() | Step() | Unbroken():
                found += equation_numbers(block.blocks)
            case Columns(left, right):
                found += equation_numbers(left) + equation_numbers(right)
            case _:
                pass
    return found
