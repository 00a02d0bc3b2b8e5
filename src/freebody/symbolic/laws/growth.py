"""q'' = k^2 (q - c):   q = c + x0 cosh(k t) + (u0/k) sinh(k t),   x0 = q0 - c."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Self

from freebody.symbolic.laws.base import SETTLED, Freely, Instants, LawInstant, Limit, MotionLaw
from freebody.symbolic.laws.turns import growth_turns
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.signs import Sign


@dataclass(frozen=True)
class Growth(MotionLaw):
    """Away from a centre, or towards it for ever."""

    key = "growing"

    center: Ratio
    square: Ratio  # k^2

    @classmethod
    def of(cls, moving: Freely) -> Self | None:
        if moving.steady is None:
            return None
        alpha, beta, gamma = moving.steady
        if not gamma.is_zero() or moving.sign(beta) is not Sign.POSITIVE:
            return None
        return cls(moving.model, moving.q0, moving.u0, moving.field.lowest_terms(-alpha / beta), beta)

    @property
    def first_acceleration(self) -> Ratio:
        return self.q0 - self.center

    @property
    def k(self) -> Ratio:
        return self.root(self.square)

    def at(self, t: Ratio) -> tuple[Ratio, Ratio]:
        k = self.k
        c, s = self.function("cosh", k * t), self.function("sinh", k * t)
        x0 = self.q0 - self.center
        return self.center + x0 * c + self.u0 / k * s, self.u0 * c + x0 * k * s

    def places(self, value: Ratio) -> Instants:
        k = self.k
        found, needs = growth_turns(self, self.q0 - self.center, self.u0 / k, value - self.center)
        return [LawInstant(tau / k, value, k * slope, key) for tau, slope, key in found], needs

    def rates(self, value: Ratio) -> Instants:
        k = self.k
        found, needs = growth_turns(self, self.u0, k * (self.q0 - self.center), value)
        return [LawInstant(tau / k, self.center + slope / k, value, key) for tau, slope, key in found], needs

    @property
    def unit_of_time(self) -> Ratio:
        return 1 / self.k

    @property
    def limit(self) -> Limit | None:
        if not (self.u0 + self.k * (self.q0 - self.center)).is_zero():
            return None
        return Limit(self.center, self.u0.field.zero, SETTLED / self.k)
