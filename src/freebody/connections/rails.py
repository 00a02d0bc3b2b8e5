"""Rails: a point stays on a curve of any kind, or lies on it; dry friction along it.

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
from freebody.measures.geometry import Point
from freebody.model.curves import CurvePlace
from freebody.model.elements import ConstraintRow, DryFriction, NonholonomicForm, UnilateralConstraint
from freebody.model.friction import read_friction
from freebody.model.glyphs import Glyph
from freebody.model.spec import Formula

if TYPE_CHECKING:
    from freebody.model.names import Names


class Rail(AlongCurve):
    """`point` stays on a curve; `leaves`: it is not held from above; `friction`."""

    point: str
    leaves: bool = False
    friction: Formula | dict[str, Any] = 0

    def moved_point(self, names: Names) -> Point:
        return names.point(self.point, "point")

    def _is_sound(self, names: Names) -> bool:
        point, base = self.moved_point(names), names.body(self.on, "on")
        if point.body == base.name:
            names.problem(Message("the point and the curve are both on {body}", body=point.body), "point")
            return False
        return True

    def curve_place(self, names: Names) -> CurvePlace | None:
        return super().curve_place(names) if self._is_sound(names) and not self.is_in_x else None

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
        f = self.y_in_x(names) or number(0)
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
        slope = differentiate(self.y_in_x(names) or number(0), "x")
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
