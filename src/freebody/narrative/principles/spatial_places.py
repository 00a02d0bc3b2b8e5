"""Directions and points of space.

Directions are the axes of the ground, of the joints and of the bodies; points are mass centres, joints and points of
contact. Moments and their weights are along the axes of each body.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from freebody.language.expression import Symbol
from freebody.language.sentences import Sentence
from freebody.measures.base import Measure
from freebody.measures.displacement import Displacement
from freebody.measures.geometry import Point
from freebody.model.elements import NonholonomicForm
from freebody.model.spins import body_axes
from freebody.narrative.principles.acting import Acting
from freebody.narrative.principles.places import Aim, MomentAxis, MomentCentre, Vector, contact_point
from freebody.narrative.principles.rolling import contact_arm, rolling_body
from freebody.questions.vectors import AXES, ORIGIN, components_of, cross, dot
from freebody.symbolic.spatial.bodies import SpatialBodies
from freebody.symbolic.state import SymbolicState

MOST_TOGETHER = 4  # bodies that are put together in every possible way
MOST_CENTRES = 5


class SpatialPlaces:
    """Where principles of space are worth writing."""

    def __init__(self, acting: Acting) -> None:
        self.acting = acting
        self.model, self.system = acting.model, acting.system
        assert isinstance(self.model.bodies, SpatialBodies)
        self.bodies: SpatialBodies = self.model.bodies
        self.field = acting.model.field
        self.state = SymbolicState(acting.model)
        self._points: dict[Point, Vector] = {}
        self._aims: dict[tuple[str, ...], list[Aim]] = {}
        self._frames: dict[str, tuple[Vector, ...]] = {}

    def sizes(self, n: int) -> Iterable[int]:
        return range(2, n + 1) if n <= MOST_TOGETHER else (2, n)

    def position(self, body: str) -> Vector:
        return self._coordinates(self.system.bodies[body].mass_center)

    def axes(self, bodies: tuple[str, ...]) -> list[MomentAxis]:
        return [MomentAxis(aim.vector, aim) for aim in self.aims(bodies)]

    def across(self, axis: MomentAxis, arm: Vector) -> Vector:
        return self._elements(cross(axis.vector, arm))

    def turning(self, axis: MomentAxis, body: str) -> Vector:
        return self._elements(dot(axis.vector, a) for a in self._axes(body))

    def _elements(self, values: Iterable[object]) -> Vector:
        return tuple(self.field.lowest_terms(self.field.element(x)) for x in values)  # pyrefly: ignore[bad-argument-type]

    # -- directions ---------------------------------------------------------------------------
    def aims(self, bodies: tuple[str, ...]) -> list[Aim]:
        if bodies not in self._aims:
            kept: list[Aim] = []
            for aim in (*self._of_ground(), *self._of_joints(bodies), *self._of_bodies(bodies)):
                if not any(all(x.is_zero() for x in cross(aim.vector, other.vector)) for other in kept):
                    kept.append(aim)
            self._aims[bodies] = kept
        return self._aims[bodies]

    def _of_ground(self) -> Iterator[Aim]:
        for k, axis in enumerate("xyz"):
            vector = tuple(self.field.one if i == k else self.field.zero for i in range(3))
            yield Aim(vector, Sentence("space.along_ground", {"axis": f"@{axis}"}))

    def _of_joints(self, bodies: tuple[str, ...]) -> Iterator[Aim]:
        for body in bodies:
            for name, axis in self.bodies.turning_axes(body):
                vector = tuple(self.field.lowest_terms(self.model.express(x)) for x in axis)
                yield Aim(vector, Sentence("space.along_joint", {"name": Symbol(name)}))

    def _of_bodies(self, bodies: tuple[str, ...]) -> Iterator[Aim]:
        for body in bodies:
            for k, vector in enumerate(self._axes(body) if self.system.bodies[body].turns else ()):
                yield Aim(vector, Sentence("space.along_body", {"axis": f"@{'xyz'[k]}", "body": body}))

    def _axes(self, body: str) -> tuple[Vector, ...]:
        """The axes of a body by ground components."""
        if body not in self._frames:
            axes = (components_of(a, self.state, 3) for a in body_axes(body))
            self._frames[body] = tuple(map(self._elements, axes))
        return self._frames[body]

    # -- points -------------------------------------------------------------------------------
    def centres(self, bodies: tuple[str, ...]) -> list[MomentCentre]:
        found: list[MomentCentre] = []
        if len(bodies) == 1:
            words = Sentence("point.mass_center", {"body": bodies[0]})
            found.append(self._centre(self.position(bodies[0]), words, bodies[0]))
        for row in self.acting.rows.values():
            if not any(b in bodies for b in row.measure.bodies()):
                continue
            for centre in self._of_connection(row.connection, row.measure, bodies):
                if not any(all((x - y).is_zero() for x, y in zip(centre.place, c.place, strict=True)) for c in found):
                    found.append(centre)
        return found[:MOST_CENTRES]

    def _of_connection(
        self, connection: str, measure: Measure | NonholonomicForm, bodies: tuple[str, ...]
    ) -> Iterator[MomentCentre]:
        if isinstance(measure, Displacement):
            point = measure.of if measure.of.body in bodies else measure.origin
            if point.body in bodies:
                yield self._centre(self._coordinates(point), Sentence("space.joint", {"connection": connection}))
        elif isinstance(measure, NonholonomicForm):
            rolling = rolling_body(self.system, connection)
            if rolling is not None and rolling[0].name in bodies:
                arm = self._elements(contact_arm(*rolling, self.state))
                center = self._coordinates(rolling[0].center)
                place = tuple(self.field.lowest_terms(c + r) for c, r in zip(center, arm, strict=True))
                yield MomentCentre(place, contact_point(self.acting, connection), is_fixed=False)

    def _centre(self, place: Vector, words: Sentence, center_of: str = "") -> MomentCentre:
        is_fixed = self.acting.is_at_rest or all(self.model.samples.vanishes(self.model.rate(x)) for x in place)
        return MomentCentre(place, words, is_fixed, center_of)

    def _coordinates(self, point: Point) -> Vector:
        if point not in self._points:
            values = (self.state.value(Displacement(point, ORIGIN, a)) for a in AXES)
            self._points[point] = self._elements(map(self.acting.here, values))
        return self._points[point]
