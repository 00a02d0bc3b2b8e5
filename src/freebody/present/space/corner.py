"""The axes of the ground in a corner of a picture, with their length, and the direction of gravity."""

from __future__ import annotations

import numpy as np

from freebody.present.figures import Array
from freebody.present.picture.shapes import Shape, area, line
from freebody.present.space.drawing import Drawing, round_length
from freebody.present.view import View

Word = tuple[Array, str, str]  # where, what, in which colour
_ARM = 3.6  # the longest an arm may be, in heights of letters


def corner_marks(drawing: Drawing, view: View, low: Array, letter: float) -> tuple[list[Shape], list[Word]]:
    """low: (2,) [m] the lower left corner of the picture; letter: [m] the height of one."""
    arm = round_length(_ARM * letter)
    origin = low + letter * np.array((5.2, 5.2))
    marks: list[Shape] = []
    words: list[Word] = []
    order = np.argsort(view.axes[2])  # what points away from the viewer first
    for k in order.tolist():
        along = arm * view.axes[:2, k]
        marks += _arrow(origin, along, letter, "muted")
        length = float(np.linalg.norm(along))
        away = along / length if length > 0.3 * letter else np.array((-0.7, -0.7))
        words.append((origin + along + 0.75 * letter * away, "xyz"[k], "ink"))
    if drawing.has_lengths:
        words.append((origin + letter * np.array((10.8, -0.6)), f"axes {arm:g} m long", "muted"))
    if drawing.scene.gravity is not None:
        down = view.axes[:2] @ drawing.scene.gravity
        start = origin + letter * np.array((17.5, 2.2))
        marks += _arrow(start, 3.4 * letter * down, letter, "force")
        words.append((start + letter * np.array((1.0, -1.4)), "g", "ink"))
    return marks, words


def _arrow(start: Array, along: Array, letter: float, color: str) -> list[Shape]:
    end = start + along
    length = float(np.linalg.norm(along))
    if length < 0.3 * letter:
        return [line(np.array((start, end)), color, -1, 1.0, 1.0, 1.2)]
    e = along / length
    n = np.array((-e[1], e[0]))
    size = min(0.7 * letter, 0.5 * length)
    head = np.array((end, end - size * (e + 0.4 * n), end - size * (e - 0.4 * n)))
    shaft = np.array((start, end - 0.8 * size * e))
    return [line(shaft, color, -1, 1.0, 1.0, 1.2), area(head, color, -1, 1.0, 1.0)]
