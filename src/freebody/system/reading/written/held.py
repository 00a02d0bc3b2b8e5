"""Bodies that say in themselves what they lie on or turn about, and lines that say how rough they are.

crate: {block: {mass: m}, on: slope, mu: 0.2}      connections: {crate_on_slope: {contact: [crate, slope], mu: 0.2}}
drum: {disk: {radius: R}, pivot: [0, 1 m]}         connections: {drum_pivot: {pin: [[0, 1 m], drum]}}
tip: {particle: {mass: m}, attached_to: rod.end}   connections: {tip_attached: {weld: [rod.end, tip]}}
lines: {slope: {angle: 30 deg, friction: mu}}      the friction of everything that touches the slope

What is round may slide or roll where it lies, and what is not may be held at any of its points: such a file is told.
"""

from __future__ import annotations

import re
from math import cos
from typing import Any, cast

from freebody.connections.base import Connection
from freebody.language.folded import folded
from freebody.language.sentences import Message
from freebody.measures.geometry import GROUND
from freebody.model.spec import Spec
from freebody.model.written_kinds import written_kind
from freebody.system.reading.sections import ATTACHED, HINGED, LIES_ON, ROUGH
from freebody.system.reading.written.dimensions import value_said
from freebody.system.reading.written.entries import rolling_with_friction
from freebody.system.reading.written.form import Entry, Written, as_option, keys_beside, shape_of
from freebody.system.reading.written.scalars import PLACES_OF_BODIES

_ROLLING, _WALL = "rolling", "wall"
_CONTACT, _PIN, _WELD, _POINT = "contact", "pin", "weld", "particle"
_LED, _ON, _ALONG = ("body", "pin"), "on", "along"
_OF_TOUCHING = {"friction", "restitution"}
_BEARING = (_CONTACT, "slider", "slot", _ROLLING, _WELD)
_ENDS = {"start": -1, "end": 1}  # of a rod, along its x axis


def hold_bodies(w: Written) -> None:
    """Takes what bodies say of how they are held among the connections."""
    bodies, connections = w.data.get("bodies"), w.data.get("connections") or {}
    if w.space or not isinstance(bodies, dict) or not isinstance(connections, dict):
        return
    for name, entry in [*cast("Entry", bodies).items()]:
        shape = shape_of(entry)
        held = {} if shape is None else _held(name, cast("Entry", entry), shape, cast("Entry", connections))
        for key, (called, connection, own) in held.items():
            ends = connection.get(_PIN, [""])
            if isinstance(ends[0], str) and ends[0].isidentifier() and ends[0] not in bodies and ends[0] != GROUND:
                held[key] = called, {_PIN: [f"{GROUND}.{ends[0]}", *ends[1:]]}, own
        for key, (called, connection, own) in held.items():
            if called in connections:
                continue
            if connection:
                connections = {**cast("Entry", connections), called: connection}
                w.data["connections"] = connections
                w.moved["connections", called] = (*w.stood(("bodies", name)), key)
            rest = cast("Entry", w.data["bodies"][name])
            w.data["bodies"][name] = {k: v for k, v in rest.items() if k != key and k not in own}


def lead_what_is_on(w: Written) -> None:
    """`{slider: {on: ram, along: up}}` that says no body: where every body is held and nothing else guides the ram,
    what might be on it is nothing of the file, so the ram is guided, on the ground. That is told."""
    bodies, connections = w.data.get("bodies"), w.data.get("connections")
    if not isinstance(bodies, dict) or not isinstance(connections, dict):
        return
    guides: dict[str, tuple[str, str, Entry]] = {}  # by the connections: the word, the field of what is led, the fields
    for name, entry in cast("Entry", connections).items():
        for word, value in cast("Entry", entry).items() if isinstance(entry, dict) else ():
            kind = written_kind(word, value, Connection.kinds, space=w.space)
            known = {} if kind is None else Connection.kinds[kind].model_fields
            led = next((field for field in _LED if field in known), None)
            if kind is not None and led is not None and {_ON, _ALONG} <= known.keys():
                guides[name] = word, led, Connection.kinds[kind].from_plain(value)
    for name, (word, led, fields) in guides.items():
        body = str(fields.get(_ON)).partition(".")[0]
        others = [each.get(field, each.get(_ON)) for other, (_w, field, each) in guides.items() if other != name]
        is_held = all(_names([*connections.values()], each) for each in cast("Entry", bodies))
        is_free = body in bodies and not any(_names(each, body) for each in (*others, fields.get(_ALONG)))
        if led in fields or not is_held or not is_free:
            continue
        read = {led if key == _ON else key: each for key, each in fields.items()}
        w.data["connections"] = {**w.data["connections"], name: {**connections[name], word: read}}
        w.assumed.append(Message("{name} guides {body}, along a line of the ground", name=name, body=body))


