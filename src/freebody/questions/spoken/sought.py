"""A parameter that is asked for by what it is, and not by its symbol: for what load is the force 25 kN, which stiffness
puts the lowest frequency at 2 Hz, what crank torque lifts the block 1 m in 4 s.

What stands between the question word and the verb names a parameter, or says what it is of (turning_round.py), or under
which key the file gives it. Put as its symbol it leaves a question that is read like any other one turned round. What
makes something so is told first as what is so: gives a ratio of 12, the ratio is 12; lifts the block, the block rises.
A quantity that is not read in its clause is read by itself, and set equal to the value. Patterns: `sought_...` in the
contexts of a language.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import cache
from typing import TYPE_CHECKING

from freebody.errors import UnitError
from freebody.language.expression import free_symbols
from freebody.language.units import FORCE, TORQUE
from freebody.language.units.reader import parse_unit
from freebody.questions.spoken import given, turning_round
from freebody.questions.spoken.composing import JOINT
from freebody.questions.spoken.compounds import in_english_nouns
from freebody.questions.spoken.keeping import is_pressed, moves_nowhere
from freebody.questions.spoken.lexicon import Word, contexts, languages
from freebody.questions.spoken.naming import elements_of, linked, plain_names
from freebody.questions.spoken.ways import ways_to_mean

if TYPE_CHECKING:
    from freebody.model.names import Names

_TURNED = re.compile(r"(?:value|range|least|largest|critical damping)(?: of)? (?P<parameter>[^\W\d]\w*)\b")
_NUMBER = re.compile(r"(?<![\w.])-?\d[\d.,]*(?:e[+-]?\d+)?")
_EVENT = re.compile(r"(?P<of>.+?)(?P<when> (?:at start|when .+|at t = .+|after .+|until .+))?")
_COUNTED = re.compile(r"(?:turns|change|distance travelled|energy lost|work|length of the path) (?:of|along) ")
_NO_QUANTITY = re.compile(r"^(?:does|is|whether|which|degrees|damping|stability) |\b(?:for which|so that|that keeps) ")
_EXTREME = re.compile(r" for which (?:(?! at start| when | until | after ).)+ is (?:largest|least)$")
_INITIAL = Word("part", "initial")
_UNIT_WORDS = 3  # of a unit that is written apart: 30 N m
_LONGEST = 8  # words for a parameter
_ARTICLES = ("a", "A", "I")  # which are words before they are symbols


@dataclass(frozen=True)
class Told:
    """A parameter, and in a language what is to be so with it, in words that ask for it by its symbol."""

    parameter: str
    language: str
    state: str
    how: str = "sought_plain"  # `sought_so` where what is to be so stands in a clause of its own
    has_it_later: bool = False  # what the words tell is the speed of a motion, which begins with the parameter

    @property
    def plain(self) -> str:
        return contexts(self.language)[self.how].format(name=self.parameter, state=self.state)


def sought(names: Names, text: str, said: Callable[[str], str]) -> Iterator[str]:
    """What a text can ask for in the words of the grammar, the likeliest first. said: the words of the grammar for a
    text, nothing where it has none."""
    for told in _told(names, text.strip(" ?.!")):
        if told.plain.lower() != text.strip(" ?.!").lower():
            turned = said(told.plain)
            if told.has_it_later and _EXTREME.search(turned):
                continue
            if turned and all(_asks_for(one, told.parameter) for one in turned.split(JOINT)):
                yield turned
                continue
        yield from _equal(names, told, said)


def _asks_for(words: str, parameter: str) -> bool:
    found = _TURNED.match(words)
    return found is not None and found["parameter"] == parameter


def _told(names: Names, text: str) -> Iterator[Told]:
    for language in languages():
        if "sought_for" not in contexts(language):
            continue
        for what, state in _parted(text, language):
            parameter = parameter_meant(names, what, language)
            if parameter is not None:
                later = _has_it_later(names, parameter, what, language)
                states = _states(names, state, language)
                yield from (Told(parameter, language, one, has_it_later=later) for one in states)
        if (found := _pattern(language, "sought_number").match(text)) is not None:
            counts = given.teeth(names, _body(names, found["of"]))
            if len(counts) == 1:
                yield Told(counts[0], language, found["state"], "sought_so")


def _has_it_later(names: Names, parameter: str, what: str, language: str) -> bool:
    """Whether words that name no parameter tell a speed, with which the motion only begins: at which angular velocity
    the power is greatest is no question about the start."""
    rates = [*names.start_rates.values(), *(v for body in names.bodies.values() for v in body.start.velocity or ())]
    is_begun = any(parameter in free_symbols(rate) for rate in rates)
    if not is_begun or re.search(rf"(?<!\w){re.escape(parameter)}(?!\w)", what):
        return False
    ways = ways_to_mean(names, contexts(language)["sought_what"].format(what=what))
    return not any(_INITIAL in meaning.words for meaning in ways)


def _parted(text: str, language: str) -> Iterator[tuple[str, str]]:
    """The words for a parameter, and the verb with all that follows, at each verb where they can part."""
    for key in ("sought_for", "sought_by"):
        asks = _pattern(language, key).match(text)
        if asks is None:
            continue
        rest = text[asks.end() :]
        for verb in _pattern(language, f"{key}_verb").finditer(rest):
            what = rest[: verb.start()].strip()
            if what and len(what.split()) <= _LONGEST:
                yield what, rest[verb.start() :].strip()


def _states(names: Names, state: str, language: str) -> Iterator[str]:
    """What is to be so, as it is said, or as what makes it so brings it about."""
    told = contexts(language)
    for rule, written in _rules(told["sought_caused"]):
        if (found := rule.fullmatch(state)) is not None:
            yield found.expand(written)
            return
    if (gives := _pattern(language, "sought_gives").match(state)) is not None:
        rest = state[gives.end() :]
        for begin, end in _values(names, rest):
            before = _pattern(language, "sought_of").sub("", rest[:begin]).strip()
            if before:
                yield told["sought_is"].format(what=before, value=rest[begin:end].strip(), when=rest[end:])
        return
    yield state


def _equal(names: Names, told: Told, said: Callable[[str], str]) -> Iterator[str]:
    """A quantity that is read by itself, and the value that it is to have."""
    begins = _pattern(told.language, "sought_does").match(told.state)
    state = told.state[begins.end() :] if begins is not None else ""
    for begin, end in _values(names, state):
        joined = _pattern(told.language, "sought_equals").search(state[:begin])
        what = state[: joined.start()] if joined is not None else state[:begin]
        when = state[end:].strip(" ,")
        is_whole = not re.search(r"[=<>*/^+]", what) and (not state[end:] or state[end] in " ,")
        if (
            not is_whole
            or not what.strip()
            or re.search(rf"(?<![\w.]){re.escape(told.parameter)}(?![\w.])", f"{what} {when}")
        ):
            continue
        read = said(f"{what.strip()} {when}".strip())
        each = [_EVENT.fullmatch(one) for one in read.split(JOINT) if not _NO_QUANTITY.search(one)] if read else []
        each = [one for one in each if one and (one["when"] or not _COUNTED.match(one["of"]))]  # until when is not said
        each = [one for one in each if one and (one["when"] or one["of"] not in names.measures)]  # a place that changes
        value = state[begin:end].strip()
        is_opposite = is_pressed(what) and read.startswith(("tension of ", "axial force of "))
        value = f"-{value}" if is_opposite and not value.startswith("-") else value
        if each:
            yield JOINT.join(
                f"value of {told.parameter} for which {one['of']} = {value}{one['when'] or ''}" for one in each if one
            )


def _values(names: Names, text: str) -> Iterator[tuple[int, int]]:
    """Where values stand in a text: numbers with their units, parameters, nothing."""
    for number in _NUMBER.finditer(text):
        end, read = number.end(), number.end()
        for word in re.finditer(r" ?(\S+)", text[end:][:40]):
            if len(text[end : end + word.end()].split()) > _UNIT_WORDS:
                break
            if _is_unit(text[end : end + word.end()].strip(" ,")):
                read = end + len(text[end : end + word.end()].rstrip(" ,"))
        yield number.start(), read
    for word in re.finditer(r"(?<![\w.])(?:zero|null|[^\W\d]\w*)(?![\w.])", text):
        if word[0] in ("zero", "null") or (word[0] in names.parameters and word[0] not in _ARTICLES):
            yield word.span()


def _is_unit(text: str) -> bool:
    try:
        parse_unit(text, with_rare=False)
    except (UnitError, ValueError):
        return False
    return True


def parameter_meant(names: Names, what: str, language: str) -> str | None:
    """The only parameter that words name, or say what it is of; None where they do not."""
    symbols = [word for word in re.findall(r"[^\W\d]\w*", what) if word in names.parameters]
    symbols = [one for one in symbols if one not in _ARTICLES or what.endswith(f" {one}") or what == one]
    if symbols:
        return symbols[0] if len({*symbols}) == 1 else None
    elements = elements_of(names)
    keyed = given.by_key(names, re.findall(r"[\w’'-]+", in_english_nouns(what, language, elements.taken).lower()))
    is_bare = len(what.split()) == 1  # what torque, of whatever it is
    if len(keyed) == 1 and not (is_bare and _has_rivals(names, keyed[0])):
        return keyed[0]
    for meaning in ways_to_mean(names, contexts(language)["sought_what"].format(what=what)):
        found = turning_round.parameter_of(names, list(meaning.words))
        is_own = len(found) == 1 and (not names.parameters[found[0]].is_angle or moves_nowhere(names))
        is_named = not is_bare and any(word.kind == "name" for word in meaning.words)
        if is_own and (is_named or not _has_rivals(names, found[0])):
            return found[0]  # an angle of what moves is its own
    if (toothed := _pattern(language, "sought_teeth").fullmatch(what)) is not None:
        counts = given.teeth(names, _body(names, toothed["of"] or ""))
        return counts[0] if len(counts) == 1 else None
    if _pattern(language, "sought_push").match(what) and len(forces := given.of_kind(names, "force")) == 1:
        return forces[0]  # the load at the tip, where nothing else is a force
    return None


def _body(names: Names, said: str) -> str:
    """The body that a word means, or the word."""
    elements = elements_of(names)
    told = {in_english_nouns(said, language, elements.taken) for language in languages()}
    marked = [plain_names(way.text) for words in told for way in linked(elements, words)]
    return next((name for name in marked if name in names.bodies), said)


def _has_rivals(names: Names, parameter: str) -> bool:
    """Whether another force, or torque, is given that may be meant as well, where nothing says whose it is."""
    own = names.parameters[parameter].dimension
    alike = [p.name for p in names.parameters.values() if p.form is None and p.dimension == own]
    return own in (FORCE, TORQUE) and len(alike) > 1


@cache
def _pattern(language: str, key: str) -> re.Pattern[str]:
    return re.compile(contexts(language)[key], re.IGNORECASE)


@cache
def _rules(table: str) -> tuple[tuple[re.Pattern[str], str], ...]:
    """Lines of a pattern and what is written for it."""
    lines = (line.split(" ==> ") for line in table.strip().splitlines())
    return tuple((re.compile(pattern.strip(), re.IGNORECASE), written.strip()) for pattern, written in lines)
