"""Vectors of a state by their ground components, as the kinds of questions share them.

A vector is a tuple (x, y) of ground components; in space three, or those along other axes.
"""

from __future__ import annotations

import re
from typing import TYPE_CHECKING, Any

from freebody.language.sentences import NOTHING, Argument, Message, Sentence
from freebody.measures.angle import Angle
from freebody.measures.displacement import Displacement
from freebody.measures.geometry import GROUND, ONE, RIGHT, UP, ZERO, Direction, Point
from freebody.model.noting import did_you_mean
from freebody.model.rotations import UNIT
from freebody.model.spins import spin
from freebody.model.state import State
from freebody.questions.base import Described, Path
from freebody.questions.forms import NAME

if TYPE_CHECKING:
    from freebody.model.names import Names

Vector = tuple[Any, ...]
# Of which bodies: None means all of them.
Group = str | tuple[str, ...] | None
Basis = tuple[Direction, Direction, Direction]  # the axes along which a vector of space is wanted
AXES = (RIGHT, UP, Direction(GROUND, (ZERO, ZERO, ONE), "z"))
ORIGIN = Point(GROUND, (ZERO, ZERO), "ground.origin")
GROUP = rf"{NAME}(?:(?:, | and ){NAME})*"  # bodies: cart and bob
IN_BASIS = rf"(?: (?:in|along the axes of) (?:the )?(?:frame |basis )?(?P<basis>{NAME}))?"


def read_group(names: Names, text: str | None, path: Path) -> Group:
    """The bodies of 'cart and bob'; None for the system."""
    if text is None or text == "system":
        return None
    bodies = tuple(names.body(word, *path).name for word in re.split(r", | and ", text))
    return bodies[0] if len(bodies) == 1 else bodies


def read_basis(names: Names, name: str | None, path: Path) -> Basis | None:
    """The axes of a body or of a frame."""
    if name is None or name == GROUND:
        return None
    if not names.space:
        names.problem(Message("a basis is for vectors of space: write space: true"), *path)
        return None
    if name not in names.bodies and name not in names.frames:
        known = [*names.bodies, *names.frames]
        told = Message("there is no body or frame {name}.{hint}", name=name, hint=did_you_mean(name, known))
        names.unknown(name, told, *path)
        return None
    x, y, z = (names.fixed_in(name, along, f"{name}.{axis}") for along, axis in zip(UNIT, "xyz", strict=True))
    return x, y, z


def has_name(along: Direction | None, basis: Basis | None = None) -> bool:
    """Whether sentences can say along what a vector is asked for."""
    return bool(along.name) if along is not None else basis is None or bool(basis[0].name)


def said_along(direction: Direction | None, basis: Basis | None = None) -> Argument:
    """'along up', 'along the axes of shaft'; nothing where none is asked for."""
    if direction is None:
        frame = basis and basis[0].name.rpartition(".")[0]  # of shaft.x
        return Sentence("what.along_axes", {"frame": frame}) if frame else NOTHING
    if direction.name in ("right", "up", "left", "down"):
        return Sentence(f"what.along_{direction.name}")
    return Sentence("what.along", {"direction": direction.name}) if direction.name else NOTHING


def said_relative(other: str) -> Argument:
    """'relative to crank'; nothing for the ground."""
    return NOTHING if other == GROUND else Sentence("what.relative", {"body": other})


def is_among(name: str, group: Group) -> bool:
    """Whether a body is one of those that are meant."""
    return group is None or name == group or (isinstance(group, tuple) and name in group)


def said_of(group: Group) -> Sentence:
    """'of cart and bob', 'of the system'"""
    if group is None:
        return Sentence("what.of_system")
    return Sentence("what.of", {"bodies": group if isinstance(group, tuple) else (group,)})


def axes_of(system: Described) -> tuple[Direction, ...]:
    """The axes of the ground."""
    return AXES if system.space else AXES[:2]


def place(system: Described, state: State[Any], point: Point, order: int = 0) -> Vector:
    """Position, velocity or acceleration of a point."""
    read = (state.value, state.rate, state.acceleration)[order]
    return tuple(read(Displacement(point, ORIGIN, axis)) for axis in axes_of(system))


def component(
    vector: Vector, along: Direction | None, size: bool, state: State[Any], basis: Basis | None = None
) -> Any:
    """A vector as it is asked for: its size, its part along a direction, or all of it, in a basis."""
    if size:
        return state.size(vector)
    if along is not None:
        return dot(vector, components_of(along, state, len(vector)))
    if basis is None:
        return vector
    return tuple(dot(vector, components_of(axis, state, len(vector))) for axis in basis)


def components_of(direction: Direction, state: State[Any], n: int) -> Vector:
    """Ground components of a direction."""
    tip, foot = Point(direction.body, direction.components), Point(direction.body, (ZERO, ZERO))
    return tuple(state.value(Displacement(tip, foot, axis)) for axis in AXES[:n])


def dot(a: Vector, b: Vector) -> Any:
    total: Any = 0
    for x, y in zip(a, b, strict=True):
        total = total + x * y
    return total


def cross(a: Vector, b: Vector) -> Vector:
    """The vector product in space, (its component out of) the plane otherwise."""
    if len(a) == 2:
        return (a[0] * b[1] - a[1] * b[0],)
    return tuple(a[j] * b[k] - a[k] * b[j] for j, k in ((1, 2), (2, 0), (0, 1)))


def added(a: Vector, b: Vector) -> Vector:
    return tuple(x + y for x, y in zip(a, b, strict=True))


def turning_rate(state: State[Any], body: str) -> Any:
    """The angular velocity of a body in the plane."""
    return state.rate(Angle(body))


def angular_velocity(system: Described, state: State[Any], body: str, axes: Basis) -> Vector:
    """Of a body of space against the ground, along given axes."""
    if system.bodies[body].fixed:
        return (0,) * len(axes)
    return tuple(state.rate(spin(body, axis)) for axis in axes)
