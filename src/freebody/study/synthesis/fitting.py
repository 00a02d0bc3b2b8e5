"""A path that is met or approached by the coupler curve of a linkage.

From many starts (`guesses`) the distances of the points (`loop`) are made small by least squares in all lengths and in
a crank angle for every point, or for the first one where the others are given from it, with exact slopes. As many
points are met exactly as there are free numbers, if a search ends at a solution; the searches are local, and that there
is no other solution, or no better one, is not proved.
Sources: Wampler, Morgan & Sommese, J. Mech. Design 114, 1992, 153-159 (nine points of a four-bar: 4326 solutions,
complex ones included); Ullah & Kota, J. Mech. Design 119, 1997, 504-510 (Fourier descriptors).
"""

from __future__ import annotations

from dataclasses import dataclass
from importlib import import_module
from typing import Any

import numpy as np

from freebody.numeric.jets import Array
from freebody.study.synthesis.guesses import Guess, arc_guesses, closed_guesses
from freebody.study.synthesis.linkage import Linkage
from freebody.study.synthesis.loop import LONGEST, LOOPS, TracedPath

FEWEST_CLOSED = 6  # points that have the look of a closed curve
_SAME = 1e-3  # of the size: fits to the same linkage
_MET = 1e-8  # of the size: points missed by less
_EXACT, _NEAR = 1e-14, 1e-8  # relative: where a search of a solution, or of a best value, ends


@dataclass(frozen=True)
class Fits:
    """linkages: the best first, and only those that meet all points where there are such; n_searches: that were made;
    is_met: whether all points are met; n_free: numbers that the points leave free, below 0 where they are too
    many."""

    linkages: tuple[Linkage, ...]
    n_searches: int
    is_met: bool
    n_free: int


def most_met(linkage: str, *, is_timed: bool) -> int:
    """How many points a linkage of this kind meets in general."""
    return (LOOPS[linkage].n_shape + 1) // 2 if is_timed else LOOPS[linkage].n_shape


def fitted(
    points: Array,
    linkage: str = "four-bar",
    *,
    turns: Array | None = None,
    is_closed: bool = True,
    full_turn: bool = True,
    seed: int = 0,
) -> Fits:
    """Linkages whose coupler curve meets points (n, 2) in their order, or comes near them; turns: (n,) of the crank
    from the first point, where they are given."""
    whole = points[:, 0] + 1j * points[:, 1]
    middle, size = complex(whole.mean()), float(np.abs(whole - whole.mean()).max()) or 1.0
    path = TracedPath(LOOPS[linkage], (whole - middle) / size, turns)
    guesses: list[Guess] = []
    if is_closed and turns is None and len(points) >= FEWEST_CLOSED:
        guesses += closed_guesses(path, seed)
    if path.is_met or turns is not None or not is_closed:
        guesses += arc_guesses(path, seed, full_turn=full_turn)
    found = [fit for guess in guesses if (fit := _searched(path, *guess)) is not None]
    found.sort(key=lambda one: one[0])
    kept: list[tuple[Array, int]] = []
    for _cost, x, side in found:
        if all(np.abs(np.abs(x[path.loop.links]) - np.abs(y[path.loop.links])).max() > _SAME for y, _s in kept):
            kept.append((x, side))
    linkages = [_linkage(path, x, side, middle, size) for x, side in kept]
    met = [one for one in linkages if one.missed == 0.0]
    return Fits(tuple(met or linkages), len(guesses), bool(met), path.n_unknowns - 2 * len(points))


def _searched(path: TracedPath, x0: Array, side: int) -> tuple[float, Array, int] | None:
    """Where the search ends; None where the loop does not close there."""
    optimize: Any = import_module("scipy.optimize")
    loop = path.loop
    low, high = np.full(path.n_unknowns, -np.inf), np.full(path.n_unknowns, np.inf)
    high[loop.links] = LONGEST
    low[loop.links] = [1e-3] * (len(loop.lengths) - loop.n_signed) + [-LONGEST] * loop.n_signed
    tolerance = _EXACT if path.is_met else _NEAR
    fit = optimize.least_squares(
        path.residuals,
        x0,
        jac=path.slopes,
        args=(side,),
        bounds=(low, high),
        x_scale="jac",
        max_nfev=300,
        ftol=tolerance,
        xtol=tolerance,
        gtol=tolerance,
    )
    x = np.asarray(fit.x, dtype=np.float64)
    return (float(fit.cost), x, side) if np.isfinite(fit.cost) and path.solved(x, side) is not None else None


def _linkage(path: TracedPath, x: Array, side: int, middle: complex, size: float) -> Linkage:
    """In the places and the size of the path; what it misses by rounding only is met."""
    solved = path.solved(x, side)
    assert solved is not None
    P, ephi = solved
    A, turn = x[0] + 1j * x[1], np.exp(1j * x[2])
    pins = path.loop.pins(x[path.loop.links], path.crank(x), ephi)

    def back(z: Any) -> Array:
        moved = middle + size * np.asarray(z)
        return np.asarray(np.stack((moved.real, moved.imag), axis=-1), dtype=np.float64)

    missed = float(size * np.abs(P - path.target).max())
    return Linkage(
        back(A),
        back(A + turn * pins.B),
        back(A + turn * pins.C),
        None if pins.D is None else back(A + turn * pins.D),
        None if pins.along is None else np.array(((turn * pins.along).real, (turn * pins.along).imag)),
        P=back(P),
        missed=missed if missed > _MET * size else 0.0,
    )
