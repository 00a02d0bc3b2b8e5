"""The time at which an event happens: the first sign change of a function along a motion.

Signs are compared at the steps and at quarters within them. Then a root is bracketed and found by Brent's
method on the motion itself, followed exactly from the step before.
"""

from __future__ import annotations

from collections.abc import Callable

from freebody.numeric.brent import zero_between
from freebody.numeric.checks import finite, named
from freebody.numeric.jets import Array
from freebody.numeric.snapshot import Snapshot, snapshot_of
from freebody.tolerances import WATCHED_ZERO

_OF_TIMES, _LAST_DIGIT = 1e-13, 1e-15  # of the time of an event, [s] and relative


class EventWatch:
    """Looks for the first sign change of an event, at the steps and at places within them."""

    def __init__(self, event: Callable[[Snapshot], float], start: Snapshot) -> None:
        self._event = event
        self._before, self._from = 0.0, start  # last value that was not zero; the step in which it was found
        self._time = start.t
        self._see(start, start)

    def _see(self, s: Snapshot, step: Snapshot) -> bool:
        """Whether the event has changed its sign since it was last seen not to be zero."""
        value = self._value(s)
        if abs(value) <= WATCHED_ZERO:
            return False
        if self._before * value < 0.0:
            return True
        self._before, self._from, self._time = value, step, s.t
        return False

    def crossing(
        self,
        now: Snapshot,
        after: Snapshot,
        dense: Callable[[float], Array],
        at: Callable[[Snapshot, float], Snapshot],
    ) -> Snapshot | None:
        """The state at the first crossing between two steps. `at` follows the motion exactly from a state."""
        n = len(now.q)
        for part in (0.25, 0.5, 0.75, 1.0):
            t = now.t + part * (after.t - now.t)
            s = after if part == 1.0 else snapshot_of(now.reference, dense(t)[:n], dense(t)[n:], t, now)
            if self._see(s, now):
                return self._root(s.t, at)
        return None

    def _root(self, late: float, at: Callable[[Snapshot, float], Snapshot]) -> Snapshot:
        def value(t: float) -> float:
            return self._value(at(self._from, t))

        early = self._time
        if value(early) * value(late) > 0.0:
            # rounding took the sign of one end: that end is the root
            return at(self._from, early if abs(value(early)) < abs(value(late)) else late)
        return at(self._from, zero_between(value, early, late, xtol=_OF_TIMES, rtol=_LAST_DIGIT))

    def _value(self, s: Snapshot) -> float:
        with named("the event"):
            return finite(self._event(s))
