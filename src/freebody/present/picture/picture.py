"""A finished picture, which every writer draws alike."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from pathlib import Path

import numpy as np

from freebody.errors import InputError
from freebody.present.figures import Array
from freebody.present.files import write_whole
from freebody.present.picture.shapes import Shape, Word

FORMATS = (".svg", ".png", ".pdf", ".tex")
MARGIN = 6.0  # [points]


@dataclass(frozen=True)
class Picture:
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

    def svg(self, *, dark: bool | None = None) -> str:
        """An SVG element of its own, whose colours follow a dark page unless `dark` says which to take."""
        from freebody.present.picture.svg import svg

        return svg(self, dark=dark)

    def tikz(self) -> str:
        """A tikzpicture, for which plain tikz is enough."""
        from freebody.present.picture.tikz import tikz

        return tikz(self)

    def png(self, *, dark: bool = False) -> bytes:
        from freebody.present.picture.pixels import rendered

        return rendered(self, "png", dark=dark)

    def pdf(self, *, dark: bool = False) -> bytes:
        from freebody.present.picture.pixels import rendered

        return rendered(self, "pdf", dark=dark)

    def text(self) -> str:
        """There is none for a terminal."""
        return ""

    def write(self, path: str | Path, *, dark: bool = False) -> Path:
        """Writes it by the suffix of the path: .svg, .png, .pdf, or .tex with a tikzpicture. Raises InputError for
        another suffix, or where it cannot be written."""
        path = checked_path(path)
        content: str | bytes
        match path.suffix.lower():
            case ".svg":
                content = '<?xml version="1.0" encoding="UTF-8"?>\n' + self.svg(dark=True if dark else None)
            case ".tex":
                content = self.tikz()
            case ".png":
                content = self.png(dark=dark)
            case _:
                content = self.pdf(dark=dark)
        write_whole(path, content)
        return path


def checked_path(path: str | Path) -> Path:
    """Raises InputError for a suffix that no picture has."""
    path = Path(path)
    if path.suffix.lower() not in FORMATS:
        raise InputError(f"{path.name}: a picture is written as {', '.join(FORMATS)}")
    return path
