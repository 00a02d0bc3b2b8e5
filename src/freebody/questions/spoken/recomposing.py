"""Parts of a question recognised each by itself, whatever their order, where no other reading has taken all of them.

    part                        as people put it                                what becomes of it
    time since the start        2 s after release, 1.5 s after the jump         a clause: after 2 s
    two of a kind               A compared with B, by what factor is A larger   the ratio of both
    what drives until           how long must the torque act until              the time until then
    instant that leads          at the top, how hard does it press             behind what is asked
    just about                  when the cord just becomes taut                 nothing: the instant says it
    change of a quantity        by how much does it drop until                  what it is then, less what it was
    limit of a parameter        as m becomes very large, if friction vanishes   a limit
    quantity, owner, instant    in any order, with verbs that only say that     of the quantity alone
                                something moves or acts

Each part is used once; a word that is part of nothing leaves the question unread.
"""

from __future__ import annotations

from itertools import pairwise
from typing import TYPE_CHECKING

from freebody.questions.spoken import dimensions, given, lookup
from freebody.questions.spoken.asking import quantities
from freebody.questions.spoken.composing import SILENT, Groups
from freebody.questions.spoken.counting import ends
from freebody.questions.spoken.events import GOES_ON, HAPPENS, conditions
from freebody.questions.spoken.instants import timed
from freebody.questions.spoken.lexicon import Word
from freebody.questions.spoken.sentence import Sentence, parted
from freebody.questions.spoken.words import Clause

if TYPE_CHECKING:
    from collections.abc import Callable

    from freebody.model.names import Names

_AFTER, _WHEN, _UNTIL = Word("mark", "after"), Word("mark", "when"), Word("mark", "until")
_AT_START, _ONLY, _TO = Word("instant", "at start"), Word("part", "only"), Word("preposition", "to")
_RATIO = Word("quantity", "ratio")
_TELLS_WHEN = ("when", "until", "after", "while")  # what leads clauses: others say of a choice what is to be so
_LETS_GO = {"start", "exert", "leave", "fall"}  # it is released, thrown, jumps: what begins the motion
_LIGHT = {*GOES_ON, "exert", "act", "carry", "reach", "become"}  # verbs of what something does all the time
_CHANGES = {"fall", "rise", "grow", "shrink", "change", "accelerate", "lost"}
_BY = ("with", "much", "far", "large")  # question words: by how much
_NO_CHANGE = ("distance", "displacement", "distance travelled", "angle", "turns", "time", "energy lost", "change")
_COMPARED = Word("verb", "compare")
_LIMITS = {"vanish": "0", "infinite": "oo"}


def recomposed(names: Names, words: list[Word], again: Callable[[Names, list[Word]], Groups]) -> Groups:
    """What words, without fillers, ask for with their parts in the order of the grammar. again: what words in that
    order ask for."""
    put = _without_just(_elapsed(names, _compared(_led_by_instant(words))))
    if put != words:
        yield from again(names, put)
    sentence = parted(put)
    if sentence is None or any(mark not in _TELLS_WHEN for mark, _ in sentence.others):
        return
    yield from _driven(names, sentence)
    yield from _changed(names, sentence)
    yield from _tending(names, sentence)
    yield from _in_any_order(names, sentence, again)


def _led_by_instant(words: list[Word]) -> list[Word]:
    """At the top, how hard does it press: the instant stands behind what is asked."""
    is_led = words[1:2] == [Word("preposition", ",")] and words[0].kind == "instant"
    return [*words[2:], words[0]] if is_led else words


def _elapsed(names: Names, words: list[Word]) -> list[Word]:
    """2 s after release is after 2 s: a time before what begins the motion, where nothing else can be meant by it."""
    for k, word in enumerate(words):
        if word.kind != "value" or not dimensions.is_time(word.what) or (k and words[k - 1] == _AFTER):
            continue
        begin = k - (k > 0 and words[k - 1].kind == "preposition")
        if words[k + 1 : k + 2] == [_AT_START]:
            return [*words[:begin], *words[k + 2 :], _AFTER, word]
        if words[k + 1 : k + 2] == [_AFTER]:
            ends_at = (j for j in range(k + 2, len(words)) if words[j].kind in ("mark", "ask", "quantity"))
            end = next(ends_at, len(words))
            event = Clause(words[k + 2 : end])
            lost = any(row.unilateral for row in names.constraint_rows)
            begins = set(event.all("verb")) <= _LETS_GO - ({"leave", "fall"} if lost else set())
            if event.has("verb") and begins and event.only("verb", "pronoun", "name") and _are_moving(names, event):
                return [*words[:begin], *words[end:], _AFTER, word]
    return words


