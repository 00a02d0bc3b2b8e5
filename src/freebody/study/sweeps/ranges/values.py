"""`0.1, 0.2, 0.3`: some values; where they are drawn, each is as likely."""

from __future__ import annotations

import re
from dataclasses import dataclass

import numpy as np

from freebody.numeric.jets import Array
from freebody.study.sweeps.ranges.base import Range, Read

FORM = "0.1, 0.2, 0.3 m"
_NUMBER = re.compile(r"\s*[-+−]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?")


@dataclass(frozen=True)
class Values(Range):
    """Some values."""

    values: tuple[float, ...]

    @property
    def extent(self) -> tuple[float, float]:
        return min(self.values), max(self.values)

    def quantiles(self, u: Array) -> Array:
        n = len(self.values)
        return np.array(self.values)[np.minimum((u * n).astype(np.int64), n - 1)]

    @property
    def grid(self) -> Array:
        return np.array(self.values)


def read(text: str, read: Read) -> Values | None:
    parts = [part.strip() for part in text.split(",")]
    if not all(_NUMBER.match(part) for part in parts) or ".." in text:
        return None
    last = _NUMBER.sub("", parts[-1], count=1)
    # 1, 2, 3 kg: the unit of all
    return Values(tuple(read(part if _NUMBER.sub("", part, count=1).strip() else part + last) for part in parts))
