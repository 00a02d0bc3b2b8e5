"""The statements of measures over the field, with and without derivatives by the body poses."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from fractions import Fraction
from typing import Any

from freebody.errors import CannotAnswer
from freebody.language.expression import Expr, GivenCall, domain, evaluate, evaluate_sharing
from freebody.language.notation import to_text
from freebody.language.sentences import Message
from freebody.measures.geometry import GROUND, NO_DIRECTION, Pose, SpatialPose, Vector
from freebody.symbolic.field import Field
from freebody.symbolic.functions import atan2, functions
from freebody.symbolic.ratio import Ratio

Tangent = Callable[[Vector[Ratio], Ratio], tuple[Ratio, Ratio]]
Slot = tuple[str, str]  # (body, "x" | "y" | "angle"); in space "x" | "y" | "z", and "rx" | "ry" | "rz" about its axes
AnyPose = Pose[Ratio] | SpatialPose[Ratio]
ROTATIONS = ("rx", "ry", "rz")


class FieldGeometry:
    """Statements over poses given as field elements."""

    def __init__(
        self,
        field: Field,
        names: Mapping[str, Ratio],
        poses: Mapping[str, AnyPose],
        tangent: Tangent,
        root: Callable[[Ratio], Ratio] | None = None,
        *,
        space: bool = False,
        is_negative: Callable[[Ratio], bool] | None = None,
    ) -> None:
        self.field = field
        self.names = names
        self.poses = poses
        self._tangent = tangent
        self._root = root
        # what signs roots have that formulas leave open; a size that is asked for as such may have either, unless here
        self.functions_here = functions(field, is_negative)
        self.functions = {**self.functions_here, "abs": functions(field)["abs"]}
        zero, one = field.zero, field.one
        self._ground: AnyPose = Pose(zero, zero, zero, one, zero)
        if space:
            axes = Vector(one, zero, zero), Vector(zero, one, zero), Vector(zero, zero, one)
            self._ground = SpatialPose(Vector(zero, zero, zero), axes)
        self._scalars: dict[Expr, Ratio] = {}

    def scalar(self, expr: Expr) -> Ratio:
        if expr not in self._scalars:
            self._scalars[expr] = evaluate(expr, self.names, self.functions)
        return self._scalars[expr]

    def pose(self, body: str) -> AnyPose:
        return self._ground if body == GROUND else self.poses[body]

    def root(self, x: Ratio) -> Ratio:
        return self.field.sqrt(x) if self._root is None else self._root(x)

    def tangent(self, v: Vector[Ratio], offset: Ratio) -> tuple[Ratio, Ratio]:
        length, angle = self._tangent(v, offset)
        if length.is_zero():  # a line between places that are one in every pose
            raise CannotAnswer(NO_DIRECTION)
        return length, angle

    def apply(self, expr: Expr, values: dict[str, Ratio], *, here: bool = False) -> Ratio:
        return evaluate_sharing(expr, {**self.names, **values}, self.functions_here if here else self.functions)

    @property
    def scalars(self) -> tuple[Expr, ...]:
        """The expressions in parameters that were evaluated so far."""
        return tuple(self._scalars)

    def needs(self, expr: Expr, values: Mapping[str, Ratio]) -> list[tuple[Ratio, str]]:
        """(element, relation to 0) without which an expression has no value as it is written."""
        names = {**self.names, **values}
        return [(evaluate(part, names, self.functions), relation) for part, relation in domain(expr)]


Compute = Callable[[Mapping[int, Any], Any], Any]


def tangent_in_numbers(field: Field, v: Vector[Ratio], offset: Ratio) -> tuple[Compute, Compute]:
    """How length and angle of a tangent are computed from the values of generators."""

    def size(values: Mapping[int, Any], fn: Any) -> Any:
        x, y, r = (field.evaluate(e, values, fn) for e in (v.x, v.y, offset))
        return fn.sqrt(x * x + y * y - r * r)

    def turn(values: Mapping[int, Any], fn: Any) -> Any:
        x, y, r = (field.evaluate(e, values, fn) for e in (v.x, v.y, offset))
        return fn.atan2(y, x) - fn.atan2(r, fn.sqrt(x * x + y * y - r * r))

    return size, turn


def straight_tangent(field: Field, is_negative: Callable[[Ratio], bool] | None) -> Tangent:
    """Length and angle of a vector whose components are known elements:
    e = (l v - offset n(v)) / |v|^2 with l = sqrt(|v|^2 - offset^2)."""

    def tangent(v: Vector[Ratio], offset: Ratio) -> tuple[Ratio, Ratio]:
        square = v.x * v.x + v.y * v.y
        length = field.sqrt(square - offset * offset, is_negative)
        if offset.is_zero():
            along = v.y if v.x.is_zero() else v.x if v.y.is_zero() else None
            if along is not None and is_negative is not None and length not in (along, -along):
                length = -along if is_negative(along) else along  # the square of a sine hides that it is a square
            return length, atan2(field, v.y, v.x, length)
        cos = (length * v.x + offset * v.y) / square
        sin = (length * v.y - offset * v.x) / square
        return length, atan2(field, sin, cos, field.one)

    return tangent


@dataclass(frozen=True)
class Dual:
    """A value with its derivatives by the coordinates of the bodies."""

    value: Ratio
    slope: dict[Slot, Ratio] = field(default_factory=dict[Slot, Ratio])

    def _with(self, value: Ratio, own: Ratio | int, other: Dual | None = None, its: Ratio | int = 0) -> Dual:
        slope = {k: own * d for k, d in self.slope.items()}
        if other is not None:
            for k, d in other.slope.items():
                slope[k] = slope[k] + its * d if k in slope else its * d
        return Dual(value, slope)

    def _lift(self, other: Any) -> Dual:
        return other if isinstance(other, Dual) else Dual(self.value.field.element(other))

    def __add__(self, other: Any) -> Dual:
        b = self._lift(other)
        return self._with(self.value + b.value, 1, b, 1)

    __radd__ = __add__

    def __neg__(self) -> Dual:
        return self._with(-self.value, -1)

    def __sub__(self, other: Any) -> Dual:
        return self + (-self._lift(other))

    def __rsub__(self, other: Any) -> Dual:
        return (-self) + other

    def __mul__(self, other: Any) -> Dual:
        b = self._lift(other)
        return self._with(self.value * b.value, b.value, b, self.value)

    __rmul__ = __mul__

    def __truediv__(self, other: Any) -> Dual:
        b = self._lift(other)
        quotient = self.value / b.value
        return self._with(quotient, 1 / b.value, b, -quotient / b.value)

    def __rtruediv__(self, other: Any) -> Dual:
        return self._lift(other) / self

    def __pow__(self, exponent: Any) -> Dual:
        if isinstance(exponent, Dual):
            exponent = exponent.value.fraction()
        if not isinstance(exponent, int):
            power = Fraction(exponent)
            value = self.value ** self.value.field.element(power)
            return self._with(value, self.value.field.element(power) * value / self.value)
        if exponent == 0:
            return self._lift(1)
        return self._with(self.value**exponent, exponent * self.value ** (exponent - 1))

    def chain(self, value: Ratio, slope: Ratio) -> Dual:
        """f(self) with f' = slope."""
        return self._with(value, slope)


