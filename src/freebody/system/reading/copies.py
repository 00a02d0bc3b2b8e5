"""Equal bodies on one carrier, of which one is written: `copies: 3` at a planet wheel.

The others stand at the angles 2 pi k/n about the axis of the carrier, each on a pin of its own. What they mesh with
they mesh with together: the sum of the ways that roll off is held, so that its multiplier is the tooth force of each,
and the copies turn alike. That is the load sharing of equal planets, and leaves no loop redundant. Source: Norton,
Design of Machinery, 5th ed. 2012, sec. 9.6; condition of assembly: Mueller, Die Umlaufgetriebe, 2nd ed. 1998, sec. 3.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import replace
from typing import Any, TypeVar, cast

from freebody.connections.base import Connection
from freebody.language.expression import PI, Call, Expr, divide, number
from freebody.language.sentences import Message
from freebody.loads.base import Load
from freebody.measures.geometry import GROUND, Point
from freebody.model.elements import RigidBody, Start
from freebody.model.names import Names
from freebody.model.spec import Spec

SpecT = TypeVar("SpecT", bound=Spec)


def copied_names(names: Names, body: str, given: Any, taken: Mapping[str, Any]) -> tuple[str, ...]:
    """What the further ones of `copies: n` are called."""
    if given is None:
        return ()
    if not isinstance(given, int) or isinstance(given, bool) or given < 2:
        told = Message("copies says how many {body} there are: a whole number, at least 2", body=body)
        names.problem(told, "copies")
        return ()
    found = tuple(f"{body}_{k}" for k in range(2, given + 1))
    for name in found:
        if name in taken:
            told = Message("a copy of {body} would be called {name}, which is taken; rename that", name=name, body=body)
            names.problem(told, "copies")
    return found


def add_copies(
    names: Names, connections: dict[str, Connection], loads: dict[str, Load]
) -> tuple[dict[str, Connection], dict[str, Load]]:
    """Puts copies on their carriers. The connections and loads with those of the copies."""
    for body in [body for body in names.bodies.values() if body.copies]:
        with names.at("bodies", body.name):
            axle = _axle(names, body, connections)
            if axle is None:
                continue
            name, own, carried = axle
            _look_at_room(names, body, own, carried, connections)
            _look_at_assembly(names, body, connections)
            for k, copy in enumerate(body.copies, 1):
                names.bodies[copy] = _copy(body, copy)
                there = _turned(names, carried, _axis_of(names, carried.body, body, connections), k, body)
                points = {str(carried): str(there)}
                connections[f"{name}_{k + 1}"] = _renamed(connections[name], body.name, copy, points)
                loads |= {
                    f"{load}_{k + 1}": _renamed(spec, body.name, copy, {})
                    for load, spec in list(loads.items())
                    if _is_on(spec, body.name)
                }
            told = Message(
                "the {n} copies of {body} stand at equal angles and share the load equally; a tooth force is that of "
                "one of them",
                n=len(body.copies) + 1,
                body=body.name,
            )
            names.assumptions.append(told)
    return connections, loads


def _axle(names: Names, body: RigidBody, connections: Mapping[str, Connection]) -> tuple[str, Point, Point] | None:
    """The connection that carries a body, the point of the body and that of its carrier."""
    found: list[tuple[str, Point, Point]] = []
    for name, spec in connections.items():
        with names.quietly():
            if body.name not in spec.mentions(names):
                continue
            joined = spec.joined_points(names)
        if spec.with_copies == "together":
            continue
        if spec.with_copies != "each" or joined is None:
            told = Message(
                "copies of {body} can only be pinned to a carrier and mesh with gears; {connection} does neither",
                body=body.name,
                connection=name,
            )
            names.problem(told, "copies")
            return None
        own, other = joined if joined[0].body == body.name else joined[::-1]
        found.append((name, own, other))
    if len(found) != 1 or found[0][2].body == GROUND:
        told = Message("the copies of {body} need one pin on a carrier that turns", body=body.name)
        names.problem(told, "copies")
        return None
    return found[0]


def _axis_of(names: Names, carrier: str, body: RigidBody, connections: Mapping[str, Connection]) -> Point:
    """The point of a carrier about which it turns: where it is pinned to something that is no copied wheel."""
    for spec in connections.values():
        with names.quietly():
            joined = spec.joined_points(names)
        for own, other in () if joined is None else (joined, joined[::-1]):
            if own.body == carrier and not names.known(other.body).copies and other.body not in body.copies:
                return own
    return names.known(carrier).center


def _turned(names: Names, axle: Point, axis: Point, k: int, body: RigidBody) -> Point:
    """Where the axle of copy k is on the carrier, entered among its points."""
    turn = divide(2 * k * PI, number(len(body.copies) + 1))
    c, s = Call("cos", turn), Call("sin", turn)
    (x, y, *_), (x0, y0, *_) = axle.offset, axis.offset
    dx, dy = x - x0, y - y0
    offset: tuple[Expr, ...] = (x0 + c * dx - s * dy, y0 + s * dx + c * dy)
    carrier = names.known(axle.body)
    own = next(name for name, at in carrier.points.items() if at == axle.offset)
    name = f"{own}_{k + 1}"
    carrier.points[name] = offset
    return carrier.point(name)


def _copy(body: RigidBody, name: str) -> RigidBody:
    """The body once more: its carrier says where."""
    start = Start(angle=body.start.angle, angular_velocity=body.start.angular_velocity)
    return replace(body, name=name, copies=(), start=start, lines={}, points=dict(body.points))


def _is_on(spec: Load, body: str) -> bool:
    return any(isinstance(v, str) and v.split(".")[0] == body for v in spec.to_plain().values())


def _renamed(spec: SpecT, body: str, copy: str, points: Mapping[str, str]) -> SpecT:
    """A description of the copy: its own points in place of those of the first."""

    def put(value: Any) -> Any:
        if isinstance(value, list):
            return [put(each) for each in cast("list[Any]", value)]
        if not isinstance(value, str):
            return value
        owner, dot, point = value.partition(".")
        return points.get(value) or (f"{copy}{dot}{point}" if owner == body else value)

    return spec.model_copy(update={key: put(value) for key, value in spec.to_plain().items()})


def _look_at_room(
    names: Names, body: RigidBody, own: Point, carried: Point, connections: Mapping[str, Connection]
) -> None:
    """Neighbours that would run into each other are refused, with the most that have room."""
    axis = _axis_of(names, carried.body, body, connections)
    arm = [names.numeric(a - b) for a, b in zip(carried.offset, axis.offset, strict=True)]
    radius = None if body.radius is None else names.numeric(body.radius)
    if radius is None or any(x is None for x in arm):
        return
    distance, n = math.hypot(*cast("list[float]", arm)), len(body.copies) + 1
    if distance == 0.0:
        told = Message(
            "the axle of {body} lies on the axis of its carrier, where there is room for one only", body=body.name
        )
        names.problem(told, "copies")
    elif distance * math.sin(math.pi / n) <= radius:
        most = math.floor(math.pi / math.asin(min(radius / distance, 1.0)) - 1e-9)
        told = Message(
            "{n} copies of {body} of radius {radius:.4g} m do not fit at {distance:.4g} m from the axis; at most "
            "{most} do",
            n=n,
            body=body.name,
            radius=radius,
            distance=distance,
            most=most,
        )
        names.problem(told, "copies")


def _look_at_assembly(names: Names, body: RigidBody, connections: Mapping[str, Connection]) -> None:
    """With n planets at equal angles the teeth of both gears that they mesh with have to stand right for each: for
    teeth z_1, z_2 that mesh with p_1, p_2 of the planet, (z_1 p_2 + z_2 p_1)/(n gcd(p_1, p_2)) is whole where one of
    the two is a ring gear, and so is the difference where both are alike."""
    n = len(body.copies) + 1
    found = [mesh for spec in connections.values() if (mesh := spec.teeth_with(names, body.name)) is not None]
    for k, (z1, p1, sense1) in enumerate(found):
        for z2, p2, sense2 in found[k + 1 :]:
            common = math.gcd(round(p1), round(p2))
            if not common:  # less than half a tooth
                continue
            total = abs(round(z1) * round(p2) - sense1 * sense2 * round(z2) * round(p1)) // common
            if total % n:
                able = [m for m in range(2, n + 4) if total % m == 0]
                told = Message(
                    "{n} copies of {body} cannot be assembled at equal angles: with these teeth {total} would have to "
                    "be divisible by {n}; possible numbers: {able}",
                    n=n,
                    body=body.name,
                    total=total,
                    able=", ".join(map(str, able)) or Message("none"),
                )
                names.problem(told, "copies")
