"""Slider (prismatic joint): a body moves along a straight guide and does not turn against it."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING, Any

from freebody.connections.base import Connection
from freebody.language.units import DIMENSIONLESS, LENGTH
from freebody.measures.angle import Angle
from freebody.measures.base import Measure
from freebody.measures.combination import Combination
from freebody.measures.displacement import Displacement
from freebody.measures.geometry import GROUND, ONE, ZERO, Direction, Point
from freebody.model.elements import Bound, Held, Rub
from freebody.model.friction import read_friction
from freebody.model.spec import Formula, Heading

if TYPE_CHECKING:
    from freebody.model.names import Names


def guide(
    names: Names, point: Point, along: Heading, on: str, through: str | None
) -> tuple[Measure, Displacement, Direction]:
    """The measure across a straight guide, the one along it, and its direction. Without a point of the guide, one
    on the ground passes where the moving body is put (`at`, `near`), else through the origin; one on a body through
    its reference point."""
    line = names.line(along, "along") if isinstance(along, str) else None
    direction = names.direction(along, "along", body=names.body(on, "on").name)
    if through is not None:
        origin = names.point(through, "through")
    elif line is not None:
        origin = line.through
    elif direction.body == GROUND:
        origin = Point(GROUND, (ZERO, ZERO), "ground.origin")
        across = Displacement(point, origin, direction.normal())
        start = names.known(point.body).start
        if start.at is None and start.near is None:
            return across, Displacement(point, origin, direction), direction
        return Combination(((ONE, across),), LENGTH), Displacement(point, origin, direction), direction
    else:
        origin = names.known(direction.body).point()
    return Displacement(point, origin, direction.normal()), Displacement(point, origin, direction), direction


class Slider(Connection, kind="slider"):
    """`slider: {body: block, along: right}`; `on` is the guiding body (default the ground), `through` a point
    of the guide. Holds the displacement across the guide and the angle (2 rows).
    `friction`: the force that resists is mu times the normal force."""

    body: str
    along: Heading
    on: str = GROUND
    through: str | None = None
    friction: Formula | dict[str, Any] = 0

    in_plane = True
    example = """
bodies: {block: {rectangle: {mass: 1 kg, width: 1 m, height: 1 m}}}
connections: {it: {slider: {body: block, along: right}}}
"""

    def rows(self, names: Names) -> list[Held]:
        point = names.point(self.body, "body")
        across, _along, direction = guide(names, point, self.along, self.on, self.through)
        if point.body == direction.body:
            names.problem(f"{point.body} cannot slide on itself; name another body with on")
            return []
        rows = [Held("normal", "normal force", across)]
        if names.known(point.body).turns and names.known(direction.body).turns:
            angle = Angle(point.body, direction.body)
            rows.append(Held("angle", "moment", Combination(((ONE, angle),), DIMENSIONLESS)))
        return rows

    def bounds(self, names: Names, connection: str) -> tuple[list[Bound], list[Rub]]:
        friction = read_friction(names, self.friction, DIMENSIONLESS)
        if friction.is_none:
            return [], []
        point = names.point(self.body, "body")
        travel = guide(names, point, self.along, self.on, self.through)[1]
        row = Held("friction", "friction force", travel, connection=connection)
        return [], [Rub(row, friction.static, friction.kinetic, (f"{connection}.normal",))]

    def offers(self, names: Names) -> Iterable[tuple[str, Measure]]:
        point = names.point(self.body, "body")
        yield "travel", guide(names, point, self.along, self.on, self.through)[1]
