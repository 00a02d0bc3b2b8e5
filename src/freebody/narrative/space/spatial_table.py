"""The table of principles in space, and the planner that chooses among them.

    linear momentum along e           weights e on the force of each body
    angular momentum about O along e  weights e x r_OG on the force, e on the moment of each body

since e . (r x F) = (e x r) . F. Directions are the axes of the ground, of the joints and of the bodies; points are mass
centres, joints and points of contact. Moments and their weights are along the axes of each body.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from itertools import combinations

import numpy as np

from freebody.language.expression import Symbol
from freebody.measures.displacement import Displacement
from freebody.measures.geometry import Point
from freebody.model.elements import NonholonomicForm
from freebody.model.spins import body_axes
from freebody.narrative.lines.script import Sentence
from freebody.narrative.principles.planner import MORE_BODIES, Array, Planner
from freebody.narrative.principles.table import Aim, MomentCentre, PrincipleTable, Slot, WritablePrinciple
from freebody.narrative.space.spatial_frames import Vector
from freebody.narrative.space.spatial_kinematics import SpatialKinematics
from freebody.questions.vectors import AXES, ORIGIN, components_of, cross, dot
from freebody.symbolic.field import Ratio
from freebody.symbolic.spatial.bodies import SpatialBodies
from freebody.tolerances import ROUND_OFF

MOST_TOGETHER = 4  # bodies that are put together in every possible way
MOST_CENTRES = 5
TOGETHER = 0.2  # what a further body costs


@dataclass(frozen=True)
class SpatialPrinciple(WritablePrinciple):
    """One equation, along an axis by ground components."""

    axis: Vector = ()


@dataclass(frozen=True)
class _Direction:
    vector: Vector
    words: Sentence


@dataclass(frozen=True)
class _Place:
    place: Vector
    words: Sentence
    is_fixed: bool
    mass_center_of: str = ""


class SpatialTable(PrincipleTable):
    """Principles of a system in space."""

    def __init__(self, kinematics: SpatialKinematics) -> None:
        super().__init__(kinematics.model)
        self.kinematics = kinematics
        self.bodies: SpatialBodies = kinematics.bodies
        self.field = kinematics.field
        self.state = kinematics.state
        self._points: dict[Point, Vector] = {}
        self._frames: dict[str, tuple[Vector, ...]] = {}

    # -- groups, directions, points -----------------------------------------------------------
    def groups(self) -> Iterator[tuple[str, ...]]:
        names = [body.name for body in self.system.moving]
        yield from ((name,) for name in names)
        sizes = range(2, len(names) + 1) if len(names) <= MOST_TOGETHER else (2, len(names))
        joined = [{b for b, _slot in slopes if b in names} for slopes in self.directions.values()]
        for size in sizes:
            for group in combinations(names, size):
                if size == len(names) or _is_connected(set(group), joined):
                    yield group

    def _directions_for(self, bodies: tuple[str, ...]) -> list[_Direction]:
        f = self.field
        found: list[_Direction] = []
        for k, axis in enumerate("xyz"):
            vector = tuple(f.one if i == k else f.zero for i in range(3))
            found.append(_Direction(vector, Sentence("space.along_ground", {"axis": f"@{axis}"})))
        for body in bodies:
            for name, axis in self.bodies.turning_axes(body):
                vector = tuple(map(self.kinematics.express, axis))
                found.append(_Direction(vector, Sentence("space.along_joint", {"name": Symbol(name)})))
        for body in bodies:
            if self.system.bodies[body].turns:
                for k, vector in enumerate(self._axes(body)):
                    words = Sentence("space.along_body", {"axis": f"@{'xyz'[k]}", "body": body})
                    found.append(_Direction(vector, words))
        kept: list[_Direction] = []
        for d in found:
            if not any(all(x.is_zero() for x in cross(d.vector, other.vector)) for other in kept):
                kept.append(d)
        return kept

    def _places_for(self, bodies: tuple[str, ...]) -> list[_Place]:
        found: list[_Place] = []
        if len(bodies) == 1:
            centre = self.system.bodies[bodies[0]].mass_center
            words = Sentence("point.mass_center", {"body": bodies[0]})
            found.append(self._place(centre, words, bodies[0]))
        for row in self.system.held:
            if not any(b in bodies for b in row.measure.bodies()):
                continue
            for place in self._places_of(row.connection, row.measure, bodies):
                if not any(all((x - y).is_zero() for x, y in zip(place.place, p.place, strict=True)) for p in found):
                    found.append(place)
        return found[:MOST_CENTRES]

    def _places_of(self, connection: str, measure: object, bodies: tuple[str, ...]) -> Iterator[_Place]:
        if isinstance(measure, Displacement):
            point = measure.of if measure.of.body in bodies else measure.origin
            if point.body in bodies:
                yield self._place(point, Sentence("space.joint", {"connection": connection}))
        elif isinstance(measure, NonholonomicForm):
            rolling = self.kinematics.rolling_body(connection)
            if rolling is not None and rolling[0].name in bodies:
                center = self._coordinates(rolling[0].center)
                arm = self.kinematics.arm(*rolling)
                place = tuple(self.field.lowest_terms(c + r) for c, r in zip(center, arm, strict=True))
                yield _Place(place, Sentence("point.contact", {"connection": connection}), False)

    def _place(self, point: Point, words: Sentence, center_of: str = "") -> _Place:
        place = self._coordinates(point)
        is_fixed = all(self.model.samples.vanishes(self.model.rate(x)) for x in place)
        return _Place(place, words, is_fixed, center_of)

    def _coordinates(self, point: Point) -> Vector:
        if point not in self._points:
            values = (self.state.value(Displacement(point, ORIGIN, a)) for a in AXES)
            self._points[point] = tuple(map(self.field.lowest_terms, values))
        return self._points[point]

    def _axes(self, body: str) -> tuple[Vector, ...]:
        """The axes of a body by ground components."""
        if body not in self._frames:
            axes = (components_of(a, self.state, 3) for a in body_axes(body))
            self._frames[body] = tuple(tuple(self.field.lowest_terms(self.field.element(c)) for c in a) for a in axes)
        return self._frames[body]

    # -- principles ---------------------------------------------------------------------------
    def of(self, bodies: tuple[str, ...]) -> Iterator[WritablePrinciple]:
        directions = self._directions_for(bodies)
        for d in directions:
            weights: dict[Slot, Ratio] = {}
            for body in bodies:
                for slot, w in zip(("x", "y", "z"), d.vector, strict=True):
                    weights[body, slot] = w
            aim = Aim((d.vector[0], d.vector[1]), d.words, "")
            yield SpatialPrinciple(bodies, "linear", _kept(weights), aim=aim, axis=d.vector)
        for place in self._places_for(bodies):
            for d in directions:
                yield self._angular(bodies, place, d)

    def _angular(self, bodies: tuple[str, ...], place: _Place, d: _Direction) -> SpatialPrinciple:
        f = self.field
        weights: dict[Slot, Ratio] = {}
        for body in bodies:
            center = self._coordinates(self.system.bodies[body].mass_center)
            arm = tuple(c - o for c, o in zip(center, place.place, strict=True))
            turned = cross(d.vector, arm)
            parts = [*turned]
            if self.system.bodies[body].turns:
                parts += [f.element(dot(d.vector, a)) for a in self._axes(body)]
            for slot, w in zip(self.model.bodies.slots, parts, strict=False):
                weights[body, slot] = f.lowest_terms(f.element(w))
        centre = MomentCentre((place.place[0], place.place[1]), place.words, place.is_fixed, place.mass_center_of)
        aim = Aim((d.vector[0], d.vector[1]), d.words, "")
        return SpatialPrinciple(bodies, "angular", _kept(weights), aim=aim, centre=centre, axis=d.vector)


class SpatialPlanner(Planner):
    """Rows of numbers in space: moments along the axes of the bodies, tensors of inertia."""

    def __init__(self, table: SpatialTable, numbers: Mapping[int, float]) -> None:
        super().__init__(table, numbers)
        self._changes = {
            body.name: [
                [self._number(x) for x in self.model.dynamics.momentum(body.name, partial)]
                for partial in self.model.kinematics.partial_velocities[body.name]
            ]
            for body in table.system.moving
        }

    def _cost(self, p: WritablePrinciple, row: Array, place: int) -> float:
        """In space it is the equations of one body that are many: those of several bodies together are preferred."""
        alone = super()._cost(p, row, place)
        return alone + (TOGETHER - MORE_BODIES[p.kind]) * (len(p.bodies) - 1)

    def row_of(self, weights: Mapping[Slot, Ratio]) -> Array:
        found = np.zeros(self.n)
        for (body, slot), weight in weights.items():
            w, place = self._number(weight), self.model.bodies.slots.index(slot)
            for k, change in enumerate(self._changes[body]):
                found[k] += w * change[place]
            for row, slopes in self._slopes.items():
                if (body, slot) in slopes:
                    found[self.column(row)] -= w * slopes[body, slot]
        found[np.abs(found) < ROUND_OFF * max(1.0, float(np.abs(found).max(initial=0.0)))] = 0.0
        return found


def _kept(weights: Mapping[Slot, Ratio]) -> dict[Slot, Ratio]:
    return {slot: w for slot, w in weights.items() if not w.is_zero()}


def _is_connected(group: set[str], joined: list[set[str]]) -> bool:
    reached, grows = {min(group)}, True
    while grows:
        before = len(reached)
        for pair in joined:
            if pair & group & reached:
                reached |= pair & group
        grows = len(reached) > before
    return reached == group


__all__ = ["SpatialPlanner", "SpatialPrinciple", "SpatialTable"]
