"""Questions turned round: for which value of a parameter, from which on, up to which something is so."""

from __future__ import annotations

from collections.abc import Callable
from itertools import pairwise
from typing import TYPE_CHECKING

from freebody.language.expression import free_symbols
from freebody.measures.geometry import GROUND
from freebody.questions.spoken import driving, given, joining, lookup, poses, rubbing
from freebody.questions.spoken.composing import SILENT, Groups
from freebody.questions.spoken.lexicon import Word
from freebody.questions.spoken.so_that import so
from freebody.questions.spoken.words import Clause

if TYPE_CHECKING:
    from freebody.model.names import Names

_RESTS = ("it stays at rest", "it does not slip", "nothing slips")
_EXERTED = ("torque", "impulse", "angular impulse")  # what a load may exert that is no force
_PUSHES = ("force", "torque", "moment", "driving force", "driving torque")
_RATES = ("speed", "velocity", "angular velocity", "acceleration")  # what a steady motion has itself
_FOR = (Word("ask", "from"), Word("ask", "for"), Word("ask", "up_to"))
_WHICH = (Word("ask", "with"), Word("ask", "what"))


def parameters(names: Names, words: list[Word], whole: Callable[..., Groups]) -> Groups:
    """What words can ask for if they ask for a parameter. whole: what other words can ask for."""
    words = _for_push(words)
    yield from _leaving_at_top(names, Clause(words))
    yield from _leaving_by_choice(names, Clause(words))
    yield from _begun_too_fast(names, Clause(words))
    yield from _without_leaving(names, Clause(words), whole)
    parted = _parted(names, _begun(names, words))
    if parted is None:
        return
    chosen, relation, end = parted
    if (relation.has("verb", "critical") or relation.all("quantity") == ["critical damping"]) and not relation.has(
        "not"
    ):
        yield [f"critical damping of {parameter}" for parameter in chosen]
    if relation.has("verb", "unstable") and relation.has("not", "before"):  # before it becomes unstable
        kept = [Word("verb", "stable") if w == Word("verb", "unstable") else w for w in relation.words]
        end, relation = end or "largest", Clause(kept).without("not")
    if relation.has("verb", "unstable") and end in ("", "least") and words[0] == Word("ask", "from"):
        end, kept = "largest", [Word("verb", "stable") if w == Word("verb", "unstable") else w for w in relation.words]
        relation = Clause(kept)
    is_begun = relation.has("verb", "start") and not relation.has("not") and not relation.has("mark", "until")
    relation = relation.without("verb", "become") if relation.has("verb", "stable") else relation
    for parameter in chosen:
        for group in so(names, relation, whole):
            for text in group:
                is_timed = text.endswith(" in steady motion") or " when " in text
                if text.partition(" = ")[0] in names.measures and not is_timed:
                    continue  # of a place that changes it is to be said when
                # the least force with which it starts is the largest with which it does not
                is_other_end = is_begun and end and text in _RESTS
                yield from _asked(names, parameter, text, _end_of_rest(names, parameter) if is_other_end else end)


def parameter_of(names: Names, words: list[Word]) -> list[str]:
    """The parameters that words ask for, where what is to be so with them stands elsewhere."""
    found = _head(names, Clause(words), Clause([]), is_marked=True)
    return [] if found is None else found[0]


def _end_of_rest(names: Names, parameter: str) -> str:
    """Where rest ends as a parameter leaves the values with which it lasts: as it grows; friction as it gets less."""
    return "least" if parameter in given.parameters(names, "friction coefficient", "") else "largest"


def _for_push(words: list[Word]) -> list[Word]:
    """With which torque it is accelerated at 2 m/s^2, or its acceleration is that, is for which one."""
    clause, (asks, kind) = Clause(words), [*words[:2], Word("", ""), Word("", "")][:2]
    is_push = asks == _WHICH[0] and kind.kind == "quantity" and kind.what in _PUSHES and not clause.has("mark")
    is_state = len(clause.values) == 1 and (len(clause.all("quantity")) > 1 or clause.has("verb", "accelerate"))
    is_steady = (
        asks == _WHICH[0] and given.is_by_unit(kind.what) and clause.has("not") and clause.has("verb", "accelerate")
    )
    return (
        [Word("ask", "for"), *words[1:]] if (is_push and is_state) or (is_steady and kind.what not in _RATES) else words
    )


