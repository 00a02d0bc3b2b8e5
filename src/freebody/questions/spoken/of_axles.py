"""Axles of a model, what turns about them and where: wheels, planets, pendulums."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING

from freebody.language.expression import ZERO
from freebody.measures.angle import Angle
from freebody.measures.geometry import GROUND, Components
from freebody.questions.spoken import lookup
from freebody.questions.spoken.joining import ends_of, is_of, keeps_height

if TYPE_CHECKING:
    from freebody.model.names import Names


def planets(names: Names) -> list[str]:
    """Gears with more meshes than one that turn about no axle of the ground."""
    toothed = [body for row in names.constraint_rows if row.reaction == "tooth force" for body in row.measure.bodies()]
    turning = lookup.turning(names)
    return [body for body in turning if toothed.count(body) > 1 and not axle_points(names, body)]


def axles(names: Names) -> list[str]:
    """Connections that something turns about."""
    return [name for name in names.connections if "axle" in names.called.get(name, ())]


def bearings(names: Names) -> list[str]:
    """Connections that carry something: no drive, and nothing that is made one with another thing."""
    no_bearings = {"driver", "weld"}
    return axles(names) or [name for name in names.connections if not no_bearings & {*names.called.get(name, ())}]


def axle_points(names: Names, body: str, *, later: bool = False) -> set[Components]:
    """The points of a body at which axles of the ground hold it, in its own axes. later: or will hold it, once they
    have caught it."""
    joints = axles(names) if later or not names.closing_later else []  # what is caught later has no axle before
    if not lookup.places(names, body):  # of a shaft that nobody asks how far it slides
        joints = [*joints, *(name for name in names.connections if "cylindrical" in names.called.get(name, ()))]
    return _points_of(names, body, (name for name in joints if GROUND in names.connections[name].mentions(names)))


def axle_points_on_level(names: Names, body: str) -> set[Components]:
    """The points of a body at which axles of bodies that only move level hold it: of a pendulum on a cart."""
    joints = () if names.closing_later else axles(names)
    others = {name: names.connections[name].mentions(names) - {body} for name in joints}
    return _points_of(names, body, (name for name in joints if all(keeps_height(names, one) for one in others[name])))


def _points_of(names: Names, body: str, joints: Iterable[str]) -> set[Components]:
    found: set[Components] = set()
    for name in joints if body in names.bodies else ():
        if is_of(names, name, body):
            own, ends = names.bodies[body], ends_of(names, name)
            points = [end.partition(".")[2] or own.default_point for end in ends if end.partition(".")[0] == body]
            found |= {own.points[point] for point in points if point in own.points}
    return found


def axle_of(names: Names, body: str) -> str:
    """Where a body turns about an axle of the ground: at its mass `center` or `beside` it; else nothing."""
    points = axle_points(names, body)
    if not points:
        return "center" if _is_coaxial(names, body) else ""
    return "center" if names.bodies[body].points.get("mass_center") in points else "beside"


def _is_coaxial(names: Names, body: str) -> bool:
    """Whether a body is held at its centre by that of another one which turns about an axle of the ground: the wheel
    of a differential in its carrier."""
    for name in () if names.closing_later else axles(names):
        others = names.connections[name].mentions(names) - {body, GROUND}
        if len(others) == 1 and body in names.connections[name].mentions(names):
            [other] = others
            here = (
                _points_of(names, one, [name]) == {names.bodies[one].points["mass_center"]} for one in (body, other)
            )
            if names.bodies[other].points["mass_center"] in axle_points(names, other) and all(here):
                return True
    return False


def turned(names: Names, body: str) -> list[str]:
    """Angles of how far a body has turned since the start: those that begin at zero."""
    free = {
        name
        for name in lookup.moving(names)
        if axle_of(names, name) == "center" and names.bodies[name].start.angle is None
    }
    plain = {
        name for name, m in names.measures.items() if isinstance(m, Angle) and m.of in free and m.reference == ZERO
    }
    begun = names.started_at_zero | {name for name in plain if name not in names.placed_at_start}
    return [name for name in lookup.angles(names, body) if name in begun]
