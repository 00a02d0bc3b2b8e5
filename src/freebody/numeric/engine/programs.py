"""Programs: what is watched, as operations on the entries of a state, written from the statement of a measure.

The statement is run over `ProgramNode`, one more scalar of `Geometry[S]`; what is constant is folded, what occurs twice
is computed once. A rate is written by the same operations, forward through the value, with the velocities for the
derivatives of what moves:

    d(x y) = dx y + x dy,  d sqrt(x) = dx/(2 sqrt(x)),  d arg(x, y) = (x dy - y dx)/(x^2 + y^2),  dr = r o (0, w)/2.

Programs are evaluated over whole parts of a step (`enclosures`), which kernels of rows cannot be.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np

from freebody.language.expression import FLOAT_FUNCTIONS, Expr, evaluate
from freebody.measures.base import Measure
from freebody.measures.combination import Combination, Composed
from freebody.measures.geometry import Pose, SpatialPose, Vector
from freebody.model.elements import Component, NonholonomicForm
from freebody.numeric.kernels.arrays import Floats, Ints, floats, ints
from freebody.numeric.kernels.operations import (
    ABS,
    ACOS,
    ADD,
    ARGUMENT,
    ASIN,
    ATAN,
    CONSTANT,
    COS,
    COSH,
    DIVIDE,
    EXP,
    FUNCTIONS,
    INPUT,
    LOG,
    MULTIPLY,
    POWER,
    SIGN,
    SIN,
    SINH,
    SQRT,
    SUBTRACT,
    TAN,
    TANH,
    TIME,
)
from freebody.numeric.numbers import Numbers


@dataclass(frozen=True)
class Program:
    """Operations (n, 3): what is done with which registers, or with which entry of the state; the last one is the
    result. inputs: the entries of the state that are read. turns: for every angle that is counted on, the place among
    the measures of the layout whose bearing it is (-1: none)."""

    code: Ints
    constants: Floats
    inputs: Ints
    turns: tuple[int, ...]


class Writer:
    """Writes programs of one system."""

    def __init__(self, numbers: Numbers, bearing_of: Callable[[Measure], int]) -> None:
        """bearing_of: the place in the layout of a measure that counts turns, else -1."""
        self.numbers = numbers
        self._bearing_of = bearing_of
        self._functions: dict[str, Any] = {name: self._function(SQRT + k, name) for k, name in enumerate(FUNCTIONS)}
        self._ops: list[tuple[int, int, int, float]] = []
        self._known: dict[tuple[int, int, int, float], int] = {}
        self._rates: dict[int, ProgramNode] = {}
        self._poses: dict[str, Pose[ProgramNode] | SpatialPose[ProgramNode]] = {}
        moving = numbers.system.moving
        self._bodies = {body.name: (k, body.turns) for k, body in enumerate(moving)}
        self._width = 6 if numbers.space else 3
        self.n_coordinates = self._width * (len(moving) + 1)
        self.time = self._node(TIME)
        self._names: dict[str, Any] = {**numbers.values, "t": self.time}
        self._place = -1

    # -- programs -----------------------------------------------------------------------------
    def program(self, measure: Measure | NonholonomicForm, order: int, sign: float = 1.0) -> Program:
        """The value of a measure (order 0) or its rate (order 1), by a sign."""
        node = self._rate_of(measure) if order or isinstance(measure, NonholonomicForm) else self._of(measure)
        return self._written(sign * node)

    def _rate_of(self, measure: Measure | NonholonomicForm) -> ProgramNode:
        if isinstance(measure, NonholonomicForm):
            total = self.constant(0.0)
            for coefficient, part in measure.terms:
                total = total + self._of(coefficient) * self._derivative(self._of(part))
            return total
        return self._derivative(self._of(measure))

    def _of(self, measure: Measure | Component) -> ProgramNode:
        if isinstance(measure, Combination):
            total = self.constant(0.0)
            for coefficient, part in measure.terms:
                total = total + self.scalar(coefficient) * self._of(part)
            return total
        if isinstance(measure, Composed):
            return self.apply(measure.expression, {name: self._of(part) for name, part in measure.measures})
        self._place = -1 if isinstance(measure, Component) else self._bearing_of(measure)
        return measure.value(self)

    def _written(self, result: ProgramNode) -> Program:
        """The operations that a result needs, in their order."""
        needed, waiting = set[int](), [result.at]
        while waiting:
            k = waiting.pop()
            if k not in needed:
                needed.add(k)
                waiting += self._taken(k)
        order = [*sorted(needed - {result.at}), result.at]
        place = {k: new for new, k in enumerate(order)}
        inputs = sorted({self._ops[k][1] for k in order if self._ops[k][0] == INPUT})
        turns = [self._ops[k] for k in order if self._ops[k][0] == ARGUMENT]
        code: list[tuple[int, int, int]] = []
        n_turns = 0
        constants: list[float] = []
        for k in order:
            op, i, j, c = self._ops[k]
            if op >= ADD:
                i = place[i]
                j = place[j] if op <= ARGUMENT else 0
            if op == ARGUMENT:
                c, n_turns = float(n_turns), n_turns + 1
            code.append((op, i, j))
            constants.append(c)
        return Program(ints(code, 2, 3), floats(constants), ints(inputs), tuple(int(t[3]) for t in turns))

    def _taken(self, k: int) -> tuple[int, ...]:
        op, i, j, _c = self._ops[k]
        return () if op <= INPUT else (i, j) if op <= ARGUMENT else (i,)

    # -- operations ---------------------------------------------------------------------------
    def _node(self, op: int, i: int = 0, j: int = 0, c: float = 0.0) -> ProgramNode:
        key = op, i, j, c
        if key not in self._known:
            self._known[key] = len(self._ops)
            self._ops.append(key)
        return ProgramNode(self, self._known[key])

    def constant(self, x: float) -> ProgramNode:
        return self._node(CONSTANT, c=float(x) + 0.0)

    def known(self, x: ProgramNode) -> float | None:
        """The number that a node is, if it is one."""
        op, _i, _j, c = self._ops[x.at]
        return c if op == CONSTANT else None

    def binary(self, op: int, a: ProgramNode, b: ProgramNode) -> ProgramNode:
        """a op b, shortened where one of them is 0 or 1."""
        x, y = self.known(a), self.known(b)
        if x is not None and y is not None and not (op == DIVIDE and y == 0.0):
            return self.constant(
                {ADD: x + y, SUBTRACT: x - y, MULTIPLY: x * y}.get(op) or (x / y if op == DIVIDE else 0.0)
            )
        if op == ADD and 0.0 in (x, y):
            return b if x == 0.0 else a
        if op == SUBTRACT and y == 0.0:
            return a
        if op == MULTIPLY and 0.0 in (x, y):
            return self.constant(0.0)
        if op == MULTIPLY and 1.0 in (x, y):
            return b if x == 1.0 else a
        if op == DIVIDE and (y == 1.0 or x == 0.0):
            return a
        return self._node(op, a.at, b.at)

    def function(self, op: int, x: ProgramNode) -> ProgramNode:
        number = self.known(x)
        if number is not None:
            try:
                return self.constant(FLOAT_FUNCTIONS[FUNCTIONS[op - SQRT]](number))
            except (ArithmeticError, ValueError):
                return self.constant(math.nan)
        return self._node(op, x.at)

    def power(self, x: ProgramNode, exponent: float | ProgramNode) -> ProgramNode:
        if isinstance(exponent, ProgramNode):
            number = self.known(exponent)
            if number is None:  # exp(y log x)
                return self.function(EXP, exponent * self.function(LOG, x))
            exponent = number
        if exponent == int(exponent) and 0 <= exponent <= 64:
            result, factor, n = self.constant(1.0), x, int(exponent)
            while n:
                result = result * factor if n & 1 else result
                n >>= 1
                factor = factor * factor if n else factor
            return result
        if exponent == int(exponent) and exponent < 0:
            return self.constant(1.0) / self.power(x, -exponent)
        if exponent == 0.5:
            return self.function(SQRT, x)
        number = self.known(x)
        if number is not None and number > 0.0:
            return self.constant(number**exponent)
        return self._node(POWER, x.at, self.constant(exponent).at, exponent)

    # -- rates --------------------------------------------------------------------------------
    def _derivative(self, x: ProgramNode) -> ProgramNode:
        """The derivative of a node along the motion."""
        for k in self._below(x.at):  # no recursion: chains may be long
            if k not in self._rates:
                self._rates[k] = self._rate_by_parts(k)
        return self._rates[x.at]

    def _below(self, k: int) -> list[int]:
        needed, waiting = set[int](), [k]
        while waiting:
            i = waiting.pop()
            if i not in needed:
                needed.add(i)
                waiting += self._taken(i)
        return sorted(needed)

    def _rate_by_parts(self, k: int) -> ProgramNode:
        op, i, j, c = self._ops[k]
        if op == CONSTANT:
            return self.constant(0.0)
        if op == TIME:
            return self.constant(1.0)
        if op == INPUT:
            return self._speed(i)
        x, dx, here = ProgramNode(self, i), self._rates[i], ProgramNode(self, k)
        if op <= ARGUMENT:
            y, dy = ProgramNode(self, j), self._rates[j]
            if op == ADD:
                return dx + dy
            if op == SUBTRACT:
                return dx - dy
            if op == MULTIPLY:
                return dx * y + x * dy
            if op == DIVIDE:
                return (dx - here * dy) / y
            if op == POWER:
                return c * self.power(x, c - 1.0) * dx
            return (x * dy - y * dx) / (x * x + y * y)
        return self._slope(op, x, here) * dx

    def _slope(self, op: int, x: ProgramNode, here: ProgramNode) -> ProgramNode:
        """The derivative of a function of one number."""
        one = self.constant(1.0)
        if op == SQRT:
            return 0.5 / here
        if op == SIN:
            return self.function(COS, x)
        if op == COS:
            return -self.function(SIN, x)
        if op == TAN:
            return one + here * here
        if op == ASIN:
            return one / self.function(SQRT, one - x * x)
        if op == ACOS:
            return -one / self.function(SQRT, one - x * x)
        if op == ATAN:
            return one / (one + x * x)
        if op == EXP:
            return here
        if op == LOG:
            return one / x
        if op == SINH:
            return self.function(COSH, x)
        if op == COSH:
            return self.function(SINH, x)
        if op == TANH:
            return one - here * here
        return self.function(SIGN, x) if op == ABS else self.constant(0.0)

    def _speed(self, entry: int) -> ProgramNode:
        """The rate of an entry of the state; r' = 1/2 r o (0, w) for a quaternion."""
        n = self.n_coordinates
        if entry < n:
            return self._node(INPUT, n + entry)
        if entry < 2 * n:
            raise ValueError("second derivatives are not written")
        b, part = divmod(entry - 2 * n - 1, 4)
        w, x, y, z = (self._node(INPUT, 2 * n + 1 + 4 * b + c) for c in range(4))
        i, j, k = (self._node(INPUT, n + 6 * b + 3 + c) for c in range(3))
        if part == 0:
            return 0.5 * (-(x * i) - y * j - z * k)
        if part == 1:
            return 0.5 * (w * i + y * k - z * j)
        if part == 2:
            return 0.5 * (w * j + z * i - x * k)
        return 0.5 * (w * k + x * j - y * i)

    # -- what statements use ------------------------------------------------------------------
    def scalar(self, expr: Expr) -> ProgramNode:
        return self.apply(expr, {})

    def apply(self, expr: Expr, values: dict[str, ProgramNode]) -> ProgramNode:
        result: Any = evaluate(expr, {**self._names, **values}, self._functions)
        return result if isinstance(result, ProgramNode) else self.constant(result)

    def _function(self, op: int, name: str) -> Any:
        def applied(x: ProgramNode | float) -> ProgramNode | float:
            return self.function(op, x) if isinstance(x, ProgramNode) else FLOAT_FUNCTIONS[name](x)

        return applied

    def pose(self, body: str) -> Pose[ProgramNode] | SpatialPose[ProgramNode]:
        if body not in self._poses:
            self._poses[body] = self._in_space(body) if self.numbers.space else self._in_plane(body)
        return self._poses[body]

    def _in_plane(self, body: str) -> Pose[ProgramNode]:
        if body not in self._bodies:
            x, y, c, s = self.numbers.fixed_pose(body)
            return Pose(*map(self.constant, (x, y, self.numbers.fixed_angle(body), c, s)))
        k, turns = self._bodies[body]
        x, y, theta = (self._node(INPUT, 3 * k + i) for i in range(3))
        if not turns:
            theta = self.constant(0.0)
        return Pose(x, y, theta, self.function(COS, theta), self.function(SIN, theta))

    def _in_space(self, body: str) -> SpatialPose[ProgramNode]:
        if body not in self._bodies:
            r, R = self.numbers.fixed_frame(body) if body in self.numbers.fixed else (np.zeros(3), np.eye(3))
            return SpatialPose(self._vector(r), (self._vector(R[:, 0]), self._vector(R[:, 1]), self._vector(R[:, 2])))
        k, turns = self._bodies[body]
        center = Vector(*(self._node(INPUT, 6 * k + i) for i in range(3)))
        columns = self._frame(k) if turns else tuple(map(self._vector, np.eye(3)))
        principal = np.asarray(self.numbers.principal(body)) if turns else np.eye(3)
        # R carries components along the principal axes; the body's own axis i has the components principal[i]
        x, y, z = (self._combined(columns, principal[i]) for i in range(3))
        return SpatialPose(center, (x, y, z))

    def _frame(self, k: int) -> tuple[Vector[ProgramNode], ...]:
        """The columns of the rotation matrix of a quaternion of any length; see `rotating.framed`."""
        first = 2 * self.n_coordinates + 1 + 4 * k
        w, x, y, z = (self._node(INPUT, first + i) for i in range(4))
        s = 2.0 / (w * w + x * x + y * y + z * z)
        return (
            Vector(1.0 - s * (y * y + z * z), s * (x * y + w * z), s * (x * z - w * y)),
            Vector(s * (x * y - w * z), 1.0 - s * (x * x + z * z), s * (y * z + w * x)),
            Vector(s * (x * z + w * y), s * (y * z - w * x), 1.0 - s * (x * x + y * y)),
        )

    def _combined(self, columns: tuple[Vector[ProgramNode], ...], by: Floats) -> Vector[ProgramNode]:
        total: Vector[ProgramNode] | None = None
        for column, c in zip(columns, by.tolist(), strict=True):
            part = column.scaled(self.constant(c))
            total = part if total is None else total + part
        assert total is not None
        return total

    def _vector(self, components: Floats) -> Vector[ProgramNode]:
        return Vector(*map(self.constant, np.asarray(components).tolist()))

    def root(self, x: ProgramNode) -> ProgramNode:
        return self.function(SQRT, x)

    def tangent(self, v: Vector[ProgramNode], offset: ProgramNode) -> tuple[ProgramNode, ProgramNode]:
        """v = l e(a) + rho n(a): l = sqrt(|v|^2 - rho^2), a = arg v - atan(rho/l)."""
        length = self.function(SQRT, v.dot(v) - offset * offset)
        if self.known(v.x) is not None and self.known(v.y) is not None:
            turn = self.constant(math.atan2(self.known(v.y) or 0.0, self.known(v.x) or 0.0))
        else:
            turn = self._node(ARGUMENT, v.x.at, v.y.at, float(self._place))
        return length, turn - self.function(ATAN, offset / length)


