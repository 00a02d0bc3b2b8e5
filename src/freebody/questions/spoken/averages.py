"""Averages over the time from the start to an event: mittlere Leistung bis zum Stillstand, average speed until it hits.

Over how long an average is taken belongs to it: where nothing says so, it is none that can be told.
"""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

from freebody.questions.spoken.asking import quantities
from freebody.questions.spoken.composing import SILENT, Groups
from freebody.questions.spoken.events import conditions
from freebody.questions.spoken.lexicon import Word
from freebody.questions.spoken.sentence import Sentence, clock
from freebody.questions.spoken.words import Clause

if TYPE_CHECKING:
    from freebody.model.names import Names

_MEAN = Word("part", "mean")
_AVERAGED = re.compile(
    r"(?P<size>\|?)(?P<what>(?:power|speed|velocity|acceleration|force) (?:of|in|along) [^|]+)(?P=size)"
)
_PLAIN = {"become", "act", "exert", "move", "turn", "reach"}  # verbs that say no more than the quantity
_UNTIL = ("until", "after", "while")


def averages(names: Names, sentence: Sentence) -> Groups:
    """The average of a quantity up to an event, or over the first so many seconds."""
    if _MEAN not in sentence.main.words or sentence.main.has("ask", "when", "where", "long"):
        return
    main = Clause([word for word in sentence.main.words if word != _MEAN])
    ends = [*_ends_of(names, sentence)]
    main, within = _within(names, main)
    ends += within
    if not set(main.all("verb")) <= _PLAIN:  # from the impact on: not from the start
        return
    if len(ends) != 1 or not main.only("quantity", "name", "ask", "verb", *SILENT):
        return
    for group in quantities(names, main.without("verb").without("ask")):
        found = [_AVERAGED.fullmatch(text) for text in group]
        yield [f"average {one['what']} until {end}" for one in found if one is not None for end in ends[0]]


def _ends_of(names: Names, sentence: Sentence) -> list[list[str]]:
    """The events up to which clauses say that the average is taken."""
    found: list[list[str]] = []
    for mark, clause in sentence.others:
        if mark not in _UNTIL:
            return []
        if (time := clock(names, clause)) is not None:
            found.append([f"t = {time}"])
        else:
            found.append(next((group for group in conditions(names, clause) if group), []))
    return found


def _within(names: Names, main: Clause) -> tuple[Clause, list[list[str]]]:
    """A clause without the time within which it is said to be: in the first 2 s."""
    words = [*main.words]
    for k, word in enumerate(words):
        time = clock(names, Clause([word])) if word.kind in ("value", "name") else None
        if time is not None and k > 0 and words[k - 1] == Word("preposition", "in"):
            return Clause([*words[: k - 1], *words[k + 1 :]]), [[f"t = {time}"]]
    return main, []
