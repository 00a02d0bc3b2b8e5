"""The system at a general instant, with accelerations and reactions left as symbols: what a question asks for in terms
of the unknowns of the table of principles."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from contextlib import suppress
from typing import Any, cast

from freebody.errors import CannotAnswer
from freebody.measures.base import Measure
from freebody.model.elements import AppliedLoad, ConstraintRow, NonholonomicForm
from freebody.narrative.principles.acting import Acting
from freebody.questions.base import Quantity
from freebody.symbolic.field import Field
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.state import SymbolicState

ValueOf = Callable[[Quantity, "FormalState"], Any]


def elements(field: Field, value: Any) -> tuple[Ratio, ...]:
    """A quantity as elements: one for a scalar, its components for a vector."""
    parts: tuple[Any, ...] = cast("tuple[Any, ...]", value) if isinstance(value, tuple) else (value,)
    return tuple(field.lowest_terms(field.element(part)) for part in parts)


class FormalState(SymbolicState):
    """A state whose reactions, frictions that slide among them, are symbols and whose accelerations are those of the
    independent coordinates."""

    def __init__(self, acting: Acting) -> None:
        super().__init__(acting.model)
        self.acting = acting

    def acceleration(self, measure: Measure | NonholonomicForm) -> Ratio:
        m = self.model
        return m.field.lowest_terms(m.in_independent_speeds(m.rate(self.raw_rate(measure))))

    def multiplier(self, row: ConstraintRow) -> Ratio:
        return self.acting.sign(row.name) * self.acting.reactions[row.name]

    def law(self, push: AppliedLoad) -> Ratio:
        law = self.acting.known.laws.get(push.load)
        return super().law(push) if law is None else self.acting.sign(law.rub.name) * self.acting.reactions[push.load]

    def sqrt(self, x: Any) -> Ratio:
        """The root of a square has the sign that it has with the reactions and accelerations of the solution."""
        return self.model.field.sqrt(x, lambda base: self.model.samples.is_turned(self._solved(base)), is_kept=True)

    def _solved(self, x: Ratio) -> Ratio:
        """An element with reactions and accelerations replaced by what they are, where that is unique."""
        m, used = self.model, self.model.field.ingredients(x)
        values: dict[int, Ratio] = {}
        for row in m.system.constraint_rows:
            reaction = self.acting.reactions.get(row.name)
            if reaction is not None and m.field.index(reaction) in used:
                with suppress(CannotAnswer):
                    values[m.field.index(reaction)] = self.acting.sign(row.name) * m.reactions.multiplier(row)
        if used & set(m.accelerations):
            values |= m.dynamics.solved_accelerations
        return m.field.lowest_terms(m.field.follow(x, values)) if values else x


def formal_parts(acting: Acting, quantity: Quantity, value_of: ValueOf | None = None) -> tuple[Ratio, ...]:
    """A quantity in coordinates, speeds, accelerations and reactions. value_of: it in a formal state, where that is not
    its value in the system itself."""
    f, model, state = acting.model.field, acting.model, FormalState(acting)
    parts = elements(f, quantity.value(acting.system, state) if value_of is None else value_of(quantity, state))
    return tuple(f.lowest_terms(model.in_independent_speeds(p)) for p in parts) if acting.system.space else parts


def unknowns_in(acting: Acting, parts: Iterable[Ratio]) -> list[int]:
    """Generators of accelerations and reactions in some elements."""
    unknowns = {acting.generator(row) for row in acting.rows} | set(acting.model.accelerations)
    return sorted({g for p in parts for g in acting.model.field.ingredients(p)} & unknowns)
