"""Words that only say that something moves as it does."""

from __future__ import annotations

from typing import TYPE_CHECKING

from freebody.language.units import LENGTH, TIME
from freebody.questions.spoken import (
    driving,
    joining,
    lookup,
    rubbing,
)
from freebody.questions.spoken.lexicon import Word
from freebody.questions.spoken.striking import without_striker
from freebody.questions.spoken.words import Clause

if TYPE_CHECKING:
    from freebody.model.names import Names


_COMMA = Word("preposition", ",")


def is_given(names: Names, clause: Clause) -> bool:
    """Whether a clause says no more than that a body is fixed which the file fixes."""
    of = [name for _, name in clause.names]
    fixed = all(name in names.bodies and names.bodies[name].fixed for name in of)
    return bool(of) and fixed and clause.only("name", "verb", "filler") and set(clause.all("verb")) <= {"hold"}


def without_course(names: Names, words: list[Word]) -> list[Word]:
    """Words without what only says that something moves as it does, and without who is let go at the start: the
    acceleration of the wedge while the block slides, that of the drum after the motor is switched on."""
    kept = list(words)
    for begin in [k for k, word in enumerate(words) if word.kind == "mark"][::-1]:
        stops = (k for k in range(begin + 1, len(kept)) if kept[k].kind == "mark" or kept[k] == _COMMA)
        end = next(stops, len(kept))
        clause = Clause([w for w in kept[begin + 1 : end] if w.kind != "filler"])
        is_empty = kept[begin].what == "while" and not clause.words and begin > 0  # while braking
        is_fixed = kept[begin].what == "when" and begin > 0 and is_given(names, clause.without("verb", "become"))
        holding = {"conserved"} <= set(clause.all("verb")) <= {"conserved", "hold", "become"}
        steady = holding and set(clause.all("quantity")) <= {"angular velocity", "velocity", "speed"}
        if kept[begin].what == "to" and steady and driving.is_driven(names):  # to keep the speed that a motor has
            kept = [*kept[:begin], *kept[end:]]
            continue
        passive = {"hold", "become"} <= set(clause.all("verb")) and not clause.has("value")
        if passive and not is_fixed and kept[begin].what == "when" and clause.names:
            return [*kept, Word("other", "held")]  # by a hand that the model has not: no instant of its motion
        rests = kept[begin].what == "while" and begin > 0 and _is_at_rest(names, words, clause)
        if is_empty or is_fixed or rests or (clause.names and is_throughout(names, kept[begin].what, clause)):
            kept = [*kept[:begin], *kept[end + (begin == 0) :]]
    kept = without_striker(names, kept)
    begins = [k for k, word in enumerate(kept) if word == Word("instant", "at start")]
    for k in begins:
        let_go = next((j for j in range(k + 1, len(kept)) if kept[j].kind != "filler"), len(kept))
        pushes = let_go < len(kept) and kept[let_go].kind == "quantity" and kept[let_go].what in ("force", "torque")
        if pushes and any(w.kind == "quantity" for w in kept[:k]):  # after the force is applied
            kept = [*kept[:let_go], *kept[let_go + 1 :]]
        others = [w.what for w in kept[:k] if w.kind == "name"]
        own = kept[let_go : let_go + 1]
        if (
            own
            and own[0].kind == "name"
            and own[0].what in (*names.loads, *names.parameters, *lookup.moving(names))
            and others
        ):
            return [*kept[:let_go], *kept[let_go + 1 :]]
    return kept


def _is_at_rest(names: Names, words: list[Word], clause: Clause) -> bool:
    """Whether a clause says of what stands still that it does, where nothing is to be chosen so that it is so."""
    chosen = any(w.kind == "degree" or w.what in ("may", "must", "for", *names.parameters) for w in words)
    clause = clause.without("instant", "in equilibrium")
    plain = clause.only("verb", "name", "pronoun") and clause.all("verb") in (["hold"], ["stop"])
    return plain and not chosen and words[0].kind != "filler" and rubbing.is_still(names)


def is_throughout(names: Names, mark: str, clause: Clause) -> bool:
    """Whether a clause is of all of the motion: while it rolls, where nothing else can come."""
    lasts = {"move", "roll", "turn", "fly", "fall", "rise", "accelerate", "exert"}
    rubs = any(row.reaction.startswith("friction") for row in names.constraint_rows)
    lasts |= set[str]() if rubs else {"slide"}
    goes_on = set(clause.all("verb")) <= lasts and clause.has("verb")
    is_told = set(clause.all("verb")) <= {"slide"} and not rubs  # down the slope, as it does
    clause = clause.without("preposition", "with")  # as it turns with the table
    plain = clause.only("verb", "pronoun", "name", *(("updown", "preposition") if is_told else ()))
    own = [name for _, name in clause.names]
    if any(name in names.parameters and names.parameters[name].dimension in (LENGTH, TIME) for name in own):
        return False  # once it has slid L
    pushes = ("driving torque", "driving force")  # as a motor says, whatever touches it
    is_led = bool(own) and all(any(driving.drivers(names, name, push) for push in pushes) for name in own)
    return mark in ("while", "when") and goes_on and (joining.goes_on(names) or is_led) and plain
