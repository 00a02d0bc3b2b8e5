"""What each quantity is, stated once for both routes over a `State`.

A vector is a pair (x, y) of ground components; in space three, or those along the axes of another body.
"""

from __future__ import annotations

import math
import re
from typing import Any, TypeVar

from freebody.errors import CannotAnswer
from freebody.measures.displacement import Displacement
from freebody.measures.geometry import GROUND, ONE, RIGHT, UP, ZERO, Direction, Point
from freebody.model.elements import RigidBody
from freebody.model.question import (
    SYSTEM_CENTER,
    Basis,
    Energy,
    Group,
    InstantCentre,
    LoadForce,
    Momentum,
    Multiplier,
    OfMeasure,
    OfPoint,
    Power,
    Quantity,
    RatioOf,
    Spin,
    Turning,
    Wrench,
)
from freebody.model.spins import body_axes, spin
from freebody.model.state import State
from freebody.model.tensors import entries
from freebody.system.system import System

S = TypeVar("S")
ORIGIN = Point(GROUND, (ZERO, ZERO), "ground.origin")


def quantity_value(quantity: Quantity, system: System, state: State[Any]) -> Any:
    """The quantity at the state's instant: a scalar, or a pair for a vector. Raises CannotAnswer for
    quantities that are no property of one instant."""
    match quantity:
        case OfMeasure(measure, order):
            return (state.value, state.rate, state.acceleration)[order](measure)
        case OfPoint(point, order, along, size, basis):
            return component(place(system, state, point, order), along, size, state, basis)
        case Turning():
            return component(
                _turning_vector(system, state, quantity), quantity.along, quantity.size, state, quantity.basis
            )
        case InstantCentre(body, other):
            return _instant_centre(body, other, system, state)
        case Multiplier():
            return multiplier(quantity, system, state)
        case Wrench():
            return _wrench(quantity, system, state)
        case LoadForce(load):
            pushes = [p for p in system.pushes if p.load == load]
            if len(pushes) != 1:
                raise CannotAnswer(f"{load} acts on several bodies; ask for one body's part")
            return system.loads[load].pulling_sign * state.law(pushes[0])
        case Energy(what, body):
            return energy(what, body, system, state)
        case Momentum(body, along):
            return component(_momentum(system, state, body), along, False, state)
        case Spin():
            return _spin(system, state, quantity)
        case Power(of):
            return _power(system, state, of)
        case RatioOf(top, bottom):
            return quantity_value(top, system, state) / quantity_value(bottom, system, state)
        case _:
            words = re.sub(r"(?<=[a-z])(?=[A-Z])", " ", type(quantity).__name__).lower()
            raise CannotAnswer(f"the {words} is not worked out at one instant; ask for it without at or when")


def multiplier(quantity: Multiplier, system: System, state: State[Any]) -> Any:
    """What the row transmits, less the dry friction on the way to the place that is asked for."""
    rows = {row.name: row for row in system.rows}
    total = rows[quantity.row].sign * state.multiplier(rows[quantity.row])
    for name in quantity.less:
        total = total - rows[name].sign * state.multiplier(rows[name])
    return total


Vector = tuple[Any, ...]
AXES = (RIGHT, UP, Direction(GROUND, (ZERO, ZERO, ONE), "z"))


def axes_of(system: System) -> tuple[Direction, ...]:
    """The axes of the ground."""
    return AXES if system.space else AXES[:2]


def place(system: System, state: State[Any], point: Point, order: int = 0) -> Vector:
    """Position, velocity or acceleration of a point."""
    read = (state.value, state.rate, state.acceleration)[order]
    return tuple(read(Displacement(point, ORIGIN, axis)) for axis in axes_of(system))


def _point(state: State[Any], point: Point, order: int) -> tuple[Any, Any]:
    """In the plane."""
    read = (state.value, state.rate, state.acceleration)[order]
    return read(Displacement(point, ORIGIN, RIGHT)), read(Displacement(point, ORIGIN, UP))


