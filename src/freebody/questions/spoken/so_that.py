"""What is to be so, where a parameter is asked for with which it is: that it rests, that a quantity has a value."""

from __future__ import annotations

import re
from collections.abc import Callable
from typing import TYPE_CHECKING

from freebody.questions.spoken import dimensions, given, joining, lookup, losing, of_axles, poses, rubbing
from freebody.questions.spoken.asking import quantities
from freebody.questions.spoken.composing import SILENT, Groups
from freebody.questions.spoken.lexicon import Word
from freebody.questions.spoken.relating import as_number
from freebody.questions.spoken.words import Clause

if TYPE_CHECKING:
    from freebody.model.names import Names

_TAUT = ({"stay_taut"}, {"hold", "taut"}, {"hold", "stay_taut"}, {"taut"})  # stays so, or is said to be so
_FACTOR = re.compile(r"\d+(?:\.\d+)?(?:/\d+)?")
_POSES = {"horizontal": poses.level, "level": poses.level, "at the top": poses.uppermost, "top": poses.uppermost}


def so(names: Names, clause: Clause, whole: Callable[..., Groups]) -> Groups:
    """What is to be so, in the words of the grammar."""
    if resting := _resting_as_slip_ends(names, clause):
        yield resting
        return
    clause = _timed_by_equation(names, _stopping_after(names, clause))
    verbs, negated = set(clause.all("verb")), clause.has("not")
    if "end" in verbs:  # it no longer slips
        verbs, negated = verbs - {"end"}, True
    of = [name for _, name in clause.names]
    who = next(iter(of), "")
    everything = all(lookup.is_all_that_moves(names, name) for name in of)
    plain = clause.only("verb", "name", "not", "quantity", "instant", *SILENT)
    turns = {"turn"} if of and all(of_axles.axle_of(names, name) == "center" for name in of) else set[str]()
    if clause.has("degree") and not clause.has("value") and not clause.has("relation"):
        yield from _extremal(names, clause, whole)
        return
    if (
        verbs
        and (verbs <= {"reach", "rise", "move", "turn"} or (verbs <= {"slide", "stop", "move"} and clause.has("value")))
        and (len(of) >= 1 or clause.has("pronoun"))
        and set(clause.all("quantity")) <= {"height"}
        and not negated
    ):
        yield from _reaching(names, clause, of)
        if clause.has("quantity"):
            return
    yield from _no_farther(names, clause, of)
    yield from _in_pose(names, clause, of)
    stays = verbs == {"hold"} or (not verbs and clause.has("relation"))
    if stays and not negated and lookup.is_forced(names):  # the bead stays at 60 deg on the hoop that turns
        yield [f"{text} in steady motion" for text in _staying(names, clause, of)]
    if verbs == {"return"} and not negated:
        yield from _returning(names, clause, of)
    if (
        verbs >= {"hit"}
        and len(clause.values) == 1
        and dimensions.is_speed(clause.values[0][1], names)
        and not clause.has("relation")
    ):
        hitting = [name for name in of if name in lookup.moving(names)] or lookup.massive(names)
        yield [f"speed of {body} before the impact = {clause.values[0][1]}" for body in hitting]  # it hits at 5 m/s
        return
    if verbs == {"leave"} and who and not negated and (at := _where(names, clause)):
        touching = [
            row for row in names.constraint_rows if row.unilateral and joining.touches(names, row.connection, who)
        ]
        yield list(dict.fromkeys(f"{row.reaction} of {row.connection} = 0 when {at}" for row in touching))
        return
    is_none = negated and clause.has("quantity") and verbs <= {"move", "stay"}
    is_given = verbs == {"reach"} and any(name in names.parameters for name in of)
    if (
        clause.has("relation")
        or clause.has("value")
        or "vanish" in verbs
        or is_none
        or is_given
        or _is_negated_motion(clause)
    ):
        yield from _relation(names, clause, whole)
    yield from _in_time(names, clause, whole)
    yield from _failing_first(names, clause)
    if not plain:
        return
    if verbs == {"engage"} and not negated and clause.only("verb", *SILENT):  # both move together
        between = [name for name in rubbing.rough(names, "") if joining.is_between(names, name)]
        yield [f"{name} does not slip" for name in between]
        return
    joint = rubbing.slipping(names, of) or rubbing.slipping_belt(names, of)
    slides = negated and "slide" in verbs <= {"slide", "start", "move"}
    if joint is not None and (slides or (verbs == {"hold"} and not negated and len(of) > 1)):
        yield [f"{joint} does not slip"]
        return
    if set(clause.all("instant")) - {"in equilibrium", "at start", "at once"} and verbs & {"hold"}:
        return  # it stays at the top
    if any(names.bodies[name].fixed for name in of if name in names.bodies) and verbs & {"hold", "stop"}:
        return  # what is held already
    is_balance = clause.all("quantity") == ["equilibrium"] and "stable" not in verbs
    if (verbs & {"hold"} and not negated and verbs <= {"hold", "move"}) or is_balance:
        yield ["it stays at rest"] if everything or _is_held(clause) else []
    elif clause.all("instant") == ["in equilibrium"] and not verbs:
        yield ["it stays at rest"] if everything else []
    elif (
        negated
        and "slide" in verbs
        and verbs <= {"slide", "start", "move"}
        and all(rubbing.is_all_that_slips(names, name) for name in of)
    ):
        yield ["it does not slip"]
    elif negated and verbs and verbs <= {"slide", "start", "move", "fall", "tip", *turns} and everything:
        if verbs & {"slide"}:
            yield ["it does not slip"] if "tip" not in verbs else ["it stays at rest"]
        elif verbs & {"move", "turn"} or ("fall" in verbs and lookup.rests(names)):
            yield ["it stays at rest"]
    elif (
        not negated
        and "start" in verbs
        and (verbs & {"slide", "move"} or lookup.rests(names))
        and verbs <= {"slide", "move", "start"}
        and everything
    ):
        yield (
            ["it does not slip"] if "slide" in verbs else ["it stays at rest"]
        )  # the end of rest is where motion begins
    if verbs == {"stop"} and not negated and len(of) <= 1 and losing.comes_to_roll(names):  # instead of rolling on
        yield [f"velocity of {way} when rolling begins = 0" for way in lookup.places(names, who)]
    holds = verbs or clause.all("instant") == ["in equilibrium"]
    rests = verbs <= {"hold", "stop", "move"} and negated == (verbs == {"move"})
    is_one = holds and rests and len(of) == 1 and not everything
    if is_one and verbs == {"stop"} and joining.comes_to_strike(names):  # one of several that collide
        yield [f"velocity of {place} after the impact = 0" for place in lookup.places(names, who)]
    elif is_one and not rubbing.is_rough(names):  # one of several bodies stays where it is
        moved = "steady amplitude" if lookup.is_forced(names) else "acceleration"
        yield [f"{moved} of {place} = 0" for place in lookup.places(names, who) or lookup.angles(names, who)]
    goes_up = len(of) == 1 and (verbs == {"fall"} if negated else verbs - {"start"} in ({"rise"}, {"fall"}))
    rubs = any(row.reaction.startswith("friction") for row in names.constraint_rows)
    if goes_up and lookup.rests(names) and not (rubs or rubbing.is_held_by_friction(names)):  # let go from rest
        sense = 1 if "rise" in verbs or negated else -1
        ways = lookup.sloping(names, lookup.places(names, who))
        yield [f"acceleration of {way} {'>=' if up == sense else '<='} 0" for way, up in ways]
    if verbs == {"leave"} and who:  # what cannot lift off by itself
        held = joining.joints(names, who, next(iter(of[1:]), ""), "normal force")
        bound = {row.connection for row in names.constraint_rows if row.unilateral}
        opens = any(
            joining.may_open(names, joint) and joining.touches(names, joint, who) for joint in names.connections
        )
        at = " at start" if clause.has("instant", "at start") else ""
        held = [joint for joint in held if joint not in bound and not opens]
        sign = " >= 0" if negated else " = 0"
        ends = [text.replace(" = 0", sign) for text in joining.no_longer_pressed(names, held, of)]
        yield [f"{text}{at}" for text in ends]
    if verbs == {"reach"} and clause.has("quantity"):  # reactions that are equal strike nothing
        return
    at_once = " at once" if clause.has("instant", "at once") else ""
    for group in _happening(names, verbs, negated, who, of):
        yield [f"{text}{at_once}" for text in group]


