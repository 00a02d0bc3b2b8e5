"""A resistance that grows with the square of the rate: u' = a + k u^2, with k u < 0 as long as it resists.

    a u > 0    towards the terminal rate +-V:   q = q0 - ln(cosh(r t) + (|u0|/V) sinh(r t))/k
    a u < 0    until it turns:                  q = q0 - ln(cos(r t) + (|u0|/V) sin(r t))/k
    a = 0      it only coasts:                  q = q0 - ln(1 - k u0 t)/k

V = sqrt(|a/k|), r = sqrt(|a k|). With |u| in the resistance it goes on after the turn with the other sign of k, from
rest. Source: Timoshenko & Young, Advanced Dynamics, 1948, sec. 6; Gross et al., Technische Mechanik 3, sec. 1.2.4.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Self

from freebody.symbolic.laws.base import SETTLED, Farthest, Freely, Instants, LawInstant, Limit, MotionLaw, Need
from freebody.symbolic.laws.there_and_back import at_near, later, limit_behind
from freebody.symbolic.laws.turns import growth_turns
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.signs import Sign

_LATE = 10**8  # units of time after which 1/t counts as zero


@dataclass(frozen=True)
class Resisted(MotionLaw):
    """What the three ways have in common. sense: +1 where it grows, else -1."""

    a: Ratio
    k: Ratio
    sense: int

    def extent(self, side: int) -> Farthest | None:
        return self.at_first_turn(side)

    @property
    def first_acceleration(self) -> Ratio:
        return self.a + self.k * self.u0 * self.u0

    @property
    def terminal(self) -> Ratio:
        """The square of V, where a and k have opposite signs; minus it, where they have the same."""
        return self.model.field.lowest_terms(-self.a / self.k)

    @property
    def slowness(self) -> Ratio:
        """r, of the dimension of one over a time."""
        square = self.model.field.lowest_terms(self.a * self.k)
        return self.root(-square if self.is_negative(square) else square)

    @property
    def speed(self) -> Ratio:
        """V."""
        return self.root(-self.terminal if self.is_negative(self.terminal) else self.terminal)

    @property
    def unit_of_time(self) -> Ratio:
        return 1 / self.slowness

    def _grown(self, value: Ratio) -> Ratio:
        """exp(-k (q - q0)) at a place."""
        return self.function("exp", self.model.field.lowest_terms(-self.k * (value - self.q0)))

    def _place(self, rate: Ratio) -> Ratio:
        """Where it has a rate, by d(u^2)/dq = 2 (a + k u^2)."""
        ratio = (self.a + self.k * rate * rate) / (self.a + self.k * self.u0 * self.u0)
        return self.q0 + self.function("log", self.model.field.lowest_terms(ratio)) / (2 * self.k)


def _sense(moving: Freely) -> int:
    """The way in which it sets out, 0 where that is open."""
    f, c = moving.field, moving.coordinate
    drive = moving.u0
    if drive.is_zero():
        if c.index in f.ingredients(moving.acceleration):
            return 0
        drive = f.lowest_terms(f.follow(moving.acceleration, {c.speed: f.zero}))
    return {Sign.POSITIVE: 1, Sign.NEGATIVE: -1}.get(moving.sign(drive), 0)


def _parts(moving: Freely, sense: int) -> tuple[Ratio, Ratio] | None:
    """(a, k) with u' = a + k u^2 as long as u has a sign."""
    f, c, x = moving.field, moving.coordinate, moving.onward(sense)
    if x is None:
        return None
    if c.speed in f.ingredients(x.denominator()):
        return None
    parts = [f.lowest_terms(part / x.denominator()) for part in x.numerator().coefficients(c.speed)]
    if len(parts) != 3 or not parts[1].is_zero() or not (parts[0].is_constant() and parts[2].is_constant()):
        return None
    return parts[0], parts[2]


def _resisted(moving: Freely) -> tuple[Ratio, Ratio, int, int] | None:
    """(a, k, sense, the sign of a u) of what is resisted on its way."""
    if not moving.is_alone or moving.coordinate.speed not in moving.field.ingredients(moving.acceleration):
        return None
    sense = _sense(moving)
    parts = _parts(moving, sense) if sense else None
    if parts is None:
        return None
    a, k = parts
    if moving.sign(sense * k) is not Sign.NEGATIVE:
        return None
    sign = moving.sign(sense * a)
    return None if sign is Sign.UNKNOWN else (a, k, sense, {Sign.POSITIVE: 1, Sign.ZERO: 0}.get(sign, -1))


@dataclass(frozen=True)
class Driven(Resisted):
    """Towards the rate at which the resistance balances what drives it."""

    key = "driven"

    @classmethod
    def of(cls, moving: Freely) -> Self | None:
        found = _resisted(moving)
        if found is None or found[3] <= 0:
            return None
        return cls(moving.model, moving.q0, moving.u0, *found[:3])

    def at(self, t: Ratio) -> tuple[Ratio, Ratio]:
        share = self.sense * self.u0 / self.speed
        c, s = self.function("cosh", self.slowness * t), self.function("sinh", self.slowness * t)
        below = self.model.field.lowest_terms(c + share * s)
        rate = self.sense * self.speed * (s + share * c) / below
        return self.q0 - self.function("log", below) / self.k, rate

    def places(self, value: Ratio) -> Instants:
        grown = self._grown(value)
        share = self.sense * self.u0 / self.speed
        turns, needs = growth_turns(self, self.u0.field.one, share, grown)
        way = self.sense * (value - self.q0)
        found: list[LawInstant] = []
        for tau, slope, _key in turns:
            found.append(LawInstant(tau / self.slowness, value, self.sense * self.speed * slope / grown, way))
        return found[:1], [*needs, (way, ">=")]

    def rates(self, value: Ratio) -> Instants:
        f, v = self.model.field, self.speed
        now, then = self.sense * self.u0, self.sense * value
        if (then * then - self.terminal).is_zero() and not (now - then).is_zero():
            return [], []  # it only tends to it
        grown = f.lowest_terms((v + then) * (v - now) / ((v - then) * (v + now)))
        time = self.function("log", grown) / (2 * self.slowness)
        return [LawInstant(time, self._place(value), value, grown - 1)], [(grown, ">")]

    @property
    def limit(self) -> Limit:
        return Limit(None, self.sense * self.speed, SETTLED / (2 * self.slowness))


