"""Questions that say of a parameter in passing which value it has: that of the file, or another one."""

from __future__ import annotations

import re
from contextlib import suppress
from typing import TYPE_CHECKING

from freebody.errors import UnitError
from freebody.language.sentences import Message
from freebody.language.units.quantity import parse_quantity

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
        begin, end = found.span() if found["with"] else found.span("of")
        return " ".join(f"{text[:begin]} {text[end:]}".split()).replace(" ?", "?")
    return None


def _parted(value: str) -> str:
    """A value whose unit has its factors parted: 60 N m."""
    return re.sub(r"(?<=N)(?=m|cm)", " ", value)


def _exerted(names: Names, text: str) -> tuple[re.Match[str], list[str], bool] | None:
    """What is said of how hard something pushes, the parameters that it can be, and whether one has that value."""
    found = _EXERTED.search(text)
    if found is None:
        return None
    with suppress(UnitError, ValueError):
        said = parse_quantity(_parted(found["value"]))
        alike = [p.name for p in names.parameters.values() if p.dimension == said.dimension and p.value is not None]
        same = [name for name in alike if names.number_of(name) == said.value]
        return found, same or alike, len(same) == 1
    return None


def _without(text: str, found: re.Match[str]) -> str:
    return re.sub(r" (?=[.?!])", "", " ".join((text[: found.start()] + text[found.end() :]).split())).strip(" ,")


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
