"""A resistance with a part linear in the rate and one quadratic in it: w' = A + B w + C w^2 for w = sense u > 0, with
B, C < 0. By separation (Riccati's equation with constant coefficients), D = B^2 - 4 A C and s = sqrt D,

    w = (w0 + (2 A + B w0) T)/(1 - (B + 2 C w0) T),          T = tanh(s t/2)/s,
    q - q0 = -sense (ln(cosh(s t/2) - (B + 2 C w0) sinh(s t/2)/s) + B t/2)/C

(D < 0: tan, cos and sin with s = sqrt(-D)). Driven (A > 0) it tends to the rate (B + s)/(-2 C); without a drive it
comes closer and closer to a place, with B + C w = (B + C w0) exp(C |q - q0|) everywhere; against its drive (A < 0)
it turns, and comes back driven.
Source: Timoshenko & Young, Advanced Dynamics, 1948, sec. 6; Marion & Thornton, Classical Dynamics, sec. 2.4.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Self

from freebody.symbolic.laws.base import SETTLED, Farthest, Freely, Instants, LawInstant, Limit
from freebody.symbolic.laws.by_rate import ByRate, is_mixed, quotient_of
from freebody.symbolic.laws.there_and_back import at_near, later, limit_behind
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.signs import Sign


@dataclass(frozen=True)
class MixedResistance(ByRate):
    """drives: the sign of A. moving: to make the law of the way back of. is_one: as of a way there and back."""

    key = "mixed_resistance"

    drives: int
    moving: Freely
    is_one: bool

    @classmethod
    def of(cls, moving: Freely) -> Self | None:
        found = quotient_of(moving)
        if found is None or not is_mixed(found):
            return None
        f, (above, below, sense, bends) = moving.field, found
        above = tuple(f.lowest_terms(x / below[0]) for x in above)
        drive = moving.sign(above[0])
        if drive is Sign.UNKNOWN or any(moving.sign(x) is not Sign.NEGATIVE for x in above[1:]):
            return None
        drives = {Sign.POSITIVE: 1, Sign.ZERO: 0}.get(drive, -1)
        is_one = drives >= 0 or moving.keeps_sense or moving.onward(1) == moving.onward(-1)
        if not is_one and not moving.takes_side:  # which way it is on is a question of its own
            return None
        return cls(moving.model, moving.q0, moving.u0, above, (f.one,), sense, bends, drives, moving, is_one)

    @property
    def has_course(self) -> bool:
        return True

    @property
    def first_rate(self) -> Ratio:
        """w0."""
        return self.sense * self.u0

    @property
    def slowness(self) -> Ratio:
        """s; without a drive -B."""
        a, b, c = self.above
        return self.root(self.model.field.lowest_terms(self.bends * (b * b - 4 * a * c))) if self.drives else -b

    @property
    def unit_of_time(self) -> Ratio:
        return 1 / self.slowness

    # -- in the time --------------------------------------------------------------------------
    def at(self, t: Ratio) -> tuple[Ratio, Ratio]:
        return self.at_near(t, t)

    def at_near(self, t: Ratio, near: Ratio) -> tuple[Ratio, Ratio]:
        return at_near(self, t, near)

    def out(self, t: Ratio) -> tuple[Ratio, Ratio]:
        """Until it turns, if it does."""
        f, (a, b, c), w0 = self.model.field, self.above, self.first_rate
        if not self.drives:
            gone = f.lowest_terms(1 - self.function("exp", f.lowest_terms(b * t)))
            below = f.lowest_terms(1 + c * w0 / b * gone)
            return self.q0 - self.sense * self.function("log", below) / c, self.u0 * (1 - gone) / below
        s = self.slowness
        names = ("cosh", "sinh") if self.bends > 0 else ("cos", "sin")
        even, odd = (self.function(name, f.lowest_terms(s * t / 2)) for name in names)
        below = f.lowest_terms(even - (b + 2 * c * w0) * odd / s)
        rate = f.lowest_terms((w0 * even + (2 * a + b * w0) * odd / s) / below)
        return self.q0 - self.sense * (self.function("log", below) + b * t / 2) / c, self.sense * rate

    @property
    def turning(self) -> tuple[Ratio, Ratio]:
        found = self._until(self.model.field.zero)
        return found.time, found.place

    @property
    def back(self) -> MixedResistance | None:
        if self.is_one:
            return None
        return MixedResistance.of(replace(self.moving, q0=self.turning[1], u0=self.model.field.zero))

    # -- instants -----------------------------------------------------------------------------
    def _until(self, value: Ratio) -> LawInstant:
        found = super().rates(value)
        assert found is not None
        return found[0][0]

    def rates(self, value: Ratio) -> Instants:
        if value.is_zero():  # it turns, or only tends to it
            return ([replace(self._until(value), key=None)] if self.drives < 0 else []), []
        if self.drives >= 0 or not self.is_negative(self.model.field.lowest_terms(self.sense * value)):
            return super().rates(value)
        back = None if self.back is None else self.back.rates(value)
        return None if back is None else (list(later(self, back)), back[1])

    def places(self, value: Ratio) -> Instants:
        """Without a drive; else the time stands in a logarithm and outside of it."""
        if self.drives:
            return None
        f, (_a, b, c), w0 = self.model.field, self.above, self.first_rate
        way = f.lowest_terms(self.sense * (value - self.q0))
        w = f.lowest_terms(((b + c * w0) * self.function("exp", f.lowest_terms(c * way)) - b) / c)
        time = (self.function("log", f.lowest_terms(w / w0)) - c * way) / b
        return [LawInstant(time, value, self.sense * w, way)], [(w, ">")]

    # -- ends ---------------------------------------------------------------------------------
    @property
    def limit(self) -> Limit | None:
        f, (_a, b, c) = self.model.field, self.above
        if self.drives < 0:
            return limit_behind(self)
        late = SETTLED / self.slowness
        if self.drives:
            return Limit(None, f.lowest_terms(-self.sense * (b + self.slowness) / (2 * c)), late)
        end = self.q0 - self.sense * self.function("log", f.lowest_terms(1 + c * self.first_rate / b)) / c
        return Limit(end, f.zero, late)

    def extent(self, side: int) -> Farthest | None:
        if side != self.sense:
            falls = self.drives < 0 and self.back is not None
            return Farthest(None, is_boundless=True) if falls else Farthest(self.q0) if self.drives >= 0 else None
        if self.drives > 0:
            return Farthest(None, is_boundless=True)
        return Farthest(None, is_limit=True) if not self.drives else self.at_first_turn(side)
