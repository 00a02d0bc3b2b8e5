"""The axes of the ground in a corner of a picture, with their length, and the direction of gravity."""

from __future__ import annotations

import math

import numpy as np

from freebody.messages import Message
from freebody.present.figures import Array
from freebody.present.picture.shapes import Shape, area, line
from freebody.present.picture.signs import arc
from freebody.present.view import View

Word = tuple[Array, str, str]  # where, what, in which colour
_ARM, _ARM_OF_PLANE = 3.6, 6.0  # the longest an arm may be, in heights of letters
_ARM_ALONE = 2.7  # where no length stands beside
_STRAIGHT = 1.0 - 1e-9  # cosine of what points at the viewer
_TURN = 1.2  # [rad]


def round_length(value: float) -> float:
    """The largest of 1, 2, 5, 10, ... times a power of ten that is not above a value."""
    power = 10.0 ** math.floor(math.log10(value))
    return power * max(m for m in (1.0, 2.0, 5.0) if m * power <= value * (1 + 1e-9))


def corner_marks(
    gravity: Array | None, view: View, low: Array, letter: float, *, has_lengths: bool = True
) -> tuple[list[Shape], list[Word]]:
    """gravity: (3,) its direction, if there is any; low: (2,) [m] the lower left corner of the picture; letter: [m] the
    height of one. Where z points at the viewer, the sense in which angles are positive stands instead."""
    is_plane = view.axes[2, 2] > _STRAIGHT
    longest = _ARM_OF_PLANE if is_plane else _ARM
    arm = round_length(longest * letter) if has_lengths else _ARM_ALONE * letter
    origin = low + letter * np.array((5.2, 5.2))
    marks: list[Shape] = []
    words: list[Word] = []
    order = np.argsort(view.axes[2])  # what points away from the viewer first
    for k in order.tolist():
        along = arm * view.axes[:2, k]
        if k == 2 and is_plane:
            turn = arc(origin, 0.6 * arm, 0.0, _TURN)
            marks += [line(turn, "muted", -1, 1.0, 1.0, 1.0), *_arrow(turn[-4], turn[-1] - turn[-4], letter, "muted")]
            words.append((origin + arm * np.array((0.75, 0.4)), "+", "ink"))
            continue
        marks += _arrow(origin, along, letter, "muted")
        length = float(np.linalg.norm(along))
        away = along / length if length > 0.3 * letter else np.array((-0.7, -0.7))
        words.append((origin + along + 0.75 * letter * away, "xyz"[k], "ink"))
    if has_lengths:
        told = Message("axes {length:g} m long", length=arm)
        words.append((origin + letter * np.array((longest + 7.2, -0.6)), told, "muted"))
    if gravity is not None:
        down = view.axes[:2] @ gravity
        aside = longest + 13.9 if has_lengths else _ARM_ALONE + 2.6  # behind the length of the axes
        start = origin + letter * np.array((aside, 2.2))
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
