"""One question in closed form: a formula is found, the conditions under which it is true are gathered, both routes are
compared, options are judged."""

from __future__ import annotations

from collections.abc import Sequence
from contextlib import suppress
from dataclasses import replace
from fractions import Fraction
from functools import partial, singledispatchmethod
from typing import NoReturn, cast

from freebody.assess.verdict import Judgement
from freebody.budgets import allowed
from freebody.errors import CannotAnswer, FormulaTooDear, FormulaTooLong, NeverHappens
from freebody.language.expression import n_operations, number
from freebody.language.notation import Stated, to_python, to_text
from freebody.language.sentences import Message, further
from freebody.questions.base import Quantity, Wanted
from freebody.questions.clock import Clock
from freebody.questions.event import FarthestPlace
from freebody.questions.extent import Extent, ExtremeOfMotion
from freebody.questions.freedom import DegreesOfFreedom
from freebody.questions.greatest_section import GreatestInRod
from freebody.questions.happening import ExistingSteadyMotion, StableEquilibrium, StableSteadyMotion
from freebody.questions.motion import Staying
from freebody.questions.period import Period
from freebody.questions.reading import AskedEvent, Question, QuestionEvent
from freebody.questions.small_motion import Equilibrium, OfSmallMotion, RestValue, SmallOscillations
from freebody.questions.steady import Extremes
from freebody.study.answering import about_rest, loops
from freebody.study.answering import evidence as proof
from freebody.study.answering.answer import ITS_RATE, Answer, Evidence, Value, made, point_moves
from freebody.study.answering.chain import chain_of, n_terms_in_all
from freebody.study.answering.completing import AnswerCompletion
from freebody.study.answering.conditions import as_written, is_kinematic, real
from freebody.study.answering.energy_in_names import answer_by_energy
from freebody.study.answering.extent import as_reached, turn_of, turning_there
from freebody.study.answering.finding import Elements, Finding, NotHere, Otherwise, answered
from freebody.study.answering.frequency_in_names import frequency_about_a_found_rest, frequency_in_names
from freebody.study.answering.in_names import answer_in_names
from freebody.study.answering.integrals import has_integrals
from freebody.study.answering.numbers import number_instead
from freebody.study.answering.passage import smooth_passage
from freebody.study.answering.staying import check_stays
from freebody.study.setup import Setup
from freebody.symbolic.conditions import Condition, insisted, require
from freebody.symbolic.dynamics import NothingWithMass
from freebody.symbolic.field import Ratio
from freebody.symbolic.on_the_way import kept_until
from freebody.symbolic.reached import HoldsOnce, Reached
from freebody.symbolic.signs import Sign, sign_of
from freebody.symbolic.state import StagedState, SymbolicState
from freebody.symbolic.tidy import tidy
from freebody.symbolic.unknowns import Coordinate
from freebody.symbolic.written import HasNoValue
from freebody.system.system import System

_MOST_PAIRS = 10_000_000  # of terms that quotients compare: a formula that takes more is read as a chain only
_MOST_READ = 150  # operations of a frequency that is told in one piece where it has a chain
_SWOLLEN = 60  # terms from which on a formula at an event is tried with the loops solved first


def with_verdict(setup: Setup, q: Quantity, found: Answer) -> Answer:
    """What numbers say of a question that asks whether, where there is no formula."""
    if not isinstance(q, OfSmallMotion) or not setup.has_values or found.is_missed:
        return found
    from freebody.study.small_motion.numbers import said_of_numbers

    with suppress(CannotAnswer, ArithmeticError, ValueError):
        verdict, notes = said_of_numbers(q, setup)
        return replace(found, verdict=verdict, notes=(*found.notes, *notes))
    return found


