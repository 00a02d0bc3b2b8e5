"""A planar drawing as shapes on paper."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import replace

import numpy as np

from freebody.model.glyphs import Equation, Field, Halt, Spread, Surface, Touch, TurnHalt
from freebody.present.drawing import Drawing
from freebody.present.figures import GROUND, Array, Drawn, hull, owners
from freebody.present.layout import bounds
from freebody.present.names import Painted
from freebody.present.picture.shapes import Ink, Shape
from freebody.present.picture.sketch import Sketch
from freebody.present.scene import Scene
from freebody.present.strokes import Path, Strand, Stroke
from freebody.present.theme import style_of

SYMBOL = 6.5  # [points] the size of symbols on paper
_LARGEST = 36.0  # [points] radius of a round body beside lines and strings that go on
_LARGEST_ON_PAPER = (390.0, 540.0)  # [points] width and height that a page takes without making the words smaller
_LEAST = 1e-9  # [m] what is smaller has no size


def sketched(
    scene: Scene, pose: Array, room: tuple[float, float], least: tuple[float, float] = (0.0, 0.0)
) -> tuple[Drawing, Sketch]:
    """The drawing of one instant and a sketch with its strokes, as large as fits into a room [points]; surfaces run on
    as far as `least` [points]. pose: (n_moving_bodies, 3)."""
    poses = np.asarray(pose, dtype=np.float64).reshape(1, -1, 3)
    low, high = bounds(scene, poses)
    scale = min(_scale(high - low, room), _most(scene))
    drawing = _drawn(scene, poses, scale, least)
    low, high = bounds(scene, drawing.poses)
    if drawing.moved:  # it may need more room
        scale = min(_scale(high - low, room), _most(scene))
        drawing = _drawn(scene, poses, scale, least)
        low, high = bounds(scene, drawing.poses)
    most = _scale(drawing.high - drawing.low, _LARGEST_ON_PAPER)
    if scale > most:  # the lines on which bodies lie and roll are no part of the bounds
        scale = most
        drawing = _drawn(scene, poses, scale, least)
        low, high = bounds(scene, drawing.poses)
    sketch = Sketch(scale, (low + high) / 2)
    sketch.add(shapes(drawing, sketch))
    return drawing, sketch


def _drawn(scene: Scene, poses: Array, scale: float, least: tuple[float, float]) -> Drawing:
    wide, tall = least
    return Drawing.of(scene, poses, symbol=SYMBOL / scale, least=(wide / scale, tall / scale))


def _scale(size: Array, room: tuple[float, float]) -> float:
    """[points by m]"""
    fits = [have / need for have, need in zip(room, size.tolist(), strict=True) if need > _LEAST]
    return min(fits, default=SYMBOL)


def _most(scene: Scene) -> float:
    """[points by m] What leaves room for the lines that bodies roll and lie on, and for what hangs on strings: where
    these are drawn, their lengths are free, and round bodies do not fill the picture."""
    is_open = any(wall.is_endless for wall in scene.walls) or any(t.along.body == GROUND for t in scene.tracks)
    if not is_open and not scene.ropes:
        return math.inf
    radii = [figure.radius for figure in scene.figures if figure.radius and not scene.is_fixed(figure.index)]
    return _LARGEST / max(radii) if radii else math.inf


def shapes(drawing: Drawing, sketch: Sketch) -> Iterator[Shape]:
    """The strokes of the first instant."""
    names = {figure.number: f"body {figure.name}" for figure in drawing.scene.figures}
    for stroke in drawing.shown(0):
        of = names.get(stroke.color, "") if isinstance(stroke, Path) else ""
        yield replace(shape_of(stroke, sketch.seen(drawing.points(stroke, 0))), of=of)


def painted(drawing: Drawing, frame: int) -> list[Painted]:
    """The strokes of one instant, in metres, in the order in which they lie on each other."""
    return [_painted(stroke, drawing.points(stroke, frame)) for stroke in drawing.shown(frame)]


def _painted(stroke: Stroke, points: Array) -> Painted:
    is_area = not isinstance(stroke, Strand) and stroke.is_closed
    outline = hull(points) if is_area else np.zeros((0, 2))
    return Painted(stroke.color if isinstance(stroke, Path) else -1, (shape_of(stroke, points),), outline)


def shape_of(stroke: Stroke, points: Array) -> Shape:
    style = style_of(stroke.style)
    body = stroke.color if isinstance(stroke, Path) else -1
    edge = Ink(style.stroke, body) if style.stroke else None
    if isinstance(stroke, Strand) or not stroke.is_closed:
        return Shape(points, edge, style.width, dashes=style.dashes)
    fill = Ink(style.fill, body, style.alpha) if style.fill else None
    return Shape(points, edge, style.width, fill, is_closed=True, dashes=style.dashes)


def part_of(scene: Scene, bodies: Sequence[str]) -> Scene:
    """The scene of some bodies alone: what joins them with each other."""
    figures = tuple(figure for figure in scene.figures if figure.name in bodies)
    kept = {k for k, name in enumerate(scene.names) if name in bodies}

    def is_inside(sign: Drawn) -> bool:
        match sign:
            case Touch(first, second):
                return first in bodies and second in bodies
            case Surface() | Halt() | TurnHalt() | Equation() | Field() | Spread():
                return False
            case _:
                return owners(sign) <= kept

    shown = tuple(shown for shown in scene.shown if is_inside(shown.sign))
    figures = tuple(
        replace(
            f,
            outside=tuple(name for name in f.outside if name in bodies),
            inside=tuple(name for name in f.inside if name in bodies),
        )
        for f in figures
    )
    return replace(scene, figures=figures, shown=shown)
