"""A Latin hypercube: every name takes each of n equal parts of its range once, in random order.

Source: McKay, Beckman & Conover, Technometrics 21, 1979, 239-245.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from freebody.numeric.jets import Array
from freebody.study.sweeps.ranges.base import Range
from freebody.study.sweeps.samplings.base import Drawn, how_many

FORM = "lhs:500"


@dataclass(frozen=True)
class LatinHypercube(Drawn):
    """n points; they are drawn together, since each knows of the others."""

    seed: int = 0

    is_random = True

    @cached_property
    def _all(self) -> Array:
        rng = np.random.default_rng([self.seed, 1])
        columns = [(rng.permutation(self.n) + rng.random(self.n)) / self.n for _ in self.ranges]
        return np.column_stack(columns) if columns else np.zeros((self.n, 0))

    def points(self, start: int, stop: int) -> Array:
        return self._all[start:stop]


def make(text: str, ranges: Mapping[str, Range], seed: int) -> LatinHypercube:
    return LatinHypercube(ranges, how_many(text, FORM), seed)
