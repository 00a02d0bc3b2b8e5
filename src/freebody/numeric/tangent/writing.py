"""What stands in the equations of motion, written over poses, velocities, accelerations and the names that vary.

A parameter that varies is an input here, as the entries of a state are, and so is where a measure counts from: what is
written can be differentiated by all of them.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from typing import Any

import numpy as np

from freebody.errors import CannotAnswer
from freebody.language.expression import Expr, free_symbols, has_jump
from freebody.language.sentences import Message
from freebody.measures.base import Measure
from freebody.measures.geometry import GROUND, Pose, Vector
from freebody.model.elements import RATE, VALUE, AppliedLoad, NonholonomicForm, RigidBody
from freebody.numeric.engine.operations import ProgramNode
from freebody.numeric.engine.programs import Writer
from freebody.numeric.jets import Array
from freebody.numeric.kernels.operations import ARGUMENT, COS, INPUT, SIN
from freebody.numeric.system import NumericSystem
from freebody.numeric.tangent.gradients import Gradient, gradient


class TangentWriter(Writer):
    """Writes what a system in numbers states, as operations of which some inputs are parameters."""

    def __init__(self, reference: NumericSystem, names: Sequence[str]) -> None:
        super().__init__(reference.numbers(), lambda measure: reference.frame.number(measure), lambda _measure: None)
        self.reference, self.varied = reference, tuple(names)
        n = self.n_coordinates
        self._first_acceleration = 2 * n + 1 + (4 * len(self._bodies) if reference.system.space else 0)
        self._n_inputs = self._first_acceleration + n
        self._gradients: dict[int, Gradient] = {}  # by operation
        self._speeds: dict[int, ProgramNode] = {}
        self.parameters = [self.new_input() for _ in names]
        self._names |= {name: self.node(INPUT, entry) for name, entry in zip(names, self.parameters, strict=True)}
        self.origins: dict[int, tuple[int, Measure]] = {}  # by number of a measure: the input that it counts from
        # coordinates: where each stands among poses (and velocities); a body in space turns by angles of its own
        self.entries = [
            self.width * k + i
            for k, columns in enumerate(reference.frame.columns.values())
            for i in range(len(columns))
        ]

    def new_input(self) -> int:
        """A further input."""
        self._n_inputs += 1
        return self._n_inputs - 1

    def angles(self) -> list[int]:
        """The operations that are angles of lines."""
        return [k for k in range(self.n_operations) if self.operation(k)[0] == ARGUMENT]

    def input(self, entry: int) -> ProgramNode:
        return self.node(INPUT, entry)

    def named(self, values: Mapping[str, ProgramNode]) -> None:
        """Names that stand for nodes from now on."""
        self._names |= values

    # -- coordinates --------------------------------------------------------------------------
    def velocity(self, entry: int) -> int:
        return self.n_coordinates + entry

    def acceleration(self, entry: int) -> int:
        return self._first_acceleration + entry

    def speed(self, entry: int) -> ProgramNode:
        if entry not in self._speeds:
            self._speeds[entry] = self._speed(entry)
        return self._speeds[entry]

    def _speed(self, entry: int) -> ProgramNode:
        n = self.n_coordinates
        if n <= entry < 2 * n:
            return self.input(self.acceleration(entry - n))
        return self.constant(0.0) if entry >= self._first_acceleration else super().speed(entry)

    def gradient(self, node: ProgramNode) -> Gradient:
        """The derivatives of a node by all inputs that are in it."""
        known = self._gradients.get(node.at)
        if known is None:
            known = self._gradients[node.at] = gradient(self, node)
        return known

    def by_velocities(self, node: ProgramNode) -> list[ProgramNode | None]:
        """The derivatives by the velocities of all coordinates; None: zero."""
        found = self.gradient(node)
        return [found.get(self.velocity(entry)) for entry in self.entries]

    def by_place(self, found: Gradient, entry: int) -> ProgramNode | None:
        """Of a gradient the derivative by one coordinate: a place, an angle, or a turn about an axis of a body."""
        place = entry % self.width
        if not self.numbers.space or place < 3:
            return found.get(entry)
        first = 2 * self.n_coordinates + 1 + 4 * (entry // self.width)
        total: ProgramNode | None = None
        for i in range(4):
            if first + i in found:
                part = found[first + i] * self.gradient(self.speed(first + i))[self.velocity(entry)]
                total = part if total is None else total + part
        return total

    def axes(self, body: str) -> tuple[Vector[ProgramNode], ...]:
        """The axes along which the angular velocity of a body in space is given, by components of the ground."""
        return self._frame(self._bodies[body][0])

    # -- measures and loads -------------------------------------------------------------------
    def value(self, measure: Measure) -> ProgramNode:
        """The value of a measure, counted from where it counts from."""
        node = self._of(measure)
        return node - self.origin(measure) if measure.incremental else node

    def raw(self, measure: Measure) -> ProgramNode:
        """The statement of a measure alone."""
        return self._of(measure)

    def rate(self, measure: Measure | NonholonomicForm) -> ProgramNode:
        return self._rate_of(measure)

    def origin(self, measure: Measure) -> ProgramNode:
        number = self.reference.frame.number(measure)
        if number not in self.origins:
            self.origins[number] = self.new_input(), measure
        return self.input(self.origins[number][0])

    def law(self, push: AppliedLoad) -> ProgramNode:
        """The generalized force of a load."""
        refuse_jumps(push.name, push.law)
        needed = free_symbols(push.law)
        names: dict[str, Any] = {}
        if {VALUE.name, RATE.name} & needed:
            names[RATE.name] = self.rate(push.measure)
            if not isinstance(push.measure, NonholonomicForm):
                names[VALUE.name] = self.value(push.measure)
        for name, other in push.measures:
            names[name], names[f"rate({name})"] = self.raw(other), self.rate(other)
        try:
            return self.apply(push.law, names)
        except KeyError as error:
            raise CannotAnswer(
                Message("the law of {load} has no derivative here: {what}", load=push.name, what=str(error))
            ) from error

    def inertia(self, body: RigidBody) -> list[list[ProgramNode]]:
        """(3, 3) the moments of inertia of a body in space along the axes in which its angular velocity is given."""
        xx, yy, zz, xy, xz, yz = (self.scalar(e) for e in body.tensor)
        tensor = [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]]
        P = np.asarray(self.numbers.principal(body.name))
        return [[self._quadratic(tensor, P[:, i], P[:, j]) for j in range(3)] for i in range(3)]

    def _quadratic(self, tensor: list[list[ProgramNode]], a: Any, b: Any) -> ProgramNode:
        total = self.constant(0.0)
        for i in range(3):
            for j in range(3):
                total = total + float(a[i] * b[j]) * tensor[i][j]
        return total

    # -- numbers ------------------------------------------------------------------------------
    def inputs(self, states: Array) -> dict[int, Array | float]:
        """What expressions read at some states (n, n_y): their entries, the names that vary, and where measures count
        from."""
        found: dict[int, Array | float] = {i: states[:, i] for i in range(self._first_acceleration)}
        found |= {entry: self.numbers.values[name] for entry, name in zip(self.parameters, self.varied, strict=True)}
        return found | {entry: self.numbers.start_value(measure) for entry, measure in self.origins.values()}

    # -- fixed bodies -------------------------------------------------------------------------
    def _in_plane(self, body: str) -> Pose[ProgramNode]:
        if body in self._bodies or body == GROUND or not self._depends(self.reference.system.bodies[body]):
            return super()._in_plane(body)
        of = self.reference.system.bodies[body]
        theta = self.constant(0.0) if of.start.angle is None else self.scalar(of.start.angle)
        c, s = self.function(COS, theta), self.function(SIN, theta)
        x = y = self.constant(0.0)
        if of.start.at is not None:
            point, place = of.start.at
            px, py = (self.scalar(e) for e in of.points[point])
            x, y = (self.scalar(e) for e in place)
            x, y = x - (c * px - s * py), y - (s * px + c * py)
        return Pose(x, y, theta, c, s)

    def _in_space(self, body: str) -> Any:
        if body not in self._bodies and body != GROUND and self._depends(self.reference.system.bodies[body]):
            raise CannotAnswer(
                Message(
                    "{body} is fixed at a place that depends on a varied name: in space there is no exact "
                    "derivative for that",
                    body=body,
                )
            )
        return super()._in_space(body)

    def _depends(self, body: RigidBody) -> bool:
        start = body.start if body.start.near is None else body.start.with_guess()
        placed = () if start.at is None else (*start.at[1], *body.points[start.at[0]])
        turned = [turn.by for turn in start.turned or ()]
        return self.depends((*placed, *turned, *(() if start.angle is None else (start.angle,))))

    def depends(self, exprs: Iterable[Expr | None]) -> bool:
        """Whether a name that varies is in one of some expressions."""
        return any(free_symbols(e) & set(self.varied) for e in exprs if e is not None)


def refuse_jumps(name: str, law: Expr) -> None:
    """Raises CannotAnswer for a law that jumps: where it does, a motion has no derivative that follows from its law."""
    if has_jump(law, free_symbols(law)):
        raise CannotAnswer(Message("the law of {load} jumps, so the motion has no exact derivative", load=name))
