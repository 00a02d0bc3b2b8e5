"""q'' = a:   q = q0 + u0 t + a t^2/2."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Self

from freebody.symbolic.laws.base import Farthest, Freely, Instants, LawInstant, Limit, MotionLaw
from freebody.symbolic.ratio import Ratio


@dataclass(frozen=True)
class UniformLaw(MotionLaw):
    """Constant acceleration."""

    key = "constant"

    a: Ratio

    @classmethod
    def of(cls, moving: Freely) -> Self | None:
        a = moving.acceleration
        return cls(moving.model, moving.q0, moving.u0, a) if a.is_constant() else None

    @property
    def first_acceleration(self) -> Ratio:
        return self.a

    def at(self, t: Ratio) -> tuple[Ratio, Ratio]:
        return self.q0 + self.u0 * t + self.a * t * t / 2, self.u0 + self.a * t

    # the instants of its places are told apart where they are asked for (`motion.py`)

    def rates(self, value: Ratio) -> Instants:
        if self.a.is_zero():
            return [], []
        t = (value - self.u0) / self.a
        return [LawInstant(t, self.at(t)[0], value, t)], []

    def extent(self, side: int) -> Farthest:
        drive = self.u0 if self.a.is_zero() else self.a
        way, needs = self.side_of(drive)
        if way == side:
            return Farthest(None, needs, is_boundless=True)
        if self.u0.is_zero() or self.a.is_zero():  # it leaves at once on the other side
            return Farthest(self.q0, needs)
        sense, more = self.side_of(self.u0)
        turn = self.q0 - self.u0 * self.u0 / (2 * self.a)
        return Farthest(turn if sense == side else self.q0, (*needs, *more))

    @property
    def limit(self) -> Limit | None:
        if not self.a.is_zero():
            return None
        return Limit(self.q0 if self.u0.is_zero() else None, self.u0, self.u0.field.one)
