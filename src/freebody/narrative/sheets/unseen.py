"""What no figure shows: coefficients of friction and restitution, unstretched lengths; and what does not rebound."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from typing import Any, cast

from freebody.errors import CannotAnswer, UnitError
from freebody.language.units import Quantity, parse_quantity
from freebody.measures.geometry import ZERO
from freebody.study.phases.at_start import closed_at_start
from freebody.system.system import System

_FIELDS = ("rest_length", "friction", "restitution", "pressure_angle")


def unseen_numbers(system: System) -> Iterator[tuple[str, str, str]]:
    """What no parameter names: the field, the connection or load, and the number as the file has it. Of friction both,
    where it is more at rest. That nothing bounces is told as well, and no other zero."""
    for field, name, value in _given(system):
        quantity = _quantity(value)
        if quantity is not None and (quantity.value or field == "restitution"):
            yield field, name, str(value)


def unseen_symbols(system: System) -> Mapping[str, tuple[str, str]]:
    """By parameter what it is of: its field, and the connection or load, nothing where all have the same one. What
    stands elsewhere too, as a radius that is a length without load as well, is shown there."""
    found: dict[str, list[tuple[str, str]]] = {}
    kinds: dict[str, set[object]] = {}
    for field, name, value in _given(system):
        kinds.setdefault(field, set()).add(value)
        if value in system.parameters:
            found.setdefault(str(value), []).append((field, name))
    single = {
        p: told[0]
        for p, told in found.items()
        if len({field for field, _name in told}) == 1 and _times_written(system, p) == len(told)
    }
    return {p: (field, "" if len(kinds[field]) == 1 else name) for p, (field, name) in single.items()}


def _times_written(system: System, name: str) -> int:
    """How often a name stands in what the file says of bodies, connections and loads."""
    word = re.compile(rf"\b{re.escape(name)}\b")

    def within(part: object) -> int:
        match part:
            case dict():
                return sum(map(within, cast("dict[str, object]", part).values()))
            case list():
                return sum(map(within, cast("list[object]", part)))
            case _:
                return len(word.findall(str(part)))

    sections = ("ground", "bodies", "connections", "loads", "measures", "start")
    return sum(within(system.document.data.get(section)) for section in sections)


def not_rebounding(system: System) -> tuple[str, ...]:
    """Connections that close on the way and of which nobody says how they rebound: they do not."""
    if not system.bounds:
        return ()
    try:
        closed = closed_at_start(system)
    except CannotAnswer:
        return ()
    closing = dict.fromkeys(b.row.connection for b in system.bounds)
    closing = {name: None for name in closing if "restitution" in type(system.connections[name]).model_fields}
    for b in system.bounds:
        if b.name in closed or b.restitution != ZERO:
            closing.pop(b.row.connection, None)
    said = {name for field, name, _value in _given(system) if field == "restitution"}
    return tuple(name for name in closing if name not in said)


def _given(system: System) -> Iterator[tuple[str, str, object]]:
    """The fields of connections and loads that no figure shows, with what the file has for them."""
    for section in ("connections", "loads"):
        data = system.document.data.get(section)
        for name, entry in cast("dict[str, Any]", data).items() if isinstance(data, dict) else ():
            told = cast("dict[str, Any]", entry) if isinstance(entry, dict) else {}
            for of in (told, *(inner for inner in told.values() if isinstance(inner, dict))):
                yield from ((field, name, value) for field, value in _fields_of(of))


def _fields_of(of: Mapping[str, Any]) -> Iterator[tuple[str, object]]:
    for field in _FIELDS:
        value = of.get(field)
        if isinstance(value, dict):
            yield from ((f"{field}_{key}", x) for key, x in cast("dict[str, Any]", value).items())
        elif value is not None:
            yield field, value


def _quantity(value: object) -> Quantity | None:
    """A number that the file gives, with its unit; nothing for formulas."""
    try:
        return parse_quantity(str(value)) if isinstance(value, (str, int, float)) else None
    except UnitError:
        return None
