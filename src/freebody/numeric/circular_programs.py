"""Linear programs with circular cones, c x least so that A x = b, G x <= h and |(p.x, q.x)| <= load.x of every cone.

From a start inside of all constraints the barrier -log of what is left of each leads to the middle of the optima, of
which there may be many. Which constraints decide is seen there, and the conditions of the optimum are solved with them
(Newton): with y, z >= 0, s >= 0

    c + A^T y + G^T z + sum of s_k grad f_k = 0,      f_k = |(p.x, q.x)| - load.x = 0,

a cone at its tip by p.x = q.x = load.x = 0 with multipliers in the cone |(u, v)| <= s that is dual to it, by least
squares, since neither x nor the multipliers need to be unique. Whatever satisfies them is an optimum, as the program is
convex. The start is where as much as possible is left of all constraints. Where there is none, or the conditions are
not found to hold, a cone is u.(p.x, q.x) <= load.x for all unit vectors u: of these planes some are there from the
beginning, and the one that touches the cone where x is outside of it is added, one after another.
Sources: Kelley, J. SIAM 8 (1960) 703-712 (planes); Boyd & Vandenberghe, Convex Optimization, 2004, sec. 5.5.3 and 11.3.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
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
_BOUNDLESS, _INSIDE = 1e9, 1e-3  # as far as this there is no middle; what must be left in all constraints at a start


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
        start = self._inside() if self.cones and self.start is None else self.start
        if self.cones and start is not None and (x := self._centred(start)) is not None:
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
    def _centred(self, start: Array) -> Array | None:
        """The middle of the optima, by the barrier; None where the start is not inside, or there is no middle."""
        barrier = _Barrier.of(self, start)
        y, weight = np.zeros(barrier.free.shape[1]), 1.0
        if not math.isfinite(barrier.value(y, weight)):
            return None
        while weight <= _SHARPEST:
            y = barrier.centred(y, weight)
            if float(np.abs(y).max(initial=0.0)) > _BOUNDLESS:
                return None
            weight *= _SHARPER
        return barrier.at(y)

    def _inside(self) -> Array | None:
        """What meets all constraints with something left: where the barrier leads with a slack until that is not
        needed; None if it leads nowhere there."""
        slack = with_slack(self._slackened())
        if slack.start is None:
            return None
        barrier = _Barrier.of(slack, slack.start)

        def is_inside(y: Array) -> bool:
            return float(barrier.at(y)[-1]) > _INSIDE

        y, weight = np.zeros(barrier.free.shape[1]), 1.0
        while weight <= _SHARPEST and not is_inside(y):
            y = barrier.centred(y, weight, is_inside)
            if float(np.abs(y).max(initial=0.0)) > _BOUNDLESS:
                return None
            weight *= _SHARPER
        return barrier.at(y)[:-1] if is_inside(y) else None

    def _slackened(self) -> CircularProgram:
        """With one more unknown, of at most 1, by which all constraints are tighter, and which is to be great."""
        last = np.append(np.zeros(len(self.cost)), 1.0)
        G = np.vstack([np.column_stack([self.G, np.ones(len(self.G))]), last])
        cones = tuple(
            CircularCone(np.append(c.one, 0.0), np.append(c.other, 0.0), np.append(c.load, -1.0)) for c in self.cones
        )
        A = np.column_stack([self.A, np.zeros(len(self.A))])
        return CircularProgram(-last, A, self.b, G, np.append(self.h, 1.0), cones)

    def _exact(self, x: Array) -> tuple[Array, Array, float] | None:
        """The optimum in which the constraints decide that do at x; None if it is none."""
        near = [cone for cone in self.cones if cone.plane(x)[1] > -_NEAR * max(1.0, float(cone.load @ x))]
        # at its tip a cone has no plane of its own: T and L are zero there
        tips = [cone for cone in near if float(cone.load @ x) <= _NEAR]
        near = [cone for cone in near if float(cone.load @ x) > _NEAR]
        decides = self.h - self.G @ x < _ACTIVE
        at_tips = [row for cone in tips for row in (cone.one, cone.other, -cone.load)]
        lines = np.vstack([self.A, self.G[decides], *at_tips])
        limits = np.concatenate([self.b, self.h[decides], np.zeros(len(at_tips))])
        n, n_lines = len(x), len(lines)

        def slopes(x: Array) -> Array:
            return np.vstack([lines, *(cone.plane(x)[0] for cone in near)])

        multipliers: Array = np.asarray(np.linalg.lstsq(slopes(x).T, -self.cost, rcond=_RCOND)[0], dtype=np.float64)
        for _ in range(_N_NEWTON):
            E = slopes(x)
            outside = [cone.plane(x)[1] for cone in near]
            rest = np.concatenate([self.cost + E.T @ multipliers, lines @ x - limits, outside])
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
        n_signed = len(self.A) + int(decides.sum())
        signed = np.concatenate([multipliers[len(self.A) : n_signed], multipliers[n_lines:]])
        holds = not np.any(self.G @ x > self.h + _BROKEN) and not any(cone.is_broken(x) for cone in self.cones)
        opens = multipliers[n_signed:n_lines].reshape(-1, 3)  # at a tip: of T within that of L, the dual cone
        if not holds or np.any(signed < -_ACTIVE) or np.any(np.hypot(opens[:, 0], opens[:, 1]) > opens[:, 2] + _ACTIVE):
            return None
        return x, -multipliers[: len(self.A)], float(self.cost @ x)


@dataclass(frozen=True)
class _Barrier:
    """The cost by a weight and the barriers of lines and cones, at x = start + free y, along which A x stays b: lines
    g - G y > 0, and of all cones p + P y, q + Q y, m + L y with L^2 - |T|^2 > 0."""

    start: Array
    free: Array
    cost: Array
    G: Array
    g: Array
    P: Array  # (n_cones, n_free), as Q and L
    p: Array
    Q: Array
    q: Array
    L: Array
    m: Array

    @classmethod
    def of(cls, program: CircularProgram, start: Array) -> _Barrier:
        _u, sizes, vt = np.linalg.svd(program.A)
        free = vt[int((sizes > _RCOND * sizes.max(initial=0.0)).sum()) :].T
        n = len(start)
        parts: list[Array] = []
        for rows in ([c.one for c in program.cones], [c.other for c in program.cones], [c.load for c in program.cones]):
            whole = np.array(rows).reshape(-1, n)
            parts += [whole @ free, whole @ start]
        lines = program.G @ free, program.h - program.G @ start
        return cls(start, free, free.T @ program.cost, *lines, *parts)

    def at(self, y: Array) -> Array:
        return self.start + self.free @ y

    def _left(self, y: Array) -> tuple[Array, Array, Array, Array, Array]:
        """Of the lines; of the cones, with their components and loads."""
        first, second, load = self.p + self.P @ y, self.q + self.Q @ y, self.m + self.L @ y
        return self.g - self.G @ y, load * load - first * first - second * second, first, second, load

    def value(self, y: Array, weight: float) -> float:
        """Infinite outside."""
        left, inner, _first, _second, load = self._left(y)
        if np.any(left <= 0.0) or np.any(inner <= 0.0) or np.any(load <= 0.0):
            return math.inf
        return weight * float(self.cost @ y) - float(np.log(left).sum()) - float(np.log(inner).sum())

    def slope(self, y: Array, weight: float) -> tuple[Array, Array]:
        """First and second derivatives."""
        left, inner, first, second, load = self._left(y)
        scaled = self.G / left[:, None]
        own = 2.0 * (load[:, None] * self.L - first[:, None] * self.P - second[:, None] * self.Q) / inner[:, None]
        over = 2.0 / inner[:, None]
        form = self.L.T @ (over * self.L) - self.P.T @ (over * self.P) - self.Q.T @ (over * self.Q)
        return weight * self.cost + scaled.sum(axis=0) - own.sum(axis=0), scaled.T @ scaled + own.T @ own - form

    def centred(self, y: Array, weight: float, until: Callable[[Array], bool] = lambda _y: False) -> Array:
        """Newton's steps to the least value, each as long as the value falls."""
        value = self.value(y, weight)
        for _ in range(_N_CENTRING):
            g, H = self.slope(y, weight)
            step = -np.linalg.lstsq(H, g, rcond=None)[0]
            fall = float(g @ step)
            if -fall <= _CENTRED or until(y):
                break
            part, new = 1.0, self.value(y + step, weight)
            while not new <= value + 0.1 * part * fall and part >= _SHORTEST:
                part *= 0.5
                new = self.value(y + part * step, weight)
            y, value = y + part * step, new
            if not math.isfinite(value) or float(np.abs(y).max(initial=0.0)) > _BOUNDLESS:
                break
        return y


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
