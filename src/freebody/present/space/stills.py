"""Pictures in space of single instants: to a file, or frame by frame with Matplotlib for films."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np

from freebody.errors import InputError
from freebody.language.plain_text import plain, shortened
from freebody.present.figures import Array
from freebody.present.picture import pixels
from freebody.present.picture.shapes import Shape
from freebody.present.scene import Scene
from freebody.present.space.corner import corner_marks
from freebody.present.space.drawing import Drawing
from freebody.present.space.labels import Footprint, names
from freebody.present.space.looks import OF_BODIES
from freebody.present.space.painter import Shot, paint, shots
from freebody.present.theme import THEMES, Theme
from freebody.present.view import AZIMUTH, ELEVATION, View

_WIDTH = 7.2  # inches
_SHAPES = (0.55, 1.1)  # height by width
_LETTER, _FONT = 0.56, 9.0  # width of a letter by its height; points
_PER_INCH = 72.0
_PATIENCE = 10  # frames


def draw(
    scene: Scene,
    center: Array,
    axes: Array,
    path: str | Path,
    *,
    title: str = "",
    view: tuple[float, float] = (AZIMUTH, ELEVATION),
    perspective: bool = False,
    dark: bool = False,
) -> Path:
    """Writes a picture of one instant as `.svg`, `.png`, `.pdf` or `.tex`, by the suffix of the path.

    center: (n_moving, 3) [m] of the mass centres; axes: (n_moving, 3, 3), whose columns are the bodies' axes, in the
    order of `scene.names`. view: azimuth and elevation of the viewer [deg]. Returns the path. Raises InputError for
    another suffix, poses that do not fit, or a file that cannot be written."""
    from freebody.present.picture.picture import checked_path
    from freebody.present.picture.space import SpaceSketch

    path = checked_path(path)
    center, axes = checked(scene, center, axes, 1)
    sketch = SpaceSketch(Drawing.of(scene, center, axes), view, perspective=perspective)
    sketch.add_corner()
    return sketch.finished(title or scene.title, description(scene)).write(path, dark=dark)


def checked(scene: Scene, centers: Array, axes: Array, n_times: int) -> tuple[Array, Array]:
    """Poses of the moving bodies at some times, (n_times, n, 3) and (n_times, n, 3, 3). Raises InputError if they do
    not fit."""
    n = len(scene.names)
    centers, axes = np.asarray(centers, dtype=np.float64), np.asarray(axes, dtype=np.float64)
    if n_times == 1 and centers.shape == (n, 3) and axes.shape == (n, 3, 3):
        centers, axes = centers[None], axes[None]
    if centers.shape != (n_times, n, 3) or axes.shape != (n_times, n, 3, 3):
        raise InputError(
            f"a picture of {n} moving bodies needs centres ({n_times}, {n}, 3) and axes ({n_times}, {n}, 3, 3), not "
            f"{centers.shape} and {axes.shape}"
        )
    if not (np.isfinite(centers).all() and np.isfinite(axes).all()):
        raise InputError("the poses of a picture must be finite numbers")
    return centers, axes


def description(scene: Scene) -> str:
    """What a picture shows, in words."""
    return f"{scene.title}, drawn in space; bodies: {', '.join(form.name for form in scene.figures)}"


# -- figures ----------------------------------------------------------------------------------
class Stage:
    """A Matplotlib figure for one view of a drawing."""

    def __init__(self, figure: Any, axes: Any, view: View, theme: Theme, *, dark: bool, letter: float) -> None:
        self.canvas_figure, self.axes, self.view, self.theme = figure, axes, view, theme
        self.is_dark = dark
        self.letter = letter  # [m] on paper, height of a letter
        self.low, self.high = np.zeros(2), np.zeros(2)
        self.choices: dict[str, int] = {}


def figure_of(
    drawing: Drawing,
    angles: tuple[float, float],
    *,
    perspective: bool = False,
    title: str = "",
    dark: bool = False,
    width: float = _WIDTH,
    is_film: bool = False,
) -> Stage:
    """An empty figure, as wide as said [inches] and as high as it needs; for a film an even number of pixels."""
    from matplotlib.backends.backend_agg import FigureCanvasAgg
    from matplotlib.figure import Figure

    view, theme = drawing.view(angles, perspective=perspective), THEMES["dark" if dark else "light"]
    low, high = drawing.bounds(view)
    wide, tall = high - low
    # room for names round the bodies, and a strip below for the axes
    head, foot = (0.45 if title else 0.12), 1.25
    room = 0.4
    shape = min(_SHAPES[1], max(_SHAPES[0], tall / wide))
    height = shape * (width - 2 * room)
    scale = min((width - 2 * room) / wide, height / tall)  # inches by metre
    page = height + 0.5 * room + head + foot
    page = round(50 * page) / 50 if is_film else page
    figure: Any = Figure(figsize=(width, page), dpi=100)
    FigureCanvasAgg(figure)
    figure.set_facecolor(theme.paper)
    axes = figure.add_axes((0.0, 0.0, 1.0, 1.0))
    axes.set_axis_off()
    stage = Stage(figure, axes, view, theme, dark=dark, letter=_FONT / _PER_INCH / scale)
    middle = 0.5 * (low + high)
    stage.low = middle - np.array((0.5 * width, 0.5 * height + foot)) / scale
    stage.high = stage.low + np.array((width, page)) / scale
    axes.set_xlim(stage.low[0], stage.high[0])
    axes.set_ylim(stage.low[1], stage.high[1])
    if title:
        look: dict[str, Any] = {"fontsize": 11, "color": theme.ink, "parse_math": False}
        figure.text(0.5, 1.0 - 0.24 / page, shortened(plain(title), 100), ha="center", va="center", **look)
    return stage


def paint_frame(stage: Stage, drawing: Drawing, frame: int) -> list[Any]:
    """Draws one instant; returns the artists. In a film names look for better places now and then."""
    taken = shots(drawing, frame, stage.view)
    shapes: list[Shape] = []
    owned: dict[int, list[tuple[Shot, list[Shape]]]] = {}
    for shot in taken:
        painted = list(paint(shot, is_dark=stage.is_dark))
        shapes += painted
        if shot.piece.look != "plane":
            owned.setdefault(owner(shot), []).append((shot, painted))
    letter = (_LETTER * stage.letter, stage.letter)
    corner, words = corner_marks(drawing, stage.view, stage.low, stage.letter)
    artists = [pixels.paint([*shapes, *corner], stage.axes, dark=stage.is_dark)]
    for at, text, color in words:
        artists.append(_text(stage, at, text, color))
    bodies = {form.index: form.name for form in drawing.scene.figures}
    foot = stage.low + np.array((0.0, 8.0 * stage.letter))
    inks = {index: Footprint.of(own, stage.letter) for index, own in owned.items()}
    found = names(inks, bodies, letter, (foot, stage.high), stage.choices, stays=frame % _PATIENCE != 0)
    stage.choices = {name.text: name.choice for name in found}
    artists.extend(_text(stage, name.at, name.text, "ink") for name in found)
    return artists


def owner(shot: Shot) -> int:
    """The index of the body that a piece is, -1 for what joins bodies."""
    return shot.piece.turn if shot.piece.look in OF_BODIES else -1


def _text(stage: Stage, at: Array, text: str, color: str) -> Any:
    from matplotlib.patheffects import withStroke

    halo = [withStroke(linewidth=2.5, foreground=stage.theme.paper)]
    ink = stage.theme.color(color, -1)
    look: Mapping[str, Any] = {"fontsize": _FONT, "parse_math": False, "path_effects": halo, "zorder": 9}
    return stage.axes.text(at[0], at[1], text, ha="center", va="center_baseline", color=ink, **look)
