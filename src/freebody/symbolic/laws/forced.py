"""A coordinate with a linear law that a drive or a load leads in time: q'' = alpha(t) + b q + g q'.

It is a forced motion and a free one, q = p + h, where p solves the equation for itself, and h'' = b h + g h' starts as
q - p does. Of the terms of alpha, with E = b + W^2,

    A cos(W t) + B sin(W t)      p = C cos(W t) + S sin(W t),     C = (g W B - E A)/D,   S = -(E B + g W A)/D,
                                 D = E^2 + (g W)^2
    the same where D = 0         p = t (A sin(W t) - B cos(W t))/(2 W): undamped resonance, which grows without end
    A t^n, b not zero            p = -(A/b) t^n + what (p'' - g p')/b leaves of lower powers

Source: Meirovitch, Elements of Vibration Analysis, 2nd ed. 1986, sec. 2.2; Magnus & Popp, Schwingungen, 7th ed. 2005.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Self

from freebody.symbolic.field import Field
from freebody.symbolic.functions import cos_sin
from freebody.symbolic.laws.base import Farthest, Freely, MotionLaw
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.time_terms import TimeTerms


@dataclass(frozen=True)
class Forced(MotionLaw):
    """led: the forced motion p in the time; free: the law of the rest of it."""

    key = "forced"

    led: Ratio
    free: MotionLaw
    swings: tuple[tuple[Ratio, Ratio, Ratio], ...] = field(default=())  # (W t, C, S) of its waves
    grows: bool = False  # whether it is in resonance without damping

    @classmethod
    def of(cls, moving: Freely) -> Self | None:
        if moving.linear is None or moving.steady is not None:
            return None
        (alpha, beta, gamma), f = moving.linear, moving.field
        if beta.is_zero() and gamma.is_zero():
            return None
        time = f.index(f.time)
        terms = TimeTerms.of(alpha, time)
        powers = None if terms is None else _led_by_powers(f, terms.powers, beta, gamma)
        if terms is None or powers is None:
            return None
        led, constant, swings, grows = *powers, list[tuple[Ratio, Ratio, Ratio]](), False
        for angle, a, b in terms.waves:
            w = f.lowest_terms(f.derivative(angle, time))
            c, s, grows_so = _led_by_wave(f, w, a, b, beta, gamma)
            cos, sin = cos_sin(f, angle)
            led = led + (f.time if grows_so else f.one) * (c * cos + s * sin)
            swings.append((angle, c, s))
            grows = grows or grows_so
        led = f.lowest_terms(led)
        at_start = {time: f.zero}
        q0 = f.lowest_terms(moving.q0 - f.follow(led, at_start))
        u0 = f.lowest_terms(moving.u0 - f.follow(f.derivative(led, time), at_start))
        c = moving.coordinate
        acceleration = constant + beta * f.variable(c.index) + gamma * f.variable(c.speed)
        alone = Freely(moving.model, c, f.lowest_terms(acceleration), q0, u0, moving.takes_side, moving.keeps_sense)
        free = next((law for kind in MotionLaw.laws if (law := kind.of(alone)) is not None), None)
        if free is None or not free.has_course:
            return None
        return cls(moving.model, moving.q0, moving.u0, led, free, tuple(swings), grows)

    @property
    def is_still(self) -> bool:
        return False

    @property
    def first_acceleration(self) -> Ratio:
        f, time = self.model.field, self.model.field.index(self.model.field.time)
        second = f.derivative(f.derivative(self.led, time), time)
        return f.lowest_terms(f.follow(second, {time: f.zero}) + self.free.first_acceleration)

    @property
    def unit_of_time(self) -> Ratio | None:
        return self.free.unit_of_time

    def at(self, t: Ratio) -> tuple[Ratio, Ratio]:
        f, time = self.model.field, self.model.field.index(self.model.field.time)
        led, rate = (f.follow(x, {time: t}) for x in (self.led, f.derivative(self.led, time)))
        place, free_rate = self.free.at(t)
        return led + place, rate + free_rate

    def extent(self, side: int) -> Farthest | None:
        return Farthest(None, is_boundless=True) if self.grows else None


def _led_by_wave(f: Field, w: Ratio, a: Ratio, b: Ratio, beta: Ratio, gamma: Ratio) -> tuple[Ratio, Ratio, bool]:
    """C and S, and whether they stand before t."""
    away = f.lowest_terms(beta + w * w)
    square = f.lowest_terms(away * away + gamma * gamma * w * w)
    if square.is_zero():
        return -b / (2 * w), a / (2 * w), True
    return (
        f.lowest_terms((gamma * w * b - away * a) / square),
        f.lowest_terms(-(away * b + gamma * w * a) / square),
        False,
    )


def _led_by_powers(f: Field, powers: Mapping[int, Ratio], beta: Ratio, gamma: Ratio) -> tuple[Ratio, Ratio] | None:
    """p of the powers of the time, and what is left of them that is constant."""
    left, led = dict(powers), f.zero
    for n in range(max(left, default=0), 0, -1):
        a = left.get(n, f.zero)
        if a.is_zero():
            continue
        if beta.is_zero():
            return None
        own = f.lowest_terms(-a / beta)
        led = led + own * f.time**n
        left[n - 1] = left.get(n - 1, f.zero) + n * own * gamma
        if n > 1:
            left[n - 2] = left.get(n - 2, f.zero) - n * (n - 1) * own
    return led, f.lowest_terms(left.get(0, f.zero))
