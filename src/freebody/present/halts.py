"""Draws stops as short hatched walls where a body meets them, and sets up walls for springs that name no second end."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

import numpy as np

from freebody.model import glyphs
from freebody.present.figures import (
    GROUND,
    Array,
    Figure,
    Halt,
    Heading,
    Pair,
    Place,
    ShownGlyph,
    Tether,
    TurnHalt,
    angles,
    turned,
)
from freebody.present.layout import Layout, placed_in
from freebody.present.scene import Scene
from freebody.present.strokes import Path
from freebody.present.surfaces import surplus
from freebody.present.symbols import hatched

_FARTHEST = 60.0  # a stop is drawn that comes this near to what it stops, in sizes of symbols
_TETHER = 8.0  # how long a spring is drawn that names no second end, in sizes of symbols
_ARM = 0.55, 0.75  # where the wall of a turning rod stands, by the length of the rod


class Halts:
    """The stops of a scene on its way."""

    def __init__(self, scene: Scene, layout: Layout) -> None:
        self.scene = scene
        self.poses = layout.poses
        self.u = layout.symbol

    def strokes(self) -> Iterator[Path]:
        for halt in self.scene.halts:
            yield from self._straight(halt) if isinstance(halt, glyphs.Halt) else self._turning(halt)

    # -- of a point on its way ----------------------------------------------------------------
    def _straight(self, halt: Halt) -> Iterator[Path]:
        """A wall across the direction, as far from the point's last place as its body reaches."""
        figure = self.scene.figure_of(halt.point.body)
        body, e, n = halt.along.body, np.array(halt.along.xy), np.array(halt.along.normal().xy)
        origin = np.array(halt.origin.xy)
        away = placed_in(self.poses, body, halt.point) - origin
        room = halt.side * (away @ e - halt.limit)
        if figure is None or room.min() > _FARTHEST * self.u:
            return
        ahead, (low, high) = self._reach(figure, halt)
        foot = origin + (halt.limit - halt.side * ahead) * e
        across = away @ n
        ends = float(across.min()) + low, float(across.max()) + high
        x, y = foot
        yield from self._wall(Place(body, float(x), float(y)), halt.along.normal().angle, ends, halt.side)

    def _reach(self, figure: Figure, halt: Halt) -> tuple[float, Pair]:
        """How far a body reaches towards the stop, and to the right and left of its point."""
        slides = any(rail.point.body == figure.index and rail.turning == "not" for rail in self.scene.rails)
        e, n = np.array(halt.along.xy), np.array(halt.along.normal().xy)
        points = self._points(figure, halt.along.body) - placed_in(self.poses, halt.along.body, halt.point)[0]
        if figure.radius is None and float(np.ptp(points, axis=0).max()) < 1e-9:
            long, tall = (1.5, 0.8) if slides else (0.7, 0.7) if figure.is_particle else (1.0, 1.0)
            return long * self.u, (-1.2 * tall * self.u, 1.2 * tall * self.u)
        ahead = float((points @ (-halt.side * e)).max())
        return ahead, (float((points @ n).min()), float((points @ n).max()))

    def _points(self, figure: Figure, body: int) -> Array:
        """(n, 2) [m] the outline of a body at the start, by components in another body."""
        if figure.radius is not None:
            center, ring = figure.center, figure.radius * np.array([(1, 0), (0, 1), (-1, 0), (0, -1)])
            places = [Place(center.body, center.x + x, center.y + y) for x, y in ring.tolist()]
        else:
            places = [Place(figure.index, x, y) for x, y in figure.outline.tolist()]
        return np.concatenate([placed_in(self.poses[:1], body, place) for place in places])

    # -- behind a spring ----------------------------------------------------------------------
    def walled(self) -> tuple[Scene, list[Path]]:
        """The scene with a spring from a wall in place of each tether, and the walls; those of one point share one."""
        shown, walls = list[ShownGlyph](), dict[Place, list[Path]]()
        for one in self.scene.shown:
            if isinstance(one.sign, glyphs.Tether) and (figure := self.scene.figure_of(one.sign.point.body)):
                tether = one.sign
                foot, end, walls[foot] = self._anchor(tether, figure)
                one = replace(one, sign=glyphs.Spring(foot, end, tether.is_spring, tether.is_damper))
            shown.append(one)
        return replace(self.scene, shown=tuple(shown)), [path for wall in walls.values() for path in wall]

    def _anchor(self, tether: Tether, figure: Figure) -> tuple[Place, Place, list[Path]]:
        """Where the wall stands and where the spring ends on the body, and the wall. It stands on the line of the
        tether, behind the point at the start and on the way, or before it where other bodies lie behind it and none
        before it."""
        body, e, n = tether.along.body, np.array(tether.along.xy), np.array(tether.along.normal().xy)
        away = placed_in(self.poses, body, tether.point)
        gaps = [placed_in(self.poses[:1], body, f.mass_center)[0] - away[0] for f in self.scene.figures if f != figure]
        beside = [float(gap @ e) for gap in gaps if abs(gap @ n) < 2 * self.u and abs(gap @ e) > self.u]
        side = -1 if any(x < 0 for x in beside) and not any(x > 0 for x in beside) else 1
        ahead, _ends = self._reach(figure, glyphs.Halt(tether.point, tether.point, tether.along, 0.0, side))
        nearest = float((side * (away @ e)).min()) - ahead - _TETHER * self.u
        x, y = side * nearest * e + float(away[0] @ n) * n
        foot = Place(body, float(x), float(y))
        half = 1.6 * self.u
        end = tether.point
        if figure.radius is not None or len(figure.outline) > 2:  # at its edge, as it lies at the start
            turn = float(
                angles(self.poses[:1], tether.along)[0] - angles(self.poses[:1], Heading(end.body, 1.0, 0.0))[0]
            )
            x, y = np.array(end.xy) - side * ahead * np.array((np.cos(turn), np.sin(turn)))
            end = Place(end.body, float(x), float(y))
        # a spring that ends on the ground has its wall there from what draws springs
        wall = [] if body == GROUND else list(self._wall(foot, tether.along.normal().angle, (-half, half), side))
        return foot, end, wall

    # -- of a turning rod ---------------------------------------------------------------------
    def _turning(self, halt: TurnHalt) -> Iterator[Path]:
        """A wall beside the rod where it may turn no farther, if the rod turns about a pin on the base."""
        figure, pivot = self.scene.figure_of(halt.of.body), self._pivot(halt)
        if figure is None or pivot is None or figure.radius is not None or len(figure.outline) != 2:
            return
        inner, outer = pivot
        arms = figure.outline - np.array(inner.xy)
        arm = arms[int(np.hypot(*arms.T).argmax())]
        length = float(np.hypot(*arm))
        angle = halt.limit + halt.origin.angle + float(np.arctan2(arm[1], arm[0]))
        aside = -halt.side * surplus(figure, self.u)
        x, y = np.array(outer.xy) + turned(angle, 0.0, aside)
        ends = _ARM[0] * length, _ARM[1] * length
        yield from self._wall(Place(outer.body, float(x), float(y)), angle, ends, -halt.side)

    def _pivot(self, halt: TurnHalt) -> tuple[Place, Place] | None:
        """The pin of a body on the base of its stop: its place in the one and in the other."""
        for pin in self.scene.pins:
            for a, b in (pin, pin[::-1]):
                if (a.body, b.body) == (halt.of.body, halt.origin.body):
                    return a, b
        return None

    def _wall(self, place: Place, angle: float, ends: Pair, side: int) -> Iterator[Path]:
        """A line with hatching on its left (side +1) or on its right."""
        low, high = ends
        line = np.array([(low, 0.0), (high, 0.0)])
        yield Path(place, place.body, turned(angle, *line.T), "surface")
        strokes = hatched(low, high, side * 0.8 * self.u, 0.75 * self.u)
        yield Path(place, place.body, turned(angle, *strokes.T), "hatch")
