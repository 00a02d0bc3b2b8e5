"""A load that pushes only what does not move: a force at the ground."""

from __future__ import annotations

from collections.abc import Iterator

from freebody.language.sentences import Message
from freebody.study.model_warnings.base import ModelWarning, Opened, WarningKind


class NoEffect(WarningKind, name="no effect"):
    """No body that moves feels any of its components."""

    def look(self, model: Opened) -> Iterator[ModelWarning]:
        system = model.system
        pushes = (*system.applied_loads, *system.impulses)
        for load in system.loads:
            bodies = {body for push in pushes if push.load == load for body in push.measure.bodies()}
            if bodies and all(system.bodies[body].fixed for body in bodies):
                told = Message(
                    "{load} acts on {bodies}, which cannot move, and has no effect: name a point of a body that moves",
                    load=load,
                    bodies=", ".join(sorted(bodies)),
                )
                yield self.warning(told, "loads", load, about=frozenset((load,)))