@dataclass(frozen=True)
class Coasting(Resisted):
    """Nothing but the resistance: it becomes slower and slower, and comes to no end."""

    key = "coasting"

    @classmethod
    def of(cls, moving: Freely) -> Self | None:
        found = _resisted(moving)
        if found is None or found[3]:
            return None
        return cls(moving.model, moving.q0, moving.u0, *found[:3])

    @property
    def unit_of_time(self) -> Ratio:
        return 1 / (self.k * self.u0)

    def at(self, t: Ratio) -> tuple[Ratio, Ratio]:
        grown = 1 - self.k * self.u0 * t
        return self.q0 - self.function("log", grown) / self.k, self.u0 / grown

    def places(self, value: Ratio) -> Instants:
        grown = self._grown(value)
        return [LawInstant((1 - grown) / (self.k * self.u0), value, self.u0 / grown, (value - self.q0) / self.u0)], []

    def rates(self, value: Ratio) -> Instants:
        if value.is_zero():
            return [], []
        grown = self.model.field.lowest_terms(self.u0 / value)
        time = (1 - grown) / (self.k * self.u0)
        return [LawInstant(time, self.q0 - self.function("log", grown) / self.k, value, grown - 1)], [(grown, ">")]

    @property
    def limit(self) -> Limit:
        return Limit(None, self.u0.field.zero, -_LATE / (self.k * self.u0))


@dataclass(frozen=True)
class Thrown(Resisted):
    """Against what drives it, until it turns; and back. k_back: of the way back, where that is resisted as well.
    is_one: whether u' = a + k u^2 is meant of both ways, so that one formula goes on over the turn."""

    key = "thrown"

    k_back: Ratio | None = None
    is_one: bool = False

    @classmethod
    def of(cls, moving: Freely) -> Self | None:
        found = _resisted(moving)
        if found is None or found[3] >= 0:
            return None
        back = _parts(moving, -found[2])
        is_resisted = back is not None and moving.sign(-found[2] * back[1]) is Sign.NEGATIVE
        is_one = back is not None and back == found[:2]
        is_one = moving.keeps_sense or (is_one and not moving.takes_side)
        if not moving.takes_side and not is_one:  # which way it is on is a question of its own
            return None
        k_back = back[1] if back and is_resisted and not moving.keeps_sense else None
        return cls(moving.model, moving.q0, moving.u0, *found[:3], k_back, is_one)

    @property
    def turning(self) -> tuple[Ratio, Ratio]:
        """When it turns, and where."""
        f = self.model.field
        time = self.function("atan", f.lowest_terms(self.sense * self.u0 / self.speed)) / self.slowness
        return time, self._place(f.zero)

    @property
    def back(self) -> Driven | None:
        """The way back, its time counted from the turn."""
        if self.k_back is None:
            return None
        zero = self.model.field.zero
        return Driven(self.model, self.turning[1], zero, self.a, self.k_back, -self.sense)

    def at(self, t: Ratio) -> tuple[Ratio, Ratio]:
        return self.at_near(t, t)

    def at_near(self, t: Ratio, near: Ratio) -> tuple[Ratio, Ratio]:
        return at_near(self, t, near)

    def out(self, t: Ratio) -> tuple[Ratio, Ratio]:
        """On the way out."""
        f, v, r = self.model.field, self.speed, self.slowness
        share = self.sense * self.u0 / v
        c, s = self.function("cos", r * t), self.function("sin", r * t)
        below = f.lowest_terms(c + share * s)
        return self.q0 - self.function("log", below) / self.k, self.sense * v * (share * c - s) / below

    def places(self, value: Ratio) -> Instants:
        f, v = self.model.field, self.speed
        way, needs, found = self.sense * (value - self.q0), list[Need](), list[LawInstant]()
        if not way.is_zero():
            grown = self.function("exp", f.lowest_terms(2 * self.k * (value - self.q0)))
            square = f.lowest_terms((v * v + self.u0 * self.u0) * grown - v * v)
            up = self.sense * self.root(square)
            needs.append((square, ">="))
            found.append(replace(self._when(up), place=value, key=way))
        back = None if self.back is None else self.back.places(value)
        return [*found, *later(self, back)], needs

    def rates(self, value: Ratio) -> Instants:
        f = self.model.field
        if value.is_zero():
            time, place = self.turning
            return [LawInstant(time, place, value, None)], []
        if not self.is_negative(f.lowest_terms(self.sense * value)):
            return [replace(self._when(value), key=self.sense * (self.u0 - value))], []
        back = None if self.back is None else self.back.rates(value)
        return None if back is None else (list(later(self, back)), back[1])

    def _when(self, rate: Ratio) -> LawInstant:
        """On the way there."""
        f, v = self.model.field, self.speed
        first, then = (self.function("atan", f.lowest_terms(self.sense * x / v)) for x in (self.u0, rate))
        return LawInstant((first - then) / self.slowness, self._place(rate), rate, None)

    @property
    def limit(self) -> Limit | None:
        return limit_behind(self)
