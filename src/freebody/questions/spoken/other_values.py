"""Questions that say of a parameter in passing which value it has: that of the file, or another one.

How that is said stands in the languages' files (`stated`); forces that nobody chooses in unchosen.py.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from contextlib import suppress
from functools import cache
from typing import TYPE_CHECKING

from freebody.errors import UnitError
from freebody.language.sentences import Message
from freebody.language.units import DIMENSIONLESS
from freebody.language.units.quantity import Quantity, parse_quantity
from freebody.questions.spoken import driving, given
from freebody.questions.spoken.compounds import in_english_nouns
from freebody.questions.spoken.lexicon import languages, values_stated
from freebody.questions.spoken.unchosen import is_unchosen, meant_by

if TYPE_CHECKING:
    from freebody.model.names import Names

_NUMBER = r"\d+(?:[.,]\d+)?"
_UNIT = r" ?(?:1/)?[A-Za-z°][A-Za-z0-9/^]*(?: (?:m|s)(?:\^?2)?(?:/[a-z]+)?(?!\w))*"
_FORCE = r" ?[kM]?N(?: ?(?:m|mm|cm))?"
_PLACES = {  # of the patterns in the languages' files
    "{value}": rf"(?P<value>{_NUMBER}(?:{_UNIT})?)",
    "{measured}": rf"(?P<value>{_NUMBER}{_UNIT})",
    "{force}": rf"(?P<value>{_NUMBER}{_FORCE})",
    "{load}": rf"(?P<value>{_NUMBER}(?:{_FORCE}| ?(?:kg|g|t)))",
    "{turning}": rf"(?P<value>{_NUMBER} ?(?:rad/s|rpm|1/min|U/min|m/s(?:\^?2|²)?|km/h))",
    "{end}": r"(?=[ ,.?!]|$)",
}
_OF_FORCE = re.compile(rf"{_NUMBER}{_FORCE}(?!\w)")
_ANGLE = re.compile(r"(?:°|deg|rad|degrees|Grad)$")
_INITIAL = re.compile(r"^(?:Anfangs|Start|Abwurf)(?=[a-z])")
_HUNDRED = 100.0  # of percent
_FACTORS = {"twice": 2.0, "half": 0.5, "thrice": 3.0}


@cache
def _pattern(language: str, how: str) -> re.Pattern[str]:
    written = re.sub(r"\{[a-z]+\}", lambda place: _PLACES[place[0]], values_stated(language)[how])
    return re.compile(written, re.IGNORECASE)


def _found(how: str, text: str) -> Iterator[re.Match[str]]:
    """Where a text says a value in one way, in all languages."""
    for language in languages():
        yield from _pattern(language, how).finditer(text)


def same_value(names: Names, text: str) -> str | None:
    """The text without the value of a parameter that the file gives as well; not zero, which may change what holds."""
    for found in _found("named", text):
        parameter = names.parameters.get(found["name"])
        if parameter is not None and parameter.value is not None:
            with suppress(UnitError, ValueError):
                if _quantity(found["value"]).value == names.number_of(parameter.name) != 0.0:
                    return _cut(text, *found.span())
    for found in _found("begun", text):
        with suppress(UnitError, ValueError):
            said = _quantity(found["value"])
            alike = [p.name for p in names.parameters.values() if p.dimension == said.dimension]
            if said.value != 0.0 and [names.number_of(name) for name in alike].count(said.value) == 1:
                swings = " with a finite amplitude" if found["swing"] else ""  # a period is then none of small ones
                return _cut(text[: found.end()] + swings + text[found.end() :], *found.span())
    if (exerted := _exerted(names, text)) is not None and exerted[2]:
        found = exerted[0]
        return _cut(text, *(found.span() if found["with"] else found.span("of")))
    return None


def stated_values(names: Names, text: str) -> tuple[dict[str, str], str]:
    """The values of parameters that a text states, by name, and the text without them; none where one of them can be
    that of several parameters."""
    values: dict[str, str] = {}
    for how in ("and_named", "named", "of_kind", "unnamed"):
        for language in languages():
            for found in reversed([*_pattern(language, how).finditer(text)]):
                if found.groupdict().get("name", "") not in ("", *names.parameters):
                    continue
                name = _stated(names, found, language)
                if name is None or name in values or not _is_value_of(names, name, found["value"]):
                    return {}, text
                values[name] = _with_unit(names, name, found["value"])
                text = _cut(text, *found.span())
    for language in languages():
        if (found := _pattern(language, "changed").search(text)) is None or _pattern(language, "asks_change").search(
            text
        ):
            continue
        if (multiple := _multiple(names, found, language)) is None or multiple[0] in values:
            return {}, text
        values[multiple[0]] = multiple[1]
        text = _cut(text, *found.span())
    speeds = [name for name in driving.drive_parameters(names) if name not in values]
    found = next(_found("turning", text), None)
    if found is not None and (name := _alone(names, found["value"])) in speeds:
        values[name] = found["value"].replace("U/min", "rpm").replace("1/min", "rpm")
        text = _cut(text, *found.span())
    exerted = _exerted(names, text)
    if exerted is not None and len(exerted[1]) == 1 and exerted[1][0] not in values:  # to hold a torque of 60 N m
        found, [name], _ = exerted
        values[name] = _parted(found["value"])
        text = _cut(text, *found.span("of"))
    return {name: values[name] for name in names.parameters if name in values}, text


def _stated(names: Names, found: re.Match[str], language: str) -> str | None:
    """The parameter that a value is said of: by its name, or the only one that it can be."""
    said = found.groupdict()
    if name := said.get("name"):
        return name
    meant = meant_by(said.get("noun", ""), language)
    is_of_one = "mass" in meant and bool(said.get("whose"))  # of which body is not looked for
    return None if is_of_one or _is_no_choice(names, found[0], language) else _alone(names, found["value"], meant)


def _alone(names: Names, value: str, meant: set[str] | None = None) -> str | None:
    """The only parameter that a value can be of, but for the strength of gravity. meant: quantities that it may be."""
    with suppress(UnitError, ValueError):
        said, weights = _quantity(value), given.weighed_by(names)
        if "friction coefficient" in (meant or ()) and said.dimension == DIMENSIONLESS:
            alike = given.parameters(names, "friction coefficient", "")
            return alike[0] if len(alike) == 1 else None
        fitting = [p for p in names.parameters.values() if p.dimension == said.dimension and p.form is None]
        alike = [p.name for p in fitting if p.name not in weights and p.is_angle == (_ANGLE.search(value) is not None)]
        return alike[0] if len(alike) == 1 else None
    return None


def _is_no_choice(names: Names, said: str, language: str) -> bool:
    """Whether a force is said that nobody chooses: a friction of 5 N, but a friction coefficient of 0.3."""
    return _OF_FORCE.search(said) is not None and is_unchosen(names, said, language)


def _is_value_of(names: Names, name: str, value: str) -> bool:
    parameter = names.parameters[name]
    with suppress(UnitError, ValueError):
        return parameter.form is None and (_is_zero(value) or _quantity(value).dimension == parameter.dimension)
    return False


def _is_zero(value: str) -> bool:
    """Whether a value is zero without a unit, as it may be of everything."""
    return re.fullmatch(r"0+(?:[.,]0+)?", value) is not None


def _with_unit(names: Names, name: str, value: str) -> str:
    dimension = str(names.parameters[name].dimension)
    return f"{value} {dimension}" if _is_zero(value) and dimension != "1" else _parted(value)


def _quantity(value: str) -> Quantity:
    return parse_quantity(_parted(value))


def _parted(value: str) -> str:
    """A value whose unit has its factors parted, 60 N m, and whose decimals stand behind a point."""
    return re.sub(r"(?<=N)(?=m|cm)", " ", re.sub(" ?°", " deg", value.replace(",", ".")))


def _exerted(names: Names, text: str) -> tuple[re.Match[str], list[str], bool] | None:
    """What is said of how hard something pushes, the parameters that it can be, and whether one has that value."""
    for language in languages():
        found = _pattern(language, "exerted").search(text)
        if found is None or _is_no_choice(names, found[0], language):
            continue
        with suppress(UnitError, ValueError):
            said = _quantity(found["value"])
            alike = [p.name for p in names.parameters.values() if p.dimension == said.dimension and p.value is not None]
            same = [name for name in alike if names.number_of(name) == said.value]
            return found, same or alike, len(same) == 1
    return None


def _cut(text: str, begin: int, end: int) -> str:
    return re.sub(r" (?=[.?!])", "", " ".join(f"{text[:begin]} {text[end:]}".split())).strip(" ,")


def _given(name: str, said: str, value: str) -> Message:
    """What is said of a text that gives a parameter another value in passing."""
    return Message(
        "the file gives {name} its value; ask without '{said}', with --set '{name}={value}'",
        name=name, said=said, value=value)  # fmt: skip


def other_value(names: Names, text: str) -> Message | None:
    """What is said of a text in which a parameter has another value in passing: if mu is 0.3, when does it roll?"""
    for found in _found("named", text):
        parameter = names.parameters.get(found["name"])
        if parameter is not None and parameter.value is not None and _is_value_of(names, found["name"], found["value"]):
            return _given(found["name"], found[0], _parted(found["value"]))
    if (exerted := _exerted(names, text)) is not None and len(exerted[1]) == 1 and not exerted[2]:
        found, [name], _ = exerted
        return _given(name, found["of"].strip(), _parted(found["value"]))
    return _changed(names, text)


def _multiple(names: Names, found: re.Match[str], language: str) -> tuple[str, str] | None:
    """A parameter that is said to be a multiple of its value, and that value: the one that is named, or the only one of
    the kind that is."""
    name = found["name"]
    if name not in names.parameters:
        kinds = meant_by(in_english_nouns(_INITIAL.sub("", name), language, frozenset()), language)
        kinds = kinds or meant_by(in_english_nouns(name, language, frozenset()), "en")
        alike = {one for kind in kinds for one in _of_kind(names, kind)}
        name = alike.pop() if len(alike) == 1 else name
    parameter = names.parameters.get(name)
    if parameter is None or parameter.value is None or parameter.form is not None:
        return None
    factor = next((factor for what, factor in _FACTORS.items() if found[what]), 1.0)
    factor += float((found["more"] or "0").replace(",", ".")) / _HUNDRED
    factor -= float((found["less"] or "0").replace(",", ".")) / _HUNDRED
    unit = "rad" if parameter.is_angle else re.sub("^1$", "", str(parameter.dimension))
    return name, f"{factor * parameter.value:g} {unit}".strip()


def _of_kind(names: Names, kind: str) -> list[str]:
    return given.of_kind(names, kind) if given.is_by_unit(kind) else given.parameters(names, kind, "")


def _changed(names: Names, text: str) -> Message | None:
    """What is said of a text in which a parameter is to be a multiple of its value."""
    for language in languages():
        for found in _pattern(language, "changed").finditer(text):
            if (multiple := _multiple(names, found, language)) is not None:
                return Message(
                    "ask for one quantity, and for it again with --set '{name}={value}'; without the value of {name} "
                    "in the file the answer says how it depends on it",
                    name=multiple[0],
                    value=multiple[1],
                )
    return None
