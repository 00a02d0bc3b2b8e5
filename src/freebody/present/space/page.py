"""A motion in space for the player page: its pieces, with the poses as places and quaternions."""

from __future__ import annotations

from dataclasses import asdict
from typing import Any

import numpy as np

from freebody.present.figures import Array
from freebody.present.page import Pages, digits_of, place_data, rounded
from freebody.present.space.drawing import SpatialDrawing
from freebody.present.space.looks import LOOKS, OF_BODIES
from freebody.present.space.painter import DASHES, LIGHT
from freebody.present.space.pieces import Piece
from freebody.present.space.stills import description
from freebody.present.view import horizontals

_TURN_DIGITS = 5


def page(
    drawing: SpatialDrawing,
    times: Array,
    turns: Array,
    angles: tuple[float, float],
    *,
    perspective: bool = False,
) -> Pages:
    """The page. times: (n_times,) [s], equally spaced, of the poses of the drawing; turns: (n_times,
    n_moving, 4) their quaternions; angles: azimuth and elevation at the start [deg]."""
    scene, digits = drawing.scene, digits_of(drawing.size)
    columns: list[list[float]] = []
    for k in range(len(scene.names)):
        columns += [rounded(drawing.poses.centers[:, k, i], digits) for i in range(3)]
        columns += [rounded(turns[:, k, i], _TURN_DIGITS) for i in range(4)]
    front, right = horizontals(scene.up)
    view = drawing.view(angles, perspective=perspective)
    own = {
        "light": rounded(LIGHT, 9),
        "dashes": DASHES,
        "looks": {name: {**asdict(look), "of_body": name in OF_BODIES} for name, look in LOOKS.items()},
        "pieces": [_piece(piece, digits + 2) for piece in drawing.pieces],
        "labels": [{"owner": form.index, "text": form.name} for form in scene.figures],
    }
    return Pages(
        scene,
        times,
        columns,
        digits,
        drawing.bounds(view),
        np.array((front, right, scene.up)),
        scene.fixed,
        own,
        description(scene),
        angles=angles,
        middle=view.middle,
        distance=view.distance if perspective else 0.0,
        has_lengths=drawing.has_lengths,
    )


def _piece(piece: Piece, digits: int) -> dict[str, Any]:
    """A piece as the script reads it; points of a line between two places keep all their digits along it."""
    fine = digits if piece.end is None else max(digits, 5)
    solid = piece.solid
    return {
        "points": [rounded(p, fine) for p in solid.points],
        "faces": solid.faces,
        "edges": [[*edge[:4], "smc".index(edge.kind[0])] for edge in solid.edges],
        "open": sorted(solid.open),
        "smooth": solid.is_smooth,
        "place": place_data(piece.place, digits),
        "end": None if piece.end is None else place_data(piece.end, digits),
        "turn": piece.turn,
        "look": piece.look,
        "color": piece.color,
        "radius": round(piece.radius, digits),
        "lines": [[rounded(p, fine) for p in line] for line in piece.lines],
        "hint": piece.is_hint,
    }
