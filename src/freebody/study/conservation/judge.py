"""The verdict on a quantity: the cases in which its rate vanishes, confirmed by simulation; options judged by them."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from contextlib import suppress
from dataclasses import replace
from functools import singledispatchmethod
from typing import Any

from freebody.assess.verdict import Judgement
from freebody.errors import CannotAnswer, RoutesDisagree
from freebody.language.expression import Expr
from freebody.language.notation import joined, reworded, to_text
from freebody.language.sentences import Message
from freebody.measures.geometry import Point
from freebody.questions.base import Quantity
from freebody.questions.conservation import Conserved
from freebody.questions.momentum import AngularMomentum, point_about
from freebody.questions.reading import Question
from freebody.study.conservation.balance import RateBalance
from freebody.study.conservation.constancy import (
    N_MOTIONS,
    TOLERANCE,
    SimulatedRuns,
    confirm,
)
from freebody.study.conservation.vanishing_rates import ConservationFinding, VanishingRates
from freebody.study.conservation.verdicts import EVERY_SIMULATED, Verdicts
from freebody.study.setup import Setup
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.tidy import tidy
from freebody.symbolic.vanishing import (
    ALWAYS,
    VanishingCase,
    cases_where_zero,
    motion_coefficients,
    texts_of,
)

_MOST_TERMS = 250  # of a formula that is put in order


class Judge:
    """Finds verdicts on one system."""

    def __init__(self, setup: Setup, n_motions: int = N_MOTIONS) -> None:
        self.setup = setup
        self.system = setup.system
        self.model = setup.model
        self.runs = SimulatedRuns(setup, n_motions)
        self.rates = VanishingRates(setup, self.runs)

    def answer(self, question: Question) -> Verdicts:
        """The verdict on a question, its options judged."""
        asked = question.quantity
        assert isinstance(asked, Conserved)
        try:
            parts = asked.of.components(self.system)
            if parts:
                return self._of_vector(question, asked.name, parts)
            found = self.rates.finding(asked.of, asked.name)
            judgement: Judgement | None = None
            if question.options:
                from freebody.assess.statements import judge_statements

                judgement = judge_statements(question, self._claim(found), self.model, self.system)
            return self._verdict(question.id, asked.name, found, judgement)
        except (CannotAnswer, RoutesDisagree) as error:
            return Verdicts(question.id, asked.name, None, None, None, reason=str(error))

    def _of_vector(self, question: Question, name: str, parts: Sequence[tuple[str, Quantity]]) -> Verdicts:
        """A vector stays if all of its components do."""
        labels = [axis for axis, _part in parts]
        findings = [self.rates.finding(part) for _axis, part in parts]
        verdicts = [
            self._verdict(question.id, f"{name} along {axis}", found, None)
            for found, axis in zip(findings, labels, strict=True)
        ]
        claims = [self._claim(found) for found in findings]
        cases = self._of_all(findings, claims)
        open_ = next((k for k, v in enumerate(verdicts) if v.is_conserved is not True or not v.is_proved), 0)
        judgement: Judgement | None = None
        if question.options:
            from freebody.assess.statements import judge_statements

            coefficients = [c for claim in claims for c in claim.coefficients]
            exact = all(claim.is_exact for claim in claims)
            rates = tuple(r for claim in claims for r in claim.rates)
            proved = all(claim.is_proved for claim in claims)
            claim = replace(
                claims[open_],
                coefficients=coefficients,
                cases=cases,
                rates=rates if proved else (),
                is_exact=exact,
                is_proved=proved,
            )
            judgement = judge_statements(question, claim, self.model, self.system)
        is_conserved = True if any(not c.equalities for c in cases) else None if cases else False
        notes = [_along(axis, v) for v, axis in zip(verdicts, labels, strict=True)]
        return replace(
            verdicts[open_],
            question=name,
            is_conserved=is_conserved,
            conditions=texts_of(cases) if is_conserved is None else (),
            value=None,
            is_proved=all(v.is_proved for v in verdicts),
            notes=(*notes, *verdicts[open_].notes),
            choice=None if judgement is None else judgement.choice,
            options={} if judgement is None else judgement.options,
            author_notes=() if judgement is None else judgement.notes,
        )

    def _of_all(self, findings: Sequence[ConservationFinding], claims: Sequence[Any]) -> tuple[VanishingCase, ...]:
        """The cases in which all components stay: what formulas ask for, with what simulations have shown of those
        without one."""
        if any(found.is_conserved is False for found in findings):
            return ()
        coefficients = [c for claim in claims for c in claim.coefficients]
        cases: tuple[VanishingCase, ...] = (ALWAYS,)
        if coefficients:
            cases = cases_where_zero(coefficients, self.rates.may_vanish)
        for found in findings:
            if not found.is_proved and found.is_conserved is None:
                cases = tuple(one.with_more(other) for one in cases for other in found.cases)
        return cases

    def look(self, id: str, quantity: Quantity, name: str) -> Verdicts:
        """The verdict on a quantity."""
        try:
            return self._verdict(id, name, self.rates.finding(quantity, name), None)
        except (CannotAnswer, RoutesDisagree) as error:
            return Verdicts(id, name, None, None, None, reason=str(error))

    def is_nothing(self, quantity: Quantity) -> bool:
        """Whether a quantity is zero in all motions, since what it is of does not move that way."""
        try:
            seen = self.runs.along(RateBalance(quantity, self.system, self.setup.state), None)
        except CannotAnswer:
            return False
        return bool(seen) and all(float(abs(m.values).max()) <= TOLERANCE * m.size for m in seen)

    def _claim(self, found: ConservationFinding) -> Any:
        from freebody.assess.statements import Claim

        has_rate = found.is_proved and not (self.model.loops and found.principle is None)
        rate = found.balance.rate if has_rate else None
        return Claim(
            [] if rate is None or found.is_conserved is True else motion_coefficients(rate, self.rates.is_parameter),
            found.cases,
            () if rate is None else (rate,),
            self.rates.is_parameter,
            found.is_exact,
            found.is_proved,
        )

    # -- the verdict --------------------------------------------------------------------------
    def _verdict(self, id: str, name: str, found: ConservationFinding, judgement: Judgement | None) -> Verdicts:
        balance, notes = found.balance, list(found.notes)
        is_conserved = found.is_conserved
        conditions = texts_of(found.cases) if is_conserved is None else ()
        if is_conserved is None:
            notes += self._edges(found.cases)
            notes += self._in_words(balance.quantity, found.cases)
        confirmation, counter = confirm(self.runs, balance, found.cases, is_conserved)
        if is_conserved is not True and counter is None:
            notes.append(Message("no simulated motion with the numbers of the file showed a change"))
        parts: tuple[tuple[str, Expr], ...] = ()
        if found.principle is not None:
            reduced = [(what, self._reduced(part)) for what, part in found.principle.parts]
            shown = [(what, self._tidied(lambda x=x: x)) for what, x in reduced if not x.is_zero()]
            parts = tuple((what, x) for what, x in shown if x is not None)
        value, rate = self._shown(found)
        return Verdicts(
            id,
            name,
            is_conserved,
            value,
            rate,
            conditions,
            tuple(notes),
            "" if found.principle is None else found.principle.statement,
            parts,
            confirmation,
            counter,
            choice=None if judgement is None else judgement.choice,
            options={} if judgement is None else judgement.options,
            author_notes=() if judgement is None else judgement.notes,
            is_exact=found.is_exact,
            is_proved=found.is_proved or is_conserved is False,
            provided=self.rates.provided(found) if is_conserved is None else (),
        )

    def _shown(self, found: ConservationFinding) -> tuple[Expr | None, Expr | None]:
        """The quantity and its rate; nothing longer than anybody reads."""
        zero, balance = self.model.field.zero, found.balance
        if not found.is_proved:
            rate: Ratio | None = None
        elif found.is_conserved is True:
            rate = zero
        else:
            rate = None if self.model.loops and found.principle is None else balance.rate
        return self._tidied(lambda: balance.value), self._tidied(lambda: rate)

    def _tidied(self, element: Callable[[], Ratio | None]) -> Expr | None:
        """For people; nothing where there is no formula, or a longer one than anybody reads."""
        try:
            x = element()
        except CannotAnswer:
            return None
        if x is None or len(x.num) + len(x.denominator().num) > _MOST_TERMS:
            return None
        return tidy(x)

    def _reduced(self, x: Ratio) -> Ratio:
        f = self.model.field
        return f.lowest_terms(self.model.in_independent_speeds(f.element(x)))

    def _edges(self, cases: Sequence[VanishingCase]) -> Iterator[str]:
        """Parameters that would have to vanish although the file declares them positive."""
        names: dict[str, None] = {}
        f = self.model.field
        for case in cases:
            for index, value in case.values.items():
                if value.is_zero() and f.generators[index].positive:
                    names[to_text(f.generators[index].display)] = None
        if names:
            listed = ", ".join(names)
            yield Message("the file declares {p} positive: the condition is the edge of what it allows", p=listed)

    @singledispatchmethod
    def _in_words(self, q: Quantity, cases: Sequence[VanishingCase]) -> Iterator[str]:
        """What the conditions mean for one kind of quantity."""
        yield from ()

    @_in_words.register(AngularMomentum)
    def _of_moments(self, q: AngularMomentum, cases: Sequence[VanishingCase]) -> Iterator[str]:
        """Where a condition brings the mass centre to the point about which the moment is taken."""
        if not isinstance(q.body, str | None) or not isinstance(q.about, Point):
            return
        bodies = [b for b in self.system.moving if q.body is None or b.name == q.body]
        if len(bodies) != 1 or bodies[0].mass_center == q.about:
            return
        about, _v = point_about(self.system, self.setup.state, q)
        middle, _w = point_about(self.system, self.setup.state, AngularMomentum(bodies[0].name))
        apart = [g - o for g, o in zip(middle, about, strict=True)]
        if all(self.model.field.element(x).is_zero() for x in apart):
            return
        for case in cases:
            with suppress(CannotAnswer):
                if case.equalities and all(case.put_in(x).is_zero() for x in apart):
                    where = texts_of([case])[0]
                    means = Message(
                        "{case} means that the mass centre of {body} coincides with {point}",
                        case=where,
                        body=bodies[0].name,
                        point=q.about,
                    )
                    yield reworded(means, where)


def _along(axis: str, v: Verdicts) -> str:
    """The verdict on one component."""
    if v.is_conserved and v.is_proved:
        return Message("along {axis}: conserved", axis=axis)
    when = joined(v.conditions, " or ")
    if not v.is_proved:
        seen = Message("constant in every simulated motion if {case}", case=when) if when else EVERY_SIMULATED
        return reworded(Message("along {axis}: {seen}", axis=axis, seen=seen), when)
    told = (
        Message("along {axis}: if {case}", axis=axis, case=when)
        if when
        else Message("along {axis}: not conserved", axis=axis)
    )
    if v.rate is not None:
        told = Message("{case}, rate {rate}", case=told, rate=to_text(v.rate))
    return reworded(told, when)
