"""Rolling without slip of a sphere on a surface z = f(x, y) in space: a ball in a bowl of revolution, over a saddle.

With the contact at r(x, y) of the surface and its unit normal n, a sphere of the radius R has its centre at

    r_C = r(x, y) + R n        (below: r(x, y) - R n),

on the parallel surface, and its material point at the contact has no velocity along two tangents b,

    (v_C - R omega x n) . b = 0.

It fits only where the principal curvatures on its side are less than 1/R. Source: Routh, Dynamics of a System of Rigid
Bodies, Advanced Part, ch. V; Neimark & Fufaev, Dynamics of Nonholonomic Systems, 1972, ch. III.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator
from typing import TYPE_CHECKING, ClassVar

from freebody.connections.base import Connection
from freebody.connections.curves import put_at
from freebody.connections.surfaces import drawn, polar, reach_of, surface_of
from freebody.errors import FreebodyError
from freebody.language.expression import evaluate, negate, number
from freebody.language.sentences import Message
from freebody.measures.base import Measure
from freebody.measures.geometry import GROUND
from freebody.model.elements import ConstraintRow
from freebody.model.glyphs import Glyph
from freebody.model.spec import Formula
from freebody.model.surfaces import SurfacePlace

if TYPE_CHECKING:
    from freebody.model.names import Names

_N_LOOKED_AT = 40  # places from the axis to the edge of what is drawn, along each of as many half lines


class RollingOnSurface(Connection, kind="rolling_on_surface"):
    """`rolling_on_surface: {body: ball, z: k*rho^2}`: a sphere rolls without slip on the surface z = f(x, y) of the
    ground (or of another body, `on`), counted from its reference point along its axes (3 rows). f is a formula in x, y,
    parameters and rho, the distance from the z axis, as of a `point_on_surface`. For an axis that points up write
    `space: {up: z}`. The sphere lies on the side of growing z; `below: true` puts it on the other one. `reach`: how far
    from the axis the surface is drawn. Where it touches, the measures `axis distance of bowl` and `azimuth of bowl`
    tell: with them as coordinates its steady motion round a bowl has a closed form. A sphere that is too large for it
    is refused with the radius that would do."""

    called: ClassVar[tuple[str, ...]] = ("bowl", "surface")

    body: str
    z: Formula
    on: str = GROUND
    below: bool = False
    reach: Formula | None = None

    space_only = True
    in_plane_take = "rolling_on_curve"
    has_contact_point = True
    example = """
space: {up: z}
parameters: {k: 1/5}
bodies: {ball: {sphere: {mass: 1 kg, radius: 0.1 m}, near: {at: [0.3 m, 0.2 m, 0.1 m]}}}
connections: {it: {rolling_on_surface: {body: ball, z: -k*x}}}
"""

    def foot(self, names: Names) -> SurfacePlace | None:
        """Where the sphere touches; None with a problem noted."""
        body, base = names.body(self.body, "body"), names.body(self.on, "on")
        if body.name == base.name:
            names.problem(Message("{body} cannot roll on itself", body=body.name), "on")
            return None
        if body.round != "sphere" or body.radius is None:
            told = Message("what rolls on a surface is a sphere: make {body} a sphere, e.g. sphere: {{mass: m, radius: "
                           "r}}", body=body.name)  # fmt: skip
            names.problem(told, "body")
            return None
        surface = surface_of(names, self.z, base)
        if surface is None:
            return None
        put = put_at(names, body.center) or (number(0), number(0))
        arm = negate(body.radius) if self.below else body.radius
        return SurfacePlace(self.own_name(names), surface, body.center, (*put[:2], arm))

    def rows(self, names: Names) -> list[ConstraintRow]:
        place = self.foot(names)
        if place is None:
            return []
        self._look_whether_it_fits(names, place)
        arm = place.near[2]
        gap = ConstraintRow("contact", "normal force", place.height, arm, sign=-1 if self.below else 1, unilateral=True)
        slips = [
            ConstraintRow(f"no slip {k}", f"friction force {k}", place.slip(arm, k), needs="contact") for k in (1, 2)
        ]
        return [gap, *slips]

    def _look_whether_it_fits(self, names: Names, place: SurfacePlace) -> None:
        """Compares its radius with the least radius of curvature on its side, where the surface is drawn."""
        radius = names.numeric(names.radius(self.body))
        bends = list(self._bends(names, place))
        tightest = 1.0 / max(bends) if bends and max(bends) > 0.0 else math.inf
        if radius is not None and radius >= tightest:
            told = Message(
                "{body} does not fit: its radius is {radius:.4g} m, and the surface has the radius of curvature "
                "{tightest:.4g} m. Take a smaller radius, a flatter surface, or a shorter reach",
                body=self.body,
                radius=radius,
                tightest=tightest,
            )
            names.problem(told, "body")

    def _bends(self, names: Names, place: SurfacePlace) -> Iterator[float]:
        """The greater of both principal curvatures [1/m] towards the sphere, at places as far as it is drawn."""
        mean, gauss = place.surface.curvatures
        far = names.numeric(reach_of(names, place.point, self.reach))
        if far is None:
            return
        values, side = names.numbers_in(place.surface.height), -1 if self.below else 1
        for j in range(1 if place.surface.is_round else _N_LOOKED_AT):
            angle = 2.0 * math.pi * j / _N_LOOKED_AT
            for k in range(_N_LOOKED_AT + 1):
                away = far * k / _N_LOOKED_AT
                at = {**values, "x": away * math.cos(angle), "y": away * math.sin(angle)}
                try:
                    h, g = float(evaluate(mean, at)), float(evaluate(gauss, at))
                except (ArithmeticError, ValueError, FreebodyError):  # at the tip of a cone
                    continue
                yield side * h + math.sqrt(max(h * h - g, 0.0))

    def offers(self, names: Names) -> Iterable[tuple[str, Measure]]:
        with names.quietly():
            place = self.foot(names)
        if place is not None:
            yield from polar(names, place.surface, place.point)

    def glyphs(self, names: Names) -> Iterable[Glyph]:
        place = self.foot(names)
        if place is not None:
            yield from drawn(names, place.surface, place.point, self.reach)
