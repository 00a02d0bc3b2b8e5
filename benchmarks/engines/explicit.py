"""Explicit Runge-Kutta steps of constant length in Python, for engines that only evaluate accelerations.

Tableaus as data: the classical method of order 4, and Dormand-Prince of order 8 as SciPy holds it (Hairer, Norsett
& Wanner, Solving Ordinary Differential Equations I, sec. II.1 and II.5).
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Literal

import numpy as np
from problems import Array

Method = Literal["RK4", "DOP8"]


def tableau(method: Method) -> tuple[Array, Array]:
    """Stage matrix and weights."""
    if method == "RK4":
        return np.array([[0, 0, 0, 0], [0.5, 0, 0, 0], [0, 0.5, 0, 0], [0, 0, 1.0, 0]]), np.array([1, 2, 2, 1]) / 6
    from scipy.integrate import DOP853

    return np.array(DOP853.A), np.array(DOP853.B)


def integrate(
    accelerations: Callable[[Array, Array], Array], q: Array, v: Array, time: float, n_steps: int, method: Method
) -> Array:
    """The coordinates after `time`; `accelerations(q, v)` [rad/s^2]. Forces may not depend on time itself."""
    matrix, weights = tableau(method)
    n_stages, n, h = len(weights), len(q), time / n_steps
    rows = [h * matrix[s, :s] for s in range(n_stages)]
    step = h * weights
    y, rates = np.concatenate([q, v]), np.empty((n_stages, 2 * n))
    for _ in range(n_steps):
        for s in range(n_stages):
            stage = y + rows[s] @ rates[:s] if s else y
            rates[s, :n] = stage[n:]
            rates[s, n:] = accelerations(stage[:n], stage[n:])
        y = y + step @ rates
    return y[:n]
