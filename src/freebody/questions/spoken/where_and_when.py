"""Where, when and which way: the place or the time at which something is so."""

from __future__ import annotations

from typing import TYPE_CHECKING

from freebody.measures.geometry import ZERO
from freebody.questions.spoken import (
    driving,
    lookup,
    of_axles,
)
from freebody.questions.spoken.asking import quantities
from freebody.questions.spoken.composing import SILENT, Groups
from freebody.questions.spoken.counting import time
from freebody.questions.spoken.events import GOES_ON
from freebody.questions.spoken.frames import FORCES
from freebody.questions.spoken.instants import timed
from freebody.questions.spoken.lexicon import Word
from freebody.questions.spoken.sentence import Sentence
from freebody.questions.spoken.words import Clause

if TYPE_CHECKING:
    from freebody.model.names import Names

_PLACES = ("angle", "position")
_OF_MOTION = ("acceleration", "angular acceleration", "speed", "velocity", "angular velocity")


def at_extreme(names: Names, sentence: Sentence) -> Groups:
    """When, where or at which angle something is greatest or least: the time, or the place, when it is."""
    words = sentence.main.words
    asks = [w.what for w in words if w.kind == "ask"]
    ends = [w for w in words if w.kind == "degree" and w.what in ("greatest", "least")]
    if sentence.others or len(asks) != 1 or words[0].kind != "ask" or len(ends) != 1 or ends[0] != words[-1]:
        return
    said = [k for k, w in enumerate(words) if w.kind == "quantity"]
    if asks[0] in ("when", "soon") and len(said) == 1:
        yield from time(names, Sentence(Clause([Word("ask", "when")]), (("when", Clause(words[1:])),)))
    elif asks[0] == "where" and len(said) == 1:
        yield from timed(names, Sentence(Clause([Word("quantity", "position")]), (("when", Clause(words[1:])),)))
    elif asks[0] == "high" and len(said) == 1:
        of = [word for word in words if word.kind == "name"]
        height = Clause([Word("quantity", "height"), *of])
        yield from timed(names, Sentence(height, (("when", Clause(words[1:])),)))
    elif asks[0] in ("with", "for") and len(said) == 2 and words[said[0]].what in _PLACES:
        place, rest = _parted_at(words, said[0] + 1)
        yield from timed(names, Sentence(Clause(place), (("when", Clause(rest)),)))


def _parted_at(words: list[Word], k: int) -> tuple[list[Word], list[Word]]:
    """The place that is asked for, and what is so there."""
    place, rest = words[1:k], words[k:]  # the horizontal force is greatest
    while rest and rest[0].kind in ("name", "preposition"):  # at which angle of the crank
        place, rest = [*place, rest[0]], rest[1:]
    return place, rest


def at_value(names: Names, sentence: Sentence) -> Groups:
    """Where a quantity has a value: the place, when it has."""
    main = sentence.main
    is_plain = main.only("ask", "quantity", "value", "name", "relation", "part", *SILENT) and not sentence.others
    if main.all("ask") == ["where"] and len(main.all("quantity")) == len(main.values) == 1 and is_plain:
        yield from timed(names, Sentence(Clause([Word("quantity", "position")]), (("when", main.without("ask")),)))


def at_zero(names: Names, sentence: Sentence) -> Groups:
    """Where, or at which angle of the crank, what moves with it is zero: the place, when it is."""
    words = sentence.main.words
    said = [k for k, word in enumerate(words) if word.kind == "quantity"]
    is_plain = sentence.main.only("ask", "quantity", "name", "verb", *SILENT) and not sentence.others
    if not is_plain or sentence.main.all("verb") != ["vanish"] or words[-1].kind != "verb" or not said:
        return
    if words[said[-1]].what not in _OF_MOTION or words[0].kind != "ask" or len(sentence.main.all("ask")) != 1:
        return
    if words[0].what == "where" and len(said) == 1:
        yield from timed(names, Sentence(Clause([Word("quantity", "position")]), (("when", Clause(words[1:])),)))
    elif words[0].what in ("with", "for") and len(said) == 2 and words[said[0]].what in _PLACES:
        place, rest = _parted_at(words, said[0] + 1)
        yield from timed(names, Sentence(Clause(place), (("when", Clause(rest)),)))