def component(
    vector: Vector, along: Direction | None, size: bool, state: State[Any], basis: Basis | None = None
) -> Any:
    """A vector as it is asked for: its size, its part along a direction, or all of it, in a basis."""
    if size:
        return state.sqrt(dot(vector, vector))
    if along is not None:
        return dot(vector, components_of(along, state, len(vector)))
    if basis is None:
        return vector
    return tuple(dot(vector, components_of(axis, state, len(vector))) for axis in basis)


def components_of(direction: Direction, state: State[Any], n: int) -> Vector:
    """Ground components of a direction."""
    tip, foot = Point(direction.body, direction.components), Point(direction.body, (ZERO, ZERO))
    return tuple(state.value(Displacement(tip, foot, axis)) for axis in AXES[:n])


def dot(a: Vector, b: Vector) -> Any:
    total: Any = 0
    for x, y in zip(a, b, strict=True):
        total = total + x * y
    return total


def cross(a: Vector, b: Vector) -> Vector:
    """The vector product in space, (its component out of) the plane otherwise."""
    if len(a) == 2:
        return (a[0] * b[1] - a[1] * b[0],)
    return tuple(a[j] * b[k] - a[k] * b[j] for j, k in ((1, 2), (2, 0), (0, 1)))


def _sum(a: Vector, b: Vector) -> Vector:
    return tuple(x + y for x, y in zip(a, b, strict=True))


# -- turning in space -------------------------------------------------------------------------
def angular_velocity(system: System, state: State[Any], body: str, axes: Basis) -> Vector:
    """Of a body against the ground, along given axes."""
    if system.bodies[body].fixed:
        return (0,) * len(axes)
    return tuple(state.rate(spin(body, axis)) for axis in axes)


def _turning_vector(system: System, state: State[Any], q: Turning) -> Vector:
    """omega or d omega/dt against another body, seen from the ground."""
    read = (state.rate, state.acceleration)[q.order - 1]
    total: Vector = (0, 0, 0)
    for name, sign in ((q.body, 1), (q.relative_to, -1)):
        if not system.bodies[name].fixed:
            total = tuple(t + sign * read(spin(name, axis)) for t, axis in zip(total, AXES, strict=True))
    return total


# -- instant centres --------------------------------------------------------------------------
FAR = 1e9  # [m]; beyond it a centre in numbers is at infinity


def _instant_centre(body: str, other: str, system: System, state: State[Any]) -> tuple[Any, Any]:
    """Where both bodies have the same velocity. With u_i = v_i - w_i x r_i, the velocity of the point of body i at the
    origin, u_1 + w_1 x r = u_2 + w_2 x r, so that r = (-d_y, d_x)/w with d = u_1 - u_2 and w = w_1 - w_2.
    Source: Norton, Design of Machinery, 5th ed. 2012, sec. 6.3."""
    dx, dy, w = relative_motion(body, other, system, state)
    if _vanishes(w, dx, dy):
        pair = body if other == GROUND else f"{body} relative to {other}"
        if _vanishes(dx) and _vanishes(dy):
            raise CannotAnswer(
                f"{pair} is at rest: a body that does not move has no instant centre. Give rates under start"
            )
        raise CannotAnswer(f"{pair} is in translation: the centre is at infinity along {_normal(dx, dy)}")
    return -dy / w, dx / w


def relative_motion(body: str, other: str, system: System, state: State[Any]) -> tuple[Any, Any, Any]:
    """Relative velocity of the points of two bodies that are at the origin, and the relative angular velocity."""
    (ux, uy, w), (vx, vy, w_other) = (motion_at_origin(system, state, name) for name in (body, other))
    return ux - vx, uy - vy, w - w_other


