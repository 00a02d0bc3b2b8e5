"""A motion as one HTML file that needs nothing else: the page of `page.html` with the drawing as data in
it, and the script that draws it."""

from __future__ import annotations

import html
import json
import math
import re
from collections.abc import Iterator
from dataclasses import asdict
from importlib.resources import files
from typing import Any

import numpy as np

from freebody.language.plain_text import plain
from freebody.present.drawing import Drawing
from freebody.present.figures import GROUND, Array, Place
from freebody.present.marks import MEANING
from freebody.present.strokes import Path, Strand, Stretch, Stroke
from freebody.present.theme import STYLES, THEMES

_ANGLE_DIGITS = 4
_KEYS = "Space plays and pauses, the arrow keys step, Home and End go to the ends."
_PART = re.compile(r"\{\{(\w+)\}\}")


def page(drawing: Drawing, times: Array, title: str, speed: float) -> str:
    """The text of the page. times: (n_times,) [s], equally spaced, of the poses of the drawing."""
    size = float((drawing.high - drawing.low).max())
    digits = 5 - math.floor(math.log10(size)) - 1  # five significant digits of the picture's size
    duration = f"{times[-1] - times[0]:.4g} s"
    description = f"Animation of {title} over {duration}; bodies: {', '.join(drawing.scene.names)}"
    note = note_on(drawing)
    data = _data(drawing, times, speed, digits)
    return filled(title, description, note, data, asset("plane.js"), _KEYS, ("ArrowLeft", "ArrowRight"))


def filled(
    title: str, description: str, note: str, data: dict[str, Any], script: str, keys: str, steps: tuple[str, str]
) -> str:
    """The page with a script that draws the data; `keys` says which keys do what, `steps` are those for one frame
    back and on, as ARIA names them."""
    parts = {
        "title": html.escape(plain(title)),
        "description": html.escape(plain(description)),
        "note": html.escape(f"{note} " if note else ""),
        "keys": html.escape(keys),
        "back_key": steps[0],
        "next_key": steps[1],
        "data": _embedded(data),
        "script": script,
    }
    return _PART.sub(lambda found: parts[found[1]], asset("page.html"))


def asset(*path: str) -> str:
    """The text of a file of the page."""
    return files("freebody.present").joinpath(*path).read_text(encoding="utf-8")


def note_on(drawing: Drawing) -> str:
    """What the marks mean, and which bodies are not drawn where their poses are; empty if there is nothing to say."""
    notes = [MEANING] if drawing.marks else []
    if drawing.moved:
        moved = ", ".join(drawing.moved)
        notes.append(f"Drawn aside by a constant amount, because the model does not say where: {moved}.")
    return " ".join(notes)


def _embedded(data: dict[str, Any]) -> str:
    """JSON that cannot end the script element it stands in."""
    text = json.dumps(data, separators=(",", ":"), allow_nan=False, ensure_ascii=False)
    return text.replace("<", "\\u003c").replace(">", "\\u003e").replace("&", "\\u0026")


def _data(drawing: Drawing, times: Array, speed: float, digits: int) -> dict[str, Any]:
    n_frames, n_bodies, _ = drawing.poses.shape
    columns: list[list[float]] = []
    for body in range(n_bodies):
        columns += [_rounded(drawing.poses[:, body, k], digits) for k in (0, 1)]
        columns.append(_rounded(drawing.poses[:, body, 2], _ANGLE_DIGITS))
    columns += [_rounded(track, _ANGLE_DIGITS) for track in drawing.headings.T]
    return {
        "names": drawing.scene.names,
        "n_frames": n_frames,
        "t0": float(times[0]),
        "dt": float(times[-1] - times[0]) / max(1, n_frames - 1) or 1.0,
        "speed": speed,
        "view": [round(float(v), digits) for v in (*drawing.low, *drawing.high)],
        "symbol": drawing.symbol,
        "themes": {name: asdict(theme) for name, theme in THEMES.items()},
        "styles": {name: asdict(style) for name, style in STYLES.items()},
        "strokes": [_stroke(stroke, digits + 1) for stroke in drawing.strokes],
        "marks": [{**_stroke(stroke, digits + 1), "frames": spans} for stroke, spans in _marks(drawing)],
        "labels": [{**asdict(label), "place": _place(label.place, digits + 1)} for label in drawing.labels],
        "points": _points(drawing, digits + 1),
        "columns": columns,
    }


def _stroke(stroke: Stroke, digits: int) -> dict[str, Any]:
    """A stroke as the script reads it."""
    if isinstance(stroke, Strand):
        nodes = [[*_place(n.place, digits), round(n.arm, digits), n.is_drum] for n in stroke.rope.nodes]
        rope = stroke.rope
        return {
            "shape": "strand",
            "style": stroke.style,
            "nodes": nodes,
            "lead": stroke.lead,
            "n_leads": len(rope.leads),
            "closed": rope.is_closed,
        }
    plain: dict[str, Any] = {"style": stroke.style}
    if isinstance(stroke, Stretch):
        ends = {"first": _place(stroke.first, digits), "second": _place(stroke.second, digits)}
        points = [[round(float(s), 4), round(float(n), digits)] for s, n in stroke.points]
        return {**plain, **ends, "shape": "stretch", "points": points, "closed": stroke.is_closed}
    assert isinstance(stroke, Path)
    points = [[round(float(x), digits), round(float(y), digits)] for x, y in stroke.points]
    where = {"place": _place(stroke.place, digits), "turn": stroke.turn}
    return {**plain, **where, "shape": "path", "points": points, "closed": stroke.is_closed, "color": stroke.color}


def _marks(drawing: Drawing) -> Iterator[tuple[Stroke, list[int]]]:
    """Each mark with the frames at which it appears and disappears, in turn."""
    for k, state, stroke in drawing.marks:
        assert drawing.contacts is not None
        is_on = np.concatenate(([False], drawing.contacts.states[:, k] == state, [False]))
        yield stroke, np.flatnonzero(np.diff(is_on)).tolist()


def _points(drawing: Drawing, digits: int) -> list[dict[str, Any]]:
    """The points that can be traced: each place of a moving body once, under its first name."""
    found: dict[Place, dict[str, Any]] = {}
    for figure in drawing.scene.figures:
        if figure.index == GROUND:
            continue
        named = [(f"{figure.name}.{name}", place) for name, place in figure.points.items()]
        for name, place in [(figure.name, figure.mass_center), *named]:
            place = Place(*_place(place, digits))
            found.setdefault(place, {"name": name, "place": place[:3], "color": figure.number})
    return list(found.values())


def _place(place: Place, digits: int) -> list[Any]:
    return [place.body, round(place.x, digits) + 0.0, round(place.y, digits) + 0.0]


def _rounded(values: Array, digits: int) -> list[float]:
    return [float(v) for v in np.round(values, digits) + 0.0]
