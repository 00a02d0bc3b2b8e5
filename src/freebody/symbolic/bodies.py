"""How bodies are placed, how they move and what momentum they carry: the questions in which plane and space differ.

The parts of a model ask the bodies. Along the slots of a body stand the velocity of its mass centre and its angular
velocity; with M its mass matrix along them, what loads and reactions have to bring about is

    d(M V)/dt = M A + what the rotation of the axes adds.

In the plane V = (dx/dt, dy/dt, d theta/dt), M = diag(m, m, I), and nothing is added.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable, Collection, Mapping
from typing import Any

from freebody.language.expression import Expr
from freebody.measures.angle import Angle
from freebody.measures.base import Measure
from freebody.measures.displacement import Displacement
from freebody.measures.geometry import GROUND, RIGHT, UP, Point, Pose
from freebody.measures.geometry import ZERO as NOTHING
from freebody.model.elements import RigidBody
from freebody.symbolic.functions import cos_sin
from freebody.symbolic.geometry import AnyPose, FieldGeometry, Tangent, straight_tangent
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.sample import Sample
from freebody.symbolic.unknowns import BODY_ANGLE, POSITION, ModelUnknowns
from freebody.system.system import System

Parts = tuple[Ratio, ...]  # along the slots of a body
ElementMap = Callable[[Ratio], Ratio]
IsNegative = Callable[[Ratio], bool]


class Bodies(ABC):
    """The bodies of a system, placed in absolute coordinates."""

    slots: tuple[str, ...]  # of a body: its velocity, its angular velocity
    n_places: int  # of these, for a particle

    def __init__(self, system: System, unknowns: ModelUnknowns) -> None:
        self.system, self.unknowns = system, unknowns
        self.field = unknowns.field
        self.poses: dict[str, AnyPose] = {}

    # -- angles that bodies are turned by -----------------------------------------------------
    @property
    def angle_names(self) -> Collection[str]:
        """Measures that are unknowns from the beginning."""
        return ()

    @property
    def rows_by_construction(self) -> Collection[str]:
        """Held rows that the choice of angles holds already."""
        return ()

    def angle_of(self, measure: Measure) -> Ratio | None:
        """The unknown that an angle is by construction, rather than the arc of its cosine and sine."""
        return None

    def really_redundant(self, rows: list[str]) -> list[str]:
        """The rows that follow from others, without those that the choice of angles holds."""
        return rows

    @property
    def singular_poses(self) -> tuple[str, ...]:
        """Where angles are not determined, in words."""
        return ()

    def unfollowed_turns(self, body: str) -> Parts:
        """Of a body that turns without being turned in its pose: the unknowns of which its rotation has the rates."""
        return ()

    # -- poses --------------------------------------------------------------------------------
    @abstractmethod
    def geometry(
        self, poses: Mapping[str, AnyPose], tangent: Tangent, root: ElementMap | None, is_negative: IsNegative
    ) -> FieldGeometry:
        """The statements of measures over poses."""

    @abstractmethod
    def expressed(self, pose: AnyPose, express: ElementMap) -> AnyPose:
        """A pose with every element of it expressed by others."""

    @abstractmethod
    def add_numbers(self, values: dict[int, Any], sample: Sample) -> None:
        """The numbers of the absolute coordinates at a sample, and of their speeds where it tells them."""

    # -- motion -------------------------------------------------------------------------------
    @abstractmethod
    def velocities(self, poses: Mapping[str, AnyPose], express: ElementMap, rate: ElementMap) -> dict[str, Parts]:
        """Velocity of the mass centre and angular velocity of every body, along its slots."""

    @abstractmethod
    def inertia(self, body: RigidBody, scalar: Callable[[Expr], Ratio]) -> Parts:
        """The entries of the mass matrix of a body."""

    @abstractmethod
    def momentum(self, inertia: Parts, velocity: Parts) -> Parts:
        """The mass matrix of a body times a velocity of its, along its slots."""

    @abstractmethod
    def turning_momentum(self, inertia: Parts, velocity: Parts) -> Parts:
        """What the rate of a body's momentum has beside mass times acceleration."""