class DualGeometry:
    """Statements over the same poses, differentiated by them: gradients of measures."""

    def __init__(self, plain: FieldGeometry, moving: Mapping[str, bool]) -> None:
        self.plain = plain
        self.moving = moving  # body -> turns
        self._functions = _dual_functions(plain, plain.functions)
        self._functions_here = _dual_functions(plain, plain.functions_here)

    def scalar(self, expr: Expr) -> Dual:
        return Dual(self.plain.scalar(expr))

    def pose(self, body: str) -> Pose[Dual] | SpatialPose[Dual]:
        p = self.plain.pose(body)
        if isinstance(p, SpatialPose):
            return self._in_space(body, p)
        if body not in self.moving:
            return Pose(*(Dual(v) for v in (p.x, p.y, p.angle, p.cos, p.sin)))
        one = self.plain.field.one
        turn: Slot = (body, "angle")
        if not self.moving[body]:
            return Pose(
                Dual(p.x, {(body, "x"): one}),
                Dual(p.y, {(body, "y"): one}),
                *(Dual(v) for v in (p.angle, p.cos, p.sin)),
            )
        return Pose(
            Dual(p.x, {(body, "x"): one}),
            Dual(p.y, {(body, "y"): one}),
            Dual(p.angle, {turn: one}),
            Dual(p.cos, {turn: -p.sin}),
            Dual(p.sin, {turn: p.cos}),
        )

    def _in_space(self, body: str, p: SpatialPose[Ratio]) -> SpatialPose[Dual]:
        """A body axis e_j turns by d e_j = sum of (e_k x e_j) rotation_k, e_k its axes."""
        if body not in self.moving:
            return SpatialPose(_constant(p.center), (_constant(p.axes[0]), _constant(p.axes[1]), _constant(p.axes[2])))
        one, axes = self.plain.field.one, p.axes
        names = ("x", "y", "z")
        center = [Dual(c, {(body, name): one}) for c, name in zip(_parts(p.center), names, strict=True)]
        turned: list[Vector[Dual]] = []
        for j in range(3):
            k, n = (j + 1) % 3, (j + 2) % 3  # e_k x e_j = -e_n, e_n x e_j = e_k
            slots: list[tuple[str, tuple[Ratio, ...], int]] = []
            if self.moving[body]:
                slots = [(ROTATIONS[k], _parts(axes[n]), -1), (ROTATIONS[n], _parts(axes[k]), 1)]
            turned.append(
                Vector(
                    *(
                        Dual(value, {(body, slot): sign * along[i] for slot, along, sign in slots})
                        for i, value in enumerate(_parts(axes[j]))
                    )
                )
            )
        return SpatialPose(Vector(*center), (turned[0], turned[1], turned[2]))

    def root(self, x: Dual) -> Dual:
        value = self.plain.root(x.value)
        if value.is_zero():
            raise CannotAnswer(NO_DIRECTION)
        return x.chain(value, 1 / (2 * value))

    def tangent(self, v: Vector[Dual], offset: Dual) -> tuple[Dual, Dual]:
        """From v = l e + rho n with constant rho:  l da = n . dv,  dl = e . dv + rho da."""
        x, y, rho = v.x.value, v.y.value, offset.value
        length, angle = self.plain.tangent(Vector(x, y), rho)
        if length.is_zero():
            raise CannotAnswer(NO_DIRECTION)
        square = x * x + y * y if not rho.is_zero() else length * length
        cos = (length * x + rho * y) / square
        sin = (length * y - rho * x) / square
        turned: dict[Slot, Ratio] = {}
        stretched: dict[Slot, Ratio] = {}
        for slot in dict.fromkeys((*v.x.slope, *v.y.slope)):
            zero = self.plain.field.zero
            dx, dy = v.x.slope.get(slot, zero), v.y.slope.get(slot, zero)
            turned[slot] = (cos * dy - sin * dx) / length
            stretched[slot] = cos * dx + sin * dy + rho * turned[slot]
        return Dual(length, stretched), Dual(angle, turned)

    def apply(self, expr: Expr, values: dict[str, Dual], *, here: bool = False) -> Dual:
        names: dict[str, Any] = {n: Dual(v) for n, v in self.plain.names.items()}
        return evaluate(expr, {**names, **values}, self._functions_here if here else self._functions)


