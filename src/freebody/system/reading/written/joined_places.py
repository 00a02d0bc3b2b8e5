"""Places of points that a joint says already.

    bodies: {pole: {rod: ..., at: {start: truck.tower}}}      bodies: {pole: {rod: ...}}
    connections: {hinge: {pin: [truck.tower, pole.start]}}    (the hinge puts it there)

Where a point of another body is follows from the joint of both. In space one point and the joints put a body: of two,
as `at: {start: A, end: [a, 0, 0]}`, the one that a joint holds at that very point of the ground is left to the joint.
"""

from __future__ import annotations

from typing import Any, cast

from freebody.connections.base import Connection
from freebody.measures.geometry import GROUND
from freebody.model.written_kinds import written_kind
from freebody.system.reading.written.form import Entry, Written

_MEET = ("pin", "weld", "spherical", "universal", "revolute")
_AT = ("at", "position")


def leave_to_joints(w: Written) -> None:
    """Takes places out that a joint of both points gives."""
    bodies, connections = w.data.get("bodies"), w.data.get("connections")
    if not isinstance(bodies, dict) or not isinstance(connections, dict):
        return
    meeting = [_ends(w, entry) for entry in cast("Entry", connections).values()]
    for name, entry in [*cast("Entry", bodies).items()]:
        key = next((key for key in _AT if isinstance(entry, dict) and isinstance(entry.get(key), dict)), None)
        if key is None:
            continue
        given = cast("Entry", entry[key])
        held = [
            point
            for point, there in given.items()
            if isinstance(there, str)
            and {f"{name}.{point}", _point(there, bodies)} in meeting
            and (_owner(there) in bodies or (w.space and len(given) > 1))
        ]
        left = {point: there for point, there in given.items() if point not in held}
        if held:
            rest = {each: value for each, value in entry.items() if each != key}
            w.data["bodies"] = bodies = {**bodies, name: {**rest, key: left} if left else rest}


def _ends(w: Written, entry: Any) -> set[str]:
    """The two points that a joint brings together."""
    for word, value in cast("Entry", entry).items() if isinstance(entry, dict) else ():
        kind = written_kind(word, value, Connection.kinds, space=w.space)
        if kind in _MEET:
            fields = Connection.kinds[kind].from_plain(value)
            return {
                _point(str(fields[end]), cast("Entry", w.data["bodies"]))
                for end in ("first", "second")
                if end in fields
            }
    return set()


def _owner(point: str) -> str:
    return point.partition(".")[0]


def _point(named: str, bodies: Entry) -> str:
    """A point by its full name: `A` is that of the ground."""
    return named if "." in named or named in bodies else f"{GROUND}.{named}"
