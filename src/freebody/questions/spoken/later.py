"""How much later one thing happens than another: by how much the time of the one is after that of the other.

    how much later does the block return after it has stopped        time between EVENT and EVENT

Both are asked for by themselves, as times. Patterns: `later` among the contexts of a language.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from typing import TYPE_CHECKING

from freebody.questions.spoken.lexicon import contexts, languages

if TYPE_CHECKING:
    from freebody.model.names import Names

_TIME = re.compile(r"time when (?P<event>[^;]+)")
_LAST = re.compile(r"time between (?P<first>[^;]+) and (?P<last>[^;]+)")


def later(_names: Names, text: str, said: Callable[[str], str]) -> str:
    """The grammar for a text that asks how much later something is; nothing where it does not. said: the words of the
    grammar for a text."""
    for language in languages():
        pattern = contexts(language).get("later")
        found = None if pattern is None else re.fullmatch(pattern, text.strip(" ?.!"), re.IGNORECASE)
        if found is None:
            continue
        before, after = (said(contexts(language)[key].format(**found.groupdict())) for key in ("earlier", "later_on"))
        begin = _TIME.fullmatch(before)
        end = _TIME.fullmatch(after) or _LAST.fullmatch(after)
        if begin is None or end is None:
            return ""
        if "first" in end.groupdict():  # what is between the same event and the later one already
            return after if end["first"] == begin["event"] else f"time between {begin['event']} and {end['last']}"
        return f"time between {begin['event']} and {end['event']}"
    return ""