def motion_at_origin(system: System, state: State[Any], body: str) -> tuple[Any, Any, Any]:
    """Velocity of the point of a body that is at the origin, and its angular velocity."""
    if system.bodies[body].fixed:
        return 0, 0, 0
    point = system.bodies[body].center
    (x, y), (vx, vy), w = _point(state, point, 0), _point(state, point, 1), _turning(state, body)
    return vx + w * y, vy - w * x, w


def _vanishes(x: Any, *others: Any) -> bool:
    """True for an element that is zero, or a number that is nothing beside others."""
    if isinstance(x, (int, float)):
        return abs(x) <= max((abs(float(other)) for other in others), default=0.0) / FAR
    return bool(x.is_zero())


def _normal(dx: Any, dy: Any) -> str:
    """The direction across a velocity, in words."""
    if _vanishes(dx, dy):
        return "right"
    if _vanishes(dy, dx):
        return "up"
    if isinstance(dx, (int, float)):
        return f"{math.degrees(math.atan2(float(dx), -float(dy))) % 180.0:.6g} deg"
    return "the normal of its velocity"


# -- forces -----------------------------------------------------------------------------------
def body_of_wrench(quantity: Wrench, system: System) -> str:
    """The body on which a connection's force is asked: the one named, else the one that is not fixed, else the
    second that the connection names."""
    bodies = list(
        dict.fromkeys(b for row in system.held if row.connection == quantity.connection for b in row.measure.bodies())
    )
    if quantity.on is not None:
        if quantity.on not in bodies:
            raise CannotAnswer(f"{quantity.connection} does not act on {quantity.on}, but on {', '.join(bodies)}")
        return quantity.on
    moving = [b for b in bodies if not system.bodies[b].fixed]
    if not moving:
        raise CannotAnswer(f"{quantity.connection} joins fixed bodies only")
    return moving[0]


def _wrench(quantity: Wrench, system: System, state: State[Any]) -> Any:
    """Force and moment of a connection on a body: the sum of multiplier * gradient over its rows."""
    body = body_of_wrench(quantity, system)
    rows = [row for row in system.held if row.connection == quantity.connection]
    if quantity.moment and quantity.about is None and not system.space:
        couples = [row for row in rows if row.reaction == "moment"]
        if couples:
            total: Any = 0
            for row in couples:
                total = total + state.gradient(row.measure, body)[2] * state.multiplier(row)
            return total
    n = len(axes_of(system))
    force: Vector = (0,) * n
    moment: Vector = (0,) * (3 if system.space else 1)
    for row in rows:
        push, multiplier = state.gradient(row.measure, body), state.multiplier(row)
        force = tuple(f + g * multiplier for f, g in zip(force, push[:n], strict=True))
        moment = tuple(m + g * multiplier for m, g in zip(moment, push[n:], strict=True))
    if not quantity.moment:
        return component(force, quantity.along, quantity.size, state, quantity.basis)
    if quantity.about is not None:
        center, about = place(system, state, system.bodies[body].mass_center), place(system, state, quantity.about)
        arm = tuple(c - p for c, p in zip(center, about, strict=True))
        moment = _sum(moment, cross(arm, force))
    if not system.space:
        return moment[0]
    return component(moment, quantity.along, quantity.size, state, quantity.basis)


def _power(system: System, state: State[Any], of: str) -> Any:
    total: Any = 0
    for push in system.pushes:
        if push.load == of:
            total = total + state.law(push) * state.rate(push.measure)
    for row in system.held:
        if row.connection == of:
            total = total + state.multiplier(row) * state.rate(row.measure)
    return total


# -- energy and momentum ----------------------------------------------------------------------
def energy(what: str, body: str | None, system: System, state: State[Any]) -> Any:
    """Kinetic energy m v^2/2 + I w^2/2; potential energy of the loads that store energy."""
    total: Any = 0
    if what in ("kinetic", "total"):
        for b in system.moving:
            if body is None or b.name == body:
                v = place(system, state, b.mass_center, 1)
                total = total + state.scalar(b.mass) * dot(v, v) / 2
                if b.turns and system.space:
                    omega = angular_velocity(system, state, b.name, body_axes(b.name))
                    total = total + dot(omega, _times_tensor(b, state, omega)) / 2
                elif b.turns:
                    w = _turning(state, b.name)
                    total = total + state.scalar(b.inertia) * w * w / 2
    if what in ("potential", "total"):
        for push in system.pushes:
            own = body is None or body in set(push.measure.bodies())
            if own and system.loads[push.load].stores_energy:
                total = total + state.potential(push)
    return total


