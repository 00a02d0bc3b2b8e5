"""Cases from a table, `table:cases.csv`: a column for each name, with a unit behind it in brackets if not in SI."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from freebody.errors import InputError
from freebody.language.sentences import Message
from freebody.numeric.jets import Array
from freebody.study.sweeps.ranges.base import Range
from freebody.study.sweeps.ranges.values import Values
from freebody.study.sweeps.samplings.base import Sampling

FORM = "table:cases.csv"


@dataclass(frozen=True)
class Table(Sampling):
    """The rows of a table, whose columns are the values of each name."""

    def cases(self, start: int, stop: int) -> Array:
        columns = [np.array(of.values[start:stop]) for of in self.ranges.values() if isinstance(of, Values)]
        return np.column_stack(columns)


def make(text: str, ranges: Mapping[str, Range], _seed: int) -> Table:
    columns = {name: of for name, of in ranges.items() if isinstance(of, Values)}
    n = {len(of.values) for of in columns.values()}
    if len(columns) < len(ranges) or len(n) != 1:
        raise InputError(Message("{text}: a table is given alone, without other names that vary", text=text))
    return Table(ranges, n.pop())
