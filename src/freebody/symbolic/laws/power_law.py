"""An acceleration that is a power of the rate: u' = b u^n, as long as u keeps its sign.

    u^(1 - n) = u0^(1 - n) + (1 - n) b t,          u^(2 - n) = u0^(2 - n) + (2 - n) b (q - q0)

For n = -1 it is the law of a constant power, for n = 3/2 or 3 a resistance of that power. n = 0, 1, 2 have laws of
their own. Source: Meriam & Kraige, Dynamics, sec. 2/2; Beer & Johnston, Dynamics, sec. 11.3 and 13.5 (power).
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from typing import Self

from freebody.symbolic.laws.base import Freely, Instants, LawInstant, Limit, MotionLaw, Need
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.signs import Sign

_HALVES = [Fraction(n, 2) for n in range(-4, 9) if n not in (0, 2, 4)]  # exponents
_LATE = 10**8  # units of time after which a power of the time counts as zero


@dataclass(frozen=True)
class PowerLaw(MotionLaw):
    """With the sense of the motion, in which u is counted positive: w = sense u, w' = b w^n."""

    key = "power_law"

    b: Ratio
    n: Fraction
    sense: int

    @classmethod
    def of(cls, moving: Freely) -> Self | None:
        f, c = moving.field, moving.coordinate
        if not moving.is_alone or moving.u0.is_zero() or c.speed not in f.ingredients(moving.acceleration):
            return None
        sense = {Sign.POSITIVE: 1, Sign.NEGATIVE: -1}.get(moving.sign(moving.u0), 0)
        if not sense or c.index in f.ingredients(moving.acceleration):
            return None
        w = f.parameter("@w")  # positive, as a parameter is
        a = f.lowest_terms(f.follow(sense * moving.acceleration, {c.speed: sense * w}))
        for n in _HALVES:
            b = _factor(moving, a, w, n)
            if b is not None:
                return cls(moving.model, moving.q0, moving.u0, b, n, sense)
        return None

    @property
    def first_acceleration(self) -> Ratio:
        return self.b

    @property
    def w0(self) -> Ratio:
        return self.sense * self.u0

    def _raised(self, x: Ratio, exponent: Fraction) -> Ratio:
        """x^exponent of what is positive."""
        if exponent.denominator == 1 or exponent.denominator == 2:
            power = x ** int(exponent) if exponent.denominator == 1 else self.root(x) ** int(2 * exponent)
            return self.model.field.lowest_terms(power)
        return self.function("exp", exponent.numerator * self.function("log", x) / exponent.denominator)

    def _at_speed(self, w: Ratio) -> tuple[Ratio, Ratio]:
        """Time and place at which the speed is w."""
        t, s = 1 - self.n, 2 - self.n
        f = self.model.field
        time = (self._raised(w, t) - self._raised(self.w0, t)) / (f.element(t) * self.b)
        way = (self._raised(w, s) - self._raised(self.w0, s)) / (f.element(s) * self.b)
        return f.lowest_terms(time), f.lowest_terms(self.q0 + self.sense * way)

    def _speed_from(self, base: Ratio, exponent: Fraction) -> Ratio:
        """w of w^exponent = base."""
        return self._raised(self.model.field.lowest_terms(base), 1 / exponent)

    def at(self, t: Ratio) -> tuple[Ratio, Ratio]:
        exponent = 1 - self.n
        base = self._raised(self.w0, exponent) + self.model.field.element(exponent) * self.b * t
        w = self._speed_from(base, exponent)
        return self._at_speed(w)[1], self.sense * w

    def places(self, value: Ratio) -> Instants:
        f, exponent = self.model.field, 2 - self.n
        way = self.sense * (value - self.q0)
        base = f.lowest_terms(self._raised(self.w0, exponent) + f.element(exponent) * self.b * way)
        w = self._speed_from(base, exponent)
        time = self._at_speed(w)[0]
        needs: list[Need] = [(base, ">")]
        return [LawInstant(time, value, self.sense * w, f.lowest_terms(way))], needs

    def rates(self, value: Ratio) -> Instants:
        f, w = self.model.field, self.sense * value
        if w.is_zero():
            if self.n >= 1 or not self.is_negative(self.b):
                return [], []  # it only tends to that, or away from it
            time = -self._raised(self.w0, 1 - self.n) / (f.element(1 - self.n) * self.b)
            way = -self._raised(self.w0, 2 - self.n) / (f.element(2 - self.n) * self.b)
            return [LawInstant(f.lowest_terms(time), self.q0 + self.sense * way, f.zero, None)], []
        time, place = self._at_speed(w)
        return [LawInstant(time, place, value, f.lowest_terms((w - self.w0) / self.b))], [(w, ">")]

    @property
    def limit(self) -> Limit | None:
        if self.n < 1 or not self.is_negative(self.b):
            return None
        f, rest = self.model.field, 2 - self.n
        way = -self._raised(self.w0, rest) / (f.element(rest) * self.b)
        unit = -self._raised(self.w0, 1 - self.n) / self.b
        place = f.lowest_terms(self.q0 + self.sense * way) if rest > 0 else None
        return Limit(place, f.zero, _LATE * unit)


def _factor(moving: Freely, a: Ratio, w: Ratio, n: Fraction) -> Ratio | None:
    """b of a = b w^n, where that does not contain w; of half a power by its square, for roots may be taken together."""
    f = moving.field
    index = f.index(w)
    if n.denominator == 1:
        b = f.lowest_terms(a / w ** int(n))
        return b if index not in f.ingredients(b) and b.is_constant() else None
    square = f.lowest_terms(a * a / w ** int(2 * n))
    if index in f.ingredients(square) or not square.is_constant():
        return None
    is_falling = moving.sign(f.follow(a, {index: f.one})) is Sign.NEGATIVE
    root = f.sqrt(square, moving.model.samples.is_negative)
    return -root if is_falling else root
