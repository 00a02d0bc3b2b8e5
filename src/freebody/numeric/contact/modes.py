"""One mode of a contact problem: its forces, and whether they meet every condition.

A mode turns every condition into an equation:

    held, closed, sticking   a = 0        open, absent   lambda = 0        slipping   T = -s c L

A magnitude |v| in a load is replaced by g.v with g = v/|v|, which is Newton's step, and solved until it stays.
Equations are singular where rows are redundant; then the forces are the least that all cones admit.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from itertools import product
from typing import Any

import numpy as np

from freebody.numeric.contact.least import least_within
from freebody.numeric.contact.problem import SLIPPING, Array, Choice, Mode, RowState
from freebody.numeric.contact.reduction import ReducedFriction, ReducedProblem, direction, magnitude_slope
from freebody.tolerances import ROUND_OFF, ROUNDED

TOLERANCE = 1e-11  # of the terms of a row: what its condition may miss by round-off
_LOOSER = 1e3  # inequalities of a row that stands at an event, where its state was forced
_FLOOR = 1e-14  # the same, of the terms of the largest row
_RANK = ROUNDED  # singular values below this part of the largest are none, for every row
_SETTLED = 1e-13  # relative, of forces from one round to the next: in their last digits
_ROUNDS = 60


@dataclass(frozen=True, slots=True)
class Rules:
    """What the search may choose: forbidden (reduced row, state), and the rubs (by reduced row) that slip for good,
    with kinetic coefficients. All other rubs at rest slip with static ones."""

    forbidden: frozenset[Choice] = frozenset()
    slipping: tuple[Choice, ...] = ()
    is_kinetic: bool = False  # whether every slip has its kinetic coefficient

    def allows(self, row: int, state: RowState) -> bool:
        return (row, state) not in self.forbidden and all(r != row or s == state for r, s in self.slipping)


@dataclass(frozen=True, slots=True)
class ModeSolution:
    """A consistent mode of the reduced rows."""

    mode: Mode
    x: Array
    a: Array


def coefficient(friction: ReducedFriction, state: RowState, rules: Rules) -> float:
    """The coefficient with which a rub slips: static only where a rub at rest is asked whether it starts at all."""
    rub = friction.rub
    pair = rub.kinetic if rub.sliding or rules.is_kinetic or (friction.row, state) in rules.slipping else rub.static
    return pair[state is RowState.BACKWARD]


def is_pressed(friction: ReducedFriction, mode: Iterable[RowState]) -> bool:
    """Whether the load can differ from zero in a mode of the normals."""
    states = tuple(mode)
    return friction.is_always_loaded or any(states[j] is RowState.CLOSED for j in friction.normals)


def solve_mode(reduced: ReducedProblem, mode: Mode, rules: Rules, turned: float = 1.0) -> ModeSolution | None:
    """The consistent forces of a mode, if any. Magnitudes start along the forces without friction, times `turned`."""
    x = np.zeros(len(mode))
    has_magnitudes = any(f.groups and mode[f.row] in SLIPPING for f in reduced.frictions)
    for k in range(_ROUNDS if has_magnitudes else 1):
        G, r = _equations(reduced, mode, rules, x, 1.0 if k else turned)
        found, null_space = _solved(G, r, reduced.is_regular)
        if found is None:
            return None
        _clear(mode, found, null_space)
        if not has_magnitudes:
            return _consistent(reduced, mode, rules, found, null_space)
        moved = float(np.abs(found - x).max())
        x = found
        if moved <= _SETTLED * (1.0 + float(np.abs(x).max())):
            return _consistent(reduced, mode, rules, x, null_space)
    return None


def worst_changed(reduced: ReducedProblem, mode: Mode, rules: Rules) -> list[Mode]:
    """Modes in which one row is changed that breaks its condition in the given one, the worst first."""
    G, r = _equations(reduced, mode, rules, np.zeros(len(mode)), 1.0)
    x, null_space = _solved(G, r, reduced.is_regular)
    if x is None:
        return []
    _clear(mode, x, null_space)
    a = reduced.A @ x + reduced.b
    sizes = reduced.magnitude @ np.abs(x) + reduced.size
    wanted: list[tuple[float, int, RowState]] = []
    for i in range(reduced.n_normals):
        other = RowState.OPEN if mode[i] is RowState.CLOSED else RowState.CLOSED
        wanted.append((-float(x[i] if mode[i] is RowState.CLOSED else a[i]), i, other))
    for friction in reduced.frictions:
        i, state = friction.row, mode[friction.row]
        if state is RowState.STICKING:
            load, T = max(0.0, friction.load(x.tolist(), x)), float(x[i])
            forward, backward = friction.rub.static
            wanted.append((T - backward * load, i, RowState.BACKWARD))
            wanted.append((-T - forward * load, i, RowState.FORWARD))
        elif state in SLIPPING and not friction.rub.sliding:
            wanted.append((-float(a[i]) if state is RowState.FORWARD else float(a[i]), i, RowState.STICKING))
    tolerance = (TOLERANCE * sizes).tolist()
    broken = sorted(((w, i, s) for w, i, s in wanted if w > tolerance[i] and rules.allows(i, s)), reverse=True)
    return [(*mode[:i], state, *mode[i + 1 :]) for _w, i, state in broken]


def _equations(reduced: ReducedProblem, mode: Mode, rules: Rules, x: Array, turned: float) -> tuple[Array, Array]:
    G, r = reduced.A.copy(), -reduced.b
    for i in range(reduced.n_normals):
        if mode[i] is RowState.OPEN:
            G[i] = 0.0
            G[i, i], r[i] = 1.0, 0.0
    for friction in reduced.frictions:
        i, state = friction.row, mode[friction.row]
        if state is RowState.STICKING:
            continue
        G[i] = 0.0
        G[i, i], r[i] = 1.0, 0.0
        if state is RowState.ABSENT:
            continue
        c = coefficient(friction, state, rules) * (1.0 if state is RowState.FORWARD else -1.0)
        r[i] = -c * friction.constant
        for j, weight in friction.pressing:
            G[i, j] += c * weight
        for group in friction.groups:
            constant, slope = magnitude_slope(group, turned * direction(group, x))
            r[i] -= c * constant
            G[i] += c * slope
    return G, r


def _solved(G: Array, r: Array, is_regular: bool) -> tuple[Array | None, Array | None]:
    """Forces, and the null space if the equations have one; no forces if they contradict each other."""
    size = float(np.abs(r).max(initial=0.0))
    if size == 0.0 and is_regular:
        return np.zeros(len(r)), None
    if is_regular:
        try:
            solved: Any = np.linalg.solve(G, r)
        except np.linalg.LinAlgError:
            return None, None
        return (solved, None) if np.abs(solved).max() <= 1e12 * size else (None, None)
    U, values, V = np.linalg.svd(G)
    kept = values > _RANK * len(r) * values[0]
    x = V[kept].T @ ((U[:, kept].T @ r) / values[kept])
    if np.abs(G @ x - r).max() > ROUND_OFF * max(size, float(np.abs(x).max())):
        return None, None
    return x, (V[~kept].T if not kept.all() else None)


def _clear(mode: Mode, x: Array, null_space: Array | None) -> None:
    """Rows that carry nothing carry exactly nothing."""
    for i, state in enumerate(mode):
        if state in (RowState.OPEN, RowState.ABSENT):
            x[i] = 0.0
            if null_space is not None:
                null_space[i] = 0.0


def _consistent(
    reduced: ReducedProblem, mode: Mode, rules: Rules, x: Array, null_space: Array | None
) -> ModeSolution | None:
    if null_space is None:
        return checked(reduced, mode, rules, x)
    return checked(reduced, mode, rules, x) or _spread(reduced, mode, rules, x, null_space)


def checked(reduced: ReducedProblem, mode: Mode, rules: Rules, x: Array) -> ModeSolution | None:
    """The forces as a solution, if they meet every condition of the mode to `TOLERANCE` of the terms of each row."""
    a = reduced.A @ x + reduced.b
    # a rub along a way that is prescribed moves nothing, and has a force all the same
    sizes = np.maximum(reduced.magnitude @ np.abs(x) + reduced.size, np.abs(x))
    tolerance = (TOLERANCE * sizes + _FLOOR * sizes.max(initial=0.0)).tolist()
    forced = {row for row, _ in rules.forbidden}
    forces, accelerations = x.tolist(), a.tolist()
    for i in range(reduced.n_normals):
        slack = tolerance[i] * (_LOOSER if i in forced else 1.0)
        if mode[i] is RowState.CLOSED:
            if forces[i] < -slack or abs(accelerations[i]) > tolerance[i]:
                return None
        elif accelerations[i] < -slack or forces[i] != 0.0:
            return None
    for friction in reduced.frictions:
        i = friction.row
        if mode[i] is RowState.ABSENT:
            if forces[i] != 0.0:
                return None
            continue
        load = friction.load(forces, x if friction.groups else None)
        load_slack = sum(abs(weight) * tolerance[j] for j, weight in friction.pressing)
        slack = tolerance[i], load_slack, _LOOSER if i in forced else 1.0
        if load < -load_slack - tolerance[i]:
            return None
        if not _rubs_rightly(friction, mode[i], rules, forces[i], accelerations[i], load, slack):
            return None
    return ModeSolution(mode, x, a)


def _rubs_rightly(
    friction: ReducedFriction,
    state: RowState,
    rules: Rules,
    T: float,
    a: float,
    load: float,
    slack: tuple[float, float, float],
) -> bool:
    """Friction's conditions. slack: of the row, of the load, and the factor of inequalities at an event."""
    own, of_load, factor = slack
    if state is RowState.STICKING:
        forward, backward = friction.rub.static
        above = T - backward * load - (own + backward * of_load) * factor
        below = -T - forward * load - (own + forward * of_load) * factor
        return above <= 0.0 and below <= 0.0 and abs(a) <= own
    sign = 1.0 if state is RowState.FORWARD else -1.0
    c = coefficient(friction, state, rules)
    is_at_limit = abs(T + sign * c * load) <= own + c * of_load
    return is_at_limit and (bool(friction.rub.sliding) or sign * a >= -own * factor)


