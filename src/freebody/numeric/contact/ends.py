"""Flat ends that tip about their rims and fall back on them.

A flat end is its middle C, with the moment M of its pressure about C: the resultant P lies in the circle, |M| <= R P.
What it may do is the dual of that cone, v_n >= R |w| with w the angular velocity along the face: the point of the rim
that goes down, where w x m points from C, is not lower than the face. So an end tips at v_n = R |w|, about the point

    e = w x m/|w|,       m the outer normal of the face,                of the rim,

which a pivot holds from then on (`RimPivot`). Where the tilt has grown to `FLAT` the rim touches where it is lowest, at
e = -(n_1, n_2)/|n| along two directions of the body; where it falls back below that the pivot at this place holds again
until the middle of the end has come down, which is an impact of the flat end. Source: Housner, Bull. Seismol. Soc. Am.
53 (1963) 403-417, for blocks; Moreau 1988 for the cone and its dual.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Protocol

from freebody.model.elements import RimPivot

if TYPE_CHECKING:
    from freebody.numeric.contact.rows import ContactInstant, FrictionRow, UnilateralRow
    from freebody.numeric.engine.writing import ArrayBuilder
    from freebody.numeric.kernels.arrays import Floats
    from freebody.numeric.numbers import Numbers

Setting = tuple[float, float, float]  # c and s of the place of a pivot, and its height


class Held(Protocol):
    """What flat ends ask of the system that they are of."""

    numbers: Numbers
    written: ArrayBuilder
    barriers: list[UnilateralRow]
    drags: list[FrictionRow]

    def values(self) -> Floats:
        """(n_rows,) of all measures in the pose that was looked at last."""
        ...

    def is_valid(self, k: int) -> bool:
        """Whether a barrier counts in the pose that was looked at last."""
        ...


@dataclass(frozen=True)
class FlatEnd:
    """A flat end in numbers: barriers, the friction that is its moment, rows."""

    pivot: RimPivot
    flat: int
    rim: int
    edge: int  # the barrier of the pivot
    moment: int  # the drag that is |M| <= R P
    radius: float
    lowest: tuple[int, int]  # rows
    along: tuple[tuple[int, int], tuple[int, int]]


class FlatEnds:
    """Those of one system, and where their pivots are now."""

    def __init__(self, bounded: Held, pivots: Mapping[str, RimPivot]) -> None:
        """pivots: by the bound of the flat end."""
        self.bounded = bounded
        number = {barrier.name: k for k, barrier in enumerate(bounded.barriers)}
        tipping = {drag.of: k for k, drag in enumerate(bounded.drags) if drag.rub.is_tipping}
        rows = bounded.written.rows
        self.ends = [
            FlatEnd(
                pivot,
                number[name],
                number[pivot.rim],
                number[pivot.bound.name],
                tipping[number[name]],
                bounded.numbers.number(pivot.radius),
                (rows[pivot.lowest[0]], rows[pivot.lowest[1]]),
                (
                    (rows[pivot.along[0][0]], rows[pivot.along[0][1]]),
                    (rows[pivot.along[1][0]], rows[pivot.along[1][1]]),
                ),
            )
            for name, pivot in pivots.items()
        ]
        self.by_flat = {end.flat: end for end in self.ends}
        self.by_rim = {end.rim: end for end in self.ends}
        self.by_edge = {end.edge: end for end in self.ends}
        self.by_moment = {end.moment: end for end in self.ends}
        self.now: dict[int, Setting] = {}
        self.set([(edge, (1.0, 0.0, 0.0)) for edge in self.by_edge])
        # in results a pivot is the rim: of barriers, of friction and of rows those for which they stand
        self.stands_for = {end.edge: end.rim for end in self.ends}
        rubs = {drag.name: k for k, drag in enumerate(bounded.drags)}
        self.rubs_for: dict[int, int] = {}
        self.rows_for: dict[int, int] = {}
        for end in self.ends:
            edge, rim = bounded.barriers[end.edge], bounded.barriers[end.rim]
            self.rows_for[edge.place] = rim.place
            own = [drag for drag in bounded.drags if drag.of == end.rim]
            twins = sorted(own, key=lambda drag: drag.packed)
            for rub, twin in zip(end.pivot.dry_friction, twins, strict=True):
                drag = bounded.drags[rubs[rub.name]]
                self.rubs_for[rubs[rub.name]] = rubs[twin.name]
                self.rows_for[drag.keeps] = twin.keeps
                if drag.across >= 0:
                    self.rows_for[drag.keeps_across] = twin.keeps_across

    # -- rates --------------------------------------------------------------------------------
    def turning(self, end: FlatEnd, now: ContactInstant) -> float:
        """|w| [rad/s]."""
        drag = self.bounded.drags[end.moment]
        return math.hypot(float(now.rates[drag.keeps]), float(now.rates[drag.keeps_across]))

    def opening(self, k: int, now: ContactInstant) -> float:
        """The rate at which a gap opens: of a flat end that of the lowest point of its rim, v_n - R |w|."""
        barrier = self.bounded.barriers[k]
        rate = barrier.sign * float(now.rates[barrier.place])
        end = self.by_flat.get(k)
        return rate if end is None else rate - end.radius * self.turning(end, now)

    def is_level(self, k: int, now: ContactInstant, slow: float) -> bool:
        """Whether a flat end keeps its direction; slow: a velocity that is none."""
        end = self.by_flat[k]
        return end.radius * self.turning(end, now) <= slow

    def tips(self, k: int, now: ContactInstant, slow: float) -> bool:
        """Whether a flat end goes on about a point of its rim."""
        return k in self.by_flat and not self.is_level(k, now, slow) and abs(self.opening(k, now)) <= slow

    # -- pivots -------------------------------------------------------------------------------
    def settings(self, closed: Iterable[int]) -> tuple[tuple[int, Setting], ...]:
        """Of the pivots among closed barriers."""
        return tuple((k, self.now[k]) for k in sorted(closed) if k in self.now)

    def set(self, settings: Sequence[tuple[int, Setting]]) -> None:
        """Puts pivots where they were."""
        for k, setting in settings:
            self.now[k] = setting
            for measure, value in zip(self.by_edge[k].pivot.settings, setting, strict=True):
                self.bounded.written.put(measure, value)

    def put_against(self, end: FlatEnd, angle: float, now: ContactInstant) -> None:
        """At e = w x m/|w|, w at an angle from p to q."""
        p, q = math.sin(angle), -math.cos(angle)
        values = self.bounded.values()
        c, s = (end.pivot.sign * (p * float(values[one]) + q * float(values[other])) for one, other in end.along)
        self._put(end, c, s, now)

    def hardly_tilted(self, now: ContactInstant, size: float) -> list[int]:
        """Pivots for ends that stand on a point of their rim and are too flat to have a lowest one of their own, where
        a motion begins so; size: a gap that is none."""
        found: list[int] = []
        for end in self.ends:
            flat, tilt = self.bounded.barriers[end.flat], math.hypot(*self._lowest(end))
            height = flat.sign * float(now.values[flat.place])
            if self.bounded.is_valid(end.flat) and height > size and abs(height - end.radius * tilt) <= size:
                self.put_at_lowest(end, now)
                found.append(end.edge)
        return found

    def put_at_lowest(self, end: FlatEnd, now: ContactInstant) -> None:
        """Where the rim is lowest."""
        c, s = (-n for n in self._lowest(end))
        self._put(end, c, s, now)

    def _lowest(self, end: FlatEnd) -> tuple[float, float]:
        values = self.bounded.values()
        return float(values[end.lowest[0]]), float(values[end.lowest[1]])

    def _put(self, end: FlatEnd, c: float, s: float, now: ContactInstant) -> None:
        """A pivot is put in a direction from the middle of the end, and kept at the height at which it is there."""
        c, s = c / math.hypot(c, s), s / math.hypot(c, s)
        flat, (one, other) = self.bounded.barriers[end.flat], self._lowest(end)
        height = flat.sign * float(now.values[flat.place]) + end.radius * (c * one + s * other)
        self.set([(end.edge, (c, s, height))])
