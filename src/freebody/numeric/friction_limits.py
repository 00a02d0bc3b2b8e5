"""Which forces can hold a system at rest: linear programs over its reactions.

With J the gradients of all rows (held ones, closed bounds, slips of dry friction) and Q the loads, rest needs

    Q + J^T lambda = 0,    N >= 0 of what cannot pull,    -forward L <= T <= backward L of dry friction,

T the multiplier of a slip, L its load. In a plane T has two components and |T| <= c L: that is u.T <= c L for all unit
vectors u, of which those are added, one after another, that the forces found break (Kelley's cutting planes). How far
this is from failing is one more unknown, the margin t:

    maximize t    so that    N >= t,    T + forward L >= t,    backward L - T >= t.

By Farkas' lemma the multipliers v of the equilibrium equations are a motion. It does no work on held rows, opens
contacts, or slips where the friction constraint is active, and at t < 0 the loads do positive work along it: that
motion is how the system fails. The same v belongs to the largest parameter that can be borne (limit analysis).
Sources: Kelley, J. SIAM 8 (1960) 703-712; Dantzig & Thapa, Linear Programming 2, 2003, ch. 2; Drucker, Coulomb
friction, plasticity, and limit loads, J. Appl. Mech. 21, 1954, 71-74.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np

from freebody.numeric.jets import Array
from freebody.numeric.rest_problem import FrictionCone, RestProblem
from freebody.numeric.solvers import optimize
from freebody.tolerances import ROUND_OFF, ROUNDED

_FREE = ROUND_OFF  # a load along a direction in which nothing resists, of the largest load
_RCOND, _POLISH = 1e-11, 1e-5  # of the constraints that decide, solved once more; a step that is larger is no polish
_N_PLANES, _MOST_CUTS, _BROKEN = 16, 60, 1e-9  # of a circular cone; a force outside it by more is moved inside
_ACTIVE = 1e-7  # a dual variable above this part of the largest marks a constraint that decides


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
    cones: list[tuple[Array, Array, Array]] = field(default_factory=list[tuple[Array, Array, Array]])  # T_1, T_2, c L
    limit_of: dict[tuple[int, int], int] = field(default_factory=dict[tuple[int, int], int])  # by cone and side

    def add(self, row: Array, bound: float, share: float) -> None:
        self.G.append(row)
        self.h.append(bound)
        self.shares.append(share)

    def broken(self, x: Array, margin: float = 0.0) -> list[Array]:
        """Of every circular cone outside of which forces are, the row of the plane that keeps them inside there."""
        found: list[Array] = []
        for one, other, load in self.cones:
            first, second = float(one @ x), float(other @ x)
            size = math.hypot(first, second)
            if size + margin > float(load @ x) + _BROKEN * max(1.0, size):
                found.append((first * one + second * other) / size - load)
        return found


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
        """A circular cone, by the first of the planes that touch it."""
        one, other, load = (np.zeros(len(self.row_scale)) for _ in range(3))
        one[cone.row] = 1.0
        other[cone.across] = self.row_scale[cone.across] / self.row_scale[cone.row]
        for row, sign in cone.load:
            load[row] += cone.forward * sign * self.row_scale[row] / self.row_scale[cone.row]
        program.cones.append((one, other, load))
        for k in range(_N_PLANES):
            angle = 2.0 * math.pi * k / _N_PLANES
            program.add(math.cos(angle) * one + math.sin(angle) * other - load, 0.0, 1.0)

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
    G = np.array([np.append(row, share) for row, share in zip(program.G, program.shares, strict=True)])
    cost = np.zeros(columns.shape[1])
    cost[-1] = -1.0
    bounds: list[tuple[float | None, float | None]] = [*[(None, None)] * (len(cost) - 1), (None, 1.0)]

    def broken(x: Array) -> list[Array]:
        return [np.append(row, 1.0) for row in program.broken(x[:-1], float(x[-1]))]

    found = _solved(cost, columns, program.b, G, np.array(program.h), bounds, broken)
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

    def broken(x: Array) -> list[Array]:
        return [np.append(row, 0.0) for row in program.broken(x[:-1])]

    found = _solved(cost, columns, program.b, G, np.array(program.h), [(None, None)] * len(cost), broken)
    if found is None:
        if _is_possible(columns, program.b, G, np.array(program.h)):
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
        G, h = np.array(program.G).reshape(-1, len(cost)), np.array(program.h)
        found = _solved(cost, program.A, program.b, G, h, [(None, None)] * len(cost), program.broken)
        if found is None:
            if not _is_possible(program.A, program.b, G, h):
                return None
            ends.append(Optimum(-sign * np.inf, np.full(len(cost), np.nan), np.zeros(len(problem.Q))))
            continue
        x, duals, _value = found
        reactions = scaled.forces(x)
        ends.append(Optimum(float(reactions[row]), reactions, scaled.motion(duals)))
    return ends[0], ends[1]


Bounds = Sequence[tuple[float | None, float | None]]


def _solved(
    cost: Array, A: Array, b: Array, G: Array, h: Array, bounds: Bounds, broken: Callable[[Array], list[Array]]
) -> tuple[Array, Array, float] | None:
    """The optimum of a program with circular cones: planes are added where it is outside of them, until it is not."""
    lines, limits = G, h
    found = _linear(cost, A, b, lines, limits, bounds)
    for _ in range(_MOST_CUTS):
        planes = [] if found is None else broken(found[0])
        if not planes:
            break
        lines, limits = np.vstack([lines, *planes]), np.append(limits, np.zeros(len(planes)))
        found = _linear(cost, A, b, lines, limits, bounds)
    return found


def _linear(cost: Array, A: Array, b: Array, G: Array, h: Array, bounds: Bounds) -> tuple[Array, Array, float] | None:
    """(x, multipliers of A x = b, least cost) of one linear program, polished; None if it has no optimum.

    The simplex method is exact up to its own tolerance of 1e-7 only. What it says is which constraints decide: with
    these as equations, x follows by least squares to round-off."""
    found: Any = optimize().linprog(
        cost, A_ub=G if len(G) else None, b_ub=h if len(G) else None, A_eq=A, b_eq=b, bounds=bounds
    )
    if found.status != 0:
        return None
    x: Array = np.asarray(found.x, dtype=np.float64)
    duals: Array = np.asarray(found.eqlin.marginals, dtype=np.float64)
    lines, right = [A], [b]
    if len(G):
        active = np.asarray(found.ineqlin.residual, dtype=np.float64) < _ACTIVE
        lines.append(G[active])
        right.append(h[active])
    at_bound = [k for k, (_low, high) in enumerate(bounds) if high is not None and x[k] > high - _ACTIVE]
    for k in at_bound:
        lines.append(np.eye(len(x))[k : k + 1])
        right.append(np.array([float(bounds[k][1] or 0.0)]))
    E, e = np.vstack(lines), np.concatenate(right)
    step: Array = np.asarray(np.linalg.lstsq(E, e - E @ x, rcond=_RCOND)[0], dtype=np.float64)
    if float(np.abs(step).max(initial=0.0)) < _POLISH * max(1.0, float(np.abs(x).max(initial=0.0))):
        x = x + step
    return x, duals, float(cost @ x)


def _is_possible(A: Array, b: Array, G: Array, h: Array) -> bool:
    found: Any = optimize().linprog(
        np.zeros(A.shape[1]),
        A_ub=G if len(G) else None,
        b_ub=h if len(G) else None,
        A_eq=A,
        b_eq=b,
        bounds=[(None, None)] * A.shape[1],
    )
    return bool(found.status == 0)
