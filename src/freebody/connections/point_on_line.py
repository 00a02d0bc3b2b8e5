"""A point on a line or in a plane: a ball in a tube, a ball on a table."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING, Any, ClassVar

from freebody.connections.base import Connection
from freebody.connections.joints import across_names, rubbing_along
from freebody.language.sentences import Message
from freebody.measures.base import Measure
from freebody.measures.displacement import Displacement
from freebody.measures.geometry import Direction, Point
from freebody.model import glyphs
from freebody.model.elements import ConstraintRow, DryFriction, UnilateralConstraint
from freebody.model.glyphs import Glyph
from freebody.model.noting import did_you_mean
from freebody.model.rotations import perpendiculars
from freebody.model.spec import Formula, Heading

if TYPE_CHECKING:
    from freebody.model.names import Names


class PointOnLine(Connection, kind="point_on_line"):
    """`point_on_line: {point: shaft.B, through: ground.A, along: x}`: a point stays on the line through a point of
    another body, along a direction of that body; a bearing that holds across its axis alone (2 rows).
    `friction: mu`: the force that resists along it is mu times the normal force, the resultant of both."""

    space_only = True
    in_plane_take = "slot"

    called: ClassVar[tuple[str, ...]] = ("guide", "wire", "rail")

    point: str
    through: str
    along: Heading
    friction: Formula | dict[str, Any] = 0

    example = """
space: true
bodies: {rod: {box: {mass: 1 kg, size: [1 m, 0.1 m, 0.2 m]}}}
connections: {it: {point_on_line: {point: rod.left, through: ground.A, along: x}}}
"""

    def _line(self, names: Names) -> tuple[Point, Point, Direction] | None:
        point, through = names.point(self.point, "point"), names.point(self.through, "through")
        along = names.direction(self.along, "along", body=through.body)
        if point.body == through.body or along.body == point.body:
            names.problem(
                Message("the point and the line are both on {body}; name points of two bodies", body=point.body)
            )
            return None
        return point, through, along

    def rows(self, names: Names) -> list[ConstraintRow]:
        line = self._line(names)
        if line is None:
            return []
        point, through, along = line
        across = [Direction(along.body, v) for v in perpendiculars(along.components)]
        return [
            ConstraintRow(name, "force", Displacement(point, through, direction))
            for name, direction in zip(across_names(along), across, strict=True)
        ]

    def bounds(self, names: Names, connection: str) -> tuple[list[UnilateralConstraint], list[DryFriction]]:
        with names.quietly():
            line = self._line(names)
            rows = self.rows(names)
        return ([], []) if line is None else rubbing_along(names, self.friction, Displacement(*line), rows, connection)

    def offers(self, names: Names) -> Iterable[tuple[str, Measure]]:
        line = self._line(names)
        if line is not None:
            yield "travel", Displacement(*line)

    def glyphs(self, names: Names) -> Iterable[Glyph]:
        line = self._line(names)
        if line is not None:
            point, through, along = line
            yield glyphs.Rail(through, point, along, "freely")


class PointOnPlane(Connection, kind="point_on_plane"):
    """`point_on_plane: {point: leg.foot, on: ground.floor}`: a point stays in a plane of another body, without friction
    (1 row)."""

    space_only = True
    in_plane_take = "slot"

    point: str
    on: str

    example = """
space: true
ground: {planes: {floor: {normal: up}}}
bodies: {rod: {box: {mass: 1 kg, size: [1 m, 0.1 m, 0.2 m]}}}
connections: {it: {point_on_plane: {point: rod.left, on: floor}}}
"""

    def rows(self, names: Names) -> list[ConstraintRow]:
        point, plane = names.point(self.point, "point"), names.plane(self.on, "on")
        if plane is None:
            known = [f"{b.name}.{name}" for b in names.bodies.values() for name in b.planes]
            names.problem(
                Message(
                    "{name} is no plane.{hint} A plane: ground: {{planes: {{floor: {{normal: up}}}}}}",
                    name=self.on,
                    hint=did_you_mean(self.on, known),
                ),
                "on",
            )
            return []
        if point.body == plane.normal.body:
            names.problem(Message("the point and the plane are both on {body}", body=point.body))
            return []
        return [ConstraintRow("contact", "normal force", Displacement(point, plane.through, plane.normal))]

    def glyphs(self, names: Names) -> Iterable[Glyph]:
        plane = names.plane(self.on)
        if plane is not None:
            yield glyphs.Face(plane.through, names.point(self.point), plane.normal, "freely")
