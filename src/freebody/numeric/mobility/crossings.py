"""Change points of a curve of poses: where they are, and the branch that leaves there.

Where the determinant of the curve changes its sign (see `curve`), the smallest singular value sigma passes through
zero and branches meet; sigma with that sign is smooth along the branch, which goes straight on. The pose of such a
point is badly determined by F = 0 itself (rounding e moves it by sqrt(e)), so it is interpolated from poses around it.
Tangents t + b p of other branches there solve psi^T F_xx[t + b p, t + b p] = 0 for all psi with psi^T J = 0.
Source: Keller, in Rabinowitz (ed.), Applications of Bifurcation Theory, 1977, 359-384; Allgower & Georg, Numerical
Continuation Methods, 1990, ch. 8.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from freebody.numeric.jets import Array
from freebody.numeric.mobility.curve import Mechanism, Station, flip

_NODES = np.array([-3.0, -2.0, -1.0, 1.0, 2.0, 3.0])  # around a change point
_CUT = 1e-7  # singular values below this part of the largest are none, at poses as good as they were assembled
_FLAT = 1e-6  # a second form, or a part of a direction, that is none beside the others
_CLOSE = 1e-4  # how near to a change point sigma is checked; lengths that differ by its square count as equal


@dataclass(frozen=True)
class ChangePoint:
    """A change point of the curve, and its tangent there."""

    x: Array
    tangent: Array


def crossing(mechanism: Mechanism, a: Station, b: Station, about: float | None = None) -> ChangePoint | None:
    """Where sigma vanishes between two stations, by interpolation from both sides. With `about` the determinant keeps
    its sign, and sigma is least at about that distance from a. None if sigma does not vanish."""
    chord = float(np.linalg.norm(b.x - a.x))
    middle = chord * a.sigma / (a.sigma + b.sigma) if about is None else about
    coarse = _around(mechanism, a, b, [(middle + 0.12 * chord * u, None) for u in _NODES], touches=about is not None)
    if coarse is None:
        return None
    guess, off = coarse[0][:, 1:], coarse[1]
    nodes = [(middle + 0.12 * chord * (off + v / 6.0), _at(guess, off + v / 6.0)) for v in _NODES]
    fine, width = _around(mechanism, a, b, nodes, touches=about is not None), 0.02 * chord
    if fine is None:
        return None
    sigma, x, u = fine[0][:, 0], fine[0][:, 1:], fine[1]
    tangent, slope = _at(_slope(x), u), abs(float(_at(_slope(sigma), u))) / width
    close = min(_CLOSE, 0.1 * width)
    check = mechanism.between(a, b, middle, _at(x, u + close / width))
    if check is None or check.sigma > 4.0 * slope * close + 1e-8:
        return None
    return ChangePoint(_at(x, u), tangent / float(np.linalg.norm(tangent)))


def _around(
    mechanism: Mechanism, a: Station, b: Station, nodes: Sequence[tuple[float, Array | None]], *, touches: bool
) -> tuple[Array, float] | None:
    """Polynomials through sigma (with its sign) and x at nodes, given by place and perhaps a guess, and where sigma is
    zero, both by the distance of the inner nodes from the middle."""
    found = [station for s, x in nodes if (station := mechanism.between(a, b, s, x)) is not None]
    if len(found) < len(nodes):
        return None
    sigma, is_even = np.array([station.sigma for station in found]), False
    if touches:
        is_even = sigma[[0, 1, 4, 5]].mean() > 4.0 * sigma[[2, 3]].mean()  # like s^2, not like |s|
        sigma *= 1.0 if is_even else np.sign(_NODES)
    else:
        sigma *= np.array([flip(a, station) for station in found])
    values = np.column_stack([sigma, np.array([station.x for station in found])])
    C = np.asarray(np.linalg.solve(np.vander(_NODES, increasing=True), values), np.float64)
    root = _root(_slope(C[:, 0]) if is_even else C[:, 0])
    return None if root is None else (C, root)


def _at(C: Array, u: float) -> Array:
    """The polynomials with the coefficients C, ascending, at u."""
    value: Array = np.vander([u], len(C), increasing=True)[0] @ C
    return value


def _slope(C: Array) -> Array:
    """Coefficients of the derivatives."""
    return C[1:] * np.arange(1.0, len(C)).reshape(-1, *[1] * (C.ndim - 1))


def _root(c: Array) -> float | None:
    """The root of a polynomial that is nearest to 0 by Newton's steps; None if it is far from the nodes."""
    u = 0.0
    for _ in range(20):
        slope = float(_at(_slope(c), u))
        u -= float(_at(c, u)) / slope if slope else math.inf
        if not abs(u) < 6.0:
            return None
    return u


def touching(mechanism: Mechanism, a: Station, b: Station) -> ChangePoint | None:
    """A change point between two stations where the determinant keeps its sign."""
    about = _least(mechanism, a, b)
    return None if about is None else crossing(mechanism, a, b, about)


def _least(mechanism: Mechanism, a: Station, b: Station) -> float | None:
    """Where sigma is least between two stations, to a thousandth of their distance; None if it stays large."""
    ratio = 0.5 * (math.sqrt(5.0) - 1.0)

    def sigma(s: float) -> float:
        station = mechanism.between(a, b, s)
        return 0.0 if station is None else station.sigma

    low, high = 0.0, float(np.linalg.norm(b.x - a.x))
    x, y = high - ratio * high, ratio * high
    at_x, at_y = sigma(x), sigma(y)
    for k in range(16):
        if k == 6 and min(at_x, at_y) > 0.2 * min(a.sigma, b.sigma):
            return None
        if at_x < at_y:
            high, y, at_y = y, x, at_x
            x = high - ratio * (high - low)
            at_x = sigma(x)
        else:
            low, x, at_x = x, y, at_y
            y = low + ratio * (high - low)
            at_y = sigma(y)
    return 0.5 * (low + high)


def other_branch(mechanism: Mechanism, change: ChangePoint) -> Array | None:
    """The tangent of the other branch at a change point; None if there is none, or more than one."""
    seen = mechanism.see(change.x, mechanism.near)
    if seen is None:
        return None
    U, S, Vt = np.linalg.svd(seen[1])
    cut = _CUT * float(S.max())
    rank = int(np.count_nonzero(cut < S))
    null = Vt[rank:].T
    if null.shape[1] != 2:
        return None
    t = null @ (null.T @ change.tangent)
    t = t / np.linalg.norm(t)
    p: Array = null @ np.array([-(null.T @ t)[1], (null.T @ t)[0]])
    psi = U[:, rank:].T

    def bent(v: Array) -> Array:
        """psi^T F_xx[v, v]; with time in the rows only the part even in v is meant, less that of v = 0."""
        bias = [mechanism.bias(change.x, part) for part in (v, -v, 0.0 * v)]
        return psi @ (0.5 * (bias[0] + bias[1]) - bias[2])

    straight, across = bent(t), bent(p)
    mixed = bent(t + p) - straight - across  # 2 F_xx[t, p]
    forms = np.column_stack([mixed, across])  # times (1, b) is zero, for the direction t + b p
    _U, size, W = np.linalg.svd(forms)
    if size[0] < _CUT or (len(size) > 1 and size[1] > _FLAT * size[0]) or abs(W[-1, 1]) < _FLAT:
        return None
    return mechanism.chart.speeds(change.x, W[-1, 0] * t + W[-1, 1] * p)
