"""A pulley on a string that nothing else holds: a light one on which nothing hangs, so that the string pulls at
nothing; one with weight that the string runs over, so that it pulls it down, too."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from freebody.language.sentences import Message
from freebody.loads.gravity import Gravity
from freebody.measures.geometry import ZERO
from freebody.study.model_warnings.base import ModelWarning, Opened, WarningKind

_ALONG = 1e-9  # of the cosine of an angle: less is across


class LoosePulley(WarningKind, name="loose pulley"):
    """What is round and joined to one string alone: without mass a movable pulley carries something, and one with a
    weight has the string under it."""

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
            if not body.is_wheel or body.name in pulled:
                continue
            from freebody.connections.string.connection import String  # imported where a model has what may be a pulley

            joints = {row.connection for row in system.rows if body.name in set(row.measure.bodies())}
            if len(joints) != 1 or not isinstance(system.connections[string := joints.pop()], String):
                continue
            if is_light:
                told = Message(
                    "{body} is light, nothing holds it and nothing hangs on it, so {string} pulls at nothing: hold "
                    "it, e.g. axle: {{pin: [ground.A, {body}]}} with the point A under ground",
                    body=body.name,
                    string=string,
                )
                yield self.warning(told, "connections", string, about=frozenset((body.name,)))
            elif self._pulls_down(model, body.name, string):
                told = Message(
                    "{string} runs over {body}, which nothing else holds, and pulls it down: a string that carries a "
                    "wheel runs under it, path: [..., under {body}, ...]",
                    string=string,
                    body=body.name,
                )
                yield self.warning(told, "connections", string, about=frozenset((body.name,)))

    def _pulls_down(self, model: Opened, body: str, string: str) -> bool:
        """Whether a tension of this string acts on a body the way of its weight: -T dL/dr, with L the length of the
        string."""
        at, columns = model.start, list(model.reference.columns(body)[:2])
        weights = [p for p in model.system.applied_loads if isinstance(model.system.loads.get(p.load), Gravity)]
        weight = sum(model.slope(p.measure, at)[columns] for p in weights if body in p.measure.bodies())
        rows = [row for row in model.system.constraint_rows if row.connection == string and row.reaction == "tension"]
        pull = -sum(model.slope(row.measure, at)[columns] for row in rows)
        return bool(np.dot(pull, weight) > _ALONG * np.linalg.norm(pull) * np.linalg.norm(weight))
