"""Point on a surface z = f(x, y), as a bowl of revolution z = f(rho): it stays there, or lies on it; dry friction.

With w the steepness of `model.surfaces`, the distance from the surface to first order is (z - f)/w. Held at zero, its
gradient is the unit normal, so that its multiplier is the normal force. Friction acts in the tangent plane, against the
slip along the two tangents. rho = sqrt(x^2 + y^2) stands in even powers without a root, so that a bowl that is smooth
on its axis has no exception there. Source: Landau & Lifshitz, Mechanics, sec. 14; Goldstein, Poole & Safko, Classical
Mechanics, 3rd ed., ch. 1 and 3.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING, Any

from freebody.connections.base import Connection
from freebody.connections.surfaces import drawn, polar, surface_of
from freebody.language.sentences import Message
from freebody.language.units import DIMENSIONLESS, LENGTH
from freebody.measures.base import Measure
from freebody.measures.combination import Composed
from freebody.measures.geometry import GROUND
from freebody.model.elements import ConstraintRow, DryFriction, NonholonomicForm, UnilateralConstraint
from freebody.model.friction import read_friction
from freebody.model.glyphs import Glyph
from freebody.model.spec import Formula
from freebody.model.surfaces import HEIGHT, Surface

if TYPE_CHECKING:
    from freebody.model.names import Names


class PointOnSurface(Connection, kind="point_on_surface"):
    """`point_on_surface: {point: bead, z: k*rho^2}`: a point stays on the surface z = f(x, y) of another body (`on`,
    default the ground), counted from its reference point along its axes (1 row). f is a formula in x, y, parameters and
    rho, the distance from the z axis, rho^2 = x^2 + y^2: `k*rho^2` is a paraboloid of revolution, `rho/tan(alpha)` a
    cone, `-k*rho^2` a dome. For an axis that points up write `space: {up: z}`. The normal force is positive when it
    pushes to the side of growing z. `leaves: true`: the point lies on the surface and is not held from above.
    `friction`: mu, or {static: 0.5, kinetic: 0.4}. `reach`: how far from the axis the surface is drawn. The measures
    `distance of bead from the z axis` and `angle of line from ground.O to bead` make polar coordinates."""

    point: str
    z: Formula
    on: str = GROUND
    leaves: bool = False
    friction: Formula | dict[str, Any] = 0
    reach: Formula | None = None

    space_only = True
    in_plane_take = "curved_rail"
    example = """
space: {up: z}
parameters: {k: 1 1/m}
bodies: {bead: {particle: {mass: 1 kg}, near: {at: [0.3 m, 0.4 m, 0.25 m]}}}
connections: {it: {point_on_surface: {point: bead, z: k*rho^2}}}
"""

    def surface(self, names: Names) -> Surface | None:
        """None with a problem noted."""
        point, base = names.point(self.point, "point"), names.body(self.on, "on")
        if point.body == base.name:
            names.problem(Message("the point and the surface are both on {body}", body=point.body), "point")
            return None
        return surface_of(names, self.z, base)

    def rows(self, names: Names) -> list[ConstraintRow]:
        surface = self.surface(names)
        if surface is None:
            return []
        place = surface.place_of(names.point(self.point))
        above = Composed((HEIGHT - surface.height) / surface.steepness, place, LENGTH)
        return [ConstraintRow("surface", "normal force", above, unilateral=self.leaves)]

    def bounds(self, names: Names, connection: str) -> tuple[list[UnilateralConstraint], list[DryFriction]]:
        friction = read_friction(names, self.friction, DIMENSIONLESS)
        surface = None if friction.is_none else self.surface(names)
        if surface is None:
            return [], []
        pressed, place = f"{connection}.surface", surface.place_of(names.point(self.point))
        rows = [
            ConstraintRow(
                f"slip {k}",
                f"friction force {k}",
                NonholonomicForm(
                    tuple((Composed(c, place[:2], DIMENSIONLESS), move[1]) for c, move in zip(b, place, strict=True)),
                    LENGTH,
                ),
                connection=connection,
            )
            for k, b in enumerate(surface.tangents, 1)
        ]
        of = pressed if self.leaves else ""
        return [], [DryFriction(rows[0], friction.static, friction.kinetic, (pressed,), of, across=rows[1])]

    def offers(self, names: Names) -> Iterable[tuple[str, Measure]]:
        with names.quietly():
            surface = self.surface(names)
        if surface is not None:
            yield from polar(names, surface, names.point(self.point))

    def glyphs(self, names: Names) -> Iterable[Glyph]:
        surface = self.surface(names)
        if surface is not None:
            yield from drawn(names, surface, names.point(self.point), self.reach)
