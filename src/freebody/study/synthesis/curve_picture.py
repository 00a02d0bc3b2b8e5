"""Burmester's curves of four positions, with poles, dyads and the linkage that is made of two of them."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from freebody.numeric.jets import Array
from freebody.present.charts.frame import legend, picture
from freebody.present.picture import label
from freebody.present.picture.picture import Picture
from freebody.present.picture.shapes import Ink, Shape, Word, line
from freebody.study.synthesis.curves import centre_point_curve, circle_point_curve, opposite_poles
from freebody.study.synthesis.linkage import Linkage
from freebody.study.synthesis.picture import Placed, named, spot
from freebody.study.synthesis.positions import Dyad, Position

_SIDE = 320.0  # [points]
_FAR = 1.5  # sizes of what has to be seen: poles farther away are not shown
_ROOM = 0.18  # round what is shown, of its size
_CENTRES, _CIRCLES, _POLES = Ink("body", 0), Ink("body", 1), Ink("muted")
_TICK = 9.0  # [points] by which a position is drawn

Drawn = tuple[list[Shape], list[Word]]


def curve_picture(
    title: str, positions: Sequence[Position], dyads: Sequence[Dyad], linkage: Linkage | None = None
) -> Picture:
    """Both curves in position 1; of the dyads fixed and moving pivots as dots; those of the linkage as bars."""
    poles = opposite_poles(positions)
    low, side = _square(positions, poles, linkage)

    def at(x: Array) -> Array:
        return (np.atleast_2d(x) - low) / side * _SIDE

    corners = np.array(((0, 0), (_SIDE, 0), (_SIDE, _SIDE), (0, _SIDE)), dtype=float)
    shapes = [line(corners, "faint", -1, 1.0, 1.0, 0.8, is_closed=True)]
    words: list[Word] = []
    seen = [(name, place) for name, place in poles if _is_seen(at(place))]
    if len(seen) == 4:
        quadrilateral = at(np.array([place for _name, place in poles]))
        shapes.append(line(quadrilateral, "muted", -1, 1.0, 1.0, 0.9, is_closed=True, dashes=(2.0, 2.0)))
    shapes += [Shape(at(run), _CENTRES, 1.5) for run in centre_point_curve(positions, low, side)]
    shapes += [Shape(at(run), _CIRCLES, 1.5, dashes=(6.0, 2.5)) for run in circle_point_curve(positions, low, side)]
    pivots = [(d.moving, _CIRCLES) for d in dyads if not d.is_line]
    pivots += [(d.fixed, _CENTRES) for d in dyads if not d.is_slide]
    shapes += [spot(at(place)[0], 1.8, ink) for place, ink in pivots if _is_seen(at(place))]
    for more, told in (_places(positions, at), _poles(seen, at), _bars(linkage, at)):
        shapes, words = shapes + more, words + told
    kinds = [("centre-point curve", _CENTRES), ("circle-point curve (dashed)", _CIRCLES)]
    more, told = legend([*kinds, *([("opposite poles", _POLES)] if seen else [])], -14.0)
    says = "centre-point curve and circle-point curve of four positions, with opposite poles and dyads"
    return picture(title, says, [*shapes, *more], [*words, *told])


def _square(
    positions: Sequence[Position], poles: Sequence[tuple[str, Array]], linkage: Linkage | None
) -> tuple[Array, float]:
    """The lower left corner and the side of what is shown: positions, the linkage, and poles that are not far away."""
    points = [np.array((p.x, p.y)) for p in positions]
    if linkage is not None:
        points += [linkage.A, linkage.B[0], linkage.C[0], *([] if linkage.D is None else [linkage.D])]
    low, high = np.min(points, axis=0), np.max(points, axis=0)
    size = float((high - low).max()) or 1.0
    near = [place for _name, place in poles if np.abs(place - 0.5 * (low + high)).max() <= _FAR * size]
    low, high = np.min([low, *near], axis=0), np.max([high, *near], axis=0)
    side = (1.0 + 2 * _ROOM) * (float((high - low).max()) or 1.0)
    return 0.5 * (low + high) - 0.5 * side, side


def _is_seen(place: Array) -> bool:
    return bool(((place >= 0.0) & (place <= _SIDE)).all())


def _places(positions: Sequence[Position], at: Placed) -> Drawn:
    """The origin of the moving plane in each position with its first axis, by their numbers."""
    shapes: list[Shape] = []
    words: list[Word] = []
    for k, p in enumerate(positions, 1):
        place = at(np.array((p.x, p.y)))[0]
        along = np.array((math.cos(p.angle), math.sin(p.angle)))
        across = np.array((-along[1], along[0]))
        shapes.append(Shape(np.array((place + _TICK * along, place, place + 0.5 * _TICK * across)), Ink(), 1.2))
        words.append(named(label.words(str(k)), place - 7.0 * (along + 0.3 * across), Ink()))
    return shapes, words


def _poles(poles: Sequence[tuple[str, Array]], at: Placed) -> Drawn:
    shapes: list[Shape] = []
    words: list[Word] = []
    for name, place in poles:
        pole = at(place)[0]
        shapes.append(spot(pole, 2.6, Ink("paper"), _POLES))
        words.append(named(label.name(f"P_{name}"), pole + np.array((10.0, -8.0)), _POLES))
    return shapes, words


def _bars(linkage: Linkage | None, at: Placed) -> Drawn:
    """Two dyads in position 1, with the coupler between them; what stands for a bar at infinity is a straight line."""
    if linkage is None:
        return [], []
    shapes: list[Shape] = []
    ends = [("A", linkage.A, "B", linkage.B[0])]
    if linkage.D is not None and linkage.along is None:
        ends.append(("D", linkage.D, "C", linkage.C[0]))
    shapes.append(Shape(at(np.array((linkage.B[0], linkage.C[0]))), Ink("body", 2), 1.6))
    pins = [(name, place) for a, A, b, B in ends for name, place in ((a, A), (b, B))]
    shapes += [Shape(at(np.array((A, B))), Ink(), 2.0) for _a, A, _b, B in ends]
    if linkage.along is not None:
        reach = 24.0 * linkage.along / np.linalg.norm(linkage.along)
        middle = at(linkage.C[0])[0]
        shapes.append(Shape(np.array((middle - reach, middle + reach)), Ink(), 2.0))
        pins.append(("D" if linkage.is_inverted else "C", linkage.C[0]))
    words: list[Word] = []
    middle = at(np.mean([place for _name, place in pins], axis=0))[0]
    for name, place in pins:
        pin = at(place)[0]
        away = (pin - middle) / max(float(np.linalg.norm(pin - middle)), 1e-9)
        shapes.append(spot(pin, 2.8, Ink("paper"), Ink()))
        words.append(named(label.name(name), pin + 11.0 * away, Ink()))
    return shapes, words