def _begun(names: Names, words: list[Word]) -> list[Word]:
    """Without what says that a speed is that at the bottom, where the motion begins there."""
    cut = next((k for k, word in enumerate(words) if word.kind == "mark"), 0)
    place = {"at the bottom": True, "at the top": False}
    told = [w for w in words[:cut] if w.kind == "instant" and w.what in place]
    begins = [w for w in told if poses.begins_at(names, "", lowest=place[w.what])]
    return [word for k, word in enumerate(words) if k >= cut or word not in begins]


def _leaving_at_top(names: Names, clause: Clause) -> Groups:
    """At what speed does the car leave the road at the top: with which nothing presses there. With which it does not
    leave it is one end of the speeds with which something presses."""
    is_speed = clause.all("quantity") in (["speed"], ["velocity"]) or clause.has("ask", "fast")
    named = [name for _, name in clause.names if name in names.parameters]
    is_speed |= len(named) == 1 and named == given.started_with(names, lookup.massive(names))
    clause = Clause(
        [word for word in clause.without("part", "only").words if word.what not in named]
    )  # it only just leaves
    known = clause.only("ask", "quantity", "name", "verb", "instant", "degree", "mark", "not", *SILENT)
    doing = {"leave" if verb == "fall" else verb for verb in clause.all("verb") if verb not in ("move", "roll")}
    if not (is_speed and known and doing in ({"leave"}, {"stay_on"}) and clause.all("instant") == ["at the top"]):
        return
    bodies = [name for _, name in clause.names if name in lookup.moving(names)] or lookup.massive(names)
    others = [name for _, name in clause.names if name not in bodies]
    if len(bodies) != 1 or len(others) > 1 or len(clause.all("degree")) > 1:
        return
    speeds = given.started_with(names, bodies)
    joints = joining.joints(names, bodies[0], next(iter(others), ""), "normal force")
    tops = [f"when {top}" for top in poses.uppermost(names, bodies[0])]
    tops = ["at start"] if poses.begins_uppermost(names, bodies[0]) else tops
    is_denied = (doing == {"leave"}) == (clause.has("not") or clause.has("mark", "without", "until"))
    end = {"least": "least", "greatest": "largest"}.get(next(iter(clause.all("degree")), ""), "")
    for top in tops if len(speeds) == len(joints) == 1 else ():
        pressed = f"normal force of {joints[0]}"
        if not is_denied:
            yield [f"value of {speeds[0]} for which {pressed} = 0 {top}"] if end in ("", "least") else []
        else:
            yield [
                f"{end} {speeds[0]} so that {pressed} >= 0 {top}"
                if end
                else f"range of {speeds[0]} for which {pressed} >= 0 {top}"
            ]


def _leaving_by_choice(names: Names, clause: Clause) -> Groups:
    """At what speed do the inner wheels lift off: with which nothing presses there, where nothing moves yet; at what
    rpm does the tappet lift off its cam, or the coin slip off its table: the largest of the drive with which it does
    not."""
    is_over = clause.all("ask") in (["with"], ["from"], ["for"])
    leads, is_denied = clause.all("mark"), clause.has("not")
    is_before = leads in (["until"], ["without"]) if not is_denied else leads in ([], ["so_that"])
    is_before &= clause.all("ask") == ["fast"]  # how fast may it spin before, so that it does not
    if clause.all("verb") == ["stay_on"] and clause.all("ask") == ["up_to"] and not is_denied and not leads:
        kept = [word for word in clause.words if word.kind not in ("ask", "verb")]  # up to which rpm it stays on
        clause, is_over = Clause([Word("ask", "from"), *kept, Word("verb", "leave")]), True
    if is_before:
        clause = clause.without("mark").without("degree", "greatest").without("not")
        turns = clause.has("verb", "turn") and not clause.has("quantity")
        clause = (
            Clause([Word("quantity", "angular velocity"), *clause.without("verb", "turn").words]) if turns else clause
        )
    known = clause.only("ask", "quantity", "name", "verb", *SILENT) and (is_over or is_before)
    asked = clause.all("quantity")
    doing = set(clause.all("verb")) - {"start"}
    things = [name for _, name in clause.names if name not in names.parameters]
    if not known or doing not in ({"leave"}, {"slide"}, {"fly"}) or len(asked) != 1 or not given.is_by_unit(asked[0]):
        return
    named = [name for _, name in clause.names if name in names.parameters]
    chosen = named or given.of_kind(names, asked[0])
    if not chosen and asked[0] in ("speed", "velocity"):  # that of the drive
        chosen = [name for name in given.of_kind(names, "angular velocity") if name in driving.drive_parameters(names)]
    if len(chosen) != 1 or not 1 <= len(things) <= 2:
        return
    rubs = [joint for joint in rubbing.rough(names, "") if all(joining.touches(names, joint, x) for x in things)]
    if rubs and len(things) > 1 and chosen[0] in driving.drive_parameters(names):
        doing = {"slide"}  # it leaves what carries it round
    if (is_before and doing != {"slide"}) or doing == {"fly"}:
        return
    if doing == {"slide"}:
        slipping = [thing for thing in things if thing not in driving.driven_bodies(names, chosen[0])]
        is_one = bool(slipping) and all(rubbing.is_all_that_slips(names, thing) for thing in slipping)
        is_one = is_one and chosen[0] in driving.drive_parameters(names)
        yield [f"largest {chosen[0]} so that it does not slip"] if is_one else []
        return
    joints = joining.joints(names, things[0], things[-1], "")
    bound = [name for name in joints if joining.may_open(names, name)]
    if chosen[0] in driving.drive_parameters(names):
        yield [f"largest {chosen[0]} so that {joint} stays on" for joint in bound]
    elif rubbing.is_still(names) or not bound:  # what holds on both sides lifts off where nothing presses
        yield [f"value of {chosen[0]} for which {text}" for text in joining.no_longer_pressed(names, joints, things)]


