"""The planar Coulomb law as a linear complementarity problem.

With limits -f L <= T <= g L of a rub at rest, let x = T + f L >= 0 and split its acceleration, a = a+ - a-:

    0 <= a+ _|_ x = T + f L >= 0           0 <= a- _|_ y = (f + g) L - x >= 0           0 <= N _|_ a_N >= 0

so that w = (a_N, a+, y), z = (N, x, a-) are complementary and w is affine in z. A rub that slips has T = -s c L.
Source: Pfeiffer & Glocker, Multibody Dynamics with Unilateral Contacts (1996), ch. 6.
"""

from __future__ import annotations

import numpy as np

from freebody.numeric.contact.complementarity import lemke
from freebody.numeric.contact.modes import Rules, coefficient, is_pressed, rub_states
from freebody.numeric.contact.problem import SLIPPING, Array, Mode, RowState
from freebody.numeric.contact.reduction import ReducedFriction, ReducedProblem

_ROUNDS = 40
_SETTLED = 1e-13  # relative, of magnitudes from one round to the next: in their last digits
_NONE = 1e-10  # of the largest terms: an acceleration, or a force within its cone, that is none


def lemke_guess(reduced: ReducedProblem, rules: Rules) -> tuple[Array, Mode] | None:
    """Forces (n_free,) and the mode that Lemke's pivots end at, or None. Magnitudes are iterated as constants."""
    magnitudes = _magnitudes(reduced, np.zeros(len(reduced.rows)))
    found: tuple[Array, Mode] | None = None
    for _ in range(_ROUNDS):
        found = _pivoted(reduced, rules, magnitudes)
        if found is None:
            return None
        renewed = _magnitudes(reduced, found[0])
        if np.abs(renewed - magnitudes).max(initial=0.0) <= _SETTLED * (1.0 + np.abs(renewed).max(initial=0.0)):
            return found
        magnitudes = renewed
    return found


def _magnitudes(reduced: ReducedProblem, x: Array) -> Array:
    """What the magnitudes add to the load of every rub."""
    return np.array([sum(float(np.linalg.norm(p + Q @ x)) for p, Q in f.groups) for f in reduced.frictions])


def _pivoted(reduced: ReducedProblem, rules: Rules, magnitudes: Array) -> tuple[Array, Mode] | None:
    """Forces (n_free,) and mode by one pivoting; magnitudes (n_frictions,): the loads |v| of the round before."""
    n = len(reduced.rows)
    normals = [i for i in range(reduced.n_normals) if rules.allows(i, RowState.CLOSED)]
    gaps = tuple(RowState.CLOSED if i in normals else RowState.OPEN for i in range(reduced.n_normals))
    undecided: list[tuple[ReducedFriction, Array, float]] = []  # with W and l0 of L = W N + l0
    # x = x0 + S (N, T + f L of the undecided rubs)
    x0 = np.zeros(n)
    S = np.zeros((n, len(normals) + len(reduced.frictions)))
    for k, i in enumerate(normals):
        S[i, k] = 1.0
    # a rub that nothing presses has no part; one that slips follows its load; the others have limits on both sides
    for friction, magnitude in zip(reduced.frictions, magnitudes.tolist(), strict=True):
        states = rub_states(friction, gaps, rules)
        if states == [RowState.ABSENT]:
            continue
        weights = sum((weight * S[j] for j, weight in friction.pressing), np.zeros(S.shape[1]))
        constant = friction.constant + magnitude
        if len(states) == 1 and states[0] in SLIPPING:
            lower = coefficient(friction, states[0], rules) * (1.0 if states[0] is RowState.FORWARD else -1.0)
        else:
            lower = coefficient(friction, RowState.FORWARD, rules)
            S[friction.row, len(normals) + len(undecided)] = 1.0
            undecided.append((friction, weights, constant))
        S[friction.row] -= lower * weights
        x0[friction.row] = -lower * constant
    return _solved(reduced, rules, normals, undecided, x0, S[:, : len(normals) + len(undecided)])


def _solved(
    reduced: ReducedProblem,
    rules: Rules,
    normals: list[int],
    undecided: list[tuple[ReducedFriction, Array, float]],
    x0: Array,
    S: Array,
) -> tuple[Array, Mode] | None:
    """w = M z + q with z = (N, x, a-) (m + 2 k), solved, and what its signs say of every row."""
    m, k = len(normals), len(undecided)
    dry_friction = [f.row for f, _, _ in undecided]
    width = np.array([sum(coefficient(f, s, rules) for s in SLIPPING) for f, _, _ in undecided])
    M = np.zeros((m + 2 * k, m + 2 * k))
    q = np.zeros(m + 2 * k)
    # the first rows: accelerations of normals, and a+ = a + a- of undecided rubs
    b = reduced.A @ x0 + reduced.b
    decided = normals + dry_friction
    M[: m + k, : m + k] = reduced.A[decided] @ S
    q[: m + k] = b[decided]
    # the last: how far the other limit is, (f + g) L - x
    if k:
        M[m : m + k, m + k :] = np.eye(k)
        M[m + k :, : m + k] = width[:, None] * np.array([weights[: m + k] for _, weights, _ in undecided])
        M[m + k :, m : m + k] -= np.eye(k)
        q[m + k :] = width * np.array([constant for _, _, constant in undecided])
    found = lemke(M, q)
    if not found.is_solved:
        return None
    # states by what is positive: the gap opens, the rub slips forward, or backward
    x = x0 + S @ found.z[: m + k]
    small = _NONE * float((np.abs(reduced.A) @ np.abs(x) + reduced.size).max(initial=0.0))
    states = [RowState.OPEN] * reduced.n_normals + [RowState.ABSENT] * len(reduced.frictions)
    for i, w in zip(normals, found.w[:m].tolist(), strict=True):
        states[i] = RowState.CLOSED if w <= small else RowState.OPEN
    gaps = tuple(states[: reduced.n_normals])
    for friction in reduced.frictions:
        if is_pressed(friction, gaps):
            states[friction.row] = rub_states(friction, gaps, rules)[0]
    for j, (friction, _, _) in enumerate(undecided):
        if states[friction.row] is RowState.ABSENT:
            continue
        if found.w[m + j] > small:
            states[friction.row] = RowState.FORWARD
        elif found.z[m + k + j] > small:
            states[friction.row] = RowState.BACKWARD
    return x, tuple(states)
