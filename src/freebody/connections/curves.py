"""Curves as connections state them: y = f(x), x and y in a parameter s, or through points; what is drawn of them."""

from __future__ import annotations

import math
from collections.abc import Iterable
from fractions import Fraction
from typing import TYPE_CHECKING, ClassVar

from freebody.connections.base import Connection
from freebody.connections.curve_points import curve_through
from freebody.errors import ExpressionError, FreebodyError, UnitError
from freebody.language.expression import Expr, Symbol, evaluate, number, substitute
from freebody.language.parser import parse
from freebody.language.sentences import Message
from freebody.language.units import DIMENSIONLESS, LENGTH, Dimension, dimension_of
from freebody.measures.base import Measure
from freebody.measures.geometry import GROUND, Direction, Point
from freebody.model import glyphs
from freebody.model.curves import PARAMETER, Curve, CurvePlace, LevelPlace
from freebody.model.glyphs import Glyph
from freebody.model.rotations import UNIT
from freebody.model.spec import Formula
from freebody.tolerances import ROUNDED

if TYPE_CHECKING:
    from freebody.model.names import Names

N_DRAWN = 72  # stretches of a drawn curve
N_LOOKED_AT = 400  # places at which a curve is looked at


class AlongCurve(Connection):
    """What a connection on a curve states of it: `on` which body it is; `ends`, between which it is drawn."""

    called: ClassVar[tuple[str, ...]] = ("wire", "rail", "track", "curve", "chute")

    on: str = GROUND
    ends: list[Formula] | None = None

    def curve(self, names: Names) -> Curve:
        """The curve in s; s is x where y is given in x."""
        raise NotImplementedError

    def y_in_x(self, names: Names) -> Expr | None:
        """y in the symbol x, where the curve is given so."""
        return None

    @property
    def is_in_x(self) -> bool:
        """Whether y is given in x."""
        return False

    def told_range(self, names: Names) -> tuple[Expr, Expr] | None:
        """From where to where the curve is told, where that is all."""
        return None

    def placed(self, names: Names) -> tuple[Point, tuple[Direction, Direction]]:
        """The point from which a curve is counted, and its axes."""
        base = names.body(self.on, "on")
        origin = base.center if base.name != GROUND else names.ground_origin
        return origin, (self.axis(names, "x"), self.axis(names, "y"))

    def moved_point(self, names: Names) -> Point:
        """What is on the curve, or rolls on it."""
        raise NotImplementedError

    def height(self, names: Names) -> Expr:
        """How far to the left of the curve the point is kept."""
        return number(0)

    def axis(self, names: Names, key: str) -> Direction:
        return names.fixed_in(self.on, UNIT["xyz".index(key)][: len(names.origin)], key)

    def curve_place(self, names: Names) -> CurvePlace | None:
        point, curve = self.moved_point(names), self.curve(names)
        h = self.height(names)
        return CurvePlace(self.own_name(names), curve, point, (self._nearest(names, curve, point), h))

    def _nearest(self, names: Names, curve: Curve, point: Point) -> Expr:
        """A guess for s: where the curve comes nearest to where the point is put."""
        put = put_at(names, point)
        if self.is_in_x:
            return put[0] if put is not None else number(0)
        place = None if put is None else [names.numeric(c) for c in put[:2]]
        ends = [names.numeric(end) for end in self._ends(names, curve)]
        if place is None or None in (*place, *ends):
            return number(0)
        best = min(self._looked_at(names, curve), key=lambda at: math.dist(place, at[1:3]), default=None)  # pyrefly: ignore[bad-argument-type]
        return number(0) if best is None else number(Fraction(best[0]).limit_denominator(10**6))

    def _looked_at(self, names: Names, curve: Curve) -> list[tuple[float, float, float, float]]:
        """(s, x, y, curvature) along the curve; nothing while parameters have no values."""
        values = names.numbers_in(curve.x, curve.y, curve.curvature)
        low, high = (names.numeric(end) for end in self._ends(names, curve))
        if low is None or high is None:
            return []
        found: list[tuple[float, float, float, float]] = []
        for k in range(N_LOOKED_AT + 1):
            s = low + (high - low) * k / N_LOOKED_AT
            try:
                x, y, bend = (evaluate(e, {**values, PARAMETER: s}) for e in (curve.x, curve.y, curve.curvature))
            except (ArithmeticError, ValueError, FreebodyError):  # at a cusp, or beyond the range of a root
                continue
            found.append((s, float(x), float(y), float(bend)))
        return found

    def tightest(self, names: Names, curve: Curve, *, side: int) -> float | None:
        """The least radius of curvature [m] where the curve is drawn, on the side to which a normal points."""
        bends = [side * bend for _s, _x, _y, bend in self._looked_at(names, curve)]
        return 1.0 / max(bends) if bends and max(bends) > 0.0 else None

    def level_places(self, names: Names) -> tuple[LevelPlace, ...]:
        """At 0, and halfway round a closed curve: so far as the numbers of the model say that it is level there, and
        nowhere as low, or as high."""
        curve = self.curve(names)
        values = names.numbers_in(curve.x, curve.y)

        def at(s: float, e: Expr) -> float:
            return float(evaluate(e, {**values, PARAMETER: s}))

        places = self._looked_at(names, curve)
        found: list[LevelPlace] = []
        try:
            is_closed = curve.dimension == DIMENSIONLESS and math.isclose(
                at(0.0, curve.x), at(2.0 * math.pi, curve.x), abs_tol=ROUNDED
            )
            for half_turns in (0, 1) if is_closed else (0,):
                s = half_turns * math.pi
                y, is_level = at(s, curve.y), abs(at(s, curve.slopes[1])) <= ROUNDED
                far = [place[2] for place in places if abs(math.remainder(place[0] - s, 2.0 * math.pi)) > ROUNDED]
                far = far if is_closed else [place[2] for place in places if abs(place[0]) > ROUNDED]
                if is_level and far and (y < min(far) or y > max(far)):
                    found.append(LevelPlace(self._measured(names, curve), half_turns, y < min(far), is_closed))
        except (ArithmeticError, ValueError, FreebodyError):
            return ()
        return tuple(found)

    def _measured(self, names: Names, curve: Curve) -> Measure:
        """What is measured along the curve: its parameter, or x where y is given in x."""
        place = self.curve_place(names)
        (_x, along), _y = curve.place_of(self.moved_point(names))
        return along if place is None else place.parameter

    # -- what is drawn ------------------------------------------------------------------------
    def drawn(self, names: Names) -> Iterable[Glyph]:
        """The curve, and its formula where y is given in x."""
        curve = self.curve(names)
        low, high = self._ends(names, curve)
        base = curve.origin.offset

        def at(s: Expr) -> Point:
            place = (substitute(curve.x, {PARAMETER: s}), substitute(curve.y, {PARAMETER: s}), *names.origin[2:])
            return Point(curve.origin.body, tuple(a + b for a, b in zip(base, place, strict=True)))

        shares = [number(k) / number(N_DRAWN) for k in range(N_DRAWN + 1)]
        yield glyphs.Relation(tuple(at(low + (high - low) * share) for share in shares))

    def _ends(self, names: Names, curve: Curve) -> tuple[Expr, Expr]:
        """From where to where it is drawn: what the model says, else about as far as the point is put, and half a turn
        either way in an angle."""
        if self.ends is not None:
            if len(self.ends) == 2:
                first, second = (names.formula(e, curve.dimension, "ends", k) for k, e in enumerate(self.ends))
                return first, second
            names.problem(Message("ends are two, from where to where the curve is drawn: ends: [-1 m, 1 m]"), "ends")
        if (told := self.told_range(names)) is not None:
            return told
        if curve.dimension == DIMENSIONLESS:
            return -Symbol("pi"), Symbol("pi")
        put = put_at(names, self.moved_point(names))
        far = None if put is None else names.numeric(put[0])
        reach = number(Fraction(1.5 * abs(far)).limit_denominator(1000)) if far else number(1)
        return -reach, reach


