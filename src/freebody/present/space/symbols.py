"""The signs of mechanics in space, about the origin, each as a few solids with looks; sizes in sizes of symbols."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise

import numpy as np

from freebody.present.figures import Array
from freebody.present.space.solids import Solid, basis, cone, plate, prism, tube

Sign = tuple[Solid, str, tuple[Array, ...]]  # a solid, its look, and lines on it

AXLE = 0.42  # radius
BALL = 0.85
STAND = 2.4  # height
_COILS, _PER_COIL = 9, 14


def axle(axis: Array, ends: list[float], radius: float) -> Iterator[Solid]:
    """A bar along an axis (3,), in parts from each end to the next."""
    for low, high in pairwise(ends):
        if high - low > 1e-9:
            yield prism(radius, low, high, 16).moved(basis(axis))


def stand(down: Array, u: float) -> Iterator[Sign]:
    """A cone with its apex at the origin on a hatched square, in the direction `down` (3,)."""
    axes = basis(down)
    yield cone(1.0 * u, STAND * u, 20).moved(axes), "stand", ()
    half = 1.75 * u
    corners = half * np.array([(-1, -1, 0), (1, -1, 0), (1, 1, 0), (-1, 1, 0)]) + (0.0, 0.0, STAND * u)
    lines = [np.array([(-half, c, 0.0), (half, c, 0.0)]) for c in np.linspace(-half, half, 7)[1:-1]]
    turn = np.array([(0.70710678, 0.70710678, 0.0), (-0.70710678, 0.70710678, 0.0), (0.0, 0.0, 1.0)])
    base = np.array((0.0, 0.0, STAND * u))
    slanted = [base + _within(line @ turn, half) for line in lines]
    yield plate(corners).moved(axes), "hatched", tuple(line @ axes for line in slanted)


def _within(line: Array, half: float) -> Array:
    """The part of a line (2, 3) at 45 degrees, as long as needed, inside a square."""
    a, b = line
    middle, along = (a + b) / 2, (b - a) / np.linalg.norm(b - a)
    room = min((half - s * middle[k]) / abs(along[k]) for k in (0, 1) for s in (-1, 1))
    return np.array([middle - room * along, middle + room * along])


def arrow(along: Array, start: float, length: float, u: float) -> Iterator[Solid]:
    """A straight arrow along a direction (3,)."""
    axes = basis(along)
    head = min(1.7 * u, 0.5 * length)
    yield prism(0.16 * u, start, start + length - head, 8).moved(axes)
    tip = cone(0.36 * head, -head, 12)
    flipped = Solid(tip.points, tuple(face[::-1] for face in tip.faces), tip.edges)
    yield flipped.moved(axes, (start + length) * along)


def curved_arrow(axis: Array, top: Array, radius: float, u: float) -> Iterator[Solid]:
    """A right-handed arrow about an axis (3,) through the origin; its middle is where `top` (3,) points, if it can."""
    side = np.cross(axis, top)
    if float(np.linalg.norm(side)) > 0.1:
        side = side / np.linalg.norm(side)
        axes = np.array([np.cross(side, axis), side, axis])
    else:
        axes = basis(axis)
    a = np.linspace(-0.75 * np.pi, 0.6 * np.pi, 33)
    way = radius * np.stack((np.cos(a), np.sin(a), np.zeros_like(a)), axis=-1)
    yield from (part.moved(axes) for part in tube(way, 0.13 * u))
    end, course = way[-1], np.array([-np.sin(a[-1]), np.cos(a[-1]), 0.0])
    tip = cone(0.55 * u, -1.6 * u, 12)
    flipped = Solid(tip.points, tuple(face[::-1] for face in tip.faces), tip.edges)
    yield flipped.moved(basis(course), end + 1.4 * u * course).moved(axes)


def spiral(axis: Array, u: float) -> Iterator[Solid]:
    """A flat spring about an axis (3,) through the origin."""
    a = np.linspace(0.0, 5 * np.pi, 61)
    r = u * np.linspace(0.7, 2.0, 61)
    way = np.stack((r * np.cos(a), r * np.sin(a), np.zeros_like(a)), axis=-1)
    yield from (part.moved(basis(axis)) for part in tube(way, 0.12 * u, 6))


def helix(radius: float) -> Array:
    """(n, 3) a spring from z = 0 to z = 1, with straight ends."""
    a = np.linspace(0.0, 2 * np.pi * _COILS, _COILS * _PER_COIL + 1)
    z = np.linspace(0.1, 0.9, len(a))
    coils = np.stack((radius * np.sin(a), radius * (1.0 - np.cos(a)) - radius, z), axis=-1)
    return np.concatenate(([(0.0, 0.0, 0.0), (0.0, 0.0, 0.1)], coils, [(0.0, 0.0, 0.9), (0.0, 0.0, 1.0)]))


def damper(radius: float) -> Iterator[Solid]:
    """A pot and its piston rod, from z = 0 to z = 1."""
    yield prism(0.2 * radius, 0.0, 0.36, 8)
    yield prism(radius, 0.36, 0.64, 16)
    yield prism(0.2 * radius, 0.64, 1.0, 8)


def thread(radius: float, low: float, high: float, pitch: float) -> Array:
    """(n, 3) a helix about z."""
    n = max(2, round(12 * (high - low) / pitch))
    z = np.linspace(low, high, n)
    a = 2 * np.pi * z / pitch
    return np.stack((radius * np.cos(a), radius * np.sin(a), z), axis=-1)
