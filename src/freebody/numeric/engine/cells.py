"""How bodies stand in the arrays of the engine, in the plane and in space.

Poses and velocities are cells of three numbers. In the plane a body is one cell: x, y of the mass centre [m] and the
angle [rad]. In space it is two: x, y, z, and the rotation, whose velocities are the angular velocity along the
principal axes of inertia, so that the matrix of masses is diagonal and constant. Points and directions of a body in
space are packed by components along these axes; of a fixed body, along those of the ground.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any, ClassVar, Protocol

import numpy as np
from numpy.typing import NDArray

from freebody.language.expression import Expr
from freebody.measures.geometry import GROUND, Direction, Point
from freebody.model.elements import RigidBody
from freebody.numeric.kernels import measures_planar, measures_spatial
from freebody.numeric.kernels.measures_planar import Kind
from freebody.numeric.numbers import Numbers

Floats = NDArray[np.float64]
Components = tuple[float, ...]


@dataclass(frozen=True)
class KindsOfMeasure:
    """The kernels of the plane, or of space."""

    width: int  # cells of a body
    kinds: tuple[Kind, ...]
    max_bodies: int
    max_numbers: int
    fill: Callable[[Any, Any, Any, Any], None]


PLANE = KindsOfMeasure(
    1, measures_planar.KINDS, measures_planar.MAX_BODIES, measures_planar.MAX_NUMBERS, measures_planar.fill
)
SPACE = KindsOfMeasure(
    2, measures_spatial.KINDS, measures_spatial.MAX_BODIES, measures_spatial.MAX_NUMBERS, measures_spatial.fill
)


class Cells(Protocol):
    """What packing asks of bodies. Numbers of a fixed body are along the axes of the ground."""

    measures: ClassVar[KindsOfMeasure]

    def point(self, point: Point) -> Components:
        """Components of a point as kernels take it."""
        ...

    def direction(self, direction: Direction) -> Components:
        """Components of a direction as kernels take it."""
        ...

    def axes(self, body: str) -> Components:
        """What kernels need to know of a body whose axes a measure reads."""
        ...

    def fixed_angle(self, body: str) -> float:
        """What the angle of a fixed body is, where kernels take it to be zero [rad]."""
        ...

    def masses(self, body: RigidBody) -> tuple[list[float], list[bool]]:
        """By coordinate the mass or moment of inertia, and whether the body has that freedom."""
        ...

    def sizes(self, mass: float, length: float) -> list[float]:
        """Masses and moments of inertia of a typical body, by coordinate."""
        ...

    def gyration(self, body: RigidBody) -> Sequence[Components]:
        """Differences of the principal moments, by which a turning body resists; nothing in the plane."""
        ...


@dataclass(frozen=True)
class PlaneCells:
    """Bodies of the plane."""

    numbers: Numbers
    moving: frozenset[str]
    measures: ClassVar[KindsOfMeasure] = PLANE

    def point(self, point: Point) -> Components:
        x, y = (self.numbers.number(c) for c in point.offset)
        if point.body in self.moving:
            return x, y
        gx, gy, c, s = self.numbers.fixed_pose(point.body)
        return gx + c * x - s * y, gy + s * x + c * y

    def direction(self, direction: Direction) -> Components:
        x, y = (self.numbers.number(c) for c in direction.components)
        if direction.body in self.moving:
            return x, y
        _x, _y, c, s = self.numbers.fixed_pose(direction.body)
        return c * x - s * y, s * x + c * y

    def axes(self, body: str) -> Components:
        return ()

    def fixed_angle(self, body: str) -> float:
        return self.numbers.fixed_angle(body)

    def masses(self, body: RigidBody) -> tuple[list[float], list[bool]]:
        mass = self.numbers.number(body.mass)
        return [mass, mass, self.numbers.number(body.inertia) if body.turns else 0.0], [True, True, body.turns]

    def sizes(self, mass: float, length: float) -> list[float]:
        return [mass, mass, mass * length**2]

    def gyration(self, body: RigidBody) -> Sequence[Components]:
        return ()


@dataclass(frozen=True)
class SpaceCells:
    """Bodies of space."""

    numbers: Numbers
    moving: frozenset[str]
    measures: ClassVar[KindsOfMeasure] = SPACE

    def point(self, point: Point) -> Components:
        offset = self._vector(point.offset)
        if point.body in self.moving:
            return _components(self._principal(point.body).T @ offset)
        r, R = self._fixed(point.body)
        return _components(r + R @ offset)

    def direction(self, direction: Direction) -> Components:
        along = self._vector(direction.components)
        if direction.body in self.moving:
            return _components(self._principal(direction.body).T @ along)
        return _components(self._fixed(direction.body)[1] @ along)

    def axes(self, body: str) -> Components:
        return _components(self._principal(body) if body in self.moving else self._fixed(body)[1].T)

    def fixed_angle(self, body: str) -> float:
        return 0.0

    def masses(self, body: RigidBody) -> tuple[list[float], list[bool]]:
        mass = self.numbers.number(body.mass)
        moments = self.numbers.moments(body.name) if body.turns else (0.0, 0.0, 0.0)
        return [mass, mass, mass, *moments], [True] * 3 + [body.turns] * 3

    def sizes(self, mass: float, length: float) -> list[float]:
        return [mass] * 3 + [mass * length**2] * 3

    def gyration(self, body: RigidBody) -> Sequence[Components]:
        i1, i2, i3 = self.numbers.moments(body.name) if body.turns else (0.0, 0.0, 0.0)
        return [(i3 - i2, i1 - i3, i2 - i1)]

    def _vector(self, components: Sequence[Expr]) -> Floats:
        """Directions of the plane are directions of space."""
        known = [self.numbers.number(c) for c in components]
        return np.array(known + [0.0] * (3 - len(known)))

    def _principal(self, body: str) -> Floats:
        """Principal axes of inertia, as columns, by components along the body's own axes."""
        return np.asarray(self.numbers.principal(body))

    def _fixed(self, body: str) -> tuple[Floats, Floats]:
        if body == GROUND:
            return np.zeros(3), np.eye(3)
        r, R = self.numbers.fixed_frame(body)
        return np.asarray(r), np.asarray(R)


def cells_of(numbers: Numbers) -> Cells:
    """How the bodies of a system stand in arrays."""
    moving = frozenset(body.name for body in numbers.system.all_moving)
    return SpaceCells(numbers, moving) if numbers.system.space else PlaneCells(numbers, moving)


def _components(array: Floats) -> Components:
    return tuple(float(x) + 0.0 for x in array.ravel())
