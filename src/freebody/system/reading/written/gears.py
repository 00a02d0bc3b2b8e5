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
from typing import Any, cast

from freebody.connections.base import Connection
from freebody.language.sentences import Message
from freebody.measures.geometry import GROUND
from freebody.model.shapes.base import Shape
from freebody.model.spec import MEANT
from freebody.model.written_kinds import written_kind
from freebody.system.reading.written.form import Entry, Written, are_mappings
from freebody.system.reading.written.toothed import of_wheel

_UNIT, _PIN, _MESH, _WELD = "mm", "pin", "gear_mesh", "weld"
# what does not carry an axle, whatever it does to the wheel on it
_LOOSE = (_MESH, "driver", "string", "heavy_rope", "belt", "chain", "brake", "disc_clutch", "dry_friction", "stop")


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
    """Puts the axles of gears that mesh, each a point of the ground without a place, beside those whose place is known;
    where none is, side by side from the origin."""
    if w.space or not are_mappings(w, "bodies", "connections"):
        return
    ground = w.data.get("ground") or {}
    given = cast("Entry", ground).get("points") or {} if isinstance(ground, dict) else None
    radii = dict(radii_of(w))
    axles = {gear: point for gear, point in axles_of(w) if gear in radii}
    if isinstance(given, list) and {*map(str, cast("list[Any]", given))} == {*axles.values()}:
        given = {}  # names without places
    if not isinstance(given, dict) or len({*axles.values()}) < max(2, len(axles)):
        return
    known = cast("Entry", given)
    open_ = {gear: point for gear, point in axles.items() if point not in known}
    if not open_ or not _own_points(w) <= {*known, *axles.values()}:
        return
    places = _side_by_side(w, axles, known, radii)
    if places is None or not open_.keys() <= places.keys():
        return
    own = {point: places[gear] for gear, point in open_.items()}
    w.data["ground"] = {**cast("Entry", ground), "points": {**known, **own}}
    w.assumed.append(
        Message("the axles {names} stand side by side, as far apart as the gears mesh", names=", ".join(axles.values()))
    )


def _side_by_side(
    w: Written, axles: dict[str, str], known: Entry, radii: dict[str, str]
) -> dict[str, list[Any]] | None:
    """By the gears whose axles are on the ground, where each is, to the right of one with which it meshes; None where
    the train is closed or in two parts, so that more than the radii tells the places."""
    places = {gear: known[point] for gear, point in axles.items() if _is_place(known.get(point))}
    pairs = [(a, b, internal) for a, b, internal in meshing(w) if {a, b} <= axles.keys()]
    if not places and pairs:
        places[pairs[0][0]] = ["0", 0]
    told = {*places}
    while left := [pair for pair in pairs if not {*pair[:2]} <= places.keys() and {*pair[:2]} & places.keys()]:
        first, second, internal = left[0]
        there, new = (first, second) if first in places else (second, first)
        apart = f"({radii[first]}) {'-' if internal else '+'} ({radii[second]})"
        x, y = places[there]
        places[new] = [apart if str(x) == "0" else f"{x} + {apart}", y]
        pairs.remove(left[0])
    if any(not {a, b} <= told for a, b, _internal in pairs):
        return None
    return places


def _is_place(value: Any) -> bool:
    return isinstance(value, list) and len(cast("list[Any]", value)) == 2 and None not in value


def bear_gears(w: Written) -> None:
    """Gives gears of a train whose axles nothing carries bearings of their own, each at its place."""
    if w.space or not are_mappings(w, "ground", "bodies", "connections"):
        return
    meshes = [*meshing(w)]
    gears = list(dict.fromkeys(name for first, second, _internal in meshes for name in (first, second)))
    known, bodies = dict(radii_of(w)), cast("Entry", w.data.get("bodies") or {})
    ground = cast("Entry", w.data.get("ground") or {})
    if not {*gears} <= known.keys():
        return
    carrying = [fields for kind, fields in joining(w) if kind not in (*_LOOSE, _WELD)]
    shafts = [[gear, *_welded(w, gear)] for gear in gears]
    loose = [s for s in shafts if not any(_is_fixed(bodies[body]) or _is_named(body, carrying) for body in s)]
    borne = {*(gear for gear, _point in axles_of(w)), *(body for shaft in loose for body in shaft)}
    borne |= {
        body for shaft in shafts if any(_is_fixed(bodies[each]) or each in borne for each in shaft) for body in shaft
    }
    beside = {gear for first, second, _internal in meshes for gear in (first, second) if not {first, second} <= borne}
    if any(_is_planet(shaft[0], meshes) or shaft[0] in beside for shaft in loose):
        return  # which axle is meant the file does not say: one goes round
    if _turn_beside(w, {body for shaft in shafts for body in shaft}):
        return  # an arm may carry what nothing holds
    first_ones = [s[0] for k, s in enumerate(loose) if not any({*s} & {*other} for other in loose[:k])]
    put = {gear: bodies[gear]["at"] for gear in first_ones if "at" in bodies[gear]}
    points = ground.get("points") or {}
    if not first_ones or not all(map(_is_place, put.values())) or (put and not isinstance(points, dict)):
        return
    own = {f"bearing_of_{gear}": {_PIN: [f"ground.bearing_of_{gear}", gear]} for gear in first_ones}
    if own.keys() & cast("Entry", w.data["connections"]).keys():
        return
    if put:
        there = {f"bearing_of_{gear}": place for gear, place in put.items()}
        w.data["ground"] = {**ground, "points": {**cast("Entry", points), **there}}
    w.data["connections"] = {**cast("Entry", w.data["connections"]), **own}
    w.moved |= {("connections", f"bearing_of_{gear}"): w.stood(("bodies", gear)) for gear in first_ones}
    told = Message("nothing holds {names}: each turns in a bearing that stands still", names=", ".join(first_ones))
    if len(first_ones) == 1:
        told = Message("nothing holds {name}: it turns in a bearing that stands still", name=first_ones[0])
    w.assumed.append(told)