def _parts(v: Vector[Ratio]) -> tuple[Ratio, Ratio, Ratio]:
    assert v.z is not None
    return v.x, v.y, v.z


def _text(x: Ratio) -> str:
    return to_text(x.field.expression(x))


def _constant(v: Vector[Ratio]) -> Vector[Dual]:
    return Vector(*map(Dual, _parts(v)))


def _dual_functions(plain: FieldGeometry, f: Mapping[str, Any]) -> dict[str, Any]:
    """Elementary functions with their derivatives."""

    def make(name: str, slope: Callable[[Ratio, Ratio], Ratio]) -> Callable[[Dual], Dual]:
        def call(x: Dual) -> Dual:
            value = f[name](x.value)
            if all(d.is_zero() for d in x.slope.values()):
                return Dual(value)
            try:
                return x.chain(value, slope(x.value, value))
            except ZeroDivisionError as error:  # acos where its argument is one, sqrt where it is zero
                raise CannotAnswer(
                    Message("{name} has no finite slope where its argument is {x}", name=name, x=_text(x.value))
                ) from error

        return call

    slopes: dict[str, Callable[[Ratio, Ratio], Ratio]] = {
        "sqrt": lambda _x, y: 1 / (2 * y),
        "sin": lambda x, _y: f["cos"](x),
        "cos": lambda x, _y: -f["sin"](x),
        "tan": lambda _x, y: 1 + y * y,
        "exp": lambda _x, y: y,
        "log": lambda x, _y: 1 / x,
        "sinh": lambda x, _y: f["cosh"](x),
        "cosh": lambda x, _y: f["sinh"](x),
        "tanh": lambda _x, y: 1 - y * y,
        "asin": lambda x, _y: 1 / f["sqrt"](1 - x * x),
        "acos": lambda x, _y: -1 / f["sqrt"](1 - x * x),
        "atan": lambda x, _y: 1 / (1 + x * x),
        "fresnel_c": lambda x, _y: f["cos"](plain.field.pi * x * x / 2),
        "fresnel_s": lambda x, _y: f["sin"](plain.field.pi * x * x / 2),
        "abs": lambda x, y: x / y,
        "sign": lambda x, _y: x - x,
    }
    made: dict[str, Any] = {name: make(name, slope) for name, slope in slopes.items()}

    def number(x: Fraction) -> Dual:
        return Dual(plain.field.element(x))

    def given(call: GivenCall, x: Dual) -> Dual:
        slope = call.derivative()
        return x.chain(f["given"](call, x.value), plain.field.zero if slope is None else f["given"](slope, x.value))

    made["number"] = number
    made["given"] = given
    made["pi"] = Dual(plain.field.pi)
    return made
