"""Times of events, and what comes together up to an event: a way, turns, heat."""

from __future__ import annotations

from itertools import product
from typing import TYPE_CHECKING

from freebody.measures.geometry import GROUND
from freebody.questions.spoken import along_lines, dimensions, farthest, given, joining, lookup, losing, poses, rubbing
from freebody.questions.spoken.composing import SILENT, Groups
from freebody.questions.spoken.events import GOES_ON, POSES, conditions
from freebody.questions.spoken.lexicon import Word
from freebody.questions.spoken.sentence import Sentence, clock
from freebody.questions.spoken.words import Clause

if TYPE_CHECKING:
    from freebody.model.names import Names


_WAYS = ("distance", "displacement", "distance travelled")
_STAYS = {"hold", "fly", "move", "stay_on"}  # verbs of what is in the air
_TO_THE_END = ("ask", "quantity", "verb", "name", *SILENT)
_LOSSES = ("energy lost", "kinetic energy lost")
COUNTED = ("work", "work of friction", "energy lost", "turns")  # up to an event, and at no instant


def time(names: Names, sentence: Sentence) -> Groups:
    """The time of an event: when, after what time, how long until."""
    main = _until_struck(sentence.main)
    if joining.is_struck_at_start_alone(names):  # how long it turns after the blow: the motion begins with it
        main = main.without("instant", "after the impact")
    if main.has("quantity", "flight time") and set(main.all("verb")) <= _STAYS and not sentence.others:
        return  # how long it stays in the air
    if main.has("quantity", "flight time") and (sentence.others or main.has("verb") or main.has("value")):
        main = Clause([Word("quantity", "time") if w == Word("quantity", "flight time") else w for w in main.words])
    asks = main.has("ask", "when", "soon", "long") or main.has("quantity", "time")
    if asks and main.has("verb", "leave") and not sentence.others and main.only("ask", "verb", "name", *SILENT):
        yield from _lifting(names, main)
    n_of_event = _is_of_event(names, main) + (len(main.all("quantity")) > 1 and main.has("relation", "="))
    if not asks or len(main.all("quantity")) > main.has("quantity", "time") + n_of_event:
        return
    head = main.without("ask").without("quantity", "time")
    if not sentence.others and (main.has("ask", "long") or main.has("quantity", "time")):
        yield from _in_contact(names, head)
    if not sentence.others and set(head.all("verb")) - {"move"} == {"fall"} and head.only("verb", "name", *SILENT):
        of = next((name for _, name in head.names), "")  # how long does it take to come down
        yield [f"time when {place}" for place in poses.named_by_file(names, of, -1) if len(head.names) <= 1]
    goes = set(head.all("verb")) <= {*GOES_ON}
    if goes and head.has("part", "upward", "uphill") and main.has("ask", "long"):  # how long does it slide upwards
        kept = head.without("part", "upward", "uphill").without("verb")
        head = Clause([*kept.words, Word("verb", "rise")])
    if (
        main.has("ask", "long")
        and not head.has("verb", "rise")
        and not sentence.others
        and not head.has("value")
        and not head.has("instant", "after engagement")
        and not any(name in names.parameters for _, name in head.names)
        and set(head.all("verb")) <= set(GOES_ON)
    ):
        of = [name for _, name in head.names]
        if head.only("verb", "name", "pronoun") and len(of) <= 1 and set(head.all("verb")) - {"move"} == {"turn"}:
            yield [f"time when {name} stops" for name in losing.runs_down(names) if name in (of or [name])]
        if head.only("verb", "name", *SILENT) and set(head.all("verb")) == {"fly"} and not joining.strikes(names):
            yield [f"time when {cord} goes taut" for cord in lookup.catching(names, pulls=True)]
            flying = next(iter(of), "")
            landing = lookup.falling(names, flying) if len(of) <= 1 and lookup.flies(names, flying) else []
            yield [f"time when {height} = 0" for height in landing]
        if head.only("verb", "name", *SILENT) and set(head.all("verb")) == {"fly"} and joining.comes_to_strike(names):
            yield ["time when it lands"] if all(lookup.is_all_that_moves(names, name) for name in of) else []
        if head.only("verb", "name", "pronoun") and len(of) <= 1 and set(head.all("verb")) == {"slide"}:
            yield [f"time when slipping of {of[0]} ends" if of else "time when slipping ends"]
        joint = rubbing.slipping_on(names, head.names)
        if joint is not None and set(head.all("verb")) == {"slide"} and head.only("verb", "name", *SILENT):
            yield [f"time when slipping of {joint} ends"]
        return
    if main.has("ask", "long") and not sentence.others and set(head.all("verb")) == {"hold"}:
        of = [name for _, name in head.names]  # how long does it stick
        if head.only("verb", "name", "pronoun") and len(of) <= 1 and rubbing.rough(names, next(iter(of), "")):
            yield [f"time when {of[0]} begins to slip" if of else "time when slipping begins"]
        return
    if head.has("verb", "return") and not sentence.others and not lookup.ways(names, "") and lookup.rests(names):
        if head.only("verb", "name", *SILENT) and set(head.all("verb")) <= {"return", "move", "turn"}:
            yield ["period of the motion"] if lookup.swings(names) else []  # it is let go from where it comes back to
        return
    rises = "rise" in head.all("verb") and set(head.all("verb")) <= {"rise", *GOES_ON} and not head.has("value")
    if main.has("ask", "long") and not sentence.others and rises:
        of = next((name for _, name in head.names), "")
        yield [f"time when {top}" for top in poses.tops(names, of)]
        yield [f"time when rate({way}) = 0" for way, sense in lookup.inclined(names, of) if sense > 0]
        return
    if len(sentence.others) == 1 and sentence.others[0][0] in ("when", "until"):
        clause = sentence.others[0][1]
        if not head.only("pronoun", "preposition", "verb", "name") or set(head.all("verb")) - set(GOES_ON):
            return
        if not any(word.kind == "pronoun" for word in clause.words) and head.names and not clause.names:
            clause = Clause([*head.words, *clause.words])
    elif not sentence.others and (
        head.has("verb")
        or head.has("part", *POSES)
        or head.has("instant")
        or head.has("relation")
        or _has_value(names, head)
    ):
        clause = head
    else:
        return
    for group in conditions(names, clause):
        free = _flown_free(names, group) if clause is not head and set(head.all("verb")) == {"fly"} else []
        yield free or [f"time when {condition}" for condition in group]


