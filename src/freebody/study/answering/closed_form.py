"""One question in closed form: a formula is found, the conditions under which it is true are gathered, both routes are
compared, options are judged."""

from __future__ import annotations

from contextlib import suppress
from dataclasses import dataclass, field, replace
from fractions import Fraction
from functools import singledispatchmethod
from typing import TYPE_CHECKING, Any

from freebody.assess.options import judge
from freebody.errors import BudgetExhausted, CannotAnswer, NeverHappens, RoutesDisagree
from freebody.language.expression import ZERO, Expr, number
from freebody.language.notation import compared, joined, reworded
from freebody.language.sentences import Message, further
from freebody.measures.combination import Composed
from freebody.progress import busy_with
from freebody.questions.base import Quantity
from freebody.questions.freedom import DegreesOfFreedom
from freebody.questions.reading import Question
from freebody.questions.small_motion import Equilibrium, SmallOscillations
from freebody.study.answering import evidence as proof
from freebody.study.answering.answer import Answer, Evidence
from freebody.study.answering.magnitude import magnitude
from freebody.study.answering.passage import FormulaPassage
from freebody.study.answering.scope import for_all
from freebody.study.eom import primitive_part
from freebody.study.setup import Setup
from freebody.study.worded import FAILED, cause
from freebody.symbolic.conditions import Condition, require
from freebody.symbolic.equilibrium import ClosedFormRest, find_equilibrium, small_oscillations
from freebody.symbolic.existence import exists
from freebody.symbolic.field import Ratio
from freebody.symbolic.state import SymbolicState
from freebody.symbolic.tidy import tidy
from freebody.symbolic.unknowns import Coordinate
from freebody.symbolic.validity import texts
from freebody.symbolic.written import HasNoValue, has_values

if TYPE_CHECKING:
    pass


Elements = Ratio | tuple[Ratio, ...]
_ROUND_OFF = 1e-12  # of an assembled pose, by the size of what is added up


@dataclass
class _ClosedForm:
    """A closed form on its way to an answer."""

    element: Elements | Fraction
    evidence: Evidence
    conditions: list[Condition] = field(default_factory=list[Condition])
    notes: list[str] = field(default_factory=list[str])
    up_to_constant: bool = False
    at_start: bool = False
    says: list[str] = field(default_factory=list[str])  # conditions in words
    may_be_complex: bool = False  # roots in it need not be real
    unit: str | None = None  # where it is not that of the quantity
    has_value: bool = True  # at the model's own numbers and start


