"""Several questions in one: velocity and acceleration of the piston, the tension on both sides, how far and how fast.

A text is parted at its conjunctions, and a part that is not complete takes what it lacks from the others: the first
ones the noun of the last (horizontal and vertical reaction at A), the later ones the quantity of the first
(acceleration of A and B). What is said of when behind the last part is meant of all that say nothing of it themselves.
Here are the texts that can be meant; which of them asks for something says whoever reads them.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

from freebody.questions.spoken import lookup, strings
from freebody.questions.spoken.compounds import in_english_nouns
from freebody.questions.spoken.elements import Elements
from freebody.questions.spoken.lexicon import (
    CLOSE,
    OPEN,
    Word,
    comparisons,
    contexts,
    counted_by,
    languages,
    pairs,
    phrases_at,
    rivals,
    several,
    translated,
)
from freebody.questions.spoken.naming import linked, plain_names
from freebody.questions.spoken.symbols import spelt_out
from freebody.questions.spoken.words import Unknown, words_of

if TYPE_CHECKING:
    from freebody.model.names import Names

MOST = 6  # questions in one
_BORROWED = 6  # words that a part may take from another
_GOES_ON = re.compile(r"\s*[+*/^=)]")  # what calculates with the part before it is no question of its own
_OF_IMPACT = tuple(Word("quantity", what) for what in ("energy lost", "kinetic energy lost", "impulse"))
_IN_IMPACT = (Word("instant", "in the impact"), Word("instant", "at the impact"))
_ALL = ("they", "them", "both", "two")  # two, where the model has no others
_IT = Word("pronoun", "it")
_PENDULUMS = ("pendulum", "pendulums", "pendula", "pendel")
_MASSES = ("mass", "masses", "weight", "weights", "body", "bodies", "block", "blocks")

_PAIR = 2


@dataclass(frozen=True)
class Part:
    """One question of several: the texts that can be meant by it, the likeliest first; and what is said of it where it
    is to be asked at the event of the first (how far does it get in this time)."""

    said: str
    texts: tuple[str, ...]
    there: str = ""


def parts(elements: Elements, text: str) -> Iterator[list[Part]]:
    """Ways in which a text can be several questions."""
    for language in languages():
        told = several(language, "lead_in").sub("", spelt_out(elements, text, language))
        for pieces in _pieces(told.strip().rstrip(".?! "), language):
            beside = any(_GOES_ON.match(piece) or _describes(piece) or _is_joined(piece) for piece in pieces)
            if beside or _kinds(elements, pieces[0], language) == {"instant"}:
                continue
            yield [_part(elements, pieces, k, language) for k in range(len(pieces))]


def sides_of(elements: Elements, text: str) -> tuple[str, str] | None:
    """What is compared where a text asks which of two is greater, or which of all of a kind, of which there are two."""
    for language in languages():
        both = plain_names(paired(elements, text, language))
        for pattern, first, second in comparisons(language):
            if found := pattern.match(both):
                return found.expand(first), found.expand(second)
    return None


def asks_again(text: str) -> bool:
    """Whether a text has a second question word behind a conjunction: what force holds it, and what force lifts it."""
    return any(several(language, "again").search(text) for language in languages())


def of_rivals(elements: Elements, text: str) -> str:
    """The text in which both are asked for, where it asks which of them is larger: their values tell."""
    if sides := sides_of(elements, text):
        return f"{sides[0]} and {sides[1]}"
    for language in languages():
        both = plain_names(paired(elements, text, language))  # which of the two is the first
        for pattern, written in rivals(language):
            text = pattern.sub(written, both if pattern.match(both) else text)
    return text


def _pieces(text: str, language: str) -> Iterator[list[str]]:
    """A text parted at all of its conjunctions, at the last one, and at the first one."""
    if any(_states(text, own) for own in languages()):
        return
    never = several(language, "never")
    cuts = [found for found in several(language, "and").finditer(text) if found.start() > 0]
    again = [cut for cut in cuts if _at_another_instant(text[: cut.start()], text[cut.end() :], language)]
    cuts = [
        cut
        for cut in cuts
        if cut in again
        or (_is_open(text[: cut.start()]) and _is_instant(text[cut.end() :], language))
        or (
            not never.search(text[: cut.start()])
            and (_is_open(text[: cut.start()]) or not _leads_on(text[cut.end() :]))
        )
    ]
    if any(_adds_to(text[: cut.start()], text[cut.end() :]) for cut in cuts):
        return
    if not cuts or len(cuts) >= MOST:
        return
    label = several(language, "label")
    for chosen in dict.fromkeys((tuple(cuts), tuple(cuts[-1:]), tuple(cuts[:1]))):
        begins, ends = [0, *(cut.end() for cut in chosen)], [*(cut.start() for cut in chosen), len(text)]
        found = [text[a:b].strip(" ,;.?!") for a, b in zip(begins, ends, strict=True)]
        said = [without for piece in found if (without := re.sub(rf"^{label.pattern}", "", piece))]
        yield [piece for piece in said if not _says_nothing(piece, language)]  # both, respectively


def _describes(text: str) -> bool:
    """Whether a text begins with a participle: measured from its lowest position."""
    return any(several(language, "beside").match(text) for language in languages())


def _is_joined(text: str) -> bool:
    """Whether a text begins with a conjunction: it has been parted by the commas of another language."""
    return any(several(language, "and").match(f" {text}") for language in languages())


def _says_nothing(text: str, language: str) -> bool:
    """Whether each word of a text is one of those that lead to a question only."""
    kinds = [{word.kind for word, _ in phrases_at(word, 0, language)} for word in text.lower().split()]
    return all(kind == {"filler"} for kind in kinds)


def _states(text: str, language: str) -> bool:
    """Whether a text begins with a sentence that asks for nothing: what it says is no question of several."""
    stated = re.match(contexts(language)["statement"], text, re.IGNORECASE)
    kinds = _may_be(stated["said"], language) if stated is not None else set[str]()
    return "verb" in kinds and not kinds & {"quantity", "ask"}


def _is_open(text: str) -> bool:
    """Whether something is to follow behind a text: just before, and after, the impact."""
    return re.search(r"\b(?:before|after|vor|nach)$", text, re.IGNORECASE) is not None


def _at_another_instant(before: str, after: str, language: str) -> bool:
    """Whether what stands behind a conjunction is another instant of the same quantity: at the start and at the end."""
    return (_is_instant(after, language) or _is_clause(after, language)) and _tail(before, language) != ""


def _is_clause(text: str, language: str) -> bool:
    """Whether a text is a clause of when, and no question: when x = 1 m; not, when does it stop."""
    return several(language, "clause").match(text) is not None


def _is_instant(text: str, language: str) -> bool:
    """Whether a text says of an instant, and nothing else."""
    words = text.lower().strip(" .?!").replace("ß", "ss").split()
    found = phrases_at(" ".join(words), 0, language) if words else []
    return any(word.kind == "instant" and len(places) == len(words) for word, places in found)


def _leads_on(text: str) -> bool:
    """Whether a text begins with what says when, or for which, in any language: no question of its own."""
    if re.match(r"\S+ ?[=<>]", text):  # when x = 1 m and y = 0
        return True
    return any(_kind_at(text.lower().split(), 0, language) in ("mark", "instant", "not") for language in languages())


def _adds_to(before: str, after: str) -> bool:
    """Whether what stands behind a conjunction is a second condition: when x = d, and the crank turns at 2 rad/s."""
    if any(_is_subordinate(before, after, language) for language in languages()):
        return True
    if re.search(r"\d", after) is None:
        return False
    plain = re.sub(r"\d\S*(?: [A-Za-z]+(?:/[A-Za-z]+)?(?![A-Za-z]))?", " ", after)  # without values and their units
    ways = [(_may_be(before, language), _may_be(plain, language)) for language in languages()]
    return any("mark" in first and "verb" in own and not own & {"ask", "mark", "degree"} for first, own in ways)


def _is_subordinate(before: str, after: str, language: str) -> bool:
    """Whether a subordinate clause goes on behind a conjunction, as the order of words tells: wenn x = 1 m ist und das
    Seil gerissen ist."""
    return several(language, "subordinate").match(after) is not None and "mark" in _may_be(before, language)


def _may_be(text: str, language: str) -> set[str]:
    """Kinds that the words of a text may be."""
    words, found = text.lower().split(), set[str]()
    for k in range(len(words)):
        found |= {
            word.kind for word, _ in phrases_at(" ".join(words), sum(len(word) + 1 for word in words[:k]), language)
        }
    return found


def _kind_at(words: Sequence[str], k: int, language: str) -> str:
    line = " ".join(words)
    start = sum(len(word) + 1 for word in words[:k])
    meant = phrases_at(line, start, language) if line else []
    return meant[0][0].kind if meant else ""


def _part(elements: Elements, pieces: list[str], k: int, language: str) -> Part:
    """One of several parts, with what it may lack."""
    own, first, last = pieces[k], pieces[0].split(), pieces[-1].split()
    kinds = _kinds(elements, own, language)
    is_asked, is_named = bool(kinds & {"quantity", "ask"}), "name" in kinds
    tail = "" if kinds & {"mark", "instant"} else _tail(pieces[-1], language)
    found: list[str] = []
    if k < len(pieces) - 1 and not _is_open(own) and _is_instant(pieces[-1], language):  # another instant than its own
        return Part(own, (own,))
    if _is_clause(pieces[-1], language) and (begun := _tail(pieces[0], language)):
        return Part(own, (f"{pieces[0].removesuffix(begun)}{own}" if _is_clause(own, language) else own,))
    if k < len(pieces) - 1 and is_asked and several(language, "quantities").search(own):
        # all tensions, and not those of what is named behind; at the instant at which that is
        found += [f"{own} {tail}", own] if tail else [own]
    if k < len(pieces) - 1 and (_is_open(own) or not (is_asked and is_named)):
        found += [f"{own} {' '.join(last[j:])}" for j in range(1, min(_BORROWED, len(last)))]
    if k > 0 and not is_asked:
        found += [f"{' '.join(first[:-j])} {own}" for j in range(1, min(_BORROWED, len(first)))]
        found += [f"{' '.join(first[:-j])} {own} {tail}" for j in range(1, min(_BORROWED, len(first))) if tail]
    if k < len(pieces) - 1 and tail:
        found.append(f"{own} {tail}")
    if is_asked or k == 0 or " " in own:  # x alone would be that measure
        found.append(own)
    there = several(language, "there").sub(" ", own)
    is_there = k > 0 and there != own
    return Part(own, () if is_there else tuple(dict.fromkeys(found)), " ".join(there.split()) if k > 0 else "")


def completed(elements: Elements, first: str, second: str, language: str) -> list[str]:
    """Texts that can be meant by the second of two sides, with what it may lack from the first: the tension at the top,
    and at the bottom; how fast is the left block, and the right one."""
    texts = list(_part(elements, [first, second], 1, language).texts)
    if (tail := _tail(first, language)) and _tail(f"x {second}", language):  # another instant in place of its own
        texts.insert(0, f"{first.removesuffix(tail).strip()} {second}")
    head, own = first.split(), re.sub(r"\s+ones?$", "", second)
    texts += [f"{own} {' '.join(head[k:])}" for k in range(1, len(head))]  # the second frequency, and the first
    texts += [f"{' '.join(head[:k])} {second}" for k in range(len(head), 0, -1)]
    return [*dict.fromkeys(texts)]


def _kinds(elements: Elements, text: str, language: str) -> set[str]:
    """Kinds of the words of a text, so far as they are known."""
    for way in linked(elements, in_english_nouns(text, language, elements.taken))[:1]:
        try:
            return {word.kind for word in words_of(way.text, language)}
        except Unknown as error:
            return {word.kind for word in error.known}
    return set()


def named_instead(names: Names, elements: Elements, text: str, first: str) -> str:
    """A text with the only body that moves of those which another names in place of it: and how fast is it then."""
    for language in languages():
        for way in linked(elements, in_english_nouns(first, language, elements.taken))[:1]:
            marked = {name for name in lookup.moving(names) if f"{OPEN}{name}{CLOSE}" in way.text}
            if len(marked) == 1:
                [name] = marked
                is_it = [any(w == _IT for w, _ in phrases_at(word.lower(), 0, language)) for word in text.split()]
                return " ".join(name if it else word for word, it in zip(text.split(), is_it, strict=True))
    return text


def of_owner(names: Names, elements: Elements, text: str, first: str) -> str:
    """A text in which its weight is the weight of the only body that moves of those which another names."""
    for language in languages():
        pattern = contexts(language).get("its")
        if pattern is None or (own := re.compile(pattern, re.IGNORECASE)).search(text) is None:
            continue
        for way in linked(elements, in_english_nouns(first, language, elements.taken))[:1]:
            marked = [name for name in lookup.moving(names) if f"{OPEN}{name}{CLOSE}" in way.text]
            if len(marked) == 1:
                return own.sub(rf"\g<what> {contexts(language)['of_whom']} {marked[0]}", text)
    return text


def multiple_of(text: str) -> tuple[str, str] | None:
    """The factor, and of what, where a text says a multiple of something: half the weight, 3 times the weight."""
    for language in languages():
        pattern = contexts(language).get("multiple")
        if pattern is not None and (found := re.match(pattern, text, re.IGNORECASE)) is not None:
            factors = dict(re.findall(r"(\S+)=(\S+)", contexts(language)["weight_factors"]))
            factor = found["count"] or factors.get((found["factor"] or "").lower(), "")
            return (factors.get(factor.lower(), factor), text[found.end() :]) if factor else None
    return None


def _tail(text: str, language: str) -> str:
    """What is said of when at the end of a text, where it is not what is asked."""
    words = text.lower().replace("ß", "ss").split()
    if any(_kind_at(words, k, language) == "ask" for k in range(min(2, len(words)))) and "long" in words[:2]:
        return ""
    for k in range(1, len(words)):
        line, start = " ".join(words), sum(len(word) + 1 for word in words[:k])
        meant = [word for word, _ in phrases_at(line, start, language)]
        is_time = any(w == Word("mark", what) for w in meant for what in ("when", "after"))
        if is_time or any(w.kind == "instant" for w in meant) or several(language, "place").match(line, start):
            asked = [w for j in range(k) for w, _ in _first_at(words, j, language) if w.kind == "quantity"]
            is_own = Word("quantity", "time") in asked  # what is lost in an impact has no other instant
            is_own |= any(w in _OF_IMPACT for w in asked) and any(w in _IN_IMPACT for w in meant)
            return "" if is_own else " ".join(text.split()[k:])
    return ""


def _first_at(words: Sequence[str], k: int, language: str) -> list[tuple[Word, tuple[int, ...]]]:
    return phrases_at(" ".join(words), sum(len(word) + 1 for word in words[:k]), language)[:1]


# -- one phrase for several things ------------------------------------------------------------
def each_of(names: Names, elements: Elements, text: str) -> list[str]:
    """The questions that a text with `both sides`, `all three masses` stands for; none where there is no such phrase or
    the model has not so many."""
    for language in languages():
        told = in_english_nouns(text, language, elements.taken)
        if (sides := several(language, "sides").search(told)) is not None:
            rest = " ".join((told[: sides.start()] + told[sides.end() :]).split())
            return [f"{rest.rstrip('.?! ')} {end}" for end in _ends(names, rest)]
        if (found := several(language, "things").search(told)) is None:
            every = several(language, "every").fullmatch(told.rstrip("?.! "))
            things = _things(elements, every["thing"].lower(), language) if every is not None else []
            if every is not None and len(things) > 1:
                return [f"{told[: every.start('all')]}{thing}{told[every.end('all') :]}" for thing in things]
            continue
        n = counted_by(language).get((found["number"] or found["count"]).lower(), 0)
        things = _things(elements, found["thing"].lower(), language) or _massive(elements, found["thing"].lower())
        if len(things) > 1 and n in (0, len(things)):
            return [f"{told[: found.start()]}{thing}{told[found.end() :]}" for thing in things]
    return []


def paired(elements: Elements, text: str, language: str) -> str:
    """The text with the names of two bodies for what stands for both: between the blocks, both blocks move together."""
    for pattern, written in pairs(language):
        if (found := pattern.search(text)) is not None:
            said = found["thing"].lower()
            one = re.sub(rf"{several(language, 'plural').pattern}$", "", said)
            known = (translated(language).get(word, "").split("|") for word in (said, one))
            words = (said, f"{said}s", *(word for some in known for word in some))  # which wire, which of the wires
            each = (_things(elements, word, language) for word in words)
            if things := next((two for two in each if len(two) == _PAIR), None):
                told = written.format(*(f"{OPEN}{thing}{CLOSE}" for thing in things), **found.groupdict())
                return f"{text[: found.start()]}{told}{text[found.end() :]}"
    return text


def _ends(names: Names, text: str) -> list[str]:
    """What the parts of the only string, or of the one that a text names, run between."""
    pulling = list(dict.fromkeys(row.connection for row in names.constraint_rows if row.reaction == "tension"))
    named = [name for name in pulling if re.search(rf"\b{re.escape(name)}\b", text)] or pulling
    return strings.spans(names, named[0]) if len(named) == 1 else []


def _massive(elements: Elements, word: str) -> list[str]:
    """All bodies with mass, for words that stand for any of them: both pendulums, where each is called otherwise."""
    is_any = word.removeprefix("the ").removeprefix("two ") in (*_MASSES, *_PENDULUMS)
    return [name for name in elements.bodies if elements.masses.get(name, 0.0) > 0.0] if is_any else []


def _things(elements: Elements, word: str, language: str) -> list[str]:
    """All bodies, or else all connections, that a word for a kind of thing means."""
    word = "bodies" if word in _ALL else word.removeprefix("the ").removeprefix("two ")
    singular = {word, re.sub(rf"{several(language, 'plural').pattern}$", "", word), word.removesuffix("s")}
    singular |= {"body"} if word == "bodies" else set()
    found = [e.name for e in elements.exact.values() if "." not in e.name and not singular.isdisjoint(e.words)]
    if word in _MASSES:
        found = [name for name in found if elements.masses.get(name, 0.0) > 0.0 and name not in elements.radii]
    bodies = [name for name in found if name in elements.bodies]
    return bodies or found
