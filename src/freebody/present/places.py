"""Points and directions of a system as numbers."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from freebody.language.expression import Expr
from freebody.measures.geometry import GROUND as GROUND_NAME
from freebody.measures.geometry import Components, Direction, Point
from freebody.numeric.described import start_pose
from freebody.numeric.rotation import matrix
from freebody.present.figures import GROUND, Array, Heading, Place, Triple, turned
from freebody.system.system import System


class Places:
    """Turns points and directions of bodies into numbers and indices. In the plane what is fixed is taken to the
    ground; in space it keeps its own axes: `fixed` are the centres (n, 3) and axes (n, 3, 3), the ground last."""

    def __init__(self, system: System, number: Callable[[Expr], float]) -> None:
        self.system, self.number = system, number
        self.is_spatial = system.space
        still = [body for body in system.bodies.values() if body.fixed]
        self.poses = {body.name: start_pose(system, body, number) for body in still}
        if system.space:
            still = sorted(still, key=lambda body: body.name == GROUND_NAME)
            order = [*system.moving, *still]
            self.index = {body.name: k for k, body in enumerate(order)}
            centers = [np.array(self.poses[body.name][:3]) for body in still]
            axes = [matrix(np.array(self.poses[body.name][3:])) for body in still]
            self.fixed: tuple[Array, Array] = np.array(centers), np.array(axes)
        else:
            self.index = {body.name: k for k, body in enumerate(system.moving)}
            self.fixed = np.zeros((1, 3)), np.eye(3)[None]

    def vector(self, components: Components) -> Triple:
        x, y, *rest = (self.number(c) for c in components)
        return x, y, rest[0] if rest else 0.0

    def place(self, point: Point) -> Place:
        x, y, z = self.vector(point.offset)
        if point.body in self.index:
            return Place(self.index[point.body], x, y, z)
        cx, cy, angle = self.poses[point.body]
        dx, dy = turned(angle, x, y)
        return Place(GROUND, float(cx + dx), float(cy + dy))

    def heading(self, direction: Direction) -> Heading:
        x, y, z = self.vector(direction.components)
        if direction.body in self.index:
            return Heading(self.index[direction.body], x, y, z)
        dx, dy = turned(self.poses[direction.body][2], x, y)
        return Heading(GROUND, float(dx), float(dy))

    def at_start(self, heading: Heading) -> Array:
        """(2,) a heading of the plane in the axes of the ground, where its body starts or is said to be near."""
        if heading.body == GROUND:
            return np.array(heading.xy)
        body = self.system.moving[heading.body]
        return turned(start_pose(self.system, body, self.number)[2], *heading.xy)
