"""Whether all that a question names stands in what is understood: a body, a contact, a parameter, a value.

What is named stands there by its name, or by what it alone can mean: the force on the ball is that of the contact which
the ball has, the velocity of x is that of the body whose way it is. A name that is not there has been dropped, and then
another quantity is understood than was asked for: that the top block does not slide on the bottom one is no rest of
both of them.
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Sequence
from itertools import pairwise
from typing import TYPE_CHECKING

from freebody.language.expression import free_symbols
from freebody.language.units import LENGTH
from freebody.measures.displacement import Displacement
from freebody.measures.geometry import GROUND, ZERO
from freebody.questions.spoken import along_lines, driving, given, joining, lookup, rubbing
from freebody.questions.spoken.accounting import TURNED_ROUND, is_accounted_for
from freebody.questions.spoken.expressed import dropped
from freebody.questions.spoken.frames import OSCILLATION
from freebody.questions.spoken.lexicon import ENGLISH, Word, contexts, languages, tells_apart
from freebody.questions.spoken.unneeded import is_unneeded

if TYPE_CHECKING:
    from freebody.model.names import Names

_THING = re.compile(r"(?<![\w.])[^\W\d]\w*(?:\.[^\W\d]\w*)?")
_OF_ALL = re.compile(
    r"\b(?:it stays at rest|keeps it at rest|does it hold|it does not slip|nothing slips|it does not tip|"
    r"does it tip or slide)\b"
)
_SLIPS = re.compile(r"\b(?:slips?|slipping|rolls?|rolling)\b")
_RESTS = re.compile(r"\b(?:it stays at rest|keeps it at rest|does it hold)\b")
_OF_THING = ("quantity", "name", "preposition")  # kinds of words behind a thing that say of what it is
_STATES = ("move", "slide", "slip", "rest", "stay", "hold", "tip", "stand", "stick", "start")  # of the whole, too
_OF_ONE = re.compile(r"^(?:velocity|speed|acceleration) of (?P<body>\w+)(?= |$)(?!.* relative )")
_ENERGIES = re.compile(r"\b(?:energies|energien)\b.*\b(?:both|two|each|beide[nr]?|zwei|jede[rs]?)\b", re.IGNORECASE)
_IN_ALL = re.compile(r"(?:kinetic|potential|total) energy(?! of\b)")
_OF_BOTH = re.compile(  # but not what both have in common
    r"(?<!common )\b(?:velocit(?:y|ies)|speeds?|accelerations?|geschwindigkeit(?:en)?|beschleunigung(?:en)?)"
    r" (?:(?:of|for) (?:the )?(?:both|two) |(?:der|von) (?:beiden|zwei) )",
    re.IGNORECASE,
)
_APART = re.compile(
    r"\b(?:distance|separation|gap) between (?:them|each other)\b|"
    r"\b(?:abstand|entfernung) (?:zwischen ihnen|voneinander|zueinander)\b",
    re.IGNORECASE,
)
_SLIDES_OFF = re.compile(r"\b(?:slide|slip)s? off\b", re.IGNORECASE)
_ALL_STOP = re.compile(r"\b(?:they|both)(?: have| all)?(?: both| all)? (?:stop|come to rest)", re.IGNORECASE)
_WAY_OF_ONE = re.compile(r"(?:change of |greatest |least )?(?P<way>\w+)(?= |$)")
_OF_TWO = re.compile(r"\b(?:(?:of|von|der) (?:the |den )?(?:both|two|beiden?|zwei)|beider) [^\W\d]", re.IGNORECASE)
_SUMMED = re.compile(
    r"(?:(?:kinetic|potential|total) energy|(?:linear|angular) momentum)(?: of (?P<of>\w+))?"
    r"(?= (?:when|at|after|before|until|along|about)\b|$)"
)
_OF_JOINT = re.compile(r"\b(?:in|at|of|on) (?:the )?([^\W\d]\w{2,})\b(?!\.)")
_PLACE_WHEN = re.compile(r"[^\W\d]\w* when ")
_GIVEN_TURNED = re.compile(
    r"(?:value|range) of (?P<parameter>\w+) for which \|?(?:force|torque) (?:in|of) (?P<load>\w+)\|? "
    r"(?:is (?:least|largest)|=)"
)
_BY_ITSELF = re.compile(r"change of (\w+) until \1 has (?:changed|moved) ")
_OF_TENSION = re.compile(r"\b(?:tension|axial force) of [\w.]+(?: at [\w.]+)? [<>]?=? ?\d")
_CALLED_JOINT = re.compile(  # the bearing A
    r"\b(?:bearing|hinge|pin|joint|support|axle|pivot|Lager|Auflager|Gelenk|Bolzen|Achse) ([^\W\d]\w*)\b(?!\.)"
)
_BEYOND = re.compile(  # how long it is above 20 m, and not when it rises above that
    r"^(?:how long (?:is|was|are)|(?:the )?time (?:spent )?|wie lange (?:ist|war)|(?:die )?zeit )"
    r"(?:(?!\b(?:until|till|when|bis|after|to)\b).)*?"
    r"\b(?:above|below|beneath|oberhalb|unterhalb|über|unter) (?:von )?\d",
    re.IGNORECASE,
)
_ABOVE = re.compile(
    r"\b(?:above|below|beneath|oberhalb|unterhalb) (?:von )?\d[\d.,]* ?(?:mm|cm|m|km)\b|"
    r"\b\d[\d.,]* ?(?:mm|cm|m|km) (?:above|below|beneath|higher|lower|oberhalb|unterhalb|höher|tiefer)\b",
    re.IGNORECASE,
)
_PLACED = re.compile(r"\b(?P<measure>\w+) = ")
_ENDS = (Word("degree", "least"), Word("degree", "greatest"))
_HEAVY = (Word("quantity", "weight"), Word("quantity", "mass"))
_MAY = Word("filler", "may")
_OVER, _ROLLS = Word("preposition", "over"), re.compile(r"\brolls without slipping\b")
_MUST, _SPEED_THERE = Word("filler", "must"), re.compile(r"[|]?(?:angular )?(?:velocity|speed) of \S+ when ")
_ON = Word("preposition", "on")
_STEADY = re.compile(r"(?:force in|torque of) (\w+) in steady motion")
_OF_ITSELF = re.compile(r"^ratio of (?P<one>.+?) to (?P=one)(?: at \w+)?(?: (?:when|at start|after) .*)?$")
_OF_GROUND = re.compile(r"(?:angle|(?:angular )?(?:velocity|acceleration)|speed) of ground(?= |$)")  # which rests
_FORCE, _HEIGHT = Word("quantity", "force"), Word("quantity", "height")
_TWO = 2
_NUMBER = re.compile(r"(?<![\w.])\d+(?:\.\d+)?")


def _telling(words: Sequence[Word]) -> list[Word]:
    return [word for word in words if word.kind != "filler"]


def is_kept(names: Names, words: Sequence[Word], text: str) -> bool:
    """Whether each name and each number of what was asked stands in words of the grammar, and its kind and way."""
    begins_with_blow = joining.is_struck_at_start_alone(names)
    if text.startswith(("time when ", "greatest ")) and begins_with_blow:
        words = [word for word in words if word != Word("instant", "after the impact")]
    is_steady = Word("instant", "in steady motion") in words and not text.startswith("steady amplitude of ")
    if {*_ENDS} & {*words} and is_steady:  # what is steady has no extreme
        return False
    if any(on == _ON and by.kind == "name" and by.what in names.measures for on, by in pairwise(words)):
        return False  # over a measure, or against it: a function
    if _ROLLS.search(text) and any(on == _OVER and by.kind == "name" for on, by in pairwise(_telling(words))):
        return False  # over a step, which it leaves the ground for
    if _MUST in words and _SPEED_THERE.match(text):  # how fast it must be there is not how fast it is
        return False
    if _PLACE_WHEN.match(text) and text.partition(" ")[0] in names.measures and moves_nowhere(names):
        return False  # what stands still is nowhere else when a force is least: another angle is meant
    if _OF_GROUND.match(text) or _is_no_place(names, words, text):
        return False
    if dropped(words, text) or _OF_ITSELF.match(text) or not is_accounted_for(names, words, text):
        return False
    if (found := _STEADY.fullmatch(text)) and any(
        load.load == found[1] and free_symbols(load.law) <= names.parameters.keys() for load in names.applied_loads
    ):  # what is given stays as it is: another one is asked for
        return False
    chosen = {p.name for p in names.parameters.values() if p.value is not None}  # the others balance a load
    if (turned := _GIVEN_TURNED.match(text)) and any(
        load.load == turned["load"] and free_symbols(load.law) <= chosen - {turned["parameter"]}
        for load in names.applied_loads
    ):
        return False  # nor does it change with another parameter
    if not chooses_of_what_is_asked(names, words, text):
        return False
    things = {thing for thing in _THING.findall(text) if _is_thing(names, thing)}
    if _counts_from(names, words, text, things):
        return False
    numbers = {float(number) for number in _NUMBER.findall(text)}
    told = [float(number) for word in words if word.kind == "value" for number in _NUMBER.findall(word.what)]
    is_of_all = _OF_ALL.search(text) is not None
    cut = _begin_of_state(names, words) if is_of_all else len(words)
    for k, word in enumerate(words):
        if (_is_what_turns(names, words, k) and "over a turn" in text) or is_unneeded(names, words, k):
            continue
        for thing in _THING.findall(word.what) if word.kind in ("name", "value") else ():
            if not _is_thing(names, thing) or _stands(names, thing, things):
                continue
            if text.startswith(("work of ", "power of ")) and given.load_of(names, thing) in things:
                continue  # the work of F is that of the load which pushes with it
            is_said = k < cut and any(_is_of(names, thing, other) for other in things & names.parameters.keys())
            is_of_another = is_of_all and k < cut and "." not in thing and _is_pushed_elsewhere(names, thing, text)
            if not is_said and (is_of_another or not _is_meant(names, thing, things, text)):
                return False
    return all(number in numbers for number in told)


def _is_no_place(names: Names, words: Sequence[Word], text: str) -> bool:
    """Whether a parameter is sought that tells no place, where one is asked for: where F has to act is no force."""
    chosen = TURNED_ROUND.match(text)
    said = [word for word in words if word.kind != "filler"]
    if chosen is None or chosen["parameter"] not in names.parameters:
        return False
    acts = _FORCE in said and bool({_HEIGHT, Word("name", chosen["parameter"])} & {*said[: said.index(_FORCE)]})
    acts = acts and said[said.index(_FORCE) + 1 :][:1] in ([Word("verb", "exert")], [Word("verb", "act")])
    if acts and names.parameters[chosen["parameter"]].dimension == LENGTH:
        placing = {name for load in names.loads for name in given.placing(names, load)}
        return chosen["parameter"] not in placing  # at which height a force must act is no length of anything else
    if said[:1] != [Word("ask", "where")]:
        return False
    parameter = names.parameters[chosen["parameter"]]
    return parameter.dimension != LENGTH and not parameter.is_angle


def moves_nowhere(names: Names) -> bool:
    """Whether the only body is held by as many constraints as it has freedoms, and driven by none."""
    return len(lookup.moving(names)) == 1 and n_freedoms(names) <= 0 and not driving.driven(names)


def chooses_of_what_is_asked(names: Names, words: Sequence[Word], text: str) -> bool:
    """Whether a parameter that is to be chosen is one of the thing that is asked for: which load can be held asks for
    no force."""
    chosen = TURNED_ROUND.match(text)
    said = [word for word in words if word.kind != "filler"]
    asks, thing, behind = [*said, *[Word("", "")] * 3][:3]
    is_thing = asks == Word("ask", "what") and thing.kind == "name" and behind.kind not in _OF_THING
    is_agent = behind.kind == "name" or behind == Word("quantity", "force")
    is_carried = asks == Word("ask", "what") and (thing.kind == "name" or thing in _HEAVY) and is_agent
    is_carried &= _MAY in words and "rise" in _doing(words)  # what weight the force can lift
    if is_carried:
        own = frozenset[str]().union(*(free_symbols(body.mass) for body in names.bodies.values()))
        return chosen is not None and (chosen["parameter"] in own or chosen["parameter"] == thing.what)
    if chosen is None or not is_thing or thing.what not in {*names.bodies, *names.loads}:
        return True
    parameter = chosen["parameter"]
    return parameter not in names.parameters or parameter == thing.what or _is_of(names, thing.what, parameter)


def _doing(words: Sequence[Word]) -> set[str]:
    return {word.what for word in words if word.kind == "verb"}


def loses_other(names: Names, said: str, text: str) -> bool:
    """Whether the speed of both of two bodies is asked for, and that of one of them stands in its place; or their
    energies, and that of all together does."""
    if _ENERGIES.search(said) is not None and _IN_ALL.match(text) is not None:
        return True
    if _OF_TWO.search(said) is not None and (summed := _SUMMED.match(text)) is not None:
        return summed["of"] in names.bodies if summed["of"] else len(_resisting(names)) != _TWO
    if _APART.search(said) is not None and (way := _WAY_OF_ONE.match(text)) is not None:
        return way["way"] in names.measures and len({*names.measures[way["way"]].bodies()} - {GROUND}) == 1
    if _ALL_STOP.search(said) is not None and "it stops" in text and len(lookup.moving(names)) > 1:
        return True  # when the first one does
    own = _OF_ONE.match(text)
    return own is not None and _OF_BOTH.search(said) is not None and own["body"] in names.bodies


def _resisting(names: Names) -> list[str]:
    """Bodies that have a mass, or resist turning, and are not held."""
    inert = [name for name, body in names.bodies.items() if name != GROUND and not body.fixed]
    return [
        n
        for n in inert
        if any(own != ZERO for own in (names.bodies[n].mass, names.bodies[n].inertia, *names.bodies[n].tensor))
    ]


def loses_height(names: Names, said: str, text: str) -> bool:
    """Whether another place stands for how high something is, above 20 m, or the time when it comes there for how long
    it is beyond that."""
    heights = [name for name, _ in lookup.heights(names, "")]
    aside = [one for one in _PLACED.findall(text) if one in names.measures and one not in heights]
    above = _ABOVE.search(said)
    risen = above is not None and not above[0][0].isdigit() and " has changed by " in text  # not above that, but by it
    return (
        (bool(heights and aside) and above is not None)
        or risen
        or (text.startswith("time when ") and _BEYOND.match(said) is not None)
    )


def is_pressed(said: str) -> bool:
    """Whether a text speaks of compression, in which the force of a bar has the other sign."""
    return _says("pressed", said)


def is_of_itself(text: str) -> bool:
    """Whether words ask how far a measure comes until it has come so far: what is to come so far is another one."""
    return _BY_ITSELF.match(text) is not None


def loses_sign(said: str, text: str) -> bool:
    """Whether a tension of so many newtons stands for a compressive force of as many."""
    return _OF_TENSION.search(text) is not None and is_pressed(said)


def loses_joint(names: Names, said: str, text: str) -> bool:
    """Whether a text says by its name of which connection a force is, and another one stands in its place."""
    said_of = (*_OF_JOINT.findall(said), *_CALLED_JOINT.findall(said))
    named = [found for found in said_of if found in names.connections and found not in names.bodies]
    found = [thing for thing in _THING.findall(text) if thing in names.connections]
    return (
        bool(named and found)
        and not {*named} & {*found}
        and not any({*driving.drives_of(names, joint)} & {*found} for joint in named)
        and not any(tells_apart(name.lower(), ENGLISH) for name in named)
    )


def _says(key: str, said: str) -> bool:
    told = (contexts(language).get(key) for language in languages())
    return any(one is not None and re.search(one, said, re.IGNORECASE) is not None for one in told)


def is_one_without_other(said: str) -> bool:
    """Whether something is to tip without sliding, or the other way round: one condition, and no two questions."""
    return _says("one_without_other", said)


def loses_failure(said: str, text: str) -> bool:
    """Whether it is to fail in one of two ways without the other, and that it does neither stands for it; or to slide
    off what carries it, and that it slips does."""
    falls = _SLIDES_OFF.search(said) is not None and text.startswith("whether ") and text.endswith(" slips")
    return falls or (_RESTS.search(text) is not None and is_one_without_other(said))


def loses_mass_center(said: str, text: str) -> bool:
    """Whether it is asked where the mass centre may lie, and a parameter that nobody names stands for its height."""
    turned = TURNED_ROUND.match(text)
    is_named = turned is not None and re.search(rf"\b{turned['parameter']}\b", said) is not None
    return turned is not None and not is_named and "center" not in text and _says("mass_center", said)


def _is_what_turns(names: Names, words: Sequence[Word], k: int) -> bool:
    """Whether a name only says of what a turn is: over one turn of the crank."""
    before = [word for word in words[:k] if word.kind != "filler"][-2:]
    is_owner = before == [Word("instant", "over a turn"), Word("preposition", "of")]
    return is_owner and words[k].what in lookup.turning(names)


def _counts_from(names: Names, words: Sequence[Word], text: str, things: set[str]) -> bool:
    """Whether a time is asked for that counts from something else than the start: from the catch until it hangs."""
    said = [word for word in words if word.kind != "filler"]
    begins = (  # but 8 m from the hinge is a place
        after
        for k, (before, after) in enumerate(pairwise(said))
        if before == Word("preposition", "from") and (k == 0 or said[k - 1].kind != "value")
    )
    return text.startswith("time when ") and any(
        after.kind == "verb" or (after.kind == "name" and after.what in names.connections and after.what not in things)
        for after in begins
    )


def _begin_of_state(names: Names, words: Sequence[Word]) -> int:
    """Where what is to be so begins: all before it is said of the parameter that is asked for. Who does something
    stands before the verb."""
    marks = [k for k, word in enumerate(words) if word.kind in ("mark", "not")]
    doing = (k for k, word in enumerate(words) if word.kind == "verb" and word.what not in ("exert", "act"))
    cut = marks[0] if marks else min(doing, default=len(words))
    while 0 < cut < len(words) and (words[cut].kind == "not" or words[cut].what in _STATES):
        before = words[cut - 1]
        if before.kind != "filler" and (before.kind != "name" or before.what in {*names.parameters, *names.loads}):
            break
        cut -= 1
    return cut


def _is_meant(names: Names, thing: str, things: set[str], text: str) -> bool:
    """Whether words of the grammar that name nothing mean a thing: that it all rests, slips, is struck."""
    body = thing.partition(".")[0]
    if text.startswith("stability of ") or text.endswith(" is stable"):  # of a part is that of all
        return True
    if text in OSCILLATION and body in names.bodies and n_freedoms(names) == 1:  # what swings takes the rest along
        return True
    if text == "natural frequency" and body in lookup.moving(names):  # or it is told that there are several
        return True
    if _OF_ALL.search(text) and thing in names.loads and thing not in names.parameters and _acted_at(names, thing):
        return all(lookup.is_all_that_moves(names, own) for own in _bodies(names, thing) - {GROUND})  # the man on it
    if _OF_ALL.search(text):
        is_one = "slip" not in text and n_freedoms(names) == 1
        return "." not in thing and (rubbing.is_all_that_slips(names, body) or is_one)
    if _SLIPS.search(text):  # the block slips on the belt, which is all that it touches
        rough = [joint for other in things for joint in rubbing.rough(names, other)]
        return bool(rough) and all(joining.touches(names, joint, thing) for joint in rough)
    parameters = things & names.parameters.keys()
    if parameters and TURNED_ROUND.search(text):
        return any(_is_of(names, thing, other) for other in parameters)
    struck = {struck for joint in names.struck_at_start for struck in (joint, *_bodies(names, joint))}
    if "in the impact" in text and not joining.strikes(names):  # what closes on the way is all that can be struck
        struck |= {struck for joint in names.closing_later for struck in (joint, *_bodies(names, joint))}
    return any(told in text for told in ("at start", "in the blow", "in the impact")) and body in struck


def _is_thing(names: Names, thing: str) -> bool:
    return thing in names.parameters or lookup.is_known(names, thing)


def _stands(names: Names, thing: str, things: set[str]) -> bool:
    """Whether a thing is among others, or is the only one that they can mean."""
    if thing in things:
        return True
    if thing in names.parameters and thing not in names.loads:
        return False
    if thing in names.loads and (places := {*_acted_at(names, thing)}) and places <= things:
        return True  # under the load
    if thing in names.parameters:
        return False
    if {way.partition(" = ")[0] for way in along_lines.counted_from(names, "", thing, "0")} & things:
        return True
    body = thing.partition(".")[0]
    if not things and thing in names.bodies and names.bodies[thing].fixed:
        return True  # the period in the bowl
    if body == GROUND or thing in names.bodies[GROUND].lines or thing in names.bodies[GROUND].planes:
        return _ground_stands(names, thing, things)
    if _is_point_of_moving(names, thing):  # another point of its body is not meant, nor its body
        places = {joining.pinned_at(names, thing), joining.joined_at(names, thing)}
        places |= {joint for joint in things & names.connections.keys() if thing in joining.ends_of(names, joint)}
        return bool(places & things) or any(along_lines.is_along(names, other, body) for other in things)
    if any(other.partition(".")[0] == body for other in things):
        return True
    if thing in names.bodies:
        is_alone = lookup.is_all_that_moves(names, body) and not things & {*lookup.moving(names)}
        return is_alone or any(body in _bodies(names, other) for other in things)
    if {joining.pinned_at(names, thing), joining.joined_at(names, thing)} & things:
        return True
    if thing in names.connections and any(_are_alike(names, thing, other) for other in things):
        return False  # the forces on the bearings A and B
    own = _bodies(names, thing) - {GROUND}
    return any(own & (_bodies(names, other) - {GROUND}) for other in things)


def _acted_at(names: Names, load: str) -> list[str]:
    """The points at which a force acts."""
    acting = (push.measure for push in names.applied_loads if push.load == load)
    return [measure.of.name for measure in acting if isinstance(measure, Displacement) and "." in measure.of.name]


def _is_point_of_moving(names: Names, thing: str) -> bool:
    body, _, point = thing.partition(".")
    return (
        body in lookup.moving(names) and point in names.bodies[body].points and point not in ("mass_center", "right")
    )  # right at the start


def _are_alike(names: Names, one: str, other: str) -> bool:
    """Whether two connections exert the same kinds of forces."""
    kinds = [{row.reaction for row in names.constraint_rows if row.connection == name} for name in (one, other)]
    return one != other and bool(kinds[0] & kinds[1])


def _ground_stands(names: Names, thing: str, things: set[str]) -> bool:
    """Whether a thing of the ground is what a contact touches, or the only one of its kind."""
    held = {joint for joint in names.connections if thing in joining.ends_of(names, joint)}
    if held and "." in thing and not held & things and things & names.connections.keys():
        return False  # a force at a bearing is none between the teeth
    if any(other in names.connections and joining.touches(names, other, thing) for other in things):
        return True
    held = {joint for joint in names.connections if thing in joining.ends_of(names, joint)}
    if held and "." in thing and not held & things and things & names.connections.keys():
        return False  # a force at a bearing is none between the teeth
    return len(names.bodies[GROUND].lines) + len(names.bodies[GROUND].planes) <= 1


def may_change(names: Names) -> bool:
    """Whether a force may be another one at another time: something can move."""
    return n_freedoms(names) > 0 and not rubbing.is_still(names)


def n_freedoms(names: Names) -> int:
    """The degrees of freedom, where no constraint follows from others: what touches a side with several points of its
    own can neither leave it nor turn."""
    free = (3, 6) if names.space else (2, 3)
    held = [row for row in names.constraint_rows if not row.reaction.startswith("friction")]
    touching = Counter(joint for joint, _ in {(row.connection, row.ends[:1]) for row in held if row.unilateral})
    n_held = sum(not row.unilateral for row in held) + sum(min(n, 2) for n in touching.values())
    return sum(free[names.bodies[body].turns] for body in lookup.moving(names)) - n_held


def _is_of(names: Names, thing: str, parameter: str) -> bool:
    """Whether a parameter is one of a thing: its mass, a size, how fast it starts, how hard it is pushed."""
    body = thing.partition(".")[0]
    if parameter in given.started_with(names, [body]) or parameter in given.leaning_by(names, thing):
        return True
    if body in names.bodies:
        own = names.bodies[body]
        sizes = [own.mass, own.inertia, *own.sizes, *(c for point in own.points.values() for c in point)]
        if any(parameter in free_symbols(size) for size in sizes):
            return True
    for load in names.applied_loads:
        if thing == load.load or body in _bodies(names, load.load):
            places = [c for on in load.measure.bodies() for at in names.bodies[on].points.values() for c in at]
            if any(parameter in free_symbols(x) for x in (load.law, *(places if thing == load.load else ()))):
                return True
    if parameter in driving.drive_parameters(names) and body in driving.driven_bodies(names, parameter):
        return True
    joints = [name for name in names.connections if name == thing or joining.touches(names, name, thing)]
    return any(
        parameter in _THING.findall(str(value))
        for joint in joints
        for value in joining.given_of(names.connections[joint]).values()
    )


def _is_pushed_elsewhere(names: Names, thing: str, text: str) -> bool:
    """Whether the force or torque that is asked for acts on other bodies than on the one that it is said to act on."""
    pushing = [load for load in names.applied_loads if free_symbols(load.law) & {*_THING.findall(text)}]
    return thing in names.bodies and bool(pushing) and all(thing not in _bodies(names, load.load) for load in pushing)


def _bodies(names: Names, thing: str) -> set[str]:
    """The bodies that a thing is of, or between."""
    body = thing.partition(".")[0]
    found = {body} if body in names.bodies else set[str]()
    if body in names.connections:
        found |= names.connections[body].mentions(names)
        found |= {own for row in names.constraint_rows if row.connection == body for own in row.measure.bodies()}
    if thing in names.measures:
        found |= {*names.measures[thing].bodies()}
    for load in names.applied_loads:
        if load.load == thing:
            found |= {*load.measure.bodies()}
    return found