def _resting_as_slip_ends(names: Names, clause: Clause) -> list[str]:
    """It comes to rest when slipping ends: it has no speed where it would begin to roll."""
    marks = [k for k, word in enumerate(clause.words) if word.kind == "mark"]
    if len(marks) != 1 or not losing.comes_to_roll(names):
        return []
    head, tail = Clause(clause.words[: marks[0]]), Clause(clause.words[marks[0] + 1 :])
    ends = "slide" in tail.all("verb") and {"end", "stop"} & {*tail.all("verb")}
    stops = head.has("verb", "stop", "hold") and not head.has("not") and head.only("name", "verb", *SILENT)
    who = next((name for _, name in head.names), "")
    return [f"velocity of {way} when rolling begins = 0" for way in lookup.places(names, who)] if ends and stops else []


def _stopping_after(names: Names, clause: Clause) -> Clause:
    """It stands still after 20 cm at most: it gets no farther than that. Without `at most` it stops there."""
    after, stop = Word("mark", "after"), Word("verb", "stop")
    k = clause.words.index(after) if after in clause.words else -1
    values = [value for _, value in clause.values]
    if k < 0 or clause.all("verb") != ["stop"] or len(values) != 1 or not dimensions.is_length(values[0], names):
        return clause
    bounded = clause.has("degree", "greatest") or clause.has("relation", "<=")
    kept = [word for word in clause.words if word not in (after, stop)]
    return Clause([*kept, Word("verb", "move") if bounded else stop])


