"""Names of bodies beside them, where they cover least.

Round each body some places are tried, just far enough from its edges. A place costs what is drawn below it and how near
other bodies are, and most of all other names and the edge of the picture.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cache

import numpy as np
from numpy.typing import NDArray

from freebody.present.figures import Array
from freebody.present.picture.placer import points_along
from freebody.present.picture.shapes import Shape

_N_AROUND = 16
_N_STEPS = 40
_ASIDE = 100.0  # the cost of another name below, and of standing outside the picture
_BELOW = 0.8  # of a point of a line below
_STRANGE = 4.0  # of being nearer to another body than to its own
_ON_OTHERS = 3.0  # of standing on something else
_FAR = 0.8  # of a letter of distance from the body
_ASTRAY = 0.06  # of a letter of distance from the middle of the body
_AGAIN = 1.5  # what a name stays for where it was


@dataclass(frozen=True)
class Name:
    """A name, its middle on paper (2,), half of its width and height, and the number of its place round the body."""

    text: str
    at: Array
    half: Array
    choice: int

    def overlaps(self, at: Array, half: Array) -> bool:
        return bool((np.abs(self.at - at) < self.half + half).all())


@dataclass(frozen=True)
class Painted:
    """What one stroke or piece becomes on paper. owner: the number of the body that it is, -1 for what joins bodies,
    None for a plane behind them; outline: (n, 2) of its area, convex, no points of a line; middle: (2,) of a ball."""

    owner: int | None
    shapes: tuple[Shape, ...]
    outline: Array
    middle: Array | None = None


@dataclass(frozen=True)
class Footprint:
    """What is drawn of a body, or of what joins bodies: points (n, 2) along lines, and outlines of pieces."""

    points: Array
    outlines: tuple[Array, ...]

    @classmethod
    def of(cls, painted: Sequence[Painted], letter: float) -> Footprint:
        """letter: [m] the height of one on paper; points nearer than a third of it are one."""
        step = letter / 3
        lines = [shape.points for own in painted for shape in own.shapes if not (shape.is_area or shape.is_closed)]
        outlines = [own.outline for own in painted if len(own.outline)]
        middles = [own.middle[None] for own in painted if own.middle is not None]
        rims = [np.concatenate((outline, outline[:1])) for outline in outlines]
        dense = np.concatenate([np.zeros((0, 2)), *middles, *(_points_on(line, step) for line in (*lines, *rims))])
        return cls(np.unique(np.round(dense / step), axis=0) * step, tuple(outlines))

    def has(self, at: Array) -> bool:
        """Whether a point (2,) is on one of its pieces."""
        for outline in self.outlines:
            way, arm = outline[_next(len(outline))] - outline, at - outline
            if (way[:, 0] * arm[:, 1] >= way[:, 1] * arm[:, 0]).all():
                return True
        return False


def footprints(painted: Sequence[Painted], letter: float) -> dict[int, Footprint]:
    """What is drawn, by the number of the body that it belongs to."""
    owned: dict[int, list[Painted]] = {}
    for own in painted:
        if own.owner is not None:
            owned.setdefault(own.owner, []).append(own)
    return {owner: Footprint.of(own, letter) for owner, own in owned.items()}


@cache
def _next(n: int) -> NDArray[np.intp]:
    """Indices of the points after each of a closed line."""
    return (np.arange(n) + 1) % n


def names(
    inks: Mapping[int, Footprint],
    bodies: Mapping[int, str],
    letter: tuple[float, float],
    frame: tuple[Array, Array],
    before: Mapping[str, int] | None = None,
    *,
    stays: bool = False,
) -> list[Name]:
    """inks: what is drawn, by the index of the body it belongs to; bodies: names by index; letter: width and height
    of one on paper [m]; frame: the corners of the picture, (2,) and (2,); before: the choices of the last picture,
    which are kept where they are not much worse, or if a name `stays` and none stands there."""
    width, height = letter
    placed: list[Name] = []
    for index, text in bodies.items():
        if index not in inks or not len(inks[index].points):
            continue
        own = inks[index].points
        rest = [ink for k, ink in inks.items() if k != index]
        others = np.concatenate([np.zeros((0, 2)), *(ink.points for ink in rest)])
        half = 0.5 * np.array((width * len(text) + 0.3 * height, 1.2 * height))
        middle = 0.5 * (own.min(axis=0) + own.max(axis=0))
        kept = before.get(text) if before is not None else None
        if stays and kept is not None:
            at = _option(kept, own, middle, half, height)
            if not any(name.overlaps(at, half) for name in placed):
                placed.append(Name(text, at, half, kept))
                continue
        options = [_option(k, own, middle, half, height) for k in range(_N_AROUND + 1)]
        costs = [
            _cost(at, half, own, others, height)
            + _ON_OTHERS * any(ink.has(at) for ink in rest)
            + _ASIDE * sum(name.overlaps(at, half) for name in placed)
            + _ASIDE * bool((at - half < frame[0]).any() or (at + half > frame[1]).any())
            + (_FAR * _gap(at, half, own) + _ASTRAY * float(np.linalg.norm(at - middle))) / height
            - _AGAIN * (kept == k)
            for k, at in enumerate(options)
        ]
        k = int(np.argmin(costs))
        placed.append(Name(text, options[k], half, k))
    return placed


def _option(k: int, own: Array, middle: Array, half: Array, letter: float) -> Array:
    """Just outside of a body in a direction from its middle, the upper right first; the last one is its middle."""
    if k == _N_AROUND:
        return middle
    a = 0.25 * np.pi + (-1) ** k * ((k + 1) // 2) * 2 * np.pi / _N_AROUND
    way = np.array((np.cos(a), np.sin(a)))
    far = max(float(((own - middle) @ way).max()), 0.0) + float(np.abs(way) @ half)
    spots = middle + np.linspace(0.0, far + 0.5 * letter, _N_STEPS)[:, None] * way
    near = np.abs(own - spots[:, None]) < half + 0.25 * letter
    is_taken = (near[..., 0] & near[..., 1]).sum(axis=1) > 0
    last = int(np.flatnonzero(is_taken).max(initial=-1))
    return spots[min(_N_STEPS - 1, last + 1)]


def _cost(at: Array, half: Array, own: Array, others: Array, letter: float) -> float:
    below = int((np.abs(own - at) < half).all(axis=1).sum()) + int((np.abs(others - at) < half).all(axis=1).sum())
    nearer = _gap(at, half, own) - _gap(at, half, others)
    return _BELOW * below + _STRANGE * min(1.0, max(0.0, 0.5 + nearer / (2 * letter)))


def _gap(at: Array, half: Array, points: Array) -> float:
    """The distance of points (n, 2) from a name."""
    if not len(points):
        return float("inf")
    return float(np.linalg.norm(np.maximum(np.abs(points - at) - half, 0.0), axis=1).min())


def _points_on(way: Array, step: float) -> Array:
    return np.concatenate((points_along(way, step, 200), way[-1:]))