def at_turning_points(names: Names, sentence: Sentence) -> Groups:
    """At which angle of the crank the rocker turns back: at the dead points of the rocker."""
    words = [word for word in sentence.main.words if word.kind not in SILENT]
    kinds = [word.kind for word in words]
    ends = (Word("verb", "turn_back"), Word("instant", "turning point"))
    ends = (*ends, Word("verb", "stop")) if driving.is_led(names) else ends
    if kinds[-2:] == ["verb", "name"]:  # where does stand still the piston, as German has it
        words, kinds = [*words[:-2], words[-1], words[-2]], [*kinds[:-2], "name", "verb"]
    if sentence.others or not words or words[-1] not in ends or kinds[-2:-1] != ["name"]:
        return
    place, turns = words[1:-2], words[-2].what
    goes = lookup.places(names, turns) if driving.is_led(names) else []  # a piston, by the only measure of its place
    turns = goes[0] if turns not in lookup.turning(names) and len(goes) == 1 else turns
    is_asked = words[0].kind == "ask" and words[0].what in ("with", "for")
    is_asked &= turns in lookup.turning(names) or turns in goes
    is_asked &= any(w.kind == "name" and w.what != turns for w in place)
    if is_asked and Clause(place).only("name", "quantity"):
        for group in quantities(names, Clause(place)):
            yield [f"{text} at the dead points of {turns}" for text in group]


def which_way(names: Names, sentence: Sentence) -> Groups:
    """Which way something moves that is let go: the way in which it is accelerated."""
    main, verbs = sentence.main, set(sentence.main.all("verb"))
    is_size = names.space and main.has("quantity", "friction force")  # which tells no direction
    if main.has("ask", "way") and set(main.all("quantity")) & {*FORCES} and not is_size:  # as its components tell
        yield from timed(names, Sentence(main.without("ask", "way").without("verb", "act", "move"), sentence.others))
    of = [name for _, name in main.names if name in lookup.moving(names)]
    begins = verbs - {"start"} <= {*GOES_ON} and (main.has("instant", "at start") or "start" in verbs)
    if begins and main.has("ask", "way") and main.only("ask", "verb", "name", "instant", *SILENT):
        ways = [name for _, name in main.names if name in names.measures]  # that is let go: as it is accelerated
        yield [f"acceleration of {way} at start" for way in ways if names.start_rates.get(way, ZERO) == ZERO]
    goes = main.has("ask", "way") and verbs <= {*GOES_ON, "hit", "leave"} and not main.has("quantity")
    if goes and (not lookup.rests(names) or sentence.others) and len(of) <= 1:  # as the components of its velocity tell
        way = Word("quantity", "velocity")
        kept = Clause([way, *(w for w in main.words if w != Word("ask", "way") and w.what not in GOES_ON)])
        yield from timed(names, Sentence(kept, sentence.others))
    begun = " at start" if main.all("instant") == ["at start"] else ""
    asked = main.without("instant", "at start")
    plain = asked.has("ask", "way") and asked.only("ask", "verb", "name", *SILENT) and not sentence.others
    relative = "".join(f" relative to {name}" for before, name in main.names if before == "relative")
    plain &= len(of) == len(main.names) == 1 + bool(relative) and lookup.rests(names)
    if plain and verbs <= {"start", "tip", *GOES_ON} and verbs:
        is_turned = bool(verbs & {"turn", "tip"}) or of_axles.axle_of(names, of[0]) == "center"
        yield [f"{'angular ' if is_turned else ''}acceleration of {of[0]}{relative}{begun}"]
