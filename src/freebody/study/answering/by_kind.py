"""A finding for one question by its kind: of an instant, of a motion that repeats itself, of rest."""

from __future__ import annotations

from collections.abc import Sequence
from contextlib import nullcontext
from dataclasses import replace
from fractions import Fraction
from functools import partial, singledispatchmethod

from freebody.budgets import allowed
from freebody.errors import CannotAnswer, NeverHappens
from freebody.language.expression import Call, Symbol
from freebody.language.sentences import Message
from freebody.questions.arithmetic import Calculated
from freebody.questions.base import Quantity
from freebody.questions.extent import Extent, ExtremeOfMotion
from freebody.questions.freedom import DegreesOfFreedom
from freebody.questions.greatest_section import GreatestInRod
from freebody.questions.period import Period
from freebody.questions.reading import Question
from freebody.questions.section import SectionForce
from freebody.questions.small_motion import Equilibrium, OfSmallMotion, RestValue, SmallOscillations
from freebody.questions.steady import Extremes
from freebody.study.answering import about_rest, loops
from freebody.study.answering import evidence as proof
from freebody.study.answering.chain import chain_of
from freebody.study.answering.finding import Elements, Finding, NotHere, Otherwise
from freebody.study.setup import Setup
from freebody.symbolic.conditions import Condition
from freebody.symbolic.reached import Reached
from freebody.symbolic.state import SymbolicState
from freebody.symbolic.written import HasNoValue
from freebody.tolerances import ROUND_OFF

_MOST_PAIRS = 10_000_000  # of terms that quotients compare: a formula that takes more is read as a chain only
_MOST_PAIRS_AT_REST = 100_000  # of a machine in one pose, whose chain is short