def _timed_by_equation(names: Names, clause: Clause) -> Clause:
    """The force at s = L is F: when s = L, which stands behind."""
    words = [word for word in clause.words if word.kind != "filler"]
    for k in range(1, len(words) - 2):
        led, measure, sign, value = words[k - 1 : k + 3]
        is_one = measure.what in names.measures and sign == Word("relation", "=") and value.kind in ("name", "value")
        rest = [*words[: k - 1], *words[k + 3 :]]
        others = [w for w in rest if w.kind in ("value", "relation") or w.what in names.parameters]
        if is_one and led == Word("preposition", "in") and others and not any(w.kind == "mark" for w in words):
            return Clause([*rest, Word("mark", "when"), measure, sign, value])
    return clause


def _where(names: Names, clause: Clause) -> str:
    """A measure and its value, where something is said to be so."""
    words = [word for word in clause.words if word.kind != "filler"]
    signs = [k for k, word in enumerate(words) if word == Word("relation", "=")]
    if len(signs) != 1 or not 1 <= signs[0] < len(words) - 1:
        return ""
    measure, value = words[signs[0] - 1], words[signs[0] + 1]
    return (
        f"{measure.what} = {value.what}" if measure.what in names.measures and value.kind in ("name", "value") else ""
    )


def _extremal(names: Names, clause: Clause, whole: Callable[..., Groups]) -> Groups:
    """A quantity is to be as large or as small as it can be."""
    ends = [degree for degree in clause.all("degree") if degree in ("greatest", "least")]
    end = {"greatest": "largest", "least": "least"}.get(ends[-1]) if ends else None
    kept = [word for word in clause.words if word.kind != "degree"]
    if not clause.has("quantity") and clause.has("verb") and set(clause.all("verb")) <= {"fly", "move", "reach"}:
        kept = [Word("quantity", "horizontal range"), *(word for word in kept if word.kind == "name")]
    for group in whole(names, kept) if end else ():
        yield [f"{text} is {end}" for text in group if not text.startswith(("does ", "is ", "whether ", "degrees "))]


def _reaching(names: Names, clause: Clause, of: list[str]) -> Groups:
    """A measure is to reach a value, or just to reach it."""
    if clause.all("quantity") == ["height"]:  # it gets 5 m high
        clause = Clause([*clause.without("quantity").words, Word("updown", "up")])
    values = [value for _, value in clause.values]
    signs = [k for k, word in enumerate(clause.words) if word == Word("relation", "=")]
    if len(signs) == 1 and len(of) <= 2 and clause.words[signs[0] - 1].kind == "name":  # it reaches x = d
        of = [clause.words[signs[0] - 1].what, *[name for name in of if name in names.parameters]]
        clause = clause.without("relation")
        clause = Clause([w for w in clause.words if w.kind != "name" or w.what in of])
    if not values and len(of) == 2 and of[1] in names.parameters:
        values = [of[1]]
    of = of or [""]
    if (
        len(values) == 1
        and clause.only("verb", "name", "value", "part", "updown", *SILENT)
        and set(clause.all("part")) <= {"only"}
    ):
        just = " just" if clause.has("part", "only") else ""
        is_angle = dimensions.is_angle(values[0])
        measures = [*lookup.angles(names, of[0]), *lookup.hung(names, of[0])] if is_angle else lookup.ways(names, of[0])
        measures = [of[0]] if of[0] in names.measures else list(dict.fromkeys(measures))
        if way := {"up": 1, "down": -1}.get(next(iter(clause.all("updown")), "")):
            risen = {measure for measure, sense in lookup.inclined(names, of[0]) if sense * way > 0}
            measures = [measure for measure in measures if measure in risen]
        if clause.has("verb", "stop"):
            yield [f"{measure} = {values[0]} when rate({measure}) = 0" for measure in measures]
            return
        yield [f"{measure}{just} reaches {values[0]}" for measure in measures]


