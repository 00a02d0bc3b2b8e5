"""Lines, areas and words on paper: x to the right, y up, in points (1/72 inch)."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

import numpy as np

from freebody.present.figures import Array
from freebody.present.picture.label import Label
from freebody.present.theme import Theme

Scheme = Literal["", "light", "dark"]


@dataclass(frozen=True)
class Ink:
    """A colour of the theme, `body` for that of the body with that number. share: of the colour, the rest is paper;
    on dark paper it may be another one. alpha: how much of what is behind it hides."""

    color: str = "ink"
    body: int = -1
    alpha: float = 1.0
    share: float = 1.0
    dark_share: float | None = None

    def on(self, theme: Theme, *, dark: bool) -> str:
        """#rrggbb."""
        share = self.dark_share if dark and self.dark_share is not None else self.share
        color = theme.color(self.color, self.body)
        if share == 1.0:
            return color
        mixed = (share * c + (1 - share) * p for c, p in zip(_rgb(color), _rgb(theme.paper), strict=True))
        return "#" + "".join(f"{min(255, max(0, round(c))):02x}" for c in mixed)


def _rgb(color: str) -> tuple[int, ...]:
    return tuple(int(color[k : k + 2], 16) for k in (1, 3, 5))


INK = Ink()


@dataclass(frozen=True)
class Shape:
    """A line or an area. points: (n, 2) [points]; scheme: the only paper on which it is drawn, empty for any; of: what
    it belongs to, as "body crank" or "force A.x", by which a page finds it."""

    points: Array
    stroke: Ink | None = INK
    width: float = 1.0
    fill: Ink | None = None
    is_closed: bool = False
    dashes: tuple[float, ...] = ()
    scheme: Scheme = ""
    of: str = ""

    @property
    def is_area(self) -> bool:
        """Whether it is nothing but a filled area."""
        return self.stroke is None


def area(points: Array, color: str, body: int, share: float, alpha: float) -> Shape:
    """An area without an edge."""
    return Shape(points, None, 0.0, Ink(color, body, alpha, share), is_closed=True)


def line(
    points: Array,
    color: str,
    body: int,
    share: float,
    alpha: float,
    width: float,
    *,
    is_closed: bool = False,
    dashes: tuple[float, ...] = (),
) -> Shape:
    """A line without a fill."""
    return Shape(points, Ink(color, body, alpha, share), width, is_closed=is_closed, dashes=dashes)


@dataclass(frozen=True)
class Word:
    """A label with its middle at a place (2,) [points]; with a halo of paper round its letters. of: as of a `Shape`."""

    label: Label
    at: Array
    size: float = 10.0
    ink: Ink = INK
    has_halo: bool = True
    of: str = ""

    @property
    def half(self) -> Array:
        """(2,) [points] half of its width and height."""
        deep = any(run.level for run in self.label.runs)
        return 0.5 * self.size * np.array((self.label.width, 1.3 if deep else 1.0))

    def overlaps(self, other: Word, room: float = 0.0) -> bool:
        return bool((np.abs(self.at - other.at) < self.half + other.half + room).all())
