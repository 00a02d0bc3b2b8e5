"""A linkage in all its positions, with the curve of the traced point."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from freebody.numeric.jets import Array
from freebody.present.charts.frame import picture, small
from freebody.present.picture.picture import Picture
from freebody.present.picture.shapes import Ink, Shape, Word
from freebody.study.synthesis.linkage import Linkage

_WIDTH = 320.0  # [points]
_DOT = 2.2


def linkage_picture(title: str, linkage: Linkage) -> Picture:
    """Bars of every position, the first one strong; the coupler curve dashed."""
    curve = coupler_curve(linkage)
    every = [linkage.A[None], linkage.B, linkage.C, *([curve] if len(curve) else [])]
    every += [x for x in (linkage.P, None if linkage.D is None else linkage.D[None]) if x is not None]
    points = np.vstack(every)
    points = points[np.isfinite(points).all(axis=1)]
    low, size = points.min(axis=0), float(np.ptp(points, axis=0).max()) or 1.0

    def at(x: Array) -> Array:
        return (np.atleast_2d(x) - low) / size * _WIDTH

    shapes: list[Shape] = [
        Shape(at(run), Ink("body", 3), 1.0, dashes=(4.0, 2.0)) for run in _runs(curve) if len(run) > 1
    ]
    for k in reversed(range(linkage.n)):
        crank, coupler, rocker = (Ink("body", body, alpha=1.0 if k == 0 else 0.45) for body in range(3))
        width = 2.0 if k == 0 else 0.9
        shapes.append(Shape(at(np.array((linkage.A, linkage.B[k]))), crank, width))
        corners = [linkage.B[k], linkage.C[k], *([] if linkage.P is None else [linkage.P[k]])]
        shapes.append(Shape(at(np.array(corners)), coupler, width, is_closed=len(corners) > 2))
        if linkage.is_inverted:
            shapes.append(Shape(at(_slot(linkage, k, size)), coupler, width, dashes=(3.0, 2.0)))
        elif linkage.D is not None:
            shapes.append(Shape(at(np.array((linkage.C[k], linkage.D))), rocker, width))
    pins = [linkage.A, linkage.B[0], linkage.C[0], *([] if linkage.D is None else [linkage.D])]
    shapes += [_dot(at(x)[0]) for x in pins]
    words: list[Word] = []
    if linkage.P is not None:
        for k, x in enumerate(linkage.P):
            place = at(x)[0]
            shapes.append(_dot(place))
            words.append(small(str(k + 1), (float(place[0]) + 5.0, float(place[1]) + 6.0), "ink"))
    return picture(title, title, shapes, words)


def _slot(linkage: Linkage, k: int, size: float) -> Array:
    """The coupler's line in a position, from beside B to beyond D."""
    assert linkage.D is not None
    e = linkage.lines[k]
    s = float(linkage.travel[k])
    return np.array((linkage.D - s * e, linkage.D + math.copysign(0.1 * size, s) * e))


def _dot(at: Array) -> Shape:
    corners = at + _DOT * np.array(((-1, 0), (0, -1), (1, 0), (0, 1)))
    return Shape(corners, None, 0.0, Ink(), is_closed=True)


def _runs(curve: Array) -> Sequence[Array]:
    if not len(curve):
        return []
    known = np.isfinite(curve).all(axis=1)
    cuts = np.flatnonzero(~known)
    return [part[np.isfinite(part).all(axis=1)] for part in np.split(curve, cuts)]


def coupler_curve(linkage: Linkage, n: int = 361) -> Array:
    """(n, 2) where the traced point is while the crank turns on the branch of position 1; NaN where the loop does not
    close; nothing without such a point."""
    if linkage.P is None:
        return np.zeros((0, 2))
    a = linkage.lengths["crank"]
    base = linkage.along if linkage.D is None else linkage.D - linkage.A
    assert base is not None
    start = math.atan2(base[1], base[0])
    B = linkage.A + a * np.column_stack([f(np.linspace(0, math.tau, n) + start) for f in (np.cos, np.sin)])
    sigma = float(linkage.branches[0])
    with np.errstate(invalid="ignore"):
        C = _driven(linkage, B, sigma)
    z = (C - B) @ np.array((1.0, 1j))
    first = (linkage.C[0] - linkage.B[0]) @ np.array((1.0, 1j))
    traced = (linkage.P[0] - linkage.B[0]) @ np.array((1.0, 1j)) * z / first
    return B + np.column_stack((traced.real, traced.imag))


def _driven(linkage: Linkage, B: Array, sigma: float) -> Array:
    """C where the crank's end is B."""
    if linkage.is_inverted:
        return _through_pivot(linkage, B, sigma)
    if linkage.D is None:
        return _on_slide(linkage, B, linkage.lengths["rod"], sigma)
    return _on_circle(B, linkage.D, linkage.lengths["coupler"], linkage.lengths["rocker"], sigma)


def _on_circle(B: Array, D: Array, b: float, c: float, sigma: float) -> Array:
    """The points b from B and c from D, on the side sigma of (C - B) x (D - C)."""
    r = D - B
    L2 = (r * r).sum(axis=1)
    part = (b * b - c * c + L2) / (2 * L2)
    height = np.sqrt(b * b / L2 - part * part)
    return B + part[:, None] * r - sigma * height[:, None] * np.column_stack((-r[:, 1], r[:, 0]))


def _through_pivot(linkage: Linkage, B: Array, sigma: float) -> Array:
    """C of the coupler whose line goes through D: D - B = (s + i e) times its direction, s^2 = BD^2 - e^2."""
    assert linkage.D is not None
    r = (linkage.D - B) @ np.array((1.0, 1j))
    s = sigma * np.sqrt(np.abs(r) ** 2 - linkage.offset**2)
    unit = np.array((1.0, 1j))
    turned = r / (s + 1j * linkage.offset) / (linkage.lines[0] @ unit)
    arm = ((linkage.C[0] - linkage.B[0]) @ unit) * turned
    return B + np.column_stack((arm.real, arm.imag))


def _on_slide(linkage: Linkage, B: Array, rod: float, sigma: float) -> Array:
    along = linkage.along
    assert along is not None
    normal = np.array((-along[1], along[0]))
    across = linkage.offset - (B - linkage.A) @ normal
    return B + across[:, None] * normal + sigma * np.sqrt(rod * rod - across * across)[:, None] * along
