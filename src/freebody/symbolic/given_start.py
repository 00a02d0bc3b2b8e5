"""What the start of a model says about measures: their start values in the parameters.

A sample tells every start value in numbers; a formula for one is taken from the places and angles that the model gives
to its bodies (`start_pose`), and where it is a multiple of a right angle at all samples it is recognised as that.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable, Mapping
from functools import cached_property

from freebody.errors import CannotAnswer
from freebody.measures.base import Measure
from freebody.measures.geometry import GROUND, Pose, Vector
from freebody.symbolic.bodies import Bodies, coordinates_of
from freebody.symbolic.functions import cos_sin
from freebody.symbolic.geometry import FieldGeometry, straight_tangent
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.samples import Samples
from freebody.symbolic.start_pose import StartPose, known_poses, recognised
from freebody.symbolic.unknowns import Coordinate


class GivenStart(ABC):
    """The start values that a model gives."""

    def __init__(self, bodies: Bodies, samples: Samples, absolute: FieldGeometry) -> None:
        """absolute: the statements of measures over the unknowns, which note what expressions they read."""
        self.bodies, self.samples, self.absolute = bodies, samples, absolute
        self.system, self.unknowns, self.field = bodies.system, bodies.unknowns, bodies.field
        # what closed loops bind at the start, by the values of coordinates there: told when the loops are known
        self.by_loops: Callable[[Mapping[int, Ratio]], Mapping[int, Ratio]] = lambda _values: {}

    @abstractmethod
    def of_coordinate(self, c: Coordinate) -> Ratio | None:
        """The start value of a coordinate where the start of the model tells it."""

    @abstractmethod
    def of_measure(self, measure: Measure, name: str) -> Ratio | None:
        """The start value of a measure, which an incremental row or load of that name has, where the start of the model
        tells it, as it is at all samples."""

    @abstractmethod
    def places(self) -> dict[int, Ratio]:
        """The absolute coordinates of bodies that the model places."""

    @abstractmethod
    def is_placed(self, measure: Measure) -> bool:
        """Whether the model gives the places and angles of all bodies of a measure."""

    def recognised(self, c: Coordinate) -> Ratio | None:
        """A start value that is a multiple of a right angle (zero for a length) at all samples."""
        return recognised(self.field, self.samples.start_numbers(c.index), is_angle=c.is_angle)


class PlanarGivenStart(GivenStart):
    """The start values of a model in the plane."""

    def of_coordinate(self, c: Coordinate) -> Ratio | None:
        f, unknowns = self.field, self.unknowns
        values = dict(self._pose_values)
        defined = unknowns.defined.get(c.index)
        x = f.variable(c.index) if defined is None else defined
        for line in unknowns.lines:
            if {line.length, line.angle} & f.ingredients(x):
                place = f.follow(line.x, values), f.follow(line.y, values)
                if not any(unknowns.inside(p) for p in place):
                    length, angle = straight_tangent(f, self.samples.is_negative)(Vector(*place), line.offset)
                    values |= {line.length: length, line.angle: angle}
        return f.follow(x, values) if unknowns.inside(x) <= values.keys() else None

    def of_measure(self, measure: Measure, name: str) -> Ratio | None:
        poses = known_poses(self.field, self.bodies.poses, self._pose_values)
        tangent = straight_tangent(self.field, self.samples.is_negative)
        start = FieldGeometry(self.field, self.unknowns.parameters, poses, tangent)
        try:
            value = measure.value(start)
        except (CannotAnswer, ZeroDivisionError):
            return None
        if self.unknowns.inside(value) or not self.samples.is_start_value(value, name):
            return None
        return value

    @cached_property
    def _pose_values(self) -> dict[int, Ratio]:
        """The absolute coordinates at the start, where the model tells them."""
        absolute = {
            self.field.index(element)
            for body in self.system.all_moving
            for element in coordinates_of(self.bodies.poses[body.name])
            if element.generators()
        }
        try:
            start = StartPose(
                self.system,
                self.field,
                self.bodies.poses,
                self.unknowns.parameters,
                {index: self.unknowns.found[index] for index in absolute},
                self.samples.is_negative,
                self.samples.at_starts,
            )
            return start.values(self.samples.start_numbers)
        except CannotAnswer:  # too long to write
            return self.places()

    def places(self) -> dict[int, Ratio]:
        values: dict[int, Ratio] = {}
        f, scalar = self.field, self.absolute.scalar
        for body in self.system.all_moving:
            pose, start = self.bodies.poses[body.name], body.start
            assert isinstance(pose, Pose)
            angle = None
            if not body.turns:
                angle = f.zero
            elif start.angle is not None:
                angle = scalar(start.angle)
                values[f.index(pose.angle)] = angle
            if start.at is None:
                continue
            point, (ax, ay) = start.at
            rx, ry = (scalar(e) for e in body.points[point])
            if angle is None and not (rx.is_zero() and ry.is_zero()):
                continue
            c, s = cos_sin(f, f.zero if angle is None else angle)
            values[f.index(pose.x)] = scalar(ax) - (c * rx - s * ry)
            values[f.index(pose.y)] = scalar(ay) - (s * rx + c * ry)
        return values

    def is_placed(self, measure: Measure) -> bool:
        given = self.places()
        poses = (self.bodies.poses[name] for name in measure.bodies() if name != GROUND)
        return all(e.generators() <= given.keys() for pose in poses for e in coordinates_of(pose))
