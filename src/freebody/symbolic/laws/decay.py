"""q'' = g (u - u1):   u = u1 + (u0 - u1) exp(g t)."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Self

from freebody.symbolic.field import Ratio
from freebody.symbolic.laws.base import SETTLED, Farthest, Freely, Instants, LawInstant, Limit, MotionLaw
from freebody.symbolic.signs import Sign, sign_of


@dataclass(frozen=True)
class Decay(MotionLaw):
    """A resistance that is linear in the rate: u tends to `end`, or leaves it."""

    key = "decay"

    end: Ratio
    gamma: Ratio

    @classmethod
    def of(cls, moving: Freely) -> Self | None:
        if moving.steady is None:
            return None
        alpha, beta, gamma = moving.steady
        if gamma.is_zero() or not beta.is_zero():
            return None
        return cls(moving.model, moving.q0, moving.u0, moving.field.lowest_terms(-alpha / gamma), gamma)

    @property
    def first_acceleration(self) -> Ratio:
        return self.u0 - self.end

    def at(self, t: Ratio) -> tuple[Ratio, Ratio]:
        grown = self.function("exp", self.gamma * t)
        over = self.u0 - self.end
        return self.q0 + self.end * t + over * (grown - 1) / self.gamma, self.end + over * grown

    def places(self, value: Ratio) -> Instants:
        if not self.end.is_zero() or self.u0.is_zero():
            return None  # the time stands in a sum of itself and an exponential
        grown = 1 + self.gamma * (value - self.q0) / self.u0
        return [
            LawInstant(self.function("log", grown) / self.gamma, value, self.u0 * grown, (value - self.q0) / self.u0)
        ], [(grown, ">")]

    def rates(self, value: Ratio) -> Instants:
        grown = (self.end - value) / (self.end - self.u0)
        time = self.function("log", grown) / self.gamma
        place = self.q0 + (value - self.u0 + self.gamma * self.end * time) / self.gamma
        return [LawInstant(time, place, value, (grown - 1) / self.gamma)], [(grown, ">")]

    @property
    def unit_of_time(self) -> Ratio:
        return 1 / self.gamma

    def extent(self, side: int) -> Farthest | None:
        """Of what dies away; its rate goes from u0 to the end without a turn between."""
        first, last = (x if sign_of(x).is_strict or x.is_zero() else None for x in (self.u0, self.end))
        if first is None or last is None or sign_of(self.gamma) is not Sign.NEGATIVE:
            return None
        goes, ends = (side * ((s is Sign.POSITIVE) - (s is Sign.NEGATIVE)) for s in map(sign_of, (first, last)))
        if ends > 0:
            return Farthest(None, is_boundless=True)
        if goes > 0:
            return Farthest(None, is_limit=not ends)
        return Farthest(self.q0)

    @property
    def limit(self) -> Limit | None:
        if not self.is_negative(self.gamma):
            return None
        place = self.q0 - self.u0 / self.gamma if self.end.is_zero() else None
        return Limit(place, self.end, -SETTLED / self.gamma)
