"""When something is meant: a clause about what happens, as groups of conditions of the grammar (composing.py)."""

from __future__ import annotations

import re
from collections.abc import Callable
from itertools import pairwise
from typing import TYPE_CHECKING

from freebody.language.notation import to_python
from freebody.measures.geometry import GROUND, ZERO
from freebody.questions.event import leads_to
from freebody.questions.spoken import (
    along_lines,
    dimensions,
    driving,
    joining,
    lookup,
    losing,
    of_axles,
    poses,
    rubbing,
    strings,
)
from freebody.questions.spoken.asking import quantities
from freebody.questions.spoken.coming import angles_of, come_so_far, going_at
from freebody.questions.spoken.composing import SILENT, Groups
from freebody.questions.spoken.lexicon import Word
from freebody.questions.spoken.words import Clause

if TYPE_CHECKING:
    from freebody.model.names import Names

HAPPENS = (  # verbs of what comes at an instant; the others are of what goes on
    *("hit", "leave", "stop", "turn_back", "return", "reach", "start", "end", "slack", "taut"),
    *("vanish", "top", "bottom", "begin_roll", "engage", "run_off", "bounce", "lock"),
)
_WAYS = ("distance", "displacement", "distance travelled", "angle", "height")
POSES = {
    "horizontal": poses.level,
    "vertical": poses.upright,
    "upright": poses.uppermost,
    "hanging": poses.lowermost,
    "to the right": poses.to_the_right,
    "to the left": poses.to_the_left,
}
_POINTING = {**POSES, "upward": poses.uppermost, "downward": poses.lowermost}
_FINAL = ("terminal velocity", "terminal angular velocity")
_NUMBER = re.compile(r"\d+(?:\.\d+)?(?:/\d+)?")
_SHARE = re.compile(r"\d+(?:\.\d+)?/\d+")
_LIES = {"stop", "hang", "hold", "reach", "move", "become", "turn", "fall", "rise"}  # verbs of what is in a pose
GOES_ON = ("move", "slide", "roll", "turn", "fall", "rise", "accelerate", "fly")


def conditions(names: Names, clause: Clause) -> Groups:
    """The conditions that a clause can state."""
    verbs = [verb for verb in clause.all("verb") if verb not in ("act", "exert")]
    if clause.has("ask") or clause.has("quantity", "time"):
        return
    kinds = ("degree", "quantity", "name", "verb", *(["part"] if clause.has("quantity") else []), *SILENT)
    if clause.has("degree", "greatest", "least") and clause.only(*kinds):
        yield from _extremes(names, clause)
    elif clause.has("instant"):
        yield from _instants(names, clause)
    elif clause.has("relation"):
        yield from _equations(names, clause)
    elif clause.all("quantity") in (["highest place"], ["lowest place"]) and not clause.values:
        of = next((name for _, name in clause.names), "")
        yield (poses.tops if clause.has("quantity", "highest place") else poses.lowermost)(names, of)
    elif clause.has("quantity"):
        yield from _of_quantity(names, clause, verbs)
    elif clause.has("part", *POSES) and clause.only("part", "name", "verb", *SILENT) and set(verbs) <= _LIES:
        of = next((name for _, name in clause.names if name not in names.connections), "")
        said = {*clause.all("part")} - {"vertical"} or {"vertical"}  # straight up is not straight down
        told = _POINTING if clause.has("part", "vertical") else POSES
        yield told[next(iter(said))](names, of) if len(said) == 1 and said <= told.keys() else []
    else:
        if clause.values or clause.has("turns") or any(name in names.parameters for _, name in clause.names):
            yield from come_so_far(names, clause, verbs)
        yield from _happening(names, clause, verbs)


def _instants(names: Names, clause: Clause) -> Groups:
    """Instants that have a name of their own."""
    of = next((name for _, name in clause.names), "")
    for instant in clause.all("instant"):
        if instant == "at the top":
            yield poses.tops(names, of)
        elif instant == "at the top of the loop":
            yield poses.uppermost(names, of)
        elif instant == "at the bottom":
            yield poses.lowermost(names, of) or ([f"{of or 'it'} hits"] if joining.comes_to_strike(names) else [])
        elif instant == "turning point":
            yield poses.turning(names, of)
        elif instant in ("level", "upright pose"):
            yield (poses.level if instant == "level" else poses.upright)(names, of)
        elif instant in ("at the impact", "in the impact"):
            yield [f"{of or 'it'} hits"]
        elif instant in ("at separation", "after engagement"):
            yield (losing.separated if instant == "at separation" else losing.engaged)(names)


