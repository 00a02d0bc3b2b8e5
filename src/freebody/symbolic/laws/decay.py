"""q'' = g (u - u1):   u = u1 + (u0 - u1) exp(g t),   q = q0 + u1 t + (u0 - u1) (exp(g t) - 1)/g.

When it is at a value, with a = u0/u1 - 1 and p = g (value - q0)/u1 + a: g t + a exp(g t) = p, and so for w = p - g t

    w e^w = a e^p,        g t = p - w,        u = u1 (1 + w).

So w is a branch of Lambert's function: W_0 (w > -1) while it moves the way of u1, W_-1 (w < -1) while it still moves
against it. Source: Corless et al., On the Lambert W function, Adv. Comput. Math. 5, 1996, sec. 2; Warburton & Wang,
Analysis of asymptotic projectile motion with air resistance using the Lambert W function, Am. J. Phys. 72, 2004, 1404.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Self

from freebody.symbolic.laws.base import SETTLED, Farthest, Freely, Instants, LawInstant, Limit, MotionLaw
from freebody.symbolic.ratio import Ratio
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
        if not self.end.is_zero():
            return self._on_the_way(value)
        if self.u0.is_zero():
            return None
        grown = 1 + self.gamma * (value - self.q0) / self.u0
        return [
            LawInstant(self.function("log", grown) / self.gamma, value, self.u0 * grown, (value - self.q0) / self.u0)
        ], [(grown, ">")]

    def _on_the_way(self, value: Ratio) -> Instants:
        """Where the rate tends to an end: once after the start if it moves the way of its end, and twice if it first
        moves against it and the place is not beyond the turn."""
        if not self.is_negative(self.gamma):
            return None
        f = self.model.field
        way = f.lowest_terms((value - self.q0) / self.end)  # of the sign of how far it is the way of the end
        start = LawInstant(f.zero, value, self.u0, f.zero)
        against, needs = self.side_of(-self.u0 / self.end) if not self.u0.is_zero() else (-1, ())
        if against < 0:
            return [start if way.is_zero() else self._by_branch("lambert_W0", value, way)], [*needs]
        back = self._by_branch("lambert_W0", value, None)
        if sign_of(way) is Sign.POSITIVE:
            return [back], [*needs]
        if way.is_zero():
            return [start, back], [*needs]
        (turn,), _needs = self.rates(f.zero) or ([], [])
        below = f.lowest_terms(turn.place - value)
        to_turn = (below if self.is_negative(self.end) else -below, ">=")
        return [self._by_branch("lambert_Wm1", value, -way), back], [*needs, to_turn]

    def _by_branch(self, name: str, value: Ratio, key: Ratio | None) -> LawInstant:
        f = self.model.field
        a = f.lowest_terms(self.u0 / self.end - 1)
        p = f.lowest_terms(self.gamma * (value - self.q0) / self.end + a)
        w = self.function(name, f.lowest_terms(a * self.function("exp", p)))
        return LawInstant(f.lowest_terms((p - w) / self.gamma), value, f.lowest_terms(self.end * (1 + w)), key)

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
