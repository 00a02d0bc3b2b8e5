"""What is conserved in a motion that changes its law: in every phase by itself, and in the impacts between them.

A verdict on one phase says nothing of the next: friction that slides takes energy and rolling does not, and an impact
changes velocities at once. So each phase is judged, and of each impact the change of the quantity is found.
"""

from __future__ import annotations

from dataclasses import replace
from typing import Any, cast

from freebody.errors import CannotAnswer
from freebody.language.notation import joined, reworded, to_text
from freebody.language.sentences import Message
from freebody.questions.base import Quantity
from freebody.questions.reading import Question
from freebody.study.answering.answer import Answer
from freebody.study.conservation.verdicts import EVERY_MOTION, NOT_CONSERVED
from freebody.study.phases.kept import KeptMode, in_first_modes
from freebody.study.phases.nodes import PhaseNode, WayToPhase
from freebody.study.phases.quantities import value_in_mode
from freebody.study.phases.result import relations
from freebody.study.phases.tree import PhaseTree
from freebody.study.phases.words import in_phase
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.tidy import tidy


def answer(tree: PhaseTree, question: Question) -> Answer:
    """The verdict on the first phase, with what is so later and in between; it stands alone where nothing follows."""
    first = in_first_modes(tree, question)
    way = _taken(tree)
    later = way.nodes[1:] if way is not None else ()
    if way is None or not later or not first.is_answered or not question.quantity.inner:
        return first
    (of,) = question.quantity.inner
    verdicts = [_verdict(first)]
    notes = [_of_phase(tree.roots[0], verdicts[0])]
    for node in later:
        if node.impact is not None:
            is_kept, told = _across(tree, node, of)
            verdicts.append(EVERY_MOTION if is_kept else NOT_CONSERVED if is_kept is False else "")
            notes.append(told)
        found = _of_node(tree, node, question)
        verdicts.append(found)
        notes.append(_of_phase(node, found) if found else _open(node))
    own = [n for n in first.notes if n != in_phase(tree.roots[0].phase)]
    kept = [c for c in first.conditions if c != verdicts[0]]
    whole = _together(verdicts, is_told=_ends(way.last))
    if whole != verdicts[0] and first.options:  # these were judged by the first phase alone
        own.append(Message("the options are not judged: they say nothing of the single phases"))
        first = replace(first, choice=None, options={}, author_notes=())
    taken = [relation.text() for relation in relations(tree, list(way.conditions))]
    return replace(first, conditions=tuple(dict.fromkeys((whole, *kept, *taken))), notes=(*own, *notes))


def _taken(tree: PhaseTree) -> WayToPhase | None:
    """The way of the model's own values, as far as it is told."""
    if not tree.roots:
        return None
    root = tree.roots[0]
    way = WayToPhase((root,), (), tuple(root.conditions))
    while True:
        edges = [e for e in way.last.edges if 0 in e.sets] or way.last.edges[:1]
        following = [(e, n) for e in edges for n in e.nodes if 0 in n.sets] or [
            (e, e.nodes[0]) for e in edges if e.nodes
        ]
        if not following:
            return way
        way = way.on(*following[0])


def _ends(last: PhaseNode) -> bool:
    """Whether nothing follows a phase: no event ends it."""
    return not last.reason and all(e.first is None for e in last.edges)


def _verdict(found: Answer) -> str:
    return found.conditions[0] if found.conditions else ""


def _of_node(tree: PhaseTree, node: PhaseNode, question: Question) -> str:
    """The verdict on a phase; nothing where there is none."""
    from freebody.study.answering.closed_form import QuestionSolver

    try:
        return _verdict(QuestionSolver(KeptMode(tree, node), replace(question, options={}, key=None)).answer())
    except CannotAnswer:
        return ""


def _of_phase(node: PhaseNode, verdict: str) -> str:
    return Message("{phase}: {verdict}", phase=in_phase(node.phase), verdict=verdict)


def _open(node: PhaseNode) -> str:
    return Message("{phase}: not judged", phase=in_phase(node.phase))


def _across(tree: PhaseTree, node: PhaseNode, of: Quantity) -> tuple[bool | None, str]:
    """Whether a quantity is the same just after an impact as just before; None where that has no formula."""
    impact = node.impact
    assert impact is not None
    try:
        before = _elements(
            tree, impact.before.setup, value_in_mode(of, tree.system, impact.before.setup.system, impact.before.now)
        )
        after = _elements(tree, node.phase, value_in_mode(of, tree.system, node.phase.system, node.phase.start_instant))
        changes = [tree.home.model.field.lowest_terms(b - a) for a, b in zip(before, after, strict=True)]
    except CannotAnswer:
        return None, Message("{impact}: not judged", impact=impact.words)
    if all(change.is_zero() for change in changes):
        return True, Message("{impact}: it stays the same", impact=impact.words)
    shown = joined(to_text(tidy(change)) for change in changes)
    return False, reworded(Message("{impact}: it changes by {change}", impact=impact.words, change=shown), shown)


def _elements(tree: PhaseTree, place: Any, value: Any) -> list[Ratio]:
    parts = cast("tuple[Any, ...]", value) if isinstance(value, tuple) else (value,)
    return [tree.to_home(place, place.model.field.element(part)) for part in parts]


def _together(verdicts: list[str], *, is_told: bool) -> str:
    """What is so of the whole motion. is_told: whether the last phase that is told is the last one."""
    if any(v == NOT_CONSERVED for v in verdicts):
        return Message("not conserved on the whole way")
    different = {v for v in verdicts if v != EVERY_MOTION}
    if not different and not is_told:
        return Message("conserved in the phases and impacts that are told; others follow")
    if len(different) <= 1 and "" not in different:
        return different.pop() if different else EVERY_MOTION
    return Message("conserved in some of the phases and impacts; see there")
