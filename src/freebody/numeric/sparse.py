"""Rows of a large system: a matrix of which few entries are not zero, and the smallest moves that it asks for.

Where `split` decomposes rows J by their singular values, at a cost that grows with the cube of their number, here the
normal equations are solved by a sparse factor, which for a chain of bodies costs as much for every link. With
A = R J D, rows of unit length in the metric of the masses,

    y = (A A^T + mu)^(-1) R b,        x = D A^T y,

and what mu, just above round-off, has spoilt is taken back by repeating that with what is left of b. Rows that say the
same thing do no harm; how many do is not known. Source: Golub & Van Loan,
Matrix Computations, 4th ed. 2013, sec. 6.1.4.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, cast

import numpy as np
from numpy.typing import NDArray

from freebody.numeric.jets import Array, Gradient, GradientEntries
from freebody.tolerances import ROUNDED

_REGULARISING = 1e-12  # by the largest entry of the square, which is 1
_ROUNDS = 20
_SOLVED = 1e-15  # what may be left of b


class SparseRows:
    """Rows (m, n) by their entries, none of them infinite."""

    def __init__(self, gradients: Sequence[Gradient], n: int) -> None:
        rows = [_entries(gradient) for gradient in gradients]
        self.shape = len(rows), n
        self._rows = np.repeat(np.arange(len(rows)), [len(row) for row in rows])
        self._columns = np.array([k for row in rows for k in row], dtype=np.int64)
        self._entries = np.array([x for row in rows for x in row.values()])

    @property
    def are_finite(self) -> bool:
        return bool(np.isfinite(self._entries).all())

    @property
    def whole(self) -> Array:
        found = np.zeros(self.shape)
        found[self._rows, self._columns] = self._entries
        return found

    def any(self, axis: int) -> NDArray[np.bool_]:
        """Which columns (axis 0) have an entry that is not zero."""
        assert axis == 0
        found = np.zeros(self.shape[1], dtype=bool)
        found[self._columns[self._entries != 0.0]] = True
        return found

    def __matmul__(self, v: Array) -> Array:
        return _sums(self._rows, self._entries * v[self._columns], self.shape[0])

    def is_stationary(self, weights: Array, D: Array, F: Array, slope: float) -> bool:
        """Whether |A^T F| is less than `slope` by the sizes of both, with A = weights J D."""
        A = self._scaled(weights, D)
        return bool(np.linalg.norm(A.T @ F) <= slope * np.linalg.norm(F) * np.linalg.norm(A.data))

    def damped(self, weights: Array, D: Array, F: Array, mu: float) -> Array:
        """D A^T (A A^T + mu)^(-1) F with A = weights J D."""
        A = self._scaled(weights, D)
        return D * (A.T @ _factor(A, max(mu, _REGULARISING * float(np.square(A.data).max(initial=1.0))))(F))

    def least(self, D: Array, b: Array) -> Array:
        """The smallest x with J x = b in the metric D."""
        sizes = np.sqrt(_sums(self._rows, (self._entries * D[self._columns]) ** 2, len(b)))
        largest = float(sizes.max(initial=0.0)) or 1.0
        R = 1.0 / np.where(sizes > ROUNDED * largest, sizes, largest)
        A, wanted = self._scaled(R, D), R * b
        solve, x, left = _factor(A, _REGULARISING), np.zeros(len(D)), wanted
        for _ in range(_ROUNDS):
            better = x + A.T @ solve(left)
            still = wanted - A @ better
            if np.abs(still).max(initial=0.0) >= np.abs(left).max(initial=0.0):
                break
            x, left = better, still
            if np.abs(left).max(initial=0.0) <= _SOLVED * np.abs(wanted).max(initial=0.0):
                break
        return D * x

    def _scaled(self, rows: Array, columns: Array) -> Any:
        from scipy.sparse import csr_array

        entries = rows[self._rows] * self._entries * columns[self._columns]
        return csr_array((entries, (self._rows, self._columns)), shape=self.shape)


def _sums(groups: NDArray[np.int64], values: Array, n: int) -> Array:
    """The sum of the values of each group."""
    found: Any = np.bincount(groups, values, minlength=n)
    return found


def _entries(gradient: Gradient) -> dict[int, float]:
    if gradient is None or isinstance(gradient, GradientEntries):
        return {} if gradient is None else gradient.of
    return {int(k): float(gradient[k]) for k in np.flatnonzero(gradient)}


def _factor(A: Any, mu: float) -> Any:
    """What solves (A A^T + mu) y = f."""
    import scipy.sparse
    import scipy.sparse.linalg as linalg

    sparse, solver = cast("Any", scipy.sparse), cast("Any", linalg)
    square = (A @ A.T + mu * sparse.eye_array(A.shape[0])).tocsc()
    return solver.splu(square, permc_spec="MMD_AT_PLUS_A", options={"SymmetricMode": True}).solve
