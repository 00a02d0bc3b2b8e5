"""Where in the tree a question is answered: at an instant of the first phases, or at an event on the way."""

from __future__ import annotations

from collections.abc import Iterator, Sequence, Set
from contextlib import suppress
from dataclasses import replace
from typing import Any, cast

import numpy as np

from freebody.errors import CannotAnswer
from freebody.language.sentences import Message
from freebody.measures.base import Measure
from freebody.questions.arithmetic import NoValue
from freebody.questions.clock import Clock
from freebody.questions.course import Transition
from freebody.questions.event import AskedEvent
from freebody.questions.reading import Question
from freebody.questions.reading_when import is_of_start
from freebody.study.answering.conditions import as_written, at_instant, real
from freebody.study.answering.finding import NO_FORM, Elements, NotHere, why
from freebody.study.phases.bouncing import ends_of_bouncing
from freebody.study.phases.branch import AnswerBranch, branch_at, just_after, signs_taken, time_of, where_so
from freebody.study.phases.changes_asked import (
    begins_with,
    event_behind,
    is_before_impact,
    is_same,
    is_struck_in,
    meant_of,
    rebounds,
)
from freebody.study.phases.ends import FirstEvent, PhaseOutcome
from freebody.study.phases.events import first_events
from freebody.study.phases.in_blow import after_in_formulas, not_struck
from freebody.study.phases.in_the_end import in_the_end
from freebody.study.phases.nodes import PhaseEnd, PhaseNode, WayToPhase
from freebody.study.phases.numbers import Chosen
from freebody.study.phases.passage import elements_in, passage_of
from freebody.study.phases.phase import BOUNCES_END, PhaseWatch
from freebody.study.phases.quantities import value_in_mode
from freebody.study.phases.reached import pending, sides
from freebody.study.phases.tree import PhaseTree
from freebody.symbolic.conditions import Condition
from freebody.symbolic.state import SymbolicState
from freebody.symbolic.unknowns import Coordinate
from freebody.system.modes import ideal_bounds
from freebody.tolerances import ROUND_OFF


def pieces(tree: PhaseTree, question: Question, behind: Transition | None = None) -> list[AnswerBranch]:
    """The answer, part by part; that of the model's own values first. behind: a blow or an impact, from which on an
    event is meant. Raises CannotAnswer where there is none."""
    roots = [WayToPhase((n,), (), (*tree.assumed, *n.conditions)) for n in tree.roots]
    met: list[str] = []
    if is_of_start(question.quantity) and not _is_of_start_blow(tree, question):
        found = list(_in_blows(tree, question, roots))
        if not found:
            reasons, stops = _untold(tree)
            raise not_struck(question.quantity, next(iter((*reasons, *stops)), ""))
    elif question.event is not None and (behind := behind or question.transition) is not None:
        found = [
            replace(piece, n_before=len(way.nodes) - 1)
            for way in ways_behind(roots, behind)
            for piece in _at_event(tree, question, question.event, [way], met)
        ]
    elif question.transition is not None:
        found = list(_at_transition(tree, question, question.transition, roots))
        if question.transition.kind == BOUNCES_END or (question.transition.rests and not found):
            found = list(ends_of_bouncing(tree, question, question.transition, roots, met))
    elif isinstance(question.event, Clock) and question.event.time is None:
        found = list(in_the_end(tree, question, question.event, roots, met))
    elif question.event is not None:
        found = list(_at_event(tree, question, question.event, roots, met, is_first=True))
    else:
        found = list(_at_instants(tree, question, roots))
    found = [piece for piece in found if len(piece.sets)]  # signs that formulas take may be those of none
    if not found:
        raise NotHere(_not_found(tree, question, met))
    found.sort(key=lambda p: int(p.sets[0]))
    return [replace(piece, needs=_needs(tree, question, piece)) for piece in found]


