"""Gears by their numbers of teeth alone: gears that mesh have one module, which is that of their partner or left open.

    a: {gear: {teeth: 20}}                     a: {gear: {teeth: 20, module: module}}
    b: {gear: {teeth: 60}}                     parameters: {module: mm}   (a symbol without a value)

What drives what depends on the teeth alone; how large the wheels are stands in the answers as the module.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import cast

from freebody.connections.base import Connection
from freebody.language.sentences import Message
from freebody.model.shapes.base import Shape
from freebody.model.written_kinds import written_kind
from freebody.system.reading.written.form import Entry, Written

_UNIT = "mm"


def with_modules(w: Written) -> None:
    """Gives gears without a module that of what they mesh with, or a symbol for all that mesh with each other."""
    gears = dict(_gears(w))
    open_ = [name for name, fields in gears.items() if "module" not in fields]
    parameters = w.data.get("parameters")
    if not open_ or not isinstance(parameters, dict | None):
        return
    groups = _groups(w, gears)
    left = [group for group in groups if not any("module" in gears[name] for name in group)]
    for group in groups:
        module = next((gears[name]["module"] for name in group if "module" in gears[name]), None)
        if module is None:
            module = _symbol(w, "module" if len(left) == 1 else f"module_{group[0]}")
            told = Message("the module of {names} is left open: {module}", names=", ".join(group), module=module)
            w.assumed.append(told)
        for name in group:
            gears[name].setdefault("module", module)


def _gears(w: Written) -> Iterator[tuple[str, Entry]]:
    """The bodies that are given by teeth, with the fields of their shape; a radius says how large a gear is."""
    bodies = w.data.get("bodies")
    for name, entry in cast("Entry", bodies).items() if isinstance(bodies, dict) else ():
        for word, value in cast("Entry", entry).items() if isinstance(entry, dict) else ():
            kind = written_kind(word, value, Shape.kinds, space=w.space) if isinstance(value, dict) else None
            fields = cast("Entry", value) if isinstance(value, dict) else {}
            own = set[str]() if kind is None else Shape.kinds[kind].model_fields.keys()
            if {"teeth", "module"} <= own and "teeth" in fields and "radius" not in fields:
                entry[word] = dict(fields)  # the document keeps its own
                yield name, entry[word]


def _groups(w: Written, gears: dict[str, Entry]) -> list[list[str]]:
    """The gears that mesh with each other, one after the other in the order of the file."""
    found = [[name] for name in gears]
    for pair in _meshes(w):
        joined = [group for group in found if {*group} & {*pair}]
        if len(joined) == 2 and {*pair} <= gears.keys():
            joined[0] += joined[1]
            found.remove(joined[1])
    order = [*gears]
    return [sorted(group, key=order.index) for group in found]


def _meshes(w: Written) -> Iterator[tuple[str, str]]:
    connections = w.data.get("connections")
    for entry in cast("Entry", connections).values() if isinstance(connections, dict) else ():
        for word, value in cast("Entry", entry).items() if isinstance(entry, dict) else ():
            kind = written_kind(word, value, Connection.kinds, space=w.space)
            spec = None if kind is None else Connection.kinds[kind]
            if spec is not None and {"first", "second", "module", "teeth"} <= spec.model_fields.keys():
                fields = spec.from_plain(value)
                first, second = fields.get("first"), fields.get("second")
                if isinstance(first, str) and isinstance(second, str):
                    yield first, second


def _symbol(w: Written, name: str) -> str:
    """A parameter of that name without a value."""
    there = cast("Entry", w.data.get("parameters") or {})
    while name in there:
        name += "_"
    w.data["parameters"] = {**there, name: _UNIT}
    return name
