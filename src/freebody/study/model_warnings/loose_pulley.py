"""A light pulley on a string that nothing holds and on which nothing hangs: the string pulls at nothing."""

from __future__ import annotations

from collections.abc import Iterator

from freebody.language.sentences import Message
from freebody.loads.gravity import Gravity
from freebody.measures.geometry import ZERO
from freebody.study.model_warnings.base import ModelWarning, Opened, WarningKind


class LoosePulley(WarningKind, name="loose pulley"):
    """What is round and has no mass, and is joined to one string alone: a movable pulley carries something."""

    def look(self, model: Opened) -> Iterator[ModelWarning]:
        system = model.system
        pulled = {
            body
            for push in system.applied_loads
            if not isinstance(system.loads.get(push.load), Gravity)
            for body in push.measure.bodies()
        }
        for body in system.moving:
            is_light = all(own == ZERO for own in (body.mass, body.inertia, *body.tensor))
            if body.radius is None or not is_light or body.name in pulled:
                continue
            from freebody.connections.string.connection import String  # imported where a model has what may be a pulley

            joints = {row.connection for row in system.rows if body.name in set(row.measure.bodies())}
            if len(joints) == 1 and isinstance(system.connections[string := joints.pop()], String):
                told = Message(
                    "{body} is light, nothing holds it and nothing hangs on it, so {string} pulls at nothing: hold "
                    "it, e.g. axle: {{pin: [ground.A, {body}]}} with the point A under ground",
                    body=body.name,
                    string=string,
                )
                yield self.warning(told, "connections", string, about=frozenset((body.name,)))
