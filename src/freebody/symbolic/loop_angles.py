"""The angles that closed loops bind, one after the other, each by those before it: what a lecturer computes in turn.

An equation A cos q + B sin q + C = 0 in one angle, or what is left of two equations in two angles without one of them
(Freudenstein's of a four-bar), has

    tan(q/2) = (w - B)/(C - A),     w = B cos q - A sin q = +-sqrt(A^2 + B^2 - C^2), the sign that of the branch;

two equations in one angle, as for the other link of a dyad, tell its cosine and sine, and tan(q/2) = sin q/(1 + cos q).
Source: Freudenstein, Trans. ASME 77 (1955), p. 853.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from itertools import combinations

from freebody.symbolic.closure import Closure
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.unknowns import Coordinate


@dataclass(frozen=True)
class ByCoefficients:
    """A cos q + B sin q + C = 0; side: the sign of w."""

    angle: Coordinate
    coefficients: tuple[Ratio, Ratio, Ratio]
    side: int


@dataclass(frozen=True)
class BySine:
    """sin q; is_turned: its cosine is negative."""

    angle: Coordinate
    sine: Ratio
    is_turned: bool


@dataclass(frozen=True)
class ByCosine:
    """cos q; is_turned: its sine is negative."""

    angle: Coordinate
    cosine: Ratio
    is_turned: bool


@dataclass(frozen=True)
class ByHalf:
    """tan(q/2)"""

    angle: Coordinate
    tangent: Ratio


LoopAngle = ByCoefficients | BySine | ByCosine | ByHalf


class LoopAngles:
    """Of one model. left: what is not told so. Raises CannotAnswer where the branch depends on the parameters."""

    def __init__(self, closure: Closure) -> None:
        self.closure, self.model, self.field = closure, closure.model, closure.field
        self.found: list[LoopAngle] = []
        self.left: list[Coordinate] = [
            d for d in self.model.dependent if any(d.index in self._inside(e.value) for e in self.model.loops)
        ]
        while self.left:
            step = next(self._next(), None)
            if step is None:
                break
            self.found.append(step)
            self.left = [d for d in self.left if d is not step.angle]

    def _inside(self, x: Ratio) -> frozenset[int]:
        return self.field.ingredients(x)

    def _next(self) -> Iterator[LoopAngle]:
        """What can be told next: by two equations, by one, or by two in two angles."""
        loops = [e.value.numerator() for e in self.model.loops]
        inside = [[d for d in self.left if d.index in self._inside(x)] for x in loops]
        for d in self.left:
            own = [x for x, bound in zip(loops, inside, strict=True) if bound == [d]]
            for pair in combinations(own, 2):
                if (both := self._by_both(d, *pair)) is not None:
                    yield both
            for x in own:
                if (parts := self.closure.linear_in(x, d.index)) is not None:
                    yield self._by_one(d, *parts)
        for (k, x), (n, y) in combinations(enumerate(loops), 2):
            bound = [d for d in self.left if d in inside[k] or d in inside[n]]
            if len(bound) != 2:
                continue
            for d, gone in (bound, bound[::-1]):
                equation = self.closure.without((x, y), gone.index, d.index)
                parts = None if equation is None else self.closure.linear_in(equation, d.index)
                if parts is not None:
                    yield self._by_one(d, *parts)

    def _by_one(self, d: Coordinate, a: Ratio, b: Ratio, c: Ratio) -> LoopAngle:
        f, closure = self.field, self.closure
        cos, sin = (f.variable(g) for g in f.pair_of(d.index) or (-1, -1))
        if a.is_zero():
            return BySine(d, f.lowest_terms(-c / b), closure.side(cos) < 0)
        if b.is_zero():
            return ByCosine(d, f.lowest_terms(-c / a), closure.side(sin) < 0)
        return ByCoefficients(d, (a, b, c), closure.side(b * cos - a * sin))

    def _by_both(self, d: Coordinate, x: Ratio, y: Ratio) -> LoopAngle | None:
        f = self.field
        first, second = (self.closure.linear_in(e, d.index) for e in (x, y))
        if first is None or second is None:
            return None
        (a, b, c), (A, B, C) = first, second
        det = f.lowest_terms(a * B - A * b)
        below = f.lowest_terms(det + b * C - B * c)
        if det.is_zero() or below.is_zero():
            return None
        return ByHalf(d, f.lowest_terms((A * c - a * C) / below))
