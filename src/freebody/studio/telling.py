"""Messages in the language of the page."""

from __future__ import annotations

from functools import cache
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from freebody.narrative.telling.catalogue import Catalogue


def told(message: str, language: str) -> str:
    """A message in a language; as it is where there are no words of it."""
    return message if language == "en" else _catalogue(language).said(message)


def decimal_of(language: str) -> str:
    """The sign of decimals."""
    return "." if language == "en" else _catalogue(language).decimal


@cache
def _catalogue(language: str) -> Catalogue:
    from freebody.narrative.telling.catalogue import Catalogue  # models in English are shown without it

    return Catalogue(language)
