"""A rough test that rules out inconsistent modes, all in one batch, so that few are left to be solved one by one.

Where rows are redundant, A + e D with two different diagonals D gives two solutions; what they agree on is determined,
and only that can rule a mode out. A condition fails if it is missed by much more than the two differ.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from freebody.numeric.contact.modes import Rules, coefficient
from freebody.numeric.contact.problem import Array, Mode, RowState
from freebody.numeric.contact.reduction import ReducedProblem

_FEW = 6
_ROUGH = 1e-6  # of the terms of a row: a condition that misses by more is met in no way
_TRUST = 100.0  # times what forces change by when twice as much is lent
_LENT = 1e-10  # to the unit diagonal, so that rows that depend on each other have one solution


def plausible(system: ReducedProblem, rules: Rules, modes: list[Mode]) -> list[Mode]:
    """The modes that are not ruled out; all of them if magnitudes make the equations nonlinear."""
    if len(modes) <= _FEW or any(f.groups for f in system.frictions):
        return modes
    states = np.array(modes, dtype=np.intp)
    slips = _signed_coefficients(system, rules, states)
    n = len(system.b)
    try:
        if system.is_regular:
            x = _solutions(system, states, slips, np.zeros(n))
            doubt = np.zeros_like(x)
        else:
            x = _solutions(system, states, slips, np.full(n, _LENT))
            doubt = np.abs(x - _solutions(system, states, slips, _LENT * np.linspace(1.0, 2.0, n)))
    except np.linalg.LinAlgError:
        return modes
    keep = _kept(system, states, x, doubt)
    return [mode for mode, kept in zip(modes, keep.tolist(), strict=True) if kept]


def _signed_coefficients(system: ReducedProblem, rules: Rules, states: NDArray[np.intp]) -> list[Array]:
    """For each rub c, -c or 0 in every mode: T = -c L."""
    found: list[Array] = []
    for friction in system.frictions:
        table = np.zeros(len(RowState))
        table[RowState.FORWARD] = coefficient(friction, RowState.FORWARD, rules)
        table[RowState.BACKWARD] = -coefficient(friction, RowState.BACKWARD, rules)
        found.append(table[states[:, friction.row]])
    return found


def _solutions(system: ReducedProblem, states: NDArray[np.intp], slips: list[Array], lent: Array) -> Array:
    """The forces of every mode, (n_modes, n)."""
    n = len(system.b)
    at_rest = (states == RowState.CLOSED) | (states == RowState.STICKING)
    G = np.where(at_rest[:, :, None], system.A + np.diag(lent), np.eye(n))
    r = np.where(at_rest, -system.b, 0.0)
    for friction, c in zip(system.frictions, slips, strict=True):
        r[:, friction.row] -= c * friction.constant
        for j, weight in friction.pressing:
            G[:, friction.row, j] += c * weight
    return np.linalg.solve(G, r[:, :, None])[:, :, 0]


def _kept(system: ReducedProblem, states: NDArray[np.intp], x: Array, doubt: Array) -> NDArray[np.bool_]:
    a = x @ system.A + system.b
    sizes = np.abs(x) @ system.magnitude + system.size
    rough = _ROUGH * sizes
    # numpy compares NaN as false, so a mode is ruled out only by numbers
    loose_x = rough + _TRUST * doubt
    loose_a = rough + _TRUST * (doubt @ system.magnitude)
    failed = ((states == RowState.CLOSED) & (x < -loose_x)) | ((states == RowState.OPEN) & (a < -loose_a))
    for friction in system.frictions:
        if friction.rub.sliding:
            continue
        i = friction.row
        state, T = states[:, i], x[:, i]
        load, looser = np.full(len(x), friction.constant), loose_x[:, i].copy()
        for j, weight in friction.pressing:
            load += weight * x[:, j]
            looser += abs(weight) * max(friction.rub.static) * loose_x[:, j]
        forward, backward = friction.rub.static
        outside = (T + forward * load < -looser) | (T - backward * load > looser)
        failed[:, i] |= (state == RowState.STICKING) & outside
        failed[:, i] |= (state == RowState.FORWARD) & (a[:, i] < -loose_a[:, i])
        failed[:, i] |= (state == RowState.BACKWARD) & (a[:, i] > loose_a[:, i])
    return ~failed.any(axis=1)
