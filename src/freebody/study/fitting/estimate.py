"""What the residuals at the best fit say of the unknowns: errors, correlation, and what the data cannot tell.

With J the Jacobian of the weighted residuals by the unknowns, each counted by its size, and s^2 the sum of their
squares over n - p, the covariance of the unknowns is s^2 (J^T J)^-1. Along a singular vector of J whose singular value
vanishes the residuals do not change: that combination the data cannot tell, and an unknown that has part in one has no
error.
Sources: Seber & Wild, Nonlinear Regression, 1989, ch. 2 and 5; Golub & Van Loan, Matrix Computations, 4th ed. 2013,
sec. 5.5.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from importlib import import_module
from typing import Any

import numpy as np

from freebody.language.sentences import Message, listed
from freebody.numeric.jets import Array

BLIND = 1e-5  # of the largest singular value: what differences of motions cannot tell from zero
_PART = 0.03  # of the largest component: less has no part in a combination
CONFIDENCE = 0.95


@dataclass(frozen=True)
class Estimate:
    """errors: (p,) half of the intervals of 95 %, infinite where the data tell nothing; correlation: (p, p), NaN there;
    combinations: what cannot be told, each in words; noise: s, by which residuals scatter."""

    errors: Array
    correlation: Array
    combinations: tuple[str, ...]
    noise: float


def estimated(jacobian: Array, residuals: Array, names: Sequence[str], sizes: Array) -> Estimate:
    """jacobian: (n, p) by the unknowns in their sizes."""
    stats: Any = import_module("scipy.stats")
    n, p = jacobian.shape
    freedom = n - p
    noise = math.sqrt(float(residuals @ residuals) / freedom) if freedom > 0 else math.nan
    _u, singular, vectors = np.linalg.svd(jacobian, full_matrices=True)
    full = np.concatenate((singular, np.zeros(p - len(singular))))
    is_blind = full <= BLIND * max(float(full.max(initial=0.0)), 1e-300)
    blind, seen = vectors[is_blind], vectors[~is_blind]
    covariance = (seen.T / full[~is_blind] ** 2) @ seen
    has_part = np.zeros(p, dtype=bool)
    for v in blind:
        has_part |= np.abs(v) > _PART * np.abs(v).max()
    spread = np.sqrt(np.diag(covariance))
    with np.errstate(invalid="ignore", divide="ignore"):
        correlation = covariance / np.outer(spread, spread)
    correlation[has_part] = np.nan
    correlation[:, has_part] = np.nan
    factor = float(stats.t.ppf(0.5 + 0.5 * CONFIDENCE, freedom)) if freedom > 0 else math.nan
    errors = np.where(has_part, math.inf, factor * noise * spread * sizes)
    return Estimate(errors, correlation, tuple(_told(v, names) for v in _simple(blind)), noise)


def _simple(blind: Array) -> Array:
    """A basis of the same directions in which as few unknowns as can be have a part, by row reduction."""
    rows = np.array(blind)
    for k in range(len(rows)):
        j = int(np.argmax(np.abs(rows[k])))
        rows[k] /= rows[k, j]
        for other in range(len(rows)):
            if other != k:
                rows[other] -= rows[other, j] * rows[k]
    return rows


def _told(v: Array, names: Sequence[str]) -> str:
    """`m by 1 % and k by 1 %`: what changes together without a trace in the data."""
    v = v / v[int(np.argmax(np.abs(v)))]
    parts = [
        Message("{name} by {part:.3g} %", name=name, part=float(x))
        for name, x in zip(names, v, strict=True)
        if abs(x) > _PART
    ]
    if len(parts) == 1:
        return Message(
            "the data tell nothing of {name}", name=next(n for n, x in zip(names, v, strict=True) if abs(x) > _PART)
        )
    return Message("changing {parts} together leaves no trace in the data", parts=listed(parts))
