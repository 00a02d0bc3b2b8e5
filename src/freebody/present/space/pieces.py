"""The one thing a picture in space consists of: a convex piece that moves with a body or runs between two of them."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from freebody.present.figures import Array, Place
from freebody.present.space.figures import Poses
from freebody.present.space.solids import Solid, basis


@dataclass(frozen=True)
class Piece:
    """A solid at a place, turning with a body. Between two places its z axis runs from 0 at the first to 1 at the
    second.

    A ball has its radius, and its solid only its middle. `lines`, (n, 3) each, are drawn on it; if it is a `hint`, they
    are all that is drawn, and the solid only says what is in front of what."""

    solid: Solid
    place: Place
    turn: int
    look: str
    color: int = -1
    end: Place | None = None
    radius: float = 0.0
    lines: tuple[Array, ...] = ()
    is_hint: bool = False

    def placed(self, poses: Poses, frame: int) -> tuple[Array, tuple[Array, ...]]:
        """(n, 3) [m] its points and those of its lines, in ground coordinates."""
        at = poses.place(self.place, frame)
        if self.end is None:
            axes = poses.axes[frame, self.turn].T
        else:
            way = poses.place(self.end, frame) - at
            length = float(np.linalg.norm(way))
            axes = basis(way if length > 1e-12 else np.array((0.0, 0.0, 1.0))) * np.array([[1.0], [1.0], [length]])
        return at + self.solid.points @ axes, tuple(at + line @ axes for line in self.lines)


def ball(place: Place, radius: float, look: str, color: int = -1, *, has_circles: bool = False) -> Piece:
    """A sphere about a place; with its equator and two meridians, so that its turning is seen."""
    a = np.linspace(0.0, 2 * np.pi, 49)
    zero = np.zeros_like(a)
    c, s = radius * np.cos(a), radius * np.sin(a)
    circles = [np.stack(line, axis=-1) for line in ((c, s, zero), (c, zero, s))]
    middle = Solid(np.zeros((1, 3)), ())
    return Piece(middle, place, place.body, look, color, radius=radius, lines=tuple(circles) if has_circles else ())
