"""`1..3 kg`, and `1..3 kg:50` for as many values of a grid, evenly from one end to the other."""

from __future__ import annotations

import re
from dataclasses import dataclass

import numpy as np

from freebody.errors import InputError
from freebody.language.sentences import Message
from freebody.numeric.jets import Array
from freebody.study.sweeps.ranges.base import Range, Read

FORM = "1..3 kg:50"
_FORM = re.compile(r"(?P<low>[^.,:]*(?:\.\d[^.,:]*)?)\.\.(?P<high>[^:,]*?)(?::\s*(?P<n>\d+))?")
_UNIT = re.compile(r"\s*[-+−]?[\d.]+(?:[eE][-+]?\d+)?")
MOST = 10_000_000  # values of one name


@dataclass(frozen=True)
class Span(Range):
    """Everything between two values."""

    low: float
    high: float
    n: int | None

    @property
    def extent(self) -> tuple[float, float]:
        return min(self.low, self.high), max(self.low, self.high)

    def quantiles(self, u: Array) -> Array:
        return self.low + (self.high - self.low) * u

    @property
    def grid(self) -> Array | None:
        return None if self.n is None else np.linspace(self.low, self.high, self.n)


def read(text: str, read: Read) -> Span | None:
    found = _FORM.fullmatch(text)
    if found is None:
        return None
    low, high = found["low"].strip(), found["high"].strip()
    unit = _UNIT.sub("", high, count=1)
    if not _UNIT.sub("", low, count=1).strip():  # 1..3 kg: the unit of both
        low += unit
    n = None if found["n"] is None else int(found["n"])
    if n is not None and not 1 <= n <= MOST:
        raise InputError(
            Message("{text}: a grid has between 1 and {most:,} values of a name, not {n:,}", text=text, most=MOST, n=n)
        )
    return Span(read(low), read(high), n)