def _flown_free(names: Names, conditions_: list[str]) -> list[str]:
    """How long it flies until its string is taut again: from where that went slack."""
    return [
        f"time between {name} goes slack and {name} goes taut"
        for name in joining.swinging_on(names)
        if conditions_ in ([f"{name} goes taut"], ["it goes taut"])
    ]


def _in_contact(names: Names, head: Clause) -> Groups:
    """How long it touches a buffer, which only pushes: from where it is reached until it is relaxed."""
    touches = set(head.all("verb")) in ({"stay_on"}, {"stay_on", "hold"}) or head.has("instant", "in the impact")
    if not touches or not head.without("instant", "in the impact").only("verb", "name", *SILENT) or len(head.names) > 2:
        return
    of = [name for _, name in head.names]
    for load in lookup.catching(names, pulls=False):
        acted = {body for p in names.applied_loads if p.load == load for body in p.measure.bodies()}
        if all(name == load or name in acted for name in of):
            yield [f"time between {load} is reached and {load} is relaxed"]


def _lifting(names: Names, main: Clause) -> Groups:
    """When do the wheels lift off that nothing lets go: with which push, where there is one alone."""
    bound = {row.connection for row in names.constraint_rows if row.unilateral}
    own = [name for _, name in main.names if name in names.connections and name not in bound]
    pushes = [name for kind in ("force", "torque") for name in given.chosen(names, given.KIND_OF[kind], [])]
    if len(pushes) == 1:
        yield [f"value of {pushes[0]} for which normal force of {name} = 0" for name in own]