def _needs(tree: PhaseTree, question: Question, piece: AnswerBranch) -> list[Condition]:
    """What the formula needs, and the state in which the motion begins or something is asked for, beside what makes
    it the branch that is taken."""
    at_event = piece.first is not None or piece.at_start
    setup = piece.nodes[0].phase.setup if at_event else piece.phase.setup
    state = setup.state if not (at_event or question.at_start) else piece.nodes[0].phase.start_instant
    own = as_written(setup, question, state) if at_event else at_instant(setup, question, state, with_contacts=False)
    if not piece.is_home:
        return [*real(piece.value), *setup.in_free_coordinates(own, state)]
    found = real(piece.value)
    for c in own:
        with suppress(CannotAnswer):
            found.append(replace(c, element=tree.to_home(setup, c.element)))
    return found


def _not_found(tree: PhaseTree, question: Question, met: list[str]) -> str:
    """That something never happens is said where every way through the phases is known to its end."""
    asked = question.transition.text if question.transition is not None else str(getattr(question.event, "text", ""))
    nodes = list(tree.nodes())
    reasons, stops = _untold(tree)
    reasons = met + reasons
    known = not tree.lost and all(n.is_exact and all(e.is_exact and e.is_proved for e in n.edges) for n in nodes)
    if not asked and not nodes and not reasons:
        return Message("no state of the contacts and stops was found that can hold at the start")
    if known and not reasons and not stops:
        return Message("'{event}' never happens, whatever the parameters are", event=asked)
    if reasons:
        return reasons[0]
    if stops:
        return Message("'{event}' does not happen in the phases that were found; {why}", event=asked, why=stops[0])
    return Message(
        "'{event}' does not happen in the phases that were found, at none of {n} parameter sets",
        event=asked,
        n=tree.sets.n,
    )


def _untold(tree: PhaseTree) -> tuple[list[str], list[str]]:
    """Why the motion is not told to its end: of phases that have no formulas, and of events that nothing follows."""
    nodes = list(tree.nodes())
    reasons = [n.reason for n in nodes if n.reason] + tree.reasons
    return reasons, [e.stops for n in nodes for e in n.edges if e.stops]


# -- one instant ------------------------------------------------------------------------------
def _at_instants(tree: PhaseTree, question: Question, roots: Sequence[WayToPhase]) -> Iterator[AnswerBranch]:
    """In all phases in which the motion may begin. One that is not the model's own may have no value: the ratio of two
    normal forces where one contact has opened."""
    own = next((way for way in roots if 0 in way.last.sets), None) if tree.system.has_values else None
    for way in roots:
        try:
            yield _at_instant(tree, question, way)
        except NoValue:
            if own is None or way is own:
                raise


def _at_instant(tree: PhaseTree, question: Question, way: WayToPhase) -> AnswerBranch:
    """In the phase in which the motion begins."""
    phase = way.last.phase
    state = phase.start_instant if question.at_start else phase.state
    value = elements_in(tree, phase, question.quantity, state)
    parts = value if isinstance(value, tuple) else (value,)
    is_home = not any(phase.model.field.ingredients(p) & phase.model.moving for p in parts)
    if is_home:
        homes = tuple(tree.to_home(phase, p) for p in parts)
        value = homes if isinstance(value, tuple) else homes[0]
    notes = [just_after(way.last)] if way.last.impact is not None and question.at_start else []
    return AnswerBranch(value, is_home, [way.last], None, list(way.conditions), way.last.sets, notes=notes)


