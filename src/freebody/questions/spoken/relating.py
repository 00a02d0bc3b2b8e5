"""Two quantities in one question: how many times larger is the tension at the top than at the bottom, how much slower
is the block when it comes back, the tension as a fraction of the weight.

Each side is a question of its own. The second one takes from the first what it lacks (several.py); smaller is larger
the other way round. Patterns: `relations` in a file of its own (xx.comparing.toml).
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from typing import TYPE_CHECKING

from freebody.questions.spoken.composing import JOINT
from freebody.questions.spoken.lexicon import compared_in, comparing, languages
from freebody.questions.spoken.naming import elements_of
from freebody.questions.spoken.several import completed

if TYPE_CHECKING:
    from freebody.language.units import Dimension
    from freebody.model.names import Names

_SIGNS = {"ratio": "/", "difference": "-", "relative": "relative"}
NO_QUANTITY = re.compile(r"^(?:does|is|whether|which|when|degrees|conserved|stability|value|range) ")
_IS_RATIO = re.compile(r"/|\b(?:ratio|factor|decrement|efficiency|advantage|transmissibility|coefficient|share)\b")
_BEARING = re.compile(r"vertical reaction of (?P<of>\w+)")
_WHEN = re.compile(r" (?:when .+|at start)$")
_TIMED = re.compile(r" (?:when|until|at|before|after|in the) |[-+*/]")
_VECTOR = re.compile(r"^(?:(?:impulsive )?reaction of|force of \w+ on|impulse of) ")
_OF_BODY = re.compile(r"^(?:acceleration|velocity|linear momentum) of (?P<body>\w+)(?![\w.]| along| relative)")
_WEIGHT = re.compile(r"^size of force of \w+ on (?P<body>\w+)$")  # the same all the time


def related(
    names: Names, text: str, said: Callable[[str], str], unit: Callable[[str], Dimension | None]
) -> Iterator[str]:
    """What a text that compares two quantities can ask for in the words of the grammar, the likeliest first. said: the
    words of the grammar for a text; unit: in what it is measured that they ask for. Both sides are so in the same."""
    text = text.strip(" ?.!")
    for language in languages():
        told = compared_in(language, "relations")
        for k, (_, how, *sides) in enumerate(told.get("asks", ())):
            found = comparing(language, "relations", "asks", k).match(text)
            if found is None:
                continue
            said_so = [(sides[0].format(**found.groupdict()), [sides[1].format(**found.groupdict())])] if sides else []
            for one, others in said_so or _sides(names, found, language):
                first = _one(names, said(one))
                if _is_of_no_blow(names, found, first):
                    continue
                if "bearer" in found.groupdict() and _is_of_surface(names, first):
                    continue
                each = (_one(names, said(other)) for other in others) if first else ()
                alike = (read for read in each if read not in ("", first) and unit(read) == unit(first))
                second = next(alike, "")
                weight = _WEIGHT.match(second)
                if "bearer" in found.groupdict() and weight is not None:
                    first = f"{first} on {weight['body']}"
                if first and second:
                    is_less = bool(found.groupdict().get("less"))
                    yield from _joined(_SIGNS[how], first, second, is_less=is_less)


def _is_of_no_blow(names: Names, found: re.Match[str], first: str) -> bool:
    """Whether a side is lost in an impact of which the text does not say, and there is none."""
    may_strike = any(row.unilateral for row in names.constraint_rows) or names.struck_at_start or names.struck_when
    return first.endswith("in the impact") and found.groupdict().get("blow", "said") is None and not may_strike


def loses_share(text: str, words: str) -> bool:
    """Whether a text asks for one quantity over another, and words for no ratio."""
    if _IS_RATIO.search(words):
        return False
    text = text.strip(" ?.!")
    for language in languages():
        for k, (_, how, *_sides_said) in enumerate(compared_in(language, "relations").get("asks", ())):
            if how == "ratio" and comparing(language, "relations", "asks", k).match(text) is not None:
                return True
    return False


def _sides(names: Names, found: re.Match[str], language: str) -> Iterator[tuple[str, list[str]]]:
    """Texts for the first side, and for each of them those for the second one."""
    told, said = compared_in(language, "relations"), found.groupdict()
    more, less = (said.get("more") or "").lower(), (said.get("less") or "").lower()
    adjective = told["larger"].get(more) or told["smaller"].get(less) or ""
    ones = [said["a"]]
    if said.get("does"):
        ones = [told["how"].format(adjective=adjective, does=said["does"], a=said["a"])]
    elif adjective not in ("", "large"):  # how much slower is the block
        ones = [told["is_so"].format(adjective=adjective, a=said["a"]), said["a"]]
    for one in ones:
        other = _plain(said["b"], one, language)
        texts = completed(elements_of(names), one, other, language)
        if said.get("does"):  # how long does the way down take, and the way up
            words = said["a"].split()
            kept = (" ".join([other, *words[-k:]]) for k in (1, 2) if len(words) > k)
            texts = [*(told["how"].format(adjective=adjective, does=said["does"], a=a) for a in kept), *texts]
        yield one, [other, *texts]


def _plain(other: str, one: str, language: str) -> str:
    """The second side without what only says that it is of the same thing: that at B, than it was at the start."""
    that = comparing(language, "relations", "that").sub("", other)
    return comparing(language, "relations", "same").sub("", that) if that == other else that


def _one(names: Names, read: str) -> str:
    """A side that is one quantity; what is a vector by its size, with which one calculates."""
    return "" if not read or JOINT in read or NO_QUANTITY.match(read) else as_number(names, read)


def as_number(names: Names, read: str) -> str:
    """A quantity in the words of the grammar; what is a vector by its size."""
    of_body = _OF_BODY.match(read)
    is_vector = _VECTOR.match(read) is not None or (of_body is not None and of_body["body"] in names.bodies)
    return f"size of {read}" if is_vector and " along " not in read else read


def _is_of_surface(names: Names, read: str) -> bool:
    """Whether a force is that of a surface, on which a body slides: it bears no share of the weight that stays."""
    found = _BEARING.match(read)
    return found is None or bool({"contact", "slider"} & {*names.called.get(found["of"], ())})


def _joined(sign: str, first: str, second: str, *, is_less: bool) -> Iterator[str]:
    if sign == "relative":  # by what fraction a is larger than b, or smaller: of b
        more, less = (second, first) if is_less else (first, second)
        yield f"(({more}) - ({less})) / ({second})"
        return
    if is_less:
        first, second = second, first
    there = _WHEN.search(second)
    if there is not None and not _TIMED.search(first) and not _TIMED.search(second[: there.start()]):
        second = second[: there.start()]  # the instant that is said last is that of both
        if first == second:
            return
        yield f"ratio of {first} to {second}{there[0]}" if sign == "/" else f"({first} - {second}){there[0]}"
        return
    if not _TIMED.search(f"{first} {second}"):
        yield f"ratio of {first} to {second}" if sign == "/" else f"{first} - {second}"
        return
    yield f"({first}) {sign} ({second})"
    starts = [f"{side} at start" if _WEIGHT.match(side) else side for side in (first, second)]
    if starts != [first, second]:
        yield f"({starts[0]}) {sign} ({starts[1]})"
