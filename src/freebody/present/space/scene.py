"""What to draw of a system in space: its bodies by their forms, and what joins and pushes them."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from freebody.language.expression import ZERO, Expr
from freebody.measures.geometry import GROUND, Components, Direction, Point
from freebody.model.elements import RigidBody
from freebody.numeric.rotation import matrix
from freebody.numeric.start import start_pose
from freebody.present.figures import Array
from freebody.present.space.figures import Form, Heading, Place, Poses, Ties, Triple
from freebody.present.space.ties import read_ties
from freebody.system.system import System


@dataclass(frozen=True)
class Scene:
    """The bodies of a system and what joins them, in numbers [m, rad]; lengths that depend on time are those at t = 0.

    up: (3,) the vertical; gravity: (3,) its direction, if there is any; fixed: centres (n_fixed, 3) and axes
    (n_fixed, 3, 3) of the bodies that stand still, the ground last."""

    title: str
    names: tuple[str, ...]  # of the moving bodies, in the order of the poses
    up: Array
    gravity: Array | None
    fixed: tuple[Array, Array]
    forms: tuple[Form, ...]
    ties: Ties

    @classmethod
    def of(cls, system: System, number: Callable[[Expr], float]) -> Scene:
        """What to draw of a system in space whose expressions have the values `number` (such as `Reference.number`)."""
        places = Places(system, number)
        ties, gravity, wheels = read_ties(system, places)
        moving = {body.name: k for k, body in enumerate(system.moving)}
        forms = [
            _form(body, k, places, is_toothed=body.name in wheels)
            for k, body in enumerate(body for body in system.bodies.values() if body.name != GROUND)
        ]
        up = np.array([number(c) for c in system.up])
        return cls(system.title, tuple(moving), up, gravity, places.fixed, tuple(forms), ties)

    @property
    def ground(self) -> int:
        """The index of the ground."""
        return len(self.names) + len(self.fixed[0]) - 1

    def is_fixed(self, index: int) -> bool:
        return index >= len(self.names)

    def poses(self, centers: Array, axes: Array) -> Poses:
        """Those of all bodies, from those of the moving ones: centers (n_times, n_moving, 3) [m], axes
        (n_times, n_moving, 3, 3) with the bodies' axes as columns."""
        n, moving = len(centers), len(self.names)
        centers, axes = centers.reshape(n, moving, 3), axes.reshape(n, moving, 3, 3)  # also where nothing moves
        still = [np.broadcast_to(part, (n, *part.shape)) for part in self.fixed]
        return Poses(np.concatenate((centers, still[0]), axis=1), np.concatenate((axes, still[1]), axis=1))


class Places:
    """Turns points and directions of bodies into numbers and indices."""

    def __init__(self, system: System, number: Callable[[Expr], float]) -> None:
        self.number = number
        still = [body for body in system.bodies.values() if body.fixed and body.name != GROUND]
        order = [*(body.name for body in system.moving), *(body.name for body in still), GROUND]
        self.index = {name: k for k, name in enumerate(order)}
        poses = [start_pose(system, body, number) for body in still]
        centers = [np.array(pose[:3]) for pose in poses]
        axes = [matrix(np.array(pose[3:])) for pose in poses]
        self.fixed = np.array([*centers, np.zeros(3)]), np.array([*axes, np.eye(3)])

    def vector(self, components: Components) -> Triple:
        x, y, *rest = (self.number(c) for c in components)
        return x, y, rest[0] if rest else 0.0

    def place(self, point: Point) -> Place:
        return Place(self.index[point.body], self.vector(point.offset))

    def heading(self, direction: Direction) -> Heading:
        return Heading(self.index[direction.body], self.vector(direction.components))


def _form(body: RigidBody, number: int, places: Places, *, is_toothed: bool) -> Form:
    points = {name: places.vector(offset) for name, offset in body.points.items()}
    return Form(
        body.name,
        places.index[body.name],
        number,
        body.solid,
        tuple(places.number(size) for size in body.sizes),
        places.vector(body.axis) if body.axis else None,
        points[body.default_point],
        points,
        tuple(points[name] for name in body.corners),
        is_particle=not body.turns,
        has_mass=body.mass != ZERO,
        is_toothed=is_toothed,
    )
