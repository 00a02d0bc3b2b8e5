"""Curves over one axis; where a value is none, a curve has a gap."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np
from numpy.typing import NDArray

from freebody.present.charts.frame import Frame, Scale, legend, picture
from freebody.present.figures import Array
from freebody.present.picture.picture import Picture
from freebody.present.picture.shapes import Ink, Shape

_DASHES = ((), (6.0, 2.5), (2.0, 2.0), (6.0, 2.0, 1.5, 2.0))
_MOST = 1500  # points of a curve
_DOT = 1.6  # half of the side of a mark [points]


def line_chart(
    title: str, x_label: str, x: Array, y_label: str, curves: Sequence[tuple[str, Array]], *, is_joined: bool = True
) -> Picture:
    """curves: each with its name, (n,) values over x; is_joined: by lines, else dots stand alone."""
    x, curves = _thinned(x, curves)
    frame = Frame(Scale.of(x_label, x), Scale.of(y_label, np.concatenate([y for _name, y in curves])))
    shapes = frame.shapes()
    for k, (_name, y) in enumerate(curves):
        ink = Ink("body", k)
        at = frame.at(x, y)
        for run in _runs(y) if is_joined else ():
            if len(run) > 1:
                shapes.append(Shape(at[run], ink, 1.4, dashes=_DASHES[k % len(_DASHES)]))
        if not is_joined or len(x) <= 40:
            shapes += [_dot(place, ink) for place in at[np.isfinite(y)]]
    words = frame.words()
    if len(curves) > 1:
        more, told = legend([(name, Ink("body", k)) for k, (name, _y) in enumerate(curves)], -38.0)
        shapes, words = shapes + more, words + told
    names = ", ".join(name for name, _y in curves)
    return picture(title, f"{title}: {names if len(curves) > 1 else y_label}", shapes, words)


def _thinned(x: Array, curves: Sequence[tuple[str, Array]]) -> tuple[Array, list[tuple[str, Array]]]:
    """No more points than can be seen, evenly taken."""
    kept = np.unique(np.linspace(0, len(x) - 1, min(len(x), _MOST)).round().astype(int))
    return x[kept], [(name, y[kept]) for name, y in curves]


def _runs(y: Array) -> Iterator[NDArray[np.intp]]:
    """The places of values without a gap between them."""
    known = np.flatnonzero(np.isfinite(y))
    yield from np.split(known, np.flatnonzero(np.diff(known) > 1) + 1) if len(known) else ()


def _dot(at: Array, ink: Ink) -> Shape:
    corners = at + _DOT * np.array(((-1, 0), (0, -1), (1, 0), (0, 1)))
    return Shape(corners, None, 0.0, ink, is_closed=True)
