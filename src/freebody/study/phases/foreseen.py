"""Which mode the contact problem in numbers finds: what is worth a closed form, where many combinations could be.

With n contacts that stick, slide either way or open there are up to 4^n combinations, of which one holds at one set of
numbers. There the complementarity problem in accelerations of the numeric route (Pfeiffer & Glocker, 1996, ch. 6) names
it; its formulas then stand or fall by their own inequalities at all sets, as those of any candidate. What is foreseen
decides only which formulas are made.
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from freebody.budgets import allowed
from freebody.errors import CannotAnswer
from freebody.language.expression import evaluate
from freebody.model.elements import DryFriction
from freebody.numeric.contact.bounded import Bounded
from freebody.numeric.contact.forces import contact_forces
from freebody.numeric.contact.problem import MOST_OTHERS, Choice, Mode, RowState
from freebody.numeric.contact.rows import RowProblem
from freebody.numeric.reference import Reference
from freebody.study.phases.consistent import candidates, sides_at_borders
from freebody.study.phases.home import Home
from freebody.study.phases.nodes import PhaseStart
from freebody.study.phases.numbers import Mask
from freebody.study.simulation.simulator import Simulator
from freebody.system.modes import ContactMode, in_mode

FEW = 10  # candidates that are tried one after the other, without looking ahead
MOST_LOOKS = 30  # sets, one after the other, whose mode is of no use
_STATES = {RowState.STICKING: 0, RowState.FORWARD: 1, RowState.BACKWARD: -1}


class Foresight:
    """The modes that may follow on a state, those first that hold at some set of numbers."""

    def __init__(self, home: Home) -> None:
        self.home = home
        self._simulators: dict[int, Simulator | None] = {}

    def modes(self, instant: PhaseStart, left: Mask) -> Iterator[ContactMode]:
        """left: (n_sets,), true where a mode is still to be found; who asks for the next one has updated it. Where
        numbers do not tell what holds at the first set, every candidate follows."""
        indices = np.flatnonzero(left)
        listed = candidates(self.home, instant, indices)
        first = [mode for mode, _k in zip(listed, range(FEW + 1), strict=False)]
        if len(first) <= FEW or any(self._rub(name).across is not None for name in instant.slips):
            yield from first
            yield from listed
            return
        seen = set[ContactMode]()
        n_idle, is_told = 0, False
        for k in map(int, indices):
            if not left[k]:
                continue
            foreseen = self._at(instant, k)
            is_told = is_told or (k == indices[0] and bool(foreseen))
            for mode in foreseen:
                if mode not in seen and left[k]:
                    seen.add(mode)
                    yield mode
            n_idle = n_idle + 1 if left[k] else 0
            if n_idle >= allowed(MOST_LOOKS):
                break
        if not is_told:
            yield from (mode for mode in (*first, *listed) if mode not in seen)

    def _rub(self, name: str) -> DryFriction:
        return next(rub for rub in self.home.system.dry_friction if rub.name == name)

    # -- one set of numbers -----------------------------------------------------------------------
    def _at(self, instant: PhaseStart, k: int) -> list[ContactMode]:
        """The consistent modes in one set of numbers; none where the numeric route has none, or no start."""
        simulator = self._simulator(k)
        if simulator is None or simulator.bounded is None:
            return []
        try:
            problem, outcomes = self._outcomes(instant, simulator.bounded, simulator, k)
        except (CannotAnswer, ZeroDivisionError, OverflowError, ValueError):
            return []
        found = [self._named(instant, simulator.bounded, problem, mode) for mode in outcomes]
        return [
            ContactMode.of(closed, states, instant.past, {}, {**instant.acting, **sides})
            for closed, states in found
            for sides in sides_at_borders(self.home, instant)
        ]

    def _simulator(self, k: int) -> Simulator | None:
        """The system in the numbers of a set, packed once for all instants."""
        if k not in self._simulators:
            own = {n: x for n, x in self.home.sets.one(k).items() if n in self.home.system.parameters}
            try:
                self._simulators[k] = Simulator(self.home.system, own)
            except (CannotAnswer, ZeroDivisionError):
                self._simulators[k] = None
        return self._simulators[k]

    def _outcomes(
        self, instant: PhaseStart, bounded: Bounded, simulator: Simulator, k: int
    ) -> tuple[RowProblem, list[Mode]]:
        """The contact problem of an instant, and every mode that was found to solve it."""
        values, placed = self.home.sets.one(k), instant.placed
        # the state: of the bodies as they are put, while what touches does so
        system, _loads = in_mode(placed.put_into(self.home.system), ContactMode.of(instant.closed, {}, instant.past))
        reference = Reference(system, {n: x for n, x in values.items() if n in system.parameters})
        q = reference.assemble()
        v = reference.velocities(q)
        time = 0.0 if placed.since is None else float(evaluate(placed.since, values))
        bounded.hold_past(instant.past)
        y = bounded.free.state(*reference.by_body(q, v))
        now = bounded.instant(y, time, simulator.engine.near())
        # what is closed, and the sense in which it slips
        closed = [n for n, barrier in enumerate(bounded.barriers) if barrier.name in instant.closed]
        drags = {n: self._sense(instant, d.name, k) for n, d in enumerate(bounded.drags) if d.name in instant.slips}
        problem = bounded.problem(now, closed, drags, of_rates=False)
        banned: list[Choice] = []
        if instant.excluded is not None and not instant.excluded[1]:
            gone = [n for n in closed if bounded.barriers[n].name == instant.excluded[0]]
            banned = [(problem.row_of_barrier(n), RowState.CLOSED) for n in gone]
        outcome = contact_forces(problem.matrices, forbidden=banned, most_others=MOST_OTHERS)
        return problem, [outcome.mode, *outcome.alternatives] if outcome.is_found else []

    def _sense(self, instant: PhaseStart, name: str, k: int) -> int:
        """In which a friction slips, 0 at rest; what an event has just let go of goes on of itself."""
        if instant.excluded is not None and instant.excluded[0] == name:
            return instant.excluded[1]
        slip = instant.slips[name]
        return 0 if slip.is_zero() else int(np.sign(self.home.numbers(slip)[k]))

    def _named(
        self, instant: PhaseStart, bounded: Bounded, problem: RowProblem, mode: Mode
    ) -> tuple[set[str], dict[str, int]]:
        """What is closed, and the states of what rubs there. A friction that nothing presses holds nothing."""
        closed = {
            bounded.barriers[n].name for n in problem.closed if mode[problem.row_of_barrier(n)] is RowState.CLOSED
        }
        states: dict[str, int] = {}
        for n in problem.drags:
            drag = bounded.drags[n]
            if drag.of < 0 or bounded.barriers[drag.of].name in closed:
                states[drag.name] = _STATES.get(mode[problem.row_of_drag(n)], 0)
        return closed, states
