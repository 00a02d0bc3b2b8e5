"""The equations of motion, M(q) du/dt = F(q, u, t).

With V the velocity of a mass centre and S = dV/du, d'Alembert's principle in Kane's form:

    sum_i S_i^T (m_i A_i) + S_w,i^T I_i alpha_i = sum over loads of law * d(rate of its measure)/du.

Source: Kane & Levinson, Dynamics: Theory and Applications (1985), ch. 6.
"""

from __future__ import annotations

from collections.abc import Callable, Container, Mapping, Sequence
from contextlib import suppress
from functools import cached_property
from itertools import product

from freebody.errors import CannotAnswer, FormulaTooLong
from freebody.language.sentences import Message
from freebody.symbolic.bodies import Bodies, Parts
from freebody.symbolic.configuration import Configuration
from freebody.symbolic.kinematics import SymbolicKinematics
from freebody.symbolic.linear import RHS, Row, solve
from freebody.symbolic.loads import SymbolicLoads
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.samples import Samples
from freebody.symbolic.signs import sign_of
from freebody.symbolic.speeds import Speeds
from freebody.symbolic.unknowns import Coordinate
from freebody.system.system import System


class NothingWithMass(CannotAnswer):
    """A coordinate can change with nothing that has inertia."""


class NotDetermined(NothingWithMass):
    """What is asked depends on how such a coordinate is accelerated: no number tells it, either."""


