"""Which forces can hold a system at rest: linear programs over its reactions.

With J the gradients of all rows (held ones, closed bounds, slips of dry friction) and Q the loads, rest needs

    Q + J^T lambda = 0,    N >= 0 of what cannot pull,    -forward L <= T <= backward L of dry friction,

T the multiplier of a slip, L its load. In a plane T has two components and |T| <= c L: that is u.T <= c L for all unit
vectors u (`circular_programs`). How far this is from failing is one more unknown, the margin t:

    maximize t    so that    N >= t,    T + forward L >= t,    backward L - T >= t.

By Farkas' lemma the multipliers v of the equilibrium equations are a motion. It does no work on held rows, opens
contacts, or slips where the friction constraint is active, and at t < 0 the loads do positive work along it: that
motion is how the system fails. The same v belongs to the largest parameter that can be borne (limit analysis).
Sources: Dantzig & Thapa, Linear Programming 2, 2003, ch. 2; Drucker, Coulomb
friction, plasticity, and limit loads, J. Appl. Mech. 21, 1954, 71-74.
"""

from __future__ import annotations

from dataclasses import dataclass, field, replace

import numpy as np

from freebody.numeric.circular_programs import CircularCone, program_of, with_slack
from freebody.numeric.jets import Array
from freebody.numeric.rest_problem import FrictionCone, RestProblem
from freebody.tolerances import ROUND_OFF, ROUNDED

_FREE = ROUND_OFF  # a load along a direction in which nothing resists, of the largest load


@dataclass(frozen=True)
class Optimum:
    """An extreme value, the multipliers there (n_rows,), and the motion (n,) that keeps it from going further."""

    value: float
    forces: Array
    motion: Array


@dataclass
class _Program:
    """A linear program over (scaled multipliers, one more unknown), with G x <= h; `shares` of each row of G in the
    margin."""

    A: Array
    b: Array
    G: list[Array] = field(default_factory=list[Array])
    h: list[float] = field(default_factory=list[float])
    shares: list[float] = field(default_factory=list[float])
    cones: list[CircularCone] = field(default_factory=list[CircularCone])
    limit_of: dict[tuple[int, int], int] = field(default_factory=dict[tuple[int, int], int])  # by cone and side

    def add(self, row: Array, bound: float, share: float) -> None:
        self.G.append(row)
        self.h.append(bound)
        self.shares.append(share)

    def circles(self, share: float | None = None) -> list[CircularCone]:
        """Its circular cones, with one more unknown of which each has a share in the margin."""
        if share is None:
            return self.cones
        return [
            CircularCone(np.append(c.one, 0.0), np.append(c.other, 0.0), np.append(c.load, -share)) for c in self.cones
        ]


class Scaled:
    """A rest problem in units of its own: forces by the largest load, torques by that times its length, and every row
    of J of length one."""

    def __init__(self, problem: RestProblem, unit: float | None = None) -> None:
        self.problem = problem
        J = problem.J * problem.moves
        sizes = np.linalg.norm(J, axis=1)
        self.row_scale = 1.0 / np.where(sizes > ROUNDED * float(sizes.max(initial=1.0)), sizes, 1.0)
        self.unit = unit or problem.force
        self.A: Array = (self.row_scale[:, None] * J).T
        self.b: Array = -problem.Q * problem.moves / self.unit

    def program(self) -> _Program:
        p, m = self.problem, len(self.problem.names)
        if any(cone.size for cone in p.cones):
            raise ValueError("cones with a size are for `friction_branches`")
        program = _Program(self.A, self.b)
        for row, sign in p.normals:
            line = np.zeros(m)
            line[row] = -sign
            program.add(line, 0.0, 1.0)
        for k, cone in enumerate(p.cones):
            if cone.across >= 0:
                self._add_circle(program, cone)
                continue
            for side, (direction, coefficient, limit) in enumerate(
                zip((1, -1), (cone.forward, cone.backward), cone.limits, strict=True)
            ):
                program.limit_of[k, side] = len(program.G)
                # -T - forward L <= limit, and T - backward L <= limit, in units of T
                line = np.zeros(m)
                line[cone.row] = -direction
                for row, sign in cone.load:
                    line[row] -= coefficient * sign * self.row_scale[row] / self.row_scale[cone.row]
                program.add(line, limit / (self.unit * self.row_scale[cone.row]), 1.0)
        for wall in p.walls:
            line = np.zeros(m)
            for row, coefficient in wall:
                line[row] = -coefficient * self.row_scale[row]
            program.add(line / (float(np.abs(line).max()) or 1.0), 0.0, 0.0)
        return program

    def _add_circle(self, program: _Program, cone: FrictionCone) -> None:
        one, other, load = (np.zeros(len(self.row_scale)) for _ in range(3))
        one[cone.row] = 1.0
        other[cone.across] = self.row_scale[cone.across] / self.row_scale[cone.row]
        for row, sign in cone.load:
            load[row] += cone.forward * sign * self.row_scale[row] / self.row_scale[cone.row]
        program.cones.append(CircularCone(one, other, load))

    def forces(self, x: Array) -> Array:
        return x * self.row_scale * self.unit

    def motion(self, duals: Array) -> Array:
        """v in the system's own units, from the multipliers of the equilibrium equations."""
        return -duals * self.problem.moves


