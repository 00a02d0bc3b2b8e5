"""Friction at rest in a plane: the resultant of two rows stays within a circle, and slip begins against it.

    T_1^2 + T_2^2 <= (c L)^2,        slipping: T = -c L u,  u = a/|a|,  a = (a_1, a_2) the acceleration of the slip

A flat end of radius R whose moment T has L = N the normal force and c = R lifts its middle as it tips: the gap that N
closes is a_N - R |a|, that of the lowest point of its rim. Then forces and accelerations are in dual cones, as they are
for points of the rim one by one, and the moment does no work.

A projected Gauss-Seidel iteration comes near to forces that obey this: every normal force in turn is made such that its
row does not accelerate, or zero; every friction is moved against its slip, and put back to the edge of its circle. What
it ends near says which rows are closed, stick or slip. With that the law is a system of equations, with the angle of
each slip as one more unknown, which Newton's method solves from there; where forces are not unique it takes the ones
that are nearest. Whatever was proposed, every condition is checked. Sources: Jourdan, Alart & Jean, Comput. Methods
Appl. Mech. Engrg. 155 (1998) 31-47; Acary & Brogliato, Numerical Methods for Nonsmooth Dynamical Systems, 2008, ch. 13.
"""

from __future__ import annotations

import math
from collections.abc import Collection, Iterable, Sequence
from dataclasses import dataclass, replace

import numpy as np

from freebody.numeric.contact.problem import (
    Array,
    Choice,
    ContactProblem,
    ForceOutcome,
    FrictionProblemRow,
    Mode,
    OutcomeCount,
    RowState,
)
from freebody.numeric.contact.reduction import ReducedFriction, ReducedProblem, direction, magnitude_slope, reduced
from freebody.tolerances import LEAST, ROUNDED

_SWEEPS = 4000
_NEAR = 1e-13  # of the largest force: what a sweep changes no more
# of a limit: what is missing from it, and a normal force that is none, by the largest; the next where one misleads
_AT_LIMIT = (1e-8, 1e-6, 1e-10, 1e-4)
_STEPS = 30
_SOLVED = 1e-10  # of the terms of a row: what its equation, or an inequality, may miss


def is_flat(problem: ContactProblem) -> bool:
    """Whether all friction acts along lines."""
    return all(rub.across < 0 for rub in problem.dry_friction)


def pointed(problem: ContactProblem, forbidden: Iterable[Choice] = ()) -> ForceOutcome:
    """The outcome of a problem with friction in planes; `directions` says where slip goes. It is not proven to be the
    only one. forbidden: states a row must not have."""
    banned, kinetic = frozenset(forbidden), frozenset[int]()
    cones = [rub for rub in problem.dry_friction if rub.across >= 0]
    while True:
        system = reduced(_along_lines(problem, cones, kinetic))
        if not system.is_consistent:
            return _nothing(problem, OutcomeCount.NONE)
        search = _Search(system, {rub.row: rub.across for rub in cones}, banned)
        found = search.found()
        if found is None:
            return _nothing(problem, OutcomeCount.NOT_FOUND)
        mode, solution = found
        # what starts to slip does so with its kinetic coefficient for good
        slips = {rub.row for rub in cones if mode[search.place[rub.row]] is RowState.FORWARD}
        if slips <= kinetic or all(rub.static == rub.kinetic for rub in cones if rub.row in slips - kinetic):
            return _outcome(problem, search, mode, *solution)
        kinetic |= slips


def _along_lines(
    problem: ContactProblem, cones: Sequence[FrictionProblemRow], kinetic: Collection[int]
) -> ContactProblem:
    """The same rows, those across with a friction of their own, by which their loads are known."""
    rubs = [rub if rub.row not in kinetic else replace(rub, static=rub.kinetic) for rub in problem.dry_friction]
    across = [replace(rub, row=rub.across) for rub in rubs if rub.across >= 0]
    return replace(problem, dry_friction=tuple(replace(rub, across=-1) for rub in (*rubs, *across)))


@dataclass(frozen=True)
class _Plane:
    """Friction in a plane: its two reduced frictions, and the scales of their forces."""

    along: ReducedFriction
    across: ReducedFriction
    scales: Array  # (2,)

    @property
    def rows(self) -> list[int]:
        return [self.along.row, self.across.row]

    def limit(self, x: list[float]) -> float:
        """c L, of the force itself."""
        return max(0.0, self.along.rub.static[0] * self.along.load(x) * float(self.scales[0]))


