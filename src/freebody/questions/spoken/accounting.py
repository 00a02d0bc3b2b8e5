"""Whether what is understood is of the kind that was asked for, and goes the way that was said.

Names and numbers are kept in keeping.py. Here the other words are looked after that say which quantity is meant: a
force is no torque, a component is no vector, a place is no extreme of it, and a parameter has the unit of what is
asked.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from itertools import pairwise, takewhile
from typing import TYPE_CHECKING

from freebody.language.expression import free_symbols
from freebody.language.units import FORCE, LENGTH, MASS
from freebody.questions.spoken import driving, given, joining, lookup, of_axles, rubbing
from freebody.questions.spoken.composing import ALONG
from freebody.questions.spoken.in_the_impact import is_of_impact
from freebody.questions.spoken.lexicon import Word
from freebody.questions.spoken.unneeded import is_pivot

if TYPE_CHECKING:
    from freebody.model.names import Names

_PUSHES = frozenset(
    {
        *("force", "contact force", "tension", "normal force", "friction force", "reaction", "bearing reaction"),
        *("spring force", "axial force", "tooth force", "driving force"),
    }
)
_TURNS = frozenset({"moment", "torque", "driving torque", "friction torque"})
_FREQUENCIES = frozenset({"natural frequency", "natural frequencies", "period of small oscillations"})
_EXERTS = tuple(Word("verb", verb) for verb in ("exert", "act", "carry"))
_OF_LOAD = re.compile(r"(?:greatest|least) force in ")
PLACED = ("high", "far")  # how high, how far, something acts: where
_POSE_OF_PART = {Word("part", "horizontal"), Word("part", "vertical")}
_FROM = Word("preposition", "from")
_BETWEEN, _ALL = Word("preposition", "between"), Word("pronoun", "system")
_WAYS = {*ALONG, "uphill", "downhill"}  # what goes that way is a component, or an instant of a motion that way
TURNED_ROUND = re.compile(r"^(?:value|range|least|largest) (?:of )?(?P<parameter>\w+) (?:for|so|that) ")
_CHANGES = ("fall", "rise", "grow", "shrink", "change")
_RANGE = Word("degree", "range")
_HIGHEST = (Word("instant", "at the top"), Word("instant", "at the bottom"))
_HELD_THROUGHOUT = re.compile(r" (?:never leaves|stays on)\b")
_NO_QUANTITY = re.compile(r"^(?:value|range|least|largest|ratio|does|is|when|whether|time|change|energy|work|turns) ")
_OF_MOTION = re.compile(r"^[|-]?(?:greatest |least )?(?:angular )?(?:speed|velocity|acceleration) of ")
_MOVED = re.compile(_OF_MOTION.pattern + r"(?P<body>\w+)(?! relative)")
# kinds of quantities, and how words of the grammar ask for one of them, or say when something is so of it
_SAID = (
    (
        _PUSHES,
        re.compile(
            r"\b(?:force|tension|pull|reaction|impulse|moment|torque|opens|leaves|slack|contact is lost|phase lag)\b"
        ),
    ),
    (
        frozenset({"energy", "kinetic energy", "potential energy", "total energy", "spring energy", "power"}),
        re.compile(r"\b(?:energy|power|work)\b|\^2 / \(2"),
    ),
    (frozenset({"acceleration", "angular acceleration"}), re.compile(r"\b(?:acceleration|deceleration|rate)\b")),
)
_TORQUE = re.compile(r"\b(?:torque|moment) (?:of|on) ")
_OF_TORQUE = re.compile(r"\b(?:torque|moment|impulse|power)\b|\bforce in |/|\*")
_COMPONENT = re.compile(r"\b(?:along|horizontal|vertical|when|until|normal|while|tension)\b")


def _behind(words: Sequence[Word], quantity: str) -> list[Word]:
    """What stands behind a quantity, and before a mark."""
    begin = next((k + 1 for k, word in enumerate(words) if word == Word("quantity", quantity)), len(words))
    return [*takewhile(lambda word: word.kind not in ("mark", "verb"), words[begin:])]


def is_accounted_for(names: Names, words: Sequence[Word], text: str) -> bool:
    """Whether words of the grammar ask for a quantity of the kind that words of a text name, along the way they say."""
    asked = {word.what for word in words if word.kind == "quantity"}
    if Word("verb", "stop") in words and _NO_QUANTITY.match(text) and not TURNED_ROUND.match(text):
        begins = [after.what for before, after in pairwise(words) if before == _FROM]  # stopped from 10 rad/s
        if any(text.endswith(f"= {value}") for value in begins):
            return False
    if turned := TURNED_ROUND.match(text):
        if Word("filler", "must") in words and _is_least_push(names, words):
            return False  # the push that is needed is none that is given, and its least is no least of a parameter
        if _RANGE in words and text.startswith(("least ", "largest ")):  # between which values
            return False
        if _HELD_THROUGHOUT.search(text) and any(word in _HIGHEST for word in words):  # at the top is not always
            return False
        is_tilt = given.counts_from_level(names, turned["parameter"])
        if is_tilt and any(word.kind == "part" and word.what == "vertical" for word in _behind(words, "angle")):
            return False  # its angle with the vertical
        if _is_of_another_force(names, words, text) or _holds_elsewhere(names, words, turned["parameter"]):
            return False
        return _has_unit(names, words, turned["parameter"]) and not is_of_impact(names, words, text)
    if _is_extreme(text) and _is_to_be_so(words, text):
        return False
    if not names.space and asked == {"angular velocity"} and Word("verb", "hit") in words and _POSE_OF_PART & {*words}:
        return False  # it hits while it is level, which is no part of how fast it turns
    if _NO_QUANTITY.match(text):
        return True
    if _is_extreme(text) and _is_of_change(words):
        return False
    if Word("filler", "may") in words:  # what can be reached by choice is none of this motion
        if rubbing.is_still(names) and _OF_MOTION.match(text):
            return False
        if asked & {"acceleration", "deceleration"} and given.growing(names, []):
            return False
        is_extreme = _is_extreme(text)
        is_place = bool(asked) and asked <= {"height", "position", "distance"}
        if (is_place or _OF_LOAD.match(text)) and any(
            word in _EXERTS for word in words
        ):  # what can be exerted, and where
            return False
        does = any(word.kind == "verb" for word in words)
        if asked & _PUSHES and (Word("verb", "rise") in words or (is_extreme and not does)):  # what load it can lift
            return False
    if Word("filler", "must") in words and asked == {"force"} and _is_pushed(names, words, text):
        return False
    is_to_be = Word("filler", "must") in words and any(word.what in ("to", "so_that") for word in words)
    if is_to_be and _OF_MOTION.match(text):  # how fast it must be pushed, so that it leaves
        return False
    moved = _MOVED.match(text)
    if moved and moved["body"] in names.bodies and names.bodies[moved["body"]].fixed:
        return False
    if asked & _FREQUENCIES and _is_about_path(names, words) and " about " not in text:
        return False  # about a circle, which is no equilibrium
    if loses_quantity(words, text):
        return False
    is_push, is_turn = bool(asked & _PUSHES), bool(asked & _TURNS)
    if is_push and not is_turn and _TORQUE.search(text):
        return False
    if is_turn and not is_push and not _OF_TORQUE.search(text):
        return False
    if is_push and not _is_between_all(names, words, text):
        return False
    main = [*takewhile(lambda word: word.kind != "mark", words)]
    goes = any(word.kind in ("part", "updown") and word.what in _WAYS for word in main)
    if goes and asked & (_PUSHES | _TURNS) and not _COMPONENT.search(text):
        return False
    is_place = Word("ask", "where") in words and not asked
    return not (is_place and _is_extreme(text))


def _is_about_path(names: Names, words: Sequence[Word]) -> bool:
    """Whether something is to be about what is no axle."""
    about = Word("preposition", "about")
    return any(
        word == about and not is_pivot(names, words, k + 1 + _n_fillers(words, k + 1)) for k, word in enumerate(words)
    )


def _is_least_push(names: Names, words: Sequence[Word]) -> bool:
    """Whether the least, or the greatest, is said of a push behind the parameter that is asked for."""
    said = [word for word in words if word.kind != "filler"]
    *head, last, end = [*[Word("", "")] * 2, *said]
    is_push = last.what in _PUSHES | _TURNS or last.what in names.loads
    return end.kind == "degree" and is_push and any(word.kind == "name" for word in head)


def _n_fillers(words: Sequence[Word], begin: int) -> int:
    return len([*takewhile(lambda word: word.kind == "filler", words[begin:])])


def loses_quantity(words: Sequence[Word], text: str) -> bool:
    """Whether words name a quantity of a kind that words of the grammar do not ask for, nor for what it depends on."""
    asked = {word.what for word in words if word.kind == "quantity"}
    is_of_something_else = TURNED_ROUND.match(text) or _NO_QUANTITY.match(text)
    return not is_of_something_else and any(asked & kinds and not said.search(text) for kinds, said in _SAID)


def _is_of_another_force(names: Names, words: Sequence[Word], text: str) -> bool:
    """Whether a force that is to be so is of a connection that nobody names, where another force is named: that of the
    buffer, whose stiffness is asked for, is no force of the rail."""
    pushing = {*names.connections, *names.loads}
    named = {word.what for word in words if word.kind == "name"} & pushing
    forces = {word.what for word in words if word.kind == "quantity"} & {"force", "contact force", "reaction"}
    found = {*re.findall(r"[^\W\d]\w*", text)} & pushing
    return bool(forces and named and found) and not named & found


def _holds_elsewhere(names: Names, words: Sequence[Word], parameter: str) -> bool:
    """Whether what holds a gear fast is asked for, and a parameter is that of the only load, which acts on another
    body: the gear is held by no load that the model has."""
    held = {word.what for word in words if word.kind == "name"} & names.bodies.keys()
    if Word("verb", "hold") not in words or not held:
        return False
    if any(names.bodies[body].fixed for body in held):
        return True
    acting = [(free_symbols(p.law), {*p.measure.bodies()}) for p in names.applied_loads]
    acted = {body for used, bodies in acting if parameter in used for body in bodies}
    is_alone = all(parameter in used for used, _ in acting)
    return is_alone and not held & acted and any(of_axles.axle_of(names, body) == "center" for body in held)


def _is_pushed(names: Names, words: Sequence[Word], text: str) -> bool:
    """Whether the force that a body needs is that of a load on it, and is taken for what holds it."""
    bodies = {word.what for word in words if word.kind == "name"} & {*names.bodies}
    chosen = given.chosen(names, given.KIND_OF["force"], [])
    pushed = {body for p in names.applied_loads if free_symbols(p.law) & {*chosen} for body in p.measure.bodies()}
    is_joint = any(word.kind == "name" and word.what in names.connections for word in words)
    return text.startswith("reaction of ") and bool(bodies & pushed) and not is_joint


def _is_extreme(text: str) -> bool:
    return text.startswith(("greatest ", "least "))


def _is_of_change(words: Sequence[Word]) -> bool:
    """Whether by how much a quantity grows, or falls, is asked for: not how large it is at most."""
    said = [word for word in words if word.kind != "filler"]
    falls = any(
        one.kind == "quantity" and after.kind == "verb" and after.what in _CHANGES for one, after in pairwise(said)
    )
    return falls and said[0] in (Word("ask", what) for what in ("with", "far", "much", "large"))


def _is_to_be_so(words: Sequence[Word], text: str) -> bool:
    """Whether a choice is asked for: the least friction with which it holds is no least of what friction does."""
    return Word("mark", "so_that") in words or (text.startswith("least ") and Word("filler", "must") in words)


def _is_between_all(names: Names, words: Sequence[Word], text: str) -> bool:
    """Whether a force that is said to be between both bodies is of what joins them."""
    said = [word for word in words if word.kind != "filler"]
    both = any(said[k : k + 2] == [_BETWEEN, _ALL] for k in range(len(said)))
    bodies = lookup.massive(names)
    if not both or len(bodies) != 2:
        return True
    joints = [name for name in names.connections if re.search(rf"\b{re.escape(name)}\b", text)]
    return all(joining.touches(names, joint, body) for joint in joints for body in bodies)


def _is_beside_asked(names: Names, words: Sequence[Word], parameter: str) -> bool:
    """Whether a parameter only says of what something else is that is asked for: what mass can a pull of F hold."""
    said = [word for word in words if word.kind != "filler"]
    asks, kind, behind = [*said, *[Word("", "")] * 3][:3]
    if asks.kind != "ask" or Word("name", parameter) not in said[3:] or Word("name", parameter) in (kind, behind):
        return False
    k = said.index(Word("name", parameter))
    if kind.kind == "name" and k > 3 and said[k - 1] == Word("preposition", "of"):  # what load can a pull of F hold
        return said[k - 2].what in _PUSHES or said[k - 2].what in names.loads
    if kind.kind != "quantity" or kind.what not in given.KIND_OF:
        return False
    told, is_mass = names.parameters[parameter], kind.what == "mass"
    return told.dimension != MASS if is_mass else given.is_by_unit(kind.what) and not given.KIND_OF[kind.what].has(told)


def _has_unit(names: Names, words: Sequence[Word], parameter: str) -> bool:
    """Whether a parameter that nobody names is of a kind that is named before what is to be so."""
    is_placed = any(word.kind == "ask" and word.what in PLACED for word in words) and Word("verb", "exert") in words
    if is_placed and parameter in names.parameters:
        return names.parameters[parameter].dimension == LENGTH or any(
            word.kind == "name" and word.what == parameter for word in words
        )
    if parameter in names.parameters and _is_beside_asked(names, words, parameter):
        return False
    if parameter not in names.parameters or any(word.kind == "name" and word.what == parameter for word in words):
        return True
    main = [*takewhile(lambda word: word != Word("mark", "so_that"), words)]
    if Word("ask", "heavy") in main:  # how heavy may it be, so that the force in the hitch is at most 3 kN
        return names.parameters[parameter].dimension in (MASS, FORCE)
    placed = [given.ASKED_BY[word.what] for word in main if word.kind == "ask" and word.what in PLACED]
    is_turned = Word("verb", "turn") in main and names.parameters[parameter].is_angle  # how far it may be tilted
    if placed and not is_turned and all(word.kind != "quantity" for word in main):
        return placed[0].has(names.parameters[parameter])  # how high the water may stand, so that a force is small
    kinds = [given.KIND_OF[w.what] for w in words if w.kind == "quantity" and w.what in given.KIND_OF]
    if not kinds or any(kind.written for kind in kinds):
        return True
    if parameter in driving.drive_parameters(names):  # the speed of what turns
        kinds += [given.KIND_OF["angular velocity"]] if given.KIND_OF["speed"] in kinds else []
    if given.KIND_OF["impulse"] in kinds:  # of what turns, an angular one
        kinds += [given.KIND_OF["angular impulse"]]
    return any(kind.has(names.parameters[parameter]) for kind in kinds)
