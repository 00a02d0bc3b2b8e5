"""Ropes over pulleys, of which a file says less than there is in the figure.

rope: {from: block, over: pulley, to: weight}      connections: {axle_of_pulley: {pin: [ground.axle_of_pulley, pulley]}}
    (nothing else holds the pulley; one that the file does not know is a disk without mass)
floor: {contact: [block, incline], mu: 0.2}        floor: {slider: {body: block, along: incline, friction: 0.2}}
    (a point mass that the rope pulls along the incline)
rope: {from: drum, to: load}                       rope: {from: wound on drum, to: load}   (a drum on an axle)
rope: {from: ceiling, to: yoyo, radius: r}         rope: {from: ceiling, to: wound on yoyo radius r}

A pulley on the way of a rope from one body to another one turns about an axle that stands still: else the rope would
only pull it down. The figure has the rope parallel to the line on which the body lies, and the pulley where that
leads it: a contact would ask for the place of the pulley, and would have the rope run at an angle to the line.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import Any, cast

from freebody.connections.base import Connection
from freebody.language.sentences import Message
from freebody.measures.geometry import GROUND
from freebody.model.names import is_of_surroundings
from freebody.model.written_kinds import written_kind
from freebody.system.reading.written.form import Entry, Written, are_mappings, kinds_of, shape_of

_ROPES = ("string", "heavy_rope", "belt", "chain", "gear_mesh", "rolling")
_WELD, _DISK = "weld", "disk"
_STRING, _PIN, _CONTACT, _SLIDER, _POINT = "string", "pin", "contact", "slider", "particle"


def hold_pulleys(w: Written) -> None:
    """Gives pulleys that nothing holds an axle, and leads bodies that a rope pulls along a line."""
    bodies, connections = w.data.get("bodies"), w.data.get("connections")
    if w.space or not isinstance(bodies, dict) or not isinstance(connections, dict):
        return
    if not are_mappings(w, "loads", "ground"):
        return
    bodies, connections = cast("Entry", bodies), cast("Entry", connections)
    for string, fields in [*of_kind(connections, _STRING)]:
        _add_pulleys(w, string, fields)
        _wind(w, string, fields)
        _add_ends(w, fields)
    bodies, connections = cast("Entry", w.data["bodies"]), cast("Entry", w.data["connections"])
    for string, fields in [*of_kind(connections, _STRING)]:
        ends = [str(fields.get(end, "")).partition(".")[0] for end in ("from", "to")]
        if not all(end in bodies for end in ends) or ends[0] == ends[1]:
            continue
        over = [body for body in _listed(fields.get("over")) if _is_round(bodies.get(body)) and body not in ends]
        for body in over:
            others = {name: each for name, each in connections.items() if name != string}
            loads = cast("Entry", w.data.get("loads") or {})
            if not is_named(body, others) and not is_named(body, loads) and not {"at", "fixed"} & {*bodies[body]}:
                _give_axle(w, string, body)
        if over:
            for end in ends:
                _lead(w, string, end, over)


def _add_pulleys(w: Written, string: str, fields: Entry) -> None:
    """A pulley on the way of a rope between two bodies that the file names there alone, as the figure does."""
    ends = [str(fields.get(end, "")).partition(".")[0] for end in ("from", "to")]
    elsewhere = {name: each for name, each in w.data["connections"].items() if name != string}
    elsewhere |= {key: w.data.get(key) for key in ("ground", "parameters")}
    for name in _listed(fields.get("over")) if all(end in w.data["bodies"] for end in ends) else ():
        is_pulley = written_kind(name, None, kinds_of("bodies"), space=False) == _DISK
        if is_pulley and name not in w.data["bodies"] and not _is_word_of(name, elsewhere):
            w.data["bodies"] = {**w.data["bodies"], name: {_DISK: None}}
            w.moved["bodies", name] = w.stood(("connections", string))
            w.assumed.append(Message("{name} is no body of the file: it is a disk without mass", name=name))


def _add_ends(w: Written, fields: Entry) -> None:
    """An end of a rope that no body is, and at which a force acts: a point without mass, as the hand that pulls."""
    way = fields.get("path")
    ends = [
        fields.get("from"),
        fields.get("to"),
        *(cast("list[Any]", way)[:1] + cast("list[Any]", way)[-1:] if isinstance(way, list) else []),
    ]
    pushed = [
        cast("Entry", each).get("at")
        for entry in cast("Entry", w.data.get("loads") or {}).values()
        if isinstance(entry, dict)
        for each in cast("Entry", entry).values()
        if isinstance(each, dict)
    ]
    for end in ends:
        is_name = isinstance(end, str) and end.isidentifier() and end not in _places(w) and not is_of_surroundings(end)
        if is_name and end in pushed and end not in w.data["bodies"]:
            w.data["bodies"] = {**w.data["bodies"], str(end): {_POINT: None}}
            w.moved["bodies", str(end)] = w.stood(("connections",))
            w.assumed.append(Message("{end} is no body of the file: it is a point without mass", end=end))


def _wind(w: Written, string: str, fields: Entry) -> None:
    """A rope that ends at a drum on a fixed axle, or at one with a hub, or that says the radius there."""
    bodies = cast("Entry", w.data["bodies"])
    round_ends = [end for end in ("from", "to") if _is_round(bodies.get(str(fields.get(end))))]
    radius = fields.get("radius")
    borne = {
        end
        for end in round_ends
        if any(True for each in _shaft(w, str(fields[end])) for _ in _axles(w, each)) and _is_free(w, str(fields[end]))
    }
    wound = {end: f"wound on {fields[end]}" for end in round_ends if end in borne}
    if radius is not None and len(round_ends) == 1:
        wound = {round_ends[0]: f"wound on {fields[round_ends[0]]} radius {radius}"}
    elif len(round_ends) == 1 and _has_hub(bodies[str(fields[round_ends[0]])]):
        wound = {round_ends[0]: f"wound on {fields[round_ends[0]]}.hub"}
    hubs = {end: body for end in ("from", "to") if (body := _hub_of(bodies, fields.get(end))) is not None}
    wound |= {end: f"wound on {body}.hub" for end, body in hubs.items() if radius is None}
    if not wound or (radius is not None and len(round_ends) != 1):
        return
    ((word, _value),) = w.data["connections"][string].items()
    read = {key: wound.get(key, each) for key, each in fields.items() if key != "radius"}
    w.data["connections"] = {**w.data["connections"], string: {word: read}}
    for way in wound.values():
        w.assumed.append(Message("{string} is {way}, not tied to its middle", string=string, way=way))


def _shaft(w: Written, wheel: str) -> list[str]:
    """A wheel and those that are welded to it middle to middle: they turn about one axle."""
    found = [wheel]
    for each in found:
        for _name, fields in of_kind(w.data["connections"], _WELD):
            ends = [str(fields.get(end)).removesuffix(".center") for end in ("first", "second")]
            if each in ends and all(_is_round(w.data["bodies"].get(end)) for end in ends):
                found += [end for end in ends if end not in found]
    return found


def _is_free(w: Written, body: str) -> bool:
    """Whether one rope alone names a wheel: what else runs round it shows that its axle is meant."""
    ropes = [
        fields for kind in _ROPES for _name, fields in of_kind(w.data["connections"], kind) if is_named(body, fields)
    ]
    return len(ropes) == 1 and not any(is_named(body, {key: ropes[0].get(key)}) for key in ("over", "under", "path"))


def _hub_of(bodies: Entry, end: Any) -> str | None:
    """The wheel whose hub an end names, which is a circle and no point: wheel.hub."""
    body, _, place = str(end).partition(".")
    return body if place == "hub" and _is_round(bodies.get(body)) and _has_hub(bodies[body]) else None


def _has_hub(entry: Any) -> bool:
    return any(isinstance(each, dict) and "hub" in each for each in cast("Entry", entry).values())


def _give_axle(w: Written, string: str, body: str) -> None:
    axle = f"axle_of_{body}"
    if axle in w.data["connections"]:
        return
    w.data["connections"] = {**w.data["connections"], axle: {_PIN: [f"{GROUND}.{axle}", body]}}
    w.moved["connections", axle] = w.stood(("bodies", body))
    told = Message(
        "nothing but {string} holds {body}: it turns about an axle that stands still", string=string, body=body
    )
    w.assumed.append(told)


def _lead(w: Written, string: str, body: str, over: list[str]) -> None:
    """A point mass that lies on a line of the ground, as one that a rope pulls along it."""
    entry = w.data["bodies"][body]
    if (shape := shape_of(entry)) is None or shape.kind != _POINT or {"at", "near", "velocity"} & {*entry}:
        return
    places = _places(w)
    if any(point in places for name in over for point in _axles(w, name)):
        return
    holding = [name for name, each in w.data["connections"].items() if name != string and is_named(body, {name: each})]
    contacts = [(name, fields) for name, fields in of_kind(w.data["connections"], _CONTACT) if name in holding]
    if len(contacts) != 1 or len(holding) != 1:
        return
    ((name, fields),) = contacts
    lines = [each.removeprefix(f"{GROUND}.") for each in _listed(fields.get("between")) if each != body]
    if len(lines) != 1 or lines[0] not in _lines(w) or not fields.keys() <= {"between", "friction"}:
        return
    rough = {"friction": fields["friction"]} if "friction" in fields else {}
    w.data["connections"][name] = {_SLIDER: {"body": body, "along": lines[0], **rough}}
    told = Message(
        "{string} pulls {body} parallel to {line}, on which it stays", string=string, body=body, line=lines[0]
    )
    w.assumed.append(told)


def of_kind(connections: Entry, wanted: str) -> Iterator[tuple[str, Entry]]:
    """The connections of one kind, with their fields."""
    for name, entry in connections.items():
        fields = cast("Entry", entry) if isinstance(entry, dict) else {}
        for word, value in fields.items() if len(fields) == 1 else ():
            if written_kind(word, value, Connection.kinds, space=False) == wanted:
                yield name, Connection.kinds[wanted].from_plain(value)


def _axles(w: Written, body: str) -> Iterator[str]:
    """The points of the ground to which a body is pinned."""
    for _name, fields in of_kind(w.data["connections"], _PIN):
        ends = [str(fields.get(end)) for end in ("first", "second")]
        if any(end.partition(".")[0] == body for end in ends):
            yield from (end.removeprefix(f"{GROUND}.") for end in ends if end.startswith(GROUND))


def _places(w: Written) -> Entry:
    ground = w.data.get("ground")
    points = cast("Entry", ground).get("points") if isinstance(ground, dict) else None
    return cast("Entry", points) if isinstance(points, dict) else {}


def _lines(w: Written) -> Entry:
    """Lines of the ground that go through no point that the file names."""
    ground = w.data.get("ground")
    lines = cast("Entry", ground).get("lines") if isinstance(ground, dict) else None
    found = cast("Entry", lines) if isinstance(lines, dict) else {}
    own = {name: line for name, line in found.items() if not isinstance(line, dict) or "through" not in line}
    return {"floor": None, "table": None, **own}


def _is_round(entry: Any) -> bool:
    shape = shape_of(entry)
    return shape is not None and "radius" in shape.model_fields


def is_named(body: str, entries: Entry) -> bool:
    return re.search(rf"(?<![\w.]){re.escape(body)}\b", str([*entries.values()])) is not None


def _is_word_of(name: str, entries: Entry) -> bool:
    return re.search(rf"\b{re.escape(name)}\b", str(entries)) is not None


def _listed(value: Any) -> list[str]:
    return (
        [str(each) for each in cast("list[Any]", value)]
        if isinstance(value, list)
        else []
        if value is None
        else [str(value)]
    )
