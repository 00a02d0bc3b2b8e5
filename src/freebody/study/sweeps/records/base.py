"""One number of a motion."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, ClassVar

import numpy as np

from freebody.numeric.jets import Array
from freebody.study.simulation.observed import observed
from freebody.study.simulation.recorded import reaction_names
from freebody.study.simulation.simulate import Simulation

if TYPE_CHECKING:
    from freebody.study.simulation.tangents import MotionTangents

Units = Mapping[str, str]  # of the series of a motion


@dataclass(frozen=True)
class Seen:
    """What has to be seen of a motion for a record: a series at a time [s], at the end where that is None, or, with a
    side, its greatest (+1) or least (-1) value."""

    series: str
    time: float | None = None
    side: int = 0


def rate_of(series: str) -> str:
    """The series that is the rate of another one."""
    return f"{series.removesuffix('_rate')}_acceleration" if series.endswith("_rate") else f"{series}_rate"


@dataclass(frozen=True)
class Record(ABC):
    """text: as it was asked for; unit: of the number."""

    text: str
    unit: str

    events = tuple[str, ...]()  # what to look for on the way, in words
    named = ""  # what happens to a contact, in the words of a simulation
    times = tuple[float, ...]()  # at which the motion is looked at [s]
    needs_course = False  # the motion is looked at all along
    seen: ClassVar[Seen | None] = None  # what tells it, where that is a single number of a smooth motion

    @abstractmethod
    def value(self, motion: Followed) -> float:
        """The number; NaN where the motion has none."""

    @abstractmethod
    def instants(self, motion: Followed) -> tuple[float, ...]:
        """When the motion is looked at for the derivatives of the number [s]."""

    @abstractmethod
    def change(self, motion: Followed, tangents: MotionTangents) -> Array:
        """(k,) the derivatives of the number by the names of the tangents. Raises CannotAnswer where it has none."""


@dataclass(frozen=True)
class Followed:
    """A motion with its series by name, each evaluated when it is first asked for."""

    result: Simulation

    @property
    def times(self) -> Array:
        return self.result.course.times

    @property
    def is_complete(self) -> bool:
        return self.result.is_complete

    def series(self, name: str) -> Array:
        """(n_times,) values."""
        if name in self.measures:
            return self.measures[name]
        if name in self._reactions:
            k, sign = self._reactions[name]
            course = self.result.course
            return np.where(course.unique[:, k], sign * course.multipliers[:, k], np.nan)
        return np.asarray(self.result.recording.series[name].values, dtype=np.float64)

    @cached_property
    def measures(self) -> dict[str, Array]:
        """Values, rates and second derivatives of all named measures."""
        found = observed(self.result, dict(self.result.system.measures))
        return {
            f"{name}{suffix}": values
            for name, triple in found.items()
            for suffix, values in zip(("", "_rate", "_acceleration"), triple, strict=True)
        }

    @cached_property
    def _reactions(self) -> dict[str, tuple[int, float]]:
        rows = self.result.rows
        return {name: (k, row.sign) for k, (name, row) in enumerate(zip(reaction_names(rows), rows, strict=True))}