def _extremes(names: Names, clause: Clause) -> Groups:
    """x is greatest; the speed is smallest."""
    ends, of = clause.all("degree"), [name for _, name in clause.names]
    if len(ends) != 1 or set(clause.all("verb")) - {"become", "reach"}:
        return
    if not clause.has("quantity"):
        yield [f"{name} is {ends[0]}" for name in of if name in names.measures and len(of) == 1]
        return
    asked = clause.without("degree").without("verb")
    said = [Word("quantity", "speed") if w == Word("quantity", "velocity") else w for w in asked.words]
    for group in quantities(names, Clause(said)):
        yield [f"{text} is {ends[0]}" for text in group]


# -- what is equal to something ---------------------------------------------------------------
def _equations(names: Names, clause: Clause) -> Groups:
    """x = d; the tension = 0; the speed = 2 m/s."""
    k = next(k for k, word in enumerate(clause.words) if word.kind == "relation")
    left, right = Clause(clause.words[:k]), Clause(clause.words[k + 1 :])
    if clause.words[k].what == "=" and left.has("quantity") and right.has("quantity"):
        yield from _multiples(names, left, right)
        return
    if clause.words[k].what != "=" or not right.only("value", "name", *SILENT, "verb"):
        return
    value = next((word.what for word in right.words if word.kind in ("value", "name")), None)
    value = "0" if value is None and right.has("verb", "vanish") else value
    if value is None or len(right.names) + len(right.values) > 1:
        return
    if left.has("quantity"):
        yield from _quantity_is(names, left, value)
        return
    of = [name for _, name in left.names]
    doing = {"reach", "move", "return", "turn", "start", "hit"}
    if not left.only("name", "verb", *SILENT) or not of or not set(left.all("verb")) <= doing:
        return
    measure = names.measures.get(of[-1])
    owners = {GROUND, *(() if measure is None else measure.bodies())}
    if len(of) == 1 or set(of[:-1]) <= owners:  # the ball reaches x = 2 m
        yield [f"{of[-1]} = {value}"]


def _multiples(names: Names, left: Clause, right: Clause) -> Groups:
    """One quantity is equal to another one, or to so many times it: a number before it."""
    factors = [value for _, value in right.values]
    is_product = len(factors) == 1 and _NUMBER.fullmatch(factors[0]) is not None
    if factors and not is_product:
        return
    other = right.without("value").without("verb")
    if not any(name for _, name in other.names):
        other = Clause([*other.words, *(word for word in left.words if word.kind == "name")])
    for one in quantities(names, left.without("verb", "become", "reach")):
        for group in quantities(names, other):
            yield [f"{a} = {f'{factors[0]}*' if factors else ''}({b})" for a in one for b in group if a != b]


def _of_quantity(names: Names, clause: Clause, verbs: list[str]) -> Groups:
    """The angle is 60 deg; its height reaches h; the normal force vanishes; at a crank angle of 60 deg."""
    values = [value for _, value in clause.values]
    if (set(verbs) & set(GOES_ON) or not verbs) and (plain := _without_kind(names, clause)) is not None:
        yield from come_so_far(names, plain, verbs)
        return
    if clause.all("quantity") == ["equilibrium"] and not values:
        if clause.only("quantity", "verb", "name", *SILENT) and set(verbs) <= {"reach", "move", "turn"}:
            yield losing.in_balance(names, next((name for _, name in clause.names), ""))
        return
    if clause.has("quantity", *_FINAL):
        yield _share_of_final(names, clause, values) if set(verbs) <= {"reach", "move", "turn", "fall"} else []
        return
    left = clause.without("value").without("verb", "vanish", "reach")
    if "halve" in verbs and not values:
        yield from _halved(names, clause)
        return
    if "vanish" in verbs and not values:
        yield from _quantity_is(names, left, "0")
    elif len(values) == 1 and set(verbs) <= {"reach", "move", "turn", "rise", "fall", "start"}:
        yield from _quantity_is(names, left.without("verb"), values[0])
    elif not values and set(verbs) <= {"reach"} and clause.names and clause.names[-1][1] in names.parameters:
        value = clause.names[-1][1]
        kept = [word for word in left.words if word.what != value]
        yield from _quantity_is(names, Clause(kept), value)


