"""What the start of a model in space says about its coordinates: places and rotations that are given to its bodies."""

from __future__ import annotations

from collections.abc import Mapping
from contextlib import suppress

from freebody.errors import CannotAnswer
from freebody.measures.base import Measure
from freebody.measures.geometry import GROUND, SpatialPose, Vector
from freebody.model.elements import RigidBody
from freebody.symbolic.bodies import Bodies
from freebody.symbolic.geometry import AnyPose, FieldGeometry, straight_tangent
from freebody.symbolic.given_start import GivenStart
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.samples import Samples
from freebody.symbolic.spatial.bodies import SpatialBodies
from freebody.symbolic.start_pose import recognised
from freebody.symbolic.unknowns import Coordinate


class SpatialGivenStart(GivenStart):
    """The start values of a model in space."""

    def __init__(self, bodies: Bodies, samples: Samples, absolute: FieldGeometry) -> None:
        super().__init__(bodies, samples, absolute)
        assert isinstance(bodies, SpatialBodies)
        self._known_rotation = bodies.known_rotation
        self._scalar = self._geometry({}).scalar

    def of_coordinate(self, c: Coordinate) -> Ratio | None:
        measure = self.unknowns.measures.get(c.index)
        if measure is None:
            return None
        value = self._value(measure)
        return self._unturned(measure) if value is None else value

    def _value(self, measure: Measure) -> Ratio | None:
        """A measure at the start, if the places and rotations of its bodies that it takes are given."""
        poses = {name: self._pose(name) for name in measure.bodies() if name != GROUND}
        known = {name: pose for name, pose in poses.items() if pose is not None}
        if len(known) < len(poses):
            return None
        there = self._geometry(known)
        with suppress(CannotAnswer, ZeroDivisionError):
            value = measure.value(there)
            return None if self.unknowns.inside(value) else value  # of a place nobody gave
        return None

    def _unturned(self, measure: Measure) -> Ratio | None:
        """A measure at the start, where angles that nobody gives are multiples of a right angle at all samples."""
        poses = {name: self._pose(name) or self.bodies.poses[name] for name in measure.bodies() if name != GROUND}
        with suppress(CannotAnswer, ZeroDivisionError):
            value = measure.value(self._geometry(poses))
            open_ = self.unknowns.inside(value) & self.unknowns.angles
            found = {i: recognised(self.field, self.samples.start_numbers(i), is_angle=True) for i in open_}
            value = self.field.follow(value, {i: x for i, x in found.items() if x is not None})
            return None if self.unknowns.inside(value) else value
        return None

    def _geometry(self, poses: Mapping[str, AnyPose]) -> FieldGeometry:
        tangent = straight_tangent(self.field, self.samples.is_negative)
        return self.bodies.geometry(poses, tangent, None, self.samples.is_negative)

    def _pose(self, name: str) -> SpatialPose[Ratio] | None:
        """Where a body is at the start, if its place or its rotation is known; what is not given is its own."""
        body, scalar = self.system.bodies[name], self._scalar
        known = self.bodies.poses[name]
        assert isinstance(known, SpatialPose)
        if body.fixed:
            return known
        axes = known.axes
        if self._is_turned(body):
            x, y, z = self._known_rotation(body.start.turned or (), scalar)
            axes = Vector(*x), Vector(*y), Vector(*z)
        elif body.start.at is None:
            return None
        if body.start.at is None:
            return SpatialPose(known.center, axes)
        point, place = body.start.at
        arm = SpatialPose(known.center, axes).turn(Vector(*map(scalar, body.points[point])))
        return SpatialPose(Vector(*map(scalar, place)) - arm, axes)

    def of_measure(self, measure: Measure, name: str) -> Ratio | None:
        value = self._value(measure)
        value = self._unturned(measure) if value is None else value
        return value if value is not None and self.samples.is_start_value(value, name) else None

    def places(self) -> dict[int, Ratio]:
        return {}

    def is_placed(self, measure: Measure) -> bool:
        starts = (self.system.bodies[name] for name in measure.bodies() if name != GROUND)
        return all(b.fixed or (b.start.at is not None and self._is_turned(b)) for b in starts)

    def _is_turned(self, body: RigidBody) -> bool:
        """Whether the start says how a body is turned, or nothing looks at it."""
        return not body.turns or body.start.turned is not None or body.name in self.system.unfollowed
