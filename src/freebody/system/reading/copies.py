"""Equal bodies on one carrier, of which one is written: `copies: 3` at a planet wheel.

The others stand at the angles 2 pi k/n about the axis of the carrier, each on a pin of its own, in space in a bearing
whose axis is turned as well. What they mesh with
they mesh with together: the sum of the ways that roll off is held, so that its multiplier is the tooth force of each,
and the copies turn alike. That is the load sharing of equal planets, and leaves no loop redundant. Source: Norton,
Design of Machinery, 5th ed. 2012, sec. 9.6; condition of assembly: Mueller, Die Umlaufgetriebe, 2nd ed. 1998, sec. 3.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, replace
from functools import partial
from typing import Any, TypeVar, cast

from freebody.connections.base import Connection
from freebody.connections.standing import number_of
from freebody.language.expression import PI, ZERO, divide, number
from freebody.language.sentences import Message
from freebody.loads.base import Load
from freebody.measures.geometry import GROUND, Components, Point
from freebody.model.elements import RigidBody, Start
from freebody.model.names import Names
from freebody.model.rotations import UNIT, along_axis, applied, rotation, vector_product
from freebody.model.spec import Spec
from freebody.tolerances import ROUNDED

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


@dataclass(frozen=True)
class _Axis:
    """That about which a carrier turns: a point of it, and its direction there."""

    point: Point
    along: Components

    def turned(self, v: Components, k: int, n: int) -> Components:
        """Components on the carrier, turned by k of n equal parts of a turn."""
        columns = rotation(self.along, divide(2 * k * PI, number(n)))
        return applied(columns, (*v, *(ZERO,) * (3 - len(v))))[: len(v)]


@dataclass(frozen=True)
class _Axle:
    """What carries a copied body: a connection, the point of the body and that of its carrier. beside: what else each
    copy has."""

    name: str
    own: Point
    carried: Point
    beside: tuple[str, ...]


def add_copies(
    names: Names, connections: dict[str, Connection], loads: dict[str, Load]
) -> tuple[dict[str, Connection], dict[str, Load]]:
    """Puts copies on their carriers. The connections and loads with those of the copies."""
    for body in [body for body in names.bodies.values() if body.copies]:
        with names.at("bodies", body.name):
            axle = _axle(names, body, connections)
            if axle is None or not _looks_alike(names, body, axle, connections):
                continue
            axis, n = _axis_of(names, axle.carried.body, body, connections), len(body.copies) + 1
            if not names.known(axle.carried.body).is_placeholder:
                _look_at_room(names, body, axle, axis, connections)
            _look_at_assembly(names, body, connections)
            for k, copy in enumerate(body.copies, 1):
                names.bodies[copy] = _copy(names, body, copy)
                points = {str(axle.carried): str(_turned(names, axle.carried, axis, k, n))}
                for name in (axle.name, *axle.beside):
                    spec = connections[name]
                    more = spec.for_copy(names, axle.carried.body, partial(axis.turned, k=k, n=n))
                    renamed = _renamed(spec, body.name, copy, points)
                    connections[f"{name}_{k + 1}"] = renamed.model_copy(update=more)
                loads |= {
                    f"{load}_{k + 1}": _renamed(spec, body.name, copy, {})
                    for load, spec in list(loads.items())
                    if _is_on(spec, body.name)
                }
            told = Message(
                "the {n} copies of {body} stand at equal angles and share the load equally; a tooth force is that of "
                "one of them",
                n=n,
                body=body.name,
            )
            names.assumptions.append(told)
    return connections, loads


def _joined(names: Names, spec: Connection) -> tuple[Point, Point] | None:
    """The points that a pin, or in space a bearing, keeps together."""
    with names.quietly():
        bearing = spec.bearing(names) if names.space else None
        return spec.joined_points(names) if bearing is None else bearing[:2]


def _axle(names: Names, body: RigidBody, connections: Mapping[str, Connection]) -> _Axle | None:
    found: list[tuple[str, Point, Point]] = []
    beside: list[str] = []
    for name, spec in connections.items():
        with names.quietly():
            if body.name not in spec.mentions(names):
                continue
        if spec.with_copies == "together":
            continue
        if spec.with_copies != "each":
            told = Message(
                "copies of {body} can only be pinned to a carrier and mesh with gears; {connection} does neither",
                body=body.name,
                connection=name,
            )
            names.problem(told, "copies")
            return None
        joined = _joined(names, spec)
        if joined is None:
            beside.append(name)
        else:
            own, other = joined if joined[0].body == body.name else joined[::-1]
            found.append((name, own, other))
    if len(found) != 1 or found[0][2].body == GROUND:
        told = Message("the copies of {body} need one pin on a carrier that turns", body=body.name)
        names.problem(told, "copies")
        return None
    return _Axle(*found[0], tuple(beside))


def _axis_of(names: Names, carrier: str, body: RigidBody, connections: Mapping[str, Connection]) -> _Axis:
    """Where a carrier is pinned to something that is no copied wheel, the ground before others."""
    found: list[tuple[bool, _Axis]] = []
    for spec in connections.values():
        joined = _joined(names, spec)
        for own, other in () if joined is None else (joined, joined[::-1]):
            if own.body == carrier and not names.known(other.body).copies and other.body not in body.copies:
                found.append((other.body != GROUND, _Axis(own, _direction_on(names, spec, carrier))))
    if not found:
        return _Axis(names.known(carrier).center, UNIT[2])
    return min(found, key=lambda each: each[0])[1]


def _direction_on(names: Names, spec: Connection, body: str) -> Components:
    """That of the axis of a pin or of a bearing, on one of its bodies."""
    with names.quietly():
        bearing = spec.bearing(names) if names.space else None
    return UNIT[2] if bearing is None else next(axis.components for axis in bearing[2:] if axis.body == body)


def _looks_alike(names: Names, body: RigidBody, axle: _Axle, connections: Mapping[str, Connection]) -> bool:
    """In space: whether it is the same however it is turned about its axle, so that a copy is told by its bearing
    alone; else with a problem noted."""
    if not names.space:
        return True
    if body.chain:
        names.problem(Message("copies of {body} are turned as their bearings say: leave out turned", body=body.name))
        return False
    k = along_axis(_direction_on(names, connections[axle.name], body.name))
    tensor = [names.numeric(part) for part in body.tensor]  # xx, yy, zz, xy, xz, yz
    if k is None or None in tensor or len(tensor) < 6:
        return True
    one, other = (float(tensor[(k[0] + j) % 3] or 0.0) for j in (1, 2))
    if abs(one - other) > ROUNDED * abs(one + other) or any(abs(float(part or 0.0)) > ROUNDED for part in tensor[3:]):
        told = Message(
            "copies are of round wheels; {body} has different moments of inertia across its axle", body=body.name
        )
        names.problem(told, "copies")
        return False
    return True


def _turned(names: Names, axle: Point, axis: _Axis, k: int, n: int) -> Point:
    """Where the axle of copy k is on the carrier, entered among its points."""
    arm = tuple(a - b for a, b in zip(axle.offset, axis.point.offset, strict=True))
    offset = tuple(a + b for a, b in zip(axis.point.offset, axis.turned(arm, k, n), strict=True))
    carrier = names.known(axle.body)
    own = next(name for name, at in carrier.points.items() if at == axle.offset)
    name = f"{own}_{k + 1}"
    carrier.points[name] = offset
    return carrier.point(name)


def _copy(names: Names, body: RigidBody, name: str) -> RigidBody:
    """The body once more: its carrier says where."""
    start = Start(angle=body.start.angle, angular_velocity=body.start.angular_velocity)
    start = Start() if names.space else start
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
    names: Names, body: RigidBody, axle: _Axle, axis: _Axis, connections: Mapping[str, Connection]
) -> None:
    """Neighbours on parallel axles that would run into each other are refused, with the most that have room."""
    own = _direction_on(names, connections[axle.name], axle.carried.body)
    if any(number_of(names, part) for part in vector_product(own, axis.along)):
        return
    gap = [a - b for a, b in zip(axle.carried.offset, axis.point.offset, strict=True)]
    arm = [names.numeric(part) for part in vector_product((*gap, *(ZERO,) * (3 - len(gap))), axis.along)]
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
