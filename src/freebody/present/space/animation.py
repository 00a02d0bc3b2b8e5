"""A motion in space as a file that plays: an HTML page whose view can be turned, a GIF or an MP4."""

from __future__ import annotations

import math
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from freebody.errors import InputError
from freebody.numeric.rotation import matrices
from freebody.present.animation import FEWEST, Film, write_film
from freebody.present.figures import Array
from freebody.present.page import Pages
from freebody.present.scene import Scene
from freebody.present.space.drawing import SpatialDrawing
from freebody.present.space.motion import at_times, largest_turn, quaternions
from freebody.present.space.page import page
from freebody.present.space.stills import show_of_space
from freebody.present.stage import Show
from freebody.present.view import AZIMUTH, ELEVATION

_STEP = 0.35  # [rad] a body turns between two frames of a page at most, or it would seem to turn the other way


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
    """Writes a motion as `.html` (one page with controls, no network), `.gif` or `.mp4`, by the suffix of the path,
    which it returns. The motion as for `film_of`. Raises InputError as that does, and if the suffix is another one, the
    file cannot be written, or there is no ffmpeg for an MP4."""
    film = film_of(scene, times, centers, axes, title=title, speed=speed, view=view, perspective=perspective)
    return write_film(film, path)


def film_of(
    scene: Scene,
    times: Array,
    centers: Array,
    axes: Array,
    *,
    title: str,
    speed: float = 1.0,
    view: tuple[float, float] = (AZIMUTH, ELEVATION),
    perspective: bool = False,
) -> Film:
    """A motion as a film.

    times: (n_times,) [s], ascending, a repeated time counts once (its last pose). centers: (n_times, n_moving, 3) [m]
    of the mass centres; axes: (n_times, n_moving, 3, 3), whose columns are the bodies' axes, or (n_times, n_moving,
    4) unit quaternions (w, x, y, z); both in the order of `scene.names`. speed: seconds of motion in a second of
    showing. view: azimuth and elevation of the viewer [deg]. Raises InputError if these do not fit together."""
    motion = _checked(scene, times, centers, axes)
    fast = largest_turn(motion.times, motion.turns) * float(motion.times[-1] - motion.times[0])

    def show(n_frames: int) -> tuple[Show, Array]:
        drawing, shown, _turns = motion.drawn(scene, n_frames)
        return show_of_space(drawing, view, perspective=perspective), shown

    def page_of(n_frames: int) -> Pages:
        drawing, shown, turns = motion.drawn(scene, n_frames)
        return page(drawing, shown, turns, view, perspective=perspective)

    fewest = max(FEWEST + 1, math.ceil(fast / _STEP) + 1)
    return Film(motion.times, title, speed, show, page_of, fewest)


@dataclass(frozen=True)
class _Turning:
    """Poses at times (n,) that ascend. centers: (n, n_moving, 3); turns: (n, n_moving, 4) quaternions."""

    times: Array
    centers: Array
    turns: Array

    def drawn(self, scene: Scene, n_frames: int) -> tuple[SpatialDrawing, Array, Array]:
        """The drawing of frames at equally spaced times, these times, and the quaternions."""
        shown, centers, turns = at_times(self.times, self.centers, self.turns, n_frames)
        return SpatialDrawing.of(scene, centers, matrices(turns)), shown, turns


def _checked(scene: Scene, times: Array, centers: Array, axes: Array) -> _Turning:
    n = len(scene.names)
    times, centers, axes = (np.asarray(given, dtype=np.float64) for given in (times, centers, axes))
    if times.ndim != 1 or not len(times):
        raise InputError(f"an animation needs times (n_times,), not {times.shape}")
    if axes.ndim == 3 and axes.shape[-1] == 4:
        axes = matrices(axes / np.linalg.norm(axes, axis=-1, keepdims=True))
    if centers.shape != (len(times), n, 3) or axes.shape != (len(times), n, 3, 3):
        raise InputError(
            f"an animation of {n} moving bodies needs centres ({len(times)}, {n}, 3) and axes ({len(times)}, {n}, 3, "
            f"3), not {centers.shape} and {axes.shape}"
        )
    if not all(np.isfinite(given).all() for given in (times, centers, axes)):
        raise InputError("the times and poses of an animation must be finite numbers")
    if (np.diff(times) < 0).any():
        raise InputError("the times of an animation must ascend")
    last = np.append(np.diff(times) > 0, True)
    return _Turning(times[last], centers[last], quaternions(axes[last]))
