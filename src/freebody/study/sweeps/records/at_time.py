"""`X at 2 s`: what a series is at an instant."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from freebody.errors import InputError
from freebody.numeric.jets import Array
from freebody.study.given import seconds
from freebody.study.sweeps.records.base import Followed, Record, Seen, Units

if TYPE_CHECKING:
    from freebody.study.simulation.tangents import MotionTangents

FORM = "X at 2 s"


@dataclass(frozen=True)
class AtTime(Record):
    """The value at an instant that the motion reaches."""

    series: str
    time: float

    @property
    def times(self) -> tuple[float, ...]:  # pyrefly: ignore[bad-override]
        return (self.time,)

    @property
    def seen(self) -> Seen:  # pyrefly: ignore[bad-override]
        return Seen(self.series, self.time)

    def value(self, motion: Followed) -> float:
        k = int(np.searchsorted(motion.times, self.time))
        is_there = k < len(motion.times) and motion.times[k] == self.time
        return float(motion.series(self.series)[k]) if is_there else math.nan

    def instants(self, motion: Followed) -> tuple[float, ...]:
        return self.times

    def change(self, motion: Followed, tangents: MotionTangents) -> Array:
        return tangents.at(self.series, self.time).by


def read(text: str, units: Units) -> AtTime | None:
    name, _, when = text.partition(" at ")
    if name not in units or not when:
        return None
    try:
        return AtTime(text, units[name], name, seconds(when))
    except InputError:
        return None
