"""Linear differential equations x' = A(t) x + B(t) on panels of time, A and B known at some places of every panel.

On a panel of length h the polynomial of degree s that fulfils the equation at the s places t + c_i h of Gauss leads
from one end to the other with an error of order h^(2s). Its slope at the end, beside the one that the equation has
there, is off by an error of order h^s: the measure of whether the panel was short enough.
Source: Hairer, Norsett & Wanner, Solving Ordinary Differential Equations I, 2nd ed. 1993, sec. II.7.
"""

from __future__ import annotations

from functools import cache

import numpy as np

from freebody.errors import CannotAnswer
from freebody.language.sentences import Message
from freebody.numeric.jets import Array
from freebody.numeric.kernels import collocating

N_PLACES = 6
UNSETTLED = Message("the derivatives of the motion do not settle; follow it with a smaller tolerance")


@cache
def _places() -> tuple[Array, Array, Array, Array]:
    """c (s,), a (s, s), b (s,), and the weights (s,) by which slopes at the places are continued to the end."""
    x, w = np.polynomial.legendre.leggauss(N_PLACES)
    c, b = 0.5 * (x + 1.0), 0.5 * w
    powers = np.arange(N_PLACES)
    V = c[:, None] ** powers  # values of 1, t, t^2 ... at the places
    a = (c[:, None] ** (powers + 1) / (powers + 1)) @ np.linalg.inv(V)
    return c, np.ascontiguousarray(a), b, np.ones(N_PLACES) @ np.linalg.inv(V)


def instants(ends: Array) -> Array:
    """(n_panels (s + 1) + 1,) the ends of the panels with the places between them."""
    c = _places()[0]
    inner = ends[:-1, None] + np.diff(ends)[:, None] * np.concatenate(([0.0], c))
    return np.append(inner.ravel(), ends[-1])


def propagated(ends: Array, F: Array, x0: Array, least: Array) -> tuple[Array, Array]:
    """x at the ends of all panels (n_panels + 1, f, k), and how far off each was (n_panels,), by the size of x.

    F (n f, f + k): A and B at `instants(ends)`, f rows each; x0 (f, k); least (k,): sizes below which x does not count.
    Raises CannotAnswer where a panel has no solution."""
    n, (f, k) = len(ends) - 1, x0.shape
    if not f:
        return np.empty((n + 1, 0, k)), np.zeros(n)
    _c, a, b, last = _places()
    s = len(b)
    x, off = np.empty(((n + 1) * f, k)), np.zeros((n, k))
    x[:f] = x0
    room, pivots = np.empty((s * f, s * f)), np.empty(s * f, dtype=np.int32)
    given, slopes = np.empty((s * f, k)), np.empty((s * f, k))
    if not collocating.collocated(ends, F, a, b, last, room, pivots, given, slopes, x, off):
        raise CannotAnswer(UNSETTLED)
    found = x.reshape(n + 1, f, k)
    size = np.maximum(np.abs(found).max(axis=(0, 1)), least)
    return found, (off / size).max(axis=1)
