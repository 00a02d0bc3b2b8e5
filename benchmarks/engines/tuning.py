"""Finding the cheapest setting of an engine that meets a tolerance, and timing it.

A run is a function of one setting (a number of steps, a tolerance) that returns its wall time and final positions.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from statistics import median
from typing import Any

from problems import Array, farthest

Run = Callable[[float], tuple[float, Array]]
N_SECONDS = 1.0  # spent on repeats of one figure, at least
LEAST, MOST = 5, 101  # repeats
BEYOND = 2  # further attempts that meet the tolerance


@dataclass(frozen=True)
class Attempt:
    setting: float
    error: float
    seconds: float


def geometric(first: int, last: int, ratio: float = 1.1) -> list[int]:
    """Rising numbers of steps, each about `ratio` times the one before."""
    n = math.ceil(math.log(last / first) / math.log(ratio))
    return sorted({round(first * (last / first) ** (k / n)) for k in range(n + 1)})


def repeated(seconds_of_one: Callable[[], float]) -> dict[str, Any]:
    """Median and minimum of repeats."""
    times: list[float] = []
    while len(times) < LEAST or (sum(times) < N_SECONDS and len(times) < MOST):
        times.append(seconds_of_one())
    return {"median_s": median(times), "minimum_s": min(times), "repeats": len(times)}


def attempts(run: Run, reference: Array, settings: Sequence[float], tolerance: float) -> list[Attempt]:
    """From coarse to fine, some way beyond the first that meets the tolerance: a finer one may be cheaper."""
    tried: list[Attempt] = []
    for setting in settings:
        seconds, positions = run(setting)
        tried.append(Attempt(setting, farthest(positions, reference), seconds))
        if len(_meeting(tried, tolerance)) > BEYOND:
            break
    return tried


def cheapest(tried: Sequence[Attempt], tolerance: float) -> Attempt | None:
    """The fastest attempt that meets the tolerance."""
    return min(_meeting(tried, tolerance), key=lambda attempt: attempt.seconds, default=None)


def _meeting(tried: Sequence[Attempt], tolerance: float) -> list[Attempt]:
    """Those within the tolerance whose next finer neighbour is too, so that luck is no reason."""
    return [a for a, finer in itertools.pairwise(tried) if max(a.error, finer.error) <= tolerance]
