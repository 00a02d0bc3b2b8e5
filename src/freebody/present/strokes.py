"""The few kinds of strokes that make a picture, and where they run at one instant.

A `Path` moves with a body, a `Stretch` runs between two places, a `Strand` is a string with its arcs round circles.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from freebody.present.figures import Array, Heading, Place, Rope, angles, positions, turned, with_ground
from freebody.present.layout import sweep

_FINE = 12  # points of a quarter of an arc, or of a wave
_FLAT = 8.0  # length of a wave of a slack string, by its height
_DEEPEST = 12.0  # depth of the loop of one whose ends are near each other, by the same height


@dataclass(frozen=True)
class Path:
    """A line or an area fixed in a body."""

    place: Place
    turn: int  # the body that it turns with
    points: Array  # (n, 2) [m] from the place
    style: str
    is_closed: bool = False
    color: int = -1


@dataclass(frozen=True)
class Stretch:
    """A line between two places, by its share of the way and its distance to the left, or against a heading [m]. Where
    the places are farther apart than it is `longest` it ends before the second."""

    first: Place
    second: Place
    points: Array  # (n, 2)
    style: str
    is_closed: bool = False
    longest: float | None = None
    against: Heading | None = None


@dataclass(frozen=True)
class Strand:
    """A string; `lead` is the column of its first lead in the headings. wave: [m] how far a slack one is drawn from its
    straight way at most."""

    rope: Rope
    lead: int
    style: str = "string"
    wave: float = 0.0


@dataclass(frozen=True)
class Caption:
    """A name beside a place, in sizes of symbols from it."""

    place: Place
    text: str
    dx: float
    dy: float


Stroke = Path | Stretch | Strand


def stroke_points(stroke: Stroke, pose: Array, every: Array) -> Array:
    """(n, 2) [m] a stroke in ground coordinates. pose: (1, n_bodies, 3); every: (n_leads,) [rad] headings of all
    leads of strings at that instant."""
    if isinstance(stroke, Strand):
        return _strand_points(stroke, pose, every)
    if isinstance(stroke, Path):
        every = with_ground(pose)
        x, y = _path_points(stroke, every, np.cos(every[..., 2]), np.sin(every[..., 2]))
        return np.stack((x[0], y[0]), axis=-1)
    a, b = positions(pose, stroke.first)[0], positions(pose, stroke.second)[0]
    along = b - a
    length = float(np.hypot(*along))
    left = np.array([-along[1], along[0]]) / (length or 1.0)
    if stroke.against is not None:
        left = -turned(float(angles(pose, stroke.against)[0]), 1.0, 0.0)
    if stroke.longest is not None and length > stroke.longest:
        along *= stroke.longest / length
    return a + stroke.points[:, :1] * along + stroke.points[:, 1:] * left


def paths_corners(strokes: Sequence[Path], poses: Array) -> Array:
    """(n, 2) [m] the corners of boxes round some strokes at all of many instants."""
    every = with_ground(poses)
    cos, sin = np.cos(every[..., 2]), np.sin(every[..., 2])  # of each body, once
    alike: dict[tuple[int, int, tuple[float, float]], list[Path]] = {}  # which move as one
    for stroke in strokes:
        alike.setdefault((stroke.place.body, stroke.turn, stroke.place.xy), []).append(stroke)
    corners: list[tuple[float, float]] = []
    for paths in alike.values():
        whole = replace(paths[0], points=np.concatenate([path.points for path in paths]))
        x, y = _path_points(whole, every, cos, sin)
        corners += [(float(x.min()), float(y.min())), (float(x.max()), float(y.max()))]
    return np.array(corners).reshape(-1, 2)


def _path_points(stroke: Path, every: Array, cos: Array, sin: Array) -> tuple[Array, Array]:
    """(n_times, n) [m] the coordinates of the points of a stroke. every: (n_times, n_bodies + 1, 3) with that of the
    ground; cos, sin: of its angles"""
    on, turn, (a, b) = stroke.place.body, stroke.turn, stroke.place.xy
    c, s, points = cos[:, on], sin[:, on], stroke.points
    x, y = every[:, on, 0] + (c * a - s * b), every[:, on, 1] + (s * a + c * b)
    c, s = cos[:, turn, None], sin[:, turn, None]
    return x[:, None] + (c * points[:, 0] - s * points[:, 1]), y[:, None] + (s * points[:, 0] + c * points[:, 1])


def _strand_points(strand: Strand, pose: Array, every: Array) -> Array:
    """(n, 2) [m] the way of a string at one instant: contact at C - s R n of a lead, arcs round the circles."""
    rope = strand.rope
    n_leads = len(rope.leads)
    lead = every[strand.lead : strand.lead + n_leads]
    points: list[Array] = []
    for k, node in enumerate(rope.nodes):
        before = lead[k - 1] if k > 0 else lead[-1] if rope.is_closed else rope.comes.angle if rope.comes else None
        after = lead[k] if k < n_leads else lead[0] if rope.is_closed else None
        wound = np.sign(node.arm) * 1.5 * np.pi if node.is_drum else 0.0
        into = before if before is not None else float(after or 0.0) - wound
        out = after if after is not None else float(before or 0.0) + wound
        turn = wound if node.is_drum else float(sweep(node.arm, into, out)) if node.arm else 0.0
        course = into + np.linspace(0.0, turn, max(2, round(_FINE * abs(turn) / 1.5708) + 1) if node.arm else 1)
        center = positions(pose, node.place)[0]
        points.append(center - node.arm * turned(course + np.pi / 2, 1.0, 0.0))
    found = np.concatenate(points)
    if rope.relaxed is not None and strand.wave:
        found = _slack(found, rope.relaxed, strand.wave)
    if rope.comes is None or rope.whole is None:
        return found
    left = rope.whole - float(np.hypot(*np.diff(found, axis=0).T).sum())
    return np.concatenate([found[:1] - max(left, 0.0) * turned(rope.comes.angle, 1.0, 0.0), found])


def _slack(points: Array, relaxed: float, most: float) -> Array:
    """(m, 2) [m] a string in waves along its way (n, 2), as long as it is relaxed, if these are not higher than `most`.

    A wave a sin(2 pi s/l) is longer than l by the factor 1 + (pi a/l)^2, for small a."""
    arms = np.diff(points, axis=0)
    lengths = np.hypot(*arms.T)
    whole = float(lengths.sum())
    if relaxed <= whole * (1.0 + 1e-9):
        return points
    if whole < _FLAT * most:
        return _loops(points, relaxed - whole, most)
    found: list[Array] = []
    for start, arm, length in zip(points[:-1], arms, lengths, strict=True):
        n = max(1, round(float(length) / (_FLAT * most)))
        share = np.linspace(0.0, 1.0, _FINE * n + 1)[:, None]
        height = min(most, length / n / np.pi * np.sqrt(relaxed / whole - 1.0))
        across = np.array((-arm[1], arm[0])) / (length or 1.0)
        found.append(start + share * arm + height * np.sin(2.0 * np.pi * n * share) * across)
    return np.concatenate(found)


def _loops(points: Array, left: float, most: float) -> Array:
    """(m, 2) [m] a slack string whose ends are near each other: what is left of it hangs between them in a loop, half
    as deep as that is long, or as deep as the size of the picture allows."""
    start, end = points[0], points[-1]
    deep, wide = min(_DEEPEST * most, left / 2), 0.5 * _FLAT * most
    way = np.linspace(0.0, np.pi, 2 * _FINE + 1)[:, None]
    across = 0.5 * (1.0 - np.cos(way))
    loop = start + across * (end - start) + np.concatenate((np.sin(2 * way) * wide / 2, -np.sin(way) * deep), axis=1)
    return np.concatenate((points[:-1], loop, points[-1:])) if len(points) > 2 else loop
