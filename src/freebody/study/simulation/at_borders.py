"""Where a motion passes the borders of loads that act on one side only: strings go taut, buffers are reached.

The step in which a border is passed ends there, and the next one is short: a long one might jump over all of a buffer.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace

from freebody.language.expression import Expr
from freebody.language.sentences import Message
from freebody.language.units import LENGTH
from freebody.model.elements import ConstraintRow
from freebody.model.one_sided import GAP_OF_BUFFER
from freebody.numeric.engine.course import Event
from freebody.numeric.engine.evaluator import EngineWatch
from freebody.numeric.engine.events import LEAPT
from freebody.system.system import System


def border_watches(system: System, number: Callable[[Expr], float], length: float) -> Iterator[EngineWatch]:
    """What is watched: each border twice, by the direction in which it is passed. length: [m] of the system."""
    for row in system.borders.values():
        assert row.target is not None
        limit = number(row.target)
        size = max(abs(limit), length if row.measure.dimension == LENGTH else length**2)
        for name, direction in zip(_names(row), (-row.sign, row.sign), strict=True):
            yield EngineWatch(name, row.measure, 0, limit, direction, is_terminal=True, size=size, is_border=True)


def with_borders(system: System, events: Sequence[Event], *, told: bool) -> tuple[Event, ...]:
    """The events of a motion, those at borders in words, or left out. Where it begins at a border, or only touches it,
    its law does not change."""
    rows = system.borders.values()
    words = {name: said for row in rows for name, said in zip(_names(row), _said(row), strict=True)}
    found: list[Event] = []
    for event in events:
        if event.name not in words:
            found.append(event)
        elif told and event.is_terminal and event.kind != LEAPT:
            name, kind = words[event.name]
            found.append(replace(event, name=name, kind=kind, is_terminal=False))
    return tuple(found)


def _names(row: ConstraintRow) -> tuple[str, str]:
    """What the engine calls a border where the load begins to act, and where it ends."""
    return f"@{row.name} begins", f"@{row.name} ends"


def _said(row: ConstraintRow) -> tuple[tuple[str, str], tuple[str, str]]:
    """The same in words, and the kinds of these events."""
    of = row.connection
    if row.component == GAP_OF_BUFFER:
        relaxed = Message("{contact} is relaxed again", contact=of)
        return (Message("{contact} is reached", contact=of), "touches"), (relaxed, "parts")
    slack = Message("{contact} goes slack", contact=of)
    return (Message("{contact} goes taut", contact=of), "goes taut"), (slack, "goes slack")
