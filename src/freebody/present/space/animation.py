"""A motion in space as a file that plays: an HTML page whose view can be turned, a GIF or an MP4."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from freebody.errors import InputError
from freebody.present.animation import FEWEST, N_FRAMES, RATE, n_frames, write_film
from freebody.present.figures import Array
from freebody.present.scene import Scene
from freebody.present.space.drawing import Drawing
from freebody.present.space.motion import at_times, largest_turn, matrices, quaternions
from freebody.present.space.page import page
from freebody.present.space.stills import checked, figure_of, paint_frame
from freebody.present.view import AZIMUTH, ELEVATION

_STEP = 0.35  # [rad] a body turns between two frames of a page at most, or it would seem to turn the other way
_INCHES = 6.4


def write_animation(
    scene: Scene,
    times: Array,
    centers: Array,
    axes: Array,
    path: str | Path,
    *,
    title: str,
    speed: float = 1.0,
    view: tuple[float, float] = (AZIMUTH, ELEVATION),
    perspective: bool = False,
) -> Path:
    """Writes a motion as `.html` (one page with controls, no network), `.gif` or `.mp4`, by the suffix of the path.

    times: (n_times,) [s], ascending, a repeated time counts once (its last pose). centers: (n_times, n_moving, 3) [m]
    of the mass centres; axes: (n_times, n_moving, 3, 3), whose columns are the bodies' axes, or (n_times, n_moving,
    4) unit quaternions (w, x, y, z); both in the order of `scene.names`. speed: seconds of motion in a second of
    showing. view: azimuth and elevation of the viewer [deg]. Returns the path. Raises InputError if these do not fit
    together, the suffix is another one, the file cannot be written, or there is no ffmpeg for an MP4."""
    return write_film(_Film(scene, _checked(scene, times, centers, axes), title, speed, view, perspective), path)


@dataclass(frozen=True)
class _Turning:
    """Poses at times (n,) that ascend. centers: (n, n_moving, 3); turns: (n, n_moving, 4) quaternions."""

    times: Array
    centers: Array
    turns: Array


def _checked(scene: Scene, times: Array, centers: Array, axes: Array) -> _Turning:
    times, axes = np.asarray(times, dtype=np.float64), np.asarray(axes, dtype=np.float64)
    if axes.ndim == 3 and axes.shape[-1] == 4:
        axes = matrices(axes / np.linalg.norm(axes, axis=-1, keepdims=True))
    if times.ndim != 1 or not len(times):
        raise InputError(f"an animation needs times (n_times,), not {times.shape}")
    centers, axes = checked(scene, centers, axes, len(times))
    if not np.isfinite(times).all() or (np.diff(times) < 0).any():
        raise InputError("the times of an animation must ascend, and be finite")
    last = np.append(np.diff(times) > 0, True)
    return _Turning(times[last], centers[last], quaternions(axes[last]))


@dataclass(frozen=True)
class _Film:
    """A motion, and how it is to be shown."""

    scene: Scene
    motion: _Turning
    title: str
    speed: float
    view: tuple[float, float]
    perspective: bool

    def page(self) -> str:
        times, turns = self.motion.times, self.motion.turns
        needed = math.ceil(largest_turn(times, turns) * float(times[-1] - times[0]) / _STEP) + 1
        n = min(N_FRAMES, max(FEWEST + 1, n_frames(times, self.speed, RATE), needed))
        shown, centers, turns = at_times(times, self.motion.centers, turns, n)
        drawing = Drawing.of(self.scene, centers, matrices(turns))
        return page(drawing, shown, turns, self.title, self.speed, self.view, perspective=self.perspective)

    def stages(self, rate: int) -> tuple[Any, Iterator[None]]:
        """A figure, and an iterator that brings it to one frame after the other."""
        n = n_frames(self.motion.times, self.speed, rate)
        shown, centers, turns = at_times(self.motion.times, self.motion.centers, self.motion.turns, n)
        drawing = Drawing.of(self.scene, centers, matrices(turns))
        look: dict[str, Any] = {"perspective": self.perspective, "title": self.title, "width": _INCHES, "is_film": True}
        stage = figure_of(drawing, self.view, **look)
        figure = stage.canvas_figure
        clock = figure.text(0.97, 0.03, "", ha="right", va="bottom", fontsize=9, color=stage.theme.muted)

        def stages() -> Iterator[None]:
            for frame, t in enumerate(shown):
                artists = paint_frame(stage, drawing, frame)
                clock.set_text(f"t = {t:.2f} s")
                yield
                for artist in artists:
                    artist.remove()

        return figure, stages()
