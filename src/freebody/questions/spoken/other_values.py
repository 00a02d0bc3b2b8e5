"""Questions that say of a parameter in passing which value it has: that of the file, or another one."""

from __future__ import annotations

import re
from contextlib import suppress
from typing import TYPE_CHECKING

from freebody.errors import UnitError
from freebody.language.sentences import Message
from freebody.language.units.quantity import Quantity, parse_quantity
from freebody.questions.spoken import given, joining

if TYPE_CHECKING:
    from freebody.model.names import Names

_IN_PASSING = re.compile(  # a parameter and a value behind a word that says for what
    r"\b(?:if|for|with|when|where|at|given|knowing that|let|wenn|falls|für|mit|bei|gegeben) "
    r"(?P<name>\w+)(?: ?= ?| is| equals| was| of| ist| von|) ?"
    r"(?P<value>\d+(?:\.\d+)?(?: ?[A-Za-z°][A-Za-z0-9/^]*(?: (?:m|s)(?:\^?2)?(?:/[a-z]+)?(?!\w))*)?)(?=[ ,.?!]|$)",
    re.IGNORECASE,
)
_STARTED = re.compile(  # a value of the only parameter that has it: if released from 60 deg, with 250 N
    r"[ ,]+(?:(?:if|when|wenn|falls) (?:it |the \w+ |er |sie |es )?(?:is |was |are )?)?"
    r"(?:(?:released|let go|started|dropped|thrown|launched|losgelassen|gestartet) (?:from|at|bei|aus) "
    r"|(?:with|mit|for|für) |(?:from|aus) (?=\d[\d.]* ?(?:m/s|km/h)))"
    r"(?:an? |the |eine[rmn]? |de[rmn] )?(?:given |gegebene[nrm]? )?(?P<swing>amplitude |ausschlag )?"
    r"(?:force |torque |angle |speed |mass |kraft |drehmoment |winkel )?(?:of |von )?"
    r"(?P<value>\d+(?:\.\d+)? ?[A-Za-z°][A-Za-z0-9/^]*(?: m)?)(?=[ ,.?!]|$)",
    re.IGNORECASE,
)
_EXERTED = re.compile(  # a value of what is exerted: with a push of 120 N, to hold a torque of 60 N m
    r"(?:(?P<with> (?:with|for|under|given|mit|für|unter|bei) )|(?<= )(?:hold|lift|carry|support|raise|um) )"
    r"(?:an? |the |one |eine[rmns]? |de[rmn] |das |die )?(?:[^\W\d]+ )?"
    r"[^\W\d]*(?:force|torque|load|push|pull|moment|mass|thrust|kraft|last|masse)"
    r"(?P<of> (?:of |von )?(?P<value>\d+(?:\.\d+)? ?(?:[kM]?N(?: ?(?:m|mm|cm))?|kg|g|t)))(?=[ ,.?!]|$)",
    re.IGNORECASE,
)
_UNIT = r"(?: ?[A-Za-z°][A-Za-z0-9/^]*(?: (?:m|s)(?:\^?2)?(?!\w))*)?"
# what a parameter is, and a value of it: at an acceleration of 5 m/s^2, when the push is 50 N
_OF_KIND = re.compile(
    r"(?:[, ]*\b(?:(?:with|for|under|at|given|mit|für|unter|bei) (?:an? |the |eine[rmns]? |de[rmn] )?"
    r"|(?:if|when|while|where|wenn|falls) (?:the |die |der |das )?))"
    r"(?P<whose>[^\W\d]+ )?"
    r"(?P<noun>[^\W\d]*(?:force|torque|load|push|pull|moment|mass|thrust|drive|acceleration|friction|"
    r"slope|incline|inclination|gradient|kraft|last|masse|moment|beschleunigung|reibung|steigung|neigung|reibungszahl))"
    rf"(?: of| is| equals| von| ist| beträgt|) (?P<value>\d+(?:\.\d+)?{_UNIT})"
    r"(?=[ ,.?!]|$)",
    re.IGNORECASE,
)
_UNNAMED = re.compile(  # how hard something pushes, before what does: with 4000 N of drive
    r"[, ]*\b(?:with|under|mit|unter) (?P<value>\d+(?:\.\d+)? ?[kM]?N(?: ?(?:m|mm|cm))?)(?: of [^\W\d]+)?(?=[ ,.?!]|$)"
)
_AND = re.compile(  # and of another parameter
    r"(?:,|,? (?:and|und)) (?:with |for |mit |für )?(?P<name>\w+) ?= ?"
    rf"(?P<value>\d+(?:\.\d+)?{_UNIT})(?=[ ,.?!]|$)"
)
_AT_SPEED = re.compile(  # how fast something is driven: at 100 rad/s, bei 300 U/min
    r"[, ]*\b(?:at|with|bei|mit) (?P<value>\d+(?:\.\d+)? ?(?:rad/s|rpm|1/min|U/min))(?=[ ,.?!]|$)"
)
_FOLLOWS = re.compile(  # forces that follow from the motion, and are no value that could be chosen
    r"friction|normal|reaction|contact|spring|rope|string|cord|cable|belt|chain|bearing|tooth|tension|inertia|centrifug|"
    r"weight|drag|reib|feder|seil|lager|zahn|riemen|ketten|kontakt|träg|flieh|gewicht|stabkraft|haft|widerstand",
    re.IGNORECASE,
)
_OF_FORCE = re.compile(r"\d ?[kM]?N\b")
_CHANGED = re.compile(  # what happens if the force F is doubled
    r"\b(?:if|when|wenn|falls) (?:(?:the|die|der|das|one|you|man) )?(?:(?:force|kraft|mass|masse|speed|torque) )?"
    r"(?P<name>\w+) (?:is |gets |becomes |wird |sich )?"
    r"(?:(?P<twice>doubles|doubled|verdoppelt)|(?P<half>halved|halves|halbiert)|(?P<thrice>tripled|triples|verdreifacht))",
    re.IGNORECASE,
)
_FACTORS = {"twice": 2.0, "half": 0.5, "thrice": 3.0}


