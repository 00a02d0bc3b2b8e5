"""Words that users write and the program shows: one line of characters that every format can hold and nobody obeys.

Control characters move the cursor of a terminal, make XML invalid and end the comments of TeX; marks of direction show
a text in another order than it has (Boucher & Anderson, Trojan Source, 2021).
"""

from __future__ import annotations

import re
import unicodedata

_SPACES = re.compile("[\t\n\v\f\r\x1c-\x1f\x85\u2028\u2029]+")
_OF_DIRECTION = "\u061c\u200e\u200f\u202a\u202b\u202c\u202d\u202e\u2066\u2067\u2068\u2069"
_NO_CHARACTERS = "\ufffe\uffff"


def plain(text: str) -> str:
    """The text on one line, without control characters, marks of direction and halves of characters."""
    if text.isascii() and text.isprintable():
        return text
    return "".join(c for c in _SPACES.sub(" ", text) if _is_shown(c))


def plain_lines(text: str) -> str:
    """The same, line by line: for messages that have several lines."""
    return "\n".join(map(plain, text.split("\n")))


def shortened(text: str, most: int) -> str:
    """A text of at most so many characters, where more would fill a picture."""
    return text if len(text) <= most else text[: most - 2].rstrip() + " …"


def _is_shown(c: str) -> bool:
    return unicodedata.category(c) not in ("Cc", "Cs") and c not in _OF_DIRECTION and c not in _NO_CHARACTERS
