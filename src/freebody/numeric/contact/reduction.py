"""A contact problem without its held rows, with unit diagonal.

    a_B = A_BB l_B + A_BU l_U + b_B = 0     =>     l_B = p + Q l_U,  p = -A_BB^+ b_B,  Q = -A_BB^+ A_BU

Redundant held rows are consistent, so the pseudo-inverse loses nothing; their forces are those of least norm, by
`lengths` where these are given. With
D = diag(A)^(-1/2) of what is left the problem D A D, D b in l/D has a unit diagonal: units and masses are gone.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from math import hypot

import numpy as np
from numpy.typing import NDArray

from freebody.numeric.contact.problem import Array, ContactProblem, FrictionProblemRow
from freebody.tolerances import LEAST, ROUND_OFF, ROUNDED

RANK = ROUNDED  # of a matrix with unit diagonal
_CONSISTENT = ROUND_OFF  # of the terms of an equation: what it may miss
_SMALL = 1e-6  # of the diagonal of a row: what is left of it may be round-off, which is looked at
_PIVOT = 1e-5  # pivots of a matrix with unit diagonal that is solved to six digits: its condition is 1e10 at most


@dataclass(frozen=True, slots=True)
class ReducedFriction:
    """A rub in reduced rows: its load divided by the scale of its force.

    `pressing`: (reduced row, weight) of every force in it; `normals`: the reduced rows that must be closed for a load,
    if it is of normals alone; `groups`: of each magnitude |p + Q x| the p, (k,), and Q, (k, n_free).
    """

    row: int
    rub: FrictionProblemRow
    constant: float
    pressing: tuple[tuple[int, float], ...]
    normals: tuple[int, ...]
    is_always_loaded: bool
    groups: tuple[tuple[Array, Array], ...]

    def load(self, x: list[float], vector: Array | None = None) -> float:
        load = self.constant
        for j, weight in self.pressing:
            load += weight * x[j]
        for p, Q in self.groups:
            load += float(np.linalg.norm(p + Q @ (np.asarray(x) if vector is None else vector)))
        return load


@dataclass(frozen=True, slots=True)
class ReducedProblem:
    """Unit-diagonal rows of normals, then rubs: A x + b. `size` is what the terms of b come to, by which it rounds."""

    problem: ContactProblem
    rows: NDArray[np.intp]
    held: NDArray[np.intp]
    scale: Array
    A: Array
    b: Array
    size: Array
    p: Array
    Q: Array
    frictions: tuple[ReducedFriction, ...]
    is_regular: bool
    is_consistent: bool
    magnitude: Array = field(repr=False)

    @property
    def n_normals(self) -> int:
        return len(self.problem.normals)

    def forces(self, x: Array) -> Array:
        """The multipliers of all rows of the problem."""
        if not len(self.held):
            full = np.empty(self.problem.n)
            full[self.rows] = self.scale * x
            return full
        full = np.zeros(self.problem.n)
        full[self.rows] = self.scale * x
        full[self.held] = self.p + self.Q @ x
        return full


def reduced(problem: ContactProblem) -> ReducedProblem:
    """Eliminates held rows and scales. `is_consistent` is false if the held rows contradict each other."""
    # D makes the diagonal of A one; a row that nothing moves keeps its units
    A, b = problem.A, problem.b
    rows = np.array(problem.free_rows, dtype=np.intp)
    held = np.array(problem.held_rows, dtype=np.intp)
    diagonal = A.diagonal()
    D = 1.0 / np.sqrt(np.where(diagonal > 0.0, diagonal, 1.0))
    # Schur complement on the free rows (n_free, n_free), with the sizes of the terms by which it is rounded
    coupling = A[np.ix_(rows, held)]
    p, Q, is_consistent = _held_forces(A, b, D, rows, held, problem.lengths)
    free, right, size = A[np.ix_(rows, rows)], b[rows], np.abs(b[rows])
    if len(held):
        free, right, size = free + coupling @ Q, right + coupling @ p, size + np.abs(coupling) @ np.abs(p)
        # what is left of a row that pushes a light body which is held, a roller without mass, is far below its diagonal
        left = free.diagonal()
        if (left <= _SMALL * diagonal[rows]).any():
            free, right = _without_carried(free, right, size, A, p, Q, rows, held)
            left = free.diagonal()
        D[rows] = 1.0 / np.sqrt(np.where(left > ROUNDED * diagonal[rows], left, D[rows] ** -2.0))
    scale = D[rows]
    scaled = scale[:, None] * (0.5 * (free + free.T)) * scale
    return ReducedProblem(
        problem=problem,
        rows=rows,
        held=held,
        scale=scale,
        A=scaled,
        b=scale * right,
        size=scale * size,
        p=p,
        Q=Q * scale,
        frictions=_frictions(problem, D, held, p, Q * scale),
        is_regular=_is_regular(scaled),
        is_consistent=is_consistent,
        magnitude=np.abs(scaled),
    )


def _held_forces(
    A: Array, b: Array, D: Array, rows: NDArray[np.intp], held: NDArray[np.intp], lengths: Array | None
) -> tuple[Array, Array, bool]:
    """p and Q of l_B = p + Q l_U, and whether the held rows can all keep their accelerations. Of forces that are not
    unique those that `lengths` make the least."""
    if not len(held):
        return np.zeros(0), np.zeros((0, len(rows))), True
    scale = D[held]
    idle = np.zeros((len(held), 0))  # forces that do nothing together
    A_B = scale[:, None] * A[np.ix_(held, held)] * scale
    right = -scale[:, None] * np.hstack([b[held, None], A[np.ix_(held, rows)]])
    if _is_regular(A_B):
        solved = np.linalg.solve(A_B, right)
    else:
        values, vectors = np.linalg.eigh(A_B)
        kept = values > RANK * len(held) * max(1.0, float(values[-1]))
        basis = vectors[:, kept]
        solved = basis @ ((basis.T @ right) / values[kept, None])
        idle = scale[:, None] * vectors[:, ~kept]
    left_over = np.abs(A_B @ solved[:, 0] - right[:, 0])
    terms = np.abs(A_B) @ np.abs(solved[:, 0]) + np.abs(right[:, 0])
    is_consistent = bool((left_over <= _CONSISTENT * max(float(terms.max()), LEAST)).all())
    solved = scale[:, None] * solved
    if idle.shape[1] and lengths is not None:
        h = lengths[held, None]
        solved -= idle @ np.linalg.lstsq(h * idle, h * solved, rcond=ROUNDED)[0]
    return solved[:, 0], solved[:, 1:], is_consistent


def _without_carried(
    free: Array, right: Array, size: Array, A: Array, p: Array, Q: Array, rows: NDArray[np.intp], held: NDArray[np.intp]
) -> tuple[Array, Array]:
    """The Schur complement where a row is a combination of held ones, J_i = -Q_i J_B: a contact at a body that joints
    keep where it is. Its force moves nothing and its acceleration is theirs, so that both entries are zero, and not
    what is left of terms that cancel: those of A_ii + A_iB Q_i + Q_i (A_BB Q_i + A_Bi), which are as large as 1/m of
    the mass that a body without any is lent, as those of b_i + A_iB p + Q_i A_BB p are."""
    through = np.abs(Q.T) @ np.abs(A[np.ix_(held, held)])
    terms = A.diagonal()[rows] + ((np.abs(A[np.ix_(rows, held)]) + through) * np.abs(Q.T)).sum(axis=1)
    carried = free.diagonal() <= ROUNDED * terms
    still = carried & (np.abs(right) <= ROUND_OFF * size + ROUNDED * (through @ np.abs(p)))
    free = np.where(carried[:, None] | carried, 0.0, free)
    return free, np.where(still, 0.0, right)


def _is_regular(A: Array) -> bool:
    """Whether a scaled positive semidefinite matrix has pivots well above rounding."""
    try:
        return bool((np.linalg.cholesky(A).diagonal() > _PIVOT).all())
    except np.linalg.LinAlgError:
        return False


def _frictions(
    problem: ContactProblem, D: Array, held: NDArray[np.intp], p: Array, Q: Array
) -> tuple[ReducedFriction, ...]:
    """The rubs in reduced rows. The magnitudes of free rows are plain slopes as well."""
    place = {row: k for k, row in enumerate(problem.free_rows)}
    held_place = {int(row): k for k, row in enumerate(held)}
    found: list[ReducedFriction] = []
    for rub in problem.dry_friction:
        s = float(D[rub.row])
        # the load as constant + slope.l of the free rows: held rows among the normals are put in by p and Q
        normals = tuple(place[j] for j in rub.normals if j in place)
        slope, constant = np.zeros(len(place)), rub.constant / s
        for j in rub.normals:
            if j in place:
                slope[place[j]] += D[j] / s
            else:
                slope += Q[held_place[j]] / s
                constant += float(p[held_place[j]]) / s
        pressing = tuple((j, weight) for j, weight in enumerate(slope.tolist()) if weight)
        is_always_loaded = rub.is_always_loaded or len(normals) < len(rub.normals)
        # magnitudes |start + slopes l|, (n_group,) and (n_group, n_free)
        groups: list[tuple[Array, Array]] = []
        for group in rub.magnitudes:
            start, slopes = np.zeros(len(group)), np.zeros((len(group), len(place)))
            for i, row in enumerate(group):
                if row in held_place:
                    start[i], slopes[i] = p[held_place[row]] / s, Q[held_place[row]] / s
                else:
                    slopes[i, place[row]] = D[row] / s
            groups.append((start, slopes))
        found.append(ReducedFriction(place[rub.row], rub, constant, pressing, normals, is_always_loaded, tuple(groups)))
    return tuple(found)


def magnitude_slope(group: tuple[Array, Array], direction: Array) -> tuple[float, Array]:
    """|v| is homogeneous, so with a unit vector g along v it equals g.v = g.p + (g.Q) x."""
    p, Q = group
    return float(direction @ p), direction @ Q


def direction(group: tuple[Array, Array], x: Array) -> Array:
    """The unit vector along a group's multipliers, zero where they vanish."""
    p, Q = group
    v = p + Q @ x
    size = hypot(*v.tolist())
    return v / size if size > 0.0 else np.zeros_like(v)