class _Search:
    """A problem without its held rows, the forces that obey it and the mode of these."""

    def __init__(self, system: ReducedProblem, across: dict[int, int], banned: frozenset[Choice]) -> None:
        self.system, self.banned, self.near = system, banned, _AT_LIMIT[0]
        self.place = {int(row): k for k, row in enumerate(system.rows)}
        by_row = {friction.rub.row: friction for friction in system.frictions}
        self.planes = [
            _Plane(by_row[row], by_row[other], system.scale[[self.place[row], self.place[other]]])
            for row, other in across.items()
        ]
        self.lifting = {plane.along.normals[0]: plane for plane in self.planes if plane.along.rub.lifts}
        second = set(across.values()) | set(across)
        self.lines = [friction for friction in system.frictions if friction.rub.row not in second]

    def found(self) -> tuple[Mode, tuple[Array, dict[int, float]]] | None:
        """A mode and its forces, by the first tolerance with which what is near tells the right mode."""
        near = self.swept()
        for self.near in _AT_LIMIT:
            mode, x = self.mode(near)
            solution = self.solved(mode, x)
            if solution is not None:
                return mode, solution
        return None

    # -- an iteration that comes near ---------------------------------------------------------
    def swept(self) -> Array:
        """(n_free,) forces by projected Gauss-Seidel sweeps."""
        A, b = self.system.A, self.system.b
        x = np.zeros(len(b))
        for _ in range(_SWEEPS):
            before = x.copy()
            for i in range(self.system.n_normals):
                x[i] = max(0.0, x[i] - self._opening(i, x) / self._yielding(i))
            for line in self.lines:
                load, rub, i = max(0.0, line.load(x.tolist(), x)), line.rub, line.row
                if rub.sliding:
                    x[i] = -rub.sliding * rub.kinetic[rub.sliding < 0] * load
                else:
                    x[i] = min(max(x[i] - float(A[i] @ x + b[i]), -rub.static[0] * load), rub.static[1] * load)
            for plane in self.planes:
                rows = plane.rows
                slip = (A[rows] @ x + b[rows]) / plane.scales
                force = plane.scales * x[rows] - slip / float((plane.scales**-2.0).sum())
                size = math.hypot(*force.tolist())
                limit = plane.limit(x.tolist())
                x[rows] = force * (1.0 if size <= limit else limit / size) / plane.scales
            if np.abs(x - before).max(initial=0.0) <= _NEAR * np.abs(x).max(initial=0.0):
                break
        return x

    def mode(self, x: Array) -> tuple[Mode, Array]:
        """What the rows do by forces that are nearly right, and these without what is none."""
        x = x.copy()
        states = [RowState.ABSENT] * len(x)
        small = self.near * float(np.abs(x).max(initial=0.0))
        for i in range(self.system.n_normals):
            is_closed = x[i] > small or (i, RowState.OPEN) in self._banned_places
            states[i] = RowState.CLOSED if is_closed or self._rests(i, x) else RowState.OPEN
        for line in self.lines:
            states[line.row] = self._of_line(line, x, states, small)
        for plane in self.planes:
            load, force = plane.limit(x.tolist()), plane.scales * x[plane.rows]
            state = RowState.STICKING
            if not self._is_pressed(plane.along, states):
                state = RowState.ABSENT
            elif (plane.along.row, RowState.STICKING) in self._banned_places:
                state = RowState.FORWARD
            elif (plane.along.row, RowState.FORWARD) not in self._banned_places:
                at_limit = math.hypot(*force.tolist()) >= (1.0 - self.near) * load
                state = RowState.FORWARD if at_limit and not self._stays(plane, x) else RowState.STICKING
            for row in plane.rows:
                states[row] = state
        for i, state in enumerate(states):
            if state in (RowState.OPEN, RowState.ABSENT):
                x[i] = 0.0
        return tuple(states), x

    @property
    def _banned_places(self) -> set[tuple[int, RowState]]:
        return {(self.place[row], state) for row, state in self.banned if row in self.place}

    def _of_line(self, line: ReducedFriction, x: Array, states: Sequence[RowState], small: float) -> RowState:
        if not self._is_pressed(line, states):
            return RowState.ABSENT
        rub, load = line.rub, line.load(x.tolist(), x)
        if rub.sliding:
            return RowState.FORWARD if rub.sliding > 0 else RowState.BACKWARD
        for state, limit in ((RowState.FORWARD, -rub.static[0] * load), (RowState.BACKWARD, rub.static[1] * load)):
            if abs(x[line.row] - limit) <= small and abs(self._acceleration(line.row, x)) > small:
                return state
        return RowState.STICKING

    def _is_pressed(self, friction: ReducedFriction, states: Sequence[RowState]) -> bool:
        return friction.is_always_loaded or any(states[j] is RowState.CLOSED for j in friction.normals)

    def _acceleration(self, i: int, x: Array) -> float:
        return float(self.system.A[i] @ x + self.system.b[i])

    def _opening(self, i: int, x: Array) -> float:
        """The acceleration of a gap: of a flat end that of the lowest point of its rim."""
        a = self._acceleration(i, x)
        plane = self.lifting.get(i)
        if plane is None:
            return a
        slip = (self.system.A[plane.rows] @ x + self.system.b[plane.rows]) / plane.scales
        return a - self._lift(plane) * math.hypot(*slip.tolist())

    def _lift(self, plane: _Plane) -> float:
        """By how much the row of its normal opens with the slip of a plane: c, scaled as that row is."""
        return plane.along.rub.static[0] * float(self.system.scale[plane.along.normals[0]])

    def _yielding(self, i: int) -> float:
        """By how much a gap opens for a unit of its force, whose moment is that of the rim."""
        plane = self.lifting.get(i)
        return 1.0 if plane is None else 1.0 + float(((self._lift(plane) / plane.scales) ** 2).max())

    def _none(self, i: int, x: Array) -> float:
        """An acceleration of a row that is none."""
        return self.near * float(self.system.magnitude[i] @ np.abs(x) + self.system.size[i])

    def _rests(self, i: int, x: Array) -> bool:
        """Whether what is not pressed does not open either."""
        return abs(self._opening(i, x)) <= self._none(i, x)

    def _stays(self, plane: _Plane, x: Array) -> bool:
        """Whether friction at its limit does not let go either."""
        return all(abs(self._acceleration(i, x)) <= self._none(i, x) for i in plane.rows)

    # -- the equations of a mode --------------------------------------------------------------
    def solved(self, mode: Mode, x: Array) -> tuple[Array, dict[int, float]] | None:
        """(n_free,) forces of a mode from ones that are near, and the angles of what slips, by the row along; None
        where they break a condition."""
        slipping = [plane for plane in self.planes if mode[plane.along.row] is RowState.FORWARD]
        angles, n = np.array([self._heading(plane, x) for plane in slipping]), len(x)
        for _ in range(_STEPS):
            E, e = self._equations(mode, x, slipping, angles)
            sizes = np.abs(E).max(axis=1, initial=LEAST)
            step: Array = np.asarray(
                np.linalg.lstsq(E / sizes[:, None], -e / sizes, rcond=ROUNDED)[0], dtype=np.float64
            )
            x, angles = x + step[:n], angles + step[n:]
            if np.abs(step[:n]).max(initial=0.0) <= _NEAR * np.abs(x).max(initial=0.0):
                break
        if not np.isfinite(x).all() or not self._obeys(mode, x, slipping, angles):
            return None
        return x, {plane.along.rub.row: float(angle) for plane, angle in zip(slipping, angles, strict=True)}

    def _heading(self, plane: _Plane, x: Array) -> float:
        """The angle against the force of a plane; where that is none, of its slip."""
        rows = plane.rows
        force = -plane.scales * x[rows]
        if math.hypot(*force.tolist()) <= self.near * float(np.abs(self.system.scale * x).max()):
            force = (self.system.A[rows] @ x + self.system.b[rows]) / plane.scales
        return math.atan2(force[1], force[0])

    def _equations(self, mode: Mode, x: Array, slipping: Sequence[_Plane], angles: Array) -> tuple[Array, Array]:
        """Slopes (n + n_slipping, n + n_slipping) and values of what must vanish."""
        A, n, m = self.system.A, len(x), len(slipping)
        E, e = np.zeros((n + m, n + m)), np.zeros(n + m)
        E[:n, :n], e[:n] = A, A @ x + self.system.b
        for i, state in enumerate(mode):
            if state in (RowState.OPEN, RowState.ABSENT):
                E[i], e[i] = 0.0, x[i]
                E[i, i] = 1.0
        for line in self.lines:
            state = mode[line.row]
            if state in (RowState.FORWARD, RowState.BACKWARD):
                pair = line.rub.kinetic if line.rub.sliding else line.rub.static
                c = pair[0] if state is RowState.FORWARD else -pair[1]
                load, slope = _load(line, x)
                E[line.row], e[line.row] = 0.0, x[line.row] + c * load
                E[line.row, :n] = c * slope
                E[line.row, line.row] += 1.0
        for k, (plane, angle) in enumerate(zip(slipping, angles.tolist(), strict=True)):
            c = plane.along.rub.static[0]
            u, turned = (math.cos(angle), math.sin(angle)), (-math.sin(angle), math.cos(angle))
            for friction, part, change in zip((plane.along, plane.across), u, turned, strict=True):
                load, slope = _load(friction, x)
                i = friction.row
                E[i], e[i] = 0.0, x[i] + c * part * load
                E[i, :n] = c * part * slope
                E[i, i] += 1.0
                E[i, n + k] = c * change * load
            slip = (A[plane.rows] @ x + self.system.b[plane.rows]) / plane.scales
            i = plane.along.normals[0] if plane.along.rub.lifts else -1
            if i >= 0 and mode[i] is RowState.CLOSED:
                lift = self._lift(plane)
                E[i, :n] -= lift * ((np.array(u) / plane.scales) @ A[plane.rows])
                e[i] -= lift * float(np.array(u) @ slip)
                E[i, n + k] -= lift * float(np.array(turned) @ slip)
            E[n + k, :n] = (np.array(turned) / plane.scales) @ A[plane.rows]
            E[n + k, n + k], e[n + k] = -float(np.array(u) @ slip), float(np.array(turned) @ slip)
        return E, e

    def _obeys(self, mode: Mode, x: Array, slipping: Sequence[_Plane], angles: Array) -> bool:
        """Whether forces meet every condition of a mode."""
        system = self.system
        a, sizes = system.A @ x + system.b, system.magnitude @ np.abs(x) + system.size
        slack = _SOLVED * (sizes + 1e-3 * sizes.max(initial=0.0))
        small = _AT_LIMIT[0] * float(np.abs(x).max(initial=0.0))
        for i in range(system.n_normals):
            opening = self._opening(i, x)
            if mode[i] is RowState.CLOSED and (x[i] < -small or abs(opening) > slack[i]):
                return False
            if mode[i] is RowState.OPEN and opening < -slack[i]:
                return False
        for line in self.lines:
            if not _line_obeys(line, mode[line.row], x, a, float(slack[line.row]), small):
                return False
        rates = {id(plane): angle for plane, angle in zip(slipping, angles.tolist(), strict=True)}
        for plane in self.planes:
            rows, state = plane.rows, mode[plane.along.row]
            if state is RowState.STICKING:
                size = math.hypot(*(plane.scales * x[rows]).tolist())
                if (
                    size > plane.limit(x.tolist()) + small * float(plane.scales.max())
                    or (abs(a[rows]) > slack[rows]).any()
                ):
                    return False
            elif state is RowState.FORWARD:
                u, slip = np.array((math.cos(rates[id(plane)]), math.sin(rates[id(plane)]))), a[rows] / plane.scales
                miss = float((slack[rows] / plane.scales).max())
                if u @ slip < -miss or abs(u[0] * slip[1] - u[1] * slip[0]) > miss:
                    return False
        return True


