"""What lies below a line that it is to lie on: nothing but its weight parts the two at once.

A line is solid on the right of its direction, so that one that points to the left has its open side below. Whoever
draws a slope from right to left has the block hang under it, and every answer about the contact is 0.
"""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import suppress
from dataclasses import replace

import numpy as np

from freebody.errors import CannotAnswer
from freebody.language.expression import Symbol
from freebody.language.sentences import Message
from freebody.measures.displacement import Displacement
from freebody.measures.geometry import GROUND
from freebody.model.elements import UnilateralConstraint
from freebody.numeric.reference import Reference
from freebody.study.model_warnings.base import ModelWarning, Opened, WarningKind
from freebody.system.modes import ContactMode, in_mode
from freebody.system.system import System

_NORMAL = "normal of "  # in front of the name of a line
_PART = 1e-6  # of the greatest acceleration: less is none


class UnderALine(WarningKind, name="under a line"):
    """A contact with a straight line that touches at the start, and that weights alone would open."""

    def look(self, model: Opened) -> Iterator[ModelWarning]:
        system = model.system
        touching = [b for b in system.bounds if b.starts_closed and isinstance(b.row.measure, Displacement)]
        weights = {name for name, load in system.loads.items() if load.kind == "gravity"}
        touching = [b for b in touching if not _is_pushed(system, b, weights)]
        if system.space or not touching or not weights:
            return
        falling = in_mode(system, ContactMode.of(frozenset(), {}))[0]
        falling = replace(falling, applied_loads=tuple(p for p in falling.applied_loads if p.load in weights))
        values = {name: model.reference.number(Symbol(name)) for name in system.parameters}
        reference = Reference(falling, values)
        q = model.start.q
        with suppress(CannotAnswer):
            there = reference.snapshot(q, np.zeros_like(q))
            greatest = float(np.abs(there.accelerations / reference.sizes.unit_moves).max(initial=0.0))
            least = _PART * greatest * reference.sizes.length
            off = {b for b in touching if b.row.sign * there.acceleration(b.row.measure) > least}
            lying = {b.row.connection for b in touching if b not in off}  # on one side of a thin body, on none else
            for bound in touching:
                if bound in off and bound.row.connection not in lying:
                    yield from self._told(system, bound)

    def _told(self, system: System, bound: UnilateralConstraint) -> Iterator[ModelWarning]:
        measure = bound.row.measure
        assert isinstance(measure, Displacement)
        line = measure.along.name.removeprefix(_NORMAL)
        if line == measure.along.name:
            return
        told = Message(
            "{body} lies below {line}, and its weight takes it off at once: a line is solid on the right of its "
            "direction. If {body} is to lie on it, turn {line} round: the opposite direction",
            body=measure.of.name,
            line=line,
        )
        yield self.warning(told, "connections", bound.row.connection, about=frozenset({bound.row.connection}))


def _is_pushed(system: System, bound: UnilateralConstraint, weights: set[str]) -> bool:
    """Whether another load than weights may press the two together."""
    bodies = {*bound.row.measure.bodies()} - {GROUND}
    return any(p.load not in weights and bodies & {*p.measure.bodies()} for p in system.applied_loads)
