"""A phase of a motion in formulas, as quantities count along it."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from freebody.measures.base import Measure
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.state import SymbolicState
from freebody.symbolic.turned_ways import TurnedWay


@dataclass(frozen=True)
class FormulaPhase:
    """One law of motion, from `begin` to `end`. told: takes an element of its field into that of the answer."""

    begin: SymbolicState
    end: SymbolicState
    told: Callable[[Ratio], Ratio]
    time: Ratio | None = None  # how long it lasts, where that has a closed form
    turned: Callable[[Ratio], TurnedWay | None] | None = None  # where something that moves in it turns back

    @property
    def told_zero(self) -> Ratio:
        return self.told(self.begin.model.field.zero)

    def at_begin(self, measure: Measure) -> Ratio:
        return self.told(self.begin.value(measure))

    def at_end(self, measure: Measure) -> Ratio:
        return self.told(self.end.value(measure))

    def rates(self, measure: Measure) -> tuple[Ratio, Ratio]:
        """At the beginning, or, where it starts at rest, what it is accelerated with; and at the end."""
        first = self.begin.rate(measure)
        if first.is_zero():
            first = self.begin.acceleration(measure)
        return self.told(first), self.told(self.end.rate(measure))
