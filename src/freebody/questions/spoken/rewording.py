"""Words of a question put as others put them, before they are parted into clauses."""

from __future__ import annotations

from typing import TYPE_CHECKING

from freebody.questions.spoken import (
    along_lines,
    dimensions,
    driving,
    joining,
    lookup,
    rubbing,
)
from freebody.questions.spoken.composing import SILENT
from freebody.questions.spoken.events import GOES_ON
from freebody.questions.spoken.lexicon import Word
from freebody.questions.spoken.words import Clause

if TYPE_CHECKING:
    from freebody.model.names import Names

_INFINITIVE = Word("preposition", "to")
_FOR = Word("preposition", "of")  # friction for rolling
_DONE = tuple(Word("verb", verb) for verb in ("hold", "rise", "fall", "move", "start", "turn", "stop", "accelerate"))
_PUSHES = ("force", "torque", "moment", "driving force", "driving torque")
_HOW_HARD = (Word("ask", "large"), Word("ask", "much"))
_WAY_BACK = Word("quantity", "way back")
_OF_SPEED = (dimensions.is_speed, dimensions.is_turning_speed)
_SO_THAT, _TO = Word("mark", "so_that"), Word("mark", "to")
_COUNTED_OVER_A_TURN = ("work", "energy", "energy lost", "power", "time", "turns")


def for_what(names: Names, words: list[Word]) -> list[Word]:
    """The least k for stability is that with which it is stable; the angle for the farthest throw is that for which
    the range is largest."""
    throw = [Word("degree", "greatest"), Word("verb", "exert")]
    if words[-2:] == throw and _SO_THAT in words:  # the angle that gives the farthest throw
        words = [*words[:-1], Word("quantity", "horizontal range")]
    k = next((k for k, word in enumerate(words) if word == _FOR and k > 0), 0)
    head, tail = Clause(words[:k]), Clause(words[k + 1 :])
    if k and tail.words == [Word("degree", "greatest"), Word("verb", "exert")]:  # for the farthest throw
        tail = Clause([Word("degree", "greatest"), Word("quantity", "horizontal range")])
    if not k or head.has("mark") or head.has("verb") or tail.has("mark") or tail.has("verb"):
        return words
    if tail.all("quantity") in (["stability of equilibrium"], ["stability of steady motion"]):
        kept = [w for w in tail.words if w.kind not in ("quantity", "preposition")]
        return [*head.words, _SO_THAT, *kept, Word("verb", "stable")]
    kept = [w for w in head.words if w.kind not in ("degree", "ask")]  # the best angle
    if tail.all("quantity") == ["distance"] and lookup.flies(names, ""):
        tail = Clause([Word("quantity", "horizontal range") if w.kind == "quantity" else w for w in tail.words])
    is_angle = head.all("quantity") == ["angle"] or (len(kept) == 1 and kept[0].what in names.parameters)
    if is_angle and tail.has("degree", "greatest") and tail.all("quantity") == ["horizontal range"]:
        return [Word("ask", "for"), *kept, *tail.without("degree").words, Word("degree", "greatest")]
    return words


def balanced_at(names: Names, words: list[Word]) -> list[Word]:
    """For which y is it in equilibrium: the equilibrium of y."""
    clause = Clause(words)
    measures = [name for _, name in clause.names if name in names.measures]
    asks = clause.all("ask") in (["for"], ["with"], ["where"], ["what"]) and words[0].kind == "ask"
    rests = clause.all("verb") in ([], ["hold"]) and clause.all("instant") in ([], ["in equilibrium"])
    rests &= clause.all("quantity") in ([], ["equilibrium"]) and not clause.only("ask", "name", *SILENT)
    others = [name for _, name in clause.names if name not in measures and name not in lookup.moving(names)]
    plain = clause.only("ask", "name", "verb", "instant", "quantity", *SILENT)
    if not (asks and rests and plain and len(measures) == 1) or others:
        return words
    return [Word("quantity", "equilibrium"), _FOR, Word("name", measures[0])]


