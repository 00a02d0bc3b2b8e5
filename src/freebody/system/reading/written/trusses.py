"""A truss as it is written in books: nodes with their places, members between them, supports of nodes.

    nodes: {A: [0, 0], B: [4 m, 0], C: [2 m, 3 m]}
    members: {AB: [A, B], AC: [A, C], BC: [B, C]}      also [[A, B], ...] or [AB, AC, BC]
    supports: {A: pin, B: roller}

    truss: {nodes: ..., members: ..., supports: ..., loads: ...}      the same

Nodes are massless particles where they are put and members links between them, in the plane and in space; a pinned node
is held by a pin (in space a spherical joint) with the name of the node, a roller moves along `right` where it says no
other direction.
"""

from __future__ import annotations

from typing import Any, cast

from freebody.errors import ModelError, Problem
from freebody.language.document.tree import Place
from freebody.language.document.writer import flow_text
from freebody.language.expression import name_problem
from freebody.language.folded import folded
from freebody.language.sentences import Message, in_turn
from freebody.system.reading.written.form import SAYS_NAME, Entry, Vocabulary, Written

_MEMBERS = ("members", "elements", "bars", "struts", "rods", "truss_members", "staebe")
_PLACES = ("nodes", "joints", "points", "knoten")
_MEMBERS_ALONE, _NODES_ALONE = ("members", "truss_members", "staebe"), ("nodes", "knoten")  # of nothing else
_TRUSSES = ("truss", "fachwerk", "framework")
_NUMBERED = "member_"  # before a number that is the name of one
_PINNED = ("pin", "pinned", "hinge", "fixed", "festlager", "a_lager")
_ROLLER = ("roller", "loslager", "b_lager", "slider")
_SUPPORTS = ("supports", "lager", "auflager")
_NODE, _ENDS, _WAY = ("at", "node", "point", "joint"), ("nodes", "between", "from", "to"), ("along", "direction")
VOCABULARY = Vocabulary(
    (*_TRUSSES, *_MEMBERS, *_PLACES, *_SUPPORTS),
    (*_PINNED, *_ROLLER, *_NODE, *_ENDS, *_WAY, "type", "name", "x", "y", "z"),
)


def with_truss(w: Written) -> tuple[Entry, dict[Place, Place], Message] | None:
    """The data with bodies and connections for a truss, where what stands in the file, and what is taken for granted;
    None where it has none, or where what is called so is something else. Raises ModelError of a truss that cannot be
    read."""
    _lift(w)
    data = w.data
    members_key = next((key for key in data if folded(key) in _MEMBERS), None)
    places_key = next((key for key in data if folded(key) in _PLACES and _places(data.get(key))), None)
    if members_key is None or places_key is None or data.get("bodies"):
        return None
    places = _places(data[places_key])
    members = _members(data[members_key], places)
    supports_key = next((key for key in data if folded(key) in _SUPPORTS), "supports")
    supports: Any = _by_node(data.get(supports_key) or {})
    if folded(members_key) in _MEMBERS_ALONE or folded(places_key) in _NODES_ALONE:
        _refuse(w, members_key, places, supports_key, supports)
    if members is None or not isinstance(supports, dict) or not cast("Entry", supports).keys() <= places.keys():
        return None
    connections: Entry = {name: {"link": [first, second]} for name, (_step, first, second) in members.items()}
    steps = places if isinstance(data[places_key], dict) else range(len(places))
    moved: dict[Place, Place] = {
        ("bodies", name): (*w.stood((places_key,)), k) for name, k in zip(places, steps, strict=True)
    }
    moved |= {
        ("connections", name): (*w.stood((members_key,)), step) for name, (step, _first, _second) in members.items()
    }
    for node, said in cast("Entry", supports).items():
        held = _support(node, said, space=w.space)
        if held is None or node in connections:
            return None
        connections[node] = held
        moved["connections", node] = (*w.stood((supports_key,)), node)
    there = data.get("connections") or {}
    if not isinstance(there, dict) or connections.keys() & cast("Entry", there).keys():
        return None
    bodies: Entry = {name: {"particle": None, "at": place} for name, place in places.items()}
    new = {key: value for key, value in data.items() if key not in (members_key, places_key, supports_key)}
    told = Message("the members are hinged at the nodes, so that each carries a force along itself only")
    return {**new, "bodies": bodies, "connections": {**cast("Entry", there), **connections}}, moved, told


def _lift(w: Written) -> None:
    """Puts what stands inside a section `truss` beside it."""
    for key in [key for key, given in w.data.items() if folded(key) in _TRUSSES and isinstance(given, dict)]:
        inside = cast("Entry", w.data[key])
        if any(folded(name) in _MEMBERS for name in inside) and not inside.keys() & w.data.keys():
            w.data = {**{name: value for name, value in w.data.items() if name != key}, **inside}
            w.moved |= {(name,): (key, name) for name in inside}


