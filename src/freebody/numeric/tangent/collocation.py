"""Linear differential equations x' = A(t) x + B(t) on panels of time, A and B known at some places of every panel.

On a panel of length h the polynomial of degree s that fulfils the equation at the s places t + c_i h of Gauss leads
from one end to the other with an error of order h^(2s). Its slope at the end, beside the one that the equation has
there, is off by an error of order h^s: the measure of whether the panel was short enough.
Source: Hairer, Norsett & Wanner, Solving Ordinary Differential Equations I, 2nd ed. 1993, sec. II.7.
"""

from __future__ import annotations

from functools import cache

import numpy as np

from freebody.numeric.jets import Array

N_PLACES = 6


@cache
def _places() -> tuple[Array, Array, Array, Array]:
    """c (s,), a (s, s), b (s,), and the weights (s,) by which slopes at the places are continued to the end."""
    x, w = np.polynomial.legendre.leggauss(N_PLACES)
    c, b = 0.5 * (x + 1.0), 0.5 * w
    powers = np.arange(N_PLACES)
    V = c[:, None] ** powers  # values of 1, t, t^2 ... at the places
    a = (c[:, None] ** (powers + 1) / (powers + 1)) @ np.linalg.inv(V)
    return c, a, b, np.ones(N_PLACES) @ np.linalg.inv(V)


def instants(ends: Array) -> Array:
    """(n_panels (s + 1) + 1,) the ends of the panels with the places between them."""
    c = _places()[0]
    inner = ends[:-1, None] + np.diff(ends)[:, None] * np.concatenate(([0.0], c))
    return np.append(inner.ravel(), ends[-1])


def propagated(ends: Array, A: Array, B: Array, x0: Array, least: Array) -> tuple[Array, Array]:
    """x at the ends of all panels (n_panels + 1, f, k), and how far off each was (n_panels,), by the size of x.

    A (n, f, f), B (n, f, k) at `instants(ends)`; x0 (f, k); least (k,): sizes below which x does not count."""
    n, f, k = len(ends) - 1, A.shape[1], B.shape[2]
    x = np.empty((n + 1, f, k))
    x[0] = x0
    if not f:
        return x, np.zeros(n)
    c, a, b, last = _places()
    s, h = len(c), np.diff(ends)[:, None, None]

    # the slopes at the places follow from one linear system for every panel: for the motions of the equation without
    # B that begin with each unit of x, and for the one with B that begins with zero
    inner = (np.arange(n)[:, None] * (s + 1) + 1 + np.arange(s)).ravel()
    Ai, Bi = A[inner].reshape(n, s, f, f), B[inner].reshape(n, s, f, k)
    system = np.eye(s * f) - h * np.einsum("ij,nifg->nifjg", a, Ai).reshape(n, s * f, s * f)
    given = np.concatenate((Ai, Bi), axis=3).reshape(n, s * f, f + k)
    slopes = np.asarray(np.linalg.solve(system, given), dtype=np.float64).reshape(n, s, f, f + k)
    step = h * np.einsum("i,nifc->nfc", b, slopes)
    for p in range(n):
        x[p + 1] = x[p] + step[p, :, :f] @ x[p] + step[p, :, f:]

    at_end = np.einsum("i,nifc->nfc", last, slopes)
    meant = A[s + 1 :: s + 1] @ x[1:] + B[s + 1 :: s + 1]
    off = h * np.abs(at_end[:, :, :f] @ x[:-1] + at_end[:, :, f:] - meant)
    size = np.maximum(np.abs(x).max(axis=(0, 1)), least)
    return x, (off / size).max(axis=(1, 2))