def _no_farther(names: Names, clause: Clause, of: list[str]) -> Groups:
    """It falls no deeper than 50 m: the greatest of what is measured that way is at most so large."""
    ways = {"fall": -1, "rise": 1}
    senses = [ways[verb] for verb in clause.all("verb") if verb in ways]
    values = [value for _, value in clause.values] or [name for name in of if name in names.parameters]
    who = [name for name in of if name in lookup.moving(names)]
    words = [_as_sign(word, clause.words[k + 1 : k + 2]) for k, word in enumerate(clause.words)]
    clause = Clause(words)  # it falls at most 50 m
    goes = clause.all("verb") != [] and set(clause.all("verb")) <= {"move", "slide", "fly", "roll"}
    if goes and clause.only("verb", "name", "value", "relation", *SILENT) and clause.all("relation") == ["<="]:
        if len(values) == 1 and dimensions.is_length(values[0], names) and len(who) <= 1:
            yield [f"greatest {way} <= {values[0]}" for way in lookup.ways(names, next(iter(who), ""))]
        return
    plain = clause.only("verb", "name", "value", "relation", *SILENT) and clause.all("verb") != []
    if plain and clause.all("relation") == ["<="] and len(values) == len(senses) == 1 and len(who) <= 1:
        inclined = lookup.inclined(names, next(iter(who), ""))
        yield [f"greatest {measure} <= {values[0]}" for measure, sense in inclined if sense == senses[0]]


def _in_pose(names: Names, clause: Clause, of: list[str]) -> Groups:
    """What swings is to come as far as it lies level, or stands upright."""
    verbs = set(clause.all("verb"))
    said = {*clause.all("part"), *clause.all("instant")} | (verbs & {"top"})
    pose = _POSES.get(next(iter(said), "")) if len(said) == 1 else None
    plain = clause.only("verb", "name", "part", "instant", *SILENT) and len(of) <= 1 and not clause.has("not")
    if pose is not None and plain and verbs and verbs <= {"reach", "rise", "move", "turn", "top"}:
        places = [place for place in pose(names, next(iter(of), "")) if re.fullmatch(r"\w+ = -?\d+ deg", place)]
        yield [place.replace(" = ", " reaches ") for place in places]


def _staying(names: Names, clause: Clause, of: list[str]) -> list[str]:
    """Something stays where its angle has a value."""
    values = [value for _, value in clause.values]
    plain = clause.only("verb", "name", "value", "relation", *SILENT) and len(of) <= 1
    if not plain or len(values) != 1 or not dimensions.is_angle(values[0]):
        return []
    who = next(iter(of), "")
    angles = [who] if who in names.measures else [*lookup.angles(names, who), *lookup.hung(names, who)]
    return [f"{angle} = {values[0]}" for angle in dict.fromkeys(angles)]


def _returning(names: Names, clause: Clause, of: list[str]) -> Groups:
    """It is to come back to where it started, perhaps with a speed."""
    values = [value for _, value in clause.values] + [name for name in of if name in names.parameters]
    who = [name for name in of if name not in names.parameters]
    ways = lookup.ways(names, who[0] if who else "")
    plain = clause.only("verb", "name", "value", "quantity", *SILENT) and len(who) <= 1
    if plain and not values and not clause.has("quantity"):
        yield [f"{way} reaches 0" for way in ways]
    elif plain and len(values) == 1 and set(clause.all("quantity")) <= {"speed", "velocity"}:
        bodies = [name for name in who if name in names.bodies] or lookup.massive(names)
        yield [f"speed of {body} when {way} = 0 is {values[0]}" for way in ways for body in bodies]


