"""A force of a fixed direction at a point of a rolling body beside its middle: the point goes round with the body."""

from __future__ import annotations

from collections.abc import Iterator

from freebody.connections.rolling import Rolling
from freebody.language.sentences import Message
from freebody.loads.force import Force
from freebody.measures.displacement import Displacement
from freebody.measures.geometry import GROUND
from freebody.study.model_warnings.base import ModelWarning, Opened, WarningKind


class PulledAtTheRim(WarningKind, name="pulled at the rim"):
    """A cord that is wound on a spool leaves it at a place that stays beside the contact, however far the spool has
    rolled. A point of the body does not stay there, so that the force is that of the cord at the start alone."""

    def look(self, model: Opened) -> Iterator[ModelWarning]:
        system = model.system
        rolling = {
            body
            for row in system.rows
            if isinstance(system.connections.get(row.connection), Rolling)
            for body in row.measure.bodies()
        }
        for push in system.applied_loads:
            if not isinstance(system.loads.get(push.load), Force) or not isinstance(push.measure, Displacement):
                continue
            point, body = push.measure.of, system.bodies.get(push.measure.of.body)
            if body is None or body.name not in rolling or not body.is_wheel:
                continue
            if push.measure.along.body == GROUND and point.offset != body.center.offset:
                told = Message(
                    "{force} acts at {point}, which goes round with {body}, while the direction of the force stays. If "
                    "a cord is meant that unwinds, write at: wound on {body} radius r at bottom (or top, left, right); "
                    "if only the start is asked for, ask at start",
                    force=push.load,
                    point=str(point),
                    body=body.name,
                )
                yield self.warning(told, "loads", push.load, about=frozenset((push.load, body.name)))
