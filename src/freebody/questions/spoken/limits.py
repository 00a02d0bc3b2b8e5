"""How far a parameter may go until rest ends, as people put it.

How hard can one push before the block moves? How far up may the person climb without the ladder slipping? From which
force on is the load lifted? What is asked is a parameter (by name, or as the only one of its kind), one end of its
values or all of them, and what lasts: rest, or that nothing slips. Such words are read only of what rests at the start,
and none may be left over.
"""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

from freebody.language.expression import free_symbols
from freebody.measures.displacement import Displacement
from freebody.questions.spoken import given, joining, lookup, rubbing, transmitting
from freebody.questions.spoken.accounting import PLACED
from freebody.questions.spoken.composing import SILENT, Groups
from freebody.questions.spoken.keeping import n_freedoms
from freebody.questions.spoken.lexicon import Word
from freebody.questions.spoken.turning_round import rolls_down
from freebody.questions.spoken.words import Clause

if TYPE_CHECKING:
    from freebody.model.names import Names

_ENDS_REST = {"slide", "move", "fall", "rise", "turn", "start", "tip"}  # verbs of what comes where rest ends
_VERBS = _ENDS_REST | {"hold", "stop", "exert", "act", "end"}
_MARKS = ("until", "so_that", "to", "when", "without")
_OF_LIMIT = re.compile(r"^(?:least|largest|range of) (\w+) (?:so that|that keeps|for which) ")
_ALONG = {"horizontal": {"right", "left"}, "vertical": {"up", "down"}}  # a force, and the directions of a file
_TO_LEVEL, _TILTED = Word("quantity", "angle to the horizontal"), "from level"
_TILT = Word("part", _TILTED)
_HEAVY = Word("ask", "heavy")
_ALONG_SLOPE = {Word("part", "uphill"): Word("part", "upward"), Word("part", "downhill"): Word("part", "downward")}
_REST, _NO_SLIP, _NO_TIP = "it stays at rest", "it does not slip", "it does not tip"


def limits(names: Names, words: list[Word], modal: set[str]) -> Groups:
    """The end of the values of a parameter up to which rest lasts. modal: whether something `may` or `must` be."""
    modal = modal - {"may"} if "must" in modal else modal  # how large must it be so that he can stand
    words = [Word("verb", "hold") if word == Word("verb", "hang") else word for word in words]
    words = _how_heavy(names, words) if "may" in modal else words
    words = [_ALONG_SLOPE.get(word, word) for word in words]
    if rubbing.is_still(names) or rubbing.is_carried(names):  # the acceleration that can be reached
        light = {"reach", "accelerate"} | ({"move"} if Word("ask", "fast") in words and "may" in modal else set[str]())
        words = [w for w in words if w.kind != "verb" or w.what not in light]
    is_tilted = "may" in modal and {Word("ask", "far"), Word("verb", "turn")} <= {*words}
    if is_tilted:  # through what angle may it be tilted
        put = {Word("ask", "far"): Word("quantity", "angle")}
        words = [put.get(w, w) for w in words if w.kind != "verb" or w.what not in ("turn", "become")]
    words = _from_level(words)
    clause = Clause(words)
    known = clause.only("ask", "degree", "quantity", "name", "verb", "not", "mark", "instant", "part", *SILENT)
    if known and not lookup.rests(names):
        yield from _grip(names, words)
    if not known or not lookup.rests(names) or not set(clause.all("verb")) <= _VERBS:
        return
    ways = [part for part in clause.all("part") if part in _ALONG]
    clause = clause.without("part", *ways) if ways else clause
    parts = {"only", "upward", "downward", _TILTED}
    if set(clause.all("instant")) - {"in equilibrium"} or set(clause.all("part")) - parts:
        return
    words = [word for word in words if word.kind != "part" or word.what not in ways]
    if clause.has("ask", "where", "when", "long", "soon", "way"):
        return
    moving = [name for _, name in clause.names if name in names.bodies]
    turned = any(lookup.angles(names, body) for body in moving)
    if clause.all("verb") == ["stop"] and clause.has("quantity", "angle") and turned:
        return  # at what angle it comes to rest is that of the body
    if any(mark not in _MARKS for mark in clause.all("mark")) or len(clause.all("degree")) > 1:
        return
    if not modal and not (clause.has("ask") or clause.has("degree") or clause.has("mark")):
        return
    if (
        clause.all("quantity") == ["friction force"]
        and clause.has("degree", "greatest")
        and not set(clause.all("verb")) - {"become", "act", "exert"}
    ):
        return  # the greatest friction is a force, and no coefficient
    if {"tip", "slide"} <= set(clause.all("verb")) and clause.has("mark", "until"):
        return  # which of both comes first is no limit of rest
    if clause.has("mark", "until") and clause.has("verb", "end"):
        return  # up to which event something is counted
    if "until" in clause.all("mark")[1:]:
        return  # so that one gets to somewhere: that is a place, and no limit of rest
    head, state = _parted(names, words)
    begins = {"start", "slide"} <= set(clause.all("verb")) and not clause.has("ask", "fast")  # from which height on
    if clause.has("ask", "far", "high", "fast") and "may" not in modal and not begins:
        return  # how far something comes is no limit of rest
    lasts = _lasting(names, head, state, modal)
    if "slide" in state.all("verb") and not rubbing.is_rough(names):
        return  # nothing can
    parameter = _parameter(names, head, [name for _, name in state.names if name in names.loads])
    if lasts is None or parameter is None or _is_lifted_by_choice(names, clause, parameter):
        return
    is_tilt = names.parameters[parameter].is_angle and given.counts_from_level(names, parameter)
    if not is_tilt and Word("part", _TILTED) in words:
        return
    if not all(_pushes_along(names, parameter, way) for way in ways):
        return
    end = _end(names, head, state, modal)
    if end == "largest" and _hinders(names, state, parameter):
        return
    is_of_friction = parameter in given.parameters(names, "friction coefficient", "")
    says_nothing = lasts == _REST and not state.words and is_of_friction  # the least mu, of what rolls
    if (lasts == _NO_SLIP or says_nothing) and rolls_down(names):
        lasts = "it rolls without slipping"
    if end in ("least", "largest"):
        yield [f"{end} {parameter} so that {lasts}"]
    elif end == "range" and lasts not in (_REST, _NO_SLIP):
        yield [f"range of {parameter} for which {lasts}"]
    elif end == "range":
        yield [f"range of {parameter} that keeps it at rest"]


