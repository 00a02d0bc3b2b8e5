"""Parallel coordinates: an upright axis for each name, a line for each case, its shade by the last name.

Source: Inselberg, The plane with parallel coordinates, The Visual Computer 1, 1985, 69-91.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from freebody.present.charts.frame import HEIGHT, Scale, picture, small
from freebody.present.figures import Array
from freebody.present.lines import number_text
from freebody.present.picture.picture import Picture
from freebody.present.picture.shapes import Ink, Shape, line

_APART = 95.0  # [points] between two axes
_MOST = 300  # lines
_PALEST = 0.15


def parallel_chart(title: str, labels: Sequence[str], values: Array) -> Picture:
    """values: (n_cases, n_names); cases with a name without a number are left out."""
    known = values[np.isfinite(values).all(axis=1)]
    chosen = known[np.unique(np.linspace(0, max(len(known) - 1, 0), min(len(known), _MOST)).round().astype(int))]
    scales = [Scale.of(text, known[:, k]) for k, text in enumerate(labels)]
    x = np.array([_APART * k for k in range(len(labels))])
    parts = np.column_stack([scale.part(chosen[:, k]) for k, scale in enumerate(scales)])
    shapes = [
        Shape(np.column_stack((x, HEIGHT * row)), Ink("body", 0, 0.7, _PALEST + (1 - _PALEST) * float(row[-1])), 0.8)
        for row in parts[np.argsort(parts[:, -1])]
    ]
    words = [small(text, (float(x[k]), HEIGHT + 24.0), "ink") for k, text in enumerate(labels)]
    for k, scale in enumerate(scales):
        shapes.append(line(np.array(((x[k], 0.0), (x[k], HEIGHT))), "ink", -1, 1.0, 1.0, 1.0))
        ends = ((scale.low, -9.0), (scale.high, HEIGHT + 10.0))
        words += [small(number_text(float(f"{value:.4g}")), (float(x[k]), y)) for value, y in ends]
    says = f"{title} ({len(chosen)}/{len(known)}): {', '.join(labels)}"
    return picture(title, says, shapes, words)
