"""Coordinates x in which the poses of a mechanism are a smooth curve.

In the plane they are those of q by the sizes of the system. In space a body that turns has a unit quaternion
Q = (w, u) of its principal axes in place of a rotation vector, so that whole turns meet no singular pose; Q and -Q are
one pose. With

    omega = 2 (w du - dw u - u x du),    |Q|^2 = 1,

gradients by speeds become those by x, and every such body adds the row Q. dQ = 0.
Source: Shuster, J. Astronaut. Sci. 41 (1993) 439, sec. on kinematics.
"""

from __future__ import annotations

import math

import numpy as np

from freebody.numeric.jets import Array
from freebody.numeric.reference import Reference
from freebody.numeric.rotation import quaternion_of_vector


class Chart:
    """The coordinates of the plane: x = q by the sizes of the system."""

    def __init__(self, reference: Reference) -> None:
        self.D = reference.sizes.unit_moves
        self.turning = reference.sizes.turning

    @classmethod
    def of(cls, reference: Reference) -> Chart:
        return SpatialChart(reference) if reference.system.space else cls(reference)

    def x(self, q: Array, near: Array | None = None) -> Array:
        """Of a pose (n_q,), as near as it has a place near another one."""
        return q / self.D

    def q(self, x: Array) -> Array:
        """The pose (n_q,)."""
        return x * self.D

    def slopes(self, x: Array, rows: Array) -> Array:
        """(n, n_x) gradients by x, from those by speeds."""
        return rows * self.D

    def speeds(self, x: Array, v: Array) -> Array:
        """(n_q,) speeds of a velocity by x."""
        return v * self.D

    def own_rows(self, x: Array) -> tuple[Array, Array]:
        """What holds of x itself: gaps (n,) and gradients (n, n_x)."""
        return np.zeros(0), np.zeros((0, len(x)))

    def own_bias(self, v: Array) -> Array:
        """(n,) second derivatives of these gaps along a straight line."""
        return np.zeros(0)

    def again(self, x: Array, tangent: Array, near: Array) -> tuple[Array, Array]:
        """The same pose and tangent where they are nearest to another x: full turns further."""
        turns = np.where(self.turning, math.tau * np.round((near - x) / math.tau), 0.0)
        return x + turns, tangent


class SpatialChart(Chart):
    """The coordinates of space."""

    def __init__(self, reference: Reference) -> None:
        super().__init__(reference)
        self._length = reference.sizes.length
        self._at: list[tuple[list[int], list[int], slice]] = []  # of a body: places and turns in q, both in x
        n = 0
        for columns in reference.frame.columns.values():
            size = 7 if len(columns) == 6 else 3
            self._at.append((list(columns[:3]), list(columns[3:]), slice(n, n + size)))
            n += size
        self._n_x, self._n_q = n, len(self.D)
        self.turning = np.zeros(n, dtype=bool)
        for _places, _turns, part in self._at:
            self.turning[part.start + 3 : part.stop] = True

    def x(self, q: Array, near: Array | None = None) -> Array:
        found = np.zeros(self._n_x)
        for places, turns, part in self._at:
            found[part.start : part.start + 3] = q[places] / self._length
            if turns:
                found[part.start + 3 : part.stop] = quaternion_of_vector(q[turns])
        return found if near is None else self.again(found, found, near)[0]

    def q(self, x: Array) -> Array:
        found = np.zeros(self._n_q)
        for places, turns, part in self._at:
            found[places] = x[part][:3] * self._length
            if turns:
                w, u = x[part][3], x[part][4:]
                sine = float(np.linalg.norm(u))
                found[turns] = u * (2.0 * math.atan2(sine, w) / sine) if sine > 0.0 else 0.0
        return found

    def _matrix(self, x: Array) -> Array:
        """(n_q, n_x): speeds by the rates of x."""
        B = np.zeros((self._n_q, self._n_x))
        for places, turns, part in self._at:
            B[places, range(part.start, part.start + 3)] = self._length
            if turns:
                w, (a, b, c) = x[part][3], x[part][4:]
                rows = np.array([[-a, w, c, -b], [-b, -c, w, a], [-c, b, -a, w]])
                size = float(x[part][3:] @ x[part][3:])
                B[np.ix_(turns, range(part.start + 3, part.stop))] = 2.0 / size * rows
        return B

    def slopes(self, x: Array, rows: Array) -> Array:
        found: Array = rows @ self._matrix(x)
        return found

    def speeds(self, x: Array, v: Array) -> Array:
        found: Array = self._matrix(x) @ v
        return found

    @property
    def _quaternions(self) -> list[slice]:
        return [slice(part.start + 3, part.stop) for _places, turns, part in self._at if turns]

    def own_rows(self, x: Array) -> tuple[Array, Array]:
        parts = self._quaternions
        rows = np.zeros((len(parts), self._n_x))
        for row, part in zip(rows, parts, strict=True):
            row[part] = x[part]
        return np.array([0.5 * (float(x[part] @ x[part]) - 1.0) for part in parts]), rows

    def own_bias(self, v: Array) -> Array:
        return np.array([float(v[part] @ v[part]) for part in self._quaternions])

    def again(self, x: Array, tangent: Array, near: Array) -> tuple[Array, Array]:
        sign = np.ones(self._n_x)
        for part in self._quaternions:
            sign[part] = 1.0 if float(x[part] @ near[part]) >= 0.0 else -1.0
        return sign * x, sign * tangent
