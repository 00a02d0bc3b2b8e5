"""Smooth motions from the start to an event, as quantities count along them: in formulas, and in numbers.

Heat and revolutions are counted where contacts or dry friction are (`study/phases`).
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

from freebody.errors import CannotAnswer
from freebody.language.sentences import Message
from freebody.measures.base import Measure
from freebody.numeric.snapshot import Snapshot
from freebody.questions.base import Quantity
from freebody.study.setup import Setup
from freebody.symbolic.field import Ratio
from freebody.symbolic.motion import Reached
from freebody.symbolic.state import SymbolicState, law_polynomial

_WORK_INSTEAD = Message("that is counted where contacts or dry friction are; here ask for the work of a load")
_ANGLE_INSTEAD = Message("that is counted where contacts or dry friction are; here ask for the change of angle")


@dataclass(frozen=True)
class FormulaPassage:
    """In formulas. elements: of a quantity in a state."""

    setup: Setup
    reached: Reached
    elements: Callable[[Quantity, SymbolicState], Any]

    def time(self) -> Ratio:
        if self.reached.time is None:
            raise CannotAnswer(self.reached.why_no_time)
        return self.reached.time

    def change(self, measure: Measure) -> Ratio:
        before = self.setup.start_instant.value(measure)
        return self.setup.model.field.lowest_terms(self._state.value(measure) - before)

    def work(self, load: str) -> Ratio:
        """Of a load that is a function of its own measure: minus the change of its potential."""
        f, before, after = self.setup.model.field, self.setup.start_instant, self._state
        total = f.zero
        pushes = [p for p in self.setup.system.pushes if p.load == load]
        if not pushes:
            raise CannotAnswer(Message("{load} is no load; the work of a constraint is asked as power", load=load))
        for push in pushes:
            law_polynomial(push)
            total = total + before.potential(push) - after.potential(push)
        return f.lowest_terms(total)

    def heat(self) -> Ratio:
        raise CannotAnswer(_WORK_INSTEAD)

    def revolutions(self, body: str) -> Ratio:
        raise CannotAnswer(_ANGLE_INSTEAD)

    def there(self, quantity: Quantity) -> Ratio:
        x = self.elements(quantity, self._state)
        if isinstance(x, tuple):
            raise CannotAnswer(Message("ask for one component of the vector at an event"))
        return x

    @property
    def _state(self) -> SymbolicState:
        return SymbolicState(self.setup.model, self.setup.motion.known_at(self.reached))


@dataclass(frozen=True)
class NumericPassage:
    """In numbers. power_integral: of a load, up to the event."""

    setup: Setup
    start: Snapshot
    event: Snapshot
    end: float
    power_integral: Callable[[str], float]

    def time(self) -> float:
        return self.end

    def change(self, measure: Measure) -> float:
        return self.event.value(measure) - self.start.value(measure)

    def work(self, load: str) -> float:
        return self.power_integral(load)

    def heat(self) -> float:
        raise CannotAnswer(_WORK_INSTEAD)

    def revolutions(self, body: str) -> float:
        raise CannotAnswer(_ANGLE_INSTEAD)

    def there(self, quantity: Quantity) -> Any:
        return quantity.value(self.setup.system, self.event)
