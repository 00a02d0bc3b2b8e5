"""Values and gradients of measures in numbers of any kind: floats, or balls of 256 bits and more.

A `ExactDual` is a value with its gradient, of which only the entries that are there are kept:  phi(f) has the gradient
phi' grad f.  Balls [m +- r] contain what they stand for.
Source: Johansson, IEEE Trans. Comput. 66, 2017, 1281-1292 (balls).
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

import flint

from freebody.language.expression import FLOAT_FUNCTIONS, FRESNEL, Expr, evaluate
from freebody.language.units import DIMENSIONLESS
from freebody.measures.base import Measure
from freebody.measures.geometry import Pose, SpatialPose, Vector
from freebody.model.elements import Component, ConstraintRow, NonholonomicForm, Parameter

_flint: Any = flint
BITS = 320  # of the balls; twice as many where that does not decide
N_DEGREES = 43200  # an angle that is a whole multiple of pi over a divisor of this is meant so


def precision(bits: int) -> Any:
    """A context in which balls are computed to so many bits."""
    return _flint.ctx.workprec(bits)


# Numbers ----------------------------------------------------------------------------------------
@dataclass(frozen=True)
class Arithmetic:
    """One kind of number."""

    number: Callable[[Any], Any]
    functions: Mapping[str, Callable[[Any], Any]]
    atan2: Callable[[Any, Any], Any]
    pi: Callable[[], Any]


_ELEMENTARY = ("sqrt", "sin", "cos", "tan", "asin", "acos", "atan", "exp", "log", "sinh", "cosh", "tanh", *FRESNEL)


def _ball(x: Any) -> Any:
    if isinstance(x, Fraction):
        return _flint.arb(_flint.fmpq(x.numerator, x.denominator))
    return _flint.arb(x)


def _method(name: str) -> Callable[[Any], Any]:
    return lambda x: getattr(_flint.arb, name)(x)


FLOATS = Arithmetic(float, {name: FLOAT_FUNCTIONS[name] for name in _ELEMENTARY}, math.atan2, lambda: math.pi)
BALLS = Arithmetic(
    _ball,
    {name: _method(name) for name in _ELEMENTARY},
    lambda y, x: _flint.arb.atan2(y, x),
    lambda: _flint.arb.pi(),
)


def is_zero(x: Any) -> bool:
    """Whether a number is exactly zero; a ball around zero is not."""
    return bool(x == 0)


def size_of(c: Any) -> float:
    """The size of a number, or the largest one in a ball."""
    return abs(c) if isinstance(c, float) else float(c.abs_upper())


def decimal(x: float) -> Fraction:
    """The shortest decimal that rounds to the number: what was written, as a rule."""
    return Fraction(repr(float(x)))


def angle(x: float) -> Fraction | None:
    """The multiple of pi that an angle is to rounding, if it is a simple one: 30 deg is pi/6."""
    turns = Fraction(x / math.pi).limit_denominator(N_DEGREES)
    is_simple = N_DEGREES % turns.denominator == 0
    return turns if is_simple and abs(float(turns) * math.pi - x) <= 4e-16 * max(1.0, abs(x)) else None


def parameter_ball(parameter: Parameter | None, value: float) -> Any:
    """What the value of a parameter stands for."""
    turns = angle(value) if parameter is not None and parameter.is_angle else None
    return _ball(decimal(value)) if turns is None else _flint.arb.pi() * _ball(turns)


# Duals ------------------------------------------------------------------------------------------
Gradient = dict[int, Any]


class ExactDual:
    """A value and its gradient, by the number of what it is a derivative by."""

    __slots__ = ("gradient", "value")

    def __init__(self, value: Any, gradient: Gradient | None = None) -> None:
        self.value = value
        self.gradient: Gradient = gradient or {}

    def __neg__(self) -> ExactDual:
        return ExactDual(-self.value, {k: -c for k, c in self.gradient.items()})

    def __add__(self, other: Any, /) -> ExactDual:
        if not isinstance(other, ExactDual):
            return ExactDual(self.value + other, self.gradient)
        if not other.gradient:
            return ExactDual(self.value + other.value, self.gradient)
        total = dict(self.gradient)
        for k, c in other.gradient.items():
            total[k] = total[k] + c if k in total else c
        return ExactDual(self.value + other.value, total)

    __radd__ = __add__

    def __sub__(self, other: Any, /) -> ExactDual:
        return self + (-other)

    def __rsub__(self, other: Any, /) -> ExactDual:
        return -self + other

    def __mul__(self, other: Any, /) -> ExactDual:
        if not isinstance(other, ExactDual):
            return self.chain(self.value * other, other)
        value = self.value * other.value
        if not other.gradient:
            return self.chain(value, other.value)
        if not self.gradient:
            return other.chain(value, self.value)
        return self.chain(value, other.value) + other.chain(0, self.value)

    __rmul__ = __mul__

    def __truediv__(self, other: Any, /) -> ExactDual:
        if not isinstance(other, ExactDual):
            return self.chain(self.value / other, 1 / other)
        return self * other.inverse()

    def __rtruediv__(self, other: Any, /) -> ExactDual:
        return self.inverse() * other

    def __pow__(self, n: Any, /) -> ExactDual:
        if isinstance(n, ExactDual):
            n = n.value
        return self.chain(self.value**n, n * self.value ** (n - 1)) if self.gradient else ExactDual(self.value**n)

    def __rpow__(self, base: Any, /) -> ExactDual:
        return ExactDual(base**self.value)

    def __abs__(self) -> ExactDual:
        return -self if self.value < 0 else self

    def inverse(self) -> ExactDual:
        y = 1 / self.value
        return self.chain(y, -y * y)

    def chain(self, f: Any, f1: Any) -> ExactDual:
        """phi(self), from the value and the slope of phi."""
        return ExactDual(f, {k: f1 * c for k, c in self.gradient.items()})


def _slope(name: str, x: Any, y: Any, arithmetic: Arithmetic) -> Any:
    call = arithmetic.functions
    match name:
        case "sqrt":
            return 1 / (2 * y)
        case "sin":
            return call["cos"](x)
        case "cos":
            return -call["sin"](x)
        case "tan":
            return 1 + y * y
        case "asin":
            return 1 / call["sqrt"](1 - x * x)
        case "acos":
            return -1 / call["sqrt"](1 - x * x)
        case "atan":
            return 1 / (1 + x * x)
        case "exp":
            return y
        case "log":
            return 1 / x
        case "fresnel_c":
            return call["cos"](arithmetic.pi() * x * x / 2)
        case "fresnel_s":
            return call["sin"](arithmetic.pi() * x * x / 2)
        case "sinh":
            return call["cosh"](x)
        case "cosh":
            return call["sinh"](x)
        case _:
            return 1 - y * y


def _functions(arithmetic: Arithmetic) -> dict[str, Any]:
    def function(name: str) -> Callable[[Any], ExactDual]:
        def call(x: Any) -> ExactDual:
            f = x if isinstance(x, ExactDual) else ExactDual(x)
            y = arithmetic.functions[name](f.value)
            return f.chain(y, _slope(name, f.value, y, arithmetic)) if f.gradient else ExactDual(y)

        return call

    def number(x: Any) -> ExactDual:
        return ExactDual(arithmetic.number(x))

    def sign(x: Any) -> ExactDual:
        value = x.value if isinstance(x, ExactDual) else x
        return ExactDual(arithmetic.number((value > 0) - (value < 0)))

    made: dict[str, Any] = {name: function(name) for name in _ELEMENTARY}
    return made | {
        "abs": abs,
        "sign": sign,
        "pi": ExactDual(arithmetic.pi()),
        "number": number,
    }


# Geometry ---------------------------------------------------------------------------------------
PlanarPlace = tuple[
    ExactDual, ExactDual, ExactDual | None
]  # x, y of the mass centre and the angle; None where a body does not turn
Place = PlanarPlace | SpatialPose[ExactDual]
Quaternion = Sequence[Any]  # (w, x, y, z) of any length but zero, over numbers of one kind


def spatial_place(
    center: Sequence[ExactDual], quaternion: Quaternion, by: Sequence[int] = ()
) -> SpatialPose[ExactDual]:
    """A body in space with the axes that a quaternion turns those of the ground to. by: the numbers of the derivatives
    by its angular velocity along its own axes, where these are wanted.

    Along its own axes  d(e_x) = w_z e_y - w_y e_z  and so on. Quaternions need no unit length: R is quadratic in them,
    over the square of their length, so that rational ones make exact rotations."""
    w, x, y, z = quaternion
    size = w * w + x * x + y * y + z * z
    own = [
        ((w * w + x * x - y * y - z * z) / size, 2 * (x * y + w * z) / size, 2 * (x * z - w * y) / size),
        (2 * (x * y - w * z) / size, (w * w - x * x + y * y - z * z) / size, 2 * (y * z + w * x) / size),
        (2 * (x * z + w * y) / size, 2 * (y * z - w * x) / size, (w * w - x * x - y * y + z * z) / size),
    ]

    def axis(j: int) -> Vector[ExactDual]:
        if not by:
            return Vector(*map(ExactDual, own[j]))
        k, n = (j + 1) % 3, (j + 2) % 3
        return Vector(*(ExactDual(own[j][i], {by[n]: own[k][i], by[k]: -own[n][i]}) for i in range(3)))

    return SpatialPose(Vector(*center), (axis(0), axis(1), axis(2)))


class ExactDualGeometry:
    """A `Geometry[ExactDual]`: bodies at their places, symbols with their values."""

    def __init__(self, places: Mapping[str, Place], values: Mapping[str, ExactDual], arithmetic: Arithmetic) -> None:
        self.arithmetic = arithmetic
        self.functions = _functions(arithmetic)
        self.places, self.values = places, values
        self._poses: dict[str, Pose[ExactDual] | SpatialPose[ExactDual]] = {}
        self._scalars: dict[int, tuple[Expr, ExactDual]] = {}
        self.memory: dict[int, tuple[object, Vector[ExactDual]]] = {}  # of points and directions

    def of(self, measure: Measure | NonholonomicForm | Component) -> ExactDual:
        """Of a measure that is only a rate, the coefficients of the velocities in it as gradient."""
        if not isinstance(measure, NonholonomicForm):
            return measure.value(self)
        total = ExactDual(self.arithmetic.number(0))
        for coefficient, term in measure.terms:
            total = total + self.of(term).chain(self.arithmetic.number(0), self.of(coefficient).value)
        return total

    def gap(self, row: ConstraintRow, origin: Any = 0) -> ExactDual:
        """How far a measure, counted from its origin, is from its target; angles up to full turns."""
        if isinstance(row.measure, NonholonomicForm):
            raise ValueError(f"{row.name} is only a rate")
        gap = self.of(row.measure) - origin
        if row.target is not None:
            gap = gap - self.scalar(row.target)
        if row.measure.dimension == DIMENSIONLESS:
            gap = gap - 2 * round(float(gap.value) / math.tau) * self.arithmetic.pi()
        return gap

    def scalar(self, expr: Expr) -> ExactDual:
        known = self._scalars.get(id(expr))
        if known is None:
            known = self._scalars[id(expr)] = expr, self.apply(expr, {})
        return known[1]

    def apply(self, expr: Expr, values: dict[str, ExactDual], *, here: bool = False) -> ExactDual:
        result: Any = evaluate(expr, {**self.values, **values} if values else self.values, self.functions)
        return result if isinstance(result, ExactDual) else ExactDual(self.arithmetic.number(result))

    def pose(self, body: str) -> Pose[ExactDual] | SpatialPose[ExactDual]:
        known = self._poses.get(body)
        if known is None:
            place = self.places[body]
            known = self._poses[body] = place if isinstance(place, SpatialPose) else self._in_plane(place)
        return known

    def _in_plane(self, place: PlanarPlace) -> Pose[ExactDual]:
        x, y, theta = place
        if theta is None:
            zero, one = (ExactDual(self.arithmetic.number(k)) for k in (0, 1))
            return Pose(x, y, zero, one, zero)
        c, s = (self.arithmetic.functions[name](theta.value) for name in ("cos", "sin"))
        return Pose(x, y, theta, theta.chain(c, -s), theta.chain(s, c))

    def root(self, x: ExactDual) -> ExactDual:
        if not x.value > 0:
            raise ValueError("points that coincide have no direction from one to the other")
        return self.functions["sqrt"](x)

    def tangent(self, v: Vector[ExactDual], offset: ExactDual) -> tuple[ExactDual, ExactDual]:
        # v = l e(a) + offset n(a):  l = sqrt(|v|^2 - offset^2),  a = atan2(v_y, v_x) - atan2(offset, l)
        square = v.dot(v) - offset * offset
        if not square.value > 0:
            raise ValueError("a line between circles that overlap has no direction")
        length = self.functions["sqrt"](square)
        heading = self._arc_tangent(v.y, v.x)
        if offset.gradient or not is_zero(offset.value):
            heading = heading - self._arc_tangent(offset, length)
        return length, heading

    def _arc_tangent(self, y: ExactDual, x: ExactDual) -> ExactDual:
        r2 = x.value * x.value + y.value * y.value
        along = y.chain(0, x.value / r2) + x.chain(0, -y.value / r2)
        return ExactDual(self.arithmetic.atan2(y.value, x.value), along.gradient)
