"""What holds points of the ground."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from freebody.present.figures import Array, Place
from freebody.present.scene import Scene
from freebody.present.space.figures import Poses
from freebody.present.space.pieces import Piece
from freebody.present.space.symbols import stand


class Stands:
    """Each place of the ground gets one stand; u: [m] the size of symbols."""

    def __init__(self, scene: Scene, poses: Poses, u: float) -> None:
        self.scene, self.poses, self.u = scene, poses, u
        self.stood: list[Array] = []

    def held(self, a: Place, b: Place) -> Iterator[Piece]:
        """A stand for a point of the ground, on the side away from what is joined to it."""
        for place, other in ((a, b), (b, a)):
            if place.body != self.scene.ground or self.scene.is_fixed(other.body):
                continue
            at = self.poses.place(place, 0)
            hanging = np.mean((self.poses.centers[:, other.body] - at) @ self.scene.up)
            yield from self.stand(at, self.scene.up * (1.0 if hanging < -0.5 * self.u else -1.0))

    def stand(self, at: Array, down: Array) -> Iterator[Piece]:
        """Once at each place, and not where a plane of the ground runs through it."""
        if any(np.linalg.norm(at - other) < 1.5 * self.u for other in self.stood) or self._is_on_sheet(at):
            return
        self.stood.append(at)
        place = Place(self.scene.ground, float(at[0]), float(at[1]), float(at[2]))
        for solid, look, lines in stand(down, self.u):
            yield Piece(solid, place, place.body, look, lines=lines)

    def _is_on_sheet(self, at: Array) -> bool:
        for through, normal in self.scene.planes:
            height = (at - self.poses.place(through, 0)) @ self.poses.heading(normal, 0)
            if self.scene.is_fixed(normal.body) and abs(height) < 0.5 * self.u:
                return True
        return False