def margin(problem: RestProblem) -> Optimum | None:
    """The largest t with which all constraints can be met, at most 1, by the largest load; below 0 nothing can hold
    the system, and the motion is how it fails. None if no reactions, of whatever sign, balance the loads."""
    scaled = Scaled(problem)
    program = scaled.program()
    columns = np.hstack([program.A, np.zeros((len(program.b), 1))])
    G = [np.append(row, share) for row, share in zip(program.G, program.shares, strict=True)]
    cost = np.zeros(columns.shape[1])
    cost[-1] = -1.0
    # the margin is at most 1
    circular = program_of(cost, columns, program.b, [*G, -cost], [*program.h, 1.0], program.circles(1.0))
    found = (with_slack(circular) if circular.cones else circular).optimum()
    if found is None:
        return None
    x, duals, value = found
    return Optimum(-value, scaled.forces(x[:-1]), scaled.motion(duals))


def unresisted(problem: RestProblem) -> Array | None:
    """A motion (n,) that no row resists and that the loads drive; None if there is none."""
    A = Scaled(problem).A
    b = problem.Q * problem.moves / problem.force
    rest = b - A @ np.linalg.lstsq(A, b, rcond=ROUNDED)[0] if A.size else b
    return rest * problem.moves if float(np.abs(rest).max(initial=0.0)) > _FREE else None


@dataclass(frozen=True)
class Ray:
    """Rest problems that depend linearly on a parameter p: the problem at p = 0, and the rates of its loads and of the
    limits of its cones."""

    problem: RestProblem
    loads: Array
    limits: tuple[tuple[float, float], ...]


def ray(first: RestProblem, second: RestProblem, p: float) -> Ray:
    """From the problems at p and at 2 p, which differ in loads and limits only."""
    limits = tuple(
        ((b.limits[0] - a.limits[0]) / p, (b.limits[1] - a.limits[1]) / p)
        for a, b in zip(first.cones, second.cones, strict=True)
    )
    cones = tuple(
        replace(cone, limits=(cone.limits[0] - p * f, cone.limits[1] - p * b))
        for cone, (f, b) in zip(first.cones, limits, strict=True)
    )
    start = replace(first, Q=2.0 * first.Q - second.Q, cones=cones)
    return Ray(start, (second.Q - first.Q) / p, limits)


def at(ray: Ray, p: float) -> RestProblem:
    """The problem at a value of the parameter."""
    cones = tuple(
        replace(cone, limits=(cone.limits[0] + p * f, cone.limits[1] + p * b))
        for cone, (f, b) in zip(ray.problem.cones, ray.limits, strict=True)
    )
    return replace(ray.problem, Q=ray.problem.Q + p * ray.loads, cones=cones)


def extreme(ray: Ray, sign: int, *, unit: float = 1.0) -> Optimum | None:
    """The largest (sign +1) or smallest (-1) parameter with which the system can be held; the value is infinite where
    there is no limit. None if no parameter does. `unit`: a typical size of the parameter."""
    p0 = ray.problem
    scaled = Scaled(p0, replace(p0, Q=np.abs(p0.Q) + unit * np.abs(ray.loads)).force)
    program = scaled.program()
    slope = (ray.loads * p0.moves * unit / scaled.unit)[:, None]
    columns = np.hstack([program.A, slope])
    G = np.array([np.append(row, 0.0) for row in program.G]).reshape(len(program.G), columns.shape[1])
    for k, (cone, rates) in enumerate(zip(p0.cones, ray.limits, strict=True)):
        for j, rate in enumerate(rates):
            if (k, j) in program.limit_of:
                G[program.limit_of[k, j], -1] = -rate * unit / (scaled.unit * scaled.row_scale[cone.row])
    cost = np.zeros(columns.shape[1])
    cost[-1] = -float(sign)

    circular = program_of(cost, columns, program.b, list(G), program.h, program.circles(0.0))
    found = circular.optimum()
    if found is None:
        if circular.is_possible():
            return Optimum(sign * np.inf, np.full(len(p0.names), np.nan), np.zeros(len(p0.Q)))
        return None
    x, duals, _value = found
    return Optimum(float(x[-1]) * unit, scaled.forces(x[:-1]), scaled.motion(duals))


def spread(problem: RestProblem, row: int) -> tuple[Optimum, Optimum] | None:
    """The least and the greatest multiplier of a row among all reactions that hold the system; infinite where there
    is no limit. None if nothing holds it."""
    scaled = Scaled(problem)
    program = scaled.program()
    ends: list[Optimum] = []
    for sign in (1.0, -1.0):
        cost = np.zeros(program.A.shape[1])
        cost[row] = sign
        circular = program_of(cost, program.A, program.b, program.G, program.h, program.circles())
        found = circular.optimum()
        if found is None:
            if not circular.is_possible():
                return None
            ends.append(Optimum(-sign * np.inf, np.full(len(cost), np.nan), np.zeros(len(problem.Q))))
            continue
        x, duals, _value = found
        reactions = scaled.forces(x)
        ends.append(Optimum(float(reactions[row]), reactions, scaled.motion(duals)))
    return ends[0], ends[1]
