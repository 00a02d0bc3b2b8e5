"""Poses over jets of bodies that move and turn: a place or a direction that is fixed in the body has its jet at once.

In the plane the turned vector has a single entry in its gradient, a quarter turn on. In space, with R the axes of the
body, S_k the derivatives of R by its angular velocity, and the rates and biases of R (`spatial.axis_jets`),

    R o has the gradient entries S_k o, the rate R' o and the bias R'' o.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from freebody.measures.geometry import Pose, SpatialPose, Vector
from freebody.numeric.jets import LARGE, Array, Gradient, GradientEntries, Jet


class TurningPose(Pose[Jet]):
    """The pose of a body that moves and turns, whose rows are arrays: x, y and the angle are three coordinates after
    each other."""

    def place(self, v: Vector[Jet]) -> Vector[Jet]:
        """What the sum of the pose and the turned vector comes to, for one that is fixed in the body: its gradient has
        a single entry more than that of the mass centre, the turned vector a quarter turn on."""
        if not (v.x.is_constant and v.y.is_constant):
            return super().place(v)
        a, b, cos, sin = v.x.value, v.y.value, self.cos, self.sin
        along, left = a * cos.value - b * sin.value, a * sin.value + b * cos.value
        turning = int(self.angle.gradient.argmax())
        x, y = self.x.gradient.copy(), self.y.gradient.copy()
        x[turning], y[turning] = -left, along
        return Vector(
            Jet(
                self.x.value + along,
                x,
                self.x.rate + (a * cos.rate - b * sin.rate),
                self.x.bias + (a * cos.bias - b * sin.bias),
            ),
            Jet(
                self.y.value + left,
                y,
                self.y.rate + (a * sin.rate + b * cos.rate),
                self.y.bias + (a * sin.bias + b * cos.bias),
            ),
        )


class TurningSpatialPose(SpatialPose[Jet]):
    """The pose of a body that moves and turns in space.

    own: where its angular velocity stands among n coordinates; jets: of its axes by vector and component, the values
    (3, 3), gradients (3, 3, 3), rates (3, 3) and biases (3, 3)."""

    def __init__(self, center: Vector[Jet], own: list[int], n: int, jets: tuple[Array, Array, Array, Array]) -> None:
        self.center = center
        self._own, self._n = own, n
        self._value, slopes, self._rate, self._bias = jets
        self._slopes = slopes.reshape(3, 9)  # a row for every axis
        self._moves = bool(self._rate.any() or self._bias.any())
        self._axes: tuple[Vector[Jet], Vector[Jet], Vector[Jet]] | None = None

    @property
    def axes(self) -> tuple[Vector[Jet], Vector[Jet], Vector[Jet]]:  # type: ignore[override]
        """Made when they are asked for."""
        if self._axes is None:
            x, y, z = (self._fixed(row) for row in np.eye(3))
            self._axes = x, y, z
        return self._axes

    def turn(self, v: Vector[Jet]) -> Vector[Jet]:
        z = 0.0 if v.z is None else v.z.value
        if v.x.is_constant and v.y.is_constant and (v.z is None or v.z.is_constant):
            return self._fixed(np.array([v.x.value, v.y.value, z]))
        return super().turn(v)

    def _fixed(self, components: Array) -> Vector[Jet]:
        """A vector that is fixed in the body."""
        value, slopes = (components @ self._value).tolist(), (components @ self._slopes).reshape(3, 3)
        if self._n > LARGE:
            rows: Sequence[Gradient] = [entries_of(self._own, row, self._n) for row in slopes]
        else:
            full = np.zeros((3, self._n))
            full[:, self._own] = slopes
            rows = list(full)
        if not self._moves:
            return Vector(*map(Jet, value, rows))
        return Vector(*map(Jet, value, rows, (components @ self._rate).tolist(), (components @ self._bias).tolist()))


def entries_of(columns: Sequence[int], values: Array, n: int) -> Gradient:
    """A gradient of n entries with those of some coordinates."""
    if n > LARGE:
        return GradientEntries(dict(zip(columns, values.tolist(), strict=True)))
    row = np.zeros(n)
    row[list(columns)] = values
    return row