@dataclass(frozen=True)
class ProgramNode:
    """One result in a program under way: a scalar that statements can be run over."""

    writer: Writer
    at: int

    def _with(self, other: Any) -> ProgramNode:
        return other if isinstance(other, ProgramNode) else self.writer.constant(float(other))

    def __add__(self, other: Any) -> ProgramNode:
        return self.writer.binary(ADD, self, self._with(other))

    def __radd__(self, other: Any) -> ProgramNode:
        return self.writer.binary(ADD, self._with(other), self)

    def __sub__(self, other: Any) -> ProgramNode:
        return self.writer.binary(SUBTRACT, self, self._with(other))

    def __rsub__(self, other: Any) -> ProgramNode:
        return self.writer.binary(SUBTRACT, self._with(other), self)

    def __mul__(self, other: Any) -> ProgramNode:
        return self.writer.binary(MULTIPLY, self, self._with(other))

    def __rmul__(self, other: Any) -> ProgramNode:
        return self.writer.binary(MULTIPLY, self._with(other), self)

    def __truediv__(self, other: Any) -> ProgramNode:
        return self.writer.binary(DIVIDE, self, self._with(other))

    def __rtruediv__(self, other: Any) -> ProgramNode:
        return self.writer.binary(DIVIDE, self._with(other), self)

    def __neg__(self) -> ProgramNode:
        return self.writer.binary(MULTIPLY, self.writer.constant(-1.0), self)

    def __pow__(self, exponent: Any) -> ProgramNode:
        return self.writer.power(self, exponent if isinstance(exponent, ProgramNode) else float(exponent))

    def __rpow__(self, base: Any) -> ProgramNode:
        return self.writer.power(self._with(base), self)
