"""Answers to questions about rest under dry friction, in closed form where there is one."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field, replace
from fractions import Fraction
from functools import lru_cache, singledispatchmethod

import numpy as np

from freebody.errors import CannotAnswer
from freebody.language.expression import ZERO, Symbol
from freebody.language.notation import compared, joined, reworded, to_text
from freebody.language.sentences import Message, in_turn
from freebody.numeric.friction_limits import unresisted
from freebody.numeric.rest_problem import FreeBeside, rest_problem
from freebody.questions.base import Quantity
from freebody.questions.happening import FailsFirst, Happening, Lasting
from freebody.questions.reading import Question
from freebody.questions.rest import FirstFailure, Holds, ReactionRange, RestLimit
from freebody.questions.turned_round import SO, RangeFor, RangeForAtRest
from freebody.study.answering.about_rest import open_loads
from freebody.study.answering.answer import Answer, AnswerCase, Evidence, made
from freebody.study.answering.closed_form import QuestionSolver
from freebody.study.answering.crosscheck import CrossCheck
from freebody.study.answering.finding import answered, judged
from freebody.study.answering.formula import Formula
from freebody.study.answering.of_parameter import solved_for
from freebody.study.answering.rest_in_names import load_at_rest
from freebody.study.answering.scope import for_all
from freebody.study.friction.balance import in_balance
from freebody.study.friction.cases import Compared, Ends, FailureCase, HoldingLimit
from freebody.study.friction.ends import ParameterEnds, ReactionEnds
from freebody.study.friction.failures import seen
from freebody.study.friction.touching import TouchingAtRest, touching
from freebody.study.setup import Setup
from freebody.symbolic.active_set import Failure
from freebody.symbolic.conditions import Condition, merged
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.tidy import tidy
from freebody.system.system import System
from freebody.tolerances import ROUND_OFF, ROUNDED

TOLERANCE = 1e-8  # relative: limits are found by halving margins of linear programs
OF_PLANES = 1e-5  # where circular cones are cut out by planes, which come close to them only
END = {1: Message("upper"), -1: Message("lower")}
_FIRST = Message("nothing else fails before")
_ALONE = Message("it stays at rest at this value alone")
ROUTE = Message("the linear programs of all reactions that rest allows")


@dataclass(frozen=True)
class PreparedRest:
    """What touches at the start, both routes for it, and what has ends there, each made once."""

    touching: TouchingAtRest
    setup: Setup
    _parameters: dict[str, ParameterEnds] = field(default_factory=dict[str, ParameterEnds], repr=False)
    _reactions: dict[str, ReactionEnds] = field(default_factory=dict[str, ReactionEnds], repr=False)

    def parameter(self, name: str) -> ParameterEnds:
        if name not in self._parameters:
            self._parameters[name] = ParameterEnds(self.touching, self.setup, name)
        return self._parameters[name]

    def reaction(self, row: str) -> ReactionEnds:
        if row not in self._reactions:
            self._reactions[row] = ReactionEnds(self.touching, self.setup, row)
        return self._reactions[row]


@lru_cache(maxsize=8)
def prepared(system: System) -> PreparedRest:
    """A system at rest, ready to be asked."""
    touched = touching(system)
    return PreparedRest(touched, Setup(touched.held))


def of_motion(system: System, question: Question) -> Question:
    """That nothing slips, asked of the motion where some body is driven along a direction in which nothing resists, or
    rolls beside a drive, so that there is no rest; else the question as it is."""
    q = question.quantity
    if not q.asks_no_slip:
        return question
    assert isinstance(q, RestLimit)
    rest = prepared(left_alone(system, q))
    if not rest.touching.dry_friction:  # in the air: there is nothing that could slip
        return question
    draw = rest.setup.draws[0]
    is_led = False
    try:
        if unresisted(rest_problem(draw.reference, draw.q, rest.touching.dry_friction)) is None:
            return question
    except FreeBeside:  # whatever carries it may end, as the bed of a truck does: rest is of the start as well
        is_led = True
    rolls = Happening(Lasting("rolls", (), question.text), question.text, at_once=is_led)
    end = "" if q.which == "range" else q.which
    wanted = RangeFor(q.parameter, rolls, ZERO, q.dimension, q.unit, question.text, relation=SO, end=end)
    return replace(question, quantity=wanted)


def answer(system: System, question: Question) -> Answer:
    """The answer to a question about rest; without a closed form, its numbers and the reason."""
    system = left_alone(system, question.quantity)
    return answered(system, question, lambda: _Answerer(system, question).answer(question.quantity))


def left_alone(system: System, quantity: Quantity) -> System:
    """The system without the loads that a question about rest leaves out."""
    without = quantity.loads_left_out
    if not without:
        return system
    return replace(system, applied_loads=tuple(p for p in system.applied_loads if p.load not in without))


class _Answerer:
    """Answers one question."""

    def __init__(self, system: System, question: Question) -> None:
        self.system = system
        self.question = question
        self.rest = prepared(system)
        self.touching, self.setup = self.rest.touching, self.rest.setup

    @singledispatchmethod
    def answer(self, q: Quantity) -> Answer:
        """By the kind of question."""
        raise CannotAnswer(Message("this is no question about rest"))

    @answer.register(RestLimit)
    def _limit(self, q: RestLimit) -> Answer:
        ends = self.rest.parameter(q.parameter)
        if q.is_of_slip:
            self._insist_on_slip(ends, q)
        if (named := self._by_names(q)) is not None:
            return named
        balance = None if ends.is_linear else in_balance(self.touching, self.setup, self.question, q)
        return (
            self._ends(ends, q.parameter, q.ends) if balance is None else QuestionSolver(self.setup, balance).answer()
        )

    def _by_names(self, q: RestLimit) -> Answer | None:
        """Of a load of a machine without friction in a pose that loops give it, which no short formula tells."""
        touching, model, start = self.touching, self.setup.model, self.setup.start
        if q.which != "range" or touching.dry_friction or touching.bounds:
            return None
        if all(d.index in start.values for d in model.dependent) or q.parameter not in open_loads(self.setup):
            return None
        return load_at_rest(self.setup, self.question, q.parameter)

    def _insist_on_slip(self, ends: Ends, q: RestLimit) -> None:
        """Of what leaves rest without any slip, words of slipping mean the motion. Raises CannotAnswer there."""
        for first in (limit.first for sign in q.ends if (limit := ends.limit(sign)).first is not None):
            assert first is not None
            if math.isinf(first.edge.value):
                continue
            failure = seen(self.touching, first.edge.problem, first.edge.optimum, first.draw).failure
            if not failure.slips and not failure.opens:
                raise CannotAnswer(
                    Message(
                        "the system moves before anything slips; name what is not to slip in its motion, as in "
                        "'largest {x} for which {contact} does not slip'",
                        x=q.parameter,
                        contact=next((rub.name.partition(".")[0] for rub in self.touching.dry_friction), "contact"),
                    )
                )

    @answer.register(FirstFailure)
    def _failure(self, q: FirstFailure) -> Answer:
        return self._first(self.rest.parameter(q.parameter), q.parameter)

    @answer.register(ReactionRange)
    def _reaction(self, q: ReactionRange) -> Answer:
        return self._ends(self.rest.reaction(self._row(q)), "it", (-1, 1))

    @answer.register(RangeForAtRest)
    def _which_first(self, q: RangeForAtRest) -> Answer:
        """For which values of a parameter one failure comes before the other as another parameter grows."""
        assert isinstance(q.of, FailsFirst)
        of, ends = q.of, self.rest.parameter(q.of.grows)

        def in_numbers(values: dict[str, float]) -> float:
            draw = self.setup.draws[0].with_values(values, self.touching.held)
            edge = ends.edge(draw, 1, None)
            if edge is None or math.isinf(edge.value):
                raise CannotAnswer(Message("{x} may grow without limit", x=of.grows))
            is_so = self._is_failure(of, seen(self.touching, edge.problem, edge.optimum, draw).failure)
            if is_so is None:
                raise CannotAnswer(Message("it tips and slides at once"))
            return 1.0 if is_so else 0.0

        def no_formula() -> Evidence:
            raise CannotAnswer(Message("it has no closed form"))

        cases = ends.limit(1).cases
        formulas = [
            Formula(
                Fraction(1),
                case.conditions,
                no_formula,
                in_numbers,
                says=self._is_failure(of, case.failure) if case.is_complete else None,
                why=case.words,
            )
            for case in cases
        ]
        if not formulas:
            raise CannotAnswer(Message("no limit of {x} was found among the values that were tried", x=of.grows))
        return QuestionSolver(self.setup, self.question).finish(solved_for(self.setup, self.question, formulas))

    @answer.register(Holds)
    def _holds(self, q: Holds) -> Answer:
        from freebody.study.friction.holding import holds

        return holds(self.touching, self.setup, self.question)

    def _is_failure(self, of: FailsFirst, failure: Failure) -> bool | None:
        """Whether a failure is the one that is meant; None where it is both."""
        tipping = {rub.name for rub in self.touching.dry_friction if rub.is_tipping}
        gives_way = {name for name, _direction in failure.slips}
        tips, slips = bool(failure.opens or gives_way & tipping), bool(gives_way - tipping)
        return None if tips == slips else tips == (of.fails == "tips")

    def _row(self, q: ReactionRange) -> str:
        """The row that is asked for: of those that could be meant the one that touches."""
        found = [row for row in self.touching.rows if row.name in q.rows]
        if not found:
            raise CannotAnswer(Message("nothing touches there at the start, so there is no {what}", what=q.reaction))
        if len(found) > 1:
            places = ", ".join(row.ends[0] if row.ends else row.name for row in found)
            raise CannotAnswer(
                Message(
                    "there are several places with a {what}; say at which: at {places}", what=q.reaction, places=places
                )
            )
        return found[0].name

    # -- ends ---------------------------------------------------------------------------------
    def _ends(self, ends: Ends, name: str, signs: Sequence[int]) -> Answer:
        limits = [ends.limit(sign) for sign in signs]
        mains = [limit.main for limit in limits]
        numbers = [limit.first.edge.value if limit.first is not None else math.nan for limit in limits]
        free = [_is_free(limit, ends) for limit in limits]
        notes: list[str] = []
        for limit, number, is_free in zip(limits, numbers, free, strict=True):
            notes += self._notes(ends, limit, name, number, is_free)
            if len(limits) > 1 or limit.main is None:
                notes += self._others(limit, name)
        found = [main for main, is_free in zip(mains, free, strict=True) if not is_free]
        values = [x for x, is_free in zip(numbers, free, strict=True) if not is_free]
        if not found and signs == (-1,) and all(c.edge.value <= 0.0 == ends.low for c in limits[0].compared):
            zero = self.setup.model.field.zero
            pairs = [replace(c, exact=0.0, edge=replace(c.edge, value=0.0)) for c in limits[0].compared]
            case = FailureCase(Failure(), "", zero, (), True)
            return self._finished(ends, [case], (zero,), [0.0], notes, [replace(limits[0], compared=tuple(pairs))])
        if not found:
            every = all(ends.is_linear and all(_unlimited(c, ends) for c in limit.compared) for limit in limits)
            why = (
                Message("every value keeps the system at rest")
                if every
                else Message("at the model's own values no limit was found")
            )
            why = why if len(signs) > 1 else notes[0]
            return made(self.question, None, None, notes=notes[1:] if len(signs) == 1 else notes, reason=why)
        shown = values if self.setup.has_values else []
        if any(main is None for main in found):
            reason = Message(
                "the way in which it fails ({words}) leads to no linear or quadratic equation",
                words=self._words(limits),
            )
            value = None if not shown else shown[0] if len(shown) == 1 else tuple(shown)
            return made(self.question, None, value, notes=notes, reason=reason)
        cases = [main for main in found if main is not None]
        exact = [self._exact(ends, case) for case in cases] if shown else []
        elements = tuple(case.element for case in cases)
        if len(elements) == 2 and elements[0] == elements[1]:
            elements, exact = elements[:1], exact[:1]
            decided = self._decided(limits)
            notes = [_ALONE, *(n for n in notes if n not in (*decided, _ALONE))]
        return self._finished(ends, cases, elements, exact, notes, limits)

    def _exact(self, ends: Ends, case: FailureCase) -> float:
        value = ends.number(case.element, self.setup.draws[0])
        return math.nan if value is None else (0.0 if abs(value) < ROUNDED else value)

    def _decided(self, limits: Sequence[HoldingLimit]) -> list[str]:
        """What is said of ends that are the same value."""
        told = ((limit.sign, limit.first.seen.words) for limit in limits if limit.first and limit.first.seen)
        return [Message("{end} limit: {words}", end=END[sign], words=words) for sign, words in told]

    def _words(self, limits: Sequence[HoldingLimit]) -> str:
        return in_turn([limit.first.seen.words for limit in limits if limit.first and limit.first.seen])

    def _notes(self, ends: Ends, limit: HoldingLimit, name: str, number: float, is_free: bool) -> Iterator[str]:
        """How it fails at this end, and what else comes first for other parameters."""
        end = END[limit.sign]
        if is_free:
            if limit.sign < 0 and math.isfinite(number):
                is_needed = limit.first is not None and limit.first.edge.optimum.value < -ROUND_OFF
                if name == "it":
                    yield (
                        Message("there is no lower limit: it need only be larger than 0")
                        if is_needed
                        else Message("there is no lower limit: it = 0 will do")
                    )
                elif is_needed:
                    yield Message("there is no lower limit: {x} need only be larger than 0", x=to_text(Symbol(name)))
                else:
                    told = Message("there is no lower limit: {x} = 0 will do", x=to_text(Symbol(name)))
                    yield reworded(told, compared(Symbol(name), "=", ZERO))
            elif ends.is_linear:  # the linear program has no bound
                yield Message("there is no {end} limit", end=end)
            else:
                yield Message("no {end} limit was found among the values that were tried", end=end)
            limited = sum(not _unlimited(c, ends) for c in limit.compared)
            if limited:
                yield Message(
                    "with other parameters there is a limit at the {end} end ({k} of {n} draws)",
                    end=end,
                    k=limited,
                    n=len(limit.compared),
                )
        elif limit.main is not None and limit.main.failure == Failure():
            yield _ALONE
        elif limit.first is not None and limit.first.seen is not None:
            yield Message("{end} limit: {words}", end=end, words=limit.first.seen.words)
        open_ = [c for c in limit.compared if c.case is None and c.seen is not None and not _unlimited(c, ends)]
        if open_ and limit.main is not None:
            yield Message(
                "{end} limit: at {k} of {n} random draws another failure comes first",
                end=end,
                k=len(open_),
                n=len(limit.compared),
            )
        unlimited = [c for c in limit.compared if _unlimited(c, ends)]
        if unlimited and not is_free:
            yield Message(
                "with other parameters there is no {end} limit ({k} of {n} draws)",
                end=end,
                k=len(unlimited),
                n=len(limit.compared),
            )

    def _others(self, limit: HoldingLimit, name: str) -> Iterator[str]:
        """What else comes first at an end of a range."""
        for case in limit.cases:
            if case is not limit.main and (limit.main is None or case.element != limit.main.element):
                end, value = END[limit.sign], to_text(tidy(case.element))
                if name == "it":
                    words = Message(
                        "{end} limit = {value} where {where}: {words}",
                        end=end,
                        value=value,
                        where=_where(case),
                        words=case.words,
                    )
                    yield reworded(words, _where(case))
                    continue
                words = Message(
                    "{end} limit {x} = {value} where {where}: {words}",
                    end=end,
                    x=to_text(Symbol(name)),
                    value=value,
                    where=_where(case),
                    words=case.words,
                )
                here = [compared(Symbol(name), "=", tidy(case.element)), *_conditions(case)]
                yield reworded(words, joined(here))

    def _finished(
        self,
        ends: Ends,
        cases: Sequence[FailureCase],
        elements: tuple[Ratio, ...],
        exact: Sequence[float],
        notes: list[str],
        limits: Sequence[HoldingLimit],
    ) -> Answer:
        conditions = merged([c for case in cases for c in case.conditions])
        is_complete = all(case.is_complete for case in cases)
        if not is_complete:
            notes.append(
                Message(
                    "that nothing else fails before was checked at the draws; the conditions are not all that this "
                    "needs"
                )
            )
        if ends.equations.inertia:
            notes.append(Message("at rest means beside what is driven"))
        evidence = _evidence(self.question.text, limits)
        element = elements[0] if len(elements) == 1 else elements
        value = None if not exact else exact[0] if len(exact) == 1 else tuple(exact)
        shown = tuple(map(tidy, elements))
        return made(
            self.question,
            shown[0] if len(shown) == 1 else shown,
            value,
            conditions=tuple(conditions) or (for_all(self.system) if is_complete else _FIRST,),
            notes=notes,
            evidence=evidence,
            judgement=judged(self.question, element, self.setup.model, self.setup.system),
            cases=_cases(limits),
        )

    # -- which comes first --------------------------------------------------------------------
    def _first(self, ends: ParameterEnds, name: str) -> Answer:
        limit = ends.limit(1)
        if limit.first is None or _is_free(limit, ends):
            if ends.is_linear:
                raise CannotAnswer(Message("{x} may grow without limit", x=name))
            raise CannotAnswer(Message("no limit of {x} was found among the values that were tried", x=name))
        if limit.main is None:
            words = limit.first.seen.words if limit.first.seen else ""
            return made(
                self.question,
                None,
                limit.first.edge.value,
                notes=[Message("first: {words}", words=words)],
                reason=Message("it has no closed form"),
            )
        notes: list[str] = [Message("first: {words}, at this {x}", words=limit.main.words, x=to_text(Symbol(name)))]
        exact = [self._exact(ends, limit.main)] if self.setup.has_values else []
        return self._finished(ends, [limit.main], (limit.main.element,), exact, notes, [limit])


def _cases(limits: Sequence[HoldingLimit]) -> tuple[AnswerCase, ...]:
    """The cases of an answer with one end, where there are several."""
    if len(limits) != 1 or len(limits[0].cases) < 2:
        return ()
    cases = sorted(limits[0].cases, key=lambda case: case is not limits[0].main)
    return tuple(AnswerCase(tidy(c.element), _conditions(c) or (_FIRST,), c.words) for c in cases)


def _is_free(limit: HoldingLimit, ends: Ends) -> bool:
    return limit.first is not None and _unlimited(limit.first, ends)


def _unlimited(c: Compared, ends: Ends) -> bool:
    return math.isinf(c.edge.value) or (c.edge.value <= ends.low)


def _where(case: FailureCase) -> str:
    """The conditions of a case in one line."""
    return joined(_conditions(case)) or _FIRST


def _conditions(case: FailureCase) -> tuple[str, ...]:
    """Each without what it is for."""
    return tuple(Condition(c.element, c.relation).text() for c in case.conditions)


def _digits_lost(c: Compared) -> float:
    """What round-off leaves open of a limit, relative: of a rope many times round a drum, whose tensions differ by
    e^(mu beta), the greater one tells only so much of the less."""
    largest = max((max(cone.forward, cone.backward) for cone in c.edge.problem.cones), default=0.0)
    return float(np.finfo(np.float64).eps) * largest


def _evidence(question: str, limits: Sequence[HoldingLimit]) -> Evidence:
    """Every draw that belongs to a case, compared with the linear programs. Raises RoutesDisagree, or CannotAnswer if
    there were too few."""
    compared = [(c, c.exact) for limit in limits for c in limit.compared if c.exact is not None]
    is_cut = any(cone.across >= 0 for c, _exact in compared for cone in c.edge.problem.cones)
    witness = CrossCheck(question, ROUTE, OF_PLANES if is_cut else TOLERANCE)
    for c, exact in compared:
        if _digits_lost(c) < witness.tolerance:
            witness.compare(c.draw, exact, c.edge.value)
    return witness.evidence()
