"""Signs of diagrams as shapes on paper: arrows, arcs with a head, dimension lines."""

from __future__ import annotations

import math
from collections.abc import Iterator

import numpy as np

from freebody.present.figures import Array
from freebody.present.picture.shapes import Ink, Shape

HEAD = 7.0  # [points] length of an arrow's head
_SLIM = 0.36  # half the width of a head by its length


def unit(angle: float) -> Array:
    return np.array((math.cos(angle), math.sin(angle)))


def across(way: Array) -> Array:
    """A quarter turn counter-clockwise."""
    return np.array((-way[1], way[0]))


def head(tip: Array, way: Array, ink: Ink, size: float = HEAD) -> Shape:
    """The head of an arrow that comes along a unit vector."""
    side = _SLIM * size * across(way)
    points = np.array((tip, tip - size * way + side, tip - 0.8 * size * way, tip - size * way - side))
    return Shape(points, None, 0.0, ink, is_closed=True)


def arrow(start: Array, end: Array, ink: Ink, width: float = 1.6, size: float = HEAD) -> Iterator[Shape]:
    """A straight arrow."""
    length = float(np.hypot(*(end - start)))
    if length < 1e-9:
        return
    way = (end - start) / length
    size = min(size, 0.6 * length)
    yield Shape(np.array((start, end - 0.7 * size * way)), ink, width)
    yield head(end, way, ink, size)


def arc(middle: Array, radius: float, begin: float, turn: float) -> Array:
    """(n, 2) points of an arc."""
    n = max(2, round(abs(turn) / 0.12) + 1)
    angles = begin + np.linspace(0.0, turn, n)
    return middle + radius * np.stack((np.cos(angles), np.sin(angles)), axis=-1)


def curved_arrow(
    middle: Array, radius: float, begin: float, turn: float, ink: Ink, width: float = 1.6, size: float = HEAD
) -> Iterator[Shape]:
    """An arc with a head, counter-clockwise for a positive turn [rad]."""
    sense = math.copysign(1.0, turn)
    size = min(size, 0.5 * radius * abs(turn))
    short = sense * 0.75 * size / radius
    yield Shape(arc(middle, radius, begin, turn - short), ink, width)
    end = begin + turn
    tip = middle + radius * unit(end)
    lean = end - sense * 0.5 * size / radius  # along the chord of the head
    yield head(tip, sense * across(unit(lean)), ink, size)


def dimension(first: Array, second: Array, aside: float, ink: Ink) -> Iterator[Shape]:
    """A line with two heads between two points, moved to the left by `aside`, with lines that lead there."""
    length = float(np.hypot(*(second - first)))
    way = (second - first) / length
    shift = aside * across(way)
    reach = shift * (1.0 + 3.0 / abs(aside)) if aside else shift
    for end in (first, second):
        if aside:
            yield Shape(np.array((end + 0.25 * shift, end + reach)), ink, 0.6)
    a, b = first + shift, second + shift
    size = min(5.0, 0.3 * length)
    yield Shape(np.array((a + 0.7 * size * way, b - 0.7 * size * way)), ink, 0.7)
    yield head(a, -way, ink, size)
    yield head(b, way, ink, size)


def cross(at: Array, ink: Ink, size: float = 3.5, width: float = 1.3) -> Iterator[Shape]:
    """A cross."""
    for side in (1.0, -1.0):
        arm = size * np.array((1.0, side))
        yield Shape(np.array((at - arm, at + arm)), ink, width)
