"""A motion as one HTML file that needs nothing else: the page of `page.html` with the drawing as data in it, and the
script that draws it (`player.js`).

The script draws strokes of the plane over each other in their order, and pieces of space by their depth, as
`space.painter`, `space.order` and `names` do; all through one camera: the plane is the view along z.
"""

from __future__ import annotations

import html
import json
import math
import re
from collections.abc import Callable, Sequence
from dataclasses import asdict, dataclass, field
from typing import Any

import numpy as np

from freebody.language.plain_text import plain
from freebody.messages import Message
from freebody.present.assets import asset
from freebody.present.figures import Array, Place
from freebody.present.scene import Scene
from freebody.present.theme import THEMES

ANGLE_DIGITS = 4
_THEMES = {name: asdict(theme) for name, theme in THEMES.items()}
_KEYS_OF_PLANE = Message(
    "Space plays and pauses, the arrow keys step, Home and End go to the ends; drag the picture to move it, the wheel "
    "or plus and minus come nearer, a double click or 0 goes back."
)
_KEYS_OF_SPACE = Message(
    "Space plays and pauses, comma and full stop step, Home and End go to the ends; drag the picture or use the arrow "
    "keys to turn the view, the wheel or plus and minus come nearer, a double click or 0 goes back."
)
_WORDS = {  # of the page itself; the script fills what is in brackets
    "play": Message("Play"),
    "pause": Message("Pause"),
    "playback": Message("Playback"),
    "back": Message("One frame back"),
    "on": Message("One frame on"),
    "time": Message("Time"),
    "speed": Message("Speed"),
    "repeat": Message("repeat"),
    "names": Message("names"),
    "traces": Message("Traces"),
    "to_trace": Message("Points to trace"),
    "axes": Message("axes [length] m long"),
    "seconds": Message("[t] seconds"),
}
_PART = re.compile(r"\{\{(\w+)\}\}")


@dataclass(frozen=True)
class Pages:
    """What a page shows: a scene on its way, and what the script needs to draw it.

    times: (n_times,) [s], equally spaced; columns: (n_times,) each, three numbers of the pose of each body of the plane
    or seven of space, then others; digits: of lengths [m]; fixed: centres and axes of the bodies that stand still, the
    ground last; front: (3, 3) rows that the camera starts from: towards the viewer, to the right, upwards; own: marks
    and their looks."""

    scene: Scene
    times: Array
    columns: Sequence[Sequence[float]]
    digits: int
    bounds: tuple[Array, Array]
    front: Array
    fixed: tuple[Array, Array]
    own: dict[str, Any]
    description: str
    note: str = ""
    is_planar: bool = False
    angles: tuple[float, float] = (0.0, 0.0)
    middle: Array = field(default_factory=lambda: np.zeros(3))
    distance: float = 0.0  # [m] of the viewer, 0 for infinite
    has_lengths: bool = True

    def text(self, title: str, speed: float, tell: Callable[[str], str] = str, language: str = "en") -> str:
        """The text of the page. tell: a message in a language"""
        steps = ("ArrowLeft", "ArrowRight") if self.is_planar else ("Comma", "Period")
        turned = "" if self.is_planar else Message("The view can be turned with the arrow keys.")
        seen = Message("Animation of {what}, over {t:.4g} s.", what=self.description, t=self.times[-1] - self.times[0])
        words = {name: tell(word) for name, word in _WORDS.items()}
        parts = {
            "title": html.escape(plain(title)),
            "description": html.escape(plain(f"{tell(seen)} {tell(turned)}".strip())),
            "note": html.escape(f"{tell(self.note)} " if self.note else ""),
            "keys": html.escape(tell(_KEYS_OF_PLANE if self.is_planar else _KEYS_OF_SPACE)),
            "back_key": steps[0],
            "next_key": steps[1],
            "language": language,
            "data": _embedded(self.data(speed)),
            "words": _embedded(words),
            **{f"word_{name}": html.escape(word) for name, word in words.items()},
            "script": asset("player.js"),
        }
        return _PART.sub(lambda found: parts[found[1]], asset("page.html"))

    def data(self, speed: float) -> dict[str, Any]:
        """What the script draws, as plain data. speed: seconds of motion in a second of showing."""
        n, gravity = len(self.times), self.scene.gravity
        still = [
            [rounded(center, self.digits), [rounded(row, 9) for row in axes]]
            for center, axes in zip(*self.fixed, strict=True)
        ]
        return {
            "planar": self.is_planar,
            "names": self.scene.names,
            "n_frames": n,
            "t0": float(self.times[0]),
            "dt": float(self.times[-1] - self.times[0]) / max(1, n - 1) or 1.0,
            "speed": speed,
            "angles": self.angles,
            "distance": self.distance,
            "middle": rounded(self.middle, self.digits),
            "bounds": rounded(np.concatenate(self.bounds), self.digits),
            "has_lengths": self.has_lengths,
            "frame": [rounded(v, 9) for v in self.front],
            "gravity": None if gravity is None else rounded(gravity, 9),
            "fixed": still,
            "themes": _THEMES,
            "points": self._points(),
            "columns": self.columns,
            **{"strokes": [], "marks": [], "pieces": [], "words": []},
            **self.own,
        }

    def _points(self) -> list[dict[str, Any]]:
        """The points that can be traced: each place of a moving body once, under its first name."""
        found: dict[tuple[Any, ...], dict[str, Any]] = {}
        for figure in self.scene.figures:
            if self.scene.is_fixed(figure.index):
                continue
            named = [(f"{figure.name}.{name}", place) for name, place in figure.points.items()]
            for name, at in [(figure.name, figure.mass_center), *named]:
                place = place_data(at, self.digits + 1)
                found.setdefault(tuple(place), {"name": name, "place": place, "color": figure.number})
        return list(found.values())


def digits_of(size: float) -> int:
    """Decimals of lengths [m]: the last one is at most 1e-5 of the size of the picture."""
    return 5 - math.floor(math.log10(size))


def place_data(place: Place, digits: int) -> list[Any]:
    """A place as the script reads it."""
    return [place.body, *(round(c, digits) + 0.0 for c in place.at)]


def rounded(values: Any, digits: int) -> list[Any]:
    """Numbers, in lists as deep as the values are, without negative zeros."""
    return (np.round(np.asarray(values, dtype=np.float64), digits) + 0.0).tolist()


def _embedded(data: dict[str, Any]) -> str:
    """JSON that cannot end the script element it stands in."""
    text = json.dumps(data, separators=(",", ":"), allow_nan=False, ensure_ascii=False)
    return text.replace("<", "\\u003c").replace(">", "\\u003e").replace("&", "\\u0026")
