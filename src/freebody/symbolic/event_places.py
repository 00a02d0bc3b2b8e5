"""Where on the way of its one coordinate q a mechanism meets an event F(q) = 0 that is not linear in q: a measure that
closed loops bind, or a wave of the coordinate, has a value. Where everything is driven, q is the time.

    an angle that a loop binds    the loops with the value put in for it, and without the other bound angles:
                                  a cos q + b sin q + d = 0
    anything else                 F with the loops solved for; its zeros are among those of the product of F over both
                                  signs of each of its roots

A zero counts where F itself vanishes at the samples, on the branch on which the loops are assembled, and where F gets
there without a jump: an angle that is a turn off is another place. The first one ahead is the event; that no other one
is passed before is part of what it needs.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import pairwise

from freebody.errors import CannotAnswer, NotReached
from freebody.language.sentences import Message
from freebody.symbolic.closure import Closure
from freebody.symbolic.functions import functions
from freebody.symbolic.model import SymbolicModel
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.signs import Sign, sign_of
from freebody.symbolic.unknowns import Coordinate
from freebody.symbolic.zeros import Indexed, reals, solve_linear, turn_of, zeros_of
from freebody.tolerances import ROUND_OFF

Need = tuple[Ratio, str]

_MOST_TERMS = 300  # of what is looked through for zeros
_TURNS = range(-2, 3)  # by which a place may differ from the formula's
_N_STEPS = 64
_JUMP = 3.0  # between neighbouring steps: less than a turn, more than an angle moves in one
_NEAR = 1e-9


@dataclass(frozen=True)
class Variable:
    """What runs: a coordinate, or the time."""

    index: int
    name: str


@dataclass(frozen=True)
class EventPlace:
    """A zero as a formula, and at every sample; nan where it is none there."""

    at: Ratio
    numbers: tuple[float, ...]


class EventPlaces:
    """The zeros of `value - target` along a variable. closure: the loops of the model."""

    def __init__(self, model: SymbolicModel, closure: Closure, q: Variable, value: Ratio, target: Ratio) -> None:
        self.model, self.closure, self.q = model, closure, q
        self.field = model.field
        self.value, self.target = value, target
        self.gap = self.field.lowest_terms(closure.explicit(self.field.lowest_terms(value - target)))
        if len(self.gap.num) + len(self.gap.denominator().num) > _MOST_TERMS:
            raise CannotAnswer(Message("the event is a formula that is too long to look for its zeros"))

    @property
    def bound(self) -> dict[int, Ratio]:
        """The angle of a loop that the event gives, with its cosine and sine."""
        found = self._bound_angle()
        return {} if found is None else self.closure.put(*found)

    # -- the first one ------------------------------------------------------------------------
    def first(self, start: Ratio, way: int) -> tuple[Ratio, list[Need]]:
        """The place that is met first from a start on, growing (way > 0) or shrinking, and what that needs."""
        begins = self.model.samples.at_starts(start)
        places = self._places(begins)
        picks = {pick for s, begin in enumerate(begins) if (pick := _next(places, s, begin, way)) is not None}
        if not picks:
            why = Message("no closed form was found for the place of {x} at which that is so", x=self.q.name)
            tried = (
                Message("it does not happen at any of the parameter values that were tried")
                if self.q.index == self.field.index(self.field.time)
                else Message(
                    "{x} does not come to such a place at any of the parameter values that were tried", x=self.q.name
                )
            )
            raise NotReached(tried) if self._candidates() else CannotAnswer(why)
        if len(picks) > 1:
            raise CannotAnswer(
                Message("at which place of {x} that is so first depends on the parameter values", x=self.q.name)
            )
        chosen = places[picks.pop()]
        at = self.field.lowest_terms(chosen.at)
        needs = [(x, ">") for x in reals(at)]
        needs += self._on_its_branch(at)
        return at, [*needs, *self._nothing_before(chosen, places, start, begins, way)]

    def _on_its_branch(self, at: Ratio) -> Iterator[Need]:
        """F is zero there, and not one of its kin: p + q r = 0 for a root r needs -p q >= 0, and an angle that a loop
        binds is on the side on which the loop is assembled."""
        f, there = self.field, {self.q.index: at}
        if (bound := self._bound_angle()) is not None:
            angle, value = bound
            there = there | self.closure.put(angle, value)
            others = {d.index for d in self.model.dependent} - {angle.index}
            for side in self.closure.sides:
                if not others & f.ingredients(side):
                    yield f.lowest_terms(f.follow(side, there)), ">"
            return
        for p, q in self._rooted(self._without_turns())[1]:
            yield f.lowest_terms(-f.follow(p * q, there)), ">="

    def is_before(self, start: Ratio, end: Ratio, way: int, *, takes_side: bool = False) -> bool:
        """Whether such a place is met between a start and an end, at every sample at which the end is real; takes_side:
        at the first one, which the way there then needs. Raises CannotAnswer where that differs from one to the
        other."""
        begins, ends = (self.model.samples.at_starts(x) for x in (start, end))
        places = self._places(begins)
        told = list[bool]()
        for s, (begin, last) in enumerate(zip(begins, ends, strict=True)):
            pick = None if math.isnan(last) else _next(places, s, begin, way)
            if not math.isnan(last):
                told.append(pick is not None and way * (last - places[pick].numbers[s]) > -_NEAR)
        if takes_side and told and told[0]:
            return True
        if len(set(told)) > 1:
            raise CannotAnswer(
                Message("at which place of {x} that is so first depends on the parameter values", x=self.q.name)
            )
        return told[0] if told else True

    def _nothing_before(
        self, chosen: EventPlace, places: Sequence[EventPlace], start: Ratio, begins: Sequence[float], way: int
    ) -> Iterator[Need]:
        """start < chosen < all other places but those behind the start, as that is at the first sample at which it is
        ahead; what is known of the nearest ones is known of all, for they repeat in the same order."""
        s = next(k for k, x in enumerate(chosen.numbers) if way * (x - begins[k]) > _NEAR)
        ahead = [p for p in places if p is not chosen and way * (p.numbers[s] - chosen.numbers[s]) > _NEAR]
        behind = [p for p in places if way * (p.numbers[s] - begins[s]) < -_NEAR]
        pairs = [(chosen.at, start)]
        pairs += [(min(ahead, key=lambda p: way * p.numbers[s]).at, chosen.at)] if ahead else []
        pairs += [(start, max(behind, key=lambda p: way * p.numbers[s]).at)] if behind else []
        for later, earlier in pairs:
            gap = self.field.lowest_terms(way * (later - earlier))
            if not self._is_open(gap):
                yield gap, ">"

    def _is_open(self, gap: Ratio) -> bool:
        """Whether a gap that is known not to be negative does not vanish where the zeros are real and apart: that of an
        arc from the end of its range does so at that end only, which is excluded."""
        f, sign = self.field, sign_of(gap)
        arcs = sorted(gap.generators() & f.arguments.keys())
        parts = gap.numerator().coefficients(arcs.pop()) if len(arcs) == 1 else []
        is_of_arc = len(parts) == 2 and (parts[0] / parts[1] / f.pi).fraction() is not None
        return sign.is_strict or (sign is Sign.NONNEGATIVE and is_of_arc)

    # -- all of them --------------------------------------------------------------------------
    def _places(self, begins: Sequence[float]) -> list[EventPlace]:
        """Zeros, and those by whole periods from them, where F vanishes itself."""
        found: list[EventPlace] = []
        for zero in self._candidates():
            period = turn_of(self.gap, self.q.index)
            for n in _TURNS if period is not None else (0,):
                at = zero if period is None else self.field.lowest_terms(zero + n * period)
                numbers = tuple(
                    x if self._is_met(s, begins[s], x) else math.nan
                    for s, x in enumerate(self.model.samples.at_starts(at))
                )
                if not all(map(math.isnan, numbers)) and all(p.numbers != numbers for p in found):
                    found.append(EventPlace(at, numbers))
        return found

    def _is_met(self, s: int, begin: float, at: float) -> bool:
        """Whether F vanishes there, and its way there has no jump."""
        if math.isnan(at) or math.isnan(begin):
            return False
        steps = [begin + (at - begin) * k / _N_STEPS for k in range(_N_STEPS + 1)]
        values = [self.model.samples.at_start_with(self.gap, s, {self.q.index: x}) for x in steps]
        size = 1.0 + max(abs(x) for x in values)
        is_smooth = all(abs(b - a) < _JUMP for a, b in pairwise(values)) or not self._is_angle
        return abs(values[-1]) < ROUND_OFF * size and is_smooth

    @property
    def _is_angle(self) -> bool:
        return bool(self.gap.generators() & (self.field.known_pairs.keys() | self.field.arguments.keys()))

    def _candidates(self) -> list[Ratio]:
        """Zeros of an equation that follows from the event."""
        seeked: Indexed = self.q
        for equation in self._equations():
            zeros = zeros_of(self.model, equation.numerator(), seeked, quadratic=True)
            if zeros:
                return [self.field.lowest_terms(x) for x in zeros]
        return []

    def _equations(self) -> Iterator[Ratio]:
        if (bound := self._bound_angle()) is not None:
            yield from self.closure.without_others(self.q.index, *bound)
        else:
            yield self._rooted(self._without_turns())[0]

    def _without_turns(self) -> Ratio:
        """Of an angle the sine of F, which is made of cosines and sines alone; else F."""
        if not self._is_angle:
            return self.gap
        sine = functions(self.field, self.model.samples.is_negative)["sin"](self.value - self.target)
        return self.closure.explicit(self.field.lowest_terms(sine))

    def _bound_angle(self) -> tuple[Coordinate, Ratio] | None:
        """The bound angle that the event gives a value, and that value."""
        present = self.field.ingredients(self.value)
        bound = [d for d in self.model.dependent if d.index in present]
        if len(bound) != 1 or self.field.pair_of(bound[0].index) is None:
            return None
        at = solve_linear(self.value - self.target, bound[0].index)
        if at is None or self.q.index in self.field.ingredients(at):
            return None
        return bound[0], self.field.lowest_terms(at)

    def _rooted(self, x: Ratio) -> tuple[Ratio, list[tuple[Ratio, Ratio]]]:
        """The product over both signs of every root that runs with the variable, the outer ones first; and of each step
        p + q r the p and the q."""
        f, steps = self.field, list[tuple[Ratio, Ratio]]()
        kinds = ((g, f.generators[g]) for g in sorted(x.generators(), reverse=True))
        roots = [g for g, generator in kinds if generator.kind == "root" and self.q.index in generator.made_of]
        x = x.numerator()
        for index in roots:
            p, q = (*x.coefficients(index), f.zero)[:2]
            if q.is_zero():
                continue
            steps.append((p, q))
            x = f.lowest_terms(p * p - q * q * f.radicand(index)).numerator()
            if len(x.num) > _MOST_TERMS:
                raise CannotAnswer(Message("the event is a formula that is too long to look for its zeros"))
        return x, steps


def _next(places: Sequence[EventPlace], s: int, begin: float, way: int) -> int | None:
    """Which place is next from a number on, at one sample."""
    ahead = [(way * (p.numbers[s] - begin), k) for k, p in enumerate(places) if way * (p.numbers[s] - begin) > _NEAR]
    return min(ahead)[1] if ahead else None
