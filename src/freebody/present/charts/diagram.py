"""A diagram as on a board: what a quantity is along a line, over an axis of its own, with its values where they change.

Values and places that are short as formulas stand as such, others as numbers.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import pairwise

import numpy as np

from freebody.present.charts.frame import HEIGHT, SMALL, WIDTH, picture
from freebody.present.figures import Array
from freebody.present.picture.label import Label
from freebody.present.picture.picture import Picture
from freebody.present.picture.placer import Wish, placed
from freebody.present.picture.shapes import INK, Ink, Shape, Word, area, line
from freebody.present.picture.signs import arrow

_BESIDE = 26.0  # [points] by which an axis goes on
_BETWEEN = 4.0  # [points] from one diagram to the next
_BELOW = 12.0  # [points] from the lowest value to the places
_UP, _DOWN = np.array((0.0, 1.0)), np.array((0.0, -1.0))
_RIGHT, _LEFT = np.array((1.0, 0.0)), np.array((-1.0, 0.0))
_AT_BEGIN = (_UP + _RIGHT, _DOWN + _RIGHT, _LEFT)
_AT_END = (_UP, _DOWN, _UP + _RIGHT, _UP + _LEFT, _DOWN + _LEFT, _RIGHT)
_SAME = 1e-9  # of the range of values


@dataclass(frozen=True)
class Stretch:
    """Where one formula holds: (n,) places and values; what is written at its ends, if anything."""

    places: Array
    values: Array
    at_begin: Label | None = None
    at_end: Label | None = None


@dataclass(frozen=True)
class Mark:
    """A place with what is written below it; or, with a value, a point of the line with what is written beside it."""

    place: float
    label: Label
    value: float | None = None


def diagram(
    title: str, over: Label, of: Label, stretches: Sequence[Stretch], marks: Sequence[Mark], *, is_filled: bool = True
) -> Picture:
    """over, of: what stands at the ends of the axes; is_filled: down to the axis, as what a rod transmits is drawn."""
    frame = _Axes.of(stretches)
    shapes = [*frame.shapes([mark.place for mark in marks if mark.value is None])]
    for stretch in stretches if is_filled else ():
        line_of = frame.at(stretch.places, stretch.values)
        feet = frame.at(stretch.places[[-1, 0]], np.zeros(2))
        shapes.append(area(np.concatenate((line_of, feet)), "body", 0, 0.16, 1.0))
    shapes += frame.jumps(stretches, to_axis=is_filled)
    shapes += [Shape(frame.at(s.places, s.values), Ink("body", 0), 1.5) for s in stretches]
    words = [
        Word(over, frame.at_one(frame.high, 0.0) + (_BESIDE + 3.0 + 5.0 * over.width) * _RIGHT, SMALL + 1.0),
        Word(of, np.array((0.0, HEIGHT + 19.0)), SMALL + 1.0),
        *(
            Word(mark.label, np.array((frame.across(mark.place), -_BELOW - 7.0)), SMALL)
            for mark in _apart(frame, marks)
        ),
    ]
    wishes = [*_ends(frame, stretches), *(w for m in marks if m.value is not None for w in _point(frame, m, m.value))]
    dots = [_dot(frame.at_one(m.place, m.value)) for m in marks if m.value is not None]
    shapes += dots
    return picture(title, title, shapes, placed(wishes, shapes, words))


def below_each_other(title: str, pictures: Sequence[Picture]) -> Picture:
    """Over one line of places: the origins of all stand under each other."""
    shapes: list[Shape] = []
    words: list[Word] = []
    y = 0.0
    for one in pictures:
        low, high = one.corners
        down = np.array((0.0, y - high[1]))
        shapes += [replace(shape, points=shape.points + down) for shape in one.shapes]
        words += [replace(word, at=word.at + down) for word in one.words]
        y -= float(high[1] - low[1]) + _BETWEEN
    return picture(title, title, shapes, words)


@dataclass(frozen=True)
class _Axes:
    """From places and values to paper; zero is on the axis of values."""

    low: float
    high: float
    least: float
    most: float

    @classmethod
    def of(cls, stretches: Sequence[Stretch]) -> _Axes:
        places = np.concatenate([s.places for s in stretches])
        values = np.concatenate([s.values for s in stretches])
        least, most = min(0.0, float(values.min())), max(0.0, float(values.max()))
        if least == most:
            least, most = -1.0, 1.0
        return cls(float(places.min()), float(places.max()), least, most)

    def across(self, place: float) -> float:
        return WIDTH * (place - self.low) / (self.high - self.low)

    def at(self, places: Array, values: Array) -> Array:
        """(n, 2) [points]"""
        x = WIDTH * (places - self.low) / (self.high - self.low)
        return np.column_stack((x, HEIGHT * (values - self.least) / (self.most - self.least)))

    def at_one(self, place: float, value: float) -> Array:
        return self.at(np.array([place]), np.array([value]))[0]

    def shapes(self, places: Sequence[float]) -> Iterator[Shape]:
        """The axes with their heads, and a fine line at each place."""
        zero, end = self.at_one(self.low, 0.0), self.at_one(self.high, 0.0) + _BESIDE * _RIGHT
        top = np.array((0.0, HEIGHT + 12.0))
        yield from arrow(zero, end, INK, 0.8, 5.0)
        yield from arrow(np.array((0.0, 0.0)), top, INK, 0.8, 5.0)
        for place in places:
            x = self.across(place)
            ends = np.array(((x, -_BELOW), (x, HEIGHT)))
            yield line(ends, "muted", -1, 1.0, 1.0, 0.5, dashes=(2.0, 2.0))

    def jumps(self, stretches: Sequence[Stretch], *, to_axis: bool) -> Iterator[Shape]:
        """Upright lines where a value jumps; to the axis at both ends, if that is wanted."""
        ends = [(s.places[0], s.values[0], s.places[-1], s.values[-1]) for s in stretches]
        upright = [(ends[0][0], 0.0, ends[0][1]), (ends[-1][2], ends[-1][3], 0.0)] if to_axis else []
        upright += [(b[0], a[3], b[1]) for a, b in pairwise(ends)]
        for place, first, second in upright:
            yield line(self.at(np.full(2, place), np.array((first, second))), "body", 0, 1.0, 1.0, 1.5)

    def is_same(self, first: float, second: float) -> bool:
        return abs(first - second) <= _SAME * (self.most - self.least)


def _apart(axes: _Axes, marks: Sequence[Mark]) -> Iterator[Mark]:
    """Places whose labels stand clear of those before."""
    end = -np.inf
    for mark in sorted((m for m in marks if m.value is None), key=lambda m: m.place):
        half = 0.5 * SMALL * mark.label.width
        if axes.across(mark.place) - half > end:
            yield mark
            end = axes.across(mark.place) + half + 3.0


def _ends(axes: _Axes, stretches: Sequence[Stretch]) -> Iterator[Wish]:
    """The values at the ends of stretches: once where two meet in one value or one is constant, none where it is 0."""
    before: float | None = None
    for stretch in stretches:
        first, last = float(stretch.values[0]), float(stretch.values[-1])
        is_flat = axes.is_same(float(np.ptp(stretch.values)), 0.0)
        if before is None or not axes.is_same(before, first):
            place, ways = (stretch.places.mean(), (_UP, _DOWN)) if is_flat else (stretch.places[0], _AT_BEGIN)
            yield from _value(axes, stretch.at_begin, float(place), first, ways)
        if not is_flat:
            yield from _value(axes, stretch.at_end, float(stretch.places[-1]), last, _AT_END)
        before = last


def _value(axes: _Axes, label: Label | None, place: float, value: float, ways: Sequence[Array]) -> Iterator[Wish]:
    if label is not None and not axes.is_same(value, 0.0):
        yield _wish(axes, label, place, value, ways)


def _point(axes: _Axes, mark: Mark, value: float) -> Iterator[Wish]:
    yield _wish(axes, mark.label, mark.place, value, (_UP, _DOWN, _UP + _RIGHT, _UP + _LEFT))


def _wish(axes: _Axes, label: Label, place: float, value: float, ways: Sequence[Array]) -> Wish:
    """Outside of the area first: above what is positive, below what is negative."""
    at = axes.at_one(place, value)
    turned = np.array((1.0, 1.0 if value >= 0 else -1.0))
    places = tuple((at, way * turned) for way in ways)
    return Wish(label, places, SMALL, is_needed=True, gap=3.0)


def _dot(at: Array) -> Shape:
    turn = np.linspace(0.0, 2 * np.pi, 12, endpoint=False)
    return Shape(at + 1.8 * np.column_stack((np.cos(turn), np.sin(turn))), None, 0.0, Ink("body", 0), is_closed=True)
