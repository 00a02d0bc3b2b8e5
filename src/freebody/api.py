"""The system as users hold it in their hands: with every study as a method."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any, Literal, cast

from freebody.messages import Message
from freebody.studies import Studies
from freebody.system.system import System as Description

if TYPE_CHECKING:
    from freebody.studio.notebook import Widget
    from freebody.study.model_warnings import ModelWarning


class System(Studies, Description):
    """A mechanical system: immutable, from a file, from text or from Python objects."""

    __hash__ = Description.__hash__

    @property
    def warnings(self) -> tuple[ModelWarning, ...]:
        """What is legal in the model but unlikely to be meant, in the order of the file."""
        from freebody.study.model_warnings import warnings_of

        return warnings_of(self)

    def widget(self, *, until: float = 3.0, language: Literal["en", "de"] = "en", height: str = "34rem") -> Widget:
        """For notebooks: the scene with time and sliders, which changes with them; `widget.system` is the system as it
        stands then. until: [s] of motion at first; height: of the view, in units of CSS. Raises InputError where the
        extra `notebook` is not installed."""
        from freebody.errors import InputError

        try:
            from freebody.studio.notebook import Widget
        except ModuleNotFoundError as error:
            raise InputError(
                Message('the widget needs {package}; pip install "freebody[notebook]"', package=error.name or "")
            ) from None
        return Widget(self, until=until, language=language, height=height)

    def _repr_html_(self) -> str:
        """For notebooks: the title, the picture, and the parameters; words where a picture cannot be drawn."""
        from html import escape

        from freebody.errors import FreebodyError

        title = f"<p><b>{escape(self.title)}</b>{f' {escape(self.about)}' if self.about else ''}</p>"
        try:
            shown = self.picture().svg()
        except FreebodyError as error:
            shown = f"<p>{escape(str(error))}</p>"
        given = ", ".join(f"{escape(name)} = {escape(text)}" for name, text in self._given())
        asked = "".join(f"<li>{escape(question.text)}</li>" for question in self.questions)
        return title + shown + (f"<p>{given}</p>" if given else "") + (f"<ul>{asked}</ul>" if asked else "")

    def _repr_mimebundle_(self, include: object = None, exclude: object = None) -> dict[str, str]:
        """What notebooks and consoles take; they choose the form that they can show."""
        return {"text/plain": repr(self), "text/html": self._repr_html_()}

    def _given(self) -> Iterator[tuple[str, str]]:
        """The parameters, as the model writes their values."""
        written: dict[str, Any] = self.document.data.get("parameters") or {}
        for name in self.parameters:
            value = written.get(name)
            if isinstance(value, dict):
                entry = cast("dict[str, Any]", value)
                value = entry.get("value", entry.get("function"))
            if value is not None:
                yield name, str(value)
