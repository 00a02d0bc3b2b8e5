"""The energy balance of a motion: what the bodies gained is what loads and drivers gave.

    (T + V)(t) - (T + V)(0) = W(t)

T is the kinetic energy, V the potential of constant loads and of linear springs, and W the work, integrated with the
motion, of all other loads and of held measures that are driven. Ideal reactions do no work, so the error of the balance
measures the whole integration.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from freebody.model.elements import NonholonomicForm
from freebody.model.states import state_name
from freebody.numeric.engine.laws import stored_law
from freebody.numeric.jets import Array
from freebody.numeric.kernels.stepped_run import EPSILON
from freebody.numeric.spatial import tensor_of

if TYPE_CHECKING:
    from freebody.study.simulation.motion import SimulatedMotion


@dataclass(frozen=True)
class EnergyBalance:
    """Energies at the output times [J]."""

    kinetic: Array
    potential: Array
    work: Array
    typical: float  # the constant loads times the length of the system [J]: less than 1e-4 of it counts as that
    least: float  # of motions by the round-off of the system's length in the whole time [J]; less counts as that

    @property
    def error(self) -> float:
        """The largest error of the balance [J]."""
        total = self.kinetic + self.potential
        return float(np.abs(total - total[0] - (self.work - self.work[0])).max())

    @property
    def relative_error(self) -> float:
        """The error by the largest energy that was exchanged."""
        exchanged = max(float(np.ptp(self.kinetic)), float(np.ptp(self.potential)), float(np.ptp(self.work)))
        largest = max(exchanged, float(self.kinetic.max(initial=0.0)), 1e-4 * self.typical, self.least)
        return self.error / largest if largest > 0.0 else 0.0


def energy_balance(result: SimulatedMotion) -> EnergyBalance:
    """Energies along a motion."""
    course, simulator = result.course, result.simulator
    kinetic, mass = np.zeros(len(course.times)), 0.0
    work = course.work.copy()
    for k, body in enumerate(result.system.all_moving):
        v = course.velocities[:, k]
        m = simulator.reference.number(body.mass)
        if state_name(body.name):  # what drives a state is no power: z f, whose integral is z^2/2
            work -= 0.5 * m * v[:, 0] ** 2
            continue
        mass += m
        kinetic += 0.5 * m * (v[:, 0] ** 2 + v[:, 1] ** 2)
        if course.rotation is not None:
            omega = course.rotation.velocities_in_body[:, k]
            tensor = tensor_of(body, simulator.reference.number)
            kinetic += 0.5 * m * v[:, 2] ** 2 + 0.5 * np.einsum("ti,ij,tj->t", omega, tensor, omega)
        elif body.turns:
            kinetic += 0.5 * simulator.reference.number(body.inertia) * v[:, 2] ** 2
    from freebody.study.simulation.observed import observed

    laws = {push.name: (push, stored_law(push, simulator.numbers.values)) for push in result.system.applied_loads}
    stored = {name: (push, law) for name, (push, law) in laws.items() if law is not None}
    found = observed(result, {name: push.measure for name, (push, _law) in stored.items()})
    potential = np.zeros_like(kinetic)
    for name, (push, (c0, c1)) in stored.items():
        assert not isinstance(push.measure, NonholonomicForm)
        x = found[name][0] - simulator.reference.start_value(push.measure)
        potential -= c0 * x + 0.5 * c1 * x * x
    loads = simulator.engine.layout.constant_force.reshape(-1, 3)
    forces = loads[::2] if result.system.space else loads[:, :2]
    typical = float(np.abs(forces).sum()) * simulator.numbers.length
    duration = float(course.times[-1] - course.times[0])
    unseen = EPSILON * simulator.numbers.length / duration if duration > 0.0 else 0.0
    return EnergyBalance(kinetic, potential, work, typical, 0.5 * mass * unseen**2)