def _refuse(w: Written, members_key: str, places: Entry, supports_key: str, supports: Any) -> None:
    """Raises ModelError where a member or a support is of no node, or a support is none."""
    nodes = ", ".join(places)
    problems: list[Problem] = []
    given = w.data[members_key]
    items = [*cast("Entry", given).items()] if isinstance(given, dict) else [*enumerate(given or [])]
    for step, entry in items:
        if _ends(entry, places) is None:
            told = Message(
                "{member} is no member between two of the nodes {nodes}: write it as [{first}, {second}]",
                member=flow_text(entry),
                nodes=nodes,
                **dict(zip(("first", "second"), [*places, "A", "B"], strict=False)),
            )
            problems.append(Problem(w.stood((members_key, step)), told))
        elif isinstance(entry, dict) and (more := [key for key in entry if key not in (*_ENDS, *SAYS_NAME)]):
            told = Message(
                "a member of a truss is a massless link and has no {key}: leave it out, and put a weight on its nodes "
                "as loads, {node}: 100 N down",
                key=in_turn([*map(str, more)]),
                node=nodes.partition(",")[0],
            )
            problems.append(Problem(w.stood((members_key, step, more[0])), told))
    for node, said in cast("Entry", supports).items() if isinstance(supports, dict) else ():
        if node not in places:
            told = Message("there is no node {node}. Nodes: {nodes}", node=node, nodes=nodes)
            problems.append(Problem(w.stood((supports_key, node)), told))
        fields = cast("Entry", said) if isinstance(said, dict) else {"type": said}
        word = fields.get("type")
        held = [*fields] if word is None and len(fields) == 1 else [word]
        known = ("type", *(_WAY if folded(str(word)) in _ROLLER else ()))
        more = [key for key in fields if key not in known] if word is not None else []
        inside = fields[held[0]] if word is None and len(held) == 1 and held[0] in fields else None
        more += [*cast("Entry", inside)] if isinstance(inside, dict) else []
        if more and folded(str(held[0])) in (*_PINNED, *_ROLLER):
            told = Message(
                "a {kind} of a truss has no {key}; it is {node}: {kind}, a roller also {{type: roller, along: 30 deg}}",
                kind=str(held[0]),
                key=in_turn([*map(str, more)]),
                node=node,
            )
            problems.append(Problem(w.stood((supports_key, node)), told))
        elif isinstance(word, str) and folded(word) not in (*_PINNED, *_ROLLER):
            told = Message("a truss has no support {kind}: supports are pin and roller", kind=word)
            problems.append(Problem(w.stood((supports_key, node)), told))
    if problems:
        raise ModelError(problems)


def _by_node(supports: Any) -> Any:
    """`[{at: A, type: pin}]` as `{A: {type: pin}}`."""
    if not isinstance(supports, list):
        return supports
    found: Entry = {}
    for item in cast("list[Any]", supports):
        fields = dict(cast("Entry", item)) if isinstance(item, dict) else {}
        node = next((fields.pop(key) for key in _NODE if key in fields), None)
        if not isinstance(node, str) or node in found:
            return supports
        found[node] = fields
    return found


def _places(given: Any) -> Entry:
    """Nodes with their places: a mapping, or a list of `{name: A, x: 0, y: 0}`; empty for anything else."""
    if not isinstance(given, list):
        return cast("Entry", given) if isinstance(given, dict) else {}
    items = [cast("Entry", item) if isinstance(item, dict) else {} for item in cast("list[Any]", given)]
    found = {str(item["name"]): [item[axis] for axis in "xyz" if axis in item] for item in items if "name" in item}
    return found if len(found) == len(items) and all(len(place) > 1 for place in found.values()) else {}


def _members(given: Any, nodes: Entry) -> dict[str, tuple[str | int, str, str]] | None:
    """Members by name: where each is given, and its two nodes."""
    named = [(str(key), value) for key, value in cast("Entry", given).items()] if isinstance(given, dict) else None
    entries = [*enumerate(cast("list[Any]", given) if isinstance(given, list) else [])] if named is None else named
    found: dict[str, tuple[str | int, str, str]] = {}
    for step, entry in entries:
        ends = _ends(entry, nodes)
        if ends is None:
            return None
        name = step if isinstance(step, str) else entry if isinstance(entry, str) else "".join(ends)
        if name_problem(name):
            name = f"{_NUMBERED}{name}" if name.isdigit() else "".join(ends)
        if name in found or name in nodes or name_problem(name):
            return None
        found[name] = (step, *ends)
    return found or None


def _ends(entry: Any, nodes: Entry) -> tuple[str, str] | None:
    """The two nodes of a member: of a list, of `{from: A, to: B}`, or of a name that is put together of both."""
    if isinstance(entry, dict):
        fields = cast("Entry", entry)
        entry = fields.get("nodes") or fields.get("between") or [fields.get("from"), fields.get("to")]
    if isinstance(entry, str):
        split = [(entry[:k], entry[k:].lstrip("-_ ")) for k in range(1, len(entry))]
        able = [pair for pair in split if pair[0].rstrip("-_ ") in nodes and pair[1] in nodes]
        return (able[0][0].rstrip("-_ "), able[0][1]) if len({(a.rstrip("-_ "), b) for a, b in able}) == 1 else None
    ends = [str(end) for end in cast("list[Any]", entry)] if isinstance(entry, list) else []
    return (ends[0], ends[1]) if len(ends) == 2 and {*ends} <= nodes.keys() else None


def _support(node: str, said: Any, *, space: bool) -> Entry | None:
    fields = cast("Entry", said) if isinstance(said, dict) else {"type": said}
    word, along = folded(str(fields.get("type"))), fields.get("along", fields.get("direction"))
    if word in _PINNED and fields.keys() <= {"type"}:
        return {"spherical" if space else "pin": [f"ground.{node}", node]}
    if word in _ROLLER and not space and fields.keys() <= {"type", "along", "direction"}:
        return {"slot": {"pin": node, "along": along or "right"}}
    return None
