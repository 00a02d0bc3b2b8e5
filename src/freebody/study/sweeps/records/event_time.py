"""`time when theta = 90 deg`, `time when ball hits floor`: when an event first happens after the start.

What happens to contacts has the words in which a simulation tells it.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

from freebody.numeric.jets import Array
from freebody.study.sweeps.records.base import Followed, Record, Units

if TYPE_CHECKING:
    from freebody.study.simulation.tangents import MotionTangents

FORM = "time when theta = 90 deg, time when EVENT"
_AT_START = ("start", "zero")


@dataclass(frozen=True)
class EventTime(Record):
    """The time of the first such event."""

    event: str

    @property
    def events(self) -> tuple[str, ...]:  # pyrefly: ignore[bad-override]
        return (self.event,) if "=" in self.event else ()

    @property
    def named(self) -> str:  # pyrefly: ignore[bad-override]
        """What happens to a contact; nothing where a measure reaches a value."""
        return "" if "=" in self.event else self.event

    def value(self, motion: Followed) -> float:
        found = (e.time for e in motion.result.events if e.name == self.event and e.kind not in _AT_START)
        return next(found, math.nan)

    def instants(self, motion: Followed) -> tuple[float, ...]:
        return (self.value(motion),)

    def change(self, motion: Followed, tangents: MotionTangents) -> Array:
        return tangents.event(self.event, self.value(motion))


def read(text: str, _units: Units) -> EventTime | None:
    words = text.removeprefix("time when ")
    return None if words == text or not words else EventTime(text, "s", words)
