"""What each quantity is, stated once for both routes over a `State`.

A vector is a pair (x, y) of ground components.
"""

from __future__ import annotations

from typing import Any, TypeVar

from freebody.errors import CannotAnswer
from freebody.measures.displacement import Displacement
from freebody.measures.geometry import GROUND, RIGHT, UP, ZERO, Direction, Point
from freebody.model.elements import Held
from freebody.model.question import (
    Energy,
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
        case Spin(body, about):
            return _spin(system, state, body, about)
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
        for row in system.held
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


def _momentum(system: System, state: State[Any], body: str | None) -> tuple[Any, Any]:
    px: Any = 0
    py: Any = 0
    for b in system.moving:
        if body is None or b.name == body:
            vx, vy = _point(state, b.mass_center, 1)
            px, py = px + state.scalar(b.mass) * vx, py + state.scalar(b.mass) * vy
    return px, py


def _spin(system: System, state: State[Any], body: str | None, about: Point | None) -> Any:
    """H_O = sum I w + m (r - r_O) x v, with absolute velocities."""
    if about is None:
        about = ORIGIN if body is None else system.bodies[body].mass_center
    ox, oy = _point(state, about, 0)
    total: Any = 0
    for b in system.moving:
        if body is None or b.name == body:
            x, y = _point(state, b.mass_center, 0)
            vx, vy = _point(state, b.mass_center, 1)
            total = total + state.scalar(b.mass) * ((x - ox) * vy - (y - oy) * vx)
            if b.turns:
                total = total + state.scalar(b.inertia) * _turning(state, b.name)
    return total
