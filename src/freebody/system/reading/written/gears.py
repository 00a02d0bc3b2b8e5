"""Gears by their numbers of teeth alone: gears that mesh have one module, which is that of their partner or left open.

    a: {gear: {teeth: 20}}                     a: {gear: {teeth: 20, module: module}}
    b: {gear: {teeth: 60}}                     parameters: {module: mm}   (a symbol without a value)

What drives what depends on the teeth alone; how large the wheels are stands in the answers as the module. Axles of
gears that mesh, of which no place is told, are put side by side as far apart as the teeth have them: r1 + r2, in a
ring gear r1 - r2.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import cast

from freebody.connections.base import Connection
from freebody.language.sentences import Message
from freebody.language.units import LENGTH, MASS
from freebody.model.shapes.base import Shape
from freebody.model.written_kinds import written_kind
from freebody.system.reading.written.dimensions import dimension_said
from freebody.system.reading.written.form import Entry, Written, are_mappings

_UNIT, _PIN, _MESH = "mm", "pin", "gear_mesh"


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


def place_axles(w: Written) -> None:
    """Puts the axles of gears that mesh, each a point of the ground without a place, side by side."""
    ground = w.data.get("ground")
    points = cast("Entry", ground).get("points") if isinstance(ground, dict) else None
    if not are_mappings(w, "ground", "bodies", "connections"):
        return
    radii = dict(_radii(w))
    axles = {gear: point for gear, point in _axles(w) if gear in radii}
    if w.space or points or len({*axles.values()}) < max(2, len(axles)) or len(_own_points(w)) > len(axles):
        return
    places: dict[str, str] = {}
    for first, second, internal in _meshing(w):
        if not {first, second} <= axles.keys():
            continue
        places.setdefault(first, "0")
        if second in places:
            return
        apart = f"({radii[first]}) {'-' if internal else '+'} ({radii[second]})"
        places[second] = apart if places[first] == "0" else f"{places[first]} + {apart}"
    if places.keys() != axles.keys() or sum(place == "0" for place in places.values()) > 1:
        return
    w.data["ground"] = {**cast("Entry", ground or {}), "points": {axles[gear]: [x, 0] for gear, x in places.items()}}
    w.assumed.append(
        Message("the axles {names} stand side by side, as far apart as the gears mesh", names=", ".join(axles.values()))
    )


def bear_gears(w: Written) -> None:
    """Gives the gears of a train of which nothing says how any is held bearings of their own, each at its place."""
    if w.space or not are_mappings(w, "bodies", "connections"):
        return
    pairs = [(first, second) for first, second, _internal in _meshing(w)]
    gears = list(dict.fromkeys(name for pair in pairs for name in pair))
    known = dict(_radii(w))
    others = [fields for kind, fields in _joining(w) if kind not in (_MESH, "driver")]
    is_held = any(re.search(rf"(?<![\w.]){re.escape(gear)}\b", str(others)) for gear in gears)
    bodies = cast("Entry", w.data.get("bodies") or {})
    if not gears or is_held or not {*gears} <= known.keys() or any({"at", "fixed"} & {*bodies[gear]} for gear in gears):
        return
    own = {f"bearing_of_{gear}": {_PIN: [f"ground.bearing_of_{gear}", gear]} for gear in gears}
    w.data["connections"] = {**cast("Entry", w.data["connections"]), **own}
    w.moved |= {("connections", f"bearing_of_{gear}"): w.stood(("bodies", gear)) for gear in gears}
    w.assumed.append(
        Message("nothing holds {names}: each turns in a bearing that stands still", names=", ".join(gears))
    )


def _own_points(w: Written) -> set[str]:
    """The points of the ground that connections and loads name."""
    texts = str([w.data.get(section) for section in ("connections", "loads", "measures")])
    return {*re.findall(r"\bground\.(\w+)", texts)}


def _radii(w: Written) -> Iterator[tuple[str, str]]:
    """The radii of gears, as formulas."""
    bodies = w.data.get("bodies")
    for name, entry in cast("Entry", bodies).items() if isinstance(bodies, dict) else ():
        for word, value in cast("Entry", entry).items() if isinstance(entry, dict) else ():
            kind = written_kind(word, value, Shape.kinds, space=w.space) if isinstance(value, dict) else None
            fields = {} if kind is None else Shape.kinds[kind].from_plain(value)
            if "radius" in fields:
                yield name, str(fields["radius"])
            elif {"teeth", "module"} <= fields.keys():
                yield name, f"({fields['teeth']})*({fields['module']})/2"


def _axles(w: Written) -> Iterator[tuple[str, str]]:
    """The bodies that are pinned to the ground by themselves, with the points there."""
    for kind, fields in _joining(w):
        first, second = str(fields.get("first")), str(fields.get("second"))
        if kind == _PIN and first.startswith("ground.") and "." not in second:
            yield second, first.removeprefix("ground.")


def _meshing(w: Written) -> Iterator[tuple[str, str, bool]]:
    """The gears that mesh, and whether one of them is a ring gear."""
    rings = {name for name, fields in _gears(w, every=True) if fields.get("internal") is True}
    for kind, fields in _joining(w):
        first, second = fields.get("first"), fields.get("second")
        if kind == _MESH and isinstance(first, str) and isinstance(second, str):
            yield first, second, fields.get("internal") is True or bool(rings & {first, second})


def _joining(w: Written) -> Iterator[tuple[str, Entry]]:
    """The connections of the plane: the kind and the fields of each."""
    connections = w.data.get("connections")
    for entry in cast("Entry", connections).values() if isinstance(connections, dict) else ():
        for word, value in cast("Entry", entry).items() if isinstance(entry, dict) else ():
            kind = written_kind(word, value, Connection.kinds, space=w.space)
            if kind is not None:
                yield kind, Connection.kinds[kind].from_plain(value)


def _gears(w: Written, *, every: bool = False) -> Iterator[tuple[str, Entry]]:
    """The bodies that are given by teeth, with the fields of their shape; a radius says how large a gear is (every: of
    those with a radius, too)."""
    bodies = w.data.get("bodies")
    for name, entry in cast("Entry", bodies).items() if isinstance(bodies, dict) else ():
        for word, value in cast("Entry", entry).items() if isinstance(entry, dict) else ():
            kind = written_kind(word, value, Shape.kinds, space=w.space) if isinstance(value, dict) else None
            fields = cast("Entry", value) if isinstance(value, dict) else {}
            own = set[str]() if kind is None else Shape.kinds[kind].model_fields.keys()
            if {"teeth", "module"} <= own and (every or ("teeth" in fields and "radius" not in fields)):
                entry[word] = _with_m(w, dict(fields))  # the document keeps its own
                yield name, entry[word]


def _with_m(w: Written, fields: Entry) -> Entry:
    """`m: 4 mm` is the module, `m: 2 kg` the mass."""
    dimension = dimension_said(w, fields.get("m"))
    meant = None if dimension is None else {LENGTH: "module", MASS: "mass"}.get(dimension)
    if meant is None or meant in fields:
        return fields
    return {meant if key == "m" else key: each for key, each in fields.items()}


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
