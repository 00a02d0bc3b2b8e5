"""The system as users hold it in their hands: with every study as a method."""

from __future__ import annotations

from typing import TYPE_CHECKING

from freebody.studies import Studies
from freebody.system.system import System as Description

if TYPE_CHECKING:
    from freebody.study.model_warnings import ModelWarning


class System(Studies, Description):
    """A mechanical system: immutable, from a file, from text or from Python objects."""

    __hash__ = Description.__hash__

    @property
    def warnings(self) -> tuple[ModelWarning, ...]:
        """What is legal in the model but unlikely to be meant, in the order of the file."""
        from freebody.study.model_warnings import warnings_of

        return warnings_of(self)

    def _repr_html_(self) -> str:
        """For notebooks: the title and the picture; words where a picture cannot be drawn."""
        from html import escape

        from freebody.errors import FreebodyError

        title = f"<p><b>{escape(self.title)}</b>{f' {escape(self.about)}' if self.about else ''}</p>"
        try:
            return title + self.picture().svg()
        except FreebodyError as error:
            return f"{title}<p>{escape(str(error))}</p>"
