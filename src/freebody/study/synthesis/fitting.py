"""A closed path of many points, approached by the coupler curve of a four-bar.

Guesses come from a sample of crank-rockers, whose curves are compared with the path by the sizes of their Fourier
coefficients over the arc length, which know neither place, nor size, nor rotation, nor beginning. Each is then refined
by least squares in all lengths and in a crank angle for every point, with exact slopes of the loop's closure

    a e^(i theta) + b e^(i phi) = d + c e^(i psi),      P = A + e^(i gamma) (a e^(i theta) + (u + i v) e^(i phi)).

Sources: Ullah & Kota, J. Mech. Design 119, 1997, 504-510 (Fourier descriptors); McCarthy & Soh, Geometric Design of
Linkages, 2nd ed. 2011, sec. 2.3. The best of several local searches: that there is no better one is not proved.
"""

from __future__ import annotations

from importlib import import_module
from typing import Any

import numpy as np
from numpy.typing import NDArray

from freebody.numeric.jets import Array
from freebody.study.synthesis.linkage import Linkage

Complex = NDArray[np.complex128]
_N_LIBRARY, _N_LAID, _N_STARTS, _N_CURVE = 4096, 200, 16, 64
_LONGEST = 20.0  # sizes of the path: links
_HARMONICS = 6
_SAME = 1e-3  # of the size: fits to the same linkage
_OUT = 10.0  # sizes: the residual where the loop does not close
_N_SHAPE = 9  # unknowns before the crank angles: A, gamma, a, b, c, d, u, v


def fitted(points: Array, seed: int = 0) -> list[Linkage]:
    """Linkages whose coupler curve comes near all points (n, 2) of a closed path in their order, the best first."""
    target: Complex = points[:, 0] + 1j * points[:, 1]
    size = float(np.abs(target - target.mean()).max())
    scaled = (target - target.mean()) / size
    optimize: Any = import_module("scipy.optimize")
    found: list[tuple[float, Array, int]] = []
    high = np.full(_N_SHAPE + len(target), np.inf)
    high[3:7] = _LONGEST
    bounds = np.where(np.isfinite(high), 1e-3, -np.inf), high
    for x0, side in _guesses(scaled, seed):
        fit = optimize.least_squares(
            residuals,
            x0,
            jac=slopes,
            args=(side, scaled),
            bounds=bounds,
            x_scale="jac",
            max_nfev=300,
        )
        if np.isfinite(fit.cost) and _solved(np.asarray(fit.x), side) is not None:
            found.append((float(fit.cost), np.asarray(fit.x, dtype=np.float64), side))
    found.sort(key=lambda one: one[0])
    kept: list[tuple[Array, int]] = []
    for _cost, x, side in found:
        if all(np.abs(np.abs(x[3:7]) - np.abs(y[3:7])).max() > _SAME for y, _s in kept):
            kept.append((x, side))
    return [_linkage(x, side, target, size) for x, side in kept]


# -- the curve --------------------------------------------------------------------------------
def _loop(lengths: Any, theta: Array, side: int) -> tuple[Complex, Complex] | None:
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


def _solved(x: Array, side: int) -> tuple[Complex, Complex, Complex] | None:
    """P, e^(i phi), e^(i psi)."""
    loop = _loop(x[3:7], x[_N_SHAPE:], side)
    if loop is None:
        return None
    P = x[0] + 1j * x[1] + np.exp(1j * x[2]) * (x[3] * np.exp(1j * x[_N_SHAPE:]) + (x[7] + 1j * x[8]) * loop[0])
    return P, *loop


def residuals(x: Array, side: int, target: Complex) -> Array:
    """(2 n,) of both coordinates; far off where the loop does not close."""
    solved = _solved(x, side)
    if solved is None:
        return np.full(2 * len(target), _OUT)
    r = solved[0] - target
    return np.concatenate((r.real, r.imag))


def slopes(x: Array, side: int, target: Complex) -> Array:
    """(2 n, 9 + n). With b i e^(i phi) dphi - c i e^(i psi) dpsi = w the coupler turns by
    dphi = Re(w conj(e^(i psi)))/Re(b i e^(i phi) conj(e^(i psi)))."""
    n = len(target)
    solved = _solved(x, side)
    if solved is None:
        return np.zeros((2 * n, _N_SHAPE + n))
    P, ephi, epsi = solved
    a, b = x[3], x[4]
    crank, turn = np.exp(1j * x[_N_SHAPE:]), np.exp(1j * x[2])
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


