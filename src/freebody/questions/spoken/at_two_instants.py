"""One quantity at two instants, or two quantities each at its own: the ratio of the tension at the top to that at the
bottom, the difference between the speed before and after the impact.

Each side is a question of its own, with what says when; a side that names no quantity is of the same one as the other.
"""

from __future__ import annotations

from itertools import islice
from typing import TYPE_CHECKING

from freebody.questions.spoken.composing import Groups
from freebody.questions.spoken.lexicon import Word

if TYPE_CHECKING:
    from collections.abc import Callable

    from freebody.model.names import Names

_OPERATORS = {"ratio": "/", "difference": "-"}
_LEADS = (Word("preposition", "of"), Word("preposition", "between"))
_THAT = (Word("pronoun", "that"), Word("pronoun", "it"))
_MARKS = ("when", "after")


def compared(names: Names, words: list[Word], again: Callable[[Names, list[Word]], Groups]) -> Groups:
    """What words, without fillers, compare of two instants. again: what the words of one side ask for."""
    if not words or words[0].kind != "quantity" or words[0].what not in _OPERATORS:
        return
    said = words[2:] if words[1:2] and words[1] in _LEADS else words[1:]
    for k, word in enumerate(said):
        if word.kind == "preposition" and word.what in ("to", "and"):
            one, other = said[:k], _completed(said[:k], said[k + 1 :])
            sides = [_only(names, side, again) if _is_timed(side) else "" for side in (one, other)]
            if all(sides):
                yield [f"({sides[0]}) {_OPERATORS[words[0].what]} ({sides[1]})"]


def _is_timed(words: list[Word]) -> bool:
    """Whether a side has a quantity, and something that says when it is meant."""
    return any(w.kind == "quantity" for w in words) and any(_tells_when(w) for w in words)


def _tells_when(word: Word) -> bool:
    return word.kind == "instant" or (word.kind == "mark" and word.what in _MARKS)


def _completed(one: list[Word], other: list[Word]) -> list[Word]:
    """The other side with the quantity of the first, where it only says when."""
    if any(word.kind == "quantity" for word in other):
        return other
    head: list[Word] = []
    for word in one:
        if _tells_when(word):
            break
        head.append(word)
    return [*head, *(word for word in other if word not in _THAT)]


def _only(names: Names, words: list[Word], again: Callable[[Names, list[Word]], Groups]) -> str:
    """What a side asks for, where that is one question."""
    found = next((group for group in islice(again(names, words), 8) if group), [])
    return found[0] if len(found) == 1 else ""
