"""How fast one thing moves for a given speed of another: the planet, if the arm turns with 2 rad/s.

Where the constraints leave one freedom, velocities are in a ratio that the pose alone fixes: v_1 = v_2 (v_1/v_2). What
is said of the other body is then no event of the motion, which need never come, but the speed that is put in.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from freebody.measures.geometry import GROUND
from freebody.questions.spoken import dimensions, joining, lookup, of_axles, within
from freebody.questions.spoken.asking import quantities
from freebody.questions.spoken.composing import JOINT, SILENT, Groups
from freebody.questions.spoken.keeping import n_freedoms
from freebody.questions.spoken.lexicon import Word
from freebody.questions.spoken.sentence import Sentence
from freebody.questions.spoken.words import Clause

if TYPE_CHECKING:
    from freebody.model.names import Names

_RUNS = {"turn", "move", "roll", "slide", "rise", "fall"}  # verbs of what has a speed
_FROM_TO = (("from", "on"), ("of", "on"), ("of", "from"))  # prepositions; the last is of German: von der, zum
_SPEEDS = ("angular velocity", "velocity", "speed")
_MAY_STAND = ("name", "value", "verb", "quantity", "part", *SILENT)


def geared(names: Names, sentence: Sentence) -> Groups:
    """A velocity for a given one of another thing, as the ratio of both times what is given."""
    parted = _parted(sentence)
    if parted is None:
        return
    main, given = parted
    driver = _driving(names, given)
    at = within.equation_at_end(main) if main.has("relation") else None
    main, when = (main, "") if at is None else (at[0], f" when {at[1]}")  # for theta = 90 deg
    if driver is None or main.has("value") or main.has("instant") or main.has("degree"):
        return
    if any(name in names.connections for _, name in main.names) or _n_freedoms(names) > 1:
        return
    thing, value, speed = driver
    if any(name == thing for _, name in main.names):
        return
    for group in quantities(names, _turning(names, main)):
        plain = [text for text in group if JOINT not in text and text.startswith(tuple(f"{v} of " for v in _SPEEDS))]
        yield [
            f"{value} * ratio of {text} to {speed}{when}"
            for text in dict.fromkeys(_signed(names, text) for text in plain)
        ]


def _signed(names: Names, text: str) -> str:
    """The speed of a body as a velocity that has a sign, and a value at rest: along its way, or its guide."""
    quantity, _, body = text.partition(" of ")
    if body not in names.bodies or quantity not in ("speed", "velocity"):
        return text
    ways, guides = lookup.places(names, body), joining.guides(names, body)
    if len(ways) == 1:
        return f"velocity of {ways[0]}"
    return f"velocity of {body} along {guides[0]}" if len(guides) == 1 else f"speed of {body}"


def _parted(sentence: Sentence) -> tuple[Clause, Clause] | None:
    """What is asked, and what runs with which speed: behind a mark, or as in `for 10 rad/s of the crank`."""
    if sentence.others:
        alone = len(sentence.others) == 1 and sentence.others[0][0] == "when"
        return (sentence.main, sentence.others[0][1]) if alone else None
    words = sentence.main.words
    for k, word in enumerate(words):
        head, tail = Clause(words[:k]), Clause(words[k + 1 :])
        leads = (
            word in (Word("preposition", "of"), Word("preposition", "in")) and head.has("name") and tail.has("value")
        )
        if leads and len(tail.names) == 1 and tail.only("name", "value", "quantity", *SILENT):
            is_said = tail.has("quantity")
            return head, tail if is_said else Clause([Word("quantity", "speed"), *tail.words])
    return None


def per_turn(names: Names, sentence: Sentence) -> Groups:
    """How far something comes for each turn of something else: 2 pi v/omega."""
    main = sentence.main
    is_counted = main.has("ask", "many") or main.has("quantity", "turns")
    is_asked = is_counted or main.has("ask", "far", "much", "high")
    if sentence.others or main.all("instant") != ["over a turn"] or not is_asked:
        return
    main = main.without("quantity", "turns")
    cut = main.words.index(Word("instant", "over a turn"))
    who, of = (Clause(words).names for words in (main.words[:cut], main.words[cut:]))
    runs = _RUNS if is_counted else _RUNS - {"turn"}
    known = main.only("ask", "verb", "name", "instant", *SILENT) and set(main.all("verb")) <= runs
    if len(who) != 1 or len(of) != 1 or not known or _n_freedoms(names) > 1:
        return
    [(_, thing)], turned = who, lookup.acted_on(names, of[0][1])
    if turned not in lookup.turning(names) or not _is_even(names, thing, turned):
        return
    if is_counted:
        both = thing in lookup.turning(names)
        yield [f"ratio of angular velocity of {thing} to angular velocity of {turned}"] if both else []
        return
    ways = lookup.places(names, thing)
    speeds = [f"velocity of {way}" for way in ways] or [f"speed of {thing}"]
    yield [f"2*pi * ratio of {speed} to angular velocity of {turned}" for speed in speeds]


def _is_even(names: Names, thing: str, turned: str) -> bool:
    """Whether a thing goes as far for each part of a turn: not by a crank, a cam, or a rope aslant to its guide."""
    joints = {name for name in names.connections if joining.touches(names, name, turned)}
    pins = [names.connections[name].mentions(names) - {GROUND, turned} for name in joints & {*of_axles.axles(names)}]
    is_crank = of_axles.axle_of(names, turned) == "beside" or any(own - {*of_axles.planets(names)} for own in pins)
    strings = {row.connection for row in names.constraint_rows if row.reaction == "tension"}
    is_aslant = bool(joining.guides(names, thing)) and any(joining.touches(names, name, thing) for name in strings)
    lifts = any({"cam", "groove"} & {*names.called.get(name, ())} for name in joints)
    return not (is_crank or lifts or is_aslant)


def _driving(names: Names, given: Clause) -> tuple[str, str, str] | None:
    """What runs with a given speed, this, and its velocity in words of the grammar."""
    of, values = [name for _, name in given.names], [value for _, value in given.values]
    if len(of) != 1 or len(values) != 1 or not given.only(*_MAY_STAND) or given.all("part"):
        return None
    if not set(given.all("verb")) <= {*_RUNS, "turn_fully"} or not set(given.all("quantity")) <= {*_SPEEDS}:
        return None
    if not given.has("verb") and not given.has("quantity"):
        return None
    [thing], [value] = of, values
    acted = {body for p in names.applied_loads if p.load == thing for body in p.measure.bodies()}
    driven = acted & {*lookup.turning(names)}
    thing = next(iter(driven)) if len(driven) == 1 else thing  # the motor: what it drives
    if dimensions.is_turning_speed(value, names) and thing in lookup.turning(names):
        return thing, value, f"angular velocity of {thing}"
    if dimensions.is_turning_speed(value, names) and thing in lookup.angles(names, ""):
        return thing, value, f"velocity of {thing}"
    if (
        dimensions.is_speed(value, names)
        and thing in lookup.moving(names)
        and of_axles.axle_of(names, thing) != "center"
    ):
        return thing, value, f"speed of {thing}"
    if dimensions.is_speed(value, names) and thing in lookup.places(names, ""):
        return thing, value, f"velocity of {thing}"
    return None


def _turning(names: Names, main: Clause) -> Clause:
    """With what speed does the carrier run, what is its rpm: what turns about an axle has that of turning."""
    of = [name for _, name in main.names]
    plain = [verb for verb in main.all("verb") if verb != "move"]
    is_turned = len(of) == 1 and of_axles.axle_of(names, of[0]) == "center" and not plain
    if is_turned and main.has("ask", "fast") and not main.has("quantity"):
        return Clause([*main.words, Word("verb", "turn")])
    return main


def _n_freedoms(names: Names) -> int:
    """The degrees of freedom where what rolls does not slip."""
    rolling = [row for row in names.constraint_rows if "rolling" in names.called.get(row.connection, ())]
    held = [row for row in rolling if row.reaction == "friction force"]
    return n_freedoms(names) - len(held)


def efficiency_of_planets(names: Names, words: list[Word]) -> Groups:
    """The efficiency of a planetary train from one of three members to another, while the third is held."""
    clause = Clause(words)
    members = [(before, name) for before, name in clause.names if name in names.bodies]
    basic = [value for _, value in clause.values]
    basic += [name for _, name in clause.names if name in names.parameters]
    is_asked = sorted(clause.all("quantity")) == ["basic efficiency", "efficiency"] and bool(of_axles.planets(names))
    is_told = len(members) == 3 and len(basic) == 1 and set(clause.all("verb")) == {"hold"}
    known = clause.only("quantity", "verb", "name", "value", "mark", "relation", "ask", *SILENT)
    if not (is_asked and is_told and known and len(clause.names) + len(clause.values) == 4):
        return
    for k in (0, 1):
        (one, driving), (two, driven) = members[k : k + 2]
        if (one, two) in _FROM_TO:
            [held] = [name for _, name in members if name not in (driving, driven)]
            yield [f"efficiency from {driving} to {driven} with {held} held and basic efficiency {basic[0]}"]