# -- events of contacts -----------------------------------------------------------------------
def _at_transition(
    tree: PhaseTree, question: Question, asked: Transition, ways: list[WayToPhase]
) -> Iterator[AnswerBranch]:
    if asked.kind in ("before", "after"):
        yield from _beside_blow(tree, question, asked, ways)
        return
    for way in ways:
        begun = begins_with(tree, asked, way.last) if not way.edges else ""
        if begun and asked.count == 1:
            yield _at_the_start(tree, question, way, begun)
            continue
        left = asked.count - 1 if begun else asked.count  # of such changes, up to the one that is meant
        for edge in way.last.edges:
            if edge.first is None:
                continue
            meant = meant_of(asked, edge.first) if asked.kind != "rolls" else None
            if meant is not None and left > 1:
                later = replace(asked, count=left - 1)
                yield from _at_transition(tree, question, later, [way.on(edge, node) for node in edge.nodes])
                continue
            if meant is not None and _is_of_all(asked):
                _refuse_what_moves_on(tree, edge, meant)
            if meant is not None and _goes_on(edge, asked, meant):
                yield from _at_rest_of_all(tree, question, asked, way, edge, meant)
                continue
            if meant is not None and asked.stays:
                yield from _at_last_rest(tree, question, asked, way, edge, meant)
                continue
            if meant is not None:
                branch = branch_at(tree, question, way, meant, edge.conditions, edge.sets)
                if asked.rests and any(0 in node.sets and _slides(node, meant) for node in edge.nodes):
                    branch.notes.append(
                        Message(
                            "with the given numbers it is at rest there for an instant only, and slides on from there"
                        )
                    )
                yield branch
                continue
            for node in edge.nodes:
                conditions = [*edge.conditions, *node.conditions]
                meant = event_behind(asked, edge.first, node)
                if meant is None:
                    yield from _at_transition(tree, question, replace(asked, count=left), [way.on(edge, node)])
                else:
                    after = node if asked.kind == "opens" and rebounds(node, asked) else None
                    yield branch_at(tree, question, way, meant, conditions, node.sets, after)


def _at_last_rest(
    tree: PhaseTree, question: Question, asked: Transition, way: WayToPhase, edge: PhaseEnd, meant: FirstEvent
) -> Iterator[AnswerBranch]:
    """Where what stops is held by friction; where it is not, at a later stop."""
    for node in edge.nodes:
        if _slides(node, meant):
            yield from _at_transition(tree, question, asked, [way.on(edge, node)])
        else:
            yield branch_at(tree, question, way, meant, [*edge.conditions, *node.conditions], node.sets)


def _is_of_all(asked: Transition) -> bool:
    """Whether all is to rest."""
    return asked.rests and not asked.of and asked.kind == "slip ends"


def _refuse_what_moves_on(tree: PhaseTree, edge: PhaseEnd, meant: FirstEvent) -> None:
    """Raises CannotAnswer where the last of all that slides has stopped at the given numbers, and what nothing brakes
    goes on."""
    for node in edge.nodes:
        if 0 in node.sets and not _others_slide(node, meant):
            moving = [c.name for c in node.phase.model.coordinates if not _rests(tree, node, c)]
            if moving:
                told = Message(
                    "{measure} still changes when all that rubs has stopped: say what stops", measure=moving[0]
                )
                raise CannotAnswer(told)


def _rests(tree: PhaseTree, node: PhaseNode, c: Coordinate) -> bool:
    """Whether a coordinate has no rate where a phase begins, as far as that is known."""
    with suppress(CannotAnswer, KeyError):
        return tree.vanishes(tree.to_home(node.phase, node.phase.start.of(c.speed)))
    return True


def _goes_on(edge: PhaseEnd, asked: Transition, meant: FirstEvent) -> bool:
    """Whether all is to rest, and something else than what stops slides on in a phase that follows."""
    return _is_of_all(asked) and any(_others_slide(node, meant) for node in edge.nodes)


def _at_rest_of_all(
    tree: PhaseTree, question: Question, asked: Transition, way: WayToPhase, edge: PhaseEnd, meant: FirstEvent
) -> Iterator[AnswerBranch]:
    """Where the last of all that slides has stopped."""
    for node in edge.nodes:
        if _others_slide(node, meant):
            yield from _at_transition(tree, question, asked, [way.on(edge, node)])
        else:
            yield branch_at(tree, question, way, meant, [*edge.conditions, *node.conditions], node.sets)


def _others_slide(node: PhaseNode, meant: FirstEvent) -> bool:
    """Whether in a phase something slides that is not what has stopped at its beginning."""
    stopped = {watch.name for watch in meant.watches}
    return any(state != 0 and name not in stopped for name, state in node.phase.mode.states.items())