class SymbolicDynamics:
    """Inertia and forces of a system, each part when it is first asked for."""

    def __init__(
        self,
        system: System,
        bodies: Bodies,
        configuration: Configuration,
        speeds: Speeds,
        kinematics: SymbolicKinematics,
        loads: SymbolicLoads,
        samples: Samples,
        solved_accelerations: Mapping[int, Ratio] | None = None,
    ) -> None:
        """solved_accelerations: taken instead of those that follow from the forces."""
        self._system, self._bodies, self._configuration = system, bodies, configuration
        self._speeds, self._kinematics, self._loads = speeds, kinematics, loads
        self._samples = samples
        self.field = bodies.field
        if solved_accelerations is not None:
            self.solved_accelerations = solved_accelerations

    # -- momentum of the bodies ---------------------------------------------------------------
    @cached_property
    def inertias(self) -> dict[str, Parts]:
        """The entries of the mass matrix of every body: in the plane along its slots; in space the mass three times,
        then the tensor (xx, yy, zz, xy, xz, yz)."""
        scalar = self._configuration.geometry.scalar
        return {b.name: self._bodies.inertia(b, scalar) for b in self._system.all_moving}

    def momentum(self, body: str, velocity: Parts) -> Parts:
        """The mass matrix of a body times a velocity of its, along its slots."""
        return self._bodies.momentum(self.inertias[body], velocity)

    def turning_momentum(self, body: str) -> Parts:
        """What the rate of a body's momentum has beside mass times acceleration: nothing in the plane, omega x I omega
        in space."""
        return self._bodies.turning_momentum(self.inertias[body], self._kinematics.velocities[body])

    def inertia_force(self, body: str, acceleration: Sequence[Ratio]) -> Parts:
        """The rate of a body's momentum, along its slots."""
        changing = self.momentum(body, tuple(acceleration))
        return tuple(p + q for p, q in zip(changing, self.turning_momentum(body), strict=True))

    # -- equations of motion ------------------------------------------------------------------
    @property
    def mass_matrix(self) -> list[list[Ratio]]:
        """Raises FormulaTooLong."""
        if isinstance(self._mass_matrix, FormulaTooLong):
            raise self._mass_matrix
        return self._mass_matrix

    @cached_property
    def _mass_matrix(self) -> list[list[Ratio]] | FormulaTooLong:
        """That it is too long is found once."""
        try:
            return self._made_mass_matrix()
        except FormulaTooLong as error:
            return error

    def _made_mass_matrix(self) -> list[list[Ratio]]:
        n = len(self._speeds.coordinates)
        f = self.field
        M = [[f.zero] * n for _ in range(n)]
        for name, partials in self._kinematics.partial_velocities.items():
            momenta = [self.momentum(name, partial) for partial in partials]
            for slot in range(len(self._bodies.slots)):
                for j in range(n):
                    weighted = momenta[j][slot]
                    if weighted.is_zero():
                        continue
                    for k in range(j, n):
                        if not partials[k][slot].is_zero():
                            M[j][k] = f.lowest_terms(M[j][k] + weighted * partials[k][slot])
        for j in range(n):
            for k in range(j):
                M[j][k] = M[k][j]
        return M

    def mass_matrix_in(self, here: Callable[[Ratio], Ratio]) -> list[list[Ratio]]:
        """The mass matrix where elements are as `here` has them: in one pose it is made there where it is too long in
        general."""
        with suppress(FormulaTooLong):
            return [[here(x) for x in row] for row in self.mass_matrix]
        n, f = len(self._speeds.coordinates), self.field
        M = [[f.zero] * n for _ in range(n)]
        for name, partials in self._kinematics.partial_velocities.items():
            inertia = tuple(map(here, self.inertias[name]))
            placed = [tuple(map(here, partial)) for partial in partials]
            momenta = [self._bodies.momentum(inertia, partial) for partial in placed]
            for j, k in product(range(n), repeat=2):
                M[j][k] = sum((p * v for p, v in zip(momenta[j], placed[k], strict=True)), M[j][k])
        return [[f.lowest_terms(x) for x in row] for row in M]

    @property
    def parts_of_inertia(self) -> list[Ratio]:
        """The entries of the mass matrix, or where they are too long what it is made of."""
        with suppress(FormulaTooLong):
            return [x for row in self.mass_matrix for x in row]
        made_of = [part for partials in self._kinematics.partial_velocities.values() for p in partials for part in p]
        return [*made_of, *(part for parts in self.inertias.values() for part in parts)]

    @cached_property
    def moves_no_mass(self) -> bool:
        """Whether something can move, and nothing that can has mass."""
        moved = self._kinematics.partial_velocities.items() if self._speeds.coordinates else ()
        return bool(moved) and all(p.is_zero() for b, partials in moved for v in partials for p in self.momentum(b, v))

    @cached_property
    def vanishing_inertia(self) -> Ratio | None:
        """What of one freedom moves no mass where it vanishes, as a piston in its dead point beside a massless crank:
        there is no acceleration there. None where there is always some."""
        if len(self._speeds.coordinates) != 1:
            return None
        moved: list[Ratio] = []
        for name, (partial,) in self._kinematics.partial_velocities.items():
            for p, v in zip(self.momentum(name, partial), partial, strict=True):
                if sign_of(p * v).is_strict:
                    return None
                if not p.is_zero():
                    moved.append(v)
        if len(moved) == 1:
            return moved[0]
        with suppress(FormulaTooLong):
            mass = self.mass_matrix[0][0]
            return None if sign_of(mass).is_strict or mass.is_zero() else mass  # nowhere any: see open_accelerations
        return None

    def generalized_force(self, c: Coordinate) -> Ratio:
        """Along an independent coordinate: the sum of law times d(rate of the measure)/du over all loads."""
        f, k, total = self.field, self._speeds.coordinates.index(c), self.field.zero
        for body, wrench in self._loads.wrenches.items():
            for part, slope in zip(wrench, self._kinematics.partial_velocities[body][k], strict=True):
                total = total + part * slope
        return f.lowest_terms(total)

    @cached_property
    def forcing(self) -> list[Ratio]:
        """F of M du/dt = F: generalized forces of the loads minus the velocity terms of the inertia."""
        f = self.field
        still = dict.fromkeys(self._speeds.accelerations, f.zero)
        forces = [f.zero for _ in self._speeds.coordinates]
        for name, wrench in self._loads.wrenches.items():
            bias = [f.substitute(a, still) for a in self._kinematics.body_accelerations[name]]
            push = [w - p for w, p in zip(wrench, self.inertia_force(name, bias), strict=True)]
            for k, partial in enumerate(self._kinematics.partial_velocities[name]):
                for p, s in zip(push, partial, strict=True):
                    if not s.is_zero() and not p.is_zero():
                        forces[k] = f.lowest_terms(forces[k] + p * s)
        return forces

    @cached_property
    def forcing_near_rest(self) -> list[Ratio]:
        """F, or where that is too long what is left of it without terms of second order in the speeds. Where nothing is
        driven, that is the velocity terms of the inertia: they are homogeneous of that order."""
        try:
            return self.forcing
        except FormulaTooLong:
            if not self._is_still_without_speeds:
                raise
            return [self.generalized_force(c) for c in self._speeds.coordinates]

    @property
    def _is_still_without_speeds(self) -> bool:
        """Whether nothing moves where the speeds of the coordinates vanish: nothing is driven."""
        f, speeds = self.field, self._speeds
        still = {c.speed: f.zero for c in (*speeds.coordinates, *speeds.dependent)}
        moved = [part for v in self._kinematics.velocities.values() for part in v]
        moved += [speeds.dependent_speed(d) for d in speeds.dependent]
        return all(f.substitute(x, still).is_zero() for x in moved)

    @cached_property
    def solved_accelerations(self) -> Mapping[int, Ratio]:
        """du/dt in coordinates, speeds and time, by acceleration generator."""
        return self.accelerations_in(lambda x: x)

    @cached_property
    def open_accelerations(self) -> Mapping[int, Ratio]:
        """The same, in which what moves nothing with mass, and is pushed by nothing, stands for itself: the roll of a
        thin rod about its axis."""
        try:
            return self.solved_accelerations
        except NothingWithMass:
            return self.accelerations_in(lambda x: x, leaves_open=True)

    def determined(self, x: Ratio) -> Ratio:
        """What is told by `open_accelerations`. Raises NotDetermined where it depends on one that is open."""
        is_open = self._left_open & self.field.ingredients(x) if self._left_open else None
        if is_open:
            raise NotDetermined(self.nothing_moves(is_open))
        return x

    @cached_property
    def _left_open(self) -> frozenset[int]:
        """The accelerations that stand for themselves; elsewhere they may be names of what they come to."""
        f, found = self.field, self.open_accelerations
        if "solved_accelerations" in vars(self):
            return frozenset()
        return frozenset(a for a, x in found.items() if (x - f.variable(a)).is_zero())

    def accelerations_in(self, here: Callable[[Ratio], Ratio], *, leaves_open: bool = False) -> Mapping[int, Ratio]:
        """du/dt where elements are as `here` has them: in one pose short where they are long in general. leaves_open:
        see `open_accelerations`."""
        accelerations = self._speeds.accelerations
        rows: list[Row] = []
        for line, force in zip(self.mass_matrix, self.forcing, strict=True):
            row: Row = {a: x for a, m in zip(accelerations, line, strict=True) if not (x := here(m)).is_zero()}
            if not (x := here(force)).is_zero():
                row[RHS] = x
            rows.append(row)
        solved = solve(self.field, rows, accelerations, self._samples.vanishes)
        if solved.free and (solved.contradictory or not leaves_open):
            raise NothingWithMass(self.nothing_moves(solved.free))
        f = self.field
        found = {a: f.variable(a) for a in solved.free}
        for a, row in solved.pivots.items():
            others = (x * f.variable(c) for c, x in row.items() if c != RHS)
            found[a] = sum(others, row.get(RHS, f.zero))
        return {a: found[a] for a in accelerations}

    def nothing_moves(self, free: Container[int]) -> Message:
        named = zip(self._speeds.coordinates, self._speeds.accelerations, strict=True)
        return Message(
            "nothing with mass moves with {x}, so its acceleration is not determined. Give the body "
            "a mass or an inertia, or connect it, or prescribe how it moves by a driver",
            x=", ".join(c.name for c, a in named if a in free),
        )
