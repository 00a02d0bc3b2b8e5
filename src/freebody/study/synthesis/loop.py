"""The coupler curve of a four-bar as least squares see it: how far it is from given points, and by which slopes.

Unknowns are the lengths and a crank angle for every point,

    a e^(i theta) + b e^(i phi) = d + c e^(i psi),      P = A + e^(i gamma) (a e^(i theta) + (u + i v) e^(i phi)).

Source: McCarthy & Soh, Geometric Design of Linkages, 2nd ed. 2011, sec. 2.3.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from freebody.numeric.jets import Array

Complex = NDArray[np.complex128]
N_SHAPE = 9  # unknowns before the crank angles: A, gamma, a, b, c, d, u, v
LONGEST = 20.0  # sizes of the path: links
_OUT = 10.0  # sizes: the residual where the loop does not close


def closed_loop(lengths: Any, theta: Array, side: int) -> tuple[Complex, Complex] | None:
    """e^(i phi) and e^(i psi); None where the loop does not close for some angle."""
    a, b, c, d = lengths
    r = d - a * np.exp(1j * theta)
    L2 = np.abs(r) ** 2
    part = (b * b - c * c + L2) / (2 * L2)
    height2 = b * b / L2 - part * part
    if np.any(height2 < 0.0):
        return None
    along = r * (part + 1j * side * np.sqrt(height2))
    return along / b, (along - r) / c


def solved_curve(x: Array, side: int) -> tuple[Complex, Complex, Complex] | None:
    """P, e^(i phi), e^(i psi)."""
    loop = closed_loop(x[3:7], x[N_SHAPE:], side)
    if loop is None:
        return None
    P = x[0] + 1j * x[1] + np.exp(1j * x[2]) * (x[3] * np.exp(1j * x[N_SHAPE:]) + (x[7] + 1j * x[8]) * loop[0])
    return P, *loop


def residuals(x: Array, side: int, target: Complex) -> Array:
    """(2 n,) of both coordinates; far off where the loop does not close."""
    solved = solved_curve(x, side)
    if solved is None:
        return np.full(2 * len(target), _OUT)
    r = solved[0] - target
    return np.concatenate((r.real, r.imag))


def slopes(x: Array, side: int, target: Complex) -> Array:
    """(2 n, 9 + n). With b i e^(i phi) dphi - c i e^(i psi) dpsi = w the coupler turns by
    dphi = Re(w conj(e^(i psi)))/Re(b i e^(i phi) conj(e^(i psi)))."""
    n = len(target)
    solved = solved_curve(x, side)
    if solved is None:
        return np.zeros((2 * n, N_SHAPE + n))
    P, ephi, epsi = solved
    a, b = x[3], x[4]
    crank, turn = np.exp(1j * x[N_SHAPE:]), np.exp(1j * x[2])
    down = (1j * b * ephi * epsi.conj()).real
    ways = (-crank, -ephi, epsi, np.ones(n), -1j * a * crank)  # w for da, db, dc, dd, dtheta
    dphi = [(w * epsi.conj()).real / down for w in ways]
    coupler = turn * (x[7] + 1j * x[8]) * 1j * ephi
    columns = [np.ones(n), np.full(n, 1j), 1j * (P - x[0] - 1j * x[1])]
    columns += [
        turn * crank + coupler * dphi[0],
        *(coupler * dphi[k] for k in (1, 2, 3)),
        turn * ephi,
        turn * 1j * ephi,
    ]
    own = np.diag(turn * 1j * a * crank + coupler * dphi[4])
    every = np.hstack((np.column_stack(columns), own))
    return np.vstack((every.real, every.imag))
