"""A linkage as it is drawn: points with their places, links between them, and which points are on the ground.

    points: {A: [0, 0], B: [0, 1 m], C: [3 m, 2 m], D: [2 m, 0]}
    links: {crank: [A, B], coupler: [B, C], rocker: [C, D]}           also {from: A, to: B, mass: m}
    ground: [A, D]                                                    also joints: {A: pin to ground, D: ground}

Links are rods that start where they are drawn, and are hinged where they meet.
"""

from __future__ import annotations

import re
from typing import Any, cast

from freebody.language.expression import name_problem
from freebody.language.folded import folded
from freebody.language.sentences import Message
from freebody.system.reading.written.form import Entry, Written, are_mappings

_LINKS = ("links", "Glieder")
_FRAMES = ("ground", "frame", "fixed", "base", "ground_link", "fixed_link", "gestell")
_HINGED = ("A", "B", "C", "D")
_PLACES = ("points", "nodes", "joints", "Punkte")
_HELD = ("ground", "fixed", "supports", "joints", "pivots")
_ON_GROUND = re.compile(r"\b(ground|grounded|fixed|frame|world|gestell|pin|pinned|support)\b")
_HINGES = re.compile(r"\b(pin|pinned|revolute|hinge|gelenk|drehgelenk)\b")
_ENDS = (("from", "to"), ("start", "end"), ("first", "second"), ("von", "nach"))


def with_linkage(w: Written) -> None:
    """Puts links between points among the bodies, with pins where they meet; whatever else there is stays as it is."""
    _with_four_bars(w)
    links = next((key for key in _LINKS if isinstance(w.data.get(key), dict)), None)
    places = next((key for key in _PLACES if isinstance(w.data.get(key), dict)), None)
    if w.space or links is None or places is None or w.data.get("bodies"):
        return
    nodes = cast("Entry", w.data[places])
    found = {name: _link(entry, nodes) for name, entry in cast("Entry", w.data[links]).items()}
    ends = {name: link[0] for name, link in found.items() if link is not None}
    held = _held(w, places, nodes)
    connections = w.data.get("connections") or {}
    if len(ends) < len(found) or not held or not isinstance(connections, dict) or any(map(name_problem, found)):
        return
    pins = _pins(ends, nodes, [*held])
    if pins.keys() & cast("Entry", connections).keys():
        return
    bodies = {
        name: {"rod": link[1] or None, "at": {"start": nodes[link[0][0]], "end": nodes[link[0][1]]}}
        for name, link in found.items()
        if link is not None
    }
    gone = {links, places, *held.values()}
    rest = {key: value for key, value in w.data.items() if key not in gone}
    w.data = {**rest, "ground": {"points": {node: nodes[node] for node in held}}, "bodies": bodies}
    w.data["connections"] = {**cast("Entry", connections), **pins}
    w.moved |= {("bodies", name): (links, name) for name in bodies} | {("bodies",): (links,)}
    w.moved |= {("connections", node): (places, node) for node in pins}
    w.moved |= {("ground", "points", node): (places, node) for node in held}
    w.assumed.append(Message("the links are rods that are hinged where they meet: {nodes}", nodes=", ".join(pins)))


def _with_four_bars(w: Written) -> None:
    """`links: {ground: 10 cm, crank: 3 cm, coupler: 9 cm, rocker: 7 cm}`: a loop of four by their lengths, the three
    that move in the order in which they are hinged to each other, from the origin to the other point of the ground."""
    key = next((key for key in _LINKS if isinstance(w.data.get(key), dict)), None)
    if key is None or w.space or not are_mappings(w, "bodies", "ground", "connections") or w.data.get("bodies"):
        return
    given = {name: _length(entry) for name, entry in cast("Entry", w.data[key]).items()}
    fixed = [name for name in given if folded(name) in _FRAMES]
    moving = [name for name in given if name not in fixed]
    pins: Entry = dict(zip(_HINGED, _ends_of(moving), strict=False))
    taken = {*cast("Entry", w.data.get("connections") or {})}
    if len(fixed) != 1 or len(moving) != 3 or None in given.values() or any(map(name_problem, moving)):
        return
    if taken & pins.keys() or (w.data.get("ground") or {}):
        return
    ends = {_HINGED[0]: [0, 0], _HINGED[-1]: [given[fixed[0]], 0]}
    w.data = {name: each for name, each in w.data.items() if name != key}
    w.data |= {"ground": {"points": ends}, "bodies": {name: {"rod": {"length": given[name]}} for name in moving}}
    w.data["connections"] = {**cast("Entry", w.data.get("connections") or {}), **pins}
    w.moved |= {("bodies", name): (key, name) for name in moving} | {("connections", pin): (key,) for pin in pins}
    w.assumed.append(
        Message(
            "{first} is hinged to the ground at {A}, {last} at {D}, and {middle} joins both",
            first=moving[0],
            middle=moving[1],
            last=moving[2],
            A=_HINGED[0],
            D=_HINGED[-1],
        )
    )


