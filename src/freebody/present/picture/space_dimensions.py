"""Dimensions in space: lengths along bodies, radii of disks, angles between axes, where the view shows them.

A length is drawn between two points of a body where it is a parameter, as in the plane. An angle is drawn where a
direction is a function of one angle p alone that it makes with its place at p = 0: with d(p) . d(0) = cos p for all p,
p is the angle between the two, and the arc lies in their plane.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from freebody.errors import FreebodyError
from freebody.language.expression import Expr, Symbol, evaluate, free_symbols
from freebody.language.units import DIMENSIONLESS
from freebody.measures.geometry import Components, Direction, Point
from freebody.model.elements import RigidBody
from freebody.model.glyphs import Glyph, Pin, Rail
from freebody.present.figures import Array, Figure, Place
from freebody.present.picture.dimensioned import INK, SIZE, Dimensioned
from freebody.present.picture.label import Label, formula
from freebody.present.picture.placer import Wish
from freebody.present.picture.shapes import Shape
from freebody.present.picture.signs import across, head
from freebody.present.picture.sketch import Sketch
from freebody.present.places import Places
from freebody.present.scene import Scene
from freebody.present.space.figures import Poses
from freebody.present.space.shells import Shells
from freebody.system.system import System

_EDGE_ON = 0.15  # cosine between the line of sight and the normal of what is seen from its edge
_ARC = 40.0  # [points]
_N_ARC = 24
_SHARE = 0.8  # of the way to where a joint is drawn, of the arc about its axis
_CROWD = 12  # how much may be near a dimension line in space
_TRIED = 0.3, 0.7  # [rad] at which an angle is compared with its parameter
_ROOM, _LEADER = 20.0, 12.0  # [points] that a radius is long for a label on it; how far its line goes on else
_RADII = (-0.6, 0.6, -2.2, 2.5, -1.2, 1.2, 0.0, 3.1)  # [rad]


@dataclass(frozen=True)
class _Bent:
    """A direction from a point (3,) [m] on, which makes the angle `name` with where it is for 0: unit vectors; reach:
    [m] how long what points there is."""

    name: str
    foot: Array
    straight: Array
    turned: Array
    reach: float
    share: float = 0.0  # of the reach, of the arc; 0: as large as arcs are


class SpaceDimensions(Dimensioned):
    """Draws dimensions into a sketch of space, each symbol of an angle once."""

    def __init__(
        self, system: System, sketch: Sketch, places: Places, scene: Scene, poses: Poses, shells: Shells
    ) -> None:
        super().__init__(system, sketch)
        self.places, self.scene, self.poses, self.shells = places, scene, poses, shells

    def draw(self) -> None:
        """Angles first, which need their place; then radii and lengths."""
        for bent in self._angles():
            if self.is_new(formula(Symbol(bent.name))):
                self._angle(bent)
        for figure in self.scene.figures:
            if figure.solid.has_flat_end and figure.axis is not None:
                self._rim(figure, self.system.bodies[figure.name])
            elif figure.solid.is_ball:
                self._ball(figure, self.system.bodies[figure.name])
        for figure in self.scene.figures:
            self._lengths(figure, self.system.bodies[figure.name])

    def _seen(self, place: Place) -> Array:
        return self.sketch.seen(self.poses.place(place, 0))

    # -- lengths ------------------------------------------------------------------------------
    def _lengths(self, figure: Figure, body: RigidBody) -> None:
        """Along a bent bar every part, along others from one joined point to the next."""
        own, is_bent = set[str](), body.name in self.system.looks.paths
        for first, second in pairwise(self._along(figure, body)):
            parts = [b - a for a, b in zip(body.points[first], body.points[second], strict=True)]
            label = self.plain(*parts)
            if label is None or (label.text in self.shown and not (is_bent and label.text in own)):
                continue
            self.dimension(label, self._seen(figure.points[first]), self._seen(figure.points[second]), 1.0, _CROWD)
            own.add(label.text)

    def _along(self, figure: Figure, body: RigidBody) -> Sequence[str]:
        path = self.system.looks.paths.get(body.name, ())
        if path or not figure.solid.has_lengths:
            return path
        used = {place for joint in self.shells.joints for place in (joint.first, joint.second)}
        return [name for name, place in figure.points.items() if place in used]

    # -- radii --------------------------------------------------------------------------------
    def _rim(self, figure: Figure, body: RigidBody) -> None:
        """From the middle of a disk to its rim: beside a disk that is seen from its edge, else on it."""
        label = self.plain(body.radius) if body.radius is not None else None
        if label is None or not self.is_new(label):
            return
        axis = self.poses.axes[0, figure.index] @ np.array(figure.axis)
        towards, middle = self.sketch.view.axes[2], self.poses.place(figure.center, 0)
        level = np.cross(axis, towards)
        if abs(float(axis @ towards)) < _EDGE_ON:
            edge = np.cross(towards, axis) / (float(np.linalg.norm(level)) or 1.0)
            down = edge if float(edge @ self.sketch.view.axes[1]) < 0.0 else -edge
            rim = middle + figure.sizes[0] * down
            self.dimension(label, self.sketch.seen(middle), self.sketch.seen(rim), 1.0, _CROWD)
            return
        first = level / float(np.linalg.norm(level)) if float(np.linalg.norm(level)) > 1e-9 else np.eye(3)[0]
        self._on_circle(label, figure, first, np.cross(axis, first))

    def _ball(self, figure: Figure, body: RigidBody) -> None:
        """From the middle of a sphere to its outline."""
        label = self.plain(body.radius) if body.radius is not None else None
        if label is not None and self.is_new(label):
            self._on_circle(label, figure, *self.sketch.view.axes[:2])

    def _on_circle(self, label: Label, figure: Figure, first: Array, second: Array) -> None:
        """The radius of a body on a circle about its middle, between two unit vectors (3,)."""
        middle = self.poses.place(figure.center, 0)
        tips = [figure.sizes[0] * (math.cos(a) * first + math.sin(a) * second) for a in _RADII]
        ends = [(self.sketch.seen(middle), self.sketch.seen(middle + tip)) for tip in tips]
        ends = [(start, end) for start, end in ends if not np.array_equal(start, end)]  # none of a disk without radius
        lines = [self._radius(start, end) for start, end in ends]
        # where the label stands beyond the end of a line, that place is to be free as well
        near = [
            [*shapes[:1], *(_beyond(*end) if _is_short(*end) else ())] for shapes, end in zip(lines, ends, strict=True)
        ]
        k = self.sketch.least_crowded(near, 30) if lines else None
        if k is None:
            return
        self.show(label)
        self.sketch.add(lines[k])
        start, end = ends[k]
        way = (end - start) / float(np.hypot(*(end - start)))
        side = across(way)
        spots = [start + share * (end - start) for share in (0.55, 0.7, 0.4)]
        places = tuple((spot, sign * side) for spot in spots for sign in (1.0, -1.0))
        if _is_short(start, end):
            far = end + _LEADER * way
            places = tuple((far, towards) for towards in (way, way + side, way - side))
        # a name may stand elsewhere, the letter at the end of a line may not
        self.sketch.wish(Wish(label, places, SIZE, INK, weight=8.0 if _is_short(start, end) else 3.0))

    def _radius(self, start: Array, end: Array) -> list[Shape]:
        """Where there is no room for its label the line goes on beyond the rim, and the label stands at its end."""
        way = (end - start) / float(np.hypot(*(end - start)))
        last = end + _LEADER * way if _is_short(start, end) else end - 4.0 * way
        return [Shape(np.array((start, last)), INK, 0.7), head(end, way, INK, 5.0)]

    # -- angles -------------------------------------------------------------------------------
    def _angle(self, bent: _Bent) -> None:
        """A dashed line where the direction would be for 0, and the arc from there."""
        side = bent.turned - float(bent.turned @ bent.straight) * bent.straight
        size = float(np.linalg.norm(side))
        normal = np.cross(bent.straight, bent.turned) / (size or 1.0)
        if size < 1e-6 or abs(float(normal @ self.sketch.view.axes[2])) < _EDGE_ON:
            return
        radius = bent.share * bent.reach or min(_ARC / self.sketch.scale, 0.75 * bent.reach)
        turn = np.linspace(0.0, math.atan2(size, float(bent.turned @ bent.straight)), _N_ARC)[:, None]
        way = bent.foot + radius * (np.cos(turn) * bent.straight + np.sin(turn) * side / size)
        dashed = np.array((bent.foot, bent.foot + (radius + 12.0 / self.sketch.scale) * bent.straight))
        self.sketch.add(Shape(self.sketch.seen(dashed), INK, 0.8, dashes=(3.0, 2.5)))
        arc, middle = self.sketch.seen(way), self.sketch.seen(bent.foot)
        self.sketch.add(Shape(arc, INK, 0.9))
        spot = arc[_N_ARC // 2]
        out = (spot - middle) / (float(np.hypot(*(spot - middle))) or 1.0)
        places = ((spot, out), (spot - 5.0 * out, -out), (arc[2 * _N_ARC // 3], out), (arc[_N_ARC // 3], out))
        self.sketch.wish(Wish(formula(Symbol(bent.name)), places, 10.5, INK, weight=4.5))
        self.show(formula(Symbol(bent.name)))

    def _angles(self) -> Iterator[_Bent]:
        yield from self._of_bars()
        yield from self._of_axes()

    def _of_bars(self) -> Iterator[_Bent]:
        for figure in self.scene.figures:
            body = self.system.bodies[figure.name]
            for first, second in pairwise(self._along(figure, body)):
                parts = tuple(b - a for a, b in zip(body.points[first], body.points[second], strict=True))
                foot = self.poses.place(figure.points[first], 0)
                reach = float(np.linalg.norm(self.poses.place(figure.points[second], 0) - foot))
                yield from self._bent(parts, figure.index, foot, reach)

    def _of_axes(self) -> Iterator[_Bent]:
        """Axes of joints, on the side on which they are drawn."""
        for shown in self.system.glyphs:
            found = _axis_of(shown.sign)
            if found is None:
                continue
            point, axis = found
            place, heading = self.places.place(point), self.places.heading(axis)
            joint = next((j for j in self.shells.joints if (j.second, j.axis) == (place, heading)), None)
            if joint is None:
                continue
            tip = self.shells.tip(joint)
            reach, share = (abs(tip), _SHARE) if tip else (_ARC / self.sketch.scale, 1.0)
            foot, index = self.poses.place(place, 0), self.places.index[axis.body]
            yield from self._bent(axis.components, index, foot, reach, math.copysign(1.0, tip), share)

    def _bent(
        self, parts: Components, body: int, foot: Array, reach: float, sign: float = 1.0, share: float = 0.0
    ) -> Iterator[_Bent]:
        """The angle that a direction of a body makes with its place at 0, if it is one parameter."""
        names = {name for part in parts for name in free_symbols(part)}
        angles = [n for n in sorted(names) if self._is_angle(n)]
        if len(angles) != 1 or reach < 1e-12:
            return
        (name,) = angles
        try:
            straight = self._direction(parts, name, 0.0)
            is_angle = all(abs(float(self._direction(parts, name, x) @ straight) - math.cos(x)) < 1e-9 for x in _TRIED)
            now = self._direction(parts, name, self.places.number(Symbol(name)))
        except (FreebodyError, ArithmeticError, ValueError):
            return
        if is_angle:
            axes = sign * self.poses.axes[0, body]
            yield _Bent(name, foot, axes @ straight, axes @ now, reach, share)

    def _is_angle(self, name: str) -> bool:
        parameter = self.system.parameters.get(name)
        return parameter is not None and parameter.dimension == DIMENSIONLESS

    def _direction(self, parts: Sequence[Expr], name: str, value: float) -> Array:
        numbers = {n: self.places.number(Symbol(n)) for part in parts for n in free_symbols(part)} | {name: value}
        found = np.array([float(evaluate(part, numbers)) for part in parts])
        return found / float(np.linalg.norm(found))


def _beyond(start: Array, end: Array) -> list[Shape]:
    """The place of a label behind the end of a line that goes on beyond a rim."""
    way = (end - start) / float(np.hypot(*(end - start)))
    far, aside = end + (_LEADER + 7.0) * way, 6.0 * across(way)
    return [Shape(np.array((far - aside, far + aside, far - aside + 6.0 * way, far + aside + 6.0 * way)))]


def _is_short(start: Array, end: Array) -> bool:
    """Whether a radius has no room for its label."""
    return float(np.hypot(*(end - start))) < _ROOM


def _axis_of(sign: Glyph) -> tuple[Point, Direction] | None:
    """Where a joint is, and what it turns about or runs along."""
    if isinstance(sign, Pin) and sign.axis is not None:
        return sign.second, sign.axis
    return (sign.point, sign.along) if isinstance(sign, Rail) else None
