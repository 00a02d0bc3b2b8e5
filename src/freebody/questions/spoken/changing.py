"""What another value of a parameter makes of a quantity: by what factor does the period change if L is doubled.

What is altered, and how, stands in a clause of its own, or is the subject (doubling the mass); what is asked for is a
quantity that is read by itself. Patterns: `changes` in a file of its own (xx.comparing.toml).
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from fractions import Fraction
from typing import TYPE_CHECKING

from freebody.language.sentences import Message
from freebody.questions.spoken import given, lookup
from freebody.questions.spoken.composing import JOINT
from freebody.questions.spoken.keeping import n_freedoms
from freebody.questions.spoken.lexicon import compared_in, comparing, languages
from freebody.questions.spoken.naming import elements_of
from freebody.questions.spoken.relating import NO_QUANTITY
from freebody.questions.spoken.sought import parameter_meant
from freebody.questions.spoken.unchosen import meant_by

if TYPE_CHECKING:
    from freebody.model.names import Names

_DOWN = {"factor": "reduction factor", "increase": "decrease", "relative increase": "relative decrease"}
_EXERTED = re.compile(r"force (?:in|of) (?P<load>\w+)")
_OF_STATE = re.compile(
    r"(?:(?:angular )?(?:speed|velocity)|height|position|(?:kinetic|potential|total) energy"
    r"|(?:linear|angular) momentum)(?: (?:of|along|about|relative to) [\w.]+)*"
)
_PAIR = 2
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
        plain = _pattern(language, "unchanged").sub("", text)
        for question, altered in _parted(names, plain, language):
            for kind, asked in _asked(question, language):
                read = said(asked)
                if read and not any(_is_no_answer(names, one) for one in read.split(JOINT)):
                    to = f"as {altered.parameter} -> {altered.value}"
                    return JOINT.join(f"{kind} of {one} {to}" for one in read.split(JOINT))
    return ""


def changed_together(names: Names, text: str) -> Message | None:
    """What is said of a text that changes several parameters at once: both masses are doubled."""
    text = text.strip(" ?.!")
    for language in languages():
        if not compared_in(language, "changes"):
            continue
        for key in ("behind", "before"):
            found = _pattern(language, key).search(text)
            if found is None or _is_of_motion(found, language):
                continue
            for k in range(len(compared_in(language, "changes")["clauses"])):
                clause = _pattern(language, "clauses", k).fullmatch(found["clause"])
                each = [] if clause is None else _all_meant(names, clause["what"], language)
                told = [] if clause is None else [_as_altered(one, clause, language) for one in each]
                if len(told) > 1 and None not in told:
                    question = f"{text[: found.start()]}{text[found.end() :]}".strip(" ,")
                    asked = next((one for _kind, one in _asked(question, language)), question)
                    return Message(
                        "{parameters} change at once: ask for {quantity}, and for it again with {settings}",
                        parameters=", ".join(each),
                        quantity=asked,
                        settings=" ".join(f"--set '{one.parameter}={_number(names, one)}'" for one in told if one),
                    )
    return None


def _all_meant(names: Names, what: str, language: str) -> list[str]:
    """The parameters of which something is said together: m1 and m2, both masses, the stiffness of all springs."""
    symbols = [word for word in re.findall(r"[^\W\d]\w*", what) if word in names.parameters]
    if len({*symbols}) > 1:
        return [*dict.fromkeys(symbols)]
    found = _pattern(language, "all_of").match(what)
    if found is None:
        return []
    said = (found["things"] or found["kind"]).lower()
    kinds = meant_by(said, language) or meant_by(re.sub("(?:es|s)$", "", said), language)
    if kinds == {"mass"}:
        return _masses(names, is_pair=found["two"] is not None)
    return [
        *dict.fromkeys(one for kind in kinds for one in given.parameters(names, kind, "") or given.of_kind(names, kind))
    ]


def _masses(names: Names, *, is_pair: bool) -> list[str]:
    """The masses of all bodies; of those that are no wheels or pulleys, where two of several are meant."""
    each = {body: given.parameters(names, "mass", body) for body in lookup.moving(names)}
    told = {body: own[0] for body, own in each.items() if len(own) == 1}
    if is_pair and len({*told.values()}) > _PAIR:
        told = {body: own for body, own in told.items() if body not in elements_of(names).radii}
    found = [*dict.fromkeys(told.values())]
    return [] if is_pair and len(told) != _PAIR else found


def _number(names: Names, altered: _Altered) -> str:
    """The other value of a parameter, with its unit, where the file gives one; else how it is calculated."""
    parameter = names.parameters[altered.parameter]
    factor = re.fullmatch(r"(?P<factor>[\d./]+)\*\w+", altered.value)
    if factor is None or parameter.value is None:
        return altered.value
    unit = "rad" if parameter.is_angle else re.sub("^1$", "", str(parameter.dimension))
    return f"{float(Fraction(factor['factor']) * Fraction(parameter.value)):g} {unit}".strip()


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
    each = _all_meant(names, what, language)
    parameter = parameter_meant(names, what, language) or (each[0] if len(each) == 1 else None)
    if parameter is None or (adjective and adjective not in (*told["adjectives"], *told["any"])):
        return None
    return _as_altered(parameter, found, language)


def _as_altered(parameter: str, found: re.Match[str], language: str) -> _Altered | None:
    """What a clause makes of a parameter."""
    said, told = found.groupdict(), compared_in(language, "changes")
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
