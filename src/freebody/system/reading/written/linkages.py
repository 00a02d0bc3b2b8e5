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
from freebody.language.units import ANGULAR_VELOCITY, DIMENSIONLESS, LENGTH
from freebody.system.reading.written.dimensions import dimension_said
from freebody.system.reading.written.form import Entry, Vocabulary, Written, are_mappings
from freebody.system.reading.written.numbers_given import wrong_unit

_LINKS = ("links", "Glieder")
_FRAMES = ("ground", "frame", "fixed", "base", "ground_link", "fixed_link", "gestell")
_FOUR_BARS = ("four_bar", "fourbar", "four_bar_linkage", "4_bar", "4bar", "linkage", "viergelenk", "gelenkviereck")
_PART_NAMES = ("crank", "coupler", "rocker", "ground")
_PARTS = (  # of a four-bar, how people call them
    ("crank", "input", "input_link", "driver", "kurbel", "antrieb", "a", "r2", "l2"),
    ("coupler", "connecting_rod", "floating_link", "koppel", "b", "r3", "l3"),
    ("rocker", "output", "output_link", "follower", "schwinge", "abtrieb", "c", "r4", "l4"),
    (*_FRAMES, "d", "r1", "l1"),
)
_ANGLES, _SPEEDS = ("angle", "theta", "winkel"), ("speed", "omega", "velocity", "rpm", "drehzahl")
_OF_CRANK = {"theta2": "angle of {body}", "omega2": "rate(angle of {body})"}
_HINGED = ("A", "B", "C", "D")
_PLACES = ("points", "nodes", "joints", "Punkte")
_HELD = ("ground", "fixed", "supports", "joints", "pivots")
_ON_GROUND = re.compile(r"\b(ground|grounded|fixed|frame|world|gestell|pin|pinned|support)\b")
_HINGES = re.compile(r"\b(pin|pinned|revolute|hinge|gelenk|drehgelenk)\b")
_ENDS = (("from", "to"), ("start", "end"), ("first", "second"), ("von", "nach"))
VOCABULARY = Vocabulary(
    (*_LINKS, *_FOUR_BARS, *_PLACES, *_HELD),
    (
        *(word for words in _PARTS for word in words),
        *(word for pair in _ENDS for word in pair),
        *(*_ANGLES, *_SPEEDS, *_OF_CRANK, "points", "between", "mass", "length", "initial"),
    ),
)


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
    that move in the order in which they are hinged to each other, from the origin to the other point of the ground; as
    a section of its own (`four_bar`) also by their parts in any order, or by letters (a crank, b coupler, c rocker, d
    ground, and r1 ground, r2 crank ...: Norton, Design of Machinery, sec. 4.5), with how the crank starts."""
    key = next((key for key in _LINKS if isinstance(w.data.get(key), dict)), None)
    key = next((key for key in w.data if folded(str(key)) in _FOUR_BARS and isinstance(w.data[key], dict)), key)
    if key is None or w.space or not are_mappings(w, "bodies", "ground", "connections") or w.data.get("bodies"):
        return
    entries, start = _apart_from_start(w, cast("Entry", w.data[key]))
    stood = {name: name for name in entries}
    if folded(str(key)) in _FOUR_BARS or all(len(str(name)) >= len("arm") for name in entries):
        entries, stood = _by_parts(entries)  # letters among links are names
    given = {name: _length(entry) for name, entry in entries.items()}
    if folded(str(key)) in _FOUR_BARS or len(given) == len(_PARTS):
        _refuse_misread(w, key, given, start)
    fixed = [name for name in given if folded(name) in _FRAMES]
    moving = [name for name in given if name not in fixed]
    pins: Entry = dict(zip(_HINGED, _ends_of(moving), strict=False))
    taken = {*cast("Entry", w.data.get("connections") or {})}
    if folded(str(key)) in _FOUR_BARS and len(given) < len(_PARTS) and None not in given.values():
        left = [part for part in _PART_NAMES if part not in [_part_of(name) for name in given]]
        told = Message(
            "a four-bar has four lengths: crank, coupler, rocker and ground; {left} is missing", left=left[-1]
        )
        w.refuse(told, key)
    if len(fixed) != 1 or len(moving) != 3 or None in given.values() or any(map(name_problem, moving)):
        return
    if taken & pins.keys() or (w.data.get("ground") or {}):
        return
    is_called = folded(str(key)) in _FOUR_BARS
    words = [_part_of(name) if is_called or len(name) >= len("arm") else None for name in moving]
    if any(word not in (None, part) for word, part in zip(words, _PART_NAMES, strict=False)):
        told = Message(
            "say which link is which: crank, coupler, rocker and ground; {names} can mean either",
            names=", ".join(given),
        )
        w.refuse(told, key)  # the order says other than the words
    ends = {_HINGED[0]: [0, 0], _HINGED[-1]: [given[fixed[0]], 0]}
    w.data = {name: each for name, each in w.data.items() if name != key}
    w.data |= {"ground": {"points": ends}, "bodies": {name: {"rod": {"length": given[name]}} for name in moving}}
    w.data["connections"] = {**cast("Entry", w.data.get("connections") or {}), **pins}
    w.moved |= {("bodies", name): (key, stood[name]) for name in moving} | {
        ("connections", pin): (key,) for pin in pins
    }
    if start:
        own = {(said.format(body=moving[0])): value for said, (_key, value) in start.items()}
        w.data["start"] = {**own, **cast("Entry", w.data.get("start") or {})}
        w.moved |= {("start", said.format(body=moving[0])): (key, at) for said, (at, _value) in start.items()}
    _angles_of_links(w, moving)
    if any(name != at for name, at in stood.items()):
        parts = {_PART_NAMES[k]: at for k, at in enumerate(stood.values())}
        w.assumed.append(
            Message("{crank} is the crank, {coupler} the coupler, {rocker} the rocker and {ground} the ground", **parts)
        )
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


def _refuse_misread(w: Written, key: str, lengths: Entry, start: dict[str, tuple[str, Any]]) -> None:
    """Raises ModelError where one length of four has no unit beside others that have one, or the crank turns at a rate
    that is none."""
    known = {name: dimension_said(w, value) for name, value in lengths.items()}
    others = [str(value).split() for name, value in lengths.items() if known[name] == LENGTH]
    unit = next((parts[1] for parts in others if len(parts) == len(("10", "cm"))), "")
    for name, value in lengths.items() if LENGTH in known.values() else ():
        is_bare = value is not None and known[name] not in (None, LENGTH)
        if is_bare and (why := wrong_unit(w, name, value, LENGTH, unit)) is not None:
            w.refuse(why, key, name)
    for said, (at, value) in start.items():
        wanted = ANGULAR_VELOCITY if said.startswith("rate") else DIMENSIONLESS
        if str(value) != "0" and (why := wrong_unit(w, at, value, wanted)) is not None:
            w.refuse(why, key, at)


def _apart_from_start(w: Written, given: Entry) -> tuple[Entry, dict[str, tuple[str, Any]]]:
    """The links, and how the crank starts: by what is said of its angle, the key and the value of that."""
    start: dict[str, tuple[str, Any]] = {}
    if not isinstance(w.data.get("start") or {}, dict):
        return given, start
    for key, value in given.items():
        word = folded(str(key))
        of, _, what = word.rpartition("_")
        said = "angle of {body}" if what in _ANGLES else "rate(angle of {body})" if what in _SPEEDS else None
        said = said or _OF_CRANK.get(word)
        if said is not None and (not of or of in (*_PARTS[0], "initial")) and isinstance(value, str | int | float):
            start[said] = key, value
    return {key: value for key, value in given.items() if key not in [at for at, _value in start.values()]}, start


def _angles_of_links(w: Written, links: list[str]) -> None:
    """`start: {crank: 60 deg}`: the angle of a link counts from the one on the ground."""
    start = w.data.get("start")
    if not isinstance(start, dict) or not isinstance(w.data.get("measures") or {}, dict):
        return
    read: Entry = {}
    for key, value in cast("Entry", start).items():
        is_link = (
            key in links and dimension_said(w, value) == DIMENSIONLESS and key not in (w.data.get("measures") or {})
        )
        called = f"angle of {key}" if is_link else key
        read[called] = value
        if is_link:
            w.moved["start", called] = ("start", key)
    w.data["start"] = read


def _by_parts(given: Entry) -> tuple[Entry, dict[str, str]]:
    """The links in the order crank, coupler, rocker, ground, where each is called by its part; letters give way to the
    words. With it: by their names, how the file calls them."""
    found: dict[str, tuple[str, str]] = {}
    for name in given:
        if (part := _part_of(name)) is not None:
            found[part] = (part if len(name) < len("arm") else name, name)
    if len(found) < len(given) or len(found) != len(_PARTS):
        return given, {name: name for name in given}
    ordered = [found[part] for part in _PART_NAMES]
    return {name: given[key] for name, key in ordered}, dict(ordered)


def _part_of(name: str) -> str | None:
    """Which part of a four-bar a link is by its name."""
    word = folded(str(name))
    return next((part for part, words in zip(_PART_NAMES, _PARTS, strict=True) if word in words), None)


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
