"""The answer that a finding is: its conditions, whether the model's own numbers break them, its value, its options.

A condition that does not change with the motion is judged at the start, one that does on the way to the event that is
asked for, in numbers.
"""

from __future__ import annotations

from collections.abc import Sequence
from contextlib import suppress
from dataclasses import replace
from fractions import Fraction
from functools import cached_property

from freebody.assess.verdict import Judgement
from freebody.errors import CannotAnswer
from freebody.language.expression import Expr, Symbol, number
from freebody.language.notation import reworded
from freebody.language.sentences import Message
from freebody.numeric.snapshot import Snapshot
from freebody.questions.reading import Question
from freebody.study.answering import loops
from freebody.study.answering.answer import WITHOUT_VALUE, Answer, Value, made
from freebody.study.answering.chain import n_terms_in_all
from freebody.study.answering.comparing import which_is_greater
from freebody.study.answering.conditions import as_written, at_instant, is_kinematic, real
from freebody.study.answering.crosscheck import element_at, holds
from freebody.study.answering.draws import Draw
from freebody.study.answering.finding import Elements, Finding, judged
from freebody.study.answering.integrals import special_functions_named
from freebody.study.answering.magnitude import magnitude
from freebody.study.answering.named_formulas import Chain
from freebody.study.answering.numbers import LONGEST, number_instead
from freebody.study.answering.scope import for_all
from freebody.study.answering.witness import motion_to, patience
from freebody.study.setup import Setup
from freebody.symbolic.conditions import Condition
from freebody.symbolic.on_the_way import MOVING, kept_until
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.reached import Reached
from freebody.symbolic.state import SymbolicState
from freebody.symbolic.tidy import tidy
from freebody.symbolic.validity import texts, validity

_READ_WHOLE = 200  # terms of a formula that is handed over in one piece beside its chain
_ROUND_OFF = 1e-12  # of an assembled pose, by the size of what is added up


