"""What a picture of a system in space consists of, in numbers.

A place is given by the index of a body and components from its mass centre along the body's axes [m]. The moving bodies
come first, in the order of `System.moving`, then the fixed ones, the ground last.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import NamedTuple

import numpy as np

from freebody.present.figures import Array

Triple = tuple[float, float, float]


class Place(NamedTuple):
    """A point fixed in a body."""

    body: int
    at: Triple


class Heading(NamedTuple):
    """A unit vector fixed in a body."""

    body: int
    along: Triple


@dataclass(frozen=True)
class Form:
    """A body: its solid with sizes [m] about `center`, and its named points, from the mass centre along its axes."""

    name: str
    index: int
    number: int  # in the order of the model, for its colour
    solid: str  # "" for a body without a form
    sizes: tuple[float, ...]
    axis: Triple | None
    center: Triple
    points: dict[str, Triple]
    corners: tuple[Triple, ...] = ()
    is_particle: bool = False
    has_mass: bool = True
    is_toothed: bool = False


@dataclass(frozen=True)
class Joint:
    """What one connection keeps: how many components of the way between two places, and of the turn between their
    bodies.

    The axis is fixed in the first body: what a hinge turns about, what a slider runs along, the normal of a plane.
    `arms` are those of a cross, one on each body."""

    first: Place
    second: Place
    n_places: int
    n_turns: int
    axis: Heading | None = None
    arms: tuple[Heading, Heading] | None = None
    has_thread: bool = False


@dataclass(frozen=True)
class Spring:
    """Between two points; or a damper, or both."""

    first: Place
    second: Place
    is_spring: bool
    is_damper: bool


@dataclass(frozen=True)
class Arrow:
    """A force at a place along a heading; a torque on the body of a place about it."""

    place: Place
    along: Heading
    turns: bool = False


@dataclass(frozen=True)
class Coil:
    """A torsional spring or damper on a body, about an axis of the one that it is on."""

    body: int
    axis: Heading


@dataclass(frozen=True)
class Sheet:
    """A plane fixed in a body."""

    through: Place
    normal: Heading
    name: str = ""


@dataclass(frozen=True)
class Ties:
    """All that joins and pushes bodies."""

    joints: list[Joint] = field(default_factory=list[Joint])
    links: list[tuple[Place, Place]] = field(default_factory=list[tuple[Place, Place]])
    strings: list[tuple[Place, ...]] = field(default_factory=list[tuple[Place, ...]])
    springs: list[Spring] = field(default_factory=list[Spring])
    coils: list[Coil] = field(default_factory=list[Coil])
    arrows: list[Arrow] = field(default_factory=list[Arrow])
    sheets: list[Sheet] = field(default_factory=list[Sheet])


@dataclass(frozen=True)
class Poses:
    """A motion: (n_times, n_bodies, 3) [m] of mass centres, and (n_times, n_bodies, 3, 3) whose columns are the bodies'
    axes."""

    centers: Array
    axes: Array

    @property
    def n_times(self) -> int:
        return len(self.centers)

    def place(self, place: Place, frame: int) -> Array:
        """(3,) [m] where a place is."""
        return self.centers[frame, place.body] + self.axes[frame, place.body] @ np.array(place.at)

    def way(self, place: Place) -> Array:
        """(n_times, 3) [m] of a place."""
        return self.centers[:, place.body] + self.axes[:, place.body] @ np.array(place.at)

    def heading(self, heading: Heading, frame: int) -> Array:
        """(3,) a unit vector."""
        return self.axes[frame, heading.body] @ np.array(heading.along)

    def headings(self, heading: Heading) -> Array:
        """(n_times, 3) unit vectors."""
        return self.axes[:, heading.body] @ np.array(heading.along)

    def back(self, index: int, point: Array, frame: int) -> Triple:
        """Where a point of space (3,) is in a body, from its mass centre along its axes."""
        x, y, z = self.axes[frame, index].T @ (point - self.centers[frame, index])
        return float(x), float(y), float(z)

    def turned_back(self, index: int, direction: Array, frame: int) -> Triple:
        """A direction (3,) along the axes of a body."""
        x, y, z = self.axes[frame, index].T @ direction
        return float(x), float(y), float(z)
