"""The pose in generalized coordinates: where bodies are, and what measures are and how they change with the bodies."""

from __future__ import annotations

import copy
from collections.abc import Mapping

from freebody.measures.base import Measure
from freebody.model.elements import NonholonomicForm
from freebody.symbolic.bodies import Bodies
from freebody.symbolic.elimination import Elimination
from freebody.symbolic.geometry import ROTATIONS, AnyPose, Dual, DualGeometry, FieldGeometry, Slot
from freebody.symbolic.ratio import Ratio


class Configuration:
    """The statements of measures over the poses that an elimination has left."""

    def __init__(self, bodies: Bodies, elimination: Elimination, geometry: FieldGeometry) -> None:
        self._bodies, self._elimination = bodies, elimination
        self.field = bodies.field
        self.geometry = geometry
        self._dual = DualGeometry(geometry, {b.name: b.turns for b in bodies.system.bodies.values()})
        self._gradients: dict[Measure | NonholonomicForm, dict[Slot, Ratio]] = {}

    def with_names(self, names: Mapping[str, Ratio]) -> Configuration:
        """The same where more names stand for elements; gradients contain none of them."""
        other = copy.copy(self)
        other.geometry = copy.copy(self.geometry)
        other.geometry.names = {**self.geometry.names, **names}
        return other

    @property
    def poses(self) -> Mapping[str, AnyPose]:
        return self.geometry.poses

    def express(self, x: Ratio) -> Ratio:
        """An element in absolute coordinates by the coordinates that stay."""
        return self._elimination.express(x)

    def value_of(self, measure: Measure) -> Ratio:
        """A measure in coordinates; an angle by which a body is turned is the one that it was made with."""
        angle = self._bodies.angle_of(measure)
        return measure.value(self.geometry) if angle is None else self.express(angle)

    def gradient(self, measure: Measure | NonholonomicForm) -> dict[Slot, Ratio]:
        """Derivatives of a measure by the coordinates of the bodies (of its rate by their velocities)."""
        if measure not in self._gradients:
            self._gradients[measure] = self._gradient(measure)
        return self._gradients[measure]

    def rate_of(self, measure: Measure | NonholonomicForm) -> Ratio:
        """The rate of a measure, with the speeds of dependent coordinates as they are. What a body does that turns
        without being turned in its pose is in no derivative of the pose."""
        rate = self.field.rate
        if isinstance(measure, NonholonomicForm):
            total = self.field.zero
            for coefficient, part in measure.terms:
                total = total + coefficient.value(self.geometry) * self.rate_of(part)
            return total
        total = rate(self.value_of(measure))
        for body in set(measure.bodies()):
            for slot, turn in zip(ROTATIONS, self._bodies.unfollowed_turns(body), strict=False):
                if (slope := self.gradient(measure).get((body, slot))) is not None:
                    total = total + slope * rate(self.express(turn))
        return total

    def _gradient(self, measure: Measure | NonholonomicForm) -> dict[Slot, Ratio]:
        if isinstance(measure, NonholonomicForm):
            total: dict[Slot, Ratio] = {}
            for coefficient, part in measure.terms:
                c = coefficient.value(self.geometry)
                for slot, slope in self._gradient(part).items():
                    total[slot] = total.get(slot, self.field.zero) + c * slope
            return total
        dual: Dual = measure.value(self._dual)
        return {slot: slope for slot, slope in dual.slope.items() if not slope.is_zero()}
