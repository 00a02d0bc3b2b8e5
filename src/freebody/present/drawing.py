"""A picture of a motion, ready for any canvas: strokes, names, and the corners of the picture."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field

import numpy as np

from freebody.present.figures import Array
from freebody.present.layout import Layout, bounds, headings
from freebody.present.pen import Pen
from freebody.present.scene import Scene
from freebody.present.strokes import Label, Stroke, stroke_points

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
    labels: list[Label] = field(default_factory=list[Label])

    @classmethod
    def of(cls, scene: Scene, poses: Array) -> Drawing:
        """The drawing of a scene on its way through poses (n_times, n_bodies, 3) [m, m, rad]."""
        layout = Layout.of(scene, np.asarray(poses, dtype=np.float64))
        tracks = [headings(rope, layout.poses) for rope in layout.ropes]
        every = np.concatenate(tracks, axis=1) if tracks else np.zeros((len(poses), 0))
        low, high = bounds(scene, layout.poses)
        drawing = cls(scene, layout.poses, every, layout.symbol, low, high, layout.moved)
        pen = Pen(scene, layout)
        drawing.strokes.extend(pen.strokes())
        drawing.labels.extend(pen.labels())
        seen = [drawing.points(stroke, k) for stroke in drawing.strokes for k in drawing.key_frames()]
        corners = np.concatenate([*seen, low[None], high[None]])
        low, high = corners.min(axis=0), corners.max(axis=0)
        margin = 3 * layout.symbol
        wide, tall = high - low + 2 * margin
        middle = (low + high) / 2
        half = np.array((max(wide, _NARROWEST * tall), max(tall, _LOWEST * wide))) / 2
        drawing.low[:], drawing.high[:] = middle - half, middle + half
        return drawing

    def key_frames(self) -> Sequence[int]:
        """A few frames that stand for all."""
        n = len(self.poses)
        return sorted({round(k * (n - 1) / 60) for k in range(61)})

    def points(self, stroke: Stroke, frame: int) -> Array:
        """(n, 2) [m] a stroke at one instant, in ground coordinates."""
        return stroke_points(stroke, self.poses[frame : frame + 1], self.headings[frame])
