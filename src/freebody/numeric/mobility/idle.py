"""Idle freedoms: what moves all alone."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from freebody.errors import CannotAnswer
from freebody.language.sentences import Message
from freebody.measures.displacement import Displacement
from freebody.measures.geometry import GROUND, RIGHT, UP, position, unit
from freebody.model.elements import ConstraintRow
from freebody.numeric.jet_geometry import JetGeometry
from freebody.numeric.jets import Array
from freebody.numeric.mobility.idle_in_space import AloneInSpace
from freebody.numeric.mobility.rank import gradients
from freebody.numeric.mobility.scene import joined, leaves, pinning
from freebody.numeric.reference import Reference
from freebody.numeric.split import Split
from freebody.tolerances import SAME_PLACE


def idle_motions(reference: Reference, q: Array, t: float = 0.0) -> dict[str, list[str]]:
    """Finite motions of one body in which nothing else moves, by body: "turns about its pin roller_pin".

    Only bodies that connections join to two others or more are asked about (fixed bodies and the ground are one): the
    last link of a chain moves alone, but what it does is the motion of the mechanism. Source: Norton, Design of
    Machinery, ch. 2 (idle or passive freedoms)."""
    found: dict[str, list[str]] = {}
    moving = reference.frame.columns
    for body in moving:
        rows = [row for row in reference.system.constraint_rows if body in set(row.measure.bodies())]
        if len({other if other in moving else GROUND for row in rows for other in joined(row)}) > 2:
            alone = AloneInSpace if reference.system.space else _Alone
            motions = [*alone(reference, q, t, body, rows).motions()]
            if motions:
                found[body] = motions
    return found


@dataclass(frozen=True)
class _Alone:
    """One body, while all others stand still."""

    reference: Reference
    q: Array
    t: float
    body: str
    rows: Sequence[ConstraintRow]

    @property
    def columns(self) -> list[int]:
        return list(self.reference.columns(self.body))

    def motions(self) -> Iterator[str]:
        """Its finite motions, in words."""
        moves = self.reference.sizes.unit_moves[self.columns]
        for v in self._null(self.q).T:
            v = v / float((np.abs(v) / moves).max())
            spin = float(v[2]) if len(v) == 3 else 0.0
            if abs(spin) < SAME_PLACE:
                along = v[:2] / float(np.linalg.norm(v[:2]))
                shifts = [part * self.reference.sizes.length * along for part in (0.05, 0.2)]
                if all(self._holds(0.0, shift) for shift in shifts):
                    yield self._sliding(along)
                continue
            x, y = self.q[self.columns[:2]]
            # the point of the body that stands still: v + spin x (r - r_O) = 0
            arm = np.array([v[1], -v[0]]) / spin
            center = np.array([x, y]) - arm
            if all(self._holds(angle, center + _rotated(arm, angle) - (x, y)) for angle in (0.1, 0.7)):
                yield self._turning(center)

    def _geometry(self, q: Array) -> JetGeometry:
        return self.reference.geometry(q, np.zeros_like(q), self.t)

    def _null(self, q: Array) -> Array:
        J = gradients(self.reference, q, self.rows, self.t)[:, self.columns]
        return Split(J, self.reference.sizes.unit_moves[self.columns]).null

    def _gaps(self, q: Array) -> Array:
        g = self._geometry(q)
        return np.array([self.reference.gap(row, g).value for row in self.rows])

    def _holds(self, angle: float, shift: Array) -> bool:
        """Whether it may be turned and shifted so, and is then as free as here."""
        there = self.q.copy()
        there[self.columns[:2]] += shift
        there[self.columns[2:]] += angle
        try:
            change = np.abs(self._gaps(there) - self._gaps(self.q))
            free = self._null(there).shape[1]
        except CannotAnswer:
            return False
        size = max(1.0, self.reference.sizes.length)
        return float(change.max(initial=0.0)) <= SAME_PLACE * size and free >= self._null(self.q).shape[1]

    def _turning(self, center: Array) -> str:
        g = self._geometry(self.q)
        for row in self.rows:
            m = pinning(row)
            if m is not None:
                place = position(g, m.of)
                away = math.hypot(place.x.value - center[0], place.y.value - center[1])
                if away <= SAME_PLACE * max(1.0, self.reference.sizes.length):
                    return Message("turns about its pin {pin}", pin=row.connection)
        x, y = (0.0 if abs(c) <= SAME_PLACE * self.reference.sizes.length else float(c) for c in center)
        return Message("turns about ({x:.6g}, {y:.6g}) m", x=x, y=y)

    def _sliding(self, along: Array) -> str:
        g = self._geometry(self.q)
        for row in self.rows:
            for m in leaves(row.measure):
                if isinstance(m, Displacement) and m.along not in (RIGHT, UP):
                    across = unit(g, m.along)
                    if abs(across.x.value * along[0] + across.y.value * along[1]) <= SAME_PLACE:
                        return Message("slides along the guide of {guide}", guide=row.connection)
        angle = math.degrees(math.atan2(along[1], along[0])) % 180.0
        return Message("slides at {angle:.6g} deg from the x axis", angle=angle)


def _rotated(u: Array, angle: float) -> Array:
    c, s = math.cos(angle), math.sin(angle)
    return np.array([c * u[0] - s * u[1], s * u[0] + c * u[1]])
