"""A contact in a model on which nothing acts: nothing presses."""

from __future__ import annotations

from collections.abc import Iterator

from freebody.language.expression import ZERO
from freebody.language.sentences import Message
from freebody.study.model_warnings.base import ModelWarning, Opened, WarningKind


class NothingActs(WarningKind, name="nothing acts"):
    """Weight is a load as every other one. Without any load, drive or speed at the start all stays as it is, and every
    normal force is zero, which nobody has a contact for."""

    def look(self, model: Opened) -> Iterator[ModelWarning]:
        system = model.system
        acts = system.loads or system.applied_loads or system.impulses or system.blows or system.brakes
        moves = (
            any(row.is_driven for row in system.constraint_rows)
            or system.start_rates
            or any(body.start.moves for body in system.bodies.values())
        )
        is_heavy = any(body.mass != ZERO for body in system.moving)
        if not system.contacts or acts or moves or not is_heavy:
            return
        told = Message(
            "no load acts, nothing is driven and nothing moves at the start, so all stays as it is: weight is a load, "
            "loads: {{weight: {{gravity: 9.81 m/s^2}}}}"
        )
        yield self.warning(told, "connections", system.contacts[0].connection)
