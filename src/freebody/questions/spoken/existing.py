"""For which values there is an equilibrium: what stands beside its formula tells that."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

from freebody.language.sentences import Message
from freebody.questions.spoken import rubbing
from freebody.questions.spoken.lexicon import contexts, languages

if TYPE_CHECKING:
    from freebody.model.names import Names


_WORD = re.compile(r"[^\W\d]\w*")


def for_which_there_is_one(names: Names, text: str) -> str | None:
    """The words of the grammar where a text asks for which values of one parameter there is an equilibrium, or none."""
    said = [word for word in dict.fromkeys(_WORD.findall(text)) if word in names.parameters]
    if len(said) != 1 or where_there_is_one(names, text) is None:
        return None
    is_none = _says(text, "no_equilibrium")
    return f"range of {said[0]} for which {'there is no equilibrium' if is_none else 'an equilibrium exists'}"


def where_there_is_one(names: Names, text: str) -> Message | None:
    """What is said of a text that asks where an equilibrium exists, in a model whose measures tell it. With friction
    rest is possible in many poses, and is asked as such."""
    asks = _says(text, "equilibrium_exists") or _says(text, "no_equilibrium")
    if not asks or not names.measures or rubbing.is_rough(names):
        return None
    return Message(
        "ask for the equilibrium of {measure}: the conditions beside its formula say for which values there is one",
        measure=next(iter(names.measures)),
    )


def _says(text: str, what: str) -> bool:
    return any(re.search(contexts(language)[what], text, re.IGNORECASE) for language in languages())
