"""Surfaces of a body, z = f(x, y).

With f_x and f_y the slopes and w^2 = 1 + f_x^2 + f_y^2 the unit normal is n = (-f_x, -f_y, 1)/w; the surface has the
tangents b_1 = (1, 0, f_x)/sqrt(1 + f_x^2) and b_2 = n x b_1. Its normal curvatures lie between the two principal ones,

    kappa = H +- sqrt(H^2 - K),   K = (f_xx f_yy - f_xy^2)/w^4,
    2 H = ((1 + f_x^2) f_yy - 2 f_x f_y f_xy + (1 + f_y^2) f_xx)/w^3,

positive where it bends to n. A point beside it has the foot (x, y) and the height h, r_P = r(x, y) + h n(x, y), which
are coordinates of their own as those beside a curve are. Source: do Carmo, Differential Geometry of Curves and
Surfaces, sec. 2-4, 3-3 and 3-5.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

from freebody.language.expression import ONE, ZERO, Call, Expr, Symbol, differentiate, divide
from freebody.language.units import DIMENSIONLESS, LENGTH
from freebody.measures.base import Measure
from freebody.measures.combination import Composed
from freebody.measures.displacement import Displacement
from freebody.measures.distance import Bearing
from freebody.measures.geometry import AXES, GROUND, Components, Direction, Point
from freebody.model.curves import FOOT
from freebody.model.elements import ConstraintRow, NonholonomicForm, RigidBody, Start
from freebody.model.rotations import vector_product
from freebody.model.spins import Terms, spin_terms

Axes = tuple[Direction, Direction, Direction]
HEIGHT = Symbol("@z")  # of a point, in formulas with x and y
_PLACE = (Symbol("@px"), Symbol("@py"), Symbol("@pz"))  # of a point beside a surface
_H, _BY = "@h", "@by"
SQUARE = Symbol("x") * Symbol("x") + Symbol("y") * Symbol("y")


@dataclass(frozen=True)
class Surface:
    """z = height in x and y, from a point of a body along its axes. is_round: in rho = sqrt(x^2 + y^2) alone."""

    height: Expr
    is_round: bool
    origin: Point
    axes: Axes

    @cached_property
    def slopes(self) -> tuple[Expr, Expr]:
        """df/dx and df/dy."""
        return differentiate(self.height, "x"), differentiate(self.height, "y")

    @cached_property
    def steepness(self) -> Expr:
        """sqrt(1 + f_x^2 + f_y^2), one over the cosine of the slope."""
        fx, fy = self.slopes
        return Call("sqrt", ONE + fx * fx + fy * fy)

    @cached_property
    def normal(self) -> Components:
        fx, fy = self.slopes
        return divide(-fx, self.steepness), divide(-fy, self.steepness), divide(ONE, self.steepness)

    @cached_property
    def tangents(self) -> tuple[Components, Components]:
        """b_1 in the plane of x and z, b_2 = n x b_1."""
        fx = self.slopes[0]
        along = Call("sqrt", ONE + fx * fx)
        first = divide(ONE, along), ZERO, divide(fx, along)
        return first, vector_product(self.normal, first)

    @cached_property
    def curvatures(self) -> tuple[Expr, Expr]:
        """H and K."""
        (fx, fy), w = self.slopes, self.steepness
        fxx, fxy, fyy = differentiate(fx, "x"), differentiate(fx, "y"), differentiate(fy, "y")
        mean = divide((ONE + fx * fx) * fyy - 2 * fx * fy * fxy + (ONE + fy * fy) * fxx, 2 * w**3)
        return mean, divide(fxx * fyy - fxy * fxy, w**4)

    def place_of(self, point: Point) -> tuple[tuple[str, Measure], ...]:
        """x, y and z of a point, as the surface counts them."""
        return tuple(
            (name, Displacement(point, self.origin, axis))
            for name, axis in zip(("x", "y", HEIGHT.name), self.axes, strict=True)
        )


@dataclass(frozen=True)
class SurfacePlace:
    """Where a point is beside a surface, of one connection. near: guesses for x, y and h of its foot."""

    connection: str
    surface: Surface
    point: Point
    near: Components

    @property
    def carrier(self) -> str:
        """The name of what has x, y and h of the foot for coordinates."""
        return f"{FOOT}{self.connection}"

    @property
    def height(self) -> Measure:
        """(r_P - r(x, y)) . n(x, y), whose multiplier is the normal force."""
        apart = (p - c for p, c in zip(_PLACE, self._foot, strict=True))
        found = sum((d * n for d, n in zip(apart, self.surface.normal, strict=True)), start=ZERO)
        return Composed(found, (*self._put, *self._own), LENGTH)

    def slip(self, radius: Expr, k: int) -> NonholonomicForm:
        """The velocity of the material point at -R n from the centre along the tangent b_k, seen from the surface:
        v . b + omega . (-R n x b), with n x b_1 = b_2 and n x b_2 = -b_1."""
        along, other = self.surface.tangents[k - 1], self.surface.tangents[2 - k]
        arm = -radius if k == 1 else radius
        terms: Terms = [(self._share(c), move) for c, (_name, move) in zip(along, self._put, strict=True)]
        for c, axis in zip(other, self.surface.axes, strict=True):
            turning = spin_terms(self.point.body, axis, axis.body)
            terms += [(self._share(arm * c, by), rate) for by, rate in turning]
        return NonholonomicForm(tuple(terms), LENGTH)

    @property
    def polar(self) -> tuple[Measure, Measure]:
        """rho and phi of the foot: how far from the axis of the surface it is, and at which angle round that."""
        middle, foot = (Point(body, (ZERO,) * 3) for body in (GROUND, self.carrier))
        away = Composed(Call("sqrt", SQUARE), self._own[:2], LENGTH)
        return away, Bearing(middle, foot)

    def body(self) -> RigidBody:
        """What carries the foot: nothing that has mass."""
        start = Start(near=Start(at=("center", self.near)))
        zero: Components = (ZERO,) * 3
        points: dict[str, Components] = {"center": zero, "mass_center": zero}
        return RigidBody(self.carrier, ZERO, ZERO, points, "center", turns=False, tensor=(ZERO,) * 6, start=start)

    def rows(self) -> list[ConstraintRow]:
        """What x, y and h are; nothing is transmitted."""
        h, seen = Symbol(_H), (*self._put, *self._own)
        found = (p - c - h * n for p, c, n in zip(_PLACE, self._foot, self.surface.normal, strict=True))
        return [
            ConstraintRow(name, "", Composed(e, seen, LENGTH), connection=self.carrier)
            for name, e in zip("xyz", found, strict=True)
        ]

    @property
    def _foot(self) -> Components:
        return Symbol("x"), Symbol("y"), self.surface.height

    @property
    def _put(self) -> tuple[tuple[str, Measure], ...]:
        """Where the point is, as the surface counts it."""
        moves = (Displacement(self.point, self.surface.origin, axis) for axis in self.surface.axes)
        return tuple((p.name, move) for p, move in zip(_PLACE, moves, strict=True))

    @property
    def _own(self) -> tuple[tuple[str, Measure], ...]:
        zero = (ZERO,) * 3
        own = (Displacement(Point(self.carrier, zero), Point(GROUND, zero), axis) for axis in AXES)
        return tuple(zip(("x", "y", _H), own, strict=True))

    def _share(self, c: Expr, by: Measure | None = None) -> Composed:
        """A part of a tangent at the foot, times what a rate is multiplied by."""
        if by is None:
            return Composed(c, self._own[:2], DIMENSIONLESS)
        return Composed(c * Symbol(_BY), (*self._own[:2], (_BY, by)), LENGTH)


def from_axis(point: Point, origin: Point, axes: Axes) -> Measure:
    """The distance of a point from the third of the axes through an origin."""
    x, y = (Displacement(point, origin, axis) for axis in axes[:2])
    return Composed(Call("sqrt", SQUARE), (("x", x), ("y", y)), LENGTH)
