"""A drawing of space for a stage, and what it shows in words."""

from __future__ import annotations

from freebody.messages import Message
from freebody.present.names import Painted
from freebody.present.scene import Scene
from freebody.present.space.drawing import SpatialDrawing
from freebody.present.space.painter import painted
from freebody.present.stage import Show


def description(scene: Scene) -> str:
    """What a picture shows, in words."""
    names = ", ".join(form.name for form in scene.figures)
    return Message("{title}, drawn in space; bodies: {names}", title=scene.title, names=names)


def show_of_space(drawing: SpatialDrawing, angles: tuple[float, float], *, perspective: bool) -> Show:
    """A drawing seen from an azimuth and an elevation [deg]."""
    view = drawing.view(angles, perspective=perspective)

    def shown(frame: int, is_dark: bool) -> list[Painted]:
        return painted(drawing, frame, view, is_dark=is_dark)

    called = {figure.index: figure.name for figure in drawing.scene.figures}
    return Show(drawing.scene, view, drawing.bounds(view), shown, called, has_lengths=drawing.has_lengths)
