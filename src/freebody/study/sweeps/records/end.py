"""`end`: when the motion ends."""

from __future__ import annotations

from typing import TYPE_CHECKING

from freebody.numeric.jets import Array
from freebody.study.sweeps.records.base import Followed, Record, Units

if TYPE_CHECKING:
    from freebody.study.simulation.tangents import MotionTangents

FORM = "end"


class End(Record):
    """The time at which the motion ends, at the latest that up to which it was to be followed."""

    def value(self, motion: Followed) -> float:
        return motion.result.t_end

    def instants(self, motion: Followed) -> tuple[float, ...]:
        return (motion.result.t_end,)

    def change(self, motion: Followed, tangents: MotionTangents) -> Array:
        return tangents.end


def read(text: str, _units: Units) -> End | None:
    return End(text, "s") if text == "end" else None