def _are_moving(names: Names, clause: Clause) -> bool:
    return all(name in lookup.moving(names) for _, name in clause.names)


def _compared(words: list[Word]) -> list[Word]:
    """How does A compare with B, by what factor is A larger than B: the ratio of A to B."""
    signs = [k for k, word in enumerate(words) if word == _COMPARED or word.kind == "relation"]
    is_ratio = _COMPARED in words or _RATIO in words
    if len(signs) != 1 or not is_ratio or any(word.kind in ("value", "mark") for word in words):
        return words
    [k] = signs
    if words[k].kind == "relation" and words[k].what not in (">", "<", "="):
        return words
    plain = not any(w.kind == "quantity" and w != _RATIO for w in words)
    turns = plain and {Word("ask", "fast"), Word("verb", "turn")} <= {*words[:k]}
    goes = plain and not turns and _RATIO in words and any(w.kind == "verb" and w.what in GOES_ON for w in words[:k])
    kind = "angular velocity" if turns or Word("verb", "turn") in words else "speed"
    own = [Word("quantity", kind)] if turns or goes else []  # how fast does A turn, compared with B
    head = [*own, *(w for w in words[:k] if w.kind not in ("ask", *(["verb"] if own else [])) and w != _RATIO)]
    tail = [w for w in words[k + 1 :] if w != _RATIO]
    while tail and tail[0].kind == "preposition":
        tail = tail[1:]
    if not head or not tail or not any(w.kind == "quantity" for w in head):
        return words
    head = head[1:] if head[0].kind == "preposition" else head
    tail = [*own, *tail]
    first, second = (tail, head) if words[k].what == "<" else (head, tail)
    if not any(w.kind == "quantity" for w in first):
        return words
    if goes and len(first) == len(second) == 2 and kind == "speed":  # as of what moves together
        return [Word("quantity", "gear ratio"), Word("preposition", "of"), first[1], _TO, second[1]]
    return [_RATIO, Word("preposition", "of"), *first, _TO, *second]


def _without_just(words: list[Word]) -> list[Word]:
    """Just, where something comes: it comes at one instant anyway."""
    comes = any(word.kind == "verb" and word.what in HAPPENS for word in words)
    return [word for word in words if word != _ONLY] if comes and _ONLY in words else words


def _driven(names: Names, sentence: Sentence) -> Groups:
    """How long must the torque act until: the time until then, where that is all that drives."""
    main = sentence.main
    is_until = len(sentence.others) == 1 and sentence.others[0][0] in ("until", "when")
    if not is_until or not main.has("ask", "long", "soon"):
        return
    pushes = [name for kind in ("force", "torque") for name in given.chosen(names, given.KIND_OF[kind], [])]
    of = [name for _, name in main.names]
    acts = set(main.all("verb")) <= {"exert", "act", *GOES_ON}
    acts &= set(main.all("quantity")) <= {"force", "torque", "moment"}
    is_all = all(name in pushes or name in names.loads for name in of) and len(pushes) <= 1
    if acts and is_all and main.has("verb") and main.only("ask", "verb", "quantity", "name", *SILENT):
        for group in conditions(names, sentence.others[0][1]):
            yield [f"time when {condition}" for condition in group]


