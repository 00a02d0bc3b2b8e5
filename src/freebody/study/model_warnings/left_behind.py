"""A body on another one that a drive leads at a speed from the start, of which nobody says how fast it is: a crate on
the bed of a truck that brakes.

Rates that nobody gives are those of least kinetic energy, so that it stands still, and slides until the bed has taken
it along. Who asks whether it slips as the truck brakes means that it goes along.
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from freebody.language.expression import Symbol
from freebody.language.sentences import Message
from freebody.model.elements import RigidBody
from freebody.study.model_warnings.base import ModelWarning, Opened, WarningKind
from freebody.system.system import System

_PART = 1e-6  # of the greatest speed: less is none


class LeftBehind(WarningKind, name="left behind"):
    """The least motion at the start is another one than that of all that goes along with the drive."""

    def look(self, model: Opened) -> Iterator[ModelWarning]:
        system = model.system
        drives = [row for row in system.constraint_rows if row.is_driven]
        if not drives or not system.dry_friction or system.space:
            return
        from freebody.numeric.reference import Reference
        from freebody.numeric.rest_problem import velocities_along
        from freebody.study.friction.touching import touching

        touched = touching(system)
        values = {name: model.reference.number(Symbol(name)) for name in system.parameters}
        reference = Reference(touched.held, values)
        q = reference.assemble(guess=model.start.q)
        along = velocities_along(reference, q, touched.dry_friction)
        behind = along - reference.velocities(q)
        if np.abs(behind).max(initial=0.0) <= _PART * np.abs(along).max(initial=0.0):
            return
        body = system.bodies[reference.most_moved(behind)]
        if _is_said(system, body):
            return
        least = _PART * np.abs(along).max()
        x, y = (0.0 if abs(speed) <= least else speed for speed in along[list(reference.columns(body.name))[:2]])
        told = Message(
            "how fast {body} is at the start is left open: it stands still while {driver} already moves what it lies "
            "on, and slides at first; asked of rest it goes along. Give it velocity: [{x:.4g} m/s, {y:.4g} m/s] if it "
            "goes along, or [0, 0]",
            body=body.name,
            driver=drives[0].connection,
            x=x,
            y=y,
        )
        yield self.warning(told, "bodies", body.name, about=frozenset({body.name}))


def _is_said(system: System, body: RigidBody) -> bool:
    """Whether the file says how fast a body is, by itself or by a measure."""
    own = body.start.velocity is not None or body.start.angular_velocity is not None
    given = (system.measures[name] for name in system.start_rates if name in system.measures)
    return own or any(body.name in measure.bodies() for measure in given)
