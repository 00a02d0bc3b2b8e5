"""Small dense linear systems by Gaussian elimination, A = P L U, in place; nothing is done for entries that are zero.

Source: Golub & Van Loan, Matrix Computations, 4th ed. 2013, sec. 3.4 (pivots that need not be the largest: 3.4.9).
"""

# pyright: basic

from __future__ import annotations

import math

from freebody.numeric.kernels.declaring import kernel


@kernel
def factor_dense(A, o, n, least, pivots):
    """The rows o ... o + n - 1 of A become L and U. A pivot stays in its place if it is at least this part of the
    largest one of its column. False where a column has none."""
    for k in range(n):
        largest, p = 0.0, k
        for i in range(k, n):
            if abs(A[o + i, k]) > largest:
                largest, p = abs(A[o + i, k]), i
        if not 0.0 < largest < math.inf:
            return False
        if abs(A[o + k, k]) >= least * largest:
            p = k
        pivots[o + k] = p
        if p != k:
            for j in range(n):
                A[o + k, j], A[o + p, j] = A[o + p, j], A[o + k, j]
        inverse = 1.0 / A[o + k, k]
        for i in range(k + 1, n):
            if A[o + i, k] != 0.0:
                f = A[o + i, k] * inverse
                A[o + i, k] = f
                for j in range(k + 1, n):
                    A[o + i, j] -= f * A[o + k, j]
    return True


@kernel
def solve_dense(A, o, n, pivots, B, n_columns):
    """The columns of B, n rows of them, become A^-1 B, with the factors of A in its rows from o on."""
    for k in range(n):
        p = pivots[o + k]
        if p != k:
            for j in range(n_columns):
                B[k, j], B[p, j] = B[p, j], B[k, j]
    for k in range(n):
        for i in range(k + 1, n):
            f = A[o + i, k]
            if f != 0.0:
                for j in range(n_columns):
                    B[i, j] -= f * B[k, j]
    for k in range(n - 1, -1, -1):
        inverse = 1.0 / A[o + k, k]
        for j in range(n_columns):
            B[k, j] *= inverse
        for i in range(k):
            f = A[o + i, k]
            if f != 0.0:
                for j in range(n_columns):
                    B[i, j] -= f * B[k, j]
