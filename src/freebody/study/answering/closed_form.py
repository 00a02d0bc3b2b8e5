"""One question in closed form: a formula is found, the conditions under which it is true are gathered, both routes are
compared, options are judged."""

from __future__ import annotations

from contextlib import suppress
from dataclasses import replace
from fractions import Fraction
from typing import cast

from freebody.assess.verdict import Judgement
from freebody.errors import CannotAnswer, FormulaTooDear, FormulaTooLong, NotReached
from freebody.language.expression import ZERO, n_operations, number
from freebody.language.notation import Stated, to_python, to_text
from freebody.language.sentences import Message, further
from freebody.questions.base import Quantity, Wanted
from freebody.questions.clock import Clock
from freebody.questions.event_base import QuestionEvent
from freebody.questions.happening import (
    ExistingEquilibrium,
    ExistingSteadyMotion,
    StableEquilibrium,
    StableSteadyMotion,
)
from freebody.questions.motion import OfMeasure, Staying
from freebody.questions.reading import Question
from freebody.questions.small_motion import OfSmallMotion
from freebody.study.answering import about_rest
from freebody.study.answering.answer import ITS_RATE, Answer, Evidence, Value, made, point_moves
from freebody.study.answering.at_events import FindingAtEvents
from freebody.study.answering.completing import AnswerCompletion
from freebody.study.answering.conditions import as_written, is_kinematic
from freebody.study.answering.energy_in_names import answer_by_energy
from freebody.study.answering.extent import as_reached, turning_there
from freebody.study.answering.finding import Elements, Finding, answered
from freebody.study.answering.frequency_in_names import frequency_about_a_found_rest, frequency_in_names
from freebody.study.answering.in_names import answer_in_names
from freebody.study.answering.numbers import number_instead
from freebody.study.answering.rest_in_names import answer_at_rest
from freebody.study.answering.staying import check_stays
from freebody.study.setup import Setup
from freebody.symbolic.conditions import Condition
from freebody.symbolic.dynamics import NothingWithMass
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.tidy import tidy
from freebody.system.system import System

_MOST_READ = 150  # operations of a frequency that is told in one piece where it has a chain


def with_verdict(setup: Setup, question: Question, found: Answer) -> Answer:
    """What numbers say of a question that asks whether, where there is no formula, and of the sign of an extreme."""
    q, event = question.quantity, question.event
    is_extreme = q.of_what_stays is not None and q.wanted is None
    if is_extreme and event is not None and not found.is_missed and found.value is not None:
        from freebody.study.answering.extremes_until import said_of_sign

        return replace(found, notes=(*found.notes, *said_of_sign(setup, q, event)))
    if not isinstance(q, OfSmallMotion) or not setup.has_values or found.is_missed:
        return found
    from freebody.study.small_motion.numbers import said_of_numbers

    with suppress(CannotAnswer, ArithmeticError, ValueError):
        verdict, notes = said_of_numbers(q, setup)
        return replace(found, verdict=verdict, notes=(*found.notes, *notes))
    return found


