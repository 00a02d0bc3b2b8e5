"""The system at a general instant, with accelerations and reactions left as symbols: what a question asks for in terms of
the unknowns of the table of principles."""

from __future__ import annotations

from freebody.measures.base import Measure
from freebody.model.elements import Held, RateMeasure
from freebody.narrative.table import Table
from freebody.symbolic.field import Ratio
from freebody.symbolic.state import SymbolicState


class FormalState(SymbolicState):
    """A state whose reactions are symbols and whose accelerations are those of the independent coordinates."""

    def __init__(self, table: Table) -> None:
        super().__init__(table.model)
        self.table = table

    def acceleration(self, measure: Measure | RateMeasure) -> Ratio:
        m = self.model
        return m.field.lowest_terms(m.in_independent_speeds(m.rate(self.raw_rate(measure))))

    def multiplier(self, row: Held) -> Ratio:
        return row.sign * self.table.reactions[row.name]