def _how_heavy(names: Names, words: list[Word]) -> list[Word]:
    """How much load can be held with the force F: how heavy it may be, where the force is as it is given."""
    plain = [word for word in words if word.kind != "filler"]
    asks, of = (plain[0], plain[1]) if len(plain) > 1 else (Word("", ""), Word("", ""))
    if asks in (Word("ask", "much"), Word("ask", "what"), _HEAVY):
        if of == Word("quantity", "mass"):
            plain = [_HEAVY, *plain[2:]]
        elif of.kind == "name" and of.what in names.bodies:
            plain = [_HEAVY, *plain[1:]]
    if plain[:1] != [_HEAVY]:
        return words
    for k, word in enumerate(plain):
        if word.kind != "preposition" or word.what not in ("from", "by", "with"):
            continue
        end = k + 1 + (plain[k + 1 : k + 2] == [Word("quantity", "force")])
        if plain[end : end + 1] and plain[end].kind == "name" and plain[end].what in names.parameters:
            return [*plain[:k], *plain[end + 1 :]]
    return plain


def _from_level(words: list[Word]) -> list[Word]:
    """The angle with the horizontal as an angle that counts from there."""
    angle, level = Word("quantity", "angle"), Word("part", "horizontal")
    words = [own for w in words for own in ((angle, _TILT) if w == _TO_LEVEL else (w,))]
    said = [k for k, w in enumerate(words) if w.kind != "filler"]
    for one, two, three in zip(said, said[1:], said[2:], strict=False):
        if words[one] == angle and words[two].kind == "preposition" and words[three] == level:
            return [*words[:two], _TILT, *words[three + 1 :]]
    return words


def _pushes_along(names: Names, parameter: str, way: str) -> bool:
    """Whether a parameter is that of a force which the file lets act in a direction: the horizontal force."""
    pushed = [load.measure for load in names.applied_loads if parameter in free_symbols(load.law)]
    return bool(pushed) and all(isinstance(m, Displacement) and m.along.name in _ALONG[way] for m in pushed)


