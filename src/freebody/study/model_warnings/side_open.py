"""A start that says how far apart two points are, and neither on which side nor in which direction.

A distance has one value on either side. Mirrored through the other point, the body is put where the connections and the
start allow it as well: then nothing in the file says which of the two is meant.
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from freebody.errors import CannotAnswer
from freebody.language.sentences import Message
from freebody.measures.distance import Distance
from freebody.measures.geometry import Point, position
from freebody.model.elements import RigidBody
from freebody.numeric.jet_geometry import JetGeometry
from freebody.numeric.jets import Array
from freebody.numeric.start import assembled
from freebody.study.model_warnings.base import ModelWarning, Opened, WarningKind

_OPPOSITE = -0.99  # the cosine between two directions that are opposite


class SideOpen(WarningKind, name="side open"):
    """The start gives a distance, and the same pose on the other side fulfils everything too."""

    def look(self, model: Opened) -> Iterator[ModelWarning]:
        for name in model.system.start:
            measure = model.system.measures.get(name)
            if not isinstance(measure, Distance):
                continue
            moving = {body.name: body for body in model.system.moving}
            ends = [(measure.start, measure.end), (measure.end, measure.start)]
            found = next(((p, q) for p, q in ends if q.body in moving), None)
            if found is None or _is_placed(moving[found[1].body]):
                continue
            other, own = found
            if not self._is_open(model, other, own):
                continue
            place = _between(model.start.geometry, None, own)
            told = Message(
                "the start says how far {point} is from {other}, but not on which side: {point} is taken to be at "
                "{place} m, and could as well be opposite. Say it with near: {{at: [x, y]}} in {body}",
                point=own.name,
                other=other.name,
                place="[" + ", ".join(f"{x:.4g}" for x in place) + "]",
                body=own.body,
            )
            yield self.warning(told, "start", name, about=frozenset({own.body}))

    def _is_open(self, model: Opened, other: Point, own: Point) -> bool:
        """Whether the body can be opposite, with everything else as the connections want it."""
        reference, start = model.reference, model.start
        here = _between(start.geometry, other, own)
        length = float(np.linalg.norm(here))
        if length < model.close:
            return False
        guess = start.q.copy()
        guess[list(reference.columns(own.body))[: len(here)]] -= 2.0 * here
        try:
            fit = assembled(reference, (), guess, 1)
        except CannotAnswer:
            return False
        there = _between(reference.geometry(fit.q, np.zeros_like(fit.q), 0.0, fit.branches), other, own)
        return float(here @ there) < _OPPOSITE * length * length


def _is_placed(body: RigidBody) -> bool:
    """Whether the file says where the body is, or near which place."""
    return body.start.at is not None or body.start.near is not None


def _between(g: JetGeometry, begin: Point | None, end: Point) -> Array:
    """[m] from one point to another, or the place of the other."""
    vector = position(g, end) if begin is None else position(g, end) - position(g, begin)
    parts = (vector.x, vector.y) if vector.z is None else (vector.x, vector.y, vector.z)
    return np.array([part.value for part in parts])