def so_far_that(names: Names, words: list[Word], modal: set[str]) -> list[Word]:
    """How far the hand must move so that the load rises by 1 m is how far until it has risen so far; how long it needs
    to reach a speed, from rest where it starts so, how long until it has reached that."""
    until = Word("mark", "until")
    if "must" in modal and Word("ask", "far") in words and _SO_THAT not in words:  # how far to raise it by 5 cm
        if _TO in words and words[-2:-1] == [_INFINITIVE]:  # whose verb stands at the end: um sie um 5 cm zu heben
            words = [_SO_THAT if word == _TO else word for word in (*words[:-2], words[-1])]
        goes = (k for k in range(len(words) - 1) if words[k] == _INFINITIVE and words[k + 1].what in GOES_ON)
        k = next(goes, None)
        words = words if k is None else [*words[:k], _SO_THAT, *words[k + 1 :]]
    reaches = Word("ask", "long") in words and Word("verb", "reach") in words and any(w.kind == "value" for w in words)
    if reaches and (_TO in words or until in words):
        at_start = Word("instant", "at start")
        words = [until if word == _TO else word for word in words if word != at_start or not lookup.rests(names)]
        k = words.index(until)
        return [*words[: k + 1], *(word for word in words[k + 1 :] if word.kind != "preposition")]
    is_geared = {Word("ask", "fast"), _SO_THAT} <= {*words} and "must" in modal
    values = [w.what for w in words if w.kind == "value"]
    is_speed = len(values) == 1 and any(is_of(values[0]) for is_of in _OF_SPEED)
    if is_geared and is_speed and not any(w.kind in ("not", "degree") for w in words):
        named = [w.what for w in words[: words.index(_SO_THAT)] if w.kind == "name"]
        if all(name in lookup.moving(names) for name in named) and named:  # and no parameter that is to be chosen
            return [Word("mark", "when") if word == _SO_THAT else word for word in words]
    is_way = "must" in modal and Word("ask", "far") in words and _SO_THAT in words
    if not is_way or any(word.kind in ("quantity", "relation", "not", "degree") for word in words):
        return words
    k = words.index(_SO_THAT)
    state = words[k + 1 :]
    if not any(w.kind == "value" for w in state) or any(w.kind == "verb" and w.what not in GOES_ON for w in words):
        return words
    named = any(word.kind == "name" for word in state)
    return [*words[:k], Word("mark", "until"), *(w for w in state if not (named and w == Word("pronoun", "it")))]


def placed(words: list[Word], modal: set[str]) -> list[Word]:
    """At what height may one push is how high one may."""
    asks = [Word("ask", "with"), Word("quantity", "height")]
    k = next((k for k in range(len(words) - 1) if words[k : k + 2] == asks), None)
    is_asked = k is not None and modal == {"may"} and Word("verb", "exert") in words
    return [*words[:k], Word("ask", "high"), *words[k + 2 :]] if is_asked and k is not None else words


def in_turns(words: list[Word]) -> list[Word]:
    """While it turns once is over a turn."""
    leads = [Word("mark", "while"), *(Word("preposition", what) for what in ("of", "in", "over"))]
    ones = [[lead, Word("turns", "1")] for lead in leads]
    is_counted = Word("ask", "many") in words or Word("quantity", "turns") in words
    ones = ones if is_counted else ones[:1]
    k = next((k for k in range(1, len(words)) if words[k : k + 2] in ones), None)
    return words if k is None else [*words[:k], Word("instant", "over a turn"), *words[k + 2 :]]


def for_a_turn(words: list[Word], modal: set[str]) -> list[Word]:
    """What is chosen for a full turn is to let it go round; what is counted for one is so over it."""
    turn = Word("instant", "for a full turn")
    if turn not in words:
        return words
    asks = ("high", "fast", "from", "for", "with", "steep")
    is_counted = any(word.kind == "quantity" and word.what in _COUNTED_OVER_A_TURN for word in words)
    is_chosen = not is_counted and (
        bool(modal) or any(w.kind == "degree" or (w.kind == "ask" and w.what in asks) for w in words)
    )
    meant = (_SO_THAT, Word("verb", "turn_fully")) if is_chosen else (Word("instant", "over a turn"),)
    return [own for word in words for own in (meant if word == turn else (word,))]


