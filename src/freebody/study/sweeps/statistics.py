"""Mean, spread and extremes of very many numbers, part by part.

Two parts are joined by  M = M_a + M_b + d^2 n_a n_b / n  with d the difference of their means, so that nothing cancels.
The mean of n independent cases has the error s / sqrt(n).
Source: Chan, Golub & LeVeque, Amer. Statist. 37, 1983, 242-247.
"""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import dataclass
from typing import Any

import numpy as np

from freebody.numeric.jets import Array


@dataclass(frozen=True)
class Statistics:
    """n: how many numbers there are; deviation: the standard deviation of a sample; NaN where there are too few."""

    n: int
    mean: float
    deviation: float
    least: float
    greatest: float

    @property
    def error(self) -> float:
        """Of the mean, if the cases are independent."""
        return self.deviation / math.sqrt(self.n) if self.n > 1 else math.nan

    def to_plain(self, *, is_random: bool) -> dict[str, Any]:
        """error_of_mean: of random cases."""
        told = {
            "n": self.n,
            "mean": self.mean,
            "deviation": self.deviation,
            "least": self.least,
            "greatest": self.greatest,
        }
        return {**told, "error_of_mean": self.error} if is_random else told


def statistics(parts: Iterable[Array]) -> Statistics:
    """Of the numbers in all parts; NaN are none."""
    n, mean, squares, least, greatest = 0, 0.0, 0.0, math.inf, -math.inf
    for part in parts:
        x = part[np.isfinite(part)]
        if not len(x):
            continue
        own = float(np.mean(x))
        difference, total = own - mean, n + len(x)
        squares += float(np.sum((x - own) ** 2)) + difference**2 * n * len(x) / total
        mean += difference * len(x) / total
        n, least, greatest = total, min(least, float(x.min())), max(greatest, float(x.max()))
    if not n:
        return Statistics(0, math.nan, math.nan, math.nan, math.nan)
    return Statistics(n, mean, math.sqrt(squares / (n - 1)) if n > 1 else math.nan, least, greatest)
