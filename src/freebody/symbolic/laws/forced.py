"""q'' = alpha + beta q + gamma q' + sum of A cos(W t + f) + B sin(W t + f): the free motion and the forced one.

With p = C cos + D sin of each wave, comparing coefficients,

    P C - Q D = A,   Q C + P D = B,   P = -(W^2 + beta),  Q = gamma W,

and q - p moves freely from q0 - p(0) with u0 - p'(0). At resonance without damping, P = Q = 0, it is another law.
Source: Magnus, Popp & Sextro, Schwingungen, ch. 5.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Self

from freebody.symbolic.field import Ratio
from freebody.symbolic.laws.base import Freely, MotionLaw


@dataclass(frozen=True)
class Forced(MotionLaw):
    """Waves of the time drive what else swings, grows or decays by itself. forced: value and rate of the forced motion
    as functions of the time."""

    key = "forced"

    free: MotionLaw
    forced: tuple[Ratio, Ratio]
    first_acceleration_: Ratio

    @classmethod
    def of(cls, moving: Freely) -> Self | None:
        if moving.linear is None or moving.steady is not None:
            return None
        alpha, beta, gamma = moving.linear
        if beta.is_zero() and gamma.is_zero():
            return None
        f, clock = moving.field, moving.field.index(moving.field.time)
        value, rate, rest = f.zero, f.zero, alpha
        for cos, sin in f.pairs(f.ingredients(alpha)):
            W = f.partial(f.angles[cos], clock)
            a, b = f.partial(alpha, cos), f.partial(alpha, sin)
            if W.is_zero() or any(clock in f.ingredients(x) for x in (W, a, b)):
                continue
            c, s = f.variable(cos), f.variable(sin)
            P, Q = -(W * W + beta), gamma * W
            size = f.lowest_terms(P * P + Q * Q)
            if size.is_zero():
                return None
            C, D = (a * P + b * Q) / size, (b * P - a * Q) / size
            value, rate = value + C * c + D * s, rate + W * (D * c - C * s)
            rest = f.lowest_terms(rest - a * c - b * s)
        if not rest.is_constant() or clock in f.ingredients(rest):
            return None
        start = {clock: f.zero}
        q0, u0 = (f.lowest_terms(x - f.follow(p, start)) for x, p in ((moving.q0, value), (moving.u0, rate)))
        q, u = f.variable(moving.coordinate.index), f.variable(moving.coordinate.speed)
        alone = replace(moving, acceleration=f.lowest_terms(rest + beta * q + gamma * u), q0=q0, u0=u0)
        free = next((law for kind in MotionLaw.laws if (law := kind.of(alone)) is not None), None)
        if free is None or not free.has_course:
            return None
        first = f.lowest_terms(f.follow(alpha, start) + beta * moving.q0 + gamma * moving.u0)
        return cls(moving.model, moving.q0, moving.u0, free, (value, rate), first)

    @property
    def is_still(self) -> bool:
        return False

    @property
    def first_acceleration(self) -> Ratio:
        return self.first_acceleration_

    def at(self, t: Ratio) -> tuple[Ratio, Ratio]:
        f = self.model.field
        place, rate = self.free.at(t)
        forced = [f.follow(x, {f.index(f.time): t}) for x in self.forced]
        return place + forced[0], rate + forced[1]
