"""Statements of measures over jets: a pose with its velocities, in which measures have values, gradients and rates."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, field, replace
from typing import Any, cast

import numpy as np

from freebody.errors import CannotAnswer
from freebody.language.expression import Expr, evaluate, free_symbols
from freebody.language.sentences import Message
from freebody.measures.base import Measure
from freebody.measures.geometry import NO_DIRECTION, Direction, Point, Pose, SpatialPose, Vector
from freebody.model.elements import Component, NonholonomicForm
from freebody.numeric import spatial
from freebody.numeric.jet_poses import TurningPose, TurningSpatialPose
from freebody.numeric.jets import (
    JET_FUNCTIONS,
    LARGE,
    TIME,
    Array,
    Gradient,
    GradientEntries,
    Jet,
    arc_tangent,
    function_of,
    times,
)
from freebody.numeric.rotation import matrix

Branch = tuple[int, int]  # which measure, and which of the angles in its statement


@dataclass(frozen=True)
class Frame:
    """What the geometry at every instant has in common: where the coordinates of a body stand in q, where
    the fixed bodies are, and the values of the parameters."""

    columns: Mapping[str, tuple[int, ...]]  # x, y and, if the body turns, theta
    fixed: Mapping[str, tuple[float, ...]]
    values: Mapping[str, float]
    space: bool = False  # x, y, z and, if the body turns, a rotation vector; see `spatial`
    principal: Mapping[str, Array] = field(default_factory=dict[str, Array])  # principal axes in body components
    _constants: dict[int, tuple[Expr, Jet]] = field(default_factory=dict[int, tuple[Expr, Jet]], repr=False)
    _turned: dict[str, Array] = field(default_factory=dict[str, Array], repr=False)
    _seen: dict[int, tuple[object, int]] = field(default_factory=dict[int, tuple[object, int]], repr=False)
    _numbers: dict[object, int] = field(default_factory=dict[object, int], repr=False)
    # points and directions that stay as they are: of fixed bodies, with components that do not know the time
    lasting: dict[int, tuple[object, Vector[Jet]]] = field(
        default_factory=dict[int, tuple[object, Vector["Jet"]]], repr=False
    )

    @property
    def n(self) -> int:
        return sum(map(len, self.columns.values()))

    def only(self, bodies: Iterable[str]) -> tuple[Frame, list[int]]:
        """The frame of some of the bodies, without the others, and where their coordinates stand in q."""
        columns: dict[str, tuple[int, ...]] = {}
        own: list[int] = []
        for body in bodies:
            columns[body] = tuple(range(len(own), len(own) + len(self.columns[body])))
            own += self.columns[body]
        return replace(self, columns=columns), own

    def released(self, body: str) -> Frame:
        """The same frame in which a fixed body may move: its coordinates are the last three."""
        kept = {name: pose for name, pose in self.fixed.items() if name != body}
        own = tuple(range(self.n, self.n + (6 if self.space else 3)))
        return replace(self, columns={**self.columns, body: own}, fixed=kept, lasting={})

    def moved(self, q: Array, step: Array) -> Array:
        """The pose a small step from q, by the speeds' directions."""
        return spatial.moved(q, step, self.columns.values()) if self.space else q + step

    def difference(self, q: Array, q0: Array) -> Array:
        """The step that leads from q0 to q."""
        return spatial.difference(q, q0, self.columns.values()) if self.space else q - q0

    def slope(self, q: Array, v: Array) -> Array:
        """dq/dt of the speeds v."""
        return spatial.slope(q, v, self.columns.values()) if self.space else v

    def constant(self, expr: Expr) -> Jet | None:
        """Value of an expression in the parameters; None where time is in it."""
        known = self._constants.get(id(expr))
        if known is None:
            if TIME in free_symbols(expr):
                return None
            known = expr, Jet(float(evaluate(expr, self.values)))
            self._constants[id(expr)] = known
        return known[1]

    def turned(self, body: str, axes: Array) -> Array:
        """The `skews` of the axes of a body, which are the same at all instants."""
        known = self._turned.get(body)
        if known is None:
            known = self._turned[body] = spatial.skews(axes)
        return known

    def number(self, measure: object) -> int:
        """The same number for equal measures."""
        known = self._seen.get(id(measure))
        if known is None:
            known = measure, self._numbers.setdefault(measure, len(self._numbers))
            self._seen[id(measure)] = known
        return known[1]

    def counted(self, branches: Mapping[Branch, float], other: Frame) -> Mapping[Branch, float]:
        """The angles of an instant that were met in another frame of the same bodies, by the numbers of this one."""
        if other is self:
            return branches
        measures = {number: measure for measure, number in other._numbers.items()}
        return {(self.number(measures[number]), k): angle for (number, k), angle in branches.items()}

    def measures(self, branches: Iterable[Branch]) -> list[Measure]:
        """The measures in whose statements these angles stand."""
        numbers = {number for number, _k in branches}
        return [cast("Measure", measure) for measure, number in self._numbers.items() if number in numbers]


