"""Outlines of the signs of mechanics, in any unit of length."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from freebody.present.figures import Array, Pair

TOOTH = ((-0.34, 0.0), (-0.16, 0.44), (0.16, 0.44), (0.34, 0.0))  # on its foot, by the pitch


def n_teeth(radius: float, size: float) -> int:
    """Of a wheel that is drawn with teeth: such as are seen, and not too many. size: of symbols"""
    return min(40, max(12, round(2 * np.pi * radius / (1.5 * size))))


def toothed(radius: float, n: int) -> Array:
    """(m, 2) points of a wheel with teeth, whose tips are on a circle; the x axis goes through a tooth."""
    pitch = 2 * np.pi / n
    shape = np.array([(-0.42, 0.44), (-0.2, 0.0), (0.2, 0.0), (0.42, 0.44)])  # round the circle and below it
    around = (pitch * (np.arange(n)[:, None] + shape[:, 0])).ravel()
    r = radius * (1.0 - pitch * np.tile(shape[:, 1], n))
    return np.stack((r * np.cos(around), r * np.sin(around)), axis=-1)


def circle(radius: float, n_quarter: int = 6) -> Array:
    """(n, 2) points of a circle about the origin."""
    a = np.linspace(0.0, 2 * np.pi, 4 * n_quarter, endpoint=False)
    return radius * np.stack((np.cos(a), np.sin(a)), axis=-1)


def box(half_length: float, half_height: float) -> Array:
    """(4, 2) corners of a rectangle about the origin."""
    return np.array([(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)]) * (half_length, half_height)


def capsule(start: Pair, end: Pair, radius: float) -> Array:
    """(n, 2) outline of everything within a radius of a straight line."""
    a, b = np.array(start), np.array(end)
    heading = np.arctan2(*(b - a)[::-1])
    half = np.linspace(-np.pi / 2, np.pi / 2, 9)

    def cap(center: Array, facing: float) -> Array:
        return center + radius * np.stack((np.cos(half + facing), np.sin(half + facing)), axis=-1)

    return np.concatenate((cap(b, heading), cap(a, heading + np.pi)))


def hatched(low: float, high: float, depth: float, step: float) -> Array:
    """(n, 2) slanted strokes on one side of the x axis, in one line that goes back along the axis; the side is that
    of the sign of `depth`."""
    n = min(200, max(2, round((high - low) / step)))
    feet = np.linspace(low, high, n + 1)[1:]
    tips = feet - (high - low) / n
    strokes = np.stack((feet, tips, feet), axis=1)
    return np.stack((strokes, np.broadcast_to((0.0, depth, 0.0), strokes.shape)), axis=-1).reshape(-1, 2)


def hatched_ring(radius: float, depth: float, step: float) -> Array:
    """(n, 2) slanted strokes outside a circle about the origin, in one line that goes on along the circle."""
    n = min(200, max(48, round(2 * np.pi * radius / step)))
    feet = np.linspace(0.0, 2 * np.pi, n + 1)
    tips = feet - min(0.5, depth / radius)
    at = np.stack((feet, tips, feet), axis=1)
    r = radius + np.broadcast_to((0.0, depth, 0.0), at.shape)
    return np.stack((r * np.cos(at), r * np.sin(at)), axis=-1).reshape(-1, 2)


_ROLLER = 0.24  # radius of the rollers of a support, in sizes of symbols


def support(size: float, *, upside_down: bool = False, on_rollers: bool = False) -> Iterator[tuple[Array, str, bool]]:
    """(points, style, whether closed) of a triangle on hatched ground below the origin, or above it; on rollers, where
    it can move along the ground."""
    flip = (1.0, -1.0 if upside_down else 1.0)
    base, foot = -1.9, -1.9 + (2.2 * _ROLLER if on_rollers else 0.0)
    yield np.array([(0.0, 0.0), (-1.1, foot), (1.1, foot)]) * size * flip, "support", True
    for x in (-0.6, 0.6) if on_rollers else ():
        yield (circle(_ROLLER) + np.array((x, base + _ROLLER))) * size * flip, "support", True
    yield np.array([(-1.7, base), (1.7, base)]) * size * flip, "surface", False
    yield (hatched(-1.7, 1.7, -0.75, 0.68) + np.array((0.0, base))) * size * flip, "hatch", False


def spiral(size: float) -> Array:
    """(n, 2) a flat spring about the origin."""
    a = np.linspace(0.0, 5 * np.pi, 46)
    r = size * np.linspace(0.6, 1.8, len(a))
    return np.stack((r * np.cos(a), r * np.sin(a)), axis=-1)


def vane(size: float) -> Iterator[Array]:
    """A rotary damper about the origin: a wing in a cup."""
    a = np.linspace(0.3, 2 * np.pi - 0.3, 24)
    yield 1.8 * size * np.stack((np.cos(a), np.sin(a)), axis=-1)
    yield np.array([(0.6, 0.0), (1.4, 0.0)]) * size
    yield np.array([(1.4, -0.4), (1.4, 0.4)]) * size


# Lines between two places: the share of the way, and the distance to the left in sizes of symbols.
_COILS = 11
_TURNS = np.linspace(0.14, 0.86, 2 * _COILS + 1)[1::2]
ZIGZAG: Sequence[Array] = (
    np.array([(0.0, 0.0), (0.14, 0.0), *((s, 0.7 * (-1) ** k) for k, s in enumerate(_TURNS)), (0.86, 0.0), (1.0, 0.0)]),
)
DASHPOT: Sequence[Array] = (
    np.array([(0.0, 0.0), (0.52, 0.0)]),
    np.array([(0.52, -0.55), (0.52, 0.55)]),
    np.array([(0.4, -0.8), (0.66, -0.8), (0.66, 0.8), (0.4, 0.8)]),
    np.array([(0.66, 0.0), (1.0, 0.0)]),
)


def aside(symbol: Sequence[Array], left: float) -> Sequence[Array]:
    """A symbol moved to the left between its ends, which stay."""
    if not left:
        return symbol
    moved = [np.stack((0.08 + 0.84 * line[:, 0], line[:, 1] + left), axis=-1) for line in symbol]
    ends = [np.array([(s, 0.0), (t, left)]) for s, t in ((0.0, 0.08), (1.0, 0.92))]
    return [*moved, *ends]
