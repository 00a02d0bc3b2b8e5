"""Dimensions of lengths that stand in the coordinates of points only, as in `at: [-b, 0]` or `points: {P: [u, v]}`."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from itertools import combinations

import numpy as np

from freebody.language.expression import ZERO, Expr, add, negate
from freebody.measures.geometry import GROUND as GROUND_NAME
from freebody.model.glyphs import Rail
from freebody.present.figures import GROUND, Array, Figure, places_in
from freebody.present.picture.dimensioned import INK, LEAST
from freebody.present.picture.dimensions import Dimensions
from freebody.present.picture.shapes import Shape

_CROSSED = 8  # how much may be near such a dimension, which often runs inside its body
_APART = 1.0  # [points] less is no distance


@dataclass(frozen=True)
class _Spot:
    """A point with its coordinates in formulas (None where it moves), where it is drawn (2,) [points], and the
    directions of its coordinates on paper, a row for each (2, 2)."""

    place: tuple[Expr | None, ...]
    at: Array
    axes: Array


class GivenPlaces:
    """Draws them where no other dimension shows their lengths."""

    def __init__(self, dimensions: Dimensions) -> None:
        self.dimensions = dimensions
        self.system, self.drawing = dimensions.system, dimensions.drawing

    def draw(self) -> None:
        for spots in (self._on_the_ground(), *map(self._on, self.drawing.scene.figures)):
            for first, second in combinations(_distinct(spots), 2):
                for k in range(2):
                    self._between(first, second, k)

    def _between(self, first: _Spot, second: _Spot, k: int) -> None:
        """The difference of one coordinate of two points, if it is a parameter that has no dimension yet."""
        from_there, to_there = first.place[k], second.place[k]
        if from_there is None or to_there is None:
            return
        label = self.dimensions.plain(add(to_there, negate(from_there)))
        length = float((second.at - first.at) @ first.axes[k])
        if label is None or not self.dimensions.is_new(label) or abs(length) < LEAST:
            return
        corner = first.at + length * first.axes[k]
        aside = float((second.at - corner) @ first.axes[1 - k])
        sense = -1.0 if (aside > 0) == ((length > 0) == (k == 0)) else 1.0  # away from the second point
        if self.dimensions.dimension(label, first.at, corner, sense, _CROSSED) and abs(aside) > _APART:
            self.dimensions.sketch.add(Shape(np.array((corner, second.at)), INK, 0.6))

    def _on(self, figure: Figure) -> Iterator[_Spot]:
        """The points of a body, those that it has by its shape among them."""
        body = self.system.bodies[figure.name]
        turn = 0.0 if figure.index == GROUND else float(self.drawing.poses[0, figure.index, 2])
        axes = np.array(((np.cos(turn), np.sin(turn)), (-np.sin(turn), np.cos(turn))))
        for name, place in figure.points.items():
            if name != "mass_center" and name in body.points:
                yield _Spot(body.points[name], self.dimensions.spot(place), axes)

    def _on_the_ground(self) -> Iterator[_Spot]:
        """Points of the ground, and where the file puts bodies. The origin is one of them where something is drawn
        there or a line of the ground goes through it."""
        scene, ground = self.drawing.scene, self.system.bodies[GROUND_NAME]
        drawn = {place.xy for sign in scene.signs for place in places_in(sign) if place.body == GROUND}
        for name, place in ground.points.items():
            at = self.dimensions.places.place(ground.point(name))
            lines = [line for line in ground.lines.values() if all(c == ZERO for c in line.through.offset)]
            if at.xy in drawn or (name == "origin" and lines):
                yield _Spot(place, self.dimensions.spot(at), np.eye(2))
        yield from self._on_guides()
        for figure in scene.figures:
            start = self.system.bodies[figure.name].start
            if start.at is not None and figure.name not in self.drawing.moved and start.at[0] in figure.points:
                yield _Spot(start.at[1], self.dimensions.spot(figure.points[start.at[0]]), np.eye(2))

    def _on_guides(self) -> Iterator[_Spot]:
        """What is guided along an axis, with the coordinate across its guide: the offset of a slider-crank."""
        for shown in self.system.glyphs:
            rail = shown.sign
            if not isinstance(rail, Rail) or rail.through is None or rail.point.body not in self.system.bodies:
                continue
            if {rail.through.body, rail.along.body} != {GROUND_NAME} or rail.point.body in self.drawing.moved:
                continue
            (x, y), (e, f) = rail.through.offset[:2], rail.along.components[:2]
            place = (x, None) if e == ZERO else (None, y) if f == ZERO else None
            if place is not None:
                yield _Spot(place, self.dimensions.spot(self.dimensions.places.place(rail.point)), np.eye(2))


def _distinct(spots: Iterable[_Spot]) -> list[_Spot]:
    found: list[_Spot] = []
    for spot in spots:
        if all(float(np.hypot(*(spot.at - other.at))) > _APART for other in found):
            found.append(spot)
    return found
