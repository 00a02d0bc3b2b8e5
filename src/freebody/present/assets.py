"""Files that pages and reports are made of, with the colours of the theme in them."""

from __future__ import annotations

import re
from base64 import b64encode
from functools import cache
from importlib.resources import files

from freebody.present.theme import PAGES, properties

_COLORS = re.compile(r"\{\{(light|dark|print)(?:\.(\w+))?\}\}")


def asset(*path: str) -> str:
    """The text of a file."""
    return colored(files("freebody.present").joinpath(*path).read_text(encoding="utf-8"))


@cache
def embedded(kind: str, *path: str) -> str:
    """A file as the address of its own content, for pages that need nothing else. kind: its media type"""
    content = files("freebody.present").joinpath(*path).read_bytes()
    return f"data:{kind};base64,{b64encode(content).decode()}"


def colored(text: str) -> str:
    """With the colours of light pages as custom properties for `{{light}}`, and one of them for `{{light.ink}}`; there
    are dark and printed pages, too."""

    def colors(found: re.Match[str]) -> str:
        return PAGES[found[1]][found[2]] if found[2] else properties(found[1])

    return _COLORS.sub(colors, text)
