"""The time of a way by energy where it is elementary: dt = dq/sqrt(W) with W = P(q)/S(q)^2, P = -a q^2 + b q + c and
S = s0 + s1 q. Between the zeros of P, for a > 0 and D = b^2 + 4 a c,

    t = (s0 + s1 b/(2 a)) phi/sqrt(a) - s1 sqrt(P)/a,        phi = arcsin((2 a q - b)/sqrt(D)),

up to a constant; there and back takes 2 pi (s0 + s1 b/(2 a))/sqrt(a). So goes a body round a centre that attracts it
with mu/r^2, where W = 2 E/m + 2 mu/r - h^2/r^2: Kepler's equation and his third law; h = 0 falls straight into it.
Where P is a polynomial in q^2 and S = s1 q it is so with u = q^2 and S = s1/2: round the middle of a spring, where W =
2 E/m - k/m r^2 - h^2/r^2, r turns twice while the body goes round once.
Source: Landau & Lifshitz, Mechanics, 3rd ed. 1976, sec. 14 and 15.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass

from freebody.symbolic.functions import functions
from freebody.symbolic.model import SymbolicModel
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.signs import Sign, sign_of
from freebody.symbolic.unknowns import Coordinate

Need = tuple[Ratio, str]


@dataclass(frozen=True)
class AlgebraicTime:
    """t(q) up to a constant, growing with q. root: of P at a place; below: S, by its two coefficients; n: by q^n."""

    a: Ratio
    b: Ratio
    below: tuple[Ratio, Ratio]
    spread: Ratio  # sqrt(D)
    root_of_a: Ratio
    root: Callable[[Ratio], Ratio]
    arc: Callable[[Ratio], Ratio]
    needs: tuple[Need, ...]
    n: int = 1

    @property
    def highest(self) -> Ratio:
        """phi at the upper turn."""
        return self.a.field.pi / 2

    @property
    def rate(self) -> Ratio:
        """dt/dphi on average."""
        return (self.below[0] + self.below[1] * self.b / (2 * self.a)) / self.root_of_a

    def _phi(self, place: Ratio) -> Ratio:
        return self.arc(self.a.field.lowest_terms((2 * self.a * place**self.n - self.b) / self.spread))

    def at(self, place: Ratio) -> Ratio:
        return self.a.field.lowest_terms(self.rate * self._phi(place) - self.below[1] * self.root(place) / self.a)

    def at_turn(self, way: int) -> Ratio:
        """At the place at which it turns, above (way > 0) or below."""
        return way * self.rate * self.highest

    @property
    def period(self) -> Ratio:
        return 2 * self.a.field.pi * self.rate

    def told(self, place: Ratio) -> tuple[str, dict[str, Ratio]]:
        """The key of the sentence that tells it, and what stands in it; sqrt(P) is S |u|."""
        f, (s0, s1) = self.a.field, self.below
        if self.n == 2:
            return "course.algebraic_square", {"phi": self._phi(place), "scale": self.rate}
        share = f.lowest_terms(s1 * (s0 + s1 * place) / self.a)
        return "course.algebraic", {"phi": self._phi(place), "scale": self.rate, "share": share}


def algebraic_time(model: SymbolicModel, c: Coordinate, square: Ratio, q0: Ratio) -> AlgebraicTime | None:
    """The time of the way of a coordinate by u^2 = square, where it is of this form and the way bounded."""
    f, index = model.field, c.index
    square = f.lowest_terms(square)
    if index not in f.ingredients(square.denominator()):
        return None  # which has laws of its own
    moving = {g for g in square.generators() if index in f.ingredients(f.variable(g))}
    if moving != {index}:
        return None
    above, below = square.numerator(), f.one
    for base, exponent in f.factor(square.denominator().num)[1]:
        if index in f.ingredients(base):
            below = below * base ** ((exponent + 1) // 2)
            above = above * base ** (exponent % 2)
    rest = f.lowest_terms(square * below**2 / above)  # of the divisor, what does not change
    parts, s, n = above.numerator().coefficients(index), below.coefficients(index), 1
    if len(parts) == 5 and len(s) == 2 and all(x.is_zero() for x in (parts[1], parts[3], s[0])):
        if not model.samples.at_starts(q0)[0] > 0:
            return None
        parts, s, n = parts[::2], [s[1] / 2, f.zero], 2
    if len(parts) != 3 or len(s) != 2:
        return None
    a, b, constant = -parts[2] * rest, parts[1] * rest, parts[0] * rest
    needs: list[Need] = []
    if sign_of(a) is not Sign.POSITIVE:
        if not model.samples.at_starts(a)[0] > 0:
            return None
        needs.append((f.lowest_terms(a), ">"))
    is_negative = model.samples.is_negative
    side = next((v for v in model.samples.at_starts(f.follow(below, {index: q0})) if not math.isnan(v)), 0.0)
    if not side:
        return None
    sense = 1 if side > 0 else -1

    def root(place: Ratio) -> Ratio:
        inside = f.lowest_terms(f.follow(above * rest, {index: place}))
        return f.sqrt(inside, is_negative)

    return AlgebraicTime(
        f.lowest_terms(a),
        f.lowest_terms(b),
        (sense * s[0], sense * s[1]),
        f.sqrt(f.lowest_terms(b * b + 4 * a * constant), is_negative),
        f.sqrt(f.lowest_terms(a), is_negative),
        root,
        functions(f, is_negative)["asin"],
        tuple(needs),
        n,
    )
