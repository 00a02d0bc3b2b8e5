"""The camera: where a scene is looked at from, and where its points come to lie on paper. The plane is seen along z.

With u the vertical, f a horizontal axis of the ground and r = u x f, the viewer is in the direction

    w = cos e (cos a f + sin a r) + sin e u

with azimuth a and elevation e. On paper x is along u x w and y along the rest of u, so the vertical stays vertical.
From a distance D a point at depth d towards the viewer grows by D/(D - d). Depth grows by the same factor: that is a
projective map, under which planes stay planes and what is in front stays in front.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from freebody.present.figures import Array

AZIMUTH, ELEVATION = 30.0, 20.0  # degrees
STRENGTH = 3.5  # how many times the size of the scene the viewer is away in a perspective picture
_STEEPEST = 89.9  # degrees: straight from above the vertical has no direction on paper


@dataclass(frozen=True)
class View:
    """axes: (3, 3), rows to the right, upwards and towards the viewer; middle: (3,) [m] what comes to (0, 0) on paper;
    distance: [m] of the viewer from there, infinite without perspective."""

    axes: Array
    middle: Array
    distance: float = math.inf

    @classmethod
    def of(
        cls,
        up: Array,
        angles: tuple[float, float] = (AZIMUTH, ELEVATION),
        middle: Array | None = None,
        distance: float = math.inf,
    ) -> View:
        """up: (3,) unit vector of the vertical; angles: azimuth and elevation [deg]."""
        azimuth, elevation = math.radians(angles[0]), math.radians(max(-_STEEPEST, min(_STEEPEST, angles[1])))
        front, right = horizontals(up)
        level = math.cos(azimuth) * front + math.sin(azimuth) * right
        towards = math.cos(elevation) * level + math.sin(elevation) * up
        across = math.cos(azimuth) * right - math.sin(azimuth) * front
        axes = np.array([across, np.cross(towards, across), towards])
        return cls(axes, np.zeros(3) if middle is None else middle, distance)

    def seen(self, points: Array) -> Array:
        """(..., 3) [m] of points (..., 3): to the right and upwards on paper, and the depth towards the viewer."""
        local: Array = (points - self.middle) @ self.axes.T
        if math.isinf(self.distance):
            return local
        near = np.minimum(local[..., 2:], 0.9 * self.distance)
        return local * (self.distance / (self.distance - near))


PLANE = View(np.eye(3), np.zeros(3))  # the plane of x and y, seen along z


def horizontals(up: Array) -> tuple[Array, Array]:
    """Two horizontal unit vectors (3,): the one towards the viewer at azimuth 0, which is z where y is up and x where z
    is, and the one to the right of it."""
    k = int(np.abs(up).argmax())
    front = np.eye(3)[(k + 1) % 3]
    front = front - (front @ up) * up
    front = front / np.linalg.norm(front)
    return front, np.cross(up, front).astype(np.float64)
