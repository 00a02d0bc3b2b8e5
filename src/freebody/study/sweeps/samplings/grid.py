"""All values of all names together: the first name changes slowest."""

from __future__ import annotations

import math
from collections.abc import Mapping

import numpy as np

from freebody.errors import InputError
from freebody.language.sentences import Message
from freebody.numeric.jets import Array
from freebody.study.sweeps.ranges.base import Range
from freebody.study.sweeps.samplings.base import MOST, Sampling

FORM = "grid"


class Grid(Sampling):
    """A full grid."""

    @property
    def dimensions(self) -> Mapping[str, int]:
        return {name: len(values) for name, values in self.axes.items()}

    @property
    def axes(self) -> Mapping[str, Array]:
        """The values of each name."""
        return {name: x for name, of in self.ranges.items() if (x := of.grid) is not None}

    def cases(self, start: int, stop: int) -> Array:
        axes = self.axes
        places = np.unravel_index(np.arange(start, stop), tuple(map(len, axes.values()))) if axes else ()
        columns = [values[k] for values, k in zip(axes.values(), places, strict=True)]
        return np.column_stack(columns) if columns else np.zeros((stop - start, 0))


def make(text: str, ranges: Mapping[str, Range], _seed: int) -> Grid:
    if text:
        raise InputError(
            Message("a grid takes its numbers from the ranges, as m1=1..3 kg:50, not from '{text}'", text=text)
        )
    open_ = [name for name, of in ranges.items() if of.grid is None]
    if open_:
        raise InputError(
            Message(
                "a grid needs the values of {names}: say how many, as m1=1..3 kg:50; from a distribution draw "
                "cases, as sobol:1024",
                names=", ".join(open_),
            )
        )
    n = math.prod(len(x) for of in ranges.values() if (x := of.grid) is not None)
    if n > MOST:
        raise InputError(Message("the grid has {n:,} cases; at most {most:,} are taken", n=n, most=MOST))
    return Grid(ranges, n)