def _is_lifted_by_choice(names: Names, clause: Clause, parameter: str) -> bool:
    """Whether it is asked how heavy, or how steep, something may be that is still lifted: no push, and no limit of rest
    where friction helps to hold it."""
    rises = clause.has("verb", "rise") or clause.has("updown", "up") or clause.has("part", "upward")
    k = next((k for k, word in enumerate(clause.words) if word.kind in ("name", "quantity")), 0)
    first, asks = clause.words[k], (Word("degree", "greatest"), Word("ask", "what"))  # what load, the heaviest load
    weighs = k > 0 and clause.words[k - 1] in asks and first.kind == "name" and first.what in names.bodies
    if _is_denied(clause) or not (rises or weighs or clause.has("verb", "move", "exert")):
        return False
    kinds = [given.ASKED_BY[ask] for ask in clause.all("ask") if ask in given.ASKED_BY]
    kinds += [given.KIND_OF[first.what]] if first.what in given.KIND_OF and first.kind == "quantity" else []
    if all(kind.is_push for kind in kinds) and (kinds or not weighs):
        return False
    is_push = any(kind.is_push and kind.has(names.parameters[parameter]) for kind in given.KINDS)
    return is_push or (rises and rubbing.is_held_by_friction(names))


def _grip(names: Names, words: list[Word]) -> Groups:
    """From what torque on does the belt slip: the largest with which it does not, while it runs."""
    head, state = _parted(names, words)
    rough = [*rubbing.rough(names, ""), *transmitting.having(names, "greatest belt force")]
    joints = [name for _, name in state.names if name in rough]
    alone = not joints and len(rough) == 1 and is_all_of(names, rough[0], [*head.names, *state.names])
    joints = rough if alone else joints
    parameter = _parameter(names, head)
    is_over = head.has("ask", "from", "with") or head.has("degree", "least")
    is_up_to = head.has("degree", "greatest") or head.has("ask", "up_to", "large", "far", "fast", "high")
    is_end = is_up_to if _is_denied(state) else is_over
    doing = set(state.all("verb"))
    if parameter and is_end and len(joints) == 1 and doing and doing <= {"slide", "start"}:
        yield [f"largest {parameter} so that {joints[0]} does not slip"]


def is_all_of(names: Names, joint: str, named: list[tuple[str, str]]) -> bool:
    """Whether all things that are named are parameters, or touch in a connection."""
    return all(name in names.parameters or joining.touches(names, joint, name) for _, name in named)


def _parted(names: Names, words: list[Word]) -> tuple[Clause, Clause]:
    """What is said of the parameter, and of what is to last: behind a mark, or from the body before a verb on."""
    marks = [k for k, word in enumerate(words) if word.kind == "mark" and word.what in _MARKS]
    verbs = [k for k, word in enumerate(words) if word.kind == "not"]
    verbs += [k for k, word in enumerate(words) if word.kind == "verb" and word.what not in ("exert", "act")]
    verbs += [k for k, word in enumerate(words) if word == Word("instant", "in equilibrium")]
    verbs += [k for k, word in enumerate(words) if word == Word("quantity", "equilibrium")]
    cut = min((*marks, *verbs), default=len(words))
    if marks and not (verbs and min(verbs) > min(marks)) and min(marks, default=0) > 0:
        cut = min(marks)
    chosen = [k for k, w in enumerate(words) if w.kind == "name" and w.what in names.parameters]
    while 0 < cut < len(words) and words[cut - 1].kind == "name" and cut - 1 not in chosen and not marks:
        if cut > 1 and words[cut - 2] == Word("preposition", "of"):
            break  # of what something is to be found
        cut -= 1  # who does something stands before the verb
    return Clause(words[:cut]), Clause(words[cut:])


