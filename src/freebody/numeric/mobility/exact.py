"""Rows of the constraint Jacobian in numbers of any kind, and their rank in balls of 256 bits and more.

A `Dual` is a value with its gradient, of which only the entries that are there are kept:  phi(f) has the gradient
phi' grad f.  Over balls [m +- r], which contain what they stand for, a pivot that does not contain zero is not zero.
Rows are eliminated in the order of the model,

    row_k - sum over earlier pivots p of m_kp pivot_p = rest_k,

and a row whose rest vanishes depends on earlier ones; its multipliers, followed back, are the one combination of
kept rows that it equals. These rows with it are its fundamental circuit: leave any of them out and the others are
independent. Since kept rows come first, the redundant row of a circuit is the one declared last.
Sources: Johansson, IEEE Trans. Comput. 66, 2017, 1281-1292 (balls); Oxley, Matroid Theory, 2nd ed. 2011, sec. 1.2
(fundamental circuits); Duff, Erisman & Reid, Direct Methods for Sparse Matrices, 2nd ed. 2017, ch. 5 and 7.
"""

from __future__ import annotations

import heapq
import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from fractions import Fraction
from typing import Any

import flint

from freebody.language.expression import Expr, evaluate
from freebody.measures.base import Measure
from freebody.measures.geometry import Pose, Vector
from freebody.model.elements import Component, Parameter, RateMeasure

_flint: Any = flint
TIME = "t"
BITS = 320  # of the balls; twice as many where that does not decide
CLEAR = 1e-9  # a rest that is larger is not zero: smaller ones would be told apart from zero by the data's last digits
N_DEGREES = 43200  # an angle that is a whole multiple of pi over a divisor of this is meant so


class Unclear(Exception):
    """A rest is neither zero nor clearly something else."""


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


_ELEMENTARY = ("sqrt", "sin", "cos", "tan", "asin", "acos", "atan", "exp", "log", "sinh", "cosh", "tanh")


def _ball(x: Any) -> Any:
    if isinstance(x, Fraction):
        return _flint.arb(_flint.fmpq(x.numerator, x.denominator))
    return _flint.arb(x)


def _method(name: str) -> Callable[[Any], Any]:
    return lambda x: getattr(_flint.arb, name)(x)


FLOATS = Arithmetic(float, {name: getattr(math, name) for name in _ELEMENTARY}, math.atan2, lambda: math.pi)
BALLS = Arithmetic(
    _ball,
    {name: _method(name) for name in _ELEMENTARY},
    lambda y, x: _flint.arb.atan2(y, x),
    lambda: _flint.arb.pi(),
)


def is_zero(x: Any) -> bool:
    """Whether a number is exactly zero; a ball around zero is not."""
    return bool(x == 0)


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


class Dual:
    """A value and its gradient, by the number of what it is a derivative by."""

    __slots__ = ("gradient", "value")

    def __init__(self, value: Any, gradient: Gradient | None = None) -> None:
        self.value = value
        self.gradient: Gradient = gradient or {}

    def __neg__(self) -> Dual:
        return Dual(-self.value, {k: -c for k, c in self.gradient.items()})

    def __add__(self, other: Any, /) -> Dual:
        if not isinstance(other, Dual):
            return Dual(self.value + other, self.gradient)
        if not other.gradient:
            return Dual(self.value + other.value, self.gradient)
        total = dict(self.gradient)
        for k, c in other.gradient.items():
            total[k] = total[k] + c if k in total else c
        return Dual(self.value + other.value, total)

    __radd__ = __add__

    def __sub__(self, other: Any, /) -> Dual:
        return self + (-other)

    def __rsub__(self, other: Any, /) -> Dual:
        return -self + other

    def __mul__(self, other: Any, /) -> Dual:
        if not isinstance(other, Dual):
            return self.chain(self.value * other, other)
        value = self.value * other.value
        if not other.gradient:
            return self.chain(value, other.value)
        if not self.gradient:
            return other.chain(value, self.value)
        return self.chain(value, other.value) + other.chain(0, self.value)

    __rmul__ = __mul__

    def __truediv__(self, other: Any, /) -> Dual:
        if not isinstance(other, Dual):
            return self.chain(self.value / other, 1 / other)
        return self * other.inverse()

    def __rtruediv__(self, other: Any, /) -> Dual:
        return self.inverse() * other

    def __pow__(self, n: Any, /) -> Dual:
        if isinstance(n, Dual):
            n = n.value
        return self.chain(self.value**n, n * self.value ** (n - 1)) if self.gradient else Dual(self.value**n)

    def __rpow__(self, base: Any, /) -> Dual:
        return Dual(base**self.value)

    def __abs__(self) -> Dual:
        return -self if self.value < 0 else self

    def inverse(self) -> Dual:
        y = 1 / self.value
        return self.chain(y, -y * y)

    def chain(self, f: Any, f1: Any) -> Dual:
        """phi(self), from the value and the slope of phi."""
        return Dual(f, {k: f1 * c for k, c in self.gradient.items()})


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
        case "sinh":
            return call["cosh"](x)
        case "cosh":
            return call["sinh"](x)
        case _:
            return 1 - y * y