class FindingByKind:
    """Finds what one question asks for, by its kind. otherwise: where no closed form is found this way."""

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

    @property
    def has_loops(self) -> bool:
        """Whether bodies close a loop, of which there is a chain: what one body alone touches is none."""
        return bool(self.model.loops) and len(self.system.moving) > 1

    # -- one instant --------------------------------------------------------------------------
    @singledispatchmethod
    def _found(self, q: Quantity) -> Finding:
        """By the kind of question: what has no finder of its own is a property of an instant."""
        return self._of_an_instant(q)

    def _of_an_instant(self, q: Quantity, needed: Sequence[Condition] = ()) -> Finding:
        """needed: what it takes for the value to be as q counts it."""
        at_start = self.question.at_start
        self._state = state = self.setup.start_for(q) if at_start else self.setup.state
        x = self._elements(q, state)
        if state is not self.setup.start_instant and at_start:
            self._check_pose_alone(x)
        remark = q.remark(self.system)
        if all(part.is_zero() for part in (x if isinstance(x, tuple) else (x,))):
            remark = q.remark_on_zero(self.system) or remark
        notes = [remark] if remark else []
        if not at_start and self._moves(x) and (changes := q.remark_in_motion(self.system)):
            notes.append(changes)
        sides = [c.element for c in needed]
        if (explicit := loops.solved(self.setup, x, state)) is not None:
            x, notes, sides = explicit[0], notes + explicit[1], sides + explicit[2]
        evidence = proof.at_instants(self.setup, self.question.text, q, x, at_start=at_start, sides=sides)
        return Finding(x, evidence, [*needed], notes, in_names=chain_of(self.setup, q, x, state))

    @_found.register(DegreesOfFreedom)
    def _freedom(self, q: DegreesOfFreedom) -> Finding:
        dof = self.model.degrees_of_freedom
        return Finding(Fraction(dof), proof.freedom(self.setup, self.question.text, dof))

    @_found.register(SectionForce)
    def _section(self, q: SectionForce) -> Finding:
        """Of a section on whose sides lengths tell what acts, with what it takes for that."""
        from freebody.study.answering.section import placed

        state = self.setup.start_for(q) if self.question.at_start else self.setup.state
        cut = placed(self.setup, q, state)
        self.question = replace(self.question, quantity=cut.section)
        found = self._of_an_instant(cut.section, cut.conditions)
        return replace(found, notes=[*found.notes, *cut.notes])

    @_found.register(GreatestInRod)
    def _greatest_in_rod(self, q: GreatestInRod) -> Finding:
        from freebody.study.answering.greatest_section import find

        self._state = self.setup.start_for(q) if self.question.at_start else self.setup.state
        return find(self.setup, self.question, q, self._state)

    def _moves(self, x: Elements) -> bool:
        f, moving = self.model.field, self.model.moving
        return any(f.ingredients(part) & moving for part in (x if isinstance(x, tuple) else (x,)))

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
        size = self._size_of_turned(q)
        if size is None:
            return find(self.setup, self.question.text, q.of, (q.side,))
        self.question = replace(self.question, quantity=size)
        found = find(self.setup, self.question.text, size.of, (size.side,))
        told = Message("negative throughout by its sign: what is greatest is its size")
        return replace(found, notes=[told, *found.notes])

    def _size_of_turned(self, q: ExtremeOfMotion) -> ExtremeOfMotion | None:
        """The greatest size of a rate that is never positive at the given numbers, as of what turns clockwise; else
        None."""
        from freebody.study.answering.numbers import rates_seen

        watched, measured = q.of.watched, q.of.named_measure
        if q.side < 0 or watched is None or measured is None or measured[1] != 1 or not self.setup.has_values:
            return None
        try:
            low, high = rates_seen(self.setup.draws[0], watched[0])
        except CannotAnswer:
            return None
        size = Calculated(Call("abs", Symbol("Q1")), (("Q1", q.of),), q.of.dimension, f"|rate({measured[0]})|")
        return replace(q, of=size) if high <= ROUND_OFF * abs(low) else None

    # -- small oscillations and equilibrium ---------------------------------------------------
    @_found.register(SmallOscillations)
    def _small(self, q: SmallOscillations) -> Finding:
        from freebody.study.small_motion.ask import looked_at

        self._look(looked_at(self.setup))
        with self.model.field.within(self._pairs):
            return about_rest.oscillations(self.setup, self.question, q)

    @_found.register(OfSmallMotion)
    def _of_small_motion(self, q: OfSmallMotion) -> Finding:
        from freebody.study.small_motion.ask import find, looked_at

        self._look(looked_at(self.setup))
        return find(self.setup, self.question, partial(about_rest.needs_of_rest, self.setup))

    @_found.register(Equilibrium)
    def _equilibrium(self, q: Equilibrium) -> Finding:
        from freebody.study.small_motion.ask import about_mean

        self._look(about_mean(self.setup))
        return about_rest.equilibrium(self.setup, self.question, q)

    @_found.register(RestValue)
    def _value_at_rest(self, q: RestValue) -> Finding:
        from freebody.study.small_motion.ask import about_mean

        self._look(about_mean(self.setup))
        # without mass nothing leaves the pose of the start, where an open load balances the others
        is_posed = self.model.dynamics.moves_no_mass and q.of.kinematic_order is None
        if is_posed and (found := self._balanced(q.of)) is not None:
            return found
        try:
            return about_rest.value(self.setup, self.question, q)
        except CannotAnswer:
            if is_posed or (found := self._balanced(q.of)) is None:
                raise
            return found

    def _balanced(self, q: Quantity) -> Finding | None:
        """In the pose of the start, where a load of which the size is open balances the others. Raises FormulaTooLong
        where a chain of names has it."""
        pairs = allowed(_MOST_PAIRS_AT_REST) if self.has_loops else None
        with self.model.field.within(pairs) if pairs else nullcontext():
            balanced = about_rest.balanced_by_a_load(self.setup)
        if balanced is None:
            return None
        setup = Setup(balanced[0])
        with setup.model.field.within(pairs):
            found = about_rest.value_where_it_starts(setup, self.question, q)
        if found is None:
            return None
        self._look(setup)
        self.question = replace(self.question, at_start=True)
        return replace(found, notes=[balanced[1]])

    def _steady(self) -> Finding:
        """Of motion that goes on evenly, in the system as the question looks at it."""
        from freebody.study.steady.ask import find, looked_at

        self._look(looked_at(self.setup, self.question))
        return find(self.setup, self.question)

    def _look(self, setup: Setup) -> None:
        """Goes on in another setup: that of the system as the question looks at it."""
        self.setup, self.model, self.system = setup, setup.model, setup.system
