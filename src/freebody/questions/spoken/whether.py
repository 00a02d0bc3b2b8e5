"""Whether something is so in the motion: does the ball lift off, bleibt das Seil straff, ob die Kiste kippt.

A clause that asks for nothing (a verb comes first, or `whether`) states what else is asked as `so that ...` or
`when ...`: the same readings of it stand behind `whether`. What rests is asked whether it holds, in meaning.py.
"""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

from freebody.questions.course import can_change, connections_of, sticking
from freebody.questions.spoken import joining, lookup, rubbing
from freebody.questions.spoken.composing import SILENT, Groups
from freebody.questions.spoken.events import conditions
from freebody.questions.spoken.lexicon import Word
from freebody.questions.spoken.sentence import Sentence
from freebody.questions.spoken.so_that import so, stands
from freebody.questions.spoken.words import Clause

if TYPE_CHECKING:
    from freebody.model.names import Names

_EVER = ("when t grows", "over the motion")  # at some time, ever
_HOW_FAR = ("height", "position", "distance", "angle")  # kinds of a measure that reaches a value
_TOLD = ("verb", "name", "not", "value", "relation", "part", "instant", *SILENT)
_GOES_BACK = {"turn_back", "return"}  # verbs of what comes to rest and does not stay there
_BEGINS_TO_SLIP = re.compile(r"(?P<who>.+?) begins to slip|slipping begins")
_AT_REST = re.compile(r"rate\((?P<way>\w+)\) = 0")
_HAS_COME = re.compile(r".+ has moved .+")
_EQUAL = re.compile(r"(?P<way>\w+) = (?P<value>.+)")
_BEGINS = ("start", "move", "act")  # verbs that say no more than that something comes: slip occurs


def whether(names: Names, sentence: Sentence) -> Groups:
    """Whether something comes, or lasts, in the motion, perhaps before something else."""
    main = _staying_on(names, _without_beginning(sentence.main.without("instant", *_EVER)))
    if not set(main.all("quantity")) <= {*_HOW_FAR} or not main.has("verb") or not main.only("quantity", *_TOLD):
        return
    if any(mark != "until" for mark, _ in sentence.others) or len(sentence.others) > 1:
        return
    if sentence.others:
        for group in _states(names, main):
            for limits in conditions(names, sentence.others[0][1]):
                yield [f"whether {state} before {limit}" for state in group for limit in limits]
        return
    for group in _states(names, main):
        yield [f"whether {state}" for state in group]


def _states(names: Names, main: Clause) -> Groups:
    """What a clause states of the motion."""
    verbs, negated = {*main.all("verb")}, main.has("not")
    who = next((name for _, name in main.names), "it")
    if (
        (verbs == {"tip"} or (verbs == {"turn_fully"} and stands(names, who)))
        and main.only("verb", "name", "not", *SILENT)
        and len(main.names) <= 1
    ):
        yield [f"{who} {'does not tip' if negated else 'tips'}"]
        return
    if (verbs & {"hold"} and "taut" not in verbs) or (verbs & {"stop", "remain"} and _stays_at_rest(names)):
        return  # of rest it is asked whether it holds, and what moves does not stay where it is
    if verbs & {"leave", "stay_on"} and joining.tracks(names):
        return  # what a link stands for holds on both sides
    if verbs == {"remain"}:
        yield from _remaining(names, main, "" if who == "it" else who, negated=negated)
        return
    if verbs == {"slide"} and who not in names.connections and not rubbing.rough(names, "" if who == "it" else who):
        return
    if "end" not in verbs and verbs != {"taut"}:  # that slipping ends is no state, and what becomes taut was not
        yield from so(names, main, lambda *_: iter(()))
    for group in conditions(names, main.without("not")):
        yield [state for condition in group for state in _stated(names, condition, verbs, negated=negated)]


def _stays_at_rest(names: Names) -> bool:
    """Whether what is at rest at the start is not let fall onto something."""
    return lookup.rests(names) and (rubbing.is_rough(names) or not joining.comes_to_strike(names))


def _stated(names: Names, condition: str, verbs: set[str], *, negated: bool) -> list[str]:
    """An event as a statement of what does something: x reaches d, x turns back, the block slips."""
    never = "never " if negated else ""
    if (slips := _BEGINS_TO_SLIP.fullmatch(condition)) is not None:
        return [f"{slips['who'] or 'it'} {'does not slip' if negated else 'slips'}"]
    if (rests := _AT_REST.fullmatch(condition)) is not None:
        return [f"{rests['way']} {never}turns back"] if verbs & _GOES_BACK else []
    if _HAS_COME.fullmatch(condition) is not None:
        return []  # how far it comes is read from no statement
    if (equal := _EQUAL.fullmatch(condition)) is not None:
        return [f"{equal['way']} {never}reaches {equal['value']}"]
    who, _, does = condition.partition(" ")
    return [f"{who} {never}{does}"]


def _remaining(names: Names, main: Clause, who: str, *, negated: bool) -> Groups:
    """It stays where it comes to rest: up a slope it does not slide back, and else it is enough that it stops."""
    if not main.only("verb", "name", "not", *SILENT) or len(main.names) > 1:
        return
    sloping = lookup.inclined(names, who) if rubbing.is_rough(names) else []
    going_up = [way for way, sense in sloping if lookup.rises(names, way, sense)]  # what goes down does not turn back
    if rubbing.is_rough(names) and (lookup.springs(names) or lookup.elastic_strings(names)):
        going_up = lookup.places(names, who)  # a spring may push it back
    yield [f"{way} {'' if negated else 'never '}turns back" for way in going_up]
    if not going_up and not negated and _may_stick(names, who):
        yield [f"{who or 'it'} stops"]


def _may_stick(names: Names, who: str) -> bool:
    """Whether what comes to rest, and has contacts that may change, is held by one where it stops."""
    if who not in names.bodies or not can_change(names):
        return True
    return bool(sticking(names, who, connections_of(names, who, ("find",))))


def _without_beginning(main: Clause) -> Clause:
    """The block begins to slip: it slips."""
    return main.without("verb", *_BEGINS) if {*main.all("verb")} - {*_BEGINS} else main


def _staying_on(names: Names, main: Clause) -> Clause:
    """What stays on what it may leave stays in contact with it, and is not at rest there."""
    others = [name for before, name in main.names if before in ("on", "in")]
    if main.all("verb") != ["hold"] or len(main.names) != 2 or len(others) != 1:
        return main
    open_ = [row.connection for row in names.constraint_rows if row.unilateral]
    leaves = any(all(joining.touches(names, joint, name) for _, name in main.names) for joint in open_)
    kept = [Word("verb", "stay_on") if word.kind == "verb" else word for word in main.words]
    return Clause(kept) if leaves and not lookup.rests(names) else main