class QuestionSolver:
    """Answers one question. otherwise: where no closed form is found this way."""

    def __init__(self, setup: Setup, question: Question, otherwise: Otherwise | None = None) -> None:
        self.setup = setup
        self.system = setup.system
        self.model = setup.model
        self.question = question
        self.otherwise = otherwise
        self._state: SymbolicState | None = None  # in which it was found, where that is one instant
        self._reached: Reached | None = None  # the event that the motion is followed to
        self._pairs: int | None = allowed(_MOST_PAIRS)
        self._holds_once = False  # whether that is there at the start alone

    def answer(self) -> Answer:
        with self.model.samples.apart():  # what one question takes to be positive is no condition of the next
            return self._answer()

    def _answer(self) -> Answer:
        match self.question.quantity.scope:
            case "every motion":
                return answered(self.system, self.question, self._conserved)
            case _:
                found = answered(self.system, self.question, self._smooth, self._number_instead, self._otherwise)
                return found if found.is_complete else with_verdict(self.setup, self.question.quantity, found)

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
            if self.model.loops or not isinstance(error, FormulaTooDear):
                raise
            self._pairs = None  # without loops it has no chain: then in one piece, whatever that takes
            return self.finish(self._find())

    def _is_unread(self, found: Finding) -> bool:
        """Whether it is a frequency whose formula nobody would read."""
        q, x = self.question.quantity, found.element
        return isinstance(q, SmallOscillations) and isinstance(x, Ratio) and n_operations(tidy(x)) > _MOST_READ

    def _otherwise(self) -> Answer | None:
        """Where no closed form is found: by a chain at a place in numbers, else as whoever asks tells."""
        from freebody.study.steady.extremes_in_names import extreme_in_names

        found = extreme_in_names(self.setup, self.question)
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

    def _balanced(self, q: Quantity) -> Finding | None:
        """In the pose of the start, where a load of which the size is open balances the others."""
        if (balanced := about_rest.balanced_by_a_load(self.setup)) is None:
            return None
        setup = Setup(balanced[0])
        found = about_rest.value_where_it_starts(setup, self.question, q)
        if found is None:
            return None
        self._look(setup)
        self.question = replace(self.question, at_start=True)
        return replace(found, notes=[balanced[1]])

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

    def _steady(self) -> Finding:
        """Of motion that goes on evenly, in the system as the question looks at it."""
        from freebody.study.steady.ask import find, looked_at

        self._look(looked_at(self.setup, self.question))
        return find(self.setup, self.question)

    def _look(self, setup: Setup) -> None:
        """Goes on in another setup: that of the system as the question looks at it."""
        self.setup, self.model, self.system = setup, setup.model, setup.system

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

        if isinstance(q.of, StableSteadyMotion):
            from freebody.study.steady.stable_for import stability as steady_stability

            return solved_for(self.setup, self.question, steady_stability(self.setup, is_so=q.of.is_so))

        if isinstance(q.of, ExistingSteadyMotion):
            from freebody.study.steady.exists_for import existence

            formulas = existence(self.setup, self.question, q.parameter, is_so=q.of.is_so)
            return solved_for(self.setup, self.question, formulas)

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
            setup = formula.setup if is_of_turn else setup  # over a turn that of the motion without its drive
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
                self.question = replace(self.question, at_start=True)
            answer = solved_for(setup, self.question, formulas)
            answer.notes += stays
            self.setup, self.model, self.system = setup, setup.model, system
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

    # -- one instant --------------------------------------------------------------------------
    @singledispatchmethod
    def _found(self, q: Quantity) -> Finding:
        """By the kind of question: what has no finder of its own is a property of an instant."""
        at_start = self.question.at_start
        self._state = state = self.setup.start_for(q) if at_start else self.setup.state
        x = self._elements(q, state)
        if state is not self.setup.start_instant and at_start:
            self._check_pose_alone(x)
        remark = q.remark(self.system)
        if all(part.is_zero() for part in (x if isinstance(x, tuple) else (x,))):
            remark = q.remark_on_zero(self.system) or remark
        notes = [remark] if remark else []
        sides: list[Ratio] = []
        if (explicit := loops.solved(self.setup, x, state)) is not None:
            x, notes, sides = explicit[0], notes + explicit[1], explicit[2]
        evidence = proof.at_instants(self.setup, self.question.text, q, x, at_start=at_start, sides=sides)
        return Finding(x, evidence, notes=notes, in_names=chain_of(self.setup, q, x, state))

    @_found.register(DegreesOfFreedom)
    def _freedom(self, q: DegreesOfFreedom) -> Finding:
        dof = self.model.degrees_of_freedom
        return Finding(Fraction(dof), proof.freedom(self.setup, self.question.text, dof))

    @_found.register(GreatestInRod)
    def _greatest_in_rod(self, q: GreatestInRod) -> Finding:
        from freebody.study.answering.greatest_section import find

        self._state = self.setup.start_for(q) if self.question.at_start else self.setup.state
        return find(self.setup, self.question, q, self._state)

    def _check_pose_alone(self, x: Elements) -> None:
        """Raises CannotAnswer where what the pose alone should tell depends on the sense of the motion as well."""
        speeds = {c.speed for c in (*self.model.coordinates, *self.model.dependent)}
        for part in x if isinstance(x, tuple) else (x,):
            if self.model.field.ingredients(part) & speeds:
                raise HasNoValue(Message("it depends on which way it moves; ask for the ratio of two speeds"))

    def _elements(self, q: Quantity, state: SymbolicState) -> Elements:
        f = self.model.field
        with f.within(self._pairs):
            value = q.value(self.system, state)
            if isinstance(value, tuple):
                return tuple(f.lowest_terms(f.element(v)) for v in value)
            return f.lowest_terms(f.element(value))

    # -- an event along the motion ------------------------------------------------------------
    @singledispatchmethod
    def _at_event(self, q: Quantity) -> Finding:
        """By the kind of question, as above."""
        event = self.question.event
        assert event is not None
        try:
            self._reached = reached = self._reach(event)
        except HoldsOnce:
            if not q.is_of_state or q.is_of_event or not isinstance(event, QuestionEvent):
                raise
            return self._at_the_start_alone(q, event)
        conditions = self._comes(event, reached)
        # a formula with signs that were taken at the start is compared only where they are so, there and at the event
        x, there = self._there(q, reached)
        if has_integrals(x):
            conditions += [c for c, _possible in (require(*need) for need in reached.timed) if c is not None]
        self._check_is_told(x)
        begins, ends = (self.setup.holding(s, with_contacts=False) for s in (self.setup.start_instant, there))
        # a distance may be zero at the start, or come to zero with the event
        begins = [c for c in begins if not c.element.is_zero()]
        ends = [c for c in ends if not self._is_untold(c.element) and not c.element.is_zero()]
        # nor is it compared where the closed loops do not close at the event; where they just do, in a singular pose,
        # there is a place but no velocity
        closing = [c for c in self.setup.closing(there) if not self._is_untold(c.element)]
        # on the way there, too
        everywhere = kept_until(self.setup.motion, reached, self.setup.closing(self.setup.state), closing=True)
        closing += [c for c in everywhere if not c.element.field.ingredients(c.element) & self.model.moving]
        is_of_pose = q.kinematic_order == 0 and not (isinstance(event, QuestionEvent) and event.order)
        conditions += closing if is_of_pose else [replace(c, relation=">") for c in closing]
        untold = [] if closing else self.setup.closing_in_full(there)
        evidence = proof.along_motion(
            self.setup,
            self.question.text,
            q,
            event,
            x,
            reached.time if reached.settled is None else reached.settled,
            [*conditions, *untold, *real(x)],
            [*begins, *ends],
            reached.decays,
        )
        named = chain_of(self.setup, q, x, there) if q.is_of_state else None
        return Finding(x, evidence, conditions + ends, reached.notes, says=reached.says, in_names=named)

    @_at_event.register(Extent)
    def _extent_until(self, q: Extent) -> Finding:
        return self._extreme_until(q.of_motion)

    @_at_event.register(ExtremeOfMotion)
    def _extreme_until(self, q: ExtremeOfMotion) -> Finding:
        from freebody.study.answering.extremes_until import find

        event = self.question.event
        assert event is not None
        reached = self._reach(event)
        return find(self.setup, self.question.text, q, event, reached, self._comes(event, reached))

    def _comes(self, event: AskedEvent, reached: Reached) -> list[Condition]:
        """What it needs to come; lengths that are held are told by what they are at the start."""
        needed = ((self.setup.state.here(x), relation) for x, relation in reached.conditions)
        never = NeverHappens(event.never)
        return insisted((Condition(x, relation, event.comes) for x, relation in needed), never)

    def _there(self, q: Quantity, reached: Reached) -> tuple[Elements, SymbolicState]:
        """A quantity at an event, and the state there; with the loops solved first where the formula is too long
        otherwise."""
        there = SymbolicState(self.model, self.setup.motion.known_at(reached))
        found: Elements | None = None
        with suppress(FormulaTooLong):
            found = q.counted(smooth_passage(self.setup, reached, self._elements, there))
        parts = found if isinstance(found, tuple) else (found,)
        if found is not None and not any(isinstance(x, Ratio) and n_terms_in_all(x) > _SWOLLEN for x in parts):
            return found, there
        try:
            staged = StagedState(self.model, self.setup.motion.closure.at({}), there.values)
            return q.counted(smooth_passage(self.setup, reached, self._elements, staged)), staged
        except (CannotAnswer, ZeroDivisionError):
            if found is None:
                raise
            return found, there

    def _at_the_start_alone(self, q: Quantity, event: QuestionEvent) -> Finding:
        """Of an event that is there at the start and does not come again."""
        self.question, self._holds_once = replace(self.question, event=None, at_start=True), True
        found = self._found(q)
        told = Message("{event} holds at the start, and never again: this is what it is at the start", event=event.text)
        found.notes.append(told)
        return found

    def _reach(self, event: AskedEvent) -> Reached:
        if isinstance(event, FarthestPlace) and event.order == 0:
            return turn_of(self.setup, event.measure, event.side, event.text)[1]
        if isinstance(event, QuestionEvent):
            return self.setup.motion.reach(event)
        time = None if event.time is None else self.model.geometry.scalar(event.time)
        if time is not None and sign_of(time) is Sign.NEGATIVE:
            raise NeverHappens(Message("that instant is before the start"))
        return self.setup.motion.at_clock(time)

    def _check_is_told(self, x: Elements) -> None:
        """Raises CannotAnswer where coordinates are left whose values at the event are not known."""
        if left := self._moving_in(x):
            if self.question.event is not None and isinstance(self.question.event, Clock):
                self._refuse_at_clock(self.question.event, left)
            raise CannotAnswer(
                Message(
                    "the quantity depends on {names} as well, for whose values at the event no closed form was found",
                    names=", ".join(c.name for c in left),
                )
            )
        if self._is_untold(x):
            raise CannotAnswer(
                Message("the quantity depends on the time of the event as well; {why}", why=self._reached.why_no_time)
                if self._reached is not None and self._reached.why_no_time
                else Message("the quantity depends on the time of the event as well, which has no closed form")
            )

    def _is_untold(self, x: Elements) -> bool:
        """Whether something is left in an element whose value at the event is not known: a coordinate, or the time,
        with which a drive turns."""
        f = self.model.field
        inside = set[int]().union(*map(f.ingredients, x if isinstance(x, tuple) else (x,)))
        is_timed = self._reached is not None and self._reached.time is None
        return bool(self._moving_in(x)) or (is_timed and any(f.generators[g].kind == "time" for g in inside))

    def _refuse_at_clock(self, event: Clock, left: Sequence[Coordinate]) -> NoReturn:
        names = ", ".join(c.name for c in left)
        if event.time is None:
            told = Message("for {names} no value was found that is tended to as the time grows", names=names)
            raise CannotAnswer(told)
        raise CannotAnswer(Message("for {names} no closed form in the time was found", names=names))

    def _moving_in(self, x: Elements) -> list[Coordinate]:
        everything = (*self.model.coordinates, *self.model.dependent)
        inside = set[int]().union(*map(self.model.field.ingredients, x if isinstance(x, tuple) else (x,)))
        return [c for c in everything if inside & {c.index, c.speed}]

    # -- a motion that repeats itself ---------------------------------------------------------
    @_found.register(Period)
    def _period(self, q: Period) -> Finding:
        from freebody.study.answering.repeated import find

        return find(self.setup, self.question.text, q.measure)

    @_found.register(Extent)
    def _extent(self, q: Extent) -> Finding:
        from freebody.study.answering.extent import find, goes_one_way
        from freebody.study.answering.modal_extremes import wave_of
        from freebody.study.steady.phase import is_led

        if (
            is_led(self.setup, q.measure)
            or not goes_one_way(self.setup, q.measure)
            or wave_of(self.setup, q.of_motion.of) is not None
        ):
            return self._extreme(q.of_motion)
        try:
            return find(self.setup, self.question.text, q.measure, q.side, q.name)
        except (NeverHappens, NotHere):
            raise
        except CannotAnswer:
            # what a momentum leads along with one coordinate, as a bowl in which a ball slides, turns where that does
            if len(self.model.coordinates) < 2:
                raise
            try:
                return self._extreme(q.of_motion)
            except NeverHappens:
                raise
            except CannotAnswer:
                pass
            raise

    @_found.register(ExtremeOfMotion)
    def _extreme(self, q: ExtremeOfMotion) -> Finding:
        from freebody.study.answering.motion_extremes import find

        if not self.model.coordinates:  # what a drive keeps going makes one turn after the other
            self.question = replace(self.question, quantity=Extremes(q.of, None, q.end))
            return self._steady()
        return find(self.setup, self.question.text, q.of, (q.side,))

    # -- small oscillations and equilibrium ---------------------------------------------------
    @_found.register(SmallOscillations)
    def _small(self, q: SmallOscillations) -> Finding:
        with self.model.field.within(self._pairs):
            return about_rest.oscillations(self.setup, self.question, q)

    @_found.register(OfSmallMotion)
    def _of_small_motion(self, q: OfSmallMotion) -> Finding:
        from freebody.study.small_motion.ask import find

        return find(self.setup, self.question, partial(about_rest.needs_of_rest, self.setup))

    @_found.register(Equilibrium)
    def _equilibrium(self, q: Equilibrium) -> Finding:
        return about_rest.equilibrium(self.setup, self.question, q)

    @_found.register(RestValue)
    def _value_at_rest(self, q: RestValue) -> Finding:
        try:
            return about_rest.value(self.setup, self.question, q)
        except CannotAnswer:
            if (found := self._balanced(q.of)) is None:
                raise
            return found

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
