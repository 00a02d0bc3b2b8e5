"""Explicit Runge-Kutta methods as data: y_new = y + h sum b_j f(t + c_j h, y + h sum a_jk f_k).

A method of n stages has rows of `a` for stages 1 ... n - 1, and, where its dense output needs them, for more stages
that follow the value at the new point (stage n). `error` are the weights of one or two embedded formulas; `dense`
those of the terms that the interpolant has beyond the cubic through values and slopes at both ends, nested by s and
1 - s in turn (s from 0 to 1 along the step).
Source: Hairer, Norsett & Wanner, Solving Ordinary Differential Equations I, 2nd ed. 1993,
sec. II.1 (classical), II.5 (DOPRI5), II.5 and II.6 (DOP853 and their dense outputs).
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from freebody.numeric.kernels.stepped_run import Tableau

Row = Mapping[int, float]


def tableau(
    order: int,
    a: Sequence[Row],
    b: Row,
    error: Sequence[Row] = (),
    extra: Sequence[Row] = (),
    dense: Sequence[Row] = (),
) -> Tableau:
    """A method from its nonzero coefficients; c_j is the sum of row j."""
    n = len(a) + 1
    n_all = n + 1 + len(extra)

    def filled(rows: Sequence[Row], first: int, n_rows: int) -> Any:
        matrix = np.zeros((n_rows, n_all))
        for i, row in enumerate(rows, first):
            for j, x in row.items():
                matrix[i, j] = x
        return matrix

    matrix = filled(a, 1, n_all) + filled([b], n, n_all) + filled(extra, n + 1, n_all)
    errors = filled(error, 0, 2)[:, : n + 1]
    sizes = [n, len(extra), order, int(bool(error)), int(bool(errors[:, n].any()))]
    return Tableau(
        matrix,
        matrix.sum(axis=1),
        matrix[n, :n].copy(),
        errors.copy(),
        filled(dense, 0, len(dense)),
        np.array(sizes, np.int32),
    )