def _until_struck(main: Clause) -> Clause:
    """How long does it fall before the impact: until it hits."""
    struck = ("before the impact", "at the impact", "in the impact")
    if not main.has("instant", *struck) or not main.has("ask", "when", "soon", "long"):
        return main
    kept = main.without("instant", *struck)
    if set(kept.all("verb")) - set(GOES_ON):
        return main
    return Clause([*kept.without("verb").words, Word("verb", "hit")])


def stopping(names: Names, sentence: Sentence) -> Groups:
    """How long it takes, and how far it goes, until something stops."""
    main = sentence.main
    of = next((name for _, name in main.names), "")
    asked = main.all("quantity")
    if main.has("degree", "least") and not _is_pushed(names):  # nothing but friction stops it, as fast as it can
        main = main.without("degree", "least")
    if sentence.others or not main.only("quantity", "ask", "name", *SILENT) or len(main.names) > 1:
        return
    if asked == ["stopping time"]:
        yield [f"time when {of or 'it'} stops"]
        ways = lookup.went(names, of) or lookup.angles(names, of)
        yield [f"time when rate({way}) = 0" for way in ways if not rubbing.is_rough(names)]
    elif asked == ["stopping distance"]:
        yield [f"change of {way} until {of or 'it'} stops" for way in lookup.went(names, of)]
        gone = {way: {*names.measures[way].bodies()} - {GROUND} for way in lookup.went(names, of)}
        free = [way for way, bodies in gone.items() if not any(rubbing.can_stick(names, body) for body in bodies)]
        yield [f"change of {way} until rate({way}) = 0" for way in free]
        yield [
            f"change of {way} until rate({way}) = 0" for way in lookup.went(names, of) if not rubbing.is_rough(names)
        ]
        if not lookup.went(names, of) and (who := of or next(iter(lookup.massive(names)), "")) in names.bodies:
            ways = [f"{axis} of {who}" for axis in joining.guided_along(names, who)]
            ways = ways or along_lines.unmeasured(names, who)
            yield [f"change of {way} until {who} stops" for way in ways[:1]]


def _is_pushed(names: Names) -> bool:
    return any("gravity" not in names.called.get(name, ()) for name in names.loads)


def _is_of_event(names: Names, main: Clause) -> bool:
    """Whether a quantity beside the time says what is reached: time to reach a speed of 2 m/s, of v."""
    return (
        _has_value(names, main)
        or main.has("relation", "=")
        or main.has("verb", "vanish", "reach", "halve")
        or main.has("quantity", *_WAYS)
    )


def lost(names: Names, sentence: Sentence) -> Groups:
    """The energy that is lost in an impact, and the kinetic energy that is lost up to an event."""
    sentence = losing.in_the_blow(names, sentence)
    main = sentence.main
    asked = main.all("quantity")
    if asked[:1] == ["fraction"]:
        yield from _fraction_lost(names, sentence, asked[1:])
        return
    is_energy = asked in (["energy lost"], ["kinetic energy lost"]) or (
        asked in (["energy"], ["kinetic energy"]) and main.has("verb", "lost")
    )
    if not is_energy or not main.only("quantity", "ask", "verb", "instant", "name", *SILENT):
        return
    before = Clause(main.words[: next((k for k, w in enumerate(main.words) if w.kind == "instant"), None)])
    bodies = [name for _, name in before.names if name in lookup.massive(names)]
    if len(bodies) == 1 < len(lookup.massive(names)) and not sentence.others:
        return  # of one body: what the others get is no loss
    is_blow = not main.has("instant") and losing.only_loses_in_the_blow(names)
    if (main.has("instant", "in the impact", "at the impact") or is_blow) and not sentence.others:
        yield ["energy lost in the blow" if joining.is_struck_at_start_alone(names) else "energy lost in the impact"]
    elif asked[0].startswith("kinetic") and len(sentence.others) == 1:
        of = "".join(f" of {name}" for _, name in main.names)
        for end in ends(names, sentence):
            yield [f"kinetic energy{of} at start - kinetic energy{of} when {condition}" for condition in end]


