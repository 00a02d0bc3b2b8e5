"""The reactions of held rows: Newton-Euler of every body, J^T lambda = M A - loads, solved for the multipliers.

Impulses of a blow follow in the same way, from what changes the momentum of every body."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import cached_property

from freebody.errors import CannotAnswer, FormulaTooLong
from freebody.language.sentences import Message, further
from freebody.model.elements import ConstraintRow
from freebody.symbolic.bodies import Bodies, Parts
from freebody.symbolic.configuration import Configuration
from freebody.symbolic.dynamics import SymbolicDynamics
from freebody.symbolic.kinematics import SymbolicKinematics
from freebody.symbolic.linear import RHS, Row, Solved, solve
from freebody.symbolic.loads import SymbolicLoads
from freebody.symbolic.ratio import Ratio
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
    def _made(self) -> Solved | FormulaTooLong:
        """What they come to, or that it is too long, which takes as long to find out."""

        def rest(body: str) -> Parts:
            changing = self._changing(body, self._dynamics.open_accelerations)
            wrench = self._loads.wrenches[body]
            return tuple(p - w for p, w in zip(changing, wrench, strict=True))

        try:
            return self._balanced(rest, lambda slope: slope)
        except FormulaTooLong as error:
            return error

    def impulses(self, rest: Callable[[str], Parts], here: Callable[[Ratio], Ratio]) -> dict[str, Ratio | CannotAnswer]:
        """By row the impulse of a blow, or why it is not unique. rest: what the held rows must give to a body, along
        its slots; here: an element in the pose of the blow."""
        solved = self._balanced(rest, here)
        found: dict[str, Ratio | CannotAnswer] = {}
        for row in self._system.constraint_rows:
            try:
                found[row.name] = self._unique(solved, row)
            except CannotAnswer as error:
                found[row.name] = error
        return found

    def at_rest(self, row: ConstraintRow, here: Callable[[Ratio], Ratio]) -> Ratio:
        """The multiplier of a row where nothing moves or accelerates, made in that pose alone: J^T lambda = -loads.
        here: an element in the pose, at rest. Raises as `multiplier`."""

        return self._unique(self._still(here), row)

    def balance_at_rest(self, here: Callable[[Ratio], Ratio]) -> bool:
        """Whether held rows balance the loads in a pose at rest, so that nothing is accelerated there."""
        return not self._still(here).contradictory

    def _still(self, here: Callable[[Ratio], Ratio]) -> Solved:
        def rest(body: str) -> Parts:
            return tuple(-here(w) for w in self._loads.wrenches[body])

        return self._balanced(rest, here)

    def in_pose(self, row: ConstraintRow, here: Callable[[Ratio], Ratio], accelerations: Mapping[int, Ratio]) -> Ratio:
        """The multiplier of a row at one instant, made in its pose alone. here: an element at the instant;
        accelerations: of the coordinates there. Raises as `multiplier`."""

        def rest(body: str) -> Parts:
            changing, wrench = self._changing(body, accelerations), self._loads.wrenches[body]
            return tuple(here(p) - here(w) for p, w in zip(changing, wrench, strict=True))

        return self._unique(self._balanced(rest, here), row)

    def _balanced(self, rest: Callable[[str], Parts], here: Callable[[Ratio], Ratio]) -> Solved:
        """J^T lambda = rest, body by body."""
        by_slot = self._slopes(here)
        rows: list[Row] = []
        for body in self._system.all_moving:
            needed = rest(body.name)
            for k, slot in enumerate(self._bodies.slots if body.turns else self._bodies.slots[: self._bodies.n_places]):
                row = dict(by_slot.get((body.name, slot), {}))
                if not needed[k].is_zero():
                    row[RHS] = needed[k]
                if row:
                    rows.append(row)
        samples = self._samples  # a formula that is divided by what is zero at the start has no value there
        columns = list(self._columns.values())
        return solve(self.field, rows, columns, samples.vanishes, is_last=samples.vanishes_at_starts)

    def _slopes(self, here: Callable[[Ratio], Ratio]) -> dict[tuple[str, str], Row]:
        """J^T: what each multiplier contributes to each slot of a body."""
        found: dict[tuple[str, str], Row] = {}
        for row in self._system.constraint_rows:
            for slot, slope in self._configuration.gradient(row.measure).items():
                found.setdefault(slot, {})[self._columns[row.name]] = here(slope)
        return found

    def _changing(self, body: str, solved: Mapping[int, Ratio]) -> Parts:
        """M A of a body and what its turning adds, along its slots. solved: accelerations of coordinates."""
        accelerations = [self.field.substitute(a, solved) for a in self._kinematics.body_accelerations[body]]
        return self._dynamics.inertia_force(body, accelerations)

    def multiplier(self, row: ConstraintRow) -> Ratio:
        """The multiplier of a row. Raises CannotAnswer naming the connections where it is not unique."""
        if isinstance(self._made, FormulaTooLong):
            raise self._made
        return self._dynamics.determined(self._unique(self._made, row))

    def _unique(self, solved: Solved, row: ConstraintRow) -> Ratio:
        column = self._columns[row.name]
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
