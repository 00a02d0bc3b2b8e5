"""The reactions of held rows: Newton-Euler of every body, J^T lambda = M A - loads, solved for the multipliers."""

from __future__ import annotations

from functools import cached_property

from freebody.errors import CannotAnswer
from freebody.language.sentences import Message, further
from freebody.model.elements import ConstraintRow
from freebody.symbolic.bodies import Bodies, Parts
from freebody.symbolic.configuration import Configuration
from freebody.symbolic.dynamics import SymbolicDynamics
from freebody.symbolic.field import Ratio
from freebody.symbolic.kinematics import SymbolicKinematics
from freebody.symbolic.linear import RHS, Row, Solved, solve
from freebody.symbolic.loads import SymbolicLoads
from freebody.symbolic.samples import Samples
from freebody.system.system import System


class Reactions:
    """The multipliers of a system, solved for together when the first is asked for."""

    def __init__(
        self,
        system: System,
        bodies: Bodies,
        configuration: Configuration,
        kinematics: SymbolicKinematics,
        loads: SymbolicLoads,
        dynamics: SymbolicDynamics,
        samples: Samples,
    ) -> None:
        self._system, self._bodies, self._configuration = system, bodies, configuration
        self._kinematics, self._loads, self._dynamics = kinematics, loads, dynamics
        self._samples = samples
        self.field = bodies.field
        self._columns = {row.name: k for k, row in enumerate(system.constraint_rows)}

    @cached_property
    def _solved(self) -> Solved:
        by_slot = self._slopes()
        rows: list[Row] = []
        for body in self._system.moving:
            changing, wrench = self._changing(body.name), self._loads.wrenches[body.name]
            for k, slot in enumerate(self._bodies.slots if body.turns else self._bodies.slots[: self._bodies.n_places]):
                row = dict(by_slot.get((body.name, slot), {}))
                if not row:
                    continue
                rest = changing[k] - wrench[k]
                if not rest.is_zero():
                    row[RHS] = rest
                rows.append(row)
        return solve(self.field, rows, list(self._columns.values()), self._samples.vanishes)

    def _slopes(self) -> dict[tuple[str, str], Row]:
        """J^T: what each multiplier contributes to each slot of a body."""
        found: dict[tuple[str, str], Row] = {}
        for row in self._system.constraint_rows:
            for slot, slope in self._configuration.gradient(row.measure).items():
                found.setdefault(slot, {})[self._columns[row.name]] = slope
        return found

    def _changing(self, body: str) -> Parts:
        """M A of a body and what its turning adds, along its slots."""
        solved = self._dynamics.solved_accelerations
        accelerations = [self.field.substitute(a, solved) for a in self._kinematics.body_accelerations[body]]
        return self._dynamics.inertia_force(body, accelerations)

    def multiplier(self, row: ConstraintRow) -> Ratio:
        """The multiplier of a row. Raises CannotAnswer naming the connections where it is not unique."""
        solved, column = self._solved, self._columns[row.name]
        names = {k: name for name, k in self._columns.items()}
        free = [column] if column in solved.free else [c for c in solved.pivots[column] if c != RHS]
        if free:
            with_it = min(({c, *(p for p, r in solved.pivots.items() if c in r)} for c in free), key=len)
            rows = ", ".join(sorted(names[c] for c in with_it))
            why = Message(
                "the reaction {row} is not unique: the constraints {rows} depend on each other, so rigid-body "
                "mechanics fixes only a combination of their reactions. Remove one of them or make one part "
                "flexible",
                row=row.name,
                rows=rows,
            )
            raise CannotAnswer(further(why, *sorted({self._system.constraint_rows[c].instead for c in with_it} - {""})))
        return solved.pivots[column].get(RHS, self.field.zero)
