"""What a picture shows, in another language, for those who do not see it."""

from __future__ import annotations

from dataclasses import replace
from typing import Any, cast

from freebody.language.sentences import Message
from freebody.narrative.telling.catalogue import Catalogue
from freebody.present.report.blocks import Picture


def told_picture(picture: Picture, catalogue: Catalogue) -> Picture:
    """A picture with its title and description said in a language; the words of an author stay."""
    title, description = (
        catalogue.said(text) if isinstance(text, Message) else text for text in (picture.title, picture.description)
    )
    return replace(cast("Any", picture), title=title, description=description)