def _in_time(names: Names, clause: Clause, whole: Callable[..., Groups]) -> Groups:
    """It is to happen after so much time: it stops within 4 s, rises 1 m in 4 s, reaches 300 rpm in 5 s."""
    values = [word for word in clause.words if word.kind == "value"]
    times = [word for word in values if dimensions.is_time(word.what, names)]
    if len(times) != 1 or not clause.has("verb") or clause.has("quantity") or clause.has("not"):
        return
    k = clause.words.index(times[0])
    led = k > 0 and clause.words[k - 1] == Word("preposition", "in")
    if len(values) == 1:
        kept = [w for w in clause.words if w.kind not in ("value", "mark")]
    elif led and k + 1 == len(clause.words) and not clause.has("mark"):
        kept = clause.words[: k - 1]
    else:
        return
    for group in whole(names, [Word("quantity", "time"), Word("mark", "when"), *kept]):
        yield [f"{text} = {times[0].what}" for text in group if text.startswith("time when ")]


def _failing_first(names: Names, clause: Clause) -> Groups:
    """It tips before it slides as a force grows: the only one, where none is named."""
    verbs = [verb for verb in clause.all("verb") if verb in ("tip", "slide")]
    grows = [word.what for word in clause.words if word.kind == "name" and word.what in names.parameters]
    is_border = clause.has("mark", "until") or clause.has("instant", "at once")  # both at once are the end of the range
    if not grows and not clause.has("verb", "grow") and is_border and not clause.has("not", "not"):
        grows = given.growing(names, [])
        clause = Clause([*clause.words, Word("verb", "grow")])
    if len(verbs) == 2 and verbs[0] != verbs[1] and len(grows) == 1 and clause.has("verb", "grow"):
        first, second = (f"{verb}s" for verb in verbs)
        yield [f"it {first} before it {second} as {grows[0]} grows"]


def _is_held(clause: Clause) -> bool:
    """Whether what is named is what something holds: F that holds the load."""
    kinds = [word.kind for word in clause.words if word.kind in ("verb", "name")]
    return kinds == ["verb", "name"]


def _is_negated_motion(clause: Clause) -> bool:
    return clause.has("not") and clause.has("verb", "accelerate")


def _happening(names: Names, verbs: set[str], negated: bool, who: str, of: list[str]) -> Groups:
    """Something that lasts, or comes, or never does."""
    other = of[1] if len(of) > 1 else ""
    if len(of) > 2:
        return
    if verbs == {"stay_on"}:
        verbs, negated = {"leave"}, not negated
    if verbs == {"fall"} and negated and joining.tracks(names):  # down from its track
        verbs = {"leave"}
    if verbs == {"turn_fully"} and not negated and (held := _on_track(names, _leading_round(names), who, other)):
        yield held
        return
    if verbs in ({"roll", "start"}, {"begin_roll"}) and not negated:
        yield [f"{who} begins to roll" if who else "rolling begins"]
    elif (verbs == {"roll"} and not negated) or (verbs == {"roll", "slide"} and negated):
        yield [f"{who or 'it'} rolls without slipping"]
    elif verbs == {"leave"} and not negated and not any(row.unilateral for row in names.constraint_rows):
        return  # it holds on both sides
    elif verbs == {"leave"} and not negated:
        yield [f"{who or 'it'} leaves {other}".strip() if who or other else "contact is lost"]
        yield [f"{joint} opens" for joint in joining.joints(names, who, other, "normal force")] if who else []
    elif verbs == {"leave"} and negated and (held := _on_track(names, joining.tracks(names), who, other)):
        yield held
    elif verbs == {"leave"} and negated:
        yield [f"{who or 'it'} never leaves {other}".strip() if other else f"{who or 'it'} stays on"]
    elif verbs == {"taut"} and not negated and "stop" in names.called.get(who, ()):  # which is open until then
        yield [f"{who} becomes taut"]
    elif (verbs == {"slack"} and negated) or (verbs in _TAUT and not negated):
        yield [f"{who or 'it'} stays taut"]
    elif verbs == {"turn_fully"} and not negated and who and not stands(names, who):
        yield [f"{who} turns fully"]
    elif verbs == {"self_locking"} and not negated:
        yield rubbing.self_locking(names, of)
    elif (verbs == {"stable"} and not negated) or (verbs == {"unstable"} and negated):
        moves = lookup.is_controlled(names) or lookup.is_forced(names)
        yield ["the equilibrium is stable"] if not moves else []
        yield ["the steady motion is stable"]
    elif verbs <= {"hit", "reach"} and verbs and not negated and who and not other:
        yield [f"it hits {who}"]
    elif verbs <= {"hit", "reach"} and verbs and not negated and other:
        yield (
            [f"{who} reaches {other}"]
            if other in names.parameters or who in names.measures
            else [f"{who} hits {other}"]
        )
        if other in names.parameters:
            yield [f"{place} reaches {other}" for place in lookup.places(names, who)]


