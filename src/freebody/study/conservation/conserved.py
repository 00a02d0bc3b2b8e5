"""What is conserved: for every motion, for none, or under which conditions.

The rate of a quantity is reduced to independent coordinates and speeds. It vanishes for every motion if and only if
all its coefficients do (`symbolic/vanishing.py`); these contain parameters and given functions of time, which gives the
conditions. Masses, inertias, sizes of bodies and gravity are taken to be there; offsets, angles of lines, strengths of
other loads and whatever the file allows to be zero may vanish.

Every verdict is confirmed by simulation: a conserved quantity stays within 1e-9, another one visibly changes.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from contextlib import suppress
from dataclasses import dataclass, replace
from functools import cached_property, singledispatchmethod
from itertools import combinations
from typing import Any

from freebody.assess.verdict import Judgement
from freebody.errors import CannotAnswer, RoutesDisagree
from freebody.language.expression import Expr, Symbol, free_symbols
from freebody.language.notation import joined, reworded, to_python, to_text
from freebody.language.sentences import Message, further
from freebody.language.units import INERTIA, LENGTH, MASS
from freebody.measures.geometry import Point
from freebody.questions.base import Quantity
from freebody.questions.conservation import Conserved
from freebody.questions.momentum import AngularMomentum, point_about
from freebody.questions.reading import Question
from freebody.study.conservation.balance import IsVector, RateBalance, RatePrinciple
from freebody.study.conservation.conservation import Conservation
from freebody.study.conservation.constancy import (
    N_IN_SEARCH,
    N_MOTIONS,
    TOLERANCE,
    VISIBLE,
    SimulatedRuns,
    confirm,
)
from freebody.study.conservation.natural import candidates
from freebody.study.conservation.verdicts import Verdicts
from freebody.study.setup import Setup
from freebody.study.worded import in_words
from freebody.symbolic.field import Ratio
from freebody.symbolic.tidy import tidy
from freebody.symbolic.vanishing import (
    VanishingCase,
    cases_where_zero,
    implies,
    most_general,
    motion_coefficients,
    texts_of,
)
from freebody.system.system import System

_MOST_TERMS = 250  # of a formula that is put in order
_MOST_INSIDE = 5  # parameters inside what moves, of which pairs are tried


@in_words
def conserved(system: System, question: str | None = None) -> Conservation:
    """Judges the quantities asked for in words, or by the questions of the model; without any, searches.

    Raises ModelError if the system cannot be assembled or the question cannot be read."""
    if system.blows:
        return _between_blows(system, question)
    if system.bounds or system.dry_friction:
        from freebody.study.settled import settled

        return conserved(settled(system), question)
    if question is None:
        asked = tuple(q for q in system.questions if q.quantity.scope == "every motion")
    else:
        asked = (_question(system, question),)
    setup = Setup(system, N_MOTIONS if asked else N_IN_SEARCH)
    if asked:
        judge = Judge(setup)
        return Conservation(system, tuple(judge.answer(q) for q in asked), is_search=False)
    return Conservation(system, tuple(_searched(setup)), is_search=True)


def _between_blows(system: System, question: str | None) -> Conservation:
    """What holds as long as no blow comes: of what happens in it nothing is said."""
    found = conserved(replace(system, blows=()), question)
    events = ", ".join(blow.name for blow in system.blows)
    note = Message("as long as no blow comes ({events}); what stays the same in it is not judged", events=events)
    told = tuple(replace(v, notes=(*v.notes, note)) if v.is_answered else v for v in found.quantities)
    return replace(found, system=system, quantities=told)


def _question(system: System, text: str) -> Question:
    words = text.strip()
    if "conserved" not in words and not words.startswith("conservation"):
        words = f"is {words} conserved"
    return system.question(words)


@dataclass(frozen=True)
class ConservationFinding:
    """The symbolic part of a verdict."""

    balance: RateBalance
    cases: tuple[VanishingCase, ...]
    is_exact: bool  # the cases are all there are
    principle: RatePrinciple | None
    notes: tuple[str, ...]

    @property
    def is_conserved(self) -> bool | None:
        if not self.cases:
            return False
        return True if any(not case.equalities for case in self.cases) else None


class Judge:
    """Finds verdicts on one system."""

    def __init__(self, setup: Setup, n_motions: int = N_MOTIONS) -> None:
        self.setup = setup
        self.system = setup.system
        self.model = setup.model
        self.runs = SimulatedRuns(setup, n_motions)

    def answer(self, question: Question) -> Verdicts:
        """The verdict on a question, its options judged."""
        asked = question.quantity
        assert isinstance(asked, Conserved)
        try:
            parts = asked.of.components(self.system)
            if parts:
                return self._of_vector(question, asked.name, parts)
            found = self.finding(asked.of, asked.name)
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
        findings = [self.finding(part) for _axis, part in parts]
        verdicts = [
            self._verdict(question.id, f"{name} along {axis}", found, None)
            for found, axis in zip(findings, labels, strict=True)
        ]
        claims = [self._claim(found) for found in findings]
        cases: tuple[VanishingCase, ...] = (VanishingCase((), {}),)
        if not all(v.is_conserved for v in verdicts):
            is_refuted = any(v.is_conserved is False for v in verdicts)
            coefficients = [c for claim in claims for c in claim.coefficients]
            cases = () if is_refuted else cases_where_zero(coefficients, self.may_vanish)
        open_ = next((k for k, v in enumerate(verdicts) if v.is_conserved is not True), 0)
        judgement: Judgement | None = None
        if question.options:
            from freebody.assess.statements import judge_statements

            coefficients = [c for claim in claims for c in claim.coefficients]
            exact = all(claim.is_exact for claim in claims)
            rates = tuple(r for claim in claims for r in claim.rates)
            claim = replace(claims[open_], coefficients=coefficients, cases=cases, rates=rates, is_exact=exact)
            judgement = judge_statements(question, claim, self.model, self.system)
        is_conserved = True if any(not c.equalities for c in cases) else None if cases else False
        notes = [_along(axis, v) for v, axis in zip(verdicts, labels, strict=True)]
        return replace(
            verdicts[open_],
            question=name,
            is_conserved=is_conserved,
            conditions=texts_of(cases) if is_conserved is None else (),
            value=None,
            notes=(*notes, *verdicts[open_].notes),
            choice=None if judgement is None else judgement.choice,
            options={} if judgement is None else judgement.options,
            author_notes=() if judgement is None else judgement.notes,
        )

    def look(self, id: str, quantity: Quantity, name: str) -> Verdicts:
        """The verdict on a quantity."""
        try:
            return self._verdict(id, name, self.finding(quantity, name), None)
        except (CannotAnswer, RoutesDisagree) as error:
            return Verdicts(id, name, None, None, None, reason=str(error))

    def is_nothing(self, quantity: Quantity) -> bool:
        """Whether a quantity is zero in all motions, since what it is of does not move that way."""
        try:
            seen = self.runs.along(RateBalance(quantity, self.system, self.setup.state), None)
        except CannotAnswer:
            return False
        return bool(seen) and all(float(abs(m.values).max()) <= TOLERANCE * m.size for m in seen)

    # -- the symbolic part --------------------------------------------------------------------
    def _is_vector(self, quantity: Quantity) -> bool:
        """By its value at the start, where it has one."""
        with suppress(CannotAnswer):
            return isinstance(quantity.value(self.system, self.setup.draws[0].start()), tuple)
        return False

    def finding(self, quantity: Quantity, name: str = "quantity") -> ConservationFinding:
        """The rate of a quantity and the cases in which it vanishes."""
        f = self.model.field
        if all(f.element(i).is_zero() for inertia in self.model.dynamics.inertias.values() for i in inertia):
            raise CannotAnswer(Message("nothing with mass moves here. Give the bodies masses or inertias"))
        balance = RateBalance(quantity, self.system, self.setup.state, name)
        try:
            rate = balance.rate
        except IsVector:
            raise
        except CannotAnswer as error:
            if self._is_vector(quantity):
                raise IsVector from None
            return self._by_simulation(balance, str(error))
        principle, notes = self._principle(balance)
        if self.model.samples.vanishes(rate):
            return ConservationFinding(balance, (VanishingCase((), {}),), True, principle, notes)
        coefficients = motion_coefficients(rate, self.is_parameter)
        cases = cases_where_zero(coefficients, self.may_vanish)
        cases = most_general([*cases, *self._special(rate)])
        cases = tuple(case for case in cases if not self._is_between_sizes(case) and self._has_value(balance, case))
        is_exact = len(coefficients) == 1 or (not self.model.loops and all(case.is_solved for case in cases))
        if not is_exact and cases:
            notes += (Message("these conditions are enough; that there are no others is not proved"),)
        return ConservationFinding(balance, cases, is_exact, principle, notes)

    def _special(self, rate: Ratio) -> Iterator[VanishingCase]:
        """Cases that the coefficients do not show, because parameters stand inside what moves, as w in sin(w t): they
        are zero, or two of them are equal or opposite."""
        f = self.model.field
        inside: set[int] = set()
        for g in rate.generators():
            if not f.is_constant_generator(g):
                inside |= {k for k in f.generators[g].made_of if self.is_parameter(k)}
        inside.discard(f.index(f.pi))
        first = [VanishingCase((f.variable(k),), {k: f.zero}) for k in sorted(inside) if self.may_vanish(k)]
        for a, b in combinations(sorted(inside)[:_MOST_INSIDE], 2):
            if self._dimension(a) == self._dimension(b):
                x, y = f.variable(a), f.variable(b)
                first.append(VanishingCase((y - x,), {b: x}))
                if not (f.generators[a].positive and f.generators[b].positive):
                    first.append(VanishingCase((y + x,), {b: -x}))
        for case in first:
            with suppress(CannotAnswer):
                left = f.lowest_terms(case.put_in(rate))
                for more in cases_where_zero(motion_coefficients(left, self.is_parameter), self.may_vanish):
                    yield case.with_more(more)

    def _dimension(self, index: int) -> object:
        shown = self.model.field.generators[index].display
        assert isinstance(shown, Symbol)
        return self.system.parameters[shown.name].dimension

    def _by_simulation(self, balance: RateBalance, why: str) -> ConservationFinding:
        """A verdict without a formula: a motion along which it changes refutes it for good."""
        drifts = [motion.drift for motion in self.runs.along(balance, None)]
        if not drifts:
            raise CannotAnswer(Message("{why}, and no motion could be simulated", why=why))
        if max(drifts) > VISIBLE:
            cases = tuple(self._without_loads(balance))
            note = further(why, Message("found by simulation"))
            if cases:
                note = further(note, Message("there may be more conditions"))
            return ConservationFinding(balance, cases, False, None, (note,))
        if max(drifts) > TOLERANCE:
            raise CannotAnswer(
                Message("{why}, and in simulations it changes by {share:.1g} of its size", why=why, share=max(drifts))
            )
        note = Message("{why}; it is constant in {n} simulated motions, which is no proof", why=why, n=len(drifts))
        return ConservationFinding(balance, (VanishingCase((), {}),), False, None, (note,))

    @staticmethod
    def _has_value(balance: RateBalance, case: VanishingCase) -> bool:
        """Whether the quantity and its rate have values in a case."""
        try:
            case.put_in(balance.value)
            return case.kills(balance.rate) or not case.is_solved
        except CannotAnswer:
            return False

    def _without_loads(self, balance: RateBalance) -> Iterator[VanishingCase]:
        """Conditions found by trying: strengths of loads that vanish, one of them or all."""
        f = self.model.field
        names = {
            n
            for push in self.system.applied_loads
            for n in free_symbols(push.in_symbols)
            if n in self.system.parameters
        }
        indices = [k for n in sorted(names) if self.may_vanish(k := f.index(self.model.parameters[n]))]
        tried = [VanishingCase((f.variable(k),), {k: f.zero}) for k in indices]
        if len(tried) > 1:
            tried.append(VanishingCase(tuple(f.variable(k) for k in indices), dict.fromkeys(indices, f.zero)))
        found: list[VanishingCase] = []
        for case in tried:
            drifts = [motion.drift for motion in self.runs.along(balance, case)]
            if drifts and max(drifts) <= TOLERANCE and not any(implies(case, other) for other in found):
                found.append(case)
                yield case

    def _is_between_sizes(self, case: VanishingCase) -> bool:
        """Whether a case relates sizes of bodies to each other alone, as a ball as large as its bowl."""
        sizes = {p.name for p in self.system.parameters.values() if p.dimension == LENGTH} & self._substance
        return any(
            {getattr(self.model.field.generators[g].display, "name", "") for g in e.generators()} <= sizes
            for e in case.equalities
        )

    def _principle(self, balance: RateBalance) -> tuple[RatePrinciple | None, tuple[str, ...]]:
        """The rate by its principle. Raises RoutesDisagree unless it is the same as by differentiation."""
        try:
            principle = balance.by_principle()
        except CannotAnswer as error:
            return None, (Message("not compared with the balance of forces: {why}", why=error),)
        if self.model.loops:
            return principle, ()
        if principle is None:
            return None, ()
        total = self.model.in_independent_speeds(principle.total(self.model.field.zero))
        if not self.model.samples.vanishes(total - balance.rate):
            # Where something moves without inertia its equation of motion binds the state, as 0 = Q: the rates agree
            # along motions only, and these are not determined.
            _ = self.model.dynamics.solved_accelerations
            raise RoutesDisagree(
                Message(
                    "the rate of {name} by its principle is not the one by differentiation. "
                    "No answer is shown. This is a defect of freebody; please report the model",
                    name=balance.name,
                )
            )
        return principle, ()

    @cached_property
    def _substance(self) -> set[str]:
        """Parameters that are taken not to vanish: masses, inertias, gravity, and the sizes of bodies."""
        names = {p.name for p in self.system.parameters.values() if p.dimension in (MASS, INERTIA)}
        for push in self.system.applied_loads:
            if self.system.loads[push.load].kind == "gravity":
                names |= free_symbols(push.law)
        for body in self.system.bodies.values():
            names |= free_symbols(body.mass) | free_symbols(body.inertia)
            if body.radius is not None:
                names |= free_symbols(body.radius)
        for row in self.system.constraint_rows:
            if row.target is not None and row.measure.dimension == LENGTH:
                names |= free_symbols(row.target)
        return names

    def is_parameter(self, index: int) -> bool:
        """Whether a generator is a parameter of the file, not one of a start; pi counts as one."""
        g = self.model.field.generators[index]
        shown = g.display
        return (
            g.kind == "parameter"
            and isinstance(shown, Symbol)
            and (shown.name in self.system.parameters or shown.name == "pi")
        )

    def may_vanish(self, index: int) -> bool:
        """Whether a parameter may be zero: what has substance is not."""
        shown = self.model.field.generators[index].display
        if not isinstance(shown, Symbol) or shown.name not in self.system.parameters:
            return False
        return self.system.parameters[shown.name].sign != "positive" or shown.name not in self._substance

    def _claim(self, found: ConservationFinding) -> Any:
        from freebody.assess.statements import Claim

        rate = None if self.model.loops and found.principle is None else found.balance.rate
        return Claim(
            [] if rate is None or found.is_conserved is True else motion_coefficients(rate, self.is_parameter),
            found.cases,
            () if rate is None else (rate,),
            self.is_parameter,
            found.is_exact,
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
            provided=self.provided(found) if is_conserved is None else (),
        )

    def provided(self, found: ConservationFinding) -> tuple[str, ...]:
        """Parameters that are taken to be there, without which terms of the rate would vanish as well."""
        try:
            rate = found.balance.rate
        except CannotAnswer:
            return ()
        names: dict[str, None] = {}
        for coefficient in motion_coefficients(rate, self.is_parameter):
            _unit, factors = rate.field.factor(coefficient.num)
            for base, _exponent in factors:
                e = base.field.generators[min(base.generators())].display
                if len(base.num) == 1 and isinstance(e, Symbol) and e.name in self._substance:
                    names[e.name] = None
        return tuple(names)

    def _shown(self, found: ConservationFinding) -> tuple[Expr | None, Expr | None]:
        """The quantity and its rate; nothing longer than anybody reads."""
        zero, balance = self.model.field.zero, found.balance
        if found.is_conserved is True:
            rate: Ratio | None = zero
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
    if v.is_conserved:
        return Message("along {axis}: conserved", axis=axis)
    when = joined(v.conditions, " or ")
    told = (
        Message("along {axis}: if {case}", axis=axis, case=when)
        if when
        else Message("along {axis}: not conserved", axis=axis)
    )
    if v.rate is not None:
        told = Message("{case}, rate {rate}", case=told, rate=to_text(v.rate))
    return reworded(told, when)


# -- the search -------------------------------------------------------------------------------
def _searched(setup: Setup) -> list[Verdicts]:
    judge = Judge(setup, N_IN_SEARCH)
    found: list[Verdicts] = []
    places: dict[str, int] = {}
    for k, (quantity, name) in enumerate(candidates(setup), 1):
        if judge.is_nothing(quantity):
            continue
        verdict = judge.look(f"c{k}", quantity, name)
        if verdict.value is not None and not _can_change(setup, verdict):
            continue  # constant because it is bound
        key = f"no formula {k}" if verdict.value is None else to_python(verdict.value)
        if key in places:
            verdict = replace(verdict, same_as=found[places[key]].question)
        else:
            places[key] = len(found)
        found.append(verdict)
    return found


def _can_change(setup: Setup, verdict: Verdicts) -> bool:
    """Whether anything in the quantity can change at all."""
    assert verdict.value is not None
    moving = {str(c.name) for c in setup.model.coordinates} | {str(c.name) for c in setup.model.dependent}
    functions = {p.name for p in setup.system.parameters.values() if p.form is not None}
    return bool(free_symbols(verdict.value) & (moving | functions | {"t"}))
