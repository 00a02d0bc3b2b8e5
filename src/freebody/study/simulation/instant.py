"""One instant of a simulated motion, as quantities are evaluated in it: forces are those that the simulation found."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from functools import cached_property

import numpy as np

from freebody.errors import CannotAnswer
from freebody.language.sentences import Message
from freebody.model.elements import ConstraintRow
from freebody.numeric.jets import Array
from freebody.numeric.snapshot import Snapshot
from freebody.study.simulation.motion import SimulatedMotion
from freebody.system.system import System
from freebody.tolerances import ROUND_OFF


class SimulatedInstant(Snapshot):
    """The k-th state of a motion; the reactions of contacts and dry friction are multipliers like all others."""

    def __init__(self, motion: SimulatedMotion, k: int) -> None:
        reference, engine, course = motion.simulator.reference, motion.simulator.engine, motion.course
        q, v = map(reference.by_column, engine.coordinates(engine.state_at(course, k)))
        at = reference.snapshot(q, v, float(course.times[k]))
        super().__init__(reference, at.geometry, q, v, at.t)
        self._course, self._k = course, k
        self._accelerations = reference.by_column(
            engine.accelerations(course)[k].reshape(-1, 6 if reference.system.space else 3)
        )
        self._rows = tuple(motion.rows)
        self._places = {row.name: j for j, row in enumerate(motion.rows)}
        self._rubs = motion.system.dry_friction

    @property
    def accelerations(self) -> Array:
        return self._accelerations

    def multiplier(self, row: ConstraintRow) -> float:
        j = self._places[row.name]
        if not self._unique[j]:
            raise CannotAnswer(Message("the {reaction} of {row} is not unique", reaction=row.reaction, row=row.name))
        return float(self._course.multipliers[self._k, j])

    @cached_property
    def _unique(self) -> Array:
        """(n_rows,) whether a multiplier is unique. Friction at its limit where nothing slips may be any smaller
        one: its row counts as held, and what balances with it is open."""
        unique = self._course.unique[self._k]
        acts = self._course.multipliers[self._k] != 0.0
        acting_names = {row.name for j, row in enumerate(self._rows) if acts[j]}
        pressed = [rub for rub in self._rubs if not rub.load or acting_names & {*rub.load}]
        rows = [row for rub in pressed for row in rub.rows if row.name in self._places]
        resting = [row for row in rows if self._rests(row)]
        if not resting or not unique.any():
            return unique
        acting = [row for row in self._rows if row.name in acting_names or row in resting]
        moving = self.reference.system.all_moving
        slopes = np.array([[x for b in moving for x in self.gradient(row.measure, b.name)] for row in acting])
        wanted = np.eye(len(acting))
        reached = slopes @ np.linalg.lstsq(slopes, wanted, rcond=None)[0]
        is_open = np.abs(reached - wanted).max(axis=0) > ROUND_OFF
        found = unique.copy()
        found[[self._places[row.name] for row, own in zip(acting, is_open, strict=True) if own]] = False
        return found

    def _rests(self, row: ConstraintRow) -> bool:
        """Whether what rubs neither slips nor is about to."""
        return abs(self.rate(row.measure)) <= ROUND_OFF and abs(self.acceleration(row.measure)) <= ROUND_OFF

    def total(self, parts: Sequence[tuple[float, ConstraintRow]]) -> float:
        """A sum of multipliers with signs or weights, as what two corners of a box transmit together. With J the rows
        whose own multipliers are not unique, those that balance the same forces differ by z with J^T z = 0; the sum w z
        is the same for all of them if and only if w = J x for some x."""
        unique = self._unique
        if all(unique[self._places[row.name]] for _sign, row in parts):
            return sum(sign * self.multiplier(row) for sign, row in parts)
        open_ = [row for row in self._rows if not unique[self._places[row.name]]]
        n = len(self.q)
        jacobian = np.array([self.reference.jet(self.geometry, row.measure).row(n) for row in open_])
        share = {row.name: float(sign) for sign, row in parts}
        wanted = np.array([share.get(row.name, 0.0) for row in open_])
        x = np.linalg.lstsq(jacobian, wanted, rcond=None)[0]
        if float(np.abs(jacobian @ x - wanted).max()) > ROUND_OFF:
            return sum(sign * self.multiplier(row) for sign, row in parts)  # which says what is not unique
        multipliers = self._course.multipliers[self._k]
        return float(sum(sign * multipliers[self._places[row.name]] for sign, row in parts))


def with_all_held(system: System) -> System:
    """The system with the rows of contacts and dry friction among those that are held, for questions about forces: what
    is open has the force zero, what slides the force of its friction."""
    return replace(system, constraint_rows=tuple(system.rows), contacts=(), limits=(), brakes=(), blows=())
