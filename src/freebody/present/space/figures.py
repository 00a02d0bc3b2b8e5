"""Bodies of space on their way, and what joins them by what it keeps of their places and turns."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from freebody.model.glyphs import Ball, Cross, Face, Pin, Rail, Weld
from freebody.present.figures import Array, Heading, Place, Triple
from freebody.present.scene import Scene

_TURNS = {"not": 3, "about": 2, "rolls": 2, "freely": 0}  # components of a turn that are kept


@dataclass(frozen=True)
class DrawnJoint:
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


def poses_of(scene: Scene, centers: Array, axes: Array) -> Poses:
    """Those of all bodies, from those of the moving ones: centers (n_times, n_moving, 3) [m], axes
    (n_times, n_moving, 3, 3) with the bodies' axes as columns."""
    n, moving = len(centers), len(scene.names)
    centers, axes = centers.reshape(n, moving, 3), axes.reshape(n, moving, 3, 3)  # also where nothing moves
    still = [np.broadcast_to(part, (n, *part.shape)) for part in scene.fixed]
    return Poses(np.concatenate((centers, still[0]), axis=1), np.concatenate((axes, still[1]), axis=1))


def joints_of(scene: Scene, poses: Poses) -> Iterator[DrawnJoint]:
    """The joints of a scene; poses: by which a rail is found that goes through where its point is at the start."""
    for sign in scene.signs:
        match sign:
            case Pin(first, second, axis):
                yield DrawnJoint(first, second, 3, 2, upright(scene, axis))
            case Weld(first, second):
                yield DrawnJoint(first, second, 3, 3)
            case Ball(first, second, passes_turn):
                yield DrawnJoint(first, second, 3, int(passes_turn))
            case Cross(first, second, arms):
                yield DrawnJoint(first, second, 3, 1, arms=arms)
            case Rail(through, point, along, turning, has_thread):
                if through is None:
                    through = Place(along.body, *poses.back(along.body, poses.place(point, 0), 0))
                yield DrawnJoint(through, point, 2, _TURNS[turning], along, has_thread=has_thread)
            case Face(through, point, normal, turning):
                yield DrawnJoint(through, point, 1, _TURNS[turning], normal)
            case _:
                pass


def upright(scene: Scene, axis: Heading | None) -> Heading:
    """The axis of a glyph; without one it is that of the plane of x and y."""
    return Heading(scene.ground, 0.0, 0.0, 1.0) if axis is None else axis
