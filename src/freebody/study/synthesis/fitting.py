"""A path of points without crank angles, met or approached by the coupler curve of a four-bar.

From many starts (`guesses`) the distances of the points (`loop`) are made small by least squares in all lengths and in
a crank angle for every point, with exact slopes. A four-bar has nine free numbers, so that up to nine points are met
exactly if a search ends at a solution; the searches are local, and that there is no other solution, or no better one,
is not proved.
Source: Wampler, Morgan & Sommese, J. Mech. Design 114, 1992, 153-159 (nine points: 4326 solutions, complex ones
included).
"""

from __future__ import annotations

from dataclasses import dataclass
from importlib import import_module
from typing import Any

import numpy as np

from freebody.numeric.jets import Array
from freebody.study.synthesis.guesses import arc_guesses, closed_guesses
from freebody.study.synthesis.linkage import Linkage
from freebody.study.synthesis.loop import LONGEST, N_SHAPE, Complex, residuals, slopes, solved_curve

MOST_EXACT = N_SHAPE  # points
FEWEST_CLOSED = 6  # points that have the look of a closed curve
_SAME = 1e-3  # of the size: fits to the same linkage
_MET = 1e-8  # of the size: points missed by less
_EXACT, _NEAR = 1e-14, 1e-8  # relative: where a search of a solution, or of a best value, ends


@dataclass(frozen=True)
class Fits:
    """linkages: the best first, and only those that meet all points where there are such; n_searches: that were made;
    is_met: whether all points are met."""

    linkages: tuple[Linkage, ...]
    n_searches: int
    is_met: bool


def fitted(points: Array, *, is_closed: bool = True, full_turn: bool = True, seed: int = 0) -> Fits:
    """Linkages whose coupler curve meets points (n, 2) in their order, or comes near them."""
    target: Complex = points[:, 0] + 1j * points[:, 1]
    size = float(np.abs(target - target.mean()).max())
    scaled = (target - target.mean()) / size
    optimize: Any = import_module("scipy.optimize")
    found: list[tuple[float, Array, int]] = []
    high = np.full(N_SHAPE + len(target), np.inf)
    high[3:7] = LONGEST
    bounds = np.where(np.isfinite(high), 1e-3, -np.inf), high
    tolerance = _EXACT if len(target) <= MOST_EXACT else _NEAR
    guesses = closed_guesses(scaled, seed) if is_closed and len(target) >= FEWEST_CLOSED else []
    if len(target) <= MOST_EXACT or not is_closed:
        guesses += arc_guesses(scaled, seed, full_turn=full_turn)
    for x0, side in guesses:
        fit = optimize.least_squares(
            residuals,
            x0,
            jac=slopes,
            args=(side, scaled),
            bounds=bounds,
            x_scale="jac",
            max_nfev=300,
            ftol=tolerance,
            xtol=tolerance,
            gtol=tolerance,
        )
        if np.isfinite(fit.cost) and solved_curve(np.asarray(fit.x), side) is not None:
            found.append((float(fit.cost), np.asarray(fit.x, dtype=np.float64), side))
    found.sort(key=lambda one: one[0])
    kept: list[tuple[Array, int]] = []
    for _cost, x, side in found:
        if all(np.abs(np.abs(x[3:7]) - np.abs(y[3:7])).max() > _SAME for y, _s in kept):
            kept.append((x, side))
    linkages = [_linkage(x, side, target, size) for x, side in kept]
    met = [linkage for linkage in linkages if linkage.missed == 0.0]
    return Fits(tuple(met or linkages), len(guesses), bool(met))


def _linkage(x: Array, side: int, target: Complex, size: float) -> Linkage:
    """In the places and the size of the path; what it misses by rounding only is met."""
    solved = solved_curve(x, side)
    assert solved is not None
    P, ephi, _epsi = solved
    turn = np.exp(1j * x[2])
    A = x[0] + 1j * x[1]
    B = A + turn * x[3] * np.exp(1j * x[N_SHAPE:])
    C = B + turn * x[4] * ephi

    def back(z: Any) -> Array:
        moved = target.mean() + size * np.asarray(z)
        return np.stack((moved.real, moved.imag), axis=-1)

    missed = float(np.abs(target.mean() + size * P - target).max())
    missed = missed if missed > _MET * size else 0.0
    return Linkage(back(A), back(B), back(C), back(A + turn * x[6]), P=back(P), missed=missed)
