"""What a picture of a system consists of, in numbers: places and directions fixed in bodies, and the bodies.

A place is given by the index of a moving body (its order in `System.moving`) and components from its mass centre along
its axes [m]. In the plane the index `GROUND` stands for the ground and all bodies fixed in it, with ground components;
in space the bodies that stand still have indices after those that move, the ground the last.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from freebody.measures.turned import within
from freebody.model import glyphs
from freebody.model.elements import Edge
from freebody.model.solids import NO_SOLID, SolidKind

Array = NDArray[np.float64]
Pair = tuple[float, float]
Triple = tuple[float, float, float]

GROUND = -1


class Place(NamedTuple):
    """A point fixed in a body."""

    body: int
    x: float
    y: float
    z: float = 0.0

    @property
    def xy(self) -> Pair:
        return self.x, self.y

    @property
    def at(self) -> Triple:
        return self.x, self.y, self.z


class Heading(NamedTuple):
    """A unit vector fixed in a body."""

    body: int
    x: float
    y: float
    z: float = 0.0

    @property
    def xy(self) -> Pair:
        return self.x, self.y

    @property
    def along(self) -> Triple:
        return self.x, self.y, self.z

    @property
    def angle(self) -> float:
        """From the body's x axis, counter-clockwise [rad]."""
        return math.atan2(self.y, self.x)

    def normal(self) -> Heading:
        """A quarter turn counter-clockwise from it."""
        return Heading(self.body, -self.y, self.x)

    def quarter_back(self) -> Heading:
        """A quarter turn clockwise from it."""
        return Heading(self.body, self.y, -self.x)


@dataclass(frozen=True)
class FigurePart:
    """A part of a composite body of space, about its own reference point; the rows of axes (3, 3) are its axes."""

    form: Figure
    axes: tuple[Triple, Triple, Triple]
    at: Triple


@dataclass(frozen=True)
class Figure:
    """A body: its named points, its form. In the plane a rim and its hubs (radii of further circles about the rim's
    centre) or corners; in space a solid with sizes [m] about its centre."""

    name: str
    number: int  # in the order of the model, for its colour
    index: int  # the body that it moves with: itself, or what it is fixed in
    mass_center: Place
    points: Mapping[str, Place]
    center: Place
    is_particle: bool = False
    has_mass: bool = True
    has_place: bool = False  # the model says where it starts
    corners: tuple[Place, ...] = ()  # of a straight-edged rim, in order
    edges: tuple[Edge[Place], ...] = ()  # what is drawn of it, where that is neither a polygon nor a full circle
    is_toothed: bool = False
    path: tuple[Place, ...] = ()  # through which it is drawn as a bent bar
    scale: float = 1.0  # how many times as large as others a point mass is drawn
    solid: SolidKind = NO_SOLID
    # in the plane
    radius: float | None = None
    hubs: tuple[float, ...] = ()
    is_hollow: bool = False
    bore: float = 0.0  # radius of the hole of an annulus
    outside: tuple[str, ...] = ()  # what may touch it, by name: its rim from outside, its corners, its points
    inside: tuple[str, ...] = ()  # what may touch its rim from inside
    # in space
    sizes: tuple[float, ...] = ()
    axis: Triple | None = None
    faces: tuple[tuple[Place, ...], ...] = ()  # of a convex body, counter-clockwise as seen from outside
    parts: tuple[FigurePart, ...] = ()  # of a composite body

    @cached_property
    def outline(self) -> Array:
        """(n, 2) [m] its edge or its corners, if they enclose an area; or those of the hull of its points or of its
        parts, counter-clockwise: two for a rod, one for a dot."""
        if len(self.edges) == 1:
            return np.array([p.xy for p in self.edges[0].places])
        if self.edges:
            return hull(np.array([p.xy for edge in self.edges if edge.look != "hole" for p in edge.places]))
        corners = np.array([p.xy for p in self.corners])
        if len(corners) > 2 and len(hull(corners)) > 2:
            return corners
        return hull(np.array([p.xy for p in self.points.values()] or [(0.0, 0.0)]))