def _held(name: str, entry: Entry, shape: type[Spec], connections: Entry) -> dict[str, tuple[str, Entry, Entry]]:
    """By the keys of a body that say how it is held: the connection and its name, and what else says of it."""
    found: dict[str, tuple[str, Entry, Entry]] = {}
    is_round = "radius" in shape.model_fields
    beside = keys_beside("bodies", space=False)
    rough = {key: value for key, value in entry.items() if key in ROUGH}
    for key, value in entry.items():
        if as_option(key, beside) and key not in LIES_ON:
            continue
        if key in LIES_ON and isinstance(value, str) and not is_round:
            on, called = value.rsplit(".", 1)[-1], f"{name}_on_{value.replace('.', '_')}"
            is_told = any(_bears(each) and _names(each, name) and _names(each, on) for each in connections.values())
            found[key] = called, {} if is_told else {_CONTACT: {"between": [name, value], **rough}}, rough
        elif folded(key) in ATTACHED and isinstance(value, str) and (is_round or shape.kind == _POINT):
            found[key] = f"{name}_attached", {_WELD: [value, name]}, {}
        elif folded(key) in HINGED and isinstance(value, str) and (is_round or shape.kind == _POINT):
            found[key] = f"{name}_hinged", {_PIN: [value, name]}, {}
        elif written_kind(key, None, Connection.kinds, space=False) == _PIN and is_round and _is_place(value):
            found[key] = f"{name}_{key}", {_PIN: [value, name]}, {}
    return found


def _bears(entry: Any) -> bool:
    """Whether a connection may say how one body lies on another one: a rope that joins two does not."""
    words = cast("Entry", entry).items() if isinstance(entry, dict) else ()
    return any(written_kind(word, value, Connection.kinds, space=False) in _BEARING for word, value in words)


def ground_as_line(w: Written) -> None:
    """`contact: [ball, ground]`: the ground is its one line, where it has none the floor."""
    ground, connections = w.data.get("ground") or {}, w.data.get("connections")
    lines = cast("Entry", ground).get("lines") or {} if isinstance(ground, dict) else None
    if w.space or not isinstance(lines, dict) or not isinstance(connections, dict) or len(cast("Entry", lines)) > 1:
        return
    (line,) = cast("Entry", lines) or ("floor",)
    for name, entry in cast("Entry", connections).items():
        if (found := _of_touching(entry, {"below"})) is not None:
            word, fields, _kind = found
            read = {key: _with_line(value, line) for key, value in fields.items()}
            if read != fields:
                connections[name] = {**entry, word: read}


