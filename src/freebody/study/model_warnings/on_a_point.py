"""A body that lies on a particle: it balances on a point, where a block on a cart or on another block is meant."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from freebody.connections.contact import Contact
from freebody.connections.planar import Planar
from freebody.language.sentences import Message
from freebody.loads.gravity import Gravity
from freebody.study.model_warnings.base import ModelWarning, Opened, WarningKind


class OnAPoint(WarningKind, name="on a point"):
    """A contact in which a particle carries a body with a shape of its own: the particle is below its mass centre."""

    def look(self, model: Opened) -> Iterator[ModelWarning]:
        turning = {body.name: body.turns for body in model.system.moving}
        for name, contact in model.system.connections.items():
            if not isinstance(contact, Contact) or contact.between is None:
                continue
            particle, other = sorted(contact.between, key=lambda body: turning.get(body, True))
            if (
                turning.get(particle, True)
                or not turning.get(other, False)
                or _is_held(model, other)
                or not self._is_below(model, particle, other)
                or not self._touches(model, name)
            ):
                continue
            told = Message(
                "{carrier} is a particle, so {carried} balances on a point and tips about it. For a body that lies on "
                "{carrier} give it sides: {carrier}: {{rectangle: {{mass: ..., width: ..., height: ...}}}}",
                carrier=particle,
                carried=other,
            )
            yield self.warning(told, "connections", name, about=frozenset((particle, other)))

    def _touches(self, model: Opened, name: str) -> bool:
        """Whether both touch at the start: what is hit later is not lain on."""
        from freebody.numeric.contact.overlaps import PENETRATION, gap_of  # imported where a model has contacts

        g, size = model.start.geometry, PENETRATION * model.reference.sizes.length
        own = [bound for bound in model.system.bounds if bound.row.connection == name]
        return any(abs(gap_of(model.reference, g, bound)) <= size for bound in own)

    def _is_below(self, model: Opened, particle: str, other: str) -> bool:
        """Whether the weight of a body points from its mass centre to the particle."""
        at, n = model.start, 3 if model.system.space else 2
        columns = [list(model.reference.columns(body)[:n]) for body in (particle, other)]
        weights = [p for p in model.system.applied_loads if isinstance(model.system.loads.get(p.load), Gravity)]
        weight = sum(
            (model.slope(p.measure, at)[columns[1]] for p in weights if other in p.measure.bodies()), np.zeros(n)
        )
        return bool((at.q[columns[0]] - at.q[columns[1]]) @ weight > 0.0)


def _is_held(model: Opened, body: str) -> bool:
    """Whether a body hangs on a pin or runs in a guide, besides what it lies on: then it does not tip about a point."""
    system = model.system
    names = {name for name, spec in system.connections.items() if not isinstance(spec, (Contact, Planar))}
    rows = (row for row in system.constraint_rows if row.connection in names and not row.unilateral)
    return any(body in row.measure.bodies() for row in rows)
