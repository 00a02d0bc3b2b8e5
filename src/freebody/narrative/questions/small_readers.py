"""How the numeric route reads small motions of one draw: the equilibrium, mass and stiffness along the coordinates.

With e_j the velocities in which coordinate j changes at unit rate and no other one does,

    M_jk = e_j . m e_k,    Q_j = sum of loads * (rate of their measures with e_j),    K_jk = -dQ_j/dq_k.

Where connections bind velocities alone, as in rolling in space, values of the coordinates do not say where the bodies
are: from the equilibrium, with what is bound there put in, the pose goes along e_k, to first order, whose errors of
second order cancel in differences.

Modes are numbered as the formulas of their squares are. Which of two is slower depends on the numbers, so a mode
is found among the numbers by the place that its formula has by size in that draw.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence

import numpy as np

from freebody.errors import CannotAnswer
from freebody.language.sentences import Message
from freebody.measures.base import Measure
from freebody.model.elements import NonholonomicForm
from freebody.narrative.lines.glossary import World
from freebody.numeric.jets import Array
from freebody.numeric.linearised import basis_of_shapes, generalized_modes
from freebody.numeric.placing import PoseEquation
from freebody.numeric.reference import Reference
from freebody.study.answering.at_equilibrium import frequencies_at, instants, is_driven
from freebody.study.answering.crosscheck import element_at
from freebody.study.answering.draws import Draw
from freebody.study.setup import Setup
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.unknowns import Coordinate

STEP = 1e-3  # rad, m
SETTLED = 1e-5  # of a step, that an equilibrium may still move by
ZERO = 1e-11  # rad, m
_STEPS = 4


class SmallMotions:
    """Reads by draws. equilibrium: the claimed values of the coordinates, from which the true ones are looked for.
    squares: of the claimed frequencies, which number the modes."""

    def __init__(
        self, setup: Setup, equilibrium: Mapping[int, Ratio], squares: Callable[[], Sequence[Ratio]] = tuple
    ) -> None:
        self.setup, self.equilibrium, self._squares = setup, equilibrium, squares
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
        binds_velocities = any(isinstance(row.measure, NonholonomicForm) for row in setup.system.constraint_rows)
        followers = [d for d in setup.model.dependent if binds_velocities and d.index in equilibrium]
        known = [(setup.model.measure_of(d), d) for d in followers]
        self._followers = [(measure, d) for measure, d in known if measure is not None]
        self._rests: dict[int, tuple[Draw, Array, Array]] = {}
        draw = setup.draws[0]
        self._is_driven = is_driven(setup, draw.reference.velocities(draw.q, self._rates(-1), with_start=False))

    def _rates(self, j: int) -> list[tuple[Measure, float]]:
        """Rates of the coordinates of which one is 1."""
        return [(m, 1.0 if i == j else 0.0) for i, m in enumerate(self.measures)]

    # -- readers ------------------------------------------------------------------------------
    def value(self, k: int) -> Callable[[World], float]:
        """A coordinate at the equilibrium."""
        return lambda world: float(self._at(world.draw)[k])

    def follower(self, dependent: Coordinate) -> Callable[[World], float]:
        """A coordinate at the equilibrium that closed loops bind there."""
        measure = self.setup.model.measure_of(dependent)
        if measure is None:
            raise CannotAnswer(
                Message("{x} is no measure of the model, so small motions along it cannot be checked", x=dependent.name)
            )

        def read(world: World) -> float:
            q = self.pose(world.draw)
            return float(world.draw.reference.snapshot(q, world.draw.reference.velocities(q)).value(measure))

        return read

    def mass(self, j: int, k: int) -> Callable[[World], float]:
        return lambda world: float(self._linear(world.draw)[0][j, k])

    def stiffness(self, j: int, k: int) -> Callable[[World], float]:
        return lambda world: float(self._linear(world.draw)[1][j, k])

    def damping(self, j: int, k: int) -> Callable[[World], float]:
        return lambda world: float(self._dampings(world.draw)[j, k])

    def swing(self, j: int, quarter: int) -> Callable[[World], float]:
        """What the force along a coordinate swings by: its cosine (0), its sine (1)."""

        def read(world: World) -> float:
            draw = world.draw
            start, half = instants(self.setup, draw)
            there = [self._forces_at(draw, self._at(draw), t)[j] for t in (start, half / 2 if quarter else start, half)]
            return float(there[1] - (there[0] + there[2]) / 2)

        return read

    def part(self, k: int, j: int) -> Callable[[World], float]:
        """A part of a mode, the first that moves being 1."""

        def read(world: World) -> float:
            mass, stiffness = self._linear(world.draw)
            places = [self._place(world.draw, i) for i in self._alike(k)]
            v = generalized_modes(mass, stiffness)[1][:, places]
            return float(basis_of_shapes(v, v.T @ mass @ v)[j, self._alike(k).index(k)])

        return read

    def amplitude(self, k: int, measure: Measure) -> Callable[[World], float]:
        """Of a measure in a mode."""
        parts = [self.part(k, j) for j in range(len(self.measures))]

        def read(world: World) -> float:
            q = self.pose(world.draw)
            moves = (part(world) * self._velocity(world.draw, q, j) for j, part in enumerate(parts))
            return float(world.draw.reference.snapshot(q, sum(moves, start=0.0 * q)).rate(measure))

        return read

    def exponent(self, k: int, n: int) -> Callable[[World], float]:
        """The squares of the exponents that are not zero, ascending: the n largest by size."""

        def read(world: World) -> float:
            mass, stiffness = self._linear(world.draw)
            squares: list[float] = generalized_modes(mass, stiffness)[0].tolist()
            return sorted(-x for x in sorted(squares, key=abs)[-n:])[k]

        return read

    def damped(self, what: str, k: int) -> Callable[[World], float]:
        """Damping ratio, quality factor, damped frequency or period, decrement of the k-th motion that swings."""

        def read(world: World) -> float:
            mass, stiffness = self._linear(world.draw)
            n = len(mass)
            turned = [-np.linalg.solve(mass, x) for x in (stiffness, self._dampings(world.draw))]
            A = np.block([[np.zeros((n, n)), np.eye(n)], turned])
            rates = np.linalg.eigvals(A)
            swinging: list[complex] = sorted((s for s in rates.tolist() if s.imag > 0), key=abs)
            if not swinging and what in ("ratio", "quality"):
                a, b = sorted(rates.real)[:2]
                ratio = float(-(a + b) / (2 * np.sqrt(a * b)))
                return ratio if what == "ratio" else 1 / (2 * ratio)
            s = swinging[k]
            return {
                "ratio": -s.real / abs(s),
                "quality": -abs(s) / (2 * s.real),
                "frequency": s.imag,
                "period": 2 * np.pi / s.imag,
                "decrement": -2 * np.pi * s.real / s.imag,
            }[what]

        return read

    def slope(self, world: World) -> float:
        """K/M of one coordinate."""
        mass, stiffness = self._linear(world.draw)
        return float(stiffness[0, 0] / mass[0, 0])

    def frequency(self, k: int) -> Callable[[World], float]:
        """The natural frequency of the full system about the equilibrium that the k-th formula is of."""
        return lambda world: float(np.sort(self._frequencies(world.draw))[self._place(world.draw, k)])

    def _alike(self, k: int) -> list[int]:
        """The modes with the frequency of the k-th one."""
        squares = self._squares()
        return [i for i, x in enumerate(squares) if x == squares[k]] if k < len(squares) else [k]

    def _place(self, draw: Draw, k: int) -> int:
        """By size in this draw, of the k-th of the claimed squares; equal ones keep their order."""
        squares = self._squares()
        if len(squares) < 2:
            return k
        start = draw.start()
        values = [element_at(self.setup, (square,), draw, start)[0] for square in squares]
        return sorted(range(len(values)), key=lambda j: values[j]).index(k)

    def _frequencies(self, draw: Draw) -> Array:
        return frequencies_at(self.setup, draw, list(zip(self.measures, map(float, self._at(draw)), strict=True)))

    def pose(self, draw: Draw) -> Array:
        return self._pose(draw, self._at(draw))

    # -- numbers ------------------------------------------------------------------------------
    def _pose(self, draw: Draw, values: Array, t: float = 0.0) -> Array:
        wanted = [(m, float(x)) for m, x in zip(self.measures, values, strict=True)]
        if not self._followers:
            return draw.reference.pose_near(draw.q, wanted, t)
        claimed, q = self._rest(draw)
        moves = [self._velocity(draw, q, j) for j in range(len(values))]
        beside = sum((x * move for x, move in zip(values - claimed, moves, strict=True)), start=0.0 * moves[0])
        return self._pinned(draw.reference, q, beside, t)

    @staticmethod
    def _pinned(reference: Reference, q: Array, beside: Array, t: float) -> Array:
        """The pose beside q by a small move, in which everything that q holds is still held: the components of the move
        along what connections of places leave free are kept, see `numeric.linearised`."""
        free = reference.split_at(q, reference.branches).null
        back = free.T / reference.sizes.small_moves**2
        pinned = [PoseEquation.along(row, q, float(row @ beside)) for row in back]
        equations = reference.held_where(q, 0.0) + pinned
        return reference.placing.placed(reference.frame.moved(q, beside), equations, t, reference.branches).q

    def _rest(self, draw: Draw) -> tuple[Array, Array]:
        """The claimed values of the coordinates, and the pose with all that is claimed."""
        if id(draw) not in self._rests:
            claimed = self._claimed(draw, self._coordinates)
            measures = [*self.measures, *(measure for measure, _d in self._followers)]
            values = [*claimed, *self._claimed(draw, [d for _measure, d in self._followers])]
            q = draw.reference.pose_near(draw.q, [(m, float(x)) for m, x in zip(measures, values, strict=True)])
            self._rests[id(draw)] = draw, claimed, q
        return self._rests[id(draw)][1:]

    def _claimed(self, draw: Draw, coordinates: Sequence[Coordinate]) -> Array:
        start = draw.start()
        found = [element_at(self.setup, (self.equilibrium[c.index],), draw, start)[0] for c in coordinates]
        return np.array(found, dtype=np.float64)

    def _velocity(self, draw: Draw, q: Array, j: int, t: float = 0.0) -> Array:
        """In which coordinate j alone changes, at unit rate, and nothing is driven."""
        moving, driven = (draw.reference.velocities(q, self._rates(k), t, with_start=False) for k in (j, -1))
        return moving - driven

    def _forces(self, draw: Draw, values: Array) -> Array:
        """Q_j at rest, of what swings the mean."""
        times = instants(self.setup, draw)
        return sum((self._forces_at(draw, values, t) for t in times), start=np.zeros(len(values))) / len(times)

    def _forces_at(self, draw: Draw, values: Array, t: float, u: Array | None = None) -> Array:
        """F_j of M u' = F, the coordinates having the rates u: the loads, and what is driven by M times the
        accelerations."""
        reference, n = draw.reference, len(self.measures)
        q = self._pose(draw, values, t)
        moves = [self._velocity(draw, q, j, t) for j in range(n)]
        v = reference.velocities(q, self._rates(-1), t, with_start=False)
        v = v + sum((x * move for x, move in zip([] if u is None else u, moves, strict=False)), start=0.0 * v)
        here = reference.snapshot(q, v, t)
        if self._is_driven:
            seen = draw.seen(here)
            accelerations = np.array([seen.acceleration(m) for m in self.measures])
            return self._inertia(draw, moves) @ accelerations
        laws = [here.law(push) for push in self.setup.system.applied_loads]
        found: list[float] = []
        for move in moves:
            moving = reference.snapshot(q, move, t)
            rates = [moving.rate(push.measure) for push in self.setup.system.applied_loads]
            found.append(float(sum(law * rate for law, rate in zip(laws, rates, strict=True))))
        return np.array(found)

    @staticmethod
    def _inertia(draw: Draw, moves: Sequence[Array]) -> Array:
        """M_jk = e_j . m e_k"""
        N = np.array(moves)
        return N @ (draw.reference.masses[:, None] * N.T)

    def _dampings(self, draw: Draw) -> Array:
        """-dQ_j/du_k at the equilibrium; laws are linear in small speeds."""
        values = self._at(draw)
        unit = np.eye(len(values))
        columns = [self._forces_at(draw, values, 0.0, e * row) for row in unit for e in (STEP, -STEP)]
        return np.array([(b - a) / (2 * STEP) for a, b in zip(columns[::2], columns[1::2], strict=True)]).T

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
            values = self._claimed(draw, self._coordinates)
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
            mass = self._inertia(draw, list(moves))
            self._matrices[key] = mass, -self._slopes(draw, values)
        return self._matrices[key]
