"""Blocks that lie on each other, of which the file says no sizes, or that of the lower one alone.

c1: {contact: [top, bottom], friction: mu}      c1: {slider: {body: top, on: bottom, along: right, friction: mu}}
c2: {contact: [bottom, floor]}
c1: {contact: [block, plank], friction: mu}     c1: {contact: [block, plank.top], friction: mu}     (plank a rectangle)

Of two point masses the one that lies on a line of the ground bears the other one, which slides along that line and
stays on it: a point mass has no edge that it could tip about or slide off. What strikes another one (`restitution`)
is no stack.
"""

from __future__ import annotations

from typing import Any, cast

from freebody.language.sentences import Message
from freebody.measures.geometry import GROUND
from freebody.system.reading.written.form import Entry, Written, are_mappings, shape_of
from freebody.system.reading.written.pulleys import of_kind

_POINT, _BOX, _SLIDER, _CONTACT = "particle", "rectangle", "slider", "contact"
_FACE, _WAY = "face", "s"
_LEVEL = ("floor", "table", "road", "ground")  # lines that need not be declared


def lay_in_stacks(w: Written) -> None:
    """Lays point masses on what bears them."""
    bodies, connections = w.data.get("bodies"), w.data.get("connections")
    if w.space or not isinstance(bodies, dict) or not isinstance(connections, dict) or not are_mappings(w, "ground"):
        return
    contacts = dict(of_kind(cast("Entry", connections), _CONTACT))
    pairs = {name: cast("list[Any]", each["between"]) for name, each in contacts.items() if _is_pair(each)}
    along = _borne_by_lines(w, [*pairs.values()])
    again = True
    while again:
        again = False
        for name, pair in [*pairs.items()]:
            upper = [each for each in pair if each not in along and each.partition(".")[2] != _FACE]
            lower = [
                each
                for each in pair
                if each in along or (each.partition(".")[2] == _FACE and each.partition(".")[0] in along)
            ]
            if len(upper) != 1 or len(lower) != 1 or not _is_point(bodies.get(upper[0])):
                continue
            del pairs[name]
            again = True
            rough = {key: each for key, each in contacts[name].items() if key == "friction"}
            if lower[0] not in along:  # the face of a wedge, which leads what lies on it
                w.data["connections"][name] = {_SLIDER: {"body": upper[0], "along": lower[0], **rough}}
                w.assumed.append(
                    Message("{upper} stays on {lower}, along which it slides", upper=upper[0], lower=lower[0])
                )
                if not w.data.get("measures") and _WAY not in (w.data.get("parameters") or {}):
                    w.data["measures"] = {_WAY: f"travel of {upper[0]} along {lower[0]} from {lower[0]}"}
                continue
            along[upper[0]] = along[lower[0]]
            if _is_point(bodies.get(lower[0])):
                fields = {"body": upper[0], "on": lower[0], "along": along[lower[0]], **rough}
                w.data["connections"][name] = {_SLIDER: fields}
                told = Message(
                    "{upper} lies on {lower}: both are point masses, and {upper} stays on it",
                    upper=upper[0],
                    lower=lower[0],
                )
                w.assumed.append(told)
            elif _has_height(bodies.get(lower[0])):
                w.data["connections"][name] = {_CONTACT: {"between": [upper[0], f"{lower[0]}.top"], **rough}}
                w.assumed.append(Message("{upper} lies on {lower}", upper=upper[0], lower=f"{lower[0]}.top"))


def _is_pair(fields: Entry) -> bool:
    """Whether two are said to touch, and to do no more than that."""
    pair = fields.get("between")
    able = isinstance(pair, list) and len(cast("list[Any]", pair)) == 2 and all(isinstance(e, str) for e in pair)
    return able and fields.keys() <= {"between", "friction"}


def _borne_by_lines(w: Written, pairs: list[list[Any]]) -> dict[str, Any]:
    """The bodies that lie on lines of the ground, with the directions of these."""
    ground, bodies = w.data.get("ground"), cast("Entry", w.data["bodies"])
    lines = cast("Entry", ground).get("lines") if isinstance(ground, dict) else None
    known = cast("Entry", lines) if isinstance(lines, dict) else {}
    found: dict[str, Any] = {}
    for pair in pairs:
        names = [str(each).removeprefix(f"{GROUND}.") for each in pair]
        for body, line in (names, names[::-1]):
            if body in bodies and line not in bodies and (line in known or line in _LEVEL):
                fields = cast("Entry", known[line]) if isinstance(known.get(line), dict) else {}
                found[body] = fields.get("along", fields.get("angle", "right"))
    for name, fields in of_kind(cast("Entry", w.data["connections"]), _SLIDER):
        del name
        if fields.get("body") in bodies and "on" not in fields:
            found.setdefault(str(fields["body"]), known.get(str(fields.get("along")), fields.get("along", "right")))
    return {
        body: way.get("along", way.get("angle", "right")) if isinstance(way, dict) else way
        for body, way in found.items()
    }


def _is_point(entry: Any) -> bool:
    shape = shape_of(entry)
    return shape is not None and shape.kind == _POINT and "at" not in cast("Entry", entry)


def _has_height(entry: Any) -> bool:
    shape = shape_of(entry)
    fields = [cast("Entry", each) for each in cast("Entry", entry or {}).values() if isinstance(each, dict)]
    return shape is not None and shape.kind == _BOX and any("height" in each or "side" in each for each in fields)