# -- guesses ----------------------------------------------------------------------------------
def _guesses(target: Complex, seed: int) -> list[tuple[Array, int]]:
    """Unknowns and side of the most similar curves of a sample, laid onto the path."""
    path = _even(np.append(target, target[0]))
    wanted = _descriptor(path)
    theta = np.linspace(0.0, 2 * np.pi, 2 * _N_CURVE + 1)
    ranked: list[tuple[float, Array, bool]] = []
    for row in _library(seed):
        loop = _loop(row[:4], theta, 1)
        if loop is None:
            continue
        curve = row[0] * np.exp(1j * theta) + (row[4] + 1j * row[5]) * loop[0]
        own = _descriptor(_even(curve))
        for is_mirrored in (False, True):
            gap = (own[::-1] if is_mirrored else own) - wanted
            ranked.append((float(np.abs(gap).sum()), row, is_mirrored))
    ranked.sort(key=lambda one: one[0])
    laid = [_laid(target, path, row, -1 if is_mirrored else 1) for _gap, row, is_mirrored in ranked[:_N_LAID]]
    laid.sort(key=lambda one: float((residuals(*one, target) ** 2).sum()))
    inside = [one for one in laid if (one[0][3:7] < _LONGEST).all()]
    return inside[:_N_STARTS]


def _library(seed: int) -> Array:
    """(n, 6) a, b, c, d, u, v of crank-rockers with a frame of 1."""
    from scipy.stats import qmc

    made: Any = qmc.Sobol(5, scramble=True, rng=seed)
    z = np.asarray(made.random(_N_LIBRARY), dtype=np.float64)
    a, b, c = 0.08 + 0.6 * z[:, 0], 0.3 + 1.7 * z[:, 1], 0.3 + 1.7 * z[:, 2]
    sides = np.column_stack((b, c, np.ones(len(z))))
    longest = sides.max(axis=1)
    turns = (a < sides.min(axis=1)) & (a + longest < sides.sum(axis=1) - longest)
    u, v = b * (3.0 * z[:, 3] - 1.0), b * (3.0 * z[:, 4] - 1.5)
    return np.column_stack((a, b, c, np.ones(len(z)), u, v))[turns]


def _even(curve: Complex) -> Complex:
    """_N_CURVE points evenly along a closed curve."""
    s = np.append(0.0, np.cumsum(np.abs(np.diff(curve))))
    at: Array = np.linspace(0.0, float(s[-1]), _N_CURVE, endpoint=False)
    found: Complex = np.interp(at, s, curve.real) + 1j * np.interp(at, s, curve.imag)
    return found


def _descriptor(even: Complex) -> Array:
    """Sizes of harmonics -6 to 6 without the mean, the sum of squares one."""
    c = np.abs(np.fft.fft(even))
    kept: Array = np.concatenate((c[-_HARMONICS:], c[1 : _HARMONICS + 1]))
    return kept / np.linalg.norm(kept)


def _laid(target: Complex, path: Complex, row: Array, side: int) -> tuple[Array, int]:
    """A curve of the sample (mirrored for side -1) turned, scaled and moved onto the path, by the best correlation."""
    shape = row.copy()
    shape[5] *= side
    theta = np.linspace(0.0, 2 * np.pi, 2 * _N_CURVE + 1)
    loop = _loop(shape[:4], theta, side)
    assert loop is not None
    curve = shape[0] * np.exp(1j * theta) + (shape[4] + 1j * shape[5]) * loop[0]
    even = _even(curve)
    best, kappa = 0.0, 1.0 + 0.0j
    for z in (even, even[::-1]):
        middle = z - z.mean()
        correlation = np.fft.ifft(np.fft.fft(path - path.mean()) * np.fft.fft(middle).conj())
        k = int(np.abs(correlation).argmax())
        if abs(correlation[k]) > best:
            best, kappa = abs(correlation[k]), correlation[k] / float((np.abs(middle) ** 2).sum())
    A = path.mean() - kappa * even.mean()
    laid = A + kappa * curve
    nearest = np.abs(target[:, None] - laid[None, :-1]).argmin(axis=1)
    scale = abs(kappa)
    return np.concatenate(([A.real, A.imag, np.angle(kappa)], scale * shape, theta[nearest])), side


# -- result -----------------------------------------------------------------------------------
def _linkage(x: Array, side: int, target: Complex, size: float) -> Linkage:
    """In the places and the size of the path."""
    solved = _solved(x, side)
    assert solved is not None
    P, ephi, _epsi = solved
    turn = np.exp(1j * x[2])
    A = x[0] + 1j * x[1]
    B = A + turn * x[3] * np.exp(1j * x[_N_SHAPE:])
    C = B + turn * x[4] * ephi

    def back(z: Any) -> Array:
        moved = target.mean() + size * np.asarray(z)
        return np.stack((moved.real, moved.imag), axis=-1)

    missed = float(np.abs(target.mean() + size * P - target).max())
    return Linkage(back(A), back(B), back(C), back(A + turn * x[6]), P=back(P), missed=missed)