def _ends_of(moving: list[str]) -> list[Entry]:
    """The pins of three rods in a row between two points of the ground."""
    if len(moving) != 3:
        return []
    first, middle, last = moving
    pairs = [
        [f"ground.{_HINGED[0]}", f"{first}.start"],
        [f"{first}.end", f"{middle}.start"],
        [f"{middle}.end", f"{last}.end"],
        [f"ground.{_HINGED[-1]}", f"{last}.start"],
    ]
    return [{"pin": pair} for pair in pairs]


def _length(entry: Any) -> Any:
    """`3 cm`, or `{length: 3 cm}`."""
    fields = cast("Entry", entry) if isinstance(entry, dict) else {"length": entry}
    lengths = [
        each for name, each in fields.items() if name in ("length", "L", "l") and isinstance(each, str | int | float)
    ]
    return lengths[0] if len(lengths) == len(fields) == 1 else None


def _link(entry: Any, nodes: Entry) -> tuple[tuple[str, str], Entry] | None:
    """The two nodes of a link, and what else is said of the rod."""
    fields: Entry = {}
    if isinstance(entry, dict):
        fields = dict(cast("Entry", entry))
        entry = fields.pop("points", None) or fields.pop("between", None)
        for pair in _ENDS if entry is None else ():
            if {*pair} <= fields.keys():
                entry = [fields.pop(key) for key in pair]
                break
    pair = [str(end) for end in cast("list[Any]", entry)] if isinstance(entry, list) else []
    is_able = len(pair) == 2 and {*pair} <= nodes.keys() and fields.keys() <= {"mass", "m"}
    return ((pair[0], pair[1]), fields) if is_able else None


def _held(w: Written, places: str, nodes: Entry) -> dict[str, str]:
    """The nodes on the ground, each with the section that says so; none where that says more than hinges."""
    found: dict[str, str] = {}
    for key in _HELD:
        given = None if key == places else w.data.get(key)
        if isinstance(given, str):
            given = [given]
        if isinstance(given, list) and {*map(str, cast("list[Any]", given))} <= nodes.keys():
            found |= dict.fromkeys(map(str, cast("list[Any]", given)), key)
        elif isinstance(given, dict) and given and cast("Entry", given).keys() <= nodes.keys():
            words = {node: folded(str(said)).replace("_", " ") for node, said in cast("Entry", given).items()}
            on_ground = [node for node, said in words.items() if _is_on_ground(said, key)]
            if any(not _HINGES.search(said) and node not in on_ground for node, said in words.items()):
                return {}
            found |= dict.fromkeys(on_ground, key)
    return found


def _is_on_ground(said: str, section: str) -> bool:
    """Whether a node is on the ground: among joints only where it is said, among supports where it is a pin."""
    said_of = _ON_GROUND if section != "joints" else re.compile(r"\b(ground|grounded|fixed|frame|world|gestell)\b")
    return said_of.search(said) is not None


def _pins(ends: dict[str, tuple[str, str]], nodes: Entry, held: list[str]) -> Entry:
    """The pins of all nodes where links meet, or where one is held."""
    pins: Entry = {}
    for node in nodes:
        at = [
            f"{name}.{end}"
            for name, pair in ends.items()
            for end, each in zip(("start", "end"), pair, strict=True)
            if each == node
        ]
        points = [*([f"ground.{node}"] if node in held else []), *at]
        if len(points) > 1:
            pins[node] = {"pin": points}
    return pins
