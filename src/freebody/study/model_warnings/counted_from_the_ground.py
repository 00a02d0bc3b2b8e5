"""The way along a line of a body that moves on, counted from the ground: of a block on the slope of a wedge that
slides, or of a man on the deck of a boat."""

from __future__ import annotations

import math
from collections.abc import Iterator

from freebody.language.sentences import Message
from freebody.measures.displacement import Displacement
from freebody.measures.geometry import AXES, GROUND, Point
from freebody.study.model_warnings.base import ModelWarning, Opened, WarningKind


class CountedFromTheGround(WarningKind, name="counted from the ground"):
    """A measure along a line of a body, from a point of the ground from which that body moves away: it contains the way
    of the body."""

    def look(self, model: Opened) -> Iterator[ModelWarning]:
        bodies = {body.name: body for body in model.system.moving}
        for name, measure in model.system.measures.items():
            if not isinstance(measure, Displacement):
                continue
            along, origin = bodies.get(measure.along.body), measure.origin
            if along is None or origin.body != GROUND or measure.of.body in (GROUND, along.name):
                continue
            if self._moves_away(model, along.point(along.default_point), origin):
                told = Message(
                    "{name} is counted from the ground while {body} moves, so the way of {body} is in it. For the way "
                    "on {body} write: travel of {point} along ... from {body}",
                    name=name,
                    body=along.name,
                    point=measure.of.name or measure.of.body,
                )
                yield self.warning(told, "measures", name, about=frozenset((name, along.name)))

    def _moves_away(self, model: Opened, point: Point, origin: Point) -> bool:
        """Whether the distance of the body from the point of the ground changes: about that point it does not turn."""
        axes = AXES if model.system.space else AXES[:2]
        parts = [Displacement(point, origin, axis) for axis in axes]
        apart = [math.hypot(*(float(at.value(part)) for part in parts)) for at in (model.start, *model.elsewhere)]
        return max(apart) - min(apart) > model.close
