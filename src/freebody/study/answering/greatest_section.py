"""Where a rod is loaded most, in closed form: which place governs is told by the given numbers, and what it takes for
that is a condition.

In each span the slope of the quantity changes its sign once, or keeps it: its coefficients in Bernstein's base are of
one sign then, and both ends are all there is to look at. See `questions.greatest_section`.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from itertools import pairwise
from typing import Any

from freebody.errors import CannotAnswer
from freebody.language.expression import add, free_symbols
from freebody.language.notation import to_text
from freebody.language.sentences import Message
from freebody.questions.greatest_section import GreatestInRod, Span, only_zero, root_of
from freebody.questions.reading import Question
from freebody.questions.section import Order, SectionForce, Side
from freebody.study.answering import evidence as proof
from freebody.study.answering.crosscheck import element_at
from freebody.study.answering.finding import Finding
from freebody.study.setup import Setup
from freebody.symbolic.conditions import Condition, require
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.state import SymbolicState
from freebody.symbolic.tidy import tidy
from freebody.tolerances import ROUNDED

_GREATEST = Message("it is greatest there")
_ZERO = Message("the shear force is zero there alone")
_NO_MOMENT = Message("the bending moment is zero there alone")
_TWICE = Message("it is extreme more than once between two places at which something acts")
_TWICE_ZERO = Message("it is zero twice, or nowhere, between two places at which something acts")
_EVEN = Message("which of several places governs depends on the numbers, and not all of them are given")


@dataclass(frozen=True)
class _Candidate:
    """A place at which it may be greatest, and how much it is there."""

    value: Ratio
    at: Ratio
    among: tuple[int, ...]  # which of the places at which something acts it is, or between which two
    side: Side = ""  # of that place


def find(setup: Setup, question: Question, q: GreatestInRod, state: SymbolicState) -> Finding:
    """The size that governs, or its place, with the inequalities for it. Raises CannotAnswer."""
    return _Search(setup, question, q, state).found()


def governing(
    setup: Setup, question: Question, q: GreatestInRod, state: SymbolicState
) -> tuple[SectionForce, list[Condition]]:
    """What is transmitted where the rod is loaded most, counted so that it is positive, and what it takes for that.
    Raises CannotAnswer."""
    search = _Search(setup, question, q, state)
    return search.governing(), search.conditions


class _Search:
    def __init__(self, setup: Setup, question: Question, q: GreatestInRod, state: SymbolicState) -> None:
        self.setup, self.question, self.q, self.state = setup, question, q, state
        draw = setup.draws[0]
        self._draw, self._start = draw, draw.seen(draw.start())

    def found(self) -> Finding:
        if self.q.asks == "zero":
            return self._zero()
        q, candidates, k, conditions = self.q, self._candidates, self._k, self.conditions
        size = self._size
        if conditions and not self.setup.has_values:
            raise CannotAnswer(_EVEN)
        x = size if q.asks == "size" else candidates[k].at
        evidence = proof.at_instants(
            self.setup,
            self.question.text,
            q,
            x,
            at_start=self.question.at_start,
            sides=[c.element for c in conditions],
        )
        told = Message("at {x} from {body}.start", x=_length(candidates[k].at), body=q.body)
        if q.asks == "place":
            told = Message("it is {x} there", x=to_text(tidy(size)))
        return Finding(x, evidence, conditions, notes=[told, *self._elsewhere(candidates, k)])

    def _zero(self) -> Finding:
        """The place at which the shear force or the bending moment goes through zero: within a span, or where a load
        acts."""
        q = self.q
        spans = [self._tidied(x) for x in q.spans(self.setup.system, self.state, self._order)]
        places, needed = list[Ratio](), self._in_order(self._order)
        for k, span in enumerate(spans):
            roots, conditions = self._roots(self._shortened(q.along(span)))
            places += [self._element(span.start + span.length * root) for root in roots]
            needed += conditions
            if k:
                border = q.at_border(spans[k - 1], span)
                sides = [_sign(x, n, 0.0) for x, n in zip(border, self._numbers([*border]), strict=True)]
                needed += [Condition(side * x, ">", "") for side, x in zip(sides, border, strict=True) if side]
                places += [span.start] if {*sides} == {-1, 1} else []
        x = only_zero(q, places)
        conditions = self._open([replace(c, purpose=_ZERO if q.part == "shear" else _NO_MOMENT) for c in needed])
        if conditions and not self.setup.has_values:
            raise CannotAnswer(_EVEN)
        told = [c.element for c in conditions]
        at_start = self.question.at_start
        evidence = proof.at_instants(self.setup, self.question.text, q, x, at_start=at_start, sides=told)
        return Finding(x, evidence, conditions)

    @cached_property
    def conditions(self) -> list[Condition]:
        """What is not so for all admissible parameters."""
        size, needed = self._size, [*self._needed]
        for other in self._candidates:
            needed += [Condition(size - other.value, ">=", _GREATEST), Condition(size + other.value, ">=", _GREATEST)]
        return self._open(needed)

    @property
    def _size(self) -> Ratio:
        value = self._candidates[self._k].value
        return value * self._side(value)

    def governing(self) -> SectionForce:
        one = self._candidates[self._k]
        along = tidy(one.at)
        places, order = one.among, self._order
        if len(places) == 1:  # a place at which something acts, and the side on which it is greatest
            offset = order[places[0]][0]
        else:
            offset = add(along, self.setup.system.bodies[self.q.body].points["start"][0])
            order = (*order[: places[1]], (offset,), *order[places[1] :])
        cut = SectionForce(self.q.body, self.q.part, offset, str(along), self.q.fields, order=order, side=one.side)
        return replace(cut, along=along, is_governing=True, is_reversed=self._side(one.value) < 0)

    @cached_property
    def _order(self) -> Order:
        return self.q.places(self.setup.system, self._start)

    @cached_property
    def _k(self) -> int:
        """Which of the candidates governs at the given numbers: the first one of the greatest size."""
        sizes = [abs(x) for x in self._numbers([c.value for c in self._candidates])]
        return next(k for k, size in enumerate(sizes) if size >= max(sizes) * (1.0 - ROUNDED))

    @property
    def _candidates(self) -> list[_Candidate]:
        return self._looked_at[0]

    @property
    def _needed(self) -> list[Condition]:
        return self._looked_at[1]

    @cached_property
    def _looked_at(self) -> tuple[list[_Candidate], list[Condition]]:
        needed, candidates = self._in_order(self._order), list[_Candidate]()
        for k, found in enumerate(self.q.spans(self.setup.system, self.state, self._order)):
            span = self._tidied(found)
            own, conditions = self._within(span, k)
            end = self._element(span.start + span.length)
            candidates += [_Candidate(span.ends[0], span.start, (k,), "behind"), *own]
            candidates.append(_Candidate(span.ends[1], end, (k + 1,), "before"))
            needed += conditions
        return candidates, needed

    def _in_order(self, order: Order) -> list[Condition]:
        """That the places follow one another as they do at the given numbers."""
        along = [[self._element(self.state.scalar(place)) for place in same] for same in order]
        if any(not (x - same[0]).is_zero() for same in along for x in same[1:]):
            raise CannotAnswer(Message("two places at which something acts are the same at the given numbers alone"))
        return [Condition(b[0] - a[0], ">", _GREATEST) for a, b in pairwise(along)]

    def _elsewhere(self, candidates: list[_Candidate], k: int) -> list[str]:
        """Other places at which it is as great, whatever the parameters are."""
        size, x = candidates[k].value, candidates[k].at
        alike = [c for c in candidates if (c.value - size).is_zero() or (c.value + size).is_zero()]
        places = dict.fromkeys(_length(c.at) for c in alike if not (c.at - x).is_zero())
        if size.is_zero() or not places:
            return []
        return [Message("as great at {places} from {body}.start", places=", ".join(places), body=self.q.body)]

    def _within(self, span: Span, k: int) -> tuple[list[_Candidate], list[Condition]]:
        """Where it is extreme within a span, and without what it is so there alone."""
        roots, conditions = self._roots(self._shortened(span.slopes))
        found = [[self._element(x) for x in span.extreme(root)] for root in roots]
        return [_Candidate(value, at, (k, k + 1)) for value, at in found], conditions

    def _roots(self, d: list[Ratio]) -> tuple[list[Ratio], list[Condition]]:
        """Where something changes its sign within a span, by its coefficients, and without what it does so there
        alone."""
        if all(x.is_zero() for x in d):
            return [], []
        numbers = self._numbers(d)
        near = max(map(abs, numbers)) * ROUNDED
        sides = [_sign(x, n, near) for x, n in zip(d, numbers, strict=True)]
        if None in sides:
            raise CannotAnswer(Message("at the given numbers it is extreme just where something acts"))
        signs = {side for side in sides if side}
        if len(signs) == 1:
            (side,) = signs
            return [], [Condition(side * x, ">=", _GREATEST) for x in d if not x.is_zero()]
        first, last = sides[0], sides[-1]
        if not first or not last or first == last:
            raise CannotAnswer(_TWICE_ZERO if self.q.asks == "zero" else _TWICE)
        root = self._element(root_of(d, first, self.state.sqrt))
        return [root], [Condition(first * d[0], ">", _GREATEST), Condition(last * d[-1], ">", _GREATEST)]

    def _shortened(self, coefficients: Sequence[Any]) -> list[Ratio]:
        """Without a factor s or 1 - s where it vanishes at an end, and without a quadratic term that is zero."""
        d = [self._element(x) for x in coefficients]
        if len(d) == 3 and (d[0] + d[2] - 2 * d[1]).is_zero():
            return [d[0], d[2]]
        if len(d) == 3 and d[2].is_zero():
            return [d[0], 2 * d[1]]
        if len(d) == 3 and d[0].is_zero():
            return [2 * d[1], d[2]]
        return d

    def _open(self, needed: list[Condition]) -> list[Condition]:
        """What is not so for all admissible parameters, each once."""
        found: dict[tuple[str, str], Condition] = {}
        for c in needed:
            condition, _possible = require(self._element(c.element), c.relation, c.purpose)
            if condition is not None:
                found.setdefault((str(tidy(condition.element)), condition.relation), condition)
        return list(found.values())

    def _tidied(self, span: Span) -> Span:
        first, last = map(self._element, span.ends)
        b_0, b_1, b_2 = map(self._element, span.bernstein)
        return Span(
            self._element(span.start), self._element(span.length), (first, last), (b_0, b_1, b_2), span.is_moment
        )

    def _element(self, x: Any) -> Ratio:
        f = self.setup.model.field
        return f.lowest_terms(f.element(x))

    def _side(self, x: Ratio) -> int:
        return -1 if self._numbers([x])[0] < 0.0 else 1

    def _numbers(self, elements: list[Ratio]) -> tuple[float, ...]:
        return element_at(self.setup, tuple(elements), self._draw, self._draw.start())


def _sign(x: Ratio, at: float, near: float) -> int | None:
    """Of what has a value at the given numbers; None where round-off decides it."""
    if x.is_zero():
        return 0
    return None if abs(at) <= near else 1 if at > 0.0 else -1


def _length(x: Ratio) -> str:
    """A place along a rod; a number is one in metres."""
    tidied = tidy(x)
    return to_text(tidied) if free_symbols(tidied) else f"{to_text(tidied)} m"
