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

import numpy as np

from freebody.numeric.jets import Array
from freebody.study.sweeps.records.base import Followed, Record, Units

FORM = "maximum of X, minimum of X"


@dataclass(frozen=True)
class Extreme(Record):
    """The greatest (side +1) or the least (-1) value; none of a motion that did not get to its end."""

    series: str
    side: int

    needs_course = True

    def value(self, motion: Followed) -> float:
        x = self.side * motion.series(self.series)
        if not motion.is_complete or np.isnan(x).all():
            return math.nan
        best = float(np.nanmax(x))
        rates = motion.measures.get(_rate_of(self.series))
        if rates is not None and len(x) > 1:
            best = max(best, _between(motion, x, self.side * rates))
        return self.side * best


def _rate_of(series: str) -> str:
    return f"{series.removesuffix('_rate')}_acceleration" if series.endswith("_rate") else f"{series}_rate"


def _between(motion: Followed, x: Array, rates: Array) -> float:
    """The greatest value inside of the intervals in which a rise turns into a fall."""
    t, events = motion.times, np.array([e.time for e in motion.result.events])
    turns = np.flatnonzero((rates[:-1] > 0.0) & (rates[1:] < 0.0))
    best = -math.inf
    for k in turns:
        if np.any((events > t[k]) & (events <= t[k + 1])) and motion.result.simulator.bounded is not None:
            continue
        h = t[k + 1] - t[k]
        best = max(best, _top(float(x[k]), float(x[k + 1]), float(h * rates[k]), float(h * rates[k + 1])))
    return best


def _top(x0: float, x1: float, r0: float, r1: float) -> float:
    """The greatest value on [0, 1] of the cubic with values x0, x1 and slopes r0 > 0 > r1 at the ends."""
    a, b = 2.0 * (x0 - x1) + r0 + r1, 3.0 * (x1 - x0) - 2.0 * r0 - r1
    root = math.sqrt(max(b * b - 3.0 * a * r0, 0.0))
    s = r0 / (root - b)  # the root of 3 a s^2 + 2 b s + r0 at which it falls
    return x0 + s * (r0 + s * (b + s * a))


def read(text: str, units: Units) -> Extreme | None:
    word, _, name = text.partition(" of ")
    if word not in ("maximum", "minimum") or name not in units:
        return None
    return Extreme(text, units[name], name, 1 if word == "maximum" else -1)
