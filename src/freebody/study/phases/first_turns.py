"""How far a motion gets until it first turns, through its phases: the ways on which it does.

What is no place, as a velocity, may be farthest between two phases: it grows until something comes to rest, or jumps in
an impact and falls from there. With a quantity Q, counted towards the side that is asked for, this is

    without an impact:  dQ/dt > 0 before, dQ/dt <= 0 behind;
    in an impact:       Q behind > Q before, dQ/dt <= 0 behind, or
                        dQ/dt > 0 before, Q behind <= Q before, and where these are equal dQ/dt <= 0 behind.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from contextlib import suppress
from dataclasses import dataclass, replace

import numpy as np

from freebody.errors import CannotAnswer
from freebody.language.sentences import Message
from freebody.questions.event import Peak
from freebody.questions.event_base import QuestionEvent
from freebody.questions.reading import Question
from freebody.study.answering.finding import NO_FORM
from freebody.study.phases.branch import AnswerBranch, branch_at
from freebody.study.phases.nodes import PhaseNode, WayToPhase
from freebody.study.phases.pieces import at_turning_impacts, pieces
from freebody.study.phases.reached import rate_of
from freebody.study.phases.tree import PhaseTree
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.state import SymbolicState
from freebody.tolerances import ROUNDED

NO_TURN = Message("no turn on that side was found among the phases of the motion")


def is_behind_an_impact(question: Question) -> bool:
    """Whether the motion is meant from an impact or a blow on."""
    return question.transition is not None and question.transition.kind == "after"


@dataclass(frozen=True)
class FirstTurns:
    """What is asked where it is told, the rate with which the motion sets out (none behind an impact), and the ways to
    a first turn, each with the question that it answers; with an event of its own, where it turns within a phase.
    behind: turns between two phases of what sets out to the other side."""

    question: Question
    rate: Ratio
    found: list[tuple[Question, AnswerBranch]]
    behind: list[AnswerBranch]


def first_turns(tree: PhaseTree, question: Question) -> FirstTurns:
    """All ways to a first turn."""
    turn = question.quantity.turn
    assert turn is not None
    of, event, side = turn
    root = tree.roots[0]
    blow = question.transition
    behind = is_behind_an_impact(question)
    question = replace(question, event=None, transition=None)
    rate = tree.home.model.field.zero if behind else _rate_of(tree, root, event)
    open_ = np.arange(tree.sets.n) if rate.is_zero() else np.flatnonzero(side * tree.numbers(rate) > 0)
    found: list[tuple[Question, AnswerBranch]] = []

    def take(asked: Question, branches: Iterable[tuple[AnswerBranch, Sequence[Ratio]]]) -> None:
        nonlocal open_
        for piece, rates in branches:
            sets = np.intersect1d(piece.sets, open_)
            for out in rates:
                sets = sets[side * tree.numbers(out)[sets] > 0]
            if len(sets):
                needed = tree.conditions([(side * out, ">", "") for out in rates], sets)
                found.append((asked, replace(piece, sets=sets, conditions=[*piece.conditions, *needed])))
                open_ = np.setdiff1d(open_, sets)

    # an impact may turn it: behind one that does the first place without speed is on the other side
    asked = replace(question, quantity=of, event=event)
    found_first: list[tuple[AnswerBranch, Sequence[Ratio]]] = []
    with suppress(CannotAnswer):
        if behind:
            take(asked, [(p, (_rate_behind(tree, p, event),)) for p in pieces(tree, asked, blow) if p.nodes[0] is root])
        else:
            found_first = [o for p in pieces(tree, asked) if p.nodes[0] is root for o in _setting_out(tree, p, event)]
    struck = replace(question, quantity=of)
    way = WayToPhase((root,), (), (*tree.assumed, *root.conditions))
    between: list[AnswerBranch] = []
    with suppress(*NO_FORM):
        if isinstance(event, Peak) and not behind and not of.may_jump:
            between += _between(tree, struck, event, side, way)
    ordered = [(len(o[0].nodes), asked, o) for o in found_first] + [(len(p.nodes), struck, (p, ())) for p in between]
    for _n, told, one in sorted(ordered, key=lambda x: x[0]):
        take(told, [one])
    away, later = np.flatnonzero(side * tree.numbers(rate) < 0), list[AnswerBranch]()
    for piece in sorted(between, key=lambda p: len(p.nodes)):
        sets = np.intersect1d(piece.sets, away)
        away = np.setdiff1d(away, sets)
        if len(sets):
            later.append(replace(piece, sets=sets))
    if not isinstance(event, Peak) and not behind:
        take(struck, [(p, (rate,)) for p in at_turning_impacts(tree, struck, event.measure, side, way)])
    return FirstTurns(question, rate, found, later)


def _rate_of(tree: PhaseTree, node: PhaseNode, event: QuestionEvent) -> Ratio:
    """The rate with which something begins a phase, from rest its acceleration."""
    phase, model = node.phase, node.phase.model
    rate = rate_of(tree, phase, event)
    begins = tree.to_home(phase, phase.start_instant.here(model.in_independent_speeds(rate)))
    if not begins.is_zero():
        return begins
    second = model.field.substitute(model.rate(model.in_independent_speeds(rate)), model.dynamics.solved_accelerations)
    return tree.to_home(phase, phase.start_instant.here(second))


def _rate_behind(tree: PhaseTree, piece: AnswerBranch, event: QuestionEvent) -> Ratio:
    """The rate with which something sets out from the last blow or impact on its way."""
    struck = [node for node in piece.nodes if node.impact is not None]
    return _rate_of(tree, struck[-1], event)


def _between(tree: PhaseTree, question: Question, event: Peak, side: int, way: WayToPhase) -> Iterator[AnswerBranch]:
    """Where a quantity is farthest between two phases."""
    for edge in way.last.edges:
        if edge.first is None:
            continue
        for node in edge.nodes:
            conditions = [*edge.conditions, *node.conditions]
            before = branch_at(tree, question, way, edge.first, conditions, node.sets)
            behind = _rate_of(tree, node, event)
            grows = rate_at_end(tree, before, event)
            if node.impact is None:
                yield from where(tree, before, [(side * grows, ">"), (-side * behind, ">=")])
            else:
                struck = branch_at(tree, question, way, edge.first, conditions, node.sets, node)
                if isinstance(struck.value, tuple) or isinstance(before.value, tuple):
                    return
                jump = struck.value - before.value
                yield from where(tree, struck, [(side * jump, ">"), (-side * behind, ">=")])
                yield from where(tree, before, [(-side * jump, ">"), (side * grows, ">")])
                if jump.is_zero():
                    yield from where(tree, before, [(side * grows, ">"), (-side * behind, ">=")])
            yield from _between(tree, question, event, side, way.on(edge, node))


def rate_at_end(tree: PhaseTree, piece: AnswerBranch, event: QuestionEvent) -> Ratio:
    """The rate of what turns at an event just before that with which a piece ends."""
    phase = piece.nodes[-1].phase
    assert piece.first is not None
    there = SymbolicState(phase.model, {**phase.still, **piece.first.zero.values})
    return tree.to_home(phase, there.here(phase.model.in_independent_speeds(rate_of(tree, phase, event))))


def where(tree: PhaseTree, piece: AnswerBranch, needed: Sequence[tuple[Ratio, str]]) -> Iterator[AnswerBranch]:
    """The part of a piece where some elements are positive, or not negative."""
    sets = piece.sets
    for x, relation in needed:
        numbers = tree.numbers(x)[sets]
        sets = sets[numbers > ROUNDED if relation == ">" else numbers >= -ROUNDED]
    if len(sets):
        conditions = tree.conditions([(x, relation, "") for x, relation in needed], sets)
        yield replace(piece, sets=sets, conditions=[*piece.conditions, *conditions])


def _setting_out(
    tree: PhaseTree, piece: AnswerBranch, event: QuestionEvent
) -> Iterator[tuple[AnswerBranch, Sequence[Ratio]]]:
    """A turn to which the measure goes with the rates that are told: that with which it sets out, be it from a blow at
    rest, and those with which it goes on behind the blows and impacts on its way."""
    for k, node in enumerate(piece.nodes):
        rate = _rate_of(tree, node, event)
        if not rate.is_zero():
            struck = [later.phase for later in piece.nodes[k + 1 :] if later.impact is not None]
            behind = [tree.to_home(p, p.start_instant.here(rate_of(tree, p, event))) for p in struck]
            yield piece, (rate, *behind)
            return
