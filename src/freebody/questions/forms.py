"""How a quantity is asked for: forms of words, each with the reader of what it names.

A kind registers a reader by `asked`; the grammar tries the forms in the order of their ranks.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Any

from freebody.questions.base import Path, Quantity
from freebody.questions.needed import Words, needed

if TYPE_CHECKING:
    from freebody.model.names import Names

NAME = r"[A-Za-z_]\w*"
POINT = PLACE = rf"{NAME}(?:\.\w+)?"
Found = dict[str, Any]  # the named groups of a pattern, a text or None
Reader = Callable[["Names", Found, Path], Quantity | None]
Fits = Callable[["Names", Found], bool]


def _always(_names: Names, _found: Found) -> bool:
    return True


@dataclass(frozen=True)
class Form:
    """One way to ask."""

    form: str
    words: str  # the pattern of the whole text, which may begin with "the"
    read: Reader
    rank: int
    example: str = ""  # a model that asks so, where the example of no kind does
    fits: Fits = _always  # whether it is meant of what is named

    @cached_property
    def pattern(self) -> re.Pattern[str]:
        return re.compile(rf"^(?:the )?(?:{self.words})$")

    @cached_property
    def needed(self) -> Words:
        """Words of which one stands wherever it is asked so."""
        return needed(self.words)

    @property
    def is_told_apart(self) -> bool:
        """Whether what is named decides that it is meant."""
        return self.fits is not _always

    def found_in(self, text: str, names: Names) -> Found | None:
        """What the words of a question name, where they ask so."""
        if self.needed and not any(word in text for word in self.needed):
            return None
        found = self.pattern.match(text)
        named = None if found is None else found.groupdict()
        return named if named is not None and self.fits(names, named) else None

    @cached_property
    def openings(self) -> tuple[str, ...]:
        """The words before `of`, as they are asked: kinetic energy, of the form kinetic | potential | total energy."""
        words = [word.strip() for word in re.split(r"[|,;]", self._sides_of_of[0])]
        last = words[-1].rpartition(" ")[2]
        return tuple(
            f"{word} {last}" if not self._takes(word) and self._takes(f"{word} {last}") else word
            for word in words
            if word and word.islower()
        )

    @property
    def is_of_body(self) -> bool:
        """Whether it asks for something of one body, or of a point of it, at an instant."""
        is_of_body = re.match(r"(?:MEASURE, or of )?(?:BODY|POINT)\b", self._sides_of_of[-1])
        return is_of_body is not None and "until" not in self.form

    @property
    def _sides_of_of(self) -> list[str]:
        without_options = re.sub(r"\[(?!of )[^]]*\]", "", self.form)
        return re.split(r" \[?of ", without_options, maxsplit=1)

    def _takes(self, opening: str) -> bool:
        return any(self.pattern.match(text) for text in (opening, f"{opening} of a"))


FORMS: list[Form] = []  # in the order in which they are tried and listed
COMMON = 50


def asked(
    form: str, pattern: str, *, rank: int = COMMON, example: str = "", fits: Fits = _always
) -> Callable[[Reader], Reader]:
    """Registers a reader of words that ask for a quantity: the form as it is listed, and the whole text's pattern. Of
    forms that fit the one with the highest rank reads. Each form has an example: that of a kind, or its own."""

    def register(read: Reader) -> Reader:
        added = Form(form, pattern, read, rank, example, fits)
        place = next((k for k, other in enumerate(FORMS) if other.rank < rank), len(FORMS))
        FORMS.insert(place, added)
        return read

    return register
