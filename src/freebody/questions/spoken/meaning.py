"""Whole questions: a main clause and what is said of when, until when, for which values it is meant.

Gives groups of texts in the words of the grammar, the likeliest first.
"""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

from freebody.measures.geometry import GROUND, ZERO
from freebody.questions.spoken import (
    beginning,
    given,
    joining,
    lookup,
    of_sections,
    poses,
    rewording,
    speeds,
    transmitting,
    turning_round,
)
from freebody.questions.spoken.after_impacts import gone_on
from freebody.questions.spoken.asking import quantities
from freebody.questions.spoken.at_two_instants import compared
from freebody.questions.spoken.averages import averages
from freebody.questions.spoken.between_events import time_between
from freebody.questions.spoken.composing import SILENT, Groups
from freebody.questions.spoken.counting import counted, lost, stopping, time
from freebody.questions.spoken.decaying import decaying
from freebody.questions.spoken.events import GOES_ON
from freebody.questions.spoken.frames import FORCES, MOTION
from freebody.questions.spoken.geared import efficiency_of_planets, geared, per_turn
from freebody.questions.spoken.instants import is_throughout, timed
from freebody.questions.spoken.lexicon import Word
from freebody.questions.spoken.limits import limits
from freebody.questions.spoken.of_motion import MASS_CENTER
from freebody.questions.spoken.recomposing import recomposed
from freebody.questions.spoken.sentence import Sentence, parted, told_who
from freebody.questions.spoken.so_that import stands
from freebody.questions.spoken.stated import stated
from freebody.questions.spoken.unneeded import without_unneeded
from freebody.questions.spoken.whether import whether
from freebody.questions.spoken.words import Clause

if TYPE_CHECKING:
    from freebody.model.names import Names

_MARKS = ("when", "until", "after", "while")
_HOLDS = ({"friction force"}, {"friction coefficient"}, {"force"}, {"tension"})  # what may be enough to hold something
_HOW_FAR = tuple(Word("ask", what) for what in ("large", "small", "heavy", "far", "high", "steep", "flat"))
_LEADS_ON = ("from", "about", "relative", "between", "along")  # prepositions behind which something stands
_NOT, _ACCELERATE = Word("not", "not"), Word("verb", "accelerate")
_STARTS, _AT_START, _FROM_REST = Word("verb", "start"), Word("instant", "at start"), Word("verb", "from_rest")
_WHILE = Word("mark", "while")
_COMMA, _IN = Word("preposition", ","), Word("preposition", "in")
_SO_THAT = Word("mark", "so_that")
_WHETHER = re.compile(
    r"(?:does|is|whether|when|time|which|range|largest|least|value|damping|stability|degrees|greatest)\b"
)
_WHETHER_WORDS = (Word("filler", "does"), Word("filler", "may"))  # does it, may it, as it begins a question
_WITHOUT = ("no_slip", "no_move", "no_accel")  # said of how something is done: without slipping
_OF_ITSELF = re.compile(r"ratio of (.+) to \1")
_FAILS = {"leave": "tip", "rise": "tip", "turn": "slide"}  # how what stands on wheels fails
_FREE_END = "free_end"  # of a body, as the spelling writes it
_ENDS_OF_LADDERS = ("foot", "head")  # where it touches what is level, and what is upright
# what only a limit tells apart: how small, how steep
_AS_LARGE = {Word("ask", what): Word("ask", "large") for what in ("small", "flat", "steep")}


def meanings(names: Names, words: list[Word]) -> Groups:
    """What words can ask for, as they stand; then with their parts put in the order of the grammar. Whether something
    is so is told by no quantity, but by which way something goes."""
    asks_whether = words[:1] == [Word("filler", "does")] and Word("preposition", "and") not in words
    for found in _in_all_orders(names, words):
        group = [text for text in found if not _OF_ITSELF.fullmatch(text)]
        yield [text for text in group if _WHETHER.match(text)] if asks_whether else group


def _in_all_orders(names: Names, words: list[Word]) -> Groups:
    yield from _as_they_stand(names, words)
    said = [word for word in words if word.kind != "filler"]
    yield from compared(names, said, _as_they_stand)
    if not any(word.kind == "other" or _leads_nowhere(said, k) or _asks_more(said, k) for k, word in enumerate(said)):
        yield from recomposed(names, said, _as_they_stand)


