"""Dimensions that are plain parameters: radii of circles, lengths along bodies, angles of inclines."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Sequence
from itertools import combinations, pairwise

import numpy as np

from freebody.errors import FreebodyError
from freebody.language.expression import ZERO, Expr, Symbol, evaluate, free_symbols
from freebody.language.units import DIMENSIONLESS
from freebody.measures.geometry import GROUND as GROUND_NAME
from freebody.measures.geometry import Components
from freebody.model.elements import RigidBody
from freebody.model.glyphs import Belt, Rail, Rod, Rope, Surface, Track, Wheels
from freebody.present.drawing import Drawing
from freebody.present.figures import GROUND, Array, Figure, Place, positions
from freebody.present.picture.dimensioned import INK, LEAST, SIZE, Dimensioned
from freebody.present.picture.label import Label, formula
from freebody.present.picture.placer import Wish
from freebody.present.picture.shapes import Shape
from freebody.present.picture.signs import across, arc, head, unit
from freebody.present.picture.sketch import Sketch
from freebody.present.places import Places
from freebody.present.strokes import Path
from freebody.system.system import System

_CROSSED = 14  # how much may be near the dimension of a whole length, which may cross another body
_NARROW = 26.0  # [points] radius of a circle within which signs leave no room
_OUTER_ANGLES = (2.36, 0.79, 3.93, 5.5, 2.0, 1.1, 3.5, 5.9)  # [rad] of an arrow to the rim
_ANGLES = (-0.6, -1.0, -2.2, 0.6, 2.5, -0.2, 1.2, 3.6)  # [rad] of a radius
_ARC = 34.0  # [points]
_NAME_OF_ANGLE = 17.0  # [points] between two lines that have a name between them


class Dimensions(Dimensioned):
    """Draws dimensions into a sketch of the plane, each symbol once."""

    def __init__(self, system: System, sketch: Sketch, drawing: Drawing, places: Places) -> None:
        super().__init__(system, sketch)
        self.drawing, self.places = drawing, places

    def draw(self) -> None:
        """Radii and lengths."""
        for figure in self.drawing.scene.figures:
            body = self.system.bodies[figure.name]
            if figure.radius is not None and body.radius is not None:
                self._radius(figure, body.radius, figure.radius)
                for hub in (*body.middle_circles.values(), *self._wound(body)):
                    self._radius(figure, hub, abs(self.places.number(hub)))
        if any(rail.is_support for rail in self.drawing.scene.rails):
            self._ground()  # the span first, of which parts along a beam may be shares
        for figure in self.drawing.scene.figures:
            self._lengths(figure, self.system.bodies[figure.name])
        self._links()
        self._ground()

    def spot(self, place: Place) -> Array:
        """(2,) [points]"""
        return self.sketch.seen(positions(self.drawing.poses, place)[0])

    def _wound(self, body: RigidBody) -> Iterator[Expr]:
        """Radii of further circles about the centre of a body: on which strings and belts run, or which roll."""
        for shown in self.system.glyphs:
            match shown.sign:
                case Rope(nodes, is_fall=False):
                    ends = [(node.place, node.arm) for node in nodes]
                case Wheels(first, second, radii) | Belt(first, second, radii):
                    ends = list(zip((first, second), radii, strict=True))
                case Track(place, _along, radius):
                    ends = [(place, radius)]
                case _:
                    continue
            yield from (radius for place, radius in ends if place == body.center and radius != ZERO)

    # -- radii --------------------------------------------------------------------------------
    def _radius(self, figure: Figure, radius: Expr, size: float) -> None:
        """Of a rim, or of a hub. size: in numbers [m]."""
        label = self.plain(radius)
        rim = size * self.sketch.scale
        is_hub = size != figure.radius
        if label is None or (rim < LEAST and not is_hub) or not self.is_new(label):
            return
        middle = self.spot(figure.center)
        turn = 0.0 if figure.index == GROUND else float(self.drawing.poses[0, figure.index, 2])
        options: list[list[Shape]] = []
        for angle in _ANGLES:
            way = unit(turn + angle)
            shaft = Shape(np.array((middle + 3.0 * way, middle + (rim - 4.0) * way)), INK, 0.7)
            options.append([shaft, head(middle + rim * way, way, INK, 5.0)])
        if rim < LEAST or (rim < _NARROW and self.sketch.least_crowded([option[:1] for option in options], 0) is None):
            self._radius_from_outside(label, middle, rim)
            return
        k = self.sketch.least_crowded([option[:1] for option in options], 14)
        if k is not None:
            self.show(label)
            self.sketch.add(options[k])
            way = unit(turn + _ANGLES[k])
            spots = [middle + share * rim * way for share in (0.55, 0.7, 0.4)]
            places = tuple((s, sign * across(way)) for s in spots for sign in (1.0, -1.0))
            self.sketch.wish(Wish(label, places, SIZE, INK, weight=3.0))

    def _radius_from_outside(self, label: Label, middle: Array, rim: float) -> None:
        """An arrow to the rim of a circle that has no room for one within."""
        ways = [unit(angle) for angle in _OUTER_ANGLES]
        options = [
            [
                Shape(np.array((middle + (rim + 4.0) * way, middle + (rim + 16.0) * way)), INK, 0.7),
                head(middle + (rim + 0.5) * way, -way, INK, 5.0),
                Shape(middle + (rim + 20.0) * way + 4.0 * np.array(((-1.0, 0.0), (1.0, 0.0)))),  # its name
            ]
            for way in ways
        ]
        k = self.sketch.least_crowded(options, 5)
        if k is not None:
            self.show(label)
            self.sketch.add(options[k][:2])
            self.sketch.wish(Wish(label, ((middle + (rim + 16.0) * ways[k], ways[k]),), SIZE, INK, weight=3.0))

    # -- lengths ------------------------------------------------------------------------------
    def _links(self) -> None:
        """Lengths of links without mass."""
        for shown in self.system.glyphs:
            if isinstance(shown.sign, Rod) and shown.sign.length is not None:
                label = self.plain(shown.sign.length)
                ends = self.places.place(shown.sign.first), self.places.place(shown.sign.second)
                if label is not None and self.is_new(label) and ends in self.drawing.scene.rods:
                    self.dimension(label, self.spot(ends[0]), self.spot(ends[1]), 1.0)

    def _ground(self) -> None:
        """Between points of the ground at which something is joined."""
        used = {place for pair in (*self.drawing.scene.joined(), *self._held()) for place in pair}
        ground = self.system.bodies[GROUND_NAME]
        joined = [called for called in ground.points if self.places.place(ground.point(called)) in used]
        for first, second in combinations(joined, 2):
            label = self._apart(ground.points[first], ground.points[second])
            if label is not None and self.is_new(label):
                a, b = (self.spot(self.places.place(ground.point(called))) for called in (first, second))
                self.dimension(label, a, b, -1.0)

    def _held(self) -> Iterator[tuple[Place, Place]]:
        """The ends of springs and strings, and supports on rollers."""
        scene = self.drawing.scene
        for rail in scene.rails:
            if rail.is_support and rail.through is not None:
                yield rail.through, rail.point
        yield from ((spring.first, spring.second) for spring in scene.springs)
        yield from ((rope.nodes[0].place, rope.nodes[-1].place) for rope in scene.ropes)

    def _lengths(self, figure: Figure, body: RigidBody) -> None:
        """Between neighbours along a rod, along two edges of a polygon."""
        for k, (first, second) in enumerate(self._stretches(figure, body)):
            label = self._apart(body.points[first], body.points[second])
            if label is not None and self.is_new(label):
                a, b = (self.spot(figure.points[name]) for name in (first, second))
                self.dimension(label, a, b, 1.0 if len(figure.outline) < 3 else -1.0, _CROSSED if not k else 5)

    def _stretches(self, figure: Figure, body: RigidBody) -> Iterator[tuple[str, str]]:
        if len(figure.corners) > 2:
            ring = [*body.corners, body.corners[0]]
            yield from list(pairwise(ring))[:2]
            return
        if figure.radius is not None or len(figure.outline) != 2:
            return
        along = figure.outline[1] - figure.outline[0]
        points = [n for n in figure.points if n not in ("center", "mass_center") or body.mass != ZERO]
        order = sorted(points, key=lambda n: float(along @ np.array(figure.points[n].xy)))
        distinct: list[str] = []
        for name in order:
            if (
                not distinct
                or np.hypot(*(self.spot(figure.points[name]) - self.spot(figure.points[distinct[-1]]))) > 1.0
            ):
                distinct.append(name)
        yield distinct[0], distinct[-1]
        yield from pairwise(distinct)
        yield from ((distinct[0], other) for other in distinct[2:-1])
        yield from ((other, distinct[-1]) for other in distinct[1:-2])

    def _apart(self, first: Components, second: Components) -> Label | None:
        """The distance of two points of a body, if it is a multiple of one length."""
        differences = [b - a for a, b in zip(first, second, strict=True)]
        return self.plain(*differences)

    # -- inclines -----------------------------------------------------------------------------
    def draw_inclines(self) -> None:
        """The angle between a surface of the ground and the horizontal or the vertical."""
        for name, angle, base in self._angles():
            line = self._surface(angle)
            if line is None or not self.is_new(formula(Symbol(name))):
                continue
            low, high = line if line[0][1] <= line[1][1] else line[::-1]
            length = float(np.hypot(*(high - low)))
            radius = min(_ARC, 0.7 * length)
            if radius < 0.5 * _ARC:
                continue
            level = np.array((math.copysign(1.0, high[0] - low[0]), 0.0)) if base == 0 else np.array((0.0, 1.0))
            self._mark(name, low, level, high - low, radius)

    def _mark(self, name: str, at: Array, level: Array, line: Array, radius: float) -> None:
        """The arc of an angle between a dashed line and a line of the picture (2,), both from one point."""
        begin, end = (math.atan2(v[1], v[0]) for v in (level, line))
        length = float(np.hypot(*line))
        turn = math.remainder(end - begin, math.tau)
        far = max(radius, _NAME_OF_ANGLE / max(abs(turn), 1e-3))  # where the name has room between the two lines
        middle = unit(begin + 0.5 * turn)
        away = unit(begin - math.copysign(0.5 * math.pi, turn))  # from the line, where its hatching is between the two
        places = (
            (at + far * middle, middle),
            (at + (radius - 5.0) * middle, -middle),
            (at + radius * unit(begin), away),
        )
        if far > length:  # nowhere: behind the arc, which stands beyond the line
            radius = length + 6.0
            places = ((at + radius * middle, middle),)
        reach = radius + 14.0 if far > length else max(radius + 14.0, _NAME_OF_ANGLE / max(abs(turn), 0.1) + 8.0)
        dashed = Shape(np.array((at, at + reach * level)), INK, 0.8, dashes=(3.0, 2.5))
        self.sketch.add(dashed, Shape(arc(at, radius, begin, turn), INK, 0.9))
        self.sketch.wish(Wish(formula(Symbol(name)), places, 10.5, INK, weight=4.5))
        self.show(formula(Symbol(name)))

    def draw_tilts(self) -> None:
        """The angle at which a rod is put, at its lower end."""
        for figure in self.drawing.scene.figures:
            angle = self.system.bodies[figure.name].start.angle
            if angle is None or figure.radius is not None or len(figure.outline) != 2:
                continue
            ends = [self.spot(place) for place in figure.points.values()]
            low, high = min(ends, key=lambda end: end[1]), max(ends, key=lambda end: end[1])
            length = float(np.hypot(*(high - low)))
            for name, base in self._counted(angle):
                if self.is_new(formula(Symbol(name))) and length > _ARC:
                    level = np.array((math.copysign(1.0, high[0] - low[0]), 0.0)) if base == 0 else np.array((0.0, 1.0))
                    self._mark(name, low, level, high - low, min(_ARC, 0.5 * length))

    def _counted(self, angle: Expr) -> Iterator[tuple[str, int]]:
        """The parameter that an angle is, and whether it counts from the horizontal (0) or the vertical (1)."""
        names = free_symbols(angle)
        if len(names) == 1:
            (name,) = names
            parameter = self.system.parameters.get(name)
            try:
                at = [float(evaluate(angle, {name: x})) for x in (0.0, 0.3)]
            except (ZeroDivisionError, ValueError):  # atan(h/a) is no plain angle
                return
            is_plain = abs(abs(at[1] - at[0]) - 0.3) < 1e-9 and abs(math.remainder(at[0], math.pi / 2)) < 1e-9
            if parameter is not None and parameter.dimension == DIMENSIONLESS and is_plain:
                yield name, round(at[0] / (math.pi / 2)) % 2

    def _angles(self) -> Iterator[tuple[str, float, int]]:
        """A parameter, the direction of a line [rad], and whether the parameter counts from the horizontal (0) or the
        vertical (1)."""
        for components in self._directions():
            names = {name for part in components for name in free_symbols(part)}
            if len(names) != 1:
                continue
            (name,) = names
            parameter = self.system.parameters.get(name)
            if parameter is None or parameter.dimension != DIMENSIONLESS:
                continue
            try:
                at = [self._bearing(components, name, x) for x in (0.0, 0.3)]
                now = self._bearing(components, name, self.places.number(Symbol(name)))
            except (FreebodyError, ValueError, ZeroDivisionError):
                continue
            if abs(abs(math.remainder(at[1] - at[0], math.tau)) - 0.3) < 1e-9:
                base = round(at[0] / (math.pi / 2)) % 2
                if abs(math.remainder(at[0], math.pi / 2)) < 1e-9:
                    yield name, now, base

    def _bearing(self, components: Sequence[Expr], name: str, value: float) -> float:
        x, y = (float(evaluate(part, {name: value})) for part in components[:2])
        return math.atan2(y, x)

    def _directions(self) -> Iterable[Components]:
        for line in self.system.bodies[GROUND_NAME].lines.values():
            yield line.direction.components
        for shown in self.system.glyphs:
            if isinstance(shown.sign, (Rail, Track, Surface)) and shown.sign.along.body == GROUND_NAME:
                yield shown.sign.along.components

    def _surface(self, angle: float) -> tuple[Array, Array] | None:
        """The ends of a surface of the ground with this direction."""
        for stroke in self.drawing.strokes:
            if (
                isinstance(stroke, Path)
                and stroke.style == "surface"
                and stroke.turn == GROUND
                and not stroke.is_closed
            ):
                a, b = self.sketch.seen(self.drawing.points(stroke, 0))[[0, -1]]
                way = b - a
                if abs(math.sin(math.atan2(way[1], way[0]) - angle)) < 1e-6:
                    return a, b
        return None