def _slides(node: PhaseNode, meant: FirstEvent) -> bool:
    """Whether what has stopped slides in the phase that follows."""
    return node.phase.mode.states.get(meant.watch.name, 0) != 0


def _beside_blow(
    tree: PhaseTree, question: Question, asked: Transition, ways: list[WayToPhase]
) -> Iterator[AnswerBranch]:
    """Just before or just after the blow or impact that is meant, the first or a later one."""
    for way in ways:
        node = way.last
        begins = not way.edges and is_struck_in(node, asked.of)
        if begins and asked.count == 1:
            yield _beside_start(tree, question, asked, way)
            continue
        left = asked.count - 1 if begins else asked.count
        for edge in node.edges:
            for after in edge.nodes:
                is_struck = is_struck_in(after, asked.of)
                if not is_struck or left > 1:
                    later = replace(asked, count=left - 1 if is_struck else left)
                    yield from _beside_blow(tree, question, later, [way.on(edge, after)])
                    continue
                assert edge.first is not None
                conditions = [*edge.conditions, *after.conditions]
                behind = after if asked.kind == "after" else None
                yield branch_at(tree, question, way, edge.first, conditions, after.sets, after=behind)


def _beside_start(tree: PhaseTree, question: Question, asked: Transition, way: WayToPhase) -> AnswerBranch:
    """Where the motion begins with an impact."""
    node, zero = way.last, tree.home.model.field.zero
    assert node.impact is not None
    conditions, sets = list(way.conditions), node.sets
    if asked.kind == "after":
        with signs_taken(tree, node.phase) as taken:
            value, note = question.quantity.counted(passage_of(tree, way, zero, node.sets)), just_after(node)
        conditions, sets = [*conditions, *taken], where_so(tree, taken, sets)
    else:
        before = node.impact.before
        found = value_in_mode(question.quantity, tree.system, before.setup.system, before.now)
        parts = cast("tuple[Any, ...]", found) if isinstance(found, tuple) else (found,)
        homes = tuple(tree.to_home(before.setup, before.setup.model.field.element(x)) for x in parts)
        value = homes if isinstance(found, tuple) else homes[0]
        note = Message("just before: {event}", event=node.impact.words)
    return AnswerBranch(value, True, [node], None, conditions, sets, zero, [note])


def ways_behind(ways: list[WayToPhase], asked: Transition) -> Iterator[WayToPhase]:
    """The ways up to the phases that begin with the blow or impact that is meant."""
    for way in ways:
        if (is_struck := is_struck_in(way.last, asked.of)) and asked.count == 1:
            yield way
            continue
        left = replace(asked, count=asked.count - 1) if is_struck else asked
        yield from ways_behind([way.on(edge, node) for edge in way.last.edges for node in edge.nodes], left)


# -- impulses ---------------------------------------------------------------------------------
def _is_of_start_blow(tree: PhaseTree, question: Question) -> bool:
    """Whether impulses are those of the blow of the start: of what holds there, and does not close later."""
    later = {name for blow in tree.system.blows for name in (*blow.closing, *blow.striking)}
    later |= {bound.row.connection for bound in tree.system.bounds}
    return tree.system.is_struck and not question.quantity.struck & later


def _in_blows(tree: PhaseTree, question: Question, ways: list[WayToPhase]) -> Iterator[AnswerBranch]:
    """In the first blow or impact of what is named: of a contact or of what closes its own, else of any."""
    named = question.quantity.struck
    own = {name for blow in tree.system.blows for name in (*blow.closing, *blow.striking)}
    _refuse_several(tree, named & own)
    own |= {bound.row.connection for bound in tree.system.bounds}
    own |= {row.connection for row in ideal_bounds(tree.system)}
    for way in ways:
        node = way.last
        if not way.edges and is_struck_in(node, sorted(named & own)):
            yield from _of_blow(tree, question, way, node, list(way.conditions), None)
            continue
        for edge in node.edges:
            for after in edge.nodes:
                if is_struck_in(after, sorted(named & own)):
                    conditions = [*way.conditions, *edge.conditions, *after.conditions]
                    yield from _of_blow(tree, question, way, after, conditions, edge.first)
                else:
                    yield from _in_blows(tree, question, [way.on(edge, after)])


