"""By how much a quantity changes as a parameter does.

    factor | reduction factor of QUANTITY as PARAMETER -> EXPRESSION                   Q(P')/Q(P), or its inverse
    increase | decrease of QUANTITY as PARAMETER -> EXPRESSION                         Q(P') - Q(P), or its negative
    relative increase | relative decrease of QUANTITY as PARAMETER -> EXPRESSION       that over Q(P)

Q(P') is to what the quantity tends as the parameter tends to its other value, each side a question of its own; all
other parameters keep theirs. What has a power law has a factor that is a number: a period of sqrt(L) grows by sqrt(2)
as L becomes 2 L.
"""

from __future__ import annotations

import re
from dataclasses import replace
from typing import TYPE_CHECKING

from freebody.language.sentences import Message
from freebody.questions.arithmetic import read_calculated
from freebody.questions.at_events import AtEvent
from freebody.questions.motion import OfMeasure
from freebody.questions.reading_of_parameters import Read, read_limit
from freebody.questions.reading_when import Meant
from freebody.questions.turned_round import LIMIT

if TYPE_CHECKING:
    from freebody.model.names import Names

_THEN, _NOW = "then", "now"
CHANGES = {  # what is calculated from both values
    "factor": (_THEN, "/", _NOW),
    "reduction factor": (_NOW, "/", _THEN),
    "increase": (_THEN, "-", _NOW),
    "decrease": (_NOW, "-", _THEN),
    "relative increase": (_THEN, "/", _NOW, "-", "1"),
    "relative decrease": ("1", "-", _THEN, "/", _NOW),
}
_CHANGE = re.compile(rf"^(?:the )?(?P<what>{'|'.join(CHANGES)}) of (?:the )?(?P<rest>.+)$")


def read_change(read: Read, names: Names, phrase: str, when: object) -> Meant | None:
    """A factor, or a difference, that a parameter with another value makes; None where a phrase asks for none, or after
    noting a problem."""
    said = _CHANGE.match(phrase)
    found = None if said is None else LIMIT.match(said["rest"])
    if said is None or found is None or found["parameter"] not in names.parameters:
        return None
    then, now = read_limit(read, names, found, when), read(names, found["of"] + (found["timed"] or ""), when)
    if then is None or now is None:
        return None
    if isinstance(now.quantity, OfMeasure) and not (now.at_start or now.event or now.transition):
        told = Message("say when {what} is meant, e.g. at start", what=found["of"])
        names.problem(told, "find")
        return None
    both = {_THEN: then, _NOW: now}
    runs = CHANGES[said["what"]]
    sides = {k: _alone(both[run]) for k, run in enumerate(runs) if run in both}
    quantity = read_calculated(names, phrase, sides, ("find",), runs)
    return None if quantity is None else replace(Meant(quantity), in_unit=then.in_unit)


def _alone(one: Meant) -> AtEvent:
    """A side as a question of its own."""
    return AtEvent(one.quantity, one.event, one.at_start, one.transition)


def asks_for_change(names: Names, phrase: str) -> bool:
    """Whether a phrase asks for what a parameter with another value makes of a quantity."""
    said = _CHANGE.match(phrase)
    found = None if said is None else LIMIT.match(said["rest"])
    return found is not None and found["parameter"] in names.parameters