def _fraction_lost(names: Names, sentence: Sentence, asked: list[str]) -> Groups:
    """What fraction of the energy is lost up to an event: of the kinetic energy, where there is no other."""
    if _is_lost_beside_the_blow(sentence.main):
        return
    main = sentence.main.without("part", "initial")  # of what there is at first
    if asked in (["energy"], ["kinetic energy"]) and main.has("verb", "lost"):  # that goes into heat
        asked = [f"{asked[0]} lost"]
        meant = Word("quantity", asked[0])
        main = Clause([meant if w.kind == "quantity" and w.what != "fraction" else w for w in main.words])
        main = main.without("verb", "lost")
    whole_loss = Word("quantity", "energy lost")
    is_heat = asked == ["heat of kinetic energy"]  # of the kinetic energy, whatever becomes of the rest of it
    asked = [whole_loss.what] if is_heat else asked
    losses = (Word("quantity", "kinetic energy lost"), Word("quantity", "heat of kinetic energy"))
    main = Clause([whole_loss if w in losses else w for w in main.words])
    is_first = sentence.main.has("part", "initial") and not joining.is_struck_at_start_alone(names)
    sentence = Sentence(main, sentence.others)
    is_lost = asked in ([one] for one in _LOSSES)
    is_lost = is_lost and not (
        is_first and asked == ["energy lost"] and not is_heat and not losing.has_kinetic_energy_alone(names)
    )
    is_all = all(lookup.is_all_that_moves(names, name) for _, name in main.names)
    blows = ("in the impact", "at the impact")
    if is_lost and not sentence.others and (main.has("instant", *blows) or losing.only_loses_in_the_blow(names)):
        if main.only("quantity", "ask", "instant", *SILENT):
            blow = "blow" if joining.is_struck_at_start_alone(names) else "impact"
            whole = "kinetic energy at start" if is_first else f"(kinetic energy before the {blow})"
            yield [f"ratio of energy lost in the {blow} to {whole}"]
        return
    if (
        is_lost
        and is_all
        and (is_heat or losing.has_kinetic_energy_alone(names))
        and main.only("quantity", "ask", "name", *SILENT)
    ):
        for end in ends(names, sentence):
            yield [f"ratio of energy lost until {condition} to kinetic energy at start" for condition in end]
    elif asked == ["kinetic energy lost"] and is_all and main.only("quantity", "ask", "name", *SILENT):
        for end in ends(names, sentence):  # whatever becomes of it
            yield [f"1 - (kinetic energy when {condition})/(kinetic energy at start)" for condition in end]


def _is_lost_beside_the_blow(main: Clause) -> bool:
    """Whether a loss before, or after, a blow is meant, and not of what there is then."""
    at = next((k for k, word in enumerate(main.words) if word.what.split(" ")[-1] == "lost"), len(main.words))
    return any(word.what in ("before the impact", "after the impact") for word in main.words[at:])


def counted(names: Names, sentence: Sentence) -> Groups:
    """What comes together up to an event: a way, turns, heat."""
    main = sentence.main
    if main.has("quantity", *_LOSSES) and losing.in_the_blow(names, sentence) is not sentence:
        return
    if main.has("ask", "turned", "travelled") and not sentence.others:
        who = next((name for _, name in main.names if name in names.bodies), "")
        heads = [who] if who in lookup.turning(names) else lookup.turning(names)
        heads = heads if main.has("ask", "turned") else lookup.ways(names, who)
        what = "turns" if main.has("ask", "turned") else "change"
        for condition in conditions(names, main.without("ask")):
            yield [f"{what} of {head} until {text}" for head, text in product(heads, condition)]
        return
    if not sentence.others:
        yield from farthest.slipped(names, main)
    sentence = _there_and_back(_while_it_turns(sentence))
    for group in _heads_counted(names, sentence):
        if sentence.others == () and main.has("instant", "in the impact"):
            yield group
        for end in ends(names, sentence):
            yield [f"{head} until {condition}" for head, condition in product(group, end)]


def _while_it_turns(sentence: Sentence) -> Sentence:
    """How far something rises when a shaft makes one turn is how far until it has made it."""
    main = sentence.main
    if not main.has("ask", "far", "much", "high") or main.has("quantity"):
        return sentence
    others = (("until" if mark == "when" and own.has("turns") else mark, own) for mark, own in sentence.others)
    return Sentence(main, tuple(others))