class JetGeometry:
    """A `Geometry[Jet]` at the pose q with the velocity v at the time t.

    Angles of tangents are counted from the nearest of `near`, the angles of an earlier instant; those met
    here are in `angles`."""

    def __init__(self, frame: Frame, q: Array, v: Array, t: float, near: Mapping[Branch, float]) -> None:
        self.frame = frame
        self.time = Jet(t, None, 1.0, 0.0)
        self.angles: dict[Branch, float] = dict(near)
        self.q, self.v = q, v
        self.least = 0.0  # [m] a line must be longer than this to have a direction
        self._q, self._v = q.tolist(), v.tolist()
        n = len(self._q)
        self._unit_rows = None if n > LARGE else np.eye(n)
        self._poses: dict[str, Pose[Jet] | SpatialPose[Jet]] = {}
        self.memory: dict[int, tuple[object, Vector[Jet]]] = {}  # of points and directions
        self._measure, self._n_tangents = -1, 0
        self._known: dict[int, tuple[int, Jet]] = {}  # by number of a measure: how many angles of lines are in it

    def of(self, measure: Measure | NonholonomicForm | Component) -> Jet:
        """The jet of a measure. One that is only a rate has the value 0, and as gradient the coefficients of
        the velocities in it."""
        if isinstance(measure, NonholonomicForm):
            return self._of_rate(measure)
        number = self._measure = self.frame.number(measure)
        if number not in self._known:
            self._n_tangents = 0
            jet = measure.value(self)
            self._known[number] = self._n_tangents, jet
        self._n_tangents, jet = self._known[number]
        return jet

    def of_near(self, measure: Measure | NonholonomicForm, target: float) -> Jet:
        """The jet of a measure, its angles counted so that the value comes nearest to the target."""
        jet = self.of(measure)
        branches = [(self._measure, k) for k in range(self._n_tangents)]
        for turn in (math.tau, -math.tau):
            while branches and abs(jet.value - target) > math.pi:
                before = {branch: self.angles[branch] for branch in branches}
                self.angles |= {branch: angle + turn for branch, angle in before.items()}
                self._forget(measure)
                turned = self.of(measure)
                if abs(turned.value - target) >= abs(jet.value - target):
                    self.angles |= before
                    self._forget(measure)
                    break
                jet = turned
        return jet

    def _forget(self, measure: Measure | NonholonomicForm) -> None:
        """Its angles are counted otherwise from here on."""
        self._known.pop(self.frame.number(measure), None)

    def _of_rate(self, measure: NonholonomicForm) -> Jet:
        # d/dt (c m') = c m'' + c' m'
        total = Jet(0.0)
        for coefficient, term in measure.terms:
            c, m = self.of(coefficient), self.of(term)
            bias = c.value * m.bias + c.rate * m.rate
            total = total + Jet(0.0, times(c.value, m.gradient), c.value * m.rate, bias)
        return total

    # -- what statements use ------------------------------------------------------------------
    def scalar(self, expr: Expr) -> Jet:
        known = self.frame.constant(expr)
        return self.apply(expr, {}) if known is None else known

    def apply(self, expr: Expr, values: dict[str, Jet], *, here: bool = False) -> Jet:
        names: dict[str, Any] = {**self.frame.values, TIME: self.time, **values}
        result = evaluate(expr, names, JET_FUNCTIONS)
        return result if isinstance(result, Jet) else Jet(float(result))

    def pose(self, body: str) -> Pose[Jet] | SpatialPose[Jet]:
        known = self._poses.get(body)
        if known is None:
            known = self._poses[body] = self._in_space(body) if self.frame.space else self._pose(body)
        return known

    def _unit_row(self, k: int) -> Gradient:
        return GradientEntries({k: 1.0}) if self._unit_rows is None else self._unit_rows[k]

    def lasting(self, what: Point | Direction, made: Callable[[], Vector[Jet]]) -> Vector[Jet]:
        """Of a fixed body what was made at an earlier instant, unless time is in it."""
        if what.body not in self.frame.fixed:
            return made()
        known = self.frame.lasting.get(id(what))
        if known is None:
            known = what, made()
            own = what.offset if isinstance(what, Point) else what.components
            if all(self.frame.constant(expr) is not None for expr in own):
                self.frame.lasting[id(what)] = known
        return known[1]

    def root(self, x: Jet) -> Jet:
        if x.value <= self.least**2:
            raise CannotAnswer(NO_DIRECTION)
        return cast("Jet", function_of("sqrt", x))

    def _in_space(self, body: str) -> SpatialPose[Jet]:
        columns, principal = self.frame.columns.get(body), self.frame.principal.get(body, spatial.UNIT)
        if columns is None:
            place = self.frame.fixed[body]
            axes = matrix(np.array(place[3:]))
            center = Vector(*(Jet(c) for c in place[:3]))
            x, y, z = (Vector(*(Jet(float(c)) for c in axes[:, j])) for j in range(3))
            return SpatialPose(center, (x, y, z))
        center = Vector(*(Jet(self._q[k], self._unit_row(k), self._v[k]) for k in columns[:3]))
        own = list(columns[3:])
        if not own:
            x, y, z = (Vector(*(Jet(float(c)) for c in row)) for row in spatial.UNIT)
            return SpatialPose(center, (x, y, z))
        omega = np.array([self._v[k] for k in own])
        axes = spatial.axis_jets(matrix(self.q[own]), principal, self.frame.turned(body, principal), omega)
        return TurningSpatialPose(center, own, len(self._q), axes)

    def _pose(self, body: str) -> Pose[Jet]:
        columns = self.frame.columns.get(body)
        if columns is None:
            x, y, theta = self.frame.fixed[body]
            return Pose(Jet(x), Jet(y), Jet(theta), Jet(math.cos(theta)), Jet(math.sin(theta)))
        x, y, *turning = (Jet(self._q[k], self._unit_row(k), self._v[k]) for k in columns)
        if not turning:
            return Pose(x, y, Jet(0.0), Jet(1.0), Jet(0.0))
        theta = turning[0]
        c, s = math.cos(theta.value), math.sin(theta.value)
        pose = Pose if self._unit_rows is None else TurningPose
        return pose(x, y, theta, theta.chain(c, -s, -c), theta.chain(s, c, -s))

    def tangent(self, v: Vector[Jet], offset: Jet) -> tuple[Jet, Jet]:
        # v = l e(a) + offset n(a):  l = sqrt(|v|^2 - offset^2),  a = atan2(v_y, v_x) - atan2(offset, l)
        distance2 = v.dot(v)
        square = distance2.value - offset.value**2
        if distance2.value <= self.least**2:
            raise CannotAnswer(NO_DIRECTION)
        if square <= 0.0:
            raise CannotAnswer(
                Message(
                    "the circles overlap: their centres are {apart:.6g} m apart, their "
                    "tangent needs more than {least:.6g} m",
                    apart=math.sqrt(distance2.value),
                    least=abs(offset.value),
                )
            )
        length = cast("Jet", function_of("sqrt", distance2 - offset * offset))
        angle = arc_tangent(v.y, v.x)
        if offset.value != 0.0 or not offset.is_constant:
            angle = angle - arc_tangent(offset, length)
        branch = self._measure, self._n_tangents
        self._n_tangents += 1
        turns = round((self.angles.get(branch, angle.value) - angle.value) / math.tau)
        angle = angle + math.tau * turns
        self.angles[branch] = angle.value
        return length, angle
