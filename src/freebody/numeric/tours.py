"""Tours: a system at rest is led along one free coordinate, both ways, to see where its loads might balance.

The coordinate grows by even steps, the others stay, and everything held is held. A tour ends where it closes, where
nothing goes further, or after a full turn (as many sizes for a coordinate that does not turn). With one degree of
freedom it runs through the whole branch: where the load along the way changes sign, or is least, there may be a rest.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass, replace
from itertools import pairwise
from typing import TYPE_CHECKING

import numpy as np

from freebody.numeric.jets import Array
from freebody.numeric.small_motion import SmallCoordinate, coordinates
from freebody.numeric.split import stack
from freebody.tolerances import ROUND_OFF

if TYPE_CHECKING:
    from freebody.numeric.rest import CountedPose, LoadBalance, RestFinder

_STEP, _FINE_STEP = 0.25, 0.1  # in sizes or radians; the second with one degree of freedom
_N_HALVINGS = 40
_N_BEND = 1e4  # condition number at which coordinates are none any more


@dataclass(frozen=True)
class _TourPose:
    """One pose of a tour, and the load along the way there."""

    balance: LoadBalance
    along: float


def toured(statics: RestFinder, pose: CountedPose, k: int) -> Iterator[CountedPose]:
    """Poses along the k-th free coordinate from which to search for a rest."""
    first = statics.try_balance(pose)
    if first is None or k >= len(first.residual):
        return
    way = _CoordinateTour(statics, first, k)
    ahead = list(way.stops(1.0))
    behind = [] if way.has_closed else list(way.stops(-1.0))
    line = [_TourPose(stop.balance, -stop.along) for stop in reversed(behind[1:])] + ahead
    rests = [stop.balance.error <= ROUND_OFF * stop.balance.scale for stop in line]
    for i, here in enumerate(line):
        neighbours = [j for j in (i - 1, i + 1) if 0 <= j < len(line)]
        if rests[i]:
            if i == 0 or not rests[i - 1]:
                yield here.balance.pose
            continue
        errors = [line[j].balance.error for j in neighbours]
        turns = any(
            line[j].along * here.along <= 0.0 and here.balance.error <= line[j].balance.error for j in neighbours
        )
        if turns or (len(errors) == 2 and here.balance.error < (1.0 - 1e-6) * min(errors)):
            yield here.balance.pose
    if len(first.residual) == 1:
        for here, there in pairwise(line):
            narrowed = _narrowed(statics, here, there)
            if narrowed is not None:
                yield narrowed


def _narrowed(statics: RestFinder, here: _TourPose, there: _TourPose) -> CountedPose | None:
    """Between two poses from which the load drives to each other with all it can, as a motor at its limit does: by
    halves, one at which it is less and tells Newton's method where to go."""
    least = (1.0 - 1e-6) * min(here.balance.error, there.balance.error)
    if here.along * there.along >= 0.0 or max(here.balance.error, there.balance.error) * (1.0 - 1e-6) > least:
        return None
    for _ in range(_N_HALVINGS):
        way = statics.reference.frame.difference(there.balance.pose.q, here.balance.pose.q)
        middle = statics.try_balance(statics.moved(here.balance.pose, 0.5 * way))
        if middle is None:
            return None
        if middle.error < least:
            return middle.pose
        half = _TourPose(middle, float(middle.forces @ way))
        here, there = (half, there) if half.along * here.along > 0.0 else (here, half)
    return None


class _CoordinateTour:
    """The way along one coordinate from a pose."""

    def __init__(self, statics: RestFinder, first: LoadBalance, k: int) -> None:
        self._statics, self._first, self._k = statics, first, k
        self._single = len(first.residual) == 1
        self._marks: list[SmallCoordinate] = coordinates(
            statics.reference, statics.geometry(first.pose), first.split.null
        )
        self._passed: list[CountedPose] = []
        self.has_closed = False

    def stops(self, sense: float) -> Iterator[_TourPose]:
        """The poses in one sense, the first one included."""
        sizes = self._statics.reference.sizes
        size = _FINE_STEP if self._single else _STEP
        here, heading = self._first, sense * self._unit(self._first, self._first.split.null[:, self._k])
        for i in range(int(1.25 * math.tau / size)):
            length = float(sizes.relative(heading).max())
            if not 0.0 < length < math.inf:
                return  # beside such sizes this direction is lost in numbers
            heading = heading / length
            yield _TourPose(here, float(here.forces @ heading))
            self._passed.append(here.pose)
            there = self._next(here, size * heading)
            if there is None:
                return
            step = float(sizes.relative(self._move(here, there)).max())
            if i > 2 and self._is_back(there, step):
                self.has_closed = True
                yield _TourPose(there, float(there.forces @ heading))
                return
            D = sizes.small_moves
            carried = there.split.null @ (there.split.null.T @ (self._move(here, there) / D**2))
            if float(sizes.relative(carried).max(initial=0.0)) < 1e-3 * step:
                return
            heading = self._unit(there, carried) * (1.0 if self._single else sense)
            if float((heading / D) @ (carried / D)) < 0.0:
                heading = carried
            here = there

    def _move(self, here: LoadBalance, there: LoadBalance) -> Array:
        return self._statics.reference.frame.difference(there.pose.q, here.pose.q)

    def _is_back(self, there: LoadBalance, step: float) -> bool:
        """Whether a pose is about the first one again, and the loads do not count the turns on the way."""
        statics, first = self._statics, self._first
        if statics.apart(there.pose, first.pose) >= 0.6 * step:
            return False
        if statics.reference.system.space:
            return statics.is_same(there, first)
        whole = there.pose.q - statics.difference(there.pose, first.pose) - first.pose.q
        again = statics.try_balance(replace(first.pose, q=first.pose.q + whole))
        if again is None or not statics.is_same(again, first):
            return False
        # a load at its limit counts no turns here, and may do so on the turn behind, which is not gone then
        return all(statics.loads_same(pose, replace(pose, q=pose.q - whole)) for pose in self._passed)

    def _next(self, here: LoadBalance, step: Array) -> LoadBalance | None:
        for part in (1.0, 0.3, 0.1):
            there = self._statics.try_balance(self._statics.moved(here.pose, part * step))
            if there is not None and len(there.residual):
                return there
        return None

    def _unit(self, here: LoadBalance, carried: Array) -> Array:
        """The direction in which the coordinate grows and the others rest; where these are no coordinates any
        more, the direction carried along."""
        N, reference, n = here.split.null, self._statics.reference, len(here.pose.q)
        if N.shape[1] == 1 or N.shape[1] != len(self._marks):
            return carried
        g = self._statics.geometry(here.pose)
        T = stack([mark.jet(reference, g, np.zeros(n)).row(n) for mark in self._marks], n) @ N
        if np.linalg.cond(T) > _N_BEND:
            return carried
        return N @ np.linalg.inv(T)[:, self._k]