def _lasting(names: Names, head: Clause, state: Clause, modal: set[str]) -> str | None:
    """What is to last, where the words say it, or only that something must do."""
    verbs = set(state.all("verb")) - {"exert", "act"}
    if state.has("quantity") and set(state.all("quantity")) != {"equilibrium"}:
        return None
    bodies = [name for _, name in state.names if name in names.bodies and not lookup.is_all_that_moves(names, name)]
    verbs = verbs - {"start"} or verbs
    is_moved = verbs in ({"move"}, {"start"}) and not state.has("part") and not state.has("updown")
    bodies = [] if is_moved and n_freedoms(names) == 1 else bodies  # where one moves, all do
    joints = [
        name for _, name in state.names if "." in name or (name in names.connections and name not in names.bodies)
    ]
    if any(names.bodies[name].fixed for name in bodies) or (joints and verbs & {"rise", "fall"}):
        return None  # what is held already
    if bodies and not rubbing.is_rough(names) and _is_subject(state):
        return None  # that one of several bodies stays where it is
    is_lifted = verbs <= {"rise", "start"} and "rise" in verbs  # not along what it touches
    if not is_lifted and (joint := rubbing.slipping(names, [name for _, name in state.names])) is not None:
        lasts = verbs <= {"slide", "start", "move"} and "slide" in verbs
        is_between = len(state.names) > 1 and verbs == {"hold"} and not state.has("not")
        return f"{joint} does not slip" if lasts or is_between else None
    holds = (
        verbs & ({"hold", "stop"} if rubbing.is_rough(names) else {"hold"})
        or state.has("instant", "in equilibrium")
        or state.has("quantity", "equilibrium")
    )
    ends = verbs & _ENDS_REST
    is_denied = _is_denied(state)
    if holds and (not ends or is_denied):
        return _REST if ends or not state.has("not") else None
    if not verbs and head.has("degree", "least", "greatest") and not modal and not state.words:
        return _REST if _is_alone(names, head) else None
    if not verbs:
        if "must" in modal and not state.words and head.has("quantity", "friction coefficient"):
            return _REST
        is_bounded = head.has("degree", "least", "greatest", "range") or head.has(
            "ask", "steep", "flat", "heavy", "rough", "fast", *(["small"] if head.has("quantity") else [])
        )
        return _REST if modal and is_bounded and not state.words and rubbing.is_rough(names) else None
    if not ends:
        return None
    if {"tip", "slide"} <= ends <= _ENDS_REST:  # it neither slips nor tips
        return _REST if is_denied and all(rubbing.is_all_that_slips(names, body) for body in bodies) else None
    if "tip" in ends:
        bodies = bodies or [name for _, name in head.names if name in names.bodies]
        alone = len(lookup.massive(names)) == 1 or (
            bodies != [] and all(rubbing.is_all_that_slips(names, body) for body in bodies)
        )
        return _NO_TIP if ends <= {"tip", "start", "move"} and alone else None
    if "slide" in ends:
        if all(rubbing.is_all_that_slips(names, body) for body in bodies):
            return _NO_SLIP
        return _REST if n_freedoms(names) == 1 and "start" in state.all("verb") else None  # all moves with it
    return _REST if not bodies or ("rise" in ends and not is_denied) else None


def _is_alone(names: Names, head: Clause) -> bool:
    """Whether the least mu, the largest load is asked for and nothing else: of what is given, where rest ends."""
    parameter = _parameter(names, head)
    if head.has("degree", "least"):
        return parameter in given.parameters(names, "friction coefficient", "")
    others = [name for _, name in head.names if name not in names.parameters and name not in names.loads]
    if rubbing.is_still(names) and any(map(given.is_by_unit, head.all("quantity"))):  # acceleration of the car
        others = [name for name in others if not lookup.is_all_that_moves(names, name)]
    is_weight = len(others) == 1 and not head.has("quantity") and others[0] in names.bodies
    return parameter is not None and rubbing.is_rough(names) and (not others or is_weight)


def _parameter(names: Names, head: Clause, against: list[str] | None = None) -> str | None:
    """The parameter that is meant: the one that is named, or the only one of the kind that is. against: loads that are
    lifted, or held, by it."""
    named = [name for _, name in head.names if name in names.parameters]
    others = [name for _, name in head.names if name not in names.parameters]
    if len(named) > 1:
        return None
    if len(asked := head.all("quantity")) > 1 or not all(map(given.can_end_rest, asked)):
        return None
    if named:
        return named[0]
    if asked == ["tension"] and any(name in names.connections or "." in name for name in others):  # nobody chooses it
        return None
    by_asking = [given.ASKED_BY[ask] for ask in head.all("ask") if ask in given.ASKED_BY]
    kinds = [given.KIND_OF[word] for word in asked] or by_asking
    if by_asking and head.has("ask", *PLACED) and head.has("verb", "exert", "act"):  # at which height may it act
        kinds = by_asking
    loads = [name for name in others if name in names.loads]
    if not kinds and (head.has("verb", "exert") or loads):
        kinds = [given.KIND_OF["force"]]
    if not kinds and len(others) == 1 and others[0] in names.bodies and head.has("degree"):  # the largest load that ..
        kinds = [given.KIND_OF["mass"]]
    found = given.chosen(names, kinds[0], others) if kinds else []
    if len(found) > 1 and against:
        found = [name for name in found if name not in given.chosen(names, kinds[0], against)]
    if len(found) > 1:  # of two angles the one of which the file itself asks for the limit
        asked = {one[1] for question in names.usual_questions if (one := _OF_LIMIT.match(question)) is not None}
        found = [name for name in found if name in asked] if len(asked & {*found}) == 1 else found
    return found[0] if len(found) == 1 else None


