"""Every closed form of a motion in phases is compared with numbers that share only the statements of the measures.

The numbers come from `witness`: the one place where another simulation could be put in.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from functools import partial
from itertools import pairwise
from typing import Any

import numpy as np

from freebody.errors import CannotAnswer
from freebody.language.expression import number
from freebody.language.sentences import Message
from freebody.numeric.jets import Array
from freebody.numeric.reference import Reference
from freebody.numeric.snapshot import Snapshot
from freebody.questions.base import Quantity
from freebody.questions.clock import Clock
from freebody.questions.energy import Energy
from freebody.questions.event import AskedEvent
from freebody.questions.reading import Question
from freebody.study.answering.answer import Evidence
from freebody.study.answering.crosscheck import (
    INSTANT_TOLERANCE,
    MOTION_TOLERANCE,
    CrossCheck,
    element_at,
    without_numbers,
)
from freebody.study.answering.draws import SEED, Draw
from freebody.study.answering.magnitude import magnitude
from freebody.study.answering.passage import NumericPassage
from freebody.study.answering.spread import disagreement
from freebody.study.phases.bounced_out import bounced_out
from freebody.study.phases.branch import AnswerBranch
from freebody.study.phases.changes_asked import is_before_impact
from freebody.study.phases.followed import before_impact, begun, changed, follow
from freebody.study.phases.how_long import longest_times
from freebody.study.phases.in_blow import Parts, after_in_numbers
from freebody.study.phases.nodes import PhaseNode
from freebody.study.phases.over_time import over_time, work_over_time
from freebody.study.phases.phase import BOUNCES_END, Phase
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
from freebody.study.phases.turns_seen import turns_seen
from freebody.study.phases.witness import FollowedPhase, NumericMode, PhaseSnapshot
from freebody.system.system import System
from freebody.tolerances import ROUND_OFF, ROUNDED

_LONGEST = 400.0  # in units of the typical time of the sets; longer motions are left to other sets


def compare(tree: PhaseTree, question: Question, piece: AnswerBranch) -> Evidence:
    """Raises RoutesDisagree on a difference, CannotAnswer if too little could be compared."""
    if piece.in_blow:
        return _in_blow(tree, question, piece)
    if piece.at_start and question.quantity.is_of_event:
        return _at_once(tree, question, piece)
    if piece.at_start and question.quantity.scope == "course":
        return _since_the_start(tree, question, piece)
    if piece.first is None:
        return _at_instants(tree, question, piece)
    return _along_motion(tree, question, piece)


# -- one instant ------------------------------------------------------------------------------
def _at_instants(tree: PhaseTree, question: Question, piece: AnswerBranch) -> Evidence:
    phase, moving = piece.phase, piece.phase.model.coordinates
    all_rest = bool(moving) and all(c.speed in phase.still for c in moving)
    at_start = question.at_start or piece.at_start or all_rest
    route = (
        Message("floating-point solve of all bodies and contacts at the start")
        if at_start
        else Message("floating-point solve of all bodies and contacts at random poses and speeds")
    )
    check = CrossCheck(question.text, route, INSTANT_TOLERANCE)

    def compare(numbered: tuple[int, int]) -> None:
        n, k = numbered
        with without_numbers():
            values = tree.sets.one(k)
            mode, q, v = begun(tree.system, stage(tree, piece.nodes[-1]), values)
            reference = mode.references[0]
            begin, node = reference.snapshot(q, v), piece.nodes[-1]
            later = {name: values[name] for name in tree.later}  # symbols for where this phase begins
            draw = Draw({**mode.values, **later}, reference, q)
            if not at_start:
                q, v = _elsewhere(phase, reference, begin, n)
            now = mode.snapshot(q, v, 0.0)
            if is_before_impact(question) and node.impact is not None:
                now, _q, _v = before_impact(tree.system, node.impact.kept, values)
            numeric = value_in_mode(question.quantity, tree.system, mode.system, now)
        exact = (
            _home_numbers(tree, piece, k)
            if piece.is_home
            else element_at(piece.phase.setup, piece.value, draw, now, begin)
        )
        check.compare(draw, exact, numeric, partial(magnitude, question.quantity.dimension, now))

    return check.gather(enumerate(_numbered(piece)), compare).evidence()


def _elsewhere(phase: Phase, reference: Reference, begin: Snapshot, n: int) -> tuple[Array, Array]:
    """A pose and velocities near the start, otherwise arbitrary; what rests all along the phase is where it is at the
    start."""
    q, v = reference.wander(begin.q, np.random.default_rng(SEED + n), 0.1)
    still = [c for c in phase.model.coordinates if c.speed in phase.still]
    if not still:
        return q, v
    measures = {c: phase.model.measure_of(c) for c in phase.model.coordinates}
    resting = [m for c, m in measures.items() if c in still and m is not None]
    if len(resting) < len(still):
        return begin.q, begin.v
    there = reference.snapshot(q, v)
    rates = [(m, there.rate(m)) for c, m in measures.items() if c not in still and m is not None]
    q = reference.pose_near(q, [(m, begin.value(m)) for m in resting])
    return q, reference.velocities(q, [*rates, *((m, 0.0) for m in resting)], with_start=False)


def _numbered(piece: AnswerBranch) -> list[int]:
    """Its parameter sets."""
    return [int(k) for k in piece.sets]


def stage(tree: PhaseTree, node: PhaseNode) -> FollowedPhase:
    """A phase as the numeric route follows it."""
    mode = node.phase.mode
    touching = None if mode.closed <= tree.closed and not mode.past else tree.closed
    if node.impact is None:
        opens = tree.closed if node.phase.mode.closed < tree.closed else frozenset[str]()
        return FollowedPhase(node.phase, touching, (), opens)
    blow = "" if node.impact.blow is None else node.impact.blow.name
    return FollowedPhase(node.phase, touching, node.impact.hits, node.impact.kept, blow)


def _at_once(tree: PhaseTree, question: Question, piece: AnswerBranch) -> Evidence:
    """At the start, what slides though it did not slip is accelerated its way, and what has opened parts: of the first
    derivatives of a gap the first that does not vanish is positive. What is struck comes nearer just before."""
    check = CrossCheck(question.text, Message("floating-point rates and accelerations at the start"), INSTANT_TOLERANCE)

    def compare(k: int) -> None:
        mode, q, v = begun(tree.system, stage(tree, piece.nodes[-1]), tree.sets.one(k))
        now, impact = mode.snapshot(q, v, 0.0), piece.nodes[-1].impact
        asked = "" if question.transition is None else question.transition.kind
        if asked == "touches" and impact is not None:
            before, _q, _v = before_impact(tree.system, impact.kept, tree.sets.one(k))
            struck_rows = [tree.bound_row(name) for name in impact.hits]
            begins = any(row.sign * before.rate(row.measure) < -ROUNDED for row in struck_rows)
        elif asked == "opens":
            rows = [tree.bound_row(name) for name in (tree.closed | tree.moving) - mode.mode.closed]
            signs = [(row.sign, now.rate(row.measure), now.acceleration(row.measure)) for row in rows]
            begins = all((s * u if abs(u) > ROUNDED else s * a) > 0 for s, u, a in signs)
        else:
            # what slides from the start on may be braked; what begins to slide has no rate yet
            slides = [(s, mode.dry_friction[n].row.measure) for n, s in mode.mode.states.items() if s]
            resting = [(s, m) for s, m in slides if abs(now.rate(m)) <= ROUNDED * max(1.0, now.rate_size(m))]
            runs = all(s * now.rate(m) > 0 for s, m in slides if (s, m) not in resting)
            begins = runs and all(s * now.acceleration(m) > 0 for s, m in resting) and bool(resting)
        draw = Draw(mode.values, mode.references[0], q)
        check.compare(draw, _home_numbers(tree, piece, k), 0.0 if begins else np.inf)

    return check.gather(_numbered(piece), compare).evidence()


def _since_the_start(tree: PhaseTree, question: Question, piece: AnswerBranch) -> Evidence:
    """What is counted from the start is nothing at the start, but for the energy that an impact takes."""
    check = CrossCheck(question.text, Message("floating-point energies before and after the impact"), INSTANT_TOLERANCE)
    node = piece.nodes[-1]

    def compare(k: int) -> None:
        values = tree.sets.one(k)
        mode, q, v = begun(tree.system, stage(tree, node), values)
        before = now = mode.snapshot(q, v, 0.0)
        if node.impact is not None:
            before, _q, _v = before_impact(tree.system, node.impact.kept, values)
        counted = question.quantity.counted(_passage(tree, piece, [], mode, before, now))
        check.compare(Draw(mode.values, mode.references[0], q), _home_numbers(tree, piece, k), counted)

    return check.gather(_numbered(piece), compare).evidence()


def _in_blow(tree: PhaseTree, question: Question, piece: AnswerBranch) -> Evidence:
    """The impulses that lead from the momenta just before to those just after."""
    check = CrossCheck(question.text, Message("floating-point momenta before and after the blow"), MOTION_TOLERANCE)
    node = piece.nodes[-1] if piece.after is None else piece.after
    ends = None if piece.time is None else tree.numbers(piece.time)

    def compare(k: int) -> None:
        last: PhaseSnapshot | None = None
        if piece.after is not None:
            if ends is not None and not 0 < ends[k] < _LONGEST:
                return
            with without_numbers():
                last = run(tree, question.event, piece, k, None if ends is None else float(ends[k]))[-1]
        state, mode, now = _just_after_blow(tree, node, k, last, piece.nodes[0])
        numeric = value_in_mode(question.quantity, tree.system, mode.system, state)
        draw = Draw(mode.values, mode.references[0], now.q)
        size = partial(magnitude, question.quantity.dimension, now)
        check.compare(draw, _home_numbers(tree, piece, k), numeric, size)

    return check.gather(_numbered(piece), compare).evidence()


def _just_after_blow(
    tree: PhaseTree, node: PhaseNode, k: int, last: PhaseSnapshot | None, first: PhaseNode
) -> tuple[Any, NumericMode, Snapshot]:
    """The state just after the blow with which a phase begins, with what happened in it, its mode and instant. last:
    how the phase before ended; None where the motion begins with the blow. first: the phase of the start."""
    values, following = tree.sets.one(k), stage(tree, node)
    just_before: Snapshot
    if last is None:
        just_before, q, v = before_impact(tree.system, following.kept, values)
        system, time = tree.system, 0.0
    else:
        q, v, time = last.q, last.v, last.time
        just_before, system = last.snapshot(), last.mode.system
    mode = NumericMode(tree.system, following, values)
    mode.near = None if last is None else last.mode.near
    after = mode.snapshot(q, changed(tree.system, following, values, q, v, time), time)

    def beside(quantity: Quantity, side: str) -> Any:
        if side == "before":
            return value_in_mode(quantity, tree.system, system, just_before)
        begin = NumericMode(tree.system, stage(tree, first), values)
        start = begin.snapshot(*begun(tree.system, stage(tree, first), values)[1:], 0.0)
        return value_in_mode(quantity, tree.system, begin.system, start)

    return after_in_numbers(tree.system, following, values, after, (q, v, time), beside), mode, after


def number_in_blow(tree: PhaseTree, quantity: Quantity, piece: AnswerBranch, k: int, last: PhaseSnapshot | None) -> Any:
    """What is asked of the blow that a piece belongs to, by the numeric route at a parameter set."""
    node = piece.nodes[-1] if piece.after is None else piece.after
    state, mode, _now = _just_after_blow(tree, node, k, last, piece.nodes[0])
    return value_in_mode(quantity, tree.system, mode.system, state)


def impulses_in_numbers(
    tree: PhaseTree, node: PhaseNode, k: int, last: PhaseSnapshot | None
) -> Callable[[Parts], float]:
    """The sums of impulses, by shares and rows, in the blow with which a phase begins, by the numeric route."""
    state, _mode, _now = _just_after_blow(tree, node, k, last, node)
    return state.total_impulse


def _home_numbers(tree: PhaseTree, piece: AnswerBranch, k: int) -> tuple[float, ...]:
    parts = piece.value if isinstance(piece.value, tuple) else (piece.value,)
    return tuple(float(tree.numbers(p)[k]) for p in parts)


# -- an event ---------------------------------------------------------------------------------
def _along_motion(tree: PhaseTree, question: Question, piece: AnswerBranch) -> Evidence:
    route = Message("numerical integration, every phase to the event that ends it")
    check = CrossCheck(question.text, route, MOTION_TOLERANCE)
    assert piece.first is not None
    expected = piece.first.watch
    ends = None if piece.time is None else tree.numbers(piece.time)

    def compare(k: int) -> None:
        exact = _home_numbers(tree, piece, k)
        if not np.isfinite(exact).all() or (ends is not None and not 0 < ends[k] < _LONGEST):
            return
        with without_numbers():
            seen = run(tree, question.event, piece, k, None if ends is None else float(ends[k]))
        event = seen[-1].event
        draw = Draw(seen[0].mode.values, seen[0].mode.references[0], seen[0].q)
        if all(other[:2] != (expected.kind, expected.name) for other in seen[-1].together):
            nothing = Message("nothing within {time:.4g} s", time=seen[-1].time)
            found = nothing if event is None else f"{event[1]} {event[0]}"
            differ = Message(
                "'{question}': the closed form says that {a} {event}, the numeric route that {b} comes first",
                question=question.text,
                a=expected.name,
                event=expected.kind,
                b=found,
            )
            raise disagreement(differ, draw.reference)
        numeric = _number(tree, question.quantity, piece, seen)
        check.compare(draw, exact, numeric, partial(magnitude, question.quantity.dimension, seen[-1].snapshot()))

    return check.gather(_numbered(piece), compare).evidence()


def run(
    tree: PhaseTree, event: AskedEvent | None, piece: AnswerBranch, k: int, end: float | None
) -> list[PhaseSnapshot]:
    """The motion of one parameter set up to the event of the piece; kept for other questions."""
    key = (
        tuple(n.phase for n in piece.nodes),
        k,
        None if event is None else event.text,
        repr(piece.first and piece.first.watch.kind),
        piece.n_before,
    )
    if key not in tree.seen:
        if isinstance(event, Clock) and event.time is None and end is not None:  # when all has settled
            event = replace(event, time=number(end))
        known = longest_times(tree, piece.nodes, piece.first, k) if end is None else [1.5 * end] * len(piece.nodes)
        stages = [stage(tree, n) for n in piece.nodes]
        seen = follow(tree.system, stages, tree.sets.one(k), known, event, piece.n_before)
        if piece.first is not None and piece.first.watch.kind == BOUNCES_END and end is not None:
            seen[-1] = bounced_out(tree.system, seen[-1], piece.first.watch.name, end)
        tree.seen[key] = seen
    return tree.seen[key]


def _number(tree: PhaseTree, quantity: Quantity, piece: AnswerBranch, seen: list[PhaseSnapshot]) -> Any:
    last = seen[-1]
    mode, now = last.mode, last.snapshot()
    values, first = seen[0].mode.values, piece.nodes[0]
    if piece.after is not None and piece.after.impact is not None:  # the value just after an impact
        following = stage(tree, piece.after)
        mode = NumericMode(tree.system, following, values)
        mode.near = last.mode.near
        now = mode.snapshot(last.q, changed(tree.system, following, values, last.q, last.v, last.time), last.time)
    begin = seen[0].begin
    if first.impact is not None:
        begin, _q, _v = before_impact(tree.system, first.impact.kept, values)
    return quantity.counted(_passage(tree, piece, seen, mode, begin, now))


def _passage(
    tree: PhaseTree,
    piece: AnswerBranch,
    seen: Sequence[PhaseSnapshot],
    mode: NumericMode,
    begin: Snapshot,
    now: Snapshot,
) -> NumericPassage:
    """What was seen of a motion in phases. begin, now: before all impacts, and where it is asked for, in `mode`."""

    def lost(of: str) -> float:
        takers = set[str]().union(*(map(connection_of, frictions(s.mode.system)) for s in seen))
        strikes = [n.impact is not None and (not of or n.impact.is_in(of)) for n in (*piece.nodes, piece.after) if n]
        is_all = takers <= {of} and all(strikes[k] for k, n in enumerate(piece.nodes) if n.impact)
        only_takes = only_friction_takes_energy if of else only_takes_energy
        if all(only_takes(s.mode.system) for s in seen) and (not of or is_all):
            first = seen[0].mode.system if seen else mode.system  # with the springs that push there
            return _energy(begin, first) - _energy(now, mode.system)
        struck = _taken_by_impacts(seen, begin, now, strikes) if seen and any(strikes) else 0.0
        return sum(_heat(s, of) for s in seen) + struck

    def instants(one: PhaseSnapshot) -> Sequence[Snapshot]:
        return [one.begin, *one.looks, one.snapshot()]

    def ways() -> Iterator[Sequence[Snapshot]]:
        for one in seen:
            if one.event is not None and one.event[0] == BOUNCES_END:  # up and down, flight by flight
                yield from pairwise(instants(one))
            else:
                yield instants(one)

    def integral(quantity: Quantity) -> Any:
        return over_time(tree.system, seen, quantity)

    def work(load: str) -> float:
        """By its potential, or by its power where it has none."""
        try:
            return passage.by_energies(load)
        except CannotAnswer:
            return work_over_time(tree.system, seen, load)

    bounces = any(s.event is not None and s.event[0] == BOUNCES_END for s in seen)
    at_end = partial(_value_there, tree, mode, now)
    passage = NumericPassage(
        tree.system,
        begin,
        now,
        at_end,
        lost,
        work,
        ways=ways,
        over_time=integral,
        turned=None if bounces else partial(turns_seen, seen),
        takes_energy=frozenset(taking_energy(tree.system)),
    )
    return passage


def _value_there(tree: PhaseTree, mode: NumericMode, now: Snapshot, quantity: Quantity) -> Any:
    return value_in_mode(quantity, tree.system, mode.system, now)


def _taken_by_impacts(seen: Sequence[PhaseSnapshot], begin: Any, now: Any, counts: Sequence[bool]) -> float:
    """Between the end of a phase and the beginning of the next; `begin` and `now` are before and after all of them.
    counts: which of them are meant."""
    before = [begin, *(s.snapshot() for s in seen)]
    after = [*(s.begin for s in seen), now]
    systems = [*(s.mode.system for s in seen), seen[-1].mode.system]
    meant = (one for one, is_meant in zip(zip(before, after, systems, strict=True), counts, strict=False) if is_meant)
    return sum(_energy(a, s) - _energy(b, s) for a, b, s in meant)


def _heat(seen: PhaseSnapshot, of: str) -> float:
    """What friction turns into heat in one phase, in one connection or in all: its force by the way that it slips.
    Raises CannotAnswer where the force changes on the way."""
    begin, end = seen.mode.snapshot(seen.begin.q, seen.begin.v, seen.begin.t, seen.begin), seen.snapshot()
    total = 0.0
    for push in frictions(seen.mode.system):
        if of and connection_of(push) != of:
            continue
        first, last = begin.law(push), end.law(push)
        if abs(last - first) > ROUND_OFF * max(abs(first), abs(last)):
            raise CannotAnswer(
                Message("the friction changes along the motion, and its heat was not checked in numbers")
            )
        total -= last * (end.value(push.measure) - begin.value(push.measure))  # pyrefly: ignore[bad-argument-type]
    return total


def _energy(now: Any, system: System) -> float:
    return float(Energy("total").value(plain(system), now))
