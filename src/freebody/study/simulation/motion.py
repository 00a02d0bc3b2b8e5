"""A motion as the engine left it, with the system that moved."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TYPE_CHECKING

from freebody.model.elements import ConstraintRow
from freebody.numeric.contact.record import PhaseRecord
from freebody.numeric.engine.course import Event, Status, Trajectory
from freebody.numeric.options import SimulationOptions
from freebody.study.simulation.simulator import Simulator
from freebody.study.where_true import is_left
from freebody.system.system import System

if TYPE_CHECKING:
    from freebody.numeric.timestepping.run import Stepped


@dataclass(frozen=True, repr=False)
class SimulatedMotion:
    """A motion as the engine left it. SI units, angles in rad."""

    system: System
    simulator: Simulator
    course: Trajectory
    options: SimulationOptions
    trusted_until: float | None = None  # with `verify`: from here on two tolerances disagree
    steps: Stepped | None = field(default=None, repr=False)  # of time stepping: what the contacts did
    follows_sides: bool = False  # the reactions are those of the flanks that bear, also where the model states others
    phases: tuple[PhaseRecord, ...] = field(default=(), repr=False)  # with their steps, where these are kept

    @property
    def rows(self) -> tuple[ConstraintRow, ...]:
        """The rows whose multipliers the course has: what is held, and what is bounded or rubs where single contacts
        are followed."""
        return self.system.constraint_rows if self.simulator.bounded is None else self.system.rows

    @property
    def tolerance(self) -> float:
        return self.options.tolerance

    @property
    def status(self) -> Status:
        return self.course.status

    @property
    def message(self) -> str:
        return self.course.message

    @property
    def events(self) -> tuple[Event, ...]:
        return self.course.events

    @property
    def t_end(self) -> float:
        return self.course.t_end

    @property
    def not_valid(self) -> tuple[tuple[str, float], ...]:
        """What the model takes for granted that the motion leaves, in words, and when first [s]."""
        found: list[tuple[str, float]] = []
        start = self.simulator.value_at_start
        for validity in self.system.validities:
            times = [e.time for e in self.events if e.name == validity.left]
            if is_left(validity, self.simulator.reference, start(validity.measure)):
                times.insert(0, 0.0)
            if times:
                found.append((validity.purpose, times[0]))
        return tuple(found)
