"""A drawing on its way, in a Matplotlib figure, one frame after the other: for films."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from freebody.language.plain_text import plain, shortened
from freebody.present.corner import corner_marks
from freebody.present.drawing import Drawing
from freebody.present.figures import Array, positions
from freebody.present.names import Painted, footprints, names
from freebody.present.picture import pixels, plane
from freebody.present.scene import Scene
from freebody.present.theme import THEMES, Theme
from freebody.present.view import View

_SHAPES = (0.55, 1.1)  # height by width
_LETTER, _FONT = 0.56, 9.0  # width of a letter by its height; points
_PER_INCH = 72.0
_PATIENCE = 10  # frames
_CORNER = 8.0  # heights of letters that the axes take
_MOST_IN_TITLE = 100


@dataclass(frozen=True)
class Show:
    """What is put on a stage: strokes of the plane or pieces of space.

    painted: by the frame and whether it is on dark paper; bounds: (2,), (2,) [m] corners on paper of all frames;
    called: names of the bodies by the numbers of their owners; words: at a frame, where (2,) and what; note: what else
    to know."""

    scene: Scene
    view: View
    bounds: tuple[Array, Array]
    painted: Callable[[int, bool], Sequence[Painted]]
    called: Mapping[int, str]
    words: Callable[[int], Sequence[tuple[Array, str]]] = lambda _frame: ()
    has_lengths: bool = True
    note: str = ""


def show_of_plane(drawing: Drawing, note: str = "") -> Show:
    """A planar drawing, seen along z."""

    def words(frame: int) -> list[tuple[Array, str]]:
        poses, u = drawing.poses[frame : frame + 1], drawing.symbol
        return [(positions(poses, w.place)[0] + u * np.array((w.dx, w.dy)), w.text) for w in drawing.words]

    def painted(frame: int, _is_dark: bool) -> list[Painted]:
        return plane.painted(drawing, frame)

    called = {figure.number: figure.name for figure in drawing.scene.figures}
    bounds = drawing.low, drawing.high
    return Show(drawing.scene, View(np.eye(3), np.zeros(3)), bounds, painted, called, words, note=note)


@dataclass
class Stage:
    """A Matplotlib figure for one view of a drawing. letter: [m] the height of one on paper; low, high: corners of the
    paper; tell: a message in the language of the picture; choices: where names were last."""

    show: Show
    figure: Any
    axes: Any
    theme: Theme
    is_dark: bool
    letter: float
    low: Array
    high: Array
    tell: Callable[[str], str] = str
    choices: dict[str, int] = field(default_factory=dict[str, int])

    @classmethod
    def of(
        cls, show: Show, width: float, *, title: str = "", dark: bool = False, tell: Callable[[str], str] = str
    ) -> Stage:
        """An empty figure, as wide as said [inches] and as high as it needs, an even number of pixels."""
        from matplotlib.backends.backend_agg import FigureCanvasAgg
        from matplotlib.figure import Figure

        theme = THEMES["dark" if dark else "light"]
        low, high = show.bounds
        wide, tall = high - low
        # room for names round the bodies, and a strip below for the axes
        head, foot = (0.45 if title else 0.12) + (0.25 if show.note else 0.0), 1.25
        room = 0.4
        shape = min(_SHAPES[1], max(_SHAPES[0], tall / wide))
        height = shape * (width - 2 * room)
        scale = min((width - 2 * room) / wide, height / tall)  # inches by metre
        page = round(50 * (height + 0.5 * room + head + foot)) / 50
        figure: Any = Figure(figsize=(width, page), dpi=100)
        FigureCanvasAgg(figure)
        figure.set_facecolor(theme.paper)
        axes = figure.add_axes((0.0, 0.0, 1.0, 1.0))
        axes.set_axis_off()
        corner = 0.5 * (low + high) - np.array((0.5 * width, 0.5 * height + foot)) / scale
        paper = np.array((width, page)) / scale
        axes.set_xlim(corner[0], corner[0] + paper[0])
        axes.set_ylim(corner[1], corner[1] + paper[1])
        look: dict[str, Any] = {"parse_math": False, "ha": "center", "va": "center"}
        if title:
            text = shortened(plain(title), _MOST_IN_TITLE)
            figure.text(0.5, 1.0 - 0.24 / page, text, fontsize=11, color=theme.ink, **look)
        if show.note:
            below = 1.0 - (head - 0.1) / page
            figure.text(0.5, below, plain(tell(show.note)), fontsize=7, color=theme.muted, wrap=True, **look)
        letter = _FONT / _PER_INCH / scale
        return cls(show, figure, axes, theme, dark, letter, corner, corner + paper, tell)

    def paint(self, frame: int) -> list[Any]:
        """Draws one instant; returns the artists. In a film names look for better places now and then."""
        painted = self.show.painted(frame, self.is_dark)
        shapes = [shape for own in painted for shape in own.shapes]
        gravity, has_lengths = self.show.scene.gravity, self.show.has_lengths
        corner, words = corner_marks(gravity, self.show.view, self.low, self.letter, has_lengths=has_lengths)
        artists = [pixels.paint([*shapes, *corner], self.axes, dark=self.is_dark)]
        artists += [self._text(at, self.tell(text), color) for at, text, color in words]
        artists += [self._text(at, text, "ink") for at, text in self.show.words(frame)]
        frame_of = self.low + np.array((0.0, _CORNER * self.letter)), self.high
        inks = footprints(painted, self.letter)
        size = _LETTER * self.letter, self.letter
        found = names(inks, self.show.called, size, frame_of, self.choices, stays=frame % _PATIENCE != 0)
        self.choices = {name.text: name.choice for name in found}
        return [*artists, *(self._text(name.at, name.text, "ink") for name in found)]

    def _text(self, at: Array, text: str, color: str) -> Any:
        from matplotlib.patheffects import withStroke

        halo = [withStroke(linewidth=2.5, foreground=self.theme.paper)]
        look: dict[str, Any] = {"fontsize": _FONT, "parse_math": False, "path_effects": halo, "zorder": 9}
        color = self.theme.color(color, -1)
        return self.axes.text(at[0], at[1], text, ha="center", va="center_baseline", color=color, **look)