def _share_of_final(names: Names, clause: Clause, values: list[str]) -> list[str]:
    """It has half of its final speed, 90 % of it: a share that stands before the speed itself."""
    of = [name for _, name in clause.names]
    if len(values) != 1 or _SHARE.fullmatch(values[0]) is None or len(clause.all("quantity")) > 1 or len(of) > 1:
        return []
    who = lookup.acted_on(names, of[0]) if of else ""
    angles = lookup.angles(names, who)
    is_turning = clause.has("quantity", _FINAL[1]) or (who and of_axles.axle_of(names, who) == "center")
    found = angles if is_turning else lookup.places(names, who) or angles
    return [f"velocity of {name} = {values[0]} of its final value" for name in found]


def _halved(names: Names, clause: Clause) -> Groups:
    """A speed has fallen to half of what it is at the start."""
    of = next((name for _, name in clause.names), "")
    turning = clause.has("quantity", "angular velocity")
    if clause.has("quantity", "angular velocity", "velocity", "speed") and len(clause.names) <= 1:
        measures = lookup.angles(names, of) if turning else lookup.places(names, of)
        measures = measures or (lookup.angles(names, of) if of_axles.axle_of(names, of) == "center" or not of else [])
        moving = [(name, names.start_rates.get(name, ZERO)) for name in measures]
        yield [f"rate({name}) = {to_python(rate / 2).replace('**', '^')}" for name, rate in moving if rate != ZERO]


def _without_kind(names: Names, clause: Clause) -> Clause | None:
    """A clause without a word that only says what a parameter is: it has covered the distance d."""
    ways = _WAYS if clause.has("verb") else _WAYS[:3]
    for quantity, named in pairwise(clause.words):
        if quantity.kind == "quantity" and named.kind == "name" and named.what in names.parameters:
            is_way = quantity.what in ways
            return clause.without("quantity") if is_way and len(clause.all("quantity")) == 1 else None
    return None


def _quantity_is(names: Names, clause: Clause, value: str) -> Groups:
    if not clause.only("quantity", "name", "part", *SILENT) or len(clause.names) > 2:
        return
    of = next((name for _, name in clause.names), "")
    is_zero = value in ("0", "zero") or value.startswith("0 ")
    for quantity in clause.all("quantity")[-1:]:
        if quantity == "angle":
            found = angles_of(names, of)
            is_joint = of in names.connections and not found  # the cam angle
            led = (
                [] if of and not is_joint else [angle for angle in found if angle in driving.driven(names)]
            )  # that of the motor
            way = next((part for part in clause.all("part") if part in ("horizontal", "vertical")), "")
            yield [f"{angle} = {value}" for angle in poses.counting_from(names, led or found, way)]
        elif quantity == "height":
            yield lookup.lifted(names, of, value)
            yield [f"height of {of} = {value}"] if of else []
        elif quantity == "stroke":
            yield lookup.climbed(names, of, value, 1)
        elif quantity in ("displacement", "distance travelled"):
            yield [f"{way} = {value}" for way in lookup.ways(names, of)]
        elif quantity == "deflection":
            yield [f"{measure} = {value}" for measure in lookup.deflections(names, of) if _grows(names, measure)]
        elif quantity == "distance" and len(clause.names) == 2:  # between both, or counted from one of them
            who, other = (name for _, name in clause.names)
            yield along_lines.counted_from(names, who, other, value) or along_lines.counted_from(
                names, other, who, value
            )
            yield [f"distance from {who} to {other} = {value}"] if {who, other} <= names.bodies.keys() else []
        elif quantity in ("position", "distance"):
            yield [f"{place} = {value}" for place in lookup.places(names, of)]
        elif quantity in ("velocity", "speed", "angular velocity") and is_zero:
            measures = lookup.angles(names, of) if quantity.startswith("angular") else lookup.places(names, of)
            yield [f"rate({measure}) = 0" for measure in measures or lookup.angles(names, of)]
        elif quantity in ("velocity", "speed", "angular velocity") and (of in names.measures or not of):
            is_turning = quantity.startswith("angular") or dimensions.is_turning_speed(value, names)
            kinds = lookup.angles if is_turning else lookup.places
            yield going_at(names, of, value, [of] if of else kinds(names, ""))
            alone = lookup.moving(names)  # of the only body, where no measure is of its place
            is_plain = not of and not is_turning and len(alone) == 1 and not names.bodies[alone[0]].turns
            yield [f"speed of {alone[0]} = {value}"] if is_plain and not kinds(names, "") else []
        elif quantity == "tension" and is_zero:
            yield [f"{joint} goes slack" for joint in joining.joints(names, of, "", "tension")]
        elif quantity in ("normal force", "contact force") and is_zero:
            yield [f"{joint} opens" for joint in joining.joints(names, of, "", "normal force")]
        else:  # what has no shorter name
            for group in quantities(names, clause):
                yield [f"{text} = {value}" for text in group]