def same_value(names: Names, text: str) -> str | None:
    """The text without the value of a parameter that the file gives as well; not zero, which may change what holds."""
    for found in _IN_PASSING.finditer(text):
        parameter = names.parameters.get(found["name"])
        if parameter is not None and parameter.value is not None:
            with suppress(UnitError, ValueError):
                if parse_quantity(found["value"]).value == names.number_of(parameter.name) != 0.0:
                    return _without(text, found)
    for found in _STARTED.finditer(text):
        with suppress(UnitError, ValueError):
            said = parse_quantity(found["value"].replace("°", "deg"))
            alike = [p.name for p in names.parameters.values() if p.dimension == said.dimension]
            if said.value != 0.0 and [names.number_of(name) for name in alike].count(said.value) == 1:
                swings = " with a finite amplitude" if found["swing"] else ""  # a period is then none of small ones
                return _without(text[: found.end()] + swings + text[found.end() :], found)
    if (exerted := _exerted(names, text)) is not None and exerted[2]:
        found = exerted[0]
        return _cut(text, *(found.span() if found["with"] else found.span("of")))
    return None


def stated_values(names: Names, text: str) -> tuple[dict[str, str], str]:
    """The values of parameters that a text states, by name, and the text without them; none where one of them can be
    that of several parameters."""
    values: dict[str, str] = {}
    for pattern in (_AND, _IN_PASSING, _OF_KIND, _UNNAMED):
        for found in reversed([*pattern.finditer(text)]):
            named, noun = found.groupdict().get("name"), found.groupdict().get("noun", "")
            if named is not None and named not in names.parameters:
                continue
            is_of_one = "mass" in noun.lower() and bool(found["whose"])  # of which body is not looked for
            if named is None and (_is_no_choice(found[0]) or is_of_one):
                return {}, text
            name = named or _alone(names, found["value"], noun)
            if name is None or name in values or not _is_value_of(names, name, found["value"]):
                return {}, text
            values[name] = _with_unit(names, name, found["value"])
            text = _without(text, found)
    speeds = [name for name in joining.drive_parameters(names) if name not in values]
    if (found := _AT_SPEED.search(text)) is not None and (name := _alone(names, found["value"], "")) in speeds:
        values[name] = found["value"].replace("U/min", "rpm").replace("1/min", "rpm")
        text = _without(text, found)
    exerted = _exerted(names, text)
    if exerted is not None and len(exerted[1]) == 1 and exerted[1][0] not in values:  # to hold a torque of 60 N m
        found, [name], _ = exerted
        values[name] = _parted(found["value"])
        text = _cut(text, *found.span("of"))
    return {name: values[name] for name in names.parameters if name in values}, text


