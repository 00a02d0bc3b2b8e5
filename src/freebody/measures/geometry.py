"""What the statement of a measure may use: poses, points, directions and a little arithmetic.

A statement is written once, over a `Geometry[S]`. The symbolic route supplies one whose scalars are
elements of a field, the numeric route one whose scalars carry derivatives; so the gradient, the rate and the
acceleration of every measure follow from the same few lines.

Planar convention: x right, y up, angles counter-clockwise. In space z points towards the viewer, rotations are
right-handed. A pose is that of the body's mass centre.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, Generic, Protocol, Self, TypeVar

from freebody.language.expression import Expr, Number, number

GROUND = "ground"
ZERO: Expr = number(0)
ONE: Expr = number(1)
# of a distance, a bearing or the lead of a string between points in one place
NO_DIRECTION = "two points coincide, so the line between them has no direction"


class Scalar(Protocol):
    """The arithmetic that statements may use."""

    def __add__(self, other: Any, /) -> Self: ...
    def __radd__(self, other: Any, /) -> Self: ...
    def __sub__(self, other: Any, /) -> Self: ...
    def __rsub__(self, other: Any, /) -> Self: ...
    def __mul__(self, other: Any, /) -> Self: ...
    def __rmul__(self, other: Any, /) -> Self: ...
    def __truediv__(self, other: Any, /) -> Self: ...
    def __neg__(self) -> Self: ...


S = TypeVar("S", bound=Scalar)


Components = tuple[Expr, ...]  # two in the plane, three in space


# Vectors and poses are what evaluation makes by the million, so they are not frozen, which would double their cost;
# nobody changes one.
@dataclass(slots=True)
class Vector(Generic[S]):
    """A vector by its ground components; one in the plane has no z."""

    x: S
    y: S
    z: S | None = None

    def __add__(self, other: Vector[S]) -> Vector[S]:
        return Vector(self.x + other.x, self.y + other.y, _sum(self.z, other.z))

    def __sub__(self, other: Vector[S]) -> Vector[S]:
        return Vector(self.x - other.x, self.y - other.y, _sum(self.z, None if other.z is None else -other.z))

    def scaled(self, c: S) -> Vector[S]:
        return Vector(c * self.x, c * self.y, None if self.z is None else c * self.z)

    def dot(self, other: Vector[S]) -> S:
        plane = self.x * other.x + self.y * other.y
        return plane if self.z is None or other.z is None else plane + self.z * other.z

    def cross(self, other: Vector[S]) -> S:
        """Out-of-plane component, positive counter-clockwise."""
        return self.x * other.y - self.y * other.x


def _sum(a: S | None, b: S | None) -> S | None:
    if a is None or b is None:
        return b if a is None else a
    return a + b


@dataclass(slots=True)
class Pose(Generic[S]):
    """Where a body is in the plane: its mass centre, its angle, and the cosine and sine of that angle."""

    x: S
    y: S
    angle: S
    cos: S
    sin: S

    def turn(self, v: Vector[S]) -> Vector[S]:
        """Body components to ground components."""
        return Vector(self.cos * v.x - self.sin * v.y, self.sin * v.x + self.cos * v.y)

    def place(self, v: Vector[S]) -> Vector[S]:
        """Ground position of the body point with the given body components."""
        turned = self.turn(v)
        return Vector(self.x + turned.x, self.y + turned.y)


@dataclass(slots=True)
class SpatialPose(Generic[S]):
    """Where a body is in space: its mass centre, and its axes by their ground components (the columns of the rotation
    matrix)."""

    center: Vector[S]
    axes: tuple[Vector[S], Vector[S], Vector[S]]

    def turn(self, v: Vector[S]) -> Vector[S]:
        """Body components to ground components."""
        ex, ey, ez = self.axes
        plane = ex.scaled(v.x) + ey.scaled(v.y)
        return plane if v.z is None else plane + ez.scaled(v.z)

    def place(self, v: Vector[S]) -> Vector[S]:
        """Ground position of the body point with the given body components."""
        return self.center + self.turn(v)


@dataclass(frozen=True)
class Point:
    """A point fixed in a body, by its body components from the mass centre [m]."""

    body: str
    offset: Components = (ZERO, ZERO)
    name: str = ""

    def __str__(self) -> str:
        return self.name or self.body


@dataclass(frozen=True)
class Direction:
    """A unit vector fixed in a body (or the ground), by its components there."""

    body: str
    components: Components
    name: str = ""

    def normal(self) -> Direction:
        """The direction a quarter turn counter-clockwise from this one, in the plane of x and y."""
        x, y, *z = self.components
        name = f"normal of {self.name}" if self.name else ""
        return Direction(self.body, (_negative(y), x, *z), name)

    def reversed(self) -> Direction:
        return Direction(self.body, tuple(map(_negative, self.components)), f"against {self.name}")


def _negative(e: Expr) -> Expr:
    return Number(-e.value) if isinstance(e, Number) else -e


# the plane's; in space they mean the same directions
RIGHT = Direction(GROUND, (ONE, ZERO), "right")
UP = Direction(GROUND, (ZERO, ONE), "up")
LEFT = Direction(GROUND, (number(-1), ZERO), "left")
DOWN = Direction(GROUND, (ZERO, number(-1)), "down")
AXES = (RIGHT, UP, Direction(GROUND, (ZERO, ZERO, ONE), "z"))
COMPASS = {"right": RIGHT, "up": UP, "left": LEFT, "down": DOWN, "x": RIGHT, "y": UP}


class Geometry(Protocol[S]):
    """What a route supplies to evaluate statements."""

    def scalar(self, expr: Expr) -> S:
        """Value of an expression in the parameters (and time)."""
        ...

    def pose(self, body: str) -> Pose[S] | SpatialPose[S]:
        """Pose of a body's mass centre; the ground's is zero."""
        ...

    def root(self, x: S) -> S:
        """The square root of a sum of squares."""
        ...

    def tangent(self, v: Vector[S], offset: S) -> tuple[S, S]:
        """Length l >= 0 and angle a with v = l e(a) + offset n(a), e(a) = (cos a, sin a), n = e turned by
        a quarter turn: polar coordinates of v when the offset is 0, the common tangent of two circles
        otherwise. The angle is continuous in the motion."""
        ...

    def apply(self, expr: Expr, values: dict[str, S], *, here: bool = False) -> S:
        """Value of an expression in which names stand for the given scalars, else for parameters. here: a
        formula need hold only where what it takes the size of keeps its sign."""
        ...


def components(g: Geometry[S], exprs: Components) -> Vector[S]:
    """A vector of the given components."""
    return Vector(*map(g.scalar, exprs))


def position(g: Geometry[S], point: Point) -> Vector[S]:
    """Ground position of a body point."""
    return _remembered(g, point, lambda: g.pose(point.body).place(components(g, point.offset)))


def unit(g: Geometry[S], direction: Direction) -> Vector[S]:
    """Ground components of a direction."""
    return _remembered(g, direction, lambda: g.pose(direction.body).turn(components(g, direction.components)))


def _remembered(g: Geometry[S], what: Point | Direction, made: Callable[[], Vector[S]]) -> Vector[S]:
    """The rows of a connection ask for the same points: a geometry of one instant keeps them in its `memory`, if it has
    one; with `lasting` it makes those once that are the same at all instants."""
    memory: dict[int, tuple[object, Vector[S]]] | None = getattr(g, "memory", None)
    if memory is None:
        return made()
    known = memory.get(id(what))
    if known is None:
        lasting: Callable[[Point | Direction, Callable[[], Vector[S]]], Vector[S]] | None = getattr(g, "lasting", None)
        vector = made() if lasting is None else lasting(what, made)
        known = memory[id(what)] = what, vector  # kept with what it belongs to, so that the number stays its own
    return known[1]
