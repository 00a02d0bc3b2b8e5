"""Motions in space in which one body moves alone, in words: "turns about the line from b to c"."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import combinations

import numpy as np

from freebody.errors import CannotAnswer
from freebody.language.sentences import Message
from freebody.model.curves import FOOT
from freebody.model.elements import ConstraintRow
from freebody.numeric.jets import Array
from freebody.numeric.mobility.twists import ScrewLine, TwistSpace, freedom
from freebody.numeric.reference import Reference
from freebody.tolerances import SAME_PLACE

AMOUNTS = (0.1, 0.7)  # by which a body is moved to see whether it stays free [rad], or parts of the size


@dataclass(frozen=True)
class AloneInSpace:
    """One body of space, while all others stand still."""

    reference: Reference
    q: Array
    t: float
    body: str
    rows: Sequence[ConstraintRow]

    def motions(self) -> Iterator[str]:
        """Its finite motions, in words: first turns about lines of its joints."""
        left = self._freedom.twists
        for screw in self._candidates:
            if not len(left):
                return
            rest = _without(left, self._twist(screw))
            if len(rest) < len(left) and self._goes_on(screw):
                left = rest
                yield self._words(screw)
        for twist in left:
            screw = ScrewLine.of(twist, self.size)
            if self._goes_on(screw):
                yield self._words(screw)

    @property
    def size(self) -> float:
        return self.reference.sizes.length

    @cached_property
    def _freedom(self) -> TwistSpace:
        return freedom(self.reference, self.q, self.body, self.rows, self.t)

    @cached_property
    def _own(self) -> dict[str, TwistSpace]:
        """What every connection alone leaves the body."""
        by_name: dict[str, list[ConstraintRow]] = {}
        for row in self.rows:
            by_name.setdefault(row.connection, []).append(row)
        return {name: freedom(self.reference, self.q, self.body, rows, self.t) for name, rows in by_name.items()}

    @cached_property
    def _centers(self) -> dict[str, Array]:
        return {name: free.center for name, free in self._own.items() if free.center is not None}

    @cached_property
    def _lines(self) -> dict[str, ScrewLine]:
        found = {name: free.screw for name, free in self._own.items()}
        return {name: screw for name, screw in found.items() if screw is not None}

    @property
    def _candidates(self) -> Iterator[ScrewLine]:
        """Lines through the centres of two joints, and axes."""
        for a, b in combinations(self._centers.values(), 2):
            along = b - a
            length = float(np.linalg.norm(along))
            if length > SAME_PLACE * self.size:
                yield ScrewLine(along / length, a, 0.0)
        yield from self._lines.values()

    def _twist(self, screw: ScrewLine) -> Array:
        if screw.pitch is None:
            return np.concatenate([np.zeros(3), screw.direction])
        return np.concatenate([screw.direction, np.cross(screw.point, screw.direction) + screw.pitch * screw.direction])

    def _goes_on(self, screw: ScrewLine) -> bool:
        """Whether finite motions along the screw keep everything, and leave the body as free as here."""
        gaps, n_free = self._gaps(self.q), self._freedom.n
        for amount in AMOUNTS:
            try:
                there = self._moved(screw, amount if screw.pitch is not None else amount * self.size)
                change = float(np.abs(self._gaps(there) - gaps).max(initial=0.0))
                is_free = freedom(self.reference, there, self.body, self.rows, self.t).n >= n_free
            except CannotAnswer:
                return False
            if change > SAME_PLACE * max(1.0, self.size) or not is_free:
                return False
        return True

    def _moved(self, screw: ScrewLine, amount: float) -> Array:
        frame, columns = self.reference.frame, list(self.reference.columns(self.body))
        step = np.zeros_like(self.q)
        own = screw.step(*self.reference.frame_of(self.q, self.body), amount, frame.principal[self.body])
        step[columns] = own[: len(columns)]
        return frame.moved(self.q, step)

    def _gaps(self, q: Array) -> Array:
        g = self.reference.geometry(q, np.zeros_like(q), self.t)
        return np.array([self.reference.gap(row, g).value for row in self.rows])

    # -- words --------------------------------------------------------------------------------
    def _words(self, screw: ScrewLine) -> str:
        if screw.pitch is None:
            return Message("slides along {direction}", direction=_numbers(screw.direction))
        told = {name: center for name, center in self._centers.items() if not name.startswith(FOOT)}
        on = [name for name, center in told.items() if screw.passes(center, self.size)]
        if screw.pitch == 0.0 and len(on) > 1:
            return Message("turns about the line from {a} to {b}", a=on[0], b=on[1])
        alike = [name for name, line in self._lines.items() if _is_same(line, screw, self.size)]
        if screw.pitch == 0.0 and alike:
            return Message("turns about the axis of {joint}", joint=alike[0])
        point, direction = _numbers(screw.point), _numbers(screw.direction)
        if screw.pitch == 0.0:
            return Message("turns about the line through {point} m along {direction}", point=point, direction=direction)
        return Message(
            "moves {pitch:.6g} m a radian along and about the line through {point} m along {direction}",
            pitch=screw.pitch,
            point=point,
            direction=direction,
        )


def _is_same(a: ScrewLine, b: ScrewLine, size: float) -> bool:
    is_parallel = float(np.linalg.norm(np.cross(a.direction, b.direction))) <= SAME_PLACE
    return a.pitch is not None and is_parallel and b.passes(a.point, size)


def _without(twists: Array, taken: Array) -> Array:
    """The twists that are left beside one of them; all of them if it is none."""
    if float(np.linalg.norm(taken - twists.T @ np.linalg.lstsq(twists.T, taken, rcond=None)[0])) > 1e-6:
        return twists
    parts = np.linalg.lstsq(twists.T, taken, rcond=None)[0]
    rest = np.linalg.svd(parts[None, :])[2][1:]
    return np.asarray(rest @ twists, np.float64)


def _numbers(v: Array) -> str:
    return f"({', '.join(f'{0.0 if abs(c) <= SAME_PLACE else float(c):.6g}' for c in v)})"
