"""The tree of phases: from the start, which mode holds, what ends it, which mode follows.

Which of the consistent modes (`consistent.py`) holds, and which event comes first, is looked up at several hundred
random parameter sets (`Sets`), and the inequalities that told them apart are the conditions of the branch, as formulas.
"""

from __future__ import annotations

from collections.abc import Generator, Iterator, Mapping, Sequence
from contextlib import contextmanager, suppress
from dataclasses import replace
from functools import lru_cache
from typing import Any

import numpy as np

from freebody.budgets import allowed
from freebody.language.expression import n_operations
from freebody.language.sentences import Message, in_turn
from freebody.model.elements import UnilateralConstraint
from freebody.questions.at_events import AtEvent
from freebody.questions.course import Transition
from freebody.questions.happening import Happening
from freebody.questions.reading import Question
from freebody.study.answering.finding import NO_FORM, why
from freebody.study.phases.blown import after_blow
from freebody.study.phases.consistent import checks, without_slip
from freebody.study.phases.decide import NOTHING, Inequality, Test, as_test, cells
from freebody.study.phases.ends import PhaseOutcome, Proofs
from freebody.study.phases.events import first_events
from freebody.study.phases.foreseen import Foresight
from freebody.study.phases.handing_over import taking_over
from freebody.study.phases.home import Home
from freebody.study.phases.impact import ClosedFormCollision, CollisionOutcome, collisions
from freebody.study.phases.in_plane import slips_of, ways_of_impact
from freebody.study.phases.locking import self_pressed
from freebody.study.phases.nodes import PhaseEnd, PhaseImpact, PhaseNode, PhaseStart
from freebody.study.phases.numbers import Chosen
from freebody.study.phases.phase import Phase
from freebody.study.phases.placed import Placed
from freebody.study.phases.reached import STRIKES, pending
from freebody.study.phases.without_phases import insist_on_phases
from freebody.symbolic.conditions import Condition
from freebody.symbolic.decide import decide
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.state import SymbolicState
from freebody.system.modes import ContactMode, ideal_bounds
from freebody.system.system import System
from freebody.tolerances import ROUND_OFF, ROUNDED

MAX_DEPTH = 5
MAX_NODES = 24
MAX_TURNS = 16  # half swings against friction, one after the other, on the way of the model's own values
MAX_IMPACTS = 2  # one after the other, in formulas
_BESIDE_IMPACTS = 2  # phases beside those that begin with an impact
MOST_TERMS = 6  # of a condition behind the jerk of a string
MOST_OF_A_CONDITION = 10_000  # operations
MOST_OPERATIONS = 1000  # of a state from which others than the model's own values are followed on
TOO_LONG = Message("what follows depends on conditions too long to read; simulate the motion")
MOST_SIGNS = 4  # ways in which the frictions of one mode are pressed
_EFFORT = 1000  # what an effort is told by