def _as_they_stand(names: Names, words: list[Word]) -> Groups:
    if any(word.kind == "other" for word in words):
        return
    words = rewording.rates(_at_mass_center(names, _at_free_ends(names, words)))
    if not words:
        return
    modal = {word.what for word in words if word.kind == "filler"} & {"may", "must"}
    is_whether = words[0] in _WHETHER_WORDS or _begins_with_verb(words)
    words = rewording.far_from_origin(names, _stretched(names, _from_rest(names, words)))
    said = rewording.signs_between([word for word in words if word.kind != "filler"])
    said = rewording.lasting_from_start(rewording.enough_to(rewording.how_deep(rewording.for_a_motion(said))))
    said = rewording.on_the_way_back(names, rewording.placed(said, modal))
    said = rewording.so_far_that(names, rewording.hauled(names, said, modal), modal)
    said = rewording.in_turns(rewording.runs_slack(rewording.for_a_turn(said, modal)))
    said = _without_auxiliary(speeds.lifted(names, said))
    said = beginning.told(names, rewording.kept_steady(names, rewording.bounded(said)))
    if said and said[-1].kind == "preposition" and said[-1].what in _LEADS_ON:
        return
    if any(_leads_nowhere(said, k) or _asks_more(said, k) for k in range(len(said) - 1)):
        return
    said = speeds.onto_buffer(names, without_unneeded(names, said))
    said = rewording.sliding_in_slots(names, rewording.holding_fast(names, said))
    said = rewording.for_what(names, rewording.infinitives(rewording.spinning(names, said)))
    said = rewording.by_joint(names, rewording.given_by_joint(names, rewording.taken_along(names, said)))
    said = rewording.pulling(names, rewording.balanced_at(names, rewording.held_by_clamp(names, said)))
    said = rewording.driven_by_needed(names, rewording.can_accelerate(names, said, modal))
    said = rewording.at_extremes(rewording.lifting_off(names, rewording.on_what_may_open(names, said)))
    said = rewording.at_driven_joint(names, rewording.holding(said, modal), modal)
    said = rewording.by_friction(rewording.needed_to_roll(names, rewording.in_doing(said)))
    said = rewording.transmitted(names, said, modal)
    said = _unaccelerated(_not_slipping(names, _carrying(names, said, modal)))
    words = _as_large(said)
    words = rewording.heaviest(names, words)
    if without_shear := of_sections.without_shear(names, Clause(said)):
        yield without_shear
        return
    yield from _rough_enough_to_roll(names, Clause(words))
    said = rewording.heaviest(names, said)
    lasting = _as_long_as(said)
    if modal == {"may"} and any(word in _HOW_FAR for word in said):  # how large may it be
        yield from limits(names, lasting, modal)
    if modal == {"may"}:  # from which height it may fall: a limit tells, which is mostly the greatest
        lasting = [Word("ask", "for") if word == Word("ask", "from") else word for word in lasting]
    yield from turning_round.parameters(names, _as_large(lasting), meanings)
    if any(word == Word("ask", "steep") for word in lasting):  # how steep is of an angle
        yield from turning_round.parameters(names, lasting, meanings)
    sentence = parted(words)
    sentence = sentence and told_who(names, sentence)
    if sentence is not None and is_whether and not joining.is_still(names):
        yield from whether(names, sentence)
    if sentence is not None and all(mark in _MARKS for mark, _ in sentence.others):
        for told in (
            _limit,
            _structure,
            _which_way,
            _conserved,
            averages,
            decaying,
            lost,
            time,
            stopping,
            gone_on,
            counted,
            geared,
            per_turn,
            _at_turning_points,
            timed,
            _at_extreme,
            _at_value,
        ):
            yield from told(names, sentence)
    if sentence is not None and is_whether:
        yield from whether(names, sentence)
    yield from time_between(names, said)
    yield from efficiency_of_planets(names, said)
    yield from stated(names, words)
    yield from limits(names, lasting, modal)


def _begins_with_verb(words: list[Word]) -> bool:
    """Whether a question begins with what something does: rutscht die Kiste, but not: slip of the crate."""
    after = next((word for word in words[1:] if word.kind != "filler"), None)
    return words[0].kind == "verb" and words[0].what not in _WITHOUT and after != Word("preposition", "of")


def _as_large(words: list[Word]) -> list[Word]:
    """How flat at most is how large at least."""
    is_small = any(word in (Word("ask", "small"), Word("ask", "flat")) for word in words)
    is_end = sum(word.kind == "degree" for word in words) == 1 and not any(
        w.kind in ("quantity", "value") for w in words
    )
    ends = {"greatest": "least", "least": "greatest"} if is_small and is_end else {}
    turned = [Word("degree", ends.get(word.what, word.what)) if word.kind == "degree" else word for word in words]
    return [_AS_LARGE.get(word, word) for word in turned]


