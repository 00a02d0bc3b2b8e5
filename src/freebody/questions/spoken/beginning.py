"""What begins, what varies, and where it settles: words that say no more than others, before clauses are parted.

What begins to lift off lifts off; between which values something may vary is between which it lies; at what
angle there is equilibrium is the equilibrium of the angle that is measured, where no friction leaves a range.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from freebody.questions.spoken import joining, lookup, rubbing
from freebody.questions.spoken.composing import SILENT
from freebody.questions.spoken.lexicon import Word
from freebody.questions.spoken.words import Clause

if TYPE_CHECKING:
    from freebody.model.names import Names

_START, _COMMA = Word("verb", "start"), Word("preposition", ",")
_AT_ONCE = ("leave", "slack", "taut")  # verbs of what takes no time
_ASKS = (["for"], ["with"], ["where"], ["what"])


def told(names: Names, words: list[Word]) -> list[Word]:
    """The words without what says no more."""
    return _settled(names, _varying(_at_once(_led(_reached(_struck(names, words))))))


def _struck(names: Names, words: list[Word]) -> list[Word]:
    """After the bullet has hit is after the impact, where it hits as the motion begins, and nothing does later."""
    marks = [k for k, word in enumerate(words) if word == Word("mark", "after")]
    if len(marks) != 1 or not joining.is_struck_at_start_alone(names):
        return words
    own = Clause(words[marks[0] + 1 :])
    is_plain = own.all("verb") == ["hit"] and own.only("verb", "name", "pronoun", *SILENT)
    return [*words[: marks[0]], Word("instant", "after the impact")] if is_plain and marks[0] else words


def _at_once(words: list[Word]) -> list[Word]:
    """It begins to lift off when it does: in one clause, where both verbs are all that it does."""
    verbs = [k for k, word in enumerate(words) if word.kind == "verb"]
    doing = sorted(words[k].what in _AT_ONCE for k in verbs)
    is_one = len(verbs) == 2 and not any(word.kind == "mark" for word in words[verbs[0] : verbs[1]])
    begins = is_one and doing == [False, True] and _START in words
    return [word for word in words if word != _START] if begins else words


def _reached(words: list[Word]) -> list[Word]:
    """Which greatest height it reaches is its greatest height."""
    kinds = [word.kind for word in words]
    if (
        words[1:2] != [Word("verb", "top")]
        or words[0] != Word("ask", "what")
        or kinds[2:] not in (["name"], ["pronoun"])
    ):
        return words
    return [Word("degree", "greatest"), Word("quantity", "height"), Word("preposition", "of"), *words[2:]]


def _led(words: list[Word]) -> list[Word]:
    """The energy that is lost until it stops, where what is asked stands behind what says when, without a comma."""
    if (
        not words
        or words[0].kind != "mark"
        or _COMMA in words
        or any(word.kind in ("ask", "mark") for word in words[1:])
    ):
        return words
    verbs = [k for k, word in enumerate(words) if word.kind == "verb"]
    asked = [k for k, word in enumerate(words) if word.kind == "quantity"]
    return [*words[asked[0] :], *words[: asked[0]]] if verbs and len(asked) == 1 and verbs[0] < asked[0] else words


def _varying(words: list[Word]) -> list[Word]:
    """The values between which something may vary are those between which it lies."""
    is_range = Word("degree", "range") in words
    return [word for word in words if word != Word("verb", "change")] if is_range else words


def _settled(names: Names, words: list[Word]) -> list[Word]:
    """At what angle is there equilibrium: of the only angle that is measured."""
    clause = Clause(words)
    if [word.kind for word in words] == ["quantity", "preposition", "pronoun"] and words[0].what == "equilibrium":
        found = list(names.measures)  # where does the scale settle
        return [*words[:2], Word("name", found[0])] if len(found) == 1 else words
    rests = clause.has("quantity", "equilibrium") or clause.has("instant", "in equilibrium")
    asks = clause.all("ask") in _ASKS and words[0].kind == "ask" and clause.has("quantity", "angle")
    asks |= clause.all("ask") == ["far"] and not clause.has("quantity")  # which angle does it show
    plain = clause.only("ask", "name", "quantity", "instant", *SILENT)
    known = set(clause.all("quantity")) <= {"angle", "equilibrium"} and len(clause.all("instant")) <= 1
    others = [name for _, name in clause.names if name not in lookup.moving(names)]
    angles = [angle for body in ([n for _, n in clause.names] or [""]) for angle in lookup.angles(names, body)]
    if not (rests and asks and plain and known) or others or len(angles) != 1 or rubbing.is_rough(names):
        return words
    return [Word("quantity", "equilibrium"), Word("preposition", "of"), Word("name", angles[0])]
