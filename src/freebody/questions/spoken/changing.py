"""What another value of a parameter makes of a quantity: by what factor does the period change if L is doubled.

What is altered, and how, stands in a clause of its own, or is the subject (doubling the mass); what is asked for is a
quantity that is read by itself. Patterns: `changes` in a file of its own (xx.comparing.toml).
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING

from freebody.questions.spoken import given
from freebody.questions.spoken.composing import JOINT
from freebody.questions.spoken.keeping import n_freedoms
from freebody.questions.spoken.lexicon import compared_in, comparing, languages
from freebody.questions.spoken.relating import NO_QUANTITY
from freebody.questions.spoken.sought import parameter_meant

if TYPE_CHECKING:
    from freebody.model.names import Names

_DOWN = {"factor": "reduction factor", "increase": "decrease", "relative increase": "relative decrease"}
_EXERTED = re.compile(r"force (?:in|of) (?P<load>\w+)")
_OF_STATE = re.compile(
    r"(?:(?:angular )?(?:speed|velocity)|height|position|(?:kinetic|potential|total) energy"
    r"|(?:linear|angular) momentum)(?: (?:of|along|about|relative to) [\w.]+)*"
)
_COUNT = re.compile(r"(?P<n>\d+(?:\.\d+)?) times", re.IGNORECASE)


@dataclass(frozen=True)
class _Altered:
    """A parameter, and the expression that it becomes."""

    parameter: str
    value: str


def changed_by(names: Names, text: str, said: Callable[[str], str]) -> str:
    """The grammar for a text that asks what another value of a parameter does to a quantity; nothing where it does not.
    said: the words of the grammar for a text."""
    text = text.strip(" ?.!")
    for language in languages():
        if not compared_in(language, "changes"):
            continue
        for question, altered in _parted(names, text, language):
            for kind, asked in _asked(question, language):
                read = said(asked)
                if read and not any(_is_no_answer(names, one) for one in read.split(JOINT)):
                    to = f"as {altered.parameter} -> {altered.value}"
                    return JOINT.join(f"{kind} of {one} {to}" for one in read.split(JOINT))
    return ""


def _is_no_answer(names: Names, words: str) -> bool:
    """Whether nothing follows from parameters there: what is chosen, or is given as it is, or is a place or a speed at
    no instant of a motion."""
    if n_freedoms(names) > 0 and (words in names.measures or _OF_STATE.fullmatch(words)):
        return True
    exerted = _EXERTED.fullmatch(words)
    loads = {given.load_of(names, name) for name in names.parameters} - {""}
    return bool(NO_QUANTITY.match(words)) or (exerted is not None and exerted["load"] in loads)


def _parted(names: Names, text: str, language: str) -> Iterator[tuple[str, _Altered]]:
    """What is asked, and what is altered, at each place where they can part."""
    for key in ("behind", "before"):
        if (found := _pattern(language, key).search(text)) is not None:
            question = f"{text[: found.start()]}{text[found.end() :]}".strip(" ,")
            if _is_of_motion(found, language):
                continue
            for k in range(len(compared_in(language, "changes")["clauses"])):
                clause = _pattern(language, "clauses", k).fullmatch(found["clause"])
                altered = None if clause is None else _altered(names, clause, language)
                if altered is not None:
                    yield question, altered
    found = _pattern(language, "with_multiple").search(text)
    if found is not None and (altered := _altered(names, found, language)) is not None:
        yield text[: found.start()], altered
    found = _pattern(language, "gerund").search(text)
    if found is not None and (altered := _altered(names, found, language)) is not None:
        yield f"{text[: found.start()]}{found['q']} {found['does']}", altered
    found = _pattern(language, "effect").match(text)
    if found is not None and (altered := _altered(names, found, language)) is not None:
        yield compared_in(language, "changes")["happens"].format(q=found["q"]), altered


def _is_of_motion(found: re.Match[str], language: str) -> bool:
    """Whether a clause says when, of what changes by itself: when the speed is halved."""
    is_when = _pattern(language, "tells_when").match(found[0]) is not None
    varies = _pattern(language, "varies").search(found["clause"]) is not None
    return is_when and varies and _pattern(language, "begins").search(found["clause"]) is None


def _altered(names: Names, found: re.Match[str], language: str) -> _Altered | None:
    """The only parameter that is meant, and what becomes of it."""
    said, told = found.groupdict(), compared_in(language, "changes")
    what = said["what"]
    if (adjective := (said.get("adjective") or "").lower()) in told["adjectives"]:
        what = told["of"].format(quantity=told["adjectives"][adjective], thing=what)
    parameter = parameter_meant(names, what, language)
    if parameter is None or (adjective and adjective not in (*told["adjectives"], *told["any"])):
        return None
    if times := said.get("times"):
        n = _COUNT.fullmatch(times)
        factor = told["times"].get(times.lower(), "") if n is None else n["n"]
        return _Altered(parameter, f"{factor}*{parameter}") if factor else None
    if factor := said.get("factor"):
        return _Altered(parameter, f"{factor}*{parameter}")
    for sign, key in ((1, "more"), (-1, "less")):
        if said.get(key):
            return _Altered(parameter, f"{1 + sign * float(said[key]) / 100:g}*{parameter}")
    return _Altered(parameter, said["value"]) if said.get("value") else None


def _asked(question: str, language: str) -> Iterator[tuple[str, str]]:
    """Which change is asked for, and of what, in words that ask for it alone."""
    told = compared_in(language, "changes")
    for k, (_, kind) in enumerate(told["asks"]):
        found = _pattern(language, "asks", k).match(question)
        if found is None:
            continue
        said = found.groupdict()
        more, less = (said.get("more") or "").lower(), (said.get("less") or "").lower()
        kind = _DOWN[kind] if less or said.get("down") else kind
        long = told["larger"].get(more) or told["smaller"].get(less)
        verb = said.get("verb")
        yield kind, told["how"].format(long=long, does=verb, q=said["q"]) if verb and long else said["q"]


def _pattern(language: str, key: str, k: int | None = None) -> re.Pattern[str]:
    return comparing(language, "changes", key, k)