class WrittenCurve(AlongCurve):
    """A curve that is written: `y` in x, `x` and `y` in s, or `points` that it goes `through`."""

    y: Formula | None = None
    x: Formula | None = None
    points: list[list[Formula]] | str | None = None
    through: str = "cubic"

    @property
    def is_in_x(self) -> bool:
        return self.x is None

    def is_written(self, names: Names) -> bool:
        """Whether the curve is said in one way; else with a problem noted."""
        if (self.y is None) == (self.points is None) or (self.x is not None and self.y is None):
            told = Message("say what the curve is: y: a formula in x; x and y: formulas in s; or points: [[0, 0], ...]")
            names.problem(told)
            return False
        return True

    def y_in_x(self, names: Names) -> Expr | None:
        if not self.is_in_x or (self.y is None and self.points is None):
            return None
        if self.points is None:
            return names.formula(self.y, LENGTH, "y", extra={"x": LENGTH})
        found = curve_through(names, self.points, self.through)
        return number(0) if found is None else found[0]

    def told_range(self, names: Names) -> tuple[Expr, Expr] | None:
        with names.quietly():
            found = None if self.points is None else curve_through(names, self.points, self.through)
        return None if found is None else (number(found[1][0]), number(found[1][1]))

    def curve(self, names: Names) -> Curve:
        origin, axes = self.placed(names)
        if self.is_in_x:
            y = self.y_in_x(names) or number(0)
            return Curve(Symbol(PARAMETER), substitute(y, {"x": Symbol(PARAMETER)}), LENGTH, origin, axes)
        dimension = self._dimension(names)
        x, y = (names.formula(getattr(self, k), LENGTH, k, extra={"s": dimension}) for k in ("x", "y"))
        s = {"s": Symbol(PARAMETER)}
        return Curve(substitute(x, s), substitute(y, s), dimension, origin, axes)

    def _dimension(self, names: Names) -> Dimension:
        """Of the parameter: an angle or a number, or a length."""
        try:
            found = dimension_of(parse(str(self.x)), {**names.dimensions(), "s": DIMENSIONLESS})
        except (ExpressionError, UnitError):
            return LENGTH
        return DIMENSIONLESS if found == LENGTH else LENGTH


def put_at(names: Names, point: Point) -> tuple[Expr, ...] | None:
    """Where the body of a point is put, or is said to be near."""
    start = names.known(point.body).start
    at = start.at or (None if start.near is None else start.near.at)
    return None if at is None else at[1]