def _there_and_back(sentence: Sentence) -> Sentence:
    """How far it goes before it comes back is how far until it turns back, and not where it is when it is back."""
    main = sentence.main
    is_way = main.has("ask", "far", "much", "high") and not main.has("quantity")
    if not (is_way or main.has("quantity", "distance", "displacement")):
        return sentence
    turns, returns = Word("verb", "turn_back"), Word("verb", "return")
    others = [
        (mark, [turns if mark == "until" and w == returns else w for w in own.words]) for mark, own in sentence.others
    ]
    return Sentence(main, tuple((mark, Clause(own)) for mark, own in others))


def _ways_gone(names: Names, main: Clause, who: str) -> list[str]:
    """Measures of how far something goes. What moves along several directions has a path that none of them tells, and
    a displacement that each one measures a part of."""
    if main.has("part", "vertical"):
        return [name for name, _ in lookup.heights(names, who)]
    return [] if _is_of_no_measure(names, main, who) else _without_heights(names, who, lookup.went(names, who))


def _is_of_no_measure(names: Names, main: Clause, who: str) -> bool:
    asked = main.all("quantity")
    is_whole = asked == ["distance travelled"] or (asked == ["displacement"] and not main.has("part"))
    return is_whole and who not in names.measures and lookup.is_free(names, who)


def _heads_counted(names: Names, sentence: Sentence) -> Groups:
    main = sentence.main
    verbs, of = set(main.all("verb")), [name for _, name in main.names]
    asked = main.all("quantity")
    if len(asked) == 2 and asked[1] in _WAYS and of and of[-1] in names.parameters:  # the work on the way d
        asked, of = asked[:1], of[:-1]
    who = next(iter(of), "")
    known = ("ask", "verb", "name", "pronoun", "preposition", "quantity", "value", "updown", "part")
    plain = main.without("instant", "in the impact").only(*known)
    if who in lookup.moving(names):  # up the incline, on the floor
        of = [name for name in of if name not in {*names.bodies[GROUND].lines, *names.bodies[GROUND].planes}]
    if len(of) > 1 or not plain:
        return
    goes = bool(verbs) and verbs <= set(GOES_ON)
    if asked == ["turns"] or (main.has("ask", "many") and "turn" in verbs and not asked):
        named = [name for _, own in sentence.others for _, name in own.names if name in lookup.turning(names)]
        named, who = named or lookup.started(names), lookup.acted_on(names, who)  # of the crank: of what it turns
        yield [f"turns of {name}" for name in ([who] if who else named or lookup.turning(names))]
    elif main.has("ask", "many") and verbs == {"turn_back"} and not asked:  # how often does it turn round
        yield [f"turns of {name}" for name in ([who] if who else lookup.started(names) or lookup.turning(names))]
    elif (asked == ["energy lost"] and verbs <= {"lost", *GOES_ON}) or (asked == ["energy"] and verbs == {"lost"}):
        if who in names.connections or who in names.loads:
            yield [] if main.has("instant", "in the impact") else [f"energy lost in {who}"]
            yield ["energy lost"] if losing.is_all_that_rubs(names, who) else []
        else:
            is_all = not of or lookup.is_all_that_moves(names, who) or losing.is_all_that_rubs(names, who)
            yield ["energy lost"] if is_all else []
    elif (main.has("ask", "far", "much", "high", "large") and not asked and goes) or (
        asked in (["distance"], ["displacement"], ["distance travelled"], ["horizontal range"]) and (goes or not verbs)
    ):
        counted = "distance travelled along" if asked == ["distance travelled"] else "change of"
        down = "fall" in verbs or main.has("updown", "down") or main.has("part", "downward")
        up = "rise" in verbs or main.has("updown", "up") or main.has("part", "upward") or main.has("ask", "high")
        if down or up:
            heights = [name for name, sense in lookup.heights(names, who) if (sense < 0) == down]
            along = [name for name, sense in lookup.inclined(names, who) if (sense < 0) == down]
            yield [f"{counted} {name}" for name in heights or along]
            if down and counted == "change of" and not (heights or along):  # by what measures it upwards
                yield [f"-(change of {name})" for name, sense in lookup.heights(names, who) if sense > 0]
            is_plain = counted == "change of" and who in lookup.moving(names)
            is_plain &= not lookup.places(names, who) or (up and not (heights or along))  # counted downwards
            yield [f"change of height of {who}"] if is_plain else []
        elif "turn" in verbs and main.has("ask", "far", "much", "large"):
            yield [f"change of {name}" for name in lookup.angles(names, who)]
        else:
            ways = _ways_gone(names, main, who)
            went = [f"{counted} {name}" for name in ways]
            is_plain = counted == "change of" and not went and who in lookup.moving(names)
            went = went or [f"change of {axis} of {who}" for axis in joining.guided_along(names, who) if is_plain]
            unmeasured = [] if _is_of_no_measure(names, main, who) else along_lines.unmeasured(names, who)
            yield went or [f"{counted} {way}" for way in unmeasured]
    elif len(asked) == 1 == len(of) and asked[0] == "work" and who in names.loads:
        yield [f"work of {who}"]
    elif asked == ["work of friction"]:
        yield [f"work of {joint}" for joint in rubbing.rough(names, who)]
    elif asked == ["change"] and not verbs and who in names.measures:
        yield [f"change of {who}"]