def _stretched(names: Names, words: list[Word]) -> list[Word]:
    """By how much a spring is longer than without force is its deflection, where that is measured."""
    of = next((word.what for word in words if word.kind == "name"), "")
    swings = bool(lookup.angles(names, of) or lookup.hung(names, of)) or not lookup.ways(names, of)
    is_spring = of in lookup.springs(names)
    excursion = Word("quantity", "excursion" if is_spring else "angle" if swings else "displacement")
    words = [excursion if word == Word("quantity", "excursion") else word for word in words]
    is_measured = any(lookup.deflections(names, name) for name in (*lookup.springs(names), ""))
    meant: dict[str, str] = dict.fromkeys(lookup.STRETCHED, "deflection")
    if not is_measured:  # the only way in which what pulls, or presses, alone is deflected
        way = lookup.deflected(names, of)
        meant = {"deflection": way} if way else {}
    return [Word("quantity", meant.get(word.what, word.what)) if word.kind == "quantity" else word for word in words]


def _leads_nowhere(words: list[Word], k: int) -> bool:
    """Whether behind a preposition there is no thing, where one has to be: relative to, but to nothing."""
    leads = words[k].kind == "preposition" and words[k].what in ("relative", "between") and k + 1 < len(words)
    return leads and words[k + 1].kind not in ("name", "pronoun", "value", "quantity", "part", "preposition", "other")


def _asks_more(words: list[Word], k: int) -> bool:
    """Whether a second question begins: how long does it take, and how far does it get."""
    begins = words[k] == Word("preposition", "and") and k + 1 < len(words) and words[k + 1].kind == "ask"
    return begins and any(word.kind == "ask" for word in words[:k])


def _at_free_ends(names: Names, words: list[Word]) -> list[Word]:
    """With the points that the tip of a rod and its free end are; nothing where there is none."""
    found: list[Word] = []
    for word in words:
        body, _, end = word.what.partition(".")
        if word.kind == "name" and end in _ENDS_OF_LADDERS:
            ground = names.bodies[GROUND]
            is_way = body in {*ground.lines, *ground.planes}  # the bottom of an incline, or of a wire
            if is_way or (names.connections.get(body) and names.connections[body].level_places(names)):
                place = Word("instant", "at the bottom" if end == "foot" else "at the top")
                found = [*(found[:-1] if found[-1:] == [_IN] else found), place]
                continue
            bodies = [body] if body else lookup.moving(names)
            joints = [joint for own in bodies for joint in joining.leaning(names, own, level=end == "foot")]
            free = joining.free_end(names, body) if not joints else None  # of a rod that hangs, the lower one
            if free is not None and poses.begins_upright(names, body) == (end == "head"):
                joints = [free]
            if len(joints) != 1:
                return []
            word = Word("name", _moved_at(names, joints[0], bodies) if _is_moved(words) else joints[0])
        if word.kind == "name" and end == _FREE_END:
            points = [joining.free_end(names, own) for own in ([body] if body else lookup.moving(names))]
            free = [point for point in points if point is not None]
            if len(free) != 1:
                return []
            word = Word("name", free[0])
        found.append(word)
    return found


def _is_moved(words: list[Word]) -> bool:
    """Whether a motion is asked for, or how fast something is."""
    return any((w.kind == "quantity" and w.what in MOTION) or w == Word("ask", "fast") for w in words)


def _moved_at(names: Names, joint: str, bodies: list[str]) -> str:
    """The point of some bodies at which a connection holds them; the connection itself where none has a name."""
    ends = joining.ends_of(names, joint) if joint in names.connections else []
    points = [end for end in ends if "." in end and end.partition(".")[0] in bodies]
    return points[0] if len(points) == 1 else joint


def _at_mass_center(names: Names, words: list[Word]) -> list[Word]:
    """With the only body whose mass centre is meant where it is not said of what; or that of all."""
    center = Word("pronoun", "mass_center")
    if center not in words:
        return words
    bodies = lookup.massive(names)
    named = [word for word in words if word.kind == "name" and word.what in bodies]
    if len(named) == 1:  # `mass center velocity of cube`
        at = lookup.mass_center_of(names, named[0].what)
        return [Word("name", at) if word == named[0] else word for word in words if word != center]
    own = lookup.mass_center_of(names, bodies[0]) if len(bodies) == 1 else MASS_CENTER
    if len(bodies) > 1:
        words = [word for word in words if word != Word("pronoun", "system")]
    return [Word("name", own) if word == center else word for word in words]


