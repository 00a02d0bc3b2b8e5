"""What a picture of a system consists of, in numbers: places fixed in bodies and what joins them.

A place is given by the index of a moving body (its order in `System.moving`) and components from its mass centre
[m]; the index `GROUND` stands for the ground and all bodies fixed in it, with ground components.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Pair = tuple[float, float]

GROUND = -1


class Place(NamedTuple):
    """A point fixed in a body."""

    body: int
    x: float
    y: float


class Heading(NamedTuple):
    """A unit vector fixed in a body."""

    body: int
    x: float
    y: float

    @property
    def angle(self) -> float:
        """From the body's x axis, counter-clockwise [rad]."""
        return math.atan2(self.y, self.x)

    def normal(self) -> Heading:
        """A quarter turn counter-clockwise from it."""
        return Heading(self.body, -self.y, self.x)


@dataclass(frozen=True)
class Figure:
    """A body: its named points, its rim and its hubs (radii of further circles about the rim's centre)."""

    name: str
    number: int  # in the order of the model, for its colour
    mass_center: Place
    points: Mapping[str, Place]
    center: Place
    turn: int  # the body that it turns with: itself, or GROUND
    radius: float | None = None
    hubs: tuple[float, ...] = ()
    is_hollow: bool = False
    is_particle: bool = False
    has_mass: bool = True
    has_place: bool = False  # the model says where it starts
    corners: tuple[Place, ...] = ()  # of a straight-edged rim, in order
    outside: tuple[str, ...] = ()  # what may touch it, by name: its rim from outside, its corners, its points
    inside: tuple[str, ...] = ()  # what may touch its rim from inside

    @property
    def outline(self) -> Array:
        """(n, 2) [m] its corners, if they enclose an area; or those of the hull of its points, counter-clockwise: two
        for a rod, one for a dot."""
        corners = np.array([(p.x, p.y) for p in self.corners])
        if len(corners) > 2 and len(hull(corners)) > 2:
            return corners
        return hull(np.array([(p.x, p.y) for p in self.points.values()] or [(0.0, 0.0)]))


@dataclass(frozen=True)
class Pin:
    """Two coincident points; a clamp where the bodies keep their angle too."""

    first: Place
    second: Place
    clamps: bool = False


@dataclass(frozen=True)
class Guide:
    """A point kept at a distance `offset` on the left of a straight line of another body: a rail that it slides on, a
    slot in which it turns, or a surface on which a circle of that radius rolls."""

    point: Place
    along: Heading
    offset: float = 0.0
    turns: bool = False


@dataclass(frozen=True)
class Contact:
    """Two circles that roll on each other, directly or joined by a belt; the radius of the second is negative where
    it lies inside the first, or where the belt is open."""

    first: Place
    second: Place
    radii: Pair
    is_toothed: bool = False  # gears, whose pitch circles these are, or a belt

    def touches(self, distance: float) -> bool:
        return abs(distance - abs(sum(self.radii))) < 0.01 * max(map(abs, self.radii))


@dataclass(frozen=True)
class Node:
    """A place on a string's way: it runs round a circle counter-clockwise (arm = +R), clockwise (-R), or through a
    point (0). On a drum it is wound up."""

    place: Place
    arm: float = 0.0
    is_drum: bool = False


@dataclass(frozen=True)
class Rope:
    """A string: its nodes, and the constant direction of each lead or None for the common tangent."""

    nodes: tuple[Node, ...]
    leads: tuple[Heading | None, ...]
    is_closed: bool = False


@dataclass(frozen=True)
class Spring:
    """A load along the line between two points: of their distance (a spring), of its rate (a damper), or both."""

    first: Place
    second: Place
    has_spring: bool = True
    has_damper: bool = False


class Tip(NamedTuple):
    """What of a body may touch a surface: a circle, or a point of radius 0."""

    place: Place
    radius: float
    figure: str  # the name of its body


@dataclass(frozen=True)
class Surface:
    """A straight line that others may touch, solid on the right of its direction."""

    through: Place
    along: Heading
    tips: tuple[Tip, ...]
    edge: Pair | None = None  # [m] from where to where it is an edge of its own body, along it from `through`

    @property
    def is_endless(self) -> bool:
        """Whether it is a line of the ground, or fixed in it."""
        return self.through.body == GROUND and self.edge is None


@dataclass(frozen=True)
class Halt:
    """A stop of a point: at `limit` from `origin` along a direction it goes no farther; `side` +1 where it stays
    ahead of that."""

    point: Place
    origin: Place
    along: Heading
    limit: float
    side: int


@dataclass(frozen=True)
class TurnHalt:
    """A stop of a turning body: its angle from a base body (or the ground) goes no farther than `limit`; `side` +1
    where it stays counter-clockwise of that."""

    body: int
    base: int
    limit: float
    side: int


@dataclass(frozen=True)
class Joints:
    """All that joins the bodies."""

    pins: list[Pin] = field(default_factory=list[Pin])
    guides: list[Guide] = field(default_factory=list[Guide])
    links: list[tuple[Place, Place]] = field(default_factory=list[tuple[Place, Place]])
    contacts: list[Contact] = field(default_factory=list[Contact])
    ropes: list[Rope] = field(default_factory=list[Rope])
    springs: list[Spring] = field(default_factory=list[Spring])
    surfaces: list[Surface] = field(default_factory=list[Surface])
    halts: list[Halt | TurnHalt] = field(default_factory=list["Halt | TurnHalt"])
    touching: set[tuple[int, int]] = field(default_factory=set[tuple[int, int]])  # bodies that may touch
    hanging: set[int] = field(default_factory=set[int])  # bodies whose place aside is not stated


def turned(angle: float | Array, x: float, y: float) -> Array:
    """(..., 2) components of a vector after a turn."""
    c, s = np.cos(angle), np.sin(angle)
    return np.stack((c * x - s * y, s * x + c * y), axis=-1)


def positions(poses: Array, place: Place) -> Array:
    """(n_times, 2) [m] of a place on the way."""
    if place.body == GROUND:
        return np.broadcast_to(np.array([place.x, place.y]), (len(poses), 2))
    return poses[:, place.body, :2] + turned(poses[:, place.body, 2], place.x, place.y)


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
