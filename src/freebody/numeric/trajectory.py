"""A motion along time: steps of order 8, each projected back on positions and velocities that hold what is held.

    (q, v)' = (v, a(q, v, t)) (in space q' follows v by the rate of rotation vectors);    after a step q moves to the
    nearest pose, and v loses J^+ (J v - target')

so that gaps do not drift. Rows that are independent at the start, if only by little, count as such on the way;
those that nearly depend on each other are not followed through singular poses.
Source: Hairer, Norsett & Wanner, Solving Ordinary Differential Equations I, 2nd ed. 1993, sec. II.5;
Hairer & Wanner, II, 2nd ed. 1996, sec. VII.2 (projection).
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np

from freebody.errors import CannotAnswer
from freebody.language.sentences import Message
from freebody.measures.base import Measure
from freebody.numeric.event import EventWatch
from freebody.numeric.instant import dynamics
from freebody.numeric.jets import Array
from freebody.numeric.snapshot import Snapshot, snapshot_of
from freebody.numeric.split import RANK_CUT, Split, stack
from freebody.numeric.system import NumericSystem

# The rank cut along a motion, which with it runs through singular poses: rows that nearly depend on each other
# there are not followed, because they would enlarge the error of a step by the inverse of this.
MOVING_CUT = 1e-3
_RTOL, _ATOL = 1e-11, 1e-12  # of a step, relative and [SI]
_SAME_TIME = 1e-14  # [s] and relative: what is left of the way is the rounding of its times
N_STEPS = 100_000


@dataclass(frozen=True)
class ReferenceTrajectory:
    """A motion: the states after every step, and the event at which it ended, if there was one."""

    reference: NumericSystem
    snapshots: tuple[Snapshot, ...]
    event_time: float | None = None
    event: Snapshot | None = None

    @property
    def times(self) -> Array:
        """(n_times,) [s]"""
        return np.array([s.t for s in self.snapshots])

    @property
    def q(self) -> Array:
        """(n_times, n_coordinates) [m, rad]"""
        return np.array([s.q for s in self.snapshots])

    @property
    def v(self) -> Array:
        """(n_times, n_coordinates) [m/s, rad/s]"""
        return np.array([s.v for s in self.snapshots])

    def values(self, measure: Measure) -> Array:
        """(n_times,) of one measure; angles go on beyond a turn."""
        found: list[float] = []
        near: Snapshot | None = None
        for s in self.snapshots:
            near = snapshot_of(self.reference, s.q, s.v, s.t, near)
            found.append(near.value(measure))
        return np.array(found)


def integrate(
    reference: NumericSystem, start: Snapshot, until: float, event: Callable[[Snapshot], float] | None = None
) -> ReferenceTrajectory:
    """The motion from a state to a time or an event; see `Reference.integrate`."""
    steps = _Steps(reference, start)
    now = steps.projected(start.q, start.v, start.t, start)
    snapshots, size = [now], None
    watch = None if event is None else EventWatch(event, now)
    while until - now.t > _SAME_TIME * max(1.0, abs(until)):
        if len(snapshots) > N_STEPS:
            raise CannotAnswer(
                Message("{n} steps reach only t = {t:.6g} s of {until:.6g} s", n=N_STEPS, t=now.t, until=until)
            )
        solver = steps.solver(now, until, size)
        after = steps.stepped(now, solver)
        if watch is not None:
            found = watch.crossing(now, after, solver.dense_output(), steps.followed)
            if found is not None:
                return ReferenceTrajectory(reference, (*snapshots, found), found.t, found)
        snapshots.append(after)
        now, size = after, float(solver.h_abs)
    if watch is not None:
        raise CannotAnswer(Message("the event does not happen until t = {until:.6g} s", until=until))
    return ReferenceTrajectory(reference, tuple(snapshots))


class _Steps:
    """What the steps of one motion have in common: what they hold, and which rows they follow."""

    def __init__(self, reference: NumericSystem, start: Snapshot) -> None:
        self._reference = reference
        self._equations = reference.held_where(start.q, start.t)
        split = reference.split_at(start.q, start.branches, start.t)
        self._cut = min(MOVING_CUT, max(RANK_CUT, 0.03 * split.smallest))

    def solver(self, of: Snapshot, end: float, first: float | None) -> Any:
        """A solver at a state; its first step is tried with the size `first`."""
        from scipy.integrate import DOP853

        reference, n = self._reference, len(of.q)

        def rhs(t: float, y: Array) -> Array:
            g = reference.geometry(y[:n], y[n:], t, of.branches)
            return np.concatenate(
                (reference.frame.slope(y[:n], y[n:]), dynamics(reference, g, self._cut).accelerations)
            )

        size = None if first is None else min(first, end - of.t)
        y = np.concatenate((of.q, of.v))
        solver: Any = DOP853(rhs, of.t, y, end, rtol=_RTOL, atol=_ATOL, first_step=size)
        return solver

    def stepped(self, of: Snapshot, solver: Any) -> Snapshot:
        """The state after one step of the solver."""
        message, n = solver.step(), len(of.q)
        if solver.status == "failed":
            raise CannotAnswer(
                Message("the motion cannot be followed beyond t = {t:.6g} s: {why}", t=of.t, why=message)
            )
        return self.projected(solver.y[:n], solver.y[n:], float(solver.t), of)

    def followed(self, of: Snapshot, end: float) -> Snapshot:
        """The state at a later time."""
        while of.t < end:
            of = self.stepped(of, self.solver(of, end, end - of.t))
        return of

    def projected(self, q: Array, v: Array, t: float, near: Snapshot) -> Snapshot:
        """The nearest state that holds what is held, and whose velocities do."""
        reference = self._reference
        fit = reference.placing.placed(q, self._equations, t, near.branches)
        g = reference.geometry(fit.q, v, t, fit.branches)
        gaps = [reference.gap(row, g) for row in reference.system.constraint_rows]
        J = stack([gap.row(len(q)) for gap in gaps], len(q))
        v = v - Split(J, reference.sizes.small_moves, self._cut).least(np.array([gap.rate for gap in gaps]))
        return Snapshot(reference, reference.geometry(fit.q, v, t, fit.branches), fit.q, v, t)