class PlanarBodies(Bodies):
    """Bodies in the plane: x, y and the angle theta of each, counter-clockwise positive."""

    slots = ("x", "y", "angle")
    n_places = 2

    def __init__(self, system: System, unknowns: ModelUnknowns) -> None:
        super().__init__(system, unknowns)
        for k, body in enumerate(system.bodies.values()):
            if not body.fixed:
                self.poses[body.name] = self._moving(k, body)
        constants = FieldGeometry(self.field, unknowns.parameters, {}, straight_tangent(self.field, None))
        for body in system.bodies.values():
            if body.fixed and body.name != GROUND:
                self.poses[body.name] = self._fixed(body, constants.scalar)

    def _moving(self, k: int, body: RigidBody) -> Pose[Ratio]:
        f, unknowns = self.field, self.unknowns
        x = unknowns.new(f"x_{body.name}", (POSITION, -k))
        y = unknowns.new(f"y_{body.name}", (POSITION, -k))
        origin = Point(GROUND, (NOTHING, NOTHING))
        unknowns.measures[f.index(x)] = Displacement(body.mass_center, origin, RIGHT)
        unknowns.measures[f.index(y)] = Displacement(body.mass_center, origin, UP)
        unknowns.join(x, y)
        if not body.turns:
            return Pose(x, y, f.zero, f.one, f.zero)
        is_put = body.start.angle is not None  # rather a coordinate: its start needs no solving of loops
        rank = BODY_ANGLE, is_put * len(self.system.bodies) - k
        angle = unknowns.new(f"theta_{body.name}", rank, is_angle=True)
        unknowns.measures[f.index(angle)] = Angle(body.name)
        return Pose(x, y, angle, *cos_sin(f, angle))

    def _fixed(self, body: RigidBody, scalar: Callable[[Expr], Ratio]) -> Pose[Ratio]:
        zero = self.field.zero
        angle = zero if body.start.angle is None else scalar(body.start.angle)
        c, s = cos_sin(self.field, angle)
        px = py = zero
        if body.start.at is not None:
            point, (ax, ay) = body.start.at
            rx, ry = (scalar(e) for e in body.points[point])
            px, py = scalar(ax) - (c * rx - s * ry), scalar(ay) - (s * rx + c * ry)
        return Pose(px, py, angle, c, s)

    def geometry(
        self, poses: Mapping[str, AnyPose], tangent: Tangent, root: ElementMap | None, is_negative: IsNegative
    ) -> FieldGeometry:
        return FieldGeometry(self.field, self.unknowns.parameters, poses, tangent)

    def expressed(self, pose: AnyPose, express: ElementMap) -> AnyPose:
        assert isinstance(pose, Pose)
        return Pose(*(express(v) for v in (pose.x, pose.y, pose.angle, pose.cos, pose.sin)))

    def add_numbers(self, values: dict[int, Any], sample: Sample) -> None:
        for body, place in sample.poses.items():
            motion = sample.velocities.get(body, ())
            for k, element in enumerate(coordinates_of(self.poses[body])):
                if element.generators():
                    index = self.field.index(element)
                    values[index] = place[k]
                    if motion:
                        values[self.unknowns.speeds[index]] = motion[k]

    def velocities(self, poses: Mapping[str, AnyPose], express: ElementMap, rate: ElementMap) -> dict[str, Parts]:
        found: dict[str, Parts] = {}
        for b in self.system.all_moving:
            x, y, angle = coordinates_of(poses[b.name])
            found[b.name] = rate(x), rate(y), rate(angle)
        return found

    def inertia(self, body: RigidBody, scalar: Callable[[Expr], Ratio]) -> Parts:
        """Mass twice, then the moment of inertia."""
        mass = scalar(body.mass)
        return mass, mass, scalar(body.inertia)

    def momentum(self, inertia: Parts, velocity: Parts) -> Parts:
        return tuple(m * v for m, v in zip(inertia, velocity, strict=True))

    def turning_momentum(self, inertia: Parts, velocity: Parts) -> Parts:
        return (self.field.zero,) * len(self.slots)


def coordinates_of(pose: AnyPose) -> tuple[Ratio, Ratio, Ratio]:
    """x, y and angle of a pose in the plane."""
    assert isinstance(pose, Pose)
    return pose.x, pose.y, pose.angle