def kept_steady(names: Names, words: list[Word]) -> list[Word]:
    """What a controller holds, or does not let tip, has a stable motion."""
    chosen = any(word.kind == "degree" or (word.kind == "name" and word.what in names.parameters) for word in words)
    is_asked = chosen or words[:1] == [Word("filler", "does")] or (words and words[0].kind == "verb")
    rubs = any("contact" in names.called.get(name, ()) for name in rubbing.rough(names, ""))
    if not is_asked or rubs or not lookup.is_controlled(names):
        return words
    meant = {"hold": "stable", "tip": "unstable"}
    if Word("not", "not") in words and Word("verb", "tip") in words:
        words = [Word("verb", "hold") if w == Word("verb", "tip") else w for w in words if w != Word("not", "not")]
    return [Word("verb", meant[w.what]) if w.kind == "verb" and w.what in meant else w for w in words]


def how_deep(words: list[Word]) -> list[Word]:
    """How deep something falls is how far down; how deep it floats is how high, the other way."""
    deep = Word("ask", "deep")
    if deep not in words:
        return words
    is_settled = Word("instant", "in equilibrium") in words or Word("verb", "hold") in words
    meant = [Word("ask", "high")] if is_settled else [Word("ask", "far"), Word("updown", "down")]
    return [own for word in words for own in (meant if word == deep else [word])]


def for_a_motion(words: list[Word]) -> list[Word]:
    """How long it takes for the way up is how long it rises; the time for the way back is how long that takes."""
    leads, does = words[-2:-1], words[-1:]
    goes = does == [_WAY_BACK] or (bool(does) and does[0].kind == "verb" and does[0].what in GOES_ON)
    plain = all(word.kind in ("ask", "name", "pronoun") or word == Word("quantity", "time") for word in words[:-2])
    is_time = Word("ask", "long") in words or (does == [_WAY_BACK] and Word("quantity", "time") in words)
    return [*words[:-2], *does] if goes and leads in ([_SO_THAT], [_FOR]) and plain and is_time else words


def on_the_way_back(names: Names, words: list[Word]) -> list[Word]:
    """On the way back, when x = 0: where it started from zero it comes there on no other way."""
    k = words.index(_WAY_BACK) if _WAY_BACK in words else 0
    zero = [Word("relation", "="), Word("value", "0")]
    back = [word.what for j, word in enumerate(words) if word.kind == "name" and words[j + 1 : j + 3] == zero]
    returns = [name for name in back if name in names.started_at_zero and name in names.start_rates]
    leads = k > 0 and words[k - 1].kind == "preposition"
    return [*words[: k - 1], *words[k + 1 :]] if leads and returns and returns == back else words


def lasting_from_start(words: list[Word]) -> list[Word]:
    """How long something lasts at the start is how long until it ends: `at first` says no more."""
    start, long = Word("instant", "at start"), Word("ask", "long")
    is_alone = not any(word.kind in ("mark", "quantity") for word in words)
    lasts = long in words and is_alone and any(w.kind == "verb" and w.what in ("hold", "roll", "slide") for w in words)
    return [word for word in words if word != start] if lasts else words


def rates(words: list[Word]) -> list[Word]:
    """A rate is a velocity; of what turns, that of its angle."""
    turns = Word("verb", "turn") in words
    rate = Word("quantity", "angular velocity" if turns else "velocity")
    return [rate if word == Word("quantity", "rate") else word for word in words]


def spinning(names: Names, words: list[Word]) -> list[Word]:
    """Wheels that start to spin slip, where nothing moves yet."""
    spin = Word("quantity", "angular velocity")
    before = (Word("verb", "start"), Word("not", "not"))
    k = next((k for k in range(len(words) - 1) if words[k] in before and words[k + 1] == spin), None)
    if k is None or not rubbing.is_still(names):
        return words
    return [*words[: k + 1], Word("verb", "slide"), *words[k + 2 :]]


_CHOSEN = ("quantity", "name")  # kinds of words for what is to be found so that something is so


def infinitives(words: list[Word]) -> list[Word]:
    """The torque to hold the load is that needed to: behind what is asked a verb says what for."""
    found: list[Word] = []
    for k, word in enumerate(words):
        before = Clause(found)
        is_led = word == Word("preposition", "to")
        is_verb = is_led and any(w in _DONE for w in words[k + 1 : k + 2])
        is_end = is_led and before.has("degree", "greatest", "least") and before.only("degree", *_CHOSEN, *SILENT)
        if is_end and before.has(*_CHOSEN[:1]) and any(w.kind == "verb" for w in words[k + 1 : k + 2]):
            found.append(_TO)  # the least height to go round
        elif not is_verb:
            found.append(word)
        elif not before.has("verb") and not before.has("mark") and before.has("quantity", *_PUSHES):
            found.append(_TO)
        elif not before.has("mark", "to", "so_that"):  # um die Last zu heben
            found.append(word)
    return found


