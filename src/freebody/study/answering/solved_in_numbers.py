"""An equation for a parameter without a solution in closed form, solved at the model's own numbers, with a proof of how
many solutions there are.

The values of the parameter are cut into boxes. In a box the formula, its slope and its conditions are enclosed in balls
(`symbolic/decide/slopes.py`). There is no solution where the ball of the formula is without zero, and none or one where
that of its slope is, as the signs at both ends tell. What is not decided is halved. What stays open, beside a place at
which the formula loses its meaning, ends the range in which the solutions are said to be all. Source: Moore, Kearfott &
Cloud, Introduction to Interval Analysis, 2009, ch. 8.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from itertools import pairwise
from typing import Any

import flint

from freebody.budgets import allowed
from freebody.errors import CannotAnswer
from freebody.language.sentences import Message, further
from freebody.model.elements import Parameter
from freebody.study.answering.finding import OnlyInNumbers
from freebody.study.setup import Setup
from freebody.symbolic.conditions import Condition
from freebody.symbolic.decide.slopes import enclosed, two_terms
from freebody.symbolic.ratio import Ratio

_flint: Any = flint
_BOXES = 600  # that one of the first ones is cut into
_MOST = 8  # solutions on one side of the parameter's own value
_DECADES = 6  # on both sides of the parameter's own size
_PER_DECADE = 4
_PARTS = 37  # of the range of an angle; no round share of it, so that ends of boxes are seldom solutions
_NARROWEST = 1e-8  # of its value, or of the first box: one that is not halved any more
_ROUNDED = 1.0 + 2.0**-50  # of a radius, which holds the ends then
_DIGITS = 5  # of the ends of a range that are shown
_WIDE = 1.2  # times its lower end: a range in which it is worth saying that there is none


@dataclass(frozen=True)
class Side:
    """A formula that vanishes at the values that are looked for, where its conditions hold."""

    element: Ratio
    needed: Sequence[Condition]


@dataclass
class Proved:
    """A range of the parameter, and all values in it at which one of the formulas vanishes."""

    low: float
    high: float
    values: list[float] = field(default_factory=list[float])

    def shown(self) -> tuple[float, float]:
        """Its ends in few digits, inside of it."""
        return _inward(self.low, 1), _inward(self.high, -1)


def _inward(x: float, way: int) -> float:
    if not x:
        return 0.0
    unit = 10.0 ** (math.floor(math.log10(abs(x))) - _DIGITS + 1)
    steps = math.ceil(x / unit) if way > 0 else math.floor(x / unit)
    return float(f"{steps * unit:.{_DIGITS}g}")


@dataclass(frozen=True)
class SolvedInNumbers:
    """All values at which something is so, in a range of the parameter."""

    range: Proved

    @property
    def values(self) -> list[float]:
        return self.range.values

    def told(self, why: str, unit: str) -> CannotAnswer:
        """Why there is no closed form, with the values and how it is known that there are no others."""
        low, high = (f"{x:.{_DIGITS}g}" for x in self.range.shown())
        place = {"low": low, "high": high if unit == "1" else f"{high} {unit}"}
        if not self.values:
            none = Message("by interval arithmetic it has no solution between {low} and {high}", **place)
            return CannotAnswer(further(why, none))
        if len(self.values) == 1:
            only = Message("by interval arithmetic it has exactly one solution between {low} and {high}", **place)
            return OnlyInNumbers(further(why, only), self.values[0])
        several = Message(
            "by interval arithmetic it has {n} solutions between {low} and {high}", n=len(self.values), **place
        )
        return OnlyInNumbers(further(why, several), tuple(self.values))


def solved_in_numbers(setup: Setup, parameter: Parameter, index: int, sides: Sequence[Side]) -> SolvedInNumbers | None:
    """The values of a parameter, whose generator is `index`, at which one of the formulas vanishes at the model's own
    numbers; None where it is not known which are all."""
    model, own = setup.model, setup.draws[0].values
    numbers = {model.field.index(x): own[name] for name, x in model.parameters.items() if name in own}
    with two_terms():
        ranges = _Search(parameter, index, sides, numbers).ranges()
    found = [r for r in ranges if r.values]
    if len(found) == 1:
        return SolvedInNumbers(found[0])
    widest = max(ranges, key=lambda r: r.high - r.low, default=None)
    if found or widest is None or abs(widest.high) < _WIDE * abs(widest.low):
        return None
    return SolvedInNumbers(widest)


class _Search:
    def __init__(self, parameter: Parameter, index: int, sides: Sequence[Side], numbers: Mapping[int, float]) -> None:
        self.parameter, self.index, self.sides = parameter, index, sides
        self.numbers = {g: _flint.arb(x) for g, x in numbers.items()}
        self.left = 0
        elements = [x for side in sides for x in (side.element, *(c.element for c in side.needed))]
        self.is_told = all(map(self._is_of_parameters, elements))

    def _is_of_parameters(self, x: Ratio) -> bool:
        """Whether nothing stands in an element whose number may depend on the parameter."""
        f = x.field
        return all(f.generators[g].compute or g == self.index or g in self.numbers for g in f.ingredients(x))

    def ranges(self) -> list[Proved]:
        """From the parameter's own value on upwards and downwards, as far as that can be decided."""
        boxes, own = list(self._boxes()), self.parameter.value or 0.0
        first = max((k for k, (a, _b) in enumerate(boxes) if a <= own), default=0) if self.is_told else len(boxes)
        parts = [*self._along(boxes[first:]), *self._along(reversed(boxes[:first] if self.is_told else []))]
        found: list[Proved] = []
        for low, high, values in sorted(parts):
            if found and found[-1].high == low:
                found[-1].high = high
                found[-1].values += values
            else:
                found.append(Proved(low, high, list(values)))
        return found

    def _along(self, boxes: Iterable[tuple[float, float]]) -> Iterator[tuple[float, float, Sequence[float]]]:
        n_found = 0
        for a, b in boxes:
            self.left = allowed(_BOXES)
            for part in self._decided(a, b):
                n_found += len(part[2])
                yield part
            if self.left <= 0 or n_found >= _MOST:
                return

    def _boxes(self) -> Iterator[tuple[float, float]]:
        p = self.parameter
        if p.acute or p.is_angle:
            low, high = (0.0, math.pi / 2) if p.acute else (0.0 if p.sign != "any" else -math.pi, math.pi)
            yield from pairwise(low + (high - low) * k / _PARTS for k in range(_PARTS + 1))
            return
        if p.is_share:
            yield from pairwise(k / _PARTS for k in range(_PARTS + 1))
            return
        size = abs(p.value or 1.0) * math.sqrt(1.1)  # seldom a solution itself
        steps = range(-_DECADES * _PER_DECADE, _DECADES * _PER_DECADE + 1)
        ends = [size * 10.0 ** (k / _PER_DECADE) for k in steps]
        if p.sign == "any":
            yield from pairwise(-x for x in reversed(ends))
            yield -ends[0], ends[0]
        yield from pairwise(ends)

    # -- one box ------------------------------------------------------------------------------
    def _decided(self, a: float, b: float) -> Iterator[tuple[float, float, Sequence[float]]]:
        """The parts of a box that are decided, in their order, each with its solutions."""
        stack, wide = [(a, b)], b - a
        while stack:
            a, b = stack.pop()
            self.left -= 1
            values = self._solutions(a, b)
            if values is not None:
                if values is not _SILENT:
                    yield a, b, values
                continue
            middle = 0.5 * (a + b)
            if self.left > 0 and b - a > _NARROWEST * max(abs(a), abs(b), wide):
                stack += [(middle, b), (a, middle)]

    def _solutions(self, a: float, b: float) -> Sequence[float] | None:
        """Those in a box; None where that is not decided, _SILENT where no formula is true."""
        ball = _flint.arb(0.5 * (a + b), 0.5 * (b - a) * _ROUNDED)
        found: set[float] = set()
        is_told = False
        for side in self.sides:
            values = self._of_side(side, ball, a, b)
            if values is None:
                return None
            if values is not _SILENT:
                is_told = True
                found.update(values)
        return sorted(found) if is_told else _SILENT

    def _of_side(self, side: Side, ball: Any, a: float, b: float) -> tuple[float, ...] | None:
        """The solutions by one formula; _SILENT where its conditions do not hold in the box."""
        holds = [self._holds(c, ball) for c in side.needed]
        if any(h is False for h in holds):
            return _SILENT
        value, slope = self._at(side.element, ball)
        if _is_not_zero(value):
            return () if all(holds) else None
        if not all(holds) or not _is_not_zero(slope):
            return None
        low, high = (self._sign(side.element, x) for x in (a, b))
        if not low or not high:
            return None
        return () if low == high else (self._root(side.element, a, b, low),)

    def _holds(self, c: Condition, ball: Any) -> bool | None:
        if c.relation == "!=":
            return True  # where a divisor vanishes the formula has no ball
        value, _slope = self._at(c.element, ball)
        return True if value > 0 else False if value < 0 else None

    def _at(self, x: Ratio, ball: Any) -> tuple[Any, Any]:
        try:
            return enclosed(x, self.index, ball, self.numbers)
        except (KeyError, ValueError, ArithmeticError):
            return _flint.arb.nan(), _flint.arb.nan()

    def _sign(self, x: Ratio, place: float) -> int:
        value, _slope = self._at(x, _flint.arb(place))
        return 1 if value > 0 else -1 if value < 0 else 0

    def _root(self, x: Ratio, a: float, b: float, low: int) -> float:
        """The one place in a box at which the sign changes, to the last digit of a double."""
        while a < (middle := 0.5 * (a + b)) < b:
            sign = self._sign(x, middle)
            if not sign:
                return middle
            a, b = (middle, b) if sign == low else (a, middle)
        return a


_SILENT: tuple[float, ...] = (math.nan,)


def _is_not_zero(ball: Any) -> bool:
    return bool(ball > 0 or ball < 0)