def _grows(names: Names, measure: str) -> bool:
    """Whether a measure starts at zero, and no rate lets it fall at first."""
    rate = names.numeric(names.start_rates.get(measure, ZERO))
    return measure in names.started_at_zero and rate is not None and rate >= 0.0


# -- what happens -----------------------------------------------------------------------------
def _happening(names: Names, clause: Clause, verbs: list[str]) -> Groups:
    """The ball hits the floor; rolling begins; the rope goes slack; it turns back."""
    if not clause.only("name", "verb", "degree", *SILENT) or set(clause.all("degree")) - {"first"}:
        return
    doing = frozenset(verbs) - ({"move", "reach"} if len(set(verbs)) > 1 else set())
    doing = frozenset(doing & {"top", "bottom"}) or doing  # it swings through the lowest point
    lines = {*names.bodies[GROUND].lines, *names.bodies[GROUND].planes}
    if not doing and len(clause.names) == 1 and clause.names[0][1] in lines and joining.strikes(names):
        yield [f"it hits {clause.names[0][1]}"]  # the time of fall to the floor
        return
    told = _TOLD.get(doing)
    if told is not None and len(clause.names) <= 2:
        yield from told(names, *_who(names, clause))


def _who(names: Names, clause: Clause) -> tuple[str, str]:
    """Who does something, and to whom: a body before what stands behind `on`, `from`, or is no body."""
    who, other = "", ""
    if clause.has("pronoun", "it") and len(clause.names) == 1:
        [(_, name)] = clause.names
        return (name, "") if lookup.is_all_that_moves(names, name) else ("", name)
    for before, name in clause.names:
        if before == "by" and name in names.connections:
            continue  # what stops it
        owner = name.partition(".")[0]
        is_body = name in names.connections or (owner in names.bodies and not names.bodies[owner].fixed)
        if not who and (is_body or name in names.measures) and before in ("", "of", "by", "between", "and"):
            who = name
        elif not other:
            other = name
        else:
            who = who or name
    return who, other


def _hits(names: Names, who: str, other: str) -> Groups:
    """What can strike nothing lands where it is as low as at the start, or as zero of its height if it starts above."""
    if caught := _caught(names, other):
        yield caught
        return
    if other in names.loads:
        yield [f"{other} is reached"] if other in lookup.catching(names, pulls=False) else []
        return
    if passing := along_lines.side_by_side(names, who, other) or along_lines.down_to(names, who, other):
        yield passing
        return
    if (drawn := _drawn_to(names, who, other)) and not any(
        set(joining.joints(names, body, other, "normal force")) - {*leads_to(names, body, other)} for body in drawn
    ):
        yield [f"{body} reaches {other}" for body in drawn]
        return
    if not joining.comes_to_strike(names) and other in ("", GROUND):
        yield [f"{height} = 0" for height in (lookup.rising(names, who) or lookup.falling(names, who))]
        thrown = [way for way, up in lookup.inclined(names, who) if lookup.rises(names, way, up)]  # up a slope
        yield [f"{way} = 0" for way in thrown if way in names.started_at_zero]
        yield poses.named_by_file(names, who, -1) if other else poses.lowermost(names, who)  # it has come down
        return
    meets = [name for name in names.connections if {"contact", "stop", "cam"} & {*names.called.get(name, ())}]
    comes = joining.comes_to_strike(names)
    is_free = bool(who) and not any(joining.touches(names, name, who) for name in meets)
    if other == GROUND and (is_free or not comes):  # no ground that the model has: where the way down ends
        yield poses.named_by_file(names, who, -1)
        return
    if "." in other and (there := [name for name in meets if other in joining.ends_of(names, name)]):  # an edge
        yield [f"{name} touches" for name in there]
        return
    strikes = comes or not joining.strikes(names)
    if strikes and (other or not who or any(joining.touches(names, name, who) for name in meets)):
        yield [f"{who or 'it'} hits {other}".strip()]


