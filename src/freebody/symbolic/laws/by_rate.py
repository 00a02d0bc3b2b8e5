"""An acceleration that is a rational function of the rate, w' = R(w)/N(w) with R of the second degree at most, or
R = a + d w^3: how long it takes to a rate, and how far it gets until then,

    t = int N(w)/R(w) dw,          q - q0 = int w N(w)/R(w) dw,

which division by R leaves as polynomials and, with D = b^2 - 4 a c of R = a + b w + c w^2,

    int dw/R = ln((2 c w + b - sqrt D)/(2 c w + b + sqrt D))/sqrt D      (D < 0: 2 atan((2 c w + b)/sqrt(-D))/sqrt(-D)),
    int w dw/R = (ln R - b int dw/R)/(2 c),

and for a third power with k^3 = -a/d and L = ln(w^2 + k w + k^2)/6 - ln|k - w|/3, A = atan((2 w + k)/(sqrt 3 k))/sqrt 3

    int dw/R = -(L + A)/(d k^2),          int w dw/R = -(L - A)/(d k),          int w^2 dw/R = ln R/(3 d).

As a function of the time it has no closed form in general; the rate tends to the zero of R where that has one, and the
acceleration leads to it from either side. So move what both dry friction and a resistance hold back, and a drive of
constant power against a resistance.
Source: Meriam & Kraige, Dynamics, sec. 2/2; Timoshenko & Young, Advanced Dynamics, 1948, sec. 6.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Self

from freebody.errors import CannotAnswer
from freebody.language.sentences import Message
from freebody.symbolic.laws.base import SETTLED, Freely, Instants, LawInstant, Limit, MotionLaw, Need
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.signs import Sign

_MOST = 6  # degree of N
_SLOWLY = 2 * SETTLED  # units of time: far from its end it may take longer
Quotient = tuple[tuple[Ratio, ...], tuple[Ratio, ...], int, int]  # coefficients of R and N, the sense, the sign of D


def quotient_of(moving: Freely) -> Quotient | None:
    """R and N of w = sense u, in the sense in which it sets out."""
    f, c = moving.field, moving.coordinate
    a = moving.acceleration
    if not moving.is_alone or c.speed not in f.ingredients(a) or {c.index, f.index(f.time)} & f.ingredients(a):
        return None
    try:
        drive = f.follow(a, {c.speed: f.zero}) if moving.u0.is_zero() else moving.u0
    except ZeroDivisionError:
        return None
    sense = {Sign.POSITIVE: 1, Sign.NEGATIVE: -1}.get(moving.sign(f.lowest_terms(drive)), 0)
    onward = moving.onward(sense) if sense else None
    if onward is None:
        return None
    w = f.parameter("@w")  # positive, as a parameter is
    a, index = f.lowest_terms(f.follow(sense * onward, {c.speed: sense * w})), f.index(w)
    if index in (f.ingredients(a) - a.generators()):
        return None
    above, below = (tuple(part.coefficients(index)) for part in (a.numerator(), a.denominator()))
    if not 2 <= len(above) <= 4 or len(below) > _MOST or any(index in f.ingredients(x) for x in (*above, *below)):
        return None
    if len(above) == 4 and not (above[1].is_zero() and above[2].is_zero() and _opposes(moving, above)):
        return None
    is_simple = len(below) == 1 and (len(above) == 2 or (len(above) == 3 and above[1].is_zero()))
    if is_simple or sum(not x.is_zero() for x in above) == 1:
        return None  # which have laws of their own
    bends = 0
    if len(above) == 3:
        sign = moving.sign(f.lowest_terms(above[1] ** 2 - 4 * above[0] * above[2]))
        bends = {Sign.POSITIVE: 1, Sign.NEGATIVE: -1}.get(sign, 0)
        if not bends:
            return None
    return above, below, sense, bends


def _opposes(moving: Freely, above: tuple[Ratio, ...]) -> bool:
    """Whether the first and the last of the coefficients have opposite signs: R has a positive zero."""
    return {moving.sign(above[0]), moving.sign(above[-1])} == {Sign.POSITIVE, Sign.NEGATIVE}


def is_mixed(found: Quotient) -> bool:
    """Whether R has all powers up to the square and N none: that has a closed form in the time, too."""
    return len(found[0]) == 3 and len(found[1]) == 1


@dataclass(frozen=True)
class ByRate(MotionLaw):
    """With the sense of the motion, in which w = sense u is positive. above, below: the coefficients of R and N."""

    key = "by_rate"

    above: tuple[Ratio, ...]
    below: tuple[Ratio, ...]
    sense: int
    bends: int  # the sign of D

    @classmethod
    def of(cls, moving: Freely) -> Self | None:
        found = quotient_of(moving)
        return None if found is None or is_mixed(found) else cls(moving.model, moving.q0, moving.u0, *found)

    @property
    def is_still(self) -> bool:
        return False

    @property
    def has_course(self) -> bool:
        return False

    @property
    def first_acceleration(self) -> Ratio:
        return self._value(self.above, self.sense * self.u0)

    def at(self, t: Ratio) -> tuple[Ratio, Ratio]:
        raise CannotAnswer(Message("no closed form of the motion in the time was found"))

    def _value(self, coefficients: tuple[Ratio, ...], w: Ratio) -> Ratio:
        return self.model.field.lowest_terms(sum((x * w**k for k, x in enumerate(coefficients)), self.model.field.zero))

    def _integral(self, top: tuple[Ratio, ...], w0: Ratio, w: Ratio) -> Ratio:
        """int top/R from w0 to w."""
        f, rest, total = self.model.field, list(top), self.model.field.zero
        degree = len(self.above) - 1
        rest += [f.zero] * (degree - len(rest))
        while len(rest) > degree:
            k = len(rest) - 1 - degree
            share = f.lowest_terms(rest[-1] / self.above[-1])
            total = total + share * (w ** (k + 1) - w0 ** (k + 1)) / (k + 1)
            for j, x in enumerate(self.above):
                rest[k + j] = f.lowest_terms(rest[k + j] - share * x)
            rest.pop()
        ratio = f.lowest_terms(self._value(self.above, w) / self._value(self.above, w0))
        grown = self.function("log", ratio)
        if degree == 1:
            return f.lowest_terms(total + rest[0] / self.above[1] * grown)
        if degree == 3:
            return f.lowest_terms(total + self._of_third_power(rest, w0, w) + rest[2] / (3 * self.above[3]) * grown)
        plain, linear = (*rest, f.zero)[:2]
        a, b, c = self.above
        per = (plain - linear * b / (2 * c)) * self._plain(b, c, a, w0, w)
        return f.lowest_terms(total + per + linear / (2 * c) * grown)

    def _plain(self, b: Ratio, c: Ratio, a: Ratio, w0: Ratio, w: Ratio) -> Ratio:
        """int dw/R for R of the second degree."""
        f = self.model.field
        root = self.root(f.lowest_terms(self.bends * (b * b - 4 * a * c)))
        first, then = (2 * c * x + b for x in (w0, w))
        if self.bends < 0:
            arcs = [self.function("atan", f.lowest_terms(x / root)) for x in (then, first)]
            return 2 * (arcs[0] - arcs[1]) / root
        ratio = f.lowest_terms((then - root) * (first + root) / ((then + root) * (first - root)))
        return self.function("log", ratio) / root

    def _of_third_power(self, top: Sequence[Ratio], w0: Ratio, w: Ratio) -> Ratio:
        """int (p + q w)/R for R = a + d w^3."""
        f, (plain, linear, *_rest) = self.model.field, top
        if plain.is_zero() and linear.is_zero():
            return f.zero
        k, d, root = self.zero, self.above[3], f.sqrt(f.element(3), self.model.samples.is_negative)
        assert k is not None
        squares = f.lowest_terms((w * w + k * w + k * k) / (w0 * w0 + k * w0 + k * k))
        gaps = f.lowest_terms((k - w) / (k - w0))
        logs = self.function("log", squares) / 6 - self.function("log", gaps) / 3
        then, first = (self.function("atan", f.lowest_terms((2 * x + k) / (root * k))) for x in (w, w0))
        arcs = (then - first) / root
        return -plain * (logs + arcs) / (d * k * k) - linear * (logs - arcs) / (d * k)

    @cached_property
    def zero(self) -> Ratio | None:
        """The one positive zero of R, to which the rate tends from either side: a drive that falls, a resistance that
        grows; None where it has none or several."""
        f, (first, *_between, last) = self.model.field, self.above
        signs = {sign for x in self.below if not x.is_zero() for sign in (self.is_negative(x),)}
        if (
            len(signs) > 1
            or self.is_negative(first) != signs.pop()
            or self.is_negative(last) == self.is_negative(first)
        ):
            return None
        if len(self.above) == 2:
            return f.lowest_terms(-first / last)
        if len(self.above) == 4:
            return self.function("exp", self.function("log", f.lowest_terms(-first / last)) / 3)
        middle = self.above[1]
        root = self.root(f.lowest_terms(middle * middle - 4 * first * last))
        return f.lowest_terms((-middle - root if self.is_negative(last) else -middle + root) / (2 * last))

    @property
    def limit(self) -> Limit | None:
        if self.zero is None:
            return None
        f, k = self.model.field, self.zero
        slope = sum((n * x * k ** (n - 1) for n, x in enumerate(self.above) if n), f.zero)
        unit = self._value(self.below, k) / slope
        return Limit(None, f.lowest_terms(self.sense * k), f.lowest_terms(-_SLOWLY * unit))

    def rates(self, value: Ratio) -> Instants:
        f, w0, w = self.model.field, self.sense * self.u0, self.sense * value
        time = self._integral(self.below, w0, w)
        way = self._integral((f.zero, *self.below), w0, w)
        first, then = (self._value(self.above, x) for x in (w0, w))
        drive = f.lowest_terms(first / self._value(self.below, w0)) if not w0.is_zero() else first
        needs: list[Need] = [] if w.is_zero() else [(w, ">")]
        needs.append((f.lowest_terms(first * then), ">"))
        place = f.lowest_terms(self.q0 + self.sense * way)
        return [LawInstant(time, place, value, f.lowest_terms((w - w0) * drive))], needs
