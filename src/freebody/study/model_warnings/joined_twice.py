"""Two connections that hold the same: the second one holds nothing that the first does not hold already."""

from __future__ import annotations

from collections.abc import Hashable, Iterator

from freebody.language.sentences import Message
from freebody.measures.displacement import Displacement
from freebody.model.elements import ConstraintRow
from freebody.study.model_warnings.base import ModelWarning, Opened, WarningKind


class JoinedTwice(WarningKind, name="joined twice"):
    """Of connections whose measures are the same the reactions are not unique, and the second is hardly meant."""

    def look(self, model: Opened) -> Iterator[ModelWarning]:
        held: dict[str, set[Hashable]] = {}
        for row in model.system.constraint_rows:
            if not (row.closes or row.if_needed or row.unilateral):
                held.setdefault(row.connection, set()).add(_what(row))
        names = [name for name in held if name in model.system.connections]
        for k, second in enumerate(names):
            first = next((name for name in names[:k] if held[second] <= held[name]), None)
            if first is not None:
                told = Message(
                    "{second} holds what {first} holds already: leave one of them out, or change what it joins",
                    second=second,
                    first=first,
                )
                yield self.warning(told, "connections", second, about=frozenset((first, second)))


def _what(row: ConstraintRow) -> Hashable:
    """What a row holds, whichever of two points is named first."""
    if isinstance(row.measure, Displacement):
        return frozenset((row.measure.of, row.measure.origin)), row.measure.along, row.target
    return row.measure, row.target