class PhaseTree(Home):
    """The phases of a system."""

    def __init__(self, system: System, n_impacts: int = MAX_IMPACTS) -> None:
        """n_impacts: how many are followed, one after the other."""
        insist_on_phases(system)
        super().__init__(system)
        self.most_impacts = allowed(n_impacts)
        self.most_depth = max(allowed(MAX_DEPTH), self.most_impacts + _BESIDE_IMPACTS)
        self.n_nodes = 0
        self.foresight = Foresight(self)
        self.reasons: list[str] = []
        self.lost: dict[int, str] = {}  # parameter sets for which nothing follows on the start, and why
        self.seen: dict[Any, Any] = {}  # motions in numbers, kept for other questions
        self.slips: dict[str, Ratio] = {}  # at the start, where nothing collides
        self.roots: list[PhaseNode] = []
        self.boundaries: list[Ratio] = []
        moving = [b for b in self.system.bounds if b.name in self.moving]
        rates = {b.name: b.row.sign * self.at_start(self.home.state.rate(b.row.measure)) for b in moving}
        for signs, sets in self.by_sign(rates, self.indices):
            self._begin(rates, signs, sets)
        self.roots.sort(key=lambda node: int(node.sets[0]))
        self.home.model.samples.settle()

    @contextmanager
    def for_one_question(self) -> Generator[None]:
        """What is taken to be positive inside is no condition of what is asked next."""
        try:
            yield
        finally:
            for samples in (self.home.model.samples, *(node.phase.samples for node in self.nodes())):
                samples.forget()

    @property
    def is_single(self) -> bool:
        """Whether one coordinate moves, in every phase."""
        return all(len(node.phase.model.coordinates) <= 1 for node in self.nodes())

    def nodes(self) -> Iterator[PhaseNode]:
        """All of them, from the start on."""
        left = list(self.roots)
        while left:
            node = left.pop(0)
            yield node
            left += [after for edge in node.edges for after in edge.nodes]

    # -- the start --------------------------------------------------------------------------------
    def _bound(self, name: str) -> UnilateralConstraint:
        return next(b for b in self.system.bounds if b.name == name)

    def _begin(self, rates: Mapping[str, Ratio], signs: Mapping[str, int], sets: Chosen) -> None:
        """The velocities of the start decide: a gap of zero that grows opens at once, one that shrinks is an impact."""
        given: list[Condition] = []
        for name, sign in signs.items():
            if sign:
                contact = name.partition(".")[0]
                what = (
                    Message("{contact} opens at once", contact=contact)
                    if sign > 0
                    else Message("{contact} is struck at once", contact=contact)
                )
                given += self.conditions([(sign * rates[name], ">", what)], sets)
            else:
                given.append(
                    Condition(
                        rates[name].numerator(),
                        "=",
                        Message("{contact} keeps touching", contact=name.partition(".")[0]),
                    )
                )
        hits = tuple(sorted(name for name, sign in signs.items() if sign < 0))
        closed = self.closed | {name for name, sign in signs.items() if sign == 0}
        if hits:
            start = PhaseStart(Placed(), closed, {}, given=tuple(given), began=self.home.model.field.zero)
            start = replace(start, acting=self.acting)
            nodes = self._struck(start, hits, sets, 0)
        else:
            here = self.home.state
            found = slips_of(self, self.rubbing(closed), lambda measure: self.at_start(here.rate(measure)))
            slips = found.sizes
            self.slips |= slips
            self.boundaries += [x for x in slips.values() if self.changes_sign(x, sets)]
            zero = self.home.model.field.zero
            start = PhaseStart(Placed(), closed, slips, given=tuple(given), began=zero, ways=found.ways)
            start = replace(start, acting=self.acting)
            nodes = self._follow(start, sets, 0)
        self.roots += nodes
        gone = np.setdiff1d(sets, np.concatenate([sets[:0], *(n.sets for n in nodes)]))
        none = Message("no state of the contacts was found that is consistent with the start")
        reason = self._locked(gone) or (self.reasons[-1] if self.reasons else none)
        self.lost |= dict.fromkeys(gone.tolist(), reason)

    def _locked(self, gone: Chosen) -> str:
        """What locks itself at all of some sets, so that nothing follows on their start."""
        if not len(gone) or not any(not x.is_zero() for x in self.slips.values()):
            return ""
        with suppress(*NO_FORM):
            for contact, reserve in self_pressed(self, self.slips):
                if (self.numbers(reserve)[gone] <= 0.0).all():
                    return Message("{contact} locks itself, and stops what slides there at once", contact=contact)
        return ""

    # -- impacts ----------------------------------------------------------------------------------
    def _struck(self, instant: PhaseStart, hits: tuple[str, ...], indices: Chosen, depth: int) -> list[PhaseNode]:
        """The phases that follow on a collision. Where it has no closed form there is none, and a reason more."""
        found: list[PhaseNode] = []
        try:
            values = self.sets.some(indices, 3)
            ways = ways_of_impact(self, instant, hits, values)
            blows: list[tuple[ClosedFormCollision, CollisionOutcome, list[Inequality], list[Test]]] = []
            labels = np.full(self.sets.n, NOTHING)
            for one in collisions(self.system, instant.closed, hits, instant.placed, values, instant.past, ways):
                for blow in one.blows():
                    elements, tests = self._tested(one, blow)
                    holds = np.all([np.ones(self.sets.n, dtype=bool), *(t.holds & t.known for t in tests)], axis=0)
                    labels[holds & (labels == NOTHING)] = len(blows)
                    blows.append((one, blow, elements, tests))
                if (labels[indices] != NOTHING).all():
                    break
        except NO_FORM as error:
            self.reasons.append(why(self.system, error))
            return []
        for cell in cells(labels, indices, [t for *_which, tests in blows for t in tests]):
            if cell.label == NOTHING:
                self.reasons.append(
                    Message(
                        "no outcome of the impact of {contacts} was found at some values", contacts=_connections(hits)
                    )
                )
                continue
            collision, blow, elements, _tests = blows[cell.label]
            impulses = {name: self.to_home(collision.setup, x) for name, x in collision.by_row(blow.impulses).items()}
            given = self.conditions([*elements, *cell.cuts], cell.sets)
            impact = PhaseImpact(hits, impulses, collision, collision.kept, collision=(collision, blow.impulses))
            if instant.impact is not None:  # by the blow just before
                first = instant.impact
                impact = replace(first, hits=hits, impulses={**first.impulses, **impulses}, collision=impact.collision)
            now = replace(instant, impact=impact, n_impacts=instant.n_impacts + 1)
            now = replace(now, given=(*instant.given, *given))
            nodes = self._after_blow(collision, blow, now, cell.sets, depth)
            for node in nodes:
                node.is_exact = node.is_exact and cell.is_exact
            found += nodes
        return found

    def _tested(self, collision: ClosedFormCollision, blow: CollisionOutcome) -> tuple[list[Inequality], list[Test]]:
        elements = [(self.to_home(collision.setup, x), relation, purpose) for x, relation, purpose in blow.conditions]
        return elements, [self._test(x, relation, purpose) for x, relation, purpose in elements]

    def _after_blow(
        self, collision: ClosedFormCollision, blow: CollisionOutcome, instant: PhaseStart, indices: Chosen, depth: int
    ) -> list[PhaseNode]:
        """A contact without rebound stays closed; what rebounds opens."""
        values = {**collision.start.values, **blow.speeds}
        after = SymbolicState(collision.model, values)
        try:
            placed = replace(self.placed(collision.setup, values), since=instant.placed.since)
            rates = {
                b.name: b.row.sign * self.to_home(collision.setup, after.rate(b.row.measure)) for b in collision.hits
            }
            touching = collision.kept | rates.keys()
            rubbing = self.rubbing(touching)
            slipping = slips_of(self, rubbing, lambda measure: self.to_home(collision.setup, after.rate(measure)))
        except NO_FORM as error:
            self.reasons.append(why(self.system, error))
            return []
        found: list[PhaseNode] = []
        for signs, sets in self.by_sign({n: x for n, x in rates.items() if not x.is_zero()}, indices):
            closed = touching - {name for name, sign in signs.items() if sign}
            own = {r.name: slipping.sizes[r.name] for r in self.rubbing(closed)}
            given = (*instant.given, *self.conditions([*self._rebounds(collision, signs)], sets))
            now = replace(instant, placed=placed, closed=closed, slips=own, ways=slipping.ways, given=given)
            found += self._follow(now, sets, depth)
        return found

    def _rebounds(self, collision: ClosedFormCollision, signs: Mapping[str, int]) -> Iterator[Inequality]:
        """What of the coefficients of restitution makes contacts open or stay closed after an impact."""
        for bound in collision.hits:
            e = self.to_home(collision.setup, collision.here(collision.model.geometry.scalar(bound.restitution)))
            name = bound.row.connection
            if bound.name in signs and e.generators():
                if signs[bound.name]:
                    yield e, ">", Message("{contact} rebounds", contact=name)
                else:
                    yield e, "=", Message("{contact} does not rebound", contact=name)

    # -- blows in mid-motion ----------------------------------------------------------------------
    def _blown(self, node: PhaseNode, edge: PhaseEnd, instant: PhaseStart) -> list[PhaseNode]:
        """The phases that follow on a blow: what only pushes or pulls answers to what it is left to do."""
        found: list[PhaseNode] = []
        for now, hits, sets in after_blow(self, node, edge, instant):
            if hits:
                found += self._struck(now, hits, sets, node.depth + 1)
            else:
                found += self._follow(now, sets, node.depth + 1)
        return found

    # -- which modes follow -----------------------------------------------------------------------
    def _test(self, x: Ratio, relation: str, purpose: str) -> Test:
        """An inequality at all sets; where it may be an equality, near the file's values up to round-off."""
        numbers = self.numbers(x)
        test = as_test(x, relation, numbers, purpose)
        if relation == "=":
            return replace(test, holds=np.abs(numbers) <= ROUNDED)
        sizes = np.abs(numbers[: self.sets.n_near])
        typical = float(np.median(sizes[np.isfinite(sizes)])) if np.isfinite(sizes).any() else 0.0
        near = np.abs(numbers) <= ROUND_OFF * min(1.0, typical)
        near &= np.arange(self.sets.n) < self.sets.n_near
        return replace(test, holds=test.holds & ~near if relation == ">" else test.holds | near)

    def _follow(self, instant: PhaseStart, indices: Chosen, depth: int) -> list[PhaseNode]:
        """The phases that begin in a state, each with the parameter sets for which it does."""
        left = np.zeros(self.sets.n, dtype=bool)
        left[indices] = True
        phases: list[tuple[Phase, list[Inequality]]] = []
        labels = np.full(self.sets.n, NOTHING)
        tests: list[Test] = []
        for mode in self.foresight.modes(instant, left):
            if not left.any() or (depth < self.most_depth and self.n_nodes >= allowed(MAX_NODES)):
                break
            try:
                for phase in self._phases_of(mode, instant, np.flatnonzero(left)):
                    needed = [(self.to_home(phase, x), rel, purpose) for x, rel, purpose in checks(phase, instant)]
                    needed += without_slip(mode, instant)
                    own = [self._test(*check) for check in needed]
                    tests += [t for t in own if t.relation != "="]
                    holds = np.all([left, *(t.holds & t.known for t in own)], axis=0)
                    if holds.any():
                        labels[holds] = len(phases)
                        phases.append((phase, needed))
                        self.n_nodes += depth < self.most_depth
                        left &= ~holds
            except NO_FORM as error:
                self.reasons.append(why(self.system, error))
        if not phases:
            return []
        found: list[PhaseNode] = []
        for cell in cells(labels, indices, [replace(t, against="") for t in tests]):
            if cell.label != NOTHING:
                phase, needed = phases[cell.label]
                cuts = [cut for cut in cell.cuts if not any(cut[:2] == check[:2] for check in needed)]
                conditions = self.conditions([*needed, *((x, relation, "") for x, relation, _p in cuts)], cell.sets)
                if _has_too_long(conditions):
                    self.reasons.append(TOO_LONG)
                    continue
                node = PhaseNode(phase, [*instant.given, *conditions], cell.sets, depth, is_exact=cell.is_exact)
                node.impact, node.n_impacts, node.known = instant.impact, instant.n_impacts, instant.known
                node.began = instant.began
                found.append(node)
        for node in found:
            self._end(node)
        return found

    def _phases_of(self, mode: ContactMode, instant: PhaseStart, left: Chosen) -> Iterator[Phase]:
        """The phase of a mode; where what presses its frictions may have either sign, one for each way of signs that is
        met at the parameter sets."""
        todo = left
        for _signs in range(MOST_SIGNS):
            phase = self.begun(mode, instant.placed, todo)
            yield phase
            exist = (
                [] if phase.determinant is None or not phase.pressed else [phase.start_instant.here(phase.determinant)]
            )
            signs = (*phase.pressed.values(), *exist, *phase.sides)
            turned = [self.numbers(self.to_home(phase, x)) < 0 for x in signs]
            todo = todo[np.any(turned, axis=0)[todo]] if turned else todo[:0]
            if not len(todo):
                return

    # -- how a phase ends -------------------------------------------------------------------------
    def _end(self, node: PhaseNode) -> None:
        """The first events, and what follows each."""
        try:
            outcomes = [
                (outcome, given)
                for watches, sets, given in pending(self, node, node.sets)
                for outcome in first_events(node.phase, self.sets, sets, watches)
            ]
        except NO_FORM as error:
            node.reason = why(self.system, error)
            return
        found = [c for o, _given in outcomes for c in self.outcome_conditions(node.phase, o)]
        if self._came_taut(node) and any(len(c.element.num) > MOST_TERMS for c in found):
            node.reason = Message("what follows on the jerk of the string depends on conditions too long to read")
            return
        if _has_too_long(found):
            node.reason = TOO_LONG
            return
        watched = node.phase.mode.closed | node.phase.closing_again.keys()
        gone = [row.connection for row in ideal_bounds(self.system) if row.name not in watched]
        again = (
            Message("whether {contact} closes again is not looked at; simulate the motion", contact=gone[0])
            if gone
            else ""
        )
        for outcome, given in outcomes:
            first = outcome.first
            time = None if first is None or first.zero.time is None else self.to_home(node.phase, first.zero.time)
            conditions = [*given, *self.outcome_conditions(node.phase, outcome)]
            proved = all(self._never(node, conditions, proofs) for proofs in outcome.unsure)
            edge = PhaseEnd(first, time, conditions, outcome.sets, is_exact=outcome.is_exact, is_proved=proved)
            node.edges.append(edge)
            if first is None:
                edge.stops = again
            else:
                self._after(node, edge)

    def _came_taut(self, node: PhaseNode) -> bool:
        """Whether a phase begins with the jerk of a string that was slack."""
        ideal = {row.name for row in ideal_bounds(self.system)}
        return node.impact is not None and not ideal.isdisjoint(node.impact.hits)

    def _never(self, node: PhaseNode, conditions: Sequence[Condition], proofs: Proofs) -> bool:
        """Whether it follows from the conditions that something does not end a phase."""
        premises = [*self.assumed, *node.known, *node.conditions, *conditions]
        return any(all(decide(self.to_home(node.phase, x), ">=", premises) for x in group) for group in proofs)

    def outcome_conditions(self, phase: Phase, outcome: PhaseOutcome) -> list[Condition]:
        elements = [(self.to_home(phase, x), relation, purpose) for x, relation, purpose in outcome.conditions]
        return self.conditions(elements, outcome.sets)

    def _after(self, node: PhaseNode, edge: PhaseEnd) -> None:
        watch = edge.watch
        assert edge.first is not None
        assert watch is not None
        is_short = node.depth + 1 < self.most_depth and self.n_nodes < allowed(MAX_NODES)
        if not is_short and not self._turns_on(node, edge):
            edge.stops = Message(
                "after {n} phases the search ends; raise the effort (--effort) to go on", n=node.depth + 1
            )
            return
        if watch.kind == "changes sign":
            edge.stops = Message("beyond {place} other formulas hold; simulate the motion", place=watch.name)
            return
        if watch.kind == "is left":
            edge.stops = Message("beyond that the model does not hold")
            return
        phase = node.phase
        there = SymbolicState(phase.model, {**phase.still, **edge.first.zero.values})
        states = dict(phase.mode.states)
        before = {n: s for n, s in states.items() if n != watch.name}
        known = (*node.known, *node.conditions, *edge.conditions)
        n_reasons = len(self.reasons)
        try:
            placed = self.placed(phase, {**phase.still, **edge.first.zero.values})
            is_own = self.system.has_values and 0 in edge.sets
            if not is_own and placed.n_operations > allowed(MOST_OPERATIONS):
                edge.stops = Message("the state there is a formula too long to read; simulate the motion")
                return
            began = None if node.began is None or edge.time is None else node.began + edge.time
            acting = dict(phase.mode.acting)
            for one in edge.first.watches:  # a buffer and the damper beside it are reached at once
                if one.name in acting:
                    acting[one.name] = one.kind == "touches"
            if watch.kind == STRIKES:
                instant = PhaseStart(placed, phase.mode.closed, {}, before, known=known, began=began)
                edge.nodes = self._blown(node, edge, replace(instant, acting=acting))
            elif watch.kind == "touches" and watch.name not in acting:
                edge.nodes = self._touched(node, edge, placed, before, known, began)
            else:
                slips: dict[str, Ratio] = {}
                for name, state in states.items():
                    is_still = name == watch.name or state == 0
                    rate = None if is_still else self.to_home(phase, there.rate(phase.dry_friction[name].row.measure))
                    slips[name] = self.home.model.field.zero if rate is None else rate
                excluded = {"opens": (watch.name, 0), "slips": (watch.name, watch.direction)}.get(watch.kind)
                closed = phase.mode.closed
                if watch.kind == "edge ends":
                    closed = closed - {watch.name} | taking_over(self, phase, there, watch.name, edge.sets)
                    dry_friction = self.rubbing(closed)
                    more = slips_of(self, dry_friction, lambda measure: self.to_home(phase, there.rate(measure)))
                    slips = {name: slips.get(name, slip) for name, slip in more.sizes.items()}
                instant = PhaseStart(placed, closed, slips, before, excluded, None, node.n_impacts, known)
                instant = replace(instant, past=phase.mode.past, began=began, ways=dict(phase.mode.ways))
                instant = replace(instant, acting=acting)
                edge.nodes = self._follow(instant, edge.sets, node.depth + 1)
                if not is_short:
                    edge.nodes = [after for after in edge.nodes if 0 in after.sets]
        except NO_FORM as error:
            edge.stops = why(self.system, error)
            return
        if not edge.nodes and not edge.stops:
            edge.stops = self.reasons[-1] if len(self.reasons) > n_reasons else Message("no mode is consistent there")

    def _turns_on(self, node: PhaseNode, edge: PhaseEnd) -> bool:
        """Whether one coordinate turns against friction on the way of the model's own values: each half swing is as
        short to write as the one before, and many may follow on each other."""
        is_own = self.system.has_values and 0 in edge.sets
        is_turn = edge.watch is not None and edge.watch.kind == "slip ends" and node.n_impacts == 0
        one = len(node.phase.model.coordinates) == 1
        return is_own and is_turn and one and node.depth + 1 < max(self.most_depth, allowed(MAX_TURNS))

    def _touched(
        self,
        node: PhaseNode,
        edge: PhaseEnd,
        placed: Placed,
        before: Mapping[str, int],
        known: tuple[Condition, ...],
        began: Ratio | None,
    ) -> list[PhaseNode]:
        """A gap that closes with a speed is an impact. After MAX_IMPACTS of them the formulas end."""
        watch = edge.watch
        assert watch is not None
        if node.n_impacts >= self.most_impacts:
            edge.stops = Message(
                "{contact} touches once more; after {n} impacts the formulas end; raise the effort (--effort) to go on",
                contact=watch.connection,
                n=node.n_impacts,
            )
            return []
        instant = PhaseStart(placed, node.phase.mode.closed, {}, before, None, None, node.n_impacts, known)
        instant = replace(instant, past=node.phase.mode.past, began=began, acting=dict(node.phase.mode.acting))
        assert edge.first is not None
        together = [
            other.name for other in edge.first.proved if other.kind == "touches" and other.name not in instant.acting
        ]
        return self._struck(instant, tuple(sorted((watch.name, *together))), edge.sets, node.depth + 1)


