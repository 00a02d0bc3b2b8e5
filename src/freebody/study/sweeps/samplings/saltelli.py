"""Cases for Sobol' indices: two independent tables of points, and the first with each column of the second in turn.

`saltelli:1024` makes 1024 (d + 2) cases of d names.
Source: Saltelli et al., Comput. Phys. Commun. 181, 2010, 259-270.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from importlib import import_module
from importlib.util import find_spec
from typing import Any

import numpy as np

from freebody.errors import InputError
from freebody.language.sentences import Message
from freebody.numeric.jets import Array
from freebody.study.sweeps.ranges.base import Range
from freebody.study.sweeps.samplings.base import Drawn, how_many

FORM = "saltelli:1024"


@dataclass(frozen=True)
class Saltelli(Drawn):
    """size: rows of each table, a power of two."""

    size: int = 0
    seed: int = 0

    @cached_property
    def _all(self) -> Array:
        sampler: Any = import_module("SALib.sample.sobol")
        points = sampler.sample(problem(list(self.ranges)), self.size, calc_second_order=False, seed=self.seed)
        return np.asarray(points, dtype=np.float64)

    def points(self, start: int, stop: int) -> Array:
        return self._all[start:stop]


def problem(names: Sequence[str]) -> dict[str, Any]:
    """The names, each between 0 and 1, as SALib describes them."""
    return {"num_vars": len(names), "names": list(names), "bounds": [[0.0, 1.0]] * len(names)}


def make(text: str, ranges: Mapping[str, Range], seed: int) -> Saltelli:
    size = how_many(text, FORM)
    if size & (size - 1):
        low, high = 1 << (size.bit_length() - 1), 1 << size.bit_length()
        told = Message(
            "the number of saltelli must be a power of two: take {low} or {high}, not {n}", low=low, high=high, n=size
        )
        raise InputError(told)
    if find_spec("SALib") is None:
        raise InputError(Message('Sobol\' indices need SALib; pip install "freebody[sweep]"'))
    return Saltelli(ranges, size * (len(ranges) + 2), size, seed)
