"""What each quantity is, stated once for both routes over a `State`.

A vector is a pair (x, y) of ground components.
"""

from __future__ import annotations

import math
from typing import Any, TypeVar

from freebody.errors import CannotAnswer
from freebody.measures.displacement import Displacement
from freebody.measures.geometry import GROUND, RIGHT, UP, ZERO, Direction, Point
from freebody.model.elements import Held
from freebody.model.question import (
    SYSTEM_CENTER,
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
    Wrench,
)
from freebody.model.state import State
from freebody.system.system import System

S = TypeVar("S")
ORIGIN = Point(GROUND, (ZERO, ZERO), "ground.origin")


def quantity_value(quantity: Quantity, system: System, state: State[Any]) -> Any:
    """The quantity at the state's instant: a scalar, or a pair for a vector. Raises CannotAnswer for
    quantities that are no property of one instant."""
    match quantity:
        case OfMeasure(measure, order):
            return (state.value, state.rate, state.acceleration)[order](measure)
        case OfPoint(point, order, along, size):
            return _component(_point(state, point, order), along, size, state)
        case InstantCentre(body, other):
            return _instant_centre(body, other, system, state)
        case Multiplier():
            row = multiplier_row(quantity, system)
            return row.sign * state.multiplier(row)
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
            return _component(_momentum(system, state, body), along, False, state)
        case Spin():
            return _spin(system, state, quantity)
        case Power(of):
            return _power(system, state, of)
        case RatioOf(top, bottom):
            return quantity_value(top, system, state) / quantity_value(bottom, system, state)
        case _:
            raise CannotAnswer(f"{type(quantity).__name__} is no property of one instant")


def multiplier_row(quantity: Multiplier, system: System) -> Held:
    """The held row whose multiplier is asked for."""
    return next(
        row
        for row in system.rows
        if row.connection == quantity.connection
        and row.reaction == quantity.reaction
        and set(quantity.at) <= set(row.ends or row.measure.bodies())
    )


def _point(state: State[Any], point: Point, order: int) -> tuple[Any, Any]:
    read = (state.value, state.rate, state.acceleration)[order]
    return read(Displacement(point, ORIGIN, RIGHT)), read(Displacement(point, ORIGIN, UP))


def _component(vector: tuple[Any, Any], along: Direction | None, size: bool, state: State[Any]) -> Any:
    if size:
        return state.sqrt(vector[0] * vector[0] + vector[1] * vector[1])
    if along is None:
        return vector
    tip, foot = Point(along.body, along.components), Point(along.body, (ZERO, ZERO))
    ex, ey = state.value(Displacement(tip, foot, RIGHT)), state.value(Displacement(tip, foot, UP))
    return vector[0] * ex + vector[1] * ey


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
    if quantity.moment and quantity.about is None:
        couples = [row for row in rows if row.reaction == "moment"]
        if couples:
            total: Any = 0
            for row in couples:
                total = total + state.gradient(row.measure, body)[2] * state.multiplier(row)
            return total
    fx: Any = 0
    fy: Any = 0
    moment: Any = 0
    for row in rows:
        gx, gy, gm = state.gradient(row.measure, body)
        multiplier = state.multiplier(row)
        fx, fy, moment = fx + gx * multiplier, fy + gy * multiplier, moment + gm * multiplier
    if not quantity.moment:
        return _component((fx, fy), quantity.along, quantity.size, state)
    if quantity.about is not None:
        gx, gy = _point(state, system.bodies[body].mass_center, 0)
        px, py = _point(state, quantity.about, 0)
        moment = moment + (gx - px) * fy - (gy - py) * fx
    return moment


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
                vx, vy = _point(state, b.mass_center, 1)
                total = total + state.scalar(b.mass) * (vx * vx + vy * vy) / 2
                if b.turns:
                    spin = _turning(state, b.name)
                    total = total + state.scalar(b.inertia) * spin * spin / 2
    if what in ("potential", "total"):
        for push in system.pushes:
            own = body is None or body in set(push.measure.bodies())
            if own and system.loads[push.load].stores_energy:
                total = total + state.potential(push)
    return total


def _turning(state: State[Any], body: str) -> Any:
    from freebody.measures.angle import Angle

    return state.rate(Angle(body))


def _momentum(system: System, state: State[Any], body: Group) -> tuple[Any, Any]:
    px: Any = 0
    py: Any = 0
    for b in system.moving:
        if is_among(b.name, body):
            vx, vy = _point(state, b.mass_center, 1)
            px, py = px + state.scalar(b.mass) * vx, py + state.scalar(b.mass) * vy
    return px, py


def is_among(name: str, group: Group) -> bool:
    """Whether a body is one of those that are meant."""
    return group is None or name == group or (isinstance(group, tuple) and name in group)


def point_about(system: System, state: State[Any], quantity: Spin) -> tuple[tuple[Any, Any], tuple[Any, Any]]:
    """Position and velocity of the point about which an angular momentum is meant."""
    group, about = quantity.body, quantity.about
    if about == SYSTEM_CENTER:
        return _mass_center(system, state, group)
    if about is None:
        about = system.bodies[group].mass_center if isinstance(group, str) else ORIGIN
    assert isinstance(about, Point)
    return _point(state, about, 0), _point(state, about, 1)


def _mass_center(system: System, state: State[Any], group: Group) -> tuple[tuple[Any, Any], tuple[Any, Any]]:
    """r_C = sum m r / sum m"""
    total: Any = 0
    x: Any = 0
    y: Any = 0
    for b in system.moving:
        if is_among(b.name, group):
            m = state.scalar(b.mass)
            bx, by = _point(state, b.mass_center, 0)
            total, x, y = total + m, x + m * bx, y + m * by
    px, py = _momentum(system, state, group)
    try:
        _ = x / total
    except ZeroDivisionError:
        raise CannotAnswer("these bodies have no mass, and so no mass centre") from None
    return (x / total, y / total), (px / total, py / total)


def _spin(system: System, state: State[Any], quantity: Spin) -> Any:
    """H_O = sum I w + m (r - r_O) x v, with absolute velocities."""
    (ox, oy), _velocity = point_about(system, state, quantity)
    total: Any = 0
    for b in system.moving:
        if is_among(b.name, quantity.body):
            x, y = _point(state, b.mass_center, 0)
            vx, vy = _point(state, b.mass_center, 1)
            total = total + state.scalar(b.mass) * ((x - ox) * vy - (y - oy) * vx)
            if b.turns:
                total = total + state.scalar(b.inertia) * _turning(state, b.name)
    return total
