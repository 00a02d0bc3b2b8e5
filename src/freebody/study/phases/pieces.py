"""Where in the tree a question is answered: at an instant of the first phases, or at an event on the way."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field, replace

import numpy as np

from freebody.errors import CannotAnswer
from freebody.model.contact_questions import Change, EnergyLost, Transition, Turns
from freebody.model.question import Event, Quantity, Question, When, Work
from freebody.study.phases.events import First, first_events
from freebody.study.phases.numbers import Chosen
from freebody.study.phases.phase import Phase, Watch
from freebody.study.phases.quantities import frictions, only_friction_takes_energy, plain, value_in_mode
from freebody.study.phases.tree import Edge, Node, Tree
from freebody.study.phases.words import label
from freebody.study.quantities import energy
from freebody.symbolic.conditions import Condition
from freebody.symbolic.field import Ratio
from freebody.symbolic.phases.course import Energy
from freebody.symbolic.state import SymbolicState, law_polynomial

Elements = Ratio | tuple[Ratio, ...]


@dataclass
class Piece:
    """An answer in one part of the space of parameters. With `is_home` its elements are of the parameters alone, in the
    field that all phases share; else they are functions of the state in the field of the last phase."""

    value: Elements
    is_home: bool
    nodes: list[Node]
    first: First | None
    conditions: list[Condition]
    sets: Chosen
    time: Ratio | None = None  # of the event, since the start
    notes: list[str] = field(default_factory=list[str])

    @property
    def phase(self) -> Phase:
        return self.nodes[-1].phase


@dataclass(frozen=True)
class _Way:
    """From the start to the beginning of a phase."""

    nodes: tuple[Node, ...]
    edges: tuple[Edge, ...]
    conditions: tuple[Condition, ...]

    def on(self, edge: Edge, node: Node) -> _Way:
        return _Way((*self.nodes, node), (*self.edges, edge), (*self.conditions, *edge.conditions, *node.conditions))

    @property
    def last(self) -> Node:
        return self.nodes[-1]


def pieces(tree: Tree, question: Question) -> list[Piece]:
    """The answer, part by part; that of the model's own values first. Raises CannotAnswer where there is none."""
    roots = [_Way((n,), (), (*tree.assumed, *n.conditions)) for n in tree.roots]
    if question.transition is not None:
        found = list(_at_transition(tree, question, question.transition, roots))
    elif question.event is not None:
        found = list(_at_event(tree, question, question.event, roots))
    else:
        found = [_at_instant(tree, question, way) for way in roots]
    if not found:
        asked = (
            question.transition.text if question.transition is not None else str(getattr(question.event, "text", ""))
        )
        reasons = [n.reason for way in roots for n in way.nodes if n.reason] + tree.reasons
        raise CannotAnswer(reasons[0] if reasons else f"'{asked}' never happens, whatever the parameters are")
    found.sort(key=lambda p: int(p.sets[0]))
    return found


# -- one instant ------------------------------------------------------------------------------
def _at_instant(tree: Tree, question: Question, way: _Way) -> Piece:
    """In the phase in which the motion begins."""
    phase = way.last.phase
    state = phase.start_instant if question.at_start else phase.state
    value = _elements(tree, phase, question.quantity, state)
    parts = value if isinstance(value, tuple) else (value,)
    moving = {c.index for c in phase.model.coordinates} | {c.speed for c in phase.model.coordinates}
    is_home = not any(phase.model.field.ingredients(p) & moving for p in parts)
    if is_home:
        homes = tuple(tree.to_home(phase, p) for p in parts)
        value = homes if isinstance(value, tuple) else homes[0]
    return Piece(value, is_home, [way.last], None, list(way.conditions), way.last.sets)


def _elements(tree: Tree, phase: Phase, quantity: Quantity, state: SymbolicState) -> Elements:
    value = value_in_mode(quantity, tree.system, phase.system, state)
    f = phase.model.field
    still = _still(phase)
    if isinstance(value, tuple):
        return tuple(f.lowest_terms(f.follow(f.element(v), still)) for v in value)  # type: ignore[arg-type]
    return f.lowest_terms(f.follow(f.element(value), still))


def _still(phase: Phase) -> dict[int, Ratio]:
    try:
        return phase.course.still
    except CannotAnswer:
        return {}


