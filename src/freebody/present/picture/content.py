"""What a finished picture is made of."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from freebody.present.figures import Array
from freebody.present.picture.shapes import Shape, Word

MARGIN = 6.0  # [points]


@dataclass(frozen=True)
class PictureContent:
    """Shapes and words in the order in which they are drawn, in points. title, description: in words, for those who
    cannot see it."""

    title: str
    description: str
    shapes: tuple[Shape, ...]
    words: tuple[Word, ...]

    @cached_property
    def corners(self) -> tuple[Array, Array]:
        """(2,), (2,) [points] lower left and upper right, with a margin."""
        ends = [shape.points for shape in self.shapes]
        ends += [np.array((word.at - word.half, word.at + word.half)) for word in self.words]
        every = np.concatenate(ends or [np.zeros((1, 2))])
        return every.min(axis=0) - MARGIN, every.max(axis=0) + MARGIN