def _without_leaving(names: Names, clause: Clause, whole: Callable[..., Groups]) -> Groups:
    """How fast may the car go without leaving the road: the largest speed at the start with which it never does."""
    is_speed = clause.all("quantity") in (["speed"], ["velocity"]) and clause.has("degree", "greatest")
    known = clause.only("ask", "quantity", "name", "verb", "degree", "mark", "not", *SILENT)
    is_denied = clause.has("not") or clause.has("mark", "without", "until")
    if not (known and is_denied and set(clause.all("verb")) - {"move"} == {"leave"}):
        return
    bodies = [name for _, name in clause.names if name in lookup.moving(names)] or lookup.massive(names)
    speeds = given.started_with(names, bodies)
    if (is_speed or clause.has("ask", "fast")) and len(speeds) == len(bodies) == 1:
        bound = {row.connection for row in names.constraint_rows if row.unilateral and row.reaction == "normal force"}
        joints = [name for name in bound if joining.touches(names, name, bodies[0])]
        named = [name for _, name in clause.names if name not in bodies]
        touched = [name for name in named if any(joining.touches(names, joint, name) for joint in joints)]
        if not joints or set(named) - {*touched, GROUND}:  # what is held on both sides never leaves
            return
        others = [Word("name", name) for name in touched]
        state = Clause([Word("name", bodies[0]), Word("not", "not"), Word("verb", "leave"), *others])
        for group in so(names, state, whole):
            yield [f"largest {speeds[0]} so that {text}" for text in group]


def _begun_too_fast(names: Names, clause: Clause) -> Groups:
    """At what initial speed does the sled leave the snow: above the largest with which it never does."""
    is_initial = clause.has("part", "initial") and clause.all("quantity") in (["speed"], ["velocity"])
    known = clause.only("ask", "quantity", "name", "verb", "part", *SILENT) and clause.has("ask", "with", "from", "for")
    bodies = [name for _, name in clause.names if name in lookup.moving(names)] or lookup.massive(names)
    others = [name for _, name in clause.names if name not in bodies]
    speeds = given.started_with(names, bodies)
    if is_initial and known and clause.all("verb") == ["leave"] and len(bodies) == len(speeds) == 1 >= len(others):
        held = f"never leaves {others[0]}" if others else "stays on"
        yield [f"largest {speeds[0]} so that {bodies[0]} {held}"]


def _asked(names: Names, parameter: str, text: str, end: str) -> Groups:
    """The values of a parameter for which a text holds, or one end of them."""
    if text == "it does not slip" and rolls_down(names):
        yield [f"{end or 'range of'} {parameter} {'so that' if end else 'for which'} it rolls without slipping"]
    elif text in _RESTS:
        yield [f"{end} {parameter} so that {text}" if end else f"range of {parameter} that keeps it at rest"]
    elif end:
        yield [f"{end} {parameter} so that {text}"]
        yield [f"value of {parameter} for which {text}"] if " = " in text else []
    elif any(sign in text for sign in (" > ", " < ", " >= ", " <= ")):
        yield [f"range of {parameter} for which {text}"]
    elif " just reaches " in text or " = " in text or text.endswith((" is largest", " is least")):
        yield [f"value of {parameter} for which {text}"]
    else:
        yield [f"range of {parameter} for which {text}"]


