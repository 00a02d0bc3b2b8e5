"""Constant-velocity joint: two points coincide, both shafts turn equally fast whatever the angle between them.

With the shafts along a and a' and b, c and b', c' across them, the joint is at zero where the bodies stand parallel. It
turns the second body by a rotation without torsion, about an axis across both shafts: the matrix between the bodies is
then symmetric in b and c, b . c' = c . b'. Its rate vanishes where both have the same angular velocity in the plane
that halves the angle between them (the homokinetic plane). Source: Seherr-Thoss, Schmelz & Aucktor, Universal Joints
and Driveshafts, 2nd ed. 2006, sec. 1.5.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING

from freebody.connections.base import Connection
from freebody.connections.joints import read_joint
from freebody.language.expression import Symbol
from freebody.language.units import DIMENSIONLESS
from freebody.measures.combination import Composed
from freebody.measures.turn import Alignment
from freebody.model import glyphs
from freebody.model.elements import ConstraintRow
from freebody.model.glyphs import Glyph
from freebody.model.spec import Heading

if TYPE_CHECKING:
    from freebody.model.names import Names


class ConstantVelocity(Connection, kind="constant_velocity"):
    """`constant_velocity: {first: drive.end, second: wheel.hub, about: z}`: the shafts meet in a point and turn equally
    fast (4 rows)."""

    space_only = True
    in_plane_take = "pin"

    meeting = ("first", "second")

    first: str
    second: str
    about: Heading
    second_axis: Heading | None = None

    example = """
space: true
bodies: {shaft: {cylinder: {mass: 1 kg, radius: 0.1 m, length: 1 m}}}
connections: {it: {constant_velocity: {first: ground.A, second: shaft.start, about: z}}}
"""

    def rows(self, names: Names) -> list[ConstraintRow]:
        joint = read_joint(names, self, self.first, self.second, self.about, self.second_axis)
        if joint is None:
            return []
        terms = (("p", Alignment(joint.c2, joint.b)), ("q", Alignment(joint.b2, joint.c)))
        equal = Composed(Symbol("p") - Symbol("q"), terms, DIMENSIONLESS)
        return [*joint.meeting(), ConstraintRow("equal speed", "moment", equal)]

    def glyphs(self, names: Names) -> Iterable[Glyph]:
        yield glyphs.Ball(names.point(self.first), names.point(self.second), passes_turn=True)
