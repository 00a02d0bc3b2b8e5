"""What is known about the best case: which limits hold it, what they cost, and whether it is a local optimum.

With goal f and limits c_i >= 0, at a local optimum

    grad f = sum lambda_i grad c_i,   lambda_i >= 0 for inequalities, 0 where c_i > 0          (first order)

if the gradients of the limits that are active are independent, and it is a strict one if besides the Hessian of
f - sum lambda_i c_i is positive on what these leave free (second order). Moving the bound of limit i by db changes
the optimum by -lambda_i dc_i/db db. Everything is counted in the sizes of goal and limits and in parts of ranges.
Source: Nocedal & Wright, Numerical Optimization, 2nd ed. 2006, th. 12.1, 12.6 and sec. 12.9.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from importlib import import_module
from typing import Any, Literal

import numpy as np

from freebody.numeric.jets import Array
from freebody.study.optimising.slopes import KEPT, Search

ACTIVE = 1e-6  # of its size: a limit that is as near counts as active
HOLDS = 1e-5  # the residual of the first-order conditions, relative to the gradient
_CLEAR = 1e-6  # a multiplier, or a curvature, that is greater counts as positive
_STEP = 1e-4

Order = Literal["strict", "stationary", "not shown"]


@dataclass(frozen=True)
class Active:
    """A limit, or an end of a range, that holds the optimum. cost: of the goal by its bound, in SI."""

    text: str
    multiplier: float
    cost: float
    unit: str


@dataclass(frozen=True)
class Conditions:
    """order: what is known of a local optimum; residual: of the first-order conditions; are_unique: the multipliers."""

    order: Order
    residual: float
    active: tuple[Active, ...]
    are_unique: bool


@dataclass
class _Row:
    """One active condition. key: of the limit that it belongs to, negative for ends of ranges; cost: d goal/d bound
    for a multiplier of 1."""

    key: tuple[str, int]
    slope: Array
    is_equation: bool = False
    cost: float = 0.0
    place: int = field(default=-1)


def conditions(search: Search, u: Array) -> Conditions:
    """At the case u (n,)."""
    at = _first_order(search, u)
    rank = int(np.linalg.matrix_rank(at.A, tol=1e-9)) if at.rows else 0
    order: Order = "not shown"
    if at.residual <= HOLDS and np.isfinite(at.gradient).all():
        order = "strict" if _is_strict(search, u, at) else "stationary"
    return Conditions(order, at.residual, tuple(_told(search, at.rows, at.multipliers)), rank == len(at.rows))


def sharpened(search: Search, u: Array) -> Array:
    """The case u (n,) after Newton steps within what the active limits leave free, as long as the first-order
    conditions are met better: a search ends where its goal no longer changes, which is half of the digits early."""
    at = _first_order(search, u)
    while not search.is_minimax:
        free = _free(at)
        curvature = free.T @ _hessian(search, u, at) @ free
        if not free.shape[1] or not np.isfinite(curvature).all() or np.linalg.eigvalsh(curvature).min() <= _CLEAR:
            break
        ahead = np.clip(u - free @ np.linalg.solve(curvature, free.T @ at.gradient), 0.0, 1.0)
        further = _first_order(search, ahead)
        if not further.residual < 0.5 * at.residual or search.missed(ahead) > max(KEPT, search.missed(u)):
            break
        u, at = ahead, further
    return u


@dataclass(frozen=True)
class _FirstOrder:
    """The first-order conditions at a case: A has a row for each active condition."""

    gradient: Array
    rows: list[_Row]
    A: Array
    multipliers: Array
    residual: float


def _first_order(search: Search, u: Array) -> _FirstOrder:
    gradient, rows = _system(search, u)
    optimize: Any = import_module("scipy.optimize")
    A = np.array([row.slope for row in rows]).reshape(len(rows), len(gradient))
    multipliers: Array = np.zeros(0)
    if rows:
        lower = np.array([-np.inf if row.is_equation else 0.0 for row in rows])
        found = optimize.lsq_linear(A.T, gradient, (lower, np.full(len(rows), np.inf)), tol=1e-14)
        multipliers = np.asarray(found.x, dtype=np.float64)
    scale = max(float(np.abs(gradient).max(initial=0.0)), 1.0 if search.is_minimax else 1e-3)
    residual = float(np.abs(gradient - A.T @ multipliers).max(initial=0.0)) / scale
    return _FirstOrder(gradient, rows, A, multipliers, residual)


def _system(search: Search, u: Array) -> tuple[Array, list[_Row]]:
    """The gradient of the goal, with that of the unknown z where a greatest value is least, and what is active."""
    problem, n = search.problem, search.problem.n
    size = n + int(search.is_minimax)
    rows: list[_Row] = []
    for k, limit in enumerate(problem.limits):
        rooms, slopes = search.rooms(k, u), search.room_slopes(k, u)
        is_equation = limit.relation == "="
        cost = -search.goal.sign * search.size * limit.sign / search.sizes[k]
        rows += [
            _Row(("limit", k), np.append(slopes[i], np.zeros(size - n)), is_equation, cost, i)
            for i in range(len(rooms))
            if is_equation or abs(rooms[i]) <= ACTIVE
        ]
    for k in range(n):
        e = np.eye(size)[k]
        per = search.goal.sign * search.size / float(problem.high[k] - problem.low[k])
        if u[k] <= ACTIVE:
            rows.append(_Row(("low", k), e, cost=per))
        if u[k] >= 1.0 - ACTIVE:
            rows.append(_Row(("high", k), -e, cost=-per))
    if not search.is_minimax:
        return search.objective_slope(u), rows
    values, slopes = search.goals(u), search.goal_slopes(u)
    for i in np.flatnonzero(values >= values.max() - ACTIVE):
        rows.append(_Row(("goal", 0), np.append(-slopes[i], 1.0), place=int(i)))
    return np.append(np.zeros(n), 1.0), rows


def _is_strict(search: Search, u: Array, at: _FirstOrder) -> bool:
    """Whether the second-order conditions are sufficient; a limit that is active and costs nothing leaves them open."""
    pairs = zip(at.rows, at.multipliers, strict=True)
    if not all(row.is_equation or m > _CLEAR for row, m in pairs):
        return False
    free = _free(at)
    if not free.shape[1]:
        return True
    reduced = free.T @ _hessian(search, u, at) @ free
    return bool(np.isfinite(reduced).all() and np.linalg.eigvalsh(reduced).min() > _CLEAR)


def _free(at: _FirstOrder) -> Array:
    """(n, n_free) directions along which the active conditions do not change."""
    size = len(at.gradient)
    if not at.rows:
        return np.eye(size)
    _u, s, vt = np.linalg.svd(at.A)
    return vt[int((s > 1e-9 * s.max(initial=1.0)).sum()) :].T


def _hessian(search: Search, u: Array, at: _FirstOrder) -> Array:
    """Of f - sum lambda c, by differences of exact gradients."""
    n, size = search.problem.n, len(at.gradient)
    H = np.zeros((size, size))
    for k in range(n):
        h = min(_STEP, max(u[k], 1.0 - u[k]))
        ahead, behind = u.copy(), u.copy()
        ahead[k], behind[k] = min(u[k] + h, 1.0), max(u[k] - h, 0.0)
        change = _lagrangian(search, ahead, at.rows, at.multipliers)
        change = change - _lagrangian(search, behind, at.rows, at.multipliers)
        H[:n, k] = change / (ahead[k] - behind[k])
    return 0.5 * (H + H.T)


def _lagrangian(search: Search, u: Array, rows: list[_Row], multipliers: Array) -> Array:
    """(n,) the gradient of f - sum lambda c with the multipliers as they are."""
    n = search.problem.n
    found = np.zeros(n) if search.is_minimax else search.objective_slope(u)
    known: dict[tuple[str, int], Array] = {}
    for row, m in zip(rows, multipliers, strict=True):
        kind, k = row.key
        if kind in ("low", "high"):
            found = found - m * row.slope[:n]
            continue
        if row.key not in known:
            known[row.key] = search.room_slopes(k, u) if kind == "limit" else -search.goal_slopes(u)
        found = found - m * known[row.key][row.place]
    return found


def _told(search: Search, rows: list[_Row], multipliers: Array) -> list[Active]:
    """One for each limit, that of its places together."""
    problem = search.problem
    sums: dict[tuple[str, int], tuple[float, float]] = {}
    for row, m in zip(rows, multipliers, strict=True):
        if row.key[0] != "goal":
            before = sums.get(row.key, (0.0, 0.0))
            sums[row.key] = before[0] + float(m), before[1] + float(m) * row.cost
    goal = search.goal.quantity
    found: list[Active] = []
    for (kind, k), (m, cost) in sums.items():
        if kind == "limit":
            limit = problem.limits[k]
            unit, text = str(goal.dimension / limit.quantity.dimension), limit.text
        else:
            v = problem.names[k]
            unit, end = str(goal.dimension / v.dimension), "lower" if kind == "low" else "upper"
            text = f"{end} bound of {v.name}"
        found.append(Active(text, m, cost, unit))
    return found
