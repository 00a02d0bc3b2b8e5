"""Changes of model documents: plain data in, changed plain data out."""

from __future__ import annotations

import random
import re
from collections.abc import Callable, Mapping
from fractions import Fraction
from typing import Any, cast

from freebody.api import System
from freebody.errors import FreebodyError
from freebody.language.units import DIMENSIONLESS, Dimension, parse_quantity
from freebody.model.phrases import phrase_text

NAMED = ("parameters", "bodies", "connections", "loads", "measures", "states")
_TOLD = ("title", "about", "source", "id", "options", "key", "text", "points", "freebody", "style")
_WORD = re.compile(r"(?<![\w.])[A-Za-z_]\w*")

Data = dict[str, Any]
Path = tuple[str | int, ...]


def section(data: Data, name: str) -> Data:
    """A section of a document, or of a part of it; empty where there is none."""
    return cast("Data", data.get(name) or {})


def prepared(system: System) -> Data:
    """The document of a model, each question with the id that it has."""
    data = system.document.data
    if system.questions:
        plain = data["questions"]
        listed: list[Data] = []
        entries = cast("list[Any]", plain if isinstance(plain, list) else list(plain.values()))
        for question, entry in zip(system.questions, entries, strict=True):
            text = phrase_text(entry)
            listed.append({**({"find": text} if text is not None else entry), "id": question.id})
        data["questions"] = listed
    for name, value in data.get("measures", {}).items():
        text = phrase_text(value)
        if text is not None:
            data["measures"][name] = text
    return data


def mapped(value: Any, change: Callable[[Path, Any], Any], path: Path = ()) -> Any:
    """The data with every scalar changed, given its path; what only tells (titles, options) stays."""
    if isinstance(value, dict):
        entries = cast("dict[str, Any]", value).items()
        return {k: v if k in _TOLD and len(path) in (0, 2) else mapped(v, change, (*path, k)) for k, v in entries}
    if isinstance(value, list):
        return [mapped(v, change, (*path, k)) for k, v in enumerate(cast("list[Any]", value))]
    return change(path, value)


def has_options(data: Data) -> bool:
    """Whether a question has options, which are formulas in the model's names and units."""
    return any("options" in q for q in data.get("questions", ()))


# -- names ------------------------------------------------------------------------------------
def renamed(data: Data, names: Mapping[str, str]) -> Data:
    """The data with bodies, connections, loads, measures and parameters called otherwise."""

    def words(text: str) -> str:
        return _WORD.sub(lambda w: names.get(w[0], w[0]), text)

    def scalar(path: Path, value: Any) -> Any:
        if (
            not isinstance(value, str)
            or is_quantity(value)
            or (path[0] == "parameters" and path[-1] in ("unit", "sign"))
        ):
            return value
        if path[0] == "parameters" and len(path) == 2:
            return value  # a unit
        return words(value)

    changed = mapped(data, scalar)

    def keys(section: Any, depth: int) -> Any:
        """Names stand at the second level, and wherever a mapping goes by bodies."""
        if isinstance(section, list):
            return [keys(v, depth + 1) for v in cast("list[Any]", section)]
        if not isinstance(section, dict):
            return section
        entries = cast("dict[str, Any]", section).items()
        is_named = depth == 0 or depth >= 3
        return {(words(k) if is_named else k): keys(v, depth + 1) for k, v in entries}

    return {s: keys(v, 0) if s in (*NAMED, "start") else v for s, v in changed.items()}


# -- quantities -------------------------------------------------------------------------------
def is_quantity(text: str) -> bool:
    try:
        parse_quantity(text)
    except FreebodyError:
        return False
    return True


def decimal(x: Fraction) -> str | None:
    """A fraction as a decimal number, exactly; None where it has no end."""
    n, d = x.numerator, x.denominator
    twos = fives = 0
    while d % 2 == 0:
        d, twos = d // 2, twos + 1
    while d % 5 == 0:
        d, fives = d // 5, fives + 1
    if d != 1:
        return None
    digits = max(twos, fives)
    scaled = abs(n) * 10**digits // x.denominator
    text = str(scaled).rjust(digits + 1, "0")
    whole, part = (text[:-digits], text[-digits:]) if digits else (text, "")
    return ("-" if n < 0 else "") + (f"{whole}.{part}" if part else whole)


def in_base_units(dimension: Dimension, units: tuple[str, str, str]) -> str:
    """A unit of a dimension from units of mass, length and time: g mm^2/(ms^2)."""
    parts = list(zip(units, (dimension.mass, dimension.length, dimension.time), strict=True))
    above = [u if n == 1 else f"{u}^{n}" for u, n in parts if n > 0]
    below = [u if n == -1 else f"{u}^{-n}" for u, n in parts if n < 0]
    text = " ".join(above) or "1"
    return text + "".join(f"/{u}" for u in below)


def rescaled(data: Data, size: Callable[[Dimension], Fraction], units: tuple[str, str, str]) -> Data | None:
    """Every quantity with a unit times `size` of its dimension, written in these units of mass, length and time; None
    where one cannot be written as a decimal number."""
    failed: list[str] = []

    def scalar(path: Path, value: Any) -> Any:
        if not isinstance(value, str) or not any(c.isalpha() for c in value) or not is_quantity(value):
            return value
        quantity = parse_quantity(value)
        if quantity.dimension == DIMENSIONLESS:
            return _angle(value, path)
        text = None if quantity.exact is None else decimal(quantity.exact * size(quantity.dimension))
        if text is None:
            failed.append(value)
            return value
        return f"{text} {in_base_units(quantity.dimension, units)}"

    changed = mapped(data, scalar)
    return None if failed else changed


def _angle(text: str, path: Path) -> str:
    """An angle in degrees as a formula; of a parameter, in radians."""
    quantity = parse_quantity(text)
    if quantity.degrees is None:
        return text
    if path[0] == "parameters":
        return f"{quantity.value!r} rad"
    return f"{quantity.degrees.numerator}*pi/{180 * quantity.degrees.denominator}"


# -- order ------------------------------------------------------------------------------------
def shuffled(data: Data, rng: random.Random) -> Data:
    """Bodies, connections, loads, measures and questions in another order."""
    changed = dict(data)
    for section in (*NAMED[1:], "start"):
        if isinstance(data.get(section), dict):
            entries = list(cast("dict[str, Any]", data[section]).items())
            if section == "measures" and any(isinstance(v, dict) for _k, v in entries):
                continue  # an expression in measures stands below them
            rng.shuffle(entries)
            changed[section] = dict(entries)
    if "questions" in data:
        changed["questions"] = rng.sample(data["questions"], len(data["questions"]))
    return changed
