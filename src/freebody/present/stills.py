"""Single instants of a drawing in Matplotlib axes, for films and figures of one's own."""

from __future__ import annotations

from typing import Any

import numpy as np

from freebody.present.drawing import Drawing
from freebody.present.figures import Array, positions
from freebody.present.picture import pixels
from freebody.present.picture.plane import shape_of
from freebody.present.scene import Scene
from freebody.present.theme import THEMES, Theme


def draw_frame(scene: Scene, pose: Array, axes: Any, *, dark: bool = False) -> None:
    """Draws one instant into Matplotlib axes. pose: (n_moving_bodies, 3), x and y of the mass centre [m] and the
    angle [rad], in the order of `scene.names`."""
    drawing = Drawing.of(scene, np.asarray(pose, dtype=np.float64)[None])
    frame_axes(drawing, axes, THEMES["dark" if dark else "light"])
    paint(drawing, 0, axes, THEMES["dark" if dark else "light"])


def frame_axes(drawing: Drawing, axes: Any, theme: Theme) -> None:
    """Sets the limits of the picture, equal scales and the colours of the paper."""
    axes.set_xlim(drawing.low[0], drawing.high[0])
    axes.set_ylim(drawing.low[1], drawing.high[1])
    axes.set_aspect("equal")
    axes.set_facecolor(theme.paper)
    for spine in axes.spines.values():
        spine.set_color(theme.faint)
    axes.tick_params(colors=theme.muted, labelsize=8)
    axes.set_xlabel("x [m], to the right", color=theme.muted, fontsize=8)
    axes.set_ylabel("y [m], up", color=theme.muted, fontsize=8)


def paint(drawing: Drawing, frame: int, axes: Any, theme: Theme) -> list[Any]:
    """Draws the strokes and names of one frame; returns the artists."""
    from matplotlib.patheffects import withStroke

    shapes = [shape_of(stroke, drawing.points(stroke, frame)) for stroke in drawing.shown(frame)]
    artists: list[Any] = [pixels.paint(shapes, axes, dark=theme is THEMES["dark"])]
    halo = [withStroke(linewidth=2.5, foreground=theme.paper)]
    for label in (*drawing.labels, *drawing.words):
        place = positions(drawing.poses[frame : frame + 1], label.place)[0]
        x, y = place + drawing.symbol * np.array((label.dx, label.dy))
        look = {"color": theme.ink, "fontsize": 8, "parse_math": False, "path_effects": halo, "zorder": 9}
        side = "left" if label.dx > 0 else "right"
        artists.append(axes.text(x, y, label.text, ha=side, va="center", **look))
    return artists
