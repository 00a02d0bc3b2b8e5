"""A picture in the making: shapes, and words that wait for a place."""

from __future__ import annotations

from collections.abc import Generator, Iterable, Sequence
from contextlib import contextmanager
from dataclasses import replace

import numpy as np

from freebody.present.figures import Array
from freebody.present.picture.picture import Picture
from freebody.present.picture.placer import Wish, dense, placed
from freebody.present.picture.shapes import Shape, Word
from freebody.present.view import PLANE, View


class Sketch:
    """scale: [points] by metre; origin: (2,) [m] what comes to (0, 0), as seen by the view."""

    def __init__(self, scale: float, origin: Array, view: View = PLANE) -> None:
        self.scale, self.origin, self.view = scale, origin, view
        self.shapes: list[Shape] = []
        self.wishes: list[Wish] = []
        self.words: list[Word] = []
        self.reserved: list[Shape] = []  # where words will stand: nothing is drawn there that can stand elsewhere
        self._known = 0, np.zeros((0, 2))
        self._of = ""

    @contextmanager
    def about(self, of: str) -> Generator[None]:
        """What is drawn meanwhile belongs to it (`Shape.of`)."""
        self._of, before = of, self._of
        yield
        self._of = before

    def at(self, points: Array) -> Array:
        """(..., 2) [points] of places on paper [m]."""
        return (np.asarray(points, dtype=np.float64) - self.origin) * self.scale

    def seen(self, points: Array) -> Array:
        """(..., 2) [points] on paper of places in space (..., 3), or in the plane (..., 2) [m]."""
        places = np.asarray(points, dtype=np.float64)
        flat = places.shape[-1] == 2
        return self.at(self.view.seen(np.insert(places, 2, 0.0, axis=-1) if flat else places)[..., :2])

    def vector(self, components: Array) -> Array:
        """(3,) of a vector as it is seen: to the right, upwards, towards the viewer. In the plane it has two
        components, that of a couple one."""
        full = np.zeros(3)
        full[slice(2, 3) if len(components) == 1 else slice(len(components))] = components
        return self.view.axes @ full

    def add(self, *shapes: Shape | Iterable[Shape]) -> None:
        for shape in shapes:
            for each in (shape,) if isinstance(shape, Shape) else shape:
                self.shapes.append(replace(each, of=self._of) if self._of else each)

    def wish(self, wish: Wish) -> None:
        self.wishes.append(replace(wish, of=self._of) if self._of else wish)

    def crowd(self, shapes: Sequence[Shape], room: float = 3.5) -> int:
        """How much of what is drawn comes near to shapes that might be."""
        n = len(self.shapes) + len(self.reserved)
        if self._known[0] != n:
            self._known = n, dense([*self.shapes, *self.reserved])
        taken, new = self._known[1], dense(shapes)
        if not len(new) or not len(taken):
            return 0
        low, high = new.min(axis=0) - room, new.max(axis=0) + room
        near = taken[((taken > low) & (taken < high)).all(axis=1)]
        return int((np.abs(new[:, None] - near).max(axis=-1) < room).any(axis=1).sum())

    def least_crowded(self, options: Sequence[Sequence[Shape]], most: int) -> int | None:
        """The first option that nothing comes near to, or the best one; None if more than `most` does."""
        best: tuple[int, int] | None = None
        for k, option in enumerate(options):
            n = self.crowd(option)
            if best is None or n < best[0]:
                best = n, k
            if n == 0:
                break
        return None if best is None or best[0] > most else best[1]

    def corners(self) -> tuple[Array, Array]:
        """(2,), (2,) [points] round all shapes so far."""
        every = np.concatenate([np.zeros((0, 2)), *(shape.points for shape in self.shapes)])
        every = every if len(every) else np.zeros((1, 2))
        return every.min(axis=0), every.max(axis=0)

    def finished(self, title: str, description: str) -> Picture:
        words = placed(self.wishes, self.shapes, self.words)
        return Picture(title, description, tuple(self.shapes), tuple(words))
