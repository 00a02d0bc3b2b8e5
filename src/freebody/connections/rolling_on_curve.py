"""Rolling without slip of a circle on a curve: a disk in a parabolic bowl, a wheel over a hump.

With the contact at s of the curve, its tangent t and normal n to the left, a circle of the radius r has its centre at

    r_C = r(s) + r n        (below: r(s) - r n),

on the parallel curve, whose radius of curvature is rho - r. Rolling says v_C . t + r omega = 0: in s alone |r'(s)| (1 -
r/rho) ds/dt + r omega = 0. The circle fits only where r < rho on its side. Source: Beer, Johnston & Cornwell, Vector
Mechanics for Engineers: Dynamics, ch. 15; do Carmo, Differential Geometry of Curves and Surfaces, sec. 1-5.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING

from freebody.connections.curves import WrittenCurve
from freebody.language.expression import Expr, negate
from freebody.language.sentences import Message
from freebody.language.units import LENGTH
from freebody.measures.angle import Angle
from freebody.measures.base import Measure
from freebody.measures.combination import Composed
from freebody.measures.geometry import Point
from freebody.model.curves import CurvePlace
from freebody.model.elements import ConstraintRow
from freebody.model.glyphs import Glyph

if TYPE_CHECKING:
    from freebody.model.names import Names


class RollingOnCurve(WrittenCurve, kind="rolling_on_curve"):
    """`rolling_on_curve: {body: ball, y: a*x^2}`: a round body rolls without slip on the curve y = f(x) of the ground
    (or of another body, `on`), on one in a parameter s, `x: ..., y: ...`, or through `points` as a `curved_rail`;
    `parameter of contact` is where on it they touch (2 rows). It lies on the left of the way of growing x or s, which
    is above a curve to the right; `below: true` puts it on the other side. `ends: [x1, x2]`: from where to where the
    curve is drawn. A circle that is too large for a curve is refused with the radius that would do."""

    body: str
    below: bool = False

    in_plane = True
    has_contact_point = True
    example = """
bodies: {ball: {sphere: {mass: 1 kg, radius: 0.1 m}, near: {at: [0.4 m, 0.2 m]}}}
parameters: {a: 0.5 1/m}
connections: {it: {rolling_on_curve: {body: ball, y: a*x^2}}}
"""

    def moved_point(self, names: Names) -> Point:
        return names.body(self.body, "body").center

    def height(self, names: Names) -> Expr:
        radius = names.radius(self.body, "body")
        return negate(radius) if self.below else radius

    def _is_sound(self, names: Names) -> bool:
        body = names.body(self.body, "body")
        if body.name == self.on:
            names.problem(Message("{body} cannot roll on itself", body=body.name), "on")
            return False
        if names.space:
            names.problem(Message("rolling on a curve is for models of the plane"))
            return False
        names.radius(body.name, "body")
        return self.is_written(names) and body.radius is not None

    def curve_place(self, names: Names) -> CurvePlace | None:
        return super().curve_place(names) if self._is_sound(names) else None

    def rows(self, names: Names) -> list[ConstraintRow]:
        place = self.curve_place(names)
        if place is None:
            return []
        self._look_whether_it_fits(names, place)
        arm, turned = self.height(names), Angle(self.body, place.curve.axes[0].body)
        slip = place.slide((Composed(arm, (("@turned", turned),), LENGTH), turned))
        sign = -1 if self.below else 1
        return [
            ConstraintRow("contact", "normal force", place.height, arm, sign=sign, unilateral=True),
            ConstraintRow("no slip", "friction force", slip, needs="contact"),
        ]

    def _look_whether_it_fits(self, names: Names, place: CurvePlace) -> None:
        radius = names.numeric(names.radius(self.body))
        tightest = self.tightest(names, place.curve, side=-1 if self.below else 1)
        if radius is not None and tightest is not None and radius >= tightest:
            told = Message(
                "{body} does not fit: its radius is {radius:.4g} m, and the curve has the radius of curvature "
                "{tightest:.4g} m. Take a smaller radius, a flatter curve, or shorter ends",
                body=self.body,
                radius=radius,
                tightest=tightest,
            )
            names.problem(told, "body")

    def offers(self, names: Names) -> Iterable[tuple[str, Measure]]:
        with names.quietly():
            place = self.curve_place(names)
        if place is not None:
            yield "s", place.parameter

    def glyphs(self, names: Names) -> Iterable[Glyph]:
        if self._is_sound(names):
            yield from self.drawn(names)
