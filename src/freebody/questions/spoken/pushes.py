"""Words for what pushes, holds or drives, put as the grammar has them: whose force or torque is meant."""

from __future__ import annotations

from typing import TYPE_CHECKING

from freebody.measures.geometry import GROUND
from freebody.questions.spoken import (
    driving,
    given,
    joining,
    lookup,
    losing,
    rubbing,
    transmitting,
)
from freebody.questions.spoken.composing import SILENT
from freebody.questions.spoken.events import GOES_ON
from freebody.questions.spoken.lexicon import Word
from freebody.questions.spoken.words import Clause

if TYPE_CHECKING:
    from freebody.model.names import Names


_FOR = Word("preposition", "of")  # friction for rolling
_HOW_HARD = (Word("ask", "large"), Word("ask", "much"))
_PUSHES = ("force", "torque", "moment", "driving force", "driving torque")
_SO_THAT, _TO = Word("mark", "so_that"), Word("mark", "to")
_TURNS = ("torque", "moment", "driving torque")
_DRIVEN = ("move", "turn", "exert", "accelerate", "rise", "fall")  # what a motor does with something
_RUNS = ("slack tension", "tight tension")  # of the two runs of a belt
_PULLS = ("force", "tension", "belt force")
_TRANSMITS = tuple(Word("verb", verb) for verb in ("carry", "exert", "act"))
_TRANSMITTED = ("torque", "moment", "driving torque", "power", "transmitted power")


def hauled(names: Names, words: list[Word], modal: set[str]) -> list[Word]:
    """How far one must pull on the rope is how far that end of it must move on which a force acts."""
    pulls = [w for w in words if w in (Word("verb", "exert"), Word("verb", "become"))]
    if words[:1] == [Word("ask", "far")] and "must" in modal and _SO_THAT in words and pulls[:1] != []:
        k, move = words.index(_SO_THAT), Word("verb", "move")  # how far it must be pulled is how far it must move
        head = [w for w in words[:k] if w not in (*pulls, move, Word("preposition", ","))]
        words = [*head, move, *words[k:]] if move in words[:k] or Word("verb", "exert") in pulls else words
    ropes = [w for w in words if w.kind == "name" and w.what in names.connections and w.what not in names.bodies]
    if words[:1] != [Word("ask", "far")] or "must" not in modal or len(ropes) != 1 or Word("verb", "move") not in words:
        return words
    acted = {body for load in lookup.driving(names) if (body := lookup.acted_on(names, load)) in names.bodies}
    ends = [body for body in sorted(acted) if joining.touches(names, ropes[0].what, body)]
    return [Word("name", ends[0]) if word == ropes[0] and len(ends) == 1 else word for word in words]


def held_by_clamp(names: Names, words: list[Word]) -> list[Word]:
    """The torque that holds the arm, where the ground holds it fast: the moment of what it is clamped by."""
    torque, of = Word("quantity", "torque"), [word.what for word in words if word.kind == "name"]
    if torque not in words or len(of) != 1 or of[0] not in lookup.moving(names):
        return words
    clamps = [name for name in joining.joints(names, of[0], GROUND, "moment") if "weld" in names.called.get(name, ())]
    if len(clamps) != 1:
        return words
    put = {torque: Word("quantity", "moment"), Word("name", of[0]): Word("name", clamps[0])}
    return [put.get(word, word) for word in words]


def pulling(names: Names, words: list[Word]) -> list[Word]:
    """How strongly does the car pull the trailer: the force between both, where no rope is."""
    pull = Word("quantity", "tension")
    k = words.index(pull) if pull in words else 0
    after = [word for word in words[k + 1 :] if word.kind != "preposition"]
    is_asked = words[:1] in ([word] for word in _HOW_HARD) and [w.kind for w in words[1:k]] == ["name"]
    both = [word.what for word in (*words[1:k], *after[:1])]
    if not k or not is_asked or not both[1:] or not {*both} <= {*lookup.moving(names)}:
        return words
    between = [joint for joint in names.connections if all(joining.touches(names, joint, body) for body in both)]
    pulled = {row.connection for row in names.constraint_rows if row.reaction == "tension"}
    if len(between) != 1 or between[0] in pulled:
        return words
    on = [Word("preposition", "on"), *after]
    return [Word("quantity", "reaction"), _FOR, Word("name", between[0]), *on]


