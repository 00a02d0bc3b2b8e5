"""Forms with places to fill: the examples of the kinds, and the grammar of phrases and questions.

A kind of connection, load or shape states its smallest example. What stands in that example says what its fields take:
a text that names a body there wants a body, `ground.A` a point, `right` a direction, `0.1 m` a length. So a random
element of any kind, a user's own included, is its example with every place filled anew, and no list of kinds is kept
here. The forms of questions and of measures have their places in capitals: `acceleration of MEASURE, or of POINT`.
"""

from __future__ import annotations

import random
import re
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import cache
from typing import Any, cast

from freebody.errors import FreebodyError
from freebody.language.document import Document
from freebody.language.units import DIMENSIONLESS, LENGTH, Dimension, parse_quantity
from freebody.model.spec import FieldType, Spec

Fill = Callable[[str], str]  # from the word of a place ("BODY") to a text for it
_COMPASS = ("right", "left", "up", "down", "x", "y", "z")
_PLACE = re.compile(r"\b[A-Z]{4,}\b")
_OPTIONAL = re.compile(r"\[([^\[\]]*)\]")
# what a place takes that an example leaves out, by the type of the field
_SLOT_OF: Mapping[FieldType, str] = {
    "flag": "flag",
    "direction": "direction",
    "text": "name",
    "formula": "any quantity",
}


@dataclass(frozen=True)
class PatternSlot:
    """A place: what it takes ("body", "wheel", "point", "surface", "measure", "direction", "quantity", "number",
    "law" ...), and what the example has there. A law has its text, and the names in it: measures and parameters."""

    role: str
    given: Any
    dimension: Dimension = DIMENSIONLESS


@cache
def example_of(kind: type[Spec]) -> dict[str, Any]:
    """The data of the example of a connection or load."""
    return Document.read(cast("str", getattr(kind, "example", ""))).data


def fields_of(kind: type[Spec], section: str) -> dict[str, Any]:
    """The fields of `it` in the example of a kind, with slots for what can be filled."""
    data = example_of(kind)
    return {name: _slots(value, data) for name, value in kind.from_plain(data[section]["it"][kind.kind]).items()}


def shape_fields(kind: type[Spec]) -> dict[str, Any]:
    """The same of a shape, whose example has its fields alone."""
    return {name: _slots(value, {}) for name, value in example_of(kind).items()}


def options_of(kind: type[Spec], given: Mapping[str, Any]) -> dict[str, Any]:
    """Slots for the fields that the example leaves out, by their types."""
    types = kind.field_types()
    found: dict[str, Any] = {}
    for name, field in kind.model_fields.items():
        if name not in given and (field.alias or name) not in given and types[name] in _SLOT_OF:
            default = "right" if types[name] == "direction" else field.default
            found[name] = PatternSlot(_SLOT_OF[types[name]], default)
    return found


def _slots(value: Any, data: Mapping[str, Any]) -> Any:
    """The value with slots for its texts and numbers."""
    if isinstance(value, dict):
        return {key: _slots(item, data) for key, item in cast("dict[str, Any]", value).items()}
    if isinstance(value, list):
        return [_slots(item, data) for item in cast("list[Any]", value)]
    if isinstance(value, bool):
        return PatternSlot("flag", value)
    if isinstance(value, (int, float)):
        return PatternSlot("number", value)
    return _slot_of_text(value, data) if isinstance(value, str) else value


def _slot_of_text(text: str, data: Mapping[str, Any]) -> PatternSlot:
    bodies = {"ground", *cast("dict[str, Any]", data.get("bodies", {}))}
    ground = cast("dict[str, Any]", data.get("ground", {}))
    measures = cast("dict[str, Any]", data.get("measures", {}))
    if text in bodies:
        return PatternSlot("wheel" if "radius" in repr(data["bodies"].get(text)) else "body", text)
    if any(text in ground.get(section, {}) for section in ("lines", "planes")):
        return PatternSlot("surface", text)
    if text in measures:
        return PatternSlot("measure", text)
    if text in _COMPASS:
        return PatternSlot("direction", text)
    if text.partition(".")[0] in bodies and " " not in text:
        return PatternSlot("point", text)
    try:
        return PatternSlot("quantity", text, parse_quantity(text).dimension)
    except FreebodyError:
        pass
    words = set(re.findall(r"[A-Za-z_]\w*", text))
    if words & bodies and not words & set(measures):
        return PatternSlot("phrase", text)
    parameters = cast("dict[str, Any]", data.get("parameters", {}))
    used = {name: parameters[name] for name in sorted(words & set(parameters))}
    return PatternSlot("law", (text, tuple(sorted(words & set(measures))), used))


def filled(slots: Any, fill: Callable[[PatternSlot], Any]) -> Any:
    """The value with every slot filled."""
    if isinstance(slots, PatternSlot):
        return fill(slots)
    if isinstance(slots, dict):
        return {key: filled(item, fill) for key, item in cast("dict[str, Any]", slots).items()}
    if isinstance(slots, list):
        return [filled(item, fill) for item in cast("list[Any]", slots)]
    return slots


# -- forms of questions and measures ----------------------------------------------------------
def phrase(form: str, fill: Fill, rng: random.Random) -> str:
    """A text of a form: optional parts in brackets, alternatives between bars, places in capitals.

    `kinetic | potential energy [of BODY]`: what follows the last alternative's first words belongs to all of them."""
    text = form.split(";", maxsplit=1)[0]
    while (found := _OPTIONAL.search(text)) is not None:
        part = rng.choice(found[1].split(" | ")) if rng.random() < 0.5 else ""
        text = text[: found.start()] + part + text[found.end() :]
    text = _alternative(" ".join(text.split()), rng)
    if ", or of " in text:
        head, tail = text.split(", or of ")
        text = rng.choice((head, head.split(" of ")[0] + " of " + tail))
    return _PLACE.sub(lambda place: fill(place[0]), text)


def _alternative(text: str, rng: random.Random) -> str:
    """One of the alternatives, with the end of the last one where it has none of its own."""
    parts = [part for part in text.split(" | ") if part != "..."]
    chosen = rng.choice(parts)
    last = parts[-1]
    if chosen is not last and not _PLACE.search(chosen):
        if " of " in last and " of " not in chosen:
            return chosen + last[last.index(" of ") :]
        if " of " not in last and " " in last and " " not in chosen:
            return f"{chosen} {last.split(' ', 1)[1]}"
    if chosen is not parts[0] and _PLACE.search(chosen) and " " not in chosen.replace(_PLACE.search(chosen)[0], ""):  # pyrefly: ignore[unsupported-operation]
        return f"{parts[0].rsplit(' ', 1)[0]} {chosen}"
    return chosen


__all__ = ["LENGTH", "PatternSlot", "example_of", "fields_of", "filled", "options_of", "phrase", "shape_fields"]
