"""Points as people say them, where a file names them.

from: {x: 0, y: 1 m}                       from: [0, 1 m]
from: {body: rod, point: end}              from: rod.end
force: {on: rod, at: end, ...}             force: {on: rod.end, ...}
pin: {between: [ground, rod.start], at: O} pin: {between: [ground.O, rod.start]}
pin: {body: drum, at: [0, 1 m]}            pin: [[0, 1 m], drum]
"""

from __future__ import annotations

from typing import Any, cast

from freebody.language.folded import folded
from freebody.measures.geometry import GROUND
from freebody.model.names import is_of_surroundings
from freebody.model.spec import Spec
from freebody.system.reading.written.form import Entry, Written, shape_of
from freebody.system.reading.written.vectors import by_axes

_OWNERS = ("body", "on", "Körper", "Bauteil")
PLACES = ("point", "at", "Punkt")
_GROUND = ("boden", "gestell", "fundament", "erde", "frame", "base")
_HELD = "pin"  # the field of a point that is guided
_JOINED = ("first", "second")
_ENDS = ("from", "to", "first", "second")


def with_points(w: Written, name: str, kind: type[Spec], value: Any) -> Any:
    """The fields of a connection or a load, called by a name, with its points as they are named."""
    owner, dot, _point = value.partition(".") if isinstance(value, str) else ("", "", "")
    if is_joint(kind) and owner in _bodies(w) and (dot or _is_round(w, owner)):
        called = name if owner != name else f"{owner}_{name}"
        return {"first": f"{GROUND}.{called}", "second": value}  # what holds one body alone holds it to the ground
    if not isinstance(value, dict):
        value = _named(w, value)
        return _on_ground(w, value) if is_joint(kind) else value
    listed = [*cast("Entry", value)]
    if is_joint(kind) and len(listed) > 1 and not any(cast("Entry", value).values()):
        return _named(w, listed)  # `{ground, rod.start}`
    fields = {key: _named(w, each) for key, each in cast("Entry", value).items()}
    if is_joint(kind):
        fields = {key: _on_ground(w, each) for key, each in fields.items()}
        return _joined(w, name, fields)
    fields = _of_body(w, kind, _beside_ground(w, of_owner(w, fields)))
    known = kind.model_fields.keys()
    if _HELD in known and _HELD not in fields and "body" not in known:
        return {_HELD if key in _OWNERS and key not in known else key: each for key, each in fields.items()}
    return fields


def _on_ground(w: Written, value: Any) -> Any:
    """`[boden, rod.start]` as points that meet: one is on the ground."""
    if isinstance(value, list):
        return [_on_ground(w, each) for each in cast("list[Any]", value)]
    is_ground = isinstance(value, str) and folded(value) in _GROUND and value not in _bodies(w)
    return GROUND if is_ground else value


def is_joint(kind: type[Spec]) -> bool:
    """Whether it lets points of two bodies meet."""
    return getattr(kind, "meeting", None) == _JOINED


def _named(w: Written, value: Any) -> Any:
    """`{x: 0, y: 1 m}` and `{body: rod, point: end}`, also in a list."""
    if isinstance(value, list):
        return [_named(w, each) for each in cast("list[Any]", value)]
    value = by_axes(value)
    fields = cast("Entry", value) if isinstance(value, dict) else {}
    said = [*of_owner(w, fields).values()] if len(fields) == 2 else []
    return said[0] if len(said) == 1 else value


def of_owner(w: Written, fields: Entry) -> Entry:
    """`{on: rod, at: end}` as `{on: rod.end}`."""
    owners = [key for key in _OWNERS if isinstance(fields.get(key), str) and fields[key] in _bodies(w)]
    places = [key for key in PLACES if key in fields and key not in owners]
    if len(owners) != 1 or len(places) != 1 or not _is_name(w, fields[places[0]]):
        return fields
    point = f"{fields[owners[0]]}.{fields[places[0]]}"
    return {key: point if key == owners[0] else each for key, each in fields.items() if key != places[0]}


def _of_body(w: Written, kind: type[Spec], fields: Entry) -> Entry:
    """`{ball: slope}` of what rolls or touches: the body and what it is on."""
    known = kind.model_fields.keys()
    named = [
        key for key, each in fields.items() if key in _bodies(w) and isinstance(each, str) and each not in _bodies(w)
    ]
    if len(named) != 1 or not {"body", "on"} <= known or {"body", "on"} & fields.keys():
        return fields
    rest = {key: each for key, each in fields.items() if key != named[0]}
    return {"body": named[0], "on": fields[named[0]], **rest}


def _beside_ground(w: Written, fields: Entry) -> Entry:
    """`{from: wall, at: [0, b], to: boom.end}` as `{from: [0, b], to: boom.end}`."""
    ends = [key for key in _ENDS if isinstance(each := fields.get(key), str) and _is_of_ground(w, each)]
    places = [key for key in PLACES if isinstance(fields.get(key), list)]
    if len(ends) != 1 or len(places) != 1:
        return fields
    return {key: fields[places[0]] if key == ends[0] else each for key, each in fields.items() if key != places[0]}


def _is_of_ground(w: Written, name: str) -> bool:
    is_known = name in (*_bodies(w), *_ground_points(w))
    return not is_known and (name == GROUND or folded(name) in _GROUND or is_of_surroundings(name))


def _joined(w: Written, name: str, fields: Entry) -> Entry:
    """Where a joint is: a point of the ground, or one of the body that it holds to the ground."""
    at = next((key for key in PLACES if key in fields), None)
    if at is None:
        return fields
    place: Any = fields[at]
    is_place = isinstance(place, list) or (isinstance(place, str) and place in _ground_points(w))
    on_ground = place if isinstance(place, list) or str(place).startswith(f"{GROUND}.") else f"{GROUND}.{place}"
    rest = {key: each for key, each in fields.items() if key != at}
    for key, each in rest.items():
        ends = cast("list[Any]", each) if isinstance(each, list) else []
        if ends.count(GROUND) == 1 and (is_place or _is_name(w, place)):
            return {**rest, key: [on_ground if end == GROUND else end for end in ends]}
        if each == GROUND and (is_place or _is_name(w, place)):
            return {**rest, key: on_ground}
    if not rest and isinstance(place, str) and place.partition(".")[0] in _bodies(w):
        return {"first": f"{GROUND}.{name}", "second": place}
    if len(rest) == 1 and next(iter(rest)) in (*_OWNERS, *_JOINED):
        (body,) = rest.values()
        if is_place:
            return {"first": on_ground, "second": body}
        if isinstance(body, str) and body in _bodies(w) and _is_name(w, place):
            return {"first": GROUND, "second": f"{body}.{place}"}
    return fields


def _is_name(w: Written, place: Any) -> bool:
    """Whether a text may be the name of a point of a body."""
    return isinstance(place, str) and place.isidentifier() and place not in (*_bodies(w), *_ground_points(w), GROUND)


def _is_round(w: Written, body: str) -> bool:
    """Whether a body turns about its middle, if nothing else is said."""
    shape = shape_of(_bodies(w)[body])
    return shape is not None and "radius" in shape.model_fields


def _bodies(w: Written) -> Entry:
    bodies = w.data.get("bodies")
    return cast("Entry", bodies) if isinstance(bodies, dict) else {}


def _ground_points(w: Written) -> Entry:
    ground = w.data.get("ground")
    points = cast("Entry", ground).get("points") if isinstance(ground, dict) else None
    return cast("Entry", points) if isinstance(points, dict) else {}