def _refuse_several(tree: PhaseTree, named: Set[str]) -> None:
    """What is calculated with two blows would take both from the first of them."""
    found = [named & {*blow.closing, *blow.striking} for blow in tree.system.blows]
    if sum(map(bool, found)) > 1:
        told = Message("{names} act in different blows: ask for each of them by itself", names=", ".join(sorted(named)))
        raise CannotAnswer(told)


def _of_blow(
    tree: PhaseTree,
    question: Question,
    way: WayToPhase,
    node: PhaseNode,
    conditions: list[Condition],
    first: FirstEvent | None,
) -> Iterator[AnswerBranch]:
    phase, state = node.phase, after_in_formulas(tree, node, way.nodes[0])
    with signs_taken(tree, phase) as taken:
        found = value_in_mode(question.quantity, tree.system, phase.system, cast("Any", state))
        parts = cast("tuple[Any, ...]", found) if isinstance(found, tuple) else (found,)
        homes = tuple(tree.to_home(phase, phase.model.field.element(x)) for x in parts)
    conditions, sets = [*conditions, *taken], where_so(tree, taken, node.sets)
    value: Elements = homes if isinstance(found, tuple) else homes[0]
    assert node.impact is not None
    notes: list[str] = [Message("in: {event}", event=node.impact.words)]
    time = tree.home.model.field.zero if first is None else time_of(tree, way, first)
    after = None if first is None else node
    if len(sets):
        yield AnswerBranch(value, True, list(way.nodes), first, conditions, sets, time, notes, after, in_blow=True)


def _at_the_start(tree: PhaseTree, question: Question, way: WayToPhase, why: str) -> AnswerBranch:
    zero = tree.home.model.field.zero
    conditions, sets = list(way.conditions), way.last.sets
    notes, is_given = [why], way.last.impact is None or is_before_impact(question)
    if not is_given:
        notes.append(just_after(way.last))
    if is_given and question.quantity.kinematic_order in (0, 1):
        # places and velocities are those of the start, as it is written there
        given: Any = question.quantity.value(tree.home.system, tree.home.start_instant)
        f = tree.home.model.field
        if isinstance(given, tuple):
            value: Elements = tuple(f.lowest_terms(f.element(x)) for x in cast("tuple[Any, ...]", given))
        else:
            value = f.lowest_terms(f.element(given))
    else:
        with signs_taken(tree, way.last.phase) as taken:
            value = question.quantity.counted(passage_of(tree, way, zero, way.last.sets))
        conditions, sets = [*conditions, *taken], where_so(tree, taken, sets)
    return AnswerBranch(value, True, [way.last], None, conditions, sets, zero, notes)


# -- a measure reaches a value ----------------------------------------------------------------
def _at_event(
    tree: PhaseTree,
    question: Question,
    event: AskedEvent,
    ways: list[WayToPhase],
    met: list[str],
    *,
    is_first: bool = False,
) -> Iterator[AnswerBranch]:
    """In every phase up to the event; `met` collects why there is no closed form on some ways. is_first: in no phase
    before was the event still to come."""
    for way in ways:
        try:
            watches = list(sides(tree, way.last.phase, event, way.last.began, "is reached", way.last.sets))
        except CannotAnswer as error:
            met.append(str(error))
            continue
        for watch, sets, given in watches:
            if watch is not None:
                yield from _in_phase(tree, question, event, way, watch, sets, given, met)
            elif is_first:
                yield from _behind_phase_at_event(tree, question, event, way, sets, met)


