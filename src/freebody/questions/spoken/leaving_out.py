"""Questions that leave out a load: does it hold without F. Of rest it is another system; a motion has it all along."""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING

from freebody.language.sentences import Message
from freebody.questions.forms import NAME
from freebody.questions.happening import NOTHING_SLIDES
from freebody.questions.rest import loads_by
from freebody.questions.spoken import rubbing
from freebody.questions.spoken.lexicon import contexts, languages
from freebody.questions.spoken.unread import AskedT, Unread, read_quietly

if TYPE_CHECKING:
    from freebody.model.names import Names


def without_load(names: Names, text: str) -> tuple[str, str] | None:
    """A question without the words that leave out a load, and that load; None where none is left out."""
    for language in languages():
        for found in re.finditer(contexts(language)["left_out"].format(name=NAME), text, re.IGNORECASE):
            loads = loads_by(names, found["load"])
            if len(loads) == 1:
                left = f"{text[: found.start()]}{text[found.end() :]}".strip(" ,")
                return left, loads[0]
    return None


def without_several(names: Names, text: str) -> Message | None:
    """What is said of a text that leaves out several loads at once."""
    for language in languages():
        joint = contexts(language)["listed"]
        several = contexts(language)["left_out"].format(name=f"{NAME}(?:(?:{joint}){NAME})+")
        for found in re.finditer(several, text, re.IGNORECASE):
            loads = [loads_by(names, word) for word in re.split(joint, found["load"], flags=re.IGNORECASE)]
            if all(len(one) == 1 for one in loads):
                return Message("one load at a time is left out: without {load}", load=loads[0][0])
    return None


def holds_without_which(names: Names, text: str) -> Message | None:
    """What is said of a text that asks whether what rests under several forces locks itself."""
    pushes = rubbing.chosen_pushes(names)
    asks = any(re.search(contexts(language)["locks_itself"], text, re.IGNORECASE) for language in languages())
    if not asks or not names.lets_go_from_rest or not rubbing.is_rough(names):
        return None
    if len(pushes) < 2:
        return NOTHING_SLIDES if rubbing.on_wheels(names) else None
    return Message(
        "say without which force it is to hold by itself, however large the others are, as in: does it hold without "
        "{load}, or range of mu that keeps it at rest without {load}",
        load=pushes[-1],
    )


def at_rest_without(
    names: Names, load: str, asked: Sequence[tuple[AskedT, str]], read: Callable[[str], AskedT | None]
) -> list[tuple[AskedT, str]]:
    """What is asked without a load, where that is read: of rest alone. asked: the same with it."""
    found: list[tuple[AskedT, str]] = []
    for _without_words, words in asked:
        put = f"{words.rstrip('? ')} without {load}"
        if isinstance(each := read_quietly(names, put, read), Unread):
            told = Message(
                "a load is left out of questions about rest alone, as in: does it hold without {load}. Of a motion, "
                "give it the value 0 in the file",
                load=load,
            )
            names.problem(told, "find")
            return []
        found += [*zip(each, (put,), strict=True)]
    return found
