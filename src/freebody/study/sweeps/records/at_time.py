"""`X at 2 s`: what a series is at an instant."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from freebody.errors import InputError
from freebody.study.given import seconds
from freebody.study.sweeps.records.base import Followed, Record, Units

FORM = "X at 2 s"


@dataclass(frozen=True)
class AtTime(Record):
    """The value at an instant that the motion reaches."""

    series: str
    time: float

    @property
    def times(self) -> tuple[float, ...]:  # type: ignore[override]
        return (self.time,)

    def value(self, motion: Followed) -> float:
        k = int(np.searchsorted(motion.times, self.time))
        is_there = k < len(motion.times) and motion.times[k] == self.time
        return float(motion.series(self.series)[k]) if is_there else math.nan


def read(text: str, units: Units) -> AtTime | None:
    name, _, when = text.partition(" at ")
    if name not in units or not when:
        return None
    try:
        return AtTime(text, units[name], name, seconds(when))
    except InputError:
        return None
