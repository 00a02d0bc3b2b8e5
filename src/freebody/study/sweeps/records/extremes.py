"""`maximum of X`, `minimum of X`: how far a series gets in the motion.

It is looked at its output times. Between two of them a measure follows the cubic that has its values and rates at both,
whose error goes with the fourth power of their distance; where a contact changes or something strikes in between, and
for reactions, the output times alone count.
Source: Hairer, Norsett & Wanner, Solving Ordinary Differential Equations I, 2nd ed. 1993, sec. II.6 (Hermite
interpolation).
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from freebody.errors import CannotAnswer
from freebody.language.sentences import Message
from freebody.numeric.jets import Array
from freebody.study.sweeps.records.base import Followed, Record, Seen, Units, rate_of

if TYPE_CHECKING:
    from freebody.study.simulation.tangents import MotionTangents

FORM = "maximum of X, minimum of X"


@dataclass(frozen=True)
class Extreme(Record):
    """The greatest (side +1) or the least (-1) value; none of a motion that did not get to its end."""

    series: str
    side: int

    needs_course = True

    @property
    def seen(self) -> Seen:  # pyrefly: ignore[bad-override]
        return Seen(self.series, side=self.side)

    def value(self, motion: Followed) -> float:
        return self._found(motion)[0]

    def instants(self, motion: Followed) -> tuple[float, ...]:
        return (self._found(motion)[1],)

    def change(self, motion: Followed, tangents: MotionTangents) -> Array:
        """Where a rise turns into a fall the rate x' vanishes, so that the change of x there is that of its greatest
        value; what is left of x' puts the instant right by dt = -x'/x''. At the ends of the motion, or where its law
        changes, x' does not vanish, and the instant may move."""
        t, end = self._found(motion)[1], motion.result.t_end
        if t <= 0.0:
            return tangents.at(self.series, 0.0).by
        if t >= end:
            last = tangents.at(self.series, end)
            return last.by + last.rate * tangents.end
        turn = tangents.turn_at(t)
        if turn is not None:
            before = tangents.at(self.series, t, before=True)
            return before.by + before.rate * turn
        rates = rate_of(self.series)
        if rates not in motion.measures or self.series.endswith("_acceleration"):
            raise CannotAnswer(
                Message(
                    "the {extreme} lies inside the motion: exact derivatives of such extremes exist for measures "
                    "and their rates only",
                    extreme=self.text,
                )
            )
        here, slope = tangents.at(self.series, t), tangents.at(rates, t)
        if slope.rate == 0.0:
            raise CannotAnswer(
                Message("{extreme}: the value stays constant for a while, so there is no derivative", extreme=self.text)
            )
        return here.by - slope.by * slope.value / slope.rate

    def _found(self, motion: Followed) -> tuple[float, float]:
        """The value, and when."""
        x = self.side * motion.series(self.series)
        if not motion.is_complete or np.isnan(x).all():
            return math.nan, math.nan
        k = int(np.nanargmax(x))
        best, when = float(x[k]), float(motion.times[k])
        rates = motion.measures.get(rate_of(self.series))
        if rates is not None and len(x) > 1:
            inside, at = _between(motion, x, self.side * rates)
            if inside > best:
                best, when = inside, at
        return self.side * best, when


def _between(motion: Followed, x: Array, rates: Array) -> tuple[float, float]:
    """The greatest value inside of the intervals in which a rise turns into a fall, and when."""
    t, events = motion.times, np.array([e.time for e in motion.result.events])
    turns = np.flatnonzero((rates[:-1] > 0.0) & (rates[1:] < 0.0))
    best, when = -math.inf, math.nan
    for k in turns:
        if np.any((events > t[k]) & (events <= t[k + 1])) and motion.result.simulator.bounded is not None:
            continue
        h = t[k + 1] - t[k]
        top, part = _top(float(x[k]), float(x[k + 1]), float(h * rates[k]), float(h * rates[k + 1]))
        if top > best:
            best, when = top, float(t[k] + part * h)
    return best, when


def _top(x0: float, x1: float, r0: float, r1: float) -> tuple[float, float]:
    """The greatest value on [0, 1], and where, of the cubic with values x0, x1 and slopes r0 > 0 > r1 at the ends."""
    a, b = 2.0 * (x0 - x1) + r0 + r1, 3.0 * (x1 - x0) - 2.0 * r0 - r1
    root = math.sqrt(max(b * b - 3.0 * a * r0, 0.0))
    s = r0 / (root - b)  # the root of 3 a s^2 + 2 b s + r0 at which it falls
    return x0 + s * (r0 + s * (b + s * a)), s


def read(text: str, units: Units) -> Extreme | None:
    word, _, name = text.partition(" of ")
    if word not in ("maximum", "minimum") or name not in units:
        return None
    return Extreme(text, units[name], name, 1 if word == "maximum" else -1)
