"""A plane of cells: numbers by their shade, or kinds by their colour."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from freebody.present.charts.frame import HEIGHT, WIDTH, Frame, Scale, legend, picture, small
from freebody.present.figures import Array
from freebody.present.lines import number_text
from freebody.present.picture.picture import Picture
from freebody.present.picture.shapes import Ink, Shape

_MOST = 64  # cells of one axis
_SHADES = 12
_PALEST = 0.08
_NOTHING = Ink("muted", -1, 1.0, 0.25)


def heat_map(
    title: str, x_label: str, x: Array, y_label: str, y: Array, z_label: str, z: Array, *, missing: str = "no number"
) -> Picture:
    """z: (n_y, n_x), NaN where there is no number, which is called `missing`."""
    frame, x, y, z = _framed(x_label, x, y_label, y, z)
    scale = Scale.of(z_label, z)
    level = np.clip((scale.part(np.nan_to_num(z)) * _SHADES).astype(int), 0, _SHADES - 1)
    level = np.where(np.isfinite(z), level, -1)
    shapes = [*_cells(frame, x, y, level, [_shade(k) for k in range(_SHADES)]), *frame.shapes()]
    words = frame.words()
    bar = WIDTH + 14.0
    for k in range(_SHADES):
        low, high = HEIGHT * k / _SHADES, HEIGHT * (k + 1) / _SHADES
        corners = np.array(((bar, low), (bar + 10, low), (bar + 10, high), (bar, high)))
        shapes.append(Shape(corners, None, 0.0, _shade(k), is_closed=True))
    for value in scale.ticks:
        text = number_text(float(f"{value:.10g}"))
        word = small(text, (0.0, 0.0))
        words.append(small(text, (bar + 14.0 + float(word.half[0]), HEIGHT * float(scale.part(np.array(value))))))
    word = small(z_label, (0.0, 0.0))
    words.append(small(z_label, (bar + 10.0 - float(word.half[0]) + 20.0, HEIGHT + 12.0), "ink"))
    if (level < 0).any():
        more, told = legend([(missing, _NOTHING)], -38.0)
        shapes, words = shapes + more, words + told
    return picture(title, f"{title}: {z_label}", shapes, words)


def kinds_map(
    title: str,
    x_label: str,
    x: Array,
    y_label: str,
    y: Array,
    kinds: Sequence[str],
    index: NDArray[np.int64],
    *,
    missing: str = "not known",
) -> Picture:
    """index: (n_y, n_x) which of the kinds holds, -1 where none is known, which is called `missing`."""
    frame, x, y, found = _framed(x_label, x, y_label, y, index.astype(np.float64))
    level = found.astype(int)
    inks = [Ink("body", k, 1.0, 0.45) for k in range(len(kinds))]
    present = [k for k in range(len(kinds)) if (level == k).any()]
    named = [(kinds[k], inks[k]) for k in present]
    more, told = legend(named + ([(missing, _NOTHING)] if (level < 0).any() else []), -38.0)
    shapes = [*_cells(frame, x, y, level, inks), *frame.shapes(), *more]
    says = f"{title}: {', '.join(kinds[k] for k in present)}"
    return picture(title, says, shapes, [*frame.words(), *told])


def _framed(x_label: str, x: Array, y_label: str, y: Array, z: Array) -> tuple[Frame, Array, Array, Array]:
    """Ascending axes with no more cells than can be told apart; each cell lies about its value."""
    across, up = np.argsort(x), np.argsort(y)
    across, up = (
        k[np.unique(np.linspace(0, len(k) - 1, min(len(k), _MOST)).round().astype(int))] for k in (across, up)
    )
    x, y, z = x[across], y[up], z[np.ix_(up, across)]
    frame = Frame(Scale.of(x_label, _edges(x)), Scale.of(y_label, _edges(y)))
    return frame, x, y, z


def _edges(x: Array) -> Array:
    if len(x) == 1:
        room = 0.5 * abs(x[0]) or 0.5
        return np.array((x[0] - room, x[0] + room))
    inner = 0.5 * (x[1:] + x[:-1])
    return np.concatenate(([2 * x[0] - inner[0]], inner, [2 * x[-1] - inner[-1]]))


def _cells(frame: Frame, x: Array, y: Array, level: NDArray[np.int64], inks: Sequence[Ink]) -> list[Shape]:
    """Neighbours of one level in a row are one area."""
    across, up = _edges(x), _edges(y)
    shapes: list[Shape] = []
    for j in range(len(y)):
        inner = [int(k) + 1 for k in np.flatnonzero(np.diff(level[j]))]
        for a, b in pairwise((0, *inner, len(x))):
            ends = across[[a, b, b, a]], up[[j, j, j + 1, j + 1]]
            ink = inks[int(level[j, a])] if level[j, a] >= 0 else _NOTHING
            shapes.append(Shape(frame.at(*ends), ink, 0.2, ink, is_closed=True))
    return shapes


def _shade(k: int) -> Ink:
    return Ink("body", 0, 1.0, _PALEST + (1.0 - _PALEST) * k / (_SHADES - 1))
