"""Where bodies are at the start by what the model says of them."""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np

from freebody.language.expression import Expr
from freebody.measures.geometry import GROUND, ONE, RIGHT, UP, ZERO, Direction
from freebody.model.elements import RigidBody, Start
from freebody.numeric import spatial
from freebody.numeric.jets import Array
from freebody.numeric.rotation import rotation_vector
from freebody.system.system import System

MIDDLE_ANGLE = 0.5  # where three named angles are far from their singular pose [rad]


_AXES = (RIGHT, UP, Direction(GROUND, (ZERO, ZERO, ONE), "z"))


def axes_of(system: System) -> tuple[Direction, ...]:
    """The axes of the ground."""
    return _AXES if system.space else _AXES[:2]


def start_pose(system: System, body: RigidBody, number: Callable[[Expr], float]) -> tuple[float, ...]:
    """Where a body is by its own `at` and `angle`, or is said to be near, zero where they say nothing: x, y and the
    angle; in space x, y, z and the rotation vector of its own axes."""
    start = body.start if body.start.near is None else body.start.with_guess()
    if system.space:
        return _start_in_space(system, body, start, number)
    theta = 0.0 if start.angle is None else number(start.angle)
    if start.at is None:
        return 0.0, 0.0, theta
    point, place = start.at
    px, py = (number(c) for c in body.points[point])
    x, y = (number(c) for c in place)
    c, s = math.cos(theta), math.sin(theta)
    return x - (c * px - s * py), y - (s * px + c * py), theta


def _start_in_space(
    system: System, body: RigidBody, start: Start, number: Callable[[Expr], float]
) -> tuple[float, ...]:
    R = _start_axes(system, body, start, number)
    center = np.zeros(3)
    if start.at is not None:
        point, place = start.at
        center = np.array([number(c) for c in place]) - R @ np.array([number(c) for c in body.points[point]])
    return (*map(float, center), *map(float, rotation_vector(R)))


def _start_axes(
    system: System, body: RigidBody, start: Start, number: Callable[[Expr], float], depth: int = 0
) -> Array:
    """The axes of a body in space at the start, as far as it is known: named angles have their start values, or else
    values where a chain of them is not singular."""
    if not body.chain:
        return spatial.turned_by(start.turned or (), {}, number)
    named = [turn.name for turn in body.chain if turn.name]
    guess = dict.fromkeys(named, 0.0)
    if len(named) == 3:
        guess[named[1]] = MIDDLE_ANGLE
    guess |= {name: number(system.all_start[name]) for name in named if name in system.all_start}
    frame = spatial.UNIT
    if body.frame != GROUND and depth < len(system.bodies):
        base = system.bodies[body.frame]
        own = base.start if base.start.near is None else base.start.with_guess()
        frame = _start_axes(system, base, own, number, depth + 1)
    return frame @ spatial.turned_by(body.chain, guess, number)
