"""Newton and Euler in one phase of a motion with contacts: principles, the law of friction, their solution."""

from __future__ import annotations

from collections.abc import Sequence
from functools import cached_property
from typing import Any, cast

import numpy as np

from freebody.language.expression import Expr, Symbol
from freebody.narrative.contact.contact_table import ContactPlanner, ContactState, ContactTable, SlidingLaw
from freebody.narrative.lines.glossary import Glossary
from freebody.narrative.lines.script import Script
from freebody.narrative.principles.elimination import EliminationRow
from freebody.narrative.principles.kinematics import Kinematics, scaled
from freebody.narrative.principles.newton import Newton, WrittenPrinciple
from freebody.narrative.principles.planner import Plan, Planner
from freebody.narrative.principles.symmetry import Copies
from freebody.questions.base import Quantity
from freebody.study.phases.phase import Phase
from freebody.study.phases.quantities import value_in_mode
from freebody.symbolic.field import Ratio
from freebody.symbolic.tidy import tidy


class ContactNewton(Newton):
    """Derives accelerations, normal forces and frictions of one phase."""

    table: ContactTable

    def __init__(self, phase: Phase, glossary: Glossary) -> None:
        super().__init__(phase.setup, glossary)
        self.phase = phase
        self.table = ContactTable(phase)
        self.kinematics = Kinematics(self.table, glossary)
        for name in self.table.laws:
            glossary.introduce(self.table.friction_meaning(name))

    @cached_property
    def copies(self) -> list[Copies]:
        """Places of contact do not stand for each other."""
        return []

    @cached_property
    def planner(self) -> Planner:
        world = list(self.glossary.worlds("always"))[-1]
        numbers = self.model.samples.numbers(world.draw.sample(world.snapshot), world.draw.sample())
        return ContactPlanner(self.table, numbers, self.merged)

    def asked(self, quantity: Quantity) -> tuple[Ratio, ...]:
        """The quantity in coordinates, speeds, accelerations and reactions of this phase."""
        value: Any = value_in_mode(quantity, self.phase.base, self.phase.system, ContactState(self.table))
        parts: tuple[Any, ...] = cast("tuple[Any, ...]", value) if isinstance(value, tuple) else (value,)
        return tuple(self.field.lowest_terms(self.field.element(p)) for p in parts)

    def reaction(self, row: str) -> int:
        """The generator of a reaction or friction."""
        return self.field.index(self.table.reactions[row])

    def plan(self, unknowns: Sequence[int]) -> Plan:
        """Principles that determine some unknowns; a friction is known with its normal force."""
        planner = self.planner
        assert isinstance(planner, ContactPlanner)
        targets = np.zeros((len(unknowns), planner.n))
        for k, unknown in enumerate(unknowns):
            targets[k, self._column(unknown)] = 1.0
            targets[k] = planner.without_frictions(targets[k])
        targets = targets[np.abs(targets).max(axis=1) > 0] if len(targets) else targets
        if not len(targets):
            return Plan((), (), ())
        return planner.plan(targets)

    def write(self, script: Script, plan: Plan, asked: Sequence[int]) -> dict[int, tuple[Ratio, int]]:
        """Free-body diagrams, principles, the law of friction, and their solution."""
        with script.stage("stage.bodies", "hint.bodies", bodies=self._bodies(plan)):
            self._cut_free(script, plan)
        with script.stage("stage.principles", "hint.principles", n=len(plan.principles)):
            written = [self._principle(script, plan, k) for k in range(len(plan.principles))]
        with script.stage("stage.friction", "hint.friction"):
            laws = [self._law(script, law) for law in self._needed(written, asked)]
        with script.stage("stage.kinematics", "hint.kinematics"):
            for w in written:
                self.explain(script, w.terms)
        with script.stage("stage.solution", "hint.solution", n=len(written) + len(laws)):
            rows = [self._in_coordinates(script, w) for w in written]
            return self._solve(script, [*rows, *laws], asked)

    def _needed(self, written: Sequence[WrittenPrinciple], asked: Sequence[int]) -> list[SlidingLaw]:
        standing = {row for w in written for row in w.reactions}
        return [law for n, law in self.table.laws.items() if n in standing or self.reaction(n) in asked]

    def _law(self, script: Script, law: SlidingLaw) -> EliminationRow:
        """F = mu N against the slip, as a line and as an equation."""
        f, name = self.field, law.rub.name
        self.name_reactions(script, [name, *([law.load] if law.load else [])])
        symbol = Symbol(self.table.symbols[name].name)
        if law.load:
            pressing = Symbol(self.table.symbols[law.load].name)
            right: Expr = scaled(f.lowest_terms(law.factor), pressing)
            entries = {self.reaction(name): f.one, self.reaction(law.load): f.lowest_terms(-law.factor)}
            rest = f.zero
        else:
            right, entries, rest = tidy(f.lowest_terms(law.factor)), {self.reaction(name): f.one}, law.factor
        way = "forward" if law.sense * law.rub.row.sign > 0 else "backward"
        args = {"connection": law.rub.row.connection, "force": symbol}
        number = script.line(symbol, right, why=f"friction.slides_{way}", args=args)
        return EliminationRow(entries, f.lowest_terms(rest), number)
