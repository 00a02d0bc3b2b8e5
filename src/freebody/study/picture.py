"""A picture of a system at its start."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from freebody.errors import CannotAnswer, InputError, ModelError, Problem
from freebody.numeric.reference import Reference
from freebody.system.system import System

FORMATS = (".svg", ".png", ".pdf")
VIEW = (30.0, 20.0)


def draw(
    system: System,
    path: str | Path,
    *,
    view: tuple[float, float] = VIEW,
    perspective: bool = False,
    dark: bool = False,
) -> Path:
    """Draws a system at its start into a file (.svg, .png or .pdf). view: in space, from where one looks: azimuth from
    the front and elevation [deg]. Raises InputError for another format, ModelError where the start cannot be
    assembled."""
    path = Path(path)
    if path.suffix.lower() not in FORMATS:
        raise InputError(f"{path.name}: a picture is written as {', '.join(FORMATS)}")
    try:
        reference = Reference(system)
        q = reference.assemble()
    except CannotAnswer as error:
        raise ModelError([Problem((), str(error))], system.file) from error
    if system.space:
        return _in_space(reference, q, path, view=view, perspective=perspective, dark=dark)
    if perspective or view != VIEW:
        raise InputError("a view from the side is for models in space; this one is in the plane")
    from freebody.present.scene import Scene
    from freebody.present.stills import write_still

    poses = np.array([reference.pose(q, body.name) for body in system.moving]).reshape(-1, 3)
    return write_still(Scene.of(system, reference.number), poses, path, title=system.title, dark=dark)


def _in_space(
    reference: Reference,
    q: np.ndarray[tuple[int, ...], np.dtype[np.float64]],
    path: Path,
    *,
    view: tuple[float, float],
    perspective: bool,
    dark: bool,
) -> Path:
    from freebody.present.space.scene import Scene
    from freebody.present.space.stills import draw as draw_still

    frames = [reference.frame_of(q, body.name) for body in reference.system.moving]
    centers, axes = np.array([r for r, _R in frames]), np.array([R for _r, R in frames])
    scene = Scene.of(reference.system, reference.number)
    title = reference.system.title
    return draw_still(scene, centers, axes, path, title=title, view=view, perspective=perspective, dark=dark)
