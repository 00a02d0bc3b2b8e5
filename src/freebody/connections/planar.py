"""Planar joint: a body moves in a plane and turns about its normal."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
from typing import TYPE_CHECKING, ClassVar, Literal

from freebody.connections.base import Connection
from freebody.connections.joints import AXES, Joint, own_direction, read_joint
from freebody.measures.angle import Angle
from freebody.measures.base import Measure
from freebody.measures.displacement import Displacement
from freebody.measures.geometry import GROUND, Point
from freebody.model import glyphs
from freebody.model.elements import Attitude, ConstraintRow
from freebody.model.glyphs import Glyph
from freebody.model.spec import Heading

if TYPE_CHECKING:
    from freebody.model.names import Names


class Planar(Connection, kind="planar"):
    """`planar: {body: plate}`: its reference point stays in the plane through `through` (the ground's origin) across
    the `normal` (z), about which it may turn (3 rows; 1 for a particle). Connections of the plane, such as pin, slider,
    string or contact, may join bodies that stay in the plane of x and y."""

    space_only = True
    with_copies: ClassVar[Literal["", "each", "together"]] = "each"

    body: str
    through: str = "ground.origin"
    normal: Heading = "z"
    second_axis: Heading | None = None

    example = """
space: true
bodies: {plate: {box: {mass: 1 kg, size: [1 m, 0.1 m, 0.2 m]}}}
connections: {it: {planar: {body: plate}}}
"""

    def _joint(self, names: Names) -> Joint | None:
        return read_joint(names, self, self.through, self.body, self.normal, self.second_axis, "normal")

    def keeps_flat(self, names: Names) -> bool:
        """Whether the body stays in the plane of x and y with its own axes x and y in it."""
        return self.normal == "z" and self.through.partition(".")[0] == GROUND and self.second_axis in (None, "z")

    def rows(self, names: Names) -> list[ConstraintRow]:
        point = names.point(self.body, "body")
        if not names.known(point.body).turns:
            origin, normal = names.point(self.through, "through"), names.direction(self.normal, "normal")
            return [ConstraintRow("plane", "normal force", Displacement(point, origin, normal))]
        joint = self._joint(names)
        if joint is None:
            return []
        return [ConstraintRow("plane", "normal force", joint.travel), *joint.parallel()]

    def attitude(self, names: Names) -> Attitude | None:
        point = names.point(self.body, "body")
        joint = self._joint(names) if names.space and names.known(point.body).turns else None
        if joint is None:
            return None
        found = joint.attitude(turns=True)
        if not self.keeps_flat(names):
            return found
        (axis, name, _angle), *_ = found.turns
        return replace(found, turns=((axis, name, Angle(joint.second.body)),))

    def offers(self, names: Names) -> Iterable[tuple[str, Measure]]:
        body = names.point(self.body, "body")
        if self.keeps_flat(names):
            origin = Point(GROUND, names.origin, "ground.origin")
            yield "x", Displacement(body, origin, AXES[0])
            yield "y", Displacement(body, origin, AXES[1])
            if names.known(body.body).turns:
                yield "angle", Angle(body.body)
            return
        joint = self._joint(names) if names.known(body.body).turns else None
        if joint is not None:
            yield "x", Displacement(joint.second, joint.first, joint.b)
            yield "y", Displacement(joint.second, joint.first, joint.c)
            yield "angle", joint.angle

    def glyphs(self, names: Names) -> Iterable[Glyph]:
        point, through = names.point(self.body), names.point(self.through)
        joint = self._joint(names) if names.known(point.body).turns else None
        normal = own_direction(names, self.normal, through.body) if joint is None else joint.axis
        yield glyphs.Face(through, point, normal, "freely" if joint is None else "about")