# glyphs in numbers
Rail = glyphs.Rail[Place, Heading]
Track = glyphs.Track[Place, Heading, float]
Wheels = glyphs.Wheels[Place, float]
Node = glyphs.Node[Place, Heading, float]
Belt = glyphs.Belt[Place, float]
Groove = glyphs.Groove[Place, float]
Roller = glyphs.Roller[Place, float]
Rope = glyphs.Rope[Place, Heading, float]
Surface = glyphs.Surface[Place, Heading, float]
Spring = glyphs.Spring[Place, float]
Tether = glyphs.Tether[Place, Heading]
Tip = glyphs.Tip[Place, float]
Spread = glyphs.Spread[Place, Heading, float]
Halt = glyphs.Halt[Place, Heading, float]
TurnHalt = glyphs.TurnHalt[Heading, float]
Drawn = glyphs.Sign[Place, Heading, float]
ShownGlyph = glyphs.ShownGlyph[Place, Heading, float]


@dataclass(frozen=True)
class Wall:
    """A straight line that others may touch, solid on the right of its direction; each line once, with all that may
    touch it."""

    through: Place
    along: Heading
    tips: tuple[Tip, ...]
    edge: Pair | None = None  # [m] from where to where it is an edge of its own body, along it from `through`

    @property
    def is_endless(self) -> bool:
        """Whether it is a line of the ground, or fixed in it."""
        return self.through.body == GROUND and self.edge is None


def owners(sign: Drawn) -> set[int]:
    """The bodies that a glyph is fixed in or runs between, by index."""
    return {part.body for part in within(sign, Place, Heading)}


def places_in(sign: Drawn) -> list[Place]:
    """The places that a glyph names, in its order."""
    return list(within(sign, Place))


def turned(angle: float | Array, x: float, y: float) -> Array:
    """(..., 2) components of a vector after a turn."""
    c, s = np.cos(angle), np.sin(angle)
    return np.stack((c * x - s * y, s * x + c * y), axis=-1)


def box_round(points: Array) -> tuple[Array, Array]:
    """(d,), (d,) the least and greatest coordinates of points (n, d), each axis for itself: NumPy's reductions over the
    long axis of such an array take a hundred times as long."""
    columns = np.ascontiguousarray(points.T)
    return columns.min(axis=1), columns.max(axis=1)


def positions(poses: Array, place: Place) -> Array:
    """(n_times, 2) [m] of a place on the way."""
    if place.body == GROUND:
        return np.broadcast_to(np.array([place.x, place.y]), (len(poses), 2))
    return poses[:, place.body, :2] + turned(poses[:, place.body, 2], place.x, place.y)


def with_ground(poses: Array) -> Array:
    """(n_times, n_bodies + 1, 3) with that of the ground, whose number is the last one's counted from the end."""
    return np.concatenate((poses, np.zeros((len(poses), 1, 3))), axis=1)


def angles(poses: Array, heading: Heading) -> Array:
    """(n_times,) [rad] of a direction on the way."""
    turn = np.zeros(len(poses)) if heading.body == GROUND else poses[:, heading.body, 2]
    return turn + heading.angle


def hull(points: Array) -> Array:
    """(n, 2) convex hull, counter-clockwise, without points on its edges.
    Source: Andrew, Another efficient algorithm for convex hulls in two dimensions, 1979."""
    size = float(np.ptp(points, axis=0).max())
    ordered = sorted({(round(x / (size or 1.0), 9), round(y / (size or 1.0), 9)) for x, y in points.tolist()})
    if len(ordered) < 3:
        return np.array(ordered) * (size or 1.0)

    def chain(candidates: list[Pair]) -> list[Pair]:
        kept: list[Pair] = []
        for x, y in candidates:
            while len(kept) > 1:
                (ax, ay), (bx, by) = kept[-2:]
                if (bx - ax) * (y - ay) - (by - ay) * (x - ax) > 1e-9:
                    break
                kept.pop()
            kept.append((x, y))
        return kept[:-1]

    return np.array(chain(ordered) + chain(ordered[::-1])) * (size or 1.0)


def is_within(corners: Array, point: Pair) -> bool:
    """Whether a point lies in a convex polygon or on its edge. corners: (n, 2), counter-clockwise or clockwise."""
    sides = np.roll(corners, -1, axis=0) - corners
    away = np.array(point) - corners
    turn = sides[:, 0] * away[:, 1] - sides[:, 1] * away[:, 0]
    least = 1e-9 * float(np.ptp(corners, axis=0).max()) ** 2
    return bool((turn > -least).all() or (turn < least).all())
