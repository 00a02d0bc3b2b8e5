"""`final X`: what a series comes to at the end of the motion."""

from __future__ import annotations

import math
from dataclasses import dataclass

from freebody.study.sweeps.records.base import Followed, Record, Units

FORM = "final X"


@dataclass(frozen=True)
class Final(Record):
    """The last value; none of a motion that did not get to its end."""

    series: str

    def value(self, motion: Followed) -> float:
        return float(motion.series(self.series)[-1]) if motion.is_complete else math.nan


def read(text: str, units: Units) -> Final | None:
    name = text.removeprefix("final ")
    return Final(text, units[name], name) if name != text and name in units else None
