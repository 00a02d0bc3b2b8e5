"""A linkage in all its positions, with the curve of the traced point."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence

import numpy as np

from freebody.numeric.jets import Array
from freebody.present.charts.frame import SMALL, picture, small
from freebody.present.picture import label
from freebody.present.picture.picture import Picture
from freebody.present.picture.shapes import Ink, Shape, Word
from freebody.present.symbols import circle
from freebody.study.synthesis.linkage import Linkage

_WIDTH = 320.0  # [points]
_DOT = 2.2
_BLOCK = 6.0  # [points] half the length of a slider

Placed = Callable[[Array], Array]


def linkage_picture(title: str, linkage: Linkage) -> Picture:
    """Bars of every position, the first one strong and with its pins named; the coupler curve dashed; a slide as far as
    it is used."""
    _B, C = _moved(linkage)
    curve, guide = coupler_curve(linkage), _guide(linkage, C)
    every = [linkage.A[None], linkage.B, linkage.C, guide, *([curve] if len(curve) else [])]
    every += [x for x in (linkage.P, None if linkage.D is None else linkage.D[None]) if x is not None]
    points = np.vstack(every)
    points = points[np.isfinite(points).all(axis=1)]
    low, size = points.min(axis=0), float(np.ptp(points, axis=0).max()) or 1.0

    def at(x: Array) -> Array:
        return (np.atleast_2d(x) - low) / size * _WIDTH

    shapes: list[Shape] = [Shape(at(guide), Ink("muted"), 1.2)] if len(guide) else []
    shapes += [Shape(at(run), Ink("body", 3), 1.0, dashes=(4.0, 2.0)) for run in _runs(curve) if len(run) > 1]
    for k in reversed(range(linkage.n)):
        shapes += _position(linkage, k, at, size)
    words: list[Word] = []
    for k, x in enumerate([] if linkage.P is None else linkage.P):
        place = at(x)[0]
        shapes.append(_dot(place))
        words.append(small(str(k + 1), (float(place[0]) + 5.0, float(place[1]) + 6.0), "ink"))
    more, told = _pins(linkage, at)
    return picture(title, title, [*shapes, *more], [*words, *told])


def _position(linkage: Linkage, k: int, at: Placed, size: float) -> list[Shape]:
    crank, coupler, rocker = (Ink("body", body, alpha=1.0 if k == 0 else 0.45) for body in range(3))
    width = 2.0 if k == 0 else 0.9
    corners = [linkage.B[k], linkage.C[k], *([] if linkage.P is None else [linkage.P[k]])]
    shapes = [Shape(at(np.array((linkage.A, linkage.B[k]))), crank, width)]
    shapes.append(Shape(at(np.array(corners)), coupler, width, is_closed=len(corners) > 2))
    if linkage.is_inverted:
        shapes.append(Shape(at(_slot(linkage, k, size)), coupler, width, dashes=(3.0, 2.0)))
    elif linkage.D is not None:
        shapes.append(Shape(at(np.array((linkage.C[k], linkage.D))), rocker, width))
    else:
        shapes.append(Shape(at(linkage.C[k])[0] + _BLOCK * _turned(linkage), rocker, width, is_closed=True))
    return shapes


def _turned(linkage: Linkage) -> Array:
    """(4, 2) corners of the slider's block, of the size 1."""
    assert linkage.along is not None
    x, y = linkage.along
    return np.array(((1, 0.6), (-1, 0.6), (-1, -0.6), (1, -0.6))) @ np.array(((x, y), (-y, x)))


def _pins(linkage: Linkage, at: Placed) -> tuple[list[Shape], list[Word]]:
    """In position 1: the fixed ones filled, the others not."""
    fixed = [("A", linkage.A), *([] if linkage.D is None else [("D", linkage.D)])]
    moving = [("B", linkage.B[0]), *([] if linkage.is_inverted else [("C", linkage.C[0])])]
    middle = at(np.mean([x for _name, x in (*fixed, *moving)], axis=0))[0]
    shapes: list[Shape] = []
    words: list[Word] = []
    for name, x in (*fixed, *moving):
        pin = at(x)[0]
        away = (pin - middle) / max(float(np.linalg.norm(pin - middle)), 1e-9)
        shapes.append(spot(pin, 2.8, Ink() if (name in "AD") else Ink("paper"), Ink()))
        words.append(named(label.name(name), pin + 11.0 * away, Ink()))
    return shapes, words


def _guide(linkage: Linkage, C: Array) -> Array:
    """(2, 2) the ends of the slide, a little beyond where the slider goes; nothing of other linkages."""
    if not linkage.is_slider:
        return np.zeros((0, 2))
    assert linkage.along is not None
    places = np.vstack((linkage.C, C[np.isfinite(C).all(axis=1)]))
    s = (places - linkage.C[0]) @ linkage.along
    more = 0.06 * linkage.size
    return linkage.C[0] + np.outer((s.min() - more, s.max() + more), linkage.along)


def spot(at: Array, radius: float, fill: Ink, edge: Ink | None = None) -> Shape:
    return Shape(at + circle(radius, 4), edge, 0.0 if edge is None else 1.1, fill, is_closed=True)


def named(text: label.Label, at: Array, ink: Ink) -> Word:
    return Word(text, at, SMALL + 1.0, ink)


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


def coupler_curve(linkage: Linkage) -> Array:
    """(n, 2) where the traced point is while the crank turns on the branch of position 1; NaN where the loop does not
    close; nothing without such a point."""
    if linkage.P is None:
        return np.zeros((0, 2))
    B, C = _moved(linkage)
    z = (C - B) @ np.array((1.0, 1j))
    first = (linkage.C[0] - linkage.B[0]) @ np.array((1.0, 1j))
    traced = (linkage.P[0] - linkage.B[0]) @ np.array((1.0, 1j)) * z / first
    return B + np.column_stack((traced.real, traced.imag))


def _moved(linkage: Linkage, n: int = 361) -> tuple[Array, Array]:
    """(n, 2) B and C while the crank turns."""
    a = linkage.lengths["crank"]
    base = linkage.along if linkage.D is None else linkage.D - linkage.A
    assert base is not None
    start = math.atan2(base[1], base[0])
    B = linkage.A + a * np.column_stack([f(np.linspace(0, math.tau, n) + start) for f in (np.cos, np.sin)])
    with np.errstate(invalid="ignore"):
        return B, _driven(linkage, B, float(linkage.branches[0]))


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
