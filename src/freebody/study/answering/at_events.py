"""What one question asks for at an event, to which the motion is followed."""

from __future__ import annotations

from collections.abc import Sequence
from contextlib import suppress
from dataclasses import replace
from functools import singledispatchmethod
from typing import NoReturn

from freebody.errors import CannotAnswer, FormulaTooLong, NeverHappens
from freebody.language.sentences import Message
from freebody.questions.base import Quantity
from freebody.questions.clock import Clock
from freebody.questions.event import AskedEvent, FarthestPlace
from freebody.questions.event_base import QuestionEvent
from freebody.questions.extent import Extent, ExtremeOfMotion
from freebody.study.answering import evidence as proof
from freebody.study.answering.by_kind import FindingByKind
from freebody.study.answering.chain import chain_of, n_terms_in_all
from freebody.study.answering.conditions import real
from freebody.study.answering.extent import turn_of
from freebody.study.answering.finding import Elements, Finding
from freebody.study.answering.integrals import has_integrals
from freebody.study.answering.passage import smooth_passage
from freebody.symbolic.conditions import Condition, insisted, require
from freebody.symbolic.on_the_way import kept_until
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.reached import HoldsOnce, Reached
from freebody.symbolic.signs import Sign, sign_of
from freebody.symbolic.state import StagedState, SymbolicState
from freebody.symbolic.unknowns import Coordinate

_SWOLLEN = 60  # terms from which on a formula at an event is tried with the loops solved first


class FindingAtEvents(FindingByKind):
    """Finds it at an event as well."""

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
        x, there, counted = self._there(q, reached)
        conditions += counted
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

    def _there(self, q: Quantity, reached: Reached) -> tuple[Elements, SymbolicState, list[Condition]]:
        """A quantity at an event, the state there, and what it needs where it is counted until then; with the loops
        solved first where the formula is too long otherwise."""
        there = SymbolicState(self.model, self.setup.motion.known_at(reached))
        found: Elements | None = None
        passage = smooth_passage(self.setup, reached, self._elements, there)
        with suppress(FormulaTooLong):
            found = q.counted(passage)
        parts = found if isinstance(found, tuple) else (found,)
        if found is not None and not any(isinstance(x, Ratio) and n_terms_in_all(x) > _SWOLLEN for x in parts):
            return found, there, passage.counted_so(self.setup.state.here)
        try:
            staged = StagedState(self.model, self.setup.motion.closure.at({}), there.values)
            by_loops = smooth_passage(self.setup, reached, self._elements, staged)
            return q.counted(by_loops), staged, by_loops.counted_so(self.setup.state.here)
        except (CannotAnswer, ZeroDivisionError):
            if found is None:
                raise
            return found, there, passage.counted_so(self.setup.state.here)

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
