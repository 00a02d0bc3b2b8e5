"""Programs: what is watched, as operations on the entries of a state, written from the statement of a measure.

The statement is run over `ProgramNode`, one more scalar of `Geometry[S]` (`operations`). What moves are places, angles
and quaternions r, of which r' = r o (0, w)/2 with the angular velocity w along the principal axes.

Programs are evaluated over whole parts of a step (`enclosures`), which kernels of rows cannot be.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from typing import Any

import numpy as np

from freebody.language.expression import FLOAT_FUNCTIONS, Expr, evaluate
from freebody.measures.base import Measure
from freebody.measures.combination import Combination, Composed
from freebody.measures.geometry import Pose, SpatialPose, Vector
from freebody.model.elements import Component, NonholonomicForm
from freebody.numeric.engine.operations import OperationGraph, Program, ProgramNode
from freebody.numeric.kernels.arrays import Floats
from freebody.numeric.kernels.operations import (
    ARGUMENT,
    ATAN,
    COS,
    FUNCTIONS,
    INPUT,
    SIN,
    SQRT,
    TIME,
)
from freebody.numeric.numbers import Numbers


class Writer(OperationGraph):
    """Writes programs of one system."""

    def __init__(
        self, numbers: Numbers, bearing_of: Callable[[Measure], int], setting: Callable[[Measure], float | None]
    ) -> None:
        """bearing_of: the place in the layout of a measure that counts turns, else -1. setting: what a number is that a
        motion sets, None of another measure."""
        super().__init__()
        self._setting = setting
        self.numbers = numbers
        self._bearing_of = bearing_of
        self._functions: dict[str, Any] = {name: self._function(SQRT + k, name) for k, name in enumerate(FUNCTIONS)}
        self._poses: dict[str, Pose[ProgramNode] | SpatialPose[ProgramNode]] = {}
        self.memory: dict[int, tuple[object, Vector[ProgramNode]]] = {}  # of points and directions (`geometry`)
        self._written: dict[int, tuple[object, ProgramNode]] = {}  # of measures, by their identity
        moving = numbers.system.all_moving
        self._bodies = {body.name: (k, body.turns) for k, body in enumerate(moving)}
        self.width = 6 if numbers.space else 3
        self.n_coordinates = self.width * (len(moving) + 1)
        self.time = self.node(TIME)
        self._names: dict[str, Any] = {**numbers.values, "t": self.time}
        self._place = -1

    # -- programs -----------------------------------------------------------------------------
    def program(self, order: int, parts: Sequence[tuple[Measure | NonholonomicForm, float]]) -> Program:
        """The values of measures (order 0) or their rates (order 1), each by a factor, added."""
        total = self.constant(0.0)
        for measure, factor in parts:
            node = self._rate_of(measure) if order or isinstance(measure, NonholonomicForm) else self._of(measure)
            total = total + factor * node
        return self.written(total)

    def forget(self) -> None:
        """What was written of measures, where a setting has changed."""
        self._written.clear()

    def _rate_of(self, measure: Measure | NonholonomicForm) -> ProgramNode:
        if isinstance(measure, NonholonomicForm):
            total = self.constant(0.0)
            for coefficient, part in measure.terms:
                total = total + self._of(coefficient) * self.derivative(self._of(part))
            return total
        return self.derivative(self._of(measure))

    def _of(self, measure: Measure | Component) -> ProgramNode:
        known = self._written.get(id(measure))
        if known is None:
            known = self._written[id(measure)] = measure, self._stated(measure)
        return known[1]

    def _stated(self, measure: Measure | Component) -> ProgramNode:
        if isinstance(measure, Combination):
            total = self.constant(0.0)
            for coefficient, part in measure.terms:
                total = total + self.scalar(coefficient) * self._of(part)
            return total
        if isinstance(measure, Composed):
            if (value := self._setting(measure)) is not None:
                return self.constant(value)
            return self.apply(measure.expression, {name: self._of(part) for name, part in measure.measures})
        self._place = -1 if isinstance(measure, Component) else self._bearing_of(measure)
        return measure.value(self)

    def speed(self, entry: int) -> ProgramNode:
        """The rate of an entry of the state; r' = 1/2 r o (0, w) for a quaternion."""
        n = self.n_coordinates
        if entry < n:
            return self.node(INPUT, n + entry)
        if entry < 2 * n:
            raise ValueError("second derivatives are not written")
        b, part = divmod(entry - 2 * n - 1, 4)
        w, x, y, z = (self.node(INPUT, 2 * n + 1 + 4 * b + c) for c in range(4))
        i, j, k = (self.node(INPUT, n + 6 * b + 3 + c) for c in range(3))
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

    def apply(self, expr: Expr, values: dict[str, ProgramNode], *, here: bool = False) -> ProgramNode:
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
        x, y, theta = (self.node(INPUT, 3 * k + i) for i in range(3))
        if not turns:
            theta = self.constant(0.0)
        return Pose(x, y, theta, self.function(COS, theta), self.function(SIN, theta))

    def _in_space(self, body: str) -> SpatialPose[ProgramNode]:
        if body not in self._bodies:
            r, R = self.numbers.fixed_frame(body) if body in self.numbers.fixed else (np.zeros(3), np.eye(3))
            return SpatialPose(self._vector(r), (self._vector(R[:, 0]), self._vector(R[:, 1]), self._vector(R[:, 2])))
        k, turns = self._bodies[body]
        center = Vector(*(self.node(INPUT, 6 * k + i) for i in range(3)))
        columns = self._frame(k) if turns else tuple(map(self._vector, np.eye(3)))
        principal = np.asarray(self.numbers.principal(body)) if turns else np.eye(3)
        # R carries components along the principal axes; the body's own axis i has the components principal[i]
        x, y, z = (self._combined(columns, principal[i]) for i in range(3))
        return SpatialPose(center, (x, y, z))

    def _frame(self, k: int) -> tuple[Vector[ProgramNode], ...]:
        """The columns of the rotation matrix of a quaternion of any length; see `rotating.framed`."""
        first = 2 * self.n_coordinates + 1 + 4 * k
        w, x, y, z = (self.node(INPUT, first + i) for i in range(4))
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
            turn = self.node(ARGUMENT, v.x.at, v.y.at, float(self._place))
        return length, turn - self.function(ATAN, offset / length)