def _as_long_as(words: list[Word]) -> list[Word]:
    """As long as it does not slip is so that it does not: but while it slides says when."""
    if _WHILE not in words:
        return words
    state = Clause(words[words.index(_WHILE) + 1 :])
    is_going = set(state.all("verb")) <= {*GOES_ON} - {"roll"} and state.has("verb") and not state.has("not")
    return words if is_going else [_SO_THAT if word == _WHILE else word for word in words]


def _from_rest(names: Names, words: list[Word]) -> list[Word]:
    """Without `if it starts from rest`, where the model does so and another instant is meant."""
    if _FROM_REST not in words:
        return words
    k = begin = words.index(_FROM_REST)
    others = Clause([*words[:k], *words[k + 1 :]])
    if not (lookup.rests(names) and others.has("value") and others.has("mark", "after", "when", "until")):
        return [own for word in words for own in ((_STARTS, _AT_START) if word == _FROM_REST else (word,))]
    while (
        begin > 0
        and words[begin - 1].kind in ("pronoun", "filler", "name")
        and any(w.kind == "mark" for w in words[:begin])
    ):
        begin -= 1
    begin -= begin > 0 and words[begin - 1].kind == "mark"
    return [*words[:begin], *words[k + 1 + (words[k + 1 : k + 2] == [_COMMA] and not begin) :]]


def _without_auxiliary(words: list[Word]) -> list[Word]:
    """`wird gehalten` is held; `wird 2 m/s` becomes, and reaches, 2 m/s."""
    become = Word("verb", "become")
    reaches = any(word.kind in ("value", "relation", "instant", "not") for word in words)
    if not reaches or any(word.kind == "verb" and word != become for word in words):
        return [word for word in words if word != become]
    return [Word("verb", "reach") if word == become else word for word in words]


def _not_slipping(names: Names, words: list[Word]) -> list[Word]:
    """`without sliding` is to roll, for what can, and else not to slide."""
    can_roll = lookup.can_roll(names) and (joining.rolls_on(names) or not joining.rough(names, ""))
    meant = [Word("verb", "roll")] if can_roll else [Word("not", "not"), Word("verb", "slide")]
    if Word("verb", "roll") in words:
        meant = []
    denied = {Word("verb", "no_slip"): meant, Word("verb", "no_move"): [_NOT, Word("verb", "move")]}
    return [own for word in words for own in denied.get(word, [word])]


def _unaccelerated(words: list[Word]) -> list[Word]:
    """What moves at constant speed is not accelerated."""
    constant = Word("verb", "no_accel")
    if constant not in words:
        return words
    kept = [word for word in words if word.kind != "verb" or word.what not in GOES_ON]
    return [own for word in kept for own in ((_NOT, _ACCELERATE) if word == constant else (word,))]


def _rough_enough_to_roll(names: Names, clause: Clause) -> Groups:
    """The least coefficient of friction with which it rolls, where the contact has no limit: |F| / N."""
    is_asked = clause.has("quantity", "friction coefficient") or clause.words[:1] == [Word("ask", "rough")]
    doing = set(clause.all("verb"))
    rolls = doing == {"roll"} or ("slide" in doing <= {"slide", "roll"} and clause.has("not"))
    known = ("quantity", "degree", "ask", "verb", "not", "name", "mark", *SILENT)
    when = " at start" if clause.all("instant") == ["at start"] else ""
    clause = clause.without("instant", "at start")
    if not (is_asked and rolls and clause.only(*known)) or set(clause.all("degree")) - {"least"}:
        return
    if len(clause.all("quantity")) > 1 or given.parameters(names, "friction coefficient", ""):
        return
    rough = joining.rough(names, "")
    joints = [joint for joint in rough if all(joining.touches(names, joint, name) for _, name in clause.names)]
    yield [f"ratio of |friction force of {joint}| to normal force of {joint}{when}" for joint in joints]