def _changed(names: Names, sentence: Sentence) -> Groups:
    """By how much a quantity drops until something: what it is then, less what it was at the start."""
    main = sentence.main
    asked, verbs = main.all("quantity"), set(main.all("verb"))
    is_change = len(asked) == 2 and "change" in asked and not verbs
    is_change &= main.has("ask", *_BY) or any(mark == "until" for mark, _ in sentence.others)
    asked = [quantity for quantity in asked if quantity != "change"]
    is_change |= len(asked) == 1 and main.has("ask", *_BY) and bool(verbs) and verbs <= _CHANGES
    if not is_change or {*asked[-1:]} & {*_NO_CHANGE} or main.has("degree"):
        return
    goes = asked[:1] in (["velocity"], ["speed"], ["acceleration"]) and bool(verbs & {"rise", "fall"})
    if goes and main.has("ask", "with"):  # with what velocity does the load rise
        return
    values = [word for word in main.words if word.kind == "value"]
    kept = main.without("ask").without("verb").without("quantity", "change").without("value")
    while kept.words and kept.words[-1].kind == "preposition":
        kept = Clause(kept.words[:-1])
    falls = bool(verbs & {"fall", "shrink", "lost"}) and not verbs & {"rise", "grow"}
    found = [one for group in ends(names, sentence) for one in group]
    if len(values) == 1 and not sentence.others and dimensions.is_time(values[0].what):
        found = [f"t = {values[0].what}"]
    if not found or len(values) > 1:
        return
    for group in quantities(names, kept):
        plain = [text for text in group if not text.startswith(("greatest", "least", "change"))]
        if falls:
            yield [f"{text} at start - {text} when {end}" for text in plain for end in found]
        else:
            yield [f"{text} when {end} - {text} at start" for text in plain for end in found]


def _tending(names: Names, sentence: Sentence) -> Groups:
    """A quantity for a parameter that becomes very large, or vanishes: its limit."""
    if len(sentence.others) != 1:
        return
    [(mark, clause)] = sentence.others
    verbs = clause.all("verb")
    parameters = [name for _, name in clause.names if name in names.parameters]
    plain = clause.only("verb", "name", *SILENT) and len(clause.names) == len(parameters) == 1
    if mark not in ("when", "while") or len(verbs) != 1 or verbs[0] not in _LIMITS or not plain:
        return
    main = sentence.main.without("verb", "move", "exert", "act")
    for group in quantities(names, main):
        yield [f"{text} as {parameters[0]} -> {_LIMITS[verbs[0]]}" for text in group]


def _owner(main: Clause) -> list[Word]:
    """The name just before the quantity, where another one follows before the verb."""
    k = next(k for k, word in enumerate(main.words) if word.kind == "quantity")
    leads = [word for word in main.words[max(k - 1, 0) : k] if word.kind == "name"]
    behind = [word.kind for word in main.words[k + 1 :] if word.kind in ("name", "verb")]
    return leads if behind[:2] == ["name", "verb"] else []


def _in_any_order(names: Names, sentence: Sentence, again: Callable[[Names, list[Word]], Groups]) -> Groups:
    """One quantity with its owner and its instant, without verbs that say no more than that something moves or acts."""
    main, others = sentence.main, sentence.others
    asked, verbs = main.all("quantity"), main.all("verb")
    known = ("ask", "quantity", "name", "verb", "instant", "part", *SILENT)
    if len(asked) != 1 or asked == ["rate"] or not main.only(*known):
        return
    if main.words[0].kind == "preposition" or main.has("preposition", "between"):
        return  # between which angles: no single value
    if any(one.kind == "preposition" and other.kind == "verb" for one, other in pairwise(main.words)):
        return  # relative to the lower one: a thing, and nothing that is done
    if set(main.all("ask")) - {"what", "with", "large", "much", "for"} or (len(verbs) > 1 and others):
        return
    if main.all("instant") == ["in steady motion"]:  # at which angle does it stay then
        main, verbs = main.without("verb", "hold"), [verb for verb in verbs if verb != "hold"]
    comes = [verb for verb in verbs if verb in HAPPENS and verb not in (*_LIGHT, "vanish")]
    if set(verbs) - _LIGHT - {*comes} or len(comes) > 1 or (comes and (others or main.has("instant"))):
        return
    of = [word for word in main.words if word.kind == "name"]
    if comes:
        owner = _owner(main)  # at what spring extension does the block begin to slip
        doing = [Word("verb", verb) for verb in verbs if owner or verb == comes[0]]
        who = of[1:2] if owner else of[:1]
        event = Clause([*who, *doing, *(w for w in of if w not in (*who, *owner))])
        main, others = Clause([Word("quantity", asked[0]), *(owner or who)]), (("when", event),)
        if owner:
            yield from again(names, [main.words[0], Word("preposition", "of"), *owner, _WHEN, *event.words])
            return
        if main.has("part"):
            return
    else:
        kept = [word for word in main.words if word.kind not in ("ask", "verb", "quantity")]
        main = Clause([Word("quantity", asked[0]), *kept])
    if Sentence(main, others) != sentence:
        yield from timed(names, Sentence(main, others))
