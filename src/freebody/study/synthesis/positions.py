"""Positions of a moving plane, and the condition that a point of it stays on a circle.

A point that is at W in position 1 is at R_j W + d_j in position j. It stays at one distance from a fixed point G if

    (W - R_j W - d_j) . G + d_j . R_j W + |d_j|^2/2 = 0,   j = 2 ... n,

bilinear in W and G. As rows N_j(W) = (A_j, B_j, C_j) with N_j (x, y, z) = 0 for G = (x, y)/z; z = 0 is a straight line
across (x, y), on which the point moves.
Source: McCarthy & Soh, Geometric Design of Linkages, 2nd ed. 2011, sec. 5.1 to 5.5.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction

import numpy as np

from freebody.numeric.jets import Array


@dataclass(frozen=True)
class Position:
    """Of the moving plane: where its origin is [m], and how it is turned [rad]. exact_x, exact_y: the coordinates as
    they were written; degrees: the angle as it was written, where that is a number of degrees."""

    x: float
    y: float
    angle: float
    exact_x: Fraction | None = None
    exact_y: Fraction | None = None
    degrees: Fraction | None = None


@dataclass(frozen=True)
class Dyad:
    """A bar between a fixed point and one of the moving plane, or what stands for it where one of them is at infinity.

    bar     moving: (2,) W in position 1; fixed: (2,) G
    slide   G at infinity: W moves on a straight line; fixed: its direction
    line    W at infinity: a straight line of the moving plane goes through G; moving: its direction in position 1

    residual: [m] how far W, or G, is off at worst."""

    moving: Array
    fixed: Array
    is_slide: bool = False
    residual: float = 0.0
    is_line: bool = False

    @property
    def is_bar(self) -> bool:
        return not (self.is_slide or self.is_line)

    @property
    def length(self) -> float:
        return float(np.linalg.norm(self.moving - self.fixed))


def rotation(angle: float) -> Array:
    """(2, 2)"""
    c, s = math.cos(angle), math.sin(angle)
    return np.array(((c, -s), (s, c)))


def displacements(positions: Sequence[Position]) -> list[tuple[Array, Array]]:
    """R_j and d_j of all positions, the first of which are 1 and 0."""
    first = positions[0]
    p1 = np.array((first.x, first.y))
    found: list[tuple[Array, Array]] = []
    for p in positions:
        R = rotation(p.angle - first.angle)
        found.append((R, np.array((p.x, p.y)) - R @ p1))
    return found


def inverted(positions: Sequence[Position]) -> tuple[Position, ...]:
    """The fixed plane as it is seen from the moving one: X_j = R_j^-1 (X - d_j), in position 1 the same."""
    found: list[Position] = []
    for R, d in displacements(positions):
        x, y = -R.T @ d
        found.append(Position(float(x), float(y), -math.atan2(R[1, 0], R[0, 0])))
    return tuple(found)


def lines_from(slides: Sequence[Dyad]) -> list[Dyad]:
    """Slides of the inverted positions as lines of the moving plane."""
    return [Dyad(d.fixed, d.moving, residual=d.residual, is_line=True) for d in slides if d.is_slide]


def rows_of(positions: Sequence[Position], W: Array) -> Array:
    """(n - 1, 3) N_j(W)."""
    found: list[Array] = []
    for R, d in displacements(positions)[1:]:
        RW = R @ W
        found.append(np.append(W - RW - d, d @ RW + 0.5 * d @ d))
    return np.array(found)


def places(positions: Sequence[Position], W: Array) -> Array:
    """(n, 2) where a point of the moving plane is."""
    return np.array([R @ W + d for R, d in displacements(positions)])


def size_of(positions: Sequence[Position]) -> float:
    """A length by which others are judged."""
    at = np.array([(p.x, p.y) for p in positions])
    return float(np.ptp(at, axis=0).max()) or float(np.abs(at).max()) or 1.0


def bar(positions: Sequence[Position], W: Array, G: Array) -> Dyad:
    """With its residual."""
    lengths = np.linalg.norm(places(positions, W) - G, axis=1)
    return Dyad(W, G, residual=float(np.ptp(lengths)))


def slide(positions: Sequence[Position], W: Array) -> Dyad:
    """Along the line through the places of W."""
    at = places(positions, W)
    middle = at - at.mean(axis=0)
    _u, _s, vt = np.linalg.svd(middle)
    along = vt[0] * (
        1.0 if (abs(vt[0][0]) > 1e-12 and vt[0][0] > 0) or (abs(vt[0][0]) <= 1e-12 and vt[0][1] > 0) else -1.0
    )
    across = middle @ np.array((-along[1], along[0]))
    return Dyad(W, along, True, float(np.abs(across).max()))
