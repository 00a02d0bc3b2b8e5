"""A main clause that tells an event with the quantity there: with what speed does the ball hit the floor."""

from __future__ import annotations

from itertools import pairwise
from typing import TYPE_CHECKING

from freebody.measures.geometry import GROUND
from freebody.questions.spoken import (
    driving,
    given,
    joining,
    lookup,
    of_axles,
    rubbing,
    within,
)
from freebody.questions.spoken.events import GOES_ON, HAPPENS, conditions
from freebody.questions.spoken.frames import MOTION
from freebody.questions.spoken.lexicon import Word
from freebody.questions.spoken.words import Clause

if TYPE_CHECKING:
    from freebody.model.names import Names


def event_within(names: Names, main: Clause) -> tuple[Clause, list[list[str]]] | None:
    """A main clause that tells an event with the quantity there: with what speed does the ball hit the floor."""
    verbs = main.all("verb")
    if main.has("degree", "least", "greatest"):  # the least spin with which it comes back
        return None
    chosen = any(given.KIND_OF[quantity].ends_rest for quantity in main.all("quantity") if quantity in given.KIND_OF)
    begins = {"start"} < set(verbs) <= {"start", "slide", "move", "tip", "roll", "fall", "rise", "turn"}
    if main.has("ask", "with") and chosen and begins and lookup.rests(names):  # at which force does it begin to slip
        return None
    if main.has("ask", "with") and main.has("quantity", "acceleration") and set(verbs) <= {"slide", "roll"}:
        return None
    is_shaken = lookup.is_forced(names) and main.has("verb", "vanish") and len(main.all("quantity")) == 1
    if main.has("ask", "with") and is_shaken:  # at what speed the vibration vanishes asks for that of the drive
        return None
    if main.has("ask", "with") and (rubbing.is_still(names) or _is_of_drive(names, main)):
        return None
    if main.has("not") or (main.has("ask", "large", "much") and set(verbs) == {"taut"}):  # how taut is it
        return None
    if main.has("ask", "with", "where") and (found_at := within.where_it_is(names, main)) is not None:
        return found_at
    if not set(verbs) & set(HAPPENS) and not (main.has("ask", "with") and set(verbs) & {"slide", "roll"}):
        return None
    if not (main.has("ask", "fast", "with", "where", "what", "large", "high") or main.has("quantity")):
        return None
    at_angle = [
        word.what
        for before, word in pairwise(main.words)
        if before == Word("quantity", "angle") and word.kind == "name" and word.what in names.measures
    ]
    if at_angle:  # at what angle phi does it leave
        main = Clause([w for w in main.words if w != Word("name", at_angle[0])])
    if main.has("ask", "high"):  # above the ground, which is not what it leaves
        main = Clause(_without_reference(main.words))
    points = [name for _, name in main.names if name.partition(".")[0] in lookup.moving(names) and "." in name]
    owner = points if len(points) == 1 and main.has("quantity", *MOTION) else []  # of whose velocity it is asked
    told = ("name", "verb", "pronoun", "preposition", "updown", "value", "degree")
    event = Clause([w for w in main.words if w.kind in told and w.what not in owner])
    goes = [w for w in main.words if w.kind == "verb" and w.what in GOES_ON and set(verbs) & set(HAPPENS)]
    found = list(conditions(names, event.without("degree")))
    if not found and goes:  # how fast does it turn as it leaves: turning is of the question
        found = list(conditions(names, Clause([w for w in event.words if w not in goes and w.kind != "degree"])))
    else:
        goes = []
    if not found:
        return None
    who = next((name for _, name in event.names if name in lookup.moving(names) or name in names.measures), None)
    who = owner[0] if owner else who
    head = [w for w in main.words if w.kind in ("ask", "quantity", "part") or w in goes]
    if who is None:
        who = next((name for _, name in main.names if name in lookup.moving(names)), None)
    if who is None and len(lookup.massive(names)) == 1:
        who = lookup.massive(names)[0]  # what leaves the dome
    is_high = main.has("ask", "high") or main.all("quantity") == ["height"]
    if is_high and (touching := _of_what_touches(names, event)):
        return Clause([Word("name", touching)]), found
    if main.has("ask", "where") and not main.has("quantity"):
        head = [Word("quantity", "position")]
        if set(verbs) & {"slack", "taut"}:  # what a string leads round is told by the angle, not by how long that is
            swung = [angle for angle in lookup.hung(names, who or "") if angle in lookup.angles(names, angle)]
            return (Clause([Word("name", swung[0])]), found) if len(swung) == 1 else None
    if main.has("quantity", "angle"):  # a place of the motion has a name: what has none is no angle of a motion
        [angle, *_] = [*at_angle, *lookup.angles(names, who or ""), *lookup.angles(names, ""), ""]
        return (Clause([Word("name", angle)]), found) if angle else None
    return Clause([*head, *([Word("name", who)] if who else [])]), found


def _of_what_touches(names: Names, event: Clause) -> str:
    """The measure of how high the point of a body is that leaves something: the upper end that leaves the wall."""
    named = [name for _, name in event.names]
    who = [name for name in named if name in lookup.moving(names)]
    joints = [name for name in named if name in names.connections]
    if len(who) == 1 and not joints:
        joints = joining.joints(names, who[0], next((name for name in named if name != who[0]), ""), "normal force")
    points = [getattr(row.measure, "of", None) for row in names.constraint_rows if row.connection in joints]
    heights = [name for name, sense in lookup.heights(names, "") if sense > 0]
    found = [name for name in heights if getattr(names.measures[name], "of", None) in points]
    return found[0] if event.has("verb", "leave") and len(joints) == len(found) == 1 else ""


def _without_reference(words: list[Word]) -> list[Word]:
    """Without `above the ground` before what happens."""
    verb = next((k for k, word in enumerate(words) if word.kind == "verb"), 0)
    said = (k for k in range(verb - 1) if words[k : k + 2] == [Word("preposition", "in"), Word("name", GROUND)])
    k = next(said, None)
    return words if k is None else [*words[:k], *words[k + 2 :]]


def _is_of_drive(names: Names, main: Clause) -> bool:
    """Whether the rate of a drive is meant: at which rpm a tappet, which cannot turn, leaves its cam."""
    rates = [name for name in given.of_kind(names, "angular velocity") if name in driving.drive_parameters(names)]
    turned = [name for _, name in main.names if of_axles.axle_of(names, name)]
    return main.has("quantity", "angular velocity") and bool(rates) and not turned
