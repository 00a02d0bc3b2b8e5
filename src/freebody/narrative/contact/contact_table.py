"""The table of principles of one phase: dry friction that slides is a force of its own, with its law beside it.

In a phase a contact that is closed has a row like any connection, and so has friction that sticks. Friction that slides
is F = -s c N along its slip (s the sense of the slip, c the kinetic coefficient): F stands in the principles as an
unknown like N, and the law is one more equation, which the planner counts by writing F in terms of N.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property

from freebody.errors import CannotAnswer
from freebody.language.expression import Symbol
from freebody.language.sentences import Message
from freebody.model.elements import AppliedLoad, ConstraintRow, DryFriction
from freebody.narrative.lines.glossary import Meaning, World
from freebody.narrative.lines.script import Sentence
from freebody.narrative.principles.formal import FormalState
from freebody.narrative.principles.planner import Array, Entry
from freebody.narrative.principles.table import PrincipleTable, Slot, WritablePrinciple
from freebody.narrative.principles.wide_planner import WidePlanner
from freebody.study.phases.phase import Phase
from freebody.symbolic.field import Ratio
from freebody.system.symbols import reaction_symbols
from freebody.tolerances import ROUND_OFF

_MOVING = 0.4


@dataclass(frozen=True)
class SlidingLaw:
    """F = factor * R of a friction that slides: R the reaction of the row `load`; without one F = factor."""

    rub: DryFriction
    sense: int  # of the slip
    coefficient: Ratio
    factor: Ratio
    load: str
    is_back: bool  # the load is the size of a reaction that is negative here


class ContactTable(PrincipleTable):
    """Principles, reactions, frictions and loads of one phase in the plane."""

    def __init__(self, phase: Phase) -> None:
        super().__init__(phase.model)
        self.phase = phase
        self.symbols = reaction_symbols(phase.base)
        self.laws = {law.rub.name: law for law in _laws(phase)}
        sliding: dict[str, ConstraintRow] = {name: law.rub.row for name, law in self.laws.items()}
        self.rows = {**{row.name: row for row in phase.system.held}, **sliding}

    @cached_property
    def loads(self) -> list[tuple[AppliedLoad, Ratio, dict[Slot, Ratio]]]:
        """Every load of the model; frictions are none."""
        return [
            (p, self.model.loads.law(p), self.model.gradient(p.measure))
            for p in self.system.pushes
            if p.load in self.system.loads
        ]

    def friction_meaning(self, name: str) -> Meaning:
        """What the symbol of a sliding friction means: read from the load that the numeric route has for it."""
        row, symbol = self.laws[name].rub.row, self.symbols[name]

        def read(world: World) -> float:
            pushes = world.snapshot.reference.system.pushes
            return row.sign * float(world.snapshot.law(next(p for p in pushes if p.load == name)))

        what = Sentence("symbol.reaction", {"reaction": "@reaction.friction", "connection": row.connection})
        return Meaning(Symbol(symbol.name), what, read, "")


def _laws(phase: Phase) -> list[SlidingLaw]:
    found: list[SlidingLaw] = []
    for name, sense in phase.mode.states.items():
        if not sense:
            continue
        rub = phase.rubs[name]
        coefficient = phase.coefficient(rub, sense, at_rest=False)
        factor = -sense * rub.row.sign * coefficient
        load, is_back = _load(phase, rub)
        found.append(SlidingLaw(rub, sense, coefficient, -factor if is_back else factor, load, is_back))
    return found


def _load(phase: Phase, rub: DryFriction) -> tuple[str, bool]:
    """The row that presses, and whether its reaction is negative."""
    if not rub.load:
        return "", False
    model = phase.model
    pressing = [name for name in rub.load if not model.reactions.multiplier(phase.rows[name]).is_zero()]
    if len(pressing) > 1:
        raise CannotAnswer(
            Message(
                "the friction of {contact} is proportional to a resultant of two components", contact=rub.row.connection
            )
        )
    name = (pressing or list(rub.load))[0]
    row = phase.rows[name]
    return name, not row.unilateral and model.samples.is_negative(row.sign * model.reactions.multiplier(row))


class ContactState(FormalState):
    """A general instant of a phase, with friction that slides as a symbol too."""

    table: ContactTable

    def law(self, push: AppliedLoad) -> Ratio:
        if push.load in self.table.laws:
            row = self.table.laws[push.load].rub.row
            return row.sign * self.table.reactions[push.load]
        return super().law(push)


class ContactPlanner(WidePlanner):
    """Chooses principles; a friction that slides counts as its normal force."""

    table: ContactTable

    def __init__(self, table: ContactTable, numbers: Mapping[int, float], merged: Mapping[str, str]) -> None:
        super().__init__(table, numbers, merged)
        self.factors = {name: self._number(law.factor) for name, law in table.laws.items()}

    def row_of(self, weights: Mapping[Slot, Ratio]) -> Array:
        return self.without_frictions(super().row_of(weights))

    def without_frictions(self, row: Array) -> Array:
        """A row with every sliding friction put in by its law."""
        row = row.copy()
        for name, law in self.table.laws.items():
            column = self.column(name)
            if law.load:
                row[self.column(law.load)] += self.factors[name] * row[column]
            row[column] = 0.0
        return row

    def _cost(self, p: WritablePrinciple, row: Array, place: int) -> float:
        """Moments about a point that moves with the contact are what one takes last."""
        moves = p.centre is not None and not p.centre.is_fixed and not p.centre.mass_center_of
        return super()._cost(p, row, place) + (_MOVING if moves else 0.0)

    def _avoided(self, e: Entry) -> tuple[str, ...]:
        kept = super()._avoided(e)
        standing = {n for n in self.table.laws if abs(self._arm(e.principle.weights, n)) > ROUND_OFF}
        pressing = {self.table.laws[n].load for n in standing}
        return tuple(r for r in kept if r not in standing and not (r in pressing and self._arm(e.principle.weights, r)))

    def _arm(self, weights: Mapping[Slot, Ratio], row: str) -> float:
        return sum(self._number(w) * self._slopes[row].get(slot, 0.0) for slot, w in weights.items())