class QuestionSolver(FindingAtEvents):
    """Answers one question. otherwise: where no closed form is found this way."""

    def answer(self) -> Answer:
        with self.model.samples.apart():  # what one question takes to be positive is no condition of the next
            return self._answer()

    def _answer(self) -> Answer:
        match self.question.quantity.scope:
            case "every motion":
                return answered(self.system, self.question, self._conserved)
            case _:
                found = answered(self.system, self.question, self._smooth, self._number_instead, self._otherwise)
                return found if found.is_complete else with_verdict(self.setup, self.question, found)

    def _smooth(self) -> Answer:
        try:
            found = self._find()
            with suppress(CannotAnswer):
                if self._is_unread(found) and (named := frequency_in_names(self.setup, self.question)) is not None:
                    return named
            return self.finish(found)
        except FormulaTooLong as error:
            named = answer_in_names(self.setup, self.question, self._reached)
            named = named or frequency_in_names(self.setup, self.question)
            named = named or answer_by_energy(self.setup, self.question)
            if named is not None:
                return named
            if self.has_loops or not isinstance(error, FormulaTooDear):
                raise
            self._pairs = None  # without loops it has no chain: then in one piece, whatever that takes
            return self.finish(self._find())

    def _is_unread(self, found: Finding) -> bool:
        """Whether it is a frequency whose formula nobody would read."""
        q, x = self.question.quantity, found.element
        return q.is_frequency and isinstance(x, Ratio) and n_operations(tidy(x)) > _MOST_READ

    def _otherwise(self) -> Answer | None:
        """Where no closed form is found: by a chain, in the pose of the start or at a place in numbers, else as whoever
        asks tells."""
        from freebody.study.steady.extremes_in_names import extreme_in_names

        found = answer_at_rest(self.setup, self.question) or extreme_in_names(self.setup, self.question)
        found = found or frequency_about_a_found_rest(self.setup, self.question)
        return found if found is not None or self.otherwise is None else self.otherwise()

    def _conserved(self) -> Answer:
        """The rate of the quantity, and whether it vanishes; `study/conservation/conserved.py` has more to say."""
        from freebody.study.conservation.balance import CARRIED
        from freebody.study.conservation.judge import Judge

        found = Judge(self.setup).answer(self.question)
        c, blow = found.confirmation, list[str]()
        if self.system.is_struck:
            blow.append(
                Message("this is meant of the motion after the blow; of the blow ask: is ... conserved in the blow")
            )
        is_zero = found.rate == number(0)
        notes = [*blow, *([ITS_RATE] if found.rate is not None else [])]
        for term in () if found.rate is None else (part for what, part in found.parts if what == CARRIED):
            words = point_moves(to_text(term))
            notes.append(Stated(words, to_python(term)))
        return made(
            self.question,
            found.rate,
            0.0 if is_zero else None,
            conditions=() if found.reason else (found.verdict,),
            notes=(*notes, *found.notes),
            reason=found.reason or (further(*found.notes) if found.rate is None else ""),
            judgement=Judgement(found.choice, found.options, found.author_notes),
            evidence=None if c is None else Evidence(c.motions, c.largest_drift or 0.0, c.route),
            why_no_value="" if is_zero else Message("the rate depends on the motion"),
        )

    def _number_instead(self) -> Value:
        return number_instead(self.setup, self.question)

    def _find(self) -> Finding:
        q = self.question.quantity
        is_given = q.scope == "steady motion"  # an event there is what the motion is said to keep
        if self.question.at_start or (self.question.event is not None and not is_given):
            as_written(self.setup, self.question, self.setup.start_instant)  # refuses where the file says nothing
        if q.wanted is not None:
            return self._turned_round(q.wanted)
        if q.scope == "steady motion":
            return self._steady()
        if q.scope == "linkage":
            from freebody.study.mobility import loop_answers

            self._look(loop_answers.looked_at(self.setup, self.question))
            return loop_answers.find(self.setup, self.question)
        if q.is_of_answers:
            return self._of_answers(q)
        if self.question.event is not None:
            try:
                return self._at_event(q)
            except NothingWithMass:
                if (found := self._in_given_pose(q)) is None:
                    raise
                return found
            except NotReached:
                if (found := self._as_it_dies_out(q)) is None:
                    raise
                return found
        needs_forces = not is_kinematic(self.setup, q)
        if needs_forces and self.model.dynamics.moves_no_mass and (found := self._where_it_starts(q)) is not None:
            return found
        try:
            return self._found(q)
        except (NothingWithMass, FormulaTooLong):
            if not self.question.at_start or (found := self._where_it_starts(q)) is None:
                raise
            return found

    def _where_it_starts(self, q: Quantity) -> Finding | None:
        """What is asked at an instant, in the pose of the start if it rests there."""
        found = about_rest.value_where_it_starts(self.setup, self.question, q)
        if found is not None:
            self.question = replace(self.question, at_start=True)
            return found
        return self._balanced(q) if self.model.dynamics.moves_no_mass else None

    def _as_it_dies_out(self, q: Quantity) -> Finding | None:
        """What a motion tends to where it is asked of its rest, which it only comes near to: resisted by its rate it
        has a rate that tends to zero. None where that is not so."""
        event = self.question.event
        is_of_rest = isinstance(event, QuestionEvent) and event.order == 1 and event.value == ZERO
        if not isinstance(event, QuestionEvent) or not is_of_rest or not q.is_of_state or q.is_of_event:
            return None
        rate, later = OfMeasure(event.measure, 1, event.text), replace(self.question, event=Clock(None, "t grows"))
        limit = QuestionSolver(self.setup, replace(later, quantity=rate))._find()
        if not isinstance(limit.element, Ratio) or not limit.element.is_zero():
            return None
        solver = QuestionSolver(self.setup, later)
        found = solver._find()
        self.question, self._state, self._reached = solver.question, solver._state, solver._reached
        told = Message("it comes to rest only as the time grows: this is what it tends to")
        return replace(found, notes=[told, *found.notes])

    def _in_given_pose(self, q: Quantity) -> Finding | None:
        """Where nothing with mass moves, an event names a pose, whatever leads there; None where it does not, or what
        is asked is a rate."""
        if q.kinematic_order not in (0, None) and not q.is_of_pose_in_motion:
            return None
        if (there := about_rest.placed_at(self.setup, self.question)) is None:
            return None
        setup = Setup(there)
        if not about_rest.is_reached(self.setup, setup):
            return None
        solver = QuestionSolver(setup, replace(self.question, event=None, at_start=True))
        found = solver._find()
        self._look(solver.setup)
        self.question, self._state = solver.question, solver._state
        return found

    def _of_answers(self, q: Quantity) -> Finding:
        """Made of what is found for each operand, each with its own conditions."""
        from freebody.study.answering.of_answers import found_of

        def found(part: Question) -> tuple[Finding, list[Condition]]:
            solver = QuestionSolver(self.setup, part)
            finding = solver._find()
            if not isinstance(finding.element, Ratio) or solver.setup is not self.setup:
                raise CannotAnswer(Message("an operand is told over a turn, or has several values: ask for it alone"))
            return finding, solver._completion().conditions(finding, finding.element)

        return found_of(self.setup, self.question, found)

    def _turned_round(self, q: Wanted) -> Finding:
        """The formula of what is to have a value, solved for a parameter."""
        from freebody.study.answering.formula import Formula
        from freebody.study.answering.of_parameter import depends_on, solved_for
        from freebody.study.answering.turned_round import first_found

        asked = replace(self.question, quantity=q.of, options={}, key=None)
        if q.of.scope == "linkage":
            from freebody.study.mobility.loop_answers import holds

            return solved_for(self.setup, self.question, [holds(q.of, self.setup)])
        if isinstance(q.of, StableEquilibrium):
            from freebody.study.small_motion.stable_for import stability

            return solved_for(self.setup, self.question, stability(self.setup, is_so=q.of.is_so))

        if isinstance(q.of, ExistingEquilibrium):
            from freebody.study.small_motion.ask import about_mean
            from freebody.study.small_motion.exists_for import existence as of_rest

            self._look(about_mean(self.setup))
            return solved_for(self.setup, self.question, of_rest(self.setup, is_so=q.of.is_so))

        if isinstance(q.of, StableSteadyMotion):
            from freebody.study.steady.stable_for import stability as steady_stability

            return solved_for(
                self.setup, self.question, steady_stability(self.setup, self.question.event, is_so=q.of.is_so)
            )

        if isinstance(q.of, ExistingSteadyMotion):
            from freebody.study.steady.exists_for import existence, left_out

            formulas = existence(self.setup, self.question, q.parameter, is_so=q.of.is_so)
            found = solved_for(self.setup, self.question, formulas)
            return replace(found, notes=[*left_out(self.setup, self.question), *found.notes])

        if q.of.scope == "steady motion":
            from freebody.study.steady.place_for import at_place

            if formulas := at_place(self.setup, self.question):
                return solved_for(self.setup, self.question, formulas)

        def attempt(system: System) -> Finding:
            setup = self.setup if system is self.system else Setup(system)
            setup.motion.is_told_as(self.setup.motion)
            stays = [check_stays(setup, q.of)] if isinstance(q.of, Staying) else []
            formula = QuestionSolver(setup, asked)
            found = formula._find()
            is_of_turn = formula.question.quantity.is_of_turn
            is_elsewhere = formula.setup is not setup and (q.of.scope == "instant" or q.of.at_rest is not None)
            # over a turn that of the motion without its drive, at rest that of the pose with the load that balances
            setup = formula.setup if is_of_turn or is_elsewhere else setup
            roots = _roots(q.of, found.element)
            needs = formula._completion().conditions
            needed = [[] if isinstance(x, Fraction) else needs(found, x, k) for k, x in enumerate(roots)]
            is_range = is_of_turn and q.relation != "="
            in_place = q.of.scope != "steady motion" and not is_range  # what goes on evenly has a route of its own
            always = needed
            if is_range and depends_on(setup, q.parameter, needed) and found.cases is not None:
                plain = replace(found, conditions=[*found.cases.always])
                roots = tuple(x for x, _where in found.cases.each)
                always = [needs(plain, x) for x in roots]
                needed = [[*own, *where] for own, (_x, where) in zip(always, found.cases.each, strict=True)]
            if is_range and depends_on(setup, q.parameter, always):
                told = Message(
                    "where the extreme of a turn is changes with {name}; ask for the value of {name} at which it is so",
                    name=q.parameter,
                )
                raise CannotAnswer(told)
            formulas = [
                Formula(x, n, lambda: found.evidence, is_put_back=in_place) for x, n in zip(roots, needed, strict=True)
            ]
            if formula._holds_once:
                self.question = replace(self.question, event=None, at_start=True)
            elif formula.question.at_start:  # nothing can move, and what is so at the start stays so
                self.question = replace(self.question, event=formula.question.event, at_start=True)
            answer = solved_for(setup, self.question, formulas)
            answer.notes += stays
            self.setup, self.model, self.system = setup, setup.model, setup.system
            return answer

        try:
            return first_found(self.system, q.parameter, attempt)
        except CannotAnswer as error:
            reached, balanced = as_reached(self.question, q), None
            if reached is None:
                balanced = about_rest.as_balanced(self.system, self.question, q)
            if reached is None and (balanced is None or len(self.model.coordinates) != 1):
                raise
            system, asked = balanced or (self.system, cast("Question", reached))
            solver = QuestionSolver(Setup(system), asked)
            found = solver._find()
            self.setup, self.model = solver.setup, solver.model
            if reached is not None:
                turning = turning_there(self.setup, self.question, q, found)
                if turning is None:
                    raise error from None
                return replace(turning, notes=[])
            told = Message("the forces balance there; whether it is stable is another question")
            return replace(found, notes=[told])

    # -- the answer ---------------------------------------------------------------------------
    def finish(self, found: Finding) -> Answer:
        """The answer that a finding is, with its conditions and what the model's own numbers make of it."""
        answer = self._completion().answer(found)
        return replace(answer, holds_once=True) if self._holds_once else answer

    def _completion(self) -> AnswerCompletion:
        return AnswerCompletion(self.setup, self.question, self._state, self._reached)


def _roots(q: Quantity, x: Elements | Fraction) -> tuple[Elements | Fraction, ...]:
    """Of what was found, each thing that may be meant."""
    return x if isinstance(x, tuple) and q.is_any_of_several else (x,)
