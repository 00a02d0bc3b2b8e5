"""Linear complementarity: w = M z + q, w >= 0, z >= 0, z.w = 0, by Lemke's pivots.

An artificial variable z0 >= 0 enters, w = M z + d z0 + q, where d > 0. From then on the complement of the variable that
left enters, until z0 leaves (solved) or nothing blocks (a ray). Ties are broken lexicographically, so no basis returns.
Source: Cottle, Pang & Stone, The Linear Complementarity Problem (1992), sec. 4.4 and 4.9.
"""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum

import numpy as np
from numpy.typing import NDArray

from freebody.tolerances import LEAST, ROUNDED

Array = NDArray[np.float64]

_PIVOT = ROUNDED  # entries of the equilibrated column below are zero
_TIE = 1e-13  # relative, of ratios: those that are the least but for the last digits leave by the order of the rows


class Ended(Enum):
    """How the pivots ended."""

    SOLVED = "solved"
    RAY = "ended on a ray: no solution was found this way"
    TOO_MANY_PIVOTS = "too many pivots"
    INACCURATE = "a solution, whose residual is above tolerance"


@dataclass(frozen=True, slots=True)
class Complementary:
    """z and w, (n,) each; `residual`: the worst violation, relative to the terms of its row."""

    ended: Ended
    z: Array
    w: Array
    residual: float
    n_pivots: int

    @property
    def is_solved(self) -> bool:
        return self.ended is Ended.SOLVED


def lemke(M: Array, q: Array, *, max_pivots: int | None = None, tolerance: float = 1e-10) -> Complementary:
    """Solves the complementarity problem of M (n, n) and q (n,). Never raises for lack of a solution: see `ended`."""
    n = len(q)
    if not (np.isfinite(M).all() and np.isfinite(q).all()):  # a row without a value: nothing solves it
        return Complementary(Ended.RAY, np.full(n, np.nan), np.full(n, np.nan), np.inf, 0)
    if n == 0 or bool((q >= 0.0).all()):
        return _judged(M, q, np.zeros(n), Ended.SOLVED, 0, tolerance)
    rows, columns = _equilibrated(M)
    scaled_M, scaled_q = rows[:, None] * M * columns, rows * q
    basis, ended, n_pivots = _pivoted(scaled_M, scaled_q / np.abs(scaled_q).max(), max_pivots or 50 * (n + 1))
    if ended is not Ended.SOLVED:
        return Complementary(ended, np.full(n, np.nan), np.full(n, np.nan), np.inf, n_pivots)
    active = np.array(sorted(k - n for k in basis if n <= k < 2 * n), dtype=np.intp)
    z = np.zeros(n)
    if len(active):
        # solved again from the data, so that rounding of the pivots is gone
        block = scaled_M[np.ix_(active, active)]
        z[active] = columns[active] * np.linalg.lstsq(block, -scaled_q[active], rcond=1e-13)[0]
    return _judged(M, q, z, ended, n_pivots, tolerance)


def _equilibrated(M: Array) -> tuple[Array, Array]:
    """Positive factors of rows and columns that bring the largest entries near 1 (Ruiz). Signs of z and w are kept."""
    rows, columns = np.ones(len(M)), np.ones(len(M))
    for _ in range(4):
        size = np.abs(rows[:, None] * M * columns)
        largest_in_row, largest_in_column = size.max(axis=1), size.max(axis=0)
        rows /= np.sqrt(np.where(largest_in_row > 0.0, largest_in_row, 1.0))
        columns /= np.sqrt(np.where(largest_in_column > 0.0, largest_in_column, 1.0))
    return rows, columns


def _pivoted(M: Array, q: Array, max_pivots: int) -> tuple[list[int], Ended, int]:
    """The final basis (w is 0..n-1, z is n..2n-1, z0 is 2n) and how it came about."""
    n = len(q)
    artificial = 2 * n
    # I w - M z - d z0 = q; the first n columns become the inverse of the basis
    tableau = np.hstack([np.eye(n), -M, -np.ones((n, 1)), q[:, None]])
    basis = list(range(n))
    row = _first_row(q)
    entering = artificial
    for count in range(1, max_pivots + 1):
        leaving = basis[row]
        _pivot(tableau, row, entering)
        basis[row] = entering
        if leaving == artificial:
            return basis, Ended.SOLVED, count
        entering = leaving + n if leaving < n else leaving - n
        chosen = _blocking_row(tableau, entering, basis, artificial)
        if chosen is None:
            return basis, Ended.RAY, count
        row = chosen
    return basis, Ended.TOO_MANY_PIVOTS, max_pivots


def _pivot(tableau: Array, row: int, column: int) -> None:
    tableau[row] /= tableau[row, column]
    factors = tableau[:, column].copy()
    factors[row] = 0.0
    tableau -= factors[:, None] * tableau[row]


def _first_row(q: Array) -> int:
    """The last of the least entries: lexicographically least, as the rows of [q, I] with d = 1 compare."""
    return int(np.flatnonzero(q <= q.min() + _TIE)[-1])


def _blocking_row(tableau: Array, entering: int, basis: list[int], artificial: int) -> int | None:
    """The row whose [q, B^-1]/pivot is lexicographically least; among rounding ties z0 leaves first."""
    n = len(basis)
    column = tableau[:, entering]
    rows = np.flatnonzero(column > _PIVOT)
    if not len(rows):
        return None
    rows = _least(rows, np.maximum(tableau[rows, -1], 0.0) / column[rows])
    for row in rows:
        if basis[row] == artificial:
            return int(row)
    for k in range(n):
        if len(rows) == 1:
            break
        rows = _least(rows, tableau[rows, k] / column[rows])
    return int(rows[0])


def _least(rows: NDArray[np.intp], ratios: Array) -> NDArray[np.intp]:
    least = ratios.min()
    return rows[ratios <= least + _TIE * max(1.0, abs(float(least)))]


def _judged(M: Array, q: Array, z: Array, ended: Ended, n_pivots: int, tolerance: float) -> Complementary:
    """Clips what rounding left, and measures z.w = 0 and the signs against the size of the terms."""
    w = M @ z + q
    size = np.abs(M) @ np.abs(z) + np.abs(q)
    size += 1e-4 * size.max(initial=0.0) + LEAST  # a row whose terms all vanish is rounded as the others
    largest_z = float(np.abs(z).max(initial=0.0)) or 1.0
    gap = np.minimum(w / size, z / largest_z)  # 0 where complementary, negative where a sign is wrong
    residual = float(np.abs(gap).max(initial=0.0))
    if residual > tolerance:
        return Complementary(Ended.INACCURATE, z, w, residual, n_pivots)
    at_z = z / largest_z > w / size
    return Complementary(ended, np.where(at_z, np.maximum(z, 0.0), 0.0), np.where(at_z, 0.0, w), residual, n_pivots)