def _functions(arithmetic: Arithmetic) -> dict[str, Any]:
    def function(name: str) -> Callable[[Any], Dual]:
        def call(x: Any) -> Dual:
            f = x if isinstance(x, Dual) else Dual(x)
            y = arithmetic.functions[name](f.value)
            return f.chain(y, _slope(name, f.value, y, arithmetic)) if f.gradient else Dual(y)

        return call

    def number(x: Any) -> Dual:
        return Dual(arithmetic.number(x))

    def sign(x: Any) -> Dual:
        value = x.value if isinstance(x, Dual) else x
        return Dual(arithmetic.number((value > 0) - (value < 0)))

    made: dict[str, Any] = {name: function(name) for name in _ELEMENTARY}
    return made | {
        "abs": abs,
        "sign": sign,
        "pi": Dual(arithmetic.pi()),
        "number": number,
    }


# Geometry ---------------------------------------------------------------------------------------
Place = tuple[Dual, Dual, Dual | None]  # x, y of the mass centre and the angle; None where a body does not turn


class DualGeometry:
    """A `Geometry[Dual]`: bodies at their places, symbols with their values."""

    def __init__(self, places: Mapping[str, Place], values: Mapping[str, Dual], arithmetic: Arithmetic) -> None:
        self.arithmetic = arithmetic
        self.functions = _functions(arithmetic)
        self.places, self.values = places, values
        self._poses: dict[str, Pose[Dual]] = {}
        self._scalars: dict[int, tuple[Expr, Dual]] = {}

    def of(self, measure: Measure | RateMeasure | Component) -> Dual:
        """Of a measure that is only a rate, the coefficients of the velocities in it as gradient."""
        if not isinstance(measure, RateMeasure):
            return measure.value(self)
        total = Dual(self.arithmetic.number(0))
        for coefficient, term in measure.terms:
            total = total + self.of(term).chain(self.arithmetic.number(0), self.of(coefficient).value)
        return total

    def scalar(self, expr: Expr) -> Dual:
        known = self._scalars.get(id(expr))
        if known is None:
            known = self._scalars[id(expr)] = expr, self.apply(expr, {})
        return known[1]

    def apply(self, expr: Expr, values: dict[str, Dual]) -> Dual:
        result: Any = evaluate(expr, {**self.values, **values} if values else self.values, self.functions)
        return result if isinstance(result, Dual) else Dual(self.arithmetic.number(result))

    def pose(self, body: str) -> Pose[Dual]:
        known = self._poses.get(body)
        if known is None:
            x, y, theta = self.places[body]
            if theta is None:
                zero, one = (Dual(self.arithmetic.number(k)) for k in (0, 1))
                known = Pose(x, y, zero, one, zero)
            else:
                c, s = (self.arithmetic.functions[name](theta.value) for name in ("cos", "sin"))
                known = Pose(x, y, theta, theta.chain(c, -s), theta.chain(s, c))
            self._poses[body] = known
        return known

    def tangent(self, v: Vector[Dual], offset: Dual) -> tuple[Dual, Dual]:
        # v = l e(a) + offset n(a):  l = sqrt(|v|^2 - offset^2),  a = atan2(v_y, v_x) - atan2(offset, l)
        square = v.dot(v) - offset * offset
        if not square.value > 0:
            raise ValueError("a line between circles that overlap has no direction")
        length = self.functions["sqrt"](square)
        heading = self._arc_tangent(v.y, v.x)
        if offset.gradient or not is_zero(offset.value):
            heading = heading - self._arc_tangent(offset, length)
        return length, heading

    def _arc_tangent(self, y: Dual, x: Dual) -> Dual:
        r2 = x.value * x.value + y.value * y.value
        along = y.chain(0, x.value / r2) + x.chain(0, -y.value / r2)
        return Dual(self.arithmetic.atan2(y.value, x.value), along.gradient)


# Elimination ------------------------------------------------------------------------------------
def size_of(c: Any) -> float:
    """The size of a number, or the largest one in a ball."""
    return abs(c) if isinstance(c, float) else float(c.abs_upper())


Row = dict[int, Any]


