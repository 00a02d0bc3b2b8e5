"""The time between two events: how long does it take from y = h to y = 0, wie viel Zeit vergeht zwischen ..."""

from __future__ import annotations

from typing import TYPE_CHECKING

from freebody.questions.spoken import lookup
from freebody.questions.spoken.composing import SILENT, Groups
from freebody.questions.spoken.events import conditions
from freebody.questions.spoken.lexicon import Word
from freebody.questions.spoken.words import Clause

if TYPE_CHECKING:
    from freebody.model.names import Names

_OPENS = [Word("preposition", what) for what in ("between", "from", "of")]
_JOINS = {
    "between": [Word("preposition", "and")],
    "from": [Word("preposition", "to"), Word("mark", "until")],
    "of": [Word("preposition", "to"), Word("mark", "until")],
}
_HAPPENING = {"slack", "taut", "hit", "leave"}  # verbs of events that no measure gives
_MOVES = {"move", "fall", "rise"}  # verbs that say no more than that it is under way


def time_between(names: Names, words: list[Word]) -> Groups:
    """In which a time is asked for, of which the ends are given by measures."""
    said = [word for word in words if word.kind != "filler"]
    yield from _way_back(names, Clause(said))
    opening = next((k for k, word in enumerate(said) if word in _OPENS), None)
    if opening is None:
        return
    head, rest = Clause(said[:opening]), said[opening + 1 :]
    joint = next((k for k, word in enumerate(rest) if word in _JOINS[said[opening].what]), None)
    is_time = head.has("ask", "long") or (head.has("quantity", "time") and len(head.all("quantity")) == 1)
    is_plain = head.only("ask", "quantity", "name", "verb", *SILENT) and {*head.all("verb")} <= _MOVES
    if joint is None or not is_time or not is_plain:
        return
    first, last = Clause(rest[:joint]), Clause(rest[joint + 1 :])
    if not all(clause.has("relation") or {*clause.all("verb")} & _HAPPENING for clause in (first, last)):
        return
    measures = [names.measures[name] for _, name in (*first.names, *last.names) if name in names.measures]
    moved = {body for measure in measures for body in measure.bodies()}
    if not {name for _, name in head.names} <= moved:  # of another body than the events tell
        return
    for begin in conditions(names, first):
        for end in conditions(names, last):
            yield [f"time between {a} and {b}" for a in begin for b in end]


def _way_back(names: Names, said: Clause) -> Groups:
    """How long it takes from where it turns back to where it started, or up to there."""
    of = [name for _, name in said.names]
    asks = said.has("ask", "long") or said.has("quantity", "time")
    plain = said.only("ask", "quantity", "name", *SILENT)
    ways = {way for way in said.all("quantity") if way != "time"}
    if not asks or not plain or len(ways) != 1 or len(of) > 1:
        return
    along = lookup.ways(names, of[0] if of else "")
    if ways == {"way back"}:
        yield [f"time between rate({way}) = 0 and {way} = 0" for way in along]
    elif ways == {"way up"}:
        yield [f"time when rate({way}) = 0" for way in along]
