"""Results as reports: what every result can do that says itself in blocks, and the blocks that several results have."""

from __future__ import annotations

import math
from abc import abstractmethod
from collections.abc import Iterable, Mapping
from copy import copy
from pathlib import Path
from typing import TYPE_CHECKING, Any, ClassVar, Protocol, TypeVar

from freebody.messages import Message
from freebody.present.report.blocks import Block, Emphasis, Entries, Entry, Paragraph, Piece, Report, Table, Text

if TYPE_CHECKING:
    from freebody.assess.verdict import Verdict


_NOTE = Message("note")
R = TypeVar("R", bound="Result")


class Teller(Protocol):
    """Who tells a report in another language."""

    @property
    def language(self) -> str: ...

    def tell(self, report: Report) -> Report: ...
    def said(self, text: str) -> str: ...


class Result:
    """What a study finds out: it says itself in blocks, and so in every format."""

    _teller: ClassVar[Teller | None] = None  # of one that is told in another language

    def __init_subclass__(cls, **rest: Any) -> None:
        """What is found out about a system is called by it in a console, not by all of its fields: a dataclass keeps
        a `__repr__` that is there."""
        super().__init_subclass__(**rest)
        has_system = any("system" in vars(of).get("__annotations__", {}) for of in cls.__mro__)
        has_own = any("__repr__" in vars(of) for of in cls.__mro__ if issubclass(of, Result))
        if has_system and not has_own:
            cls.__repr__ = _called_by_system  # type: ignore[method-assign]

    @property
    @abstractmethod
    def report(self) -> Report:
        """The result as a report, in English unless the study knows languages itself."""

    @property
    def told(self) -> Report:
        """The report in the language in which the result is read: what every writer writes."""
        return self.report if self._teller is None else self._teller.tell(self.report)

    def in_language(self, text: str) -> str:
        """A text in the language in which the result is read: for pictures, whose words are drawn."""
        return text if self._teller is None else self._teller.said(text)

    def told_by(self: R, teller: Teller) -> R:
        """The same result, read in another language. Names and plain data stay as they are."""
        found = copy(self)
        object.__setattr__(found, "_teller", teller)  # results are frozen
        return found

    @abstractmethod
    def to_plain(self) -> dict[str, Any]:
        """The result as plain data: the JSON document of the command line."""

    @property
    def is_complete(self) -> bool:
        """Whether all that was asked has been found."""
        return True

    def to_text(self, width: int | None = None, *, is_short: bool = False) -> str:
        """For a terminal, by default 100 characters wide, a result in short 110; if it `is_short`, formulas that nobody
        would read are told by their size."""
        from freebody.present.report.formats.terminal import terminal_text

        return terminal_text(self.told, width, is_short=is_short)

    def to_html(self) -> str:
        """A page of its own, without any network."""
        from freebody.present.report.formats.html import html_page

        return html_page(self.told)

    def to_latex(self) -> str:
        """For a document of one's own."""
        from freebody.present.report.formats.latex import latex_fragment

        return latex_fragment(self.told)

    def write(self, path: str | Path) -> list[Path]:
        """Writes it as .html, .md, .tex, .pdf, .ipynb or .txt, by the suffix; returns all files written. Raises
        InputError for another suffix or a place that cannot be written."""
        from freebody.present.report.write import write_report

        return write_report(self.told, Path(path), code=self._code)

    @property
    def _code(self) -> str:
        """What the first cell of a notebook runs."""
        return ""

    def __str__(self) -> str:
        return self.to_text().rstrip()

    def _repr_html_(self) -> str:
        from freebody.present.report.formats.html import html_fragment

        return html_fragment(self.told)

    def _repr_latex_(self) -> str:
        from freebody.present.report.formats.latex import latex_fragment

        return latex_fragment(self.told)

    def _repr_mimebundle_(self, include: object = None, exclude: object = None) -> dict[str, str]:
        """What notebooks and consoles take; they choose the form that they can show."""
        return {"text/plain": str(self), "text/html": self._repr_html_(), "text/latex": self._repr_latex_()}


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


def _called_by_system(result: Any) -> str:
    return f"<{type(result).__name__} of {result.system.title!r}: print() shows it>"
