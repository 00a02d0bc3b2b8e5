"""Named measures as arrows in the direction in which they grow, with their names."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence

import numpy as np

from freebody.language.expression import Number, differentiate, evaluate, free_symbols, number
from freebody.measures.angle import Angle
from freebody.measures.base import Measure
from freebody.measures.combination import Combination, Composed
from freebody.measures.displacement import Displacement
from freebody.measures.distance import Bearing, Distance
from freebody.present.drawing import Drawing
from freebody.present.figures import GROUND, Array, Figure, Place, positions
from freebody.present.picture.label import Label, name
from freebody.present.picture.placer import Wish
from freebody.present.picture.shapes import Ink, Shape
from freebody.present.picture.signs import across, arc, arrow, curved_arrow, dimension, unit
from freebody.present.picture.sketch import Sketch
from freebody.present.places import Places

INK = Ink("measure")
_SHORT, _LONG = 14.0, 28.0  # [points] a displacement that is hardly seen, the arrow that it has then
_SMALL = 0.2  # [rad] an angle that is hardly seen
_WIDTH = 1.1
_ASIDE = (0.0, 9.0, 18.0, 30.0)  # [points] from what moves
_RADII = (26.0, 34.0, 44.0, 20.0, 56.0)
_NAME = 16.0  # [points] between two lines that have a name between them


class Coordinates:
    """Draws measures into a sketch."""

    def __init__(
        self, sketch: Sketch, drawing: Drawing, places: Places, labels: Mapping[str, Label] | None = None
    ) -> None:
        """labels: what stands beside a measure instead of its name."""
        self.labels = labels or {}
        self.named: set[str] = set()  # what has found its place
        self.sketch, self.drawing, self.places = sketch, drawing, places
        self.figures = {figure.index: figure for figure in drawing.scene.figures if figure.index != GROUND}

    def draw(self, called: str, measure: Measure, sense: int = 1) -> None:
        """sense: -1 for one that grows against the measure. Of what no body shows, as the foot on a curve, nothing."""
        if any(body not in self.places.index and body not in self.places.poses for body in measure.bodies()):
            return
        match measure:
            case Combination(((Number(factor), own),)) if abs(factor) == 1:
                self.draw(called, own, sense * int(factor))
            case Composed(expression, ((variable, own),)) if free_symbols(expression) == frozenset((variable,)):
                slope = differentiate(expression, variable)
                if slope in (number(1), number(-1)) and not evaluate(expression, {variable: 0.0}):
                    self.draw(called, own, sense if slope == number(1) else -sense)
            case Displacement() if sense > 0:
                self._displacement(called, measure)
            case Angle(of, origin, reference):
                self._angle(called, of, self._turn_of(origin) + self.places.number(reference), sense)
            case Bearing(start, end, origin, reference):
                foot, tip = (self._at(self.places.place(point)) for point in (start, end))
                begin = self._turn_of(origin) + self.places.number(reference)
                arm = tip - foot
                self._between(called, foot, begin, math.atan2(*arm[::-1]), sense, math.hypot(*arm), has_line=True)
            case Distance(start, end):
                self._distance(called, self._at(self.places.place(start)), self._at(self.places.place(end)))
            case _:
                pass

    def _at(self, place: Place) -> Array:
        return self.sketch.seen(positions(self.drawing.poses, place)[0])

    def _turn_of(self, body: str) -> float:
        """[rad] the angle of a body."""
        if body in self.places.index:
            return float(self.drawing.poses[0, self.places.index[body], 2])
        return self.places.poses[body][2]

    # -- displacements ------------------------------------------------------------------------
    def _displacement(self, called: str, measure: Displacement) -> None:
        tip, foot = self._at(self.places.place(measure.of)), self._at(self.places.place(measure.origin))
        heading = self.places.heading(measure.along)
        turn = 0.0 if heading.body == GROUND else float(self.drawing.poses[0, heading.body, 2])
        way = unit(heading.angle + turn)
        side = across(way)
        figure = self.figures.get(self.places.place(measure.of).body)
        is_aside = figure is not None and figure.name in self.drawing.apart  # its arrow begins where it is drawn
        length = 0.0 if is_aside else float((tip - foot) @ way)
        is_long = length > _SHORT
        options: list[list[Shape]] = []
        ends: list[tuple[Array, Array]] = []
        for aside in _ASIDE:
            for sign in (1.0, -1.0):
                reach = self._reach(figure, tip, sign * side) + 8.0 + aside
                base = tip + sign * reach * side
                start = base - length * way if is_long else base - min(max(length, -_SHORT), 0.0) * way
                end = base if is_long else start + _LONG * way
                tick = Shape(np.array((start - 4.0 * side, start + 4.0 * side)), INK, _WIDTH)
                options.append([tick, *arrow(start, end, INK, _WIDTH, 6.0)])
                ends.append((start, end))
        k = self.sketch.least_crowded(options, 30)
        if k is not None:
            self.sketch.add(options[k])
            self._name(called, _beside(*ends[k]))

    def _reach(self, figure: Figure | None, at: Array, way: Array) -> float:
        """[points] how far a body reaches from a point in a direction."""
        if figure is None:
            return 0.0
        corners = [self._at(place) for place in figure.points.values()] or [at]
        reach = max(float((corner - at) @ way) for corner in corners)
        if figure.radius is not None:
            middle = self._at(figure.center)
            reach = max(reach, float((middle - at) @ way) + figure.radius * self.sketch.scale)
        return max(reach, 0.0)

    def _distance(self, called: str, start: Array, end: Array) -> None:
        if float(np.hypot(*(end - start))) < _SHORT:
            return
        options = [list(dimension(start, end, aside, INK)) for aside in (14.0, -14.0, 24.0, -24.0)]
        k = self.sketch.least_crowded(options, 20)
        if k is not None:
            self.sketch.add(options[k])
            shift = (14.0, -14.0, 24.0, -24.0)[k] * across((end - start) / float(np.hypot(*(end - start))))
            self._name(called, _beside(start + shift, end + shift))

    # -- angles -------------------------------------------------------------------------------
    def _angle(self, called: str, of: str, begin: float, sense: int) -> None:
        figure = self.figures.get(self.places.index.get(of, GROUND))
        if figure is None:
            return
        angle = self._turn_of(of)
        pivot = self._pivot(figure)
        at = self._at(pivot)
        arms = [(math.hypot(p.x - pivot.x, p.y - pivot.y), p) for p in figure.points.values()]
        far, tip = max(arms, default=(0.0, pivot))
        is_along = figure.radius is None and far > 1e-9 and abs(math.atan2(tip.y - pivot.y, tip.x - pivot.x)) < 0.02
        if is_along:
            self._between(called, at, begin, angle, sense, far * self.sketch.scale, has_line=False)
            return
        rim = (figure.radius or 0.0) * self.sketch.scale
        radii = (0.72 * rim, rim + 7.0) if rim > 34.0 else (rim + 7.0, rim + 14.0) if rim else (18.0, 26.0)
        self._turning(called, at, radii, sense)

    def _pivot(self, figure: Figure) -> Place:
        """Where a body is pinned, to the ground rather than to others; else its middle."""
        found = [
            (other.body != GROUND, own)
            for pin in (*self.drawing.scene.pins, *self.drawing.scene.welds)
            for own, other in (pin, pin[::-1])
            if own.body == figure.index
        ]
        return min(found, key=lambda item: item[0])[1] if found else figure.center

    def _between(
        self, called: str, at: Array, begin: float, angle: float, sense: int, reach: float, *, has_line: bool
    ) -> None:
        """From a line of reference, drawn dashed, to a line that turns, which is so long [points]."""
        turn = math.remainder(angle - begin, math.tau)
        sweep = turn if abs(turn) > _SMALL else 0.9 * sense
        options: list[list[Shape]] = []
        radii = [radius for radius in _RADII if radius <= max(reach, _RADII[0])]
        # those that have room for a name between the two lines, if there are any
        radii = [radius for radius in radii if radius * abs(sweep) > _NAME] or radii
        for radius in radii:
            # a negative angle grows towards its line of reference
            first, way = (begin, sweep) if sweep * sense > 0 else (begin + sweep, -sweep)
            dashed = Shape(np.array((at, at + (radius + 12.0) * unit(begin))), Ink("muted"), 0.8, dashes=(3.0, 2.5))
            line = [Shape(np.array((at, at + (radius + 12.0) * unit(angle))), Ink("muted"), 0.8)] if has_line else []
            options.append([dashed, *line, *curved_arrow(at, radius, first, way, INK, _WIDTH, 6.0)])
        k = self.sketch.least_crowded([option[-2:] for option in options], 60)
        if k is not None:
            self.sketch.add(options[k])
            spots = arc(at, radii[k], begin + 0.25 * sweep, 0.5 * sweep)
            self._name(
                called,
                [(s, sign * (s - at) / radii[k]) for sign in (1.0, -1.0) for s in spots[:: max(1, len(spots) // 4)]],
            )

    def _turning(self, called: str, at: Array, radii: Sequence[float], sense: int) -> None:
        """The sense in which a body turns."""
        options: list[list[Shape]] = []
        spots: list[tuple[Array, Array]] = []
        for radius in radii:
            sweep = min(1.0, 34.0 / radius)
            for k in range(8):
                middle = math.pi / 2 + k * math.pi / 4
                begin, turn = middle - 0.5 * sense * sweep, sense * sweep
                options.append(list(curved_arrow(at, radius, begin, turn, INK, _WIDTH, 6.0)))
                spots.append((at + radius * unit(middle), unit(middle)))
        k = self.sketch.least_crowded(options, 12)
        if k is not None:
            self.sketch.add(options[k])
            at, way = spots[k]
            self._name(called, [(at, way), (at, -way)])

    def _name(self, called: str, places: Sequence[tuple[Array, Array]]) -> None:
        label = self.labels.get(called) or name(called)
        self.sketch.wish(Wish(label, tuple(places), 10.5, INK, weight=4.0))
        self.named.add(called)


def _beside(start: Array, end: Array) -> list[tuple[Array, Array]]:
    """Places beside an arrow."""
    way = (end - start) / (float(np.hypot(*(end - start))) or 1.0)
    side = across(way)
    spots = [start + share * (end - start) for share in (0.5, 0.75, 0.3)]
    return [(s, sign * side) for s in spots for sign in (1.0, -1.0)] + [(end, way)]