def _load(friction: ReducedFriction, x: Array) -> tuple[float, Array]:
    """L and its slopes."""
    slope = np.zeros(len(x))
    for j, weight in friction.pressing:
        slope[j] += weight
    for group in friction.groups:
        slope += magnitude_slope(group, direction(group, x))[1]
    return friction.load(x.tolist(), x), slope


def _line_obeys(line: ReducedFriction, state: RowState, x: Array, a: Array, slack: float, small: float) -> bool:
    i, rub = line.row, line.rub
    if state is RowState.STICKING:
        load = line.load(x.tolist(), x)
        return -rub.static[0] * load - small <= x[i] <= rub.static[1] * load + small and abs(a[i]) <= slack
    if state in (RowState.FORWARD, RowState.BACKWARD) and not rub.sliding:
        return bool((1.0 if state is RowState.FORWARD else -1.0) * a[i] >= -slack)
    return True


def _outcome(problem: ContactProblem, search: _Search, mode: Mode, x: Array, angles: dict[int, float]) -> ForceOutcome:
    forces = search.system.forces(x)
    accelerations = problem.A @ forces + problem.b
    states = [RowState.HELD] * problem.n
    for row, k in search.place.items():
        states[row] = mode[k]
    held = list(problem.held_rows)
    accelerations[held] = 0.0
    return ForceOutcome(
        OutcomeCount.UNIQUE, tuple(states), forces, accelerations, is_proven=False, directions=tuple(angles.items())
    )


def _nothing(problem: ContactProblem, status: OutcomeCount) -> ForceOutcome:
    unknown = np.full(problem.n, np.nan)
    mode = tuple(RowState.OPEN for _ in range(problem.n))
    return ForceOutcome(status, mode, unknown, unknown, is_proven=status is OutcomeCount.NONE)
