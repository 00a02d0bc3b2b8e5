"""A quantity, and the instant at which it is meant."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import product
from typing import TYPE_CHECKING

from freebody.measures.geometry import GROUND
from freebody.questions.spoken import (
    dimensions,
    farthest,
    joining,
    lookup,
    losing,
    poses,
    rubbing,
    within,
)
from freebody.questions.spoken.asking import quantities
from freebody.questions.spoken.composing import SILENT, Groups, ended
from freebody.questions.spoken.counting import COUNTED
from freebody.questions.spoken.event_within import event_within
from freebody.questions.spoken.events import GOES_ON, conditions
from freebody.questions.spoken.lexicon import Word
from freebody.questions.spoken.sentence import Sentence, clock
from freebody.questions.spoken.striking import BLOWS, NTH_IMPACT, hitting_again, is_caught
from freebody.questions.spoken.throughout import is_given, is_throughout
from freebody.questions.spoken.words import Clause

if TYPE_CHECKING:
    from freebody.model.names import Names

_CONTINUOUS = (
    *(
        "velocity",
        "speed",
        "angular velocity",
        "angle of descent",
        "angle to the horizontal",
        "direction of motion",
        "deflection",
        *lookup.STRETCHED,
        "spring force",
        "position",
        "displacement",
        "angle",
        "height",
        "distance",
    ),
    *("kinetic energy", "potential energy", "total energy", "energy", "linear momentum", "angular momentum"),
    *("rotational energy", "translational energy"),
)
_OF_WHAT_MOVES = (
    *("velocity", "speed", "angular velocity", "kinetic energy", "linear momentum", "angular momentum"),
    *("rotational energy", "translational energy"),
    *("direction of motion", "angle of descent", "angle to the horizontal"),
)
_PLACES = {
    "at the top": poses.tops,
    "at the bottom": poses.lowermost,
    "at the top of the loop": poses.uppermost,
    "turning point": poses.turning,
    "level": poses.level,
    "upright pose": poses.upright,
    "at separation": losing.separated,
    "after engagement": losing.engaged,
    "at the end": losing.at_the_end,
}
_LANDS = (Word("pronoun", "it"), Word("verb", "hit"))
_TERMINAL = {"terminal velocity": "speed", "terminal angular velocity": "angular velocity"}
_LANDING = {"impact speed": "speed", "impact angle": "angle of descent"}
_DEAD = ("at the dead points", "at the outer dead point", "at the inner dead point")
_TIMED = {text: f" {text}" for text in ("in steady motion", "when t grows", *_DEAD)}


def timed(names: Names, sentence: Sentence) -> Groups:
    """A quantity, and when it is meant."""
    main, others = sentence.main, [one for one in sentence.others if not is_throughout(names, *one)]
    others = [(mark, clause) for mark, clause in others if not (mark == "when" and is_given(names, clause))]
    if _may_settle(names, sentence):
        return
    lasts = main.has("degree", "greatest") and not joining.strikes(names)
    if lasts and not any(row.closes for row in names.constraint_rows):  # with a buffer, which takes its time
        main = main.without("instant", "in the impact", "at the impact")
    main = hitting_again(names, _told_twice(names, main, others))
    if main.has("instant", "over the motion") and not main.has("degree") and joining.goes_on(names):
        main = main.without("instant", "over the motion")
    if main.has("quantity", "deflection", *lookup.STRETCHED) and main.all("verb") == ["hold"]:
        main = Clause([*main.without("verb").words, Word("instant", "in equilibrium")])  # stretched where it rests
    at_rest = _in_equilibrium(names, main) if not others else None
    if at_rest is not None:
        yield from at_rest
        return
    is_thrown_back = not joining.strikes(names) and lookup.catching(names, pulls=False)  # by a buffer
    if main.all("instant") == ["after the impact"] and not others and is_thrown_back:
        main, others = main.without("instant"), [("when", Clause([Word("verb", "bounce")]))]
    if main.has(
        "quantity", "deflection", "displacement", *lookup.STRETCHED
    ):  # how far until something happens is how far when it does
        others = [("when" if mark == "until" else mark, clause) for mark, clause in others]
    is_range = main.has("ask", "up_to") and set(main.all("quantity")) <= {"angle", "height"} and not main.has("not")
    asks = ("when", "soon", "long", "for", "from", *(() if is_range and main.has("quantity") else ("up_to",)))
    if main.has("ask", *asks) or main.has("quantity", *COUNTED):
        return
    if (
        (main.has("ask", "high", "far", "up_to") or main.has("degree", "greatest"))
        and main.all("instant") == ["after the impact"]
        and joining.is_struck_at_start_alone(names)
    ):
        main = main.without("instant")
    is_place = main.all("quantity") in (["angle"], ["position"], ["height"], ["distance"]) and main.has("ask", "with")
    if is_place and main.all("verb") == ["hold"]:  # at what angle does it sit
        main = Clause([Word("quantity", "equilibrium"), *(w for w in main.words if w.kind == "name")])
    if main.has("ask", "high") or main.all("quantity") == ["height"]:
        after = [one for one in main.all("instant") if (nth := NTH_IMPACT.fullmatch(one)) and nth["side"] == "after"]
        if after and not others and main.all("instant") == after and not main.has("degree", "least"):
            yield from farthest.after_bounce(names, main, after[0])
            return
    if farthest.is_settled(main) and not others:
        yield from farthest.where_it_settles(names, main)
        return
    if main.has("ask", "high") and main.all("degree") == ["greatest"] and not main.has("quantity"):
        main = main.without("degree") if set(main.all("verb")) & {*GOES_ON, "reach"} else main  # how high at most
    if main.has("ask", "high") and not others and main.has("verb") and main.only("ask", "verb", "name", "pronoun"):
        yield from farthest.how_high(names, main)
        return
    if main.has("ask", "far") and main.all("degree") == ["greatest"] and not main.has("quantity"):
        falls = (main.has("updown") and main.has("verb")) or main.has("verb", "fall")
        falls |= main.all("verb") == ["turn"] and any(lookup.hung(names, name) for _, name in main.names)
        falls = falls and set(main.all("verb")) <= {*GOES_ON, "reach"}
        main = main.without("degree") if falls else main  # how deep at most
    is_range = set(main.all("verb")) <= {"fly", "hit"} and main.only("ask", "verb", "name", "pronoun")
    is_far = main.has("ask", "far") and main.only("ask", "verb", "name", "pronoun", "updown", "part")
    if is_far and not is_range and not others:
        yield from farthest.how_far(names, main)
        return
    if main.has("ask", "where") and main.has("instant", "in equilibrium") and not main.has("quantity"):
        main = Clause([Word("quantity", "equilibrium"), *main.without("ask").without("verb").without("instant").words])
    main = _begun(names, main, others)
    if main.has("quantity", "common speed") and joining.is_struck_at_start_alone(names):  # after the bullet hits it
        others = [(mark, own) for mark, own in others if not (mark in ("after", "when") and own.has("verb", "hit"))]
    main = _in_other_names(names, main, others)
    tails, main = _tails(names, main)
    tails, main = _understood(names, main, others, tails)
    if _in_first_phase(names, main, others):
        others, tails = [], [*tails, [" at start"]]
    if any(_is_of_state(mark, clause) for mark, clause in others) and not _is_continuous(names, main):
        return
    for mark, clause in others:
        found = list(_at(names, mark, clause))
        if not found:
            return
        tails.append([text for group in found for text in group])
    if len(tails) > 1:  # said twice: in the lowest position, theta = 0
        tails = [[text for text in tails[0] if all(text in own for own in tails)]]
        if not tails[0] or others:
            return
    event = event_within(names, main) if not tails else None
    if event is not None:
        head, conditions_ = event
        for group, when in product(list(quantities(names, head)), conditions_):
            pairs = product(group, when)
            yield [ended(text, f" when {end}") for text, end in pairs if not end.startswith(f"{text} = ")]
        return
    if not tails:
        yield from quantities(names, main)
        return
    for tail in _at(names, others[0][0], others[0][1]) if len(others) == 1 else iter(tails[:1]):
        for group in quantities(names, main):
            yield [ended(text, end) for text, end in product(group, tail) if not end.startswith(f" when {text} = ")]


def _in_equilibrium(names: Names, main: Clause) -> Iterator[list[str]] | None:
    """What something is where it rests: a place, how far a spring is stretched. None where it is not meant so."""
    if main.all("instant") != ["in equilibrium"]:
        return None
    of = [name for _, name in main.names]
    plain = main.only("ask", "quantity", "instant", "name", "verb", *SILENT)
    if main.has("quantity", "deflection"):
        measures = [f"equilibrium of {measure}" for measure in lookup.deflections(names, next(iter(of), ""))]
        return iter([measures, lookup.stretched_at_rest(names, next(iter(of), ""))] if plain else [])
    if main.has("quantity", *lookup.STRETCHED):
        longer = lookup.stretched_at_rest(names, next(iter(of), "")) if plain and len(of) <= 1 else None
        if longer is None:
            return iter([])
        return iter([longer if main.has("quantity", "extension") else [f"-({text})" for text in longer]])
    if main.only("name", "instant", *SILENT) and len(of) == 1 and of[0] in names.measures:  # y in equilibrium
        return iter([[f"equilibrium of {of[0]}"]])
    if main.all("quantity") == ["depth"]:
        deep = quantities(names, main.without("instant").without("ask"))
        return ([f"equilibrium of {measure}" for measure in group] for group in deep)
    return None


def _begun(names: Names, main: Clause, others: list[tuple[str, Clause]]) -> Clause:
    """A clause without what only says that something sets off, arrives or comes back: with what acceleration does it
    start to move is its acceleration at the start."""
    speeds_up = main.has("verb", "accelerate") or main.has("quantity", "acceleration", "angular acceleration")
    if speeds_up and main.has("verb", "start") and not main.has("instant"):  # with what acceleration does it set off
        kept = main.without("verb", "start", "move").without("part", "initial")
        main = Clause([*kept.words, Word("instant", "at start")])
    is_so_far = any(mark == "after" and clause.has("value") for mark, clause in others)
    if (
        others and main.has("quantity") and (is_so_far or not joining.strikes(names))
    ):  # with what speed does it arrive after 3 m
        main = main.without("verb", "hit", "reach", *(["bounce"] if not joining.strikes(names) else []))
    if any(mark in ("when", "after") for mark, _ in others) and main.has("quantity", *_OF_WHAT_MOVES):
        main = main.without("verb", "return")  # with what speed does it run back when the string is slack again
    if main.has("instant", "after the impact") and main.has("ask", "fast"):
        main = main.without("verb", "leave")  # how fast does it leave
    begins = {"start"} < set(main.all("verb")) <= {"start", *GOES_ON}
    begins |= main.all("verb") == ["start"]
    if begins and main.all("instant") == ["after the impact"] and main.has("quantity") and not others:
        main = main.without("verb")  # with what speed does it begin to swing
    sets_off = begins and main.has("quantity", "velocity", "speed", "angular velocity") and main.has("ask", "with")
    is_sent = not lookup.rests(names) or joining.is_struck_at_start_alone(names)
    is_sent &= set(main.all("verb")) <= {"start", "turn", "move"} and not rubbing.is_rough(names)  # or it rolls later
    if sets_off and is_sent and not others and not main.has("instant"):  # with what speed it sets off
        main = Clause([*main.without("verb").words, Word("instant", "at start")])
    accelerates = main.has("quantity", "acceleration", "angular acceleration") and main.has("verb", "start")
    accelerates = accelerates and not rubbing.is_still(names)
    if (
        accelerates and set(main.all("verb")) <= {"start", *GOES_ON} and not others
    ):  # with what acceleration does it start to move
        main = Clause([*main.without("verb").words, Word("instant", "at start")])
    return main


def _in_other_names(names: Names, main: Clause, others: list[tuple[str, Clause]]) -> Clause:
    """A clause with the quantities as the instant has them: the final speed once it rolls, the speed of what turns
    alike after it has engaged, what goes round in steady motion."""
    if main.has("quantity", *_TERMINAL) and others:  # the final speed once it rolls
        main = Clause(
            [Word("quantity", _TERMINAL.get(w.what, w.what)) if w.kind == "quantity" else w for w in main.words]
        )
    is_steady = main.all("instant") == ["in steady motion"] and main.all("quantity") == ["angular velocity"]
    if is_steady and names.space and not main.names:  # of what goes round
        main = Clause([Word("quantity", "precession rate") if w.kind == "quantity" else w for w in main.words])
    if main.all("instant") == ["after engagement"] and not main.names and not others:  # both turn alike
        alike = ("speed", "angular velocity", "velocity")
        common = Word("quantity", "common speed")
        main = Clause([common if w.kind == "quantity" and w.what in alike else w for w in main.words])
    if not others and not main.has("instant") and main.has("ask", "far", "much", "large"):
        main = _at_most(names, main)
    if main.has("quantity", "common speed") and losing.clutches(names):
        main = main.without("instant", "at the end")  # of what slips, where both turn alike
    return main


def _understood(
    names: Names, main: Clause, others: list[tuple[str, Clause]], tails: list[list[str]]
) -> tuple[list[list[str]], Clause]:
    """The instants that go without saying: of the speed of impact, of a common speed, of an initial value."""
    if main.has("quantity", *_LANDING):
        main = Clause(
            [Word("quantity", _LANDING.get(w.what, w.what)) if w.kind == "quantity" else w for w in main.words]
        )
        struck = {GROUND, *names.bodies[GROUND].lines, *names.bodies[GROUND].planes}
        landing = Clause([*(w for w in main.words if w.kind == "name" and w.what in struck), *_LANDS])
        main = Clause([w for w in main.words if w not in landing.words])
        tails = tails or (
            [] if others else [[f" when {text}" for group in conditions(names, landing) for text in group]]
        )
    if main.has("quantity", "common speed") and not others:
        taking = losing.clutches(names) or losing.taking_along(names)
        tails = tails or [[f" when slipping of {name} ends"] for name in taking]
        tails = tails or ([[" after the impact"]] if names.closing_later else [])
        tails = tails or ([[" at start"]] if joining.is_struck_at_start_alone(names) else [])
    if main.has("quantity", "precession rate"):  # of a top that does not nod, unless another instant is said
        tails = tails or ([] if others else [[" in steady motion"]])
    if any(word.kind == "part" and word.what == "initial" for word in main.words) and not tails:
        main, tails = main.without("part", "initial"), [[" at start"]]
    return tails, main


def _in_first_phase(names: Names, main: Clause, others: list[tuple[str, Clause]]) -> bool:
    """Whether it is said of the phase with which a motion begins, of which forces and accelerations do not change:
    while it slides, where it comes to roll; while it rises, where it turns back."""
    slides = [clause for mark, clause in others if mark == "while" and clause.all("verb") == ["slide"]]
    is_first = losing.comes_to_roll(names) or (losing.clutches(names) and not lookup.rests(names))
    rising = [clause for mark, clause in others if mark == "while" and clause.all("verb") == ["rise"]]
    if rising and any(lookup.rises(names, way, sense) for way, sense in lookup.inclined(names, "")):
        slides, is_first = rising, True
    return len(slides) == 1 == len(others) and bool(is_first) and not _is_continuous(names, main)


def _at_most(names: Names, main: Clause) -> Clause:
    """How far a spring is compressed that something comes upon, or that swings, is how far at most."""
    of = next((name for _, name in main.names), "")
    is_stretched = main.all("quantity") in (["deflection"], *([way] for way in lookup.STRETCHED))
    if not is_stretched or main.has("degree") or main.has("verb") or main.has("value") or main.has("relation"):
        return main
    comes = bool(lookup.deflected(names, of)) or not lookup.rests(names)
    return Clause([Word("degree", "greatest"), *main.words]) if comes else main


def _is_of_state(mark: str, clause: Clause) -> bool:
    """Whether it is said of a state that lasts, or of what comes after an event: when it rolls, after it slipped."""
    verbs = set(clause.all("verb"))
    contact = verbs & {"roll", "slide", "hit", "leave", "slack", "taut", "stop", "begin_roll"}
    return bool(contact) and (mark == "after" or (verbs <= {"roll", "slide"} and not clause.has("value")))


def _may_settle(names: Names, sentence: Sentence) -> bool:
    """Whether it is asked where something comes to rest that is let go and that nothing stops: where it turns back for
    an instant may be meant, or where it settles."""
    main, others = sentence.main, sentence.others
    is_where = main.has("ask", "where") or main.all("quantity") in (["angle"], ["position"], ["height"])
    doing = [own for mark, own in others if mark == "when"] or [main]
    stops = len(doing) == 1 and doing[0].all("verb") == ["stop"] and len(others) <= 1
    stops = stops and not any(own.has("instant") for own in (main, *doing))
    return is_where and stops and lookup.rests(names) and not rubbing.is_rough(names)


def _is_continuous(names: Names, main: Clause) -> bool:
    """Whether a quantity is the same just before and just after rolling or slipping begins: forces and accelerations
    are not."""
    asked = main.all("quantity")
    if not asked:
        return not main.has("verb", "accelerate")
    return all(quantity in _CONTINUOUS for quantity in asked)


def _of_another(main: Clause, instant: str) -> tuple[str, Clause]:
    """Whose instant it is, where that is said behind it, and the clause without: at the dead points of the rocker."""
    k = main.words.index(Word("instant", instant))
    of, thing = [*main.words[k + 1 : k + 3], Word("", ""), Word("", "")][:2]
    if of != Word("preposition", "of") or thing.kind != "name":
        return "", main
    return f" of {thing.what}", Clause([*main.words[: k + 1], *main.words[k + 3 :]])


def _tails(names: Names, main: Clause) -> tuple[list[list[str]], Clause]:
    """Instants within a main clause, and the clause without them."""
    tails: list[list[str]] = []
    for instant in main.all("instant"):
        if instant == "at start":
            tails.append([" at start"])
        elif instant in _TIMED:
            whose, main = _of_another(main, instant) if instant in _DEAD else ("", main)
            is_one_of_both = instant in _DEAD and any(joining.guides(names, body) for body in lookup.moving(names))
            tails.append([f"{_TIMED[instant if is_one_of_both or instant not in _DEAD else _DEAD[0]]}{whose}"])
        elif NTH_IMPACT.fullmatch(instant):
            tails.append([f" {instant}"])
            main = main.without("instant", instant)
        elif instant in BLOWS:
            struck = joining.is_struck_at_start_alone(names)
            tails.append([" at start" if struck and instant[0] == "a" else f" {instant}"])
        elif instant in _PLACES:
            of = next((name for _, name in main.names if name in lookup.moving(names) or name in names.measures), "")
            main = _without_owner(names, main, instant)
            lies = instant == "level" and poses.begins_lying(names, of) and lookup.rests(names)
            if lies or (instant == "upright pose" and poses.begins_hanging(names, of)):
                tails.append([" at start"])
                continue
            if (instant in ("at the top", "at the top of the loop") and poses.begins_uppermost(names, of)) or (
                instant == "at the bottom" and not lookup.rests(names) and poses.begins_at(names, of, lowest=True)
            ):
                tails.append([" at start"])
                continue
            if instant == "at the top" and joining.tracks(names):
                instant = "at the top of the loop"
            found_at = _PLACES[instant](names, of) or (_uppermost(names, of) if instant == "at the top" else [])
            tails.append([f" when {text}" for text in found_at])
        elif instant == "at the impact" or (instant == "in the impact" and _is_continuous(names, main)):
            if main.has("verb", "reach"):  # the height reached is no height in the impact
                return [[]], main
            if joining.is_struck_at_start_alone(names):
                tails.append([" at start"])
                main = main.without("instant", "in the impact")
                continue
            of = next((name for _, name in main.names), "")
            heights = lookup.rising(names, of) or lookup.falling(names, of)
            caught = [name for _, name in main.names if name in lookup.catching(names, pulls=False)]
            if caught:  # by a buffer
                main = Clause([w for w in main.words if w != Word("name", caught[0])])
                tails.append([f" when {caught[0]} is reached"])
                main = main.without("instant", "in the impact")
                continue
            landed = [[f"{height} = 0" for height in heights]] if heights else conditions(names, Clause([*_LANDS]))
            on_the_way = [] if joining.strikes(names) else landed
            tails.append([f" when {text}" for group in on_the_way for text in group] or [" when it hits"])
            main = main.without("instant", "in the impact")
        elif instant == "in equilibrium" and (main.has("quantity", *_OF_WHAT_MOVES) or main.has("ask", "fast")):
            of = next((name for _, name in main.names), "")  # as it passes there; at rest it has none
            tails.append([f" when {text}" for text in losing.in_balance(names, of)])
        elif instant == "in equilibrium":
            tails.append([" in equilibrium"])
    main = main.without("instant", "at start", *_TIMED, *_PLACES, *BLOWS, "at the impact", "in equilibrium")
    times = [value for before, value in main.values if before in ("in", "of", "")]
    if main.has("relation"):
        found = within.equation_at_end(main)
        if found is not None:
            main, condition = found
            tails.append([f" when {condition}"])
        elif (compared := within.two_compared(main)) is not None:
            main, at = compared
            tails.append([f" when {condition}" for group in conditions(names, at) for condition in group])
    elif not main.values and (asked := within.place_by_parameter(names, main)) is not None:
        head, at = asked
        if found_at := [c for group in conditions(names, at) for c in group]:
            tails.append([f" when {condition}" for condition in found_at])
            main = head
    elif len(times) == 1 and len(main.values) == 1:
        [value] = times
        kept = Clause([w for w in main.words if w != Word("value", value)])
        if dimensions.is_time(value, names) and not kept.has("ask", "far", "much"):
            tails.append([f" after {value}"])
            main = kept
        elif (asked := within.place_within(main, value)) is not None:
            head, at = asked
            found_at = [c for group in conditions(names, at) for c in group]
            if found_at:
                tails.append([f" when {condition}" for condition in found_at])
                main = head
    return tails, main


def _told_twice(names: Names, main: Clause, others: list[tuple[str, Clause]]) -> Clause:
    """At the bottom after 80 m: where the model has no such place, or has it there, the length alone says where."""
    places = [place for place in main.all("instant") if place in ("at the bottom", "at the end")]
    is_told = len(others) == 1 and any(dimensions.is_length(value, names) for _, value in others[0][1].values)
    of = next((name for _, name in main.names), "")
    if len(places) != 1 or not is_told:
        return main
    told = others[0][1].values[0][1]
    if not all(dimensions.is_same(names, told, text.rpartition("= ")[2]) for text in _PLACES[places[0]](names, of)):
        return main
    return main.without("instant", places[0])


def _without_owner(names: Names, main: Clause, instant: str) -> Clause:
    """Without what a place is of: at the bottom of the wire."""
    k = next(k for k, word in enumerate(main.words) if word == Word("instant", instant))
    of, thing = [*main.words[k + 1 : k + 3], Word("", ""), Word("", "")][:2]
    is_owner = of == Word("preposition", "of") and thing.kind == "name" and thing.what in names.connections
    return Clause([*main.words[: k + 1], *main.words[k + 3 :]]) if is_owner else main


def _uppermost(names: Names, of: str) -> list[str]:
    """Where what goes up a slope at the start turns back."""
    return [f"rate({way}) = 0" for way, sense in lookup.inclined(names, of) if lookup.rises(names, way, sense)]


def _at(names: Names, mark: str, clause: Clause) -> Groups:
    """The instant that a clause beside the main one says."""
    if mark in ("until", "while"):
        return
    if clause.has("verb", "hit") and any(is_caught(names, name) for _, name in clause.names):
        yield [" before the impact" if mark == "when" else " after the impact"]
        return
    lines = {*names.bodies[GROUND].lines, *names.bodies[GROUND].planes}
    if mark == "after" and clause.only("name", *SILENT) and {name for _, name in clause.names} <= lines:
        yield [f" when {place}" for place in losing.at_the_end(names)]  # at the end of the incline
        return
    if mark == "after":
        time = clock(names, clause)
        if time is not None:
            yield [f" after {time}"]
            return
        closed = [name for _, name in clause.names if name in names.struck_at_start or name in names.closing_later]
        if clause.only("name", *SILENT) and len(closed) == len(clause.names) == 1:  # after the coupling
            yield [" at start" if joining.is_struck_at_start_alone(names) else " after the impact"]
            return
        if clause.has("verb", "hit", "bounce") and joining.is_struck_at_start_alone(names):
            yield [" at start"]
            return
        if clause.has("verb", "hit", "bounce"):
            yield (
                [" after the impact"]
                if clause.only("verb", "name", "pronoun", "preposition") and joining.strikes(names)
                else []
            )
            return
        if clause.all("verb") == ["taut"] and clause.only("verb", "name", "pronoun", "preposition"):  # with a jerk
            strings = [name for _, name in clause.names]
            if all(name in names.connections for name in strings) and len(strings) <= 1:
                yield [" after the impact" + "".join(f" of {name}" for name in strings)]
                return
    starts = [instant for instant in clause.all("instant") if instant == "at start"]
    if starts and clause.only("instant", "pronoun", "name"):
        yield [" at start"]
        return
    places = {"at the top": False, "at the bottom": True}
    said = [instant for instant in clause.all("instant") if instant in places and not lookup.rests(names)]
    if len(said) == 1 and clause.only("instant", "pronoun", "name", "verb", "preposition"):
        of = next((name for _, name in clause.names if name in lookup.moving(names)), "")
        if poses.begins_at(names, of, lowest=places[said[0]]):
            yield [" at start"]
            return
    if clause.has("part", "horizontal") and clause.only("part", "name", "verb", *SILENT) and lookup.rests(names):
        of = next((name for _, name in clause.names if name in lookup.moving(names)), "")
        if poses.begins_lying(names, of):  # let go where it lies level
            yield [" at start"]
            return
    if (
        clause.only("pronoun", "verb", "preposition", "name")
        and clause.all("verb") in (["start"], ["start", "move"])
        and mark != "after"
    ):
        return
    for group in conditions(names, clause):
        yield [f" when {condition}" for condition in group]
