"""Blows in mid-motion: what closes and strikes at an event, with what only pushes or pulls left out.

That answers afterwards to what it is left to do (`transition`): by an impact, by parting, or by touching on.
"""

from __future__ import annotations

from collections.abc import Set
from dataclasses import dataclass

import numpy as np

from freebody.errors import CannotAnswer
from freebody.language.sentences import Message
from freebody.model.elements import NonholonomicForm
from freebody.numeric.blow import Blow, impulse, struck
from freebody.numeric.engine.course import BlowRecord
from freebody.numeric.jets import Array
from freebody.numeric.reference import Reference
from freebody.numeric.system import NumericSystem
from freebody.system.modes import at_blow
from freebody.system.system import System
from freebody.tolerances import ROUND_OFF

MEETS = 1e-7  # of the size of the system: so far what closes may be apart, after a motion that is followed to tolerance


@dataclass(frozen=True)
class SuddenBlows:
    """The blows of a system at given parameters."""

    reference: Reference

    @property
    def system(self) -> System:
        return self.reference.system

    def by_column(self, array: Array) -> Array:
        """The coordinates, from an array of all bodies."""
        return self.reference.by_column(array)

    def by_body(self, q: Array, v: Array) -> tuple[Array, Array]:
        """Poses and velocities of all bodies."""
        return self.reference.by_body(q, v)

    def words(self, name: str) -> str:
        """What happens in a blow, and when."""
        blow = next(b for b in self.system.blows if b.name == name)
        return Message("{blow} ({event})", blow=blow.words, event=name)

    def at(self, name: str, past: Set[str], q: Array, v: Array, t: float) -> tuple[Array, BlowRecord]:
        """The velocities (n,) just after a blow, and what it did. q, v: just before; past: the blows before it. Raises
        CannotAnswer where what closes does not meet, and where dry friction in a joint is loaded."""
        blow = next(b for b in self.system.blows if b.name == name)
        reference = Reference(at_blow(self.system, blow, frozenset(past)), self.reference.frame.values)
        g = reference.geometry(q, np.zeros_like(q), t)
        for row in blow.rows:
            if isinstance(row.measure, NonholonomicForm) or (row.target is None and row.measure.incremental):
                continue
            gap = float(reference.gap(row, g).value)
            if abs(gap) > MEETS * max(1.0, reference.sizes.length):
                raise CannotAnswer(
                    Message(
                        "{connection} cannot close when {event}: what it joins is {gap:.6g} apart there, in SI units",
                        connection=row.connection,
                        event=name,
                        gap=abs(gap),
                    )
                )
        found = struck(reference, g, v)
        self._refuse_friction(name, reference, found.multipliers)
        return found.after, recorded(reference, found, name, t)

    def _refuse_friction(self, name: str, reference: Reference, multipliers: Array) -> None:
        loads = {load for rub in self.system.dry_friction if not rub.of for load in rub.load}
        largest = float(np.abs(multipliers).max(initial=0.0))
        for row, size in zip(reference.system.constraint_rows, multipliers, strict=True):
            if row.name in loads and abs(size) > ROUND_OFF * largest:
                raise CannotAnswer(
                    Message(
                        "the blow when {event} loads {connection}, whose dry friction acts in it as well: such a blow "
                        "is not solved",
                        event=name,
                        connection=row.connection,
                    )
                )


def recorded(reference: NumericSystem, blow: Blow, name: str, time: float) -> BlowRecord:
    """What is kept of a blow: its impulses, as far as they are unique, and what it does to the kinetic energy."""
    impulses: dict[str, float] = {}
    unknown: list[str] = []
    for row in reference.system.constraint_rows:
        try:
            impulses[row.name] = row.sign * impulse(reference, blow, row)
        except CannotAnswer:
            unknown.append(row.name)
    M = reference.masses
    change = 0.5 * float(blow.after @ (M * blow.after) - blow.before @ (M * blow.before))
    return BlowRecord(time, name, impulses, tuple(unknown), change)
