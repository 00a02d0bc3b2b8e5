"""A picture of a motion, ready for any canvas: strokes, names, and the corners of the picture."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from functools import cached_property
from itertools import pairwise

import numpy as np

from freebody.present.figures import Array, box_round
from freebody.present.halts import Halts
from freebody.present.layout import Layout, bounds, headings
from freebody.present.marks import ContactTrack
from freebody.present.pen import Pen
from freebody.present.scene import Scene
from freebody.present.strokes import Caption, Path, Stretch, Stroke, paths_corners, stroke_points
from freebody.present.surfaces import Surfaces, surplus

_NARROWEST, _LOWEST = 0.6, 0.35  # width by height of a picture, and height by width


@dataclass(frozen=True)
class Drawing:
    """All strokes in the order in which they are drawn, for a motion.

    poses: (n_times, n_bodies, 3) as drawn; headings: (n_times, n_leads) [rad] of the strings' leads; low, high: the
    corners of the picture [m]; symbol: the size of symbols [m]; moved: bodies that are drawn aside of their poses.
    """

    scene: Scene
    poses: Array
    headings: Array
    symbol: float
    low: Array
    high: Array
    moved: tuple[str, ...]
    strokes: list[Stroke] = field(default_factory=list[Stroke])
    words: list[Caption] = field(default_factory=list[Caption])  # equations that have no sign
    contacts: ContactTrack | None = None  # with as many times as the poses
    apart: tuple[str, ...] = ()  # as in `Layout`

    @classmethod
    def of(
        cls,
        scene: Scene,
        poses: Array,
        contacts: ContactTrack | None = None,
        *,
        symbol: float | None = None,
        least: tuple[float, float] = (0.0, 0.0),
    ) -> Drawing:
        """The drawing of a scene on its way through poses (n_times, n_bodies, 3) [m, m, rad], with marks where bodies
        touch if these are given. symbol: [m] the size of symbols, by that of the picture if nothing is said; least: [m]
        width and height that the picture has at least."""
        layout = Layout.of(scene, np.asarray(poses, dtype=np.float64), symbol)
        tracks = [headings(rope, layout.poses) for rope in layout.ropes]
        every = np.concatenate(tracks, axis=1) if tracks else np.zeros((len(poses), 0))
        low, high = bounds(scene, layout.poses)
        scene, walls = Halts(scene, layout).walled()
        drawing = cls(
            scene,
            layout.poses,
            every,
            layout.symbol,
            low,
            high,
            layout.moved,
            contacts=contacts,
            apart=layout.apart,
        )
        pen, surfaces = Pen(scene, layout), Surfaces(scene, layout)
        drawing.strokes.extend(walls)
        drawing.strokes.extend(Halts(scene, layout).strokes())
        drawing.strokes.extend(pen.strokes())
        drawing.words.extend(pen.words())
        drawing._frame(least)
        drawing.strokes[:0] = surfaces.strokes(drawing.low, drawing.high)
        drawing.strokes[:] = _lines_over_hatching(drawing.strokes)
        return drawing

    def _frame(self, least: tuple[float, float]) -> None:
        """Sets the corners round all strokes so far."""
        frames = self.key_frames()
        corners = paths_corners([stroke for stroke in self.strokes if isinstance(stroke, Path)], self.poses[frames])
        seen = [self.points(s, k) for s in self.strokes if not isinstance(s, Path) for k in frames]
        low, high = box_round(np.concatenate([*seen, corners, self.low[None], self.high[None]]))
        margin = 3 * self.symbol
        wide, tall = high - low + 2 * margin
        middle = (low + high) / 2
        half = np.array((max(wide, _NARROWEST * tall, least[0]), max(tall, _LOWEST * wide, least[1]))) / 2
        self.low[:], self.high[:] = middle - half, middle + half

    def key_frames(self) -> Sequence[int]:
        """A few frames that stand for all."""
        n = len(self.poses)
        return sorted({round(k * (n - 1) / 60) for k in range(61)})

    @cached_property
    def marks(self) -> list[tuple[int, int, Path | Stretch]]:
        """Marks where bodies touch: the number of the meeting, the state in which it shows, and the mark."""
        thicker = {figure.index: surplus(figure, self.symbol) for figure in self.scene.figures}
        return [] if self.contacts is None else list(self.contacts.marks(self.symbol, thicker))

    def shown(self, frame: int) -> list[Stroke]:
        """The strokes of one instant: all that there are, and the marks of the present contacts."""
        if self.contacts is None:
            return self.strokes
        now = self.contacts.states[frame]
        return [*self.strokes, *(stroke for k, state, stroke in self.marks if now[k] == state)]

    def points(self, stroke: Stroke, frame: int) -> Array:
        """(n, 2) [m] a stroke at one instant, in ground coordinates."""
        return stroke_points(stroke, self.poses[frame : frame + 1], self.headings[frame])


def _lines_over_hatching(strokes: Sequence[Stroke]) -> list[Stroke]:
    """Each line before its hatching after it: the strokes of that are one line, which goes back along the surface."""
    found = list(strokes)
    for k, (first, second) in enumerate(pairwise(strokes)):
        if (first.style, second.style) == ("surface", "hatch"):
            found[k], found[k + 1] = second, first
    return found