# -- events of contacts -----------------------------------------------------------------------
def _at_transition(tree: Tree, question: Question, asked: Transition, ways: list[_Way]) -> Iterator[Piece]:
    for way in ways:
        if not way.edges and asked.kind == "slips":
            yield from _slips_at_once(tree, question, asked, way)
        for edge in way.last.edges:
            if edge.first is None:
                continue
            if _is_meant(asked, edge.first.watch) and asked.kind != "rolls":
                yield _piece(tree, question, way, edge.first, edge.conditions, edge.sets)
                continue
            for node in edge.nodes:
                sticks = node.phase.mode.states.get(edge.first.watch.name) == 0
                if asked.kind == "rolls" and sticks and _is_meant(asked, edge.first.watch):
                    yield _piece(tree, question, way, edge.first, [*edge.conditions, *node.conditions], node.sets)
                else:
                    yield from _at_transition(tree, question, asked, [way.on(edge, node)])


def _slips_at_once(tree: Tree, question: Question, asked: Transition, way: _Way) -> Iterator[Piece]:
    """Where nothing slips at the start and yet a friction cannot hold, slipping begins then."""
    phase = way.last.phase
    for name, state in phase.mode.states.items():
        if state and tree.slips[name].is_zero() and (not asked.of or name.partition(".")[0] in asked.of):
            zero = tree.home.model.field.zero
            if isinstance(question.quantity, When):
                value: Elements = zero
            else:
                value = _elements(tree, phase, question.quantity, phase.start_instant)
                parts = value if isinstance(value, tuple) else (value,)
                homes = tuple(tree.to_home(phase, p) for p in parts)
                value = homes if isinstance(value, tuple) else homes[0]
            notes = [f"{label(name)} cannot hold at the start: it slips at once"]
            yield Piece(value, True, [way.last], None, list(way.conditions), way.last.sets, zero, notes)
            return


def _is_meant(asked: Transition, watch: Watch) -> bool:
    kind = {"rolls": "slip ends"}.get(asked.kind, asked.kind)
    return watch.kind == kind and (not asked.of or watch.connection in asked.of)


# -- a measure reaches a value ----------------------------------------------------------------
def _at_event(tree: Tree, question: Question, event: Event, ways: list[_Way]) -> Iterator[Piece]:
    for way in ways:
        node = way.last
        watch = _watch(tree, node, event)
        found, _never = first_events(node.phase, tree.sets, node.sets, [watch])
        for first, sets in found:
            if first.watch is watch:
                elements = [(tree.to_home(node.phase, x), ">", why) for x, why in first.conditions]
                conditions = tree.conditions(elements, sets)
                yield _piece(tree, question, way, first, conditions, sets)
        for edge in node.edges:
            mine = [sets for first, sets in found if edge.first is not None and first.watch is edge.first.watch]
            for after in edge.nodes:
                later = np.intersect1d(after.sets, np.concatenate(mine)) if mine else after.sets[:0]
                if len(later):
                    yield from _at_event(tree, question, event, [way.on(edge, replace(after, sets=later))])


def _watch(tree: Tree, node: Node, event: Event) -> Watch:
    """The distance from the value, positive at the beginning of the phase."""
    phase = node.phase
    value = phase.state.rate(event.measure) if event.order == 1 else phase.state.value(event.measure)
    difference = value - phase.model.geometry.scalar(event.value)
    at_first = tree.numbers(tree.to_home(phase, phase.start_instant.here(difference)))[node.sets]
    signs = set(np.sign(at_first[np.abs(at_first) > 1e-9]).tolist())
    if len(signs) > 1:
        raise CannotAnswer(f"whether '{event.text}' is reached from below or above depends on the parameter values")
    return Watch("is reached", event.text, -difference if signs == {-1.0} else difference)


# -- the value there --------------------------------------------------------------------------
def _piece(tree: Tree, question: Question, way: _Way, first: First, conditions: list[Condition], sets: Chosen) -> Piece:
    notes: list[str] = []
    time = _total(tree, way, first)
    if isinstance(course := way.last.phase.course, Energy) and course.coordinate.speed not in first.zero.values:
        notes.append("that it gets so far was checked at many parameter values; there is no short condition for it")
    value = _value_there(tree, question.quantity, way, first, time, notes)
    return Piece(value, True, list(way.nodes), first, [*way.conditions, *conditions], sets, time, notes)


def _total(tree: Tree, way: _Way, first: First) -> Ratio | None:
    """Time since the start: the phases before and the part of the last one."""
    total = tree.home.model.field.zero
    for edge in way.edges:
        if edge.time is None:
            return None
        total = total + edge.time
    return None if first.zero.time is None else total + tree.to_home(way.last.phase, first.zero.time)