def _behind_phase_at_event(
    tree: PhaseTree, question: Question, event: AskedEvent, way: WayToPhase, sets: Chosen, met: list[str]
) -> Iterator[AnswerBranch]:
    """Where it is so at the start and all along the first phase, the next time is meant: what is at rest until it is
    struck comes to rest."""
    for edge in way.last.edges:
        for after in edge.nodes:
            later = np.intersect1d(after.sets, sets)
            if len(later):
                on = way.on(edge, replace(after, sets=later))
                yield from _at_event(tree, question, event, [on], met, is_first=True)


def _in_phase(
    tree: PhaseTree,
    question: Question,
    event: AskedEvent,
    way: WayToPhase,
    watch: PhaseWatch,
    sets: Chosen,
    given: list[Condition],
    met: list[str],
) -> Iterator[AnswerBranch]:
    """In the last phase of a way, or in those that follow it."""
    node = way.last
    try:
        outcomes: list[PhaseOutcome] = []
        for watches, mine, more in pending(tree, node, sets):
            found = first_events(node.phase, tree.sets, mine, [watch, *watches])
            outcomes += [replace(o, given=tuple(more)) for o in found]
    except NO_FORM as error:
        met.append(why(tree.system, error))
        return
    for outcome in outcomes:
        if outcome.first is not None and outcome.first.watch is watch:
            conditions = [*given, *outcome.given, *tree.outcome_conditions(node.phase, outcome)]
            yield branch_at(tree, question, way, outcome.first, conditions, outcome.sets)
    for edge in node.edges:
        mine = [o for o in outcomes if edge.first and o.first and is_same(o.first.watch, edge.first.watch)]
        for after in edge.nodes:
            ways = _not_before(tree, way.on(edge, after), mine, given)
            yield from _at_event(tree, question, event, list(ways), met)


def _not_before(
    tree: PhaseTree, way: WayToPhase, outcomes: Sequence[PhaseOutcome], given: Sequence[Condition]
) -> Iterator[WayToPhase]:
    """A way on which what is asked for has not come in the phase before, with what makes that so where it is not so on
    all of it. outcomes: how that phase ends otherwise; given: from which side it came to the event."""
    after = way.last
    later = np.intersect1d(after.sets, np.concatenate([after.sets[:0], *(o.sets for o in outcomes)]))
    if len(later) == len(after.sets):
        yield way
        return
    for outcome in outcomes:
        sets = np.intersect1d(after.sets, outcome.sets)
        if len(sets):
            needed = (*given, *outcome.given, *tree.outcome_conditions(way.nodes[-2].phase, outcome))
            here = (*way.nodes[:-1], replace(after, sets=sets))
            yield replace(way, nodes=here, conditions=(*way.conditions, *needed))


def watches_of(
    tree: PhaseTree, way: WayToPhase, event: AskedEvent
) -> Iterator[tuple[PhaseWatch, Chosen, list[Condition]]]:
    """The distance from the value, positive when the phase begins (where it is zero, right after that), with the sets
    for which it has this sign."""
    node = way.last
    for watch, mine, given in sides(tree, node.phase, event, node.began, "is reached", node.sets):
        if watch is not None:
            yield watch, mine, given


def at_turning_impacts(
    tree: PhaseTree, question: Question, measure: Measure, side: int, way: WayToPhase
) -> Iterator[AnswerBranch]:
    """Where the first impact stops a measure that grows (side +1) or falls, or throws it back."""
    phase = way.last.phase
    for edge in way.last.edges:
        if edge.first is None:
            continue
        there = SymbolicState(phase.model, {**phase.still, **edge.first.zero.values})
        before = side * tree.numbers(tree.to_home(phase, there.rate(measure)))
        for node in edge.nodes:
            if node.impact is None:
                yield from at_turning_impacts(tree, question, measure, side, way.on(edge, node))
                continue
            own = node.phase.start_instant.rate(measure)
            after = side * tree.numbers(tree.to_home(node.phase, own))
            sets = node.sets[(before[node.sets] > 0) & (after[node.sets] <= ROUND_OFF * before[node.sets])]
            if len(sets):
                yield branch_at(tree, question, way, edge.first, [*edge.conditions, *node.conditions], sets)
