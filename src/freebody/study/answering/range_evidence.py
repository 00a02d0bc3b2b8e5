"""The evidence of a range: values inside of every interval, for a verdict outside too, by the numeric route."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import suppress
from typing import Any

from freebody.errors import CannotAnswer
from freebody.language.sentences import Message
from freebody.questions.turned_round import SO
from freebody.study.answering.answer import Evidence
from freebody.study.answering.crosscheck import (
    INSTANT_TOLERANCE,
    MIN_DRAWS,
    MOTION_TOLERANCE,
    CrossCheck,
    TooLittleCompared,
    element_at,
)
from freebody.study.answering.draws import Draw
from freebody.study.answering.magnitude import magnitude
from freebody.study.answering.range_truth import Interval, TruthInNumbers, keys_of
from freebody.study.answering.turned_round import (
    PutBack,
    instant_of,
    quantity_with,
)
from freebody.study.setup import N_MORE
from freebody.symbolic.conditions import Condition
from freebody.symbolic.ratio import Ratio


class OtherEnds(CannotAnswer):
    """At other numbers that keep to the conditions other ends count."""


class RangeEvidence:
    """Compares the intervals of one search."""

    def __init__(
        self,
        truth: TruthInNumbers,
        intervals: Callable[[Draw], list[Interval]],
        n_more: int = N_MORE,
        only: str = "",
    ) -> None:
        """intervals: those at the numbers of a draw; n_more: draws of each kind beside the first ones; only: the end
        that is to be the same at all of them, "least" or "largest", where that alone is asked for; else all are."""
        self.truth, self.intervals, self.n_more, self.only = truth, intervals, n_more, only

    def of(self, found: Sequence[Interval], conditions: Sequence[Condition]) -> Evidence:
        """The quantity inside of every interval is compared with the numeric route; and at other numbers that keep to
        the conditions the same ends come out, or the same one. Raises OtherEnds where they do not."""
        by_event = self.truth.question.event is not None
        is_verdict = self.truth.wanted.relation == SO
        route = (
            Message("values inside and outside of the range put in for the parameter, each looked at in numbers")
            if is_verdict
            else Message("values inside of the range put in for the parameter, each by the numeric route")
        )
        check = CrossCheck(self.truth.question.text, route, MOTION_TOLERANCE if by_event else INSTANT_TOLERANCE)
        keys = self._keys(found)

        def compare(item: tuple[int, Draw]) -> None:
            # the same ends at these numbers, and what is inside and outside of them
            k, draw = item
            numbers = self.truth.numbers_of(draw)
            if not all(self.truth.is_so(c.element, c.relation, numbers, False) for c in conditions):
                return
            here = self.intervals(draw)
            if self._keys(here) != keys:
                raise OtherEnds(Message("which ends count depends on more than could be told in formulas"))
            for interval in here:
                for value in self._beside(interval, numbers):
                    self._compare_at(check, k, draw, value)
            if is_verdict:
                for value in self._outside(here, numbers):
                    self._compare_at(check, k, draw, value)

        if not all(truth.formula.is_put_back for truth in self.truth.truths):
            return self._of_formulas()
        enough = 2 * MIN_DRAWS if is_verdict else MIN_DRAWS
        return check.gather(enumerate(self.truth.setup.draw_stream(self.n_more)), compare, enough).evidence()

    def _keys(self, found: Sequence[Interval]) -> list[Any]:
        """Of the ends that are compared."""
        keys = keys_of(found)
        return {"": keys, "least": keys[:1], "largest": keys[-1:]}[self.only]

    def _of_formulas(self) -> Evidence:
        """Beside an event of contacts, which the numeric route finds in its own way, the formulas of the cases are what
        it is compared with, at numbers of their own. Raises TooLittleCompared where that was possible for none."""
        found: list[Evidence] = []
        missed: TooLittleCompared | None = None
        for truth in self.truth.truths:
            try:
                found.append(truth.formula.evidence())
            except TooLittleCompared as error:
                missed = missed or error
        if not found:
            raise missed or TooLittleCompared(Message("the quantity could not be compared with the numeric route"))
        worst = max(e.worst_relative_difference for e in found)
        return Evidence(sum(e.draws for e in found), worst, found[0].route)

    def _beside(self, interval: Interval, numbers: Mapping[int, Any]) -> Iterator[float]:
        low, high = self.truth.domain()
        values = [low if interval[0].value is None else self.truth.value_of(interval[0].value, numbers)[0]]
        values.append(high if interval[1].value is None else self.truth.value_of(interval[1].value, numbers)[0])
        if values[0] < values[1]:
            yield self.truth.places_between(*values)[1]

    def _outside(self, found: Sequence[Interval], numbers: Mapping[int, Any]) -> Iterator[float]:
        """A value in every gap between the intervals."""
        low, high = self.truth.domain()
        ends = [end.value for interval in found for end in interval]
        values = [None if end is None else self.truth.value_of(end, numbers)[0] for end in ends]
        borders = [low, *(x for x in values if x is not None), high]
        if ends[0] is None:
            borders = borders[1:]
        if ends[-1] is None:
            borders = borders[:-1]
        for a, b in zip(borders[::2], borders[1::2], strict=True):
            if a < b:
                yield self.truth.places_between(a, b)[-2 if math.isfinite(a) else 1]

    def _compare_at(self, check: CrossCheck, number: int, draw: Draw, value: float) -> None:
        values = draw.values | {self.truth.parameter.name: value}
        numbers = self.truth.with_value(self.truth.numbers_of(draw), value)
        said = [t for t in self.truth.truths if t.formula.says is not None and self.truth.holds_for(t, numbers, False)]
        truth = max(said, key=lambda t: t.formula.says is True, default=None)
        if truth is None:
            return
        if self.truth.wanted.relation == SO:
            assert truth.formula.in_numbers is not None
            with suppress(CannotAnswer):
                check.compare(draw, 1.0 if truth.formula.says else 0.0, truth.formula.in_numbers(values))
            return
        made = PutBack(number, draw.with_values(values, self.truth.setup.system), 1.0)
        numeric = quantity_with(self.truth.setup, self.truth.question, self.truth.wanted.of, truth.formula, made)
        if self.truth.wanted.of.is_verdict:
            check.compare(made.draw, 1.0, numeric)
            return
        if truth.element is None:  # the event comes there as well
            check.compare(made.draw, (1.0,), 1.0)
            return
        assert isinstance(truth.formula.element, Ratio)
        has_numbers = truth.formula.in_numbers is not None
        here = made.draw.start() if has_numbers else instant_of(self.truth.question, self.truth.wanted.of, made)
        exact = element_at(self.truth.setup, truth.formula.element, made.draw, here)
        seen = made.draw.seen(here)
        check.compare(made.draw, exact, numeric, lambda: magnitude(self.truth.wanted.of.dimension, seen))
