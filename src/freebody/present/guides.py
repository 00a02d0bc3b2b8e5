"""Draws what guides points and bodies of the plane: rails, slots, the lines on which circles roll, grooves."""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Iterator
from dataclasses import replace

import numpy as np

from freebody.model import glyphs
from freebody.present.figures import GROUND, Array, Figure, Groove, Heading, Place, Rail, Track, positions, turned
from freebody.present.layout import extent_across, travel
from freebody.present.scene import Scene
from freebody.present.strokes import Path, Stroke
from freebody.present.symbols import TOOTH, capsule, circle, hatched, n_teeth, support, toothed

_RAIL = 6.0  # half of the rail of what is short, in sizes of symbols
_SHORT = 5.0  # what is shorter, in sizes of symbols
_FAR = 60.0  # a rail goes on to what is nearer, in sizes of symbols
_ROLLED_ON = 2.6  # half of a line on which a wheel rolls, by the radius of the wheel


class Guides:
    """The guides of a scene on its way. poses: (n_times, n_bodies, 3); u: [m] the size of symbols."""

    def __init__(self, scene: Scene, poses: Array, u: float) -> None:
        self.scene, self.poses, self.u = scene, poses, u

    def strokes(self) -> Iterator[Stroke]:
        for sign in self.scene.signs:
            match sign:
                case glyphs.Rail():
                    yield from self._rail(sign)
                case glyphs.Face(through, point, normal, turning):
                    edge = glyphs.Rail(
                        through, point, normal.quarter_back(), "freely" if turning == "freely" else "not"
                    )
                    yield from self._rail(edge)
                case glyphs.Track():
                    yield from self._track(sign)
                case glyphs.Groove():
                    yield from self._groove(sign)
                case _:
                    pass

    def _rail(self, rail: Rail) -> Iterator[Stroke]:
        """A hatched rail on the ground, a line on a body; a slot for a pin that turns in it. Rails that lie on one line
        and nearly meet are one."""
        if rail.is_support:
            yield from self._support(rail)
            return
        if rail.turning != "not":
            low, high, level = self._run(rail.point, rail.along, (3.0 * self.u, 3.0 * self.u))
            slot = capsule((low, 0.0), (high, 0.0), 0.9 * self.u)
            yield self._on_line(rail.along, level, slot, "slot", is_closed=True)
            return
        low, high, level = self._guided(rail)
        others = [other for other in self.scene.rails if _goes_along(other, rail)]
        runs = [self._guided(other) for other in others]
        of_line = sorted((a, b, k) for k, (a, b, at) in enumerate(runs) if abs(at - level) < 0.1 * self.u)
        together = [of_line[0]] if of_line else []
        for run in of_line[1:]:
            if run[0] > max(b for _a, b, _k in together) + 2 * _RAIL * self.u:
                if any(others[k] is rail for *_, k in together):
                    break
                together = []
            together.append(run)
        if together and others[min(k for *_, k in together)] is not rail:
            return  # drawn with the first of them
        low, high = min([low, *(a for a, _b, _k in together)]), max([high, *(b for _a, b, _k in together)])
        yield from self._edge(rail.along, level, low, high, -1.0)

    def _support(self, rail: Rail) -> Iterator[Stroke]:
        """A triangle on rollers, on the ground below, or on that side of an upright line that the bodies are not on: to
        the right, where they are on neither."""
        at = positions(self.poses, rail.point)[0]
        x, y = turned(rail.along.angle, 0.0, 1.0)
        centers = [positions(self.poses, figure.mass_center)[0] for figure in self.scene.figures]
        inward = float(np.mean([(center - at) @ (x, y) for center in centers]))
        upright = math.copysign(1.0, x if abs(inward) < 1e-6 * self.u else -inward)
        side = upright if abs(y) <= 1e-6 else -math.copysign(1.0, y)
        angle = math.atan2(side * y, side * x) + np.pi / 2
        for points, style, is_closed in support(self.u, on_rollers=True):
            yield Path(Place(GROUND, *map(float, at)), GROUND, turned(angle, *points.T), style, is_closed)

    def _guided(self, rail: Rail) -> tuple[float, float, float]:
        """From where to where a body needs its rail, up to the springs that hold it from the ground on this line, and
        how far on the left of the origin the rail is [m]."""
        figure = self.scene.figure_of(rail.point.body)
        back, ahead = self._lengths(figure, rail.point, rail.along)
        is_short = back + ahead < _SHORT * self.u
        more = max(0.5 * (2 * _RAIL * self.u - back - ahead), self.u) if is_short else self.u
        low, high, level = self._run(rail.point, rail.along, (back + more, ahead + more))
        for foot in self._held_from(rail):
            s, across = travel(foot, rail.along, self.poses)
            if abs(float(across[0]) - level) < self.u and low - _FAR * self.u < s[0] < high + _FAR * self.u:
                low, high = min(low, float(s[0])), max(high, float(s[0]))
        below, above = extent_across(figure, rail.point, rail.along, self.poses) if figure else (0.0, 0.0)
        level += below if below < -1e-9 else -0.8 * self.u if above < 1e-9 else 0.0
        return low, high, level

    def _held_from(self, rail: Rail) -> Iterator[Place]:
        """The places of its guide from which springs hold what slides on a rail. Several side by side would lie on its
        hatching."""
        held = Counter[tuple[Place, Place]]()
        for spring in self.scene.springs:
            ends = spring.first, spring.second
            for foot, end in (ends, ends[::-1]):
                if foot.body == rail.along.body == GROUND and end.body == rail.point.body:
                    held[foot, end] += 1
        yield from (foot for (foot, _end), n in held.items() if n == 1)

    def _track(self, track: Track) -> Iterator[Stroke]:
        """The line on which a circle rolls, unless it is a surface for others too."""
        if track.radius == 0.0:  # it lies on its line, which has no side
            return
        side = math.copysign(1.0, track.radius)
        sharing = [other for other in self.scene.tracks if self._share_line(track, other)]
        runs = [self._rolled(other) for other in sharing]
        low, high, level = min(run[0] for run in runs), max(run[1] for run in runs), runs[0][2]
        if track.is_toothed:
            yield self._teeth(track, level, low, high)
            return
        if sharing[0] is track and not self._is_drawn(track.along, level):
            yield from self._edge(track.along, level, low, high, -side)

    def _teeth(self, track: Track, level: float, low: float, high: float) -> Stroke:
        """The teeth of a rack, as long as its body; at the start a gap faces the pinion."""
        rack = self.scene.figure_of(track.along.body)
        if rack is not None and len(rack.outline) > 1:
            back, ahead = self._lengths(rack, rack.mass_center, track.along)
            at = rack.mass_center.x * track.along.x + rack.mass_center.y * track.along.y
            low, high = at - back, at + ahead
        pitch = 2 * math.pi * abs(track.radius) / n_teeth(abs(track.radius), self.u)
        facing = float(travel(track.center, track.along, self.poses)[0][0])
        first, last = (math.floor((end - facing) / pitch + 0.5 * way) for end, way in ((low, 1.0), (high, -1.0)))
        side = math.copysign(1.0, track.radius)
        teeth = [
            np.array(TOOTH) * (pitch, side * pitch) + (facing + (k + 0.5) * pitch, 0.0) for k in range(first, last)
        ]
        points = np.concatenate(([(low, 0.0)], *teeth, [(high, 0.0)]))
        moves = rack is not None and track.along.body != GROUND
        path = self._on_line(track.along, level, points, "body" if moves else "surface", is_closed=moves)
        return replace(path, color=-1 if rack is None else rack.number)

    def edge(self, wheel: Figure, rim: float) -> Array:
        """(n, 2) that of a wheel: a circle of a radius, or on a rack its teeth, of which one faces it at the start."""
        radius = wheel.radius or 0.0
        tracks = (track for track in self.scene.tracks if track.is_toothed and track.center == wheel.center)
        track = next((each for each in tracks if abs(abs(each.radius) - radius) < 1e-9 * radius), None)
        if track is None or wheel.index == GROUND:
            return circle(rim, 24)
        facing = track.along.angle - math.copysign(np.pi / 2, track.radius)
        for body, sense in ((track.along.body, 1.0), (wheel.index, -1.0)):
            facing += 0.0 if body == GROUND else sense * float(self.poses[0, body, 2])
        return turned(facing, *toothed(radius, n_teeth(radius, self.u)).T)

    def _rolled(self, track: Track) -> tuple[float, float, float]:
        """From where to where one circle needs its line, and how far on the left of the origin that is [m]."""
        lengths = self._lengths(self.scene.figure_of(track.center.body), track.center, track.along)
        reach = max(_ROLLED_ON * abs(track.radius), *lengths, 2 * self.u) + self.u
        low, high, level = self._run(track.center, track.along, (reach, reach))
        return low, high, level - track.radius

    def _share_line(self, a: Track, b: Track) -> bool:
        """Whether two circles roll on the same side of one line, which is drawn once."""
        if a.along.body != b.along.body or a.radius * b.radius <= 0:
            return False
        levels = [self._rolled(track)[2] for track in (a, b)]
        is_same_way = float(np.hypot(a.along.x - b.along.x, a.along.y - b.along.y)) < 1e-9
        return is_same_way and abs(levels[0] - levels[1]) < 1e-6

    def _groove(self, groove: Groove) -> Iterator[Stroke]:
        """The two edges of a circular groove."""
        turn = groove.center.body
        for radius in (groove.radius - 0.9 * self.u, groove.radius + 0.9 * self.u):
            if radius > 0.0:
                yield Path(groove.center, turn, circle(radius, 24), "slot", True)

    def _run(self, point: Place, along: Heading, reach: tuple[float, float]) -> tuple[float, float, float]:
        """From where to where a point goes along a line, with some reach behind it and ahead, and how far on its left
        it starts [m]."""
        s, across = travel(point, along, self.poses)
        return float(s.min()) - reach[0], float(s.max()) + reach[1], float(across[0])

    def _edge(self, along: Heading, level: float, low: float, high: float, side: float) -> Iterator[Stroke]:
        """A line, hatched on one side on the ground."""
        yield self._on_line(along, level, np.array([(low, 0.0), (high, 0.0)]), "surface")
        if along.body == GROUND:
            yield self._on_line(along, level, hatched(low, high, side * self.u, self.u), "hatch")

    def _on_line(self, along: Heading, level: float, points: Array, style: str, *, is_closed: bool = False) -> Path:
        """A path given along and across a line."""
        start = turned(along.angle + np.pi / 2, 1.0, 0.0) * level
        return Path(Place(along.body, *map(float, start)), along.body, turned(along.angle, *points.T), style, is_closed)

    def _is_drawn(self, along: Heading, level: float) -> bool:
        """Whether a line is a surface for others too, which is drawn at full length."""
        for wall in self.scene.walls:
            turn = along.x * wall.along.y - along.y * wall.along.x
            height = wall.through.y * along.x - wall.through.x * along.y
            if wall.along.body == along.body and max(abs(turn), abs(height - level)) < 1e-6:
                return True
        return False

    def _lengths(self, figure: Figure | None, point: Place, along: Heading) -> tuple[float, float]:
        """[m] how far a body reaches behind a point and ahead of it along a line."""
        if figure is None or figure.is_particle:
            return 0.0, 0.0
        low, high = extent_across(figure, point, along.quarter_back(), self.poses)
        return -low, high


def _goes_along(other: Rail, rail: Rail) -> bool:
    """Whether a body slides on another rail of the same direction."""
    a, b = other.along, rail.along
    return other.turning == "not" and a.body == b.body and abs(a.x - b.x) + abs(a.y - b.y) < 1e-9
