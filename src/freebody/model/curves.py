"""Curves of a body, r = (X(s), Y(s)), and where a point is beside one.

With the unit tangent t = r'/|r'| and the normal n, a quarter turn counter-clockwise from it, a point has the foot s and
the height h:

    r_P = r(s) + h n(s)

singular only where h times the curvature is 1, at the centre of curvature. s and h are coordinates of their own, of
something without mass that transmits nothing: what acts on the point is told by the gradient of (r_P - r(s)) . n(s),
which is n, since its derivative by s is -|r'| (r_P - r) . t/rho + ... = 0 at the foot. Source: do Carmo, Differential
Geometry of Curves and Surfaces, sec. 1-5; Glocker, Set-Valued Force Laws, 2001, ch. 4 (contact kinematics).
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

from freebody.language.expression import Call, Expr, Symbol, differentiate, divide, negate
from freebody.language.units import DIMENSIONLESS, LENGTH, Dimension
from freebody.measures.base import Measure
from freebody.measures.combination import Composed
from freebody.measures.displacement import Displacement
from freebody.measures.geometry import AXES, GROUND, RIGHT, UP, ZERO, Components, Direction, Point
from freebody.model.elements import ConstraintRow, NonholonomicForm, RigidBody, Start

PARAMETER = "@s"  # as all names in a statement: no user can type it, so that no parameter is called so
_X, _Y, _H = "@x", "@y", "@h"
FOOT = "⌒"  # no user can type a name that begins so


@dataclass(frozen=True)
class Curve:
    """x and y in the parameter s, from a point of a body along its axes. dimension: of s."""

    x: Expr
    y: Expr
    dimension: Dimension
    origin: Point
    axes: tuple[Direction, Direction]

    @cached_property
    def slopes(self) -> tuple[Expr, Expr]:
        """dx/ds and dy/ds."""
        return differentiate(self.x, PARAMETER), differentiate(self.y, PARAMETER)

    @cached_property
    def stretch(self) -> Expr:
        """|dr/ds|"""
        dx, dy = self.slopes
        return Call("sqrt", dx * dx + dy * dy)

    @cached_property
    def tangent(self) -> tuple[Expr, Expr]:
        """In the sense of growing s."""
        dx, dy = self.slopes
        return divide(dx, self.stretch), divide(dy, self.stretch)

    @cached_property
    def normal(self) -> tuple[Expr, Expr]:
        """To the left of the tangent."""
        tx, ty = self.tangent
        return negate(ty), tx

    @cached_property
    def curvature(self) -> Expr:
        """Positive where the curve bends to the left."""
        dx, dy = self.slopes
        return divide(dx * differentiate(dy, PARAMETER) - dy * differentiate(dx, PARAMETER), self.stretch**3)

    def place_of(self, point: Point) -> tuple[tuple[str, Measure], tuple[str, Measure]]:
        """x and y of a point, as the curve counts them."""
        x, y = (Displacement(point, self.origin, axis) for axis in self.axes)
        return (_X, x), (_Y, y)


@dataclass(frozen=True)
class LevelPlace:
    """Where a curve is lowest, or highest: what is measured along it is pi times half_turns there, and again after each
    turn of a closed curve (recurs)."""

    measure: Measure
    half_turns: int
    is_lowest: bool
    recurs: bool


@dataclass(frozen=True)
class CurvePlace:
    """Where a point is beside a curve, of one connection. near: guesses for s and h."""

    connection: str
    curve: Curve
    point: Point
    near: tuple[Expr, Expr]

    @property
    def carrier(self) -> str:
        """The name of what has s and h for coordinates."""
        return f"{FOOT}{self.connection}"

    @cached_property
    def parameter(self) -> Measure:
        """s of the foot."""
        return Composed(Symbol(PARAMETER), ((PARAMETER, self._along(RIGHT)),), self.curve.dimension)

    @cached_property
    def height(self) -> Measure:
        """(r_P - r(s)) . n(s), whose multiplier is the normal force."""
        (nx, ny), x, y = self.curve.normal, Symbol(_X) - self.curve.x, Symbol(_Y) - self.curve.y
        return self._composed(x * nx + y * ny)

    def slide(self, *more: tuple[Measure, Measure]) -> NonholonomicForm:
        """The velocity along the tangent, and what comes to it, by coefficient and measure."""
        (_x, x), (_y, y) = self.curve.place_of(self.point)
        tx, ty = (Composed(part, ((PARAMETER, self._along(RIGHT)),), DIMENSIONLESS) for part in self.curve.tangent)
        return NonholonomicForm(((tx, x), (ty, y), *more), LENGTH)

    def body(self) -> RigidBody:
        """What carries s and h: nothing that has mass."""
        start = Start(near=Start(at=("center", (*self.near, *self._zero[2:]))))
        points = {"center": self._zero, "mass_center": self._zero}
        return RigidBody(self.carrier, ZERO, ZERO, points, "center", turns=False, tensor=(ZERO,) * 6, start=start)

    def rows(self) -> list[ConstraintRow]:
        """What s and h are; nothing is transmitted."""
        (nx, ny), h = self.curve.normal, Symbol(_H)
        x = self._composed(Symbol(_X) - (self.curve.x + h * nx))
        y = self._composed(Symbol(_Y) - (self.curve.y + h * ny))
        more = [("z", self._along(axis)) for axis in AXES[2 : len(self._zero)]]  # in space: it stays in a plane
        return [ConstraintRow(n, "", m, connection=self.carrier) for n, m in (("x", x), ("y", y), *more)]

    @property
    def _zero(self) -> Components:
        return tuple(ZERO for _each in self.curve.origin.offset)

    def _along(self, axis: Direction) -> Displacement:
        return Displacement(Point(self.carrier, self._zero), Point(GROUND, self._zero), axis)

    def _composed(self, expression: Expr) -> Composed:
        own = (PARAMETER, self._along(RIGHT)), (_H, self._along(UP))
        return Composed(expression, (*self.curve.place_of(self.point), *own), LENGTH)


def is_foot(name: str) -> bool:
    """Whether it is the name of what carries the coordinates of a place beside a curve."""
    return name.startswith(FOOT)