def _carrying(names: Names, words: list[Word], modal: set[str]) -> list[Word]:
    """What a connection carries is its force: the rope carries 500 N; what it can carry is no less than that."""
    carry = Word("verb", "carry")
    joints = [word.what for word in words if word.kind == "name" and word.what in names.connections]
    if len(joints) == 1 and "may" not in modal and _asks_what_holds(words):
        words = [carry if word == Word("verb", "hold") else word for word in words]
    rows = {row.reaction for row in names.constraint_rows if row.connection in joints}
    kind = next((kind for kind in ("tension", "normal force", "reaction") if kind in rows), "reaction")
    if kind == "tension" and not any(row.unilateral for row in names.constraint_rows if row.connection in joints):
        kind = "force"  # a bar may be pressed
    meant = Word("quantity", kind) if len(joints) == 1 and not any(w.kind == "quantity" for w in words) else None
    bounds = (Word("ask", "heavy"), Word("ask", "large"))
    if meant is not None and carry in words:
        if any(w.kind == "degree" or w in bounds for w in words[: words.index(carry)]):
            words = [_SO_THAT if w == Word("mark", "when") else w for w in words]
            at = next((k for k, w in enumerate(words) if w.kind == "value"), 0)
            is_said = any(w.kind == "relation" for w in words) or (at and words[at - 1].kind == "degree")
            if "may" in modal and at and not is_said:
                after = [w for w in words[at:] if w != Word("degree", "greatest")]  # 8 kN at most
                words = [*words[:at], Word("relation", "<="), *after]
        k = words.index(Word("name", joints[0]))
        return [w for w in (*words[:k], meant, *words[k:]) if w != carry]
    return [Word("verb", "move") if word == carry else word for word in words]


def _asks_what_holds(words: list[Word]) -> bool:
    """What must the rope hold, how much does it hold: its force."""
    is_what = words[:1] and words[0] in (Word("ask", what) for what in ("what", "much", "large", "with"))
    plain = [w.what for w in words if w.kind not in ("ask", "name", *SILENT)]
    return bool(is_what) and plain == ["hold"] and sum(w.kind == "name" for w in words) == 1


def _limit(names: Names, sentence: Sentence) -> Groups:
    """A quantity as a parameter tends to a value: the acceleration for M -> 0."""
    yield from _without(names, sentence)
    arrows = [k for k, word in enumerate(sentence.main.words) if word == Word("relation", "->")]
    clause = sentence.others[0][1] if len(sentence.others) == 1 and not arrows else sentence.main
    words = clause.words
    arrows = [k for k, word in enumerate(words) if word == Word("relation", "->")]
    if len(arrows) != 1 or not 0 < arrows[0] == len(words) - 2 or words[arrows[0] - 1].kind != "name":
        return
    k = arrows[0]
    parameter, value = words[k - 1].what, words[k + 1].what
    head = Clause(words[: k - 1]) if clause is sentence.main else sentence.main
    head = head.without("verb", "limit").without("quantity", "limit")
    if parameter in names.parameters and words[k + 1].kind in ("value", "name"):
        for group in quantities(names, head):
            yield [f"{text} as {parameter} -> {value}" for text in group]


def _without(names: Names, sentence: Sentence) -> Groups:
    """A quantity where a body has no mass, or nothing has friction: the limit as these go to zero."""
    words = [*sentence.main.words, *(word for _, own in sentence.others for word in own.words)]
    if len(sentence.others) > 1 or not any(
        word.kind == "verb" and word.what in ("massless", "smooth") for word in words
    ):
        return
    k = next(k for k, word in enumerate(words) if word.kind == "verb" and word.what in ("massless", "smooth"))
    beside = [j for j in (k + 1, k - 1) if 0 <= j < len(words) and words[j].kind == "name"][:1]
    of = words[beside[0]].what if beside else ""
    kind = "mass" if words[k].what == "massless" else "friction coefficient"
    kept = [word for j, word in enumerate(words) if j not in (k, *beside)]
    while kept and kept[-1].kind in ("preposition", "mark"):
        kept.pop()
    found = given.parameters(names, kind, of)
    for group in quantities(names, Clause(kept)) if len(found) == 1 else ():
        yield [f"{text} as {found[0]} -> 0" for text in group]


