"""An acceleration that is given in time: u = u0 + int a dt, q = q0 + int u dt."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import Self

from freebody.symbolic.antiderivative import antiderivative
from freebody.symbolic.laws.base import SETTLED, Freely, Instants, LawInstant, Limit, MotionLaw
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.signs import Sign, sign_of
from freebody.symbolic.unknowns import Coordinate
from freebody.symbolic.zeros import zeros_of


@dataclass(frozen=True)
class InTime(MotionLaw):
    """Where the acceleration and what comes of it are integrated over time. gained, way: the integral of the
    acceleration, and of that, both zero at the start."""

    key = "in_time"

    gained: Ratio
    way: Ratio

    @classmethod
    def of(cls, moving: Freely) -> Self | None:
        if moving.linear is None or moving.steady is not None:
            return None
        alpha, beta, gamma = moving.linear
        if not (beta.is_zero() and gamma.is_zero()):
            return None
        f = moving.field
        found, x = list[Ratio](), alpha
        for _integral in range(2):
            whole = antiderivative(x, f.index(f.time))
            if whole is None:
                return None
            x = f.lowest_terms(whole - f.follow(whole, {f.index(f.time): f.zero}))
            found.append(x)
        return cls(moving.model, moving.q0, moving.u0, *found)

    @property
    def is_still(self) -> bool:
        return False

    @property
    def first_acceleration(self) -> Ratio:
        f = self.model.field
        return f.follow(f.derivative(self.gained, f.index(f.time)), {f.index(f.time): f.zero})

    def at(self, t: Ratio) -> tuple[Ratio, Ratio]:
        f = self.model.field
        way, gained = (f.follow(x, {f.index(f.time): t}) for x in (self.way, self.gained))
        return self.q0 + self.u0 * t + way, self.u0 + gained

    @cached_property
    def _clock(self) -> Coordinate:
        f = self.model.field
        return Coordinate("t", f.index(f.time), -1, is_angle=False)

    def places(self, value: Ratio) -> Instants:
        return self._zeros(self.at(self.model.field.time)[0] - value)

    def rates(self, value: Ratio) -> Instants:
        return self._zeros(self.at(self.model.field.time)[1] - value)

    def _zeros(self, x: Ratio) -> Instants:
        """Of a polynomial in the time all of whose factors are of the second degree at most, or of a power of it."""
        f, t = self.model.field, self._clock
        x = f.lowest_terms(x).numerator()
        if (single := self._of_power(x)) is not None:
            return single
        for base, _exponent in f.factor(x.num)[1]:
            if t.index in f.ingredients(base):
                parts = base.coefficients(t.index)
                if len(parts) > 3 or any(t.index in f.ingredients(part) for part in parts):
                    return None
        found: list[LawInstant] = []
        for time in zeros_of(self.model, x, t, quadratic=True):
            time = f.lowest_terms(time)
            place, rate = map(f.lowest_terms, self.at(time))
            found.append(LawInstant(time, place, rate, time))
        return found, []

    def _of_power(self, x: Ratio) -> Instants:
        """c + a t^n = 0 with n > 2 has one zero after the start where -c/a is positive, and none else."""
        f, t = self.model.field, self._clock.index
        if {g for g in x.generators() if t in f.ingredients(f.variable(g))} != {t}:
            return None
        c, *middle, a = x.coefficients(t)
        if len(middle) < 2 or c.is_zero() or not all(m.is_zero() for m in middle):
            return None
        share = f.lowest_terms(-c / a)
        time = self.function("exp", self.function("log", share) / (len(middle) + 1))
        place, rate = map(f.lowest_terms, self.at(time))
        return [LawInstant(time, place, rate, None)], [(share, ">")]

    @property
    def limit(self) -> Limit | None:
        """Where exponentials of the time are all there is of it, and all of them die away."""
        f, t = self.model.field, self._clock.index
        place, rate = self.q0 + self.u0 * f.time + self.way, self.u0 + self.gained
        units = f.zero
        for g in sorted((self.gained + self.way).generators()):
            name, argument = f.arguments.get(g, ("", f.one))
            if g == t or t not in f.ingredients(f.variable(g)):
                continue
            slope = f.derivative(argument, t)
            sign = sign_of(slope)
            if name != "exp" or not sign.is_strict:
                return None
            found = [_far(x, g, is_growing=sign is Sign.POSITIVE) for x in (place, rate)]
            if found[1] is None:
                return None
            place, rate = found[0] or f.time, found[1]
            units = units + (1 / slope if sign is Sign.POSITIVE else -1 / slope)
        if t in f.ingredients(rate):
            return None
        return Limit(None if t in f.ingredients(place) else place, rate, SETTLED * units)


def _far(x: Ratio, g: int, *, is_growing: bool) -> Ratio | None:
    """A quotient of polynomials in an exponential where that is gone, or beyond all bounds; None where it is so too."""
    f = x.field
    above, below = (part.coefficients(g) or [f.zero] for part in (x.numerator(), x.denominator()))
    if is_growing:
        if len(above) > len(below):
            return None
        return f.lowest_terms(above[-1] / below[-1]) if len(above) == len(below) else f.zero
    return None if below[0].is_zero() else f.lowest_terms(above[0] / below[0])
