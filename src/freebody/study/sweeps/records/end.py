"""`end`: when the motion ends."""

from __future__ import annotations

from freebody.study.sweeps.records.base import Followed, Record, Units

FORM = "end"


class End(Record):
    """The time at which the motion ends, at the latest that up to which it was to be followed."""

    def value(self, motion: Followed) -> float:
        return motion.result.t_end


def read(text: str, _units: Units) -> End | None:
    return End(text, "s") if text == "end" else None