def stands(names: Names, who: str) -> bool:
    """Whether a body stands on what it may leave: what turns over there tips."""
    return (
        who in names.bodies
        and not of_axles.axle_of(names, who)
        and any(joining.may_open(names, joint) and joining.touches(names, joint, who) for joint in names.connections)
    )


def _leading_round(names: Names) -> list[str]:
    """What leads something all the way round: a track, or a string from the ground on which it swings."""
    swung = joining.swinging_on(names)
    return [*joining.tracks(names), *(string for string in swung if string not in joining.tracks(names))]


def _on_track(names: Names, leading: list[str], who: str, other: str) -> list[str]:
    """What a link stands for keeps something on as long as it pulls at the top."""
    body = who if who in names.bodies else ""  # it does not fall off the track
    led = [track for track in leading if all(joining.touches(names, track, t) for t in (who, other) if t)]
    return [f"tension of {track} >= 0 when {top}" for track in led for top in poses.uppermost(names, body)]


def _relation(names: Names, clause: Clause, whole: Callable[..., Groups]) -> Groups:
    """An equation or an inequality between a quantity and a value, or two quantities, perhaps at an instant."""
    clause = Clause(_led_by_time(names, clause.words))
    marks = [k for k, word in enumerate(clause.words) if word.kind == "mark"]
    timed = clause.words[marks[0] :] if marks else []
    head = clause.words[: marks[0]] if marks else clause.words
    signs = [k for k, word in enumerate(timed) if word.kind == "relation"]
    if len(signs) == 1 and Clause(timed[: signs[0]]).has("verb") and not Clause(head).has("relation"):
        head, timed = [*head, *timed[signs[0] :]], timed[: signs[0]]  # its speed when it is back is v
    sides = _sides(names, Clause(head))
    if sides is None:
        return
    left, sign, right, tail = sides
    for head in whole(names, [*left.words, *timed]) if timed or left.has("instant") else quantities(names, left):
        for text in head:
            if sign in ("<", "<=") and not timed and not tail and _varies(names, text):  # at no instant of the motion
                text = f"greatest {text}"
            if sign in ("<", "<=") and left.has("quantity", "force") and _may_press(names, text):
                text = f"|{text}|"
            if isinstance(right, str):
                yield [f"{text} is {right}" if timed and sign == "=" else f"{text} {sign} {right}{tail}"]
            else:
                one = as_number(names, text)  # of two vectors the sizes are compared
                times, of = _multiple(left, right)
                for other in quantities(names, of):
                    yield [f"{one} {sign} {times}{as_number(names, what)}{tail}" for what in other]


def _multiple(left: Clause, right: Clause) -> tuple[str, Clause]:
    """The factor with which a quantity is taken, and its words: twice the force in A; twice that in A, as at left."""
    times = right.words[0].what if right.words and right.words[0].kind == "value" else ""
    of = Clause(right.words[1:] if _FACTOR.fullmatch(times) else right.words)
    if of is not right and not of.has("quantity"):
        of = Clause([*(word for word in left.words if word.kind in ("quantity", "part")), *of.words])
    return f"{times}*" if _FACTOR.fullmatch(times) else "", of


def _led_by_time(names: Names, words: list[Word]) -> list[Word]:
    """The words with a time behind what is so then: that it is after 60 s 80 km/h fast, gets to that in 60 s."""
    values = [k for k, word in enumerate(words) if word.kind == "value"]
    if len(values) != len(("time", "other")) or any(word.kind == "relation" for word in words):
        return words
    k, other = values
    leads = k > 0 and words[k - 1] in (Word("mark", "after"), Word("preposition", "in"))
    if not leads or not dimensions.is_time(words[k].what, names) or dimensions.is_time(words[other].what, names):
        return words
    return [*words[: k - 1], *words[k + 1 :], Word("mark", "after"), words[k]]


