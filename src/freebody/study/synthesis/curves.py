"""Burmester's curves of four positions: the points of the moving plane that stay on a circle, and the centres of these.

Circle points W are where the determinant of the rows N_2, N_3, N_4 of `positions` vanishes, a cubic. Seen from the
moving plane the fixed one goes through the inverse positions; its circle points are the centre points. A centre point
sees opposite sides of the quadrilateral of opposite poles, P_12 P_23 P_34 P_14, under angles that are equal or differ
by half a turn.
Source: McCarthy & Soh, Geometric Design of Linkages, 2nd ed. 2011, sec. 5.4.
"""

from __future__ import annotations

from collections.abc import Sequence
from importlib import import_module
from typing import Any

import numpy as np

from freebody.errors import CannotAnswer
from freebody.numeric.jets import Array
from freebody.study.synthesis.fewer import pole
from freebody.study.synthesis.positions import Position, inverted, places, rows_of

_GRID = 240  # cells of a side, by whose corners the curve is found
_POWERS = tuple((i, j) for i in range(4) for j in range(4 - i))  # of a cubic in (u, v)
_OPPOSITE = ((0, 1), (1, 2), (2, 3), (0, 3))  # P_12, P_23, P_34, P_14


def circle_point_curve(positions: Sequence[Position], low: Array, side: float) -> list[Array]:
    """(n, 2) runs of it, in position 1, within a square with the lower left corner `low`."""
    cubic = _cubic(positions, low, side)
    at = np.linspace(0.0, 1.0, _GRID + 1)
    values = sum(c * np.outer(at**j, at**i) for (i, j), c in zip(_POWERS, cubic, strict=True))
    return [low + side * _polished(cubic, run) for run in _zero_lines(at, np.asarray(values)) if len(run) > 1]


def centre_point_curve(positions: Sequence[Position], low: Array, side: float) -> list[Array]:
    """(n, 2) runs of it in the fixed plane, within a square with the lower left corner `low`."""
    return circle_point_curve(inverted(positions), low, side)


def opposite_poles(positions: Sequence[Position]) -> list[tuple[str, Array]]:
    """P_12, P_23, P_34 and P_14 in the fixed plane, each with its indices; those at infinity are left out."""
    found: list[tuple[str, Array]] = []
    for i, j in _OPPOSITE:
        try:
            found.append((f"{i + 1}{j + 1}", places(positions, pole(positions, i, j))[i]))
        except CannotAnswer:  # both are turned alike
            continue
    return found


def _cubic(positions: Sequence[Position], low: Array, side: float) -> Array:
    """(10,) coefficients of the determinant in parts of the square, from its values at ten points, largest one 1."""
    nodes = np.array([(i / 3, j / 3) for i, j in _POWERS])
    values = np.array([np.linalg.det(rows_of(positions, low + side * z) / (1.0, 1.0, side)) for z in nodes])
    powers = np.column_stack([nodes[:, 0] ** i * nodes[:, 1] ** j for i, j in _POWERS])
    found: Array = np.linalg.solve(powers, values)
    largest = float(np.abs(found).max())
    return found / largest if largest > 0.0 else found


def _zero_lines(at: Array, values: Array) -> Sequence[Array]:
    """Where a function on a square grid vanishes."""
    contourpy: Any = import_module("contourpy")
    return contourpy.contour_generator(at, at, values, line_type="Separate").lines(0.0)


def _polished(cubic: Array, points: Array) -> Array:
    """Newton's steps along the slope; where the curve crosses itself there is none, and the point stays."""
    for _ in range(8):
        f, slope = _value_and_slope(cubic, points)
        step = f[:, None] * slope / np.maximum((slope * slope).sum(axis=1), 1e-300)[:, None]
        is_near = np.linalg.norm(step, axis=1) < 1.0 / _GRID
        points = points - np.where(is_near[:, None], step, 0.0)
    return points


def _value_and_slope(cubic: Array, points: Array) -> tuple[Array, Array]:
    """(n,) and (n, 2)"""
    u, v = points.T
    value, du, dv = np.zeros(len(u)), np.zeros(len(u)), np.zeros(len(u))
    for (i, j), c in zip(_POWERS, cubic, strict=True):
        value += c * u**i * v**j
        du += c * i * u ** max(i - 1, 0) * v**j
        dv += c * j * u**i * v ** max(j - 1, 0)
    return value, np.column_stack((du, dv))