def _alone(names: Names, value: str, noun: str) -> str | None:
    """The only parameter that a value can be of, but for the strength of gravity."""
    if re.search(r"friction|reibung", noun, re.IGNORECASE):
        alike = given.parameters(names, "friction coefficient", "")
        return alike[0] if len(alike) == 1 else None
    with suppress(UnitError, ValueError):
        said, weights = _quantity(value), given.weighed_by(names)
        fitting = [p for p in names.parameters.values() if p.dimension == said.dimension and p.form is None]
        alike = [p.name for p in fitting if p.name not in weights and p.is_angle == _is_angle(value)]
        return alike[0] if len(alike) == 1 else None
    return None


def _is_no_choice(said: str) -> bool:
    """Whether a force is said that nobody chooses: with a friction of 5 N, but with a friction coefficient of 0.3."""
    return _OF_FORCE.search(said) is not None and _FOLLOWS.search(said) is not None


def _is_angle(value: str) -> bool:
    return re.search(r"(?:°|deg|rad|degrees|Grad)$", value) is not None


def _is_value_of(names: Names, name: str, value: str) -> bool:
    parameter = names.parameters[name]
    with suppress(UnitError, ValueError):
        is_of = _is_zero(value) or _quantity(value).dimension == parameter.dimension
        return is_of and parameter.form is None
    return False


def _is_zero(value: str) -> bool:
    """Whether a value is zero without a unit, as it may be of everything."""
    return re.fullmatch(r"0+(?:\.0+)?", value) is not None


def _with_unit(names: Names, name: str, value: str) -> str:
    dimension = str(names.parameters[name].dimension)
    return f"{value} {dimension}" if _is_zero(value) and dimension != "1" else _parted(value)


def _quantity(value: str) -> Quantity:
    return parse_quantity(_parted(value))


def _parted(value: str) -> str:
    """A value whose unit has its factors parted: 60 N m."""
    return re.sub(r"(?<=N)(?=m|cm)", " ", re.sub(" ?°", " deg", value))


def _exerted(names: Names, text: str) -> tuple[re.Match[str], list[str], bool] | None:
    """What is said of how hard something pushes, the parameters that it can be, and whether one has that value."""
    found = _EXERTED.search(text)
    if found is None or _is_no_choice(found[0]):
        return None
    with suppress(UnitError, ValueError):
        said = _quantity(found["value"])
        alike = [p.name for p in names.parameters.values() if p.dimension == said.dimension and p.value is not None]
        same = [name for name in alike if names.number_of(name) == said.value]
        return found, same or alike, len(same) == 1
    return None


def _without(text: str, found: re.Match[str]) -> str:
    return _cut(text, *found.span())


def _cut(text: str, begin: int, end: int) -> str:
    return re.sub(r" (?=[.?!])", "", " ".join(f"{text[:begin]} {text[end:]}".split())).strip(" ,")


def other_value(names: Names, text: str) -> Message | None:
    """What is said of a text in which a parameter has another value in passing: if mu is 0.3, when does it roll?"""
    for found in _IN_PASSING.finditer(text):
        parameter = names.parameters.get(found["name"])
        if parameter is not None and parameter.value is not None:
            return Message(
                "the file gives {name} its value; ask without '{said}', with --set '{name}={value}'",
                name=found["name"],
                said=found[0],
                value=found["value"],
            )
    if (exerted := _exerted(names, text)) is not None and len(exerted[1]) == 1 and not exerted[2]:
        found, [name], _ = exerted
        return Message(
            "the file gives {name} its value; ask without '{said}', with --set '{name}={value}'",
            name=name,
            said=found["of"].strip(),
            value=_parted(found["value"]),
        )
    return _changed(names, text)


def _changed(names: Names, text: str) -> Message | None:
    """What is said of a text in which a parameter is to be a multiple of its value."""
    for found in _CHANGED.finditer(text):
        parameter = names.parameters.get(found["name"])
        if parameter is not None and parameter.value is not None:
            factor = next(factor for what, factor in _FACTORS.items() if found[what])
            unit = "rad" if parameter.is_angle else str(parameter.dimension)
            return Message(
                "ask for one quantity, and for it again with --set '{name}={value}'; without the value of {name} in "
                "the file the answer says how it depends on it",
                name=found["name"],
                value=f"{factor * parameter.value:g} {'' if unit == '1' else unit}".strip(),
            )
    return None
