"""Questions after the rest that lasts: until it stops for good, where it finally comes to rest.

What turns back is at rest for an instant each time; the grammar calls the last one `comes to rest for good`.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING

from freebody.language.sentences import Message
from freebody.questions.spoken import rubbing
from freebody.questions.spoken.lexicon import contexts, languages
from freebody.questions.spoken.unread import AskedT, Unread, read_quietly

if TYPE_CHECKING:
    from freebody.model.names import Names

_STOPS = re.compile(r"\b(?:stops|comes to rest)$")
_AT_REST = re.compile(r" (?:when|until) (?P<who>it|[\w.]+) (?:stops|comes to rest)$| (?:when|until) rate\(")


def without_for_good(text: str) -> str | None:
    """A question without the words that mean the last of several rests; None where there are none."""
    for language in languages():
        said = re.sub(contexts(language)["for_good"], "", text, flags=re.IGNORECASE)
        if said != text:
            return " ".join(said.split())
    return None


def at_last_rest(
    names: Names, asked: Sequence[tuple[AskedT, str]], read: Callable[[str], AskedT | None]
) -> list[tuple[AskedT, str]]:
    """The same of the rest that lasts. asked: of a rest, or of something else that has none."""
    found: list[tuple[AskedT, str]] = []
    for one, words in asked:
        put = _STOPS.sub("comes to rest for good", words)
        each = read_quietly(names, put, read)
        if put != words and not isinstance(each, Unread):
            found += [*zip(each, (put,), strict=True)]
        elif _AT_REST.search(words) and rubbing.is_rough(names):
            told = Message("ask when it comes to rest for good, as in: time until it comes to rest for good")
            names.problem(told, "find")
            return []
        else:
            found.append((one, words))
    return found