def _structure(names: Names, sentence: Sentence) -> Groups:
    """What is asked of the system itself: whether it stays at rest, turns fully, is stable, can be assembled."""
    main = sentence.main
    whole = Clause([*main.words, *(word for _, own in sentence.others for word in own.words)])
    growing = [name for _, name in whole.names if name in names.parameters]
    bodies = [name for _, name in whole.names if name in names.bodies]
    kinds = [given.KIND_OF[what] for what in whole.all("quantity") if given.is_by_unit(what)]
    if not growing and whole.has("verb", "grow") and all(lookup.is_all_that_moves(names, name) for name in bodies):
        growing = given.growing(names, [name for _, name in whole.names])
        growing = [name for name in growing if all(kind.has(names.parameters[name]) for kind in kinds)]
    doing = set(whole.all("verb")) - {"start", "move"}
    if {"tip", "slide", "rise"} == doing:  # when the ramp is raised
        doing, growing = {"tip", "slide", "grow"}, growing or given.growing(names, [])
        bodies = []
    if joining.is_still(names) and whole.has("degree", "first"):  # whether wheels spin, or others lift off first
        spin = {"turn"} if whole.has("quantity", "angular velocity") else set[str]()
        doing = {_FAILS.get(verb, verb) for verb in doing | spin}
    if doing == {"tip", "slide"} and not (sentence.others or whole.has("ask")):  # of the only force
        growing = growing or given.growing(names, [])
        doing |= {"grow"}
    if doing == {"tip", "slide", "grow"} and not growing and len(kinds) == 1:  # as the acceleration increases
        growing = given.chosen(names, kinds[0], [])
        bodies = []
    fails = doing == {"tip", "slide", "grow"} and not whole.has("value")
    fails = fails and lookup.rests(names)
    if fails and len(growing) == 1 and not whole.has("not") and set(whole.all("degree")) <= {"first"}:
        yield [f"does it tip or slide as {growing[0]} grows"]
    verbs, of = set(main.all("verb")), [name for _, name in main.names]
    grown = [
        own.names[0][1] for mark, own in sentence.others if mark == "when" and own.has("verb", "grow") and own.names
    ]
    if verbs & {"tip"} and verbs & {"slide"} and len(verbs - {"start", "move"}) == 2 and len(grown) == 1:
        yield [f"does it tip or slide as {grown[0]} grows"]
    doing = set(whole.all("verb"))
    is_enough = "suffice" in doing <= {"hold", "suffice"} or (doing == {"slide", "suffice"} and whole.has("not"))
    holding = (Word("verb", "hold"), Word("quantity", "friction force"))
    is_held = doing == {"hold"} and main.words[:1] and main.words[0] in holding  # does friction hold it
    is_plain = whole.only("verb", "quantity", "mark", "name", "not", *SILENT) and set(whole.all("quantity")) in _HOLDS
    if (is_enough or is_held) and is_plain and lookup.rests(names):
        yield ["does it hold"]
    if sentence.others or main.has("value") or main.has("relation") or main.has("turns"):
        return
    slips_not = verbs == {"slide"} and main.has("not") and main.only("verb", "name", "not", *SILENT)
    if slips_not and all(joining.is_all_that_slips(names, name) for name in of) and not joining.rolls(names):
        yield ["does it hold"] if lookup.rests(names) else []
    asks_when = main.words[:1] and main.words[0].kind == "ask" and main.words[0].what in ("when", "soon", "with")
    if asks_when and verbs == {"stable"} and main.all("quantity") == ["equilibrium"] and not of:
        yield ["stability of equilibrium"]  # whose answer says when
    if asks_when and verbs == {"stable"} and not main.has("quantity") and not of and lookup.is_controlled(names):
        yield ["stability of steady motion"]
    if main.all("ask") == ["long"] and len(of) == 1 and main.only("ask", "name", *SILENT):  # how long is the cable
        yield [f"length of {name}" for name in of if name in transmitting.having(names, "length")]
    if main.has("quantity", "degrees of freedom") and main.only("quantity", "ask", "pronoun", "preposition", "verb"):
        yield ["degrees of freedom"]
    asks_nothing = not (main.has("ask") or main.has("not") or main.has("degree") or main.has("quantity"))
    everything = all(lookup.is_all_that_moves(names, name) or joining.is_all_that_slips(names, name) for name in of)
    comes_to_rest = "stop" in verbs and joining.comes_to_strike(names) and not joining.is_rough(names)  # let fall
    if verbs and verbs <= {"hold", "move", "stop", "remain"} and verbs - {"move"} and asks_nothing and everything:
        yield ["does it hold"] if lookup.rests(names) and not comes_to_rest else []
    at_rest = main.all("instant") == ["in equilibrium"] and main.only("instant", "name", "pronoun") and everything
    if lookup.rests(names) and at_rest:
        yield ["does it hold"]
    begins = verbs - {"start"}
    is_other = "slide" in begins and (joining.rolls(names) or not joining.is_rough(names))
    is_begun = begins and begins <= {"move", "slide", "turn"} and main.only("verb", "name", *SILENT)
    if is_begun and everything and not is_other:
        yield ["does it hold"] if lookup.rests(names) else []
    if verbs & {"stable", "unstable"} and main.only("verb", "quantity", "pronoun", "preposition", "name", "instant"):
        asked = main.all("quantity")
        is_all = len(of) <= 1 or "in equilibrium" in main.all("instant")  # what a part is at is that of all
        spins = names.space and not lookup.rests(names) and not asked
        if not asked and (lookup.is_controlled(names) or spins) and is_all:
            yield ["stability of steady motion"]
        is_held = joining.is_rough(names) and lookup.rests(names) and verbs == {"stable"} and not main.has("ask")
        if is_held and not asked and everything and not main.all("instant"):  # of what friction holds
            yield ["does it hold"]
        if asked == ["equilibrium"] or (not asked and is_all and not spins):
            yield ["stability of equilibrium"]
    if "turn_fully" in verbs and main.only("verb", "name", "ask") and len(of) == 1 and not main.has("ask"):
        yield [f"does {of[0]} turn fully"] if not stands(names, of[0]) else []
    is_chosen = any(name in names.parameters for name in of)  # for which b it locks itself
    if (
        verbs == {"self_locking"} and main.only("verb", "name", "ask", *SILENT) and not is_chosen
    ):  # rest needs no torque
        yield [f"is {name} self-locking" for name in joining.threads(names, of)]
        pushes = [
            name for name in given.of_kind(names, "torque") if name in given.chosen(names, given.KIND_OF["torque"], [])
        ]
        yield [f"range of {push} that keeps it at rest" for push in pushes]
    if "assemble" in verbs and not main.has("quantity") and not of:
        yield ["when does the loop assemble"]
    if verbs == {"damped"} and main.only("verb", "name", "pronoun"):
        yield ["damping ratio"]
    if verbs & {"tip"} and verbs & {"slide"} and len(verbs - {"start", "move"}) == 2:
        grows = [name for name in of if name in names.parameters]
        yield [f"does it tip or slide as {name} grows" for name in grows]


