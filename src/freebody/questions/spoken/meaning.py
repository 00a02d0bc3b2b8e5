"""Whole questions: a main clause and what is said of when, until when, for which values it is meant.

Gives groups of texts in the words of the grammar, the likeliest first.
"""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

from freebody.questions.spoken import (
    beginning,
    given,
    joining,
    lookup,
    of_sections,
    pushes,
    rewording,
    rubbing,
    speeds,
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
from freebody.questions.spoken.geared import efficiency_of_planets, geared, per_turn
from freebody.questions.spoken.instants import timed
from freebody.questions.spoken.lexicon import Word
from freebody.questions.spoken.limits import limits
from freebody.questions.spoken.of_the_whole import conserved, structure
from freebody.questions.spoken.points_meant import at_free_ends, at_mass_center
from freebody.questions.spoken.recomposing import recomposed
from freebody.questions.spoken.sentence import Sentence, parted, told_who
from freebody.questions.spoken.stated import stated
from freebody.questions.spoken.unneeded import without_unneeded
from freebody.questions.spoken.where_and_when import at_extreme, at_turning_points, at_value, at_zero, which_way
from freebody.questions.spoken.whether import whether
from freebody.questions.spoken.words import Clause

if TYPE_CHECKING:
    from freebody.model.names import Names

_MARKS = ("when", "until", "after", "while")
_HOW_FAR = tuple(Word("ask", what) for what in ("large", "small", "heavy", "far", "high", "steep", "flat"))
_HOW_LARGE = Word("ask", "large")
_OF_CONTACTS = ("friction force", "normal force", "contact force", "reaction")
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
    words = rewording.rates(at_mass_center(names, at_free_ends(names, words)))
    if not words:
        return
    modal = {word.what for word in words if word.kind == "filler"} & {"may", "must"}
    is_whether = words[0] in _WHETHER_WORDS or _begins_with_verb(words)
    words = rewording.far_from_origin(names, _stretched(names, _from_rest(names, words)))
    said = rewording.signs_between([word for word in words if word.kind != "filler"])
    said = rewording.lasting_from_start(pushes.enough_to(rewording.how_deep(rewording.for_a_motion(said))))
    said = rewording.on_the_way_back(names, rewording.rolling_back(names, rewording.placed(said, modal)))
    said = rewording.so_far_that(names, pushes.hauled(names, said, modal), modal)
    said = rewording.in_turns(pushes.runs_slack(rewording.for_a_turn(said, modal)))
    said = _without_auxiliary(speeds.lifted(names, said))
    said = beginning.told(names, rewording.kept_steady(names, rewording.bounded(said)))
    if said and said[-1].kind == "preposition" and said[-1].what in _LEADS_ON:
        return
    if any(_leads_nowhere(said, k) or _asks_more(said, k) for k in range(len(said) - 1)):
        return
    said = speeds.onto_buffer(names, without_unneeded(names, said))
    said = rewording.sliding_in_slots(names, pushes.holding_fast(names, said))
    said = rewording.for_what(names, rewording.infinitives(rewording.spinning(names, said)))
    said = pushes.by_joint(names, pushes.given_by_joint(names, pushes.taken_along(names, said)))
    said = pushes.pulling(names, rewording.balanced_at(names, pushes.held_by_clamp(names, said)))
    said = pushes.driven_by_needed(names, rewording.can_accelerate(names, said, modal))
    said = rewording.at_extremes(rewording.lifting_off(names, rewording.on_what_may_open(names, said)))
    said = pushes.at_driven_joint(names, pushes.holding(said, modal), modal)
    said = pushes.by_friction(pushes.needed_to_roll(names, rewording.in_doing(said)))
    said = pushes.transmitted(names, said, modal)
    said = _unaccelerated(_not_slipping(names, _carrying(names, said, modal)))
    words = _as_large(said)
    words = pushes.heaviest(names, words)
    if places := of_sections.without_load(names, Clause(said)):
        yield places
        return
    yield from _rough_enough_to_roll(names, Clause(words))
    said = pushes.heaviest(names, said)
    lasting = _as_long_as(said, modal)
    if modal == {"may"} and any(word in _HOW_FAR for word in said):  # how large may it be
        yield from limits(names, lasting, modal)
    if modal == {"may"}:  # from which height it may fall: a limit tells, which is mostly the greatest
        lasting = [Word("ask", "for") if word == Word("ask", "from") else word for word in lasting]
    yield from turning_round.parameters(names, _as_large(lasting), meanings)
    if any(word == Word("ask", "steep") for word in lasting):  # how steep is of an angle
        yield from turning_round.parameters(names, lasting, meanings)
    sentence = parted(words)
    sentence = sentence and told_who(names, sentence)
    if sentence is not None and is_whether and not rubbing.is_still(names):
        yield from whether(names, sentence)
    if sentence is not None and all(mark in _MARKS for mark, _ in sentence.others):
        for told in (
            _limit,
            structure,
            which_way,
            conserved,
            averages,
            decaying,
            lost,
            time,
            stopping,
            gone_on,
            counted,
            geared,
            per_turn,
            at_turning_points,
            timed,
            at_extreme,
            at_value,
            at_zero,
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


def _as_long_as(words: list[Word], modal: set[str]) -> list[Word]:
    """As long as it does not slip is so that it does not: but while it slides says when, and so does what is asked of
    a force that is as it is: how large is it while it rests."""
    head = words[1:] if words[:1] == [_HOW_LARGE] else words
    is_given = not modal and bool(head) and head[0].kind == "quantity" and head[0].what in _OF_CONTACTS
    if _WHILE not in words or is_given:
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
    can_roll = lookup.can_roll(names) and (rubbing.rolls_on(names) or not rubbing.rough(names, ""))
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
    rough = rubbing.rough(names, "")
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
