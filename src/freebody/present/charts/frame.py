"""The frame of a chart: axes with round numbers, and where a value comes to on paper."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from freebody.present.figures import Array
from freebody.present.lines import number_text
from freebody.present.picture import label
from freebody.present.picture.picture import Picture
from freebody.present.picture.shapes import Ink, Shape, Word, line

WIDTH, HEIGHT = 320.0, 190.0  # [points]
SMALL = 8.0  # size of letters
_TICK = 3.0
_MOST_TICKS = 6


@dataclass(frozen=True)
class Scale:
    """One axis: what it is, and the least and greatest value."""

    label: str
    low: float
    high: float

    @classmethod
    def of(cls, label: str, values: Array) -> Scale:
        """For values of which some may be no numbers."""
        known = values[np.isfinite(values)]
        low, high = (float(known.min()), float(known.max())) if known.size else (0.0, 1.0)
        if high - low <= 1e-12 * max(abs(low), abs(high)):
            room = 0.5 * abs(high) or 0.5
            low, high = low - room, high + room
        return cls(label, low, high)

    def part(self, x: Array) -> Array:
        """Which part of the axis lies before a value."""
        return (x - self.low) / (self.high - self.low)

    @property
    def ticks(self) -> Array:
        """Round numbers: 1, 2 or 5 times a power of ten apart."""
        rough = (self.high - self.low) / _MOST_TICKS
        power = 10.0 ** math.floor(math.log10(rough))
        step = next(f * power for f in (1.0, 2.0, 5.0, 10.0) if f * power >= rough * (1 - 1e-9))
        first, last = math.ceil(self.low / step - 1e-9), math.floor(self.high / step + 1e-9)
        return np.array([step * k for k in range(first, last + 1)])


@dataclass(frozen=True)
class Frame:
    """Two axes."""

    x: Scale
    y: Scale

    def at(self, x: Array, y: Array) -> Array:
        """(n, 2) [points] on paper."""
        return np.column_stack((WIDTH * self.x.part(x), HEIGHT * self.y.part(y)))

    def shapes(self) -> list[Shape]:
        """The frame, with a mark at each round number."""
        corners = np.array(((0, 0), (WIDTH, 0), (WIDTH, HEIGHT), (0, HEIGHT)), dtype=float)
        found = [line(corners, "muted", -1, 1.0, 1.0, 0.8, is_closed=True)]
        for x in WIDTH * self.x.part(self.x.ticks):
            found.append(line(np.array(((x, 0.0), (x, -_TICK))), "muted", -1, 1.0, 1.0, 0.8))
        for y in HEIGHT * self.y.part(self.y.ticks):
            found.append(line(np.array(((0.0, y), (-_TICK, y))), "muted", -1, 1.0, 1.0, 0.8))
        return found

    def words(self) -> list[Word]:
        """The numbers, and what the axes are."""
        found: list[Word] = []
        widest = 0.0
        for value, x in zip(self.x.ticks, WIDTH * self.x.part(self.x.ticks), strict=True):
            found.append(small(_number(value), (x, -9.0)))
        for value, y in zip(self.y.ticks, HEIGHT * self.y.part(self.y.ticks), strict=True):
            word = small(_number(value), (0.0, y))
            widest = max(widest, 2 * float(word.half[0]))
            found.append(small(_number(value), (-5.0 - float(word.half[0]), y)))
        found.append(small(self.x.label, (0.5 * WIDTH, -22.0), "ink"))
        up = small(self.y.label, (0.0, 0.0), "ink")
        found.append(small(self.y.label, (float(up.half[0]) - widest - 5.0, HEIGHT + 12.0), "ink"))
        return found


def _number(value: float) -> str:
    return number_text(0.0 if abs(value) < 1e-300 else float(f"{value:.10g}"))


def small(text: str, at: tuple[float, float], color: str = "muted") -> Word:
    """Small letters with their middle at a place."""
    return Word(label.words(text), np.array(at, dtype=float), SMALL, Ink(color), has_halo=False)


def legend(kinds: Sequence[tuple[str, Ink]], top: float) -> tuple[list[Shape], list[Word]]:
    """A patch and words for each kind, one under the other, below a height."""
    shapes: list[Shape] = []
    words: list[Word] = []
    for k, (text, ink) in enumerate(kinds):
        y = top - 13.0 * k
        patch = np.array(((0, y - 4), (10, y - 4), (10, y + 4), (0, y + 4)), dtype=float)
        shapes.append(Shape(patch, Ink("muted"), 0.5, ink, is_closed=True))
        word = small(text, (0.0, y), "ink")
        words.append(small(text, (15.0 + float(word.half[0]), y), "ink"))
    return shapes, words


def picture(title: str, description: str, shapes: Sequence[Shape], words: Sequence[Word]) -> Picture:
    return Picture(title, description, tuple(shapes), tuple(words))