def can_accelerate(names: Names, words: list[Word], modal: set[str]) -> list[Word]:
    """How fast it can speed up is the greatest acceleration, how hard it has to is one too; so are decelerations."""
    fast, speeds_up = Word("ask", "fast"), Word("verb", "accelerate")
    if not (rubbing.is_still(names) or rubbing.is_carried(names)):
        return words
    slows = Word("quantity", "deceleration")
    words = [Word("quantity", "acceleration") if word == slows else word for word in words]
    asks = [word for word in words if word == fast or word in _HOW_HARD]
    if not modal or len(asks) != 1 or speeds_up not in words:
        return words
    if (asks == [fast] and "may" not in modal) or any(word.kind == "quantity" for word in words):
        return words
    said = [word for word in words if word.kind == "degree"] or [Word("degree", "greatest")] * ("may" in modal)
    meant = (*(said or [Word("ask", "what")]), Word("quantity", "acceleration"))
    kept = (word for word in words if word != speeds_up and word.kind != "degree")
    return [own for word in kept for own in (meant if word in asks else (word,))]


def rolling_back(names: Names, words: list[Word]) -> list[Word]:
    """What starts at rest on a slope, or on a rope, rolls back where it goes down."""
    back = Word("verb", "turn_back")
    if back not in words or Word("not", "not") not in words or not lookup.rests(names):
        return words
    who = [word.what for word in words if word.kind == "name"]
    goes = any(lookup.inclined(names, name) for name in who if name in lookup.moving(names))
    return [Word("verb", "fall") if word == back and goes else word for word in words]


def signs_between(words: list[Word]) -> list[Word]:
    """A sign stands between what it compares: that the tension 8 kN not exceeds, as German has it."""
    found = _undenied(words)
    for k in range(1, len(found)):
        ends = k + 1 == len(found) or found[k + 1].kind in ("mark", "preposition")
        is_bound = found[k - 1].kind == "value" or (
            k > 1
            and [word.kind for word in found[k - 2 : k]] == ["quantity", "name"]
            and any(word.kind == "mark" for word in found[:k])
        )  # that the side force F is not exceeded
        if found[k].kind == "relation" and is_bound and ends:
            found[k - 1], found[k] = found[k], found[k - 1]
    return found


def _undenied(words: list[Word]) -> list[Word]:
    """What does not exceed a value is at most that."""
    opposite = {">": "<=", "<": ">="}
    found: list[Word] = []
    for word in words:
        if word.kind == "relation" and word.what in opposite and found[-1:] == [Word("not", "not")]:
            found[-1] = Word("relation", opposite[word.what])
        else:
            found.append(word)
    return found


def bounded(words: list[Word]) -> list[Word]:
    """`F ist mindestens nötig` is the least F: at least, where no value follows, is the end of a range."""
    ends = {">=": Word("degree", "least"), "<=": Word("degree", "greatest")}
    alone = [
        word.kind == "relation"
        and word.what in ends
        and not any(w.kind in ("value", "name", "quantity") for w in words[k + 1 : k + 2])
        for k, word in enumerate(words)
    ]
    return [ends[word.what] if is_end else word for word, is_end in zip(words, alone, strict=True)]


def in_doing(words: list[Word]) -> list[Word]:
    """Beim Hochziehen, in falling: while it does so."""
    is_doing = len(words) > 2 and words[-2] == Word("preposition", "in") and words[-1].kind == "verb"
    if not is_doing or words[-1].what not in (*GOES_ON, "exert") or not any(w.kind == "quantity" for w in words):
        return words
    return [*words[:-2], Word("mark", "while"), words[-1]]


def sliding_in_slots(names: Names, words: list[Word]) -> list[Word]:
    """How fast a pin slides in its slot is its speed of sliding there."""
    cut = next((k for k, word in enumerate(words) if word.kind == "mark"), len(words))
    head = Clause(words[:cut])
    is_asked = head.all("quantity") in (["velocity"], ["speed"]) or (
        head.has("ask", "fast") and not head.has("quantity")
    )
    in_slot = any(name in joining.slots(names) for _, name in head.names)
    if not (is_asked and in_slot and set(head.all("verb")) == {"slide"}):
        return words
    kept = [word for word in head.words if word.kind not in ("ask", "quantity", "verb")]
    return [Word("quantity", "slip speed"), *kept, *words[cut:]]


