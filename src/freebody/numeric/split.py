"""What rows J determine and what they leave free, however many of them say the same.

With x = D y in the metric of the masses and every row brought to unit length by R, the singular values of

    R J D = U S V^T

tell the rank. Those that count give the smallest solutions of J x = b and J^T lambda = f; the columns of V
beyond them, times D, are the moves that J leaves free, those of U the combinations of rows that vanish.
Source: Golub & Van Loan, Matrix Computations, 4th ed. 2013, sec. 5.5.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from freebody.errors import CannotAnswer
from freebody.language.sentences import Message
from freebody.numeric.jets import Array
from freebody.tolerances import ROUNDED

NO_GRADIENT = Message("a measure has no finite gradient in this pose")
RANK_CUT = 1e-10  # singular values below this part of the largest count as zero


def stack(rows: Sequence[Array], n: int) -> Array:
    """Rows of n entries as a matrix, even if there are none. Raises CannotAnswer for infinite entries."""
    J = np.array(rows, dtype=np.float64).reshape(len(rows), n)
    if not np.isfinite(J).all():
        raise CannotAnswer(NO_GRADIENT)
    return J


class Split:
    """The rows J split at their rank, in the metric D."""

    def __init__(self, J: Array, D: Array, cut: float = RANK_CUT) -> None:
        sizes: Array = np.linalg.norm(J * D, axis=1)
        largest = float(sizes.max(initial=0.0)) or 1.0
        self.row_scale: Array = 1.0 / np.where(sizes > ROUNDED * largest, sizes, largest)
        self._D = D
        U, singular, Vt = np.linalg.svd(self.row_scale[:, None] * J * D)
        rank = int(np.count_nonzero(singular > cut * singular.max(initial=0.0)))
        self._U, self._S, self._V = U[:, :rank], singular[:rank], Vt[:rank].T
        self.smallest = float(self._S.min(initial=1.0) / singular.max(initial=1.0))
        self.null: Array = D[:, None] * Vt[rank:].T  # columns x with J x = 0
        self.left_null: Array = U[:, rank:]  # columns y with y^T R J = 0

    def least(self, b: Array) -> Array:
        """The smallest x with J x = b, or with the smallest gaps."""
        return self._D * (self._V @ ((self._U.T @ (self.row_scale * b)) / self._S))

    def multipliers(self, forces: Array) -> Array:
        """The smallest solution of J^T lambda = forces."""
        return self.row_scale * (self._U @ ((self._V.T @ (self._D * forces)) / self._S))