class QuestionSolver:
    """Answers one question."""

    def __init__(self, setup: Setup, question: Question) -> None:
        self.setup = setup
        self.system = setup.system
        self.model = setup.model
        self.question = question

    def answer(self) -> Answer:
        busy_with(f"answering {self.question.id}: {self.question.text}")
        with self.model.samples.apart():  # what one question takes to be positive is no condition of the next
            return self._answer()

    def _answer(self) -> Answer:
        q = self.question
        if q.quantity.scope == "every motion":
            return self._conserved()
        if q.quantity.scope == "rest":
            from freebody.study.friction.answers import answer

            return answer(self.system, q)
        try:
            return self._finish(self._find())
        except NeverHappens as error:
            return Answer(q.id, q.text, None, self._unit(), None, reason=str(error), never=True)
        except HasNoValue as error:
            return Answer(q.id, q.text, None, self._unit(), None, reason=str(error))
        except (CannotAnswer, *FAILED) as error:
            reason = str(error) if isinstance(error, CannotAnswer) else cause(self.system, error)
            value, unfinished = self._number_instead()
            return Answer(q.id, q.text, None, self._unit(), value, reason=further(reason, *unfinished))
        except RoutesDisagree as error:
            return Answer(q.id, q.text, None, self._unit(), None, reason=str(error))

    def _conserved(self) -> Answer:
        """The rate of the quantity, and whether it vanishes; `study/conservation/conserved.py` has more to say."""
        from freebody.study.conservation.conserved import Judge

        q = self.question
        found = Judge(self.setup).answer(q)
        answer = Message("conserved for every motion") if found.is_conserved else Message("not conserved")
        if found.is_conserved is None:
            answer = found.verdict
        c = found.confirmation
        return Answer(
            q.id,
            q.text,
            found.rate,
            q.quantity.unit,
            0.0 if found.rate == number(0) else None,
            conditions=() if found.reason else (answer,),
            notes=(Message("this is its rate"), *found.notes) if found.rate is not None else found.notes,
            reason=found.reason or (further(*found.notes) if found.rate is None else ""),
            choice=found.choice,
            options=found.options,
            author_notes=found.author_notes,
            evidence=None if c is None else Evidence(c.motions, c.largest_drift or 0.0, c.route),
            why_no_value=Message("the rate depends on the motion"),
        )

    def _number_instead(self) -> tuple[float | tuple[float, ...] | None, tuple[str, ...]]:
        """The value of the numeric route where there is no closed form, at the start or at the event; and what is to be
        said where a budget was exhausted on the way."""
        q = self.question
        if not self.setup.has_values or q.quantity.scope == "steady motion":
            return None, ()
        try:
            return proof.number(self.setup, q.quantity, q.event), ()
        except BudgetExhausted as error:
            return None, (str(error),)
        except (CannotAnswer, ArithmeticError, ValueError):
            return None, ()

    def _find(self) -> _ClosedForm:
        q = self.question.quantity
        if self.question.at_start or self.question.event is not None:
            self._as_written(q, self.setup.start_instant)  # refuses a start at which the file says nothing
        if q.scope == "steady motion":
            return self._steady()
        if self.question.event is not None:
            return self._at_event(q)
        return self._found(q)

    # -- one instant --------------------------------------------------------------------------
    @singledispatchmethod
    def _found(self, q: Quantity) -> _ClosedForm:
        """By the kind of question: what has no finder of its own is a property of an instant."""
        at_start = self.question.at_start
        x = self._elements(q, self._start_of(q) if at_start else self.setup.state)
        evidence = proof.at_instants(self.setup, self.question.text, q, x, at_start=at_start)
        remark = q.remark(self.system)
        notes = [remark] if remark else []
        return _ClosedForm(x, evidence, notes=notes, up_to_constant=q.is_up_to_constant, at_start=at_start)

    @_found.register(DegreesOfFreedom)
    def _freedom(self, q: DegreesOfFreedom) -> _ClosedForm:
        dof = self.model.degrees_of_freedom
        return _ClosedForm(Fraction(dof), proof.freedom(self.setup, self.question.text, dof))

    def _start_of(self, q: Quantity) -> SymbolicState:
        """The start; for an instant centre with one freedom, whose speed cancels, the pose at the start."""
        if not q.is_of_pose_in_motion or self.model.degrees_of_freedom != 1:
            return self.setup.start_instant
        speeds = {c.speed for c in (*self.model.coordinates, *self.model.dependent)}
        values = self.setup.start.values
        return SymbolicState(self.model, {k: x for k, x in values.items() if k not in speeds})

    def _elements(self, q: Quantity, state: SymbolicState) -> Elements:
        value = q.value(self.system, state)
        f = self.model.field
        if isinstance(value, tuple):
            return tuple(f.lowest_terms(f.element(v)) for v in value)  # type: ignore[arg-type]
        return f.lowest_terms(f.element(value))

    # -- an event along the motion ------------------------------------------------------------
    def _at_event(self, q: Quantity) -> _ClosedForm:
        event = self.question.event
        assert event is not None
        reached = self.setup.motion.reach(event)
        conditions: list[Condition] = []
        for x, relation in reached.conditions:
            condition, possible = require(x, relation, Message("{event} is reached", event=event.text))
            if not possible:
                raise NeverHappens(Message("{event} is never reached after the start", event=event.text))
            if condition is not None:
                conditions.append(condition)
        x: Ratio = q.counted(FormulaPassage(self.setup, reached, self._elements))
        self._check_is_told(x)
        # a formula with signs that were taken at the start is compared only where they are so, there and at the event
        there = SymbolicState(self.model, self.setup.motion.known_at(reached))
        begins, ends = (self.setup.holding(s, with_contacts=False) for s in (self.setup.start_instant, there))
        ends = [c for c in ends if not self._moving_in(c.element)]
        evidence = proof.along_motion(
            self.setup,
            self.question.text,
            q,
            event,
            x,
            reached.time,
            [*conditions, *self._root_conditions(x)],
            [*begins, *ends],
        )
        return _ClosedForm(x, evidence, conditions + ends, reached.notes, at_start=True, says=reached.says)

    def _check_is_told(self, x: Ratio) -> None:
        """Raises CannotAnswer where coordinates are left whose values at the event are not known."""
        if left := self._moving_in(x):
            raise CannotAnswer(
                Message(
                    "the quantity depends on {names} as well, for whose values at the event no closed form was found",
                    names=", ".join(c.name for c in left),
                )
            )

    def _moving_in(self, x: Ratio) -> list[Coordinate]:
        everything = (*self.model.coordinates, *self.model.dependent)
        return [c for c in everything if self.model.field.ingredients(x) & {c.index, c.speed}]

    # -- small oscillations and equilibrium ---------------------------------------------------
    @_found.register(SmallOscillations)
    def _small(self, q: SmallOscillations) -> _ClosedForm:
        found = small_oscillations(self.model, self.setup.start)
        f = self.model.field
        conditions: list[Condition] = [*found.rest.exists]
        for square in found.squares:
            if square.is_zero() and q.what == "frequencies":
                continue  # it moves on evenly
            condition, possible = require(square, ">", Message("oscillates"))
            if not possible:
                raise CannotAnswer(further(*found.notes, Message("there is no oscillation about it: it is unstable")))
            if condition is not None:
                conditions.append(condition)
        if q.what != "frequencies" and len(found.squares) != 1:
            raise CannotAnswer(
                Message("there are {n} natural frequencies; ask for natural frequencies", n=len(found.squares))
            )
        is_period = q.what == "period"
        if is_period:
            element: Elements = 2 * f.pi * f.sqrt(1 / found.squares[0], self.model.samples.is_negative)
        else:
            roots = [f.sqrt(s, self.model.samples.is_negative) for s in found.squares]
            element = roots[0] if len(roots) == 1 else tuple(roots)
        evidence = proof.small_oscillations(
            self.setup, self.question.text, element, found.equilibrium, period=is_period
        )
        return _ClosedForm(element, evidence, conditions, list(found.notes), at_start=True)

    @_found.register(Equilibrium)
    def _equilibrium(self, q: Equilibrium) -> _ClosedForm:
        rest = find_equilibrium(self.model, self.setup.start, stable_first=False)
        x = SymbolicState(self.model, rest.values).value(q.measure)
        evidence = proof.at_rest(self.setup, self.question.text, rest.values, x)
        return _ClosedForm(x, evidence, [*rest.exists], self._stability(rest), at_start=True)

    def _stability(self, rest: ClosedFormRest) -> list[str]:
        """What is to be said of it, with the condition where there is one."""
        if rest.is_stable is None:
            return [Message("whether this equilibrium is stable does not follow from the linearised equations")]
        where = joined(texts([replace(c, purpose="") for c in rest.stable]))
        if not where:
            return [] if rest.is_stable else [Message("this equilibrium is not stable")]
        if not self.setup.has_values:
            return [reworded(Message("this equilibrium is stable if {condition}", condition=where), where)]
        verdict = (
            Message("this equilibrium is stable if {condition}: with the given numbers it is stable", condition=where)
            if rest.is_stable
            else Message(
                "this equilibrium is stable if {condition}: with the given numbers it is not stable", condition=where
            )
        )
        return [reworded(verdict, where)]

    # -- what goes on evenly ------------------------------------------------------------------
    def _steady(self) -> _ClosedForm:
        from freebody.study.steady.ask import find

        x = find(self.setup, self.question)
        return _ClosedForm(
            x.element,
            x.evidence,
            x.conditions,
            x.notes,
            at_start=True,
            says=x.says,
            may_be_complex=x.may_be_complex,
            unit=x.unit,
            has_value=x.has_value,
        )

    # -- conditions ---------------------------------------------------------------------------
    def _root_conditions(self, x: Elements) -> list[Condition]:
        """Every divisor, root and arc in the shown form."""
        return exists(x if isinstance(x, tuple) else (x,))

    def _finish(self, found: _ClosedForm) -> Answer:
        q = self.question
        if isinstance(found.element, Fraction):
            expression: Expr | tuple[Expr, ...] = number(found.element)
            value: float | tuple[float, ...] | None = float(found.element)
            conditions: list[str] = []
        else:
            element = found.element
            expression = tuple(map(tidy, element)) if isinstance(element, tuple) else tidy(element)
            value = self._value(element) if found.has_value else None
            needed = self._conditions(found, element)
            broken = self._violated(needed)
            found.notes += broken + self._loop_notes(element)
            value = None if broken else value
            parts = element if isinstance(element, tuple) else (element,)
            conditions = found.says + texts(needed) or [for_all(self.system, parts)]
        judgement = self._judge(found) if q.options else None
        return Answer(
            q.id,
            q.text,
            expression,
            self._unit() if found.unit is None else found.unit,
            value,
            tuple(conditions),
            tuple(found.notes),
            choice=None if judgement is None else judgement.choice,
            options={} if judgement is None else judgement.options,
            author_notes=() if judgement is None else judgement.notes,
            evidence=found.evidence,
        )

    def _loop_notes(self, element: Elements) -> list[str]:
        """The closed loops, where an answer contains coordinates that they bind."""
        bound = {c.index for c in self.model.dependent} | {c.speed for c in self.model.dependent}
        parts = element if isinstance(element, tuple) else (element,)
        if not any(self.model.field.ingredients(part) & bound for part in parts):
            return []
        zeros = [compared(ZERO, "=", tidy(primitive_part(loop.value))) for loop in self.model.loops]
        return [reworded(Message("with {zero}", zero=zero), zero) for zero in zeros]

    def _conditions(self, found: _ClosedForm, element: Elements) -> list[Condition]:
        """Everything without which the answer is not true."""
        q = self.question.quantity
        conditions = [*found.conditions]
        if not found.may_be_complex:
            conditions += self._root_conditions(element)
        at_start = self.question.at_start
        state = self.setup.start_instant if at_start else self.setup.state
        if q.is_of_state:
            judges_contacts = bool(self.system.pushes) or not self._is_kinematic(q)
            conditions += self.setup.holding(state, with_contacts=judges_contacts) + self.setup.closing(state)
            if not judges_contacts and any(row.unilateral for row in self.system.held):
                found.notes.append(Message("no load acts, so it is not judged whether contacts and strings hold"))
        conditions += self._as_written(q, state)
        return self.setup.in_free_coordinates(conditions, state)

    def _as_written(self, q: Quantity, state: SymbolicState) -> list[Condition]:
        """Where the file's own expressions have values: in the state that is asked for, and where an event is asked
        for at the start."""
        measures = [m for m in (getattr(q, "measure", None),) if isinstance(m, Composed)]
        rests = q.scope == "small motion"
        if not (rests or q.is_of_state):
            return []
        if rests:
            values = find_equilibrium(self.model, self.setup.start, stable_first=q.is_about_stable).values
            state = SymbolicState(self.model, values)
        elif self.question.event is not None:
            state = self.setup.start_instant
        return has_values(state, measures, with_loads=not self._is_kinematic(q) or self.question.event is not None)

    def _is_kinematic(self, q: Quantity) -> bool:
        """Whether the quantity follows from geometry alone."""
        order = q.kinematic_order
        return order is not None and (order < 2 or self.model.degrees_of_freedom == 0)

    def _violated(self, conditions: list[Condition]) -> list[str]:
        """Conditions that the model's own numbers break at the start; the answer is not true of that model."""
        if not self.setup.has_values:
            return []
        draw = self.setup.draws[0]
        start = draw.start()
        broken: list[Condition] = []
        for c in conditions:
            with suppress(CannotAnswer, ArithmeticError, ValueError):
                if not proof.holds(self.setup, c, draw, start, round_off=_ROUND_OFF):
                    broken.append(c)
        return [reworded(Message("Not valid for the given numbers: {text}", text=text), text) for text in texts(broken)]

    def _judge(self, found: _ClosedForm) -> Any:
        element: Any = found.element
        if self.question.quantity.scope == "structure":
            with suppress(CannotAnswer):
                from freebody.study.mobility.mobility import judged

                return judged(self.system, self.question, int(element))
        dimension = self.question.quantity.dimension
        return judge(self.question, element, dimension, self.model, self.system, up_to_constant=found.up_to_constant)

    def _value(self, element: Elements) -> float | tuple[float, ...] | None:
        if not self.setup.has_values:
            return None
        draw = self.setup.draws[0]
        field = self.model.field
        parts = element if isinstance(element, tuple) else (element,)
        try:
            # exactly at the start where it has a formula, so that a zero is a zero
            parts = tuple(field.follow(p, self.setup.start.values) for p in parts)
        except ZeroDivisionError:
            return None
        except CannotAnswer:
            pass
        try:
            values = proof.element_at(self.setup, parts, draw, draw.start())
        except (CannotAnswer, ArithmeticError, ValueError):
            return None
        small = _ROUND_OFF * (magnitude(self.question.quantity.dimension, draw.seen(draw.start())) or 1.0)
        values = tuple(0.0 if abs(v) < small else v for v in values)
        return values if isinstance(element, tuple) else values[0]

    def _unit(self) -> str:
        return self.question.quantity.unit