def _at_extreme(names: Names, sentence: Sentence) -> Groups:
    """When, where or at which angle something is greatest or least: the time, or the place, when it is."""
    words = sentence.main.words
    asks = [w.what for w in words if w.kind == "ask"]
    ends = [w for w in words if w.kind == "degree" and w.what in ("greatest", "least")]
    if sentence.others or len(asks) != 1 or words[0].kind != "ask" or len(ends) != 1 or ends[0] != words[-1]:
        return
    said = [k for k, w in enumerate(words) if w.kind == "quantity"]
    if asks[0] in ("when", "soon") and len(said) == 1:
        yield from time(names, Sentence(Clause([Word("ask", "when")]), (("when", Clause(words[1:])),)))
    elif asks[0] == "where" and len(said) == 1:
        yield from timed(names, Sentence(Clause([Word("quantity", "position")]), (("when", Clause(words[1:])),)))
    elif asks[0] == "high" and len(said) == 1:
        of = [word for word in words if word.kind == "name"]
        height = Clause([Word("quantity", "height"), *of])
        yield from timed(names, Sentence(height, (("when", Clause(words[1:])),)))
    elif asks[0] in ("with", "for") and len(said) == 2 and words[said[0]].what in ("angle", "position"):
        place, rest = words[1 : said[0] + 1], words[said[0] + 1 :]  # the horizontal force is greatest
        while rest and rest[0].kind in ("name", "preposition"):  # at which angle of the crank
            place, rest = [*place, rest[0]], rest[1:]
        yield from timed(names, Sentence(Clause(place), (("when", Clause(rest)),)))


def _at_value(names: Names, sentence: Sentence) -> Groups:
    """Where a quantity has a value: the place, when it has."""
    main = sentence.main
    is_plain = main.only("ask", "quantity", "value", "name", "relation", "part", *SILENT) and not sentence.others
    if main.all("ask") == ["where"] and len(main.all("quantity")) == len(main.values) == 1 and is_plain:
        yield from timed(names, Sentence(Clause([Word("quantity", "position")]), (("when", main.without("ask")),)))


