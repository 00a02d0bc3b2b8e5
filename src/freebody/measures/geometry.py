"""What the statement of a measure may use: poses, points, directions and a little arithmetic.

A statement is written once, over a `Geometry[S]`. The symbolic route supplies one whose scalars are
elements of a field, the numeric route one whose scalars carry derivatives; so the gradient, the rate and the
acceleration of every measure follow from the same few lines.

Planar convention: x right, y up, angles counter-clockwise. A pose is that of the body's mass centre.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Generic, Protocol, Self, TypeVar

from freebody.language.expression import Expr, Number, number

GROUND = "ground"
ZERO: Expr = number(0)
ONE: Expr = number(1)


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


@dataclass(frozen=True)
class Vector(Generic[S]):
    """A vector in the plane, by its ground components."""

    x: S
    y: S

    def __add__(self, other: Vector[S]) -> Vector[S]:
        return Vector(self.x + other.x, self.y + other.y)

    def __sub__(self, other: Vector[S]) -> Vector[S]:
        return Vector(self.x - other.x, self.y - other.y)

    def dot(self, other: Vector[S]) -> S:
        return self.x * other.x + self.y * other.y

    def cross(self, other: Vector[S]) -> S:
        """Out-of-plane component, positive counter-clockwise."""
        return self.x * other.y - self.y * other.x


@dataclass(frozen=True)
class Pose(Generic[S]):
    """Where a body is: its mass centre, its angle, and the cosine and sine of that angle."""

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


@dataclass(frozen=True)
class Point:
    """A point fixed in a body, by its body components from the mass centre [m]."""

    body: str
    offset: tuple[Expr, Expr] = (ZERO, ZERO)
    name: str = ""

    def __str__(self) -> str:
        return self.name or self.body


@dataclass(frozen=True)
class Direction:
    """A unit vector fixed in a body (or the ground), by its components there."""

    body: str
    components: tuple[Expr, Expr]
    name: str = ""

    def normal(self) -> Direction:
        """The direction a quarter turn counter-clockwise from this one."""
        x, y = self.components
        name = f"normal of {self.name}" if self.name else ""
        return Direction(self.body, (_negative(y), x), name)

    def reversed(self) -> Direction:
        x, y = self.components
        return Direction(self.body, (_negative(x), _negative(y)), f"against {self.name}")


def _negative(e: Expr) -> Expr:
    return Number(-e.value) if isinstance(e, Number) else -e


RIGHT = Direction(GROUND, (ONE, ZERO), "right")
UP = Direction(GROUND, (ZERO, ONE), "up")
LEFT = Direction(GROUND, (number(-1), ZERO), "left")
DOWN = Direction(GROUND, (ZERO, number(-1)), "down")
COMPASS = {"right": RIGHT, "up": UP, "left": LEFT, "down": DOWN, "x": RIGHT, "y": UP}


class Geometry(Protocol[S]):
    """What a route supplies to evaluate statements."""

    def scalar(self, expr: Expr) -> S:
        """Value of an expression in the parameters (and time)."""
        ...

    def pose(self, body: str) -> Pose[S]:
        """Pose of a body's mass centre; the ground's is zero."""
        ...

    def tangent(self, v: Vector[S], offset: S) -> tuple[S, S]:
        """Length l >= 0 and angle a with v = l e(a) + offset n(a), e(a) = (cos a, sin a), n = e turned by
        a quarter turn: polar coordinates of v when the offset is 0, the common tangent of two circles
        otherwise. The angle is continuous in the motion."""
        ...

    def apply(self, expr: Expr, values: dict[str, S]) -> S:
        """Value of an expression in which names stand for the given scalars, else for parameters."""
        ...


def position(g: Geometry[S], point: Point) -> Vector[S]:
    """Ground position of a body point."""
    x, y = point.offset
    return g.pose(point.body).place(Vector(g.scalar(x), g.scalar(y)))


def unit(g: Geometry[S], direction: Direction) -> Vector[S]:
    """Ground components of a direction."""
    x, y = direction.components
    return g.pose(direction.body).turn(Vector(g.scalar(x), g.scalar(y)))
