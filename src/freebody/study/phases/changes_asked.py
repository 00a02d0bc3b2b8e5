"""Which change of a contact a question means: what touches, opens, slides or is struck, and when."""

from __future__ import annotations

from collections.abc import Sequence

from freebody.language.sentences import Message
from freebody.questions.course import Transition
from freebody.questions.reading import Question
from freebody.study.phases.ends import FirstEvent
from freebody.study.phases.nodes import PhaseNode
from freebody.study.phases.phase import PhaseWatch
from freebody.study.phases.reached import STRIKES
from freebody.study.phases.tree import PhaseTree
from freebody.study.phases.words import label


def meant_of(asked: Transition, first: FirstEvent) -> FirstEvent | None:
    """An event called by what is asked for, of all that happens at its instant."""
    return next((first.named_by(watch) for watch in first.watches if is_meant(asked, watch)), None)


def event_behind(asked: Transition, first: FirstEvent, node: PhaseNode) -> FirstEvent | None:
    """An event called by that of what happens at its instant behind which a change of a contact comes, if one does."""
    return next((first.named_by(watch) for watch in first.watches if comes_behind(asked, watch, node)), None)


def comes_behind(asked: Transition, watch: PhaseWatch, node: PhaseNode) -> bool:
    """Whether a change of a contact comes with the phase that follows on an event: slip ends and rolling follows, an
    edge ends and nothing touches behind it, or what is struck parts again."""
    if asked.kind == "rolls":
        return node.phase.mode.states.get(watch.name) == 0 and is_meant(asked, watch)
    if asked.kind != "opens":
        return False
    return (watch.kind == "edge ends" and _is_left(node, asked, watch.connection)) or rebounds(node, asked)


def is_struck_in(node: PhaseNode, of: Sequence[str]) -> bool:
    """Whether a phase begins with a blow or an impact of what is named."""
    if node.impact is None:
        return False
    struck = {name.partition(".")[0] for name in node.impact.hits}
    if node.impact.blow is not None:
        struck |= {*node.impact.blow.closing, *node.impact.blow.striking}
    return not of or bool(struck.intersection(of))


def _is_left(node: PhaseNode, asked: Transition, connection: str) -> bool:
    """Whether no place of a connection touches any more, where an edge has ended."""
    still = {name.partition(".")[0] for name in node.phase.mode.closed}
    return _is_named(asked, connection) and connection not in still


def rebounds(node: PhaseNode, asked: Transition) -> bool:
    """Whether a phase begins with an impact that parts what is meant: what strikes, or what has touched."""
    touched = frozenset[str]() if node.impact is None else node.impact.touched
    return any(_is_named(asked, name.partition(".")[0]) for name in touched - node.phase.mode.closed)


def begins_with(tree: PhaseTree, asked: Transition, node: PhaseNode) -> str:
    """Why what is asked for happens at the start: nothing slips and yet friction cannot hold, what touches parts, or it
    begins with an impact."""
    phase = node.phase
    if asked.kind == "slips":
        for name, state in phase.mode.states.items():
            is_still = name in tree.slips and tree.slips[name].is_zero()
            if state and is_still and _is_named(asked, name.partition(".")[0]):
                return Message("{contact} cannot hold at the start: it slips at once", contact=label(name))
    hits = () if node.impact is None or asked.kind != "touches" else node.impact.hits
    for name in hits:
        if _is_named(asked, name.partition(".")[0]):
            return Message("{contact} is struck at once", contact=label(name))
    if asked.kind == "opens":
        for name in sorted((tree.closed | tree.moving) - phase.mode.closed):
            if _is_named(asked, name.partition(".")[0]):
                return Message("{contact} touches at the start only: it opens at once", contact=label(name))
    return ""


def is_before_impact(question: Question) -> bool:
    """Whether a place or a velocity is asked for where something is struck: it is that just before."""
    asked = question.transition
    if asked is None or asked.kind == "before":
        return asked is not None
    return asked.kind == "touches" and question.quantity.kinematic_order in (0, 1)


def _is_named(asked: Transition, connection: str) -> bool:
    return not asked.of or connection in asked.of


def is_meant(asked: Transition, watch: PhaseWatch) -> bool:
    kind = {"rolls": "slip ends"}.get(asked.kind, asked.kind)
    return watch.kind == kind and _is_named(asked, watch.connection)


def is_same(watch: PhaseWatch, other: PhaseWatch) -> bool:
    """Whether two watches are for one event; those for blows are made anew."""
    return watch is other or (watch.kind == other.kind == STRIKES and watch.name == other.name)
