"""Principles of a system at rest: sums of forces and of moments are zero, in the start pose.

At the limit every contact is in one of three states (`symbolic/active_set.py`): it opens, N = 0; it slips, F is at its
limit; or it stays, and nothing is known of its force. What the states say is put into the equations, so that a set of
them from which all forces that are left drop out is a condition on the parameters alone: this is what the planner looks
for, or for a set from which a reaction follows.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from freebody.errors import CannotAnswer
from freebody.language.sentences import Message
from freebody.measures.base import Measure
from freebody.model.elements import AppliedLoad, DryFriction, NonholonomicForm
from freebody.narrative.principles.planner import Array, Entry, Plan, is_multiple
from freebody.narrative.principles.table import Pair, PrincipleTable, Slot, WritablePrinciple
from freebody.narrative.principles.wide_planner import WidePlanner
from freebody.study.friction.touching import TouchingAtRest
from freebody.symbolic.active_set import Failure, RestEquations
from freebody.symbolic.field import Ratio
from freebody.system.symbols import reaction_symbols
from freebody.tolerances import ROUND_OFF

_TERM = 0.05  # for a force in an equation


@dataclass(frozen=True)
class FrictionLimit:
    """F = factor * R at its limit, R the reaction of the row `load`, or F = factor without one; sense: of the slip."""

    rub: DryFriction
    sense: int
    coefficient: Ratio
    factor: Ratio
    load: str


class RestTable(PrincipleTable):
    """Principles, reactions and frictions in the start pose."""

    def __init__(self, touching: TouchingAtRest, equations: RestEquations) -> None:
        super().__init__(equations.state.model)
        self.touching = touching
        self.equations = equations
        self.symbols = reaction_symbols(touching.system)
        self.rows = {row.name: row for row in touching.rows}

    def here(self, x: Ratio) -> Ratio:
        return self.equations.here(x)

    def gradient(self, measure: Measure | NonholonomicForm) -> dict[Slot, Ratio]:
        found = {slot: self.here(x) for slot, x in self.model.gradient(measure).items()}
        return {slot: x for slot, x in found.items() if not x.is_zero()}

    @cached_property
    def loads(self) -> list[tuple[AppliedLoad, Ratio, dict[Slot, Ratio]]]:
        return [(p, self.here(self.model.loads.law(p)), self.gradient(p.measure)) for p in self.system.pushes]

    def position(self, body: str) -> Pair:
        x, y = super().position(body)
        return self.here(x), self.here(y)

    def _is_still(self, place: Pair) -> bool:
        return True

    # -- states of the contacts ---------------------------------------------------------------
    def limits(self, failure: Failure) -> dict[str, FrictionLimit]:
        """The frictions that are at their limit. Raises CannotAnswer for one with a resultant of two components."""
        found: dict[str, FrictionLimit] = {}
        for name, sense in failure.slips:
            rub = self.equations.rubs[name]
            if len(rub.load) > 1:
                raise CannotAnswer(
                    Message(
                        "the friction of {contact} is proportional to a resultant of two components, for which "
                        "the equations are not linear",
                        contact=rub.row.connection,
                    )
                )
            c = self.equations.coefficient(rub, sense)
            factor, load = -sense * rub.row.sign * c, ""
            if rub.load:
                load = rub.load[0]
                row = self.rows[load]
                own = 1 if row.unilateral else dict(failure.signs).get(load, 1) * row.sign
                factor = own * factor
            found[name] = FrictionLimit(rub, sense, c, self.model.field.lowest_terms(factor), load)
        return found

    def absent(self, failure: Failure) -> tuple[str, ...]:
        """Rows without force: what opens, and the friction there."""
        opened = set(failure.opens)
        return (*sorted(opened), *(n for n, rub in self.equations.rubs.items() if rub.load and set(rub.load) <= opened))


class RestPlanner(WidePlanner):
    """Chooses equations of equilibrium in one failure. The last column is that of the loads."""

    table: RestTable

    def __init__(
        self, table: RestTable, numbers: Mapping[int, float], failure: Failure, asked: Sequence[str] = ()
    ) -> None:
        """asked: rows whose reactions are wanted; without any a condition on the parameters is."""
        super().__init__(table, numbers)
        self.asked = tuple(asked)
        self.limits = table.limits(failure)
        self.gone = table.absent(failure)
        self.factors = {name: self._number(limit.factor) for name, limit in self.limits.items()}
        self._loads = [
            {slot: self._number(law * slope) for slot, slope in slopes.items()} for _p, law, slopes in table.loads
        ]
        self.last: int = self.n
        self.width: int = self.last + 1

    def row_of(self, weights: Mapping[Slot, Ratio]) -> Array:
        numbers = {slot: self._number(w) for slot, w in weights.items()}
        row = np.zeros(self.width)
        for name, slopes in self._slopes.items():
            row[self.column(name)] = sum(w * slopes.get(slot, 0.0) for slot, w in numbers.items())
        if not self.asked:
            row[self.last] = sum(w * load.get(slot, 0.0) for load in self._loads for slot, w in numbers.items())
        row[np.abs(row) < ROUND_OFF * max(1.0, float(np.abs(row).max(initial=0.0)))] = 0.0
        return self.decided(row)

    def decided(self, row: Array) -> Array:
        """With what the states of the contacts say put in."""
        row = row.copy()
        for name in self.gone:
            row[self.column(name)] = 0.0
        for name, limit in self.limits.items():
            column = self.column(name)
            if limit.load:
                row[self.column(limit.load)] += self.factors[name] * row[column]
            elif not self.asked:
                row[self.last] += self.factors[name] * row[column]
            row[column] = 0.0
        return row

    def equations(self) -> Plan:
        """Equations from which every force that is not known drops out, or from which the asked reaction follows."""
        if not self.asked:
            target = np.zeros((1, self.width))
            target[0, self.last] = 1.0
            return self.plan(target)
        found: list[Array] = []
        for name in self.asked:
            row = np.zeros(self.width)
            row[self.column(name)] = 1.0
            found.append(self.decided(row))
        return self.plan(np.array([row for row in found if row.any()]))

    def _entries(self, among: frozenset[str] | None) -> list[Entry]:
        """All principles but multiples of cheaper ones: with frictions at their limit many have the same unknowns."""
        found: list[Entry] = []
        for group in self.table.groups():
            for place, principle in enumerate(self.table.of(group)):
                row = self.row_of(principle.weights)
                if row.any() and (among is None or set(group) <= among):
                    found.append(Entry(principle, row, self._cost(principle, row, place)))
        kept: list[Entry] = []
        for e in sorted(found, key=lambda e: e.cost):
            if not any(is_multiple(e.row, other.row) for other in kept):
                kept.append(e)
        return kept

    def _cost(self, p: WritablePrinciple, row: Array, place: int) -> float:
        """Equations with fewer forces come first."""
        arms = (self._arm(p.weights, name) for name in self._slopes if name not in self.gone)
        return super()._cost(p, row, place) + _TERM * sum(1 for arm in arms if abs(arm) > ROUND_OFF)

    def _arm(self, weights: Mapping[Slot, Ratio], row: str) -> float:
        return sum(self._number(w) * self._slopes[row].get(slot, 0.0) for slot, w in weights.items())

    def _avoided(self, e: Entry) -> tuple[str, ...]:
        weights, bodies = e.principle.weights, set(e.principle.bodies)
        found: list[str] = []
        for name, slopes in self._slopes.items():
            moving = {b for b, _slot in slopes if not self._is_fixed(b)}
            if name in self.gone or not moving & bodies or (moving <= bodies and len(moving) > 1):
                continue
            if abs(self._arm(weights, name)) < ROUND_OFF:
                found.append(name)
        return tuple(found)