class AnswerCompletion:
    """What is made of the finding of one question."""

    def __init__(
        self, setup: Setup, question: Question, state: SymbolicState | None = None, reached: Reached | None = None
    ) -> None:
        """state: the instant in which it was found, where it is one; reached: the event that the motion is followed
        to."""
        self.setup, self.question, self.state, self.reached = setup, question, state, reached

    def answer(self, found: Finding) -> Answer:
        """The answer that a finding is, with its conditions and what the model's own numbers make of it."""
        q = self.question
        if isinstance(found.element, Fraction):
            expression: Expr | tuple[Expr, ...] = number(found.element)
            value: Value = float(found.element)
            conditions: list[str] = []
            is_broken = False
        else:
            element = found.element
            chain = None if found.in_names is None else found.in_names.chain
            expression = self._expression(element, chain)
            value = self._value(element) if found.has_value else None
            needed = self.conditions(found, element)
            broken = self._violated(needed)
            found.notes += broken + loops.loops_in(self.setup, element, self.state, chain)
            if broken:
                value = self._where_a_divisor_vanishes(needed)
                found.notes += [] if value is None else [Message("the value is that of the simulated motion")]
            if q.quantity.compares and isinstance(element, Ratio):
                found.verdict = which_is_greater(element, needed, value)
            parts = element if isinstance(element, tuple) else (element,)
            found.notes += special_functions_named(parts)
            told = texts(needed, until_event=self.reached is not None)
            if found.in_names is not None and not self.setup.closing(self.setup.state):
                told = [*found.in_names.closing, *told]
            conditions = found.says + told or [for_all(self.setup.system, parts)]
            is_broken = bool(broken) and value is None
        judgement = self._judge(found.element)
        answer = made(
            q,
            expression,
            value,
            unit=found.unit,
            conditions=conditions,
            notes=found.notes,
            verdict=found.verdict,
            judgement=judgement,
            evidence=found.evidence,
            chain=None if found.in_names is None else found.in_names.chain,
        )
        return replace(answer, why_no_value=WITHOUT_VALUE) if is_broken else answer

    def _expression(self, element: Elements, chain: Chain | None) -> Expr | tuple[Expr, ...]:
        """The whole formula; by the names of its chain where nobody would read it."""
        parts = element if isinstance(element, tuple) else (element,)
        is_long = sum(map(n_terms_in_all, parts)) > _READ_WHOLE
        shown = chain.result if chain is not None and is_long else tuple(map(tidy, parts))
        return shown if isinstance(element, tuple) else shown[0]

    def conditions(self, found: Finding, element: Elements, root: int | None = None) -> list[Condition]:
        """Everything without which the answer is not true. root: which of several values the element is, where it is
        one of them."""
        if found.is_complete:
            return found.conditions
        q = self.question.quantity
        own = found.of_root if root is None else found.of_root[root : root + 1]
        conditions = [*found.conditions, *(c for needed in own for c in needed)]
        if not found.may_be_complex:
            conditions += real(element) if found.in_names is None else found.in_names.needs
        at_start = self.question.at_start
        state = self.setup.start_instant if at_start else self.setup.state
        if q.is_of_state:
            judges_contacts = bool(self.setup.system.applied_loads) or not is_kinematic(self.setup, q)
            needed = at_instant(self.setup, self.question, state, with_contacts=judges_contacts)
            if self.reached is not None:
                needed = self._on_the_way(self.reached, needed, state)
            conditions += needed
            if not judges_contacts and any(row.unilateral for row in self.setup.system.constraint_rows):
                found.notes.append(Message("no load acts, so contact forces and string tensions are not checked"))
        else:
            conditions += as_written(self.setup, self.question, state)
        return self.setup.in_free_coordinates(conditions, state, loops.SHORT)

    def _on_the_way(self, reached: Reached, needed: Sequence[Condition], state: SymbolicState) -> list[Condition]:
        """What conditions on the state come to from the start to the event."""
        closing = [c for c in needed if c in self.setup.closing(state)]
        found: list[Condition] = []
        for group in (closing, [c for c in needed if c not in closing]):
            free = self.setup.in_free_coordinates(group, state, loops.READABLE)
            found += kept_until(self.setup.motion, reached, free, closing=group is closing)
        return found

    def _where_a_divisor_vanishes(self, conditions: Sequence[Condition]) -> Value:
        """What a motion that is followed to an event gives by numbers where nothing but a divisor of its formula is
        zero, as in exact resonance: the motion itself has no gap there."""
        if self.reached is None or any(c.relation != "!=" and self._is_broken(c) for c in conditions):
            return None
        with suppress(CannotAnswer, ArithmeticError, ValueError):
            return number_instead(self.setup, self.question)
        return None

    def _violated(self, conditions: list[Condition]) -> list[str]:
        """Conditions that the model's own numbers break at the start; the answer is not true of that model."""
        broken = [c for c in conditions if self._is_given((c.element,)) and self._is_broken(c)]
        if not broken:
            return []
        parts = [c for c in validity(broken) if self._is_broken(c)] or broken  # a product is broken by one factor
        told = texts(parts, until_event=self.reached is not None)
        return [reworded(Message("Not valid for the given numbers: {text}", text=text), text) for text in told]

    def _is_broken(self, c: Condition) -> bool:
        """Whether the model's own numbers break a condition: at the start, or on the way to the event."""
        draw = self.setup.draws[0]
        for here in self._instants(c, draw):
            with suppress(CannotAnswer, ArithmeticError, ValueError):
                if not holds(self.setup, c, draw, here, round_off=_ROUND_OFF):
                    return True
        return False

    def _instants(self, c: Condition, draw: Draw) -> Sequence[Snapshot]:
        """At which a condition is judged in numbers: at the start, and what changes with the motion up to the event."""
        changes = any(c.element.field.generators[g].kind in MOVING for g in c.element.field.ingredients(c.element))
        return self._way_in_numbers if changes else [draw.start()]

    @cached_property
    def _way_in_numbers(self) -> Sequence[Snapshot]:
        """The motion at the model's own numbers, from the start to the event that is asked for."""
        draw, event = self.setup.draws[0], self.question.event
        start = draw.start()
        if event is None or self.reached is None:
            return [start]
        try:
            return [start, *motion_to(draw.reference, start, patience(start, LONGEST), event).links]
        except (CannotAnswer, ArithmeticError, ValueError):
            return [start]

    def _judge(self, element: Elements | Fraction) -> Judgement:
        if isinstance(element, Fraction) and self.question.quantity.scope == "structure" and self.question.options:
            with suppress(CannotAnswer):
                from freebody.study.mobility.mobility import judged as judged_by_count

                return judged_by_count(self.setup.system, self.question, int(element))
        return judged(self.question, element, self.setup.model, self.setup.system)

    def _is_given(self, parts: Sequence[Ratio]) -> bool:
        """Whether the file has numbers for all that stands in elements, and for all that the pose of the start hangs on
        where that stands in them: the lengths of its loops, not an open torque. The way to an event hangs on more."""
        if self.setup.has_values:
            return True
        field, system = self.setup.model.field, self.setup.system
        open_ = {Symbol(p.name) for p in system.parameters.values() if p.value is None and p.form is None}
        used = {g for part in parts for g in field.ingredients(part)}
        moving = {g for g in used if field.generators[g].kind in MOVING}
        decided = self._decided_at_start(moving) if moving else set[int]()
        return decided is not None and not any(field.generators[g].display in open_ for g in used | decided)

    def _decided_at_start(self, moving: set[int]) -> set[int] | None:
        """What the values of coordinates and speeds at the start are made of; None where that is not known."""
        if self.reached is not None:
            return None
        model = self.setup.model
        try:
            values = self.setup.start.values
        except (CannotAnswer, ZeroDivisionError):
            return None
        bound = {d.index for d in model.dependent}
        made = [values[g] for g in moving if g in values]
        if moving & bound - values.keys():  # it follows from the others
            made += [model.field.follow(loop.value, values) for loop in model.loops]
        found = {g for x in made for g in model.field.ingredients(x)}
        left = {g for g in moving | found if model.field.generators[g].kind in MOVING} - values.keys()
        return found if left <= bound else None

    def _value(self, element: Elements) -> Value:
        draw = self.setup.draws[0]
        field = self.setup.model.field
        parts = element if isinstance(element, tuple) else (element,)
        try:
            # exactly at the start where it has a formula, so that a zero is a zero
            parts = tuple(field.follow(p, self.setup.start.values) for p in parts)
        except ZeroDivisionError:
            return None
        except CannotAnswer:
            pass
        if not self._is_given(parts):
            return None
        try:
            values = element_at(self.setup, parts, draw, draw.start())
        except (CannotAnswer, ArithmeticError, ValueError):
            return None
        q = self.question.quantity
        size = 0.0 if q.wanted is not None else magnitude(q.dimension, draw.seen(draw.start())) or 1.0
        small = _ROUND_OFF * size  # a parameter is not added up from what moves
        pairs = zip(parts, values, strict=True)
        values = tuple(0.0 if abs(v) < small or self._cancels(part) else v for part, v in pairs)
        return values if isinstance(element, tuple) else values[0]

    def _cancels(self, part: Ratio) -> bool:
        """Whether it is zero for the decimals as they are written: 4 * 0.3 - 6 * 0.2 is not so in binary numbers."""
        field, draw = self.setup.model.field, self.setup.draws[0]
        if any(field.generators[g].kind != "parameter" for g in field.ingredients(part)):
            return False
        numbers = self.setup.model.samples.numbers(draw.sample())
        return field.evaluate(part, {g: Fraction(repr(numbers[g])) for g in field.ingredients(part)}) == 0