def raise_walls(w: Written) -> None:
    """`contact: [ball, wall]`: a wall that nobody declares goes upright through the origin, and is solid on the side on
    which the body is not."""
    ground, connections = w.data.get("ground") or {}, w.data.get("connections")
    if w.space or not isinstance(ground, dict) or not isinstance(connections, dict):
        return
    lines, points = (cast("Entry", ground).get(each) or {} for each in ("lines", "points"))
    bodies = w.data.get("bodies")
    if (
        not isinstance(lines, dict)
        or not isinstance(bodies, dict)
        or any(_WALL in each for each in (lines, points, bodies))
    ):
        return
    touching = [each for each in connections.values() if _names(each, _WALL)]
    found = [_of_touching(each, _OF_TOUCHING) for each in touching]
    if not touching or None in found or _names(w.data.get("loads"), _WALL):
        return  # also a point to which something is tied
    beside = {name for name in bodies for each in touching if _names(each, name)}
    entries = [cast("Entry", bodies[name]) if isinstance(bodies[name], dict) else {} for name in beside]
    places = [next((entry[key] for key in PLACES_OF_BODIES if key in entry), None) for entry in entries]
    left = [value_said(w, at[0]) if isinstance(at, list) and at else None for at in places]
    if len(touching) == len(beside) == 1 and places == [None]:
        left = [_side_of_end(w, next(iter(beside)), entries[0], touching[0])]
    sides = {x > 0 for x in left if x}
    if None in left or len(sides) != 1:
        return
    (is_on_left,) = sides
    solid = "left" if is_on_left else "right"
    w.data["ground"] = {**ground, "lines": {**lines, _WALL: {"through": [0, 0], "solid": solid}}}
    w.assumed.append(
        Message("{wall} goes upright through the origin and is solid on the {side}", wall=_WALL, side=solid)
    )


def _side_of_end(w: Written, name: str, entry: Entry, touching: Any) -> float | None:
    """On which side of a wall a rod stands that leans on it with one end: where that end points, the wall is."""
    ends = [end for end in _ENDS if _names(touching, f"{name}.{end}")]
    angle = value_said(w, entry.get("angle")) if "angle" in entry else None
    return None if len(ends) != 1 or angle is None else -_ENDS[ends[0]] * cos(angle)


def _with_line(value: Any, line: str) -> Any:
    if isinstance(value, list):
        return [_with_line(each, line) for each in cast("list[Any]", value)]
    return line if value == GROUND else value


def roughen_lines(w: Written) -> None:
    """`lines: {slope: {angle: 30 deg, friction: mu}}`: what touches a line has its friction where it says no other."""
    ground, connections = w.data.get("ground"), w.data.get("connections")
    lines = cast("Entry", ground).get("lines") if isinstance(ground, dict) else None
    if w.space or not isinstance(lines, dict) or not isinstance(connections, dict):
        return
    for name, line in [*cast("Entry", lines).items()]:
        said = cast("Entry", line) if isinstance(line, dict) else {}
        rough = {key: value for key, value in said.items() if key in ROUGH}
        touching = [called for called in connections if rough and _names(connections[called], name)]
        for called in touching:
            if (found := _of_touching(connections[called], _OF_TOUCHING)) is not None:
                word, own, kind = found
                added = {key: value for key, value in kind.from_plain(rough).items() if key not in own}
                connections[called] = {**connections[called], word: {**own, **added}}
            elif isinstance(connections[called], dict) and len(connections[called]) == 1:
                ((word, _value),) = connections[called].items()
                if written_kind(word, _value, Connection.kinds, space=False) == _ROLLING:
                    connections[called] = rolling_with_friction(w, called, {**connections[called], **rough}, word)
        if touching:
            left = {key: value for key, value in said.items() if key not in rough}
            lines = {k: left if k == name else v for k, v in cast("Entry", lines).items() if k != name or left}
            w.data["ground"] = {**cast("Entry", ground), "lines": lines}


def _of_touching(entry: Any, fields: set[str]) -> tuple[str, Entry, type[Spec]] | None:
    """The word for its kind, its fields and its kind, of a connection whose kind has some of these fields."""
    for word, value in cast("Entry", entry).items() if isinstance(entry, dict) else ():
        kind = written_kind(word, value, Connection.kinds, space=False)
        if kind is not None and fields & Connection.kinds[kind].model_fields.keys():
            return word, Connection.kinds[kind].from_plain(value), Connection.kinds[kind]
    return None


def _names(entry: Any, name: str) -> bool:
    return re.search(rf"\b{re.escape(name)}\b", str(entry)) is not None


def _is_place(value: Any) -> bool:
    """Coordinates, or the name of a point."""
    return isinstance(value, list) or (isinstance(value, str) and value.replace(".", "_").isidentifier())
