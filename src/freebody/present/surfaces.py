"""Draws lines that others touch, as surfaces with hatching on their solid side.

A particle and a rod have no thickness, but are drawn with some. A surface that only they touch is drawn lower by as
much, so that they lie on it and not in it.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from freebody.present.figures import GROUND, Array, Figure, Pair, Place, Tip, Wall, positions, turned
from freebody.present.layout import Layout, along_wall
from freebody.present.scene import Scene
from freebody.present.strokes import Path
from freebody.present.symbols import hatched

_NEAR = 0.5  # a gap at which something lies on a surface, in sizes of symbols


@dataclass(frozen=True)
class Plane:
    """Everything on one side of a straight line: normal . r >= level."""

    normal: Array
    level: float


class Surfaces:
    """The surfaces of a scene on its way."""

    def __init__(self, scene: Scene, layout: Layout) -> None:
        self.scene = scene
        self.poses = layout.poses
        self.u = layout.symbol
        self.figures = {figure.name: figure for figure in scene.figures}

    def strokes(self, low: Array, high: Array) -> Iterator[Path]:
        """Surfaces, those of the ground up to the edges of the picture. low, high: (2,) [m] its corners."""
        inset = 1.5 * self.u
        frame = [Plane(n * sign, sign * float(n @ corner) + inset) for n, sign, corner in _sides(low, high)]
        for surface in self.scene.walls:
            ends = self._visible(surface, frame) if surface.is_endless else self._used(surface)
            if ends is not None and ends[1] - ends[0] > 0.1 * self.u:
                yield from self._draw(surface, ends)

    # -- from where to where ------------------------------------------------------------------
    def _visible(self, surface: Wall, frame: Sequence[Plane]) -> Pair | None:
        """The part of an endless surface in the picture, without what the others keep everything away from."""
        names = {tip.body for tip in surface.tips}
        others = [s for s in self.scene.walls if s.is_endless and s is not surface]
        solid = [self._free_side(s) for s in others if names <= {tip.body for tip in s.tips}]
        start, along = self._at(surface, 0.0), np.array(surface.along.xy)
        ends = clipped(start, along, [*frame, *solid]) or clipped(start, along, frame)
        return ends and self._outside(surface, ends, names)

    def _outside(self, surface: Wall, ends: Pair, touching: set[str]) -> Pair:
        """The part of a surface on which it is touched, as far as it is inside no body that does not touch it."""
        low, high = ends
        start, along = np.array(surface.through.xy), np.array(surface.along.xy)
        touched = [float(along_wall(surface, tip, self.poses)[0][0]) for tip in surface.tips]
        middle = float(np.mean(touched)) if touched else 0.5 * (low + high)
        for figure in self.scene.figures:
            if figure.name in touching or len(figure.corners) < 3:
                continue
            corners = np.array([positions(self.poses, corner)[0] for corner in figure.corners])
            inside = crossed(start, along, corners)
            if inside is None or inside[1] <= low or inside[0] >= high:
                continue
            if inside[1] < middle + 0.5 * self.u:
                low = max(low, inside[1])
            elif inside[0] > middle - 0.5 * self.u:
                high = min(high, inside[0])
        return (low, high) if low < high else ends

    def _free_side(self, surface: Wall) -> Plane:
        normal = np.array(surface.along.normal().xy)
        return Plane(normal, float(normal @ self._at(surface, 0.0)))

    def _used(self, surface: Wall) -> Pair | None:
        """The edge of its body that a surface is, and farther to where something lies on it."""
        spans = [] if surface.edge is None else [surface.edge]
        for tip in surface.tips:
            s, gap = along_wall(surface, tip, self.poses)
            near = s[np.abs(gap) < max(_NEAR * self.u, 1.1 * float(np.abs(gap).min()))]
            reach = 0.0 if surface.edge else max(1.5 * tip.radius, 2 * self.u)
            spans.append((float(near.min()) - reach, float(near.max()) + reach))
        if not spans:
            return None
        return min(low for low, _ in spans), max(high for _, high in spans)

    # -- drawing ------------------------------------------------------------------------------
    def _at(self, surface: Wall, travel: float) -> Array:
        """(2,) [m] a point of the surface as drawn, in its body."""
        along, normal = np.array(surface.along.xy), np.array(surface.along.normal().xy)
        is_fixed = surface.through.body == GROUND and surface.edge is None
        lower = 0.0 if not is_fixed else min((self._surplus(tip) for tip in surface.tips), default=0.0)
        return np.array(surface.through.xy) + travel * along - lower * normal

    def _surplus(self, tip: Tip) -> float:
        figure = self.figures.get(tip.body)
        return surplus(figure, self.u) if figure and not tip.radius else 0.0

    def _draw(self, surface: Wall, ends: Pair) -> Iterator[Path]:
        body = surface.through.body
        x, y = map(float, self._at(surface, 0.0))
        low, high = ends
        line, angle = np.array([(low, 0.0), (high, 0.0)]), surface.along.angle
        yield Path(Place(body, x, y), body, turned(angle, *line.T), "surface")
        if body == GROUND and (surface.edge is None or surface.edge != ends):
            strokes = hatched(low, high, -self.u, self.u)
            yield Path(Place(body, x, y), body, turned(angle, *strokes.T), "hatch")


def surplus(figure: Figure, u: float) -> float:
    """[m] half the width that a body is drawn with and does not have: of a particle, of a rod."""
    if figure.radius is not None:
        return 0.0
    size = float(np.ptp(figure.outline, axis=0).max())
    if size < 1e-9:
        return (0.7 if figure.is_particle else 1.0) * u
    if len(figure.outline) == 2:
        return min((0.35 if figure.outside else 0.6) * u, 0.15 * size)
    return 0.0


def clipped(start: Array, along: Array, planes: Sequence[Plane]) -> Pair | None:
    """From where to where a line start + s along is on the right side of all planes; None if nowhere.
    Source: Cyrus & Beck, Computers & Graphics 3 (1978) 23."""
    low, high = -math.inf, math.inf
    for plane in planes:
        slope, room = float(plane.normal @ along), float(plane.normal @ start) - plane.level
        if abs(slope) < 1e-9:
            if room < 0:
                return None
        elif slope > 0:
            low = max(low, -room / slope)
        else:
            high = min(high, -room / slope)
    return (low, high) if low < high else None


def crossed(start: Array, along: Array, corners: Array) -> Pair | None:
    """From where to where a line start + s along crosses a polygon (n, 2); None where it misses it, or only touches."""
    away = corners - start
    across = away @ np.array([-along[1], along[0]])
    travel = away @ along
    places: list[float] = []
    for k in range(len(corners)):
        a, b = float(across[k - 1]), float(across[k])
        if a * b < 0.0:
            places.append(float(travel[k - 1] + (travel[k] - travel[k - 1]) * a / (a - b)))
    return (min(places), max(places)) if len(places) > 1 else None


def _sides(low: Array, high: Array) -> Iterator[tuple[Array, float, Array]]:
    """Normal, sign and corner of the four sides of a picture."""
    for normal in (np.array([1.0, 0.0]), np.array([0.0, 1.0])):
        yield normal, 1.0, low
        yield normal, -1.0, high