def _caught(names: Names, other: str) -> list[str]:
    """The events that what closes in mid-motion catches: of all that closes, or of what does so at a place."""
    closing = sorted(names.closing_later)
    return [f"{name} closes" for name in closing if other in ("", name, *joining.ends_of(names, name))]


def _bounces(names: Names, who: str, other: str) -> Groups:
    """It is thrown back by what only pushes, where that lets it go; of what strikes it is said after the impact."""
    if not joining.strikes(names):
        yield [f"{load} is relaxed" for load in lookup.catching(names, pulls=False) if other in ("", load)]


def _runs_off(names: Names, who: str, other: str) -> Groups:
    """A rope has left its drum; a string without mass, which has no end here, where the file's own questions say so."""
    yield strings.run_off(names, who) or strings.run_off(names, other) or poses.named_by_file(names, "", -1)


def _leaves(names: Names, who: str, other: str) -> Groups:
    if other in names.loads:  # nothing is said of where a spring no longer pushes, unless it only pushes
        yield [f"{other} is relaxed"] if other in lookup.catching(names, pulls=False) else []
        return
    if off := strings.run_off(names, who) or along_lines.at_point(names, who, other):
        yield off
        return
    free = {row.connection for row in names.constraint_rows if row.unilateral or row.reaction == "tension"}
    body, _, point = who.partition(".")
    at_end = [
        joint for joint in joining.joints(names, body, other, "normal force") if who in joining.ends_of(names, joint)
    ]
    if point and len(at_end) == 1 and at_end[0] in free:  # the upper end that leaves the wall
        yield [f"{at_end[0]} opens"]
        return
    if any(name in names.connections and name not in free for name in (who, other)):
        return  # it holds on both sides
    if (who or other) and free:
        yield [f"{who or 'it'} leaves {other}".strip()]
        yield [f"{who or other} opens"]
    elif any(row.unilateral for row in names.constraint_rows):
        yield ["contact is lost"]


def _rolls(names: Names, who: str, other: str) -> Groups:
    if not joining.can_turn(names, who):
        yield strings.run_off(names, who)  # what rolls off is wound on something
        return
    yield [f"{who} begins to roll" if who else "rolling begins"] if _is_rough_to(names, who, other) else []


def _slips(names: Names, who: str, other: str) -> Groups:
    yield [f"{who} begins to slip" if who else "slipping begins"] if _is_rough_to(names, who, other) else []


def _ends_slipping(names: Names, who: str, other: str) -> Groups:
    yield [f"slipping of {who} ends" if who else "slipping ends"] if _is_rough_to(names, who, other) else []


def _is_rough_to(names: Names, who: str, other: str) -> bool:
    """Whether what a body slips on is the only thing that it can slip on, where that is named."""
    if not other:
        return True
    rough = {row.connection for row in names.constraint_rows if row.reaction.startswith("friction force")}
    own = [joint for joint in rough if not who or joining.touches(names, joint, who)]
    return len(own) == 1 and joining.touches(names, own[0], other)


def _stops(names: Names, who: str, other: str) -> Groups:
    if who in names.measures:
        yield [f"rate({who}) = 0"] if not other else []
        return
    if not other and losing.damped(names) and lookup.springs(names):
        return  # where it turns back, or where it comes to rest for good
    if (
        not other and not rubbing.can_stick(names, who) and who not in names.connections
    ):  # where it turns back, or comes near to
        yield poses.turning(names, who)
        return
    yield [f"{who or 'it'} stops"] if not other else []


def _rests(names: Names, who: str, other: str) -> Groups:
    """It is at rest again; what starts at rest is in equilibrium elsewhere, or nowhere."""
    yield from _stops(names, who, other) if rubbing.can_stick(names, who) or not lookup.rests(names) else ()


def _locks(names: Names, who: str, other: str) -> Groups:
    """A wheel no longer turns, whatever becomes of what it carries; a clutch no longer slips."""
    if not other and who in losing.clutches(names):
        yield losing.engaged(names)
        return
    turned = lookup.angles(names, who) if who and not other else []
    yield [f"rate({angle}) = 0" for angle in turned]


def _turns_back(names: Names, who: str, other: str) -> Groups:
    if not other:
        yield [f"rate({name}) = 0" for name in lookup.places(names, who) or lookup.angles(names, who)]