def taken_along(names: Names, words: list[Word]) -> list[Word]:
    """The block with the bullet, of which both are one after the impact: the block."""
    for k in range(1, len(words) - 1):
        both = [words[k - 1], words[k + 1]]
        leads = words[k] in (Word("preposition", "from"), Word("preposition", "with"))
        bodies = [word.what for word in both if word.kind == "name" and word.what in lookup.moving(names)]
        if leads and len(bodies) == len(both) and not any(names.bodies[body].turns for body in bodies):
            pins = [joint for joint in names.connections if "pin" in names.called.get(joint, ())]
            if any(all(joining.touches(names, joint, body) for body in bodies) for joint in pins):
                return [*words[:k], *words[k + 2 :]]
    return words


def by_joint(names: Names, words: list[Word]) -> list[Word]:
    """With what force does the hitch pull the trailer, where the hitch is no rope: its force on it."""
    exert, force = Word("verb", "exert"), Word("quantity", "force")
    pulls = [word for word in words if word in (exert, Word("quantity", "tension"))]
    of = [word for word in words if word.kind == "name"]
    asks = words[:1] in ([Word("ask", "with")], [Word("ask", "what")], *([word] for word in _HOW_HARD))
    plain = all(word.kind in ("ask", "name", *SILENT) or word in (exert, force, *pulls) for word in words)
    is_between = [word for word in words if word in (*pulls, *of)] == [*of[:1], *pulls, *of[1:]]
    if not (asks and plain and len(pulls) == 1 and len(of) == 2 and is_between):  # the hinge of the lever is loaded
        return words
    joint, body = of[0].what, of[1].what
    pulled = {row.connection for row in names.constraint_rows if row.reaction in ("tension", "normal force")}
    is_joint = "pin" in names.called.get(joint, ()) and joint not in names.bodies and joint not in pulled
    if not is_joint or body not in lookup.moving(names) or not joining.touches(names, joint, body):
        return words
    return [Word("quantity", "reaction"), _FOR, of[0], Word("preposition", "on"), of[1]]


def given_by_joint(names: Names, words: list[Word]) -> list[Word]:
    """What momentum the coupling gives the cart is its impulse on it."""
    momentum = Word("quantity", "linear momentum")
    joint = next((w.what for w in words if w.kind == "name"), "")
    is_given = momentum in words and joint in names.connections and joint not in names.bodies
    kept = [w for w in words if w.kind not in ("ask", "verb")]
    return [Word("quantity", "impulse") if word == momentum else word for word in kept] if is_given else words


def enough_to(words: list[Word]) -> list[Word]:
    """Large enough to hold it is what is needed to; whether it is enough is no limit."""
    enough = Word("verb", "suffice")
    k = words.index(enough) if enough in words[2:] else 0
    behind = [word for word in words[k + 1 :] if word not in (Word("preposition", "to"), Word("preposition", ","))]
    is_asked = words[:1] and (words[0].kind == "degree" or words[0] in (Word("ask", "what"), Word("ask", "with")))
    if not k or not is_asked or not behind or Clause(words[:k]).has("mark"):
        return words
    head = [word for word in words[:k] if word != Word("part", "only")]
    behind = behind if behind[0].kind != "mark" else behind[1:]
    return [*head, _TO, *behind]


def runs_slack(words: list[Word]) -> list[Word]:
    """A run of a belt that goes slack pulls with nothing; what pulls in a run is its tension."""
    runs = [k for k, w in enumerate(words) if w.kind == "quantity" and w.what in _RUNS]
    slack = Word("verb", "slack")
    words = [Word("verb", "vanish") if runs and word == slack else word for word in words]
    for k in reversed(runs):  # the force in the slack run is its tension
        lead = next((j for j in range(k - 1, -1, -1) if words[j].kind != "preposition"), None)
        if lead is not None and words[lead].kind == "quantity" and words[lead].what in _PULLS:
            words = [*words[:lead], *words[k:]]
    return words


