"""Pictures in space of single instants, written to a file; and a drawing of space for a stage."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from freebody.errors import InputError
from freebody.present.figures import Array
from freebody.present.names import Painted
from freebody.present.scene import Scene
from freebody.present.space.drawing import Drawing
from freebody.present.space.painter import painted
from freebody.present.stage import Show
from freebody.present.view import AZIMUTH, ELEVATION


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


def show_of_space(drawing: Drawing, angles: tuple[float, float], *, perspective: bool) -> Show:
    """A drawing seen from an azimuth and an elevation [deg]."""
    view = drawing.view(angles, perspective=perspective)

    def shown(frame: int, is_dark: bool) -> list[Painted]:
        return painted(drawing, frame, view, is_dark=is_dark)

    called = {figure.index: figure.name for figure in drawing.scene.figures}
    return Show(drawing.scene, view, drawing.bounds(view), shown, called, has_lengths=drawing.has_lengths)
