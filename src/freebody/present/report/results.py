"""Results as reports: the blocks that several results have."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
from typing import TYPE_CHECKING, Any

from freebody.messages import Message
from freebody.present.report.blocks import Block, Emphasis, Entries, Entry, Paragraph, Piece, Report, Table, Text

if TYPE_CHECKING:
    from freebody.assess.verdict import Verdict

_NOTE = Message("note")


def summary(title: str, blocks: Iterable[Block]) -> Report:
    """The sheet of a result."""
    return Report(title, "en", "", tuple(blocks), {}, is_summary=True)


def question_title(id: str, question: str) -> Text:
    return Emphasis(id, "code"), "  ", question


def line(*pieces: Piece) -> Paragraph:
    return Paragraph(pieces)


def remark(words: str) -> Paragraph:
    """A line below the one that it remarks on."""
    return Paragraph((Emphasis(words, "soft"),))


def entry(label: str, *texts: str | Text) -> Entry:
    return Entry(label, tuple((text,) if isinstance(text, str) else text for text in texts))


def entries(*found: Entry | None) -> list[Block]:
    """Those that have something to say, or no block if none has."""
    said = tuple(each for each in found if each is not None and each.texts)
    return [Entries(said)] if said else []


def table(rows: Iterable[Iterable[str | Text]], header: Iterable[str] = ()) -> list[Block]:
    """No block without rows."""
    cells = tuple(tuple((cell,) if isinstance(cell, str) else cell for cell in row) for row in rows)
    return [Table(tuple((word,) for word in header), cells)] if cells else []


def notes(texts: Iterable[str], label: str = _NOTE) -> list[Entry]:
    return [entry(label, text) for text in texts]


def options(choice: str | None, verdicts: Mapping[str, Verdict]) -> list[Entry]:
    """The right option, and why each other is wrong."""
    if not verdicts:
        return []
    others = [(f"({k})", _verdict(v)) for k, v in verdicts.items() if k != choice]
    right = entry(Message("right"), f"({choice})" if choice else Message("none"))
    return [right, *(Entry(letter, ((reason,),), is_below=True) for letter, reason in others)]


def _verdict(of: Verdict) -> str:
    match of.verdict:
        case "right":
            return Message("right: {reason}", reason=of.reason)
        case "wrong":
            return Message("wrong: {reason}", reason=of.reason)
        case "unreadable":
            return Message("unreadable: {reason}", reason=of.reason)


def finite(document: Any) -> Any:
    """Plain JSON: what is no finite number is null."""
    if isinstance(document, dict):
        return {str(key): finite(value) for key, value in document.items()}
    if isinstance(document, list | tuple):
        return [finite(value) for value in document]
    if hasattr(document, "tolist"):  # numbers and arrays of NumPy
        return finite(document.tolist())
    if isinstance(document, float) and not math.isfinite(document):
        return None
    return document
