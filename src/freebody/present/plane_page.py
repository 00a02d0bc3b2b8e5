"""A motion of the plane for the player page: its strokes, with the poses as places and angles."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import asdict
from typing import Any

import numpy as np

from freebody.messages import Message, in_turn
from freebody.present.drawing import Drawing
from freebody.present.figures import GROUND, Array, Place
from freebody.present.marks import MEANING
from freebody.present.page import ANGLE_DIGITS, Pages, digits_of, place_data, rounded
from freebody.present.strokes import Path, Strand, Stretch, Stroke
from freebody.present.theme import STYLES

_STYLES = {name: asdict(style) for name, style in STYLES.items()}
_ALONG_Z = np.array([(0.0, 0.0, 1.0), (1.0, 0.0, 0.0), (0.0, 1.0, 0.0)])


def page(drawing: Drawing, times: Array, title: str) -> Pages:
    """The page. times: (n_times,) [s], equally spaced, of the poses of the drawing."""
    digits = digits_of(float((drawing.high - drawing.low).max()))
    poses = np.moveaxis(drawing.poses, 0, -1)  # of each body x, y and the angle over time
    places, angles = rounded(poses[:, :2], digits), rounded(poses[:, 2], ANGLE_DIGITS)
    columns = [track for (x, y), angle in zip(places, angles, strict=True) for track in (x, y, angle)]
    columns += rounded(drawing.headings.T, ANGLE_DIGITS)
    script = _Strokes(len(drawing.scene.names), digits + 1)
    own = {
        "symbol": drawing.symbol,
        "styles": _STYLES,
        "strokes": [script.stroke(stroke) for stroke in drawing.strokes],
        "marks": [{**script.stroke(stroke), "frames": spans} for stroke, spans in _marks(drawing)],
        "labels": [{"owner": figure.number, "text": figure.name} for figure in drawing.scene.figures],
        "words": [{**asdict(word), "place": script.place(word.place)} for word in drawing.words],
    }
    ground = np.zeros((1, 3)), np.eye(3)[None]
    bounds = drawing.low, drawing.high
    description = Message("{title}; bodies: {names}", title=title, names=", ".join(drawing.scene.names))
    note = note_on(drawing)
    return Pages(
        drawing.scene, times, columns, digits, bounds, _ALONG_Z, ground, own, description, note, is_planar=True
    )


def note_on(drawing: Drawing) -> str:
    """What the marks mean, and which bodies are not drawn where their poses are; empty if there is nothing to say."""
    notes = [MEANING] if drawing.marks else []
    if drawing.moved:
        moved = ", ".join(drawing.moved)
        notes.append(
            Message("Drawn aside by a constant amount, because the model does not say where: {moved}.", moved=moved)
        )
    return in_turn(notes, "{first} {second}")


def _marks(drawing: Drawing) -> Iterator[tuple[Stroke, list[int]]]:
    """Each mark with the frames at which it appears and disappears, in turn."""
    for k, state, stroke in drawing.marks:
        assert drawing.contacts is not None
        is_on = np.concatenate(([False], drawing.contacts.states[:, k] == state, [False]))
        yield stroke, np.flatnonzero(np.diff(is_on)).tolist()


class _Strokes:
    """Strokes as the script reads them, for which the ground is the body after those that move."""

    def __init__(self, ground: int, digits: int) -> None:
        self.ground, self.digits = ground, digits

    def place(self, place: Place) -> list[Any]:
        return place_data(place._replace(body=self._index(place.body)), self.digits)

    def _index(self, body: int) -> int:
        return self.ground if body == GROUND else body

    def stroke(self, stroke: Stroke) -> dict[str, Any]:
        match stroke:
            case Strand(rope, lead, style):
                nodes = [
                    {"place": self.place(n.place), "arm": round(n.arm, self.digits), "drum": n.is_drum}
                    for n in rope.nodes
                ]
                own = {"nodes": nodes, "lead": lead, "n_leads": len(rope.leads), "closed": rope.is_closed, "owner": -1}
                if rope.comes is not None and rope.whole is not None:
                    own |= {"comes": round(rope.comes.angle, 6), "whole": round(rope.whole, self.digits)}
                return {"shape": "strand", "style": style, **own}
            case Stretch(first, second, points, style, is_closed, longest, against):
                ends = {"first": self.place(first), "second": self.place(second)}
                shares = [[round(float(s), 4), round(float(n), self.digits)] for s, n in points]
                own = {"shape": "stretch", "style": style, "points": shares, "closed": is_closed, "owner": -1}
                own |= {} if longest is None else {"longest": round(longest, self.digits)}
                if against is not None:
                    own |= {"against": [round(against.x, 6), round(against.y, 6)], "turn": self._index(against.body)}
                return {**own, **ends}
            case Path(place, turn, points, style, is_closed, color):
                where = {"place": self.place(place), "turn": self._index(turn)}
                own = {"shape": "path", "style": style, "closed": is_closed, "owner": color}
                return {**own, **where, "points": rounded(points, self.digits)}