def transmitted(names: Names, words: list[Word], modal: set[str]) -> list[Word]:
    """The greatest torque that can be transmitted, where nothing is named: by the only thing that slips beyond one."""
    greatest = Word("degree", "greatest")
    asked = [k for k, word in enumerate(words) if word.kind == "quantity"]
    known = all(word.kind in ("ask", "degree", "quantity", "verb", *SILENT) for word in words)
    is_limit = any(word in _TRANSMITS for word in words) and known and (greatest in words or modal == {"may"})
    if not is_limit or len(asked) != 1 or words[asked[0]].what not in _TRANSMITTED:
        return words
    slipping = [*transmitting.having(names, "greatest belt force"), *losing.clutches(names)]
    return [greatest, words[asked[0]], _FOR, Word("name", slipping[0])] if len(slipping) == 1 else []


def driven_by_needed(names: Names, words: list[Word]) -> list[Word]:
    """The torque needed to turn the crank, where a motor says how it turns, is that of the motor."""
    kinds = {"torque": "driving torque", "moment": "driving torque", "force": "driving force"}
    words = _as_driven(names, words)
    told = [word for word in words if word.kind != "filler"]
    if [word.kind for word in told[:4]] == ["ask", "quantity", "verb", "name"]:
        told = [*told[:2], _TO, *told[2:]]  # what force moves the trolley
    k = told.index(_TO) if _TO in told else 0
    asked = [word for word in told[:k] if word.kind != "ask"]
    behind = [word for word in told[k + 1 :] if word.kind != "filler" and word != Word("preposition", "to")]
    said, rest = behind[:2], behind[2:]  # to move the trolley; um die Katze zu bewegen
    goes = [word.what for word in said if word.kind == "verb" and word.what in _DRIVEN]
    who = [word.what for word in said if word.kind == "name"]
    if not goes or not who or not asked or asked[0].what not in kinds:
        return words
    push = kinds[asked[0].what]
    driven = [body for body in (who[0], *joining.joined_by(names, who[0])) if driving.drivers(names, body, push)]
    if not driven:
        return words
    thing = driven[0] if push == "driving torque" else driving.drivers(names, driven[0], push)[0]
    return [Word("quantity", push), *asked[1:], Word("name", thing), *rest]


def at_driven_joint(names: Names, words: list[Word], modal: set[str]) -> list[Word]:
    """The torque that slewing takes, the power of the slewing drive: of what drives that joint, for the joint itself
    transmits none of it."""
    kinds = {"torque": "driving torque", "moment": "driving torque", "force": "driving force"}
    pushes = {*kinds, *kinds.values(), "power"}
    k = next((k for k, word in enumerate(words) if word.kind == "quantity" and word.what in pushes), None)
    joints = [word.what for word in words if word.kind == "name" and word.what in names.connections]
    is_of_drive = "must" in modal or Word("verb", "move") in words or Word("part", "driving") in words
    if k is None or len(joints) != 1 or not (is_of_drive or words[k].what in kinds.values()):
        return words
    drives = driving.drives_of(names, joints[0])
    if len(drives) != 1 or drives == joints:
        return words
    meant = Word("quantity", kinds.get(words[k].what, words[k].what))
    told = [meant if word == words[k] else word for word in words]
    told = [Word("name", drives[0]) if word == Word("name", joints[0]) else word for word in told]
    return [word for word in told if word not in (Word("verb", "move"), Word("part", "driving"))]


def _as_driven(names: Names, words: list[Word]) -> list[Word]:
    """The torque of the motor, so that the hoop turns uniformly, where that is how the motor turns it."""
    marks = [k for k, word in enumerate(words) if word in (_TO, _SO_THAT)]
    if len(marks) != 1:
        return words
    head, tail = Clause(words[: marks[0]]), Clause(words[marks[0] + 1 :])
    drivers = [name for _, name in head.names if "driver" in names.called.get(name, ())]
    goes = tail.only("verb", "name", "not", *SILENT) and set(tail.all("verb")) <= {*GOES_ON, "hold", "no_accel"}
    steady = not tail.has("not") or tail.has("verb", "accelerate")
    is_push = bool(set(head.all("quantity")) & {*_PUSHES}) and not head.has("degree")
    return head.words if drivers and goes and steady and is_push and tail.has("verb") else words


