"""Linear programs with circular cones, c x least so that A x = b, G x <= h and |(p.x, q.x)| <= load.x of every cone.

From a start inside of all constraints the barrier -log of what is left of each leads to the middle of the optima, of
which there may be many. Which constraints decide is seen there, and the conditions of the optimum are solved with them
(Newton): with y, z >= 0, s >= 0

    c + A^T y + G^T z + sum of s_k grad f_k = 0,      f_k = |(p.x, q.x)| - load.x = 0,

by least squares, since neither x nor the multipliers need to be unique. Whatever satisfies them is an optimum, as the
program is convex. Where there is no such start, or they are not found to hold, a cone is u.(p.x, q.x) <= load.x for all
unit vectors u: of these planes some are there from the beginning, and the one that touches the cone where x is outside
of it is added, one after another.
Sources: Kelley, J. SIAM 8 (1960) 703-712 (planes); Boyd & Vandenberghe, Convex Optimization, 2004, sec. 5.5.3 and 11.3.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from freebody.numeric.jets import Array
from freebody.numeric.solvers import optimize

_RCOND, _POLISH = 1e-11, 1e-5  # of the constraints that decide, solved once more; a step that is larger is no polish
_N_PLANES, _MOST_CUTS, _BROKEN = 16, 60, 1e-9  # of a circular cone; a force outside it by more is moved inside
_ACTIVE = 1e-7  # what is met to this decides
_NEAR, _N_NEWTON, _EXACT = 1e-4, 12, 1e-12  # a cone that decides; Newton's steps, and what is left of the equations
_SHARPER, _SHARPEST = 10.0, 1e9  # the weight of the cost beside the barrier: how it grows, and up to what
_N_CENTRING, _CENTRED, _SHORTEST = 30, 1e-8, 1e-12  # Newton's steps of one weight; half their decrement; part of a step


@dataclass(frozen=True)
class CircularCone:
    """|(one.x, other.x)| <= load.x."""

    one: Array
    other: Array
    load: Array

    def plane(self, x: Array) -> tuple[Array, float]:
        """The plane row.x <= 0 that touches it where x points, and by how much x is outside."""
        first, second = float(self.one @ x), float(self.other @ x)
        size = math.hypot(first, second)
        row = (first * self.one + second * self.other) / size - self.load if size else -self.load
        return row, size - float(self.load @ x)

    def curvature(self, x: Array) -> Array:
        """The second derivatives of the size, (T_2 p - T_1 q)(T_2 p - T_1 q)^T/|T|^3."""
        first, second = float(self.one @ x), float(self.other @ x)
        across = second * self.one - first * self.other
        return np.outer(across, across) / math.hypot(first, second) ** 3

    def barrier(self, x: Array) -> tuple[float, Array, Array]:
        """-log(L^2 - |T|^2) with its first and second derivatives; infinite outside."""
        first, second, load = (float(v @ x) for v in (self.one, self.other, self.load))
        left = load * load - first * first - second * second
        if load <= 0.0 or left <= 0.0:
            return math.inf, self.load, np.zeros((len(x), len(x)))
        slope = 2.0 * (load * self.load - first * self.one - second * self.other) / left
        form = np.outer(self.load, self.load) - np.outer(self.one, self.one) - np.outer(self.other, self.other)
        return -math.log(left), -slope, np.outer(slope, slope) - 2.0 * form / left

    def is_broken(self, x: Array) -> bool:
        return self.plane(x)[1] > _BROKEN * max(1.0, math.hypot(float(self.one @ x), float(self.other @ x)))


@dataclass(frozen=True)
class CircularProgram:
    """A program in numbers; see the head of the file."""

    cost: Array
    A: Array
    b: Array
    G: Array
    h: Array
    cones: tuple[CircularCone, ...] = ()
    start: Array | None = None  # with A x = b

    def optimum(self) -> tuple[Array, Array, float] | None:
        """(x, -y, least cost); None if there is none."""
        if self.cones and self.start is not None and (x := self._centred(self.start)) is not None:
            exact = self._exact(x)
            if exact is not None:
                return exact
        lines, limits = self._with_planes()
        found = self._linear(lines, limits)
        for _ in range(_MOST_CUTS):
            if found is None:
                break
            x = found[0]
            planes = [cone.plane(x)[0] for cone in self.cones if cone.is_broken(x)]
            if not planes:
                break
            lines, limits = np.vstack([lines, *planes]), np.append(limits, np.zeros(len(planes)))
            found = self._linear(lines, limits)
            if found is not None and np.array_equal(found[0], x):
                break  # what is left is less than the simplex method tells apart
        return found

    def is_possible(self) -> bool:
        """Whether anything satisfies the constraints."""
        lines, limits = self._with_planes()
        return self._solved(np.zeros(len(self.cost)), lines, limits).status == 0

    def _with_planes(self) -> tuple[Array, Array]:
        """All lines, those of the first planes of the cones included."""
        planes = [
            math.cos(angle) * cone.one + math.sin(angle) * cone.other - cone.load
            for cone in self.cones
            for angle in (2.0 * math.pi * k / _N_PLANES for k in range(_N_PLANES))
        ]
        return np.vstack([self.G, *planes]), np.append(self.h, np.zeros(len(planes)))

    def _solved(self, cost: Array, G: Array, h: Array) -> Any:
        return optimize().linprog(
            cost,
            A_ub=G if len(G) else None,
            b_ub=h if len(G) else None,
            A_eq=self.A,
            b_eq=self.b,
            bounds=[(None, None)] * len(cost),
        )

    def _linear(self, G: Array, h: Array) -> tuple[Array, Array, float] | None:
        """The optimum of a linear program with the lines G, polished; None if it has none.

        The simplex method is exact up to its own tolerance of 1e-7 only. What it says is which constraints decide: with
        these as equations, x follows by least squares to round-off."""
        found = self._solved(self.cost, G, h)
        if found.status != 0:
            return None
        x: Array = np.asarray(found.x, dtype=np.float64)
        duals: Array = np.asarray(found.eqlin.marginals, dtype=np.float64)
        active = h - G @ x < _ACTIVE if len(G) else np.zeros(0, dtype=bool)
        E, e = np.vstack([self.A, G[active]]), np.concatenate([self.b, h[active]])
        step: Array = np.asarray(np.linalg.lstsq(E, e - E @ x, rcond=_RCOND)[0], dtype=np.float64)
        if float(np.abs(step).max(initial=0.0)) < _POLISH * max(1.0, float(np.abs(x).max(initial=0.0))):
            x = x + step
        return x, duals, float(self.cost @ x)

    # -- with the cones themselves ------------------------------------------------------------
    def _centred(self, x: Array) -> Array | None:
        """The middle of the optima, by the barrier; None where the start is not inside."""
        _u, sizes, vt = np.linalg.svd(self.A)
        free = vt[int((sizes > _RCOND * sizes.max(initial=0.0)).sum()) :].T  # along which A x stays b
        if not math.isfinite(self._barrier(x, 1.0)[0]):
            return None
        weight = 1.0
        while weight <= _SHARPEST:
            for _ in range(_N_CENTRING):
                value, slope, curvature = self._barrier(x, weight)
                g, H = free.T @ slope, free.T @ curvature @ free
                step = -np.linalg.lstsq(H, g, rcond=None)[0]
                if -float(g @ step) <= _CENTRED:
                    break
                part = 1.0
                while not self._barrier(x + part * (free @ step), weight)[0] <= value + 0.1 * part * float(g @ step):
                    part *= 0.5
                    if part < _SHORTEST:
                        break
                x = x + part * (free @ step)
            weight *= _SHARPER
        return x

    def _barrier(self, x: Array, weight: float) -> tuple[float, Array, Array]:
        """The cost by a weight and the barriers, with their first and second derivatives."""
        left = self.h - self.G @ x
        if np.any(left <= 0.0):
            return math.inf, self.cost, np.zeros((len(x), len(x)))
        scaled = self.G / left[:, None]
        value = weight * float(self.cost @ x) - float(np.log(left).sum())
        slope, curvature = weight * self.cost + scaled.sum(axis=0), scaled.T @ scaled
        for cone in self.cones:
            own, first, second = cone.barrier(x)
            value, slope, curvature = value + own, slope + first, curvature + second
        return value, slope, curvature

    def _exact(self, x: Array) -> tuple[Array, Array, float] | None:
        """The optimum in which the constraints decide that do at x; None if it is none."""
        near = [cone for cone in self.cones if cone.plane(x)[1] > -_NEAR * max(1.0, float(cone.load @ x))]
        if not near or any(float(cone.load @ x) <= _NEAR for cone in near):
            return None  # at its tip a cone has no plane of its own
        decides = self.h - self.G @ x < _ACTIVE
        lines, limits = np.vstack([self.A, self.G[decides]]), np.append(self.b, self.h[decides])
        n, n_lines = len(x), len(lines)

        def slopes(x: Array) -> Array:
            return np.vstack([lines, *(cone.plane(x)[0] for cone in near)])

        multipliers: Array = np.asarray(np.linalg.lstsq(slopes(x).T, -self.cost, rcond=_RCOND)[0], dtype=np.float64)
        for _ in range(_N_NEWTON):
            E = slopes(x)
            rest = np.concatenate(
                [self.cost + E.T @ multipliers, lines @ x - limits, [cone.plane(x)[1] for cone in near]]
            )
            if float(np.abs(rest).max()) <= _EXACT:
                break
            H = sum(
                (s * cone.curvature(x) for s, cone in zip(multipliers[n_lines:], near, strict=True)), np.zeros((n, n))
            )
            K = np.block([[H, E.T], [E, np.zeros((len(E), len(E)))]])
            step = np.linalg.lstsq(K, -rest, rcond=_RCOND)[0]
            x, multipliers = x + step[:n], multipliers + step[n:]
        else:
            return None
        signed = multipliers[len(self.A) :]
        holds = not np.any(self.G @ x > self.h + _BROKEN) and not any(cone.is_broken(x) for cone in self.cones)
        if not holds or np.any(signed < -_ACTIVE):
            return None
        return x, -multipliers[: len(self.A)], float(self.cost @ x)


def program_of(
    cost: Array, A: Array, b: Array, G: Sequence[Array], h: Sequence[float], cones: Sequence[CircularCone] = ()
) -> CircularProgram:
    """From rows that may be none."""
    return CircularProgram(cost, A, b, np.array(G).reshape(-1, len(cost)), np.array(h), tuple(cones))


def with_slack(program: CircularProgram) -> CircularProgram:
    """With a start: the last unknown, which makes room in all constraints that have a share in it, as low as that
    needs."""
    A = program.A[:, :-1]
    x = np.append(np.linalg.lstsq(A, program.b, rcond=_RCOND)[0], 0.0)
    if np.abs(program.A @ x - program.b).max(initial=0.0) > _BROKEN:
        return program
    left = [*(program.h - program.G @ x), *(-cone.plane(x)[1] for cone in program.cones)]
    x[-1] = min(0.0, *left) - 1.0
    return replace(program, start=x)
