"""How the numeric route reads small motions of one draw: the equilibrium, mass and stiffness along the coordinates.

With e_j the velocities in which coordinate j changes at unit rate and no other one does,

    M_jk = e_j . m e_k,    Q_j = sum of loads * (rate of their measures with e_j),    K_jk = -dQ_j/dq_k.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping

import numpy as np

from freebody.errors import CannotAnswer
from freebody.language.sentences import Message
from freebody.measures.base import Measure
from freebody.narrative.lines.glossary import World
from freebody.numeric.jets import Array
from freebody.study.answering.crosscheck import element_at
from freebody.study.answering.draws import Draw
from freebody.study.setup import Setup
from freebody.symbolic.field import Ratio
from freebody.symbolic.unknowns import Coordinate

STEP = 1e-3  # rad, m
SETTLED = 1e-5  # of a step, that an equilibrium may still move by
ZERO = 1e-11  # rad, m
_STEPS = 4


class SmallMotions:
    """Reads by draws. equilibrium: the claimed values of the coordinates, from which the true ones are looked for."""

    def __init__(self, setup: Setup, equilibrium: Mapping[int, Ratio]) -> None:
        self.setup, self.equilibrium = setup, equilibrium
        self._values: dict[int, tuple[Draw, Array]] = {}
        self._matrices: dict[int, tuple[Array, Array]] = {}
        self.measures: list[Measure] = []
        for c in setup.model.coordinates:
            measure = setup.model.measure_of(c)
            if measure is None:
                raise CannotAnswer(
                    Message("{x} is no measure of the model, so small motions along it cannot be checked", x=c.name)
                )
            self.measures.append(measure)
        draw = setup.draws[0]
        if draw.reference.velocities(draw.q, [(m, 0.0) for m in self.measures], with_start=False).any():
            raise CannotAnswer(
                Message(
                    "a driver keeps the system moving; small motions beside a driven one are not derived step by step"
                )
            )

    # -- readers ------------------------------------------------------------------------------
    def value(self, k: int) -> Callable[[World], float]:
        """A coordinate at the equilibrium."""
        return lambda world: float(self._at(world.draw)[k])

    def mass(self, j: int, k: int) -> Callable[[World], float]:
        return lambda world: float(self._linear(world.draw)[0][j, k])

    def stiffness(self, j: int, k: int) -> Callable[[World], float]:
        return lambda world: float(self._linear(world.draw)[1][j, k])

    def slope(self, world: World) -> float:
        """K/M of one coordinate."""
        mass, stiffness = self._linear(world.draw)
        return float(stiffness[0, 0] / mass[0, 0])

    def frequency(self, k: int) -> Callable[[World], float]:
        """The natural frequencies of the full system about the equilibrium, ascending."""
        return lambda world: float(np.sort(world.draw.reference.frequencies(self.pose(world.draw)))[k])

    def pose(self, draw: Draw) -> Array:
        return self._pose(draw, self._at(draw))

    # -- numbers ------------------------------------------------------------------------------
    def _pose(self, draw: Draw, values: Array) -> Array:
        wanted = [(m, float(x)) for m, x in zip(self.measures, values, strict=True)]
        return draw.reference.pose_near(draw.q, wanted)

    def _velocity(self, draw: Draw, q: Array, j: int) -> Array:
        wanted = [(m, 1.0 if i == j else 0.0) for i, m in enumerate(self.measures)]
        return draw.reference.velocities(q, wanted, with_start=False)

    def _forces(self, draw: Draw, values: Array) -> Array:
        """Q_j at rest."""
        reference, q = draw.reference, self._pose(draw, values)
        rest = reference.snapshot(q, np.zeros_like(q))
        laws = [rest.law(push) for push in self.setup.system.applied_loads]
        found: list[float] = []
        for j in range(len(self.measures)):
            moving = reference.snapshot(q, self._velocity(draw, q, j))
            rates = [moving.rate(push.measure) for push in self.setup.system.applied_loads]
            found.append(float(sum(law * rate for law, rate in zip(laws, rates, strict=True))))
        return np.array(found)

    def _slopes(self, draw: Draw, values: Array) -> Array:
        """dQ_j/dq_k by differences of fourth order."""
        columns: list[Array] = []
        for k in range(len(values)):
            step = np.zeros(len(values))
            step[k] = STEP
            near = self._forces(draw, values + step) - self._forces(draw, values - step)
            far = self._forces(draw, values + 2 * step) - self._forces(draw, values - 2 * step)
            columns.append((8 * near - far) / (12 * STEP))
        return np.array(columns).T

    def _at(self, draw: Draw) -> Array:
        """The equilibrium by Newton's method, from the claimed one."""
        key = id(draw)
        if key not in self._values:
            start = draw.start()
            claimed = [element_at(self.setup, (self.equilibrium[c.index],), draw, start)[0] for c in self._coordinates]
            values = np.array(claimed, dtype=np.float64)
            for _ in range(_STEPS):
                slopes, forces = self._slopes(draw, values), self._forces(draw, values)
                step = np.linalg.lstsq(slopes, -forces, rcond=1e-9)[0]
                values = values + step
                if float(np.abs(step).max(initial=0.0)) < SETTLED * STEP:
                    break
            values[np.abs(values) < ZERO] = 0.0
            self._values[key] = draw, values
        return self._values[key][1]

    @property
    def _coordinates(self) -> tuple[Coordinate, ...]:
        return self.setup.model.coordinates

    def _linear(self, draw: Draw) -> tuple[Array, Array]:
        key = id(draw)
        if key not in self._matrices:
            values = self._at(draw)
            q = self._pose(draw, values)
            moves = np.array([self._velocity(draw, q, j) for j in range(len(values))])
            mass = moves @ (draw.reference.masses[:, None] * moves.T)
            self._matrices[key] = mass, -self._slopes(draw, values)
        return self._matrices[key]
