"""Curved rail: a point on a curve, as a bead on a bent wire.

With psi the slope of a curve y = f(x), tan(psi) = f'(x), the distance from the curve to first order is (y - f(x))
cos(psi). Held at zero, its gradient is the unit normal (-sin(psi), cos(psi)), so that its multiplier is the normal
force. On a curve x(s), y(s) the foot s is a coordinate of its own (`model.curves`). Dry friction resists along the
tangent with mu times the normal force, in which the curvature is: N = m (g cos(psi) + v^2/rho). Source: Beer, Johnston
& Cornwell, Vector Mechanics for Engineers: Dynamics, ch. 12 and 13.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING, Any

from freebody.connections.curves import AlongCurve
from freebody.language.expression import Call, Symbol, differentiate, divide, number
from freebody.language.sentences import Message
from freebody.language.units import DIMENSIONLESS, LENGTH
from freebody.measures.base import Measure
from freebody.measures.combination import Composed
from freebody.measures.displacement import Displacement
from freebody.measures.geometry import GROUND, Point
from freebody.model import glyphs
from freebody.model.curves import CurvePlace
from freebody.model.elements import ConstraintRow, DryFriction, NonholonomicForm, UnilateralConstraint
from freebody.model.friction import read_friction
from freebody.model.glyphs import Glyph
from freebody.model.spec import Formula

if TYPE_CHECKING:
    from freebody.model.names import Names


class CurvedRail(AlongCurve, kind="curved_rail"):
    """`curved_rail: {point: bead, y: a*x^2}`: a point stays on the curve y = f(x) of another body (`on`, default the
    ground), x and y from its reference point along its axes (1 row, in space 2). f is a formula in x and parameters.
    `curved_rail: {point: bead, x: R*(s + sin(s)), y: R*(1 - cos(s))}`: on a curve in a parameter s, an angle or a
    length, in the plane; `parameter of rail` is it as a measure. The normal force is positive when it pushes to the
    left of the way of growing x or s, which is up where a curve to the right is level. `leaves: true`: the point lies
    on the curve and is not held from above. `friction`: mu, or {static: 0.5, kinetic: 0.4}. `ends: [x1, x2]`: from
    where to where the curve is drawn."""

    point: str
    y: Formula
    x: Formula | None = None
    on: str = GROUND
    leaves: bool = False
    friction: Formula | dict[str, Any] = 0
    ends: list[Formula] | None = None

    example = """
bodies: {bead: {particle: {mass: 1 kg}, near: {at: [0.5 m, 0.3 m]}}}
parameters: {a: 1 1/m}
connections: {it: {curved_rail: {point: bead, y: a*x^2}}}
"""

    def moved_point(self, names: Names) -> Point:
        return names.point(self.point, "point")

    def _is_sound(self, names: Names) -> bool:
        point, base = self.moved_point(names), names.body(self.on, "on")
        if point.body == base.name:
            names.problem(Message("the point and the curve are both on {body}", body=point.body), "point")
            return False
        if self.x is not None and names.space:
            names.problem(Message("a curve in a parameter lies in the plane; in space give y as a formula in x"), "x")
            return False
        return True

    def curve_place(self, names: Names) -> CurvePlace | None:
        return super().curve_place(names) if self.x is not None and self._is_sound(names) else None

    def rows(self, names: Names) -> list[ConstraintRow]:
        if not self._is_sound(names):
            return []
        place = self.curve_place(names)
        away = self._away(names) if place is None else place.height
        rows = [ConstraintRow("rail", "normal force", away, unilateral=self.leaves)]
        if names.space:
            point, origin = self.moved_point(names), self.curve(names).origin
            rows.append(ConstraintRow("side", "side force", Displacement(point, origin, self.axis(names, "z"))))
        return rows

    def _away(self, names: Names) -> Measure:
        """(y - f(x)) cos(psi)"""
        f = names.formula(self.y, LENGTH, "y", extra={"x": LENGTH})
        slope = differentiate(f, "x")
        steep = Call("sqrt", number(1) + slope * slope)
        (_x, x), (y, above) = self.curve(names).place_of(self.moved_point(names))
        return Composed((Symbol(y) - f) / steep, (("x", x), (y, above)), LENGTH)

    def bounds(self, names: Names, connection: str) -> tuple[list[UnilateralConstraint], list[DryFriction]]:
        friction = read_friction(names, self.friction, DIMENSIONLESS)
        if friction.is_none or not self._is_sound(names):
            return [], []
        place, pressed = self.curve_place(names), f"{connection}.rail"
        slide = self._slide(names) if place is None else place.slide()
        row = ConstraintRow("friction", "friction force", slide, connection=connection)
        rub = DryFriction(row, friction.static, friction.kinetic, (pressed,), pressed if self.leaves else "")
        return [], [rub]

    def _slide(self, names: Names) -> NonholonomicForm:
        """The velocity along the curve, cos(psi) x' + sin(psi) y'."""
        slope = differentiate(names.formula(self.y, LENGTH, extra={"x": LENGTH}), "x")
        steep = Call("sqrt", number(1) + slope * slope)
        (_x, x), (_y, y) = self.curve(names).place_of(self.moved_point(names))
        along = [Composed(part, (("x", x),), DIMENSIONLESS) for part in (divide(number(1), steep), slope / steep)]
        return NonholonomicForm(((along[0], x), (along[1], y)), LENGTH)

    def offers(self, names: Names) -> Iterable[tuple[str, Measure]]:
        with names.quietly():
            if not self._is_sound(names):
                return
            place, point, origin = self.curve_place(names), self.moved_point(names), self.curve(names).origin
        if place is None:
            yield "x", Displacement(point, origin, self.axis(names, "x"))
        else:
            yield "s", place.parameter

    def glyphs(self, names: Names) -> Iterable[Glyph]:
        if self._is_sound(names):
            yield from self.drawn(names)
            if self.x is None:
                yield glyphs.Equation(self.moved_point(names), f"y = {self.y}")
