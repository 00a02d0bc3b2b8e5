"""`final X`: what a series comes to at the end of the motion."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

from freebody.numeric.jets import Array
from freebody.study.sweeps.records.base import Followed, Record, Seen, Units

if TYPE_CHECKING:
    from freebody.study.simulation.tangents import MotionTangents

FORM = "final X"


@dataclass(frozen=True)
class Final(Record):
    """The last value; none of a motion that did not get to its end."""

    series: str

    @property
    def seen(self) -> Seen:  # pyrefly: ignore[bad-override]
        return Seen(self.series)

    def value(self, motion: Followed) -> float:
        return float(motion.series(self.series)[-1]) if motion.is_complete else math.nan

    def instants(self, motion: Followed) -> tuple[float, ...]:
        return (motion.result.t_end,)

    def change(self, motion: Followed, tangents: MotionTangents) -> Array:
        last = tangents.at(self.series, motion.result.t_end)
        return last.by + last.rate * tangents.end


def read(text: str, units: Units) -> Final | None:
    name = text.removeprefix("final ")
    return Final(text, units[name], name) if name != text and name in units else None
