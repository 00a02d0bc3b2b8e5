"""A spring and a resistance that is linear in the rate: q'' = -w0^2 (q - c) - 2 d q'.

    w0 > d    q = c + exp(-d t) (x0 cos(w t) + y0 sin(w t)),      w = sqrt(w0^2 - d^2),   y0 = (u0 + d x0)/w
    w0 < d    q = c + exp(-d t) (x0 cosh(k t) + y0 sinh(k t)),    k = sqrt(d^2 - w0^2),   y0 = (u0 + d x0)/k
    w0 = d    q = c + exp(-d t) (x0 + (u0 + d x0) t)

x0 = q0 - c. Places other than the centre, and rates other than zero, have no closed form in the time.
Source: Magnus & Popp, Schwingungen, 7th ed. 2005, sec. 2.2.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import ClassVar, Self

from freebody.symbolic.laws.base import (
    SETTLED,
    Farthest,
    Freely,
    Instants,
    LawInstant,
    Limit,
    MotionLaw,
    Need,
    first,
)
from freebody.symbolic.laws.turns import wave_zeros
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.signs import Sign

_Zero = tuple[Ratio, Ratio | None]  # a time, and its key


@dataclass(frozen=True)
class Damped(MotionLaw):
    """What the three cases have in common."""

    tends_alike = True

    center: Ratio
    delta: Ratio
    square: Ratio  # w0^2

    @classmethod
    def among(cls, moving: Freely, sign: Sign) -> Self | None:
        """The law where d^2 - w0^2 has a sign."""
        if moving.steady is None:
            return None
        alpha, beta, gamma = moving.steady
        if gamma.is_zero() or beta.is_zero():
            return None
        f = moving.field
        if moving.sign(f.lowest_terms(gamma * gamma / 4 + beta)) is not sign:
            return None
        center = f.lowest_terms(-alpha / beta)
        return cls(moving.model, moving.q0, moving.u0, center, f.lowest_terms(-gamma / 2), -beta)

    swings: ClassVar[bool] = False  # else it turns at most once, and does not get beyond its centre after that

    def extent(self, side: int) -> Farthest | None:
        if self.is_negative(self.delta) or self.is_negative(self.square):
            return None
        if self.u0.is_zero():  # from the start to the other side of the centre, or only to the centre
            sense, needs = self.side_of(self.x0)
            return Farthest(self.q0 if side == sense else None, needs, is_limit=side != sense and not self.swings)
        sense, needs = self.side_of(self.u0)
        if side == sense:
            return Farthest(None, needs)
        if self.swings:
            return self._farthest_back(side, needs)
        if self.x0.is_zero():  # it comes back to the centre and stays there
            return Farthest(self.q0, needs)
        begins, more = self.side_of(self.x0)
        return Farthest(self.q0, (*needs, *more)) if begins == side else Farthest(None, (*needs, *more), is_limit=True)

    def _farthest_back(self, side: int, needs: tuple[Need, ...]) -> Farthest | None:
        """On the side from which it first goes away: its second turn, or the start, whichever is farther."""
        instants, more = self.rates(self.u0.field.zero) or ((), [])
        turn = first(self.model, instants)
        if turn is None:
            return None
        place = self.turned_after(turn.instant, 1)
        beyond = self.model.field.lowest_terms(side * (place - self.q0))
        needs = (*needs, *more, *turn.conditions)
        if self.is_negative(beyond):
            return Farthest(self.q0, (*needs, (-beyond, ">=")))
        return Farthest(place, (*needs, (beyond, ">=")))

    @property
    def first_acceleration(self) -> Ratio:
        return self.q0 - self.center

    @property
    def x0(self) -> Ratio:
        return self.q0 - self.center

    @property
    def drive(self) -> Ratio:
        """u0 + d x0."""
        return self.model.field.lowest_terms(self.u0 + self.delta * self.x0)

    @property
    def pull(self) -> Ratio:
        """d u0 + w0^2 x0, by which the rate falls."""
        return self.model.field.lowest_terms(self.delta * self.u0 + self.square * self.x0)

    def decayed(self, t: Ratio) -> Ratio:
        return self.function("exp", -self.delta * t)

    @property
    def unit_of_time(self) -> Ratio:
        return 1 / self.delta

    @property
    def limit(self) -> Limit | None:
        if self.is_still:
            return Limit(self.q0, self.u0, self.u0.field.one)
        if self.is_negative(self.delta) or self.is_negative(self.square):
            return None
        # the slower root is d - k = w0^2/(d + k) >= w0^2/(2 d), or has the real part d
        return Limit(self.center, self.u0.field.zero, SETTLED * (1 / self.delta + 2 * self.delta / self.square))

    def places(self, value: Ratio) -> Instants:
        return self._instants(self.center_passed()) if (value - self.center).is_zero() else None

    def rates(self, value: Ratio) -> Instants:
        return self._instants(self.turned()) if value.is_zero() else None

    def _instants(self, zeros: tuple[Sequence[_Zero], list[Need]]) -> Instants:
        lowest, found = self.model.field.lowest_terms, list[LawInstant]()
        for time, key in zeros[0]:
            place, rate = map(lowest, self.at(time))
            found.append(LawInstant(time, place, rate, key))
        return found, zeros[1]

    def center_passed(self) -> tuple[Sequence[_Zero], list[Need]]:
        """When it is at the centre."""
        raise NotImplementedError

    def turned(self) -> tuple[Sequence[_Zero], list[Need]]:
        """When its rate is zero."""
        raise NotImplementedError


@dataclass(frozen=True)
class Underdamped(Damped):
    """It swings."""

    key = "underdamped"
    swings = True

    @classmethod
    def of(cls, moving: Freely) -> Self | None:
        return cls.among(moving, Sign.NEGATIVE)

    @property
    def w(self) -> Ratio:
        return self.root(self.model.field.lowest_terms(self.square - self.delta * self.delta))

    def at(self, t: Ratio) -> tuple[Ratio, Ratio]:
        w, e = self.w, self.decayed(t)
        c, s = self.function("cos", w * t), self.function("sin", w * t)
        return self.center + e * (self.x0 * c + self.drive / w * s), e * (self.u0 * c - self.pull / w * s)

    @property
    def period(self) -> Ratio:
        return 2 * self.model.field.pi / self.w

    @property
    def is_undamped(self) -> bool:
        return False

    @property
    def half_period(self) -> Ratio:
        return self.model.field.pi / self.w

    def turned_after(self, begin: LawInstant, n: int) -> Ratio:
        # from one turn to the next its deviation from the centre becomes -exp(-d pi/w) times as large
        way = self.decayed(self.model.field.element(n) * self.half_period) * (-1) ** n
        return self.center + (begin.place - self.center) * way

    def center_passed(self) -> tuple[Sequence[_Zero], list[Need]]:
        return [(tau / self.w, key) for tau, key in wave_zeros(self, self.x0, self.drive / self.w)], []

    def turned(self) -> tuple[Sequence[_Zero], list[Need]]:
        return [(tau / self.w, key) for tau, key in wave_zeros(self, self.u0, -self.pull / self.w)], []


@dataclass(frozen=True)
class Overdamped(Damped):
    """It creeps back."""

    key = "overdamped"

    @classmethod
    def of(cls, moving: Freely) -> Self | None:
        return cls.among(moving, Sign.POSITIVE)

    @property
    def k(self) -> Ratio:
        return self.root(self.model.field.lowest_terms(self.delta * self.delta - self.square))

    def at(self, t: Ratio) -> tuple[Ratio, Ratio]:
        k, e = self.k, self.decayed(t)
        c, s = self.function("cosh", k * t), self.function("sinh", k * t)
        return self.center + e * (self.x0 * c + self.drive / k * s), e * (self.u0 * c - self.pull / k * s)

    def center_passed(self) -> tuple[Sequence[_Zero], list[Need]]:
        return self._zeros(self.x0, self.drive / self.k)

    def turned(self) -> tuple[Sequence[_Zero], list[Need]]:
        return self._zeros(self.u0, -self.pull / self.k)

    def _zeros(self, a: Ratio, b: Ratio) -> tuple[Sequence[_Zero], list[Need]]:
        """a cosh(tau) + b sinh(tau) = 0: exp(2 tau) = (b - a)/(b + a)."""
        if a.is_zero() or (b + a).is_zero() or (b - a).is_zero():
            return ([(a, a)] if a.is_zero() else []), []
        grown = self.model.field.lowest_terms((b - a) / (b + a))
        return [(self.function("log", grown) / (2 * self.k), grown - 1)], [(grown, ">")]


@dataclass(frozen=True)
class CriticallyDamped(Damped):
    """Between the two."""

    key = "critically_damped"

    @classmethod
    def of(cls, moving: Freely) -> Self | None:
        return cls.among(moving, Sign.ZERO)

    def at(self, t: Ratio) -> tuple[Ratio, Ratio]:
        e = self.decayed(t)
        return self.center + e * (self.x0 + self.drive * t), e * (self.u0 - self.delta * self.drive * t)

    def center_passed(self) -> tuple[Sequence[_Zero], list[Need]]:
        return self._zeros(self.x0, self.drive)

    def turned(self) -> tuple[Sequence[_Zero], list[Need]]:
        return self._zeros(self.u0, -self.delta * self.drive)

    def _zeros(self, a: Ratio, b: Ratio) -> tuple[Sequence[_Zero], list[Need]]:
        if b.is_zero():
            return [], []
        time = self.model.field.lowest_terms(-a / b)
        return [(time, time)], []
