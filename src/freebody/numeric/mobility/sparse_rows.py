"""Many independent rows: their smallest singular value, and what they leave free, by a sparse factor.

With J of unit rows, A = J J^T = L U. Inverse iteration x <- A^-1 x / |A^-1 x| leads to the smallest eigenvalue, the
square of the smallest singular value of J; g - J^T A^-1 J g is the part of g across all rows. Every row meets only
those of the bodies that it joins, so that the factor of a linkage costs in proportion to its size.
Source: Golub & Van Loan, Matrix Computations, 4th ed. 2013, sec. 8.2; Davis, Direct Methods for Sparse Linear Systems,
2006, ch. 6.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from importlib import import_module
from typing import Any

import numpy as np

from freebody.numeric.jets import Array

LARGE = 120  # rows, from which on the sparse factor is the quicker one
_N_ITERATIONS = 12


class FactoredRows:
    """Rows J of unit length, factored."""

    def __init__(self, J: Array) -> None:
        """Raises ValueError where the rows depend on each other so that the factor breaks down."""
        sparse: Any = import_module("scipy.sparse")
        linalg: Any = import_module("scipy.sparse.linalg")
        self._J: Any = sparse.csc_matrix(J)
        self._A: Any = (self._J @ self._J.T).tocsc()
        try:
            self._factor: Any = linalg.splu(self._A)
        except RuntimeError:
            raise ValueError("the rows depend on each other") from None

    def smallest(self) -> float:
        """The smallest singular value as a part of the largest, from above and close."""
        starts = np.random.default_rng(0).standard_normal((2, self._A.shape[0]))
        least = self._grown(self._factor.solve, starts[0])
        most = self._grown(self._A.__matmul__, starts[1])
        product = least * most
        return 1.0 / math.sqrt(product) if math.isfinite(product) and product > 0.0 else 0.0

    @staticmethod
    def _grown(apply: Callable[[Array], Array], x: Array) -> float:
        """By how much repeated application makes a vector longer in the end."""
        growth = 1.0
        for _ in range(_N_ITERATIONS):
            x = apply(x / np.linalg.norm(x))
            growth = float(np.linalg.norm(x))
        return growth

    def across(self, g: Array) -> Array:
        """The part of g that is perpendicular to all rows."""
        part: Array = g
        for _ in range(2):  # once more, since the first result carries the error of the factor
            part = part - self._J.T @ self._factor.solve(self._J @ part)
        return part