def _spread(reduced: ReducedProblem, mode: Mode, rules: Rules, x: Array, Z: Array) -> ModeSolution | None:
    """The least forces x + Z y in all cones; magnitudes in the loads of sticking rubs stay as at x."""
    rows: list[Array] = []
    bounds: list[float] = []
    for i in range(reduced.n_normals):
        if mode[i] is RowState.CLOSED:
            rows.append(Z[i])
            bounds.append(-float(x[i]))
    for friction in reduced.frictions:
        if mode[friction.row] is not RowState.STICKING:
            continue
        load, T = friction.load(x.tolist(), x), float(x[friction.row])
        slope = sum((weight * Z[j] for j, weight in friction.pressing), np.zeros(Z.shape[1]))
        forward, backward = friction.rub.static
        rows += [Z[friction.row] + forward * slope, backward * slope - Z[friction.row]]
        bounds += [-T - forward * load, T - backward * load]
    if not rows:
        return None
    size = float(np.abs(x).max()) or 1.0
    y = least_within(np.array(rows), np.array(bounds) / size)
    return checked(reduced, mode, rules, x + size * (Z @ y)) if y is not None else None


def all_modes(reduced: ReducedProblem, rules: Rules) -> list[Mode]:
    """Every mode that the rules allow, lasting contact first."""
    normals = [[s for s in (RowState.CLOSED, RowState.OPEN) if rules.allows(i, s)] for i in range(reduced.n_normals)]
    modes: list[Mode] = []
    for gaps in product(*normals):
        choices = [rub_states(friction, gaps, rules) for friction in reduced.frictions]
        modes += [(*gaps, *rest) for rest in product(*choices)]
    return sorted(modes, key=departures)


def rub_states(friction: ReducedFriction, gaps: tuple[RowState, ...], rules: Rules) -> list[RowState]:
    """The states a rub may have with the normals in the given ones."""
    if not is_pressed(friction, gaps):
        return [RowState.ABSENT]
    if friction.rub.sliding:
        return [RowState.FORWARD if friction.rub.sliding > 0 else RowState.BACKWARD]
    return [s for s in (RowState.STICKING, *SLIPPING) if rules.allows(friction.row, s)]


def n_modes(reduced: ReducedProblem) -> int:
    """An upper bound for the length of `all_modes`: a rub of one normal has states only while that is closed."""
    closed, count = [1] * reduced.n_normals, 1
    for friction in reduced.frictions:
        n_states = 1 if friction.rub.sliding else 3
        if len(friction.normals) == 1 and not friction.is_always_loaded:
            closed[friction.normals[0]] *= n_states
        else:
            count *= n_states
    for n_states in closed:
        count *= 1 + n_states
    return count


def departures(mode: Mode) -> tuple[int, int]:
    """How many contacts end, and how many rubs slip."""
    return sum(s is RowState.OPEN for s in mode), sum(s in SLIPPING for s in mode)
