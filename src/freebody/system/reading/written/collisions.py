"""Point masses that strike each other on one line.

    bodies: {A: {mass: 2 kg, velocity: 3 m/s}, B: {mass: 1 kg, velocity: -1 m/s}}
    collision: {between: [A, B], e: 0.5}
        connections: {guide_of_A: {slider: {body: A, along: right}}, ...}
        bodies: {B: {..., at: [gap_A_B, 0]}}      parameters: {gap_A_B: 1 m}

Two points do not touch in the plane; whose velocity is one number moves along a line, and right is positive. Of two
whose places the file leaves out the first one named is on the left, or, by their numbers, the one that catches up.
"""

from __future__ import annotations

from typing import Any, cast

from freebody.language.sentences import Message
from freebody.model.written_kinds import written_kind
from freebody.system.reading.written.dimensions import value_said
from freebody.system.reading.written.form import Entry, Written, are_mappings, kinds_of, shape_of
from freebody.system.reading.written.pulleys import is_named, of_kind
from freebody.system.reading.written.scalars import PLACES_OF_BODIES
from freebody.system.reading.written.vectors import SPEEDS

_GAP = "1 m"  # on which no velocity depends
_POINT, _SLIDER, _CONTACT, _GRAVITY = "particle", "slider", "contact", "gravity"


def guide_what_collides(w: Written) -> None:
    """Two point masses that strike each other on a level line, where nothing else acts on them, stay on that line."""
    bodies, connections = w.data.get("bodies"), w.data.get("connections")
    if w.space or not isinstance(bodies, dict) or not isinstance(connections, dict):
        return
    if not are_mappings(w, "ground", "loads", "parameters"):
        return
    bodies = cast("Entry", bodies)
    for name, fields in [*of_kind(cast("Entry", connections), _CONTACT)]:
        pair = fields.get("between")
        two = [str(each) for each in cast("list[Any]", pair)] if isinstance(pair, list) else []
        others = {key: each for key, each in w.data["connections"].items() if key != name}
        if len(two) != 2 or any(is_named(body, others) for body in two):
            continue
        if not any({*SPEEDS, *PLACES_OF_BODIES} & {*_said_of(bodies.get(body))} for body in two):
            continue  # nothing says that they meet on a line
        if not all(_moves_level(bodies.get(body)) for body in two) or _height(bodies[two[0]]) != _height(
            bodies[two[1]]
        ):
            continue
        if not (_weigh_alone(w) if any(_is_number(_speed(bodies[body])) for body in two) else not w.data.get("loads")):
            continue
        own = {f"guide_of_{body}": {_SLIDER: {"body": body, "along": "right"}} for body in two}
        w.data["connections"] = {**w.data["connections"], **own}
        w.moved |= {("connections", f"guide_of_{body}"): w.stood(("bodies", body)) for body in two}
        w.assumed.append(Message("{names} strike each other on one line, on which they stay", names=", ".join(two)))
        if not any({*PLACES_OF_BODIES, "near"} & {*bodies[body]} for body in two):
            _put_apart(w, two)


def _put_apart(w: Written, two: list[str]) -> None:
    """Two bodies without places, with a distance between them that stays a symbol."""
    bodies = cast("Entry", w.data["bodies"])
    parameters = cast("Entry", w.data.get("parameters") or {})
    first, second = (
        value_said(w, velocity[0] if isinstance(velocity := _speed(bodies[body]), list) else velocity) for body in two
    )
    if first is None or second is None:
        return  # which of them catches up is in no number
    left, right = two[::-1] if first < second else two
    gap = f"gap_{left}_{right}"
    if gap in parameters:
        return
    w.data["parameters"] = {**parameters, gap: _GAP}
    w.data["bodies"] = {**bodies, left: {**bodies[left], "at": [0, 0]}, right: {**bodies[right], "at": [gap, 0]}}
    w.moved |= {("bodies", body, "at"): w.stood(("bodies", body)) for body in two}
    w.assumed.append(
        Message("{left} is on the left of {right}, by {gap} = {size}", left=left, right=right, gap=gap, size=_GAP)
    )


def _moves_level(entry: Any) -> bool:
    """Whether it is a point mass with a place and a velocity, if any, along x."""
    shape, fields = shape_of(entry), _said_of(entry)
    velocity = _speed(fields)
    is_pair = isinstance(velocity, list) and len(cast("list[Any]", velocity)) == 2 and str(velocity[1]) == "0"
    is_level = is_pair or _is_number(velocity)
    return shape is not None and shape.kind == _POINT and _height(fields) is not None and is_level


def _said_of(entry: Any) -> Entry:
    return cast("Entry", entry) if isinstance(entry, dict) else {}


def _speed(entry: Entry) -> Any:
    return next((entry[key] for key in SPEEDS if key in entry), [0, 0])


def _is_number(value: Any) -> bool:
    return isinstance(value, int | float | str)


def _height(entry: Entry) -> str | None:
    at: Any = next((entry[key] for key in PLACES_OF_BODIES if key in entry), [0, 0])
    return str(at[1]) if isinstance(at, list) and len(cast("list[Any]", at)) == 2 else "0" if _is_number(at) else None


def _weigh_alone(w: Written) -> bool:
    """Whether nothing acts but weight, across the line."""
    loads = cast("Entry", w.data.get("loads") or {})
    kinds = kinds_of("loads")
    words = [next(iter(each.items())) for each in loads.values() if isinstance(each, dict) and each]
    return all(written_kind(word, value, kinds, space=False) == _GRAVITY for word, value in words)
