"""q'' = n (D'/D) q' with D a function of the time:   q' = u0 (D/D0)^n,   q = q0 + int q' dt.

So moves what keeps its momentum while its inertia D is changed from inside (n = -1): a skater who pulls in the arms.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Self

from freebody.symbolic.antiderivative import antiderivative
from freebody.symbolic.functions import functions
from freebody.symbolic.laws.base import Freely
from freebody.symbolic.laws.in_time import InTime
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.signs import Sign


@dataclass(frozen=True)
class Spun(InTime):
    """size: D/D0, as a function of the time. The rate grows without bound where a divisor D comes to zero, and what is
    told ends there."""

    key = "spun"

    size: Ratio

    @classmethod
    def of(cls, moving: Freely) -> Self | None:
        f, c, a = moving.field, moving.coordinate, moving.acceleration
        clock = f.index(f.time)
        if not moving.is_alone or clock not in f.ingredients(a) or c.speed in a.denominator().generators():
            return None
        share = f.lowest_terms(a / f.variable(c.speed))
        if f.ingredients(share) & {c.index, c.speed}:
            return None
        D = share.denominator()
        grows = f.derivative(D, clock)
        n = f.lowest_terms(share * D / grows) if not grows.is_zero() else f.zero
        power = next((k for k in (-2, -1, 1, 2) if (n - k).is_zero()), 0)
        if not power:
            return None
        D0 = f.follow(D, {clock: f.zero})
        rate = f.lowest_terms(moving.u0 * (D / D0) ** power)
        whole = antiderivative(rate, clock) or _of_inverse_square(moving, rate)
        if whole is None:
            return None
        way = whole - f.follow(whole, {clock: f.zero}) - moving.u0 * f.time
        return cls(moving.model, moving.q0, moving.u0, f.lowest_terms(rate - moving.u0), f.lowest_terms(way), D / D0)

    @property
    def is_still(self) -> bool:
        return self.u0.is_zero()

    def at(self, t: Ratio) -> tuple[Ratio, Ratio]:
        f, clock = self.model.field, self.model.field.index(self.model.field.time)
        if clock not in f.ingredients(t) and self.gained.den is not None:
            self.is_negative(f.lowest_terms(f.follow(self.size, {clock: t})))
        return super().at(t)


def _of_inverse_square(moving: Freely, x: Ratio) -> Ratio | None:
    """int k/(a + b t + c t^2) dt = 2 k/s atan((b + 2 c t)/s) with s^2 = 4 a c - b^2 > 0."""
    f, clock = moving.field, moving.field.index(moving.field.time)
    parts = x.denominator().coefficients(clock)
    if clock in f.ingredients(x.numerator()) or len(parts) != 3 or any(clock in f.ingredients(p) for p in parts):
        return None
    a, b, c = parts
    square = f.lowest_terms(4 * a * c - b * b)
    if moving.sign(square) is not Sign.POSITIVE:
        return None
    s = f.sqrt(square, moving.model.samples.is_negative)
    arc = functions(f, moving.model.samples.is_negative)["atan"]((b + 2 * c * f.time) / s)
    whole = f.lowest_terms(2 * x.numerator() / s * arc)
    return whole if (f.derivative(whole, clock) - x).is_zero() else None
