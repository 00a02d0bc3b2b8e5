"""Single instants of a drawing in Matplotlib axes, for films and figures of one's own."""

from __future__ import annotations

from typing import Any

import numpy as np

from freebody.present.drawing import Drawing
from freebody.present.figures import Array, positions
from freebody.present.scene import Scene
from freebody.present.strokes import Path, Strand, Stroke
from freebody.present.theme import THEMES, Theme, style_of


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

    artists: list[Any] = []
    strokes = drawing.shown(frame)
    for k, stroke in enumerate(strokes):
        artist = _line(stroke, drawing.points(stroke, frame), axes, theme)
        artist.set_zorder(2 + k / len(strokes))
        artists.append(artist)
    halo = [withStroke(linewidth=2.5, foreground=theme.paper)]
    for label in drawing.labels:
        place = positions(drawing.poses[frame : frame + 1], label.place)[0]
        x, y = place + drawing.symbol * np.array((label.dx, label.dy))
        look = {"color": theme.ink, "fontsize": 8, "parse_math": False, "path_effects": halo, "zorder": 9}
        side = "left" if label.dx > 0 else "right"
        artists.append(axes.text(x, y, label.text, ha=side, va="center", **look))
    return artists


def _line(stroke: Stroke, points: Array, axes: Any, theme: Theme) -> Any:
    from matplotlib.lines import Line2D
    from matplotlib.patches import Polygon

    style = style_of(stroke.style)
    edge = theme.color(style.stroke, stroke.color if isinstance(stroke, Path) else -1)
    dashes = (0, style.dashes) if style.dashes else "-"
    if not isinstance(stroke, Strand) and stroke.is_closed:
        fill = theme.color(style.fill, stroke.color if isinstance(stroke, Path) else -1)
        # an area and its edge are two colours with an alpha of their own
        face = (*_rgb(fill), style.alpha) if fill else "none"
        patch = Polygon(points, closed=True, facecolor=face, edgecolor=edge or "none", linewidth=style.width)
        patch.set_linestyle(dashes)
        return axes.add_patch(patch)
    line = Line2D(*points.T, color=edge, linewidth=style.width, solid_capstyle="round", solid_joinstyle="round")
    line.set_linestyle(dashes)
    return axes.add_line(line)


def _rgb(color: str) -> tuple[float, ...]:
    return tuple(int(color[k : k + 2], 16) / 255 for k in (1, 3, 5))