def _without_heights(names: Names, who: str, ways: list[str]) -> list[str]:
    """Of what rolls, or slides, in space how high it is does not say how far it comes."""
    joints = [name for name in names.connections if not who or joining.touches(names, name, who)]
    rests_on = names.space and any({"contact", "rolling"} & {*names.called.get(name, ())} for name in joints)
    upright = {name for name, _ in lookup.heights(names, "")} if rests_on else set[str]()
    return [name for name in ways if name not in upright]


def _has_value(names: Names, clause: Clause) -> bool:
    """Whether something comes to a value: while the crate rises by 2 m."""
    given = any(name in names.parameters for _, name in clause.names)
    return given or clause.has("value") or clause.has("turns")


def ends(names: Names, sentence: Sentence) -> Groups:
    """Up to what is counted."""
    if len(sentence.others) == 1:
        mark, clause = sentence.others[0]
        time = clock(names, clause) if mark == "after" else None
        if time is not None:
            yield [f"t = {time}"]
        elif mark in ("until", "when", "after") or (mark == "while" and _has_value(names, clause)):
            yield from conditions(names, clause)
        elif mark == "while" and clause.all("verb") == ["slide"] and clause.only("verb", "name", "pronoun"):
            yield [f"slipping of {name} ends" for _, name in clause.names] or ["slipping ends"]
    elif not sentence.others:
        is_open = sentence.main.has("quantity", "turns") and not (sentence.main.has("ask") or sentence.main.has("verb"))
        if not is_open and sentence.main.has("quantity", *COUNTED) and sentence.main.only(*_TO_THE_END):
            who = [name for _, name in sentence.main.names if name in names.bodies]
            clutches = losing.clutches(names) or losing.taking_along(names)
            stopping = [f"{name} stops" for name in losing.runs_down(names) if not who or who == [name]]
            yield [f"slipping of {name} ends" for name in clutches] or stopping
            if losing.braked(names) and not stopping:  # as far as what is braked comes
                yield [f"rate({way}) = 0" for way in lookup.ways(names, "")]
            yield ["rolling begins"] if losing.comes_to_roll(names) else []
            yield ["it stops"] if losing.comes_to_rest(names) else []
        within = [value for before, value in sentence.main.values if before in ("in", "of")]
        within += [value for before, value in sentence.main.values if before in ("on", "along", "through", "over")]
        if len(within) == 1 == len(sentence.main.values):
            [value] = within
            yield [f"t = {value}"] if dimensions.is_time(value, names) else []
            yield [f"{way} = {value}" for way in lookup.ways(names, "")] if dimensions.is_length(value, names) else []
        said = sentence.main.names
        if said and said[-1][1] in names.parameters and sentence.main.has("quantity", *_WAYS):
            yield [f"{way} = {said[-1][1]}" for way in lookup.ways(names, "")]  # on the way d
