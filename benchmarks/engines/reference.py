"""Reference solutions that share no code with any engine.

Chain, absolute angles theta (Lagrange's equations of n uniform rods, m = l = 1):

    sum_j c_ij cos(theta_i - theta_j) theta_j'' = -sum_j c_ij sin(theta_i - theta_j) theta_j'^2 - g w_i cos(theta_i)

with w_i = n - i - 1/2, c_ij = w_max(i,j), c_ii = n - i - 2/3 (i from 0). Dense Cholesky, DOP853.
N-four-bar: the cranks stay parallel, theta'' = -(V/M) cos(theta), M = (N+1)/3 + N, V = g ((N+1)/2 + N).
"""

from __future__ import annotations

import tempfile
from pathlib import Path

import numpy as np
from problems import GRAVITY, Array, farthest, joint_positions
from scipy.integrate import solve_ivp
from scipy.linalg import cho_factor, cho_solve

CACHE = Path(tempfile.gettempdir()) / "freebody-benchmark-references"


class Chain:
    """Angular accelerations of n links in absolute angles."""

    def __init__(self, n: int) -> None:
        i = np.arange(n)
        self.weights = n - i - 0.5
        self.coefficients = self.weights[np.maximum.outer(i, i)]
        self.coefficients[i, i] = n - i - 2 / 3

    def accelerations(self, theta: Array, omega: Array) -> Array:
        c, s = np.cos(theta), np.sin(theta)
        # cos(a - b) and sin(a - b) of all pairs by the addition theorems
        mass = self.coefficients * (np.outer(c, c) + np.outer(s, s))
        centripetal = self.coefficients * (np.outer(s, c) - np.outer(c, s))
        force = -centripetal @ omega**2 - GRAVITY * self.weights * c
        return cho_solve(cho_factor(mass, overwrite_a=True, check_finite=False), force, check_finite=False)

    def after(self, time: float, theta: Array, omega: Array, tolerance: float) -> Array:
        n = len(theta)
        solution = solve_ivp(
            lambda _t, y: np.concatenate([y[n:], self.accelerations(y[:n], y[n:])]),
            (0.0, time),
            np.concatenate([theta, omega]),
            method="DOP853",
            rtol=tolerance,
            atol=tolerance,
        )
        if not solution.success:
            raise RuntimeError(solution.message)
        return solution.y[:n, -1]


def chain_second(n: int) -> tuple[Array, float]:
    """(n, 2) joint positions after 1 s from the horizontal at rest, and their change under a looser tolerance [m]."""
    file = CACHE / f"chain-{n}.npz"
    if not file.exists():
        chain, zero = Chain(n), np.zeros(n)
        fine, check = (joint_positions(chain.after(1.0, zero, zero, tolerance)) for tolerance in (1e-13, 1e-11))
        CACHE.mkdir(exist_ok=True)
        np.savez(file, positions=fine, doubt=farthest(check, fine))
    with np.load(file) as stored:
        return stored["positions"], float(stored["doubt"])


def four_bar_angle(n_windows: int, time: float) -> tuple[float, float]:
    """The exact crank angle [rad] and its rate [rad/s]."""
    n = n_windows
    ratio = GRAVITY * ((n + 1) / 2 + n) / ((n + 1) / 3 + n)
    solution = solve_ivp(
        lambda _t, y: [y[1], -ratio * np.cos(y[0])],
        (0.0, time),
        [np.pi / 2, -1.0],
        method="DOP853",
        rtol=1e-13,
        atol=1e-13,
    )
    return float(solution.y[0, -1]), float(solution.y[1, -1])


def four_bar(n_windows: int, time: float) -> Array:
    """The exact position of B_0 [m]."""
    theta, _ = four_bar_angle(n_windows, time)
    return np.array([np.cos(theta), np.sin(theta)])


def check() -> None:
    """Raises AssertionError unless published values and a second tolerance agree."""
    published = {(2, 10.0): (0.328458111541, 0.944518538179), (40, 20.0): (0.410901153763, 0.911679900972)}
    for (n, time), position in published.items():
        assert farthest(four_bar(n, time), np.array(position)) < 1e-9
    for n in (10, 50):
        assert chain_second(n)[1] < 1e-9


if __name__ == "__main__":
    check()
