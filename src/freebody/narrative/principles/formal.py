"""The system at a general instant, with accelerations and reactions left as symbols: what a question asks for in terms
of the unknowns of the table of principles."""

from __future__ import annotations

from contextlib import suppress
from typing import Any, cast

from freebody.errors import CannotAnswer
from freebody.measures.base import Measure
from freebody.model.elements import ConstraintRow, NonholonomicForm
from freebody.narrative.principles.table import PrincipleTable
from freebody.symbolic.field import Field, Ratio
from freebody.symbolic.state import SymbolicState


def elements(field: Field, value: Any) -> tuple[Ratio, ...]:
    """A quantity as elements: one for a scalar, its components for a vector."""
    parts: tuple[Any, ...] = cast("tuple[Any, ...]", value) if isinstance(value, tuple) else (value,)
    return tuple(field.lowest_terms(field.element(part)) for part in parts)


class FormalState(SymbolicState):
    """A state whose reactions are symbols and whose accelerations are those of the independent coordinates."""

    def __init__(self, table: PrincipleTable) -> None:
        super().__init__(table.model)
        self.table = table

    def acceleration(self, measure: Measure | NonholonomicForm) -> Ratio:
        m = self.model
        return m.field.lowest_terms(m.in_independent_speeds(m.rate(self.raw_rate(measure))))

    def multiplier(self, row: ConstraintRow) -> Ratio:
        return row.sign * self.table.reactions[row.name]

    def sqrt(self, x: Any) -> Ratio:
        """The root of a square has the sign that it has with the reactions and accelerations of the solution."""
        return self.model.field.sqrt(x, lambda base: self.model.samples.is_turned(self._solved(base)), is_kept=True)

    def _solved(self, x: Ratio) -> Ratio:
        """An element with reactions and accelerations replaced by what they are, where that is unique."""
        m, used = self.model, self.model.field.ingredients(x)
        values: dict[int, Ratio] = {}
        for row in m.system.held:
            reaction = self.table.reactions.get(row.name)
            if reaction is not None and m.field.index(reaction) in used:
                with suppress(CannotAnswer):
                    values[m.field.index(reaction)] = row.sign * m.reactions.multiplier(row)
        if used & set(m.accelerations):
            values |= m.dynamics.solved_accelerations
        return m.field.lowest_terms(m.field.follow(x, values)) if values else x
