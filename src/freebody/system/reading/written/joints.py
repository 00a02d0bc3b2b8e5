"""Joints of rods by parent and child, as files of robots have them, and rods that are pinned by their plain name.

    joints: {elbow: {type: revolute, parent: upper, child: lower, torque: tau}}
        connections: {elbow: {pin: [upper.end, lower.start]}}
        loads: {torque_of_elbow: {torque: {on: lower, reacts_on: upper, magnitude: tau}}}
        measures: {elbow: angle of lower from upper.x}

A rod begins at the joint that carries it, and carries the next one at its other end; an angle counts from the parent,
that of the first from the right, counter-clockwise. Where a joint says its `origin` or its axis this is left alone.
"""

from __future__ import annotations

from typing import Any, cast

from freebody.connections.base import Connection
from freebody.language.sentences import Message
from freebody.measures.geometry import GROUND
from freebody.model.names import is_of_surroundings
from freebody.model.written_kinds import written_kind
from freebody.system.reading.sections import SAYS_KIND
from freebody.system.reading.written.form import Entry, Vocabulary, Written, are_mappings, shape_of

_PARENT, _CHILD, _TORQUE = "parent", "child", "torque"
VOCABULARY = Vocabulary((), (_PARENT, _CHILD, _TORQUE))
_HINGES = ("revolute", "continuous", "hinge", "pin", "rotary")
_ROD, _PIN = "rod", "pin"


def join_rods(w: Written) -> None:
    """Writes joints by parent and child as pins at the ends of rods."""
    connections = w.data.get("connections")
    if w.space or not isinstance(connections, dict) or not are_mappings(w, "bodies", "loads", "measures", "start"):
        return
    told: list[str] = []
    for name, entry in [*cast("Entry", connections).items()]:
        fields = cast("Entry", entry) if isinstance(entry, dict) else {}
        kind = next((str(fields[key]).lower() for key in SAYS_KIND if key in fields), "")
        beside = {key: each for key, each in fields.items() if key not in SAYS_KIND}
        if kind not in _HINGES or not {_PARENT, _CHILD} <= beside.keys() <= {_PARENT, _CHILD, _TORQUE}:
            continue
        parent, child = str(beside[_PARENT]), str(beside[_CHILD])
        is_first = parent == GROUND or (parent not in (w.data.get("bodies") or {}) and is_of_surroundings(parent))
        if not _is_rod(w, child) or not (is_first or _is_rod(w, parent)):
            continue
        held = f"{GROUND}.{name}" if is_first else f"{parent}.end"
        w.data["connections"] = {**w.data["connections"], name: {_PIN: [held, f"{child}.start"]}}
        if _TORQUE in beside:
            against = {} if is_first else {"reacts_on": parent}
            load = {_TORQUE: {"on": child, "magnitude": beside[_TORQUE], **against}}
            w.data["loads"] = {**cast("Entry", w.data.get("loads") or {}), f"torque_of_{name}": load}
            w.moved["loads", f"torque_of_{name}"] = (*w.stood(("connections", name)), _TORQUE)
        measures = cast("Entry", w.data.get("measures") or {})
        if name not in {*measures, *(w.data.get("parameters") or {}), *(w.data.get("bodies") or {})}:
            of = f"angle of {child}" if is_first else f"angle of {child} from {parent}.x"
            w.data["measures"] = {**measures, name: of}
            w.moved["measures", name] = w.stood(("connections", name))
        told.append(f"{name}: {child}.start" if is_first else f"{name}: {held} = {child}.start")
    if told:
        w.assumed.append(
            Message(
                "a rod begins at the joint that carries it and carries the next one at its end, and the angle of a "
                "joint counts from its parent ({joints})",
                joints=", ".join(told),
            )
        )


def tell_middles(w: Written) -> None:
    """A rod that is pinned by its plain name is held in its middle, which is told."""
    connections = w.data.get("connections")
    for name, entry in cast("Entry", connections).items() if isinstance(connections, dict) and not w.space else ():
        for word, value in cast("Entry", entry).items() if isinstance(entry, dict) else ():
            if written_kind(word, value, Connection.kinds, space=False) != _PIN:
                continue
            for end in Connection.kinds[_PIN].from_plain(value).values():
                if isinstance(end, str) and _is_rod(w, end):
                    w.assumed.append(
                        Message(
                            "{name} holds {rod} in its middle; its ends are {ends}", name=name, rod=end, ends=_ends(end)
                        )
                    )


def _ends(rod: str) -> str:
    return f"{rod}.start, {rod}.end"


def _is_rod(w: Written, name: str) -> bool:
    bodies = w.data.get("bodies")
    entry: Any = cast("Entry", bodies).get(name) if isinstance(bodies, dict) else None
    shape = shape_of(entry)
    return shape is not None and shape.kind == _ROD
