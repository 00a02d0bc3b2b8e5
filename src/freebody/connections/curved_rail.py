"""Curved rail: a point on a curve y = f(x), as a bead on a bent wire.

With psi the slope of the curve, tan(psi) = f'(x), the distance from the curve to first order is (y - f(x)) cos(psi).
Held at zero, its gradient is the unit normal (-sin(psi), cos(psi)), so that its multiplier is the normal force. Source:
Beer, Johnston & Cornwell, Vector Mechanics for Engineers: Dynamics, ch. 12 and 13.
"""

from __future__ import annotations

from collections.abc import Iterable
from fractions import Fraction
from typing import TYPE_CHECKING, ClassVar

from freebody.connections.base import Connection
from freebody.language.expression import Call, Expr, Symbol, differentiate, number, substitute
from freebody.language.sentences import Message
from freebody.language.units import LENGTH
from freebody.measures.base import Measure
from freebody.measures.combination import Composed
from freebody.measures.displacement import Displacement
from freebody.measures.geometry import GROUND, Direction, Point
from freebody.model import glyphs
from freebody.model.elements import ConstraintRow
from freebody.model.glyphs import Glyph
from freebody.model.rotations import UNIT
from freebody.model.spec import Formula

if TYPE_CHECKING:
    from freebody.model.names import Names


_N_DRAWN = 48  # stretches of a drawn curve


class CurvedRail(Connection, kind="curved_rail"):
    """`curved_rail: {point: bead, y: a*x^2}`: a point stays on the curve y = f(x) of another body (`on`, default the
    ground), x and y from its reference point along its axes, without friction (1 row, in space 2). f is a formula in x
    and the parameters. The normal force is positive when it pushes to the left of the way of growing x, which is up
    where the curve is level. `leaves: true`: the point lies on the curve and is not held from above. `ends: [x1, x2]`:
    from where to where the curve is drawn."""

    called: ClassVar[tuple[str, ...]] = ("wire", "rail", "track", "curve", "chute")

    point: str
    y: Formula
    on: str = GROUND
    leaves: bool = False
    ends: list[Formula] | None = None

    example = """
bodies: {bead: {particle: {mass: 1 kg}, near: {at: [0.5 m, 0.3 m]}}}
parameters: {a: 1 1/m}
connections: {it: {curved_rail: {point: bead, y: a*x^2}}}
"""

    def _curve(self, names: Names) -> tuple[Expr, Point, Point] | None:
        """f, the point on the curve, and where x and y count from."""
        point, base = names.point(self.point, "point"), names.body(self.on, "on")
        if point.body == base.name:
            names.problem(Message("the point and the curve are both on {body}", body=point.body), "point")
            return None
        f = names.formula(self.y, LENGTH, "y", extra={"x": LENGTH})
        return f, point, base.center if base.name != GROUND else names.ground_origin

    def _axis(self, names: Names, key: str) -> Direction:
        return names.fixed_in(self.on, UNIT["xyz".index(key)][: len(names.origin)], key)

    def rows(self, names: Names) -> list[ConstraintRow]:
        found = self._curve(names)
        if found is None:
            return []
        f, point, origin = found
        slope = differentiate(f, "x")
        steep = Call("sqrt", number(1) + slope * slope)
        parts = tuple((key, Displacement(point, origin, self._axis(names, key))) for key in ("x", "y"))
        away = Composed((Symbol("y") - f) / steep, parts, LENGTH)
        rows = [ConstraintRow("rail", "normal force", away, unilateral=self.leaves)]
        if names.space:
            rows.append(ConstraintRow("side", "side force", Displacement(point, origin, self._axis(names, "z"))))
        return rows

    def offers(self, names: Names) -> Iterable[tuple[str, Measure]]:
        with names.quietly():
            found = self._curve(names)
        if found is not None:
            _f, point, origin = found
            yield "x", Displacement(point, origin, self._axis(names, "x"))

    def glyphs(self, names: Names) -> Iterable[Glyph]:
        found = self._curve(names)
        if found is None:
            return
        f, point, origin = found
        low, high = self._drawn_between(names)
        shares = [number(k) / number(_N_DRAWN) for k in range(_N_DRAWN + 1)]
        along = [low + (high - low) * share for share in shares]
        places = [(x, substitute(f, {"x": x}), *names.origin[2:]) for x in along]
        base = origin.offset
        yield glyphs.Relation(
            tuple(Point(origin.body, tuple(a + b for a, b in zip(base, at, strict=True))) for at in places)
        )
        yield glyphs.Equation(point, f"y = {self.y}")

    def _drawn_between(self, names: Names) -> tuple[Expr, Expr]:
        """From where to where it is drawn: what the model says, else about as far as the point is put."""
        if self.ends is not None and len(self.ends) == 2:
            first, second = (names.formula(end, LENGTH, "ends", k) for k, end in enumerate(self.ends))
            return first, second
        body = names.known(names.point(self.point).body)
        start = body.start.at or (body.start.near.at if body.start.near is not None else None)
        far = names.numeric(start[1][0]) if start is not None else None
        reach = number(Fraction(1.5 * abs(far)).limit_denominator(1000)) if far else number(1)
        return -reach, reach
