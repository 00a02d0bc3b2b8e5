"""What comes together on the way through phases, in formulas of the parameters alone."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import partial

from freebody.errors import CannotAnswer
from freebody.language.sentences import Message
from freebody.model.elements import AppliedLoad, NonholonomicForm
from freebody.questions.base import Quantity
from freebody.questions.energy import Energy
from freebody.study.answering.finding import Elements
from freebody.study.answering.formula_phase import FormulaPhase
from freebody.study.answering.over_time import FORCE_CHANGES
from freebody.study.answering.passage import NO_SWINGS, FormulaPassage, drivers, resistances
from freebody.study.phases.ends import FirstEvent
from freebody.study.phases.nodes import PhaseNode, WayToPhase
from freebody.study.phases.numbers import Chosen
from freebody.study.phases.phase import Phase
from freebody.study.phases.quantities import (
    connection_of,
    frictions,
    only_friction_takes_energy,
    only_takes_energy,
    plain,
    taking_energy,
    value_in_mode,
)
from freebody.study.phases.tree import PhaseTree
from freebody.symbolic.motion import SmoothMotion
from freebody.symbolic.phases.course import UniformMotion
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.reached import Reached
from freebody.symbolic.state import SymbolicState
from freebody.symbolic.turned_ways import TurnedWay, turned_way

_NO_TIME = Message(
    "the time is the integral of the coordinate over its speed, which has no elementary closed form here; simulate the "
    "motion for a number"
)


@dataclass(frozen=True)
class PassageWithFriction(FormulaPassage):
    """A passage on which friction and impacts take energy."""

    tree: PhaseTree
    way: WayToPhase
    first: FirstEvent | None
    after: PhaseNode | None

    def started(self, quantity: Quantity) -> Elements:
        phase = self.way.nodes[0].phase
        x = elements_in(self.tree, phase, quantity, phase.start_instant)
        return tuple(map(self.phases[0].told, x)) if isinstance(x, tuple) else self.phases[0].told(x)

    def work(self, load: str) -> Ratio:
        """Of what rubs or collides: what it has turned into heat, and negative."""
        if load in taking_energy(self.tree.system) and load not in drivers(self.system):
            return -self._rubbed(load)
        return super().work(load)

    def _balance(self, loads: Sequence[str]) -> tuple[Ratio, Ratio] | None:
        """T + V of all other loads, and at the end what friction and impacts take on the way."""
        if drivers(self.system) - {*loads}:
            return None
        others = list(dict.fromkeys(p.load for p in self.system.applied_loads if p.load not in loads))
        try:
            before, after = self._potentials(others, 1)
        except CannotAnswer:
            return None
        begun, ended = self.started(Energy("kinetic")), self.there(Energy("kinetic"))
        assert not isinstance(begun, tuple)
        assert not isinstance(ended, tuple)
        f = before.field
        return f.lowest_terms(begun + before), f.lowest_terms(ended + after + self._rubbed("", is_apart=True))

    def integral(self, quantity: Quantity) -> Elements:
        parts: list[tuple[Ratio, ...]] = []
        is_vector = False
        for node, ended in zip(self.way.nodes, self.phases, strict=False):
            if ended.time is None:
                raise CannotAnswer(_NO_TIME)
            phase = node.phase
            x = elements_in(self.tree, phase, quantity, phase.state)
            is_vector = isinstance(x, tuple)
            told = x if isinstance(x, tuple) else (x,)
            for part in told:
                if phase.model.field.ingredients(part) & phase.model.moving:
                    raise CannotAnswer(FORCE_CHANGES)
            parts.append(tuple(self.tree.to_home(phase, part) * ended.time for part in told))
        total = tuple(x[0].field.lowest_terms(sum(x[1:], x[0])) for x in zip(*parts, strict=True))
        return total if is_vector else total[0]

    def half_swings(self) -> Ratio:
        """The phases in which it slides, each from one turn to the next: what slides along one coordinate."""
        nodes = self.way.nodes
        if any(len(node.phase.model.coordinates) > 1 or node.impact is not None for node in nodes):
            raise CannotAnswer(NO_SWINGS)
        sliding = [node for node in nodes if any(node.phase.mode.states.values())]
        return self.tree.home.model.field.element(len(sliding))

    def heat(self, of: str) -> Ratio:
        if of or not resistances(self.system):
            return self._rubbed(of)
        ends = [*(edge.first for edge in self.way.edges), self.first]
        zero = self.tree.home.model.field.zero
        lost = (
            _energy_lost(self.tree, node.phase, end.zero.values)
            for node, end in zip(self.way.nodes, ends, strict=True)
            if end is not None
        )
        return sum(lost, zero) + self._struck(of)

    def _rubbed(self, of: str, *, is_apart: bool = False) -> Ratio:
        """What friction and impacts have taken. is_apart: where other loads take energy, only that."""
        return _heat(self.tree, self.way, self.first, of, is_apart=is_apart or bool(of)) + self._struck(of)

    def _struck(self, of: str) -> Ratio:
        nodes = (*self.way.nodes, *(() if self.after is None else (self.after,)))
        return sum((_taken_by_impact(self.tree, node, of) for node in nodes), self.tree.home.model.field.zero)


def passage_of(
    tree: PhaseTree,
    way: WayToPhase,
    elapsed: Ratio | None,
    sets: Chosen,
    first: FirstEvent | None = None,
    after: PhaseNode | None = None,
) -> PassageWithFriction:
    """The way to an instant: the event `first` that ends the last phase of a way, just behind the impact with which
    another one begins (`after`), or the start. sets: the parameter sets that go this way."""
    phases: list[FormulaPhase] = []
    for k, node in enumerate(way.nodes):
        ends = way.edges[k].first if k < len(way.edges) else first
        values = node.phase.start.values if ends is None else {**node.phase.still, **ends.zero.values}
        end = SymbolicState(node.phase.model, values)
        told = partial(tree.to_home, node.phase)
        own = None if ends is None else ends.zero.time
        turned = None if own is None else _turned_in(node.phase, own)
        phases.append(FormulaPhase(node.phase.start_instant, end, told, None if own is None else told(own), turned))
    last = way.last.phase
    if after is not None:
        last = after.phase
        phases.append(FormulaPhase(last.start_instant, last.start_instant, partial(tree.to_home, last)))

    def elements(quantity: Quantity, state: SymbolicState) -> Elements:
        return elements_in(tree, last, quantity, state)

    return PassageWithFriction(
        plain(last.system),
        phases,
        elapsed,
        _NO_TIME,
        elements,
        lambda x: tree.numbers(x)[sets],
        tree.home.state.sqrt,
        tree,
        way,
        first,
        after,
    )


def _turned_in(phase: Phase, time: Ratio) -> Callable[[Ratio], TurnedWay | None]:
    """Where something that moves in a phase turns back until a time of it."""
    motion = SmoothMotion(phase.model, phase.start)
    return partial(turned_way, motion, reached=Reached(time, None, time, None))


def elements_in(tree: PhaseTree, phase: Phase, quantity: Quantity, state: SymbolicState) -> Elements:
    value = value_in_mode(quantity, tree.system, phase.system, state)
    f = phase.model.field
    still = phase.still
    if isinstance(value, tuple):
        return tuple(f.lowest_terms(f.follow(f.element(v), still)) for v in value)
    return f.lowest_terms(f.follow(f.element(value), still))


def _heat(tree: PhaseTree, way: WayToPhase, first: FirstEvent | None, of: str, *, is_apart: bool) -> Ratio:
    """What dry friction turns into heat: in every phase the integral of -F s' over time, F the friction along the slip
    s, which is not negative whatever else does work; where the motion is known by its energy alone, what that loses, or
    where other loads take energy (`is_apart`) and of one connection (`of`) a steady F times its way."""
    total = tree.home.model.field.zero
    for k, node in enumerate(way.nodes):
        phase, last = node.phase, k == len(way.edges)
        rubbing = [p for p in frictions(phase.system) if not of or connection_of(p) == of]
        if not rubbing:
            continue
        ends = first if last else way.edges[k].first
        if ends is None:
            continue
        zero = ends.zero
        if not isinstance(phase.course, UniformMotion):
            is_all = len(rubbing) == len(frictions(phase.system))
            is_alone = not is_apart or (is_all and only_friction_takes_energy(phase.system))
            if is_alone and (only_takes_energy(phase.system) or _goes_by_rates(phase)):
                total = total + _energy_lost(tree, phase, zero.values)
            else:
                total = sum((_by_way(tree, phase, push, zero.values) for push in rubbing), total)
            continue
        time = None if zero.time is None else tree.to_home(phase, zero.time)
        if time is None:
            raise CannotAnswer(Message("the time of the event has no closed form, so neither has the heat of friction"))
        for push in rubbing:
            power = phase.state.law(push) * phase.state.rate(push.measure)
            for n, coefficient in enumerate(phase.course.along(power)):
                total = total - tree.to_home(phase, coefficient) * time ** (n + 1) / (n + 1)
    return total


def _goes_by_rates(phase: Phase) -> bool:
    """Whether a load depends on how fast something moves, and may take energy that is not stored."""
    model = phase.model
    speeds = {c.speed for c in (*model.coordinates, *model.dependent)}
    return any(model.field.ingredients(phase.state.law(p)) & speeds for p in plain(phase.system).applied_loads)


def _by_way(tree: PhaseTree, phase: Phase, push: AppliedLoad, values: Mapping[int, Ratio]) -> Ratio:
    """What a friction that stays the same turns into heat from the beginning of a phase to a state of it."""
    size, f = phase.state.law(push), phase.model.field
    if f.ingredients(size) & phase.model.moving or isinstance(push.measure, NonholonomicForm):
        raise CannotAnswer(
            Message(
                "the friction in {name} changes on the way, and its heat has no closed form", name=connection_of(push)
            )
        )
    there = SymbolicState(phase.model, {**phase.still, **values})
    way = there.value(push.measure) - phase.start_instant.value(push.measure)
    return tree.to_home(phase, f.lowest_terms(-size * way))


def _energy_lost(tree: PhaseTree, phase: Phase, values: Mapping[int, Ratio]) -> Ratio:
    """What the mechanical energy loses from the beginning of a phase to a state of it."""
    if not only_takes_energy(phase.system):
        raise CannotAnswer(
            Message("other loads do work as well, and the heat of friction has no closed form; simulate the motion")
        )
    there = SymbolicState(phase.model, {**phase.still, **values})
    system = plain(phase.system)
    before, after = (Energy("total").value(system, state) for state in (phase.start_instant, there))
    return tree.to_home(phase, before) - tree.to_home(phase, after)


def _taken_by_impact(tree: PhaseTree, node: PhaseNode, of: str) -> Ratio:
    """What the mechanical energy loses in the collision with which a phase begins; in one connection (`of`) where that
    alone strikes."""
    if node.impact is None:
        return tree.home.model.field.zero
    if of and not node.impact.is_in(of):
        return tree.home.model.field.zero
    setup, phase = node.impact.before.setup, node.phase
    if node.impact.blow is not None and node.impact.blow.impulses:
        raise CannotAnswer(
            Message(
                "{names} does work on the way; ask for the kinetic energy just before and just after it",
                names=", ".join(node.impact.blow.striking),
            )
        )
    before = Energy("total").value(plain(setup.system), node.impact.before.now)
    after = Energy("total").value(plain(phase.system), phase.start_instant)
    return tree.to_home(setup, before) - tree.to_home(phase, after)