@dataclass
class Elimination:
    """Rows eliminated in their order. `kept` are the independent ones, `circuits` holds for every other row the
    kept ones that it depends on, and itself.

    zero: rests that are smaller count as zero, rests between it and `clear` raise Unclear. Rows are to have entries
    of about one.
    """

    zero: float
    clear: float = CLEAR
    kept: list[int] = field(default_factory=list[int])
    circuits: list[tuple[int, ...]] = field(default_factory=list[tuple[int, ...]])
    smallest: float = 1.0  # the smallest pivot
    largest: float = 0.0  # the largest rest that counts as zero
    _pivots: list[tuple[int, Any, Row]] = field(default_factory=list[tuple[int, Any, Row]], repr=False)
    _at: dict[int, int] = field(default_factory=dict[int, int], repr=False)  # column -> which pivot
    _steps: list[list[tuple[int, Any]]] = field(default_factory=list[list[tuple[int, Any]]], repr=False)

    @classmethod
    def of(cls, rows: Sequence[Row], zero: float, clear: float = CLEAR) -> Elimination:
        made = cls(zero, clear)
        counts: dict[int, int] = {}
        for row in rows:
            for k in row:
                counts[k] = counts.get(k, 0) + 1
        for k, row in enumerate(rows):
            made._take(k, row, counts)
        return made

    @property
    def rank(self) -> int:
        return len(self.kept)

    def _take(self, index: int, row: Row, counts: Mapping[int, int]) -> None:
        rest, steps = self._reduced(dict(row))
        sizes = {k: size_of(c) for k, c in rest.items()}
        if not math.isfinite(sum(sizes.values())):
            raise Unclear("a row has no finite entries")
        most = max(sizes.values(), default=0.0)
        if most <= self.zero:
            self.largest = max(self.largest, most)
            self.circuits.append((*sorted(self._combination(steps)), index))
            return
        if most < self.clear:
            raise Unclear(f"a row is left with entries of {most:.1e} after elimination")
        # of the large entries the one in the column that is used least: it is eliminated most rarely
        column = min((k for k, size in sizes.items() if size > 0.1 * most), key=lambda k: (counts[k], -sizes[k]))
        pivot = rest.pop(column)
        if not abs(pivot) > self.zero:
            raise Unclear("a pivot is not proved to differ from zero")
        self.smallest = min(self.smallest, size_of(pivot))
        self._at[column] = len(self._pivots)
        self._pivots.append((index, pivot, rest))
        self._steps.append(steps)
        self.kept.append(index)

    def _reduced(self, row: Row) -> tuple[Row, list[tuple[int, Any]]]:
        """The row less what earlier pivots account for, and how much of each that is."""
        at = self._at
        columns = {at[k]: k for k in row if k in at}
        waiting = list(columns)
        heapq.heapify(waiting)
        steps: list[tuple[int, Any]] = []
        while waiting:
            p = heapq.heappop(waiting)
            c = row.pop(columns[p], None)
            if c is None or size_of(c) <= self.zero:
                continue
            _index, pivot, others = self._pivots[p]
            factor = c / pivot
            steps.append((p, factor))
            for k, other in others.items():
                if k in row:
                    row[k] = row[k] - factor * other
                    continue
                row[k] = -(factor * other)
                if k in at and at[k] not in columns:
                    columns[at[k]] = k
                    heapq.heappush(waiting, at[k])
        return row, steps

    def _combination(self, steps: Sequence[tuple[int, Any]]) -> list[int]:
        """The kept rows with a part in what these steps took away."""
        parts: dict[int, Any] = dict(steps)
        waiting = [-p for p in parts]
        heapq.heapify(waiting)
        found: list[int] = []
        while waiting:
            p = -heapq.heappop(waiting)
            part = parts[p]
            size = size_of(part)
            if size <= self.zero:
                continue
            if size < self.clear:
                raise Unclear(f"a row takes part in a circuit by no more than {size:.1e}")
            found.append(self._pivots[p][0])
            for earlier, factor in self._steps[p]:
                if earlier not in parts:
                    parts[earlier] = -(part * factor)
                    heapq.heappush(waiting, -earlier)
                else:
                    parts[earlier] = parts[earlier] - part * factor
        return found


def unit_rows(rows: Sequence[Gradient], scale: Callable[[int], Any]) -> list[Row]:
    """Rows in scaled coordinates, brought to a largest entry of about one."""
    made: list[Row] = []
    for row in rows:
        scaled = {k: c * scale(k) for k, c in row.items() if not is_zero(c)}
        size = max((size_of(c) for c in scaled.values()), default=0.0)
        made.append({k: c / size for k, c in scaled.items()} if size > 0.0 else {})
    return made