def _may_press(names: Names, text: str) -> bool:
    """Whether it is the tension of a bar, in which the force is as large where it is pressed."""
    joint = text.removeprefix("tension of ").partition(" at ")[0]
    held = [row for row in names.constraint_rows if row.connection == joint]
    return text.startswith("tension of ") and bool(held) and not any(row.unilateral for row in held)


def _varies(names: Names, text: str) -> bool:
    """Whether a quantity is the force of a spring, or how far it is deflected, or of what stretches as one."""
    what, _, name = text.rpartition(" ")
    is_of_spring = what in ("force in", *(f"{way} of" for way in lookup.STRETCHED))
    return is_of_spring and name in (*lookup.springs(names), *lookup.elastic_strings(names))


def _as_sign(word: Word, after: list[Word]) -> Word:
    """`mindestens 5 N` is an inequality."""
    if word.kind == "degree" and after and after[0].kind == "value":
        return {"least": Word("relation", ">="), "greatest": Word("relation", "<=")}.get(word.what, word)
    return word


def _sides(names: Names, clause: Clause) -> tuple[Clause, str, str | Clause, str] | None:
    words, tail = clause.words, ""
    if clause.has("instant", "at start"):
        words, tail = clause.without("instant", "at start").words, " at start"
    if _is_negated_motion(clause):
        left = [w for w in words if w.kind in ("name", "part")]
        left = [Word(w.kind, lookup.acted_on(names, w.what)) if w.kind == "name" else w for w in left]
        of = [word.what for word in left if word.kind == "name"][:1] or lookup.massive(names)
        kind = "angular acceleration" if all(of_axles.axle_of(names, body) for body in of) else "acceleration"
        return Clause([Word("quantity", kind), *left]), "=", "0", tail
    words = [_as_sign(word, words[k + 1 : k + 2]) for k, word in enumerate(words)]
    signs = [k for k, word in enumerate(words) if word.kind == "relation"]
    if len(signs) == 1:
        [k] = signs
        sign = words[k].what
        left, right = words[:k], Clause(words[k + 1 :])
        behind = [w for w in right.words[1:] if w.kind in ("quantity", "name", "part")]
        if right.words[:1] and right.words[0].kind == "value" and behind and not Clause(left).has("quantity"):
            left, right = [*behind, *left], Clause(right.words[:1])  # by at most 15 cm compressed
        left = Clause(left).without("verb", "reach", "move")
        if right.only("value", "preposition") and len(right.values) == 1:
            return left, sign, right.values[0][1], tail
        if right.only("name", "preposition") and len(right.names) == 1:
            return left, sign, right.names[0][1], tail
        if right.has("verb", "vanish"):
            return left, sign, "0", tail
        return left, sign, right, tail
    if not signs and clause.has("not") and clause.has("quantity") and not clause.has("value"):  # it has no velocity
        return Clause([w for w in words if w.kind not in ("not", "verb")]), "=", "0", tail
    if not signs and clause.has("verb", "accelerate") and len(clause.values) == 1 and not clause.has("quantity"):
        value = clause.values[0][1]
        kept = [w for w in words if w.kind != "value" and w != Word("verb", "accelerate")]
        return Clause([Word("quantity", "acceleration"), *kept]), "=", value, tail
    if not signs and clause.has("verb", "vanish") and not clause.has("not"):
        return Clause(words).without("verb", "vanish", "reach", "move"), "=", "0", tail
    given_ = [word for word in words if word.kind == "name" and word.what in names.parameters]
    if not signs and clause.all("verb") == ["reach"] and len(given_) == 1 and clause.has("quantity"):  # it comes to F
        kept = [word for word in words if word not in (given_[0], Word("verb", "reach"), Word("part", "only"))]
        return Clause(kept), "=", given_[0].what, tail
    values = [word for word in words if word.kind == "value"]
    if not signs and len(values) == 1 and not clause.has("quantity") and not clause.has("not"):
        kind = dimensions.kind_of(values[0].what, names)
        kind = (
            "deceleration" if kind == "acceleration" and clause.has("verb", "stop") else kind
        )  # it brakes with 6 m/s^2
        if kind:
            kept = [w for w in words if w.kind in ("name", "part", "updown")]
            return Clause([Word("quantity", kind), *kept]), "=", values[0].what, tail
    if not signs and len(values) == 1 and not clause.has("not"):
        kept = Clause([word for word in words if word != values[0]])
        return kept.without("verb", "reach", "move"), "=", values[0].what, tail
    return None
