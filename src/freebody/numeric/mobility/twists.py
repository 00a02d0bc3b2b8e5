"""Motions of single bodies in space: twists, and the screws along which they go.

A twist is the angular velocity w and the velocity u of the point of the body that is at the origin, along the axes of
the ground. With w not zero it is a turn about the line

    r = (w x u)/|w|^2 + s w/|w|      with the pitch      h = w . u/|w|^2,

a travel of h for every radian; with w = 0 it is a translation along u.
Source: Ball, A Treatise on the Theory of Screws, 1900, ch. I; Davidson & Hunt, Robots and Screw Theory, 2004, ch. 3.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from freebody.model.elements import ConstraintRow
from freebody.numeric.jets import Array
from freebody.numeric.mobility.rank import gradients
from freebody.numeric.reference import Reference
from freebody.numeric.rotation import matrix
from freebody.numeric.split import Split
from freebody.tolerances import LEAST, SAME_PLACE


@dataclass(frozen=True)
class ScrewLine:
    """A line with a direction and a pitch [m/rad]; without a pitch a translation along the direction."""

    direction: Array
    point: Array
    pitch: float | None

    @classmethod
    def of(cls, twist: Array, size: float) -> ScrewLine:
        """The screw of a twist (6,); size: of the system [m]."""
        w, u = twist[:3], twist[3:]
        spin = float(np.linalg.norm(w))
        if spin * size <= SAME_PLACE * float(np.linalg.norm(u)):
            return cls(u / np.linalg.norm(u), np.zeros(3), None)
        pitch = float(w @ u) / spin**2
        return cls(w / spin, np.cross(w, u) / spin**2, 0.0 if abs(pitch) <= SAME_PLACE * size else pitch)

    def passes(self, place: Array, size: float) -> bool:
        """Whether the line goes through a place."""
        return float(np.linalg.norm(np.cross(self.direction, place - self.point))) <= SAME_PLACE * max(size, LEAST)

    def step(self, center: Array, R: Array, amount: float, principal: Array) -> Array:
        """The step (6,) of a body's coordinates that takes it along the screw: by an angle, or by a length."""
        if self.pitch is None:
            return np.concatenate([amount * self.direction, np.zeros(3)])
        turn = amount * self.direction
        arm = center - self.point
        shift = matrix(turn) @ arm - arm + self.pitch * amount * self.direction
        return np.concatenate([shift, (R @ principal).T @ turn])


@dataclass(frozen=True)
class TwistSpace:
    """The motions that some rows leave a body while all others stand still."""

    twists: Array  # (n, 6), orthonormal by the size of the system
    size: float

    @property
    def n(self) -> int:
        return len(self.twists)

    @cached_property
    def screw(self) -> ScrewLine | None:
        """The screw of the only motion."""
        return ScrewLine.of(self.twists[0], self.size) if self.n == 1 else None

    @cached_property
    def axis(self) -> Array | None:
        """The direction about which alone the body can turn."""
        if not self.n:
            return None
        _U, S, Vt = np.linalg.svd(self.twists[:, :3])
        cut = SAME_PLACE * max(1.0, float(S[0]))
        is_one = S[0] > 1e-6 and (len(S) < 2 or S[1] <= cut)
        return np.asarray(Vt[0], np.float64) if is_one else None

    @cached_property
    def line(self) -> ScrewLine | None:
        """The line about which alone the body can turn; it may travel along it."""
        axis = self.axis
        if axis is None:
            return None
        across = np.eye(3) - np.outer(axis, axis)
        spins = self.twists[:, :3] @ axis
        k = int(np.abs(spins).argmax())
        others = self.twists - np.outer(spins / spins[k], self.twists[k])  # those that do not turn
        if float(np.abs(others[:, 3:] @ across).max()) > SAME_PLACE * self.size:
            return None
        return ScrewLine(axis, np.cross(self.twists[k, :3], self.twists[k, 3:]) / spins[k] ** 2, 0.0)

    @cached_property
    def center(self) -> Array | None:
        """The point that stays where it is in all motions, if there is one alone: u + w x r = 0 for every twist."""
        if self.n < 2:
            return None
        A = np.vstack([_cross_matrix(w) for w in self.twists[:, :3]])
        b = -self.twists[:, 3:].ravel()
        r, _rest, rank, _S = np.linalg.lstsq(A, b, rcond=SAME_PLACE)
        gap = float(np.abs(A @ r - b).max())
        return np.asarray(r, np.float64) if rank == 3 and gap <= SAME_PLACE * self.size else None


def freedom(reference: Reference, q: Array, body: str, rows: Sequence[ConstraintRow], t: float = 0.0) -> TwistSpace:
    """What rows leave a body of space."""
    columns = list(reference.columns(body))
    moves = reference.sizes.unit_moves[columns]
    null = Split(gradients(reference, q, rows, t)[:, columns], moves).null
    found = [twist_of(reference, q, body, v) for v in null.T]
    size = reference.sizes.length
    if not found:
        return TwistSpace(np.zeros((0, 6)), size)
    scale = np.array([1.0, 1.0, 1.0, 1.0 / size, 1.0 / size, 1.0 / size])
    basis = np.linalg.qr((np.array(found) * scale).T)[0].T
    return TwistSpace(basis / scale, size)


def twist_of(reference: Reference, q: Array, body: str, speeds: Array) -> Array:
    """(6,) the twist of a body with its own speeds, those of its columns."""
    center, _R = reference.frame_of(q, body)
    own = list(reference.columns(body)[3:])
    w = matrix(q[own]) @ speeds[3:] if own else np.zeros(3)
    return np.concatenate([w, speeds[:3] + np.cross(center, w)])


def _cross_matrix(w: Array) -> Array:
    """The matrix with  A r = w x r."""
    x, y, z = w
    return np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])
