"""What begins, what nothing does, and where it settles: words that say no more than others, before clauses are parted.

What lifts off at once begins to lift off; between which values something may vary is between which it lies; at what
angle there is equilibrium is the equilibrium of the angle that is measured, where no friction leaves a range.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from freebody.questions.spoken import joining, lookup
from freebody.questions.spoken.composing import SILENT
from freebody.questions.spoken.lexicon import Word
from freebody.questions.spoken.words import Clause

if TYPE_CHECKING:
    from freebody.model.names import Names

_START, _NOT = Word("verb", "start"), Word("not", "not")
_AT_ONCE = ("leave", "slack", "taut")  # verbs of what takes no time
_TURNS = Word("quantity", "turns")
_ASKS = (["for"], ["with"], ["where"], ["what"])


def told(names: Names, words: list[Word]) -> list[Word]:
    """The words without what says no more."""
    return _settled(names, _varying(_nothing_turns(_at_once(words))))


def _at_once(words: list[Word]) -> list[Word]:
    """It begins to lift off when it does."""
    begins = _START in words and any(word.kind == "verb" and word.what in _AT_ONCE for word in words)
    verbs = [word for word in words if word.kind == "verb"]
    return [word for word in words if word != _START] if begins and len(verbs) == 2 else words


def _nothing_turns(words: list[Word]) -> list[Word]:
    """So that nothing turns: no number of turns."""
    ends = len(words) > 1 and words[-1] == _TURNS and _NOT in words[-3:-1]
    return [*words[:-1], Word("verb", "turn")] if ends else words


def _varying(words: list[Word]) -> list[Word]:
    """The values between which something may vary are those between which it lies."""
    is_range = Word("degree", "range") in words
    return [word for word in words if word != Word("verb", "change")] if is_range else words


def _settled(names: Names, words: list[Word]) -> list[Word]:
    """At what angle is there equilibrium: of the only angle that is measured."""
    clause = Clause(words)
    rests = clause.has("quantity", "equilibrium") or clause.has("instant", "in equilibrium")
    asks = clause.all("ask") in _ASKS and words[0].kind == "ask" and clause.has("quantity", "angle")
    plain = clause.only("ask", "name", "quantity", "instant", *SILENT)
    known = set(clause.all("quantity")) <= {"angle", "equilibrium"} and len(clause.all("instant")) <= 1
    others = [name for _, name in clause.names if name not in lookup.moving(names)]
    angles = [angle for body in ([n for _, n in clause.names] or [""]) for angle in lookup.angles(names, body)]
    if not (rests and asks and plain and known) or others or len(angles) != 1 or joining.is_rough(names):
        return words
    return [Word("quantity", "equilibrium"), Word("preposition", "of"), Word("name", angles[0])]