def _returns(names: Names, who: str, other: str) -> Groups:
    if not other:
        rising = {name for name, _ in lookup.heights(names, who)}  # what is thrown comes back to its height alone
        aside = (
            {*lookup.places(names, who)} - rising if lookup.is_free(names, who) and who not in names.measures else ()
        )
        yield [f"{way} = 0" for way in lookup.ways(names, who) if way not in aside]
        yield [f"{place} = {to_python(start)}" for place, start in lookup.begun(names, who) if place not in aside]


def _reaches(names: Names, who: str, other: str) -> Groups:
    """A place that is reached is struck, where it can be, and not only led to."""
    if at := along_lines.at_point(names, who, other):
        yield at
    elif drawn := _drawn_to(names, who, other):
        yield [f"{body} reaches {other}" for body in drawn]
    elif other in lookup.catching(names, pulls=False):
        yield [f"{other} is reached"]
    elif other and (caught := _caught(names, other)):
        yield caught
    elif other and not any(other in own for own in (names.parameters, names.measures, names.loads)):
        is_held = other in names.connections and other not in names.closing_later
        yield [] if is_held and not joining.may_open(names, other) else [f"{who or 'it'} hits {other}"]


def _drawn_to(names: Names, who: str, other: str) -> list[str]:
    """The bodies that a rope draws to a place, all of them where none is named."""
    return [body for body in ([who] if who else names.bodies) if other and leads_to(names, body, other)]


def _at_top(names: Names, who: str, other: str) -> Groups:
    yield poses.tops(names, who)


def _at_bottom(names: Names, who: str, other: str) -> Groups:
    yield poses.lowermost(names, "" if who in names.connections and who not in names.bodies else who)


def _passes_zero(names: Names, who: str, other: str) -> Groups:
    yield [f"{name} = 0" for name in lookup.places(names, who) or lookup.angles(names, who)] if not other else []


def _hangs(names: Names, who: str, other: str) -> Groups:
    """One thing hangs straight down; that several do is more than one condition."""
    alone = len(lookup.massive(names)) == 1
    yield poses.lowermost(names, who if who in names.bodies else "") if alone or who in names.bodies else []


def _hangs_by_half(names: Names, who: str, other: str) -> Groups:
    """Half of a chain hangs over the edge."""
    yield strings.hung_down(names, who, "{}/2") if not other else []


def _slackens(names: Names, who: str, other: str) -> Groups:
    who, other = (other, "") if other in names.loads and not who else (who, other)
    yield [f"{who or 'it'} goes slack"] if not other else []
    if who in lookup.springs(names) and not other:
        yield [f"force in {who} = 0"]


def _tightens(names: Names, who: str, other: str) -> Groups:
    who, other = (other, "") if other in names.loads and not who else (who, other)
    yield [f"{who or 'it'} goes taut"] if not other else []


def _engages(names: Names, who: str, other: str) -> Groups:
    """What a clutch joins turns alike where it no longer slips; two that move alike have the same velocity."""
    bodies = lookup.moving(names)
    joined = losing.engaged(names) or len(bodies) != 2 or (who and not other)
    pairs = [] if joined else lookup.alike(names, bodies[0], bodies[1])
    yield losing.engaged(names) or [f"velocity of {a} = velocity of {b}" for a, b in pairs if len(pairs) == 1]


_TOLD: dict[frozenset[str], Callable[..., Groups]] = {
    frozenset(doing.split()): told
    for doing, told in (
        ("hit", _hits),
        ("leave", _leaves),
        ("run_off", _runs_off),
        ("bounce", _bounces),
        ("bounce leave", _bounces),
        ("start leave", _leaves),
        ("roll", _rolls),
        ("start roll", _rolls),
        ("begin_roll", _rolls),
        ("stop slide start roll", _rolls),
        ("stop slide roll", _rolls),
        ("end slide roll", _rolls),
        ("end slide start roll", _rolls),
        ("start slide", _slips),
        ("slide", _slips),
        ("end slide", _ends_slipping),
        ("stop slide", _ends_slipping),
        ("stop", _stops),
        ("hold", _rests),
        ("lock", _locks),
        ("turn_back", _turns_back),
        ("return", _returns),
        ("return move", _returns),
        ("hit return", _returns),
        ("reach", _reaches),
        ("hang", _hangs),
        ("halve hang", _hangs_by_half),
        ("halve run_off", _hangs_by_half),
        ("vanish", _passes_zero),
        ("top", _at_top),
        ("bottom", _at_bottom),
        ("engage", _engages),
        ("engage turn", _engages),
        ("engage move", _engages),
        ("slack", _slackens),
        ("taut", _tightens),
    )
}
