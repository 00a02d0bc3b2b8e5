"""A scrambled Sobol' sequence: it fills the space of the names evenly.

Source: Owen, Scrambling Sobol' and Niederreiter-Xing points, J. Complexity 14, 1998, 466-489.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from freebody.errors import InputError
from freebody.language.sentences import Message
from freebody.numeric.jets import Array
from freebody.study.sweeps.ranges.base import Range
from freebody.study.sweeps.samplings.base import Drawn, how_many

FORM = "sobol:4096"
_MOST_NAMES = 21_201  # for which the tables have directions


@dataclass(frozen=True)
class Sobol(Drawn):
    """The first n points of a sequence."""

    seed: int = 0

    def points(self, start: int, stop: int) -> Array:
        if not self.ranges:
            return np.zeros((stop - start, 0))
        from scipy.stats import qmc

        sequence: Any = qmc.Sobol(len(self.ranges), scramble=True, rng=self.seed)
        if start:
            sequence.fast_forward(start)
        return sequence.random(stop - start)


def make(text: str, ranges: Mapping[str, Range], seed: int) -> Sobol:
    n = how_many(text, FORM)
    if n & (n - 1):
        raise InputError(
            Message(
                "a Sobol' sequence is even for powers of two only: take sobol:{low} or sobol:{high}, not {n}",
                low=1 << (n.bit_length() - 1),
                high=1 << n.bit_length(),
                n=n,
            )
        )
    if len(ranges) > _MOST_NAMES:
        raise InputError(Message("a Sobol' sequence has at most {most:,} names", most=_MOST_NAMES))
    return Sobol(ranges, n, seed)
