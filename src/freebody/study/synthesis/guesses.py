"""Where the search for a path begins: linkages whose coupler curves look like it, laid onto its points.

    closed   the sizes of Fourier coefficients over the arc length know neither place, nor size, nor rotation, nor
             beginning; the nearest of a sample whose crank turns fully are laid onto the path
    arc      every linkage of a sample goes over a part of its motion, the points at equal parts of the path's length,
             or by the crank angles that are given; place, size and rotation follow by linear least squares

Samples are Sobol's. Source: Ullah & Kota, J. Mech. Design 119, 1997, 504-510 (Fourier descriptors).
"""

from __future__ import annotations

from typing import Any

import numpy as np

from freebody.numeric.jets import Array
from freebody.study.synthesis.loop import LONGEST, Complex, Loop, TracedPath

_N_LIBRARY, _N_LAID, _N_STARTS, _N_CURVE = 4096, 200, 16, 64
_N_ARCS = 48  # starts of an arc
_SHORTEST_ARC = 0.3  # [rad] of the crank
_HARMONICS = 6

Guess = tuple[Array, int]  # unknowns, and the side on which the loop is closed


def closed_guesses(path: TracedPath, seed: int) -> list[Guess]:
    """The most similar curves of a sample, laid onto a closed path."""
    loop = path.loop
    even = _even(np.append(path.target, path.target[0]))
    wanted = _descriptor(even)
    theta = np.linspace(0.0, 2 * np.pi, 2 * _N_CURVE + 1)
    ranked: list[tuple[float, Array, bool]] = []
    for shape, _more in _library(loop, seed, full_turn=True):
        curve = _curve(loop, shape, theta, 1)
        if curve is None:
            continue
        own = _descriptor(_even(curve))
        for is_mirrored in (False, True):
            gap = (own[::-1] if is_mirrored else own) - wanted
            ranked.append((float(np.abs(gap).sum()), shape, is_mirrored))
    ranked.sort(key=lambda one: one[0])
    laid = [
        _laid(path, even, *(loop.mirrored(shape, 1) if is_mirrored else (shape, 1)))
        for _gap, shape, is_mirrored in ranked[:_N_LAID]
    ]
    return [guess for _gap, guess in _nearest(path, laid)[:_N_STARTS]]


def arc_guesses(path: TracedPath, seed: int, *, full_turn: bool) -> list[Guess]:
    """Parts of the curves of a sample, laid onto points in their order; mirrored ones are the other way round."""
    loop = path.loop
    found: list[Guess] = []
    for shape, more in _library(loop, seed, full_turn=full_turn):
        for way in (-1.0, 1.0):
            theta = 2 * np.pi * more[0] + way * _turns(path, float(more[1]))
            z = _curve(loop, shape, theta, 1)
            if z is None:
                continue
            for is_mirrored in (False, True):
                if path.turns is not None and is_mirrored != (way < 0):
                    continue
                laid, side = loop.mirrored(shape, 1) if is_mirrored else (shape, 1)
                own = (z.conj(), -theta) if is_mirrored else (z, theta)
                x = _similar(path, *own, laid)
                if x is not None:
                    found.append((x, side))
    return [guess for _gap, guess in _nearest(path, found)[:_N_ARCS]]


def _turns(path: TracedPath, part: float) -> Array:
    """Of the crank from the first point: as they are given, else a part of a turn by the lengths along the path."""
    if path.turns is not None:
        return path.turns
    length = np.append(0.0, np.cumsum(np.abs(np.diff(path.target))))
    return (_SHORTEST_ARC + (2 * np.pi - _SHORTEST_ARC) * part) * length / length[-1]


def _nearest(path: TracedPath, guesses: list[Guess]) -> list[tuple[float, Guess]]:
    """By what they miss, without those whose links are too long."""
    inside = [g for g in guesses if (np.abs(g[0][path.loop.links]) < LONGEST).all()]
    return sorted(((float((path.residuals(*g) ** 2).sum()), g) for g in inside), key=lambda one: one[0])


def _curve(loop: Loop, shape: Array, theta: Array, side: int) -> Complex | None:
    """Of the traced point in the frame's axes; None where the loop does not close."""
    *lengths, u, v = shape
    ephi = loop.coupler(lengths, theta, side)
    return None if ephi is None else lengths[0] * np.exp(1j * theta) + (u + 1j * v) * ephi


def _unknowns(path: TracedPath, A: complex, kappa: complex, shape: Array, theta: Array) -> Array:
    """Of a linkage that is turned and scaled by kappa; theta: at the points."""
    own = theta if path.turns is None else theta[:1]
    return np.concatenate(([A.real, A.imag, np.angle(kappa)], abs(kappa) * shape, own))


def _similar(path: TracedPath, z: Complex, theta: Array, shape: Array) -> Array | None:
    """Unknowns of the curve points z of a linkage, turned, scaled and moved onto the target as near as they come."""
    middle = z - z.mean()
    square = float((np.abs(middle) ** 2).sum())
    if not square > 0.0:
        return None
    kappa = complex((path.target * middle.conj()).sum() / square)
    if kappa == 0.0:
        return None
    return _unknowns(path, complex(path.target.mean() - kappa * z.mean()), kappa, shape, theta)


def _library(loop: Loop, seed: int, *, full_turn: bool) -> list[tuple[Array, Array]]:
    """Lengths, u and v of linkages of the size 1, of those whose crank turns fully if it has to; and two numbers from
    0 to 1."""
    from scipy.stats import qmc

    made: Any = qmc.Sobol(7, scramble=True, rng=seed)
    z = np.asarray(made.random(_N_LIBRARY), dtype=np.float64)
    lengths, scale = loop.sample(z[:, :3], full_turn=full_turn)
    u, v = scale * (3.0 * z[:, 3] - 1.0), scale * (3.0 * z[:, 4] - 1.5)
    shapes = np.column_stack((lengths, u, v))
    return [(shape, more) for shape, more in zip(shapes, z[:, 5:], strict=True) if np.isfinite(shape).all()]


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


def _laid(path: TracedPath, even: Complex, shape: Array, side: int) -> Guess:
    """A curve of the sample turned, scaled and moved onto the path, by the best correlation."""
    theta = np.linspace(0.0, 2 * np.pi, 2 * _N_CURVE + 1)
    curve = _curve(path.loop, shape, theta, side)
    assert curve is not None
    own = _even(curve)
    best, kappa = 0.0, 1.0 + 0.0j
    for z in (own, own[::-1]):
        middle = z - z.mean()
        correlation = np.fft.ifft(np.fft.fft(even - even.mean()) * np.fft.fft(middle).conj())
        k = int(np.abs(correlation).argmax())
        if abs(correlation[k]) > best:
            best, kappa = abs(correlation[k]), correlation[k] / float((np.abs(middle) ** 2).sum())
    A = even.mean() - kappa * own.mean()
    laid = A + kappa * curve
    nearest = np.abs(path.target[:, None] - laid[None, :-1]).argmin(axis=1)
    return _unknowns(path, complex(A), complex(kappa), shape, theta[nearest]), side