def _value_there(
    tree: Tree, quantity: Quantity, way: _Way, first: First, time: Ratio | None, notes: list[str]
) -> Elements:
    phase = way.last.phase
    there = SymbolicState(phase.model, {**_still(phase), **first.zero.values})
    begin = way.nodes[0].phase
    match quantity:
        case When():
            if time is None:
                raise CannotAnswer(
                    "the time is the integral of the coordinate over its speed, which has no elementary closed form "
                    "here; simulate the motion for a number"
                )
            return time
        case Change(measure, _name):
            after, before = there.value(measure), begin.start_instant.value(measure)
            return tree.to_home(phase, after) - tree.to_home(begin, before)
        case EnergyLost():
            return _heat(tree, way, first)
        case Turns(body):
            return _turns(tree, body, way, first, notes)
        case Work(of):
            pushes = [p for p in plain(phase.system).pushes if p.load == of]
            if not pushes:
                raise CannotAnswer(f"{of} is no load; ask for the energy lost, or for power")
            total = tree.home.model.field.zero
            for push in pushes:
                law_polynomial(push)
                before = tree.to_home(begin, begin.start_instant.potential(push))
                total = total + before - tree.to_home(phase, there.potential(push))
            return total
        case _:
            value = _elements(tree, phase, quantity, there)
            if isinstance(value, tuple):
                return tuple(tree.to_home(phase, v) for v in value)
            return tree.to_home(phase, value)


def _heat(tree: Tree, way: _Way, first: First) -> Ratio:
    """What dry friction turns into heat: in every phase the integral of -F s' over time, F the friction along the slip
    s, which is not negative whatever else does work; where the motion is known by its energy alone, what that loses."""
    total = tree.home.model.field.zero
    for k, node in enumerate(way.nodes):
        phase, last = node.phase, k == len(way.edges)
        rubbing = frictions(phase.system)
        if not rubbing:
            continue
        zero = first.zero if last else way.edges[k].first.zero  # type: ignore[union-attr]
        if isinstance(phase.course, Energy):
            total = total + _energy_lost(tree, phase, zero.values)
            continue
        time = None if zero.time is None else tree.to_home(phase, zero.time)
        if time is None:
            raise CannotAnswer("the time of the event has no closed form, so neither has the heat of friction")
        for push in rubbing:
            power = phase.state.law(push) * phase.state.rate(push.measure)
            for n, coefficient in enumerate(phase.course.along(power)):
                total = total - tree.to_home(phase, coefficient) * time ** (n + 1) / (n + 1)
    return total


def _energy_lost(tree: Tree, phase: Phase, values: Mapping[int, Ratio]) -> Ratio:
    """What the mechanical energy loses from the beginning of a phase to a state of it."""
    if not only_friction_takes_energy(phase.system):
        raise CannotAnswer(
            "other loads do work as well, and the heat of friction has no closed form; simulate the motion"
        )
    there = SymbolicState(phase.model, {**_still(phase), **values})
    system = plain(phase.system)
    before, after = (energy("total", None, system, state) for state in (phase.start_instant, there))
    return tree.to_home(phase, before) - tree.to_home(phase, after)


def _turns(tree: Tree, body: str, way: _Way, first: First, notes: list[str]) -> Ratio:
    """Angles turned through, without sign, over a full turn; in every phase the body turns one way only."""
    from freebody.measures.angle import Angle

    home = tree.home.model.field
    total = home.zero
    for k, node in enumerate(way.nodes):
        phase = node.phase
        values = way.edges[k].first.zero.values if k < len(way.edges) else first.zero.values  # type: ignore[union-attr]
        end = SymbolicState(phase.model, {**_still(phase), **values})
        angle = Angle(body)
        a, b = (tree.to_home(phase, s.value(angle)) for s in (phase.start_instant, end))
        u, w = (tree.numbers(tree.to_home(phase, s.rate(angle))) for s in (phase.start_instant, end))
        turned = tree.numbers(b - a)[way.last.sets]
        if (u * w)[way.last.sets].min() < -1e-9 and not isinstance(phase.course, Energy):
            raise CannotAnswer(f"{body} turns one way and then the other; ask for the change of its angle instead")
        signs = set(np.sign(turned[np.abs(turned) > 1e-12]).tolist())
        if len(signs) > 1:
            raise CannotAnswer(
                f"which way {body} turns depends on the parameter values; ask for the change of its angle"
            )
        total = total + (a - b if signs == {-1.0} else b - a)
    return total / (2 * home.pi)
