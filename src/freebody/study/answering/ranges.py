"""All values of a parameter for which an inequality holds: between the zeros, poles and limits of a formula.

The formula can change its side only where it vanishes, has no value, or stops being true. All these places are found in
closed form, at the model's own numbers they have an order, and between two of them one value tells. The order is a
condition of the answer; at other random numbers that keep to it the same values must come out, and inside of each
interval the quantity is compared with the numeric route.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from contextlib import suppress
from functools import cached_property
from itertools import pairwise, product
from typing import Any

from freebody.errors import CannotAnswer
from freebody.language.expression import Symbol
from freebody.language.notation import compared, joined, reworded, to_text
from freebody.language.sentences import Message
from freebody.questions.base import Wanted
from freebody.questions.happening import Happening, Lasting
from freebody.questions.reading import Question
from freebody.questions.turned_round import REACHED, SO
from freebody.study.answering.answer import Evidence
from freebody.study.answering.conditions import real
from freebody.study.answering.draws import Draw
from freebody.study.answering.finding import Finding
from freebody.study.answering.formula import Formula
from freebody.study.answering.parameter_domain import above, after, domain_of, for_every
from freebody.study.answering.range_evidence import OtherEnds, RangeEvidence
from freebody.study.answering.range_truth import End, Interval, NotKnown, TruthInNumbers, with_ends
from freebody.study.answering.turned_round import NoneFound, without_roots
from freebody.study.setup import N_MORE, Setup
from freebody.symbolic.conditions import Condition, insisted
from freebody.symbolic.parameter_roots import solutions
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.signs import Sign, sign_of
from freebody.symbolic.tidy import tidy
from freebody.symbolic.validity import MOVING
from freebody.symbolic.zeros import zeros_of

_SAME = 1e-9  # of their size: two ends that are one
_ONE_SIDE = 12  # draws that are looked at where only some are on the one side of a border, each time
_MOST_TWINS = 2  # of ends that coincide
_NEAR = 1e-4  # of the way to the next place: what is seen so near to an end is so up to it
_OPEN = CannotAnswer(Message("where that holds has ends for which no closed form was found"))
_MOST_SHIFTS = range(-1, 2)  # whole turns by which an angle may differ from that of a formula


def find_range(setup: Setup, question: Question, formulas: Sequence[Formula]) -> Finding:
    """The ends of the values for which the question's inequality holds. Raises CannotAnswer where they have no closed
    form, NoneFound where there is no such value."""
    wanted = question.quantity.wanted
    assert wanted is not None
    return RangeSearch(setup, question, wanted, formulas).finding()


class RangeSearch(TruthInNumbers):
    """Where the truth can change, and what it is in between."""

    def __init__(
        self,
        setup: Setup,
        question: Question,
        wanted: Wanted,
        formulas: Sequence[Formula],
        *,
        within_a_turn: bool = False,
    ) -> None:
        """within_a_turn: whether of an angle, of which only sines and cosines count, one turn is meant."""
        super().__init__(setup, question, wanted, formulas)
        self._within_a_turn = within_a_turn
        self._twins: list[tuple[Ratio, Ratio]] = []  # ends that coincide, where they were looked at last
        self._below: list[Ratio] = []  # those that are negative there
        self._not_real: list[Ratio] = []  # those that have no value there
        self._is_one_end = False  # whether at other numbers only the end is the same that is asked for
        self._on_border: list[Ratio] = []  # those that are zero there, of what is positive
        self._unknown: list[Interval] = []  # where no case tells there whether it is so
        self._placed: list[Ratio] = []  # all ends within the range of the parameter, where they were looked at last

    # -- where it can change ------------------------------------------------------------------
    def domain(self) -> tuple[float, float]:
        low, high = super().domain()
        if not self._within_a_turn or self.parameter.acute or not self.parameter.is_angle:
            return low, high
        elements = [x for t in self.truths for x in (t.element, *(c.element for c in t.conditions)) if x is not None]
        if any(self.index in x.generators() for x in elements):
            return low, high
        return (-math.pi, math.pi) if self.parameter.sign == "any" else (0.0, math.tau)

    @cached_property
    def ends(self) -> list[Ratio]:
        """Every place at which the truth can change, as formulas."""
        found: list[Ratio] = []
        for truth in self.truths:
            elements = [c.element for c in truth.conditions]
            elements += [] if truth.element is None else [truth.element, *(c.element for c in real(truth.element))]
            for x in elements:
                for place in (*self._places(x.numerator()), *self._places(x.denominator())):
                    if all(place != other for other in found):
                        found.append(place)
        return found

    def _places(self, x: Ratio) -> Iterator[Ratio]:
        """Where an element vanishes. Raises CannotAnswer where that has no closed form."""
        f = self.field
        if self.index not in f.ingredients(x):
            return
        equation, _one_side = without_roots(x, self.index)
        for base, _exponent in f.factor(equation.num)[1]:
            if self.index not in f.ingredients(base) or _has_one_sign(base, self.index):
                continue
            places = zeros_of(self.model, base, self, quadratic=True)
            places = places or [values[self.index] for values in solutions(f, base, self.index)]
            powers = base.coefficients(self.index)
            is_alone = all(part.is_zero() for part in powers[1:-1])  # one power: its roots are all among the places
            degree = 1 if is_alone else len(powers) - 1
            made = [g for g in base.generators() if self.index in f.generators[g].made_of]
            if not places:
                zero = compared(tidy(base), "=", tidy(f.zero))
                why = Message(
                    "the equation {equation} is not solved for {name} in closed form",
                    equation=zero,
                    name=self.parameter.name,
                )
                raise CannotAnswer(reworded(why, zero))
            if not made and degree > max(2, len(places)):
                raise CannotAnswer(Message("the ends are roots of a polynomial of degree {n}", n=degree))
            for place in places:
                place = f.lowest_terms(place)
                if self.index in f.ingredients(place):
                    continue
                yield from self._with_turns(place) if made and self.parameter.is_angle else (place,)

    def _with_turns(self, place: Ratio) -> Iterator[Ratio]:
        yield place
        if not self.parameter.acute:
            yield from (place + n * self.field.pi for n in _MOST_SHIFTS if n)

    # -- what the formulas say between the ends -----------------------------------------------
    def true_at(self, draw: Draw, value: float) -> list[int]:
        """The numbers of the formulas that are true, their relation aside, for a value of the parameter."""
        here = self.with_value(self.numbers_of(draw), value)
        return [
            k
            for k, truth in enumerate(self.truths)
            if all(self.is_so(c.element, c.relation, here, at_end=True) for c in truth.conditions)
        ]

    def values_at(self, draw: Draw, value: float, formulas: Sequence[Formula]) -> list[float]:
        """What formulas are worth for a value of the parameter; those that have a value."""
        here = self.with_value(self.numbers_of(draw), value)
        found = [self.value_of(f.element, here)[0] for f in formulas if isinstance(f.element, Ratio)]
        return [x for x in found if not math.isnan(x)]

    def values_between(self, draw: Draw, formulas: Sequence[Formula]) -> Iterator[float]:
        """What the formulas are worth that are true, at places between all ends."""
        numbers, (low, high) = self.numbers_of(draw), self.domain()
        placed = sorted(x for end in self.ends if low < (x := self.value_of(end, numbers)[0]) < high)
        for a, b in pairwise([low, *placed, high]):
            for value in self.places_between(a, b):
                yield from self.values_at(draw, value, [formulas[k] for k in self.true_at(draw, value)])

    # -- the intervals ------------------------------------------------------------------------
    def intervals(self, draw: Draw) -> list[Interval]:
        """At the numbers of a draw."""
        ends = self.ends  # first: numbers are those of all that there is by now
        numbers, (low, high) = self.numbers_of(draw), self.domain()
        placed: list[tuple[float, Ratio]] = []
        border: list[Ratio] = []
        twins: list[tuple[Ratio, Ratio]] = []
        for end in ends:
            value, size = self.value_of(end, numbers)
            if low == 0.0 and abs(value) <= _SAME * size:
                border.append(end)
                continue
            is_new = all(abs(value - other) > _SAME * max(abs(value), abs(other)) for other, _e in placed)
            if math.isfinite(value) and low < value < high:
                if is_new:
                    placed.append((value, end))
                else:
                    twin = min(placed, key=lambda pair: abs(pair[0] - value))
                    twins.append((twin[1], end))
        placed.sort(key=lambda pair: pair[0])
        self._twins, self._on_border = twins, border
        self._below = [end for end in ends if low == 0.0 and self.value_of(end, numbers)[0] < 0.0]
        self._not_real = [end for end in ends if math.isnan(self.value_of(end, numbers)[0])]
        self._placed = [end for _value, end in placed]
        values = [low, *(value for value, _end in placed), high]
        told = [self._between(numbers, a, b, draw) for a, b in pairwise(values)]
        inside = self._known(told, [end for _value, end in placed])
        is_at = [self.is_true(numbers, value, at_end=True) for value, _end in placed]
        at_low = self.parameter.sign == "nonnegative" and self.is_true(numbers, 0.0, at_end=True)
        found: list[Interval] = []
        begun = End(None, at_low) if inside[0] else None
        for k, (_value, end) in enumerate(placed):
            before, after = inside[k], inside[k + 1]
            if before == after and not is_at[k] and (before or self._may_be_one_value):
                is_at[k] = self._is_seen(placed[k][0], draw)
            if before and begun is not None and not (after and is_at[k]):
                found.append((begun, End(end, is_at[k])))
                begun = None
            if after and begun is None:
                begun = End(end, is_at[k])
            elif is_at[k] and not before and not after:
                found.append((End(end, True), End(end, True)))
        if begun is not None:
            found.append((begun, End(None, False)))
        return found

    @property
    def _may_be_one_value(self) -> bool:
        """Whether it may be so of a single value: of a ball that is struck so that it rolls at once, and on."""
        of = self.wanted.of
        return isinstance(of, Happening) and (of.at_once or isinstance(of.what, Lasting)) and of.is_so

    def _is_seen(self, value: float, draw: Draw) -> bool:
        """Whether it is so just on the border of two cases, in both of which it is, or is not: by the numeric route."""
        return self.wanted.relation in (REACHED, SO) and bool(self.seen(value, draw))

    def _near_ends(self, a: float, b: float, places: Sequence[float]) -> Iterator[float]:
        """Places just beside the finite ends of an interval, but that of the domain: a motion that hardly begins is not
        followed to its end."""
        if math.isfinite(a) and a != self.domain()[0]:
            yield a + _NEAR * (min(places) - a)
        if math.isfinite(b) and b != self.domain()[1]:
            yield b - _NEAR * (b - max(places))

    def _between(self, numbers: Mapping[int, Any], a: float, b: float, draw: Draw) -> bool | NotKnown:
        """Whether it holds between two ends. Raises CannotAnswer where it does so at some places only."""
        seen = set[bool]()
        was_seen, self.is_seen_in_numbers = self.is_seen_in_numbers, False
        places = self.places_between(a, b)
        try:
            seen |= {self.is_true(numbers, value, draw=draw) for value in places}
            if self.is_seen_in_numbers:  # then it may change where no formula vanishes, near to the ends as well
                seen |= {self.is_true(numbers, value, draw=draw) for value in self._near_ends(a, b, places)}
        except NotKnown as error:
            return error
        finally:
            self.is_seen_in_numbers |= was_seen
        if len(seen) > 1:
            raise CannotAnswer(Message("where that holds has ends for which no closed form was found"))
        return seen.pop()

    def _known(self, told: Sequence[bool | NotKnown], placed: Sequence[Ratio]) -> list[bool]:
        """Where it is so, as far as that is known. Raises NotKnown where an end that is asked for would lie between
        what is so and what is not known."""
        self._unknown = []
        ends = [None, *placed, None]
        so = [k for k, own in enumerate(told) if own is True]
        beside = {"least": so[:1], "largest": so[-1:]}.get(self.wanted.end, so)
        sides = {"least": (1,), "largest": (-1,)}.get(
            self.wanted.end, (1, -1)
        )  # on which it is not known, of what is so
        for k, own in enumerate(told):
            if not isinstance(own, NotKnown):
                continue
            if not so or any(k + side in beside for side in sides):
                raise own
            goes_on = k > 0 and isinstance(told[k - 1], NotKnown)
            begun = self._unknown.pop()[0] if goes_on else End(ends[k], k > 0)
            self._unknown.append((begun, End(ends[k + 1], k + 2 < len(ends))))
        return [own is True for own in told]

    # -- the answer ---------------------------------------------------------------------------
    def finding(self) -> Finding:
        own, name = self.setup.draws[0], self.parameter.name
        if self._is_of_motion_alone():
            raise CannotAnswer(Message("that does not depend on {name}", name=name))
        found = self.intervals(own)
        unknown = list(self._unknown)
        if not found:
            raise NoneFound(Message("no value of {name} within its range was found for which that is so", name=name))
        if len(found) == 1 and found[0][0].value is None and found[0][1].value is None:
            raise CannotAnswer(self._for_every())
        found, conditions, evidence = self._confirmed(found)
        element, notes = self._asked(found), list[str]()
        told = joined([self._told(interval) for interval in found], " or ")
        so = Message("this holds for {range}", range=told)
        if self._is_one_end:
            so = Message(
                "this holds for {range} with the given numbers: at others there may be other ends beside", range=told
            )
        notes.append(reworded(so, told))
        for interval in unknown:
            where = self._told(interval)
            notes.append(reworded(Message("for {range} it is not known what happens", range=where), where))
        for formula in self.left_aside:
            shown = to_text(tidy(self.field.element(formula.element)))  # pyrefly: ignore[bad-argument-type]
            told = Message("the value {value} does not depend on {name} and is left aside", value=shown, name=name)
            notes.append(reworded(told, shown))
        if any(truth.formula.in_numbers is not None for truth in self.truths) and any(
            end.value is not None and not end.is_in for interval in found for end in interval
        ):
            notes.append(Message("the end itself is the limit between two cases, and is not decided here"))
        says = list[str]()
        if self.is_seen_in_numbers:  # which other ends there may be at other numbers, no formula says
            says.append(Message("near the given numbers: at others other ends may count"))
            notes.append(
                Message(
                    "for some values of {name} no case has formulas: whether it is so there was looked at in numbers",
                    name=name,
                )
            )
        if self.parameter.value is not None:
            notes.append(Message("the number given for {name} is not used", name=name))
        return Finding(element, evidence, conditions, notes, says, has_value=self.setup.has_values, is_complete=True)

    def _for_every(self) -> str:
        """That no value of the parameter is excepted: of all numbers only where no end is left that others may move."""
        told = for_every(self.setup.system, self.parameter, self.question.text)
        if not self.ends:
            return told
        where = Message("with the given numbers")
        if any(x.field.generators[g].kind in MOVING for x in self.ends for g in x.field.ingredients(x)):
            where = Message("with the given numbers at the start")
        if len(self._below) != 1:
            return Message("{where} {told}", where=where, told=told)
        end = to_text(tidy(self._below[0]))
        why = Message("{where} {told}: the end of the range, {end}, is negative", where=where, told=told, end=end)
        return reworded(why, end)

    def _confirmed(self, found: list[Interval]) -> tuple[list[Interval], list[Condition], Evidence]:
        """The intervals with what they need. Of ends that coincide at the model's own numbers, as those of a linkage
        with two links of one length, either may count at others: for the one side of the border, then."""
        # intervals at other numbers have others
        twins, before, below = list(self._twins), list(self._placed), list(self._below)
        without = list(self._not_real)
        needed = self._order(found, before)
        needed += insisted((Condition(-end, ">=", Message("which end is which")) for end in self._on_border), _OPEN)
        if self.wanted.of.scope == "linkage":  # ends of no positive length need not be so at other numbers
            outside = (Condition(-end, ">=", Message("which end is which")) for end in self._below)
            needed += insisted(outside, _OPEN)
        if not twins:
            n_more = _ONE_SIDE if below else N_MORE
            try:
                return found, needed, RangeEvidence(self, self.intervals, n_more).of(found, needed)
            except OtherEnds:
                with suppress(CannotAnswer):
                    return self._one_end(found, before)
                # where all places keep their order, those that end no interval here among them
                kept = [*needed, *self._all_in_order(before, below, without)]
                return found, kept, RangeEvidence(self, self.intervals, _ONE_SIDE).of(found, kept)
        for choice in product((False, True), repeat=2 * min(len(twins), _MOST_TWINS)):
            swaps, ways = choice[::2], choice[1::2]
            pairs = [(b, a) if swap else (a, b) for (a, b), swap in zip(twins, swaps, strict=False)]
            others = {b.key(): a for (a, b), swap in zip(pairs, swaps, strict=True) if swap}
            chosen = with_ends(found, others)
            sides = (after(a, b) if way else after(b, a) for (a, b), way in zip(pairs, ways, strict=True))
            both = {a.key(): b for a, b in twins} | {b.key(): a for a, b in twins}
            placed = [both.get(end.key(), end) for end in before]
            conditions = [*self._order(chosen, placed), *needed]  # either of them among the others
            conditions += insisted((Condition(x, ">=", Message("which end is which")) for x in sides), _OPEN)
            with suppress(CannotAnswer):
                return chosen, conditions, RangeEvidence(self, self.intervals, _ONE_SIDE).of(chosen, conditions)
        ends = ", ".join(to_text(tidy(end)) for pair in twins for end in pair)
        told = Message("{ends} coincide at the given numbers, and which of them ends the range is not told", ends=ends)
        raise CannotAnswer(told)

    def _one_end(
        self, found: list[Interval], placed: Sequence[Ratio]
    ) -> tuple[list[Interval], list[Condition], Evidence]:
        """With what the end needs that alone is asked for: whichever others there are beside it at other numbers.
        Raises CannotAnswer where it is another one there, or all are asked for."""
        if not self.wanted.end:
            raise OtherEnds(Message("which ends count depends on more than could be told in formulas"))
        is_least = self.wanted.end == "least"
        end = (found[0][0] if is_least else found[-1][1]).value
        ends = [] if end is None else [end]
        if end is not None and self.wanted.of.is_verdict:  # those beyond stay beyond: before it they might count
            k = next(k for k, other in enumerate(placed) if other == end)
            ends = list(placed[: k + 1] if is_least else placed[k:])
        needed = self._needs(ends)
        evidence = RangeEvidence(self, self.intervals, _ONE_SIDE, only=self.wanted.end).of(found, needed)
        self._is_one_end = True
        return found, needed, evidence

    def _all_in_order(
        self, placed: Sequence[Ratio], below: Sequence[Ratio], without: Sequence[Ratio]
    ) -> list[Condition]:
        """That all places at which the truth can change are as they are at the model's own numbers. without: those that
        have no value there."""
        ordered = [Condition(after(a, b), ">", Message("which end is which")) for a, b in pairwise(placed)]
        outside = [Condition(-above(end), ">=", Message("which end is which")) for end in below]
        for end in without:
            missed = [c for c in real(end) if c.relation in (">", ">=")]
            if len(missed) == 1:  # of several it may be either
                strict = missed[0].relation == ">="
                outside.append(Condition(-missed[0].element, ">" if strict else ">=", Message("which end is which")))
        return insisted([*ordered, *outside], _OPEN)

    def _is_of_motion_alone(self) -> bool:
        """Whether what moves stands in the formulas, and the parameter in none: it may be one of the start, which then
        says nothing of other motions."""
        elements = [x for t in self.truths for x in (t.element, *(c.element for c in t.conditions)) if x is not None]
        inside = set[int]().union(*map(self.field.ingredients, elements))
        return self.index not in inside and bool(inside & self.model.moving)

    def _asked(self, found: Sequence[Interval]) -> Ratio | tuple[Ratio, ...]:
        """All ends, or the one that is asked for."""
        if self.wanted.end:
            end = found[0][0] if self.wanted.end == "least" else found[-1][1]
            if end.value is None:
                raise CannotAnswer(self._without_end(len(found) > 1))
            return end.value
        ends = [end.value for interval in found for end in interval if end.value is not None]
        ends = [x for k, x in enumerate(ends) if all(x != other for other in ends[:k])]
        return ends[0] if len(ends) == 1 else tuple(ends)

    def _without_end(self, has_gaps: bool) -> str:
        """has_gaps: whether it is so in several intervals."""
        name = self.parameter.name
        if self.wanted.end == "least" and has_gaps:
            return Message(
                "there is no least value: it is so for all small ones, not for those that follow, and again beyond; "
                "ask for the range of {name}",
                name=name,
            )
        if self.wanted.end == "least":
            return Message("there is no least value: it is so for all small ones")
        if has_gaps:
            return Message(
                "there is no largest value: it is so for the largest ones, not for all below, and again for smaller "
                "ones; ask for the range of {name}",
                name=name,
            )
        if self.parameter.acute:
            return Message("there is no largest value: it is so for all acute angles up to 90°")
        if self.parameter.is_share:
            return Message("there is no largest value: it is so for all up to 1")
        return Message("there is no largest value: it is so for all large ones")

    def _told(self, interval: Interval) -> str:
        """An interval as inequalities of the parameter."""
        (low, high), name = interval, Symbol(self.parameter.name)
        if low.value is not None and high.value is not None and low.value == high.value:
            return compared(name, "=", tidy(low.value))
        sides: list[str] = []
        if low.value is not None:
            sides.append(compared(name, ">=" if low.is_in else ">", tidy(low.value)))
        if high.value is not None:
            sides.append(compared(name, "<=" if high.is_in else "<", tidy(high.value)))
        elif self.parameter.acute:
            sides.append(compared(name, "<", tidy(self.field.pi / 2)))
        return joined(sides)

    def _order(self, found: Sequence[Interval], placed: Sequence[Ratio]) -> list[Condition]:
        """That the ends are real, within the range of the parameter, and in this order."""
        ends = [end.value for interval in found for end in interval if end.value is not None]
        if self.wanted.of.is_verdict:  # the others have their places as well: in another order others may count
            ends = list(placed)
        return self._needs(ends)

    def _needs(self, ends: Sequence[Ratio]) -> list[Condition]:
        """The same, of ends in their order."""
        needs = [c for end in ends for c in real(end)]
        for end in (*ends[:1], *ends[-1:]):
            needs += domain_of(self.parameter, end)
        needs += [Condition(after(a, b), ">", Message("which end is which")) for a, b in pairwise(ends) if a != b]
        numbers = self.numbers_of(self.setup.draws[0])
        for truth in self.truths:  # what does not depend on the parameter, and holds here
            free = [c for c in truth.conditions if self.index not in self.field.ingredients(c.element)]
            needs += [c for c in free if self.is_so(c.element, c.relation, numbers, True)]
        return insisted(needs, CannotAnswer(Message("where that holds has ends for which no closed form was found")))


def _has_one_sign(x: Ratio, index: int) -> bool:
    """Whether an element vanishes for no value of a parameter P: a P^2 + b P + c, or the same of P^2, where
    b^2 < 4 a c."""
    if sign_of(x).is_strict:
        return True
    powers = x.coefficients(index) if index in x.generators() else []
    is_even = len(powers) == 5 and powers[1].is_zero() and powers[3].is_zero()
    powers = powers[::2] if is_even else powers
    if len(powers) != 3 or any(index in x.field.ingredients(part) for part in powers):
        return False
    c, b, a = powers
    return sign_of(b * b - 4 * a * c) is Sign.NEGATIVE
