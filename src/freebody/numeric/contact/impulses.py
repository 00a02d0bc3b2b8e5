"""What the laws of impact have in common: the outcome, its energy, and rubs as they act in an impact.

Friction has one coefficient, the kinetic one, because an impulse that sticks at the end may have slipped before. Loads
of finite force (brakes) carry no impulse.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from freebody.numeric.contact.problem import Array, ContactProblem, FrictionProblemRow, Mode, OutcomeCount

_GREW = 1e-11  # of the terms of the work of impulses: energy that grows by less is round-off


@dataclass(frozen=True, slots=True)
class ImpactOutcome:
    """Impulses and velocities after, (n,) each, in the mode at the end; NaN if there are none.

    `energy_change`: sum P (u+ + u-)/2 [J] over all rows; held rows that moved before take part. `energy_grew`: it
    exceeds rounding, which Newton's law with friction allows (Kane & Levinson 1985).
    """

    status: OutcomeCount
    mode: Mode
    impulses: Array
    velocities: Array
    energy_change: float
    energy_grew: bool
    is_proven: bool = True

    @property
    def is_found(self) -> bool:
        return self.status in (OutcomeCount.UNIQUE, OutcomeCount.SEVERAL)


def impulsive(problem: ContactProblem) -> tuple[FrictionProblemRow, ...]:
    """The rubs as they act in an impact: kinetic coefficients, no slip known, nothing from finite forces."""
    return tuple(replace(rub, static=rub.kinetic, constant=0.0, sliding=0) for rub in problem.dry_friction)


def judged(
    problem: ContactProblem, status: OutcomeCount, mode: Mode, impulses: Array, is_proven: bool
) -> ImpactOutcome:
    """The outcome of impulses, with its energy: dT = sum P (u+ + u-)/2, because u+ - u- = A P."""
    velocities = problem.A @ impulses + problem.b
    velocities[list(problem.held_rows)] = 0.0
    change = float(impulses @ (velocities + problem.b)) / 2.0
    terms = float(np.abs(impulses) @ (np.abs(velocities) + np.abs(problem.b))) / 2.0
    return ImpactOutcome(status, mode, impulses, velocities, change, change > _GREW * terms, is_proven)
