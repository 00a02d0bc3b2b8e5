"""Independent random cases (Monte Carlo), whose means have a known error."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from freebody.numeric.jets import Array
from freebody.study.sweeps.ranges.base import Range
from freebody.study.sweeps.samplings.base import GROUP, Drawn, groups, how_many

FORM = "random:1000"


@dataclass(frozen=True)
class Random(Drawn):
    """n independent points; each group of them has a seed of its own, so that none hangs on where others begin."""

    seed: int = 0

    is_random = True

    def points(self, start: int, stop: int) -> Array:
        found = [
            np.random.default_rng([self.seed, 2, k]).random((GROUP, len(self.ranges))) for k in groups(start, stop)
        ]
        first = start // GROUP * GROUP
        return np.concatenate(found)[start - first : stop - first]


def make(text: str, ranges: Mapping[str, Range], seed: int) -> Random:
    return Random(ranges, how_many(text, FORM), seed)