def on_what_may_open(names: Names, words: list[Word]) -> list[Word]:
    """What remains on what it could leave stays on it: the follower on the cam, which no friction holds there."""
    hold, on = Word("verb", "hold"), Word("preposition", "on")
    of = [word.what for word in words if word.kind == "name" and word.what not in names.parameters]
    if (
        hold not in words
        or on not in words
        or len(of) != 2
        or any(w.kind == "quantity" and w.what in _PUSHES for w in words)
    ):
        return words
    joints = [name for name in names.connections if name in of or all(joining.touches(names, name, x) for x in of)]
    opens = [name for name in joints if joining.may_open(names, name) and name not in rubbing.rough(names, "")]
    if len(opens) != 1 or not all(x == opens[0] or joining.touches(names, opens[0], x) for x in of):
        return words
    return [Word("verb", "stay_on") if word == hold else word for word in words if word != on]


def _is_of(names: Names, word: Word, line: str) -> bool:
    """Whether a word names a line of the ground, or what touches it."""
    is_joint = word.what in names.connections and word.what not in names.bodies
    return word.what == line or (is_joint and joining.touches(names, word.what, line))


def lifting_off(names: Names, words: list[Word]) -> list[Word]:
    """At what speed a wheel lifts, and whether it does: it leaves the road on which it stands."""
    rise, slope = Word("verb", "rise"), joining.sloping(names)
    k = words.index(rise) + 1 if rise in words else 0
    along = [
        j for j in range(k, len(words)) if k and slope and words[j].kind == "name" and _is_of(names, words[j], slope)
    ]
    if along:  # up the slope, which it does not leave
        return [word for j, word in enumerate(words) if j not in along]
    of = [word.what for word in words if word.kind == "name"]
    stands = [name for name in (*of, *(joining.joined_at(names, name) for name in of)) if name in names.connections]
    is_whether = bool(of) and all(word.kind == "name" or word == rise for word in words)  # does the rear wheel lift
    is_still = rubbing.is_still(names)
    is_asked = (words[:1] == [Word("ask", "with")] and is_still and rise in words) or is_whether
    # for which load a support lifts: it no longer presses
    supports = [name for name in of if name in names.connections and name not in names.bodies]
    holds_still = lookup.rests(names) and not names.measures and not driving.driven(names)
    is_support = holds_still and words[:1] in ([Word("ask", "for")], [Word("ask", "from")]) and len(supports) == 1
    if not (is_support and rise in words) and not (is_asked and any(joining.may_open(names, name) for name in stands)):
        return words
    return [Word("verb", "leave") if word == rise else word for word in words]


def at_extremes(words: list[Word]) -> list[Word]:
    """At the greatest compression, beim grössten Ausschlag: when that is greatest."""
    for k in range(1, len(words) - 2):
        at, degree, of = words[k : k + 3]
        is_led = at == Word("preposition", "in") and degree.kind == "degree" and degree.what in ("greatest", "least")
        asked = [word for word in words[:k] if word.kind in ("quantity", "degree", "mark")]
        rest = words[k + 3 :]
        is_end = (
            all(word.kind in ("name", *SILENT) for word in rest) and len([w for w in rest if w.kind == "name"]) <= 1
        )
        if (
            is_led
            and of.kind == "quantity"
            and [word.kind for word in asked] == ["quantity"]
            and asked[0] != of
            and is_end
        ):
            is_sprung = of.what in (*lookup.STRETCHED, "deflection") and asked[0] == Word("quantity", "force")
            head = [Word("quantity", "spring force") if is_sprung and word == asked[0] else word for word in words[:k]]
            return [*head, Word("mark", "when"), degree, *words[k + 2 :]]
    return words


def far_from_origin(names: Names, words: list[Word]) -> list[Word]:
    """How far something is from the thing from which its place is measured: its position."""
    said = [word for word in words if word.kind != "filler"]
    if [word.kind for word in said[:4]] != ["ask", "name", "preposition", "name"] or said[0].what != "far":
        return words
    _, who, leads, other = said[:4]
    if leads.what != "from" or not along_lines.counted_from(names, who.what, other.what, ""):
        return words
    return [Word("quantity", "position"), Word("preposition", "of"), who, *said[4:]]
