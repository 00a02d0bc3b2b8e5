"""A motion in space as one HTML file that needs nothing else: the page of planar motions with another script in it.

The script draws as `painter`, `order` and `labels` do; it gets the pieces, and the poses as places and quaternions.
"""

from __future__ import annotations

import math
from dataclasses import asdict
from typing import Any

import numpy as np

from freebody.present.figures import Array, Place
from freebody.present.page import asset, filled
from freebody.present.space.drawing import Drawing
from freebody.present.space.looks import LOOKS, OF_BODIES
from freebody.present.space.painter import DASHES, LIGHT
from freebody.present.space.pieces import Piece
from freebody.present.space.stills import description
from freebody.present.theme import THEMES
from freebody.present.view import horizontals

_TURN_DIGITS = 5
_KEYS = (
    "Drag the picture or use the arrow keys to turn the view, the wheel or plus and minus to come nearer; "
    "a double click or 0 goes back. Space plays and pauses, comma and full stop step, Home and End go to the ends."
)


def page(
    drawing: Drawing,
    times: Array,
    turns: Array,
    title: str,
    speed: float,
    angles: tuple[float, float],
    *,
    perspective: bool = False,
) -> str:
    """The text of the page. times: (n_times,) [s], equally spaced, of the poses of the drawing; turns: (n_times,
    n_moving, 4) their quaternions; angles: azimuth and elevation at the start [deg]."""
    duration = f"{times[-1] - times[0]:.4g} s"
    words = f"Animation of {description(drawing.scene)}, over {duration}. The view can be turned with the arrow keys."
    data = _data(drawing, times, turns, speed, angles, perspective=perspective)
    return filled(title, words, "", data, asset("space", "player.js"), _KEYS, ("Comma", "Period"))


def _data(
    drawing: Drawing, times: Array, turns: Array, speed: float, angles: tuple[float, float], *, perspective: bool
) -> dict[str, Any]:
    scene, poses = drawing.scene, drawing.poses
    digits = 5 - math.floor(math.log10(drawing.size)) - 1  # five significant digits of the size of the motion
    columns: list[list[float]] = []
    for k in range(len(scene.names)):
        columns += [_rounded(poses.centers[:, k, i], digits) for i in range(3)]
        columns += [_rounded(turns[:, k, i], _TURN_DIGITS) for i in range(4)]
    front, right = horizontals(scene.up)
    view = drawing.view(angles, perspective=perspective)
    low, high = drawing.bounds(view)
    return {
        "names": scene.names,
        "n_frames": poses.n_times,
        "t0": float(times[0]),
        "dt": float(times[-1] - times[0]) / max(1, poses.n_times - 1) or 1.0,
        "speed": speed,
        "angles": angles,
        "distance": view.distance if perspective else 0.0,
        "middle": _rounded(view.middle, digits),
        "bounds": _rounded(np.concatenate((low, high)), digits),
        "has_lengths": drawing.has_lengths,
        "frame": [_rounded(v, 9) for v in (front, right, scene.up)],
        "gravity": None if scene.gravity is None else _rounded(scene.gravity, 9),
        "light": _rounded(LIGHT, 9),
        "dashes": DASHES,
        "fixed": [
            [_rounded(center, digits), [_rounded(row, 9) for row in axes]]
            for center, axes in zip(*scene.fixed, strict=True)
        ],
        "themes": {name: asdict(theme) for name, theme in THEMES.items()},
        "looks": {name: {**asdict(look), "of_body": name in OF_BODIES} for name, look in LOOKS.items()},
        "pieces": [_piece(piece, digits + 2) for piece in drawing.pieces],
        "labels": [{"body": form.index, "text": form.name} for form in scene.figures],
        "points": _points(drawing, digits + 1),
        "columns": columns,
    }


def _piece(piece: Piece, digits: int) -> dict[str, Any]:
    """A piece as the script reads it; points of a line between two places keep all their digits along it."""
    fine = digits if piece.end is None else max(digits, 5)
    solid = piece.solid
    return {
        "points": [_rounded(p, fine) for p in solid.points],
        "faces": solid.faces,
        "edges": [[*edge[:4], "smc".index(edge.kind[0])] for edge in solid.edges],
        "open": sorted(solid.open),
        "smooth": solid.is_smooth,
        "place": _place(piece.place, digits),
        "end": None if piece.end is None else _place(piece.end, digits),
        "turn": piece.turn,
        "look": piece.look,
        "color": piece.color,
        "radius": round(piece.radius, digits),
        "lines": [[_rounded(p, fine) for p in line] for line in piece.lines],
        "hint": piece.is_hint,
    }


def _points(drawing: Drawing, digits: int) -> list[dict[str, Any]]:
    """The points that can be traced: each place of a moving body once, under its first name."""
    found: dict[tuple[Any, ...], dict[str, Any]] = {}
    for form in drawing.scene.figures:
        if drawing.scene.is_fixed(form.index):
            continue
        named = [(f"{form.name}.{name}", place) for name, place in form.points.items()]
        for name, at in [(form.name, form.mass_center), *named]:
            place = _place(at, digits)
            found.setdefault(tuple(place), {"name": name, "place": place, "color": form.number})
    return list(found.values())


def _place(place: Place, digits: int) -> list[Any]:
    return [place.body, *(round(c, digits) + 0.0 for c in place.at)]


def _rounded(values: Any, digits: int) -> list[float]:
    return [float(v) for v in np.round(np.asarray(values, dtype=np.float64), digits) + 0.0]
