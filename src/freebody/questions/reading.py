"""Reading questions: what is asked in the words of the grammar or in others, and the options to choose from.
`QUANTITY as a function of MEASURE` is asked of any place, `QUANTITY as a function of t` of any instant,
and what a rod transmits as a function of a name that is none, as `x`, of any of its sections.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from typing import Any, cast

from freebody.language.plain_text import plain
from freebody.language.sentences import Message
from freebody.language.units import DIMENSIONLESS
from freebody.model.names import Names
from freebody.model.noting import did_you_mean
from freebody.model.phrases import phrase_text
from freebody.questions.along_rods import SectionsOfRod, is_free
from freebody.questions.base import Quantity
from freebody.questions.course import Counted, Transition, as_condition
from freebody.questions.event import AnyInstant, AnyPlace, Anywhere, AskedEvent
from freebody.questions.grammar import read_phrase
from freebody.questions.greatest_section import GreatestInRod
from freebody.questions.reading_when import Meant, beside_a_stop

_ANYWHERE = "12.345"  # no place that means anything in a model
_AT_TIME = re.compile(r"\b(?P<of>[^\W\d]\w*) ?\((?:t ?= ?)?(?P<time>\d[\d.]* ?(?:ms|s|min|h))\)")  # x(2 s)
_AS_FUNCTION = re.compile(r"(?P<what>.+?) as a function of (?P<of>\w+)")
KEYS_OF_QUESTIONS = ("find", "id", "when", "options", "key", "text", "points")


@dataclass(frozen=True)
class FoundAt:
    """Where the event of a question was found to be: the conditions under which it is there, and how that is told."""

    conditions: tuple[str, ...]
    told: str


@dataclass(frozen=True)
class Question:
    """A quantity that is asked for, when it is meant, and the options to choose from."""

    id: str
    text: str
    quantity: Quantity
    event: AskedEvent | None = None
    at_start: bool = False
    options: Mapping[str, str] = field(default_factory=dict[str, str])
    key: str | None = None
    transition: Transition | None = None  # instead of an event: a contact changes its state
    understood: str = ""  # the question in the words of the grammar
    words: str = ""  # in which a sheet asks it, where its author has written them
    points: float | None = None
    found_at: FoundAt | None = None  # of an event that was asked for by what is so there
    in_unit: str = ""  # in which the answer is told beside its own, if that is wanted

    @property
    def runs_over(self) -> str:
        """The name of what the answer is a function of; nothing where it is none."""
        return self.event.name if isinstance(self.event, Anywhere) else self.quantity.function_of


def read_questions(names: Names, given: Any) -> tuple[Question, ...]:
    """The questions of a model; a question is a text, or a mapping with find, id, when, options, key, and
    for exercise sheets text and points."""
    if given is None:
        return ()
    if isinstance(given, dict):
        pairs = list(cast("dict[str, Any]", given).items())
    elif isinstance(given, list):
        pairs = [(f"q{k}", v) for k, v in enumerate(cast("list[Any]", given), 1)]
    else:
        wanted = given if isinstance(given, str) else "acceleration of x"
        names.problem(Message("questions is a list, e.g. questions: [{wanted}]", wanted=wanted), "questions")
        return ()
    found: list[Question] = []
    for k, (name, value) in enumerate(pairs):
        place = name if isinstance(given, dict) else k
        with names.at("questions", place):
            read = _questions(names, name, value)
        for question in read:
            if any(other.id == question.id for other in found):
                names.problem(Message("two questions have the id {id}", id=question.id), "questions", place, "id")
            found.append(question)
    return tuple(found)


def _questions(names: Names, name: str, value: Any) -> list[Question]:
    """What one entry asks: one question, or several where its words ask for several things."""
    known = KEYS_OF_QUESTIONS
    phrased = phrase_text(value)
    entry: dict[str, Any] = {}
    if phrased is not None:
        entry = {"find": phrased}
    elif isinstance(value, dict):
        entry = cast("dict[str, Any]", value)
    if not isinstance(entry.get("find"), str):
        names.problem(Message("a question needs find, e.g. {{find: acceleration of x}}"))
        return []
    for key in entry:
        if key not in known:
            names.problem(Message("a question has no {key}.{hint}", key=key, hint=did_you_mean(key, known)), key)
    text = " ".join(str(entry["find"]).split())
    found = _understood(names, text, entry.get("when"))
    own = plain(str(entry.get("id", name)))
    if len(found) > 1:
        if entry.get("options") or entry.get("key") is not None:
            several = "\n    ".join(words for _, words in found)
            told = Message(
                "options are of one quantity, and '{text}' asks for\n    {several}", text=text, several=several
            )
            names.problem(told, "find")
        points = _points(names, entry.get("points"))
        read = [_asks(names, f"{own}_{k}", words, meant, entry) for k, (meant, words) in enumerate(found, 1)]
        asked = [question for question in read if question is not None]
        return [replace(question, points=None if points is None else points / len(found)) for question in asked]
    return [question for meant, words in found if (question := _asks(names, own, text, meant, entry, words))]


def _asks(
    names: Names, own: str, text: str, meant: Meant, entry: Mapping[str, Any], canonical: str = ""
) -> Question | None:
    """One question. own: its id; canonical: in the words of the grammar, where its text is not."""
    quantity, event, at_start, transition = meant.quantity, meant.event, meant.at_start, meant.transition
    condition = event or transition
    if quantity.scope == "every motion" and (condition is not None or at_start):
        names.problem(Message("what is conserved is so at every instant; leave out 'at start' and 'when'"), "find")
        return None
    options: Any = entry.get("options") or {}
    if isinstance(options, list):
        letters = "abcdefghijklmnopqrstuvwxyz"
        options = dict(zip(letters, cast("list[Any]", options), strict=False))
    if not isinstance(options, dict):
        names.problem(Message("options is a mapping, e.g. options: {{a: g/2, b: g}}"), "options")
        options = {}
    shown = {plain(str(k)): plain(_option_text(v)) for k, v in cast("dict[Any, Any]", options).items()}
    key = entry.get("key")
    if key is not None and str(key) not in shown:
        names.problem(Message("key {key} is not among the options {shown}", key=key, shown=", ".join(shown)), "key")
    return Question(
        own,
        plain(text),
        quantity,
        event,
        at_start,
        shown,
        None if key is None else str(key),
        transition,
        plain(canonical or text),
        plain(" ".join(str(entry.get("text", "")).split())),
        _points(names, entry.get("points")),
        in_unit=meant.in_unit,
    )


def _points(names: Names, given: object) -> float | None:
    """What an answer is worth."""
    if given is None:
        return None
    if isinstance(given, bool) or not isinstance(given, (int, float)) or given < 0:
        names.problem(Message("points is a number, e.g. points: 2, not {given}", given=str(given)), "points")
        return None
    return float(given)


def _understood(names: Names, text: str, when: object) -> list[tuple[Meant, str]]:
    """What a text asks for, and the words of the grammar in which it does. when: what the file says of it beside the
    text, in words of the grammar or in others."""
    text = _at_its_time(names, names.spelt_out(text))
    if isinstance(when, str):
        when = names.spelt_out(when)
        with names.quietly():
            n_before = len(names.problems)
            is_read = bool(_meant_by(names, text, when)) and len(names.problems) == n_before
            together = [] if is_read else _meant_by(names, f"{text} when {when.removeprefix('when ')}", None)
        if together:
            return together
    return _meant_by(names, text, when)


def _at_its_time(names: Names, text: str) -> str:
    """Where a measure stands with a time, as in x(2 s), it is meant then, and no product."""
    found = _AT_TIME.search(text)
    if found is None or found["of"] not in names.measures:
        return text
    return text.replace(found[0], f"{found['of']} when t = {found['time']}")


def _meant_by(names: Names, text: str, when: object) -> list[tuple[Meant, str]]:
    text = beside_a_stop(names, text)
    function = _AS_FUNCTION.fullmatch(text)
    place = None if function is None or when is not None else Anywhere.on(names, function["of"])
    if function is not None and place is not None:
        return _as_function(names, text, function["what"], place)

    def read(words: str) -> Meant | None:
        return read_phrase(names, as_condition(names, words.rstrip(" ?!")), when)

    n_before = len(names.problems)
    meant = None if names.is_undeclared_in(text) else read(text)
    if meant is not None and len(names.problems) == n_before:
        return [(meant, as_condition(names, text))]
    del names.problems[n_before:]
    from freebody.questions.spoken import in_terms_of
    from freebody.questions.spoken.naming import elements_of
    from freebody.questions.spoken.understanding import understood  # a tenth of what solving imports
    from freebody.questions.spoken.wanted_unit import told_in, without_units

    spoken = in_terms_of.as_function(names, text) if when is None else None
    if spoken is not None and (found := _function_of(names, text, *spoken)):
        return found
    bare, units = without_units(text, elements_of(names).exact)
    if len(units) != 1:
        found = [(meant, as_condition(names, words)) for meant, words in understood(names, text, read)]
        return [(_counted_in(names, text, *found[0]), found[0][1])] if len(found) == 1 else found
    with names.quietly():
        found = _meant_by(names, bare, when)
        if not found or len(names.problems) > n_before:
            del names.problems[n_before:]
            found = understood(names, text, read)
        is_read = bool(found) and len(names.problems) == n_before
    if not is_read:
        return _meant_by(names, bare, when)
    if len(found) > 1 or not found[0][0].quantity.unit:
        return found
    told = told_in(names, text, *found[0], units[0])
    return [] if told is None else [(told, as_condition(names, found[0][1]))]


def _function_of(names: Names, text: str, what: str, of: str) -> list[tuple[Meant, str]]:
    """A quantity as a function of a measure, the time, or the section of a rod; nothing, without a problem noted, where
    it is of nothing that there is."""
    from freebody.questions.spoken.in_terms_of import joined

    place = Anywhere.on(names, of)
    if each := [found for part in joined(what) if (found := _quietly_function_of(names, part, of))]:
        return [one for found in each for one in found] if len(each) == len(joined(what)) else []
    return _along_a_rod(names, what, of) if place is None else _as_function(names, text, what, place)


def _quietly_function_of(names: Names, what: str, of: str) -> list[tuple[Meant, str]]:
    with names.quietly():
        n_before = len(names.problems)
        found = _function_of(names, what, what, of)
        return found if len(names.problems) == n_before else []


def _as_function(names: Names, text: str, what: str, place: AnyPlace | AnyInstant) -> list[tuple[Meant, str]]:
    """A quantity as a function of a measure or of the time; what is counted on the way up to it, too."""
    of, dimension = place.name, place.dimension
    until = f" until {of} = {_ANYWHERE} {'rad' if dimension == DIMENSIONLESS else dimension}"
    found = _quietly_meant(names, what)
    counted = [] if found else _quietly_meant(names, f"{what}{until}")
    if not found and not counted:
        return _meant_by(names, what, None)  # which says why it is not read
    free = [replace(meant, event=None) for meant, _ in counted] or [meant for meant, _ in found]
    kinds = (Counted,) if counted else (Quantity,)
    if all(isinstance(m.quantity, kinds) and m.event is None and m.transition is None and not m.at_start for m in free):
        said = [words.removesuffix(until) for _, words in counted or found]
        pairs = zip(free, said, strict=True)
        return [(replace(meant, event=place), f"{words} as a function of {of}") for meant, words in pairs]
    told = Message("'{text}' is not asked as a function of {of}: ask until, or when, {of} = ...", text=text, of=of)
    names.problem(told, "find")
    return []


def _along_a_rod(names: Names, what: str, of: str) -> list[tuple[Meant, str]]:
    """What is transmitted in the sections of a rod, in other words than those of the grammar: by what is greatest in
    it. Nothing where something else is asked."""
    from freebody.questions.spoken.in_terms_of import greatest_of

    if not is_free(names, of):
        return []
    each = (found for text in greatest_of(what.removeprefix("the ")) if len(found := _quietly_meant(names, text)) == 1)
    meant = next((found[0][0] for found in each), None)
    if meant is None or meant.event is not None or not isinstance(meant.quantity, GreatestInRod):
        return []
    words = SectionsOfRod(meant.quantity.body, meant.quantity.part, of).words
    read = read_phrase(names, words, None)
    return [] if read is None else [(read, words)]


def _quietly_meant(names: Names, text: str) -> list[tuple[Meant, str]]:
    """What a text asks for; nothing where it is not read."""
    with names.quietly():
        n_before = len(names.problems)
        found = _meant_by(names, text, None)
        return found if len(names.problems) == n_before else []


def _counted_in(names: Names, text: str, meant: Meant, words: str) -> Meant:
    """What is meant, in the unit of which a text asks how many, if it has it: how many joules are lost."""
    from freebody.questions.spoken.wanted_unit import counted_in, told_in

    with names.quietly():
        unit = counted_in(text)
        return (unit and told_in(names, text, meant, words, unit)) or meant


def _option_text(value: Any) -> str:
    """An option as text; a vector may be written as a list."""
    if isinstance(value, list):
        return "[" + ", ".join(map(str, cast("list[Any]", value))) + "]"
    return str(value)
