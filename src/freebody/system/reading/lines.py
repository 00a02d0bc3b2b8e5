"""Lines and planes fixed in bodies: `lines: {slope: {along: right}}`, `planes: {table: {normal: up}}`."""

from __future__ import annotations

from dataclasses import replace
from typing import Any, cast

from freebody.connections.slider import EITHER_WAY
from freebody.language.document.writer import flow_text
from freebody.language.sentences import Message, in_turn
from freebody.language.units import LENGTH
from freebody.measures.geometry import GROUND, Point
from freebody.model.elements import BodyPlane, Line, RigidBody
from freebody.model.names import Names
from freebody.system.reading.source import known_keys

# along: the way it points, solid on its right; angle: the same by an angle; solid: the side that is solid, across it
_DIRECTIONS = ("along", "angle", "solid")

_OF_CONTACTS = ("friction", "mu", "mu_s", "mu_k", "restitution", "Reibung")


def read_line(names: Names, body: RigidBody, name: str, spec: Any) -> Line:
    entry = cast("dict[str, Any]", spec) if isinstance(spec, dict) else {"along": spec}
    if (ends := _ends(names, body, spec)) is not None:
        label = _label(body, name)
        apart = tuple(b - a for a, b in zip(*(end.offset for end in ends), strict=True))
        return Line(ends[0], replace(names.unit_direction(body.name, apart), name=label), label)
    if rough := {key: value for key, value in entry.items() if key in _OF_CONTACTS}:
        contact = {"contact": {"between": ["BODY", name], **rough}}
        told = Message(
            "a line has no {keys}: that is of {contact}", keys=in_turn([*rough]), contact=flow_text(contact)[1:-1]
        )
        names.problem(told, next(iter(rough)))
        entry = {key: value for key, value in entry.items() if key not in rough}
    known_keys(names, entry, ("through", *_DIRECTIONS), Message("a line"))
    given = [key for key in _DIRECTIONS if key in entry]
    if not given and entry.keys() <= {"through"}:  # else what is there is told to be wrong
        names.problem(Message("a line needs a direction, e.g. {{along: right}}, {{angle: -alpha}} or {{solid: down}}"))
    elif len(given) > 1:
        told = Message("{first} and {second} both say how the line runs; keep one", first=given[0], second=given[1])
        names.problem(told, given[1])
    key = next(iter(given), "angle")
    way = entry.get(key, 0)
    way = EITHER_WAY.get(str(way), way) if key != "solid" else way
    along = names.direction(way, key, body=body.name)
    if key == "solid":
        along = along.normal()
    label = _label(body, name)
    return Line(_through(names, body, entry.get("through")), replace(along, name=label), label)


def _ends(names: Names, body: RigidBody, spec: Any) -> tuple[Point, Point] | None:
    """`[P, Q]`: the line from one point of its body to another."""
    if not isinstance(spec, list) or len(cast("list[Any]", spec)) != 2:
        return None
    called = [str(each).removeprefix(f"{body.name}.") for each in cast("list[Any]", spec)]
    if not all(name in body.points for name in called) or set(called) <= names.parameters.keys():
        return None
    return body.point(called[0]), body.point(called[1])


def read_plane(names: Names, body: RigidBody, name: str, spec: Any) -> BodyPlane:
    entry = cast("dict[str, Any]", spec) if isinstance(spec, dict) else {"normal": spec}
    known_keys(names, entry, ("through", "normal"), Message("a plane"))
    label = _label(body, name)
    normal = names.direction(entry.get("normal", "up"), "normal", body=body.name)
    return BodyPlane(_through(names, body, entry.get("through")), replace(normal, name=f"normal of {label}"), label)


def _label(body: RigidBody, name: str) -> str:
    return name if body.name == GROUND else f"{body.name}.{name}"


def _through(names: Names, body: RigidBody, through: Any) -> Point:
    """A point of a line or plane: by name, which needs no body where it is a point of its own, by its place on the
    body, or the middle of the body."""
    if isinstance(through, str):
        is_own = through in body.points or (body.name != GROUND and through not in names.bodies)
        if "." not in through and is_own:
            return names.point(f"{body.name}.{through}", "through")
        return names.point(through, "through")
    if through is None:
        return body.point()
    return replace(body.point(), offset=names.components(through, LENGTH, "through"))
