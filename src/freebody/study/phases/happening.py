"""Whether something happens in a motion, or lasts, in every part of the space of parameters, by the phases.

A state lasts if every phase of a way has it; an event comes if the end of one of them is that event, and what it is to
come before has not come by then. Which of the two is first in a phase is told as it is told what ends the phase.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import product

import numpy as np

from freebody.errors import CannotAnswer
from freebody.language.sentences import Message
from freebody.measures.base import Measure
from freebody.questions.clock import Clock
from freebody.questions.course import Transition
from freebody.questions.event import TurnsBack
from freebody.questions.event_base import QuestionEvent
from freebody.questions.happening import Happening, Lasting
from freebody.study.answering.finding import NO_FORM, why
from freebody.study.phases.changes_asked import begins_with, event_behind, meant_of
from freebody.study.phases.events import first_events
from freebody.study.phases.locking import locking_cases
from freebody.study.phases.nodes import PhaseEnd, PhaseNode, WayToPhase
from freebody.study.phases.numbers import Chosen
from freebody.study.phases.phase import Phase, PhaseWatch
from freebody.study.phases.pieces import watches_of
from freebody.study.phases.standing import cannot_slip, feet_of
from freebody.study.phases.tree import PhaseTree
from freebody.symbolic.conditions import Condition, require
from freebody.symbolic.state import SymbolicState
from freebody.tolerances import ROUND_OFF


@dataclass(frozen=True)
class HappeningCase:
    """Whether it is so in one part of the space of parameters; None where that is not known, with the reason."""

    is_so: bool | None
    conditions: tuple[Condition, ...]
    why: str = ""
    is_proved: bool = True  # that nothing else ends a phase follows from formulas


def happening_cases(tree: PhaseTree, happening: Happening) -> list[HappeningCase]:
    """All parts, as far as the phases are known."""
    if tree.system.blows and isinstance(happening.what, Lasting) and happening.what.kind == "stands":
        told = Message(
            "what is caught in its motion turns about the place that is caught, and tips over once it is past its "
            "balance: ask for the angle, as in least v so that phi reaches 45 deg"
        )
        raise CannotAnswer(told)
    if isinstance(happening.what, Lasting) and happening.what.kind == "locks":
        found = [HappeningCase(is_so, where) for is_so, where in locking_cases(tree, tree.slips, happening.what)]
        return [replace(case, is_so=case.is_so is happening.is_so) for case in found]
    roots = [WayToPhase((node,), (), (*tree.assumed, *node.conditions)) for node in tree.roots]
    found = [case for way in roots for case in _Walk.begun(tree, happening, way.last).cases(way)]
    if happening.is_so:
        return found
    found = [replace(case, is_so=None if case.is_so is None else not case.is_so) for case in found]
    return found if happening.away is None else list(_outwards(tree, happening.away, found))


def _outwards(tree: PhaseTree, away: Measure, found: Sequence[HappeningCase]) -> Iterator[HappeningCase]:
    """What never turns back goes away if it sets out so; else it comes nearer and nearer, and meets the centre."""
    start = tree.home.start_instant
    rate = start.rate(away)
    drive = start.acceleration(away) if rate.is_zero() else rate
    if not rate.is_zero() and tree.home.model.samples.is_negative(rate):
        raise CannotAnswer(Message("it sets out towards the centre: whether it escapes is told from its nearest place"))
    outward, is_possible = require(drive, ">", Message("sets out away from the centre"))
    for case in found:
        if case.is_so and outward is not None:
            if is_possible:
                yield replace(case, conditions=(*case.conditions, outward))
            yield HappeningCase(False, (*case.conditions, Condition(-drive, ">=", outward.purpose)))
        else:
            yield case


_Ends = Iterator[tuple[PhaseWatch | PhaseEnd | None, list[Condition], Chosen]]


class _Walk:
    """From the start along all ways. counted: of what is asked for, that which was counted as it happened at the
    start."""

    def __init__(self, tree: PhaseTree, happening: Happening, counted: Sequence[Transition] = ()) -> None:
        self.tree, self.happening, self.counted = tree, happening, tuple(counted)
        self.what, self.before = happening.what, happening.before
        self.at_once = happening.at_once

    @classmethod
    def begun(cls, tree: PhaseTree, happening: Happening, node: PhaseNode) -> _Walk:
        """From a first phase on: the second impact is the next one where the motion begins with an impact."""
        walk = cls(tree, happening)
        for asked in (happening.what, happening.before):
            if isinstance(asked, Transition) and asked.count > 1 and begins_with(tree, asked, node):
                walk = walk._past(asked)
                walk.counted = (*walk.counted, replace(asked, count=asked.count - 1))
        return walk

    def _past(self, asked: Transition) -> _Walk:
        """The same behind one of several impacts that are counted."""
        later = replace(asked, count=asked.count - 1)
        what = later if asked is self.what else self.what
        before = later if asked is self.before else self.before
        return _Walk(self.tree, replace(self.happening, what=what, before=before), self.counted)

    def _begins(self, asked: Transition, node: PhaseNode) -> bool:
        return asked.count == 1 and asked not in self.counted and bool(begins_with(self.tree, asked, node))

    def cases(self, way: WayToPhase) -> Iterator[HappeningCase]:
        """Those of the ways that go on from here."""
        node = way.last
        if (known := self._in_phase(node, is_first=not way.edges)) is not None:
            yield HappeningCase(known, way.conditions)
            return
        try:
            ends = list(self._ends(way))
        except NO_FORM as error:
            yield HappeningCase(None, way.conditions, why(self.tree.system, error))
            return
        if node.reason:
            yield HappeningCase(None, way.conditions, node.reason)
            return
        for end, conditions, sets in ends:
            here = replace(way, conditions=(*way.conditions, *conditions))
            if isinstance(end, PhaseWatch) and isinstance(self.what, TurnsBack) and end.name == self.what.text:
                yield from self._at_turn(here, self.what, sets)
            elif isinstance(end, PhaseWatch):
                is_so = isinstance(self.what, (QuestionEvent, Clock)) and end.name == self.what.text
                yield HappeningCase(is_so or isinstance(self.what, Lasting), here.conditions)
            elif end is None or end.first is None:
                yield self._at_last(end, here)
            else:
                yield from self._behind(here, end, sets)

    def _in_phase(self, node: PhaseNode, *, is_first: bool) -> bool | None:
        """What is decided by the phase alone."""
        if isinstance(self.what, Lasting):
            has = self._has(node, self.what)
            return has if self.at_once or not has else None
        if not is_first:
            return None
        if isinstance(self.what, Transition):
            begins = self._begins(self.what, node) or self._rolls_at_once(node)
            if begins or self.at_once:
                return begins
        if isinstance(self.before, Transition) and self._begins(self.before, node):
            return isinstance(self.what, Lasting)
        return None

    def _rolls_at_once(self, node: PhaseNode) -> bool:
        assert isinstance(self.what, Transition)
        return self.what.kind == "rolls" and self._has(node, Lasting("rolls", self.what.of, ""))

    def _has(self, node: PhaseNode, lasting: Lasting) -> bool:
        """Whether a phase has a state: of every connection that is meant a place touches, or no slip goes on."""
        mode = node.phase.mode
        if lasting.kind == "touches":
            begun = {name.partition(".")[0] for name in self.tree.closed | self.tree.moving}
            meant = set(lasting.of) or begun
            return meant <= {name.partition(".")[0] for name in mode.closed}
        if lasting.kind == "stands":
            begun = self.tree.closed | self.tree.moving
            feet = feet_of(self.tree.system, begun, lasting.of)
            return not any(each.is_tipped(mode.closed.__contains__) for each in feet)
        if not {*cannot_slip(self.tree.system, self.tree.closed | self.tree.moving, lasting.of)} <= {*mode.closed}:
            return False
        rubs = [
            rub
            for rub in node.phase.base.dry_friction
            if not rub.resists_turning and (not lasting.of or rub.name.partition(".")[0] in lasting.of)
        ]
        sticking = {name.partition(".")[0] for name, state in mode.states.items() if state == 0}
        sliding = {rub.name.partition(".")[0] for rub in rubs if mode.states.get(rub.name)}
        return not sliding and {rub.name.partition(".")[0] for rub in rubs} <= sticking

    def _ends(self, way: WayToPhase) -> _Ends:
        """How the last phase of a way ends: by an event that is asked for (its watch), or as the tree knows."""
        node, tree = way.last, self.tree
        asked = [e for e in (self.what, self.before) if isinstance(e, (QuestionEvent, Clock))]
        if isinstance(self.what, TurnsBack) and node.phase.state.rate(self.what.measure).is_zero():
            asked = [e for e in asked if e is not self.what]  # what is held does not turn
        if not asked:
            yield from ((edge, list(edge.conditions), edge.sets) for edge in node.edges)
            return
        for chosen in product(*(list(watches_of(tree, way, event)) for event in asked)):
            sets = node.sets
            for _watch, own, _given in chosen:
                sets = np.intersect1d(sets, own)
            if not len(sets):
                continue
            watches: Sequence[PhaseWatch] = [watch for watch, _own, _given in chosen]
            given = [c for _watch, _own, conditions in chosen for c in conditions]
            for outcome in first_events(node.phase, tree.sets, sets, watches):
                conditions = [*given, *tree.outcome_conditions(node.phase, outcome)]
                first = None if outcome.first is None else outcome.first.watch
                if first is None or any(first is watch for watch in watches):
                    last = next((edge for edge in node.edges if edge.first is None), None)
                    yield last if first is None else first, conditions, outcome.sets
                    continue
                for edge in node.edges:
                    if edge.watch is first and len(own := np.intersect1d(outcome.sets, edge.sets)):
                        yield edge, conditions, own

    def _at_turn(self, way: WayToPhase, turn: TurnsBack, sets: Chosen) -> Iterator[HappeningCase]:
        """What has come to rest goes back, by itself or in the next phase, or stays there at first."""
        tree, phase = self.tree, way.last.phase
        stops = [edge for edge in way.last.edges if len(self._resting(phase, edge, turn, sets))]
        if not stops:
            yield HappeningCase(True, way.conditions)
        for edge in stops:
            assert edge.first is not None
            there = SymbolicState(phase.model, {**phase.still, **edge.first.zero.values})
            before = tree.numbers(tree.to_home(phase, there.acceleration(turn.measure)))
            for node in edge.nodes:
                own = np.intersect1d(self._resting(phase, edge, turn, sets), node.sets)
                drive = node.phase.start_instant.acceleration(turn.measure)
                back = before * tree.numbers(tree.to_home(node.phase, drive)) > 0.0
                nodes = (*way.nodes, replace(node, sets=own))
                on = WayToPhase(nodes, (*way.edges, edge), (*way.conditions, *node.conditions))
                if not len(own):
                    continue
                if back[own].all():
                    yield HappeningCase(True, on.conditions)
                elif not back[own].any():
                    yield from self.cases(on)
                else:
                    yield HappeningCase(None, on.conditions)
            if not edge.nodes:
                yield HappeningCase(None, way.conditions, edge.stops)

    def _resting(self, phase: Phase, edge: PhaseEnd, turn: TurnsBack, sets: Chosen) -> Chosen:
        """For which of the sets what turns is at rest where a phase ends by a change of its contacts."""
        if edge.first is None:
            return sets[:0]
        there = SymbolicState(phase.model, {**phase.still, **edge.first.zero.values})
        begun = self.tree.numbers(self.tree.to_home(phase, there.acceleration(turn.measure)))
        rate = self.tree.numbers(self.tree.to_home(phase, there.rate(turn.measure)))
        own = np.intersect1d(sets, edge.sets)
        return own[np.abs(rate[own]) <= ROUND_OFF * np.abs(begun[own])]

    def _at_last(self, end: PhaseEnd | None, way: WayToPhase) -> HappeningCase:
        """The last phase goes on for ever."""
        if end is not None and end.stops:
            return HappeningCase(None, way.conditions, end.stops)
        is_proved = end is None or end.is_proved
        return HappeningCase(isinstance(self.what, Lasting), way.conditions, is_proved=is_proved)

    def _behind(self, way: WayToPhase, edge: PhaseEnd, sets: Chosen) -> Iterator[HappeningCase]:
        """What a phase ends by is asked for, or other phases follow."""
        assert edge.first is not None
        walk = self
        for asked, is_so in ((self.what, True), (self.before, isinstance(self.what, Lasting))):
            if isinstance(asked, Transition) and asked.kind != "rolls" and meant_of(asked, edge.first):
                if asked.count == 1:
                    yield HappeningCase(is_so, way.conditions)
                    return
                walk = walk._past(asked)
        for node in edge.nodes:
            own = np.intersect1d(sets, node.sets)
            if not len(own):
                continue
            nodes = (*way.nodes, replace(node, sets=own))
            there = WayToPhase(nodes, (*way.edges, edge), (*way.conditions, *node.conditions))
            known: bool | None = None
            for asked, is_so in ((self.before, isinstance(self.what, Lasting)), (self.what, True)):
                if isinstance(asked, Transition) and event_behind(asked, edge.first, node):
                    known = is_so
            if known is None:
                yield from walk.cases(there)
            else:
                yield HappeningCase(known, there.conditions)
        if not edge.nodes:
            yield HappeningCase(None, way.conditions, edge.stops)
