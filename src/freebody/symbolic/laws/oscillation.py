"""q'' = -w^2 (q - c):   q = c + x0 cos(w t) + (u0/w) sin(w t),   x0 = q0 - c."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Self

from freebody.symbolic.laws.base import Farthest, Freely, Instants, LawInstant, Limit, MotionLaw
from freebody.symbolic.laws.turns import wave_turns
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.signs import Sign


@dataclass(frozen=True)
class Oscillation(MotionLaw):
    """Harmonic about a centre."""

    key = "harmonic"

    center: Ratio
    square: Ratio  # of the angular frequency

    @classmethod
    def of(cls, moving: Freely) -> Self | None:
        if moving.steady is None:
            return None
        alpha, beta, gamma = moving.steady
        if not gamma.is_zero() or moving.sign(beta) is not Sign.NEGATIVE:
            return None
        return cls(moving.model, moving.q0, moving.u0, moving.field.lowest_terms(-alpha / beta), -beta)

    @property
    def first_acceleration(self) -> Ratio:
        return self.q0 - self.center

    @property
    def w(self) -> Ratio:
        return self.root(self.square)

    def at(self, t: Ratio) -> tuple[Ratio, Ratio]:
        w = self.w
        c, s = self.function("cos", w * t), self.function("sin", w * t)
        x0 = self.q0 - self.center
        return self.center + x0 * c + self.u0 / w * s, self.u0 * c - x0 * w * s

    def places(self, value: Ratio) -> Instants:
        w = self.w
        waves, needs = wave_turns(self, self.q0 - self.center, self.u0 / w, value - self.center)
        return [LawInstant(tau / w, value, w * slope, key, self.period) for tau, slope, key in waves], needs

    def rates(self, value: Ratio) -> Instants:
        # u is a wave as well: u0 cos(tau) - w x0 sin(tau), and du/dtau = -w (q - c)
        w = self.w
        waves, needs = wave_turns(self, self.u0, -w * (self.q0 - self.center), value)
        found = [LawInstant(tau / w, self.center - slope / w, value, key, self.period) for tau, slope, key in waves]
        return found, needs

    def extent(self, side: int) -> Farthest:
        # it reaches c - A and c + A, and A^2 = x0^2 + (u0/w)^2
        x0 = self.q0 - self.center
        if self.u0.is_zero() or x0.is_zero():
            size = x0 if self.u0.is_zero() else self.u0 / self.w
            way, needs = self.side_of(size)
            return Farthest(self.center + side * way * size, needs)
        return Farthest(self.center + side * self.root(x0 * x0 + self.u0 * self.u0 / self.square))

    @property
    def period(self) -> Ratio:
        return 2 * self.model.field.pi / self.w

    @property
    def half_period(self) -> Ratio:
        return self.model.field.pi / self.w

    def turned_after(self, begin: LawInstant, n: int) -> Ratio:
        return 2 * self.center - begin.place if n % 2 else begin.place

    @property
    def unit_of_time(self) -> Ratio:
        return 1 / self.w

    @property
    def limit(self) -> Limit | None:
        return Limit(self.q0, self.u0, self.u0.field.one) if self.is_still else None
