"""A contact with a restitution that is said to touch at the start, where what is said of the speeds would be a blow.

What touches goes on touching: speeds that the file does not give are those with which the two move together. Who writes
`touching: true` for a ball that has just come up to a rod means the impact.
"""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import suppress

from freebody.errors import CannotAnswer
from freebody.language.expression import ZERO, Symbol
from freebody.language.sentences import Message
from freebody.numeric.reference import Reference
from freebody.study.model_warnings.base import ModelWarning, Opened, WarningKind
from freebody.system.modes import ContactMode, in_mode

_PART = 1e-6  # of the greatest speed: less is no approach


class StruckWhileTouching(WarningKind, name="struck while touching"):
    """The two would come nearer with the given speeds alone."""

    def look(self, model: Opened) -> Iterator[ModelWarning]:
        system = model.system
        bounds = [b for b in system.bounds if b.starts_closed and b.restitution not in (None, ZERO)]
        if not bounds:
            return
        values = {name: model.reference.number(Symbol(name)) for name in system.parameters}
        apart = Reference(in_mode(system, ContactMode.of(frozenset(), {}))[0], values)
        q = model.start.q
        with suppress(CannotAnswer):
            v = apart.velocities(q)
            g = apart.at_rest(q, 0.0)
            for bound in bounds:
                row = apart.jet(g, bound.row.measure, bound.name).row(len(q))
                sizes = abs(row) @ abs(v)
                if bound.row.sign * float(row @ v) < -_PART * sizes:
                    name = bound.row.connection
                    told = Message(
                        "{name} is said to touch at the start: what it is between moves on together, and nothing "
                        "strikes. For an impact at the start leave touching out",
                        name=name,
                    )
                    yield self.warning(told, "connections", name, about=frozenset({name}))
                    return
