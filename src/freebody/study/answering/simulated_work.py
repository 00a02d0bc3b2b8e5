"""The work of a load in a simulated motion in which contacts and dry friction may change their states."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from freebody.budgets import allowed
from freebody.errors import CannotAnswer
from freebody.language.sentences import Message
from freebody.numeric.engine.course import Status, Trajectory
from freebody.numeric.jets import Array
from freebody.numeric.options import SimulationOptions
from freebody.questions.loads import Power
from freebody.study.simulation.instant import SimulatedInstant, with_all_held
from freebody.study.simulation.motion import SimulatedMotion
from freebody.study.simulation.simulator import Simulator
from freebody.system.system import System

_N_NODES = 8  # of a panel
_MOST = 6_000  # instants that are looked at
_AGREE = 1e-7  # of the size: by as little do panels of half the length differ


@dataclass(frozen=True)
class SimulatedWork:
    """The integral of the power over the time, by Gauss-Legendre points between the changes of contacts, in panels that
    are halved until that changes nothing."""

    system: System
    simulator: Simulator
    options: SimulationOptions
    course: Trajectory  # up to the event

    def changes(self) -> Array:
        """[s] the start, the changes of contacts on the way, and the event."""
        end = float(self.course.t_end)
        return np.array([0.0, *sorted({e.time for e in self.course.events if 0.0 < e.time < end}), end])

    def instants(self, times: Array) -> list[SimulatedInstant]:
        """The same motion at some times before the event."""
        course = self.simulator.run(float(self.course.t_end), self.options, outputs=times)
        places = np.searchsorted(course.times, times)  # there are instants of events as well
        if course.status is Status.TOO_LONG or places[-1] >= len(course.times):
            raise CannotAnswer(Message("the motion to the event could not be followed again"))
        motion = SimulatedMotion(self.system, self.simulator, course, self.options)
        return [SimulatedInstant(motion, int(k)) for k in places]

    def of(self, load: str) -> float:
        """Raises CannotAnswer where the power is too rugged to be added up."""
        edges, n, before = self.changes(), 2, None
        while n * _N_NODES * (len(edges) - 1) <= allowed(_MOST):
            total, size = self._by_panels(load, edges, n)
            if before is not None and abs(total - before) <= _AGREE * size:
                return total
            n, before = 2 * n, total
        raise CannotAnswer(Message("the power of {of} changes too often on the way to be added up", of=load))

    def _by_panels(self, load: str, edges: Array, n: int) -> tuple[float, float]:
        """The integral of the power, and of its size."""
        nodes, weights = np.polynomial.legendre.leggauss(_N_NODES)
        begins = np.concatenate([np.linspace(a, b, n + 1)[:-1] for a, b in pairwise(edges)])
        halves = 0.5 * np.diff(np.append(begins, edges[-1]))[:, None]
        held = with_all_held(self.system)
        instants = self.instants((begins[:, None] + halves * (1.0 + nodes)).ravel())
        power = np.array([float(Power(load).value(held, now)) for now in instants])
        weight = (halves * weights).ravel()
        return float(weight @ power), float(weight @ np.abs(power))
