"""Where the search for a path begins: linkages whose coupler curves look like it, laid onto its points.

    closed   the sizes of Fourier coefficients over the arc length know neither place, nor size, nor rotation, nor
             beginning; the nearest of a sample of crank-rockers are laid onto the path
    arc      every linkage of a sample goes over a part of its motion, the points at equal parts of the path's length;
             place, size and rotation follow by linear least squares

Samples are Sobol's. Source: Ullah & Kota, J. Mech. Design 119, 1997, 504-510 (Fourier descriptors).
"""

from __future__ import annotations

from typing import Any

import numpy as np

from freebody.numeric.jets import Array
from freebody.study.synthesis.loop import LONGEST, Complex, closed_loop, residuals

_N_LIBRARY, _N_LAID, _N_STARTS, _N_CURVE = 4096, 200, 16, 64
_N_ARCS = 48  # starts of an arc
_SHORTEST_ARC = 0.3  # [rad] of the crank
_HARMONICS = 6

Guess = tuple[Array, int]  # unknowns, and the side on which the loop is closed


def closed_guesses(target: Complex, seed: int) -> list[Guess]:
    """The most similar curves of a sample, laid onto a closed path."""
    path = _even(np.append(target, target[0]))
    wanted = _descriptor(path)
    theta = np.linspace(0.0, 2 * np.pi, 2 * _N_CURVE + 1)
    ranked: list[tuple[float, Array, bool]] = []
    for row in _library(seed, full_turn=True)[:, :6]:
        loop = closed_loop(row[:4], theta, 1)
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
    inside = [one for one in laid if (one[0][3:7] < LONGEST).all()]
    return inside[:_N_STARTS]


def arc_guesses(target: Complex, seed: int, *, full_turn: bool) -> list[Guess]:
    """Parts of the curves of a sample, laid onto points in their order; mirrored ones are the other way round."""
    length = np.append(0.0, np.cumsum(np.abs(np.diff(target))))
    parts = length / length[-1]
    found: list[tuple[float, Guess]] = []
    for row in _library(seed, full_turn=full_turn):
        for way in (-1.0, 1.0):
            theta = 2 * np.pi * row[6] + way * (_SHORTEST_ARC + (2 * np.pi - _SHORTEST_ARC) * row[7]) * parts
            loop = closed_loop(row[:4], theta, 1)
            if loop is None:
                continue
            z = row[0] * np.exp(1j * theta) + (row[4] + 1j * row[5]) * loop[0]
            for side in (-1, 1):
                x = _similar(target, z if side > 0 else z.conj(), row[:6] * (1, 1, 1, 1, 1, side), side * theta)
                if x is not None and (x[3:7] < LONGEST).all():
                    found.append((float((residuals(x, side, target) ** 2).sum()), (x, side)))
    found.sort(key=lambda one: one[0])
    return [guess for _gap, guess in found[:_N_ARCS]]


def _similar(target: Complex, z: Complex, shape: Array, theta: Array) -> Array | None:
    """Unknowns of the curve points z of a linkage, turned, scaled and moved onto the target as near as they come."""
    middle = z - z.mean()
    square = float((np.abs(middle) ** 2).sum())
    if not square > 0.0:
        return None
    kappa = complex((target * middle.conj()).sum() / square)
    if kappa == 0.0:
        return None
    A = target.mean() - kappa * z.mean()
    return np.concatenate(([A.real, A.imag, np.angle(kappa)], abs(kappa) * shape, theta))


def _library(seed: int, *, full_turn: bool) -> Array:
    """(n, 8) a, b, c, d, u, v of linkages with a frame of 1, of crank-rockers if the crank has to turn fully, and two
    numbers from 0 to 1."""
    from scipy.stats import qmc

    made: Any = qmc.Sobol(7, scramble=True, rng=seed)
    z = np.asarray(made.random(_N_LIBRARY), dtype=np.float64)
    a, b, c = 0.08 + (0.6 if full_turn else 1.9) * z[:, 0], 0.3 + 1.7 * z[:, 1], 0.3 + 1.7 * z[:, 2]
    sides = np.column_stack((b, c, np.ones(len(z))))
    longest = sides.max(axis=1)
    turns = (a < sides.min(axis=1)) & (a + longest < sides.sum(axis=1) - longest)
    u, v = b * (3.0 * z[:, 3] - 1.0), b * (3.0 * z[:, 4] - 1.5)
    every = np.column_stack((a, b, c, np.ones(len(z)), u, v, z[:, 5:]))
    return every[turns] if full_turn else every


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


def _laid(target: Complex, path: Complex, row: Array, side: int) -> Guess:
    """A curve of the sample (mirrored for side -1) turned, scaled and moved onto the path, by the best correlation."""
    shape = row.copy()
    shape[5] *= side
    theta = np.linspace(0.0, 2 * np.pi, 2 * _N_CURVE + 1)
    loop = closed_loop(shape[:4], theta, side)
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
