"""Who takes part in a blow, and in which one: after the impact of the bullet, when it hits the second time."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

from freebody.measures.geometry import GROUND
from freebody.questions.spoken import joining
from freebody.questions.spoken.lexicon import Word
from freebody.questions.spoken.words import Clause
from freebody.questions.sudden import NTH

if TYPE_CHECKING:
    from freebody.model.names import Names

BLOWS = ("after the impact", "before the impact")
_ON = ("by", "on", "to", "in", "with", "from")  # what leads to who catches something
NTH_IMPACT = re.compile(rf"(?P<side>after|before|at) the {NTH} impact")


def without_striker(names: Names, words: list[Word]) -> list[Word]:
    """After it is caught by the peg, after the impact of the bullet, is after the impact, where nothing else strikes.
    Who strikes is who is asked of, where no other is named."""
    blows = (*BLOWS, "at the impact", "in the impact")
    said = [k for k, word in enumerate(words) if word.kind != "filler"]
    for j, blow in enumerate(said):
        if words[blow].kind != "instant" or words[blow].what not in blows:
            continue
        is_led = j + 1 < len(said) and words[said[j + 1]].kind == "preposition" and words[said[j + 1]].what in _ON
        behind = said[j + 1 + is_led :]
        who = words[behind[0]] if behind else words[blow]
        others = any(word.kind == "name" for k, word in enumerate(words) if behind and k != behind[0])
        if who.kind == "name" and (is_led or others) and _is_struck(names, who.what):
            return [*words[: blow + 1], *words[behind[0] + 1 :]]
    return words


def _is_struck(names: Names, thing: str) -> bool:
    """Whether something is caught at a place, or takes part in the only blow that there is."""
    closing = {row.connection for row in names.constraint_rows if row.closes}
    if is_caught(names, thing):
        return len(names.closing_later) == 1
    return len(closing) == 1 and not joining.strikes(names) and joining.touches(names, next(iter(closing)), thing)


def is_caught(names: Names, place: str) -> bool:
    """Whether something is caught at a place: a connection closes there on the way."""
    return any(place in (name, *joining.ends_of(names, name)) for name in names.closing_later)


def hitting_again(names: Names, main: Clause) -> Clause:
    """The speed with which it hits at the second impact is that just before."""
    again = [one for one in main.all("instant") if (nth := NTH_IMPACT.fullmatch(one)) and nth["side"] == "at"]
    is_speed = main.has("quantity", "velocity", "speed", "impact speed") or main.has("ask", "fast")
    if len(again) != 1 or not is_speed or set(main.all("verb")) - {"hit", "move", "fall"}:
        return main
    before = Word("instant", again[0].replace("at ", "before ", 1))
    struck = {GROUND, *names.bodies[GROUND].lines, *names.bodies[GROUND].planes}
    kept = [w for w in main.without("verb").words if not (w.kind == "name" and w.what in struck)]
    return Clause([before if w == Word("instant", again[0]) else w for w in kept])