def _has_too_long(conditions: Sequence[Condition]) -> bool:
    """Roots and angles of earlier phases stand in each other, and nobody reads what becomes of it."""
    return any(n_operations(c.element.field.expression(c.element)) > MOST_OF_A_CONDITION for c in conditions)


def tree_of(system: System, question: Question | None = None) -> PhaseTree:
    """The tree of a system, made once for all that is asked of it, but for what comes after many impacts. Raises
    CannotAnswer where there is none."""
    asked = list[object]()
    if question is not None:
        wanted = question.quantity.wanted
        of = None if wanted is None else wanted.of
        asked = [question.transition, *((of.what, of.before) if isinstance(of, Happening) else ())]
        asked += [] if of is None else [q.transition for q in of.inner if isinstance(q, AtEvent)]
    counts = [one.count for one in asked if isinstance(one, Transition)]
    return _tree(system, allowed(_EFFORT), max([MAX_IMPACTS, *counts]))


@lru_cache(maxsize=4)
def _tree(system: System, _effort: int, n_impacts: int) -> PhaseTree:
    """With another effort it is another tree."""
    return PhaseTree(system, n_impacts)


def _connections(names: Sequence[str]) -> str:
    return in_turn([*dict.fromkeys(name.partition(".")[0] for name in names)])