def heaviest(names: Names, words: list[Word]) -> list[Word]:
    """The largest load that F can hold is no F: it is how heavy the load may be."""
    named = [word.what for word in words if word.kind == "name"]
    holds = words[-1:] in ([Word("verb", "hold")], [Word("verb", "rise")], [Word("verb", "move")])
    is_body = named[:1] != [] and named[0] in names.bodies and len(named) <= 2
    is_body = is_body and all(name in names.parameters for name in named[1:])
    holds = holds and (words[-1] == Word("verb", "hold") or not rubbing.is_held_by_friction(names))
    if not holds or not is_body or words[0] != Word("degree", "greatest") or words[1].kind != "name":
        return words
    return [
        words[0],
        Word("quantity", "mass"),
        words[1],
        Word("mark", "so_that"),
        Word("pronoun", "it"),
        Word("verb", "hold"),
    ]


def needed_to_roll(names: Names, words: list[Word]) -> list[Word]:
    """The friction that rolling needs is the friction force, where it has no limit."""
    if words[:1] == [Word("ask", "rough")] or Word("quantity", "friction force") not in words:
        return words
    marks = [k for k, w in enumerate(words) if w in (_SO_THAT, Word("mark", "to"))]
    marks += [k for k in range(1, len(words)) if words[k - 1] == _FOR and words[k] == Word("verb", "roll")]
    tail = Clause(words[marks[0] :]) if marks else Clause()
    doing = set(tail.all("verb"))
    rolls = doing == {"roll"} or (doing == {"slide"} and tail.has("not"))
    if (
        not rolls
        or given.parameters(names, "friction coefficient", "")
        or not tail.only("mark", "verb", "not", "name", *SILENT)
    ):
        return words
    head = words[: marks[0] - (words[marks[0] - 1] == _FOR)]
    return head if any(word.kind == "name" for word in head) else [*head, *(w for w in tail.words if w.kind == "name")]


def holding(words: list[Word], modal: set[str]) -> list[Word]:
    """The friction that holds the crate is a force on it, where nothing says that it is to be enough for that."""
    friction, hold = Word("quantity", "friction force"), Word("verb", "hold")
    plain = all(word.kind in ("ask", "quantity", "verb", "name", *SILENT) for word in words)
    asks = {word.what for word in words if word.kind == "ask"} <= {"what", "large", "much"}
    is_force = plain and asks and not modal and [w for w in words if w.kind in ("quantity", "verb")] == [friction, hold]
    return [_FOR if word == hold else word for word in words] if is_force else words


def holding_fast(names: Names, words: list[Word]) -> list[Word]:
    """The torque that holds the ring gear, or is needed to hold it, is that on it, where the file holds it fast."""
    clause = Clause(words)
    fixed = joining.fixed_body(names, [name for _, name in clause.names])
    plain = clause.only("ask", "quantity", "verb", "name", "mark", *SILENT) and set(clause.all("mark")) <= {"to"}
    asked, doing = clause.all("quantity"), set(clause.all("verb"))
    if not (fixed and plain and len(asked) == 1 and asked[0] in _TURNS and "hold" in doing <= {"hold", "act", "exert"}):
        return words
    return [Word("quantity", asked[0]), Word("name", fixed)]


def by_friction(words: list[Word]) -> list[Word]:
    """Energy that is lost by friction is energy lost."""
    friction = Word("quantity", "friction force")
    is_lost = Word("quantity", "energy lost") in words or {Word("quantity", "energy"), Word("verb", "lost")} <= {*words}
    k = words.index(friction) if friction in words and is_lost else 0
    return [*words[: k - 1], *words[k + 1 :]] if k > 1 and words[k - 1].kind == "preposition" else words
