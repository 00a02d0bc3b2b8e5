"""What every result can do that says itself in blocks: it is read, written and shown in every format."""

from __future__ import annotations

from abc import abstractmethod
from copy import copy
from pathlib import Path
from typing import TYPE_CHECKING, Any, ClassVar, Protocol, TypeVar

if TYPE_CHECKING:
    from freebody.present.report.blocks import Report  # a motion that is looked at is told in none

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


def _called_by_system(result: Any) -> str:
    return f"<{type(result).__name__} of {result.system.title!r}: print() shows it>"
