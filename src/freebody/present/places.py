"""Points and directions of a system as numbers."""

from __future__ import annotations

from collections.abc import Callable

from freebody.language.expression import Expr
from freebody.measures.geometry import Direction, Point
from freebody.numeric.start import start_pose
from freebody.present.figures import GROUND, Heading, Place, turned
from freebody.system.system import System


class Places:
    """Turns points and directions of bodies into numbers and indices; what is fixed is taken to the ground."""

    def __init__(self, system: System, number: Callable[[Expr], float]) -> None:
        self.number = number
        self.index = {body.name: k for k, body in enumerate(system.moving)}
        self.fixed = {b.name: start_pose(system, b, number) for b in system.bodies.values() if b.fixed}

    def place(self, point: Point) -> Place:
        x, y = map(self.number, point.offset)
        if point.body in self.index:
            return Place(self.index[point.body], x, y)
        cx, cy, angle = self.fixed[point.body]
        dx, dy = turned(angle, x, y)
        return Place(GROUND, float(cx + dx), float(cy + dy))

    def heading(self, direction: Direction) -> Heading:
        x, y = map(self.number, direction.components)
        if direction.body in self.index:
            return Heading(self.index[direction.body], x, y)
        dx, dy = turned(self.fixed[direction.body][2], x, y)
        return Heading(GROUND, float(dx), float(dy))
