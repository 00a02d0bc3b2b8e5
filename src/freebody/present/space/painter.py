"""Turns pieces into areas and lines on paper, from the farthest to the nearest.

Faces that look at the viewer are painted, the light comes from above on the left; edges between two faces that look
away are hidden ones, drawn weakly and dashed.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from freebody.present.figures import Array
from freebody.present.names import Painted
from freebody.present.picture.shapes import Shape, area, line
from freebody.present.space.drawing import SpatialDrawing
from freebody.present.space.looks import LOOKS, OF_BODIES, Look
from freebody.present.space.order import EDGE_ON, Seen, back_to_front, seen_ball, seen_solid
from freebody.present.space.pieces import Piece
from freebody.present.view import View

LIGHT = np.array((-0.35, 0.75, 0.56)) / np.linalg.norm((-0.35, 0.75, 0.56))  # on paper and towards the viewer
DASHES = (3.0, 2.5)
_N_BALL = 48


@dataclass(frozen=True)
class Shot:
    """A piece at one instant as it is seen: its points (n, 3), its lines, and the normals of its faces on paper."""

    piece: Piece
    points: Array
    lines: tuple[Array, ...]
    normals: Array  # (n_faces, 3)
    seen: Seen

    @property
    def fronts(self) -> NDArray[np.bool_]:
        """(n_faces,) whether each looks at the viewer."""
        return self.normals[:, 2] > EDGE_ON


def shots(drawing: SpatialDrawing, frame: int, view: View) -> list[Shot]:
    """All pieces at one instant, from the back to the front. Planes are behind what stands on them, or before it."""
    taken = [_shot(drawing, piece, frame, view) for piece in drawing.pieces]
    flats = [shot for shot in taken if shot.piece.look == "plane"]
    rest = [shot for shot in taken if shot.piece.look != "plane"]
    below = [shot for shot in flats if shot.normals[0, 2] > EDGE_ON]
    above = [shot for shot in flats if shot.normals[0, 2] <= EDGE_ON]
    return [*below, *(rest[k] for k in back_to_front([shot.seen for shot in rest])), *above]


def painted(drawing: SpatialDrawing, frame: int, view: View, *, is_dark: bool = False) -> list[Painted]:
    """All pieces at one instant, from the back to the front."""
    return [painted_shot(shot, tuple(paint(shot, is_dark=is_dark))) for shot in shots(drawing, frame, view)]


def painted_shot(shot: Shot, shapes: Sequence[Shape]) -> Painted:
    """A piece with what it becomes on paper."""
    piece = shot.piece
    owner = None if piece.look == "plane" else piece.turn if piece.look in OF_BODIES else -1
    return Painted(owner, tuple(shapes), shot.seen.outline, shot.points[0, :2] if piece.radius else None)


def _shot(drawing: SpatialDrawing, piece: Piece, frame: int, view: View) -> Shot:
    placed, lines = piece.placed(drawing.poses, frame)
    points = view.seen(placed)
    if piece.radius:
        scale = (
            float(np.linalg.norm(view.seen(placed[0] + piece.radius * view.axes[0])[:2] - points[0, :2])) / piece.radius
        )
        seen = seen_ball(points[0], piece.radius * scale)
        return Shot(piece, points, tuple(view.seen(line) for line in lines), np.zeros((0, 3)), seen)
    normals = piece.solid.normals(points)
    seen = seen_solid(points, normals, points[[face[0] for face in piece.solid.faces]])
    return Shot(piece, points, tuple(view.seen(line) for line in lines), normals, seen)


def paint(shot: Shot, *, is_dark: bool = False) -> Iterator[Shape]:
    """The areas and lines of one piece, in order. On dark paper colours are lighter than the paper, so what the light
    meets has more of them; on light paper, what it does not."""
    look, piece = LOOKS[shot.piece.look], shot.piece
    if piece.radius:
        yield from _ball(shot, look, is_dark=is_dark)
    elif piece.is_hint:
        yield from (line(way[:, :2], look.color, piece.color, 1.0, 1.0, look.fine) for way in shot.lines)
    else:
        yield from _areas(shot, look, is_dark=is_dark)
        yield from (line(way[:, :2], look.color, piece.color, 0.6, 1.0, look.fine) for way in shot.lines)
        yield from _edges(shot, look)


def _ball(shot: Shot, look: Look, *, is_dark: bool) -> Iterator[Shape]:
    middle, color = shot.points[0], shot.piece.color
    a = np.linspace(0.0, 2 * np.pi, _N_BALL, endpoint=False)
    outline = middle[:2] + shot.seen.radius * np.stack((np.cos(a), np.sin(a)), axis=-1)
    yield area(outline, look.color, color, look.tint, look.cover)
    # a crescent away from the light, or what is left of it
    if look.shade:
        inner = middle[:2] + shot.seen.radius * (0.18 * LIGHT[:2] + 0.88 * np.stack((np.cos(a), np.sin(a)), axis=-1))
        around = inner if is_dark else np.concatenate((outline, outline[:1], inner[:1], inner[::-1]))
        yield area(around, look.color, color, 1.0, 0.35 * look.shade)
    for circle in shot.lines:
        near = circle[:, 2] > middle[2]
        for k, run in _runs(near):
            stroke = circle[k : k + run, :2]
            if near[k]:
                yield line(stroke, look.color, color, 1.0, 1.0, look.fine)
            else:
                yield line(stroke, look.color, color, 1.0, look.hidden, look.fine, dashes=DASHES)
    yield line(outline, look.color, color, 1.0, 1.0, look.width, is_closed=True)


def _runs(flags: NDArray[np.bool_]) -> Iterator[tuple[int, int]]:
    """Where each run of equal flags begins, and its length with the point after it."""
    begins = [0, *(np.flatnonzero(flags[1:] != flags[:-1]) + 1).tolist(), len(flags)]
    for a, b in pairwise(begins):
        yield a, min(b + 1, len(flags)) - a


def _areas(shot: Shot, look: Look, *, is_dark: bool) -> Iterator[Shape]:
    """A round solid as one area with shade on it, another face by face."""
    solid, color = shot.piece.solid, shot.piece.color
    if solid.is_smooth:
        yield area(shot.seen.outline, look.color, color, look.tint, look.cover)
        if look.is_seamed:
            yield line(shot.seen.outline, look.color, color, look.tint, 1.0, 0.6, is_closed=True)
    for k, face in enumerate(solid.faces):
        if not shot.fronts[k] or k in solid.open:
            continue
        normal = shot.normals[k] / (float(np.linalg.norm(shot.normals[k])) or 1.0)
        lit = max(0.0, float(normal @ LIGHT))
        more = look.shade * (lit if is_dark else 1.0 - lit)
        corners = shot.points[list(face), :2]
        if solid.is_smooth:
            if more > 0.01:
                yield area(corners, look.color, color, 1.0, more * look.cover)
            continue
        share = look.tint + more * (1.0 - look.tint)
        yield area(corners, look.color, color, share, look.cover)
        if look.is_seamed:
            yield line(corners, look.color, color, share, 1.0, 0.6, is_closed=True)


def _edges(shot: Shot, look: Look) -> Iterator[Shape]:
    """Hidden edges first, then those that are seen."""
    if not look.width:
        return
    hidden: list[Shape] = []
    shown: list[Shape] = []
    for a, b, left, right, kind in shot.piece.solid.edges:
        n_front = int(shot.fronts[left]) + int(shot.fronts[right])
        ends = shot.points[[a, b], :2]
        if kind == "mark" and n_front:
            shown.append(line(ends, look.color, shot.piece.color, 1.0, 0.8, look.fine))
        elif n_front and (kind == "crease" or n_front == 1):
            shown.append(line(ends, look.color, shot.piece.color, 1.0, 1.0, look.width))
        elif kind == "crease" and not n_front and look.hidden:
            hidden.append(line(ends, look.color, shot.piece.color, 1.0, look.hidden, look.fine, dashes=DASHES))
    yield from joined(hidden)
    yield from joined(shown)


def joined(strokes: list[Shape]) -> Iterator[Shape]:
    """Strokes that follow on each other as one line, so that dashes run on and ends meet."""
    way: list[Array] = []
    for k, stroke in enumerate(strokes):
        way += list(stroke.points if not way else stroke.points[1:])
        after = strokes[k + 1] if k + 1 < len(strokes) else None
        is_alike = after is not None and (after.width, after.stroke) == (stroke.width, stroke.stroke)
        if after is None or not is_alike or (after.points[0] != way[-1]).any():
            yield replace(stroke, points=np.array(way))
            way = []