def _at_turning_points(names: Names, sentence: Sentence) -> Groups:
    """At which angle of the crank the rocker turns back: at the dead points of the rocker."""
    words = [word for word in sentence.main.words if word.kind not in SILENT]
    kinds = [word.kind for word in words]
    ends = (Word("verb", "turn_back"), Word("instant", "turning point"))
    ends = (*ends, Word("verb", "stop")) if joining.is_led(names) else ends
    if kinds[-2:] == ["verb", "name"]:  # where does stand still the piston, as German has it
        words, kinds = [*words[:-2], words[-1], words[-2]], [*kinds[:-2], "name", "verb"]
    if sentence.others or not words or words[-1] not in ends or kinds[-2:-1] != ["name"]:
        return
    place, turns = words[1:-2], words[-2].what
    goes = lookup.places(names, turns) if joining.is_led(names) else []  # a piston, by the only measure of its place
    turns = goes[0] if turns not in lookup.turning(names) and len(goes) == 1 else turns
    is_asked = words[0].kind == "ask" and words[0].what in ("with", "for")
    is_asked &= turns in lookup.turning(names) or turns in goes
    is_asked &= any(w.kind == "name" and w.what != turns for w in place)
    if is_asked and Clause(place).only("name", "quantity"):
        for group in quantities(names, Clause(place)):
            yield [f"{text} at the dead points of {turns}" for text in group]


def _which_way(names: Names, sentence: Sentence) -> Groups:
    """Which way something moves that is let go: the way in which it is accelerated."""
    main, verbs = sentence.main, set(sentence.main.all("verb"))
    is_size = names.space and main.has("quantity", "friction force")  # which tells no direction
    if main.has("ask", "way") and set(main.all("quantity")) & {*FORCES} and not is_size:  # as its components tell
        yield from timed(names, Sentence(main.without("ask", "way").without("verb", "act", "move"), sentence.others))
    of = [name for _, name in main.names if name in lookup.moving(names)]
    begins = verbs - {"start"} <= {*GOES_ON} and (main.has("instant", "at start") or "start" in verbs)
    if begins and main.has("ask", "way") and main.only("ask", "verb", "name", "instant", *SILENT):
        ways = [name for _, name in main.names if name in names.measures]  # that is let go: as it is accelerated
        yield [f"acceleration of {way} at start" for way in ways if names.start_rates.get(way, ZERO) == ZERO]
    goes = main.has("ask", "way") and verbs <= {*GOES_ON, "hit", "leave"} and not main.has("quantity")
    if goes and (not lookup.rests(names) or sentence.others) and len(of) <= 1:  # as the components of its velocity tell
        way = Word("quantity", "velocity")
        kept = Clause([way, *(w for w in main.words if w != Word("ask", "way") and w.what not in GOES_ON)])
        yield from timed(names, Sentence(kept, sentence.others))
    plain = main.has("ask", "way") and main.only("ask", "verb", "name", *SILENT) and not sentence.others
    relative = "".join(f" relative to {name}" for before, name in main.names if before == "relative")
    plain &= len(of) == len(main.names) == 1 + bool(relative) and lookup.rests(names)
    if plain and verbs <= {"start", "tip", *GOES_ON} and verbs:
        is_turned = bool(verbs & {"turn", "tip"}) or joining.axle_of(names, of[0]) == "center"
        yield [f"{'angular ' if is_turned else ''}acceleration of {of[0]}{relative}"]


def _conserved(names: Names, sentence: Sentence) -> Groups:
    """Is the total energy conserved? When is it?"""
    main = sentence.main
    if main.words[:1] == [Word("verb", "change")]:  # does the energy change: whether it is conserved tells that
        main = Clause([Word("verb", "conserved"), *main.words[1:]])
    if not main.has("verb", "conserved") or main.has("not"):
        return
    asks_when = main.has("ask", "when", "with")
    others = [clause for mark, clause in sentence.others if not is_throughout(names, mark, clause)]
    if (main.has("ask") and not asks_when) or others:
        return
    in_blow = [w for w in main.words if w in (Word("instant", "in the impact"), Word("instant", "at the impact"))]
    struck = [w for w in main.words if in_blow and w.kind == "name" and w.what in names.connections][-1:]
    silent = (Word("verb", "conserved"), Word("verb", "move"), *in_blow, *struck)
    kept = Clause([w for w in main.words if w.kind not in ("ask",) and w not in silent])
    when = "".join(f" of {w.what}" for w in struck)
    when = f" in the blow{when}" if in_blow else ""
    for group in quantities(names, kept):
        yield [f"{'when is' if asks_when and not in_blow else 'is'} {text} conserved{when}" for text in group]