def rolls_down(names: Names) -> bool:
    """Whether what is let go on a slope can roll down it, so that not to slip is no rest."""
    bodies = lookup.moving(names)
    return lookup.can_roll(names) and len(bodies) == 1 and bool(lookup.inclined(names, "") or joining.sloping(names))


def _parted(names: Names, words: list[Word]) -> tuple[list[str], Clause, str] | None:
    """The parameters that can be meant, what is to be so, and which end of the values."""
    words = _by_its_name(names, _told_by_what_follows(names, words))
    marks = [k for k, word in enumerate(words) if word.kind == "mark" and word.what in ("so_that", "to")]
    asks = bool(words) and words[0].kind == "ask"
    if marks:
        head, rest = Clause(words[: marks[0]]), Clause(words[marks[0] + 1 :])
    elif (
        asks
        and words[0].what in ("for", "with", "what", "large", "much", "up_to", "from")
        and not any(w == Word("mark", "until") for w in words)
    ):
        k = next((k for k, word in enumerate(words) if word.kind == "name" and word.what in names.parameters), None)
        end = (k or 0) + 1
        behind = Clause(words[end : end + 2])
        is_led = behind.words[:1] != [] and behind.words[0].kind == "degree" and not behind.has("quantity")
        end += bool(k) and is_led  # P höchstens, ohne dass
        head, rest = Clause(words[:end]), Clause(words[end:])
        if k is None or (words[0].what == "with" and not rest.words):
            return _without_mark(names, words)
    else:
        return _without_mark(names, words)
    return _head(names, head, rest, is_marked=bool(marks))


def _told_by_what_follows(names: Names, words: list[Word]) -> list[Word]:
    """What speed v did the bullet have if the block swings through 30 deg: the v with which it just does."""
    whens = [k for k, word in enumerate(words) if word == Word("mark", "when")]
    head = words[: whens[0]] if len(whens) == 1 else []
    is_parameter = [w.what in names.parameters for w in head if w.kind == "name"][:1] == [True]
    if head[:1] != [Word("ask", "what")] or not is_parameter or head[1].what not in given.KIND_OF:
        return words
    so = [word for word in words[whens[0] + 1 :] if word != Word("mark", "until")]  # up to 30 deg
    return [*head[:3], Word("mark", "so_that"), *so, Word("part", "only")]


def _by_its_name(names: Names, words: list[Word]) -> list[Word]:
    """At what friction coefficient it slips is at what mu, where there is one such parameter; at which angle of the
    chute, at the one by which that leans."""
    asks, kind, leads, thing = [*words[:4], *[Word("", "")] * 4][:4]
    is_asked = asks.kind == "ask" and asks.what in ("with", "for", "from", "up_to") and kind.kind == "quantity"
    if is_asked and kind.what == "angle" and leads == Word("preposition", "of") and thing.kind == "name":
        leaning = [name for name in given.of_kind(names, "angle") if name in given.leaning_by(names, thing.what)]
        asks = _FOR[1] if asks == _WHICH[0] else asks
        return [asks, Word("name", leaning[0]), *words[4:]] if len(leaning) == 1 else words
    if not is_asked or not given.is_written(kind.what) or leads.kind in ("preposition", "mark", ""):
        return words
    found = given.parameters(names, kind.what, "")
    return [asks, Word("name", found[0]), *words[2:]] if len(found) == 1 else words


def _without_mark(names: Names, words: list[Word]) -> tuple[list[str], Clause, str] | None:
    """The least force F that holds the load; the largest F before it slips."""
    if len(words) > 2 and words[0].what in names.parameters and words[1] == Word("preposition", "of"):
        rest = Clause(words[2:])  # c for a damping ratio of 0.1
        return ([words[0].what], rest, "") if words[0].kind == "name" and rest.has("value") else None
    k = _end_of_head(names, words)
    if k is None:
        return None
    rest = Clause(words[k:])
    if rest.words[0] == Word("mark", "until"):  # the largest before something happens is that with which it does not
        rest = Clause([*rest.words[1:], Word("not", "before")])
    return _head(names, Clause(words[:k]), rest)


