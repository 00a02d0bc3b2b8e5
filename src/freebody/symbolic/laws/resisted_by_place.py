"""A resistance that is proportional to the rate and to the place: u' = (b + 2 c q) u, so that the rate is a polynomial
of the place,

    u = R(q) = u0 + b (q - q0) + c (q^2 - q0^2),          t = int dq/R(q).

With the zeros q1, q2 of R it goes from one towards the other: with r^2 = (R'/2)^2 - c R and the middle of the zeros,

    -c (q - middle)/r = tanh(r t + ...).

Source: Meriam & Kraige, Dynamics, sec. 2/2 (acceleration given as a function of place and velocity).
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Self

from freebody.symbolic.laws.base import SETTLED, Freely, Instants, LawInstant, Limit, MotionLaw, Need
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.signs import Sign


@dataclass(frozen=True)
class ResistedByPlace(MotionLaw):
    """Where c u0 < 0: there are real zeros on both sides, and it slows down towards one of them."""

    key = "resisted_by_place"

    b: Ratio
    c: Ratio

    @classmethod
    def of(cls, moving: Freely) -> Self | None:
        f, k = moving.field, moving.coordinate
        if not moving.is_alone or moving.u0.is_zero() or k.speed not in moving.acceleration.generators():
            return None
        a = f.lowest_terms(moving.acceleration / f.variable(k.speed))
        if {k.speed, f.index(f.time)} & f.ingredients(a) or k.index in f.ingredients(a.denominator()):
            return None
        parts = a.coefficients(k.index)
        if len(parts) != 2 or not all(x.is_constant() for x in parts):
            return None
        # R has two real zeros on both sides of the place where c u0 < 0
        if moving.sign(f.lowest_terms(parts[1] * moving.u0)) is not Sign.NEGATIVE:
            return None
        return cls(moving.model, moving.q0, moving.u0, parts[0], f.lowest_terms(parts[1] / 2))

    @property
    def first_acceleration(self) -> Ratio:
        return self.b + 2 * self.c * self.q0

    def _rate(self, q: Ratio) -> Ratio:
        return self.u0 + self.b * (q - self.q0) + self.c * (q * q - self.q0 * self.q0)

    @property
    def middle(self) -> Ratio:
        return self.model.field.lowest_terms(-self.b / (2 * self.c))

    @property
    def r(self) -> Ratio:
        """r^2 = (b/2)^2 - c (u0 - b q0 - c q0^2), positive."""
        f, half = self.model.field, self.b / 2
        return self.root(f.lowest_terms(half * half - self.c * (self.u0 - self.b * self.q0 - self.c * self.q0**2)))

    def _tangent(self, q: Ratio) -> Ratio:
        """tanh of what grows with the time: -c (q - middle)/r."""
        return self.model.field.lowest_terms(-self.c * (q - self.middle) / self.r)

    def at(self, t: Ratio) -> tuple[Ratio, Ratio]:
        f, begin = self.model.field, self._tangent(self.q0)
        grown = self.function("tanh", self.r * t)
        tangent = (begin + grown) / (1 + begin * grown)
        q = f.lowest_terms(self.middle - self.r / self.c * tangent)
        return q, f.lowest_terms(-self.r * self.r / self.c * (1 - tangent * tangent))

    def places(self, value: Ratio) -> Instants:
        f = self.model.field
        first, then = (self._tangent(q) for q in (self.q0, value))
        ratio = f.lowest_terms((1 + then) * (1 - first) / ((1 - then) * (1 + first)))
        time = self.function("log", ratio) / (2 * self.r)
        rate = f.lowest_terms(self._rate(value))
        needs: list[Need] = [(f.lowest_terms(rate * self.u0), ">")]
        return [LawInstant(time, value, rate, f.lowest_terms((value - self.q0) * self.u0))], needs

    def rates(self, value: Ratio) -> Instants:
        """R(q) = value, behind the start on the way."""
        f = self.model.field
        if value.is_zero():
            return [], []
        square = f.lowest_terms(self.r * self.r + self.c * value)
        root = self.root(square)
        found: list[LawInstant] = []
        for sign in (1, -1):
            place = f.lowest_terms(self.middle + sign * root / self.c)
            instants = self.places(place)
            assert instants is not None
            found += [LawInstant(i.time, i.place, value, i.key) for i in instants[0]]
        return found, [(square, ">"), (f.lowest_terms(value * self.u0), ">")]

    @property
    def limit(self) -> Limit | None:
        f = self.model.field
        return Limit(f.lowest_terms(self.middle - self.r / self.c), f.zero, SETTLED / self.r)

    @property
    def unit_of_time(self) -> Ratio:
        return 1 / self.r