def _turning(state: State[Any], body: str) -> Any:
    from freebody.measures.angle import Angle

    return state.rate(Angle(body))


def _times_tensor(body: RigidBody, state: State[Any], omega: Vector) -> Vector:
    """I omega along the body's axes."""
    return tuple(dot(tuple(state.scalar(e) for e in row), omega) for row in entries(body.tensor or (ZERO,) * 6))


def _momentum(system: System, state: State[Any], body: Group) -> Vector:
    total: Vector = (0,) * len(axes_of(system))
    for b in system.moving:
        if is_among(b.name, body):
            m, v = state.scalar(b.mass), place(system, state, b.mass_center, 1)
            total = tuple(t + m * c for t, c in zip(total, v, strict=True))
    return total


def is_among(name: str, group: Group) -> bool:
    """Whether a body is one of those that are meant."""
    return group is None or name == group or (isinstance(group, tuple) and name in group)


def point_about(system: System, state: State[Any], quantity: Spin) -> tuple[Vector, Vector]:
    """Position and velocity of the point about which an angular momentum is meant."""
    group, about = quantity.body, quantity.about
    if about == SYSTEM_CENTER:
        return _mass_center(system, state, group)
    if about is None:
        about = system.bodies[group].mass_center if isinstance(group, str) else ORIGIN
    assert isinstance(about, Point)
    return place(system, state, about), place(system, state, about, 1)


def _mass_center(system: System, state: State[Any], group: Group) -> tuple[Vector, Vector]:
    """r_C = sum m r / sum m"""
    total: Any = 0
    moment: Vector = (0,) * len(axes_of(system))
    for b in system.moving:
        if is_among(b.name, group):
            m, r = state.scalar(b.mass), place(system, state, b.mass_center)
            total, moment = total + m, tuple(t + m * c for t, c in zip(moment, r, strict=True))
    momentum = _momentum(system, state, group)
    try:
        return tuple(c / total for c in moment), tuple(c / total for c in momentum)
    except ZeroDivisionError:
        raise CannotAnswer("these bodies have no mass, and so no mass centre") from None


def _spin(system: System, state: State[Any], quantity: Spin) -> Any:
    """H_O = sum I w + m (r - r_O) x v, with absolute velocities."""
    about, _velocity = point_about(system, state, quantity)
    total: Vector = (0, 0, 0) if system.space else (0,)
    for b in system.moving:
        if is_among(b.name, quantity.body):
            r, v = place(system, state, b.mass_center), place(system, state, b.mass_center, 1)
            arm, m = tuple(c - o for c, o in zip(r, about, strict=True)), state.scalar(b.mass)
            total = _sum(total, tuple(m * c for c in cross(arm, v)))
            if b.turns:
                total = _sum(total, _own_spin(system, state, b))
    if not system.space:
        return total[0]
    return component(total, quantity.along, quantity.size, state, quantity.basis)


def _own_spin(system: System, state: State[Any], b: RigidBody) -> Vector:
    """The angular momentum about the mass centre, by its ground components."""
    if not system.space:
        return (state.scalar(b.inertia) * _turning(state, b.name),)
    axes = body_axes(b.name)
    own = _times_tensor(b, state, angular_velocity(system, state, b.name, axes))
    total: Vector = (0, 0, 0)
    for h, axis in zip(own, axes, strict=True):
        total = tuple(t + h * c for t, c in zip(total, components_of(axis, state, 3), strict=True))
    return total