def _end_of_head(names: Names, words: list[Word]) -> int | None:
    """Where the words for the parameter end: the least force F | that holds the load."""
    asks = ("large", "heavy", "rough", "up_to", "from", "for", "much")
    is_written = words[:1] == [Word("ask", "with")] and given.is_written(words[1].what if words[1:] else "")
    if not is_written and not any(
        word.kind == "degree" or (word.kind == "ask" and word.what in asks) for word in words
    ):
        return None
    chosen = [
        k for k, w in enumerate(words) if (w.kind == "name" and w.what in names.parameters) or given.is_written(w.what)
    ]
    if not chosen and words[0] in _FOR:  # from which force on, for which angle
        chosen = [k for k, w in enumerate(words) if w.kind == "quantity" and given.is_by_unit(w.what)][:1]
    if not chosen and words[0].kind == "degree" and words[1:2] and any(w.kind == "not" for w in words[2:]):
        chosen = [1] if given.is_by_unit(words[1].what) else []  # the greatest speed without slipping
    acts = Word("verb", "exert") in words and Word("mark", "until") in words
    if not chosen and acts and words[0] in _WHICH:  # with what torque may the motor drive at most before
        return words.index(Word("mark", "until"))
    if not chosen and words[0] in (Word("ask", "heavy"), Word("ask", "rough")):
        chosen = [k for k, word in enumerate(words) if word.kind == "name"]
    if not chosen:
        return None
    is_led = words[0] in (*_FOR, Word("degree", "range")) or is_written
    kinds = ("verb", "not", "relation", "degree", *(["quantity"] if is_led else []))
    marks = ("until", "to", "in equilibrium", "equilibrium")
    begins = (k for k, w in enumerate(words) if k > chosen[0] and (w.kind in kinds or w.what in marks))
    k = next(begins, None)
    if k is None:
        return None
    named = [j for j in range(chosen[0] + 1, k) if words[j].kind == "name" and words[j - 1].kind != "preposition"]
    return named[0] if named else k  # who does something stands before the verb


def _may_be(names: Names, ask: str, parameter: str) -> bool:
    """Whether a parameter can be so: a force is not far, nor a length fast."""
    kind = given.ASKED_BY.get(ask)
    if kind is None or kind.dimension is None:
        return True
    turns = given.KIND_OF["angular velocity"].has(names.parameters[parameter])
    return kind.has(names.parameters[parameter]) or (ask == "fast" and turns)


def _speeds(names: Names, asked: str, of: list[str]) -> list[str]:
    """The speed with which something starts, or with which what is driven goes round."""
    driven = [name for name in driving.drive_parameters(names) if set(of) <= driving.driven_bodies(names, name)]
    driven = [name for name in driven if name in given.of_kind(names, asked)]
    if asked == "angular velocity" and (of or driven):
        return driven
    started = [] if asked == "angular velocity" else given.started_with(names, of or lookup.massive(names))
    rates = given.of_kind(names, "angular velocity")  # of a swing, that of its angle
    begun = frozenset[str]().union(*map(free_symbols, names.start_rates.values()))
    return started or ([] if of else [name for name in rates if name in begun])