def _is_planet(gear: str, meshes: list[tuple[str, str, bool]]) -> bool:
    """Whether a gear runs between a ring gear and another one, so that its axle may go round."""
    own = [internal for first, second, internal in meshes if gear in (first, second)]
    return len(own) > 1 and any(own)


def _turn_beside(w: Written, train: set[str]) -> bool:
    """Whether other bodies turn about a bearing of a train: are pinned to the middle of a gear, or where one is."""
    bodies = cast("Entry", w.data.get("bodies") or {})
    pins = [_ends(w, fields) for kind, fields in joining(w) if kind == _PIN]
    middles = {*train, *(f"{name}.center" for name in train)}
    axles = middles | {end for ends in pins if {*ends} & middles for end in ends}
    others = {name for name, entry in bodies.items() if name not in train and not _is_fixed(entry)}
    return any({*ends} & axles and {end.partition(".")[0] for end in ends} & others for ends in pins)


def _ends(w: Written, fields: Entry) -> list[str]:
    """What a pin joins, a point of the ground as its place."""
    ground = cast("Entry", w.data.get("ground") or {})
    points = ground.get("points")
    known = cast("Entry", points) if isinstance(points, dict) else {}
    listed = [
        each
        for value in fields.values()
        for each in (value if isinstance(value, list) and not _is_place(value) else [value])
    ]
    places = {GROUND: [0, 0], **{f"{GROUND}.{name}": place for name, place in known.items()}}
    return [str(places.get(each, each) if isinstance(each, str) else each) for each in listed]


def _is_fixed(entry: Any) -> bool:
    """Whether a body says that it stands still."""
    said = cast("Entry", entry) if isinstance(entry, dict) else {}
    return any("fixed" in (key, *MEANT.get(key, ())) for key in said)


def _welded(w: Written, gear: str) -> list[str]:
    """The bodies on one shaft with a gear: welded to it, or to what is."""
    bodies = [*cast("Entry", w.data.get("bodies") or {})]
    welds = [fields for kind, fields in joining(w) if kind == _WELD]
    shaft = [gear]
    for body in shaft:
        for fields in welds:
            if _is_named(body, [fields]):
                shaft += [each for each in bodies if each not in shaft and _is_named(each, [fields])]
    return shaft[1:]


def _is_named(body: str, fields: list[Entry]) -> bool:
    return re.search(rf"(?<![\w.]){re.escape(body)}\b", str(fields)) is not None


def _own_points(w: Written) -> set[str]:
    """The points of the ground that connections and loads name."""
    texts = str([w.data.get(section) for section in ("connections", "loads", "measures")])
    return {*re.findall(r"\bground\.(\w+)", texts)}


def radii_of(w: Written) -> Iterator[tuple[str, str]]:
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


def axles_of(w: Written) -> Iterator[tuple[str, str]]:
    """The bodies that are pinned to the ground by themselves, with the points there."""
    for kind, fields in joining(w):
        first, second = str(fields.get("first")), str(fields.get("second"))
        if second.startswith("ground."):
            first, second = second, first
        wheel = second.removesuffix(".center")
        if kind == _PIN and first.startswith("ground.") and "." not in wheel:
            yield wheel, first.removeprefix("ground.")


def meshing(w: Written) -> Iterator[tuple[str, str, bool]]:
    """The gears that mesh, and whether one of them is a ring gear."""
    rings = {name for name, fields in _gears(w, every=True) if fields.get("internal") is True}
    for kind, fields in joining(w):
        first, second = fields.get("first"), fields.get("second")
        if kind == _MESH and isinstance(first, str) and isinstance(second, str):
            yield first, second, fields.get("internal") is True or bool(rings & {first, second})


def joining(w: Written) -> Iterator[tuple[str, Entry]]:
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
            fields = cast("Entry", of_wheel(w, value, n_is_teeth=True)) if isinstance(value, dict) else {}
            own = set[str]() if kind is None else Shape.kinds[kind].model_fields.keys()
            if {"teeth", "module"} <= own and (every or ("teeth" in fields and "radius" not in fields)):
                entry[word] = fields  # the document keeps its own
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