def _end(names: Names, head: Clause, state: Clause, modal: set[str]) -> str:
    """Which end of the values is meant; `range` where the words leave it open, nothing where they contradict."""
    [degree] = head.all("degree")[:1] or state.all("degree")[:1] or [""]
    ends_rest = set(state.all("verb")) & _ENDS_REST
    is_denied = _is_denied(state)
    starts = bool(ends_rest) and not is_denied
    if starts and len({"rise", "fall", "hold"} & {*state.all("verb")}) > 1:  # what raises it, and what holds it
        return ""
    if state.has("part", "only") and is_denied and not degree:  # it just does not move
        named = [names.parameters[name] for _, name in head.names if name in names.parameters]
        pushes = all(kind.is_push for kind in given.KINDS for one in named if kind.dimension and kind.has(one))
        degree = "greatest" if _is_push(head) and pushes and "must" not in modal else ""
    if head.has("ask", "flat", "small"):  # how flat at most: the least
        degree = {"least": "greatest", "greatest": "least"}.get(degree, degree)
    if "slide" in ends_rest and (state.has("part", "downward") or head.has("part", "downward")):
        return "least" if degree == "least" and is_denied else "range" if not degree else ""
    if degree in ("least", "greatest"):
        if starts and "fall" in ends_rest and not is_denied and _is_push(head):
            return degree if degree == "least" else ""
        if starts and "hold" not in state.all("verb"):  # the least force that moves it is the largest that does not
            return {"least": "largest"}.get(degree, "")
        return {"greatest": "largest"}.get(degree, degree)
    if degree not in ("", "value", "range"):
        return ""
    if head.has("ask", "flat", "small"):
        return "least" if "may" in modal and not starts else ""
    is_up = head.has("ask", "large", "far", "high", "heavy", "steep", "rough", "fast")
    if head.has("ask", "up_to") or (is_up and not starts and ("may" in modal or state.has("mark", "until"))):
        return "largest"
    if starts and _is_motion(head) and "fall" not in ends_rest:  # at what speed does it slide
        return "largest"
    if "must" in modal and not starts and (is_up or head.has("quantity", "friction coefficient")):
        return "least"
    if starts and _is_push(head) and "fall" not in ends_rest and not state.has("updown", "down"):
        return "largest"
    if (
        starts and _is_push(head) and (state.has("mark", "to") or ends_rest - {"start"} == {"fall"})
    ):  # needed to lower the load
        return "least"
    return "range"


def _hinders(names: Names, state: Clause, parameter: str) -> bool:
    """Whether more of a parameter keeps something from the motion that is to begin: friction, and the mass of what is
    to go up. Where rest ends by it, another motion begins."""
    ends = {*state.all("verb")} & _ENDS_REST
    if not ends or _is_denied(state):
        return False
    goes_up = "rise" in ends or state.has("updown", "up") or state.has("part", "upward")
    masses = [names.bodies[name].mass for _, name in state.names if name in names.bodies]
    is_own = goes_up and any(parameter in free_symbols(mass) for mass in masses)
    return is_own or parameter in given.parameters(names, "friction coefficient", "")


def _is_subject(state: Clause) -> bool:
    """Whether what is named is what does something: it stands before the verb."""
    kinds = [word.kind for word in state.words if word.kind in ("name", "verb")]
    return kinds[:1] == ["name"]


def _is_denied(state: Clause) -> bool:
    """Whether what would end rest is said not to come: it does not slip, before it slips, what stops it from it."""
    return state.has("not") or state.has("mark", "until", "without") or state.has("verb", "end", "stop")


def _is_motion(head: Clause) -> bool:
    """Whether the parameter is a speed or an acceleration, of which rest can stand so much."""
    asked = [given.KIND_OF[word] for word in head.all("quantity") if given.can_end_rest(word)]
    return any(kind.ends_rest_by_growing and not kind.is_push for kind in asked)


def _is_push(head: Clause) -> bool:
    """Whether the parameter is how hard something is pushed or turned."""
    asked = head.all("quantity")
    is_push = any(given.can_end_rest(word) and given.KIND_OF[word].is_push for word in asked)
    return is_push or head.has("verb", "exert") or (head.has("name") and not asked)