def _head(names: Names, head: Clause, rest: Clause, *, is_marked: bool = False) -> tuple[list[str], Clause, str] | None:
    if head.words and head.words[0].kind == "verb":
        return None  # does friction suffice: yes or no
    is_largest = head.has("ask", "large", "heavy") and (rest.has("not", "before") or rest.has("verb", "start"))
    degrees = {"greatest"} if is_largest else set(head.all("degree")) - {"value", "range"}
    if (
        len(degrees) > 1
        or (head.has("verb", "hit", "leave", "roll", "slide", "turn") and not is_marked)
        or head.has("value")
        or head.has("relation")
    ):
        return None
    end = {"least": "least", "greatest": "largest"}.get(next(iter(degrees), ""), "")
    asked_by = [given.ASKED_BY[ask].words[0] for ask in head.all("ask") if ask in ("high", "far", "steep", "flat")]
    if head.has("ask", "fast") and is_marked:
        asked_by = ["speed"]
    named = [name for _, name in head.names if name in names.parameters]
    if named and any(not _may_be(names, ask, named[0]) for ask in head.all("ask")):  # how far may F be from A
        return None
    others = [name for before, name in head.names if name not in names.parameters and (not before or not named)]
    if head.has("verb", "hit", "exert", "start") and is_marked:  # at which height h do I hit the ball so that ..
        others = []
    titles = [one for one, after in pairwise(head.words) if after.kind == "name" and after.what in named]
    asked = [w.what for w in head.words if w.kind == "quantity" and w not in titles]  # the sag f needs no other word
    if asked == ["mass"] and head.has("ask", "high", "far") and head.has("verb"):  # how high the mass may fall
        asked = []
    acts = head.has("verb", "exert", "act") and asked == ["force"]  # at which height the force must act
    asked = asked_by if acts and asked_by else asked
    asked = asked or (asked_by if is_marked and not named else [])
    if head.has("ask", "up_to") and (not named or rest.has("verb", "stable")):
        end = end or "largest"
    if len(named) == 1 and len(others) <= head.has("ask") and set(asked) <= given.KIND_OF.keys():
        return named, rest, end
    if head.has("ask", "from"):
        end = "least"
    of_speed = asked in (["speed"], ["velocity"], ["angular velocity"]) and (others or head.has("ask", "fast") or end)
    if of_speed and not named and is_marked:
        found = _speeds(names, asked[0], others)  # the speed that the bullet must have
        return (found, rest, end) if len(found) == 1 else None
    if asked == ["normal force"] and is_marked and not named and not others:  # with which something is pressed on
        asked = ["force"]
    if asked == ["impulse"] and not given.of_kind(names, "impulse"):  # of what turns about a hinge
        asked = ["angular impulse"]
    is_extremal = is_marked and rest.has("degree") and rest.has("quantity")  # the angle for the greatest range
    if not named and len(asked) == 1 and asked[0] in given.ROLES and (found := given.in_role(names, asked[0], others)):
        return found, rest, end  # the motor torque, the braking force
    if not named and not others and len(asked) == 1 and given.is_by_unit(asked[0]):  # the only one that is a force
        found = given.of_kind(names, asked[0])
        found = found if len(found) == 1 else given.chosen(names, given.KIND_OF[asked[0]], [])
        return (found, rest, end) if len(found) == 1 and (end or head.has("ask") or is_extremal) else None
    bodies = [name for name in others if name in lookup.moving(names)]
    if not named and bodies and bodies == others and end and len(asked) == 1 and given.is_by_unit(asked[0]):
        found = given.chosen(names, given.KIND_OF[asked[0]], bodies)  # the greatest torque with which the motor drives
        return (found, rest, end) if len(found) == 1 and head.has("verb", "exert", "act") else None
    if head.has("ask", "extended") and not named and not asked:
        asked = ["length"]
    if head.has("ask", "large") and not named and not asked and len(others) == 1 and is_marked:
        is_point = others[0] in names.bodies and "particle" in names.called.get(others[0], ())
        asked = ["mass"] if is_point else asked  # how large the mass must be: nothing else of it has a size
    loads = [name for name in others if name in names.loads or name in names.impulses]
    if head.has("ask", "where") and not named:  # where the man may stand
        found = given.placing(names, loads[0]) if len(loads) == 1 and loads == others and not asked else []
        return (found, rest, end) if len(found) == 1 else None
    if asked == ["height"] and not named and len(loads) == 1 and loads == others:  # how high the water may stand
        found = given.placing(names, loads[0])
        return (found, rest, end) if len(found) == 1 else None
    kind = asked[0].replace("driving ", "") if len(asked) == 1 else ""
    if not asked and len(loads) == 1:  # what motor torque
        kind = next((word for word in _EXERTED if given.exerts(names, loads[0], word)), "force")
    acted = {body for load in names.applied_loads for body in load.measure.bodies()}
    is_exerted = kind in ("force", "moment", *_EXERTED) and others != []
    if not named and is_exerted and (loads == others or acted.issuperset(others)):  # the torque of, or on, the motor
        found = given.chosen(names, given.KIND_OF[kind], others)
        return (found, rest, end) if len(found) == 1 else None
    if head.has("ask", "heavy", "rough") and not named and not asked:
        asked = ["mass"] if head.has("ask", "heavy") else ["friction coefficient"]
        end, others = end or "least" if head.has("ask", "rough") else end, others if head.has("ask", "heavy") else []
    if not named and len(asked) == 1 and given.is_written(asked[0]) and len(others) <= 1:
        of = next(iter(others), "")
        found = given.parameters(names, asked[0], of)
        found = found or (given.chosen(names, given.KIND_OF["mass"], others) if asked[0] == "mass" and others else [])
        return (found, rest, end) if found else None
    return None
